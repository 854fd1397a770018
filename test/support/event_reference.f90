!> The crossings in test/reference/events.dat, a scene for each column and value.
module event_reference
   use, intrinsic :: iso_fortran_env, only: real64
   use reference_data, only: read_reference, set_name_length
   use reference_kinds, only: real128
   implicit none
   private
   public :: reference_type, read_events

   type :: reference_type
      character(len=:), allocatable :: scene        !! With the event; no effects
      real(real64), allocatable :: times(:)
      logical :: is_close = .false.                 !! Next to an extreme
   end type reference_type

contains

   function read_events() result(references)
      type(reference_type), allocatable :: references(:)
      real(real128), allocatable, dimension(:, :) :: arguments, results, condition
      character(len=set_name_length), allocatable :: columns(:)
      type(reference_type) :: next
      character(len=24) :: speed, value
      integer :: i

      call read_reference('events', 64, arguments, results, condition, sets=columns)
      allocate (references(0))
      do i = 1, size(columns)
         if (nint(arguments(3, i)) == 1) then
            write (speed, '(es24.16)') arguments(1, i)
            write (value, '(es24.16)') arguments(2, i)
            next%scene = '&pendulum length=1 position=0.6,0,-0.8 velocity=0,'//trim(adjustl(speed))//',0 / &event quantity=''' &
               //trim(columns(i))//''' value='//trim(adjustl(value))//' / &output duration=3 samples=4 / '
            next%is_close = columns(i) == 'x' .and. arguments(2, i) > 0.5_real128
            allocate (next%times(0))
         end if
         next%times = [next%times, real(results(1, i), real64)]
         if (i < size(columns)) then
            if (nint(arguments(3, i + 1)) /= 1) cycle
         end if
         references = [references, next]
         deallocate (next%times)
      end do
   end function read_events

end module event_reference
