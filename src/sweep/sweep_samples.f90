!> What a sweep keeps of the samples of one scene: extremes, ends, crossings, swings, contacts.
module kyvadlo_sweep_samples
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_quantities, only: quantities
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_sweep_measures
   implicit none
   private
   public :: measured_samples_type, begin_measures, get_measures

   type, extends(sample_sink_type) :: measured_samples_type
      private
      type(measure_type), allocatable :: measures(:)
      type(watch_type) :: watch
      integer, allocatable :: columns(:)             !! Of the measures among the samples; 0: none
      integer :: crossing = 0                        !! Column that is watched
      integer :: swing(3) = 0                        !! Columns of x, y and the inclination
      logical :: has_any = .false.
      real(wp), allocatable, dimension(:) :: least, greatest, first, last !! By measure
      real(wp) :: slack_time = 0, crossing_time = 0, energy_lost = 0, contacts = 0
      real(wp) :: before(2) = 0                      !! Time of the last sample, and the watched quantity less the level
      real(wp) :: amplitude = 0, azimuth = 0
      real(wp) :: times(2) = 0, swings(3, 2) = 0     !! The last two samples
      integer :: kept = 0                            !! Of them
   contains
      procedure :: begin => begin_samples
      procedure :: take => take_samples
      procedure :: note => note_event
   end type measured_samples_type

contains

   !> Ready for the samples of a scene.
   pure subroutine begin_measures(sink, measures, watch)
      type(measured_samples_type), intent(out) :: sink
      type(measure_type), intent(in) :: measures(:)
      type(watch_type), intent(in) :: watch

      sink%measures = measures
      sink%watch = watch
      allocate (sink%least(size(measures)), source=huge(1.0_wp))
      allocate (sink%greatest(size(measures)), source=-huge(1.0_wp))
      allocate (sink%first(size(measures)), sink%last(size(measures)), source=quiet_nan_real64)
      allocate (sink%columns(size(measures)), source=0)
      sink%slack_time = quiet_nan_real64
      sink%crossing_time = quiet_nan_real64
      sink%amplitude = quiet_nan_real64
      sink%azimuth = quiet_nan_real64
   end subroutine begin_measures

   subroutine begin_samples(sink, columns)
      class(measured_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)
      integer :: i

      do i = 1, size(sink%measures)
         sink%columns(i) = place_of(sink%measures(i)%quantity, sink%measures(i)%column)
      end do
      sink%crossing = place_of(sink%watch%quantity, sink%watch%column)
      if (any(sink%measures%kind == sampled_swing_amplitude .or. sink%measures%kind == sampled_swing_azimuth)) &
         sink%swing = [findloc(columns%name, 'x', 1), findloc(columns%name, 'y', 1), &
         findloc(columns%name, 'inclination', 1)]

   contains

      pure integer function place_of(quantity, column) result(place)
         integer, intent(in) :: quantity, column

         place = 0
         if (quantity > 0) place = findloc(columns%name, quantities(quantity)%column_names(column), 1)
      end function place_of
   end subroutine begin_samples

   subroutine take_samples(sink, values, goes_on)
      class(measured_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      real(wp) :: least, greatest
      integer :: i, j, n

      goes_on = .true.
      n = size(values, 1)
      if (n == 0) return
      do i = 1, size(sink%measures)
         j = sink%columns(i)
         if (j == 0) cycle
         if (.not. sink%has_any) sink%first(i) = values(1, j)
         sink%last(i) = values(n, j)
         if (sink%measures(i)%kind == sampled_least) then
            ! What does not exist is NaN, which compares with nothing.
            least = minval(values(:, j), values(:, j) == values(:, j))
            sink%least(i) = min(sink%least(i), least)
         else if (sink%measures(i)%kind == sampled_greatest) then
            greatest = maxval(values(:, j), values(:, j) == values(:, j))
            sink%greatest(i) = max(sink%greatest(i), greatest)
         end if
      end do
      if (sink%crossing > 0) call look_for_crossing(sink, values(:, 1), values(:, sink%crossing))
      if (sink%swing(1) > 0) call look_for_turning(sink, values(:, 1), values(:, sink%swing(1)), &
         values(:, sink%swing(2)), values(:, sink%swing(3)))
      sink%has_any = .true.
   end subroutine take_samples

   !> The first change of sign, on the straight line between two samples.
   pure subroutine look_for_crossing(sink, times, values)
      class(measured_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: times(:), values(:)
      real(wp) :: above
      integer :: i

      if (sink%crossing_time == sink%crossing_time) return
      do i = 1, size(times)
         above = values(i) - sink%watch%level
         if (sink%has_any .or. i > 1) then
            associate (old => sink%before(2))
               if (old < 0 .and. above >= 0 .or. old > 0 .and. above <= 0) then
                  sink%crossing_time = sink%before(1) + (times(i) - sink%before(1))*(old/(old - above))
                  return
               end if
            end associate
         end if
         sink%before = [times(i), above]
      end do
   end subroutine look_for_crossing

   !> The first turning point outwards from the time on: the top of the parabola through three samples of the
   !> inclination.
   pure subroutine look_for_turning(sink, times, x, y, inclination)
      class(measured_samples_type), intent(inout) :: sink
      real(wp), intent(in), dimension(:) :: times, x, y, inclination
      real(wp), parameter :: pi = acos(-1.0_wp)
      real(wp) :: now(3), at(3), shift, bend
      integer :: i

      if (sink%amplitude == sink%amplitude) return
      do i = 1, size(times)
         now = [x(i), y(i), inclination(i)]
         if (sink%kept == 2 .and. sink%times(2) >= sink%watch%time) then
            if (sink%swings(3, 2) >= sink%swings(3, 1) .and. sink%swings(3, 2) >= now(3)) then
               bend = sink%swings(3, 1) - 2*sink%swings(3, 2) + now(3)
               shift = 0
               if (bend < 0) shift = (sink%swings(3, 1) - now(3))/(2*bend)
               at = sink%swings(:, 2) + shift*(now - sink%swings(:, 1))/2 &
                  + shift**2*(now - 2*sink%swings(:, 2) + sink%swings(:, 1))/2
               sink%amplitude = at(3)
               sink%azimuth = atan2(at(2), at(1))
               if (sink%azimuth > pi/2) sink%azimuth = sink%azimuth - pi
               if (sink%azimuth <= -pi/2) sink%azimuth = sink%azimuth + pi
               return
            end if
         end if
         if (sink%kept > 0) then
            sink%swings(:, 1) = sink%swings(:, 2)
            sink%times(1) = sink%times(2)
         end if
         sink%swings(:, 2) = now
         sink%times(2) = times(i)
         sink%kept = min(sink%kept + 1, 2)
      end do
   end subroutine look_for_turning

   subroutine note_event(sink, event)
      class(measured_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      if (event%request > 0) return
      if (event%what == 'slack') then
         if (sink%slack_time /= sink%slack_time) sink%slack_time = event%time
      else
         sink%contacts = sink%contacts + 1
         sink%energy_lost = sink%energy_lost + event%energy_lost
      end if
   end subroutine note_event

   !> What was measured; NaN where there is nothing. Quantities of the orbit are left alone.
   pure subroutine get_measures(sink, values)
      type(measured_samples_type), intent(in) :: sink
      real(wp), intent(inout) :: values(:)           !! Components of all measures
      integer :: i, at

      at = 0
      do i = 1, size(sink%measures)
         at = at + sink%measures(i)%components
         select case (sink%measures(i)%kind)
         case (sampled_least)
            values(at) = sink%least(i)
            if (.not. sink%least(i) < huge(1.0_wp)) values(at) = quiet_nan_real64
         case (sampled_greatest)
            values(at) = sink%greatest(i)
            if (.not. sink%greatest(i) > -huge(1.0_wp)) values(at) = quiet_nan_real64
         case (sampled_first)
            values(at) = sink%first(i)
         case (sampled_last)
            values(at) = sink%last(i)
         case (sampled_slack_time)
            values(at) = sink%slack_time
         case (sampled_crossing_time)
            values(at) = sink%crossing_time
         case (sampled_swing_amplitude)
            values(at) = sink%amplitude
         case (sampled_swing_azimuth)
            values(at) = sink%azimuth
         case (sampled_energy_lost)
            values(at) = sink%energy_lost
         case (sampled_contacts)
            values(at) = sink%contacts
         end select
      end do
   end subroutine get_measures

end module kyvadlo_sweep_samples
