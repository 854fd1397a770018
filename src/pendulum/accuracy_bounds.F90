!> What the position error of an orbit is at most, grade by grade of the batch kernels: the model by which
!> kyvadlo_accuracy chooses.
module kyvadlo_accuracy_bounds
   use, intrinsic :: iso_fortran_env, only: real32, real64
#ifdef KYVADLO_NO_REAL128
   ! No wider kind here: what is said of it below is never reached.
   use, intrinsic :: iso_fortran_env, only: real128 => real64
#else
   use, intrinsic :: iso_fortran_env, only: real128
#endif
   use kyvadlo_batch_constants
   use kyvadlo_numbers, only: product_or_infinity
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_pairs, only: operator(+), value
   implicit none
   private
   public :: error_bounds, half_periods, accuracy_finest_double, accuracy_finest_double_double, accuracy_finest_quad

   !> The worst position error of double precision, in l: 6.4 eps were measured (test/unit/test_batch.pf), 16 are
   !> promised.
   real(real64), parameter :: accuracy_finest_double = 16*epsilon(1.0_real64)
   !> The same of double-double arithmetic: 7e-31 were measured (test/unit/test_double_double.pf).
   real(real64), parameter :: accuracy_finest_double_double = 1e-29_real64
   !> The finest of this build: that of real128, whose series and pairs are the same to its own epsilon; with nearly
   !> four times the room: 1.2e-32, and no digit behind that.
   real(real64), parameter :: accuracy_finest_quad = min(accuracy_finest_double_double, &
      62.3_real64*real(epsilon(1.0_real128), real64))
   !> What real32 adds by rounding once the phase is reduced, in l: 3.3 eps at worst in 27000 random orbits of every
   !> regime and 24 places of each; 6 leave room.
   real(real64), parameter :: narrow_rounding = 6*real(epsilon(1.0_real32), real64)
   !> Error of T, in eps T, and of lambda T, in eps pi, where the set-up rounds them: 2.8 and 2.6 at worst in 180000
   !> random orbits of every regime; of lambda T times K/E, which `set_up_rates` loses.
   real(real64), parameter :: rough_rounding = 6
   !> V up to 20: exp(4 V) and its inverse are in the range of real32.
   real(real64), parameter :: most_stretch = 40
   real(real64), parameter :: half_pi = acos(-1.0_real64)/2

contains

   !> Bounds of the position error in l, grade by grade; huge where a grade does not apply.
   !>
   !> With P and F of [S5.1] the position is 2 l P F/(|P|**2 + |F|**2) and l (|P|**2 - |F|**2)/(the same): an error d of
   !> (P, F) moves it by at most 2 l |d|/|(P, F)|, and |P|**2 + |F|**2 = 2 l D**2. So what counts is the error of P and
   !> F beside sqrt(2 l) D, where D >= 1 - 2 q in the nome q, D >= cosh V at the bottom and D >= 1 at the top in the
   !> complementary nome.
   pure subroutine error_bounds(orbit, span, is_rough, bounds)
      type(orbit_type), intent(in) :: orbit
      real(real64), intent(in) :: span      !! [s]
      logical, intent(in) :: is_rough       !! T and lambda T are rounded by the set-up
      real(real64), intent(out) :: bounds(0:most_grade)
      real(real64) :: left_out(0:3), sensitivity, error, rounding, reduction, travel, halves
      integer :: grade

      bounds = huge(bounds)
      if (.not. is_rough) bounds(grade_full) = accuracy_finest_double
      associate (b => orbit%kernel)
         if (b%form == form_scalar) return
         halves = half_periods(orbit, span) + abs(orbit%start_phase%high)*b%per_half
         if (.not. halves <= most_halves - 1) return
         call weigh(orbit, left_out, sensitivity)
         ! What a half period moves the bob at most, in l. In half periods the reduced phase is off by half an eps of
         ! the count for each of: 2/T, the product, the sum, the start's product. The angle of the frame, in quarter
         ! turns, by as much for each of: the advance, the product, the sum.
         travel = greatest_speed(orbit)*(orbit%period()/2)/orbit%length
         reduction = halves*epsilon(1.0_real64)*(2*travel + 1.5_real64*half_pi*abs(sum(b%advance)))
         ! The stretch of a half period is pi K/2K', K at least; half of the advance falls to it.
         if (is_rough) reduction = reduction + rough_rounding*halves*epsilon(1.0_real64)*(travel &
            + half_pi*(1 + b%stretch))
         do grade = 1, most_grade
            if (grade == grade_single .and. b%stretch > most_stretch) cycle
            error = merge(grade_cosh_error(grade), grade_sine_error(grade), b%form == form_dual)
            rounding = merge(narrow_rounding, accuracy_finest_double, grade == grade_single)
            ! The sines of the frame add sqrt(2) of their error.
            bounds(grade) = rounding + reduction + left_out(grade_harmonics(grade)) + sensitivity*error &
               + sqrt(2.0_real64)*grade_sine_error(grade)
         end do
      end associate
   end subroutine error_bounds

   !> What harmonics above n are worth, and what a unit error of sine and cosine (relative, of the hyperbolic ones)
   !> does: both as position errors in l.
   pure subroutine weigh(orbit, left_out, sensitivity)
      type(orbit_type), intent(in) :: orbit
      real(real64), intent(out) :: left_out(0:3), sensitivity
      real(real64) :: scaling, step, power, u, least
      integer :: n

      associate (b => orbit%kernel, low => orbit%bottom, high => orbit%top)
         least = 1
         if (b%form /= form_dual) least = 1 - 2*orbit%series_nome
         scaling = 2/(sqrt(2*value(orbit%gaps%length))*least)
         left_out = 0
         ! exp V half a half period from the passage: V = pi K/4K', and q' = exp(-pi K/K').
         step = 1/sqrt(sqrt(max(orbit%series_nome, tiny(1.0_real64))))
         u = (step**2 + 1/step**2)/2
         do n = 3, 1, -1
            left_out(n - 1) = left_out(n)
            if (n > low%highest) cycle
            if (b%form == form_dual) then
               power = step**(2*n)
               left_out(n - 1) = left_out(n) + scaling*max( &
                  power*largest(low%p_cos(n), low%p_sin(n)) + power/step*largest(low%f_cos(n), low%f_sin(n)), &
                  power*step*largest(high%f_cos(n), high%f_sin(n)) + power*largest(high%p_cos(n), high%p_sin(n)))
            else
               left_out(n - 1) = left_out(n) &
                  + scaling*(largest(low%p_cos(n), low%p_sin(n)) + largest(low%f_cos(n), low%f_sin(n)))
            end if
         end do
         if (b%form == form_dual) then
            sensitivity = max(hyperbolic_odd(b%odd(1)), product_or_infinity(hyperbolic_odd(b%odd(0)), step)) &
               + max(hyperbolic_even(b%even(1)), hyperbolic_even(b%even(0)))
         else
            sensitivity = trigonometric_odd(b%odd(1))
            if (b%form == form_direct_odd) then
               sensitivity = sensitivity + trigonometric_odd(b%even(1))
            else
               sensitivity = sensitivity + trigonometric_even(b%even(1))
            end if
         end if
         sensitivity = scaling*sensitivity
      end associate

   contains

      !> Bound of a cos x + i b sin x, hyperbolic ones relative to cosh.
      pure real(real64) function largest(a, b)
         real(real64), intent(in) :: a, b

         largest = sqrt(a**2 + b**2)
      end function largest

      !> c (sum of a u**n) + i s (sum of b u**n) with errors e of c, s and of sine in u = 1 - 2 sine**2, |sine| <=
      !> sqrt(1/2): u is off by 2 sqrt(2) e.
      pure real(real64) function trigonometric_odd(wave)
         type(wave_type), intent(in) :: wave
         real(real64), parameter :: weights(0:3) = 1 + sqrt(8.0_real64)*[0, 1, 2, 3]

         trigonometric_odd = sum(weights*(abs(wave%cosine) + abs(wave%sine)))
      end function trigonometric_odd

      !> (sum of a u**n) + i s2 (sum of b u**n), s2 = 2 c s off by 2 sqrt(2) e.
      pure real(real64) function trigonometric_even(wave)
         type(wave_type), intent(in) :: wave
         real(real64), parameter :: weights(0:3) = sqrt(8.0_real64)*[0, 1, 2, 3]

         trigonometric_even = sum(weights*(abs(wave%cosine) + abs(wave%sine))) + sqrt(8.0_real64)*sum(abs(wave%sine))
      end function trigonometric_even

      !> Relative to cosh V. Errors e relative to cosh of the reduced argument make 3 e relative to cosh V (the sum of
      !> the exponents' cosh and sinh is at most twice the former, and cosh(n ln 2 + r) at least 2/3 of the product), 6
      !> e relative to u = cosh 2V.
      pure real(real64) function hyperbolic_odd(wave)
         type(wave_type), intent(in) :: wave

         hyperbolic_odd = grown(wave%cosine, 3, 0) + grown(wave%sine, 3, 0)
      end function hyperbolic_odd

      !> s2 = 2 c s <= u is off by 12 e u.
      pure real(real64) function hyperbolic_even(wave)
         type(wave_type), intent(in) :: wave

         hyperbolic_even = grown(wave%cosine, 0, 0) + grown(wave%sine, 12, 1)
      end function hyperbolic_even

      !> Sum of (first + 6 n) |a(n)| u**(n+power) for the largest u. What is 0 may stand beside an overflow.
      pure real(real64) function grown(a, first, power)
         real(real64), intent(in) :: a(0:3)
         integer, intent(in) :: first, power  !! 0 or 1
         real(real64) :: u_power
         integer :: n

         grown = 0
         u_power = merge(u, 1.0_real64, power == 1)
         do n = 0, 3
            if (abs(a(n)) > 0) grown = grown + product_or_infinity((first + 6*n)*abs(a(n)), u_power)
            u_power = product_or_infinity(u_power, u)
         end do
      end function grown
   end subroutine weigh

   !> The speed at the lowest point, v**2 = 2 (c1 - g z2) = 2 g (z1 + z3) [m/s].
   pure real(real64) function greatest_speed(orbit)
      type(orbit_type), intent(in) :: orbit

      associate (gaps => orbit%gaps)
         greatest_speed = scale(sqrt(2*value(gaps%gravity)*value(gaps%upper_rise + gaps%outer_excess)), &
            gaps%length_power + gaps%gravity_power)
      end associate
   end function greatest_speed

   !> Half periods in the span; 0 where there is no period.
   pure real(real64) function half_periods(orbit, span)
      type(orbit_type), intent(in) :: orbit
      real(real64), intent(in) :: span  !! [s]

      half_periods = 0
      if (orbit%period() <= huge(span)) half_periods = 2*(span/orbit%period())
   end function half_periods

end module kyvadlo_accuracy_bounds
