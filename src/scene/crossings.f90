!> Where the quantities of a smooth stretch of a motion pass given values, and where they are extreme.
!>
!> Between two neighbouring points a quantity can do what its second derivative lets it. With a bound b of that, values
!> f and g at a distance h leave no zero between them if both are beyond b h**2/8 on one side, and one at most if they
!> differ by more than b h**2. Where neither can be said the stretch is halved, down to what rounding resolves: so no
!> pair of zeros is missed. Zeros are found by the regula falsi with the Illinois rule, and bisection where that stalls.
module kyvadlo_crossings
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_nan
   implicit none
   private
   public :: probe_type, step_watcher_type, watch_type, crossing_type, extreme_type, find_crossings, find_extremes

   !> Who can tell the quantities of a motion at times within a stretch.
   type, abstract :: probe_type
      integer :: columns = 0               !! Of what `at` tells
      logical :: is_approximate = .false.  !! `at` has better values when they are asked for `exactly`
   contains
      procedure(probe_at), deferred :: at
      procedure(settle_at), deferred :: settle
   end type probe_type

   abstract interface
      !> All columns at some times.
      subroutine probe_at(probe, times, values, exactly)
         import :: probe_type, wp
         class(probe_type), intent(inout) :: probe
         real(wp), intent(in) :: times(:)
         real(wp), intent(out) :: values(:, :)     !! (time, column)
         logical, intent(in) :: exactly
      end subroutine probe_at

      !> From now on times are not earlier than this one: where turns are counted from.
      subroutine settle_at(probe, time)
         import :: probe_type, wp
         class(probe_type), intent(inout) :: probe
         real(wp), intent(in) :: time
      end subroutine settle_at
   end interface

   !> Who looks at every step of an integration.
   type, abstract :: step_watcher_type
      logical :: is_over = .false.         !! No further step is wanted
   contains
      procedure(look_at_step), deferred :: look
   end type step_watcher_type

   abstract interface
      !> After a step, while its ends and what is between them are known.
      subroutine look_at_step(watcher, from, to)
         import :: step_watcher_type, wp
         class(step_watcher_type), intent(inout) :: watcher
         real(wp), intent(in) :: from, to  !! [s]
      end subroutine look_at_step
   end interface

   !> A column and a value that it may pass, and what is known of it so far.
   type :: watch_type
      integer :: column = 0
      real(wp) :: value = 0
      real(wp) :: noise = 0                !! What is nearer to the value may be on either side of it, for rounding
      real(wp) :: bend = -1                !! Bound of the second derivative; negative: estimated from the points
      integer, private :: side = 0         !! Of the value, at the last point beyond the noise; 0: there was none
      real(wp), private :: time = 0, miss = 0 !! When that was, and by how much it was off
   end type watch_type

   type :: crossing_type
      real(wp) :: time = 0
      integer :: watch = 0
      integer :: direction = 0             !! 1: rising, -1: falling
   end type crossing_type

   !> The largest or least of a column.
   type :: extreme_type
      integer :: column = 0
      integer :: sense = 1                 !! 1: the largest, -1: the least
      real(wp) :: value = -huge(1.0_wp)    !! Times `sense`
      real(wp) :: time = 0
   end type extreme_type

   !> Halvings of a distance of two points, and of one with a zero in it, that leave nothing to halve.
   integer, parameter :: most_halvings = digits(1.0_wp), most_steps = 4*digits(1.0_wp)
   !> An estimated bound of the second derivative is so many times the largest that the points show.
   real(wp), parameter :: margin = 4

contains

   !> The crossings of a stretch, those of one watch after the other.
   subroutine find_crossings(probe, times, values, watches, crossings)
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: times(:)                     !! (n) ascending; the first where the stretch before ended
      real(wp), intent(in) :: values(:, :)                 !! (n, columns) by `probe`
      type(watch_type), intent(inout) :: watches(:)        !! Of column 0: nothing is looked for
      type(crossing_type), allocatable, intent(out) :: crossings(:)
      real(wp) :: bend
      integer :: i, j

      allocate (crossings(0))
      do j = 1, size(watches)
         if (watches(j)%column == 0) cycle
         associate (watch => watches(j), f => values(:, watches(j)%column) - watches(j)%value)
            call arrive(probe, watch, j, times(1), times(1), f(1), crossings)
            bend = bend_of(watch, times, f)
            do i = 2, size(times)
               call look(probe, watch, j, times(1), bend, times(i - 1), f(i - 1), times(i), f(i), 0, crossings)
            end do
         end associate
      end do
   end subroutine find_crossings

   !> The bound of a watch, or one from the second differences of the points.
   pure real(wp) function bend_of(watch, times, f) result(bend)
      type(watch_type), intent(in) :: watch
      real(wp), intent(in) :: times(:), f(:)
      real(wp) :: second
      integer :: i

      bend = watch%bend
      if (bend >= 0) return
      bend = 0
      do i = 2, size(times) - 1
         ! Where the times are one there is no slope; 0/0 is not even formed.
         if (.not. (times(i) > times(i - 1) .and. times(i + 1) > times(i))) cycle
         second = 2*abs((f(i + 1) - f(i))/(times(i + 1) - times(i)) - (f(i) - f(i - 1))/(times(i) - times(i - 1))) &
            /(times(i + 1) - times(i - 1))
         if (is_nan(second)) cycle
         if (second > bend) bend = second
      end do
      bend = margin*bend
   end function bend_of

   !> What lies between two points.
   recursive subroutine look(probe, watch, j, start, bend, from, at_from, to, at_to, halvings, crossings)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(inout) :: watch
      integer, intent(in) :: j                             !! Its number
      real(wp), intent(in) :: start, bend, from, at_from, to, at_to
      integer, intent(in) :: halvings                      !! So far
      type(crossing_type), allocatable, intent(inout) :: crossings(:)
      real(wp) :: middle, at_middle, dip
      logical :: is_clear, is_resolved

      if (is_nan(at_from) .or. is_nan(at_to)) then
         call arrive(probe, watch, j, start, to, at_to, crossings)
         return
      end if
      dip = bend*(to - from)**2/8
      is_clear = abs(at_to - at_from) > 8*dip
      if (at_from > 0 .eqv. at_to > 0) is_clear = is_clear .or. min(abs(at_from), abs(at_to)) > dip
      is_resolved = dip <= watch%noise .or. halvings == most_halvings .or. to - from <= 4*spacing(to)
      if (is_clear .or. is_resolved) then
         call arrive(probe, watch, j, start, to, at_to, crossings)
         return
      end if
      if (max(abs(at_from), abs(at_to)) <= watch%noise) then
         ! Zero where it cannot be by chance: a quantity that the motion keeps, like y in the plane of x.
         if (is_quiet(probe, watch, from, to)) return
      end if
      middle = from + (to - from)/2
      at_middle = miss_at(probe, watch, middle, .false.)
      call look(probe, watch, j, start, bend, from, at_from, middle, at_middle, halvings + 1, crossings)
      call look(probe, watch, j, start, bend, middle, at_middle, to, at_to, halvings + 1, crossings)
   end subroutine look

   !> Whether there is nothing but noise between two points.
   logical function is_quiet(probe, watch, from, to)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(in) :: watch
      real(wp), intent(in) :: from, to
      real(wp), parameter :: parts(3) = [0.29_wp, 0.53_wp, 0.81_wp]  !! In no simple ratio
      integer :: i

      do i = 1, size(parts)
         is_quiet = abs(miss_at(probe, watch, from + parts(i)*(to - from), .false.)) <= watch%noise
         if (.not. is_quiet) return
      end do
   end function is_quiet

   !> The next point: is it on the other side?
   subroutine arrive(probe, watch, j, start, time, miss, crossings)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(inout) :: watch
      integer, intent(in) :: j
      real(wp), intent(in) :: start, time, miss
      type(crossing_type), allocatable, intent(inout) :: crossings(:)
      integer :: side

      if (is_nan(miss)) then
         watch%side = 0
         return
      end if
      if (.not. abs(miss) > watch%noise) return
      side = merge(1, -1, miss > 0)
      if (watch%side == -side) crossings = [crossings, crossing_type(zero_between(probe, watch, start, time, miss), j, &
         side)]
      watch%side = side
      watch%time = time
      watch%miss = miss
   end subroutine arrive

   real(wp) function miss_at(probe, watch, time, exactly) result(miss)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(in) :: watch
      real(wp), intent(in) :: time
      logical, intent(in) :: exactly
      real(wp) :: values(1, probe%columns)

      call probe%at([time], values, exactly)
      miss = values(1, watch%column) - watch%value
   end function miss_at

   !> The zero between the last point off the value and one on its other side.
   real(wp) function zero_between(probe, watch, start, to, at_to) result(zero)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(in) :: watch
      real(wp), intent(in) :: start                        !! Before it the probe knows nothing
      real(wp), intent(in) :: to, at_to
      real(wp) :: low, high, at_low, at_high, value, slope, width
      integer :: i, last

      low = watch%time
      at_low = watch%miss
      high = to
      at_high = at_to
      zero = to
      if (low < start) then
         ! It was within the noise when the stretch before ended.
         low = start
         at_low = miss_at(probe, watch, low, .false.)
         zero = low
         if (at_low > 0 .eqv. at_high > 0) return
      end if
      if (.not. high > low) return
      slope = (at_high - at_low)/(high - low)
      last = 0
      width = high - low
      do i = 1, most_steps
         zero = (low*at_high - high*at_low)/(at_high - at_low)
         ! Three steps that do not halve the stretch: a bend or a jump.
         if (modulo(i, 4) == 0) then
            if (high - low > width/2) zero = low + (high - low)/2
            width = high - low
         end if
         if (.not. (zero > low .and. zero < high)) zero = low + (high - low)/2
         if (zero <= low .or. zero >= high) exit
         value = miss_at(probe, watch, zero, .false.)
         if (.not. abs(value) > 0) exit
         if (value > 0 .eqv. at_high > 0) then
            high = zero
            at_high = value
            if (last == 1) at_low = at_low/2
            last = 1
         else
            low = zero
            at_low = value
            if (last == -1) at_high = at_high/2
            last = -1
         end if
         if (high - low <= 2*spacing(high)) exit
      end do
      if (probe%is_approximate) call polish(probe, watch, watch%time, to, slope, zero)
   end function zero_between

   !> The secant method on the exact values, within the stretch where the approximate ones have the zero.
   subroutine polish(probe, watch, from, to, first_slope, zero)
      class(probe_type), intent(inout) :: probe
      type(watch_type), intent(in) :: watch
      real(wp), intent(in) :: from, to, first_slope
      real(wp), intent(inout) :: zero
      real(wp) :: slope, next, value, before
      integer :: i
      !> From the tolerance of a step to its square and on.
      integer, parameter :: most_secants = 5

      slope = first_slope
      value = miss_at(probe, watch, zero, .true.)
      do i = 1, most_secants
         next = zero - value/slope
         if (.not. (next >= from .and. next <= to)) return
         if (abs(next - zero) <= spacing(zero)) return
         before = value
         value = miss_at(probe, watch, next, .true.)
         if (.not. abs(value) < abs(before)) return
         slope = (value - before)/(next - zero)
         zero = next
      end do
   end subroutine polish

   !> Extremes of a stretch beyond those known.
   subroutine find_extremes(probe, times, values, extremes)
      class(probe_type), intent(inout) :: probe
      real(wp), intent(in) :: times(:), values(:, :)       !! As for `find_crossings`
      type(extreme_type), intent(inout) :: extremes(:)
      real(wp) :: f(3), top
      integer :: i, j

      do j = 1, size(extremes)
         if (extremes(j)%column == 0) cycle
         associate (extreme => extremes(j), g => extremes(j)%sense*values(:, extremes(j)%column))
            do i = 1, size(times)
               if (is_beyond(g(i), extreme)) then
                  extreme%value = g(i)
                  extreme%time = times(i)
               end if
            end do
            do i = 2, size(times) - 1
               f = g(i - 1:i + 1)
               if (.not. (f(2) >= f(1) .and. f(2) >= f(3) .and. f(1) + f(3) < 2*f(2))) cycle
               ! No more than that above the parabola through them.
               top = f(2) + (f(1) - f(3))**2/(8*(2*f(2) - f(1) - f(3))) + (2*f(2) - f(1) - f(3))
               if (is_beyond(top, extreme)) call climb(probe, extreme, times(i - 1:i + 1), f)
            end do
         end associate
      end do
   end subroutine find_extremes

   !> More than by rounding: of equals the first counts.
   pure logical function is_beyond(value, extreme)
      real(wp), intent(in) :: value                        !! Times the sense
      type(extreme_type), intent(in) :: extreme

      is_beyond = value > extreme%value + 8*epsilon(value)*abs(extreme%value)
   end function is_beyond

   !> To the top between three points: along parabolas, each through the best three so far.
   subroutine climb(probe, extreme, times, values)
      class(probe_type), intent(inout) :: probe
      type(extreme_type), intent(inout) :: extreme
      real(wp), intent(in) :: times(3), values(3)          !! The second is the highest
      real(wp) :: t(3), f(3), row(1, probe%columns), at, value, d1, d2
      integer :: i
      !> Near the top their order is 1.3; golden sections take the place of steps that do not move.
      integer, parameter :: most_climbs = 40

      t = times
      f = values
      do i = 1, most_climbs
         d1 = (t(2) - t(1))*(f(2) - f(3))
         d2 = (t(2) - t(3))*(f(2) - f(1))
         at = t(2)
         if (abs(d1 - d2) > 0) at = t(2) - ((t(2) - t(1))*d1 - (t(2) - t(3))*d2)/(2*(d1 - d2))
         if (modulo(i, 4) == 0 .or. .not. (abs(at - t(2)) > 0)) at = t(2) + 0.38_wp*merge(t(3) - t(2), t(1) - t(2), &
            t(3) - t(2) > t(2) - t(1))
         if (.not. (at > t(1) .and. at < t(3))) exit
         call probe%at([at], row, .false.)
         value = extreme%sense*row(1, extreme%column)
         if (value > f(2)) then
            if (at > t(2)) then
               t = [t(2), at, t(3)]
               f = [f(2), value, f(3)]
            else
               t = [t(1), at, t(2)]
               f = [f(1), value, f(2)]
            end if
         else if (at > t(2)) then
            t(3) = at
            f(3) = value
         else
            t(1) = at
            f(1) = value
         end if
         if (t(3) - t(1) <= sqrt(epsilon(at))*(times(3) - times(1))) exit
      end do
      if (.not. is_beyond(f(2), extreme)) return
      extreme%value = f(2)
      extreme%time = t(2)
   end subroutine climb

end module kyvadlo_crossings
