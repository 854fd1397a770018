!> What the double-double kernels of the place read of an orbit: the closed form [S5.1] as polynomials, in pairs.
module kyvadlo_double_double_constants
   use, intrinsic :: iso_fortran_env, only: real64, int64
   use kyvadlo_batch_constants, only: form_scalar
   use kyvadlo_double_doubles, only: pair_type
   implicit none
   public

   !> Points are evaluated in blocks of this size, in whole groups, each point by itself; times, and what
   !> comes out, are sums of two parts.
   integer, parameter :: wide_block_size = 64, wide_group_size = 8
   !> The last harmonic: the one after it has at k**2 = 1/2 the relative size exp(-pi (25 - 5/2)), 2e-31.
   integer, parameter :: wide_harmonics = 4
   !> Half periods that count: T/2 and the turn in three parts leave 2**-159 of themselves.
   real(real64), parameter :: wide_most_halves = 2.0_real64**31

   !> As `wave_type` of kyvadlo_batch_constants.
   type :: wide_wave_type
      type(pair_type) :: cosine(0:wide_harmonics)
      type(pair_type) :: sine(0:wide_harmonics)
      type(pair_type) :: cosine_slope(0:wide_harmonics)
      type(pair_type) :: sine_slope(0:wide_harmonics)
   end type wide_wave_type

   !> Constants of one orbit with its start: as `batch_type` and `start_type`.
   type :: wide_batch_type
      integer :: form = form_scalar
      real(real64) :: half(3) = 0        !! T/2 in three parts [s]
      real(real64) :: advance(3) = 0     !! lambda T/pi, or A T/pi, in three parts: quarter turns in half a period
      type(pair_type) :: per_half        !! 2/T
      type(pair_type) :: turn            !! rho T/pi: quarter turns of the frame in half a period
      integer(int64) :: half_turns = 0   !! All bits set: the frame makes two, else one quarter turn in half a period
      integer(int64) :: top_turns = 1    !! Quarter turns added where a direct form is evaluated for a top passage
      type(pair_type) :: stretch         !! V per half period (dual)
      type(pair_type) :: diameter        !! 2 l [m]
      type(pair_type) :: rate            !! dv/dt or dV/dt [1/s]
      type(pair_type) :: turn_rate       !! rho [1/s]
      type(wide_wave_type) :: odd(0:1), even(0:1)  !! By passage: 1 bottom, 0 top (dual form only)
      type(pair_type) :: time            !! Time since an upper turning point at t = 0 [s]
      type(pair_type) :: angle           !! Start azimuth in quarter turns
      real(real64) :: mirror = 1         !! -1: momentum negative
   end type wide_batch_type
end module kyvadlo_double_double_constants
