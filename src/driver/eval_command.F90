!> The command `eval`: requests from the command line or from standard input, answers to standard output.
module kyvadlo_eval_command
   use, intrinsic :: iso_fortran_env, only: real32, real64
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real128
#endif
   use kyvadlo_command_line, only: arguments_type, option_given, option_value
   use kyvadlo_eval, only: answer_request
   use kyvadlo_eval_requests, only: requests
   use kyvadlo_standard_io, only: close_output, input_type, longest_line, message, open_output, output_type, read_line
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: integer_text, join
   implicit none
   private
   public :: eval_command

contains

   !> Runs the command. An error of the system comes back in `error`; a request that failed makes `status` 1.
   subroutine eval_command(arguments, status, error)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      type(input_type) :: input
      character(len=:), allocatable :: line, answer, kind_word
      type(error_type), allocatable :: input_error
      logical :: failed, ended, is_cut, by_modulus

      status = 0
      kind_word = option_value(arguments, '--kind', 'double')
      by_modulus = option_given(arguments, '--modulus')
      call open_output(output, '', error)
      if (option_given(arguments, '--list')) then
         call list_requests(output)
      else if (size(arguments%operands) > 0) then
         call answer_in_kind(kind_word, join(arguments%operands, ' '), by_modulus, answer, failed)
         if (failed) then
            call message('error: '//answer)
            status = 1
         else
            call output%put(answer)
         end if
      else
         do
            call read_line(input, output, line, ended, is_cut, input_error)
            if (ended) exit
            if (is_cut) then
               failed = .true.
               answer = 'a request has at most '//integer_text(longest_line)//' bytes'
            else
               call answer_in_kind(kind_word, line, by_modulus, answer, failed)
            end if
            if (failed) then
               answer = 'error: '//answer
               status = 1
            end if
            call output%put(answer)
         end do
      end if
      call close_output(output, error)
      if (allocated(input_error) .and. .not. allocated(error)) call move_alloc(input_error, error)
   end subroutine eval_command

   subroutine answer_in_kind(kind_word, line, by_modulus, answer, failed)
      character(len=*), intent(in) :: kind_word, line
      logical, intent(in) :: by_modulus
      character(len=:), allocatable, intent(out) :: answer
      logical, intent(out) :: failed

      select case (kind_word)
      case ('single')
         call answer_request(1.0_real32, line, by_modulus, answer, failed)
#ifndef KYVADLO_NO_REAL128
      case ('quad')
         call answer_request(1.0_real128, line, by_modulus, answer, failed)
#endif
      case default
         call answer_request(1.0_real64, line, by_modulus, answer, failed)
      end select
   end subroutine answer_in_kind

   !> Every request on one line: name and arguments, results, domain.
   subroutine list_requests(output)
      type(output_type), intent(inout) :: output
      character(len=:), allocatable :: line
      integer :: i

      do i = 1, size(requests)
         line = requests(i)%name//requests(i)%arguments//' -> '//trim(requests(i)%results)
         if (requests(i)%domain /= '') line = line//'   ('//trim(requests(i)%domain)//')'
         call output%put(line)
      end do
   end subroutine list_requests

end module kyvadlo_eval_command
