!> What a simulation may be asked for: words, columns and units.
module kyvadlo_quantities
   implicit none
   private
   public :: quantity_type, quantities, default_quantities, has_derivatives
   public :: quantity_position, quantity_velocity, quantity_speed, quantity_energy, quantity_momentum, &
      quantity_tension, quantity_azimuth, quantity_inclination, quantity_drag_work, quantity_pivot_work, &
      quantity_derivatives, quantity_major, quantity_minor, quantity_plane, quantity_handedness, quantity_pivot_force

   !> A word of `quantities`, and the columns it stands for.
   type :: quantity_type
      character(len=11) :: name = ''
      integer :: columns = 0                 !! 1 or 3; of `derivatives`, by what is asked for, 0
      character(len=11) :: column_names(3) = ''
      character(len=7) :: unit = ''          !! As UDUNITS writes it
      character(len=64) :: meaning = ''
   end type quantity_type

   !> Places in `quantities`; those up to the inclination have derivatives.
   integer, parameter :: quantity_position = 1, quantity_velocity = 2, quantity_speed = 3, quantity_energy = 4, &
      quantity_momentum = 5, quantity_tension = 6, quantity_azimuth = 7, quantity_inclination = 8, &
      quantity_drag_work = 9, quantity_pivot_work = 10, quantity_derivatives = 11, quantity_major = 12, &
      quantity_minor = 13, quantity_plane = 14, quantity_handedness = 15, quantity_pivot_force = 16

   type(quantity_type), parameter :: quantities(16) = [ &
      quantity_type('position', 3, [character(len=11) :: 'x', 'y', 'z'], 'm', 'position of the bob, z upwards'), &
      quantity_type('velocity', 3, [character(len=11) :: 'vx', 'vy', 'vz'], 'm s-1', 'velocity of the bob'), &
      quantity_type('speed', 1, [character(len=11) :: 'speed', '', ''], 'm s-1', 'magnitude of the velocity'), &
      quantity_type('energy', 1, [character(len=11) :: 'energy', '', ''], 'm2 s-2', &
         'energy per mass, 0 for rest at the height of the pivot'), &
      quantity_type('momentum', 1, [character(len=11) :: 'momentum', '', ''], 'm2 s-1', &
         'angular momentum per mass about the vertical'), &
      quantity_type('tension', 1, [character(len=11) :: 'tension', '', ''], 'm s-2', &
         'force of the rod or string per mass, positive towards the pivot'), &
      quantity_type('azimuth', 1, [character(len=11) :: 'azimuth', '', ''], 'rad', &
         'azimuth of the bob from the x axis, turns counted'), &
      quantity_type('inclination', 1, [character(len=11) :: 'inclination', '', ''], 'rad', &
         'angle from the downward vertical'), &
      quantity_type('drag_work', 1, [character(len=11) :: 'drag_work', '', ''], 'm2 s-2', &
         'work of the air on the bob since t = 0, per mass'), &
      quantity_type('pivot_work', 1, [character(len=11) :: 'pivot_work', '', ''], 'm2 s-2', &
         'work of the moving pivot on the bob since t = 0, per mass'), &
      quantity_type('derivatives', 0, [character(len=11) :: '', '', ''], '', &
         'derivatives of the other quantities'), &
      quantity_type('major', 1, [character(len=11) :: 'major', '', ''], 'm', &
         'of the swing''s ellipse: horizontal radius at its highest point'), &
      quantity_type('minor', 1, [character(len=11) :: 'minor', '', ''], 'm', &
         'of the swing''s ellipse: horizontal radius at its lowest point'), &
      quantity_type('plane', 1, [character(len=11) :: 'plane', '', ''], 'rad', &
         'azimuth of the swing''s plane: of the nearest highest point'), &
      quantity_type('handedness', 1, [character(len=11) :: 'handedness', '', ''], '1', &
         'of the ellipse: 1 anticlockwise from above, -1, 0 in a plane'), &
      quantity_type('pivot_force', 3, [character(len=11) :: 'force_x', 'force_y', 'force_z'], 'N', &
         'force of the pivot on the body')]

   !> What `derivatives` differentiates (kyvadlo_derivative_samples).
   integer, parameter :: has_derivatives(*) = [quantity_position, quantity_velocity, quantity_speed, quantity_energy, &
      quantity_momentum, quantity_tension, quantity_azimuth, quantity_inclination]

   !> Without `quantities`.
   character(len=*), parameter :: default_quantities = 'position velocity'

end module kyvadlo_quantities
