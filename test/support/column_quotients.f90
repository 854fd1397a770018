!> The columns of `derivatives` of a scene beside quotients of differences of its samples, for tests.
module column_quotients
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_number_text, only: read_number
   use kyvadlo_quantities, only: quantities
   use kyvadlo_scene_groups, only: pendulum_group, settings, starts
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: change_setting, parse_simulation, simulation_type
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_status, only: error_type
   use sample_record, only: record_type
   implicit none
   private
   public :: worst_quotient

contains

   !> The largest difference in units of the largest of its column, and which column has it.
   subroutine worst_quotient(text, step, worst, name, path_chosen, tolerance)
      character(len=*), intent(in) :: text                   !! Of the scene
      real(real64), intent(in) :: step                       !! Part of a number, or where it is zero the step
      real(real64), intent(out) :: worst
      character(len=:), allocatable, intent(out) :: name     !! Or the message of an error
      integer, intent(out), optional :: path_chosen
      real(real64), intent(in), optional :: tolerance        !! Of a step, where the scene is integrated
      type(simulation_type) :: simulation, moved
      type(record_type) :: record, other
      real(real64), allocatable :: points(:, :, :), quotient(:), found(:)
      real(real64) :: value, h, difference
      character(len=:), allocatable :: column, message
      integer :: i, j, k, q, from

      worst = huge(worst)
      call run(text, simulation, record, tolerance, name, path_chosen)
      if (name /= '') return
      worst = -1
      do j = 1, size(simulation%settings%derivatives)
         associate (by => simulation%settings%derivatives(j))
            value = number_of(simulation, j)
            h = step
            if (abs(value) > 0) h = abs(value)*step
            do k = -3, 3
               moved = simulation
               if (k /= 0) call change_setting(moved, by, value + k*h)
               call follow(moved, other, tolerance, message)
               if (message /= '') then
                  worst = huge(worst)
                  name = message
                  return
               end if
               if (.not. allocated(points)) allocate (points(size(other%values, 1), size(other%values, 2), -3:3))
               points(:, :, k) = other%values
            end do
            do i = 1, size(simulation%settings%differentiated)
               q = simulation%settings%differentiated(i)
               do k = 1, quantities(q)%columns
                  column = trim(quantities(q)%column_names(k))
                  from = findloc(record%columns%name == column, .true., 1)
                  quotient = (45*(points(:, from, 1) - points(:, from, -1)) - 9*(points(:, from, 2) &
                     - points(:, from, -2)) + points(:, from, 3) - points(:, from, -3))/(60*h)
                  found = record%values(:, findloc(record%columns%name == 'd'//column//'_d'//by%name, .true., 1))
                  difference = maxval(abs(found - quotient))/max(maxval(abs(quotient)), 1e-2_real64)
                  ! NaN is the worst.
                  if (any(found /= found)) difference = huge(difference)
                  if (difference > worst) then
                     worst = difference
                     name = 'd'//column//'_d'//trim(by%name)
                  end if
               end do
            end do
         end associate
      end do
   end subroutine worst_quotient

   subroutine run(text, simulation, record, tolerance, message, path_chosen)
      character(len=*), intent(in) :: text
      type(simulation_type), intent(out) :: simulation
      type(record_type), intent(inout) :: record
      real(real64), intent(in), optional :: tolerance
      character(len=:), allocatable, intent(out) :: message
      integer, intent(out), optional :: path_chosen
      type(error_type), allocatable :: error

      call parse_simulation(text, 'f', simulation, error)
      if (allocated(error)) then
         message = error%message
         return
      end if
      call follow(simulation, record, tolerance, message)
      if (present(path_chosen)) path_chosen = record%path
   end subroutine run

   subroutine follow(simulation, record, tolerance, message)
      type(simulation_type), intent(in) :: simulation
      type(record_type), intent(inout) :: record
      real(real64), intent(in), optional :: tolerance
      character(len=:), allocatable, intent(out) :: message
      type(simulation_type) :: chosen
      type(path_type) :: path
      type(error_type), allocatable :: error

      message = ''
      chosen = simulation
      call choose_path(chosen, path, error, tolerance)
      if (.not. allocated(error)) call simulate(chosen, path, record, error)
      if (allocated(error)) message = error%message
      record%path = path%path
   end subroutine follow

   !> The number that a derivative is by, as it stands in the scene.
   real(real64) function number_of(simulation, j) result(value)
      type(simulation_type), intent(in) :: simulation
      integer, intent(in) :: j
      character(len=:), allocatable :: what

      associate (by => simulation%settings%derivatives(j), pendulum => simulation%pendulum)
         if (settings(by%setting)%group /= pendulum_group) then
            value = simulation%settings%number(by%element, by%setting)
         else if (settings(by%setting)%name == 'length') then
            call read_number(pendulum%length%text, value, what)
         else if (settings(by%setting)%name == 'gravity') then
            call read_number(pendulum%gravity%text, value, what)
         else if (settings(by%setting)%name == starts(pendulum%start)%first) then
            call read_number(pendulum%first(by%element)%text, value, what)
         else
            call read_number(pendulum%second(by%element)%text, value, what)
         end if
      end associate
   end function number_of

end module column_quotients
