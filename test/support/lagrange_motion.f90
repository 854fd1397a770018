!> Motions under effects that have no closed form, in quadruple precision, on a way that shares nothing with src/numeric: Lagrange's
!> equations in the two angles of a cardan suspension (and its length, where it is elastic) instead of Newton's in Cartesian
!> coordinates, extrapolated midpoint rules (Gragg, Bulirsch, Stoer) of order 18 instead of a Runge-Kutta method, contacts of a string by
!> bisection.
!>
!> The angles: a about the axis of the upper hinge, b about that of the lower; the bob is at e sin a along the long direction,
!> s sin b along the short one and upper - e cos a in height, e = apart + s cos b. With both hinges in one point it is a sphere.
module lagrange_motion
   use reference_kinds, only: qp => integrated
   implicit none
   private
   public :: scene_type, contact_type, lagrange_run

   type :: scene_type
      real(qp) :: length = 1, gravity = 1
      real(qp) :: linear_drag = 0, quadratic_drag = 0, wind(3) = 0, turn_rate(3) = 0
      real(qp) :: diameter = 0, mass = 1, density = 0, viscosity = 0 !! Of a sphere in air by the curve of Brown and Lawler
      real(qp) :: amplitude(3) = 0, frequency(3) = 0, phase(3) = 0
      real(qp), allocatable :: times(:), displacements(:, :)  !! Table of the pivot, (n), (3, n)
      real(qp) :: hoist_rate = 0                              !! Of the length
      real(qp), allocatable :: hoist_times(:), hoist_lengths(:) !! Table of it, (n)
      real(qp) :: stiffness = 0, extra_length(2) = 0, restitution = 0, density_ratio = 0, added_mass = 0
      logical :: is_string = .false.
   end type scene_type

   type :: contact_type
      real(qp) :: time = 0, position(3) = 0, energy_lost = 0
      logical :: is_slack = .false.   !! The string goes slack; else it becomes taut or rebounds
   end type contact_type

   !> Coordinates, their rates, works of drag and pivot.
   integer, parameter :: most = 8
   !> Columns of the extrapolation.
   integer, parameter :: columns = 9
   real(qp), parameter :: pi = acos(-1.0_qp)

   type :: motion_type
      type(scene_type) :: scene
      real(qp), allocatable :: moments(:, :)   !! Second derivatives of the spline at its knots, (n, 3)
      real(qp), allocatable :: hoist_moments(:)
      logical :: is_taut = .true.
      integer :: free = 2              !! Coordinates
      real(qp) :: y(most) = 0, t = 0
      integer :: long = 1, short = 2
      real(qp) :: upper = 0, apart = 0, radius = 0, inertia = 1
   end type motion_type

contains

   !> The state at ascending times, in steps of `step`; contacts of a string on the way.
   subroutine lagrange_run(scene, position, velocity, times, step, positions, velocities, tensions, works, contacts)
      type(scene_type), intent(in) :: scene
      real(qp), intent(in) :: position(3), velocity(3), times(:), step
      real(qp), intent(out) :: positions(:, :), velocities(:, :), tensions(:), works(:, :)
      type(contact_type), allocatable, intent(out) :: contacts(:)
      type(motion_type) :: motion
      real(qp) :: h, next(most), rates(most)
      integer :: i
      logical :: hit, fresh

      call begin(motion, scene, position, velocity)
      allocate (contacts(0))
      fresh = .true.
      do i = 1, size(times)
         do while (motion%t < times(i))
            h = min(step, times(i) - motion%t)
            if (allocated(scene%times)) then
               h = min(h, minval(scene%times, scene%times > motion%t) - motion%t)
            end if
            if (allocated(scene%hoist_times)) &
               h = min(h, minval(scene%hoist_times, scene%hoist_times > motion%t) - motion%t)
            next = stepped(motion, h)
            hit = .false.
            if (scene%is_string) call look_for_contact(motion, fresh, h, next, hit)
            motion%y = next
            motion%t = motion%t + h
            if (hit) call make_contact(motion, contacts)
            fresh = hit
         end do
         call find_rates(motion, motion%t, motion%y, rates, tensions(i))
         call cartesian(motion, motion%t, motion%y, positions(:, i), velocities(:, i))
         works(:, i) = motion%y(7:8)
      end do
   end subroutine lagrange_run

   subroutine begin(motion, scene, position, velocity)
      type(motion_type), intent(out) :: motion
      type(scene_type), intent(in) :: scene
      real(qp), intent(in) :: position(3), velocity(3)
      real(qp) :: rates(most), tension
      integer :: axis

      motion%scene = scene
      if (scene%extra_length(2) > scene%extra_length(1)) then
         motion%long = 2
         motion%short = 1
      end if
      motion%upper = maxval(scene%extra_length)
      motion%apart = motion%upper - minval(scene%extra_length)
      motion%radius = scene%length + minval(scene%extra_length)
      motion%inertia = 1 + scene%density_ratio*scene%added_mass
      if (scene%stiffness > 0) motion%free = 3
      if (allocated(scene%times)) then
         allocate (motion%moments(size(scene%times), 3))
         do axis = 1, 3
            motion%moments(:, axis) = natural_moments(scene%times, scene%displacements(axis, :))
         end do
      end if
      if (allocated(scene%hoist_times)) motion%hoist_moments = natural_moments(scene%hoist_times, scene%hoist_lengths)
      call set_state(motion, position, velocity)
      if (.not. scene%is_string) return
      call find_rates(motion, 0.0_qp, motion%y, rates, tension)
      if (tension < 0) then
         motion%is_taut = .false.
         call set_state(motion, position, velocity)
      end if
   end subroutine begin

   !> Coordinates from place and velocity, by what kind of motion it is.
   subroutine set_state(motion, p, v)
      type(motion_type), intent(inout) :: motion
      real(qp), intent(in) :: p(3), v(3)
      real(qp) :: q(3), tangents(3, 3), rest(3), matrix(3, 3)
      integer :: i, j

      if (.not. motion%is_taut) then
         motion%y(:6) = [p, v]
         return
      end if
      q = angles(motion, p)
      call frame(motion, q, [0.0_qp, 0.0_qp, 0.0_qp], tangents, rest)
      do i = 1, 3
         do j = 1, 3
            matrix(i, j) = dot_product(tangents(:, i), tangents(:, j))
         end do
      end do
      rest = solved(matrix, matmul(v, tangents))
      motion%y(:6) = 0
      motion%y(:motion%free) = q(:motion%free)
      motion%y(motion%free + 1:2*motion%free) = rest(:motion%free)
   end subroutine set_state

   pure function angles(motion, p) result(q)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: p(3)
      real(qp) :: q(3), x, zeta, along

      x = p(motion%long)
      zeta = motion%upper - p(3)
      along = sqrt(x**2 + zeta**2) - motion%apart
      q = [atan2(x, zeta), atan2(p(motion%short), along), sqrt(along**2 + p(motion%short)**2)]
   end function angles

   !> Derivatives of the place by the coordinates, and its second derivative in time without theirs.
   pure subroutine frame(motion, q, rate, tangents, rest)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: q(3), rate(3)
      real(qp), intent(out) :: tangents(3, 3), rest(3)
      real(qp) :: sa, ca, sb, cb, e, e1, e2

      sa = sin(q(1)); ca = cos(q(1)); sb = sin(q(2)); cb = cos(q(2))
      e = motion%apart + q(3)*cb
      e1 = rate(3)*cb - q(3)*sb*rate(2)
      e2 = -2*rate(3)*sb*rate(2) - q(3)*cb*rate(2)**2
      associate (x => motion%long, y => motion%short)
         tangents(x, :) = [e*ca, -q(3)*sb*sa, cb*sa]
         tangents(y, :) = [0.0_qp, q(3)*cb, sb]
         tangents(3, :) = [e*sa, q(3)*sb*ca, -cb*ca]
         rest(x) = e2*sa + 2*e1*ca*rate(1) - e*sa*rate(1)**2
         rest(y) = 2*rate(3)*cb*rate(2) - q(3)*sb*rate(2)**2
         rest(3) = -e2*ca + 2*e1*sa*rate(1) + e*ca*rate(1)**2
      end associate
   end subroutine frame

   !> What the length is more than at time 0, and its derivatives.
   pure function longer(motion, t) result(more)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t
      real(qp) :: more(0:2), at_start(0:2)

      more = 0
      if (allocated(motion%hoist_moments)) then
         more = spline(t)
         at_start = spline(0.0_qp)
         more(0) = more(0) - at_start(0)
      end if
      more(:1) = more(:1) + motion%scene%hoist_rate*[t, 1.0_qp]

   contains

      pure function spline(t) result(values)
         real(qp), intent(in) :: t
         real(qp) :: values(0:2), h, x
         integer :: k

         associate (times => motion%scene%hoist_times, f => motion%scene%hoist_lengths, m => motion%hoist_moments)
            k = max(1, min(count(times <= t), size(times) - 1))
            h = times(k + 1) - times(k)
            x = t - times(k)
            values(2) = m(k) + x*(m(k + 1) - m(k))/h
            values(1) = (f(k + 1) - f(k))/h - h*(2*m(k) + m(k + 1))/6 + x*(m(k) + x*(m(k + 1) - m(k))/(2*h))
            values(0) = f(k) + x*((f(k + 1) - f(k))/h - h*(2*m(k) + m(k + 1))/6 &
               + x*(m(k)/2 + x*(m(k + 1) - m(k))/(6*h)))
         end associate
      end function spline
   end function longer

   pure subroutine split(motion, t, y, q, rate)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t, y(:)
      real(qp), intent(out) :: q(3), rate(3)
      real(qp) :: more(0:2)

      more = longer(motion, t)
      q = [y(1), y(2), motion%radius + more(0)]
      rate = [y(motion%free + 1), y(motion%free + 2), more(1)]
      if (motion%free == 3) then
         q(3) = y(3)
         rate(3) = y(6)
      end if
   end subroutine split

   subroutine cartesian(motion, t, y, p, v)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t, y(:)
      real(qp), intent(out) :: p(3), v(3)
      real(qp) :: q(3), rate(3), tangents(3, 3), rest(3)

      p = y(1:3)
      v = y(4:6)
      if (.not. motion%is_taut) return
      call split(motion, t, y, q, rate)
      call frame(motion, q, rate, tangents, rest)
      v = matmul(tangents, rate)
      ! The last tangent is the unit vector along the rod.
      p = q(3)*tangents(:, 3)
      p(motion%long) = p(motion%long) + motion%apart*sin(q(1))
      p(3) = p(3) + motion%upper - motion%apart*cos(q(1))
   end subroutine cartesian

   subroutine find_rates(motion, t, y, rates, tension)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t, y(:)
      real(qp), intent(out) :: rates(:), tension
      real(qp), dimension(3) :: q, rate, rest, v, force, net, second, pivot_speed, pivot_bend
      real(qp) :: tangents(3, 3), matrix(3, 3), right(3), power, more(0:2)
      integer :: i, j, n

      rates = 0
      tension = 0
      if (.not. motion%is_taut) then
         call outer_force(motion, t, y(4:6), force, power, pivot_speed, pivot_bend)
         rates(1:3) = y(4:6)
         rates(4:6) = force/motion%inertia - pivot_bend
         rates(7) = power
         return
      end if
      n = motion%free
      call split(motion, t, y, q, rate)
      call frame(motion, q, rate, tangents, rest)
      v = matmul(tangents, rate)
      call outer_force(motion, t, v, force, power, pivot_speed, pivot_bend)
      more = longer(motion, t)
      net = force/motion%inertia - pivot_bend - rest
      if (n == 2) net = net - more(2)*tangents(:, 3)
      right = matmul(net, tangents)
      do i = 1, 3
         do j = 1, 3
            matrix(i, j) = dot_product(tangents(:, i), tangents(:, j))
         end do
      end do
      if (n == 3) then
         tension = motion%scene%stiffness*(q(3) - motion%radius - more(0))
         right(3) = right(3) - tension/motion%inertia
         second = solved(matrix, right)
      else
         ! The length is what it is: its equation gives the tension.
         matrix(:2, 3) = 0
         matrix(3, :2) = 0
         second = solved(matrix, right)
         tension = motion%inertia*dot_product(tangents(:, 3), net - matmul(tangents(:, :2), second(:2)))
      end if
      rates(:n) = rate(:n)
      rates(n + 1:2*n) = second(:n)
      rates(7) = power
      rates(8) = -tension*(dot_product(tangents(:, 3), pivot_speed) + more(1))
   end subroutine find_rates

   !> Force per mass without that of the rod, power of the drag, and the motion of the pivot.
   subroutine outer_force(motion, t, v, force, power, pivot_speed, pivot_bend)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t, v(3)
      real(qp), intent(out) :: force(3), power, pivot_speed(3), pivot_bend(3)
      real(qp) :: u(3), w(3), angle, h, x
      integer :: i, k

      associate (scene => motion%scene)
         do i = 1, 3
            angle = 2*pi*scene%frequency(i)
            pivot_speed(i) = -scene%amplitude(i)*angle*sin(angle*t + scene%phase(i))
            pivot_bend(i) = -scene%amplitude(i)*angle**2*cos(angle*t + scene%phase(i))
         end do
         if (allocated(scene%times)) then
            k = max(1, min(count(scene%times <= t), size(scene%times) - 1))
            h = scene%times(k + 1) - scene%times(k)
            x = t - scene%times(k)
            associate (f => scene%displacements, m => motion%moments)
               do i = 1, 3
                  ! Taylor's series at the left knot.
                  pivot_speed(i) = pivot_speed(i) + (f(i, k + 1) - f(i, k))/h - h*(2*m(k, i) + m(k + 1, i))/6 &
                     + x*(m(k, i) + x*(m(k + 1, i) - m(k, i))/(2*h))
                  pivot_bend(i) = pivot_bend(i) + m(k, i) + x*(m(k + 1, i) - m(k, i))/h
               end do
            end associate
         end if
         u = v + pivot_speed
         w = u - scene%wind
         force = -(scene%linear_drag + scene%quadratic_drag*norm2(w))*w
         if (scene%diameter > 0) then
            x = scene%density*norm2(w)*scene%diameter/scene%viscosity
            h = 24/x*(1 + 0.15_qp*exp(0.681_qp*log(x))) + 0.407_qp/(1 + 8710/x)
            force = -h*scene%density*pi*scene%diameter**2/8/scene%mass*norm2(w)*w
         end if
         power = dot_product(force, u)
         ! Coriolis: -2 turn_rate x u
         do i = 1, 3
            force(i) = force(i) - 2*(scene%turn_rate(1 + mod(i, 3))*u(1 + mod(i + 1, 3)) &
               - scene%turn_rate(1 + mod(i + 1, 3))*u(1 + mod(i, 3)))
         end do
         force(3) = force(3) - scene%gravity*(1 - scene%density_ratio)
      end associate
   end subroutine outer_force

   !> Gragg's midpoint rule with 2, 4, ... substeps, extrapolated in the square of the substep.
   function stepped(motion, h) result(y)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: h
      real(qp) :: y(most), a(most), b(most), c(most), rates(most), first(most), s, tension
      real(qp) :: table(most, columns), new(most, columns)
      integer :: i, j, k, n

      call find_rates(motion, motion%t, motion%y, first, tension)
      do k = 1, columns
         n = 2*k
         s = h/n
         a = motion%y
         b = a + s*first
         do i = 1, n - 1
            call find_rates(motion, motion%t + i*s, b, rates, tension)
            c = a + 2*s*rates
            a = b
            b = c
         end do
         call find_rates(motion, motion%t + h, b, rates, tension)
         new(:, 1) = (a + b + s*rates)/2
         do j = 1, k - 1
            new(:, j + 1) = new(:, j) + (new(:, j) - table(:, j))/((real(k, qp)/(k - j))**2 - 1)
         end do
         table = new
      end do
      y = table(:, columns)
   end function stepped

   real(qp) function margin(motion, t, y)
      type(motion_type), intent(in) :: motion
      real(qp), intent(in) :: t, y(:)
      real(qp) :: rates(most), q(3)

      if (motion%is_taut) then
         call find_rates(motion, t, y, rates, margin)
      else
         q = angles(motion, y(1:3))
         margin = motion%radius - q(3)
      end if
   end function margin

   !> The first time without margin, looked for at 8 parts of the step, by bisection.
   subroutine look_for_contact(motion, fresh, h, next, hit)
      type(motion_type), intent(in) :: motion
      logical, intent(in) :: fresh          !! The motion has just begun, its margin may be zero
      real(qp), intent(inout) :: h, next(:)
      logical, intent(out) :: hit
      real(qp) :: low, high, middle
      integer :: k

      hit = .false.
      low = 0
      if (fresh) low = h/4096
      high = h
      do k = 1, 8
         high = h*k/8
         hit = margin(motion, motion%t + high, stepped(motion, high)) < 0
         if (hit) exit
         low = high
      end do
      if (.not. hit) return
      do while (high - low > max(1e-24_qp, spacing(high)))
         middle = (low + high)/2
         if (margin(motion, motion%t + middle, stepped(motion, middle)) < 0) then
            high = middle
         else
            low = middle
         end if
      end do
      h = high
      next = stepped(motion, h)
   end subroutine look_for_contact

   subroutine make_contact(motion, contacts)
      type(motion_type), intent(inout) :: motion
      type(contact_type), allocatable, intent(inout) :: contacts(:)
      type(contact_type) :: contact
      real(qp) :: p(3), v(3), along(3), radial, force(3), power, pivot_speed(3), pivot_bend(3), q(3), tangents(3, 3), rest(3)

      call cartesian(motion, motion%t, motion%y, p, v)
      contact%time = motion%t
      contact%position = p
      contact%is_slack = motion%is_taut
      if (motion%is_taut) then
         motion%is_taut = .false.
      else if (motion%scene%stiffness > 0) then
         motion%is_taut = .true.
      else
         q = angles(motion, p)
         call frame(motion, q, [0.0_qp, 0.0_qp, 0.0_qp], tangents, rest)
         along = tangents(:, 3)
         radial = dot_product(along, v)
         associate (e => motion%scene%restitution)
            v = v - (1 + e)*radial*along
            contact%energy_lost = motion%inertia*(1 - e**2)*radial**2/2
            call outer_force(motion, motion%t, v, force, power, pivot_speed, pivot_bend)
            motion%y(8) = motion%y(8) - motion%inertia*(1 + e)*radial*dot_product(along, pivot_speed)
            motion%is_taut = .not. e > 0
         end associate
      end if
      call set_state(motion, p, v)
      if (motion%is_taut .and. motion%scene%stiffness <= 0) then
         if (margin(motion, motion%t, motion%y) < 0) then
            motion%is_taut = .false.
            call set_state(motion, p, v)
         end if
      end if
      contacts = [contacts, contact]
   end subroutine make_contact

   !> Second derivatives of the natural cubic spline at its knots, by elimination.
   pure function natural_moments(t, f) result(m)
      real(qp), intent(in) :: t(:), f(:)
      real(qp) :: m(size(t)), upper(size(t)), right(size(t)), a, b, pivot
      integer :: i, n

      n = size(t)
      upper = 0
      right = 0
      do i = 2, n - 1
         a = t(i) - t(i - 1)
         b = t(i + 1) - t(i)
         pivot = 2*(a + b) - a*upper(i - 1)
         upper(i) = b/pivot
         right(i) = (6*((f(i + 1) - f(i))/b - (f(i) - f(i - 1))/a) - a*right(i - 1))/pivot
      end do
      m = 0
      do i = n - 1, 2, -1
         m(i) = right(i) - upper(i)*m(i + 1)
      end do
   end function natural_moments

   !> Cramer's rule.
   pure function solved(m, b) result(x)
      real(qp), intent(in) :: m(3, 3), b(3)
      real(qp) :: x(3), replaced(3, 3)
      integer :: i

      do i = 1, 3
         replaced = m
         replaced(:, i) = b
         x(i) = determinant(replaced)/determinant(m)
      end do
   end function solved

   pure real(qp) function determinant(m)
      real(qp), intent(in) :: m(3, 3)

      determinant = m(1, 1)*(m(2, 2)*m(3, 3) - m(2, 3)*m(3, 2)) - m(1, 2)*(m(2, 1)*m(3, 3) - m(2, 3)*m(3, 1)) &
         + m(1, 3)*(m(2, 1)*m(3, 2) - m(2, 2)*m(3, 1))
   end function determinant

end module lagrange_motion
