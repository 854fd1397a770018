!> How a scene is computed: the one place where the path is chosen.
module kyvadlo_simulation_path
   use kyvadlo_motion_kinds
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_string, only: event_slack, new_string_motion, string_event_type, string_motion_type, &
      string_starts_in_flight
   use kyvadlo_accuracy, only: accurate_orbit_type, accuracy_finest_quad, new_orbit_to_accuracy
   use kyvadlo_closed_form, only: closed_form_words, default_duration, lowest_tension
   use kyvadlo_buoyancy, only: effective_gravity, effective_gravity_rest, effective_inertia, effective_weight
   use kyvadlo_effects, only: any_effect, effects_type
   use kyvadlo_force_checks, only: check_forces
   use kyvadlo_forces, only: forces_type, new_forces
   use kyvadlo_integration_start, only: begin_motion
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_pivot, only: pivot_motion
   use kyvadlo_quantities, only: quantity_major, quantity_tension
   use kyvadlo_sample_times, only: rounded_off, samples_at_rate
   use kyvadlo_scene_effects, only: effects_of
   use kyvadlo_scene_groups
   use kyvadlo_scene_orbit, only: numbers_of, numbers_type, orbit_in_fluid, pendulum_orbit
   use kyvadlo_scene_settings, only: settings_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_number_text, only: digits_text, read_number, shortest_text
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   use kyvadlo_step_forecast, only: cause_start, forecast_steps
   use kyvadlo_version, only: with_gsl
   implicit none
   private
   public :: path_type, check_type, choose_path
   public :: path_constant, path_closed_form, path_string, path_integrated

   integer, parameter :: path_constant = 1      !! At rest: every sample is the start
   integer, parameter :: path_closed_form = 2   !! One orbit for all times
   integer, parameter :: path_string = 3        !! Orbits and free flights, event by event
   integer, parameter :: path_integrated = 4    !! Newton's equations by GSL

   !> What the samples are computed from.
   type :: path_type
      integer :: path = 0                       !! One of the `path_*` constants
      real(wp) :: length = 0, gravity = 0       !! Of the pendulum [m], [m/s2]
      real(wp) :: rests(2) = 0                  !! What of l and the effective gravity their rounding took off [m, m/s2]
      type(effects_type) :: effects
      type(orbit_type) :: orbit                 !! Through the start, without effects but buoyancy
      type(accurate_orbit_type), allocatable :: plan !! For places to an accuracy; not allocated: all digits
      integer :: figures = 0                    !! To write, of an accuracy finer than doubles; 0: those of doubles
      type(string_motion_type) :: string        !! Of `path_string`
      !> Of `path_string`, with one at the start if the string is slack there
      type(string_event_type), allocatable :: events(:)
      real(wp) :: position(3) = 0, velocity(3) = 0 !! At the start, relative to the pivot [m], [m/s]
      logical :: starts_freely = .false.        !! On no orbit: only a string or a suspension lets it start there
      real(wp) :: mass = 0                      !! Of the body [kg]; 0: not given
      real(wp) :: centre_part = 1               !! Distance of its centre of mass over the length
      real(wp) :: inertia = 1                   !! Mass moved, fluid included, over that of the bob
      real(wp) :: pivot_energy = 0              !! Of the bob at the pivot's height, where that stays at one [m2/s2]
      real(wp) :: duration = 0                  !! [s]
      real(wp) :: duration_rest = 0             !! What rounding took off the duration as it was typed [s]
      character(len=:), allocatable :: duration_typed !! Empty: none was
      real(wp) :: tolerance = 0                 !! Of a step of `path_integrated`
      integer :: threads = 1                    !! That share a long block; 0: as many as OpenMP offers
      real(wp) :: steps = 0                     !! Of it, about
      real(wp) :: most_steps = 0                !! It may take
      character(len=:), allocatable :: hardest  !! What asks for the most steps: file, line and group
      character(len=:), allocatable :: method   !! In words
      character(len=:), allocatable :: note     !! Of something that is allowed and seldom meant; not allocated: none
      character(len=:), allocatable :: reason   !! In words
   end type path_type

   !> The largest differences between an integrated scene and the same at a tenth of the tolerance.
   type :: check_type
      real(wp) :: position = 0, position_time = 0      !! [m], and when [s]
      real(wp) :: velocity = 0, velocity_time = 0      !! [m/s], and when [s]
   end type check_type

   !> Without an accuracy asked for: some ten steps a swing, and 1e-10 of the length after a hundred of them.
   real(wp), parameter :: default_tolerance = 1e-12_wp
   !> Steps of an integration without another bound: some ten seconds to a minute.
   real(wp), parameter :: default_most_steps = 1e7_wp
   !> Where double precision cannot tell the phase: what must be left of it.
   real(wp), parameter :: phase_accuracy = 1e-3_wp
   !> Places are written as doubles down to this accuracy; in finer ones so many figures at most tell what quadruple
   !> precision has.
   real(wp), parameter :: finest_of_doubles = 1e-16_wp
   integer, parameter :: most_figures = 34
   real(wp), parameter :: half_ulp_of_quads = 2.0_wp**(-113)
   !> What two parts of a double resolve.
   real(wp), parameter :: finest_of_parts = epsilon(1.0_wp)**2
   !> What a table of lengths may be off at time 0: numbers of three digits, as in kyvadlo_gaps.
   real(wp), parameter :: most_off = 1e-3_wp
   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   !> Chooses the cheapest path that is exact, and integration only for what has no closed form.
   !>
   !> Errors: a start that determines no orbit; effects in a build without an integrator; an integration of more than
   !> `most_steps`; a string with more events than `new_string_motion` follows; an accuracy that cannot be kept.
   subroutine choose_path(simulation, path, error, accuracy, most_steps)
      type(simulation_type), intent(inout) :: simulation   !! Its number of samples, where a rate was given, changes
      type(path_type), intent(out) :: path
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in), optional :: accuracy       !! Of places in l (default: all digits), or of a step (1e-12)
      real(wp), intent(in), optional :: most_steps     !! Of an integration (default 1e7)
      type(numbers_type) :: numbers
      real(wp) :: first_length
      logical :: has_orbit

      associate (settings => simulation%settings)
         call numbers_of(simulation%pendulum, numbers, error)
         if (allocated(error)) return
         path%length = numbers%length
         path%mass = numbers%mass
         path%centre_part = numbers%distance/numbers%length
         call check_forces(settings, error)
         if (allocated(error)) return
         path%gravity = numbers%gravity
         numbers%gravity = effective_gravity(path%gravity, settings%effects%density_ratio, settings%effects%added_mass)
         numbers%rests(2) = effective_gravity_rest(path%gravity, settings%effects%density_ratio, &
            settings%effects%added_mass)
         path%rests = numbers%rests
         path%tolerance = default_tolerance
         if (present(accuracy)) path%tolerance = accuracy
         path%most_steps = default_most_steps
         if (present(most_steps)) path%most_steps = most_steps
         path%inertia = effective_inertia(settings%effects%density_ratio, settings%effects%added_mass)
         call effects_of(simulation, path%effects, error, path%note, first_length)
         if (.not. allocated(error)) call find_start(simulation, numbers, path, has_orbit, error)
         if (.not. allocated(error)) call count_samples(simulation%settings, path%duration, error)
         if (.not. allocated(error)) call check_table(simulation, path, error)
         if (.not. allocated(error)) call check_length(simulation, path, first_length, error)
         if (allocated(error)) return
         if (any_effect(path%effects) .or. differentiates_effects(simulation)) then
            call choose_integration(simulation, path, error)
         else if (.not. has_orbit) then
            path%reason = '&string is slack at the start'
            call follow_string(simulation, numbers, path, present(accuracy), error)
         else if (settings%given(string_group) .and. lowest_tension(path%orbit) < 0) then
            path%reason = '&string goes slack: its tension would be negative at the upper turning height'
            call follow_string(simulation, numbers, path, present(accuracy), error)
         else if (path%orbit%motion == motion_rest .or. path%orbit%motion == motion_upright) then
            path%path = path_constant
            path%method = 'the start, repeated'
            path%reason = 'the bob is at rest at its '//merge('lowest ', 'highest', path%orbit%motion == motion_rest)
            path%reason = trim(path%reason)//' point'
         else
            path%path = path_closed_form
            path%method = trim(closed_form_words(path%orbit))
            path%reason = 'no effect without a closed form is asked for'
            if (integrated_groups(simulation) /= '') path%reason = trim(integrated_groups(simulation))// &
               ': nothing there that acts'
            if (settings%given(string_group)) path%reason = '&string stays taut: its tension is nowhere negative'
            if (present(accuracy)) then
               call plan_accuracy(simulation, numbers, accuracy, .true., path, error)
            else if (path%duration > path%orbit%time_limit()) then
               ! Double precision cannot tell the phase to the end.
               call plan_accuracy(simulation, numbers, phase_accuracy, .false., path, error)
            end if
         end if
      end associate
   end subroutine choose_path

   !> Where the bob starts: on an orbit, or where only a string that is slack or a suspension of another form lets it
   !> be. The duration too, which is a period without one.
   subroutine find_start(simulation, numbers, path, has_orbit, error)
      type(simulation_type), intent(in) :: simulation
      type(numbers_type), intent(in) :: numbers              !! Under the effective gravity
      type(path_type), intent(inout) :: path
      logical, intent(out) :: has_orbit
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: no_orbit
      type(forces_type) :: forces
      logical :: is_taut, is_free
      real(wp) :: slack, displacement(3), velocity(3)

      associate (effects => path%effects, settings => simulation%settings)
         call pendulum_orbit(simulation%pendulum, numbers, path%orbit, no_orbit)
         has_orbit = .not. allocated(no_orbit)
         if (has_orbit) call path%orbit%locate(0.0_wp, path%position, path%velocity)
         is_free = .false.
         if (simulation%pendulum%start == start_state) then
            is_free = effects%stiffness > 0 .or. any(effects%extra_length > 0)
            if (effects%is_string) is_free = is_free .or. string_starts_in_flight(path%length, numbers%first, &
               numbers%second)
         end if
         path%starts_freely = is_free
         if (is_free) then
            has_orbit = .false.
            path%position = numbers%first
            path%velocity = numbers%second
         else if (.not. has_orbit) then
            call move_alloc(no_orbit, error)
            return
         end if
         path%duration = settings%duration
         path%duration_rest = rounded_off(settings%duration_typed, settings%duration)
         path%duration_typed = settings%duration_typed
         if (.not. path%duration > 0) then
            path%duration = 2*pi*sqrt(numbers%length/numbers%gravity)
            if (path%orbit%motion /= motion_none) path%duration = default_duration(path%orbit)
         end if
         if (.not. any_effect(effects)) then
            call pivot_motion(effects, 0.0_wp, displacement, velocity)
            path%pivot_energy = effective_weight(path%gravity, settings%effects%density_ratio)*displacement(3)
         end if
         if (.not. is_free .and. .not. any(effects%extra_length > 0)) return
         call new_forces(forces, effects, path%length, path%gravity, error)
         if (.not. allocated(error)) call begin_motion(forces, path%position, path%velocity, is_taut, slack, error)
         if (allocated(error)) error%message = place_of(settings%file, simulation%pendulum%start_line)// &
            '&pendulum: '//error%message
      end associate
   end subroutine find_start

   !> As many samples as the rate says, where one was given.
   subroutine count_samples(settings, duration, error)
      type(settings_type), intent(inout) :: settings
      real(wp), intent(in) :: duration                 !! [s]
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: ignored
      real(wp) :: rate

      if (settings%sample_rate == '') return
      call read_number(settings%sample_rate, rate, ignored)
      if (rate*duration < 1/epsilon(rate)) then
         settings%samples = samples_at_rate(settings%sample_rate, duration)
      else
         call fail(error, code_input, place_of(settings%file, settings%line(output_group))//'&output: rate='// &
            settings%sample_rate//' over '//trim(digits_text(duration, 6))//' s makes more than 4.5e15 samples')
      end if
   end subroutine count_samples

   !> Integration, if it comes to an end.
   subroutine choose_integration(simulation, path, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(inout) :: path
      type(error_type), allocatable, intent(out) :: error
      !> The groups behind the `cause_*` constants; 0: &pendulum.
      integer, parameter :: groups(*) = [0, 0, air_group, wind_group, earth_rotation_group, moving_pivot_group, &
         elastic_group, hoist_group]
      integer :: cause

      associate (settings => simulation%settings)
         if (.not. with_gsl) then
            call fail(error, code_unsupported, &
               place_of(settings%file, maxval(settings%line, settings%given .and. .not. has_closed_form)) &
               //'this build has no integrator (CMake option KYVADLO_WITH_GSL) for '//integrated_groups(simulation))
            return
         end if
         path%path = path_integrated
         path%method = 'Newton''s equations integrated by Runge, Kutta, Prince and Dormand''s method of order 8 (GSL)'
         path%reason = trim(integrated_groups(simulation))//': no closed form'
         if (.not. any_effect(path%effects)) path%reason = trim(integrated_groups(simulation))// &
            ': derivatives have no closed form'
         call forecast_steps(path%effects, path%length, path%gravity, norm2(path%velocity), path%duration, &
            path%tolerance, path%steps, cause)
         if (groups(cause) > 0) then
            path%hardest = place_of(settings%file, settings%line(groups(cause)))//'&'// &
               trim(group_names(groups(cause)))//': '
         else
            path%hardest = place_of(settings%file, merge(simulation%pendulum%start_line, simulation%pendulum%line, &
               cause == cause_start))//'&pendulum: '
         end if
         if (path%steps <= path%most_steps) return
         call fail(error, code_unsupported, path%hardest//'the integration over '//trim(digits_text(path%duration, 4)) &
            //' s would take '//trim(step_words(path%steps))//', more than '//trim(digits_text(path%most_steps, 2)) &
            //' (option --most-steps); shorten &output duration')
      end associate
   end subroutine choose_integration

   !> `about 1.2e+09 steps`.
   pure function step_words(steps) result(words)
      real(wp), intent(in) :: steps
      character(len=40) :: words

      words = 'more steps than there are numbers'
      if (is_finite(steps)) words = 'about '//trim(digits_text(steps, 2))//' steps'
   end function step_words

   !> Swings and flights, event by event.
   subroutine follow_string(simulation, numbers, path, has_accuracy, error)
      type(simulation_type), intent(in) :: simulation
      type(numbers_type), intent(in) :: numbers              !! Under the effective gravity
      type(path_type), intent(inout) :: path
      logical, intent(in) :: has_accuracy
      type(error_type), allocatable, intent(out) :: error

      associate (settings => simulation%settings)
         path%path = path_string
         path%method = 'closed forms of swings on the sphere and free flights, event by event'
         if (has_accuracy) then
            ! What an event is off by grows with every one that follows.
            call fail(error, code_unsupported, place_of(settings%file, settings%line(string_group))// &
               '&string: the string goes slack, and from event to event no accuracy can be promised; ' &
               //'leave --accuracy out for all digits of double precision')
            return
         end if
         call new_string_motion(path%string, numbers%length, numbers%gravity, path%position, path%velocity, &
            settings%effects%restitution, path%duration, error, path%rests)
         if (allocated(error)) then
            error%message = place_of(settings%file, simulation%pendulum%start_line)//'&pendulum: '//error%message
            return
         end if
         if (.not. path%string%is_complete) call fail(error, code_unsupported, place_of(settings%file, &
            settings%line(string_group))//'&string: too many events before the end of the duration; shorten it')
         path%events = path%string%events
         associate (first => path%string%pieces(1))
            if (.not. first%is_taut) path%events = [string_event_type(0.0_wp, event_slack, first%position, 0.0_wp), &
               path%events]
         end associate
      end associate
   end subroutine follow_string

   !> The tables of pivot and length must cover the duration.
   subroutine check_table(simulation, path, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error

      if (allocated(path%effects%pivot_times)) call check(path%effects%pivot_times, moving_pivot_group)
      if (allocated(path%effects%pivot_curve%times)) call check(path%effects%pivot_curve%times, moving_pivot_group)
      if (allocated(path%effects%hoist%times)) call check(path%effects%hoist%times, hoist_group)

   contains

      subroutine check(t, group)
         real(wp), intent(in) :: t(:)
         integer, intent(in) :: group

         if (allocated(error) .or. size(t) < 1) return
         if (t(1) <= 0 .and. t(size(t)) >= path%duration) return
         associate (settings => simulation%settings)
            call fail(error, code_input, place_of(settings%file, settings%line(group))//'&'// &
               trim(group_names(group))//': the table must cover the duration, 0 to '// &
               shortest_text(path%duration)//' s; it goes from '// &
               shortest_text(t(1))//' to '//shortest_text(t(size(t)))//' s')
         end associate
      end subroutine check
   end subroutine check_table

   !> A length that varies begins as the pendulum's, and stays positive.
   subroutine check_length(simulation, path, first_length, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      real(wp), intent(in) :: first_length             !! Of the table, at time 0; 0: there is none [m]
      type(error_type), allocatable, intent(out) :: error

      associate (settings => simulation%settings, rate => path%effects%hoist_rate)
         if (first_length > 0 .and. .not. abs(first_length - path%length) <= most_off*path%length) then
            call fail(error, code_input, place_of(settings%file, settings%line(hoist_group))// &
               '&hoist: the table must begin with the length of the pendulum, '// &
               trim(digits_text(path%length, 6))//' m at t = 0; it has '// &
               trim(digits_text(first_length, 6))//' m there')
         else if (.not. path%length + rate*path%duration > 0) then
            call fail(error, code_input, place_of(settings%file, settings%line(hoist_group))// &
               '&hoist: the length must stay positive over the duration of '// &
               trim(digits_text(path%duration, 6))//' s; at this rate nothing is left of it after '// &
               trim(digits_text(-path%length/rate, 6))//' s')
         end if
      end associate
   end subroutine check_length

   !> The cheapest evaluation that keeps an accuracy of the places throughout.
   subroutine plan_accuracy(simulation, numbers, accuracy, is_asked, path, error)
      type(simulation_type), intent(in) :: simulation
      type(numbers_type), intent(in) :: numbers              !! Under the effective gravity
      real(wp), intent(in) :: accuracy
      logical, intent(in) :: is_asked                        !! By the user; else because of the duration
      type(path_type), intent(inout) :: path
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: asked(:)
      real(wp) :: drift

      if (accuracy < accuracy_finest_quad) then
         call fail(error, code_input, 'option --accuracy must be at least '// &
            trim(digits_text(accuracy_finest_quad, 2)) //' for a scene in closed form, got '//shortest_text(accuracy))
         return
      end if
      allocate (path%plan)
      associate (pendulum => simulation%pendulum)
         call new_orbit_to_accuracy(path%plan, pendulum%start, numbers%length, numbers%gravity, &
            numbers%first(:pendulum%values), numbers%second(:pendulum%values), accuracy, path%duration, error, &
            path%rests)
      end associate
      if (.not. allocated(error) .and. lost_phase(path) > max(accuracy, finest_of_parts)) &
         call fail(error, code_unsupported, '')
      if (allocated(error)) then
         call say_where('rounding alone loses the phase by more')
         return
      end if
      path%method = path%method//' ('//trim(path%plan%choice_text())//')'
      ! Two figures more than the accuracy has, so that rounding adds a hundredth of it.
      if (accuracy < finest_of_doubles) path%figures = min(2 + ceiling(-log10(accuracy)), most_figures)
      asked = simulation%settings%quantities
      if (allocated(simulation%settings%events)) asked = [asked, simulation%settings%events%quantity]
      if (path%figures > 0 .and. any(asked >= quantity_major .or. path%mass > 0 .and. asked == quantity_tension)) &
         call fail(error, code_input, 'option --accuracy below 1e-16: major, minor, plane, handedness and forces '// &
         'in newtons are computed in double precision')
      ! Figures beyond those of doubles are figures of the decimals that were written, not of the doubles next to them.
      if (allocated(error) .or. path%figures == 0 .or. .not. path%plan%is_beyond_double()) return
      if (.not. allocated(path%plan%wide)) allocate (path%plan%wide)
      call orbit_in_fluid(simulation%pendulum, simulation%settings%effects%density_ratio, &
         simulation%settings%effects%added_mass, path%plan%wide, error, drift)
      if (allocated(error)) return
      ! Times are rounded too, unless they are whole parts, a power of two of them, of a duration that a double holds.
      if (abs(path%duration_rest) > 0 .or. popcnt(simulation%settings%samples - 1) > 1) drift = drift &
         + half_ulp_of_quads*sqrt(2*(path%orbit%energy() + path%gravity*path%length))/path%length
      if (drift*path%duration > accuracy) then
         call fail(error, code_unsupported, '')
         call say_where('the decimals of the scene, rounded to quadruple precision, lose the phase by more')
      else
         call path%plan%take_wide()
      end if

   contains

      subroutine say_where(why)
         character(len=*), intent(in) :: why

         error%message = place_of(simulation%settings%file, max(simulation%settings%line(output_group), 1))// &
            '&output: over '//shortest_text(path%duration)//' s '
         if (is_asked) then
            error%message = error%message//'an accuracy of '//shortest_text(accuracy)//' cannot be kept: '//why// &
               '; shorten duration'
         else
            error%message = error%message// &
               'no precision of this build can tell the phase of the motion; shorten duration'
         end if
      end subroutine say_where
   end subroutine plan_accuracy

   !> By how much the phase is off at the end of the duration, because the gravity in a fluid is known in two parts of a
   !> double [rad].
   pure real(wp) function lost_phase(path)
      type(path_type), intent(in) :: path

      lost_phase = 0
      if (path%effects%density_ratio > 0) lost_phase = &
         epsilon(path%duration)**2/4*(sqrt(path%gravity/path%length)*path%duration)
   end function lost_phase

   !> Whether a derivative is asked for that has no closed form, though the motion may have one: by an effect that is
   !> zero.
   pure logical function differentiates_effects(simulation)
      type(simulation_type), intent(in) :: simulation
      integer :: j

      differentiates_effects = .false.
      if (.not. allocated(simulation%settings%derivatives)) return
      associate (list => simulation%settings%derivatives)
         do j = 1, size(list)
            if (.not. has_closed_form(settings(list(j)%setting)%group)) differentiates_effects = .true.
         end do
      end associate
   end function differentiates_effects

   !> The groups without a closed form, in words, blanks behind.
   pure function integrated_groups(simulation) result(words)
      type(simulation_type), intent(in) :: simulation
      character(len=size(group_names)*(len(group_names) + 3)) :: words
      integer :: i

      words = ''
      do i = 1, size(group_names)
         if (simulation%settings%given(i) .and. .not. has_closed_form(i)) words = trim(words)//', &'//group_names(i)
      end do
      words = words(3:)
   end function integrated_groups

end module kyvadlo_simulation_path
