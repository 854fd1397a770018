!> The period alone, without setting up an orbit: of one orbit or of many.
module kyvadlo_periods
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_batch_constants, only: block_size, group_size
   use kyvadlo_batch_kernel_single, only: period_point
   use kyvadlo_batch_dispatch, only: any_time_beyond, vector_level, period_groups
   use kyvadlo_numbers_real64, only: is_finite, quiet_nan
   use kyvadlo_threads, only: thread_count
   implicit none
   private
   public :: orbit_period_from_gaps, orbits_period_from_gaps

contains

   !> T, (16), of the orbit with the gaps l - z1 and l + z2 [s]: what `period` gives after a set-up, in a twentieth of
   !> the time.
   !> Domain: 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0, g > 0; NaN elsewhere.
   !> Error 3 ulp at worst (test/unit/test_periods.pf).
   elemental real(real64) function orbit_period_from_gaps(length, gravity, upper_gap, lower_rise) result(period)
      real(real64), intent(in) :: length, gravity      !! l [m], g [m/s2]
      real(real64), intent(in) :: upper_gap, lower_rise  !! l - z1, l + z2 [m]
      real(real64) :: unit, factor

      period = quiet_nan
      ! == and /= never raise, also of NaN.
      if (upper_gap /= upper_gap .or. lower_rise /= lower_rise) return
      call scale_lengths(length, gravity, unit, factor)
      if (factor /= factor) return
      call period_point(length*unit, factor, upper_gap*unit, lower_rise*unit, period)
   end function orbit_period_from_gaps

   !> T of many orbits of one pendulum, by vector kernels; each one by itself, as in `locate`.
   !> Domain and error as `orbit_period_from_gaps`; arrays of different sizes give NaN.
   subroutine orbits_period_from_gaps(length, gravity, upper_gap, lower_rise, period, highest_level, threads)
      real(real64), intent(in) :: length, gravity                       !! l [m], g [m/s2]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(out), dimension(:) :: period                 !! [s] (n)
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      real(real64) :: unit, factor
      integer :: block, blocks, orbits, level, sharing

      orbits = size(period)
      if (size(upper_gap) /= orbits .or. size(lower_rise) /= orbits) then
         period = quiet_nan
         return
      end if
      call scale_lengths(length, gravity, unit, factor)
      if (factor /= factor) then
         period = quiet_nan
         return
      end if
      level = vector_level(highest_level)
      include 'block_loop.inc'

   contains

      subroutine fill_block(start, last)
         integer, intent(in) :: start, last
         real(real64), dimension(block_size) :: top, bottom, found
         logical :: is_given(block_size), has_nan
         integer :: points

         points = last - start + 1
         top(:points) = upper_gap(start:last)*unit
         bottom(:points) = lower_rise(start:last)*unit
         top(points + 1:) = length*unit
         bottom(points + 1:) = 0
         has_nan = any_time_beyond(level, block_size, top, huge(top))
         if (.not. has_nan) has_nan = any_time_beyond(level, block_size, bottom, huge(bottom))
         if (has_nan) then
            ! The kernels compare, which would raise.
            is_given = is_finite(top) .and. is_finite(bottom)
            top = merge(top, length*unit, is_given)
            bottom = merge(bottom, 0.0_real64, is_given)
         end if
         call period_groups(level, (points + group_size - 1)/group_size, length*unit, factor, top, bottom, found)
         if (has_nan) found = merge(found, quiet_nan, is_given)
         period(start:last) = found(:points)
      end subroutine fill_block
   end subroutine orbits_period_from_gaps

   !> The power of 4 that brings the length near 1, and pi l sqrt(2)/sqrt(g) in seconds for lengths times it.
   pure subroutine scale_lengths(length, gravity, unit, factor)
      real(real64), intent(in) :: length, gravity
      real(real64), intent(out) :: unit, factor
      real(real64), parameter :: root_two_pi = acos(-1.0_real64)*sqrt(2.0_real64)
      integer :: power

      unit = 1
      factor = quiet_nan
      ! Without gravity, or with an infinite one, there is no period: the set-ups refuse both.
      if (length /= length .or. gravity /= gravity) return
      if (.not. (length > 0 .and. gravity > 0 .and. gravity <= huge(gravity))) return
      power = exponent(length)/2
      unit = scale(1.0_real64, -2*power)
      factor = root_two_pi*(length*unit)/sqrt(gravity)*scale(1.0_real64, power)
   end subroutine scale_lengths
end module kyvadlo_periods
