!> The words of a scene: groups, names, starts. One table of settings: reader, checks, messages, `kyvadlo simulate
!> --list` and the tables of doc/scene_format.md come from it.
module kyvadlo_scene_groups
   use kyvadlo_start_kinds, only: start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, &
      start_energy_above_bottom, start_release, start_state
   implicit none
   private
   public :: group_names, group_meanings, has_closed_form, setting_type, settings, setting_place, start_type, starts, &
      old_names, new_names
   public :: rule_any, rule_positive, rule_not_negative, rule_fraction, rule_part, rule_latitude, rule_half_turn, &
      rule_count, rule_text, rule_truth, rule_direction, rules
   public :: pendulum_group, output_group, rod_group, string_group, buoyancy_group, turning_frame_group, air_group, &
      wind_group, earth_rotation_group, moving_pivot_group, elastic_group, anisotropic_support_group, fit_group, &
      camera_group, event_group, hoist_group, body_group
   public :: start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, start_energy_above_bottom, &
      start_release, start_state

   !> Places in `group_names`.
   integer, parameter :: pendulum_group = 1, output_group = 2, rod_group = 3, string_group = 4, buoyancy_group = 5, &
      turning_frame_group = 6, air_group = 7, wind_group = 8, earth_rotation_group = 9, moving_pivot_group = 10, &
      elastic_group = 11, anisotropic_support_group = 12, fit_group = 13, camera_group = 14, event_group = 15, &
      hoist_group = 16, body_group = 17

   character(len=19), parameter :: group_names(*) = [character(len=19) :: 'pendulum', 'output', 'rod', 'string', &
      'buoyancy', 'turning_frame', 'air', 'wind', 'earth_rotation', 'moving_pivot', 'elastic', 'anisotropic_support', &
      'fit', 'camera', 'event', 'hoist', 'body']
   !> Whether the motion with a group has a closed form; without one it has where all coefficients are zero.
   logical, parameter :: has_closed_form(size(group_names)) = [.true., .true., .true., .true., .true., .true., &
      .false., .false., .false., .false., .false., .false., .true., .true., .true., .false., .true.]

   !> What each is about, in a line of `kyvadlo help`.
   character(len=72), parameter :: group_meanings(size(group_names)) = [character(len=72) :: &
      'length, gravity and start of a pendulum', 'when and what is computed', &
      'a rod, which pushes and pulls: the default', 'a string, which only pulls and may go slack', &
      'a fluid that carries part of the weight and moves along', 'a turning observer', &
      'drag of the air, by coefficients or of a sphere', 'a steady wind', &
      'rotation of the Earth: Foucault''s pendulum', &
      'a pivot that moves: swinging, by a table, to another place, on a circle', &
      'a rod or string that stretches', 'a support that makes it longer in one direction than in the other', &
      'what kyvadlo fit may change, and how well measurements are known', 'how a camera saw the measurements', &
      'a quantity passes a value: when, and what then; any number of these', &
      'a length that varies: a crane that lifts, a pumped swing', &
      'a rigid body, or a ball on a wire, in the place of a mass point']

   !> What a value may be: `name must RULE`.
   integer, parameter :: rule_any = 1, rule_positive = 2, rule_not_negative = 3, rule_fraction = 4, rule_part = 5, &
      rule_latitude = 6, rule_half_turn = 7, rule_count = 8, rule_text = 9, rule_truth = 10, rule_direction = 11
   character(len=38), parameter :: rules(*) = [character(len=38) :: 'be a finite number', 'be positive', &
      'not be negative', 'lie between 0 and 1', 'be at least 0 and less than 1', 'lie between -90 and 90 degrees', &
      'lie between -180 and 180 degrees', 'be a whole number from 2 to 4.5e15', 'be a text in quotation marks', &
      'be .true. or .false.', 'be -1, 0 or 1']

   !> A name of a group.
   type :: setting_type
      integer :: group = 0                 !! Place in `group_names`
      character(len=19) :: name = ''
      integer :: values = 1                !! How many it takes: 1, or 2 or 3 for vectors
      integer :: rule = 0                  !! One of the `rule_*` constants
      character(len=6) :: unit = ''
      character(len=80) :: meaning = ''
      character(len=24) :: default = ''    !! A number, or words; 'required' by its group
   end type setting_type

   type(setting_type), parameter :: settings(*) = [ &
      setting_type(pendulum_group, 'name', 1, rule_text, '', 'title in tables', '`pendulum N`'), &
      setting_type(pendulum_group, 'length', 1, rule_positive, 'm', 'radius l of the sphere, positive', 'required'), &
      setting_type(pendulum_group, 'gravity', 1, rule_positive, 'm/s2', 'g, positive', '9.80665'), & ! CGPM 1901
      setting_type(pendulum_group, 'z_upper', 1, rule_any, 'm', 'z1', ''), &
      setting_type(pendulum_group, 'z_lower', 1, rule_any, 'm', 'z2', ''), &
      setting_type(pendulum_group, 'upper_gap', 1, rule_any, 'm', 'l - z1', ''), &
      setting_type(pendulum_group, 'upper_rise', 1, rule_any, 'm', 'l + z1', ''), &
      setting_type(pendulum_group, 'lower_rise', 1, rule_any, 'm', 'l + z2', ''), &
      setting_type(pendulum_group, 'energy', 1, rule_any, 'm2/s2', 'c1', ''), &
      setting_type(pendulum_group, 'momentum', 1, rule_any, 'm2/s', 'c2', ''), &
      setting_type(pendulum_group, 'energy_above_top', 1, rule_any, 'm2/s2', 'c1 - g l', ''), &
      setting_type(pendulum_group, 'energy_above_bottom', 1, rule_any, 'm2/s2', 'c1 + g l', ''), &
      setting_type(pendulum_group, 'release_angle', 1, rule_half_turn, 'deg', 'from the downward vertical, towards x', &
      ''), setting_type(pendulum_group, 'release_speed', 1, rule_any, 'm/s', 'horizontal, across', '0'), &
      setting_type(pendulum_group, 'position', 3, rule_any, 'm', 'x, y, z', ''), &
      setting_type(pendulum_group, 'velocity', 3, rule_any, 'm/s', 'the rates of x, y, z', ''), &
      setting_type(output_group, 'duration', 1, rule_positive, 's', 'of the simulation, positive', 'one period'), &
      setting_type(output_group, 'samples', 1, rule_count, '', 'a whole number, at least 2; both ends count', '201'), &
      setting_type(output_group, 'rate', 1, rule_positive, '1/s', 'samples a second, in place of their number', ''), &
      setting_type(output_group, 'quantities', 1, rule_text, '', &
      'words of the next table, separated by blanks or commas, in quotation marks', '`''position velocity''`'), &
      setting_type(output_group, 'derivatives', 1, rule_text, '', &
      'names of settings by which `derivatives` differentiates, in quotation marks', 'length, gravity, start'), &
      setting_type(event_group, 'quantity', 1, rule_text, '', &
      'a column of the table of quantities: `x`, `vz`, `speed` ...', 'required'), &
      setting_type(event_group, 'value', 1, rule_any, '', 'in the unit of the column', '0'), &
      setting_type(event_group, 'direction', 1, rule_direction, '', '1: only where it rises, -1: only where it falls', &
      '0'), setting_type(event_group, 'stop', 1, rule_truth, '', '`.true.`: the simulation ends there', '`.false.`'), &
      setting_type(string_group, 'restitution', 1, rule_fraction, '', &
      'radial speed after over before the re-tension, 0 to 1; 0: all is lost', '0'), &
      setting_type(buoyancy_group, 'density_ratio', 1, rule_part, '', &
      'r: density of the fluid over that of the bob, at least 0, less than 1', 'required'), &
      setting_type(buoyancy_group, 'added_mass', 1, rule_not_negative, '', &
      'a: mass of the fluid that moves along, over that displaced (1/2 for a sphere)', '0'), &
      setting_type(turning_frame_group, 'rate', 1, rule_any, 'rad/s', &
      'of the frame about the vertical, counted as the azimuth', 'required'), &
      setting_type(air_group, 'linear', 1, rule_not_negative, '1/s', 'drag force over mass and speed, not negative', &
      '0'), setting_type(air_group, 'quadratic', 1, rule_not_negative, '1/m', &
      'drag force over mass and square of the speed, not negative', '0'), &
      setting_type(air_group, 'drag', 1, rule_text, '', &
      '`sphere`: the curve of Brown and Lawler (2003), to the Reynolds number 2e5', ''), &
      setting_type(air_group, 'diameter', 1, rule_positive, 'm', 'of a spherical bob, instead of the two above', ''), &
      setting_type(air_group, 'mass', 1, rule_positive, 'kg', 'of the spherical bob', ''), &
   ! At 20 degrees Celsius and 101325 Pa: ISO 2533 gives 1.225 and 1.789e-5 at 15 degrees, ideal gas and Sutherland's
   ! law these.
      setting_type(air_group, 'density', 1, rule_positive, 'kg/m3', 'of the air around it (20 degrees Celsius)', &
      '1.204'), setting_type(air_group, 'viscosity', 1, rule_positive, 'Pa s', 'of the air around it', '1.813e-5'), &
      setting_type(wind_group, 'velocity', 3, rule_any, 'm/s', 'of the air, steady', 'required'), &
      setting_type(earth_rotation_group, 'latitude', 1, rule_latitude, 'deg', '-90 to 90, north positive', &
      'required'), &
      setting_type(earth_rotation_group, 'rate', 1, rule_any, 'rad/s', 'of the Earth about its axis', & ! IERS
      '7.292115e-5'), &
      setting_type(moving_pivot_group, 'amplitude', 3, rule_any, 'm', 'along x, y, z', ''), &
      setting_type(moving_pivot_group, 'frequency', 3, rule_not_negative, 'Hz', 'along x, y, z, not negative', ''), &
      setting_type(moving_pivot_group, 'phase', 3, rule_any, 'deg', 'along x, y, z', '0'), &
      setting_type(moving_pivot_group, 'table', 1, rule_text, '', 'a file of times and displacements instead', ''), &
      setting_type(moving_pivot_group, 'table_of', 1, rule_text, '', &
      '`displacement`, `velocity` or `acceleration`: what the table has', '`''displacement''`'), &
      setting_type(moving_pivot_group, 'between', 1, rule_text, '', &
      '`spline` or `linear`: how the table goes on between its lines', '`''spline''`'), &
      setting_type(moving_pivot_group, 'move_to', 3, rule_any, 'm', 'from rest at 0 to rest there instead', ''), &
      setting_type(moving_pivot_group, 'speed', 1, rule_positive, 'm/s', 'the largest of that move, positive', ''), &
      setting_type(moving_pivot_group, 'acceleration', 1, rule_positive, 'm/s2', 'the largest of that move, positive', &
      ''), setting_type(moving_pivot_group, 'jerk', 1, rule_positive, 'm/s3', 'the largest of that move, positive', &
      'none'), &
      setting_type(moving_pivot_group, 'circle_radius', 1, rule_not_negative, 'm', &
      'of a level circle instead, run through from x towards y, not negative', ''), &
      setting_type(moving_pivot_group, 'circle_rate', 1, rule_any, 'Hz', 'turns a second; negative: the other way', &
      ''), &
      setting_type(moving_pivot_group, 'relative', 1, rule_truth, '', &
      '`.true.`: positions and velocities relative to the pivot', '`.false.`'), &
      setting_type(hoist_group, 'rate', 1, rule_any, 'm/s', 'at which the length grows; negative: it shrinks', ''), &
      setting_type(hoist_group, 'table', 1, rule_text, '', 'a file of times and lengths instead', ''), &
      setting_type(body_group, 'inertia', 1, rule_positive, 'kg m2', 'of the body about the pivot, positive', ''), &
      setting_type(body_group, 'distance', 1, rule_positive, 'm', 'of its centre of mass from the pivot, positive', &
      ''), &
      setting_type(body_group, 'mass', 1, rule_positive, 'kg', 'of the body, or of the bob, positive', ''), &
      setting_type(body_group, 'bob_diameter', 1, rule_not_negative, 'm', &
      'of a ball whose centre is `length` below the pivot, not negative', '0'), &
      setting_type(body_group, 'wire_mass', 1, rule_not_negative, 'kg', &
      'of the wire from the pivot to the ball, not negative', '0'), &
      setting_type(elastic_group, 'stiffness', 1, rule_positive, 'N/m', &
      'of the rod, or of the string with `&string`, positive', 'required'), &
      setting_type(elastic_group, 'mass', 1, rule_positive, 'kg', 'of the bob, positive', 'required'), &
      setting_type(anisotropic_support_group, 'extra_length_x', 1, rule_not_negative, 'm', &
      'by how much longer the pendulum is when it swings along x, not negative', '0'), &
      setting_type(anisotropic_support_group, 'extra_length_y', 1, rule_not_negative, 'm', 'the same along y', '0'), &
      setting_type(fit_group, 'free', 1, rule_text, '', &
      'names of the settings to find, separated by blanks or commas, in quotation marks', 'required'), &
      setting_type(fit_group, 'sigma', 1, rule_positive, '', 'standard deviation of every measured column', ''), &
      setting_type(fit_group, 'sigma_x', 1, rule_positive, 'm', 'of the column `x`', ''), &
      setting_type(fit_group, 'sigma_y', 1, rule_positive, 'm', 'of the column `y`', ''), &
      setting_type(fit_group, 'sigma_z', 1, rule_positive, 'm', 'of the column `z`', ''), &
      setting_type(fit_group, 'sigma_azimuth', 1, rule_positive, '', 'of the column `azimuth`', ''), &
      setting_type(fit_group, 'sigma_angle', 1, rule_positive, '', 'of the column `angle`', ''), &
      setting_type(fit_group, 'sigma_u', 1, rule_positive, '', 'of the column `u`', ''), &
      setting_type(fit_group, 'sigma_v', 1, rule_positive, '', 'of the column `v`', ''), &
      setting_type(fit_group, 'sigma_tension', 1, rule_positive, 'm/s2', 'of the column `tension`', ''), &
      setting_type(fit_group, 'sigma_plane', 1, rule_positive, '', 'of the column `plane`', ''), &
      setting_type(fit_group, 'sigma_turning_time', 1, rule_positive, 's', 'of the column `turning_time`', ''), &
      setting_type(fit_group, 'sigma_crossing_time', 1, rule_positive, 's', 'of the column `crossing_time`', ''), &
      setting_type(fit_group, 'sigma_period', 1, rule_positive, 's', 'of the column `period`', ''), &
      setting_type(fit_group, 'sigma_amplitude', 1, rule_positive, '', 'of the column `amplitude`', ''), &
      setting_type(fit_group, 'sigma_t', 1, rule_positive, 's', 'of the column `t`', ''), &
      setting_type(fit_group, 'units', 1, rule_text, '', &
      '`degrees`: the angles of the data and their sigmas; `pixels` as a reminder', '`''radians''`'), &
      setting_type(fit_group, 'loss', 1, rule_text, '', &
      '`squares`, `huber` or `cauchy`: what residuals far beyond their sigma count', '`''squares''`'), &
      setting_type(fit_group, 'loss_scale', 1, rule_positive, '', &
      'the residual, in sigmas, from which on it counts less', '1.345 or 2.385'), &
      setting_type(camera_group, 'view', 1, rule_text, '', '`xz`, `yz` or `xy`: what u and v would show, unturned', &
      'required'), &
      setting_type(camera_group, 'scale', 1, rule_positive, '1/m', 'units of u and v in a metre', '1'), &
      setting_type(camera_group, 'angle', 1, rule_any, 'deg', 'by which the picture is turned, from u to v', '0'), &
      setting_type(camera_group, 'offset', 2, rule_any, 'm', 'added to what is seen before turning and scaling', '0'), &
      setting_type(camera_group, 'time_offset', 1, rule_any, 's', 'added to t of the data gives t of the scene', '0')]

   !> A start is given by two names. The first tells which it is.
   type :: start_type
      character(len=19) :: first, second
      integer :: values = 1              !! Values of each name: 1, or 3 for vectors
   end type start_type

   !> Names of &pendulum until version 0.1, and those that took their places.
   character(len=10), parameter :: old_names(*) = ['top_gap   ', 'bottom_gap']
   character(len=10), parameter :: new_names(*) = ['upper_gap ', 'lower_rise']

   !> By the numbers `start_*` of the core.
   type(start_type), parameter :: starts(8) = [ &
      start_type('z_upper', 'z_lower'), &
      start_type('upper_gap', 'lower_rise'), &
      start_type('upper_rise', 'lower_rise'), &
      start_type('energy', 'momentum'), &
      start_type('energy_above_top', 'momentum'), &
      start_type('energy_above_bottom', 'momentum'), &
      start_type('release_angle', 'release_speed'), &
      start_type('position', 'velocity', 3)]

contains

   !> Place in `settings`, or 0.
   pure integer function setting_place(group, name) result(place)
      integer, intent(in) :: group
      character(len=*), intent(in) :: name

      place = findloc(settings%group == group .and. settings%name == name, .true., 1)
   end function setting_place

end module kyvadlo_scene_groups
