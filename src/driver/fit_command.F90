!> The command `fit`: from a scene and measurements to the pendulum, with error bars.
module kyvadlo_fit_command
   use kyvadlo_command_line, only: arguments_type, option_given, option_value
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_file_text, only: file_name, read_file
   use kyvadlo_fit, only: fit_measurements, fit_result_type
   use kyvadlo_fit_data, only: fit_data_type, parse_fit_data
   use kyvadlo_fit_report, only: write_fit_csv, write_fit_json, write_fit_text, write_residuals
   use kyvadlo_fit_request, only: fit_request_type, parse_fit_request
   use kyvadlo_gsl, only: fgsl_error_handler_t, fgsl_set_error_handler_off
   use kyvadlo_run_files, only: add_input, add_output, check_files, run_files_type
   use kyvadlo_standard_io, only: close_output, discard_output, message, open_output, output_type
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
      type(run_files_type) :: files
      type(fit_request_type) :: request
      type(fit_data_type) :: data
      type(fit_result_type) :: result
      character(len=:), allocatable :: scene, table
      type(fgsl_error_handler_t) :: old
      integer :: i

      status = 0
      old = fgsl_set_error_handler_off()   ! A failure is a status, no end of the program.
      if (size(arguments%operands) /= 2) then
         call fail(error, code_input, 'fit needs a scene and a table of data; - is standard input')
         return
      end if
      associate (scene_path => arguments%operands(1)%text, data_path => arguments%operands(2)%text)
         call add_input(files, 'the scene', scene_path)
         call add_input(files, 'the data', data_path)
         call add_output(files, 'option --output', option_value(arguments, '--output', ''))
         if (option_given(arguments, '--residuals')) &
            call add_output(files, 'option --residuals', option_value(arguments, '--residuals', ''))
         call check_files(files, error)
         if (.not. allocated(error)) call read_file(scene_path, scene, error)
         if (.not. allocated(error)) call parse_fit_request(scene, file_name(scene_path), request, error)
         if (.not. allocated(error)) call read_file(data_path, table, error)
         if (.not. allocated(error)) call parse_fit_data(table, file_name(data_path), data, error)
      end associate
      if (.not. allocated(error)) call fit_measurements(request, data, result, error)
      if (allocated(error)) return
      if (allocated(result%notes)) then
         do i = 1, size(result%notes)
            call message('kyvadlo: '//data%file//': '//result%notes(i)%text)
         end do
      end if
      if (.not. result%is_converged) status = 1
      call write_file('--output', error)
      if (.not. allocated(error) .and. option_given(arguments, '--residuals')) call write_file('--residuals', error)

   contains

      subroutine write_file(option, error)
         character(len=*), intent(in) :: option
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
#else
      status = 0
      call fail(error, code_unsupported, 'fit needs GSL, and this build has none')
#endif
   end subroutine fit_command

end module kyvadlo_fit_command
