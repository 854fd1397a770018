!> What GSL has and FGSL 1.6 lacks, under GSL's own names: part of the facade kyvadlo_gsl whichever way it takes.
module kyvadlo_gsl_beside_fgsl
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   implicit none
   private
   public :: gsl_sf_ellint_dcomp

   interface
      function gsl_dcomp(k, mode) bind(c, name='gsl_sf_ellint_Dcomp') result(value)
         import :: c_double, c_int
         real(c_double), value :: k
         integer(c_int), value :: mode
         real(c_double) :: value
      end function gsl_dcomp
   end interface

   !> GSL_PREC_DOUBLE.
   integer(c_int), parameter :: double_precision = 0

contains

   !> Complete D(k) = (K - E)/k**2 in GSL's double precision.
   function gsl_sf_ellint_dcomp(k) result(value)
      real(c_double), intent(in) :: k
      real(c_double) :: value
      value = gsl_dcomp(k, double_precision)
   end function gsl_sf_ellint_dcomp

end module kyvadlo_gsl_beside_fgsl
