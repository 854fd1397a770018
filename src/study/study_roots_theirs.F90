!> The roots of z**3 + b z**2 + c z + d as others find them: Cardano's angles, GSL's cubic, LAPACK's eigenvalues.
module kyvadlo_study_roots_theirs
   use, intrinsic :: iso_fortran_env, only: real64
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl, only: fgsl_poly_solve_cubic
   use kyvadlo_lapack, only: dgeev
#endif
   implicit none
   private
   public :: roots_by_cardano, roots_by_gsl, roots_by_lapack

contains

   !> Three real roots by the cosine of a third of an angle (F. Viete, 1615; Cardano's casus irreducibilis).
   subroutine roots_by_cardano(coefficients, roots, has_failed)
      real(real64), intent(in) :: coefficients(3)  !! b, c, d
      real(real64), intent(out) :: roots(3)        !! Ascending
      logical, intent(inout) :: has_failed
      real(real64), parameter :: third_of_turn = 2*acos(-1.0_real64)/3
      real(real64) :: q, r, angle

      associate (b => coefficients(1), c => coefficients(2), d => coefficients(3))
         q = (b*b - 3*c)/9
         r = (2*b**3 - 9*b*c + 27*d)/54
         if (.not. q > 0) then
            has_failed = .true.
            roots = 0
            return
         end if
         ! Rounding may carry the cosine of nearly equal roots beyond 1.
         angle = acos(max(-1.0_real64, min(r/sqrt(q**3), 1.0_real64)))/3
         roots = -2*sqrt(q)*cos([angle, angle - third_of_turn, angle + third_of_turn]) - b/3
      end associate
   end subroutine roots_by_cardano

   !> GSL finds one root or three; one is a failure here.
   subroutine roots_by_gsl(coefficients, roots, has_failed)
      real(real64), intent(in) :: coefficients(3)
      real(real64), intent(out) :: roots(3)
      logical, intent(inout) :: has_failed
#ifdef KYVADLO_WITH_GSL
      roots = 0
      if (fgsl_poly_solve_cubic(coefficients(1), coefficients(2), coefficients(3), roots(1), roots(2), roots(3)) /= 3) &
         has_failed = .true.
#else
      roots = 0*coefficients
      has_failed = .true.
#endif
   end subroutine roots_by_gsl

   !> Eigenvalues of the companion matrix; of a pair that comes out complex the real part.
   subroutine roots_by_lapack(coefficients, roots, has_failed)
      real(real64), intent(in) :: coefficients(3)
      real(real64), intent(out) :: roots(3)
      logical, intent(inout) :: has_failed
#ifdef KYVADLO_WITH_GSL
      ! 34 n is plenty: dhseqr asks for 11 n
      real(real64) :: matrix(3, 3), imaginary(3), left(1, 1), right(1, 1), work(34*3)
      integer :: info

      matrix(1, :) = -coefficients
      matrix(2, :) = [1, 0, 0]
      matrix(3, :) = [0, 1, 0]
      call dgeev('N', 'N', 3, matrix, 3, roots, imaginary, left, 1, right, 1, work, size(work), info)
      if (info /= 0) has_failed = .true.
      if (roots(1) > roots(2)) roots(:2) = roots(2:1:-1)
      if (roots(2) > roots(3)) roots(2:) = roots(3:2:-1)
      if (roots(1) > roots(2)) roots(:2) = roots(2:1:-1)
#else
      roots = 0*coefficients
      has_failed = .true.
#endif
   end subroutine roots_by_lapack

end module kyvadlo_study_roots_theirs
