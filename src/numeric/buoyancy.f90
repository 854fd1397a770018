!> A bob in a fluid that carries part of its weight and moves along with it.
!>
!> Let r be the density of the fluid over that of the bob and k the added mass over the displaced mass (1/2 for a sphere
!> in an ideal fluid). The fluid lifts by r of the weight and adds k r of the mass: (1 + k r) a = (1 - r) g + forces
!> over mass. A pendulum with no other force moves as in vacuum under gravity g (1 - r)/(1 + k r).
module kyvadlo_buoyancy
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_pairs_real64, only: operator(*), operator(+), operator(/), pair, pair_type, two_difference, two_product
   implicit none
   private
   public :: effective_gravity, effective_gravity_rest, effective_weight, effective_inertia

contains

   !> Gravity of the pendulum in vacuum that moves alike [m/s2].
   elemental real(wp) function effective_gravity(gravity, density_ratio, added_mass)
      real(wp), intent(in) :: gravity        !! [m/s2]
      real(wp), intent(in) :: density_ratio  !! Fluid over bob, 0 to 1
      real(wp), intent(in) :: added_mass     !! Part of the displaced mass

      type(pair_type) :: both

      both = in_parts(gravity, density_ratio, added_mass)
      effective_gravity = both%high
   end function effective_gravity

   !> What of it rounding took off: it would grow with the time [m/s2].
   elemental real(wp) function effective_gravity_rest(gravity, density_ratio, added_mass)
      real(wp), intent(in) :: gravity, density_ratio, added_mass
      type(pair_type) :: both

      both = in_parts(gravity, density_ratio, added_mass)
      effective_gravity_rest = both%low
   end function effective_gravity_rest

   elemental function in_parts(gravity, density_ratio, added_mass) result(both)
      real(wp), intent(in) :: gravity, density_ratio, added_mass
      type(pair_type) :: both

      both = pair(gravity)
      if (.not. density_ratio > 0) return
      both = both*two_difference(1.0_wp, density_ratio)/(pair(1.0_wp) + two_product(added_mass, density_ratio))
   end function in_parts

   !> Weight less buoyancy over the mass of the bob, g (1 - r) [m/s2].
   elemental real(wp) function effective_weight(gravity, density_ratio)
      real(wp), intent(in) :: gravity, density_ratio

      effective_weight = gravity*(1 - density_ratio)
   end function effective_weight

   !> Mass of bob and fluid moved over the mass of the bob, 1 + k r. Energies and tensions of the vacuum pendulum times
   !> this are those in the fluid, per mass of the bob.
   elemental real(wp) function effective_inertia(density_ratio, added_mass)
      real(wp), intent(in) :: density_ratio, added_mass

      effective_inertia = 1 + added_mass*density_ratio
   end function effective_inertia

end module kyvadlo_buoyancy
