!> A program of somebody else that links the whole library.
program with_everything
   use kyvadlo_version, only: version, licence
   implicit none

   if (len(version) < 5) error stop 'no version'
   print '(4a)', 'kyvadlo ', version, ', ', licence
end program with_everything
