!> Computes the samples of a scene along the path chosen, block by block, in memory that does not grow with their number.
module kyvadlo_simulate
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_quantities
   use kyvadlo_scene_groups, only: turning_frame_group
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path
   use kyvadlo_status, only: error_type
   use kyvadlo_turning_frame, only: seen_from_turning_frame
   implicit none
   private
   public :: simulate

   !> Samples of a block: small enough for the nearer caches, large enough for the threads of `locate_batch`.
   integer, parameter :: block_samples = 8192

   !> A block of samples. What is needed but not asked for stands in columns behind those that are handed over.
   type :: block_type
      integer :: count = 0                          !! Samples in it
      integer :: visible = 0                        !! Columns to hand over
      integer :: column(size(quantities)) = 0       !! First column of a quantity; 0: not needed
      real(wp), allocatable :: values(:, :)         !! (block_samples, columns); the first is the time
   end type block_type

contains

   !> Computes a scene and hands the samples, and the events between them, to a sink.
   !>
   !> Samples are equidistant in time, both ends included. The sink may end the run early. Errors: those of the integrator;
   !> what was handed over before then is of no use.
   subroutine simulate(simulation, path, sink, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path                     !! From `choose_path`
      class(sample_sink_type), intent(inout) :: sink
      type(error_type), allocatable, intent(out) :: error
      type(block_type) :: block
      integer(int64) :: first
      integer :: noted
      logical :: goes_on

      call set_up_block(simulation, path, block)
      call sink%begin(columns_of(simulation))
      noted = 0
      goes_on = .true.
      first = 0
      do while (first < simulation%settings%samples .and. goes_on)
         call set_times(simulation%settings%samples, path%duration, first, block)
         select case (path%path)
         case (path_constant)
            call fill_constant(path, block)
         case (path_closed_form)
            call fill_closed_form(path, block)
         case (path_string)
            call fill_string(path, block)
         end select
         if (simulation%settings%given(turning_frame_group)) call turn_frame(simulation%settings%frame_rate, block)
         call derive(path, block)
         call hand_over(path, block, sink, noted, goes_on)
         first = first + block%count
      end do
      if (allocated(error)) return
   end subroutine simulate

   !> The columns of a scene: the time, then what is asked for.
   pure function columns_of(simulation) result(columns)
      type(simulation_type), intent(in) :: simulation
      type(column_type), allocatable :: columns(:)
      integer :: i, j, count

      associate (chosen => simulation%settings%quantities)
         allocate (columns(1 + sum(quantities(chosen)%columns)))
         columns(1) = column_type('t', 's', 'time since the start')
         count = 1
         do i = 1, size(chosen)
            associate (quantity => quantities(chosen(i)))
               do j = 1, quantity%columns
                  count = count + 1
                  columns(count) = column_type(quantity%column_names(j), quantity%unit, quantity%meaning)
               end do
            end associate
         end do
      end associate
   end function columns_of

   !> Gives every quantity its columns, and those it is derived from.
   subroutine set_up_block(simulation, path, block)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(block_type), intent(out) :: block
      integer :: i, count

      count = 1
      do i = 1, size(simulation%settings%quantities)
         call add(simulation%settings%quantities(i))
      end do
      block%visible = count
      if (block%column(quantity_speed) > 0) call add(quantity_velocity)
      if (path%path == path_string) then
         if (any(block%column([quantity_energy, quantity_momentum]) > 0)) call add(quantity_velocity)
         if (block%column(quantity_azimuth) > 0) call add(quantity_position)
      end if
      if (block%column(quantity_velocity) > 0 .or. block%column(quantity_inclination) > 0) call add(quantity_position)
      allocate (block%values(block_samples, count))

   contains

      subroutine add(quantity)
         integer, intent(in) :: quantity

         if (block%column(quantity) > 0) return
         block%column(quantity) = count + 1
         count = count + quantities(quantity)%columns
      end subroutine add
   end subroutine set_up_block

   !> The times of the block that begins at a sample: i times the duration over the number of intervals, rounded once where
   !> the product is exact.
   pure subroutine set_times(samples, duration, first, block)
      integer(int64), intent(in) :: samples, first            !! `first` is counted from 0
      real(wp), intent(in) :: duration
      type(block_type), intent(inout) :: block
      real(wp) :: intervals
      integer :: i

      intervals = real(samples - 1, wp)
      block%count = int(min(int(block_samples, int64), samples - first))
      do i = 1, block%count
         block%values(i, 1) = real(first + i - 1, wp)*duration/intervals
      end do
      if (first + block%count == samples) block%values(block%count, 1) = duration
   end subroutine set_times

   !> A bob that stays where it is.
   pure subroutine fill_constant(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(wp) :: position(3), velocity(3)
      integer :: i

      call locate(path%orbit, 0.0_wp, position, velocity)
      associate (n => block%count, column => block%column)
         do i = 1, 3
            if (column(quantity_position) > 0) block%values(:n, column(quantity_position) + i - 1) = position(i)
            if (column(quantity_velocity) > 0) block%values(:n, column(quantity_velocity) + i - 1) = velocity(i)
         end do
         if (column(quantity_tension) > 0) block%values(:n, column(quantity_tension)) = &
            path%inertia*rod_force(path%orbit, 0.0_wp)
         ! It has none.
         if (column(quantity_azimuth) > 0) block%values(:n, column(quantity_azimuth)) = &
            ieee_value(1.0_wp, ieee_quiet_nan)
      end associate
      call fill_constants(path, block)
   end subroutine fill_constant

   !> What the motion of one orbit conserves, and works that nothing does.
   pure subroutine fill_constants(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      associate (n => block%count, column => block%column)
         if (column(quantity_energy) > 0) block%values(:n, column(quantity_energy)) = path%inertia*orbit_energy(path%orbit)
         if (column(quantity_momentum) > 0) block%values(:n, column(quantity_momentum)) = orbit_momentum(path%orbit)
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
         call place_samples(path%orbit, block%values(:n, 1), 1, block)
         if (column(quantity_tension) > 0) block%values(:n, column(quantity_tension)) = &
            path%inertia*rod_force(path%orbit, block%values(:n, 1))
         if (column(quantity_azimuth) > 0) block%values(:n, column(quantity_azimuth)) = &
            azimuth(path%orbit, block%values(:n, 1))
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
            call locate_batch(orbit, time, values(first:last, p), values(first:last, p + 1), values(first:last, p + 2), &
               values(first:last, v), values(first:last, v + 1), values(first:last, v + 2))
         else if (p > 0) then
            call locate_batch(orbit, time, values(first:last, p), values(first:last, p + 1), values(first:last, p + 2))
         end if
      end associate
   end subroutine place_samples

   !> Swings and flights.
   subroutine fill_string(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block
      real(wp) :: since(block_samples), position(3), velocity(3), tension
      integer :: first, last, piece, i

      associate (values => block%values, string => path%string, n => block%count, p => block%column(quantity_position), &
         v => block%column(quantity_velocity), tension_column => block%column(quantity_tension), &
         energy => block%column(quantity_energy), momentum => block%column(quantity_momentum))
         piece = 1
         first = 1
         do while (first <= n)
            ! The piece of this sample, and the last sample in it.
            do while (piece < size(string%pieces))
               if (string%pieces(piece + 1)%start > values(first, 1)) exit
               piece = piece + 1
            end do
            last = n
            if (piece < size(string%pieces)) last = first - 1 + count(values(first:n, 1) < string%pieces(piece + 1)%start)
            if (string%pieces(piece)%is_taut) then
               since(first:last) = values(first:last, 1) - string%pieces(piece)%start
               call place_samples(string%pieces(piece)%orbit, since(first:last), first, block)
               if (tension_column > 0) values(first:last, tension_column) = &
                  path%inertia*rod_force(string%pieces(piece)%orbit, since(first:last))
            else
               do i = first, last
                  call locate_on_string(string, values(i, 1), position, velocity, tension)
                  if (p > 0) values(i, p:p + 2) = position
                  if (v > 0) values(i, v:v + 2) = velocity
                  if (tension_column > 0) values(i, tension_column) = tension
               end do
            end if
            first = last + 1
         end do
         if (energy > 0) values(:n, energy) = path%inertia*((values(:n, v)**2 + values(:n, v + 1)**2 &
            + values(:n, v + 2)**2)/2 + string%gravity*values(:n, p + 2))
         if (momentum > 0) values(:n, momentum) = values(:n, p)*values(:n, v + 1) - values(:n, p + 1)*values(:n, v)
      end associate
      call fill_no_work(block)
   end subroutine fill_string

   !> The motion seen from a frame that turns about the vertical. Energy, momentum and tension stay those of the resting one.
   pure subroutine turn_frame(rate, block)
      real(wp), intent(in) :: rate                            !! [rad/s]
      type(block_type), intent(inout) :: block
      real(wp) :: position(3), velocity(3)
      integer :: i

      associate (values => block%values, n => block%count, p => block%column(quantity_position), &
         v => block%column(quantity_velocity), azimuth_column => block%column(quantity_azimuth))
         if (azimuth_column > 0) values(:n, azimuth_column) = values(:n, azimuth_column) - rate*values(:n, 1)
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

   !> What follows from place and velocity as they are shown.
   pure subroutine derive(path, block)
      type(path_type), intent(in) :: path
      type(block_type), intent(inout) :: block

      associate (values => block%values, n => block%count, column => block%column, &
         p => block%column(quantity_position), v => block%column(quantity_velocity))
         if (column(quantity_speed) > 0) values(:n, column(quantity_speed)) = &
            hypot(hypot(values(:n, v), values(:n, v + 1)), values(:n, v + 2))
         if (column(quantity_inclination) > 0) values(:n, column(quantity_inclination)) = &
            atan2(hypot(values(:n, p), values(:n, p + 1)), -values(:n, p + 2))
         if (column(quantity_azimuth) > 0 .and. path%path == path_string) values(:n, column(quantity_azimuth)) = &
            atan2(values(:n, p + 1), values(:n, p))
      end associate
   end subroutine derive

   !> Gives the samples to the sink, and each event before the samples that follow it.
   subroutine hand_over(path, block, sink, noted, goes_on)
      type(path_type), intent(in) :: path
      type(block_type), intent(in) :: block
      class(sample_sink_type), intent(inout) :: sink
      integer, intent(inout) :: noted                         !! Events handed over so far
      logical, intent(inout) :: goes_on
      type(scene_event_type) :: event
      integer :: first, last

      first = 1
      do while (first <= block%count .and. goes_on)
         last = block%count
         if (path%path == path_string) then
            do while (noted < size(path%string%events))
               if (path%string%events(noted + 1)%time > block%values(first, 1)) exit
               noted = noted + 1
               event = scene_event(path%string%events(noted))
               call sink%note(event)
            end do
            if (noted < size(path%string%events)) last = first - 1 &
               + count(block%values(first:block%count, 1) < path%string%events(noted + 1)%time)
         end if
         call sink%take(block%values(first:last, :block%visible), goes_on)
         first = last + 1
      end do
   end subroutine hand_over

   !> An event of the string, in words.
   pure function scene_event(from) result(event)
      type(string_event_type), intent(in) :: from
      type(scene_event_type) :: event

      event%time = from%time
      event%position = from%position
      event%energy_lost = from%energy_lost
      select case (from%kind)
      case (event_slack)
         event%what = 'slack'
      case (event_taut)
         event%what = 'taut'
      case (event_rebound)
         event%what = 'rebound'
      case default
         event%what = 'taut after rattling'
      end select
   end function scene_event

end module kyvadlo_simulate
