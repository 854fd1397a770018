!> `kyvadlo simulate --list`: the table of settings, in the form in which doc/scene_format.md shows it.
module kyvadlo_settings_list
   use kyvadlo_scene_groups, only: group_names, settings
   use kyvadlo_text, only: text_sink_type
   implicit none
   private
   public :: write_settings

contains

   subroutine write_settings(sink)
      class(text_sink_type), intent(inout) :: sink
      character(len=24) :: default
      integer :: i, group

      group = 0
      do i = 1, size(settings)
         if (settings(i)%group /= group) then
            if (group > 0) call sink%put('')
            group = settings(i)%group
            call sink%put('| name of `&'//trim(group_names(group))//'` | meaning | unit | default |')
            call sink%put('|---|---|---|---|')
         end if
         default = settings(i)%default
         if (default == 'required') default = 'none: must be given'
         call sink%put('| `'//trim(settings(i)%name)//trim(elements(settings(i)%values))//'` | ' &
            //trim(settings(i)%meaning)//' | '//trim(settings(i)%unit)//' | '//trim(default)//' |')
      end do
   end subroutine write_settings

   !> `(3)` behind a vector.
   pure function elements(values) result(text)
      integer, intent(in) :: values
      character(len=3) :: text

      text = ''
      if (values > 1) text = '('//achar(iachar('0') + values)//')'
   end function elements

end module kyvadlo_settings_list
