!> Messages of the set-ups name values as numbers; whoever typed them looks for what was typed.
module kyvadlo_as_typed
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_number_text, only: read_number
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_groups, only: starts
   implicit none
   private
   public :: put_as_typed

   character(len=*), parameter :: coordinates(3) = ['x', 'y', 'z'], rates(3) = ['vx', 'vy', 'vz']

contains

   !> Puts the numbers of a pendulum as its scene has them into a message that says `NAME = VALUE`. A value that is
   !> another by now, like gravity in a fluid, stays.
   pure subroutine put_as_typed(pendulum, message)
      type(pendulum_type), intent(in) :: pendulum
      character(len=:), allocatable, intent(inout) :: message
      integer :: i

      associate (names => starts(pendulum%start), first => pendulum%first, second => pendulum%second)
         if (allocated(pendulum%length%text)) call put(message, 'length', 'length', pendulum%length%text)
         if (allocated(pendulum%gravity%text)) call put(message, 'gravity', 'gravity', pendulum%gravity%text)
         if (names%values == 3) then
            do i = 1, 3
               call put(message, coordinates(i), coordinates(i), first(i)%text)
               call put(message, trim(rates(i)), trim(rates(i)), second(i)%text)
            end do
         else
            call put(message, trim(names%first), trim(names%first), first(1)%text)
            ! What the core calls energy, whatever its zero.
            if (index(names%first, 'energy') == 1) call put(message, 'energy', trim(names%first), first(1)%text)
            call put(message, trim(names%second), trim(names%second), second(1)%text)
         end if
      end associate
   end subroutine put_as_typed

   pure subroutine put(message, label, name, text)
      character(len=:), allocatable, intent(inout) :: message
      character(len=*), intent(in) :: label, name, text
      character(len=:), allocatable :: what
      real(real64) :: said, typed
      integer :: from, to

      from = index(message, ' '//label//' = ')
      if (from == 0) return
      to = from + len(label) + 3 + scan(message(from + len(label) + 4:)//',', ',') - 1
      call read_number(message(from + len(label) + 4:to), said, what)
      if (.not. allocated(what)) call read_number(text, typed, what)
      if (allocated(what)) return
      if (.not. (said <= typed .and. said >= typed)) return
      message = message(:from)//name//' = '//text//message(to + 1:)
   end subroutine put

end module kyvadlo_as_typed
