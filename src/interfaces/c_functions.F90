!> The elliptic functions for C, in double precision: kyvadlo_ before the Fortran name, arguments by value.
!>
!> One procedure a function, each made from `c_scalar.inc`; documented in kyvadlo.h.
module kyvadlo_c_functions
   use, intrinsic :: iso_c_binding, only: c_double
   use kyvadlo
   implicit none
   private
   public :: kyvadlo_sncndn, kyvadlo_sncndnc
   public :: kyvadlo_elliptic_k
   public :: kyvadlo_elliptic_kc
   public :: kyvadlo_elliptic_e
   public :: kyvadlo_elliptic_ec
   public :: kyvadlo_elliptic_d
   public :: kyvadlo_elliptic_dc
   public :: kyvadlo_elliptic_b
   public :: kyvadlo_elliptic_bc
   public :: kyvadlo_elliptic_nome
   public :: kyvadlo_elliptic_nomec
   public :: kyvadlo_carlson_rc
   public :: kyvadlo_elliptic_pi
   public :: kyvadlo_elliptic_pic
   public :: kyvadlo_elliptic_f
   public :: kyvadlo_elliptic_fc
   public :: kyvadlo_elliptic_einc
   public :: kyvadlo_elliptic_eincc
   public :: kyvadlo_elliptic_dinc
   public :: kyvadlo_elliptic_dincc
   public :: kyvadlo_elliptic_binc
   public :: kyvadlo_elliptic_bincc
   public :: kyvadlo_jacobi_zeta
   public :: kyvadlo_jacobi_zetac
   public :: kyvadlo_heuman_lambda
   public :: kyvadlo_heuman_lambdac
   public :: kyvadlo_carlson_rf
   public :: kyvadlo_carlson_rd
   public :: kyvadlo_carlson_rg
   public :: kyvadlo_elliptic_piinc
   public :: kyvadlo_elliptic_piincc
   public :: kyvadlo_carlson_rj

contains

#define c_name kyvadlo_elliptic_k
#define f_name elliptic_k
#define f_arguments m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_kc
#define f_name elliptic_kc
#define f_arguments mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_e
#define f_name elliptic_e
#define f_arguments m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_ec
#define f_name elliptic_ec
#define f_arguments mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_d
#define f_name elliptic_d
#define f_arguments m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_dc
#define f_name elliptic_dc
#define f_arguments mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_b
#define f_name elliptic_b
#define f_arguments m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_bc
#define f_name elliptic_bc
#define f_arguments mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_nome
#define f_name elliptic_nome
#define f_arguments m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_nomec
#define f_name elliptic_nomec
#define f_arguments mc
#include "c_scalar.inc"

#define c_name kyvadlo_carlson_rc
#define f_name carlson_rc
#define f_arguments x, y
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_pi
#define f_name elliptic_pi
#define f_arguments n, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_pic
#define f_name elliptic_pic
#define f_arguments n, mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_f
#define f_name elliptic_f
#define f_arguments phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_fc
#define f_name elliptic_fc
#define f_arguments phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_einc
#define f_name elliptic_einc
#define f_arguments phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_eincc
#define f_name elliptic_eincc
#define f_arguments phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_dinc
#define f_name elliptic_dinc
#define f_arguments phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_dincc
#define f_name elliptic_dincc
#define f_arguments phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_binc
#define f_name elliptic_binc
#define f_arguments phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_bincc
#define f_name elliptic_bincc
#define f_arguments phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_jacobi_zeta
#define f_name jacobi_zeta
#define f_arguments u, m
#include "c_scalar.inc"

#define c_name kyvadlo_jacobi_zetac
#define f_name jacobi_zetac
#define f_arguments u, mc
#include "c_scalar.inc"

#define c_name kyvadlo_heuman_lambda
#define f_name heuman_lambda
#define f_arguments phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_heuman_lambdac
#define f_name heuman_lambdac
#define f_arguments phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_carlson_rf
#define f_name carlson_rf
#define f_arguments x, y, z
#include "c_scalar.inc"

#define c_name kyvadlo_carlson_rd
#define f_name carlson_rd
#define f_arguments x, y, z
#include "c_scalar.inc"

#define c_name kyvadlo_carlson_rg
#define f_name carlson_rg
#define f_arguments x, y, z
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_piinc
#define f_name elliptic_piinc
#define f_arguments n, phi, m
#include "c_scalar.inc"

#define c_name kyvadlo_elliptic_piincc
#define f_name elliptic_piincc
#define f_arguments n, phi, mc
#include "c_scalar.inc"

#define c_name kyvadlo_carlson_rj
#define f_name carlson_rj
#define f_arguments x, y, z, p
#include "c_scalar.inc"

   pure subroutine kyvadlo_sncndn(argument, parameter, sn, cn, dn, am) bind(c)
      real(c_double), value :: argument, parameter
      real(c_double), intent(out) :: sn, cn, dn, am

      call jacobi_functions(argument, parameter, sn, cn, dn, am)
   end subroutine kyvadlo_sncndn

   pure subroutine kyvadlo_sncndnc(argument, complementary_parameter, sn, cn, dn, am) bind(c)
      real(c_double), value :: argument, complementary_parameter
      real(c_double), intent(out) :: sn, cn, dn, am

      call jacobi_functionsc(argument, complementary_parameter, sn, cn, dn, am)
   end subroutine kyvadlo_sncndnc

end module kyvadlo_c_functions
