!> A program of somebody else that needs the core only.
program with_core
   use kyvadlo
   implicit none
   type(error_type), allocatable :: error

   call fail(error, code_domain, 'with_core: made to fail')
   if (.not. allocated(error)) error stop 'no error came back'
   if (error%code /= code_domain) error stop 'another code came back'
   deallocate (error)   ! the leak sanitizer counts what a main program keeps
   print '(a)', 'with_core: fine'
end program with_core
