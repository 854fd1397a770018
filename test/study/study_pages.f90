!> What the pages printed by the studies have in common.
module study_pages
   use, intrinsic :: iso_fortran_env, only: real64, output_unit
   use kyvadlo_study_csv, only: processor
   use kyvadlo_version, only: version, compiler, compiler_flags
   implicit none
   private
   public :: write_machine, number_text

contains

   !> What made the page: command, program, compiler and machine.
   subroutine write_machine(command)
      character(len=*), intent(in) :: command

      write (output_unit, '(a)') 'Printed by', '', '```sh', command, '```', '', &
         'Here: kyvadlo '//version//', '//compiler//', `'//trim(adjustl(compiler_flags))//'`, '//trim(processor())//'.', ''
   end subroutine write_machine

   !> Two or three significant digits.
   function number_text(x) result(text)
      real(real64), intent(in) :: x
      character(len=:), allocatable :: text
      character(len=32) :: line
      integer :: power

      if (.not. x < huge(x)) then
         line = 'inf'
      else if (abs(x - anint(x)) <= 0 .and. abs(x) < 1000) then
         write (line, '(i0)') nint(x)
      else if (abs(x) < 0.01_real64 .or. abs(x) >= 1000) then
         write (line, '(es12.1e4)') x
         line = adjustl(line)
         read (line(index(line, 'E') + 1:), *) power
         write (line(index(line, 'E'):), '("e", i0)') power
      else if (abs(x) < 10) then
         write (line, '(f5.2)') x
      else
         write (line, '(f6.1)') x
      end if
      text = trim(adjustl(line))
   end function number_text

end module study_pages
