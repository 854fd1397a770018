!> Scenes that take time, but no work.
module sleeping_scenes
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: int64, wp => real64
   use kyvadlo_philox, only: philox_uniform
   use kyvadlo_sweep_chunks, only: chunk_range
   use kyvadlo_sweep_plan, only: plan_type
   use kyvadlo_sweep_reductions, only: chunk_type
   use kyvadlo_sweep_worker, only: worker_type
   implicit none
   private
   public :: sleep, work

   integer(int64), public :: my_work = 0, start_time = 0 !! [microseconds], [counts of the system's clock]
   !> Of the clock to the work: four seconds whatever the number of ranks, so that some tenths, for which a busy machine
   !> may let a rank wait, matter little.
   real(wp), public :: pace = 1

   interface
      integer(c_int) function usleep(microseconds) bind(c)
         import :: c_int
         integer(c_int), value :: microseconds
      end function usleep
   end interface

contains

   !> Of a scene [microseconds]: from 1 to 40 thousand, most of them short.
   pure integer(int64) function work(scene)
      integer(int64), intent(in) :: scene

      work = int(1000*min(40.0_wp, 1/philox_uniform([1_int64, 1_int64], scene)), int64)
   end function work

   subroutine sleep(plan, worker, chunk, found)
      type(plan_type), intent(in) :: plan
      type(worker_type), intent(inout) :: worker
      integer(int64), intent(in) :: chunk
      type(chunk_type), intent(inout) :: found
      integer(int64) :: first, count, now, rate, rest

      call chunk_range(plan%cut, chunk, first, count)
      found%chunk = chunk
      if (.not. allocated(found%stored)) then
         allocate (found%stored(1), found%status(count))
         allocate (found%stored(1)%values(1, count))
      end if
      worker%coordinates(1, 1) = real(first, wp)
      found%stored(1)%values = worker%coordinates(1, 1)
      found%status = 1
      my_work = my_work + work(first)
      ! Until the time by the clock of all: a rank that wakes late on a busy machine sleeps the less next time.
      call system_clock(now, rate)
      rest = int(my_work*pace, int64) - (now - start_time)*1000000/rate
      if (rest > 0) then
         if (usleep(int(rest, c_int)) /= 0) error stop 'no sleep'
      end if
   end subroutine sleep

end module sleeping_scenes

!> 1000 scenes of uneven work, shared out by the loop of `kyvadlo sweep` among ranks that sleep instead of computing:
!> how much work the busiest rank does. Run by mpirun; at most 1.02 of what falls to each, and the longest scene. With
!> the argument `tickets` how long a rank waits for the number of its next chunk.
program makespan
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_ranks
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_plan, only: plan_type, read_plan
   use kyvadlo_sweep_layout, only: sweep_file_type
   use kyvadlo_sweep_run, only: cells_type, run_chunks
   use sleeping_scenes, only: my_work, pace, sleep, start_time, work
   implicit none
   integer, parameter :: wp = real64, scenes = 1000
   character(len=*), parameter :: text = '&pendulum length=1, position=0,0,-1, velocity=1,0,0 /'//new_line('a') &
      //'&axis name = ''velocity(2)'', from = 0, to = 1, count = 1000 /'//new_line('a') &
      //'&measure quantities = ''greatest_z'' /'
   type(ranks_type) :: ranks
   type(plan_type) :: plan
   type(cells_type) :: cells
   type(sweep_file_type) :: file
   type(error_type), allocatable :: error
   integer(int64), allocatable :: work_of(:)
   integer(int64) :: all_work, longest, ticket, start, end, rate
   integer :: i, high, low
   character(len=8) :: argument
   integer, parameter :: tickets = 100000


   call start_ranks(ranks)
   call get_command_argument(1, argument)
   if (argument == 'tickets') then
      call wait_for_ranks()
      call system_clock(start, rate)
      do i = 1, tickets
         call next_ticket(ranks, ticket)
      end do
      call system_clock(end)
      print '("rank ", i0, ": ", f0.2, " microseconds a ticket")', ranks%rank, 1e6_wp*(end - start)/rate/tickets
      call end_ranks(ranks)
      stop
   end if
   call read_plan(text, 'plan', '', plan, error)
   if (allocated(error)) error stop 'a plan that is none'
   if (plan%cut%chunks /= scenes) error stop 'a chunk of more than one scene'
   allocate (cells%bits(2, plan%points), source=0_int64)
   call wait_for_ranks()
   call system_clock(start_time)
   high = int(start_time/2_int64**30)
   low = int(mod(start_time, 2_int64**30))
   call share_number(high)
   call share_number(low)
   start_time = high*2_int64**30 + low
   pace = 0.8_wp*ranks%count
   call run_chunks(plan, sleep, ranks, 1, 0_int64, plan%cut%chunks, .false., .false., file, cells, error)
   allocate (work_of(ranks%count), source=0_int64)
   work_of(ranks%rank + 1) = my_work
   call gather_bits(ranks, work_of)
   all_work = 0
   longest = 0
   do i = 1, scenes
      all_work = all_work + work(i - 1_int64)
      longest = max(longest, work(i - 1_int64))
   end do
   if (ranks%rank == 0) then
      print '(i0, " ranks: the busiest ", i0, ", each on average ", i0, ", the longest scene ", i0)', &
         ranks%count, maxval(work_of), all_work/ranks%count, longest
      if (sum(work_of) /= all_work) error stop 'a scene was computed twice, or not at all'
      if (maxval(work_of) > 1.02_wp*all_work/ranks%count + longest) error stop 'the work is shared out badly'
   end if
   call end_ranks(ranks)
end program makespan
