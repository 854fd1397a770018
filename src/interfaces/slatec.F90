! SLATEC's elliptic integrals (category C14) by name, order of arguments and error number, over kyvadlo's: DRC, DRF,
! DRD, DRJ and, in single precision, RC, RF, RD, RJ. A program that calls SLATEC is linked again, not edited. A library
! of its own (kyvadlo_slatec), so that nobody else meets these names. Described in doc/legacy_fortran.md.
!
! IER as SLATEC documents it, tested in its order: 1 a negative argument, 3 one above UPLIM, 2 one below LOLIM; 0 fine.
! On an error the function is 0 and SLATEC's XERMSG is called, where the program has it. NaN in gives IER 1 and NaN.

!> SLATEC's error message.
module kyvadlo_slatec_message
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_size_t
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: report

   interface
      !> In slatec_message.c: only C has weak references.
      subroutine call_xermsg(routine, routine_length, message, message_length, code) bind(c, name='kyvadlo_call_xermsg')
         import :: c_char, c_int, c_size_t
         character(kind=c_char), intent(in) :: routine(*), message(*)
         integer(c_size_t), value :: routine_length, message_length
         integer(c_int), value :: code
      end subroutine call_xermsg
   end interface

contains

   !> CALL XERMSG('SLATEC', routine, rule WHERE X = ... AND ... = ..., code, 1), the last value a limit if the rule has
   !> one; IER as the caller is to return it.
   subroutine report(routine, code, rule, values, ier)
      character(len=*), intent(in) :: routine, rule
      integer, intent(in) :: code
      real(real64), intent(in) :: values(:)
      integer, intent(out) :: ier
      character(len=*), parameter :: names(4) = ['X', 'Y', 'Z', 'P']
      character(len=200) :: text
      character(len=16) :: number
      integer :: i, used

      used = 0
      call append(rule//' WHERE')
      do i = 1, size(values)
         write (number, '(1pe15.6)') values(i)
         if (i == size(values)) call append(' AND')
         if (i < size(values) .or. code == 1) then
            call append(' '//names(i)//' = '//number)
         else
            call append(merge(' UPLIM = ', ' LOLIM = ', code == 3)//number)
         end if
      end do
      call call_xermsg(routine, len(routine, c_size_t), text, int(used, c_size_t), int(code, c_int))
      ier = code

   contains

      subroutine append(piece)
         character(len=*), intent(in) :: piece

         text(used + 1:) = piece
         used = used + len(piece)
      end subroutine append
   end subroutine report
end module kyvadlo_slatec_message

module kyvadlo_slatec_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64
   use kyvadlo_carlson, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj
   use kyvadlo_numbers_real32, only: quiet_nan
   use kyvadlo_slatec_message, only: report
#include "slatec.inc"
end module kyvadlo_slatec_real32

module kyvadlo_slatec_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64
   use kyvadlo_carlson, only: carlson_rc, carlson_rf, carlson_rd, carlson_rj
   use kyvadlo_numbers_real64, only: quiet_nan
   use kyvadlo_slatec_message, only: report
#include "slatec.inc"
end module kyvadlo_slatec_real64

!> The names. They are those that gfortran, flang and their like give to external functions.
module kyvadlo_slatec
   use, intrinsic :: iso_c_binding, only: c_double, c_float, c_int
   use kyvadlo_slatec_real32, only: checked_rc_real32 => checked_rc, checked_rf_real32 => checked_rf, &
      checked_rd_real32 => checked_rd, checked_rj_real32 => checked_rj
   use kyvadlo_slatec_real64, only: checked_rc, checked_rf, checked_rd, checked_rj
   implicit none
   private
   public :: rc, rf, rd, rj, drc, drf, drd, drj

contains

   real(c_double) function drc(x, y, ier) bind(c, name='drc_')
      real(c_double), intent(in) :: x, y
      integer(c_int), intent(out) :: ier

      drc = checked_rc(x, y, 'DRC', ier)
   end function drc

   real(c_double) function drf(x, y, z, ier) bind(c, name='drf_')
      real(c_double), intent(in) :: x, y, z
      integer(c_int), intent(out) :: ier

      drf = checked_rf(x, y, z, 'DRF', ier)
   end function drf

   real(c_double) function drd(x, y, z, ier) bind(c, name='drd_')
      real(c_double), intent(in) :: x, y, z
      integer(c_int), intent(out) :: ier

      drd = checked_rd(x, y, z, 'DRD', ier)
   end function drd

   real(c_double) function drj(x, y, z, p, ier) bind(c, name='drj_')
      real(c_double), intent(in) :: x, y, z, p
      integer(c_int), intent(out) :: ier

      drj = checked_rj(x, y, z, p, 'DRJ', ier)
   end function drj

   real(c_float) function rc(x, y, ier) bind(c, name='rc_')
      real(c_float), intent(in) :: x, y
      integer(c_int), intent(out) :: ier

      rc = checked_rc_real32(x, y, 'RC', ier)
   end function rc

   real(c_float) function rf(x, y, z, ier) bind(c, name='rf_')
      real(c_float), intent(in) :: x, y, z
      integer(c_int), intent(out) :: ier

      rf = checked_rf_real32(x, y, z, 'RF', ier)
   end function rf

   real(c_float) function rd(x, y, z, ier) bind(c, name='rd_')
      real(c_float), intent(in) :: x, y, z
      integer(c_int), intent(out) :: ier

      rd = checked_rd_real32(x, y, z, 'RD', ier)
   end function rd

   real(c_float) function rj(x, y, z, p, ier) bind(c, name='rj_')
      real(c_float), intent(in) :: x, y, z, p
      integer(c_int), intent(out) :: ier

      rj = checked_rj_real32(x, y, z, p, 'RJ', ier)
   end function rj

end module kyvadlo_slatec
