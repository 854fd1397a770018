!> Motions in time that are known piece by piece: polynomials between ascending times.
module kyvadlo_curves
   use, intrinsic :: iso_fortran_env, only: wp => real64
   implicit none
   private
   public :: curve_type, look_up, next_joint, rate_jump, interval_at, least_value, integrated, move_curve

   !> Not allocated: there is none. Before the first piece and behind the last these go on.
   type :: curve_type
      real(wp), allocatable :: times(:)        !! (n + 1) ends of the pieces, ascending [s]
      real(wp), allocatable :: terms(:, :, :)  !! (m, 0:degree, n) coefficients of the powers of time - times(k)
   end type curve_type

contains

   !> The values of a curve and their derivatives, by Horner's rule.
   pure subroutine look_up(curve, time, derivatives, until)
      type(curve_type), intent(in) :: curve
      real(wp), intent(in) :: time                  !! [s]
      real(wp), intent(out) :: derivatives(:, 0:)   !! (m, 0:order)
      real(wp), intent(in), optional :: until       !! From this end on the piece before it goes on [s]
      real(wp) :: since, factor
      integer :: i, j, k, order

      k = interval_at(curve%times, time)
      if (present(until)) then
         if (time >= until) k = interval_at(curve%times, nearest(until, -1.0_wp))
      end if
      since = time - curve%times(k)
      do order = 0, ubound(derivatives, 2)
         derivatives(:, order) = 0
         do i = ubound(curve%terms, 2), order, -1
            factor = 1
            do j = 0, order - 1
               factor = factor*(i - j)
            end do
            derivatives(:, order) = derivatives(:, order)*since + factor*curve%terms(:, i, k)
         end do
      end do
   end subroutine look_up

   !> The next end of a piece, where a derivative jumps; huge without a curve or behind it [s].
   pure real(wp) function next_joint(curve, time)
      type(curve_type), intent(in) :: curve
      real(wp), intent(in) :: time

      next_joint = huge(next_joint)
      if (.not. allocated(curve%times)) return
      associate (t => curve%times)
         if (time < t(1)) then
            next_joint = t(1)
         else if (time < t(size(t))) then
            next_joint = t(interval_at(t, time) + 1)
         end if
      end associate
   end function next_joint

   !> By how much the first derivative of a motion in space jumps at a time: along straight lines, at their joints.
   pure function rate_jump(curve, time) result(jump)
      type(curve_type), intent(in) :: curve
      real(wp), intent(in) :: time                  !! [s]
      real(wp) :: jump(3)
      integer :: k

      jump = 0
      if (.not. allocated(curve%times)) return
      k = interval_at(curve%times, time)
      if (ubound(curve%terms, 2) > 1 .or. k == 1 .or. time > curve%times(k)) return
      jump = curve%terms(:, 1, k) - curve%terms(:, 1, k - 1)
   end function rate_jump

   !> The k with t(k) <= time < t(k + 1), at the ends the outermost.
   pure integer function interval_at(t, time) result(low)
      real(wp), intent(in) :: t(:), time
      integer :: high, middle

      low = 1
      high = size(t)
      do while (high - low > 1)
         middle = shiftr(low + high, 1)
         if (t(middle) <= time) then
            low = middle
         else
            high = middle
         end if
      end do
   end function interval_at

   !> The curve whose rate this one is: zero at time 0.
   pure function integrated(curve) result(integral)
      type(curve_type), intent(in) :: curve
      type(curve_type) :: integral
      real(wp) :: at_start(size(curve%terms, 1), 0:0), step
      integer :: i, k, m, n, degree

      m = size(curve%terms, 1)
      degree = ubound(curve%terms, 2)
      n = size(curve%terms, 3)
      allocate (integral%times, source=curve%times)
      allocate (integral%terms(m, 0:degree + 1, n))
      integral%terms = 0
      do k = 1, n
         do i = 0, degree
            integral%terms(:, i + 1, k) = curve%terms(:, i, k)/(i + 1)
         end do
         if (k == n) exit
         step = curve%times(k + 1) - curve%times(k)
         do i = degree + 1, 0, -1
            integral%terms(:, 0, k + 1) = integral%terms(:, 0, k + 1)*step + integral%terms(:, i, k)
         end do
      end do
      call look_up(integral, 0.0_wp, at_start)
      do k = 1, n
         integral%terms(:, 0, k) = integral%terms(:, 0, k) - at_start(:, 0)
      end do
   end function integrated

   !> From rest at 0 at time 0 to rest at a place, along a straight line, as fast as speed, acceleration and jerk may
   !> be; without a jerk the acceleration jumps. There it stays.
   pure function move_curve(way, speed, acceleration, jerk) result(curve)
      real(wp), intent(in) :: way(3)                !! [m]
      real(wp), intent(in) :: speed, acceleration   !! Largest, positive [m/s], [m/s2]
      real(wp), intent(in) :: jerk                  !! Largest [m/s3]; 0: no limit
      type(curve_type) :: curve
      real(wp) :: distance, ramp, rise, cruise, spans(7), bends(7), state(0:1), third, h
      integer :: k, n

      distance = norm2(way)
      if (.not. (distance > 0 .and. speed > 0 .and. acceleration > 0)) return
      ramp = 0
      if (jerk > 0) ramp = min(acceleration/jerk, sqrt(speed/jerk))
      if (jerk > 0) then
         rise = ramp + speed/(jerk*ramp)
      else
         rise = speed/acceleration
      end if
      cruise = distance/speed - rise
      if (.not. cruise > 0) then
         ! The speed is not reached.
         cruise = 0
         if (jerk > 0) ramp = min(acceleration/jerk, (distance/(2*jerk))**(1.0_wp/3))
         if (jerk > 0 .and. ramp < acceleration/jerk) then
            rise = 2*ramp
         else
            rise = ramp/2 + sqrt(ramp**2/4 + distance/acceleration)
         end if
      end if
      ! What rounding makes of no span is none.
      if (rise - 2*ramp < 1024*epsilon(rise)*rise) rise = 2*ramp
      if (cruise < 1024*epsilon(rise)*rise) cruise = 0
      spans = [ramp, rise - 2*ramp, ramp, cruise, ramp, rise - 2*ramp, ramp]
      ! The acceleration at the begin of each.
      bends = distance/((rise - ramp)*(rise + cruise))*[0, 1, 1, 0, 0, -1, -1]
      allocate (curve%times(count(spans > 0) + 2), curve%terms(3, 0:3, count(spans > 0) + 1))
      curve%terms = 0
      curve%times(1) = 0
      state = 0
      n = 0
      do k = 1, 7
         h = spans(k)
         if (.not. h > 0) cycle
         n = n + 1
         curve%times(n + 1) = curve%times(n) + h
         third = slope(k)
         curve%terms(:, 0, n) = way/distance*state(0)
         curve%terms(:, 1, n) = way/distance*state(1)
         curve%terms(:, 2, n) = way/distance*bends(k)/2
         curve%terms(:, 3, n) = way/distance*third/6
         state(0) = state(0) + h*(state(1) + h*(bends(k)/2 + h*third/6))
         state(1) = state(1) + h*(bends(k) + h*third/2)
      end do
      curve%times(n + 2) = huge(h)
      curve%terms(:, 0, n + 1) = way

   contains

      !> The jerk of a span.
      pure real(wp) function slope(k)
         integer, intent(in) :: k

         slope = 0
         if (mod(k, 2) == 1 .and. ramp > 0) slope = merge(1, -1, k == 1 .or. k == 7)*maxval(bends)/ramp
      end function slope
   end function move_curve

   !> The least value of one component between two times, of pieces up to the third degree.
   pure real(wp) function least_value(curve, component, from, to) result(least)
      type(curve_type), intent(in) :: curve
      integer, intent(in) :: component
      real(wp), intent(in) :: from, to              !! [s]
      real(wp) :: a, b, c, d, root
      integer :: k

      least = min(value_at(from), value_at(to))
      do k = 1, size(curve%times) - 1
         if (curve%times(k) > from .and. curve%times(k) < to) least = min(least, curve%terms(component, 0, k))
         ! Where a + b s + c s**2 vanishes and rises.
         a = curve%terms(component, 1, k)
         b = 2*curve%terms(component, 2, k)
         c = 3*curve%terms(component, 3, k)
         d = b**2 - 4*a*c
         if (.not. d >= 0) cycle
         root = sqrt(d)
         d = b + root
         if (b < 0) d = b - root
         if (b < 0 .and. abs(c) > 0) then
            root = -d/(2*c)
         else if (abs(d) > 0) then
            root = -2*a/d
         else
            cycle
         end if
         root = curve%times(k) + root
         if (root > max(from, curve%times(k)) .and. root < min(to, curve%times(k + 1))) &
            least = min(least, value_at(root))
      end do

   contains

      pure real(wp) function value_at(time)
         real(wp), intent(in) :: time
         real(wp) :: derivatives(size(curve%terms, 1), 0:0)

         call look_up(curve, time, derivatives)
         value_at = derivatives(component, 0)
      end function value_at
   end function least_value

end module kyvadlo_curves
