!> An orbit from any start, the start a number: for scenes, and for who chooses the kind last.
module kyvadlo_start_kinds
   implicit none
   public

   integer, parameter :: start_heights = 1              !! `new_orbit_from_heights`: z1, z2
   integer, parameter :: start_gaps = 2                 !! `new_orbit_from_gaps`: l - z1, l + z2
   integer, parameter :: start_rises = 3                !! `new_orbit_from_rises`: l + z1, l + z2
   integer, parameter :: start_energy = 4               !! `new_orbit_from_energy`: c1, c2
   integer, parameter :: start_energy_above_top = 5     !! `new_orbit_from_energy_above_top`: c1 - g l, c2
   integer, parameter :: start_energy_above_bottom = 6  !! `new_orbit_from_energy_above_bottom`: c1 + g l, c2
   integer, parameter :: start_release = 7              !! `new_orbit_from_release`: angle, speed
   integer, parameter :: start_state = 8                !! `new_orbit_from_state`: position, velocity
end module kyvadlo_start_kinds
