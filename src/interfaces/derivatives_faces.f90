!> Derivatives of the motion for C (`kyvadlo.h`) and Fortran 77 (`KYVSTM`): set up and evaluated at all times in one
!> call.
module kyvadlo_derivatives_faces
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_size_t
   use kyvadlo, only: derivatives_type, error_type => kyvadlo_error_type, new_derivatives_from_energy, &
      new_derivatives_from_energy_above_bottom, new_derivatives_from_energy_above_top, new_derivatives_from_gaps, &
      new_derivatives_from_heights, new_derivatives_from_release, new_derivatives_from_rises, new_derivatives_from_state
   use kyvadlo_c_orbits, only: give_message
   implicit none
   private
   public :: kyvadlo_derivatives_from_heights, kyvadlo_derivatives_from_gaps, kyvadlo_derivatives_from_rises, &
      kyvadlo_derivatives_from_energy, kyvadlo_derivatives_from_energy_above_top, &
      kyvadlo_derivatives_from_energy_above_bottom, kyvadlo_derivatives_from_release, kyvadlo_derivatives_from_state, &
      kyvadlo_turning_time_derivatives_from_state, kyvadlo_turning_time_derivatives_from_release, kyvstm

contains

   function kyvadlo_derivatives_from_state(length, gravity, position, velocity, count, times, states, matrices, &
      periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity
      real(c_double), intent(in) :: position(3), velocity(3)
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(9, 6, count), periods(8, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_state(derivatives, length, gravity, position, velocity, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_state

   function kyvadlo_derivatives_from_heights(length, gravity, upper, lower, count, times, states, matrices, periods, &
      message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, upper, lower
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_heights(derivatives, length, gravity, upper, lower, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_heights

   function kyvadlo_derivatives_from_gaps(length, gravity, upper_gap, lower_rise, count, times, states, matrices, &
      periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, upper_gap, lower_rise
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_gaps(derivatives, length, gravity, upper_gap, lower_rise, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_gaps

   function kyvadlo_derivatives_from_rises(length, gravity, upper_rise, lower_rise, count, times, states, matrices, &
      periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, upper_rise, lower_rise
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_rises(derivatives, length, gravity, upper_rise, lower_rise, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_rises

   function kyvadlo_derivatives_from_energy(length, gravity, energy, momentum, count, times, states, matrices, &
      periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_energy(derivatives, length, gravity, energy, momentum, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_energy

   function kyvadlo_derivatives_from_energy_above_top(length, gravity, energy, momentum, count, times, states, &
      matrices, periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_energy_above_top(derivatives, length, gravity, energy, momentum, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_energy_above_top

   function kyvadlo_derivatives_from_energy_above_bottom(length, gravity, energy, momentum, count, times, states, &
      matrices, periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, energy, momentum
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_energy_above_bottom(derivatives, length, gravity, energy, momentum, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_energy_above_bottom

   function kyvadlo_derivatives_from_release(length, gravity, angle, speed, count, times, states, matrices, &
      periods, message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, angle, speed
      integer(c_size_t), value :: count, capacity
      real(c_double), intent(in) :: times(count)
      real(c_double), intent(out) :: states(6, count), matrices(5, 6, count), periods(4, 2)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_release(derivatives, length, gravity, angle, speed, error)
      call give_all(derivatives, times, states, matrices, periods)
      call give_message(error, message, capacity, code)
   end function kyvadlo_derivatives_from_release

   !> CALL KYVSTM(EL, G, X, V, T, XT, VT, DM, IER): position XT(3) and velocity VT(3) at the time T after the start
   !> The first time later than `time` at which the bob is at a turning height, and its derivatives.
   function kyvadlo_turning_time_derivatives_from_state(length, gravity, position, velocity, time, turning, slopes, &
      message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, time
      real(c_double), intent(in) :: position(3), velocity(3)
      integer(c_size_t), value :: capacity
      real(c_double), intent(out) :: turning, slopes(8)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_state(derivatives, length, gravity, position, velocity, error)
      call derivatives%of_turning_time(time, turning, slopes)
      call give_message(error, message, capacity, code)
   end function kyvadlo_turning_time_derivatives_from_state

   function kyvadlo_turning_time_derivatives_from_release(length, gravity, angle, speed, time, turning, slopes, &
      message, capacity) result(code) bind(c)
      real(c_double), value :: length, gravity, angle, speed, time
      integer(c_size_t), value :: capacity
      real(c_double), intent(out) :: turning, slopes(4)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: code
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_release(derivatives, length, gravity, angle, speed, error)
      call derivatives%of_turning_time(time, turning, slopes)
      call give_message(error, message, capacity, code)
   end function kyvadlo_turning_time_derivatives_from_release

   !> X(3), V(3), and the matrix DM(6,9) of their derivatives with respect to x, y, z, vx, vy, vz, l, g, t.
   subroutine kyvstm(length, gravity, position, velocity, time, position_then, velocity_then, matrix, ier) bind(c, &
      name='kyvstm_')
      real(c_double), intent(in) :: length, gravity, position(3), velocity(3), time
      real(c_double), intent(out) :: position_then(3), velocity_then(3), matrix(6, 9)
      integer(c_int), intent(out) :: ier
      type(derivatives_type) :: derivatives
      type(error_type), allocatable :: error

      call new_derivatives_from_state(derivatives, length, gravity, position, velocity, error)
      call derivatives%evaluate(time, position_then, velocity_then, matrix)
      ier = 0
      if (allocated(error)) ier = int(error%code, c_int)
   end subroutine kyvstm

   !> The matrices row by row, as C stores them. After a set-up that failed all are NaN.
   subroutine give_all(derivatives, times, states, matrices, periods)
      type(derivatives_type), intent(in) :: derivatives
      real(c_double), intent(in) :: times(:)
      real(c_double), intent(out), contiguous :: states(:, :), matrices(:, :, :)
      real(c_double), intent(out) :: periods(:, :)
      integer, parameter :: most_times = 256   ! As the blocks of `evaluate`
      real(c_double) :: matrix(6, size(matrices, 1), most_times), position(3, most_times), velocity(3, most_times)
      integer :: i, j, k, first, count

      do first = 1, size(times), most_times
         count = min(most_times, size(times) - first + 1)
         call derivatives%evaluate(times(first:first + count - 1), position(:, :count), velocity(:, :count), &
            matrix(:, :, :count))
         do i = 1, count
            states(1:3, first + i - 1) = position(:, i)
            states(4:6, first + i - 1) = velocity(:, i)
            do j = 1, 6
               do k = 1, size(matrices, 1)
                  matrices(k, j, first + i - 1) = matrix(j, k, i)
               end do
            end do
         end do
      end do
      call derivatives%of_period(periods(:, 1), periods(:, 2))
   end subroutine give_all
end module kyvadlo_derivatives_faces
