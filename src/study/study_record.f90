!> What `kyvadlo study` measures: work done by a method, its cell in the record, and how it is timed.
module kyvadlo_study_record
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_quoting, only: csv_field
   use kyvadlo_stopwatch, only: median, nanoseconds_since, quantile
   implicit none
   private
   public :: cell_type, study_type, work_type, add_cell, measure, set_deadline, out_of_time, csv_header, csv_line
   public :: measured, capped, failed

   !> Outcomes of a cell.
   integer, parameter :: measured = 0  !! Error and time are numbers
   integer, parameter :: capped = 1    !! One pass would take longer than the cap
   integer, parameter :: failed = 2    !! The method gave up, or its error is no finite number

   !> One point of the record: a question asked about an orbit, answered by a method at a setting.
   type :: cell_type
      character(len=16) :: question = ''    !! position, position_1000, period, roots, gaps, functions
      character(len=64) :: orbit = ''       !! Name of the orbit, or of the function
      character(len=16) :: method = ''      !! One of the methods in doc/commands.md
      character(len=24) :: setting = ''     !! Without a comma
      character(len=8) :: kind = ''         !! real32, real64, real128
      real(real64) :: error = 0             !! What it means is the question's
      real(real64) :: ns_median = 0, ns_low = 0, ns_high = 0 !! Nanoseconds a result: median, quartiles
      !> In one pass: of the right side, the integrand ...; 0 where that means nothing
      integer(int64) :: evaluations = 0
      integer :: outcome = measured
   end type cell_type

   !> All cells so far and how to measure.
   type :: study_type
      type(cell_type), allocatable :: cells(:)      !! The first `count` are filled
      integer :: count = 0
      logical :: quick = .false.                    !! Fewer settings
      real(real64) :: seconds = 0.02_real64         !! Of measuring, for each cell
      real(real64) :: cap = 0.4_real64              !! Longest time of one pass [s]
      real(real64) :: checksum = 0                  !! Of everything computed, so that nothing can be left out
      procedure(progress_hook), pointer, nopass :: progress => null() !! Told of every cell
   end type study_type

   abstract interface
      subroutine progress_hook(count, cell)
         import :: cell_type
         integer, intent(in) :: count        !! Cells before this one
         type(cell_type), intent(in) :: cell !! About to be measured
      end subroutine progress_hook
   end interface

   !> Something to be timed. Extensions hold the arguments and the results; `measure` calls their two procedures by
   !> dynamic dispatch, so no compiler can see that a result is not used.
   type, abstract :: work_type
      integer :: results = 1                !! Given by one pass: times are divided by it
      integer(int64) :: evaluations = 0     !! Of one pass, set by `pass`
      logical :: has_failed = .false.       !! Set by a `pass` that cannot go on
      logical :: is_capped = .false.        !! Set by a `pass` that ended because it was `out_of_time`
      real(real64) :: sink = 0              !! `pass` adds something that depends on its results
      integer(int64) :: deadline = huge(1_int64) !! Of the system clock, set by `measure`
   contains
      procedure(pass), deferred :: pass
      procedure(error_of), deferred :: error
   end type work_type

   abstract interface
      !> Does the work once, set-up included if the method needs one.
      subroutine pass(work)
         import :: work_type
         class(work_type), intent(inout) :: work
      end subroutine pass
      !> Error of the results of the last pass, against the reference.
      function error_of(work) result(error)
         import :: work_type, real64
         class(work_type), intent(in) :: work
         real(real64) :: error
      end function error_of
   end interface

   !> A pass shorter than this [ns] is timed together with others: a thousand times the resolution of the clock.
   real(real64), parameter :: shortest = 2e4_real64
   !> Measurements beyond this tell no more about the median.
   integer, parameter :: most_samples = 101

   character(len=*), &
      parameter :: csv_header = 'question,orbit,method,setting,kind,error,ns_median,ns_low,ns_high,evaluations'

contains

   !> Adds a cell to the record.
   subroutine add_cell(study, cell)
      type(study_type), intent(inout) :: study
      type(cell_type), intent(in) :: cell
      type(cell_type), allocatable :: more(:)
      integer, parameter :: first_size = 256

      if (.not. allocated(study%cells)) allocate (study%cells(first_size))
      if (study%count == size(study%cells)) then
         allocate (more(2*study%count))
         more(:study%count) = study%cells(:study%count)
         call move_alloc(more, study%cells)
      end if
      study%count = study%count + 1
      study%cells(study%count) = cell
   end subroutine add_cell

   !> Times the work, takes its error and adds the cell, whose names are given. The first pass warms up and tells how
   !> long the others will take; then passes are repeated for `study%seconds`, at least three unless they would outlast
   !> the cap.
   subroutine measure(study, work, cell)
      type(study_type), intent(inout) :: study
      class(work_type), intent(inout) :: work
      type(cell_type), intent(in) :: cell     !! Question, orbit, method, setting, kind
      type(cell_type) :: new
      real(real64) :: samples(most_samples), one, spent
      integer(int64) :: start
      integer :: count, batch, i

      new = cell
      if (associated(study%progress)) call study%progress(study%count, cell)
      work%has_failed = .false.
      work%is_capped = .false.
      call set_deadline(work, study%cap)
      call system_clock(start)
      call work%pass()
      one = nanoseconds_since(start)
      new%outcome = outcome_of(work)
      if (new%outcome == measured .and. one > 1e9_real64*study%cap) new%outcome = capped
      if (new%outcome == measured) then
         new%error = work%error()
         if (.not. ieee_is_finite(new%error)) new%outcome = failed
      end if
      if (new%outcome == measured) then
         new%evaluations = work%evaluations
         ! Passes that are measured may take longer than the first: the cap has been kept.
         work%deadline = huge(work%deadline)
         call time_batch(work, 1, one)
         batch = max(1, min(ceiling(shortest/max(one, 1.0_real64)), 100000))
         spent = 0
         count = 0
         do while (count < most_samples)
            count = count + 1
            call time_batch(work, batch, samples(count))
            spent = spent + batch*samples(count)
            if (spent >= 1e9_real64*study%cap) exit
            if (count >= 3 .and. spent >= 1e9_real64*study%seconds) exit
         end do
         samples(:count) = samples(:count)/work%results
         new%ns_median = median(samples(:count))
         new%ns_low = quantile(samples(:count), 0.25_real64)
         new%ns_high = quantile(samples(:count), 0.75_real64)
         do i = 1, count
            if (.not. ieee_is_finite(samples(i))) new%outcome = failed
         end do
      end if
      if (ieee_is_finite(work%sink)) study%checksum = study%checksum + work%sink
      work%sink = 0
      call add_cell(study, new)
   end subroutine measure

   !> Nanoseconds of one pass among a number of them.
   subroutine time_batch(work, passes, time)
      class(work_type), intent(inout) :: work
      integer, intent(in) :: passes
      real(real64), intent(out) :: time
      integer(int64) :: start
      integer :: i

      call system_clock(start)
      do i = 1, passes
         call work%pass()
      end do
      time = nanoseconds_since(start)/passes
   end subroutine time_batch

   integer function outcome_of(work)
      class(work_type), intent(in) :: work

      outcome_of = measured
      if (work%has_failed) outcome_of = failed
      if (work%is_capped) outcome_of = capped
   end function outcome_of

   !> From now on the work has this many seconds.
   subroutine set_deadline(work, seconds)
      class(work_type), intent(inout) :: work
      real(real64), intent(in) :: seconds
      integer(int64) :: now, rate

      call system_clock(now, rate)
      work%deadline = now + int(seconds*real(rate, real64), int64)
   end subroutine set_deadline

   !> To be asked by a pass that may take long, between its parts.
   logical function out_of_time(work)
      class(work_type), intent(in) :: work
      integer(int64) :: now

      call system_clock(now)
      out_of_time = now > work%deadline
   end function out_of_time

   !> The cell as a line of the CSV file: a word instead of the numbers where there are none.
   function csv_line(cell) result(line)
      type(cell_type), intent(in) :: cell
      character(len=256) :: line
      character(len=64) :: numbers

      select case (cell%outcome)
      case (measured)
         write (numbers, '(es10.3e3,3(",",es10.4e2))') cell%error, cell%ns_median, cell%ns_low, cell%ns_high
      case (capped)
         numbers = 'capped,capped,capped,capped'
      case default
         numbers = 'failed,failed,failed,failed'
      end select
      line = trim(cell%question)//','//csv_field(trim(cell%orbit))//','//trim(cell%method)//','// &
         csv_field(trim(cell%setting))// ','//trim(cell%kind)//','//trim(numbers)
      write (numbers, '(i0)') cell%evaluations
      line = trim(line)//','//numbers
   end function csv_line

end module kyvadlo_study_record
