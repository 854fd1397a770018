!> Samples of motions in closed form: at rest, on one orbit, on a string that goes slack.
module kyvadlo_exact_samples
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_string, only: string_motion_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_quantities
   use kyvadlo_sample_block, only: block_samples, block_type
   use kyvadlo_sample_times, only: last_before
   use kyvadlo_simulation_path, only: path_type
   use kyvadlo_turned_azimuth, only: turned_azimuth
   implicit none
   private
   public :: fill_constant, fill_closed_form, fill_string

contains

   !> A bob that stays where it is.
   pure subroutine fill_constant(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(wp) :: position(3), velocity(3)
      integer :: i

      call path%orbit%locate(0.0_wp, position, velocity)
      associate (n => block%count, column => block%column)
         do i = 1, 3
            if (column(quantity_position) > 0) block%values(:n, column(quantity_position) + i - 1) = position(i)
            if (column(quantity_velocity) > 0) block%values(:n, column(quantity_velocity) + i - 1) = velocity(i)
         end do
         if (column(quantity_tension) > 0) block%values(:n, column(quantity_tension)) = &
            path%inertia*path%orbit%rod_force(0.0_wp)
         ! It has none.
         if (column(quantity_azimuth) > 0) block%values(:n, column(quantity_azimuth)) = &
            quiet_nan_real64
      end associate
      call fill_constants(path, block)
   end subroutine fill_constant

   !> What the motion of one orbit conserves, and works that nothing does.
   pure subroutine fill_constants(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      associate (n => block%count, column => block%column)
         if (column(quantity_energy) > 0) block%values(:n, column(quantity_energy)) = &
            path%inertia*path%orbit%energy() + path%pivot_energy
         if (column(quantity_momentum) > 0) block%values(:n, column(quantity_momentum)) = path%orbit%momentum()
      end associate
      call fill_no_work(block)
   end subroutine fill_constants

   pure subroutine fill_no_work(block)
      type(block_type), intent(inout) :: block

      associate (n => block%count, column => block%column)
         if (column(quantity_drag_work) > 0) block%values(:n, column(quantity_drag_work)) = 0
         if (column(quantity_pivot_work) > 0) block%values(:n, column(quantity_pivot_work)) = 0
      end associate
   end subroutine fill_no_work

   !> One orbit at all times.
   subroutine fill_closed_form(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      associate (n => block%count, column => block%column)
         if (allocated(path%plan)) then
            call place_to_accuracy(path, block)
         else
            call place_samples(path%orbit, block%values(:n, 1), 1, block)
         end if
         if (column(quantity_tension) > 0 .and. allocated(path%plan)) then
            ! Places to an accuracy are not what it is computed from.
            block%values(:n, column(quantity_tension)) = path%inertia*path%orbit%rod_force(block%values(:n, 1))
         else if (column(quantity_tension) > 0) then
            call fill_tension(path%orbit, path%inertia, 1, n, block)
         end if
         if (column(quantity_azimuth) > 0) call path%orbit%azimuths(block%values(:n, 1), &
            block%values(:n, column(quantity_azimuth)))
      end associate
      call fill_constants(path, block)
   end subroutine fill_closed_form

   !> Places, and velocities if needed, of one orbit at some times, from a sample of the block on.
   subroutine place_samples(orbit, time, first, block)
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: time(:)
      integer, intent(in) :: first
      type(block_type), intent(inout) :: block
      integer :: last

      last = first + size(time) - 1
      associate (values => block%values, p => block%column(quantity_position), v => block%column(quantity_velocity))
         if (v > 0) then
            call orbit%locate(time, values(first:last, p), values(first:last, p + 1), values(first:last, p + 2), &
               values(first:last, v), values(first:last, v + 1), values(first:last, v + 2))
         else if (p > 0) then
            call orbit%locate(time, values(first:last, p), values(first:last, p + 1), values(first:last, p + 2))
         end if
      end associate
   end subroutine place_samples

   !> The tension of one orbit from the heights, `rod_force` by `energy`.
   pure subroutine fill_tension(orbit, inertia, first, last, block)
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: inertia
      integer, intent(in) :: first, last
      type(block_type), intent(inout) :: block

      associate (values => block%values, z => block%column(quantity_position) + 2)
         values(first:last, block%column(quantity_tension)) = (inertia/orbit%length)*(2*orbit%energy() &
            - (3*orbit%gravity)*values(first:last, z))
      end associate
   end subroutine fill_tension

   !> Places, and velocities if needed, to an accuracy.
   subroutine place_to_accuracy(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      associate (values => block%values, n => block%count, p => block%column(quantity_position), &
         v => block%column(quantity_velocity))
         if (v > 0) then
            call path%plan%locate(values(:n, 1), values(:n, p), values(:n, p + 1), values(:n, p + 2), values(:n, v), &
               values(:n, v + 1), values(:n, v + 2), threads=path%threads)
         else if (p > 0) then
            call path%plan%locate(values(:n, 1), values(:n, p), values(:n, p + 1), values(:n, p + 2), &
               threads=path%threads)
         end if
      end associate
   end subroutine place_to_accuracy

   !> Swings and flights.
   subroutine fill_string(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(wp) :: since(block_samples), position(3), velocity(3), tension
      integer :: first, last, piece, i

      associate (values => block%values, string => path%string, n => block%count, &
         p => block%column(quantity_position), v => block%column(quantity_velocity), &
         tension_column => block%column(quantity_tension), energy => block%column(quantity_energy), &
         momentum => block%column(quantity_momentum), azimuth_column => block%column(quantity_azimuth))
         piece = block%piece
         if (azimuth_column > 0 .and. .not. values(1, 1) > 0) block%azimuth = first_azimuth(string)
         first = 1
         do while (first <= n)
            ! The piece of this sample, and the last sample in it.
            do while (piece < size(string%pieces))
               if (string%pieces(piece + 1)%start > values(first, 1)) exit
               if (azimuth_column > 0) block%azimuth = azimuth_after(string, piece, block%azimuth)
               piece = piece + 1
            end do
            last = n
            if (piece < size(string%pieces)) last = last_before(values(:n, 1), first, string%pieces(piece + 1)%start)
            if (string%pieces(piece)%is_taut) then
               since(first:last) = values(first:last, 1) - string%pieces(piece)%start
               call place_samples(string%pieces(piece)%orbit, since(first:last), first, block)
               if (tension_column > 0) call fill_tension(string%pieces(piece)%orbit, path%inertia, first, last, block)
               if (azimuth_column > 0) then
                  call string%pieces(piece)%orbit%azimuths(since(first:last), values(first:last, azimuth_column))
                  values(first:last, azimuth_column) = block%azimuth &
                     + (values(first:last, azimuth_column) - string%pieces(piece)%orbit%azimuth(0.0_wp))
               end if
            else
               do i = first, last
                  call string%locate(values(i, 1), position, velocity, tension)
                  if (p > 0) values(i, p:p + 2) = position
                  if (v > 0) values(i, v:v + 2) = velocity
                  if (tension_column > 0) values(i, tension_column) = tension
                  if (azimuth_column > 0) values(i, azimuth_column) = turned_azimuth(position(1), position(2), &
                     velocity(1), velocity(2), block%azimuth)
               end do
            end if
            first = last + 1
         end do
         block%piece = piece
         if (energy > 0) values(:n, energy) = path%inertia*((values(:n, v)**2 + values(:n, v + 1)**2 &
            + values(:n, v + 2)**2)/2 + string%gravity*values(:n, p + 2)) + path%pivot_energy
         if (momentum > 0) values(:n, momentum) = values(:n, p)*values(:n, v + 1) - values(:n, p + 1)*values(:n, v)
      end associate
      call fill_no_work(block)
   end subroutine fill_string

   !> The azimuth at the end of a piece of the motion, from that at its start: a swing counts its turns, a flight is
   !> straight.
   pure real(wp) function azimuth_after(string, piece, at_start) result(at_end)
      type(string_motion_type), intent(in) :: string
      integer, intent(in) :: piece            !! Not the last
      real(wp), intent(in) :: at_start        !! [rad]

      at_end = at_start
      associate (this => string%pieces(piece), next => string%pieces(piece + 1))
         if (this%is_taut) at_end = at_start + (this%orbit%azimuth(next%start - this%start) &
            - this%orbit%azimuth(0.0_wp))
         at_end = turned_azimuth(next%position(1), next%position(2), next%velocity(1), next%velocity(2), at_end)
      end associate
   end function azimuth_after

   !> The azimuth at the start; of a bob that first falls along the axis that of its first motion off it. NaN: it has
   !> none.
   pure real(wp) function first_azimuth(string) result(azimuth)
      type(string_motion_type), intent(in) :: string
      integer :: i

      azimuth = quiet_nan_real64
      do i = 1, size(string%pieces)
         associate (p => string%pieces(i)%position, v => string%pieces(i)%velocity)
            azimuth = turned_azimuth(p(1), p(2), v(1), v(2), azimuth)
         end associate
         if (azimuth == azimuth) return
      end do
   end function first_azimuth

end module kyvadlo_exact_samples
