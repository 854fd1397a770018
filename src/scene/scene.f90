!> A pendulum as a scene describes it: its numbers are texts until an orbit is made of them, in whatever kind.
module kyvadlo_scene
   use kyvadlo_text, only: text_type
   implicit none
   private
   public :: pendulum_type, body_names, body_inertia, body_distance, body_mass, body_bob_diameter, body_wire_mass

   !> Places in `body_names`: what &body says of a rigid body.
   integer, parameter :: body_inertia = 1, body_distance = 2, body_mass = 3, body_bob_diameter = 4, body_wire_mass = 5
   character(len=12), parameter :: body_names(5) = [character(len=12) :: 'inertia', 'distance', 'mass', &
      'bob_diameter', 'wire_mass']

   !> One &pendulum group: plain data, SI units.
   type :: pendulum_type
      character(len=:), allocatable :: name      !! Title; `pendulum N` if the scene gives none
      character(len=:), allocatable :: file      !! Where it was read, for messages
      character(len=:), allocatable :: note      !! Of a name that has another now; not allocated: there is none
      integer :: line = 0                        !! Of the group
      integer :: length_line = 0, gravity_line = 0, start_line = 0
      type(text_type) :: length                  !! l [m]
      type(text_type) :: gravity                 !! g [m/s2]
      type(text_type) :: body(5)                 !! Of a rigid body, by `body_names`; not allocated: not given
      integer :: body_line = 0                   !! 0: a mass point
      integer :: start = 0                       !! One of the `start_*` places
      integer :: values = 0                      !! Of each name of the start: 1 or 3
      type(text_type) :: first(3), second(3)     !! Values of the two names of the start; scalars in element 1
   end type pendulum_type

end module kyvadlo_scene
