!> Many orbits of one pendulum at once, each evaluated once: their advances, and their positions at one time. Their
!> periods are in `kyvadlo_periods`.
module kyvadlo_many_orbits
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_batch_constants, only: block_size, group_size
   use kyvadlo_batch_dispatch, only: advance_groups, any_time_beyond, vector_level
   use kyvadlo_numbers_real64, only: is_finite, quiet_nan
   use kyvadlo_orbit, only: orbit_type
   use kyvadlo_start, only: new_orbit, new_rough_orbit
   use kyvadlo_start_kinds, only: start_gaps
   use kyvadlo_status, only: error_type
   use kyvadlo_threads, only: thread_count
   implicit none
   private
   public :: orbits_advance_from_gaps, orbits_locate_from_gaps

contains

   !> lambda T = phi(T) - pi of many orbits with the gaps l - z1 and l + z2 [rad], (35): what `apsidal_advance` gives
   !> after a set-up, in a tenth of the time, by vector kernels; next to the upright (k'**2 < 1/64) by a set-up. NaN
   !> unless 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0; arrays of different sizes give NaN.
   !> Error 8 ulp at worst (test/unit/test_many_orbits.pf).
   subroutine orbits_advance_from_gaps(length, upper_gap, lower_rise, advance, highest_level, threads)
      real(real64), intent(in) :: length                                !! l [m]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(out), dimension(:) :: advance                !! [rad] (n)
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      real(real64) :: unit
      integer :: block, blocks, orbits, level, sharing

      advance = quiet_nan
      orbits = size(advance)
      if (size(upper_gap) /= orbits .or. size(lower_rise) /= orbits) return
      if (.not. is_finite(length)) return
      if (.not. length > 0) return
      ! Lengths near 1, by a power of 2: twice a length, and products of three, stay in the range.
      unit = scale(1.0_real64, -max(-1021, min(1021, exponent(length))))
      level = vector_level(highest_level)
      blocks = (orbits + block_size - 1)/block_size
      sharing = thread_count(threads, orbits, blocks)
      if (sharing > 1) then
         !$omp parallel do schedule(static) num_threads(sharing)
         do block = 1, blocks
            call fill_block(block)
         end do
      else
         do block = 1, blocks
            call fill_block(block)
         end do
      end if

   contains

      subroutine fill_block(block)
         integer, intent(in) :: block
         real(real64), dimension(block_size) :: top, bottom, found
         logical :: is_given(block_size), has_nan
         integer :: start, last, points, i

         start = (block - 1)*block_size + 1
         last = min(orbits, start + block_size - 1)
         points = last - start + 1
         top(:points) = upper_gap(start:last)*unit
         bottom(:points) = lower_rise(start:last)*unit
         top(points + 1:) = length*unit
         bottom(points + 1:) = 0
         ! The kernels compare, which would raise.
         has_nan = any_time_beyond(level, block_size, top, 2*length*unit)
         if (.not. has_nan) has_nan = any_time_beyond(level, block_size, bottom, 2*length*unit)
         is_given = .true.
         if (has_nan) then
            is_given = is_finite(top) .and. is_finite(bottom)
            top = merge(top, length*unit, is_given)
            bottom = merge(bottom, 0.0_real64, is_given)
            is_given = is_given .and. abs(top) <= 2*length*unit .and. abs(bottom) <= 2*length*unit
            top = merge(top, length*unit, is_given)
            bottom = merge(bottom, 0.0_real64, is_given)
         end if
         call advance_groups(level, (points + group_size - 1)/group_size, length*unit, top, bottom, found)
         do i = 1, points
            if (.not. is_given(i)) cycle
            if (found(i) >= 0) then
               advance(start + i - 1) = found(i)
            else
               call by_set_up(upper_gap(start + i - 1), lower_rise(start + i - 1), advance(start + i - 1))
            end if
         end do
      end subroutine fill_block

      !> The advance does not depend on gravity.
      subroutine by_set_up(upper_gap, lower_rise, advance)
         real(real64), intent(in) :: upper_gap, lower_rise
         real(real64), intent(out) :: advance
         type(orbit_type) :: orbit
         type(error_type), allocatable :: error

         advance = quiet_nan
         if (.not. (lower_rise >= 0 .and. lower_rise < upper_gap)) return
         call new_orbit(orbit, start_gaps, length, 1.0_real64, [upper_gap], [lower_rise], error)
         if (.not. allocated(error)) advance = orbit%apsidal_advance()
      end subroutine by_set_up
   end subroutine orbits_advance_from_gaps

   !> Positions, and velocities if wanted, of many orbits with the gaps l - z1 and l + z2 at one time, counted from the
   !> upper turning height at azimuth 0: for orbits that are evaluated once, in half the time of a set-up with `locate`.
   !> NaN unless 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0, g > 0; arrays of different sizes give NaN.
   !> Error 3 eps (l + |t| v) and 3 eps (v + |t| (g + v**2/l)) at worst, v the greatest speed: the period has the digits
   !> of the kind only (test/unit/test_many_orbits.pf).
   subroutine orbits_locate_from_gaps(length, gravity, upper_gap, lower_rise, time, position, velocity, threads)
      real(real64), intent(in) :: length, gravity                       !! l [m], g [m/s2]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(in) :: time                                  !! [s]
      real(real64), intent(out), dimension(:, :) :: position            !! [m] (3, n)
      real(real64), intent(out), dimension(:, :), optional :: velocity  !! [m/s] (3, n)
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      integer :: block, blocks, orbits, sharing
      logical :: fit

      orbits = size(upper_gap)
      fit = size(lower_rise) == orbits .and. all(shape(position) == [3, orbits])
      if (present(velocity)) fit = fit .and. all(shape(velocity) == [3, orbits])
      if (.not. fit) then
         position = quiet_nan
         if (present(velocity)) velocity = quiet_nan
         return
      end if
      blocks = (orbits + block_size - 1)/block_size
      sharing = thread_count(threads, orbits, blocks)
      if (sharing > 1) then
         !$omp parallel do schedule(static) num_threads(sharing)
         do block = 1, blocks
            call fill_block(block)
         end do
      else
         do block = 1, blocks
            call fill_block(block)
         end do
      end if

   contains

      subroutine fill_block(block)
         integer, intent(in) :: block
         type(orbit_type) :: orbit
         type(error_type), allocatable :: error
         integer :: i

         do i = (block - 1)*block_size + 1, min(orbits, block*block_size)
            call new_rough_orbit(orbit, start_gaps, length, gravity, upper_gap(i:i), lower_rise(i:i), error)
            ! Of no orbit the position is NaN.
            if (present(velocity)) then
               call orbit%locate(time, position(:, i), velocity(:, i))
            else
               call orbit%locate(time, position(:, i))
            end if
         end do
      end subroutine fill_block
   end subroutine orbits_locate_from_gaps
end module kyvadlo_many_orbits
