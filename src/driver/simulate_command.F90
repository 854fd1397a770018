!> The command `simulate`: one scene, its samples as CSV or NetCDF, and a picture.
module kyvadlo_simulate_command
   use kyvadlo_command_line, only: arguments_type, integer_option, option_given, option_value
   use kyvadlo_explain_scene, only: explain_scene
   use kyvadlo_kinds, only: wp => real64
#ifdef KYVADLO_WITH_NETCDF
   use kyvadlo_netcdf_samples, only: discard_netcdf, finish_netcdf, netcdf_samples_type, new_netcdf
#endif
   use kyvadlo_number_text, only: digits_text, read_number
   use kyvadlo_plot_samples, only: check_plot, discard_plot, finish_plot, new_plot, plot_samples_type
   use kyvadlo_quantities, only: quantity_position
   use kyvadlo_sample_block, only: columns_of
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_samples, only: sample_sink_type
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: read_simulation, simulation_type
   use kyvadlo_simulation_path, only: check_type, choose_path, path_integrated, path_type
   use kyvadlo_run_files, only: add_input, add_output, check_files, is_netcdf_name, run_files_type
   use kyvadlo_scene_effects, only: get_table_paths
   use kyvadlo_settings_list, only: write_settings
   use kyvadlo_standard_io, only: become_program, close_output, discard_output, get_unfinished_name, is_on_terminal, &
      is_terminal, message, open_output, output_type
   use kyvadlo_summary, only: new_summary, summary_type, write_summary
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   use kyvadlo_text, only: counting_sink_type, shown, text_type
   use kyvadlo_watched_samples, only: new_watch, stop_watch, watched_samples_type
   implicit none
   private
   public :: simulate_command

contains

   !> Runs the command. Files appear whole or not at all.
   subroutine simulate_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(simulation_type) :: simulation
      type(path_type) :: path
      type(run_files_type) :: files
      type(output_type) :: list
      real(wp), allocatable :: accuracy, most_steps
      character(len=:), allocatable :: pendulum     !! Not allocated: the scene has one

      if (option_given(arguments, '--list')) then
         call open_output(list, '', error)
         call write_settings(list)
         call close_output(list, error)
         return
      end if
      if (size(arguments%operands) /= 1) then
         call fail(error, code_input, 'simulate needs one scene file, or - for standard input')
         return
      end if
      call check_options(arguments, error)
      if (.not. allocated(error)) call number_option(arguments, '--accuracy', 0.1_wp, 'above 0, at most 0.1', &
         accuracy, error)
      if (.not. allocated(error)) call number_option(arguments, '--most-steps', 1e15_wp, 'above 0, at most 1e15', &
         most_steps, error)
      if (.not. allocated(error)) call add_input(files, 'the scene', arguments%operands(1)%text)
      if (option_given(arguments, '--pendulum')) pendulum = option_value(arguments, '--pendulum', '')
      if (.not. allocated(error)) call read_simulation(arguments%operands(1)%text, simulation, error, pendulum)
      if (allocated(simulation%pendulum%note) .and. .not. allocated(error)) &
         call message('kyvadlo: '//simulation%pendulum%note)
      if (.not. allocated(error)) call check_all_files(arguments, simulation, files, error)
      if (.not. allocated(error)) call choose_path(simulation, path, error, accuracy, most_steps)
      if (allocated(path%note) .and. .not. allocated(error)) call message('kyvadlo: '//path%note)
      if (.not. allocated(error)) call integer_option(arguments, '--threads', 0, 1024, path%threads, error)
      if (.not. allocated(error)) call check_tolerance(path, option_given(arguments, '--check'), error)
      if (.not. allocated(error) .and. path%figures > 0 .and. is_netcdf_name(option_value(arguments, '--output', ''))) &
         call fail(error, code_input, 'option --accuracy below 1e-16 needs CSV: a NetCDF file (.nc) has doubles')
      if (.not. allocated(error) .and. option_given(arguments, '--explain')) call explain_scene(simulation, path, error)
      if (.not. allocated(error)) call run(arguments, simulation, path, error)
   end subroutine simulate_command

   !> A number above 0 that an option gives; how small it may be depends on the path.
   subroutine number_option(arguments, name, largest, range, value, error)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: name, range
      real(wp), intent(in) :: largest
      real(wp), allocatable, intent(out) :: value             !! Not allocated: not given
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what, text

      if (.not. option_given(arguments, name)) return
      allocate (value)
      text = option_value(arguments, name, '')
      call read_number(text, value, what)
      if (.not. allocated(what) .and. .not. (value > 0 .and. value <= largest)) what = 'out of range'
      if (allocated(what)) call fail(error, code_input, 'option '//name//' must be a number '//range//", got '"// &
         shown(text)//"' ("//what//')')
   end subroutine number_option

   !> What else can be said of the options before anything is written.
   subroutine check_options(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: files(2) = [character(len=8) :: '--output', '--events']
      integer :: i

      do i = 1, size(files)
         if (option_given(arguments, trim(files(i))) .and. option_value(arguments, trim(files(i)), '') == '') then
            call fail(error, code_input, 'option '//trim(files(i))//' needs the name of a file')
            return
         end if
      end do
      if (option_given(arguments, '--summary') .and. option_value(arguments, '--output', '') == '-') then
         call fail(error, code_input, 'option --summary: standard output has it; give --output the name of a file')
         return
      end if
      if (is_netcdf_name(option_value(arguments, '--output', ''))) then
#if defined(KYVADLO_WITH_NETCDF) || defined(KYVADLO_NETCDF_ELSEWHERE)
         if (option_given(arguments, '--events')) then
            call fail(error, code_input, 'option --events: a NetCDF file has the events in it')
            return
         end if
#endif
#ifdef KYVADLO_WITH_NETCDF
#elif defined(KYVADLO_NETCDF_ELSEWHERE)
         call become_program(KYVADLO_DATA_PROGRAM, 'NetCDF', error)
         return
#else
         call fail(error, code_unsupported, 'cannot write '//option_value(arguments, '--output', '') &
            //': this build has no NetCDF-Fortran (CMake finds it at configure time)')
         return
#endif
      end if
      if (option_value(arguments, '--events', '') == '-') then
         call fail(error, code_input, 'option --events needs the name of a file: standard output has the samples')
      else if (is_netcdf_name(option_value(arguments, '--events', ''))) then
         call fail(error, code_input, 'option --events writes CSV; with --output FILE.nc the events are in that file')
      end if
   end subroutine check_options

   !> Whether the files of the run, read and written, go together.
   subroutine check_all_files(arguments, simulation, files, error)
      type(arguments_type), intent(in) :: arguments
      type(simulation_type), intent(in) :: simulation
      type(run_files_type), intent(inout) :: files
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: tables(:)
      integer :: i

      call get_table_paths(simulation, tables)
      do i = 1, size(tables)
         call add_input(files, 'the table of the scene', tables(i)%text)
      end do
      if (option_given(arguments, '--output')) then
         call add_output(files, 'option --output', option_value(arguments, '--output', ''))
      else
         call add_output(files, 'standard output', '-')
      end if
      if (option_given(arguments, '--events')) &
         call add_output(files, 'option --events', option_value(arguments, '--events', ''))
      if (option_given(arguments, '--plot')) &
         call check_plot(option_value(arguments, '--plot', ''), simulation%pendulum%name, files, error)
      if (.not. allocated(error)) call check_files(files, error)
   end subroutine check_all_files

   !> Whether samples are written at all: a picture alone does not pour them over the terminal.
   logical function wants_samples(arguments)
      type(arguments_type), intent(in) :: arguments

      wants_samples = .not. is_terminal(1)
      if (option_given(arguments, '--output') .or. .not. option_given(arguments, '--plot')) wants_samples = .true.
      if (option_given(arguments, '--summary')) wants_samples = option_given(arguments, '--output')
   end function wants_samples

   !> Whether the integrator, and the check at a tenth, take the accuracy: rounding in a step is near 1e-15.
   subroutine check_tolerance(path, is_checked, error)
      type(path_type), intent(in) :: path
      logical, intent(in) :: is_checked
      type(error_type), allocatable, intent(out) :: error

      if (path%path /= path_integrated) return
      if (is_checked .and. .not. path%tolerance/10 >= 1e-15_wp) then
         call fail(error, code_input, &
            'option --accuracy must be at least 1e-14 beside --check, which takes a tenth of it, got '// &
            digits_text(path%tolerance, 2))
      else if (.not. path%tolerance >= 1e-15_wp) then
         call fail(error, code_input, 'option --accuracy must be at least 1e-15 for a scene that is integrated, got ' &
            //digits_text(path%tolerance, 2))
      end if
   end subroutine check_tolerance

   !> Opens the files, computes, and gives them their names when they are whole.
   subroutine run(arguments, simulation, path, error)
      type(arguments_type), intent(in) :: arguments
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      type(output_type), target :: output, events
      type(plot_samples_type), target :: plot
      type(summary_type), target :: summary
      logical :: has_events, has_plot

      has_events = option_given(arguments, '--events')
      has_plot = option_given(arguments, '--plot')
      call open_output(output, option_value(arguments, '--output', ''), error)
      if (allocated(error)) return
      if (has_events) call open_output(events, option_value(arguments, '--events', ''), error)
      if (allocated(error)) then
         call discard_output(output)
         return
      end if
      if (has_plot) call new_plot(plot, option_value(arguments, '--plot', ''), simulation%pendulum%name, &
         simulation%settings%samples, error)
      if (.not. allocated(error)) then
         call compute(arguments, simulation, path, output, events, plot, summary, error)
         if (has_plot .and. allocated(error)) call discard_plot(plot)
      end if
      if (option_given(arguments, '--summary') .and. .not. allocated(error)) then
         if (option_given(arguments, '--output')) call finish(output, error)
         if (option_given(arguments, '--output')) call open_output(output, '', error)
         if (.not. allocated(error)) call write_summary(summary, simulation, path, &
            option_value(arguments, '--summary', '') == 'json', output)
      end if
      call finish(output, error)
      if (has_events) call finish(events, error)
      if (has_plot .and. .not. allocated(error)) call finish_plot(plot, error)
   end subroutine run

   !> Computes the samples and writes them.
   subroutine compute(arguments, simulation, path, output, events, plot, summary, error)
      type(arguments_type), intent(in) :: arguments
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(output_type), intent(inout), target :: output
      type(output_type), intent(inout), target :: events     !! With --events
      type(plot_samples_type), intent(inout), target :: plot !! With --plot
      type(summary_type), intent(inout), target :: summary   !! With --summary
      type(error_type), allocatable, intent(out) :: error
      type(simulation_type) :: wanted
      type(csv_samples_type), target :: lines
      type(counting_sink_type), target :: nowhere   !! Samples beside events that alone are wanted
#ifdef KYVADLO_WITH_NETCDF
      type(netcdf_samples_type), target :: netcdf
      character(len=:), allocatable :: name
      logical :: is_netcdf
#endif
      class(sample_sink_type), pointer :: samples, picture, account
      type(watched_samples_type) :: watch
      type(check_type), allocatable :: check
      integer :: columns
      logical :: shows, with_samples, with_events

      with_samples = wants_samples(arguments)
      with_events = option_given(arguments, '--events')
      if (with_events .and. .not. with_samples) then
         lines = new_csv_samples(nowhere, events, path%threads, size(simulation%settings%events) > 0)
      else if (with_events) then
         lines = new_csv_samples(output, events, path%threads, size(simulation%settings%events) > 0)
      else
         lines = new_csv_samples(output, threads=path%threads)
      end if
      samples => null()
      if (with_samples .or. with_events) samples => lines
#ifdef KYVADLO_WITH_NETCDF
      is_netcdf = is_netcdf_name(option_value(arguments, '--output', ''))
      if (is_netcdf) then
         call get_unfinished_name(output, name)
         call new_netcdf(netcdf, name, simulation, path%method, error)
         if (allocated(error)) return
         samples => netcdf
      end if
#endif
      columns = size(columns_of(simulation))
      wanted = simulation
      shows = is_on_terminal(output)
      if (associated(samples) .and. shows) then
         shows = .false.
      else
         shows = is_terminal(2)
      end if
      picture => null()
      account => null()
      if (option_given(arguments, '--plot')) then
         if (all(simulation%settings%quantities /= quantity_position)) &
            wanted%settings%quantities = [simulation%settings%quantities, quantity_position]
         picture => plot
      end if
      if (option_given(arguments, '--summary')) then
         call new_summary(summary, simulation, path, wanted)
         account => summary
      end if
      watch = new_watch(samples, shows, simulation%settings%samples, columns, size(simulation%settings%events), &
         picture, account)
      if (option_given(arguments, '--check')) allocate (check)
      call simulate(wanted, path, watch, error, check, summary%extremes)
      call stop_watch(watch)
#ifdef KYVADLO_WITH_NETCDF
      if (is_netcdf .and. .not. allocated(error)) then
         call finish_netcdf(netcdf, error)
      else if (is_netcdf) then
         call discard_netcdf(netcdf)
      end if
#endif
      if (allocated(check) .and. .not. allocated(error)) call report_check(path, check)
   end subroutine compute

   !> Ends a file: whole, or after an error not at all.
   subroutine finish(output, error)
      type(output_type), intent(inout) :: output
      type(error_type), allocatable, intent(inout) :: error

      if (allocated(error)) then
         call discard_output(output)
      else
         call close_output(output, error)
      end if
   end subroutine finish

   !> What the second run said, on standard error.
   subroutine report_check(path, check)
      type(path_type), intent(in) :: path
      type(check_type), intent(in) :: check

      if (path%path == path_integrated) then
         call message('check: at a tenth of the accuracy, '//digits_text(path%tolerance/10, 2)//', places differ by ' &
            //digits_text(check%position, 3)//' m at most (t = '//digits_text(check%position_time, 4)// &
            ' s), velocities by '//digits_text(check%velocity, 3)//' m/s (t = '// &
            digits_text(check%velocity_time, 4)//' s)')
      else
         call message('check: nothing was integrated: '//path%method)
      end if
   end subroutine report_check

end module kyvadlo_simulate_command
