!> Chooses at run time among the kernels of the derivatives compiled for several levels of the processor.
module kyvadlo_derivative_dispatch
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_batch_constants, only: batch_type, start_type
   use kyvadlo_derivative_constants
   use kyvadlo_derivative_kernel_baseline, only: all_baseline => differentiate, &
      halves_baseline => count_halves
   use kyvadlo_derivative_kernel_v3, only: all_v3 => differentiate, halves_v3 => count_halves
   use kyvadlo_derivative_kernel_v4, only: all_v4 => differentiate, halves_v4 => count_halves
   implicit none
   private
   public :: differentiate_at, count_halves_at

contains

   pure subroutine differentiate_at(level, frame, c, time, whole, states, results)
      integer, intent(in) :: level  !! As `vector_level` gives it
      type(frame_type), intent(in) :: frame
      type(passage_type), intent(in) :: c
      real(real64), intent(in) :: time(lanes), whole(lanes)
      real(real64), intent(out) :: states(lanes, 6), results(lanes, 6, 9)

      select case (level)
      case (2)
         call all_v4(frame, c, time, whole, states, results)
      case (1)
         call all_v3(frame, c, time, whole, states, results)
      case default
         call all_baseline(frame, c, time, whole, states, results)
      end select
   end subroutine differentiate_at

   pure subroutine count_halves_at(level, b, start, n, time, halves)
      integer, intent(in) :: level, n
      type(batch_type), intent(in) :: b
      type(start_type), intent(in) :: start
      real(real64), intent(in) :: time(n)
      real(real64), intent(out) :: halves(n)

      select case (level)
      case (2)
         call halves_v4(b, start, n, time, halves)
      case (1)
         call halves_v3(b, start, n, time, halves)
      case default
         call halves_baseline(b, start, n, time, halves)
      end select
   end subroutine count_halves_at
end module kyvadlo_derivative_dispatch
