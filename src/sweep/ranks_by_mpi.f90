!> The processes that share a sweep, by MPI. Beside the NetCDF files the only source that knows MPI.
module kyvadlo_ranks
   use mpi_f08
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: ranks_type, start_ranks, next_ticket, stop_tickets, share_text, share_number, gather_bits, worst_of, &
      wait_for_ranks, end_ranks, end_all_ranks

   logical, parameter, public :: with_mpi = .true.

   type :: ranks_type
      integer :: rank = 0, count = 1
      logical :: may_thread = .false.            !! Threads may call, one at a time
      type(MPI_Win), private :: window
      integer(int64), pointer, private :: counter(:) => null()
   end type ranks_type

contains

   subroutine start_ranks(ranks)
      type(ranks_type), intent(out) :: ranks
      integer :: provided
      integer(MPI_ADDRESS_KIND) :: size
      type(c_ptr) :: base

      call MPI_Init_thread(MPI_THREAD_SERIALIZED, provided)
      ranks%may_thread = provided >= MPI_THREAD_SERIALIZED
      call MPI_Comm_rank(MPI_COMM_WORLD, ranks%rank)
      call MPI_Comm_size(MPI_COMM_WORLD, ranks%count)
      ! The counter lies with rank 0; the others have none.
      size = merge(8, 0, ranks%rank == 0)
      call MPI_Win_allocate(size, 8, MPI_INFO_NULL, MPI_COMM_WORLD, base, ranks%window)
      if (ranks%rank == 0) then
         call c_f_pointer(base, ranks%counter, [1])
         ranks%counter = 0
      end if
      call MPI_Barrier(MPI_COMM_WORLD)
      call MPI_Win_lock_all(0, ranks%window)
   end subroutine start_ranks

   !> 0, 1, 2 ...: every number to one caller only, whoever asks first.
   subroutine next_ticket(ranks, ticket)
      type(ranks_type), intent(in) :: ranks
      integer(int64), intent(out) :: ticket
      ! MPI uses them until the flush.
      integer(int64), asynchronous :: one, found

      one = 1
      call MPI_Fetch_and_op(one, found, MPI_INTEGER8, 0, 0_MPI_ADDRESS_KIND, MPI_SUM, ranks%window)
      call MPI_Win_flush(0, ranks%window)
      ticket = found
   end subroutine next_ticket

   !> No more work for anybody.
   subroutine stop_tickets(ranks)
      type(ranks_type), intent(in) :: ranks
      integer(int64), asynchronous :: large, found

      large = 2_int64**62
      call MPI_Fetch_and_op(large, found, MPI_INTEGER8, 0, 0_MPI_ADDRESS_KIND, MPI_SUM, ranks%window)
      call MPI_Win_flush(0, ranks%window)
   end subroutine stop_tickets

   !> A text of rank 0, to all.
   subroutine share_text(text)
      character(len=:), allocatable, intent(inout) :: text
      integer :: length

      length = 0
      if (allocated(text)) length = len(text)
      call MPI_Bcast(length, 1, MPI_INTEGER, 0, MPI_COMM_WORLD)
      if (allocated(text)) then
         if (len(text) /= length) deallocate (text)
      end if
      if (.not. allocated(text)) allocate (character(len=length) :: text)
      call MPI_Bcast(text, length, MPI_CHARACTER, 0, MPI_COMM_WORLD)
   end subroutine share_text

   !> A number of rank 0, to all.
   subroutine share_number(number)
      integer, intent(inout) :: number

      call MPI_Bcast(number, 1, MPI_INTEGER, 0, MPI_COMM_WORLD)
   end subroutine share_number

   !> What the ranks have filled of one array, each other parts of it, together on rank 0.
   subroutine gather_bits(ranks, bits)
      type(ranks_type), intent(in) :: ranks
      integer(int64), intent(inout) :: bits(:)
      integer(int64), allocatable :: mine(:)

      allocate (mine(size(bits)))
      mine(:) = bits
      call MPI_Reduce(mine, bits, size(bits), MPI_INTEGER8, MPI_BOR, 0, MPI_COMM_WORLD)
      if (ranks%rank > 0) bits = mine
   end subroutine gather_bits

   !> The largest of the ranks' numbers.
   subroutine worst_of(number)
      integer, intent(inout) :: number
      integer :: mine

      mine = number
      call MPI_Allreduce(mine, number, 1, MPI_INTEGER, MPI_MAX, MPI_COMM_WORLD)
   end subroutine worst_of

   subroutine wait_for_ranks()
      call MPI_Barrier(MPI_COMM_WORLD)
   end subroutine wait_for_ranks

   subroutine end_ranks(ranks)
      type(ranks_type), intent(inout) :: ranks

      call MPI_Win_unlock_all(ranks%window)
      call MPI_Win_free(ranks%window)
      call MPI_Finalize()
   end subroutine end_ranks

   !> After a failure that the others do not know of.
   subroutine end_all_ranks(status)
      integer, intent(in) :: status

      call MPI_Abort(MPI_COMM_WORLD, status)
   end subroutine end_all_ranks

end module kyvadlo_ranks
