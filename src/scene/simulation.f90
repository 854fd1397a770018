!> A scene to simulate: one pendulum, what acts on it, what is asked for.
module kyvadlo_simulation
   use kyvadlo_file_text, only: file_name, read_file
   use kyvadlo_namelist_file, only: group_type, parse_groups, place_of
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_reader, only: choose_pendulum, pendulums_from_groups
   use kyvadlo_scene_settings, only: settings_type
   use kyvadlo_scene_settings_reader, only: settings_from_groups
   use kyvadlo_status, only: code_input, error_type, fail
   implicit none
   private
   public :: simulation_type, read_simulation, parse_simulation

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
      if (.not. allocated(error)) simulation%pendulum = pendulums(1)
   end subroutine parse_simulation

end module kyvadlo_simulation
