!> What `simulate --explain` says of a scene before it runs: the path, why, and its cost, measured on a few samples.
module kyvadlo_explain_scene
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_sample_block, only: columns_of
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_samples, only: column_type
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_integrated, path_string, path_type
   use kyvadlo_standard_io, only: message
   use kyvadlo_status, only: error_type
   use kyvadlo_step_forecast, only: forecast_error
   use kyvadlo_text, only: counting_sink_type, integer_text
   implicit none
   private
   public :: explain_scene

   !> Samples of the first trial and of the last, a thousandth of a second on the exact paths. A trial longer than so
   !> many seconds is not followed by one of more samples.
   integer(int64), parameter :: first_trial = 16, last_trial = 4096, growth = 16
   real(wp), parameter :: patience = 0.01_wp

contains

   !> Prints on standard error, a line for each fact. Errors: those of the run, met in the trial.
   subroutine explain_scene(simulation, path, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      type(simulation_type) :: trial
      type(path_type) :: trial_path
      type(column_type), allocatable :: columns(:)
      real(wp) :: seconds, bytes, all, off
      character(len=:), allocatable :: names
      integer :: i

      allocate (columns, source=columns_of(simulation))
      names = ''
      do i = 1, size(columns)
         names = names//' '//trim(columns(i)%name)
      end do
      all = real(simulation%settings%samples, wp)
      call message('path:     '//path%method)
      call message('because:  '//path%reason)
      if (path%path == path_string) call message('events:   '//integer_text(size(path%events)))
      if (path%path == path_integrated) then
         call message('accuracy: '//digits_text(path%tolerance, 2)//', error of a step')
         call message('steps:    about '//trim(digits_text(path%steps, 2))//' of at most '// &
            trim(digits_text(path%most_steps, 2))//' (--most-steps)')
         off = forecast_error(path%effects, path%length, path%gravity, path%duration, path%tolerance)
         if (off > 0) call message('error:    about '//trim(digits_text(off, 1))// &
            ' of the length at the end, growing with the square of the time')
      end if
      call message('columns: '//names)
      call message('samples:  '//counted(simulation%settings%samples)//' over '//digits_text(path%duration, 6)//' s')

      trial = simulation
      trial_path = path
      trial_path%duration_rest = 0
      trial_path%duration_typed = ''
      trial%settings%samples = min(simulation%settings%samples, first_trial)
      do
         trial_path%duration = path%duration*(real(trial%settings%samples - 1, wp)/(all - 1))
         call try(trial, trial_path, seconds, bytes, error)
         if (allocated(error)) return
         if (seconds > patience .or. trial%settings%samples >= min(simulation%settings%samples, last_trial)) exit
         trial%settings%samples = min(simulation%settings%samples, growth*trial%settings%samples)
      end do
      seconds = seconds/trial%settings%samples
      bytes = bytes/trial%settings%samples
      call message('cost:     '//trim(digits_text(1e9_wp*seconds, 3))//' ns a sample, '//digits_text(all*seconds, 3) &
         //' s in all, measured on the first '//counted(trial%settings%samples))
      call message('output:   '//integer_text(nint(bytes))//' bytes a sample as CSV, '// &
         digits_text(all*bytes/2**20, 3)//' MiB in all')
   end subroutine explain_scene

   !> Seconds and bytes of a scene, its samples dropped: the least of five short trials, as the first may pay for the
   !> start of threads, and any for what else the machine does.
   subroutine try(simulation, path, seconds, bytes, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      real(wp), intent(out) :: seconds, bytes
      type(error_type), allocatable, intent(out) :: error
      type(counting_sink_type), target :: counter
      type(csv_samples_type) :: samples
      integer(int64) :: start, finish, rate
      integer :: i

      seconds = huge(seconds)
      do i = 1, 5
         counter%bytes = 0
         samples = new_csv_samples(counter, threads=path%threads)
         call system_clock(start, rate)
         call simulate(simulation, path, samples, error)
         call system_clock(finish)
         seconds = min(seconds, real(finish - start, wp)/rate)
         if (allocated(error) .or. seconds > 10*patience) exit
      end do
      bytes = real(counter%bytes, wp)
   end subroutine try

   pure function counted(count) result(text)
      integer(int64), intent(in) :: count
      character(len=:), allocatable :: text
      character(len=20) :: buffer

      write (buffer, '(i0)') count
      text = trim(buffer)
   end function counted

end module kyvadlo_explain_scene
