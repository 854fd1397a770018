!> The command `study` of a build without quadruple precision, in which a study measures errors: it says so.
module kyvadlo_study_command
   use kyvadlo_command_line, only: arguments_type
   use kyvadlo_status, only: code_input, error_type, fail
   implicit none
   private
   public :: study_command

contains

   subroutine study_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error

      call fail(error, code_input, arguments%command// &
         ': this build has no quadruple precision, in which a study measures errors')
   end subroutine study_command

end module kyvadlo_study_command
