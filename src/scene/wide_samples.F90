!> Samples of one orbit in quadruple precision: for an accuracy that double precision does not keep, and for times at
!> which it cannot tell the phase.
module kyvadlo_wide_samples
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_sample_block, only: block_type, fill_ellipse, shows_ellipse
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_type
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use kyvadlo_buoyancy, only: effective_gravity
   use kyvadlo_number_text, only: padded_digits, padded_shortest, read_number, shortest_text
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities
   use kyvadlo_scene_groups, only: moving_pivot_group, turning_frame_group
#endif
   implicit none
   private
   public :: fill_wide, is_wide, longest_cell

   !> The longest number of 34 figures with its sign, point and exponent.
   integer, parameter :: longest_cell = 44

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
      real(qp) :: wide(block%count, size(block%values, 2))
      integer :: i, j

      call fill(simulation, path, block, wide)
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

#ifndef KYVADLO_NO_REAL128
   !> Constants of the motion as the paths of double precision have them, in this kind.
   subroutine fill(simulation, path, block, wide)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(qp), intent(out) :: wide(:, :)                     !! (sample, column)
      real(qp), dimension(block%count) :: x, y, z, vx, vy, vz
      real(qp) :: t(block%count), inertia, weight
      real(wp) :: displacement(3), velocity(3)
      character(len=:), allocatable :: ignored
      integer :: i

      wide = 0
      t = block%values(:block%count, 1)
      if (path%figures > 0) then ! Of the times as they are written, too
         do i = 1, block%count
            call read_number(shortest_text(block%values(i, 1)), t(i), ignored)
         end do
      end if
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
