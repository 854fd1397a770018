!> The words of a scene: which starts there are and which names give them.
module kyvadlo_scene_names
   use kyvadlo_start, only: start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, &
      start_energy_above_bottom, start_release, start_state
   implicit none
   private
   public :: start_type, starts, pendulum_names
   public :: start_heights, start_gaps, start_rises, start_energy, start_energy_above_top, start_energy_above_bottom, &
      start_release, start_state

   !> A start is given by two names, each with so many values.
   type :: start_type
      character(len=20) :: first, second
      integer :: values = 1              !! Values of each name: 1, or 3 for vectors
   end type start_type

   !> By the numbers `start_*` of the core.
   type(start_type), parameter :: starts(8) = [ &
      start_type('z_upper', 'z_lower', 1), &
      start_type('top_gap', 'bottom_gap', 1), &
      start_type('upper_rise', 'lower_rise', 1), &
      start_type('energy', 'momentum', 1), &
      start_type('energy_above_top', 'momentum', 1), &
      start_type('energy_above_bottom', 'momentum', 1), &
      start_type('release_angle', 'release_speed', 1), &
      start_type('position', 'velocity', 3)]

   !> The names of a &pendulum group that are no part of a start.
   character(len=8), parameter :: pendulum_names(3) = [character(len=8) :: 'name', 'length', 'gravity']

end module kyvadlo_scene_names
