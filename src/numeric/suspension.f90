!> The surface on which a taut pendulum moves: a sphere, or the torus of two hinges, one for each direction of swing.
!>
!> Swinging along x the pendulum is longer by extra_length(1), along y by extra_length(2), and hangs a length below the
!> origin either way. The hinge of the longer direction, say x, is extra_length(1) above the origin with its axis along
!> y; the rod below it carries the other hinge, extra_length(2) above the origin at rest. With d = extra_length(1) -
!> extra_length(2) >= 0 and rho = sqrt(x**2 + (z - extra_length(1))**2) the bob is sqrt((rho - d)**2 + y**2) = l +
!> extra_length(2) away from the lower hinge; a sphere about the origin when both are zero. The surface is smooth but
!> where the bob meets the axis of the upper hinge, rho = 0.
module kyvadlo_suspension
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: suspension_type, new_suspension, stretch, put_on_surface, surface_excess
   public :: suspension_change_type, new_suspension_change, stretch_change, surface_change, radius_change

   type :: suspension_type
      logical :: is_sphere = .true.
      real(wp) :: radius = 0          !! Distance of the bob from the lower hinge at rest length [m]
      real(wp) :: first_radius = 0    !! At time 0; where a winch changes it: `radius` is that at `time`, with its rates
      real(wp) :: time = 0, radius_rate = 0, radius_bend = 0  !! [s], [m/s], [m/s2]
      integer :: long = 1, short = 2  !! Axes of the longer and of the shorter pendulum
      real(wp) :: upper = 0           !! Height of the upper hinge [m]
      real(wp) :: apart = 0           !! Distance of the hinges [m]
   end type suspension_type

   !> How a surface changes with a parameter. Of hinges at one height the one that rises is the upper one.
   type :: suspension_change_type
      logical :: is_sphere = .true.   !! A sphere remains one
      real(wp) :: radius = 0, upper = 0, apart = 0
      real(wp) :: growth = 0          !! Of the rate of the radius
      integer :: long = 1, short = 2
   end type suspension_change_type

contains

   pure subroutine new_suspension(suspension, length, extra_length)
      type(suspension_type), intent(out) :: suspension
      real(wp), intent(in) :: length           !! [m]
      real(wp), intent(in) :: extra_length(2)  !! Not negative [m]

      suspension%is_sphere = .not. any(extra_length > 0)
      if (extra_length(2) > extra_length(1)) then
         suspension%long = 2
         suspension%short = 1
      end if
      suspension%radius = length + extra_length(suspension%short)
      suspension%first_radius = suspension%radius
      suspension%upper = extra_length(suspension%long)
      suspension%apart = extra_length(suspension%long) - extra_length(suspension%short)
   end subroutine new_suspension

   !> Distance s of the bob from the lower hinge, its gradient, and what of its second time derivative is there without
   !> acceleration: s'' = outward.a + bending.
   pure subroutine stretch(suspension, position, velocity, distance, outward, bending)
      type(suspension_type), intent(in) :: suspension
      real(wp), intent(in) :: position(3), velocity(3)
      real(wp), intent(out) :: distance    !! [m]
      real(wp), intent(out) :: outward(3)  !! Unit vector away from the lower hinge
      real(wp), intent(out) :: bending     !! [m/s2]
      real(wp) :: arm(2), speed(2), rho, q, q_rate, rate

      if (suspension%is_sphere) then
         distance = sqrt(dot_product(position, position))
         outward = 0
         bending = 0
         ! At the pivot no direction is outward.
         if (.not. distance > 0) return
         outward = position/distance
         rate = dot_product(outward, velocity)
         bending = (dot_product(velocity, velocity) - rate**2)/distance
         return
      end if
      associate (long => suspension%long, short => suspension%short)
         arm = [position(long), position(3) - suspension%upper]
         speed = [velocity(long), velocity(3)]
         rho = sqrt(dot_product(arm, arm))
         arm = arm/rho
         q = rho - suspension%apart
         q_rate = dot_product(arm, speed)
         distance = sqrt(q**2 + position(short)**2)
         outward(long) = q*arm(1)/distance
         outward(3) = q*arm(2)/distance
         outward(short) = position(short)/distance
         rate = dot_product(outward, velocity)
         bending = (q_rate**2 + velocity(short)**2 - rate**2 + q*(dot_product(speed, speed) - q_rate**2)/rho)/distance
      end associate
   end subroutine stretch

   !> The nearest point of the surface, and of the velocities along it there: tangential, and with the surface where it
   !> grows.
   pure subroutine put_on_surface(suspension, position, velocity)
      type(suspension_type), intent(in) :: suspension
      real(wp), intent(inout) :: position(3), velocity(3)
      real(wp) :: distance, outward(3), bending, rho, q, scale

      if (suspension%is_sphere) then
         scale = 1/sqrt(position(1)**2 + position(2)**2 + position(3)**2)
         outward(1) = position(1)*scale
         outward(2) = position(2)*scale
         outward(3) = position(3)*scale
         rho = outward(1)*velocity(1) + outward(2)*velocity(2) + outward(3)*velocity(3) - suspension%radius_rate
         velocity(1) = velocity(1) - rho*outward(1)
         velocity(2) = velocity(2) - rho*outward(2)
         velocity(3) = velocity(3) - rho*outward(3)
         position = suspension%radius*outward
         return
      end if
      call stretch(suspension, position, velocity, distance, outward, bending)
      velocity = velocity - (dot_product(outward, velocity) - suspension%radius_rate)*outward
      associate (long => suspension%long, short => suspension%short)
         rho = sqrt(position(long)**2 + (position(3) - suspension%upper)**2)
         scale = suspension%radius/distance
         q = (rho - suspension%apart)*scale
         position(short) = position(short)*scale
         scale = (q + suspension%apart)/rho
         position(long) = position(long)*scale
         position(3) = suspension%upper + (position(3) - suspension%upper)*scale
      end associate
   end subroutine put_on_surface

   !> (s**2 - radius**2)/2 at `start` + `way`, where `start` lies on the surface: positive beyond it. Without
   !> cancellation for a short way, as what `start` itself contributes is zero and left out.
   pure real(wp) function surface_excess(suspension, start, way) result(excess)
      type(suspension_type), intent(in) :: suspension
      real(wp), intent(in) :: start(3), way(3)
      real(wp) :: arm(2), moved(2), rho, q, change

      if (suspension%is_sphere) then
         excess = dot_product(start + way/2, way)
         return
      end if
      associate (long => suspension%long, short => suspension%short)
         arm = [start(long), start(3) - suspension%upper]
         moved = [way(long), way(3)]
         rho = norm2(arm)
         q = rho - suspension%apart
         change = dot_product(2*arm + moved, moved)/(rho + norm2(arm + moved))
         excess = (q + change/2)*change + (start(short) + way(short)/2)*way(short)
      end associate
   end function surface_excess

   !> The change of a surface with its length and extra lengths.
   pure subroutine new_suspension_change(change, suspension, length, extra_length, growth)
      type(suspension_change_type), intent(out) :: change
      type(suspension_type), intent(in) :: suspension
      real(wp), intent(in) :: length           !! Change of the length
      real(wp), intent(in) :: extra_length(2)  !! Changes of the extra lengths
      real(wp), intent(in), optional :: growth !! Change of the rate of the length

      if (present(growth)) change%growth = growth
      change%is_sphere = suspension%is_sphere .and. .not. any(abs(extra_length) > 0)
      change%long = suspension%long
      change%short = suspension%short
      if (.not. suspension%apart > 0 .and. extra_length(change%short) > extra_length(change%long)) then
         change%long = suspension%short
         change%short = suspension%long
      end if
      change%radius = length + extra_length(change%short)
      change%upper = extra_length(change%long)
      change%apart = extra_length(change%long) - extra_length(change%short)
   end subroutine new_suspension_change

   !> What the radius at the time of a suspension changes [m].
   pure real(wp) function radius_change(suspension, change)
      type(suspension_type), intent(in) :: suspension
      type(suspension_change_type), intent(in) :: change

      radius_change = change%radius + change%growth*suspension%time
   end function radius_change

   !> The changes of what `stretch` gives, with those of position, velocity and surface.
   pure subroutine stretch_change(suspension, change, position, velocity, moved, turned, distance, outward, bending)
      type(suspension_type), intent(in) :: suspension
      type(suspension_change_type), intent(in) :: change
      real(wp), intent(in) :: position(3), velocity(3)
      real(wp), intent(in) :: moved(3), turned(3)          !! Changes of position and velocity
      real(wp), intent(out) :: distance, outward(3), bending
      real(wp) :: s, o(3), b, arm(2), speed(2), e_change(2), speed_change(2), rho, q, q_rate, square
      real(wp) :: rho_change, q_change, q_rate_change, rate, rate_change, top

      call stretch(suspension, position, velocity, s, o, b)
      rate = dot_product(o, velocity)
      if (change%is_sphere) then
         distance = dot_product(o, moved)
         outward = (moved - distance*o)/s
         rate_change = dot_product(outward, velocity) + dot_product(o, turned)
         bending = (2*dot_product(velocity, turned) - 2*rate*rate_change - b*distance)/s
         return
      end if
      associate (long => change%long, short => change%short)
         arm = [position(long), position(3) - suspension%upper]
         speed = [velocity(long), velocity(3)]
         speed_change = [turned(long), turned(3)]
         rho = norm2(arm)
         arm = arm/rho
         q = rho - suspension%apart
         q_rate = dot_product(arm, speed)
         e_change = [moved(long), moved(3) - change%upper]
         rho_change = dot_product(arm, e_change)
         e_change = (e_change - rho_change*arm)/rho
         q_change = rho_change - change%apart
         q_rate_change = dot_product(e_change, speed) + dot_product(arm, speed_change)
         distance = (q*q_change + position(short)*moved(short))/s
         outward(long) = (q_change*arm(1) + q*e_change(1) - o(long)*distance)/s
         outward(3) = (q_change*arm(2) + q*e_change(2) - o(3)*distance)/s
         outward(short) = (moved(short) - o(short)*distance)/s
         rate_change = dot_product(outward, velocity) + dot_product(o, turned)
         square = dot_product(speed, speed) - q_rate**2
         top = 2*(q_rate*q_rate_change + velocity(short)*turned(short) - rate*rate_change) + (q_change*square &
            + q*(2*(dot_product(speed, speed_change) - q_rate*q_rate_change) - square*rho_change/rho))/rho
         bending = (top - b*distance)/s
      end associate
   end subroutine stretch_change

   !> The changes of a state that `put_on_surface` puts on the surface, from those of the state before it.
   pure subroutine surface_change(suspension, change, position, velocity, moved, turned)
      type(suspension_type), intent(in) :: suspension
      type(suspension_change_type), intent(in) :: change
      real(wp), intent(in) :: position(3), velocity(3)     !! Before it
      real(wp), intent(inout) :: moved(3), turned(3)
      real(wp) :: distance, outward(3), bending, distance_change, outward_change(3), bending_change
      real(wp) :: arm(2), e_change(2), rho, rho_change, q, q_change, radial, wider

      call stretch(suspension, position, velocity, distance, outward, bending)
      call stretch_change(suspension, change, position, velocity, moved, turned, distance_change, outward_change, &
         bending_change)
      wider = radius_change(suspension, change)
      radial = dot_product(outward, velocity) - suspension%radius_rate
      turned = turned - (dot_product(outward_change, velocity) + dot_product(outward, turned) - change%growth)*outward &
         - radial*outward_change
      associate (r => suspension%radius)
         if (change%is_sphere) then
            moved = wider*outward + r*outward_change
            return
         end if
         associate (long => change%long, short => change%short)
            arm = [position(long), position(3) - suspension%upper]
            rho = norm2(arm)
            arm = arm/rho
            e_change = [moved(long), moved(3) - change%upper]
            rho_change = dot_product(arm, e_change)
            e_change = (e_change - rho_change*arm)/rho
            q = r*(rho - suspension%apart)/distance
            q_change = (wider*(rho - suspension%apart) + r*(rho_change - change%apart) &
               - q*distance_change)/distance
            arm = (q_change + change%apart)*arm + (q + suspension%apart)*e_change
            moved(long) = arm(1)
            moved(3) = change%upper + arm(2)
            moved(short) = wider*outward(short) + r*outward_change(short)
         end associate
      end associate
   end subroutine surface_change

end module kyvadlo_suspension
