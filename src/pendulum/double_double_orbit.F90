!> Sets up what the double-double kernels read of an orbit: gaps, T and the advance in three parts, the theta series in
!> pairs, all in real64. The formulas are those of `kyvadlo_orbit`, from the same source.
module kyvadlo_double_double_orbit
   use, intrinsic :: iso_fortran_env, only: wp => real64, cp => real64, int64
   use kyvadlo_batch_constants, only: form_direct_even, form_direct_odd, form_dual
   use kyvadlo_double_double_constants, only: wide_batch_type, wide_wave_type, &
      wide_harmonics
   use kyvadlo_double_double_angle, only: quarter_turns
   use kyvadlo_double_double_numbers, number_type => pair_type
   use kyvadlo_gaps_double_double
   use kyvadlo_motion_kinds
   use kyvadlo_double_doubles, only: pi_number => pi_pair
   use kyvadlo_three_part, triple_value => value
   implicit none
   private
   public :: orbit_type, harmonics_type, set_up, set_kernel, value

   !> As in `kyvadlo_orbit`.
   type :: harmonics_type
      integer :: highest = 0
      logical :: p_is_odd = .true., f_is_odd = .false., d_is_odd = .false.
      type(number_type), dimension(0:most_harmonics) :: p_cos, p_sin, f_cos, f_sin, d_cos
   end type harmonics_type

   !> What of the `orbit_type` of `kyvadlo_orbit` its set-up writes.
   type :: orbit_type
      integer :: motion = motion_none
      logical :: is_dual = .false., is_rotation_like = .false.
      type(gaps_type) :: gaps
      type(pair_type) :: root_outer_swing, mean, period_pair, advance, rate_period
      type(number_type) :: parameter, complementary_parameter, series_nome, stretch, turn_period
      type(number_type) :: eta1, eta1_star, eta, eta_star, eta_growth, eta1_star_loss
      type(number_type) :: sin_x, cos_x, sin_x1, cos_x1
      integer :: terms(2) = 0
      type(harmonics_type) :: bottom, top
   end type orbit_type

   interface value
      module procedure rounded_to_pair
   end interface value
   interface atan2
      module procedure arctangent
   end interface atan2
   interface operator(+)
      module procedure plus_pair
   end interface operator(+)

   integer, parameter :: highest_harmonic = wide_harmonics
   real(cp), parameter :: finest = epsilon(1.0_cp)**2
   type(number_type), parameter :: pi = pi_number
   !> A gap below has no third part.
   real(cp), parameter :: least_gap = 2.0_cp**(-700)

   !> Polynomials in u = cos 2v, by row the power, of cos 2nv; sin 2nv/sin 2v; cos (2n+1)v/cos v; sin (2n+1)v/sin v.
   real(cp), parameter :: even_cosines(0:4, 0:4) = reshape([real(cp) :: &
      1, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0, 2, 0, 0, 0, -3, 0, 4, 0, 1, 0, -8, 0, 8], [5, 5])
   real(cp), parameter :: even_sines(0:4, 0:4) = reshape([real(cp) :: &
      0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 0, -1, 0, 4, 0, 0, 0, -4, 0, 8, 0], [5, 5])
   real(cp), parameter :: odd_cosines(0:4, 0:4) = reshape([real(cp) :: &
      1, 0, 0, 0, 0, -1, 2, 0, 0, 0, -1, -2, 4, 0, 0, 1, -4, -4, 8, 0, 1, 4, -12, -8, 16], [5, 5])
   real(cp), parameter :: odd_sines(0:4, 0:4) = reshape([real(cp) :: &
      1, 0, 0, 0, 0, 1, 2, 0, 0, 0, -1, 2, 4, 0, 0, -1, -4, 4, 8, 0, 1, -4, -12, 8, 16], [5, 5])

contains

   !> T, the advance and the series of an orbit from its gaps, as `set_up` of `kyvadlo_orbit`; `motion_none` where there
   !> is no closed form, or where it is out of range.
   pure subroutine set_up(orbit, gaps)
      type(orbit_type), intent(out) :: orbit
      type(gaps_type), intent(in) :: gaps
      type(pair_type) :: outer_gap, outer_swing
      real(cp) :: most_small

      orbit%gaps = gaps
      outer_gap = gaps%outer_excess + gaps%upper_gap
      outer_swing = gaps%outer_excess + gaps%lower_gap
      most_small = min(smallness(outer_gap), smallness(gaps%upper_rise), smallness(gaps%lower_rise), &
         smallness(gaps%upper_gap), smallness(gaps%outer_excess), smallness(gaps%swing))
      if (.not. outer_gap%high > 0 .or. most_small < least_gap) return
      if (.not. gaps%swing%high > 0) then
         if (.not. gaps%upper_rise%high > 0) return
         orbit%motion = motion_conical
      else if (gaps%lower_rise%high > 0) then
         orbit%motion = motion_generic
      else
         orbit%motion = merge(motion_plane_libration, motion_plane_rotation, gaps%upper_gap%high > 0)
      end if
      orbit%root_outer_swing = sqrt(outer_swing)
      orbit%parameter = value(gaps%swing/outer_swing)
      orbit%complementary_parameter = value(outer_gap/outer_swing)
      orbit%is_dual = orbit%parameter > 0.5_cp
      orbit%is_rotation_like = gaps%upper_gap < gaps%outer_excess
      call rates_in_three_parts(orbit, sqrt(outer_gap))
      if (orbit%is_dual) then
         call set_up_dual(orbit, value(outer_gap))
      else
         call set_up_direct(orbit, value(outer_gap))
      end if

   contains

      !> The gap, of none 1.
      pure real(cp) function smallness(gap)
         type(pair_type), intent(in) :: gap

         smallness = 1
         if (abs(gap%high) > 0) smallness = abs(gap%high)
      end function smallness
   end subroutine set_up

   !> The constants of the kernels, as `set_up_kernel` of `kyvadlo_orbit`.
   pure subroutine set_kernel(b, orbit)
      type(wide_batch_type), intent(out) :: b
      type(orbit_type), intent(in) :: orbit
      type(pair_type) :: turns
      integer :: side  !! 1 for hyperbolic functions, whose derivatives keep the sign, else -1

      side = merge(1, -1, orbit%is_dual)
      turns = scaled(orbit%period_pair, -1)
      b%half = [turns%high, turns%low, turns%lowest]
      b%per_half = value(pair(1.0_cp)/turns)
      turns = orbit%advance
      if (orbit%is_rotation_like) turns = orbit%rate_period
      turns = turns/pi_pair
      b%advance = [turns%high, turns%low, turns%lowest]
      b%half_turns = merge(-1_int64, 0_int64, orbit%is_rotation_like)
      b%diameter = value(scaled(orbit%gaps%length, 2*orbit%gaps%length_power + 1))
      b%turn = orbit%turn_period/pi
      b%rate = pi*b%per_half/2
      if (orbit%motion == motion_conical) then
         b%form = form_direct_even
         b%turn = value(orbit%advance/pi_pair)
         b%odd(1)%cosine(0) = sqrt(value(orbit%gaps%upper_rise))
         b%odd(1)%sine(0) = b%odd(1)%cosine(0)
         b%odd(1)%cosine_slope(0) = -b%odd(1)%cosine(0)
         b%odd(1)%sine_slope(0) = b%odd(1)%cosine(0)
         b%even(1)%cosine(0) = sqrt(value(orbit%gaps%upper_gap))
      else if (orbit%is_dual) then
         b%form = form_dual
         b%stretch = orbit%stretch/2
         b%rate = b%stretch*b%per_half
         call set_odd_wave(b%odd(1), orbit%bottom%p_cos, orbit%bottom%p_sin)
         call set_even_wave(b%even(1), orbit%bottom%f_cos, orbit%bottom%f_sin)
         call set_odd_wave(b%odd(0), orbit%top%f_cos, orbit%top%f_sin)
         call set_even_wave(b%even(0), orbit%top%p_cos, orbit%top%p_sin)
      else
         b%form = merge(form_direct_odd, form_direct_even, orbit%bottom%f_is_odd)
         if (orbit%bottom%f_is_odd) b%top_turns = 2
         call set_odd_wave(b%odd(1), orbit%bottom%p_cos, orbit%bottom%p_sin)
         if (orbit%bottom%f_is_odd) then
            call set_odd_wave(b%even(1), orbit%bottom%f_cos, orbit%bottom%f_sin)
         else
            call set_even_wave(b%even(1), orbit%bottom%f_cos, orbit%bottom%f_sin)
         end if
      end if
      b%turn_rate = b%turn*(pi*b%per_half/2)

   contains

      !> Sum of c(n) cos (2n+1)v + i s(n) sin (2n+1)v, hyperbolic in the dual form.
      pure subroutine set_odd_wave(wave, c, s)
         type(wide_wave_type), intent(inout) :: wave
         type(number_type), intent(in) :: c(0:), s(0:)
         integer, parameter :: multiples(0:wide_harmonics) = [1, 3, 5, 7, 9]

         wave%cosine = powers(odd_cosines, c(:wide_harmonics))
         wave%sine = powers(odd_sines, s(:wide_harmonics))
         wave%cosine_slope = powers(odd_sines, side*multiples*c(:wide_harmonics))
         wave%sine_slope = powers(odd_cosines, multiples*s(:wide_harmonics))
      end subroutine set_odd_wave

      !> Sum of c(n) cos 2nv + i s(n) sin 2nv, hyperbolic in the dual form.
      pure subroutine set_even_wave(wave, c, s)
         type(wide_wave_type), intent(inout) :: wave
         type(number_type), intent(in) :: c(0:), s(0:)
         integer, parameter :: multiples(0:wide_harmonics) = [0, 2, 4, 6, 8]

         wave%cosine = powers(even_cosines, c(:wide_harmonics))
         wave%sine = powers(even_sines, s(:wide_harmonics))
         wave%cosine_slope = powers(even_sines, side*multiples*c(:wide_harmonics))
         wave%sine_slope = powers(even_cosines, multiples*s(:wide_harmonics))
      end subroutine set_even_wave

      !> matmul(matrix, weights) without its zeros.
      pure function powers(matrix, weights) result(total)
         real(cp), intent(in) :: matrix(0:wide_harmonics, 0:wide_harmonics)
         type(number_type), intent(in) :: weights(0:wide_harmonics)
         type(number_type) :: total(0:wide_harmonics)
         integer :: i, n

         do n = 0, wide_harmonics
            do i = 0, n
               if (abs(matrix(i, n)) > 0) total(i) = total(i) + weights(n)*matrix(i, n)
            end do
         end do
      end function powers
   end subroutine set_kernel

   !> In two parts.
   elemental type(number_type) function rounded_to_pair(p) result(x)
      type(pair_type), intent(in) :: p

      x%high = p%high + p%low
      x%low = (p%low - (x%high - p%high)) + p%lowest
   end function rounded_to_pair

   elemental type(pair_type) function plus_pair(a, b) result(s)
      type(pair_type), intent(in) :: a
      type(number_type), intent(in) :: b

      s = a + pair_type(b%high, b%low)
   end function plus_pair

   elemental type(number_type) function arctangent(y, x) result(angle)
      type(number_type), intent(in) :: y, x

      angle = quarter_turns(y, x)*pi/2
   end function arctangent

#define number type(pair_type)
#define rates_name rates_in_three_parts
#include "orbit_rates.inc"
#define real_number type(number_type)
#define numbers_are_pairs
#include "orbit_series.inc"
end module kyvadlo_double_double_orbit
