!> A program of somebody else that needs the core only.
program with_core
   use kyvadlo
   implicit none
   type(error_type), allocatable :: error

   ! K(1/2) = RF(0, 1/2, 1) = 1.8540746773013719...
   call check(elliptic_k(0.5_real64))
   call check(carlson_rf(0.0_real64, 0.5_real64, 1.0_real64))
   call fail(error, code_domain, 'with_core: made to fail')
   if (error%code /= code_domain) error stop 'another code came back'
   deallocate (error)   ! the leak sanitizer counts what a main program keeps

contains

   subroutine check(value)
      real(real64), intent(in) :: value
      if (.not. abs(value - 1.8540746773013719_real64) <= 4*epsilon(value)) error stop 'not K(1/2)'
      print '(a, f18.16)', 'K(1/2) = ', value
   end subroutine check

end program with_core
