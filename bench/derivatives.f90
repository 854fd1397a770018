!> Rows of `kyvadlo-bench --motion`: derivatives beside position and velocity alone, and their set-up beside an orbit's.
module kyvadlo_bench_derivatives
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: print_derivatives

   integer, parameter :: points = 500
   type :: start_type
      character(len=20) :: name
      real(real64) :: velocity(3)
   end type start_type
   !> Over sqrt(g l), from (0.6, 0, -0.8) l
   type(start_type), parameter :: starts(*) = [ &
      start_type('k**2 < 1/2', [0.1_real64, 0.3_real64, 0.075_real64]), &
      start_type('k**2 > 1/2', [1.4_real64, 0.1_real64, 1.05_real64]), &
      start_type('energy above 2 g l', [1.3_real64, 1.9_real64, 0.975_real64])]

contains

   !> Each figure is a median over calls, all columns measured in turn.
   subroutine print_derivatives(unit, level, sine, passes)
      integer, intent(in) :: unit, level  !! Of the kernels
      real(real64), intent(in) :: sine    !! ns
      integer, intent(in) :: passes
      type(orbit_type) :: orbit
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error
      real(real64), dimension(points) :: time, x, y, z, vx, vy, vz
      real(real64) :: position(3, points), velocity(3, points), t(5, 10*passes), m(5), at(3), v(3)
      real(real64), allocatable :: all(:, :, :), few(:, :, :)
      integer(int64) :: begun
      integer :: i, k, pass

      allocate (all(6, 9, points), few(6, 3, points))
      if (level == 0) write (unit, '(/,a,/,a,/,a,/,/,a6,2x,a20,a9,3a8,a9,a8,a10,a8)') &
         'Derivatives at 500 times of a motion from a state: nanoseconds a time, and times what position and', &
         'velocity alone take. 6x9: with respect to x, y, z, vx, vy, vz, l, g, t; 6x3: l, g, t; both with position', &
         'and velocity. Set-up beside that of the orbit.', 'kernel', 'motion              ', 'x, v', '6x9', 'S', &
         'times', '6x3', 'times', 'set-up', 'times'
      do k = 1, size(starts)
         at = [0.6_real64, 0.0_real64, -0.8_real64]
         v = starts(k)%velocity*sqrt(9.81_real64)
         call new_orbit_from_state(orbit, 1.0_real64, 9.81_real64, at, v, error)
         call new_derivatives_from_state(derivatives, 1.0_real64, 9.81_real64, at, v, error)
         do i = 1, points
            time(i) = 100*modulo(0.6180339887498949_real64*i, 1.0_real64)
         end do
         do pass = 1, 10*passes
            call system_clock(begun)
            call orbit%locate(time, x, y, z, vx, vy, vz, highest_level=level)
            t(1, pass) = nanoseconds_since(begun)/points
            call system_clock(begun)
            call derivatives%evaluate(time, position, velocity, all, highest_level=level)
            t(2, pass) = nanoseconds_since(begun)/points
            call system_clock(begun)
            call derivatives%evaluate(time, position, velocity, few, [7, 8, 9], highest_level=level)
            t(3, pass) = nanoseconds_since(begun)/points
            call system_clock(begun)
            call new_orbit_from_state(orbit, 1.0_real64, 9.81_real64, at, v, error)
            t(4, pass) = nanoseconds_since(begun)
            call system_clock(begun)
            call new_derivatives_from_state(derivatives, 1.0_real64, 9.81_real64, at, v, error)
            t(5, pass) = nanoseconds_since(begun)
         end do
         m = [(median(t(i, :)), i=1, 5)]
         write (unit, '(i6,2x,a20,f9.2,3f8.2,f9.2,f8.2,f10.0,f8.2)') level, starts(k)%name, m(1), m(2), m(2)/sine, &
            m(2)/m(1), m(3), m(3)/m(1), m(5), m(5)/m(4)
      end do
   end subroutine print_derivatives
end module kyvadlo_bench_derivatives
