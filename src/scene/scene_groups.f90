!> The groups of a scene beside &pendulum: their names, what each value may be, and what holds without it.
module kyvadlo_scene_groups
   implicit none
   private
   public :: group_names, setting_type, settings, group_place, setting_place
   public :: rule_any, rule_positive, rule_not_negative, rule_fraction, rule_part, rule_latitude, rule_count, rule_text, &
      rule_truth
   public :: output_group, rod_group, string_group, buoyancy_group, turning_frame_group, air_group, wind_group, &
      earth_rotation_group, moving_pivot_group, elastic_group, anisotropic_support_group

   !> Places in `group_names`.
   integer, parameter :: output_group = 1, rod_group = 2, string_group = 3, buoyancy_group = 4, turning_frame_group = 5, &
      air_group = 6, wind_group = 7, earth_rotation_group = 8, moving_pivot_group = 9, elastic_group = 10, &
      anisotropic_support_group = 11

   character(len=19), parameter :: group_names(11) = [character(len=19) :: 'output', 'rod', 'string', 'buoyancy', &
      'turning_frame', 'air', 'wind', 'earth_rotation', 'moving_pivot', 'elastic', 'anisotropic_support']

   integer, parameter :: rule_any = 1           !! Any finite number
   integer, parameter :: rule_positive = 2
   integer, parameter :: rule_not_negative = 3
   integer, parameter :: rule_fraction = 4      !! 0 <= x <= 1
   integer, parameter :: rule_part = 5          !! 0 <= x < 1
   integer, parameter :: rule_latitude = 6      !! -90 <= x <= 90
   integer, parameter :: rule_count = 7         !! A whole number, at least 2
   integer, parameter :: rule_text = 8
   integer, parameter :: rule_truth = 9         !! .true. or .false.

   !> A name of a group.
   type :: setting_type
      integer :: group                     !! Place in `group_names`
      character(len=14) :: name
      integer :: values                    !! How many it takes
      integer :: rule                      !! One of the `rule_*` constants
      logical :: is_required = .false.     !! By its group
   end type setting_type

   type(setting_type), parameter :: settings(*) = [ &
      setting_type(output_group, 'duration', 1, rule_positive), &
      setting_type(output_group, 'samples', 1, rule_count), &
      setting_type(output_group, 'quantities', 1, rule_text), &
      setting_type(string_group, 'restitution', 1, rule_fraction), &
      setting_type(buoyancy_group, 'density_ratio', 1, rule_part, .true.), &
      setting_type(buoyancy_group, 'added_mass', 1, rule_not_negative), &
      setting_type(turning_frame_group, 'rate', 1, rule_any, .true.), &
      setting_type(air_group, 'linear', 1, rule_not_negative), &
      setting_type(air_group, 'quadratic', 1, rule_not_negative), &
      setting_type(air_group, 'diameter', 1, rule_positive), &
      setting_type(air_group, 'mass', 1, rule_positive), &
      setting_type(air_group, 'density', 1, rule_positive), &
      setting_type(air_group, 'viscosity', 1, rule_positive), &
      setting_type(wind_group, 'velocity', 3, rule_any, .true.), &
      setting_type(earth_rotation_group, 'latitude', 1, rule_latitude, .true.), &
      setting_type(earth_rotation_group, 'rate', 1, rule_any), &
      setting_type(moving_pivot_group, 'amplitude', 3, rule_any), &
      setting_type(moving_pivot_group, 'frequency', 3, rule_not_negative), &
      setting_type(moving_pivot_group, 'phase', 3, rule_any), &
      setting_type(moving_pivot_group, 'table', 1, rule_text), &
      setting_type(moving_pivot_group, 'relative', 1, rule_truth), &
      setting_type(elastic_group, 'stiffness', 1, rule_positive, .true.), &
      setting_type(elastic_group, 'mass', 1, rule_positive, .true.), &
      setting_type(anisotropic_support_group, 'extra_length_x', 1, rule_not_negative), &
      setting_type(anisotropic_support_group, 'extra_length_y', 1, rule_not_negative)]

contains

   !> Place in `group_names`, or 0.
   pure integer function group_place(name) result(place)
      character(len=*), intent(in) :: name

      place = findloc(group_names == name, .true., 1)
   end function group_place

   !> Place in `settings`, or 0.
   pure integer function setting_place(group, name) result(place)
      integer, intent(in) :: group
      character(len=*), intent(in) :: name

      place = findloc(settings%group == group .and. settings%name == name, .true., 1)
   end function setting_place

end module kyvadlo_scene_groups
