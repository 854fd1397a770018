!> One of the pendulums of a scene, by its name or its number.
module kyvadlo_pendulum_choice
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, shown, text_type
   implicit none
   private
   public :: find_pendulum

contains

   !> The place of the pendulum that is wanted. A name comes before a number. Errors: none, or several, of that name.
   pure subroutine find_pendulum(names, wanted, place, error)
      type(text_type), intent(in) :: names(:)
      character(len=*), intent(in) :: wanted           !! A name, or a number from 1 on
      integer, intent(out) :: place
      type(error_type), allocatable, intent(out) :: error
      integer :: i, status, found

      place = 0
      found = 0
      do i = 1, size(names)
         if (names(i)%text /= wanted) cycle
         place = i
         found = found + 1
      end do
      if (found == 0 .and. wanted /= '' .and. len(wanted) <= 9 .and. verify(wanted, '0123456789') == 0) then
         read (wanted, '(i9)', iostat=status) place
         if (status == 0 .and. place >= 1 .and. place <= size(names)) return
      end if
      if (found == 1) return
      if (found > 1) then
         call fail(error, code_input, "option --pendulum: several are named '"//shown(wanted)//"'; give a number from 1 to " &
            //integer_text(size(names)))
      else
         call fail(error, code_input, "option --pendulum: none is named '"//shown(wanted)//"', nor is that a number from 1 to " &
            //integer_text(size(names)))
      end if
   end subroutine find_pendulum

end module kyvadlo_pendulum_choice
