!> A block of samples: its columns, its times, and how the motion is looked at.
module kyvadlo_sample_block
   use kyvadlo_effects, only: effects_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities
   use kyvadlo_samples, only: column_type
   use kyvadlo_scene_groups, only: body_group, moving_pivot_group, setting_place, settings, turning_frame_group
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_swing_ellipse, only: apsides_type, ellipse_type, next_ellipse
   use kyvadlo_turned_azimuth, only: is_upright
   use kyvadlo_turning_frame, only: frame_angle, seen_from_turning_frame
   implicit none
   private
   public :: block_type, block_samples, columns_of, in_laboratory, new_block, fill_ellipse, fill_inclination, &
      fill_newtons, fill_speed, move_with_pivot, shows_ellipse, turn_azimuth, turn_frame

   !> Samples of a block: small enough for the nearer caches, large enough for the threads of `locate`.
   integer, parameter :: block_samples = 8192

   !> A block of samples. What is needed but not asked for stands in columns behind those that are handed over.
   type :: block_type
      integer :: count = 0                          !! Samples in it
      integer :: piece = 1                          !! Of a string: the last one of the block before
      real(wp) :: azimuth = 0                       !! ... and the azimuth at its start, turns counted [rad]
      type(apsides_type) :: apsides                 !! Of the sample before
      integer :: visible = 0                        !! Columns to hand over
      integer :: column(size(quantities)) = 0       !! First column of a quantity; 0: not needed
      real(wp), allocatable :: values(:, :)         !! (block_samples, columns); the first is the time
   end type block_type

contains

   !> The columns of a scene: the time, then what is asked for.
   pure function columns_of(simulation) result(columns)
      type(simulation_type), intent(in) :: simulation
      type(column_type), allocatable :: columns(:)
      character(len=6) :: unit
      integer :: i, j, k, m, count

      associate (chosen => simulation%settings%quantities)
         allocate (columns(1 + sum(columns_of_quantity(simulation, chosen))))
         columns(1) = column_type('t', 's', 'time since the start')
         count = 1
         do i = 1, size(chosen)
            associate (quantity => quantities(chosen(i)))
               do j = 1, quantity%columns
                  count = count + 1
                  columns(count) = column_type(quantity%column_names(j), quantity%unit, quantity%meaning)
                  if (chosen(i) == quantity_tension .and. simulation%settings%number(1, setting_place(body_group, &
                     'mass')) > 0) columns(count) = column_type('tension', 'N', 'force of the rod or string')
               end do
            end associate
            if (chosen(i) /= quantity_derivatives) cycle
            do k = 1, size(simulation%settings%differentiated)
               associate (quantity => quantities(simulation%settings%differentiated(k)))
                  do j = 1, quantity%columns
                     do m = 1, size(simulation%settings%derivatives)
                        count = count + 1
                        associate (by => simulation%settings%derivatives(m))
                           columns(count) = column_type('d'//trim(quantity%column_names(j))//'_d'//by%name, &
                              quantity%unit, 'derivative of '//trim(quantity%column_names(j))//' with respect to '// &
                              by%name)
                           unit = settings(by%setting)%unit
                           if (unit == 'deg') unit = 'degree'
                           if (unit /= '') columns(count)%unit = trim(quantity%unit)//'/('//trim(unit)//')'
                        end associate
                     end do
                  end do
               end associate
            end do
         end do
      end associate
   end function columns_of

   !> How many columns a quantity has.
   elemental integer function columns_of_quantity(simulation, quantity) result(columns)
      type(simulation_type), intent(in) :: simulation
      integer, intent(in) :: quantity

      columns = quantities(quantity)%columns
      if (quantity == quantity_derivatives) columns = size(simulation%settings%derivatives)* &
         sum(quantities(simulation%settings%differentiated)%columns)
   end function columns_of_quantity

   !> Gives every quantity its columns, and those it is derived from.
   subroutine new_block(simulation, is_one_orbit, block)
      type(simulation_type), intent(in) :: simulation
      logical, intent(in) :: is_one_orbit                     !! Its constants come without places
      type(block_type), intent(out) :: block
      integer :: i, count

      count = 1
      do i = 1, size(simulation%settings%quantities)
         call add(simulation%settings%quantities(i))
      end do
      block%visible = count
      if (size(simulation%settings%events) > 0) call add(quantity_position)
      do i = 1, size(simulation%settings%events)
         call add(simulation%settings%events(i)%quantity)
      end do
      if (block%column(quantity_derivatives) > 0) call add(quantity_velocity)
      if (block%column(quantity_pivot_force) > 0) call add(quantity_tension)
      if (block%column(quantity_speed) > 0 .or. shows_ellipse(block)) call add(quantity_velocity)
      if (.not. is_one_orbit .and. &
         any(block%column([quantity_energy, quantity_momentum]) > 0)) call add(quantity_velocity)
      if (block%column(quantity_velocity) > 0 .or. block%column(quantity_inclination) > 0 .or. &
         block%column(quantity_tension) > 0 .or. &
         block%column(quantity_azimuth) > 0 .and. &
         simulation%settings%given(turning_frame_group)) call add(quantity_position)
      allocate (block%values(block_samples, count))

   contains

      subroutine add(quantity)
         integer, intent(in) :: quantity

         if (block%column(quantity) > 0) return
         block%column(quantity) = count + 1
         count = count + columns_of_quantity(simulation, quantity)
      end subroutine add
   end subroutine new_block

   !> Whether what is shown moves with the pivot.
   pure logical function in_laboratory(simulation)
      type(simulation_type), intent(in) :: simulation

      in_laboratory = simulation%settings%given(moving_pivot_group) .and. .not. simulation%settings%relative
   end function in_laboratory

   !> Inclination. Places are relative to the pivot still.
   pure subroutine fill_inclination(block)
      type(block_type), intent(inout) :: block

      associate (values => block%values, n => block%count, p => block%column(quantity_position), &
         inclination => block%column(quantity_inclination))
         if (inclination > 0) values(:n, inclination) = atan2(hypot(values(:n, p), values(:n, p + 1)), &
            -values(:n, p + 2))
      end associate
   end subroutine fill_inclination

   !> Forces in newtons from the tension over mass T of the mass point that moves as the body does: its acceleration a,
   !> in the laboratory, makes d/l a of the centre of mass, and the pivot gives what weight does not. Positions are
   !> relative to the pivot and in the resting frame still.
   pure subroutine fill_newtons(mass, part, gravity, effects, block)
      real(wp), intent(in) :: mass                            !! [kg]
      real(wp), intent(in) :: part                            !! d/l: of the centre of mass, over the length
      real(wp), intent(in) :: gravity                         !! [m/s2]
      type(effects_type), intent(in) :: effects
      type(block_type), intent(inout) :: block
      real(wp) :: displacement(3), velocity(3), bend(3)
      integer :: i

      associate (values => block%values, p => block%column(quantity_position), tension => block%column( &
         quantity_tension), force => block%column(quantity_pivot_force))
         do i = 1, merge(block%count, 0, force > 0)
            call pivot_motion(effects, values(i, 1), displacement, velocity, bend)
            bend(3) = bend(3) + gravity
            values(i, force:force + 2) = mass*((1 - part)*bend - part*values(i, tension)*(values(i, p:p + 2)/ &
               norm2(values(i, p:p + 2))))
         end do
         if (tension > 0) values(:block%count, tension) = mass*values(:block%count, tension)
      end associate
   end subroutine fill_newtons

   pure logical function shows_ellipse(block)
      type(block_type), intent(in) :: block

      shows_ellipse = any(block%column([quantity_major, quantity_minor, quantity_plane, quantity_handedness]) > 0)
   end function shows_ellipse

   !> The ellipse of the swing. Positions are relative to the pivot and in the resting frame still; a bob in free flight
   !> has none.
   subroutine fill_ellipse(gravity, free_within, rate, block)
      real(wp), intent(in) :: gravity                         !! Effective [m/s2]
      real(wp), intent(in) :: free_within                     !! Nearer to the pivot the string is slack [m]
      real(wp), intent(in) :: rate                            !! Of the frame that the plane is seen from [rad/s]
      type(block_type), intent(inout) :: block
      type(ellipse_type) :: ellipse
      integer :: i

      if (.not. shows_ellipse(block)) return
      associate (values => block%values, p => block%column(quantity_position), v => block%column(quantity_velocity))
         do i = 1, block%count
            if (norm2(values(i, p:p + 2)) < free_within) then
               ellipse = ellipse_type(quiet_nan_real64, quiet_nan_real64, quiet_nan_real64, quiet_nan_real64)
            else
               call next_ellipse(block%apsides, values(i, 1), values(i, p:p + 2), values(i, v:v + 2), gravity, ellipse)
            end if
            call put(quantity_major, ellipse%major)
            call put(quantity_minor, ellipse%minor)
            call put(quantity_plane, ellipse%plane - rate*values(i, 1))
            call put(quantity_handedness, ellipse%handedness)
         end do
      end associate

   contains

      subroutine put(quantity, value)
         integer, intent(in) :: quantity
         real(wp), intent(in) :: value

         if (block%column(quantity) > 0) block%values(i, block%column(quantity)) = value
      end subroutine put
   end subroutine fill_ellipse

   !> Magnitude of the velocity as it is shown.
   pure subroutine fill_speed(block)
      type(block_type), intent(inout) :: block

      associate (values => block%values, n => block%count, v => block%column(quantity_velocity), &
         speed => block%column(quantity_speed))
         if (speed > 0) values(:n, speed) = hypot(hypot(values(:n, v), values(:n, v + 1)), values(:n, v + 2))
      end associate
   end subroutine fill_speed

   !> Places and velocities in the laboratory from those relative to the pivot.
   pure subroutine move_with_pivot(effects, block)
      type(effects_type), intent(in) :: effects
      type(block_type), intent(inout) :: block
      real(wp) :: displacement(3), velocity(3)
      integer :: i

      associate (values => block%values, p => block%column(quantity_position), v => block%column(quantity_velocity))
         if (p == 0) return
         do i = 1, block%count
            call pivot_motion(effects, values(i, 1), displacement, velocity)
            values(i, p:p + 2) = values(i, p:p + 2) + displacement
            if (v > 0) values(i, v:v + 2) = values(i, v:v + 2) + velocity
         end do
      end associate
   end subroutine move_with_pivot

   !> The motion seen from a frame that turns about the vertical. Energy, momentum and tension stay those of the resting
   !> one.
   pure subroutine turn_frame(rate, block)
      real(wp), intent(in) :: rate                            !! [rad/s]
      type(block_type), intent(inout) :: block
      real(wp) :: position(3), velocity(3)
      integer :: i

      associate (values => block%values, n => block%count, p => block%column(quantity_position), &
         v => block%column(quantity_velocity))
         if (p == 0) return
         velocity = 0
         do i = 1, n
            position = values(i, p:p + 2)
            if (v > 0) velocity = values(i, v:v + 2)
            call seen_from_turning_frame(rate, values(i, 1), position, velocity)
            values(i, p:p + 2) = position
            if (v > 0) values(i, v:v + 2) = velocity
         end do
      end associate
   end subroutine turn_frame

   !> The azimuth seen from that frame, of places relative to the pivot: the angle of the place, which has all digits,
   !> with the turns of the difference, which may be a small one of large numbers.
   pure subroutine turn_azimuth(rate, block)
      real(wp), intent(in) :: rate                            !! [rad/s]
      type(block_type), intent(inout) :: block
      real(wp), parameter :: two_pi = 2*acos(-1.0_wp)
      real(wp) :: seen
      integer :: i

      associate (values => block%values, p => block%column(quantity_position), column => block%column(quantity_azimuth))
         do i = 1, merge(block%count, 0, column > 0)
            seen = values(i, column)
            if (.not. is_upright(values(i, p), values(i, p + 1))) seen = atan2(values(i, p + 1) + 0, values(i, p))
            seen = seen - frame_angle(rate, values(i, 1))
            values(i, column) = seen + two_pi*anint((values(i, column) - rate*values(i, 1) - seen)/two_pi)
         end do
      end associate
   end subroutine turn_azimuth

end module kyvadlo_sample_block
