!> What a scene asks for beside its pendulum: plain data, SI units.
module kyvadlo_scene_settings
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_effects, only: effects_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_scene_groups, only: body_group, group_names, setting_place, settings
   use kyvadlo_text, only: text_type
   implicit none
   private
   public :: settings_type, value_of_name_type, derivative_type, event_request_type, is_extended

   !> What a name was given.
   type :: value_of_name_type
      type(text_type) :: text(3)                         !! As written; not allocated where not given
      integer :: line(3) = 0                             !! 0: not given
      real(wp) :: number(3) = 0
   end type value_of_name_type

   !> A number of a scene by which it is differentiated.
   type :: derivative_type
      integer :: setting = 0                             !! Place in `settings`
      integer :: element = 1                             !! Of a vector
      character(len=40) :: name = ''                     !! In the names of columns, behind `_d`
   end type derivative_type

   !> An &event: a column that passes a value.
   type :: event_request_type
      integer :: quantity = 0, component = 1             !! Place in the table of quantities, and which of its columns
      real(wp) :: value = 0                              !! In the unit of the column
      character(len=48) :: typed = ''                    !! As it stands there; blank: not, or longer
      integer :: direction = 0                           !! 1: where it rises, -1: where it falls, 0: both
      logical :: stops = .false.                         !! The simulation ends there
      integer :: line = 0
      character(len=64) :: names(2) = ''                 !! `z rises through -0.5`, `z falls through -0.5`
   end type event_request_type

   !> The groups of a scene; which of them stand in it is in `given`.
   type :: settings_type
      logical :: given(size(group_names)) = .false.
      integer :: line(size(group_names)) = 0             !! Of the group, for messages
      character(len=:), allocatable :: file              !! For messages, and where tables are looked for
      real(wp) :: duration = 0                           !! [s]; 0: one period
      character(len=:), allocatable :: duration_typed    !! As it stands there; empty: not given
      integer(int64) :: samples = 0                      !! Both ends included; 0: as the rate and the duration say
      character(len=:), allocatable :: sample_rate       !! [1/s], as it stands there; empty: not given
      integer, allocatable :: quantities(:)              !! Places in the table of quantities, in the order asked
      !> The words of `derivatives`, empty if there are none, and their line
      character(len=:), allocatable :: derivatives_typed
      integer :: derivatives_line = 0
      !> What is differentiated (places in the table of quantities), and by what; of no size without derivatives
      integer, allocatable :: differentiated(:)
      type(derivative_type), allocatable :: derivatives(:)
      type(event_request_type), allocatable :: events(:) !! In the order of the groups
      real(wp) :: number(3, size(settings)) = 0          !! Of all groups but &pendulum, as given or by default
      real(wp) :: frame_rate = 0                         !! Of the frame of the output [rad/s]
      logical :: relative = .false.                      !! Output in the frame of the pivot
      type(effects_type) :: effects                      !! But the table of the pivot, which is read when it is needed
      character(len=:), allocatable :: table             !! File of times and displacements; not allocated: none
      logical :: is_sphere = .false.                     !! The drag is that of the curve
      integer :: table_order = 0                         !! 0: of displacements, 1: of velocities, 2: of accelerations
      logical :: table_is_linear = .false.               !! Between its lines; else a spline
      character(len=:), allocatable :: hoist_table       !! ... and of times and lengths
   end type settings_type

contains

   !> Whether a body is more than a mass point.
   pure logical function is_extended(chosen)
      type(settings_type), intent(in) :: chosen

      is_extended = any(chosen%number(1, [setting_place(body_group, 'inertia'), setting_place(body_group, &
         'bob_diameter'), setting_place(body_group, 'wire_mass')]) > 0)
   end function is_extended

end module kyvadlo_scene_settings
