!> Samples of one orbit in quadruple precision: for an accuracy that double precision does not keep, and for times at
!> which it cannot tell the phase.
module kyvadlo_wide_samples
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_sample_block, only: block_type, fill_ellipse, shows_ellipse
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_type
   use kyvadlo_samples, only: longest_cell, scene_event_type
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_number_text, only: padded_digits, padded_shortest, read_number, shortest_text
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities
   use kyvadlo_scene_groups, only: moving_pivot_group, turning_frame_group
   use kyvadlo_scene_settings, only: event_request_type
#endif
   implicit none
   private
   public :: fill_wide, is_wide, sharpen_events

contains

   pure logical function is_wide(path)
      type(path_type), intent(in) :: path

      is_wide = .false.
#ifndef KYVADLO_NO_REAL128
      if (allocated(path%plan)) is_wide = allocated(path%plan%wide)
#endif
   end function is_wide

   !> All columns of a block as they are shown, rounded; and as text with the figures that are kept.
   subroutine fill_wide(simulation, path, block, cells)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      character(len=longest_cell), intent(inout) :: cells(:, :) !! (sample, visible column); no columns: no text
#ifndef KYVADLO_NO_REAL128
      real(qp) :: wide(block%count, size(block%values, 2)), t(block%count)
      character(len=:), allocatable :: ignored
      integer :: i, j

      t = block%values(:block%count, 1)
      if (path%figures > 0) then ! Of the times as they are written, too
         do i = 1, block%count
            call read_number(shortest_text(block%values(i, 1)), t(i), ignored)
         end do
      end if
      call fill(simulation, path, t, block, wide)
      block%values(:block%count, 2:) = real(wide(:, 2:), wp)
      if (size(cells, 2) == 0) return
      do i = 1, block%count
         cells(i, 1) = padded_shortest(block%values(i, 1))
         do j = 2, block%visible
            cells(i, j) = ''
            if (.not. is_nan(wide(i, j))) cells(i, j) = padded_digits(wide(i, j), path%figures)
         end do
      end do
#else
      cells = ''
#endif
   end subroutine fill_wide

   !> Events found in double precision, with the figures that are kept: time, position and all columns.
   subroutine sharpen_events(simulation, path, block, events)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path                     !! One that is wide, for its figures
      type(block_type), intent(inout) :: block                !! Its columns alone matter
      type(scene_event_type), intent(inout) :: events(:)
#ifndef KYVADLO_NO_REAL128
      real(qp) :: wide(1, size(block%values, 2)), t(1)
      integer :: i, j, place

      place = block%column(quantity_position)
      do i = 1, size(events)
         associate (event => events(i))
            call sharpen(simulation, path, block, simulation%settings%events(event%request), event%time, t, wide)
            event%time = real(t(1), wp)
            event%position = real(wide(1, place:place + 2), wp)
            event%values(2:) = real(wide(1, 2:block%visible), wp)
            event%values(1) = event%time
            event%position_cells = [(cell(wide(1, place + j - 1)), j=1, 3)]
            event%cells = [cell(t(1)), (cell(wide(1, j)), j=2, block%visible)]
         end associate
      end do

   contains

      pure function cell(number)
         real(qp), intent(in) :: number
         character(len=longest_cell) :: cell

         cell = ''
         if (.not. is_nan(number)) cell = padded_digits(number, path%figures)
      end function cell
#endif
   end subroutine sharpen_events

#ifndef KYVADLO_NO_REAL128
   !> When a column passes a value, by the secant method, and all columns then.
   subroutine sharpen(simulation, path, block, request, near, t, wide)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      type(event_request_type), intent(in) :: request
      real(wp), intent(in) :: near                            !! As double precision knows it [s]
      real(qp), intent(out) :: t(1), wide(:, :)               !! [s]; (1, column)
      real(qp) :: wanted, before, miss, miss_before, step
      character(len=:), allocatable :: ignored
      integer :: i
      !> From the digits of a double to those of this kind in three, and some to spare.
      integer, parameter :: most_secants = 12

      associate (column => block%column(request%quantity) + request%component - 1)
         wanted = request%value
         if (request%typed /= '') call read_number(trim(request%typed), wanted, ignored)
         t = near
         call fill(simulation, path, t, block, wide)
         miss = wide(1, column) - wanted
         ! About the last digits of a double.
         step = 1e-14_qp*(near + sqrt(path%length/path%gravity))
         do i = 1, most_secants
            before = t(1)
            miss_before = miss
            t = t + step
            call fill(simulation, path, t, block, wide)
            miss = wide(1, column) - wanted
            if (.not. abs(miss - miss_before) > 0) exit
            step = -miss*((t(1) - before)/(miss - miss_before))
            if (abs(step) <= 2*epsilon(step)*t(1) .or. .not. abs(miss) > 0) exit
         end do
      end associate
   end subroutine sharpen

   !> Constants of the motion as the paths of double precision have them, in this kind.
   subroutine fill(simulation, path, t, block, wide)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      real(qp), intent(in) :: t(:)                            !! (sample) [s]
      type(block_type), intent(inout) :: block
      real(qp), intent(out) :: wide(:, :)                     !! (sample, column)
      real(qp), dimension(size(t)) :: x, y, z, vx, vy, vz
      real(qp) :: inertia, weight
      real(wp) :: displacement(3), velocity(3)

      wide = 0
      call path%plan%locate_at_real128(t, x, y, z, vx, vy, vz)
      call pivot_motion(path%effects, 0.0_wp, displacement, velocity)
      associate (orbit => path%plan%wide, column => block%column, settings => simulation%settings)
         inertia = 1 + real(settings%effects%added_mass, qp)*settings%effects%density_ratio
         weight = real(path%gravity, qp)*(1 - real(settings%effects%density_ratio, qp))
         if (shows_ellipse(block)) then
            call put(quantity_position, x, y, z)
            call put(quantity_velocity, vx, vy, vz)
            block%values(:block%count, 2:) = real(wide(:, 2:), wp)
            call fill_ellipse(effective_gravity(path%gravity, settings%effects%density_ratio, &
               settings%effects%added_mass), 0.0_wp, settings%frame_rate, block)
            wide(:, 2:) = block%values(:block%count, 2:)
         end if
         if (column(quantity_energy) > 0) wide(:, column(quantity_energy)) = inertia*orbit%energy() &
            + weight*displacement(3)
         if (column(quantity_momentum) > 0) wide(:, column(quantity_momentum)) = orbit%momentum()
         if (column(quantity_tension) > 0) wide(:, column(quantity_tension)) = inertia*orbit%rod_force(t)
         if (column(quantity_inclination) > 0) wide(:, column(quantity_inclination)) = atan2(hypot(x, y), -z)
         if (column(quantity_azimuth) > 0) wide(:, column(quantity_azimuth)) = orbit%azimuth(t)
         if (settings%relative .or. .not. settings%given(moving_pivot_group)) displacement = 0
         x = x + displacement(1)
         y = y + displacement(2)
         z = z + displacement(3)
         if (settings%given(turning_frame_group)) then
            call turn(real(settings%frame_rate, qp), t, x, y, vx, vy)
            if (column(quantity_azimuth) > 0) wide(:, column(quantity_azimuth)) = wide(:, column(quantity_azimuth)) &
               - real(settings%frame_rate, qp)*t
         end if
         call put(quantity_position, x, y, z)
         call put(quantity_velocity, vx, vy, vz)
         if (column(quantity_speed) > 0) wide(:, column(quantity_speed)) = hypot(hypot(vx, vy), vz)
      end associate

   contains

      subroutine put(quantity, a, b, c)
         integer, intent(in) :: quantity
         real(qp), intent(in), dimension(:) :: a, b, c

         associate (first => block%column(quantity))
            if (first == 0) return
            wide(:, first) = a
            wide(:, first + 1) = b
            wide(:, first + 2) = c
         end associate
      end subroutine put
   end subroutine fill

   !> As seen_from_turning_frame.
   elemental subroutine turn(rate, time, x, y, vx, vy)
      real(qp), intent(in) :: rate, time
      real(qp), intent(inout) :: x, y, vx, vy
      real(qp), parameter :: two_pi = 2*acos(-1.0_qp)
      complex(qp) :: back, place, moving

      back = exp(cmplx(0.0_qp, -modulo(rate*time, two_pi), qp))
      place = cmplx(x, y, qp)
      moving = (cmplx(vx, vy, qp) - rate*cmplx(-y, x, qp))*back
      place = place*back
      x = real(place, qp)
      y = aimag(place)
      vx = real(moving, qp)
      vy = aimag(moving)
   end subroutine turn
#endif

end module kyvadlo_wide_samples
