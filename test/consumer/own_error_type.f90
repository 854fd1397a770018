!> A module of somebody else with an `error_type`, used beside kyvadlo.
module somebody_else
   implicit none
   private
   public :: error_type, orbit

   type :: error_type
      integer :: number = 0
   end type error_type

   real, parameter :: orbit = 1.0
end module somebody_else

program own_error_type
   use kyvadlo
   use somebody_else
   implicit none
   type(error_type) :: theirs
   type(kyvadlo_error_type), allocatable :: ours
   type(orbit_type) :: motion

   theirs%number = 3
   call new_orbit_from_heights(motion, 1d0, 9.80665d0, 0.8d0, 0.5d0*orbit, ours)
   if (.not. allocated(ours)) error stop 'an impossible orbit was accepted'
   if (ours%code /= code_domain .or. theirs%number /= 3) error stop 'the errors are mixed up'
   deallocate (ours)   ! the leak sanitizer counts what a main program keeps
   print '(a)', 'two error types live side by side'
end program own_error_type
