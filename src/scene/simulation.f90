!> A scene to simulate: one pendulum, what acts on it, what is asked for.
module kyvadlo_simulation
   use kyvadlo_file_text, only: file_name, read_file
   use kyvadlo_namelist_file, only: group_type, parse_groups, place_of
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_quantities, only: quantity_derivatives
   use kyvadlo_scene, only: body_names, pendulum_type
   use kyvadlo_scene_derivatives, only: derivative_type, parse_derivatives
   use kyvadlo_scene_groups, only: body_group, pendulum_group, settings, starts
   use kyvadlo_scene_reader, only: choose_pendulum, pendulums_from_groups
   use kyvadlo_scene_settings, only: settings_type
   use kyvadlo_scene_settings_reader, only: set_effects, settings_from_groups
   use kyvadlo_status, only: code_input, error_type, fail
   implicit none
   private
   public :: simulation_type, read_simulation, parse_simulation, change_setting

   type :: simulation_type
      type(pendulum_type) :: pendulum
      type(settings_type) :: settings
      character(len=:), allocatable :: text      !! Of the scene file, for the record
      character(len=:), allocatable :: folder    !! Where the files it names lie: empty, or with its slash
   end type simulation_type

contains

   !> Reads a scene. Errors (`code_file`, `code_input`): those of `read_scene` and of the groups beside &pendulum; more
   !> than one pendulum.
   subroutine read_simulation(path, simulation, error, pendulum)
      character(len=*), intent(in) :: path                  !! `-`: standard input
      type(simulation_type), intent(out) :: simulation
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in), optional :: pendulum    !! Its name or number
      character(len=:), allocatable :: text

      call read_file(path, text, error)
      if (.not. allocated(error)) call parse_simulation(text, file_name(path), simulation, error, pendulum)
      simulation%folder = path(:index(path, '/', back=.true.))
   end subroutine read_simulation

   !> The scene in a text.
   pure subroutine parse_simulation(text, file, simulation, error, pendulum)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: file                  !! Name for messages
      type(simulation_type), intent(out) :: simulation
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in), optional :: pendulum    !! Its name or number
      type(group_type), allocatable :: groups(:)
      type(pendulum_type), allocatable :: pendulums(:)

      simulation%text = text
      simulation%folder = ''
      call parse_groups(text, file, groups, error)
      if (allocated(error)) return
      call settings_from_groups(groups, file, simulation%settings, error)
      if (allocated(error)) return
      call pendulums_from_groups(groups, file, pendulums, error)
      if (allocated(error)) return
      if (present(pendulum)) then
         call choose_pendulum(pendulums, pendulum, error)
      else if (size(pendulums) > 1) then
         call fail(error, code_input, place_of(file, pendulums(2)%line)//'a second &pendulum; choose it by --pendulum')
      end if
      if (allocated(error)) return
      simulation%pendulum = pendulums(1)
      associate (chosen => simulation%settings)
         if (all(chosen%quantities /= quantity_derivatives)) return
         call parse_derivatives(chosen%derivatives_typed, chosen, simulation%pendulum, chosen%derivatives, error)
         if (allocated(error)) error%message = place_of(file, chosen%derivatives_line)//'&output: derivatives: '// &
            error%message
      end associate
   end subroutine parse_simulation

   !> Gives a number of a scene another value, in its own unit. What else it may be, is checked when it is computed.
   pure subroutine change_setting(simulation, which, value)
      type(simulation_type), intent(inout) :: simulation
      type(derivative_type), intent(in) :: which
      real(wp), intent(in) :: value
      integer :: i

      associate (pendulum => simulation%pendulum, name => settings(which%setting)%name)
         if (settings(which%setting)%group /= pendulum_group) then
            simulation%settings%number(which%element, which%setting) = value
            do i = 1, size(body_names)
               if (settings(which%setting)%group == body_group .and. name == body_names(i)) &
                  pendulum%body(i)%text = shortest_text(value)
            end do
            call set_effects(simulation%settings)
         else if (name == 'length') then
            pendulum%length%text = shortest_text(value)
         else if (name == 'gravity') then
            pendulum%gravity%text = shortest_text(value)
         else if (name == starts(pendulum%start)%first) then
            pendulum%first(which%element)%text = shortest_text(value)
         else
            pendulum%second(which%element)%text = shortest_text(value)
         end if
      end associate
   end subroutine change_setting

end module kyvadlo_simulation
