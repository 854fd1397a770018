!> How a motion that is integrated begins: what a suspension allows, and whether its string is taut.
module kyvadlo_integration_start
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_forces, only: forces_type, move
   use kyvadlo_suspension, only: put_on_surface, stretch
   implicit none
   private
   public :: begin_motion

   !> Numbers of three digits are still taken for a start on the surface, as in kyvadlo_gaps; further off they are a
   !> mistake.
   real(wp), parameter :: most_off = 1e-3_wp
   !> What rounding leaves of a distance, and of a radial speed.
   real(wp), parameter :: rounding = 8*epsilon(1.0_wp)

contains

   !> An elastic rod or string starts anywhere, at any velocity; a string without elasticity anywhere inside its
   !> surface, or on it if the bob does not move outwards; a rod on its surface. A start next to the surface is put on
   !> it, a velocity next to its tangent plane into that.
   subroutine begin_motion(forces, position, velocity, is_taut, slack, error, was_put)
      type(forces_type), intent(inout) :: forces
      real(wp), intent(inout) :: position(3), velocity(3)  !! Relative to the pivot [m], [m/s]
      logical, intent(out) :: is_taut                      !! Whether the rod or string acts
      real(wp), intent(out) :: slack                       !! If not: (radius**2 - distance**2)/2 [m2]
      type(error_type), allocatable, intent(out) :: error
      logical, intent(out), optional :: was_put(2)         !! Whether position, velocity were put on the surface
      real(wp) :: distance, outward(3), bending, radial, unused(3)
      logical :: is_string, put(2)

      is_taut = .true.
      slack = 0
      put = .false.
      if (present(was_put)) was_put = .false.
      is_string = forces%effects%is_string
      if (.not. (all(is_finite(position)) .and. all(is_finite(velocity)))) then
         call fail(error, code_domain, 'position and velocity must be finite')
         return
      end if
      call stretch(forces%suspension, position, velocity, distance, outward, bending)
      radial = dot_product(outward, velocity)
      associate (radius => forces%suspension%radius, speed => norm2(velocity))
         if (is_string .and. flies(distance, radius, radial, speed)) then
            is_taut = .false.
            if (distance >= (1 - rounding)*radius .and. .not. forces%is_elastic) then
               unused = 0
               call put_on_surface(forces%suspension, position, unused)
               put(1) = .true.
               distance = radius
            end if
         else if (forces%is_elastic) then
            if (.not. distance > 0) call fail(error, code_domain, &
               'the start must not be at the pivot, where an elastic rod has no direction')
         else if (is_string .and. .not. distance - radius <= most_off*radius) then
            call fail(error, code_domain, 'the position must not lie outside what the string lets the bob reach, '// &
               trim(short(radius))//' m, got the distance '//trim(short(distance))//' m')
         else if (.not. abs(distance - radius) <= most_off*radius) then
            call fail(error, code_domain, &
               'the position must lie on the surface on which the bob moves, to a thousandth of its '// &
               'radius, got the distance '//trim(short(distance))//' m and the radius '//trim(short(radius))//' m')
         else if (.not. abs(radial) <= most_off*speed) then
            call fail(error, code_domain, 'the radial speed must be at most a thousandth of the speed, got ' &
               //trim(short(radial))//' m/s of '//trim(short(speed))//' m/s')
         else
            call put_on_surface(forces%suspension, position, velocity)
            put = .true.
         end if
         if (allocated(error)) return
         if (present(was_put)) was_put = put
         if (is_string) is_taut = is_taut_at(forces, position, velocity, distance, radial)
         if (.not. is_taut .and. distance < radius*(1 - rounding)) slack = (radius - distance)*(radius + distance)/2
      end associate
   end subroutine begin_motion

   !> As `string_starts_in_flight` of kyvadlo_string.
   pure logical function flies(distance, radius, radial, speed)
      real(wp), intent(in) :: distance, radius, radial, speed

      flies = distance - radius <= -most_off*radius .or. distance - radius <= most_off*radius .and. &
         radial < 0 .and. radial <= -most_off*speed .or. &
         distance < (1 - rounding)*radius .and. radial > 0 .and. radial >= most_off*speed
   end function flies

   !> Whether a string acts at a start: by its length, and next to its surface by where the bob is going.
   logical function is_taut_at(forces, position, velocity, distance, radial) result(is_taut)
      type(forces_type), intent(inout) :: forces
      real(wp), intent(in) :: position(3), velocity(3), distance, radial
      real(wp) :: acceleration(3), tension, powers(2), outward(3), bending, length

      associate (radius => forces%suspension%radius, speed => norm2(velocity))
         if (distance - radius <= -most_off*radius .or. .not. forces%is_elastic .and. &
            flies(distance, radius, radial, speed)) then
            is_taut = .false.
         else if (.not. forces%is_elastic) then
            call move(forces, .true., 0.0_wp, position, velocity, acceleration, tension, powers)
            is_taut = tension >= 0
         else if (abs(distance - radius) > rounding*radius) then
            is_taut = distance > radius
         else if (abs(radial) > rounding*speed) then
            is_taut = radial > 0
         else
            ! At its rest length, at rest along it.
            call move(forces, .false., 0.0_wp, position, velocity, acceleration, tension, powers)
            call stretch(forces%suspension, position, velocity, length, outward, bending)
            is_taut = dot_product(outward, acceleration) + bending >= 0
         end if
      end associate
   end function is_taut_at

   !> A number for a message, as long as it needs to be to show a thousandth.
   pure function short(number) result(text)
      real(wp), intent(in) :: number
      character(len=16) :: text

      write (text, '(g0.7)') number
   end function short

end module kyvadlo_integration_start
