!> One process, in the build without MPI: the same procedures as in ranks_by_mpi.f90.
module kyvadlo_ranks
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: ranks_type, start_ranks, next_ticket, stop_tickets, share_text, share_number, gather_bits, worst_of, &
      wait_for_ranks, end_ranks, end_all_ranks

   logical, parameter, public :: with_mpi = .false.

   type :: ranks_type
      integer :: rank = 0, count = 1
      logical :: may_thread = .true.
      integer(int64), private :: counter = 0
   end type ranks_type

contains

   subroutine start_ranks(ranks)
      type(ranks_type), intent(out) :: ranks

      ranks%rank = 0
   end subroutine start_ranks

   subroutine next_ticket(ranks, ticket)
      type(ranks_type), intent(inout) :: ranks
      integer(int64), intent(out) :: ticket

      ticket = ranks%counter
      ranks%counter = ranks%counter + 1
   end subroutine next_ticket

   subroutine stop_tickets(ranks)
      type(ranks_type), intent(inout) :: ranks

      ranks%counter = 2_int64**62
   end subroutine stop_tickets

   subroutine share_text(text)
      character(len=:), allocatable, intent(inout) :: text

      if (.not. allocated(text)) text = ''
   end subroutine share_text

   subroutine share_number(number)
      integer, intent(inout) :: number

      number = number + 0
   end subroutine share_number

   subroutine gather_bits(ranks, bits)
      type(ranks_type), intent(in) :: ranks
      integer(int64), intent(inout) :: bits(:)

      bits = bits + ranks%rank
   end subroutine gather_bits

   subroutine worst_of(number)
      integer, intent(inout) :: number

      number = number + 0
   end subroutine worst_of

   subroutine wait_for_ranks()
   end subroutine wait_for_ranks

   subroutine end_ranks(ranks)
      type(ranks_type), intent(inout) :: ranks

      ranks%count = 1
   end subroutine end_ranks

   subroutine end_all_ranks(status)
      integer, intent(in) :: status

      if (status < 0) return
   end subroutine end_all_ranks

end module kyvadlo_ranks
