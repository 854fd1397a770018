!> Explicit interfaces of what is called of LAPACK.
module kyvadlo_lapack
   implicit none
   private
   public :: dgeev, dgesvd

   interface
      !> Eigenvalues, and eigenvectors if asked for, of a general real matrix.
      subroutine dgeev(jobvl, jobvr, n, a, lda, wr, wi, vl, ldvl, vr, ldvr, work, lwork, info)
         use, intrinsic :: iso_fortran_env, only: real64
         implicit none
         character, intent(in) :: jobvl, jobvr           !! 'N' or 'V': left, right eigenvectors
         integer, intent(in) :: n, lda, ldvl, ldvr, lwork
         real(real64), intent(inout) :: a(lda, *)        !! (n, n), overwritten
         real(real64), intent(out) :: wr(*), wi(*)       !! (n) real and imaginary parts
         real(real64), intent(out) :: vl(ldvl, *), vr(ldvr, *)
         real(real64), intent(out) :: work(*)            !! (lwork), 3n at least without eigenvectors
         integer, intent(out) :: info                    !! 0, or why it failed
      end subroutine dgeev

      !> Singular values, descending, and the vectors asked for: a = u diag(s) vt.
      subroutine dgesvd(jobu, jobvt, m, n, a, lda, s, u, ldu, vt, ldvt, work, lwork, info)
         use, intrinsic :: iso_fortran_env, only: real64
         implicit none
         character, intent(in) :: jobu, jobvt            !! 'N': none, 'S' or 'A': of u, of vt
         integer, intent(in) :: m, n, lda, ldu, ldvt, lwork
         real(real64), intent(inout) :: a(lda, *)        !! (m, n), overwritten
         real(real64), intent(out) :: s(*), u(ldu, *), vt(ldvt, *)
         real(real64), intent(out) :: work(*)            !! (lwork), max(3 min(m, n) + max(m, n), 5 min(m, n)) at least
         integer, intent(out) :: info                    !! 0, or why it failed
      end subroutine dgesvd
   end interface

end module kyvadlo_lapack
