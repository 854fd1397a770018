!> The work of a sweep: threads and ranks take chunk after chunk until none is left.
module kyvadlo_sweep_run
   use, intrinsic :: iso_fortran_env, only: error_unit, int8, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_ranks, only: next_ticket, ranks_type, stop_tickets
   use kyvadlo_standard_io, only: terminal_width
   use kyvadlo_status, only: error_type
#ifdef KYVADLO_SWEEP_NETCDF
   use kyvadlo_sweep_layout, only: read_marks, sweep_file_type, write_chunk
#endif
   use kyvadlo_sweep_chunks, only: chunk_range
   use kyvadlo_sweep_plan, only: plan_type
   use kyvadlo_sweep_reductions, only: chunk_type
   use kyvadlo_sweep_worker, only: compute_interface, new_worker, worker_type
   implicit none
   private
   public :: cells_type, run_chunks
#ifndef KYVADLO_SWEEP_NETCDF
   public :: sweep_file_type

   type :: sweep_file_type
      integer(int64) :: chunks_done = 0   !! None: there is no file
   end type sweep_file_type
#endif

   !> A small sweep in memory, as bits: what a rank did not compute is 0.
   type :: cells_type
      integer(int64), allocatable :: bits(:, :)      !! (components and the status, point)
   end type cells_type

   integer, parameter :: window = 65536              !! Marks that are looked at together

   integer, parameter :: progress_width = 64
   type :: progress_type
      integer(int64) :: start = 0, last_line = 0
      logical :: has_line = .false.
   end type progress_type

contains

   !> Computes the chunks from `first` on up to before `last`, those without a mark. Into the file, or into the cells.
   subroutine run_chunks(plan, compute, ranks, threads, first, last, is_resumed, shows, file, cells, error)
      type(plan_type), intent(in) :: plan
      procedure(compute_interface) :: compute
      type(ranks_type), intent(inout) :: ranks
      integer, intent(in) :: threads
      integer(int64), intent(in) :: first, last
      logical, intent(in) :: is_resumed, shows
      type(sweep_file_type), intent(inout) :: file
      type(cells_type), intent(inout) :: cells
      type(error_type), allocatable, intent(out) :: error
      type(progress_type) :: progress
      type(worker_type) :: worker
      type(chunk_type) :: found
      integer(int8), allocatable :: marks(:)
      integer(int64) :: chunk, first_mark
      logical :: goes_on

      allocate (marks(0))
      first_mark = 0
      call system_clock(progress%start)
      progress%last_line = progress%start
      !$omp parallel num_threads(threads) default(shared) private(worker, found, chunk, goes_on)
      call new_worker(plan, worker)
      found%count = -1   ! A private copy may lack what its type begins with.
      goes_on = .true.
      do while (goes_on)
         !$omp critical (kyvadlo_sweep_calls)
         call take_chunk(chunk)
         goes_on = chunk < last .and. .not. allocated(error)
         !$omp end critical (kyvadlo_sweep_calls)
         if (.not. goes_on) exit
         call compute(plan, worker, chunk, found)
         !$omp critical (kyvadlo_sweep_calls)
         if (.not. allocated(error)) call give_chunk(found)
         goes_on = .not. allocated(error)
         !$omp end critical (kyvadlo_sweep_calls)
      end do
      !$omp end parallel
      if (progress%has_line) write (error_unit, '(a)', advance='no') achar(13)//repeat(' ', &
         min(progress_width, terminal_width() - 1))//achar(13)
      if (allocated(error)) call stop_tickets(ranks)

   contains

      !> The next chunk that is not done yet.
      subroutine take_chunk(chunk)
         integer(int64), intent(out) :: chunk
         logical :: is_done

         do
            call next_ticket(ranks, chunk)
            chunk = min(chunk, 2_int64**61) + first
            if (chunk >= last) return
            if (shows) call show(plan, progress, chunk - first, last - first)
            is_done = .false.
#ifdef KYVADLO_SWEEP_NETCDF
            if (is_resumed) then
               if (chunk >= first_mark + size(marks)) then
                  first_mark = chunk
                  deallocate (marks)
                  allocate (marks(min(last - chunk, int(window, int64))))
                  call read_marks(file, first_mark, marks)
               end if
               is_done = marks(chunk - first_mark + 1) == 1
            end if
#else
            is_done = is_resumed .and. file%chunks_done > chunk
#endif
            if (.not. is_done) return
         end do
      end subroutine take_chunk

      subroutine give_chunk(found)
         type(chunk_type), intent(inout) :: found
         integer(int64) :: start, count
         integer :: i, at

         if (allocated(cells%bits)) then
            call chunk_range(plan%cut, found%chunk, start, count)
            at = 0
            do i = 1, size(found%stored)
               associate (values => found%stored(i)%values)
                  cells%bits(at + 1:at + size(values, 1), start + 1:start + count) = &
                     reshape(transfer(values, cells%bits), shape(values))
                  at = at + size(values, 1)
               end associate
            end do
            cells%bits(at + 1, start + 1:start + count) = found%status
         else
#ifdef KYVADLO_SWEEP_NETCDF
            call write_chunk(plan, file, found, error)
#endif
         end if
      end subroutine give_chunk
   end subroutine run_chunks

   !> ` 1.20E+08 points, 12 %,  1.20E+06 points/s,  3.40E+01 s left`, over the line before.
   subroutine show(plan, progress, done, total)
      type(plan_type), intent(in) :: plan
      type(progress_type), intent(inout) :: progress
      integer(int64), intent(in) :: done, total
      integer(int64) :: now, rate
      real(wp) :: seconds, part, points
      character(len=progress_width) :: line

      call system_clock(now, rate)
      seconds = real(now - progress%start, wp)/rate
      if (done == 0 .or. seconds < 1 .or. real(now - progress%last_line, wp) < 0.2_wp*rate) return
      progress%last_line = now
      part = real(done, wp)/total
      points = part*(real(plan%points, wp)*total/plan%cut%chunks)
      write (line, '(es8.2," points, ",i0," %, ",es8.2," points/s, ",es8.2," s left")') points, int(100*part), &
         points/seconds, seconds*(1 - part)/part
      write (error_unit, '(a)', advance='no') achar(13)//line(:min(len_trim(line), terminal_width() - 1))
      flush (error_unit)
      progress%has_line = .true.
   end subroutine show

end module kyvadlo_sweep_run
