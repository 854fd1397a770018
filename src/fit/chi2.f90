!> The distribution of chi2.
module kyvadlo_chi2
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: chi2_probability

contains

   !> That chi2 of n degrees of freedom is larger than x: the incomplete gamma function Q(n/2, x/2), by its series
   !> below its middle, by its continued fraction above (DLMF 8.7.1, 8.9.2, the latter by Lentz's method).
   !> NaN for NaN; 1 where there is no degree of freedom.
   elemental real(wp) function chi2_probability(x, n) result(q)
      real(wp), intent(in) :: x
      integer, intent(in) :: n
      real(wp) :: a, y, front, term, total, b, c, d
      integer :: k
      integer, parameter :: most = 100000                !! Near the middle some 6 sqrt(a) terms are needed

      q = x
      if (.not. abs(x) >= 0) return
      q = 1
      if (n < 1 .or. .not. x > 0) return
      a = n/2.0_wp
      y = x/2
      front = exp(a*log(y) - y - log_gamma(a))
      if (y < a + 1) then
         term = 1/a
         total = term
         do k = 1, most
            term = term*y/(a + k)
            total = total + term
            if (term < epsilon(y)*total) exit
         end do
         q = max(0.0_wp, 1 - front*total)
      else
         b = y + 1 - a
         c = huge(c)
         d = 1/b
         total = d
         do k = 1, most
            b = b + 2
            d = 1/(k*(a - k)*d + b)
            c = b + k*(a - k)/c
            total = total*c*d
            if (abs(c*d - 1) < epsilon(y)) exit
         end do
         q = front*total
      end if
   end function chi2_probability

end module kyvadlo_chi2
