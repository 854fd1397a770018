!> Chooses at run time among the double-double kernels compiled for several levels of the processor.
module kyvadlo_double_double_dispatch
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_double_double_constants
   use kyvadlo_double_double_kernel_baseline, only: place_baseline => wide_place_group, &
      rates_baseline => wide_rates_group
   use kyvadlo_double_double_kernel_v3, only: place_v3 => wide_place_group, rates_v3 => wide_rates_group
   use kyvadlo_double_double_kernel_v4, only: place_v4 => wide_place_group, rates_v4 => wide_rates_group
   implicit none
   private
   public :: wide_place_groups, wide_rates_groups

contains

   pure subroutine wide_place_groups(level, b, groups, time, x, y, z)
      integer, intent(in) :: level  !! As `vector_level` of kyvadlo_batch_dispatch tells
      type(wide_batch_type), intent(in) :: b
      integer, intent(in) :: groups
      real(real64), intent(in) :: time(wide_block_size, 2)
      real(real64), intent(out), dimension(wide_block_size, 2) :: x, y, z

      select case (level)
      case (2)
         call place_v4(b, groups, time, x, y, z)
      case (1)
         call place_v3(b, groups, time, x, y, z)
      case default
         call place_baseline(b, groups, time, x, y, z)
      end select
   end subroutine wide_place_groups

   pure subroutine wide_rates_groups(level, b, groups, time, x, y, z, vx, vy, vz)
      integer, intent(in) :: level  !! As `vector_level` of kyvadlo_batch_dispatch tells
      type(wide_batch_type), intent(in) :: b
      integer, intent(in) :: groups
      real(real64), intent(in) :: time(wide_block_size, 2)
      real(real64), intent(out), dimension(wide_block_size, 2) :: x, y, z, vx, vy, vz

      select case (level)
      case (2)
         call rates_v4(b, groups, time, x, y, z, vx, vy, vz)
      case (1)
         call rates_v3(b, groups, time, x, y, z, vx, vy, vz)
      case default
         call rates_baseline(b, groups, time, x, y, z, vx, vy, vz)
      end select
   end subroutine wide_rates_groups
end module kyvadlo_double_double_dispatch
