!> What a scene asks for beside its pendulum: plain data, SI units.
module kyvadlo_scene_settings
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_scene_groups, only: group_names
   implicit none
   private
   public :: settings_type

   !> The groups of a scene; which of them stand in it is in `given`.
   type :: settings_type
      logical :: given(size(group_names)) = .false.
      integer :: line(size(group_names)) = 0             !! Of the group, for messages
      character(len=:), allocatable :: file              !! For messages, and where tables are looked for
      ! &output
      real(wp) :: duration = 0                           !! [s]; 0: one period
      character(len=:), allocatable :: duration_typed    !! As it stands there; empty: not given
      integer(int64) :: samples = 201                    !! Both ends included
      integer, allocatable :: quantities(:)              !! Places in the table of quantities, in the order asked
      ! &string
      real(wp) :: restitution = 0
      ! &buoyancy
      real(wp) :: density_ratio = 0                      !! Of the fluid and the bob
      real(wp) :: added_mass = 0                         !! Part of the displaced mass
      ! &turning_frame
      real(wp) :: frame_rate = 0                         !! [rad/s]
      ! &air, &wind
      real(wp) :: linear_drag = 0                        !! [1/s]
      real(wp) :: quadratic_drag = 0                     !! [1/m]
      real(wp) :: diameter = 0                           !! Of a sphere [m]; 0: the drag is given
      real(wp) :: mass = 0                               !! [kg]
      real(wp) :: density = 0                            !! Of the air [kg/m3]
      real(wp) :: viscosity = 0                          !! [Pa s]
      real(wp) :: wind(3) = 0                            !! [m/s]
      ! &earth_rotation
      real(wp) :: latitude = 0                           !! [degrees]
      real(wp) :: earth_rate = 0                         !! [rad/s]
      ! &moving_pivot
      real(wp) :: amplitude(3) = 0                       !! [m]
      real(wp) :: frequency(3) = 0                       !! [Hz]
      real(wp) :: phase(3) = 0                           !! [degrees]
      character(len=:), allocatable :: table             !! File of times and displacements; not allocated: none
      logical :: relative = .false.                      !! Output in the frame of the pivot
      ! &elastic
      real(wp) :: stiffness = 0                          !! [N/m]
      real(wp) :: elastic_mass = 0                       !! [kg]
      ! &anisotropic_support
      real(wp) :: extra_length(2) = 0                    !! Along x and y [m]
   end type settings_type

end module kyvadlo_scene_settings
