!> Positions and velocities at many times of one orbit.
!>
!> `batch.inc` holds the public procedures, `batch_block.inc` what happens to a block, `batch_loop.inc` the kernels.
module kyvadlo_batch_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64, int64
   use kyvadlo_orbit_real32
   use kyvadlo_motion_real32
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#include "batch.inc"
#include "batch_block.inc"
end module kyvadlo_batch_real32

module kyvadlo_batch_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64, int64
   use kyvadlo_orbit_real64
   use kyvadlo_motion_real64
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real64
#define kernel_takes_arguments
#include "batch.inc"
#include "batch_block.inc"
#undef kernel_takes_arguments
end module kyvadlo_batch_real64

#ifndef KYVADLO_NO_REAL128
!> The kernels are real64: in real128 the scalar form serves, in the same blocks and threads.
module kyvadlo_batch_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real64, int64
   use kyvadlo_orbit_real128
   use kyvadlo_motion_real128
   use kyvadlo_numbers_real128, only: quiet_nan
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch
   use kyvadlo_threads, only: thread_count
   use kyvadlo_motion_kinds
   use kyvadlo_pairs_real128
#include "batch.inc"

   !> Up to `block_size` points.
   pure subroutine place_block(orbit, level, n, time, x, y, z, vx, vy, vz)
      type(orbit_type), intent(in) :: orbit
      integer, intent(in) :: level, n  !! The level is that of the real64 kernels: nothing to choose here
      real(wp), intent(in) :: time(n)
      real(wp), intent(out), dimension(n) :: x, y, z
      real(wp), intent(out), dimension(n), optional :: vx, vy, vz
      real(wp) :: position(3), velocity(3)
      integer :: i

      if (level < 0) return
      do i = 1, n
         if (present(vx)) then
            call locate(orbit, time(i), position, velocity)
         else
            call locate(orbit, time(i), position)
         end if
         x(i) = position(1)
         y(i) = position(2)
         z(i) = position(3)
         if (.not. present(vx)) cycle
         vx(i) = velocity(1)
         vy(i) = velocity(2)
         vz(i) = velocity(3)
      end do
   end subroutine place_block
end module kyvadlo_batch_real128
#endif

module kyvadlo_batch
   use kyvadlo_batch_real32
   use kyvadlo_batch_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_batch_real128
#endif
   implicit none
   public
end module kyvadlo_batch
