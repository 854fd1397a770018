!> The elliptic functions by GSL, for `kyvadlo bench` and `kyvadlo study`; without GSL it has no function.
module kyvadlo_function_values_gsl
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_function_ids
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl
#endif
   implicit none
   private
   public :: gsl_values

contains

   !> GSL's values at the arguments of `our_values`, with the modulus in the place of the parameter.
   subroutine gsl_values(id, x, out, has)
      integer, intent(in) :: id
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: out(:,:)
      logical, intent(out) :: has            !! GSL is here and has the function
#ifdef KYVADLO_WITH_GSL
      integer :: i, status

      has = .true.
      select case (id)
      case (id_rc)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_rc(x(i, 1), x(i, 2), fgsl_prec_double)
         end do
      case (id_rf)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_rf(x(i, 1), x(i, 2), x(i, 3), fgsl_prec_double)
         end do
      case (id_rd)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_rd(x(i, 1), x(i, 2), x(i, 3), fgsl_prec_double)
         end do
      case (id_rj)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_rj(x(i, 1), x(i, 2), x(i, 3), x(i, 4), fgsl_prec_double)
         end do
      case (id_k)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_kcomp(x(i, 1), fgsl_prec_double)
         end do
      case (id_e)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_ecomp(x(i, 1), fgsl_prec_double)
         end do
      case (id_d)
         do i = 1, size(x, 1)
            out(i, 1) = gsl_sf_ellint_dcomp(x(i, 1))
         end do
      case (id_pi)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_pcomp(x(i, 2), -x(i, 1), fgsl_prec_double)
         end do
      case (id_f)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_f(x(i, 1), x(i, 2), fgsl_prec_double)
         end do
      case (id_einc)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_e(x(i, 1), x(i, 2), fgsl_prec_double)
         end do
      case (id_dinc)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_d(x(i, 1), x(i, 2), fgsl_prec_double)
         end do
      case (id_piinc)
         do i = 1, size(x, 1)
            out(i, 1) = fgsl_sf_ellint_p(x(i, 2), x(i, 3), -x(i, 1), fgsl_prec_double)
         end do
      case (id_jacobi, id_set_up)
         do i = 1, size(x, 1)
            status = fgsl_sf_elljac_e(x(i, 1), x(i, 2), out(i, 1), out(i, 2), out(i, 3))
            if (status /= 0) out(i, 1) = huge(1.0_real64)
         end do
      case default
         has = .false.
      end select
#else
      has = .false.
      if (id < 0) out = x ! Every argument is referred to in either build.
#endif
   end subroutine gsl_values

end module kyvadlo_function_values_gsl
