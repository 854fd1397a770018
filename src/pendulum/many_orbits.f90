!> Many orbits at once, each evaluated once: their constants, their advances, and their positions at one time. Their
!> periods alone are in `kyvadlo_periods`.
module kyvadlo_many_orbits
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_batch_constants
   use kyvadlo_batch_dispatch, only: any_time_beyond, constants_groups, many_groups, vector_level
   use kyvadlo_numbers_real64, only: is_finite, quiet_nan
   use kyvadlo_orbit, only: orbit_type
   use kyvadlo_start, only: new_orbit, new_rough_orbit
   use kyvadlo_start_kinds, only: start_gaps
   use kyvadlo_status, only: error_type
   use kyvadlo_threads, only: thread_count
   implicit none
   private
   public :: orbits_advance_from_gaps, orbits_constants_from_gaps, orbits_locate_from_gaps
   public :: constants_of_orbit, constants_of_block

contains

   !> T, k, k', K, q, A, phi(T) and lambda T of many orbits with the gaps l - z1 and l + z2: what the functions of an
   !> orbit give after a set-up, in a tenth of the time, by vector kernels; next to the upright (k'**2 < 1/64) by a
   !> set-up.
   !> Domain: 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0, g > 0; NaN elsewhere and for arrays of different
   !> sizes.
   !> Error 8 ulp at worst, of A, which is a difference, 10 (test/unit/test_many_orbits.pf).
   subroutine orbits_constants_from_gaps(length, gravity, upper_gap, lower_rise, constants, highest_level, threads)
      real(real64), intent(in) :: length, gravity                       !! l [m], g [m/s2]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(out) :: constants(:, :)                      !! [s], 1, 1, 1, 1, [1/s], [rad], [rad] (8, n)
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      integer :: block, blocks, orbits, level, sharing

      orbits = size(upper_gap)
      if (size(lower_rise) /= orbits .or. any(shape(constants) /= [printed_constants, orbits])) then
         constants = quiet_nan
         return
      end if
      level = vector_level(highest_level)
      include 'block_loop.inc'

   contains

      subroutine fill_block(start, last)
         integer, intent(in) :: start, last
         real(real64) :: gaps(block_size, gap_columns), found(block_size, constant_columns)
         integer :: i

         call constants_of_block(level, start_gaps, spread(length, 1, last - start + 1), &
            spread(gravity, 1, last - start + 1), upper_gap(start:last), lower_rise(start:last), .false., gaps, found)
         do i = start, last
            constants(:, i) = found(i - start + 1, :printed_constants)
            if (.not. found(i - start + 1, constant_period) > 0) &
               call set_up_constants(length, gravity, upper_gap(i), lower_rise(i), constants(:, i))
         end do
      end subroutine fill_block
   end subroutine orbits_constants_from_gaps

   !> lambda T = phi(T) - pi of many orbits with the gaps l - z1 and l + z2 [rad], (35): what `apsidal_advance` gives
   !> after a set-up, by vector kernels; next to the upright (k'**2 < 1/64) by a set-up.
   !> Domain: 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0; NaN elsewhere and for arrays of different sizes.
   !> Error 8 ulp at worst (test/unit/test_many_orbits.pf).
   subroutine orbits_advance_from_gaps(length, upper_gap, lower_rise, advance, highest_level, threads)
      real(real64), intent(in) :: length                                !! l [m]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(out), dimension(:) :: advance                !! [rad] (n)
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      integer :: block, blocks, orbits, level, sharing

      orbits = size(advance)
      if (size(upper_gap) /= orbits .or. size(lower_rise) /= orbits) then
         advance = quiet_nan
         return
      end if
      level = vector_level(highest_level)
      include 'block_loop.inc'

   contains

      subroutine fill_block(start, last)
         integer, intent(in) :: start, last
         real(real64) :: gaps(block_size, gap_columns), found(block_size, constant_columns)
         real(real64) :: constants(printed_constants)
         integer :: i

         ! The advance does not depend on gravity.
         call constants_of_block(level, start_gaps, spread(length, 1, last - start + 1), &
            spread(1.0_real64, 1, last - start + 1), upper_gap(start:last), lower_rise(start:last), .true., gaps, found)
         do i = start, last
            advance(i) = found(i - start + 1, constant_advance)
            if (found(i - start + 1, constant_period) > 0) cycle
            call set_up_constants(length, 1.0_real64, upper_gap(i), lower_rise(i), constants)
            advance(i) = constants(constant_advance)
         end do
      end subroutine fill_block
   end subroutine orbits_advance_from_gaps

   !> By a set-up; NaN where that refuses.
   subroutine set_up_constants(length, gravity, upper_gap, lower_rise, constants)
      real(real64), intent(in) :: length, gravity, upper_gap, lower_rise
      real(real64), intent(out) :: constants(printed_constants)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      constants = quiet_nan
      if (.not. are_gaps(upper_gap, lower_rise)) return
      call new_orbit(orbit, start_gaps, length, gravity, [upper_gap], [lower_rise], error)
      if (.not. allocated(error)) constants = constants_of_orbit(orbit)
   end subroutine set_up_constants

   !> What `eval orbit` prints of an orbit.
   pure function constants_of_orbit(orbit) result(constants)
      type(orbit_type), intent(in) :: orbit
      real(real64) :: constants(printed_constants)

      constants = [orbit%period(), orbit%modulus(), orbit%complementary_modulus(), orbit%quarter_period(), &
         orbit%nome(), orbit%azimuth_rate(), orbit%azimuth_per_period(), orbit%apsidal_advance()]
   end function constants_of_orbit

   !> Gaps and constants of a block of orbits from heights, gaps or rises, each with its own length and gravity, by the
   !> columns that kyvadlo_batch_constants names. T is not positive where the set-up must tell: next to the upright,
   !> out of the range of plain numbers, and where there is no orbit.
   subroutine constants_of_block(level, start, length, gravity, first, second, only_advance, gaps, constants)
      integer, intent(in) :: level                                      !! `vector_level`
      integer, intent(in) :: start                                      !! `start_heights`, `start_gaps`, `start_rises`
      real(real64), intent(in), dimension(:) :: length, gravity           !! [m], [m/s2] (n), n <= block_size
      real(real64), intent(in), dimension(:) :: first, second             !! [m] (n)
      logical, intent(in) :: only_advance                               !! T and lambda T alone
      real(real64), intent(out) :: gaps(block_size, gap_columns)          !! Those of n
      real(real64), intent(out) :: constants(block_size, constant_columns)
      real(real64) :: given(block_size, 4)
      !> An orbit for what is none.
      real(real64), parameter :: any_orbit(4) = [real(real64) :: 1, 1, 0, 0]
      !> Sums of some are in the range.
      real(real64), parameter :: largest = huge(1.0_real64)/8
      logical, dimension(block_size) :: is_given, is_small
      integer :: n, whole, i

      n = size(length)
      whole = group_size*((n + group_size - 1)/group_size)
      given(:n, 1) = length
      given(:n, 2) = gravity
      given(:n, 3) = first
      given(:n, 4) = second
      do i = 1, 4
         given(n + 1:whole, i) = any_orbit(i)
      end do
      ! The kernels compare, which would raise.
      do i = 1, 4
         if (any_time_beyond(level, whole, given(:whole, i), largest)) exit
      end do
      is_given = .true.
      if (i <= 4) then
         do i = 1, 4
            is_small(:whole) = is_finite(given(:whole, i))
            given(:whole, i) = merge(given(:whole, i), any_orbit(i), is_small(:whole))
            is_given(:whole) = is_given(:whole) .and. is_small(:whole) .and. abs(given(:whole, i)) <= largest
         end do
         do i = 1, 4
            given(:whole, i) = merge(given(:whole, i), any_orbit(i), is_given(:whole))
         end do
      end if
      call constants_groups(level, whole/group_size, start, given(:whole, 1), given(:whole, 2), given(:whole, 3), &
         given(:whole, 4), only_advance, gaps, constants)
      if (.not. all(is_given)) constants(:, constant_period) = &
         merge(constants(:, constant_period), -1.0_real64, is_given)
   end subroutine constants_of_block

   !> Positions, and velocities if wanted, of many orbits with the gaps l - z1 and l + z2 at one time, counted from the
   !> upper turning height at azimuth 0: for orbits that are evaluated once, by vector kernels; next to the upright
   !> (k'**2 < 1/64) by a set-up.
   !> Domain: 0 <= lower_rise < upper_gap <= 2 l - lower_rise, l > 0, g > 0; NaN elsewhere and for arrays of different
   !> sizes.
   !> Error 6 eps l + 3 eps |t| v and 6 eps v + 3 eps |t| (g + v**2/l) at worst, v the greatest speed: the period has
   !> the digits of the kind only (test/unit/test_many_orbits.pf).
   subroutine orbits_locate_from_gaps(length, gravity, upper_gap, lower_rise, time, position, velocity, threads, &
         highest_level)
      real(real64), intent(in) :: length, gravity                       !! l [m], g [m/s2]
      real(real64), intent(in), dimension(:) :: upper_gap, lower_rise     !! l - z1, l + z2 [m] (n)
      real(real64), intent(in) :: time                                  !! [s]
      real(real64), intent(out), dimension(:, :) :: position            !! [m] (3, n)
      real(real64), intent(out), dimension(:, :), optional :: velocity  !! [m/s] (3, n)
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer :: block, blocks, orbits, level, sharing
      logical :: fit

      orbits = size(upper_gap)
      fit = size(lower_rise) == orbits .and. all(shape(position) == [3, orbits]) .and. is_finite(time)
      if (present(velocity)) fit = fit .and. all(shape(velocity) == [3, orbits])
      if (.not. fit) then
         position = quiet_nan
         if (present(velocity)) velocity = quiet_nan
         return
      end if
      level = vector_level(highest_level)
      include 'block_loop.inc'

   contains

      subroutine fill_block(start, last)
         integer, intent(in) :: start, last
         real(real64) :: gaps(block_size, gap_columns), constants(block_size, constant_columns)
         real(real64) :: placed(block_size, place_columns), lengths(block_size), at_once(3)
         integer :: i, n

         n = last - start + 1
         lengths = length
         call constants_of_block(level, start_gaps, lengths(:n), spread(gravity, 1, n), upper_gap(start:last), &
            lower_rise(start:last), .true., gaps, constants)
         call many_groups(level, (n + group_size - 1)/group_size, time, lengths, gaps, constants, present(velocity), &
            placed)
         do i = start, last
            if (placed(i - start + 1, place_kept) > 0) then
               position(:, i) = placed(i - start + 1, 1:3)
               if (present(velocity)) velocity(:, i) = placed(i - start + 1, 4:6)
            else if (present(velocity)) then
               call set_up_place(length, gravity, upper_gap(i), lower_rise(i), time, position(:, i), velocity(:, i))
            else
               call set_up_place(length, gravity, upper_gap(i), lower_rise(i), time, position(:, i), at_once)
            end if
         end do
      end subroutine fill_block
   end subroutine orbits_locate_from_gaps

   !> By a set-up; NaN where that refuses.
   subroutine set_up_place(length, gravity, upper_gap, lower_rise, time, position, velocity)
      real(real64), intent(in) :: length, gravity, upper_gap, lower_rise, time
      real(real64), intent(out) :: position(3), velocity(3)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error

      position = quiet_nan
      velocity = quiet_nan
      if (.not. are_gaps(upper_gap, lower_rise)) return
      call new_rough_orbit(orbit, start_gaps, length, gravity, [upper_gap], [lower_rise], error)
      if (.not. allocated(error)) call orbit%locate(time, position, velocity)
   end subroutine set_up_place

   !> Whether to try a set-up: its message takes many times as long as an orbit.
   elemental logical function are_gaps(upper_gap, lower_rise)
      real(real64), intent(in) :: upper_gap, lower_rise

      are_gaps = is_finite(upper_gap) .and. is_finite(lower_rise)
      if (are_gaps) are_gaps = lower_rise >= 0 .and. lower_rise < upper_gap
   end function are_gaps
end module kyvadlo_many_orbits
