!> The worst errors found, by question, part of the answer, set of arguments and kind.
module errors_found
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: finding_type, findings_type, note, kinds

   integer, parameter :: kinds(3) = [32, 64, 128]

   !> One line of the table.
   type :: finding_type
      character(len=20) :: question = ''         !! Reference file
      integer :: part = 0                        !! Which of its results
      character(len=32) :: set = ''
      integer :: rows(3) = 0                     !! By kind, as in `kinds`
      real(real64) :: raw(3) = 0                 !! Worst error in units of the promise (ulps, ...)
      real(real64) :: beyond(3) = 0              !! The same after what the promise allows for the condition
   end type finding_type

   type :: findings_type
      type(finding_type), allocatable :: line(:)
   end type findings_type

contains

   !> Enters one error. NaN becomes `huge`, so that no comparison lets it pass.
   subroutine note(findings, question, part, set, bits, raw, beyond)
      type(findings_type), intent(inout) :: findings
      character(len=*), intent(in) :: question, set
      integer, intent(in) :: part, bits
      real(real64), intent(in) :: raw, beyond
      integer :: i, k

      if (.not. allocated(findings%line)) allocate (findings%line(0))
      do i = size(findings%line), 1, -1
         if (findings%line(i)%question == question .and. findings%line(i)%part == part .and. findings%line(i)%set == set) exit
      end do
      if (i == 0) then
         i = size(findings%line) + 1
         findings%line = [findings%line, finding_type(question=question, part=part, set=set)]
      end if
      k = findloc(kinds, bits, dim=1)
      associate (line => findings%line(i))
         line%rows(k) = line%rows(k) + 1
         line%raw(k) = larger(line%raw(k), raw)
         line%beyond(k) = larger(line%beyond(k), beyond)
      end associate

   contains

      real(real64) function larger(x, y)
         real(real64), intent(in) :: x, y

         larger = huge(x)
         if (y <= huge(y)) larger = max(x, y)
      end function larger
   end subroutine note

end module errors_found
