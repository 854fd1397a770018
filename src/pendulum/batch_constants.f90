!> What the kernels of the place read of an orbit: the closed form [S5.1] as polynomials, in real64.
module kyvadlo_batch_constants
   use, intrinsic :: iso_fortran_env, only: real64, int64
   implicit none
   public

   !> Points are evaluated in blocks of this size, each by itself: the outcome for a time does not depend on its
   !> neighbours.
   integer, parameter :: block_size = 256
   !> The kernels work on whole groups; the last block is filled up with zeros to one.
   integer, parameter :: group_size = 16
   !> Half periods a kernel counts: the first parts of T/2 and of the turn have 53 - 32 bits, so that their products
   !> with the count are exact.
   real(real64), parameter :: most_halves = 2.0_real64**31
   integer, parameter :: part_bits = 21

   integer, parameter :: form_scalar = 0       !! No closed form in polynomials: separatrix, rest, no orbit
   integer, parameter :: form_direct_even = 1  !! Nome q, F in even multiples
   integer, parameter :: form_direct_odd = 2   !! Nome q, F in odd multiples ("rot")
   integer, parameter :: form_dual = 3         !! Nome q', bottom and top

   !> What the kernels leave out for a lower accuracy: kyvadlo_accuracy chooses, batch_kernel.inc tells what.
   !> grade_single computes in real32 once the phase is reduced, which it does in real64.
   integer, parameter :: grade_full = 0, grade_single = 1, grade_short = 2, most_grade = 2
   !> Harmonics above these are left out.
   integer, parameter :: grade_harmonics(0:most_grade) = [3, 2, 2]
   !> The largest errors of sine and cosine, and of cosh and sinh relative to cosh, as printed in
   !> batch_polynomials*.inc; with |sin| <= 0.7072, sinh/cosh <= 0.3334.
   real(real64), parameter :: grade_sine_error(0:most_grade) = [real(real64) :: 2.8e-17, 2.5e-8, 3.4e-12]
   real(real64), parameter :: grade_cosh_error(0:most_grade) = [real(real64) :: 1.2e-17, 7.4e-9, 1.6e-12]

   !> With u = cos 2v (cosh 2V in the dual form) and c, s the cosine and sine of v (V), s2 = 2 s c, coefficients of u**0
   !> ... u**3: an odd function is c*cosine(u) + i s*sine(u), an even one cosine(u) + i s2*sine(u).
   type :: wave_type
      real(real64) :: cosine(0:3) = 0        !! Even part
      real(real64) :: sine(0:3) = 0          !! Odd part
      real(real64) :: cosine_slope(0:3) = 0  !! Derivative of the even part: times s, or s2
      real(real64) :: sine_slope(0:3) = 0    !! Derivative of the odd part: times c, or 1
   end type wave_type

   !> Many orbits at once. Their gaps: l - z1, l + z2, l + z1, l - z2, -(z1 + z2), z1 - z2.
   integer, parameter :: gap_upper = 1, gap_lower_rise = 2, gap_upper_rise = 3, gap_lower = 4, gap_deficit = 5, &
      gap_swing = 6, gap_columns = 6
   !> Their constants: those that `eval orbit` prints, in its order; z3 - l, z3 - z1.
   integer, parameter :: constant_period = 1, constant_modulus = 2, constant_complementary_modulus = 3, &
      constant_quarter_period = 4, constant_nome = 5, constant_azimuth_rate = 6, constant_azimuth_per_period = 7, &
      constant_advance = 8, constant_outer_excess = 9, constant_outer_gap = 10, constant_columns = 10, &
      printed_constants = 8
   !> Their places: x, y, z, vx, vy, vz; positive where the kernel applies.
   integer, parameter :: place_kept = 7, place_columns = 7
   !> Polynomials in u = cos 2v, by row the power, of cos 2nv; sin 2nv/sin 2v; cos (2n+1)v/cos v; sin (2n+1)v/sin v.
   real(real64), parameter :: even_cosines(0:3, 0:3) = reshape([real(real64) :: &
      1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 2, 0, 0, -3, 0, 4], [4, 4])
   real(real64), parameter :: even_sines(0:3, 0:3) = reshape([real(real64) :: &
      0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, -1, 0, 4, 0], [4, 4])
   real(real64), parameter :: odd_cosines(0:3, 0:3) = reshape([real(real64) :: &
      1, 0, 0, 0, -1, 2, 0, 0, -1, -2, 4, 0, 1, -4, -4, 8], [4, 4])
   real(real64), parameter :: odd_sines(0:3, 0:3) = reshape([real(real64) :: &
      1, 0, 0, 0, 1, 2, 0, 0, -1, 2, 4, 0, -1, -4, 4, 8], [4, 4])

   !> Constants of one orbit, but for its start.
   type :: batch_type
      integer :: form = form_scalar
      integer :: grade = grade_full
      real(real64) :: per_half = 0       !! 2/T
      real(real64) :: half(3) = 0        !! T/2 in three parts
      real(real64) :: advance(3) = 0     !! lambda T/pi, or A T/pi, in three parts: quarter turns in half a period
      real(real64) :: turn = 0           !! rho T/pi: quarter turns of the frame in half a period
      integer(int64) :: half_turns = 0   !! All bits set: the frame makes two, else one quarter turn in half a period
      integer(int64) :: top_turns = 1    !! Quarter turns added where a direct form is evaluated for a top passage
      real(real64) :: stretch = 0        !! V per half period (dual)
      real(real64) :: diameter = 0       !! 2 l [m]
      real(real64) :: rate = 0           !! dv/dt or dV/dt [1/s]
      real(real64) :: turn_rate = 0      !! rho [1/s]
      !> P and F of [S5.1], up to a common factor, by passage: 1 bottom, 0 top (dual form only). At the bottom P is
      !> `odd` and F `even` ("even" only in name for `form_direct_odd`), at the top F is `odd` and P `even`.
      type(wave_type) :: odd(0:1), even(0:1)
   end type batch_type

   !> Where an orbit starts.
   type :: start_type
      real(real64) :: time(2) = 0        !! Time since an upper turning point at t = 0, two parts [s]
      real(real64) :: angle = 0          !! Start azimuth in quarter turns
      real(real64) :: mirror = 1         !! -1: momentum negative
   end type start_type
end module kyvadlo_batch_constants
