!> Samples and events on their way to a sink, in the order of time.
module kyvadlo_event_order
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_sample_block, only: block_type, in_laboratory
   use kyvadlo_sample_times, only: last_before
   use kyvadlo_samples, only: sample_sink_type, scene_event_type
   use kyvadlo_scene_groups, only: turning_frame_group
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_string, path_type
   use kyvadlo_string, only: event_rebound, event_slack, event_taut, string_event_type
   use kyvadlo_turning_frame, only: seen_from_turning_frame
   implicit none
   private
   public :: merge_events, hand_over, take_last

contains

   !> Adds to events found those of the string up to a time that were not handed over yet, in the order of time.
   pure subroutine merge_events(simulation, path, found, of_string, until, noted, events)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(scene_event_type), intent(in) :: found(:)
      type(string_event_type), intent(in) :: of_string(:)     !! All that are known yet
      real(wp), intent(in) :: until                           !! [s]
      integer, intent(inout) :: noted                         !! Of these, handed over so far
      type(scene_event_type), allocatable, intent(out) :: events(:)
      integer :: i, j, first

      first = noted
      do while (noted < size(of_string))
         if (of_string(noted + 1)%time > until) exit
         noted = noted + 1
      end do
      allocate (events(noted - first + size(found)))
      j = 0
      do i = first + 1, noted
         do while (j < size(found))
            if (.not. found(j + 1)%time < of_string(i)%time) exit
            j = j + 1
            events(i - first + j - 1) = found(j)
         end do
         events(i - first + j) = scene_event(simulation, path, of_string(i))
      end do
      events(noted - first + j + 1:) = found(j + 1:)
   end subroutine merge_events

   !> Gives the samples to the sink, and each event before the samples that follow it.
   subroutine hand_over(block, events, sink, goes_on, cells)
      type(block_type), intent(in) :: block
      type(scene_event_type), intent(in) :: events(:)
      class(sample_sink_type), intent(inout) :: sink
      logical, intent(inout) :: goes_on
      character(len=*), intent(in) :: cells(:, :)            !! The samples as text; of no size: as the numbers are
      integer :: first, last, noted

      first = 1
      noted = 0
      do while (goes_on)
         do while (noted < size(events))
            if (first <= block%count) then
               if (events(noted + 1)%time > block%values(first, 1)) exit
            end if
            noted = noted + 1
            call sink%note(events(noted))
         end do
         if (first > block%count) exit
         last = block%count
         if (noted < size(events)) last = last_before(block%values(:block%count, 1), first, events(noted + 1)%time)
         if (size(cells) > 0) then
            call sink%take_written(block%values(first:last, :block%visible), cells(first:last, :), goes_on)
         else
            call sink%take(block%values(first:last, :block%visible), goes_on)
         end if
         first = last + 1
      end do
   end subroutine hand_over

   !> A simulation that an event ends has its last sample there.
   subroutine take_last(block, event, sink)
      type(block_type), intent(in) :: block
      type(scene_event_type), intent(in) :: event
      class(sample_sink_type), intent(inout) :: sink
      logical :: goes_on

      if (block%count > 0) then
         if (.not. block%values(block%count, 1) < event%time) return
      end if
      if (allocated(event%cells)) then
         call sink%take_written(reshape(event%values, [1, block%visible]), reshape(event%cells, [1, block%visible]), &
            goes_on)
      else
         call sink%take(reshape(event%values, [1, block%visible]), goes_on)
      end if
   end subroutine take_last

   !> An event of the string in words, and where the samples show it.
   pure function scene_event(simulation, path, from) result(event)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(string_event_type), intent(in) :: from
      type(scene_event_type) :: event
      real(wp) :: displacement(3), velocity(3)

      event%time = from%time
      event%position = from%position
      event%energy_lost = from%energy_lost
      ! The integrator knows of the fluid.
      if (path%path == path_string) event%energy_lost = path%inertia*from%energy_lost
      if (in_laboratory(simulation)) then
         call pivot_motion(path%effects, from%time, displacement, velocity)
         event%position = event%position + displacement
      end if
      if (simulation%settings%given(turning_frame_group)) then
         velocity = 0
         call seen_from_turning_frame(simulation%settings%frame_rate, from%time, event%position, velocity)
      end if
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

end module kyvadlo_event_order
