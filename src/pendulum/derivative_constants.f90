!> What the kernels of the derivatives read of an orbit: a passage and four changes of it as polynomials,
!> in real64 (derivatives.inc fills it in).
module kyvadlo_derivative_constants
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_batch_constants, only: batch_type, start_type
   implicit none
   public

   !> Times a kernel takes at once: what it keeps in between stays in the first cache.
   integer, parameter :: lanes = 32

   !> Powers of a short time: the nearest pole, at i K' in w, is about four times as far as this, and 4**(-n)
   !> below epsilon.
   integer, parameter :: most_short = 36

   !> Columns at most that have a direction to themselves: l, g and two start values, or g of a state.
   integer, parameter :: most_own = 4

   !> A series of [S5.1], or its change along a direction. Direct: `parts`, polynomials in u = cos 2v, whose sums times
   !> m1 or m2 (c and s, cosine and sine of v, for odd powers; 1 and 2 s c for even ones) make, of real coefficients: 1
   !> the real part by m1, 2 the imaginary one by m2, 3 and 4 real and imaginary part of the slope by m2 and m1; of
   !> imaginary ones: 5 the imaginary part by m1, 6 the real one by m2, 7 and 8 imaginary and real part of the slope by
   !> m2 and m1. Dual: 1, 2 real and imaginary part in powers of exp(2V), 3, 4 in those of exp(-2V), 5 to 8 the slope,
   !> times m1 and m2 (exp(V) and exp(-V) for odd powers, 1 and exp(-2V) for even ones).
   type :: series_type
      real(real64) :: parts(0:3, 8) = 0
   end type series_type

   !> One passage, or the motion in the direct form.
   type :: passage_type
      logical :: is_dual = .false., p_is_odd = .true., f_is_odd = .false.
      type(series_type) :: p(0:4), f(0:4)                                  !! The motion; its changes
      real(real64) :: rate = 0, turn = 0                                   !! dv/dt, dpsi/dt [1/s]
      real(real64) :: rate_change(4) = 0, turn_change(4) = 0
      !> Coordinates of the columns of a state's six numbers, in the units of these: constant, per second, per whole
      !> period.
      real(real64) :: weights(4, 6, 0:2)
      !> The directions that columns have to themselves, in the units of these, with the unit of time; what grows of
      !> them along the motion and around the vertical, per second and per whole period.
      type(series_type) :: own_p(most_own), own_f(most_own)
      real(real64), dimension(most_own) :: own_rate = 0, own_turn = 0
      real(real64), dimension(2, most_own) :: along = 0, around = 0
   end type passage_type

   !> What all passages share.
   type :: frame_type
      type(batch_type) :: b
      type(start_type) :: start
      integer :: columns = 0                    !! 9 from a state, else 5
      logical :: wanted(9) = .false.            !! Columns; that of t is always there
      integer :: own = 0, own_columns(most_own) = 0  !! Columns with directions to themselves
      logical :: by_angle = .false.             !! They grow along p(2), f(2), not along the motion
      integer :: length_at = 0, gravity_at = 0  !! Columns of l and g
      real(real64) :: length = 0, rate_square = 0, unit_time = 0, length_per_gravity = 0  !! l, g/l, sqrt(l/g), l/g
      !> Of fast motions: what the energy over l changes by with each column, in their units [m/s2/unit]
      logical :: is_fast = .false.
      real(real64) :: energies(9) = 0
      !> Below it the column of g by powers of the time in sqrt(l/g)
      real(real64) :: short_time = 0, short_powers(3, 2:most_short)
   end type frame_type
end module kyvadlo_derivative_constants
