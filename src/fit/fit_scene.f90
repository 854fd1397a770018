!> The scene of a fit with what was found, ready for `simulate`.
module kyvadlo_fit_scene
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result, only: fit_result_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: group_type, parse_groups
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_scene_groups
   use kyvadlo_scene_reader, only: keep_pendulum
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: fitted_scene

contains

   !> All groups but &fit and &camera. Of a start by position and velocity both are written, whichever of them is free:
   !> the bob stays at its length and the velocity at right angles to it, also where length alone is free.
   subroutine fitted_scene(result, request, text)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      character(len=:), allocatable, intent(out) :: text
      type(group_type), allocatable :: groups(:)
      type(error_type), allocatable :: error
      integer, allocatable :: found(:)                   !! Settings
      logical, allocatable :: is_written(:)
      integer :: i, j, k, g
      character(len=*), parameter :: line_feed = achar(10)

      text = ''
      call parse_groups(request%text, request%file, groups, error)
      if (.not. allocated(error)) call keep_pendulum(groups, request%file, error, request%choice)
      if (allocated(error)) return
      found = result%of%setting
      if (request%pendulum%start == start_state) then
         i = setting_place(pendulum_group, 'position')
         j = setting_place(pendulum_group, 'velocity')
         found = [pack(found, found /= i .and. found /= j), i, j]
      end if
      allocate (is_written(size(found)))
      is_written = .false.
      do g = 1, size(groups)
         if (groups(g)%name == 'fit' .or. groups(g)%name == 'camera') cycle
         text = text//'&'//groups(g)%name//line_feed
         do j = 1, size(groups(g)%entries)
            associate (entry => groups(g)%entries(j))
               if (any(group_names(settings(found)%group) == groups(g)%name .and. settings(found)%name == entry%name)) &
                  cycle
               text = text//'   '//entry%name
               if (entry%first > 0) text = text//'('//integer_text(entry%first)//')'
               text = text//' = '
               do k = 1, size(entry%values)
                  if (k > 1) text = text//', '
                  if (entry%values(k)%quoted) then
                     call put_quoted(entry%values(k)%text)
                  else
                     text = text//entry%values(k)%text
                  end if
               end do
               text = text//line_feed
            end associate
         end do
         call put_found(groups(g)%name)
         ! Of a scene without a start, whose periods were measured: a swing of the largest amplitude.
         if (groups(g)%name == 'pendulum' .and. .not. request%has_start) text = text//'   release_angle = '// &
            shortest_text(maxval(result%model%all%amplitude)*180/acos(-1.0_wp))//line_feed
         text = text//'/'//line_feed
      end do
      do i = 1, size(found)
         if (is_written(i)) cycle
         associate (group => group_names(settings(found(i))%group))
            if (group == 'camera') cycle
            text = text//'&'//trim(group)//line_feed
            call put_found(trim(group))
            text = text//'/'//line_feed
         end associate
      end do

   contains

      subroutine put_found(group)
         character(len=*), intent(in) :: group
         integer :: i, k

         do i = 1, size(found)
            if (is_written(i) .or. group_names(settings(found(i))%group) /= group) cycle
            is_written(i) = .true.
            text = text//'   '//trim(settings(found(i))%name)//' = '
            do k = 1, settings(found(i))%values
               if (k > 1) text = text//', '
               text = text//shortest_text(result%number(k, found(i)))
            end do
            text = text//line_feed
         end do
      end subroutine put_found

      !> Quotation marks in it are doubled.
      subroutine put_quoted(value)
         character(len=*), intent(in) :: value
         integer :: i

         text = text//"'"
         do i = 1, len(value)
            text = text//value(i:i)
            if (value(i:i) == "'") text = text//"'"
         end do
         text = text//"'"
      end subroutine put_quoted
   end subroutine fitted_scene

end module kyvadlo_fit_scene
