!> The unknowns of a fit: how numbers without bounds stand for the free settings, and what follows from them.
module kyvadlo_fit_unknowns
   use kyvadlo_effects, only: effects_type
   use kyvadlo_fit_physics, only: camera_type, direction_type, effects_with, gravity_felt, physics_type
   use kyvadlo_force_changes, only: change_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_scene_groups
   use kyvadlo_start_real64, only: new_orbit
   use kyvadlo_status, only: error_type
   use kyvadlo_suspension, only: new_suspension, new_suspension_change, put_on_surface, surface_change, &
      suspension_change_type, suspension_type
   implicit none
   private
   public :: unknown_type, unknowns_type, physics_at, camera_at, numbers_at, place_at, &
      natural_scales, outward_slopes, setting_rows
   public :: unknown_scalar, unknown_position, unknown_velocity
   public :: form_plain, form_logarithm, form_above, form_below, form_between

   integer, parameter :: unknown_scalar = 1, unknown_position = 2, unknown_velocity = 3
   integer, parameter :: form_plain = 1, form_logarithm = 2, form_above = 3, form_below = 4, form_between = 5

   !> One unknown: an element of a setting, or a coordinate of the start.
   type :: unknown_type
      integer :: kind = unknown_scalar
      integer :: free = 0, setting = 0, element = 1
      integer :: form = form_plain                        !! How it stands for the value
      real(wp) :: least = 0, most = 0, scale = 1
   end type unknown_type

   !> All of them, around numbers.
   type :: unknowns_type
      type(unknown_type), allocatable :: of(:)
      real(wp) :: number(3, size(settings)) = 0      !! Of the scene; those of free settings are where x = 0 was placed
      real(wp) :: direction(3) = [0.0_wp, 0.0_wp, -1.0_wp]  !! Of the start, of length 1
      real(wp) :: across(3, 2) = 0                   !! Two directions at right angles to it
      logical :: has_state = .false., is_position_free = .false., is_velocity_free = .false.
      logical :: is_plane = .false.                  !! Nothing but the x-z plane is seen
      logical :: given(size(group_names)) = .false.
      type(effects_type) :: effects                  !! Of the scene
      logical :: is_exact = .true.
      real(wp) :: tolerance = 1e-10_wp
      integer :: start = 0, start_values = 0
   end type unknowns_type

   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   !> Rows of the natural size of each unknown's setting: how far from its value it would be another pendulum. An
   !> uncertainty beyond it says that nothing is known.
   subroutine natural_scales(unknowns, physics, scales)
      type(unknowns_type), intent(in) :: unknowns
      type(physics_type), intent(in) :: physics
      real(wp), intent(out) :: scales(:)
      real(wp) :: rate
      integer :: j

      rate = sqrt(physics%gravity/physics%length)
      do j = 1, size(unknowns%of)
         associate (one => unknowns%of(j), setting => settings(unknowns%of(j)%setting))
            scales(j) = max(abs(unknowns%number(one%element, one%setting)), 1.0_wp)
            if (setting%rule == rule_positive) scales(j) = unknowns%number(1, one%setting)
            select case (setting%unit)
            case ('deg')
               scales(j) = 1/degree
            case ('m')
               if (setting%rule /= rule_positive) scales(j) = physics%length
            case ('m/s')
               scales(j) = physics%length*rate
            case ('1/s')
               scales(j) = rate
            case ('rad/s')
               scales(j) = rate
               if (setting%group == earth_rotation_group) scales(j) = 7.3e-5_wp
            case ('1/m')
               if (setting%group == air_group) scales(j) = 1/physics%length
            case ('s')
               scales(j) = 1/rate
            case ('Hz')
               scales(j) = rate
            end select
            if (one%kind == unknown_position) scales(j) = 1
            if (one%kind == unknown_velocity) scales(j) = max(physics%length*rate, norm2(physics%velocity))
         end associate
      end do
   end subroutine natural_scales

   !> Places the numbers at x = what they are now, around which the start has its coordinates.
   subroutine place_at(unknowns, x, away)
      type(unknowns_type), intent(inout) :: unknowns
      real(wp), intent(out) :: x(:)
      !> A search begins a little away from bounds, where nothing has a slope: by this part of the most
      real(wp), intent(in), optional :: away
      real(wp) :: p(3), v(3), e(3), scales(size(x)), value, off
      type(physics_type) :: physics
      integer :: j, place

      if (unknowns%has_state) then
         place = setting_place(pendulum_group, 'position')
         p = unknowns%number(:, place)
         if (.not. norm2(p) > 0) p = [0.0_wp, 0.0_wp, -1.0_wp]
         unknowns%direction = p/norm2(p)
         if (unknowns%is_plane) then
            unknowns%direction(2) = 0
            unknowns%direction = unknowns%direction/max(norm2(unknowns%direction), tiny(value))
            unknowns%across(:, 1) = [-unknowns%direction(3), 0.0_wp, unknowns%direction(1)]
            unknowns%across(:, 2) = [0.0_wp, 1.0_wp, 0.0_wp]
         else
            e = 0
            e(minloc(abs(unknowns%direction), 1)) = 1
            e = e - dot_product(e, unknowns%direction)*unknowns%direction
            unknowns%across(:, 1) = e/norm2(e)
            associate (n => unknowns%direction, a => unknowns%across(:, 1))
               unknowns%across(:, 2) = [n(2)*a(3) - n(3)*a(2), n(3)*a(1) - n(1)*a(3), n(1)*a(2) - n(2)*a(1)]
            end associate
         end if
         v = unknowns%number(:, setting_place(pendulum_group, 'velocity'))
      end if
      physics%length = unknowns%number(1, setting_place(pendulum_group, 'length'))
      physics%gravity = unknowns%number(1, setting_place(pendulum_group, 'gravity'))
      physics%velocity = 0
      off = 0
      if (present(away)) off = away
      call natural_scales(unknowns, physics, scales)
      do j = 1, size(unknowns%of)
         associate (one => unknowns%of(j))
            unknowns%of(j)%scale = scales(j)
            value = unknowns%number(one%element, one%setting)
            if (one%kind == unknown_position) then
               x(j) = 0
            else if (one%kind == unknown_velocity) then
               x(j) = dot_product(v, unknowns%across(:, one%element))/scales(j)
            else
               select case (one%form)
               case (form_plain)
                  x(j) = value/scales(j)
               case (form_logarithm)
                  x(j) = log(max(value, tiny(value)))
               case (form_above)
                  x(j) = sqrt(max(value - one%least, off*1e-4_wp*scales(j))/scales(j))
               case (form_below)
                  x(j) = sqrt(max(one%most - value, off*1e-4_wp*scales(j))/scales(j))
               case (form_between)
                  value = (value - one%least)/(one%most - one%least)
                  x(j) = asin(2*min(max(value, 0.02_wp*off), 1 - 0.02_wp*off) - 1)
               end select
            end if
         end associate
      end do
   end subroutine place_at

   !> The number of an unknown, and its rate.
   pure subroutine value_of(one, x, value, rate)
      type(unknown_type), intent(in) :: one
      real(wp), intent(in) :: x
      real(wp), intent(out) :: value, rate

      select case (one%form)
      case (form_logarithm)
         value = exp(max(-700.0_wp, min(x, 700.0_wp)))
         rate = value
      case (form_above)
         value = one%least + one%scale*x**2
         rate = 2*one%scale*x
      case (form_below)
         value = one%most - one%scale*x**2
         rate = -2*one%scale*x
      case (form_between)
         value = one%least + (one%most - one%least)*(1 + sin(x))/2
         rate = (one%most - one%least)*cos(x)/2
      case default
         value = one%scale*x
         rate = one%scale
      end select
   end subroutine value_of

   !> The numbers of all settings at x, and the rates of the scalars among the free ones.
   pure subroutine numbers_at(unknowns, x, number, rates)
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: number(:, :), rates(:)
      integer :: j

      number = unknowns%number
      rates = 1
      do j = 1, size(unknowns%of)
         if (unknowns%of(j)%kind /= unknown_scalar) cycle
         associate (one => unknowns%of(j))
            call value_of(one, x(j), number(one%element, one%setting), rates(j))
         end associate
      end do
   end subroutine numbers_at

   !> Of unknowns whose numbers stand at a bound, but for 1e-7 of their natural size: the sign of the slope of what
   !> grows towards the inside.
   pure function outward_slopes(unknowns, x) result(slopes)
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: x(:)
      real(wp) :: slopes(size(x))
      real(wp), parameter :: close = 3e-4_wp           !! Its square is part of a natural size
      real(wp) :: value, rate
      integer :: j

      slopes = 0
      do j = 1, size(x)
         associate (one => unknowns%of(j))
            if (one%kind /= unknown_scalar) cycle
            call value_of(one, x(j), value, rate)
            select case (one%form)
            case (form_above)
               if (abs(x(j)) < close) slopes(j) = sign(1.0_wp, rate)
            case (form_below)
               if (abs(x(j)) < close) slopes(j) = sign(1.0_wp, -rate)
            case (form_between)
               if (abs(cos(x(j))) < close) slopes(j) = sign(1.0_wp, -rate*sin(x(j)))
            end select
         end associate
      end do
   end function outward_slopes

   pure subroutine camera_at(unknowns, number, camera)
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: number(:, :)
      type(camera_type), intent(out) :: camera

      if (.not. unknowns%given(camera_group)) return
      camera%scale = number(1, setting_place(camera_group, 'scale'))
      camera%angle = number(1, setting_place(camera_group, 'angle'))*degree
      camera%offset = number(:2, setting_place(camera_group, 'offset'))
      camera%time_offset = number(1, setting_place(camera_group, 'time_offset'))
   end subroutine camera_at

   !> What determines the motion at x, and how it changes with each unknown. With `by_value` the derivatives are those
   !> by the settings themselves, by position and velocity in the coordinates of the start.
   subroutine physics_at(unknowns, x, number, physics, failed, directions)
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: number(:, :)
      type(physics_type), intent(out) :: physics
      logical, intent(out) :: failed
      type(direction_type), intent(out), optional :: directions(:)
      real(wp) :: rates(size(x)), n(3), dn(3, 2), w(3), dw(3), v(3), size_of, other(3, size(settings)), step
      type(physics_type) :: up, down
      type(suspension_type) :: suspension
      type(suspension_change_type) :: suspension_change
      real(wp) :: p0(3), v0(3)
      logical :: failed_up, failed_down, changes_start, changes_effects
      integer :: j, k

      call numbers_at(unknowns, x, number, rates)
      call physics_of(unknowns, number, physics, failed)
      if (failed) return
      if (unknowns%has_state) then
         n = unknowns%direction
         w = 0
         do j = 1, size(x)
            associate (one => unknowns%of(j))
               if (one%kind == unknown_position) n = n + x(j)*unknowns%across(:, one%element)
               if (one%kind == unknown_velocity) w = w + x(j)*one%scale*unknowns%across(:, one%element)
            end associate
         end do
         if (.not. unknowns%is_velocity_free) w = unknowns%number(:, setting_place(pendulum_group, 'velocity'))
         size_of = norm2(n)
         n = n/size_of
         do k = 1, 2
            dn(:, k) = (unknowns%across(:, k) - dot_product(n, unknowns%across(:, k))*n)/size_of
         end do
         v = w - dot_product(n, w)*n
         physics%position = physics%length*n
         physics%velocity = v
         number(:, setting_place(pendulum_group, 'position')) = physics%position
         number(:, setting_place(pendulum_group, 'velocity')) = v
      end if
      call new_suspension(suspension, physics%length, physics%effects%extra_length)
      p0 = physics%position
      v0 = physics%velocity
      if (.not. suspension%is_sphere) then
         call put_on_surface(suspension, physics%position, physics%velocity)
         if (unknowns%has_state) then
            number(:, setting_place(pendulum_group, 'position')) = physics%position
            number(:, setting_place(pendulum_group, 'velocity')) = physics%velocity
         end if
      end if
      if (.not. present(directions)) return
      do j = 1, size(x)
         associate (one => unknowns%of(j), setting => settings(unknowns%of(j)%setting), &
               change => directions(j)%change)
            if (one%kind == unknown_position) then
               change%position = physics%length*dn(:, one%element)
               change%velocity = -dot_product(dn(:, one%element), w)*n - dot_product(n, w)*dn(:, one%element)
            else if (one%kind == unknown_velocity) then
               dw = one%scale*unknowns%across(:, one%element)
               change%velocity = dw - dot_product(n, dw)*n
            else
               if (setting%group == pendulum_group .and. setting%name == 'length') change%length = rates(j)
               if (setting%group == pendulum_group .and. setting%name == 'gravity') change%gravity = rates(j)
               if (unknowns%has_state .and. change%length /= 0) change%position = rates(j)*n
               changes_effects = setting%group /= pendulum_group .and. setting%group /= camera_group
               changes_start = .not. unknowns%has_state .and. (setting%group == pendulum_group .or. &
                  setting%group == buoyancy_group)
               if (changes_effects .or. changes_start) then
                  ! The start and the coefficients are short closed forms: central differences of them keep ten digits.
                  step = 1e-5_wp*max(abs(number(one%element, one%setting)), 1e-2_wp*one%scale)
                  other = number
                  other(one%element, one%setting) = number(one%element, one%setting) + step
                  call physics_of(unknowns, other, up, failed_up)
                  other(one%element, one%setting) = number(one%element, one%setting) - step
                  call physics_of(unknowns, other, down, failed_down)
                  if (failed_up .or. failed_down) then
                     failed = .true.
                     return
                  end if
                  step = rates(j)/(2*step)
                  if (changes_start) then
                     change%position = (up%position - down%position)*step
                     change%velocity = (up%velocity - down%velocity)*step
                  end if
                  change%effects%linear_drag = (up%effects%linear_drag - down%effects%linear_drag)*step
                  change%effects%quadratic_drag = (up%effects%quadratic_drag - down%effects%quadratic_drag)*step
                  change%effects%wind = (up%effects%wind - down%effects%wind)*step
                  change%effects%turn_rate = (up%effects%turn_rate - down%effects%turn_rate)*step
                  change%effects%pivot_amplitude = (up%effects%pivot_amplitude - down%effects%pivot_amplitude)*step
                  change%effects%pivot_frequency = (up%effects%pivot_frequency - down%effects%pivot_frequency)*step
                  change%effects%pivot_phase = (up%effects%pivot_phase - down%effects%pivot_phase)*step
                  change%effects%stiffness = (up%effects%stiffness - down%effects%stiffness)*step
                  change%effects%hoist_rate = (up%effects%hoist_rate - down%effects%hoist_rate)*step
                  change%effects%extra_length = (up%effects%extra_length - down%effects%extra_length)*step
                  change%effects%density_ratio = (up%effects%density_ratio - down%effects%density_ratio)*step
                  change%effects%added_mass = (up%effects%added_mass - down%effects%added_mass)*step
                  directions(j)%frame_rate = (up%frame_rate - down%frame_rate)*step
               end if
            end if
            if (.not. suspension%is_sphere) then
               call new_suspension_change(suspension_change, suspension, change%length, change%effects%extra_length)
               call surface_change(suspension, suspension_change, p0, v0, change%position, change%velocity)
            end if
         end associate
      end do
   end subroutine physics_at

   !> Length, gravity, effects, and a start that is none by position and velocity.
   subroutine physics_of(unknowns, number, physics, failed)
      type(unknowns_type), intent(in) :: unknowns
      real(wp), intent(in) :: number(:, :)
      type(physics_type), intent(out) :: physics
      logical, intent(out) :: failed
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer :: first, second

      physics%length = number(1, setting_place(pendulum_group, 'length'))
      physics%gravity = number(1, setting_place(pendulum_group, 'gravity'))
      physics%is_exact = unknowns%is_exact
      physics%tolerance = unknowns%tolerance
      physics%effects = unknowns%effects
      call effects_with(number, unknowns%given, physics%effects, physics%frame_rate)
      failed = .not. (physics%length > 0 .and. physics%length < 1e30_wp .and. physics%gravity > 0 .and. &
         physics%gravity < 1e30_wp)
      if (failed .or. unknowns%has_state) return
      first = setting_place(pendulum_group, trim(starts(unknowns%start)%first))
      second = setting_place(pendulum_group, trim(starts(unknowns%start)%second))
      call new_orbit(orbit, unknowns%start, physics%length, gravity_felt(physics), number(:1, first), number(:1, &
         second), &
         error)
      failed = allocated(error)
      if (.not. failed) call orbit%locate(0.0_wp, physics%position, physics%velocity)
   end subroutine physics_of

   !> Which unknowns belong to a free setting.
   pure function setting_rows(unknowns, free) result(rows)
      type(unknowns_type), intent(in) :: unknowns
      integer, intent(in) :: free
      integer, allocatable :: rows(:)
      integer :: j

      rows = pack([(j, j=1, size(unknowns%of))], unknowns%of%free == free)
   end function setting_rows

end module kyvadlo_fit_unknowns
