!> `kyvadlo-bench --scenes`: what a sample of a simulated scene costs beside the closed-form kernel alone.
module kyvadlo_bench_scenes
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_sample_block, only: block_samples
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: parse_simulation, simulation_type
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_bench_text, only: bench_text
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   use kyvadlo_text, only: counting_sink_type
   implicit none
   private
   public :: bench_scenes

   !> Takes samples and drops them.
   type, extends(sample_sink_type) :: no_samples_type
      real(wp) :: checksum = 0
   contains
      procedure :: begin => begin_none
      procedure :: take => take_none
      procedure :: note => note_none
   end type no_samples_type

   !> Samples of a scene, and of one whose samples take longer: some milliseconds, less than a slice of a busy machine.
   integer, parameter :: samples = 16*block_samples, written = 2048
   integer, parameter :: kernel_places = 1, scene_places = 2, kernel_rates = 3, scene_rates = 4, scene_more = 5, &
      string_rates = 6, lines_rates = 7, last_row = 7
   character(len=*), parameter :: wide = '&pendulum length=1, z_upper=0.3, z_lower=-0.8 /'
   character(len=*), parameter :: slack = &
      '&pendulum length=1, position=0.6,0,0.8, velocity=0,1.2,0 / &string restitution=0.2 /'

contains

   !> Measures and prints the table. Medians over passes; all rows are measured in turn, on one thread.
   subroutine bench_scenes(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
      real(wp), allocatable :: times(:, :)
      real(wp) :: t(last_row), checksum
      integer :: row, pass, passes

      passes = merge(3, 101, quick)
      allocate (times(passes, last_row))
      checksum = 0
      do pass = 0, passes  ! The first warms the caches and is not counted.
         do row = 1, last_row
            call measure(row, times(max(pass, 1), row), checksum)
         end do
      end do
      do row = 1, last_row
         t(row) = median(times(:, row))
      end do
      write (unit, '(a)') 'Simulated scenes: a wide swing at equidistant times, one thread; ns a sample.', ''
      write (unit, '(a,a10,a16)') repeat(' ', 48), 'ns', 'over kernel'
      call print_row('positions: kernel alone', kernel_places, kernel_places)
      call print_row('positions: scene', scene_places, kernel_places)
      call print_row('positions and velocities: kernel alone', kernel_rates, kernel_rates)
      call print_row('positions and velocities: scene', scene_rates, kernel_rates)
      call print_row('... with energy, tension and azimuth', scene_more, kernel_rates)
      call print_row('... of a slack string', string_rates, kernel_rates)
      call print_row('... as CSV, seven columns', lines_rates, kernel_rates)
      call bench_text(unit, passes, checksum)
      write (unit, '(a,es22.15)') 'Sum of all values computed: ', checksum

   contains

      subroutine print_row(name, row, base)
         character(len=*), intent(in) :: name
         integer, intent(in) :: row, base
         character(len=48) :: padded

         padded = name
         write (unit, '(a,f10.1,f16.2)') padded, t(row), t(row)/t(base)
      end subroutine print_row
   end subroutine bench_scenes

   !> Nanoseconds a sample, set-up left out.
   subroutine measure(row, time, checksum)
      integer, intent(in) :: row
      real(wp), intent(out) :: time
      real(wp), intent(inout) :: checksum

      select case (row)
      case (kernel_places, kernel_rates)
         call run_kernel(row == kernel_rates, time, checksum)
      case (scene_places)
         call run_scene(wide, 'position', samples, .false., time, checksum)
      case (scene_rates)
         call run_scene(wide, 'position velocity', samples, .false., time, checksum)
      case (scene_more)
         call run_scene(wide, 'position velocity energy tension azimuth', samples/4, .false., time, checksum)
      case (string_rates)
         call run_scene(slack, 'position velocity', samples, .false., time, checksum)
      case default
         call run_scene(wide, 'position velocity', written, .true., time, checksum)
      end select
   end subroutine measure

   !> The kernel of `locate` over ascending times, block by block.
   subroutine run_kernel(with_rates, time, checksum)
      logical, intent(in) :: with_rates
      real(wp), intent(out) :: time
      real(wp), intent(inout) :: checksum
      real(wp), allocatable :: values(:, :)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer(int64) :: start
      integer :: block, i

      call new_orbit_from_heights(orbit, 1.0_wp, 9.80665_wp, 0.3_wp, -0.8_wp, error)
      allocate (values(block_samples, 7), source=0.0_wp)
      do i = 1, block_samples
         values(i, 1) = 0.01_wp*i
      end do
      call system_clock(start)
      do block = 1, int(samples/block_samples)
         if (with_rates) then
            call orbit%locate(values(:, 1), values(:, 2), values(:, 3), values(:, 4), values(:, 5), &
               values(:, 6), values(:, 7))
         else
            call orbit%locate(values(:, 1), values(:, 2), values(:, 3), values(:, 4))
         end if
      end do
      time = nanoseconds_since(start)/samples
      checksum = checksum + values(block_samples, 4)
   end subroutine run_kernel

   !> A scene, its samples dropped, or written as lines that are.
   subroutine run_scene(pendulum, quantities, count, as_text, time, checksum)
      character(len=*), intent(in) :: pendulum, quantities
      integer, intent(in) :: count
      logical, intent(in) :: as_text
      real(wp), intent(out) :: time
      real(wp), intent(inout) :: checksum
      type(simulation_type) :: simulation
      type(path_type) :: path
      type(error_type), allocatable :: error
      type(no_samples_type) :: none
      type(counting_sink_type), target :: no_lines
      type(csv_samples_type) :: lines
      integer(int64) :: start
      character(len=12) :: number

      time = 0
      write (number, '(i0)') count
      call parse_simulation(pendulum//'&output duration=5000, samples='//trim(number)//', quantities="'//quantities// &
         '" /', 'bench', simulation, error)
      if (.not. allocated(error)) call choose_path(simulation, path, error)
      if (allocated(error)) return
      call system_clock(start)
      if (as_text) then
         lines = new_csv_samples(no_lines)
         call simulate(simulation, path, lines, error)
         checksum = checksum + real(no_lines%bytes, wp)
      else
         call simulate(simulation, path, none, error)
         checksum = checksum + none%checksum
      end if
      time = nanoseconds_since(start)/count
   end subroutine run_scene

   subroutine begin_none(sink, columns)
      class(no_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      sink%checksum = size(columns)
   end subroutine begin_none

   subroutine take_none(sink, values, goes_on)
      class(no_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on

      sink%checksum = sink%checksum + values(size(values, 1), size(values, 2))
      goes_on = .true.
   end subroutine take_none

   subroutine note_none(sink, event)
      class(no_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      sink%checksum = sink%checksum + event%time
   end subroutine note_none

end module kyvadlo_bench_scenes
