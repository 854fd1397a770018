!> The normal distribution's inverse: M. J. Wichura, "Algorithm AS 241: the percentage points of the normal
!> distribution", Applied Statistics 37 (1988) 477, PPND16. GSL has the same, but sweeps work without GSL too.
module kyvadlo_normal_quantile
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: infinity_real64, quiet_nan_real64
   implicit none
   private
   public :: normal_quantile

   !> Coefficients of numerator and denominator, by rising power, as published.
   real(wp), parameter :: middle_top(0:7) = [real(wp) :: 3.3871328727963666080e0_wp, 1.3314166789178437745e2_wp, &
      1.9715909503065514427e3_wp, 1.3731693765509461125e4_wp, 4.5921953931549871457e4_wp, &
      6.7265770927008700853e4_wp, 3.3430575583588128105e4_wp, 2.5090809287301226727e3_wp]
   real(wp), parameter :: middle_bottom(0:7) = [real(wp) :: 1, 4.2313330701600911252e1_wp, &
      6.8718700749205790830e2_wp, 5.3941960214247511077e3_wp, 2.1213794301586595867e4_wp, &
      3.9307895800092710610e4_wp, 2.8729085735721942674e4_wp, 5.2264952788528545610e3_wp]
   real(wp), parameter :: near_top(0:7) = [real(wp) :: 1.42343711074968357734e0_wp, 4.63033784615654529590e0_wp, &
      5.76949722146069140550e0_wp, 3.64784832476320460504e0_wp, 1.27045825245236838258e0_wp, &
      2.41780725177450611770e-1_wp, 2.27238449892691845833e-2_wp, 7.74545014278341407640e-4_wp]
   real(wp), parameter :: near_bottom(0:7) = [real(wp) :: 1, 2.05319162663775882187e0_wp, &
      1.67638483018380384940e0_wp, 6.89767334985100004550e-1_wp, 1.48103976427480074590e-1_wp, &
      1.51986665636164571966e-2_wp, 5.47593808499534494600e-4_wp, 1.05075007164441684324e-9_wp]
   real(wp), parameter :: far_top(0:7) = [real(wp) :: 6.65790464350110377720e0_wp, 5.46378491116411436990e0_wp, &
      1.78482653991729133580e0_wp, 2.96560571828504891230e-1_wp, 2.65321895265761230930e-2_wp, &
      1.24266094738807843860e-3_wp, 2.71155556874348757815e-5_wp, 2.01033439929228813265e-7_wp]
   real(wp), parameter :: far_bottom(0:7) = [real(wp) :: 1, 5.99832206555887937690e-1_wp, &
      1.36929880922735805310e-1_wp, 1.48753612908506148525e-2_wp, 7.86869131145613259100e-4_wp, &
      1.84631831751005468180e-5_wp, 1.42151175831644588870e-7_wp, 2.04426310338993978564e-15_wp]

contains

   !> The number that a standard normal variable stays below with this probability. NaN outside 0 ... 1.
   pure elemental real(wp) function normal_quantile(probability) result(x)
      real(wp), intent(in) :: probability
      real(wp) :: from_middle, r

      from_middle = probability - 0.5_wp
      if (.not. abs(from_middle) <= 0.5_wp) then
         x = quiet_nan_real64
      else if (abs(from_middle) <= 0.425_wp) then
         r = 0.180625_wp - from_middle*from_middle
         x = from_middle*ratio(middle_top, middle_bottom, r)
      else
         r = merge(probability, 1 - probability, from_middle < 0)
         if (r <= 0) then
            x = infinity_real64
         else
            r = sqrt(-log(r))
            if (r <= 5) then
               x = ratio(near_top, near_bottom, r - 1.6_wp)
            else
               x = ratio(far_top, far_bottom, r - 5)
            end if
         end if
         if (from_middle < 0) x = -x
      end if
   end function normal_quantile

   pure real(wp) function ratio(top, bottom, r)
      real(wp), intent(in) :: top(0:7), bottom(0:7), r
      real(wp) :: above, below
      integer :: i

      above = top(7)
      below = bottom(7)
      do i = 6, 0, -1
         above = above*r + top(i)
         below = below*r + bottom(i)
      end do
      ratio = above/below
   end function ratio

end module kyvadlo_normal_quantile
