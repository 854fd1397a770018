!> A bob in a fluid that carries part of its weight and moves along with it.
!>
!> Let r be the density of the fluid over that of the bob and k the added mass over the displaced mass (1/2 for a sphere in
!> an ideal fluid). The fluid lifts by r of the weight and adds k r of the mass: (1 + k r) a = (1 - r) g + forces over mass.
!> A pendulum with no other force moves as in vacuum under gravity g (1 - r)/(1 + k r).
module kyvadlo_buoyancy
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: effective_gravity, effective_weight, effective_inertia

contains

   !> Gravity of the pendulum in vacuum that moves alike [m/s2].
   elemental real(wp) function effective_gravity(gravity, density_ratio, added_mass)
      real(wp), intent(in) :: gravity        !! [m/s2]
      real(wp), intent(in) :: density_ratio  !! Fluid over bob, 0 to 1
      real(wp), intent(in) :: added_mass     !! Part of the displaced mass

      effective_gravity = effective_weight(gravity, density_ratio)/effective_inertia(density_ratio, added_mass)
   end function effective_gravity

   !> Weight less buoyancy over the mass of the bob, g (1 - r) [m/s2].
   elemental real(wp) function effective_weight(gravity, density_ratio)
      real(wp), intent(in) :: gravity, density_ratio

      effective_weight = gravity*(1 - density_ratio)
   end function effective_weight

   !> Mass of bob and fluid moved over the mass of the bob, 1 + k r. Energies and tensions of the vacuum pendulum times this
   !> are those in the fluid, per mass of the bob.
   elemental real(wp) function effective_inertia(density_ratio, added_mass)
      real(wp), intent(in) :: density_ratio, added_mass

      effective_inertia = 1 + added_mass*density_ratio
   end function effective_inertia

end module kyvadlo_buoyancy
