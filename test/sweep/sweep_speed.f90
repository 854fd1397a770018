!> A taker of samples that does nothing with them.
module sink_of_nothing
   use, intrinsic :: iso_fortran_env, only: wp => real64
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   implicit none
   private
   public :: nothing_type

   type, extends(sample_sink_type) :: nothing_type
   contains
      procedure :: begin => begin_nothing
      procedure :: take => take_nothing
      procedure :: note => note_nothing
   end type nothing_type

contains

   subroutine begin_nothing(sink, columns)
      class(nothing_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      if (size(columns) < 0) print *, same_type_as(sink, sink)
   end subroutine begin_nothing

   subroutine take_nothing(sink, values, goes_on)
      class(nothing_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on

      goes_on = same_type_as(sink, sink) .or. size(values) > 0
   end subroutine take_nothing

   subroutine note_nothing(sink, event)
      class(nothing_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      if (event%time < 0) print *, same_type_as(sink, sink)
   end subroutine note_nothing

end module sink_of_nothing

!> What a sweep costs beside what it is made of, in time of one core: periods into a histogram beside the bare loop,
!> orbits with eight constants, scenes beside `simulate`. The best of some runs of both in turn, of many more where a
!> busy machine disturbs them; with the argument `test` it ends with an error where the ratio of a row exceeds its bound.
program sweep_speed
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_many_orbits, only: orbits_constants_from_gaps
   use kyvadlo_periods, only: orbits_period_from_gaps
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_plan, only: plan_type, read_plan
   use kyvadlo_sweep_points, only: compute_chunk
   use kyvadlo_sweep_reductions, only: chunk_type
   use kyvadlo_sweep_worker, only: new_worker, worker_type
   use sink_of_nothing, only: nothing_type
   implicit none
   integer, parameter :: wp = real64, runs = 15, most_runs = 150
   character(len=*), parameter :: nl = new_line('a')
   character(len=*), parameter :: gaps = '&pendulum length = 1, upper_gap = 0.5, lower_rise = 0.2 /'//nl &
      //'&axis name = ''upper_gap'', from = 0.5, to = 1, count = 31623 /'//nl &
      //'&axis name = ''lower_rise'', from = 0.01, to = 0.4, count = 31623 /'//nl
   character(len=*), parameter :: scenes = '&pendulum length = 10, release_angle = 4, release_speed = 0 /'//nl &
      //'&earth_rotation latitude = 48.85 /'//nl//'&output duration = 70, samples = 1401 /'//nl &
      //'&axis name = ''release_speed'', from = 0, to = 0.02, count = 64 /'//nl

   logical :: is_test, has_failed
   character(len=8) :: argument

   call get_command_argument(1, argument)
   is_test = argument == 'test'
   has_failed = .false.
   call periods
   call of_orbits
   call of_scenes
   if (has_failed .and. is_test) error stop 'a sweep costs too much'

contains

   subroutine periods()
      integer, parameter :: points = 1048576, block = 2048
      real(wp), parameter :: bound = 1.1_wp
      real(wp), allocatable :: upper(:), lower(:), period(:)
      real(wp) :: bare, ours
      integer :: run, i, j
      real(wp) :: start, end

      allocate (upper(points), lower(points), period(points))
      upper = [(0.5_wp + 0.5_wp*i/points, i=1, points)]
      lower = [(0.01_wp + 0.39_wp*i/points, i=1, points)]
      bare = huge(bare)
      ours = huge(ours)
      do run = 1, most_runs
         if (run > runs .and. ours <= bound*bare) exit
         call cpu_time(start)
         do j = 1, points, block
            call orbits_period_from_gaps(1.0_wp, 9.80665_wp, upper(j:j + block - 1), lower(j:j + block - 1), &
               period(j:j + block - 1))
         end do
         call cpu_time(end)
         bare = min(bare, (end - start)/points)
         ours = min(ours, time_of_chunk(gaps//'&measure quantities = ''T'' /'//nl &
            //'&histogram quantity = ''T'', from = 0.9, to = 2, count = 100 /'))
      end do
      if (.not. all(period > 0)) error stop 'no periods'
      call report('a period, the bare loop', bare)
      call report('a period into least, greatest, histogram', ours, bare, bound)

   end subroutine periods

   subroutine of_orbits()
      integer, parameter :: points = 65536, block = 2048
      real(wp), parameter :: bound = 1.5_wp
      real(wp), allocatable :: upper(:), lower(:), constants(:, :)
      real(wp) :: ours, bare, start, end
      integer :: run, i, j

      allocate (upper(points), lower(points), constants(8, points))
      upper = [(0.5_wp + 0.5_wp*i/points, i=1, points)]
      lower = [(0.01_wp + 0.39_wp*i/points, i=1, points)]
      ours = huge(ours)
      bare = huge(bare)
      do run = 1, most_runs
         if (run > runs .and. ours <= bound*bare) exit
         call cpu_time(start)
         do j = 1, points, block
            call orbits_constants_from_gaps(1.0_wp, 9.80665_wp, upper(j:j + block - 1), lower(j:j + block - 1), &
               constants(:, j:j + block - 1))
         end do
         call cpu_time(end)
         bare = min(bare, (end - start)/points)
         ours = min(ours, time_of_chunk(gaps//'&measure quantities = ' &
            //'''T k complementary_modulus K q A phi_T advance'' /'))
      end do
      if (.not. all(constants(1, :) > 0)) error stop 'no constants'
      call report('eight constants, the bare loop', bare)
      call report('an orbit of eight constants', ours, bare, bound)
   end subroutine of_orbits

   subroutine of_scenes()
      real(wp), parameter :: bound = 1.05_wp
      real(wp) :: ours, bare
      integer :: run

      ours = huge(ours)
      bare = huge(bare)
      do run = 1, 40
         if (run > 3 .and. ours <= bound*bare) exit
         bare = min(bare, time_of_simulate())
         ours = min(ours, time_of_chunk(scenes//'&measure quantities = ''greatest_inclination'' /', 64))
      end do
      call report('a scene, simulate', bare)
      call report('a scene in a sweep', ours, bare, bound)
   end subroutine of_scenes

   !> Seconds a point of a chunk in the middle of the sweep, or of several.
   real(wp) function time_of_chunk(text, chunks) result(time)
      character(len=*), intent(in) :: text
      integer, intent(in), optional :: chunks
      type(plan_type) :: plan
      type(worker_type) :: worker
      type(chunk_type) :: found
      type(error_type), allocatable :: error
      real(wp) :: start, end
      integer(int64) :: points
      integer :: i, last

      call read_plan(text, 'plan', '', plan, error)
      if (allocated(error)) error stop 'a plan that is none'
      call new_worker(plan, worker)
      last = 1
      if (present(chunks)) last = min(chunks, int(plan%cut%chunks))
      points = 0
      if (last == 1) call compute_chunk(plan, worker, plan%cut%chunks/2 - 1, found)
      call cpu_time(start)
      do i = 1, last
         call compute_chunk(plan, worker, merge(plan%cut%chunks/2, int(i - 1, int64), last == 1), found)
         points = points + found%count
      end do
      call cpu_time(end)
      if (found%reduction(1) < found%count) error stop 'points that are not computed'
      time = (end - start)/points
   end function time_of_chunk

   !> Of the same scenes.
   real(wp) function time_of_simulate() result(time)
      type(plan_type) :: plan
      type(path_type) :: path
      type(nothing_type) :: samples
      type(error_type), allocatable :: error
      real(wp) :: start, end
      integer :: i

      call read_plan(scenes//'&measure quantities = ''greatest_inclination'' /', 'plan', '', plan, error)
      if (allocated(error)) error stop 'a plan that is none'
      call cpu_time(start)
      do i = 1, 64
         plan%scene%pendulum%second(1)%text = shortest_text(0.02_wp*(i - 1)/63)
         call choose_path(plan%scene, path, error)
         if (.not. allocated(error)) call simulate(plan%scene, path, samples, error)
         if (allocated(error)) error stop 'a scene that fails'
      end do
      call cpu_time(end)
      time = (end - start)/64
   end function time_of_simulate

   !> Nanoseconds, and how many times another.
   subroutine report(what, time, beside, bound)
      character(len=*), intent(in) :: what
      real(wp), intent(in) :: time
      real(wp), intent(in), optional :: beside, bound

      if (.not. present(beside)) then
         print '(a, t45, f12.2, " ns")', what, 1e9_wp*time
         return
      end if
      print '(a, t45, f12.2, " ns", f8.3, " times")', what, 1e9_wp*time, time/beside
      ! A busy machine disturbs by some per cent even the best of many runs.
      has_failed = has_failed .or. .not. time <= (bound + 0.15_wp)*beside
   end subroutine report

end program sweep_speed
