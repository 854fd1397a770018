!> The command `sweep` where MPI or NetCDF is: the program that is linked with them does it.
module kyvadlo_sweep_command
   use kyvadlo_command_line, only: arguments_type
   use kyvadlo_standard_io, only: become_program
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: sweep_command

contains

   !> Comes back only with an error.
   subroutine sweep_command(arguments, status, error)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status
      type(error_type), allocatable, intent(out) :: error

      status = 2
      call become_program(KYVADLO_DATA_PROGRAM, arguments%command, error)
   end subroutine sweep_command

end module kyvadlo_sweep_command
