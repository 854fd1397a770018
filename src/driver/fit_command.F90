!> The command `fit`: from a scene and measurements to the pendulum, with error bars.
module kyvadlo_fit_command
   use kyvadlo_command_line, only: arguments_type, integer_option, option_given, option_value
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_explain_fit, only: explain_fit
   use kyvadlo_file_text, only: file_name, read_file
   use kyvadlo_fit, only: check_fit, fit_measurements, fit_result_type
   use kyvadlo_fit_data, only: fit_data_type, parse_fit_data
   use kyvadlo_fit_intervals, only: find_bootstrap, find_profile
   use kyvadlo_fit_json, only: write_fit_json
   use kyvadlo_fit_plot, only: plot_fit
   use kyvadlo_fit_report, only: write_fit_csv, write_fit_text, write_residuals
   use kyvadlo_fit_request, only: fit_request_type, parse_fit_request
   use kyvadlo_plot_samples, only: check_plot
   use kyvadlo_run_files, only: add_input, add_output, check_files, is_netcdf_name, run_files_type
   use kyvadlo_standard_io, only: close_output, message, open_output, output_type
#endif
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   implicit none
   private
   public :: fit_command

contains

   !> Runs the command. Files appear whole or not at all.
   subroutine fit_command(arguments, status, error)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: status                !! 0; 1: no minimum
      type(error_type), allocatable, intent(out) :: error
#ifdef KYVADLO_WITH_GSL
      type(fit_request_type) :: request
      type(fit_data_type) :: data
      type(fit_result_type) :: result
      integer :: i, copies, seed, threads

      status = 0
      call read_options(arguments, copies, seed, threads, error)
      if (.not. allocated(error)) call read_inputs(arguments, request, data, error)
      if (allocated(error)) return
      if (option_given(arguments, '--explain')) call explain_fit(request, data)
      call fit_measurements(request, data, result, error)
      if (allocated(error)) return
      if (allocated(result%notes)) then
         do i = 1, size(result%notes)
            call message('kyvadlo: '//result%notes(i)%text)
         end do
      end if
      if (result%is_converged) then
         if (option_given(arguments, '--profile')) call find_profile(result, request, data, threads)
         if (copies > 0) call find_bootstrap(result, request, data, copies, seed, threads)
      else
         status = 1
      end if
      call write_file(arguments, '--output', result, request, error)
      if (.not. allocated(error) .and. option_given(arguments, '--residuals')) &
         call write_file(arguments, '--residuals', result, request, error)
      if (allocated(error) .or. .not. option_given(arguments, '--plot')) return
      if (allocated(result%residual)) then
         call plot_fit(result, request, option_value(arguments, '--plot', ''), error)
      else
         call message('kyvadlo: no picture, as there is no fit')
      end if
#else
      status = 0
      call fail(error, code_unsupported, 'fit needs GSL, and this build has none')
#endif
   end subroutine fit_command

#ifdef KYVADLO_WITH_GSL
   !> Operands and options, as far as they can be judged alone.
   subroutine read_options(arguments, copies, seed, threads, error)
      type(arguments_type), intent(in) :: arguments
      integer, intent(out) :: copies, seed, threads
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: named(2) = [character(len=11) :: '--output', '--residuals']
      character(len=:), allocatable :: name
      integer :: i

      copies = 0
      seed = 1
      threads = 1
      if (size(arguments%operands) /= 2) then
         call fail(error, code_input, 'fit needs a scene and a table of data; - is standard input')
      else if (arguments%operands(1)%text == '-' .and. arguments%operands(2)%text == '-') then
         call fail(error, code_input, 'fit: the scene and the data cannot both be standard input')
      end if
      do i = 1, size(named)
         if (allocated(error)) return
         if (.not. option_given(arguments, trim(named(i)))) cycle
         name = option_value(arguments, trim(named(i)), '')
         if (name == '') then
            call fail(error, code_input, 'option '//trim(named(i))//' needs the name of a file')
         else if (is_netcdf_name(name)) then
            call fail(error, code_input, 'option '//trim(named(i))//': a fit is text; NetCDF (.nc) comes from simulate')
         end if
      end do
      if (.not. allocated(error)) call integer_option(arguments, '--bootstrap', 20, 1000000, copies, error)
      if (.not. allocated(error)) call integer_option(arguments, '--seed', 0, 999999999, seed, error)
      if (.not. allocated(error)) call integer_option(arguments, '--threads', 0, 1024, threads, error)
      if (allocated(error)) return
      if (copies > 0 .and. option_given(arguments, '--profile')) then
         call fail(error, code_input, 'options --profile and --bootstrap both give intervals; choose one')
      else if (copies == 0 .and. option_given(arguments, '--seed')) then
         call fail(error, code_input, 'option --seed is of --bootstrap')
      else if (copies == 0 .and. .not. option_given(arguments, '--profile') .and. option_given(arguments, &
         '--threads')) then
         call fail(error, code_input, 'option --threads shares the work of --profile and --bootstrap')
      end if
   end subroutine read_options

   !> The scene and the data, and that the files to be written are others.
   subroutine read_inputs(arguments, request, data, error)
      type(arguments_type), intent(in) :: arguments
      type(fit_request_type), intent(out) :: request
      type(fit_data_type), intent(out) :: data
      type(error_type), allocatable, intent(out) :: error
      type(run_files_type) :: files
      character(len=:), allocatable :: scene, table, pendulum

      if (option_given(arguments, '--pendulum')) pendulum = option_value(arguments, '--pendulum', '')
      associate (scene_path => arguments%operands(1)%text, data_path => arguments%operands(2)%text)
         call add_input(files, 'the scene', scene_path)
         call add_input(files, 'the data', data_path)
         call add_output(files, 'option --output', option_value(arguments, '--output', ''))
         if (option_given(arguments, '--residuals')) &
            call add_output(files, 'option --residuals', option_value(arguments, '--residuals', ''))
         call check_files(files, error)
         if (.not. allocated(error)) call read_file(scene_path, scene, error)
         if (.not. allocated(error)) call parse_fit_request(scene, file_name(scene_path), request, error, pendulum)
         if (.not. allocated(error) .and. option_given(arguments, '--plot')) then
            call check_plot(option_value(arguments, '--plot', ''), request%pendulum%name, files, error)
            if (.not. allocated(error)) call check_files(files, error)
         end if
         if (.not. allocated(error)) call read_file(data_path, table, error)
         if (.not. allocated(error)) call parse_fit_data(table, file_name(data_path), data, error)
      end associate
      if (.not. allocated(error)) call check_fit(request, data, error)
   end subroutine read_inputs

   !> What an option names: the answer or the residuals.
   subroutine write_file(arguments, option, result, request, error)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: option
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output

      call open_output(output, option_value(arguments, option, ''), error)
      if (allocated(error)) return
      if (option == '--residuals') then
         call write_residuals(result, request, output)
      else
         select case (option_value(arguments, '--format', 'text'))
         case ('json')
            call write_fit_json(result, request, output)
         case ('csv')
            call write_fit_csv(result, output)
         case default
            call write_fit_text(result, request, output)
         end select
      end if
      call close_output(output, error)
   end subroutine write_file
#endif

end module kyvadlo_fit_command
