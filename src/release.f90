!> The version of the library, for who compiles against it and for who asks the library that was linked.
module kyvadlo_release
   implicit none
   private
   public :: kyvadlo_version_number, kyvadlo_version_linked

   !> As CMakeLists.txt has it (a test compares): a constant of the module files that a program was compiled with.
   character(len=*), parameter :: kyvadlo_version_number = '0.2.0'

contains

   !> The version of the library that is linked; with shared libraries it may be another one than was compiled against.
   pure function kyvadlo_version_linked() result(number)
      character(len=len(kyvadlo_version_number)) :: number

      number = kyvadlo_version_number
   end function kyvadlo_version_linked

end module kyvadlo_release
