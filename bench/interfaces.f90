!> `kyvadlo-bench --interfaces`: the same procedure called from Fortran, from C and from Fortran 77.
module kyvadlo_bench_interfaces
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo, only: carlson_rf, carlson_rj, elliptic_f, elliptic_k, error_type => kyvadlo_error_type, &
      jacobi_functions, new_orbit_from_heights, orbit_type
   use kyvadlo_c_functions, only: kyvadlo_carlson_rf, kyvadlo_carlson_rj, kyvadlo_elliptic_f, kyvadlo_elliptic_k, &
      kyvadlo_sncndn
   use kyvadlo_c_motion, only: kyvadlo_locate
   use kyvadlo_c_orbits, only: c_orbit_type, kyvadlo_orbit_from_heights
   use kyvadlo_f77_functions, only: kyvelf, kyvelk, kyvrf, kyvrj, kyvscd
   use kyvadlo_f77_pendulum, only: kyvpos, kyvset, work_length
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_interfaces

   integer, parameter :: points = 2000
   character(len=*), parameter :: names(6) = [character(len=16) :: &
      'K(m)', 'F(phi, m)', 'R_F', 'R_J', 'sn cn dn (u, m)', 'locate']

contains

   !> Measures and prints the table; the three faces of a procedure are measured in turn, pass by pass.
   subroutine bench_interfaces(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! A tenth of the passes: to see that it runs, not to measure
      real(real64), allocatable :: x(:,:), times(:,:)
      real(real64) :: checksum, each(3)
      integer(int64) :: start
      integer :: row, face, pass, passes

      passes = merge(7, 71, quick)
      allocate (x(points, 4), times(passes, 3))
      call random_number(x)
      checksum = 0
      write (unit, '(a)') 'One call from Fortran, from C and from Fortran 77, in nanoseconds; medians.', '', &
         '                  Fortran       C     F77   C/Fortran   F77/C'
      do row = 1, size(names)
         do pass = 0, passes ! The first pass warms the caches and is not counted.
            do face = 1, 3
               call system_clock(start)
               if (row < 6) call call_function(row, face, x, checksum)
               if (row == 6) call call_orbit(face, x, checksum)
               times(max(pass, 1), face) = nanoseconds_since(start)/points
            end do
         end do
         each = [(median(times(:, face)), face=1, 3)]
         write (unit, '(a, 3f8.1, 2f10.2)') names(row), each, each(2)/each(1), each(3)/each(2)
      end do
      write (unit, '(a, es22.15)') 'Sum of all values computed: ', checksum
   end subroutine bench_interfaces

   subroutine call_function(row, face, x, checksum)
      integer, intent(in) :: row, face  !! 1 Fortran, 2 C, 3 Fortran 77
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: checksum
      real(real64) :: y, sn, cn, dn, am
      integer :: i, ier

      do i = 1, size(x, 1)
         select case (3*row + face - 3)
         case (1); y = elliptic_k(x(i, 1))
         case (2); y = kyvadlo_elliptic_k(x(i, 1))
         case (3); call kyvelk(x(i, 1), y, ier)
         case (4); y = elliptic_f(x(i, 1), x(i, 2))
         case (5); y = kyvadlo_elliptic_f(x(i, 1), x(i, 2))
         case (6); call kyvelf(x(i, 1), x(i, 2), y, ier)
         case (7); y = carlson_rf(x(i, 1), x(i, 2), x(i, 3))
         case (8); y = kyvadlo_carlson_rf(x(i, 1), x(i, 2), x(i, 3))
         case (9); call kyvrf(x(i, 1), x(i, 2), x(i, 3), y, ier)
         case (10); y = carlson_rj(x(i, 1), x(i, 2), x(i, 3), x(i, 4))
         case (11); y = kyvadlo_carlson_rj(x(i, 1), x(i, 2), x(i, 3), x(i, 4))
         case (12); call kyvrj(x(i, 1), x(i, 2), x(i, 3), x(i, 4), y, ier)
         case (13); call jacobi_functions(x(i, 1), x(i, 2), sn, cn, dn, am); y = sn + cn + dn
         case (14); call kyvadlo_sncndn(x(i, 1), x(i, 2), sn, cn, dn, am); y = sn + cn + dn
         case (15); call kyvscd(x(i, 1), x(i, 2), sn, cn, dn, ier); y = sn + cn + dn
         end select
         checksum = checksum + y
      end do
   end subroutine call_function

   subroutine call_orbit(face, x, checksum)
      integer, intent(in) :: face
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: checksum
      type(orbit_type) :: orbit
      type(c_orbit_type) :: c_orbit
      type(error_type), allocatable :: error
      character(kind=c_char) :: message(80)
      real(real64) :: work(work_length), position(3), velocity(3)
      integer :: i, ier
      integer(c_int) :: code

      call new_orbit_from_heights(orbit, 1.0_real64, 9.80665_real64, 0.3_real64, -0.8_real64, error)
      code = kyvadlo_orbit_from_heights(1.0_c_double, 9.80665_c_double, 0.3_c_double, -0.8_c_double, c_orbit, message, &
         size(message, kind=c_size_t))
      call kyvset(1.0_real64, 9.80665_real64, 0.3_real64, -0.8_real64, work, work_length, ier)
      do i = 1, size(x, 1)
         select case (face)
         case (1); call orbit%locate(10*x(i, 1), position, velocity)
         case (2); call kyvadlo_locate(c_orbit, 10*x(i, 1), position, velocity)
         case (3); call kyvpos(work, 10*x(i, 1), position, velocity, ier)
         end select
         checksum = checksum + position(1) + velocity(1)
      end do
   end subroutine call_orbit
end module kyvadlo_bench_interfaces
