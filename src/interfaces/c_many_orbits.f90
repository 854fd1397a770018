!> Many orbits at once, each evaluated once, in C. Documented in kyvadlo.h.
module kyvadlo_c_many_orbits
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_size_t
   use kyvadlo, only: orbits_advance_from_gaps, orbits_constants_from_gaps, orbits_locate_from_gaps, &
      orbits_period_from_gaps
   implicit none
   private

   !> The library counts in default integers: longer arrays go in pieces.
   integer(c_size_t), parameter :: longest = 2**28

contains

   subroutine kyvadlo_orbits_period_from_gaps(length, gravity, count, upper_gaps, lower_rises, periods, threads) bind(c)
      real(c_double), value :: length, gravity
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: upper_gaps(count), lower_rises(count)
      real(c_double), intent(out) :: periods(count)
      integer(c_int), value :: threads
      integer(c_size_t) :: start, last

      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call orbits_period_from_gaps(length, gravity, upper_gaps(start:last), lower_rises(start:last), &
            periods(start:last), threads=int(threads))
      end do
   end subroutine kyvadlo_orbits_period_from_gaps

   subroutine kyvadlo_orbits_advance_from_gaps(length, count, upper_gaps, lower_rises, advances, threads) bind(c)
      real(c_double), value :: length
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: upper_gaps(count), lower_rises(count)
      real(c_double), intent(out) :: advances(count)
      integer(c_int), value :: threads
      integer(c_size_t) :: start, last

      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call orbits_advance_from_gaps(length, upper_gaps(start:last), lower_rises(start:last), advances(start:last), &
            threads=int(threads))
      end do
   end subroutine kyvadlo_orbits_advance_from_gaps

   subroutine kyvadlo_orbits_constants_from_gaps(length, gravity, count, upper_gaps, lower_rises, constants, threads) &
         bind(c)
      real(c_double), value :: length, gravity
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: upper_gaps(count), lower_rises(count)
      real(c_double), intent(out) :: constants(8, count)
      integer(c_int), value :: threads
      integer(c_size_t) :: start, last

      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call orbits_constants_from_gaps(length, gravity, upper_gaps(start:last), lower_rises(start:last), &
            constants(:, start:last), threads=int(threads))
      end do
   end subroutine kyvadlo_orbits_constants_from_gaps

   subroutine kyvadlo_orbits_locate_from_gaps(length, gravity, count, upper_gaps, lower_rises, time, positions, &
         velocities, threads) bind(c)
      real(c_double), value :: length, gravity, time
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: upper_gaps(count), lower_rises(count)
      real(c_double), intent(out) :: positions(3, count), velocities(3, count)
      integer(c_int), value :: threads
      integer(c_size_t) :: start, last

      do start = 1, count, longest
         last = min(count, start + longest - 1)
         call orbits_locate_from_gaps(length, gravity, upper_gaps(start:last), lower_rises(start:last), time, &
            positions(:, start:last), velocities(:, start:last), int(threads))
      end do
   end subroutine kyvadlo_orbits_locate_from_gaps
end module kyvadlo_c_many_orbits
