!> How failure travels: an allocatable `error`, allocated on failure only.
module kyvadlo_status
   implicit none
   private
   public :: error_type, fail
   public :: code_domain, code_input, code_file, code_unsupported

   !> A value breaks a rule of the mathematics or of the physics.
   integer, parameter :: code_domain = 1
   !> A word, a name or a number could not be understood.
   integer, parameter :: code_input = 2
   !> A file could not be read or written.
   integer, parameter :: code_file = 3
   !> The request is sound, but this build cannot serve it.
   integer, parameter :: code_unsupported = 4

   type :: error_type
      integer :: code = 0                   !! One of the `code_*` constants
      character(len=:), allocatable :: message !! Names the procedure, the rule and the values
   end type error_type

contains

   !> Allocates `error` with a code and a message.
   pure subroutine fail(error, code, message)
      type(error_type), allocatable, intent(out) :: error  !! Allocated on return
      integer, intent(in) :: code                          !! One of the `code_*` constants
      character(len=*), intent(in) :: message  !! Names the procedure, the rule and the values; blanks at its end go

      allocate (error)
      error%code = code
      error%message = trim(message)
   end subroutine fail

end module kyvadlo_status
