!> Answers thousands of arguments for test/reference/function_campaign.py:
!>
!>     function_values QUESTION BITS PARTS COUNT
!>
!> QUESTION is a reference file without .dat, BITS the kind, PARTS the number of results, COUNT that of arguments. Rows
!> `set argument...` come from standard input; for every part of a row goes out a line `promise slack value`.
program function_values
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128, input_unit, output_unit
   use elliptic_answers, only: elliptic_answer
   use promises, only: promise_type, promise_of
   implicit none

   character(len=40) :: question, set
   integer :: bits, parts, count

   call get_command_argument(1, question)
   bits = integer_argument(2)
   parts = integer_argument(3)
   count = integer_argument(4)
   call answer_rows()

contains

   subroutine answer_rows()
      real(real128) :: arguments(count), answers(parts)
      type(promise_type) :: promise
      integer :: status, part

      do
         read (input_unit, *, iostat=status) set, arguments
         if (status /= 0) exit
         select case (bits)
         case (32)
            answers = elliptic_answer(trim(question), real(arguments, real32), parts)
         case (64)
            answers = elliptic_answer(trim(question), real(arguments, real64), parts)
         case default
            answers = elliptic_answer(trim(question), arguments, parts)
         end select
         do part = 1, parts
            promise = promise_of(trim(question), part, trim(set))
            write (output_unit, '(2(f0.1, 1x), es48.36e5)') promise%ulp, promise%slack, answers(part)
         end do
      end do
   end subroutine answer_rows

   integer function integer_argument(number) result(value)
      integer, intent(in) :: number
      character(len=20) :: word

      call get_command_argument(number, word)
      read (word, *) value
   end function integer_argument

end program function_values
