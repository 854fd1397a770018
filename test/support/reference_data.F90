!> Stored references and the distance from them.
!>
!> A file `test/reference/<name>.dat`, written by the `make_*.py` beside it, holds comment lines (`#`), the line
!> `columns <arguments> <results>`, and rows `<set> <bits> <argument>... <result>... <condition>...`:
!> the name of the set (regime), the kind (32, 64 or 128) in which the arguments are exact, the results to 40 digits, and
!> for each result the change, in its own ulps of that kind, that half an ulp of every argument makes in sum.
module reference_data_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32
   use reference_kinds, only: real128
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   implicit none
   private
   public :: ulps
   interface ulps
      module procedure ulps_kind
   end interface ulps
contains
#include "reference_body.inc"
end module reference_data_real32

module reference_data_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use reference_kinds, only: real128
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   implicit none
   private
   public :: ulps
   interface ulps
      module procedure ulps_kind
   end interface ulps
contains
#include "reference_body.inc"
end module reference_data_real64

#ifndef KYVADLO_NO_REAL128
module reference_data_real128
   use, intrinsic :: iso_fortran_env, only: wp => real128, real128
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   implicit none
   private
   public :: ulps
   interface ulps
      module procedure ulps_kind
   end interface ulps
contains
#include "reference_body.inc"
end module reference_data_real128
#endif

module reference_data
   use reference_kinds, only: real128
   use reference_data_real32
   use reference_data_real64
#ifndef KYVADLO_NO_REAL128
   use reference_data_real128
#endif
   implicit none
   private
   public :: ulps, read_reference, set_name_length

   integer, parameter :: set_name_length = 32

contains

   !> Reads the rows of one kind from `test/reference/<name>.dat`. Stops the test program if the file is missing, is not of
   !> the form above, or has no row of that kind and set: a test without references must not pass.
   subroutine read_reference(name, bits, arguments, results, condition, set, sets)
      character(len=*), intent(in) :: name                      !! File name without `.dat`
      integer, intent(in) :: bits                               !! 32, 64 or 128
      real(real128), allocatable, intent(out) :: arguments(:,:) !! (argument, row)
      real(real128), allocatable, intent(out) :: results(:,:)   !! (result, row)
      real(real128), allocatable, intent(out) :: condition(:,:) !! (result, row), in ulps of the kind
      character(len=*), intent(in), optional :: set             !! Only the rows of this set
      character(len=set_name_length), allocatable, intent(out), optional :: sets(:) !! Set of each row

      character(len=4096) :: line
      character(len=set_name_length) :: row_set
      integer :: unit, status, argument_count, result_count, row_bits, row, pass

      open (newunit=unit, file=name//'.dat', status='old', action='read', iostat=status)
      if (status /= 0) error stop 'read_reference: cannot open '//name//'.dat'
      do pass = 1, 2
         rewind (unit)
         row = 0
         argument_count = -1
         do
            read (unit, '(a)', iostat=status) line
            if (status /= 0) exit
            if (line(1:1) == '#' .or. line == '') cycle
            if (line(1:8) == 'columns ') then
               read (line(9:), *) argument_count, result_count
               cycle
            end if
            if (argument_count < 0) error stop 'read_reference: no columns line in '//name//'.dat'
            read (line, *) row_set, row_bits
            if (row_bits /= bits) cycle
            if (present(set)) then
               if (row_set /= set) cycle
            end if
            row = row + 1
            if (pass == 1) cycle
            read (line, *) row_set, row_bits, arguments(:, row), results(:, row), condition(:, row)
            if (present(sets)) sets(row) = row_set
         end do
         if (row == 0) error stop 'read_reference: no row of that kind and set in '//name//'.dat'
         if (pass == 1) then
            allocate (arguments(argument_count, row), results(result_count, row), condition(result_count, row))
            if (present(sets)) allocate (sets(row))
         end if
      end do
      close (unit)
   end subroutine read_reference

end module reference_data
