!> What may act on a real pendulum besides gravity and a rigid rod: one value, in which zero means off. doc/effects.md
!> says how each effect works and how they combine.
module kyvadlo_effects
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers_real64, only: is_finite
   use kyvadlo_status, only: error_type, fail, code_domain
   use kyvadlo_curves, only: curve_type
   implicit none
   private
   public :: effects_type, put_coefficient, any_effect, check_effects, has_drag, has_hoist, has_moving_pivot, &
      earth_turn_rate, air_coefficients, sphere_coefficients, sphere_drag, largest_reynolds

   !> The effects of a scene; each is off unless given. Forces are per mass of the bob.
   type :: effects_type
      real(wp) :: linear_drag = 0         !! Drag force over mass and speed through the air [1/s]
      real(wp) :: quadratic_drag = 0      !! Drag force over mass and square of that speed [1/m]
      !> That of a sphere by the curve of Brown and Lawler, where its Reynolds number is 1 [m/s]; then linear_drag and
      !> quadratic_drag are by sphere_coefficients. 0: the two above, added
      real(wp) :: sphere_speed = 0
      real(wp) :: wind(3) = 0             !! Steady velocity of the air [m/s]
      real(wp) :: turn_rate(3) = 0        !! Rotation of the frame, as of the Earth; x east, y north, z up [rad/s]
      real(wp) :: pivot_amplitude(3) = 0  !! Of the pivot's displacement amplitude*cos(2 pi frequency t + phase) [m]
      real(wp) :: pivot_frequency(3) = 0  !! [Hz]
      real(wp) :: pivot_phase(3) = 0      !! [rad]
      real(wp), allocatable :: pivot_times(:)             !! (n) knots of a table of displacements, ascending [s]
      real(wp), allocatable :: pivot_displacements(:, :)  !! (3, n) there, added to the harmonic ones [m]
      !> (3, n) second derivatives of the spline: new_pivot_table [m/s2]
      real(wp), allocatable :: pivot_curvatures(:, :)
      type(curve_type) :: pivot_curve = curve_type() !! Added to these: of a move, or of a table of rates [m]
      real(wp) :: hoist_rate = 0          !! At which a winch lets the length grow; negative: it hauls in [m/s]
      type(curve_type) :: hoist = curve_type() !! What the length is more than at time 0, by new_hoist_table [m]
      real(wp) :: stiffness = 0           !! Of an elastic rod or string, over mass; 0: it keeps its length [1/s2]
      real(wp) :: extra_length(2) = 0     !! How much longer the pendulum is when it swings along x, along y [m]
      logical :: is_string = .false.      !! Pulls only
      real(wp) :: restitution = 0         !! Of the radial speed where an inextensible string becomes taut, 0 to 1
      real(wp) :: density_ratio = 0       !! Density of the fluid over that of the bob, below 1
      real(wp) :: added_mass = 0          !! Of the fluid that moves with the bob, over the displaced mass
   end type effects_type

   !> The curve of Brown and Lawler: 24/Re (1 + stokes Re**power) + newton/(1 + turn/Re), and where it ends.
   real(wp), parameter :: stokes = 0.15_wp, power = 0.681_wp, newton = 0.407_wp, turn = 8710
   real(wp), parameter :: largest_reynolds = 2e5_wp
   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   !> Puts a number of a scene, or how fast it changes, in its place, by `group.name`.
   pure subroutine put_coefficient(effects, name, element, value, is_put)
      type(effects_type), intent(inout) :: effects
      character(len=*), intent(in) :: name
      integer, intent(in) :: element           !! Of a vector; 1 for others
      real(wp), intent(in) :: value
      logical, intent(out) :: is_put           !! False: it is none, or goes into several or with others

      is_put = .true.
      select case (name)
      case ('string.restitution')
         effects%restitution = value
      case ('buoyancy.density_ratio')
         effects%density_ratio = value
      case ('buoyancy.added_mass')
         effects%added_mass = value
      case ('air.linear')
         effects%linear_drag = value
      case ('air.quadratic')
         effects%quadratic_drag = value
      case ('wind.velocity')
         effects%wind(element) = value
      case ('moving_pivot.amplitude')
         effects%pivot_amplitude(element) = value
      case ('moving_pivot.frequency')
         effects%pivot_frequency(element) = value
      case ('moving_pivot.phase')
         effects%pivot_phase(element) = value*degree
      case ('hoist.rate')
         effects%hoist_rate = value
      case ('anisotropic_support.extra_length_x')
         effects%extra_length(1) = value
      case ('anisotropic_support.extra_length_y')
         effects%extra_length(2) = value
      case default
         is_put = .false.
      end select
   end subroutine put_coefficient

   !> Whether the closed form does not answer. A string, buoyancy and a constant displacement of the pivot it does.
   pure logical function any_effect(effects)
      type(effects_type), intent(in) :: effects

      any_effect = has_drag(effects) .or. any(abs(effects%turn_rate) > 0) .or. has_moving_pivot(effects) &
         .or. effects%stiffness > 0 .or. any(effects%extra_length > 0) .or. has_hoist(effects)
   end function any_effect

   pure logical function has_drag(effects)
      type(effects_type), intent(in) :: effects

      has_drag = abs(effects%linear_drag) > 0 .or. abs(effects%quadratic_drag) > 0
   end function has_drag

   !> Whether the length changes in time.
   pure logical function has_hoist(effects)
      type(effects_type), intent(in) :: effects

      has_hoist = abs(effects%hoist_rate) > 0 .or. allocated(effects%hoist%times)
   end function has_hoist

   pure logical function has_moving_pivot(effects)
      type(effects_type), intent(in) :: effects

      has_moving_pivot = allocated(effects%pivot_times) .or. allocated(effects%pivot_curve%times) .or. &
         any(abs(effects%pivot_amplitude*effects%pivot_frequency) > 0)
   end function has_moving_pivot

   !> Fails on a coefficient that is no number, negative or outside its range.
   pure subroutine check_effects(effects, error)
      type(effects_type), intent(in) :: effects
      type(error_type), allocatable, intent(out) :: error

      call refuse_negative('linear_drag', effects%linear_drag, error)
      call refuse_negative('quadratic_drag', effects%quadratic_drag, error)
      call refuse_negative('sphere_speed', effects%sphere_speed, error)
      call refuse_negative('stiffness', effects%stiffness, error)
      call refuse_negative('extra_length_x', effects%extra_length(1), error)
      call refuse_negative('extra_length_y', effects%extra_length(2), error)
      call refuse_negative('restitution', effects%restitution, error)
      call refuse_negative('density_ratio', effects%density_ratio, error)
      call refuse_negative('added_mass', effects%added_mass, error)
      if (allocated(error)) return
      if (effects%restitution > 1) then
         call fail(error, code_domain, 'effects: restitution must lie between 0 and 1')
      else if (.not. effects%density_ratio < 1) then
         call fail(error, code_domain, 'effects: density_ratio must be below 1, or the bob floats')
      else if (.not. all(is_finite([effects%wind, effects%turn_rate, effects%pivot_amplitude, effects%pivot_frequency, &
            effects%pivot_phase, effects%hoist_rate]))) then
         call fail(error, code_domain, 'effects: wind, turn rate, motion of the pivot and hoist rate must be finite')
      else if (has_hoist(effects) .and. effects%is_string) then
         call fail(error, code_domain, 'effects: a length that varies needs a rod, not a string, which may go slack')
      else if (allocated(effects%pivot_times) .neqv. allocated(effects%pivot_curvatures)) then
         call fail(error, code_domain, 'effects: a table of the pivot is made by new_pivot_table')
      end if
   end subroutine check_effects

   !> The first failure stands.
   pure subroutine refuse_negative(name, value, error)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value
      type(error_type), allocatable, intent(inout) :: error
      character(len=24) :: got

      if (allocated(error) .or. value >= 0 .and. is_finite(value)) return
      write (got, '(es24.16)') value
      call fail(error, code_domain, 'effects: '//name//' must not be negative, got '//trim(adjustl(got)))
   end subroutine refuse_negative

   !> Rotation of the Earth in the axes of a place: x east, y north, z up.
   pure function earth_turn_rate(latitude, rate) result(turn_rate)
      real(wp), intent(in) :: latitude  !! North positive [degrees]
      real(wp), intent(in) :: rate      !! Of the Earth about its axis [rad/s]
      real(wp) :: turn_rate(3)

      turn_rate = rate*[0.0_wp, cos(latitude*degree), sin(latitude*degree)]
      ! The cosine of a rounded right angle is not zero.
      if (abs(latitude) >= 90 .and. abs(latitude) <= 90) turn_rate(2) = 0
   end function earth_turn_rate

   !> Drag of a sphere: Stokes's force at low speed and Newton's at high, added, as R. A. Nelson and M. G. Olsson fit
   !> pendulums (Am. J. Phys. 54 (1986) 112).
   pure subroutine air_coefficients(diameter, mass, density, viscosity, linear_drag, quadratic_drag, drag_coefficient)
      real(wp), intent(in) :: diameter, mass         !! Of the bob [m], [kg]
      real(wp), intent(in) :: density, viscosity     !! Of the air [kg/m3], [Pa s]
      real(wp), intent(out) :: linear_drag           !! 3 pi viscosity diameter/mass [1/s]
      real(wp), intent(out) :: quadratic_drag        !! coefficient density (pi/4) diameter**2/(2 mass) [1/m]
      real(wp), intent(in), optional :: drag_coefficient !! Default 0.47: a smooth sphere at Reynolds numbers 1e3 to 2e5
      real(wp), parameter :: pi = acos(-1.0_wp)
      real(wp) :: coefficient

      coefficient = 0.47_wp
      if (present(drag_coefficient)) coefficient = drag_coefficient
      linear_drag = 3*pi*viscosity*diameter/mass
      quadratic_drag = coefficient*density*pi*diameter**2/(8*mass)
   end subroutine air_coefficients

   !> Of a smooth sphere, with the drag coefficient 24/Re (1 + 0.150 Re**0.681) + 0.407/(1 + 8710/Re) up to the Reynolds
   !> number Re = 2e5: P. P. Brown and D. F. Lawler, J. Environ. Eng. 129 (2003) 222.
   pure subroutine sphere_coefficients(diameter, mass, density, viscosity, linear_drag, quadratic_drag, sphere_speed)
      real(wp), intent(in) :: diameter, mass         !! Of the bob [m], [kg]
      real(wp), intent(in) :: density, viscosity     !! Of the air [kg/m3], [Pa s]
      real(wp), intent(out) :: linear_drag, quadratic_drag, sphere_speed !! For `sphere_drag` [1/s], [1/m], [m/s]

      call air_coefficients(diameter, mass, density, viscosity, linear_drag, quadratic_drag, newton)
      sphere_speed = viscosity/(density*diameter)
   end subroutine sphere_coefficients

   !> Drag force over mass and speed, and how it changes with speed, the two coefficients and sphere_speed.
   pure subroutine sphere_drag(effects, speed, drag, changes)
      type(effects_type), intent(in) :: effects
      real(wp), intent(in) :: speed                  !! Through the air [m/s]
      real(wp), intent(out) :: drag                  !! [1/s]
      real(wp), intent(out), optional :: changes(4)
      real(wp) :: reynolds, more, part

      reynolds = speed/effects%sphere_speed
      more = stokes*reynolds**power
      part = reynolds/(reynolds + turn)
      drag = effects%linear_drag*(1 + more) + effects%quadratic_drag*speed*part
      if (.not. present(changes)) return
      changes = 0
      changes(2:3) = [1 + more, speed*part]
      if (.not. speed > 0) return
      changes(1) = effects%linear_drag*power*more/speed + effects%quadratic_drag*part*(2 - part)
      changes(4) = -(effects%linear_drag*power*more + effects%quadratic_drag*speed*part*(1 - part))/effects%sphere_speed
   end subroutine sphere_drag

end module kyvadlo_effects
