!> Chooses at run time among the batch kernels compiled for several levels of the processor.
module kyvadlo_batch_dispatch
   use, intrinsic :: iso_fortran_env, only: real64
   use, intrinsic :: iso_c_binding, only: c_int
   use kyvadlo_batch_constants
   use kyvadlo_batch_kernel_baseline, only: place_baseline => place_group, rates_baseline => place_group_rates, &
      azimuths_baseline => azimuth_group, &
      beyond_baseline => any_beyond, periods_baseline => period_group, advances_baseline => advance_group, &
      gaps_baseline => gaps_group, constants_baseline => constants_group, &
      many_baseline => many_group, many_rates_baseline => many_group_rates
   use kyvadlo_batch_kernel_baseline_single, only: place_baseline_single => place_group, &
      rates_baseline_single => place_group_rates
   use kyvadlo_batch_kernel_baseline_short, only: place_baseline_short => place_group, &
      rates_baseline_short => place_group_rates
   use kyvadlo_batch_kernel_v3, only: place_v3 => place_group, rates_v3 => place_group_rates, &
      azimuths_v3 => azimuth_group, &
      beyond_v3 => any_beyond, periods_v3 => period_group, advances_v3 => advance_group, &
      gaps_v3 => gaps_group, constants_v3 => constants_group, &
      many_v3 => many_group, many_rates_v3 => many_group_rates
   use kyvadlo_batch_kernel_v3_single, only: place_v3_single => place_group, &
      rates_v3_single => place_group_rates
   use kyvadlo_batch_kernel_v3_short, only: place_v3_short => place_group, &
      rates_v3_short => place_group_rates
   use kyvadlo_batch_kernel_v4, only: place_v4 => place_group, rates_v4 => place_group_rates, &
      azimuths_v4 => azimuth_group, &
      beyond_v4 => any_beyond, periods_v4 => period_group, advances_v4 => advance_group, &
      gaps_v4 => gaps_group, constants_v4 => constants_group, &
      many_v4 => many_group, many_rates_v4 => many_group_rates
   use kyvadlo_batch_kernel_v4_single, only: place_v4_single => place_group, &
      rates_v4_single => place_group_rates
   use kyvadlo_batch_kernel_v4_short, only: place_v4_short => place_group, &
      rates_v4_short => place_group_rates
   implicit none
   private
   public :: vector_level, place_groups, place_groups_rates, azimuth_groups, period_groups, constants_groups, &
      many_groups, any_time_beyond

   !> Levels of the processor: 0 baseline, 1 x86-64-v3, 2 x86-64-v4.
   integer, parameter :: levels = 3

   interface
      pure integer(c_int) function processor_level() bind(c, name='kyvadlo_vector_level')
         import :: c_int
      end function processor_level
   end interface

contains

   !> The level of the kernels to use: what the processor has, or less if less is wanted. 0 baseline, 1 x86-64-v3, 2
   !> x86-64-v4.
   pure integer function vector_level(wanted) result(level)
      integer, intent(in), optional :: wanted

      level = processor_level()
      if (present(wanted)) level = max(0, min(level, wanted))
   end function vector_level

   pure subroutine place_groups(level, b, start, groups, time, x, y, z)
      integer, intent(in) :: level, groups
      type(batch_type), intent(in) :: b
      type(start_type), intent(in) :: start
      real(real64), intent(in) :: time(group_size*groups)
      real(real64), intent(out), dimension(group_size*groups) :: x, y, z

      select case (level + levels*b%grade)
      case (1)
         call place_v3(b, start, groups, time, x, y, z)
      case (2)
         call place_v4(b, start, groups, time, x, y, z)
      case (3)
         call place_baseline_single(b, start, groups, time, x, y, z)
      case (4)
         call place_v3_single(b, start, groups, time, x, y, z)
      case (5)
         call place_v4_single(b, start, groups, time, x, y, z)
      case (6)
         call place_baseline_short(b, start, groups, time, x, y, z)
      case (7)
         call place_v3_short(b, start, groups, time, x, y, z)
      case (8)
         call place_v4_short(b, start, groups, time, x, y, z)
      case default
         call place_baseline(b, start, groups, time, x, y, z)
      end select
   end subroutine place_groups

   pure subroutine place_groups_rates(level, b, start, groups, time, x, y, z, vx, vy, vz)
      integer, intent(in) :: level, groups
      type(batch_type), intent(in) :: b
      type(start_type), intent(in) :: start
      real(real64), intent(in) :: time(group_size*groups)
      real(real64), intent(out), dimension(group_size*groups) :: x, y, z, vx, vy, vz

      select case (level + levels*b%grade)
      case (1)
         call rates_v3(b, start, groups, time, x, y, z, vx, vy, vz)
      case (2)
         call rates_v4(b, start, groups, time, x, y, z, vx, vy, vz)
      case (3)
         call rates_baseline_single(b, start, groups, time, x, y, z, vx, vy, vz)
      case (4)
         call rates_v3_single(b, start, groups, time, x, y, z, vx, vy, vz)
      case (5)
         call rates_v4_single(b, start, groups, time, x, y, z, vx, vy, vz)
      case (6)
         call rates_baseline_short(b, start, groups, time, x, y, z, vx, vy, vz)
      case (7)
         call rates_v3_short(b, start, groups, time, x, y, z, vx, vy, vz)
      case (8)
         call rates_v4_short(b, start, groups, time, x, y, z, vx, vy, vz)
      case default
         call rates_baseline(b, start, groups, time, x, y, z, vx, vy, vz)
      end select
   end subroutine place_groups_rates

   pure subroutine azimuth_groups(level, b, start, is_plane, groups, time, azimuth)
      integer, intent(in) :: level, groups
      type(batch_type), intent(in) :: b
      type(start_type), intent(in) :: start
      logical, intent(in) :: is_plane
      real(real64), intent(in) :: time(group_size*groups)
      real(real64), intent(out) :: azimuth(group_size*groups)

      select case (level)
      case (2)
         call azimuths_v4(b, start, is_plane, groups, time, azimuth)
      case (1)
         call azimuths_v3(b, start, is_plane, groups, time, azimuth)
      case default
         call azimuths_baseline(b, start, is_plane, groups, time, azimuth)
      end select
   end subroutine azimuth_groups

   pure subroutine period_groups(level, groups, length, factor, upper_gap, lower_rise, period)
      integer, intent(in) :: level, groups
      real(real64), intent(in) :: length, factor
      real(real64), intent(in), dimension(group_size*groups) :: upper_gap, lower_rise
      real(real64), intent(out), dimension(group_size*groups) :: period

      select case (level)
      case (2)
         call periods_v4(groups, length, factor, upper_gap, lower_rise, period)
      case (1)
         call periods_v3(groups, length, factor, upper_gap, lower_rise, period)
      case default
         call periods_baseline(groups, length, factor, upper_gap, lower_rise, period)
      end select
   end subroutine period_groups

   !> Gaps and constants, or T and lambda T alone, from a start by heights, gaps or rises.
   pure subroutine constants_groups(level, groups, start, length, gravity, first, second, only_advance, gaps, constants)
      integer, intent(in) :: level, groups, start
      real(real64), intent(in), dimension(group_size*groups) :: length, gravity, first, second
      logical, intent(in) :: only_advance
      real(real64), intent(inout) :: gaps(block_size, gap_columns), constants(block_size, constant_columns)

      select case (level + merge(levels, 0, only_advance))
      case (1)
         call gaps_v3(groups, start, length, first, second, gaps)
         call constants_v3(groups, length, gravity, gaps, constants)
      case (2)
         call gaps_v4(groups, start, length, first, second, gaps)
         call constants_v4(groups, length, gravity, gaps, constants)
      case (3)
         call gaps_baseline(groups, start, length, first, second, gaps)
         call advances_baseline(groups, length, gravity, gaps, constants)
      case (4)
         call gaps_v3(groups, start, length, first, second, gaps)
         call advances_v3(groups, length, gravity, gaps, constants)
      case (5)
         call gaps_v4(groups, start, length, first, second, gaps)
         call advances_v4(groups, length, gravity, gaps, constants)
      case default
         call gaps_baseline(groups, start, length, first, second, gaps)
         call constants_baseline(groups, length, gravity, gaps, constants)
      end select
   end subroutine constants_groups

   !> Positions, and velocities if wanted, of many orbits at one time.
   pure subroutine many_groups(level, groups, time, length, gaps, constants, with_velocity, placed)
      integer, intent(in) :: level, groups
      real(real64), intent(in) :: time, length(group_size*groups)
      real(real64), intent(in) :: gaps(block_size, gap_columns), constants(block_size, constant_columns)
      logical, intent(in) :: with_velocity
      real(real64), intent(inout) :: placed(block_size, place_columns)

      select case (level + merge(levels, 0, with_velocity))
      case (1)
         call many_v3(groups, time, length, gaps, constants, placed)
      case (2)
         call many_v4(groups, time, length, gaps, constants, placed)
      case (3)
         call many_rates_baseline(groups, time, length, gaps, constants, placed)
      case (4)
         call many_rates_v3(groups, time, length, gaps, constants, placed)
      case (5)
         call many_rates_v4(groups, time, length, gaps, constants, placed)
      case default
         call many_baseline(groups, time, length, gaps, constants, placed)
      end select
   end subroutine many_groups

   !> Whether a time is NaN or beyond what the kernels reduce.
   pure logical function any_time_beyond(level, n, time, limit)
      integer, intent(in) :: level, n
      real(real64), intent(in) :: time(n), limit

      select case (level)
      case (2)
         any_time_beyond = beyond_v4(n, time, limit)
      case (1)
         any_time_beyond = beyond_v3(n, time, limit)
      case default
         any_time_beyond = beyond_baseline(n, time, limit)
      end select
   end function any_time_beyond
end module kyvadlo_batch_dispatch
