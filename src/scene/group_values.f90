!> The values of a group of a namelist file that do not depend on a kind: texts, truth values.
module kyvadlo_group_values
   use kyvadlo_namelist_file, only: group_type, place_of
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: lower_case, shown
   implicit none
   private
   public :: entry_place, take_text, take_truth

contains

   !> Place of the first entry of that name, or 0.
   pure integer function entry_place(group, name) result(place)
      type(group_type), intent(in) :: group
      character(len=*), intent(in) :: name
      integer :: i

      place = 0
      do i = size(group%entries), 1, -1
         if (group%entries(i)%name == name) place = i
      end do
   end function entry_place

   !> A text given in quotation marks. Without the name, `text` stays as it is.
   pure subroutine take_text(group, name, text, error)
      type(group_type), intent(in) :: group
      character(len=*), intent(in) :: name
      character(len=:), allocatable, intent(inout) :: text
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      i = entry_place(group, name)
      if (i == 0) return
      associate (entry => group%entries(i))
         if (entry%subscript /= 0 .or. size(entry%values) /= 1) then
            call fail(error, code_input, place_of(group%file, entry%line)//'&'//group%name//': '//name &
               //' takes one text')
         else if (.not. entry%values(1)%quoted) then
            call fail(error, code_input, place_of(group%file, entry%values(1)%line)//'&'//group%name//': '//name &
               //' must be a text in quotation marks, got '//shown(entry%values(1)%text))
         else
            text = trim(entry%values(1)%text)
         end if
      end associate
   end subroutine take_text

   !> `.true.` or `.false.`, also `t` and `f`. Without the name, `truth` stays as it is.
   pure subroutine take_truth(group, name, truth, error)
      type(group_type), intent(in) :: group
      character(len=*), intent(in) :: name
      logical, intent(inout) :: truth
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: word
      integer :: i

      i = entry_place(group, name)
      if (i == 0) return
      associate (entry => group%entries(i))
         word = ''
         if (entry%subscript == 0 .and. size(entry%values) == 1) then
            if (.not. entry%values(1)%quoted) word = lower_case(entry%values(1)%text)
         end if
         select case (word)
         case ('.true.', '.t.', 'true', 't')
            truth = .true.
         case ('.false.', '.f.', 'false', 'f')
            truth = .false.
         case default
            call fail(error, code_input, place_of(group%file, entry%line)//'&'//group%name//': '//name &
               //' must be .true. or .false., got '//shown(entry%values(1)%text))
         end select
      end associate
   end subroutine take_truth

end module kyvadlo_group_values
