!> The right-hand sides that GSL's own driver is given in effects_table: Newton's equations with the force of the rod, and
!> nothing for the surface, for works, for contacts. Of one effect each, as short as they can be written; where that would be the
!> library's procedure over again, that procedure.
module bare_equations
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_ptr
   use kyvadlo_effects, only: effects_type
   use kyvadlo_forces, only: forces_type, move
   implicit none
   private
   public :: bare_rod, bare_air, bare_earth, bare_shaken, bare_spring, bare_any

   type :: state_type
      real(c_double) :: x, y, z, u, v, w
   end type state_type

contains

   function bare_rod(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: pull

      call see(y, dydt, params, s, d, forces)
      pull = (s%u**2 + s%v**2 + s%w**2 - forces%weight*s%z)/(s%x**2 + s%y**2 + s%z**2)
      d = state_type(s%u, s%v, s%w, -pull*s%x, -pull*s%y, -pull*s%z - forces%weight)
      status = merge(0_c_int, 1_c_int, t >= 0)
   end function bare_rod

   function bare_air(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: pull, a, b, c, drag

      call see(y, dydt, params, s, d, forces)
      a = s%u - forces%effects%wind(1)
      b = s%v - forces%effects%wind(2)
      c = s%w - forces%effects%wind(3)
      drag = forces%effects%linear_drag + forces%effects%quadratic_drag*sqrt(a**2 + b**2 + c**2)
      a = -drag*a
      b = -drag*b
      c = -drag*c - forces%weight
      pull = (s%u**2 + s%v**2 + s%w**2 + a*s%x + b*s%y + c*s%z)/(s%x**2 + s%y**2 + s%z**2)
      d = state_type(s%u, s%v, s%w, a - pull*s%x, b - pull*s%y, c - pull*s%z)
      status = merge(0_c_int, 1_c_int, t >= 0)
   end function bare_air

   function bare_earth(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: pull, a, b, c

      call see(y, dydt, params, s, d, forces)
      associate (turn => forces%effects%turn_rate)
         a = -2*(turn(2)*s%w - turn(3)*s%v)
         b = -2*(turn(3)*s%u - turn(1)*s%w)
         c = -2*(turn(1)*s%v - turn(2)*s%u) - forces%weight
      end associate
      pull = (s%u**2 + s%v**2 + s%w**2 + a*s%x + b*s%y + c*s%z)/(s%x**2 + s%y**2 + s%z**2)
      d = state_type(s%u, s%v, s%w, a - pull*s%x, b - pull*s%y, c - pull*s%z)
      status = merge(0_c_int, 1_c_int, t >= 0)
   end function bare_earth

   !> A pivot that moves along x.
   function bare_shaken(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: pull, a, rate
      real(c_double), parameter :: two_pi = 2*acos(-1.0_c_double)

      call see(y, dydt, params, s, d, forces)
      rate = two_pi*forces%effects%pivot_frequency(1)
      a = forces%effects%pivot_amplitude(1)*rate**2*cos(rate*t + forces%effects%pivot_phase(1))
      pull = (s%u**2 + s%v**2 + s%w**2 + a*s%x - forces%weight*s%z)/(s%x**2 + s%y**2 + s%z**2)
      d = state_type(s%u, s%v, s%w, a - pull*s%x, -pull*s%y, -pull*s%z - forces%weight)
      status = 0
   end function bare_shaken

   function bare_spring(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: pull

      call see(y, dydt, params, s, d, forces)
      pull = forces%effects%stiffness*(1 - forces%suspension%radius/sqrt(s%x**2 + s%y**2 + s%z**2))
      d = state_type(s%u, s%v, s%w, -pull*s%x, -pull*s%y, -pull*s%z - forces%weight)
      status = merge(0_c_int, 1_c_int, t >= 0)
   end function bare_spring

   !> Whatever the library evaluates.
   function bare_any(t, y, dydt, params) bind(c) result(status)
      real(c_double), value :: t
      type(c_ptr), value :: y, dydt, params
      integer(c_int) :: status
      type(state_type), pointer :: s, d
      type(forces_type), pointer :: forces
      real(c_double) :: acceleration(3), tension, powers(2)

      call see(y, dydt, params, s, d, forces)
      call move(forces, .true., t, [s%x, s%y, s%z], [s%u, s%v, s%w], acceleration, tension, powers)
      d = state_type(s%u, s%v, s%w, acceleration(1), acceleration(2), acceleration(3))
      status = 0
   end function bare_any

   subroutine see(y, dydt, params, s, d, forces)
      type(c_ptr), intent(in) :: y, dydt, params
      type(state_type), pointer, intent(out) :: s, d
      type(forces_type), pointer, intent(out) :: forces

      call c_f_pointer(y, s)
      call c_f_pointer(dydt, d)
      call c_f_pointer(params, forces)
   end subroutine see

end module bare_equations
