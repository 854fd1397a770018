!> The columns of `derivatives`: how the quantities asked for change with the settings asked for, from the matrix of the
!> derivatives of position and velocity.
module kyvadlo_derivative_samples
   use kyvadlo_curves, only: rate_jump
   use kyvadlo_derivatives_real64, only: derivatives_type, new_derivatives_from_state
   use kyvadlo_force_changes, only: energy_change, forces_change_type, move_changes, new_forces_change
   use kyvadlo_forces, only: forces_type, move, new_forces
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_numbers, only: is_finite, quiet_nan_real64
   use kyvadlo_pivot, only: pivot_change, pivot_motion
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_quantities
   use kyvadlo_saltation, only: is_tangential, jump_at_shock
   use kyvadlo_sample_block, only: block_samples, block_type
   use kyvadlo_scene_groups, only: moving_pivot_group, start_gaps, start_heights, start_rises, string_group, &
      turning_frame_group
   use kyvadlo_setting_changes, only: changes_of_settings, computed_scene_type, setting_change_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path
   use kyvadlo_status, only: code_unsupported, error_type, fail
   use kyvadlo_string, only: event_rebound, event_slack
   use kyvadlo_turning_frame, only: seen_from_turning_frame
   implicit none
   private
   public :: derivative_samples_type, begin_derivatives, find_matrices, fill_derivatives

   !> What the derivatives of a scene are computed from.
   type :: derivative_samples_type
      type(setting_change_type), allocatable :: changes(:)    !! (p); of no size: no derivatives are asked for
      real(wp), allocatable :: matrices(:, :, :)              !! (6, p, samples) of position and velocity
      type(forces_type), private :: forces
      type(forces_change_type), allocatable, private :: forces_changes(:)
      type(derivatives_type), private :: core                 !! Of the closed form, on a string of the present swing
      integer, private :: piece = 0                           !! Of a string: the one whose start follows
      real(wp), allocatable, private :: start(:, :)           !! (6, p) columns at the start of that piece
   end type derivative_samples_type

   !> A sample that is differentiated.
   type :: sample_type
      real(wp) :: time = 0, rate = 0
      real(wp), dimension(3) :: position = 0, velocity = 0             !! Relative to the pivot, in resting axes
      real(wp), dimension(3) :: shown_position = 0, shown_velocity = 0
      real(wp), dimension(3) :: moved = 0, turned = 0                  !! Changes of the two before
      logical :: is_moved = .false., is_turned = .false.  !! What is shown
      real(wp), allocatable :: tensions(:)                             !! (p) changes
   end type sample_type

   !> Relative error of a margin of a string in closed form: as in kyvadlo_integrator.
   real(wp), parameter :: closeness = 1024*epsilon(1.0_wp)

contains

   !> The changes of a scene's numbers, and of its start. Errors: those of the closed form's derivatives; a taut string
   !> whose tension only touches zero.
   subroutine begin_derivatives(derivatives, simulation, path, error, count)
      type(derivative_samples_type), intent(out) :: derivatives
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in), optional :: count                  !! Samples at a time (default: those of a block)
      integer :: j, samples

      samples = block_samples
      if (present(count)) samples = count
      if (all(simulation%settings%quantities /= quantity_derivatives)) then
         allocate (derivatives%changes(0))
         return
      end if
      call changes_of_settings(simulation, computed_scene_type(path%effects, path%length, path%gravity, path%orbit, &
         path%position, path%velocity, path%starts_freely), simulation%settings%derivatives, derivatives%changes, &
         derivatives%core, error)
      if (allocated(error)) return
      associate (p => size(derivatives%changes))
         allocate (derivatives%matrices(6, p, samples), derivatives%forces_changes(p), derivatives%start(6, p))
         call new_forces(derivatives%forces, path%effects, path%length, path%gravity, error)
         if (allocated(error)) return
         do j = 1, p
            call new_forces_change(derivatives%forces_changes(j), derivatives%changes(j)%change, derivatives%forces, &
               path%gravity)
            derivatives%start(:, j) = [derivatives%changes(j)%change%position, derivatives%changes(j)%change%velocity]
         end do
         if (any(abs(derivatives%forces_changes%suspension%growth) > 0)) derivatives%forces%has_hoist = .true.
      end associate
      if (simulation%settings%given(string_group) .and. path%path == path_closed_form) &
         call look_for_touch(path%orbit, 0.0_wp, path%duration, error)
   end subroutine begin_derivatives

   !> Whether the tension of a swing is zero at its highest point: motions next to it go slack. The first time when it
   !> is there ends the derivatives.
   subroutine look_for_touch(orbit, start, until, error)
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: start, until             !! Of the swing [s]
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: time

      associate (g => orbit%gravity, z => orbit%turning%upper)
         if (abs(2*orbit%energy() - 3*g*z) > closeness*(g*orbit%length + abs(orbit%energy()))) return
      end associate
      time = start + orbit%time_to_height(orbit%turning%upper)
      if (time <= until) call fail(error, code_unsupported, touch_message(time))
   end subroutine look_for_touch

   !> The matrices at the times of a block, of a motion that is not integrated.
   subroutine find_matrices(derivatives, simulation, path, block, error)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: position(3), velocity(3), matrix(6, 9)
      integer :: i, j

      if (path%path == path_string) then
         call find_string_matrices(derivatives, path, block, error)
         return
      end if
      do i = 1, block%count
         call derivatives%core%evaluate(block%values(i, 1), position, velocity, matrix)
         do j = 1, size(derivatives%changes)
            associate (new => derivatives%changes(j))
               select case (simulation%pendulum%start)
               case (start_heights, start_gaps, start_rises)
                  derivatives%matrices(:, j, i) = combined(matrix(:, :4), [new%change%length, new%fall, &
                     new%start(:, 1)])
               case default
                  derivatives%matrices(:, j, i) = combined(matrix(:, :8), [derivatives%start(:, j), new%change%length, &
                     new%fall])
               end select
            end associate
         end do
      end do
   end subroutine find_matrices

   !> A matrix times weights; a column of weight zero counts for nothing, even if it has no numbers.
   pure function combined(matrix, weights) result(column)
      real(wp), intent(in) :: matrix(:, :), weights(:)
      real(wp) :: column(6)
      integer :: i

      column = 0
      do i = 1, size(weights)
         if (abs(weights(i)) > 0 .or. weights(i) /= weights(i)) column = column + weights(i)*matrix(:, i)
      end do
   end function combined

   !> Swings and flights, with the jump where the string becomes taut.
   subroutine find_string_matrices(derivatives, path, block, error)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      associate (pieces => path%string%pieces, piece => derivatives%piece)
         if (piece == 0) then
            piece = 1
            call begin_piece(derivatives, path, error)
         end if
         do i = 1, block%count
            do while (piece < size(pieces) .and. .not. allocated(error))
               if (pieces(piece + 1)%start > block%values(i, 1)) exit
               call end_piece(derivatives, path, error)
               piece = piece + 1
               if (.not. allocated(error)) call begin_piece(derivatives, path, error)
            end do
            if (allocated(error)) return
            call columns_in_piece(derivatives, path, block%values(i, 1) - pieces(piece)%start, &
               derivatives%matrices(:, :, i))
         end do
      end associate
   end subroutine find_string_matrices

   !> The closed form of a swing.
   subroutine begin_piece(derivatives, path, error)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error

      associate (piece => path%string%pieces(derivatives%piece))
         if (.not. piece%is_taut) return
         call new_derivatives_from_state(derivatives%core, path%string%length, path%string%gravity, piece%position, &
            piece%velocity, error)
         if (.not. allocated(error) .and. derivatives%piece == size(path%string%pieces)) &
            call look_for_touch(piece%orbit, piece%start, path%duration, error)
      end associate
   end subroutine begin_piece

   !> The columns a time after the start of the present piece.
   subroutine columns_in_piece(derivatives, path, time, columns)
      type(derivative_samples_type), intent(in) :: derivatives
      type(path_type), intent(in) :: path
      real(wp), intent(in) :: time                     !! [s]
      real(wp), intent(out) :: columns(:, :)           !! (6, p)
      real(wp) :: position(3), velocity(3), matrix(6, 9)
      integer :: j

      if (path%string%pieces(derivatives%piece)%is_taut) call derivatives%core%evaluate(time, position, velocity, &
         matrix)
      do j = 1, size(derivatives%changes)
         associate (new => derivatives%changes(j), start => derivatives%start(:, j))
            if (path%string%pieces(derivatives%piece)%is_taut) then
               columns(:, j) = combined(matrix(:, :8), [start, new%change%length, new%fall])
            else
               columns(:, j) = [start(1:3) + time*start(4:6), start(4:6)]
               columns(3, j) = columns(3, j) - new%fall*time**2/2
               columns(6, j) = columns(6, j) - new%fall*time
            end if
         end associate
      end do
   end subroutine columns_in_piece

   !> The columns at the start of the next piece: no force jumps where the string goes slack. Error: the event is met
   !> tangentially.
   subroutine end_piece(derivatives, path, error)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: columns(6, size(derivatives%changes)), before(9), after(6), outward(3), back, slope, scale, left
      logical :: is_slack
      integer :: j

      associate (this => path%string%pieces(derivatives%piece), next => path%string%pieces(derivatives%piece + 1), &
         event => path%string%events(derivatives%piece), g => path%string%gravity, l => path%string%length)
         call columns_in_piece(derivatives, path, next%start - this%start, columns)
         is_slack = event%kind == event_slack
         before = [event%position, next%velocity, 0.0_wp, 0.0_wp, -g]
         ! A flight keeps its horizontal velocity.
         if (.not. is_slack) before(4:6) = this%velocity - [0.0_wp, 0.0_wp, g*(next%start - this%start)]
         outward = event%position/norm2(event%position)
         scale = 2*g + dot_product(before(4:6), before(4:6))/l
         if (is_slack) then
            ! The tension 3 g (height of zero tension - z)/l, over what it may be, as a length.
            slope = 3*g*before(6)/scale
         else
            slope = dot_product(outward, before(4:6))
         end if
         if (is_tangential(slope, scale, l, closeness)) then
            ! Ever smaller rebounds are none.
            left = 0
            if (derivatives%piece > 1) then
               if (path%string%events(derivatives%piece - 1)%kind == event_rebound) left = &
                  abs(dot_product(this%position, this%velocity))/l
            end if
            if (is_slack .or. .not. (left > 0 .and. slope > sqrt(closeness)*left)) then
               call fail(error, code_unsupported, touch_message(next%start))
               return
            end if
         end if
         back = merge(path%effects%restitution, 0.0_wp, event%kind == event_rebound)
         after = [next%velocity, 0.0_wp, 0.0_wp, -g]
         if (next%is_taut) after(4:6) = after(4:6) - (dot_product(next%velocity, next%velocity)/l &
            - g*outward(3))*outward
         do j = 1, size(derivatives%changes)
            if (.not. is_slack) call jump_at_shock(derivatives%forces%suspension, &
               derivatives%forces_changes(j)%suspension, before, after, back, &
               derivatives%changes(j)%change%effects%restitution, columns(:, j))
         end do
         derivatives%start = columns
      end associate
   end subroutine end_piece

   !> Blanks behind.
   pure function touch_message(time) result(text)
      real(wp), intent(in) :: time            !! [s]
      character(len=160) :: text

      text = 'there are no derivatives after t = '//shortest_text(time)// &
         ' s, where the string goes slack or taut tangentially'
   end function touch_message

   !> The columns of a block. Positions are still relative to the pivot, in resting axes.
   subroutine fill_derivatives(derivatives, simulation, path, block)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      type(sample_type) :: sample
      integer :: i, j, k, at, m, p

      p = size(derivatives%changes)
      associate (settings => simulation%settings, first => block%column(quantity_derivatives))
         do i = 1, block%count
            call look_at_sample(derivatives, simulation, path, block, i, sample)
            do j = 1, p
               call shown_changes(derivatives, j, derivatives%matrices(:, j, i), path, sample)
               at = first + j - 1
               do k = 1, size(settings%differentiated)
                  m = quantities(settings%differentiated(k))%columns
                  block%values(i, at:at + (m - 1)*p:p) = derivatives_of(settings%differentiated(k), derivatives, j, &
                     derivatives%matrices(:, j, i), sample, m)
                  at = at + m*p
               end do
            end do
         end do
         ! Where a quantity has no derivative, as the azimuth on the axis.
         m = p*sum(quantities(settings%differentiated)%columns)
         where (.not. is_finite(block%values(:block%count, first:first + m - 1))) &
            block%values(:block%count, first:first + m - 1) = quiet_nan_real64
      end associate
   end subroutine fill_derivatives

   !> A sample, relative to the pivot and as it is shown.
   subroutine look_at_sample(derivatives, simulation, path, block, i, sample)
      type(derivative_samples_type), intent(inout) :: derivatives
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      integer, intent(in) :: i
      type(sample_type), intent(inout) :: sample
      real(wp) :: displacement(3), pivot_velocity(3), acceleration(3), tension, powers(2)
      real(wp) :: accelerations(3, size(derivatives%changes))

      associate (settings => simulation%settings, column => block%column)
         sample%time = block%values(i, 1)
         sample%position = block%values(i, column(quantity_position):column(quantity_position) + 2)
         sample%velocity = block%values(i, column(quantity_velocity):column(quantity_velocity) + 2)
         sample%is_moved = settings%given(moving_pivot_group) .and. .not. settings%relative
         sample%is_turned = settings%given(turning_frame_group)
         sample%rate = settings%frame_rate
         sample%shown_position = sample%position
         sample%shown_velocity = sample%velocity
         if (sample%is_moved) then
            call pivot_motion(path%effects, sample%time, displacement, pivot_velocity)
            sample%shown_position = sample%position + displacement
            sample%shown_velocity = sample%velocity + pivot_velocity
         end if
         if (sample%is_turned) call seen_from_turning_frame(sample%rate, sample%time, sample%shown_position, &
            sample%shown_velocity)
         if (.not. any(settings%differentiated == quantity_tension)) return
         if (.not. allocated(sample%tensions)) allocate (sample%tensions(size(derivatives%changes)))
         sample%tensions = 0
         ! In flight there is none.
         if (path%effects%is_string .and. .not. block%values(i, column(quantity_tension)) > 0) return
         ! As the samples: that before a jump of the pivot's acceleration, that behind one of its velocity.
         derivatives%forces%until = sample%time
         if (any(abs(rate_jump(path%effects%pivot_curve, sample%time)) > 0)) &
            derivatives%forces%until = huge(sample%time)
         call move(derivatives%forces, .true., sample%time, sample%position, sample%velocity, acceleration, tension, &
            powers)
         call move_changes(derivatives%forces, derivatives%forces_changes, .true., sample%time, sample%position, &
            sample%velocity, derivatives%matrices(:, :, i), accelerations, sample%tensions)
      end associate
   end subroutine look_at_sample

   !> The changes of position and velocity as they are shown.
   subroutine shown_changes(derivatives, j, column, path, sample)
      type(derivative_samples_type), intent(in) :: derivatives
      integer, intent(in) :: j
      real(wp), intent(in) :: column(6)
      type(path_type), intent(in) :: path
      type(sample_type), intent(inout) :: sample
      real(wp) :: displacement(3), pivot_velocity(3), acceleration(3)

      associate (new => derivatives%changes(j), moved => sample%moved, turned => sample%turned, &
         p => sample%shown_position, v => sample%shown_velocity)
         moved = column(1:3)
         turned = column(4:6)
         if (sample%is_moved) then
            call pivot_change(path%effects, new%change%effects, sample%time, displacement, pivot_velocity, acceleration)
            moved = moved + displacement
            turned = turned + pivot_velocity
         end if
         if (.not. sample%is_turned) return
         call seen_from_turning_frame(sample%rate, sample%time, moved, turned)
         ! A frame that turns faster has turned further, and takes more of the velocity.
         if (.not. abs(new%frame_rate) > 0) return
         moved = moved + new%frame_rate*sample%time*[p(2), -p(1), 0.0_wp]
         turned = turned + new%frame_rate*([p(2), -p(1), 0.0_wp] + sample%time*[v(2), -v(1), 0.0_wp])
      end associate
   end subroutine shown_changes

   !> The changes of a quantity.
   function derivatives_of(quantity, derivatives, j, column, sample, count) result(values)
      integer, intent(in) :: quantity, j, count
      type(derivative_samples_type), intent(in) :: derivatives
      real(wp), intent(in) :: column(6)
      type(sample_type), intent(in) :: sample
      real(wp) :: values(count), wide, wider

      associate (p => sample%position, v => sample%velocity, dp => column(1:3), dv => column(4:6))
         wide = hypot(p(1), p(2))
         select case (quantity)
         case (quantity_position)
            values = sample%moved
         case (quantity_velocity)
            values = sample%turned
         case (quantity_speed)
            values = dot_product(sample%shown_velocity, sample%turned)/norm2(sample%shown_velocity)
         case (quantity_energy)
            values = energy_change(derivatives%forces, derivatives%forces_changes(j), sample%time, p, v, column)
         case (quantity_momentum)
            values = dp(1)*v(2) + p(1)*dv(2) - dp(2)*v(1) - p(2)*dv(1)
         case (quantity_tension)
            values = sample%tensions(j)
         case (quantity_azimuth)
            values = (p(1)*dp(2) - p(2)*dp(1))/wide**2
            if (sample%is_turned) values = values - derivatives%changes(j)%frame_rate*sample%time
         case default
            ! Of the inclination.
            wider = (p(1)*dp(1) + p(2)*dp(2))/wide
            values = (wide*dp(3) - p(3)*wider)/dot_product(p, p)
         end select
      end associate
   end function derivatives_of

end module kyvadlo_derivative_samples
