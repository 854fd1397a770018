!> The program `kyvadlo`: the only code that opens standard output, ends with a status and writes messages.
program kyvadlo_main
   use kyvadlo_command_line, only: arguments_type, option_given, read_command_line, write_help
   use kyvadlo_eval_command, only: eval_command
   use kyvadlo_fit_command, only: fit_command
   use kyvadlo_help_command, only: examples_command, help_command
   use kyvadlo_help_pages, only: write_completion, write_manual_page
   use kyvadlo_help_topics, only: write_scene_page
   use kyvadlo_simulate_command, only: simulate_command
   use kyvadlo_standard_io, only: close_output, end_program, message, open_output, output_type, prepare_program
   use kyvadlo_status, only: error_type
   use kyvadlo_study_command, only: study_command
   use kyvadlo_sweep_command, only: sweep_command
   use kyvadlo_table_command, only: table_command
   use kyvadlo_version, only: compiler, compiler_flags, licence, version
   implicit none

   integer :: exit_status

   call run(exit_status)
   call end_program(exit_status)

contains

   !> Everything; procedures free what they allocate, the main program would not.
   subroutine run(status)
      integer, intent(out) :: status   !! 0, 1 if a request failed, 2 on wrong usage or input
      type(arguments_type) :: arguments
      type(error_type), allocatable :: error
      type(output_type) :: output

      status = 0
      call prepare_program(error)
      if (.not. allocated(error)) call read_command_line(arguments, error)
      if (.not. allocated(error)) then
         if (option_given(arguments, '--help') .or. arguments%command == '' .and. size(arguments%names) > 0) then
            call open_output(output, '', error)
            if (option_given(arguments, '--help')) then
               call write_help(output, arguments%command)
            else if (option_given(arguments, '--version')) then
               call write_version(output)
            else if (option_given(arguments, '--manual-page')) then
               call write_manual_page(output)
            else if (option_given(arguments, '--scene-page')) then
               call write_scene_page(output, version)
            else
               call write_completion(output)
            end if
            call close_output(output, error)
         else
            select case (arguments%command)
            case ('eval')
               call eval_command(arguments, status, error)
            case ('fit')
               call fit_command(arguments, status, error)
            case ('table')
               call table_command(arguments, error)
            case ('simulate')
               call simulate_command(arguments, error)
            case ('help')
               call help_command(arguments, error)
            case ('examples')
               call examples_command(arguments, error)
            case ('sweep')
               call sweep_command(arguments, status, error)
            case ('study')
               call study_command(arguments, error)
            case default
               call message('kyvadlo: no command; kyvadlo --help lists them')
               status = 2
            end select
         end if
      end if
      if (allocated(error)) then
         call message('kyvadlo: '//error%message)
         status = 2
      end if
   end subroutine run

   subroutine write_version(output)
      type(output_type), intent(inout) :: output

      call output%put('kyvadlo '//version)
      call output%put('Licence: '//licence)
      call output%put('Compiler: '//compiler)
      call output%put('Flags: '//compiler_flags)
   end subroutine write_version

end program kyvadlo_main
