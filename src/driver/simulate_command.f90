!> The command `simulate`: one scene, its samples as CSV.
module kyvadlo_simulate_command
   use kyvadlo_command_line, only: arguments_type, option_given, option_value
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: read_simulation, simulation_type
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_standard_io, only: close_output, discard_output, open_output, output_type
   use kyvadlo_status, only: code_input, error_type, fail
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

      if (size(arguments%operands) /= 1) then
         call fail(error, code_input, 'simulate needs one scene file, or - for standard input')
         return
      end if
      call read_simulation(arguments%operands(1)%text, simulation, error)
      if (.not. allocated(error)) call choose_path(simulation, path, error)
      if (.not. allocated(error)) call check_options(arguments, error)
      if (.not. allocated(error)) call run(arguments, simulation, path, error)
   end subroutine simulate_command

   !> What can be said of the options before anything is written.
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
      if (option_given(arguments, '--events') .and. option_value(arguments, '--events', '') == '-') &
         call fail(error, code_input, 'option --events needs the name of a file: standard output has the samples')
   end subroutine check_options

   !> Computes and writes.
   subroutine run(arguments, simulation, path, error)
      type(arguments_type), intent(in) :: arguments
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      type(output_type), target :: output, events
      type(csv_samples_type), target :: samples
      type(watched_samples_type) :: watch
      logical :: has_events

      has_events = option_given(arguments, '--events')
      call open_output(output, option_value(arguments, '--output', ''), error)
      if (allocated(error)) return
      if (has_events) call open_output(events, option_value(arguments, '--events', ''), error)
      if (allocated(error)) then
         call discard_output(output)
         return
      end if
      if (has_events) then
         samples = new_csv_samples(output, events)
      else
         samples = new_csv_samples(output)
      end if
      watch = new_watch(samples, output, simulation%settings%samples)
      call simulate(simulation, path, watch, error)
      call stop_watch(watch)
      if (.not. allocated(error)) then
         call close_output(output, error)
      else
         call discard_output(output)
      end if
      if (.not. has_events) return
      if (.not. allocated(error)) then
         call close_output(events, error)
      else
         call discard_output(events)
      end if
   end subroutine run

end module kyvadlo_simulate_command
