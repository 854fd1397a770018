!> `kyvadlo-bench --fits`: what a fit of a long table in memory takes, beside one evaluation of its model.
module kyvadlo_bench_fits
#ifdef KYVADLO_WITH_GSL
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_fit, only: fit_measurements, fit_result_type
   use kyvadlo_fit_data, only: column_t, column_x, column_z, columns, fit_data_type
   use kyvadlo_fit_motion, only: find_states
   use kyvadlo_fit_physics, only: direction_type, physics_type
   use kyvadlo_fit_request, only: fit_request_type, parse_fit_request
   use kyvadlo_fit_unknowns, only: physics_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene_groups, only: settings
   use kyvadlo_stopwatch, only: median
#endif
   implicit none
   private
   public :: bench_fits

#ifdef KYVADLO_WITH_GSL
   !> 600 s at 30 frames a second.
   integer, parameter :: rows = 18000
   real(wp), parameter :: span = 600, noise = 1e-3_wp, length = 1.2_wp, gravity = 9.81_wp
   real(wp), parameter :: position(3) = [0.72_wp, 0.0_wp, -0.96_wp], velocity(3) = [-0.4_wp, 1.1_wp, -0.3_wp]
   character(len=*), parameter :: free = "free='length gravity position velocity"
#endif

contains

   !> Measures and prints the table. Medians over passes, on one thread.
   subroutine bench_fits(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! Few passes: to see that it runs, not to measure
#ifdef KYVADLO_WITH_GSL
      integer :: passes

      passes = merge(1, 11, quick)
      write (unit, '(a,/,a,/,/,a40,a10,a12,a8)') &
         'Fits of x, y, z in 18 000 rows (600 s at 30 a second, 300 periods) to a thousandth of the length, arrays', &
         'in memory, one thread: ms of the processor, and times one motion with its derivatives at all rows.', &
         '', 'ms', 'one motion', 'times'
      call measure(unit, passes, 'exact, no guess', "&pendulum / &fit "//free//"', sigma=1e-3 /")
      call measure(unit, passes, 'exact, from a guess within 2 %', "&pendulum length=1.22 gravity=9.65 "// &
         "position=0.73,0.01,-0.977 velocity=-0.405,1.09,-0.306 / &fit "//free//"', sigma=1e-3 /")
      call measure(unit, passes, 'air, integrated, no guess', "&pendulum / &air linear=1e-3 / &fit "//free// &
         " linear', sigma=1e-3 /")
#else

      if (.not. quick) write (unit, '(a)') 'Fits need GSL, and this build has none.'
#endif
   end subroutine bench_fits

#ifdef KYVADLO_WITH_GSL
   subroutine measure(unit, passes, title, scene)
      integer, intent(in) :: unit, passes
      character(len=*), intent(in) :: title, scene
      type(fit_request_type) :: request
      type(fit_data_type) :: data
      type(fit_result_type) :: result
      type(error_type), allocatable :: error
      real(wp) :: times(passes), motions(passes)
      real(wp) :: begun, ended
      integer :: pass
      logical :: failed

      call parse_fit_request(scene, 'scene', request, error)
      if (allocated(error)) error stop 'bench_fits: no request'
      call make_data(data, failed)
      if (failed) error stop 'bench_fits: no data'
      do pass = 1, passes
         call cpu_time(begun)
         call fit_measurements(request, data, result, error)
         call cpu_time(ended)
         times(pass) = 1e3_wp*(ended - begun)
         if (allocated(error) .or. .not. result%is_converged) error stop 'bench_fits: no minimum'
         call time_motion(result, motions(pass))
      end do
      write (unit, '(a40,f10.1,f12.2,f8.1)') title, median(times), median(motions), median(times)/median(motions)
   end subroutine measure

   subroutine make_data(data, failed)
      type(fit_data_type), intent(out) :: data
      logical, intent(out) :: failed
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer :: i, j

      data%file = 'memory'
      data%rows = rows
      data%has(column_x:column_z) = .true.
      data%has(column_t) = .true.
      allocate (data%value(rows, columns), data%sigma(rows, columns))
      data%value = quiet_nan_real64
      data%sigma = quiet_nan_real64
      data%line = [(i + 1, i=1, rows)]
      call new_orbit_from_state(orbit, length, gravity, position, velocity, error)
      failed = allocated(error)
      if (failed) return
      data%value(:, column_t) = [(span*i/rows, i=0, rows - 1)]
      call orbit%locate(data%value(:, column_t), data%value(:, 1), data%value(:, 2), data%value(:, 3))
      do i = 1, rows
         do j = 1, 3
            ! Of size 1, and no two alike.
            data%value(i, j) = data%value(i, j) + noise*sqrt(12.0_wp)* &
               (modulo(0.6180339887498949_wp*(3.0_wp*i + j)**2, 1.0_wp) - 0.5_wp)
         end do
      end do
   end subroutine make_data

   !> One motion with its derivatives by the unknowns, at all rows.
   subroutine time_motion(result, milliseconds)
      type(fit_result_type), intent(in) :: result
      real(wp), intent(out) :: milliseconds
      type(physics_type) :: physics
      type(direction_type) :: directions(size(result%x))
      real(wp) :: number(3, size(settings))
      real(wp), allocatable :: states(:, :), matrices(:, :, :)
      real(wp) :: begun, ended
      logical :: failed

      allocate (states(6, rows), matrices(6, size(result%x), rows))
      call physics_at(result%model%motion, result%x, number, physics, failed, directions)
      call cpu_time(begun)
      call find_states(physics, directions, result%model%times, states, failed, matrices)
      call cpu_time(ended)
      milliseconds = 1e3_wp*(ended - begun)
      if (failed) error stop 'bench_fits: no motion'
   end subroutine time_motion
#endif
end module kyvadlo_bench_fits
