!> An error of the integrator in the words of a scene: its file, line and group.
module kyvadlo_integration_failure
   use kyvadlo_integrator, only: failure_events, failure_short_step, failure_steps, failure_tangential, integration_type
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: digits_text, shortest_text
   use kyvadlo_scene_groups, only: air_group, output_group, string_group
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_simulation_path, only: path_type
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: explain_failure

contains

   !> What of the scene made an integration fail.
   subroutine explain_failure(simulation, path, run, error)
      type(simulation_type), intent(in) :: simulation
      type(path_type), intent(in) :: path
      type(integration_type), intent(in) :: run
      type(error_type), allocatable, intent(inout) :: error

      associate (settings => simulation%settings)
         select case (run%failure)
         case (failure_short_step)
            if (index(error%message, 'Reynolds') > 0) then
               error%message = place_of(settings%file, settings%line(air_group))//'&air: drag=''sphere'' ends at '// &
                  'the Reynolds number 2e5, which the bob passes at t = '//trim(digits_text(run%time, 6))//' s'
               return
            end if
            error%message = path%hardest//'no step is short enough at t = '//shortest_text(run%time) &
               //' s; the motion is singular there, or too fast for the accuracy (option --accuracy)'
         case (failure_steps)
            error%message = path%hardest//'the integration got to t = '//shortest_text(run%time)//' s in ' &
               //trim(digits_text(path%most_steps, 2))//' steps (option --most-steps); shorten &output duration'
         case (failure_tangential)
            error%message = place_of(settings%file, settings%line(output_group))// &
               '&output: there are no derivatives after t = '//shortest_text(run%time)// &
               ' s, where the string goes slack or taut tangentially'
         case (failure_events)
            error%message = place_of(settings%file, settings%line(string_group)) &
               //'&string: too many events, by t = '//shortest_text(run%time)//' s; shorten &output duration'
         case default
            error%message = settings%file//': '//error%message
         end select
      end associate
   end subroutine explain_failure

end module kyvadlo_integration_failure
