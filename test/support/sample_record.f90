!> A sink of samples that keeps them, for tests.
module sample_record
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_simulate, only: simulate
   use kyvadlo_simulation, only: parse_simulation, simulation_type
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: record_type, run_scene, column

   type, extends(sample_sink_type) :: record_type
      type(column_type), allocatable :: columns(:)
      real(real64), allocatable :: values(:, :)            !! (sample, column)
      type(scene_event_type), allocatable :: events(:)
      integer, allocatable :: samples_before(:)            !! (event)
      integer :: path = 0                                  !! That was chosen
      integer :: most = huge(0)                            !! Ends the run after so many samples
   contains
      procedure :: begin => begin_record
      procedure :: take => take_record
      procedure :: note => note_record
   end type record_type

contains

   !> Simulates the scene in a text; on failure the message.
   subroutine run_scene(text, record, message)
      character(len=*), intent(in) :: text
      type(record_type), intent(inout) :: record
      character(len=:), allocatable, intent(out) :: message !! Empty: no error
      type(simulation_type) :: simulation
      type(path_type) :: path
      type(error_type), allocatable :: error

      message = ''
      call parse_simulation(text, 'f', simulation, error)
      if (.not. allocated(error)) call choose_path(simulation, path, error)
      if (.not. allocated(error)) call simulate(simulation, path, record, error)
      if (allocated(error)) message = error%message
      record%path = path%path
   end subroutine run_scene

   !> The values under a name.
   function column(record, name) result(values)
      type(record_type), intent(in) :: record
      character(len=*), intent(in) :: name
      real(real64), allocatable :: values(:)

      values = record%values(:, findloc(record%columns%name == name, .true., 1))
   end function column

   subroutine begin_record(sink, columns)
      class(record_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      sink%columns = columns
      if (allocated(sink%values)) deallocate (sink%values, sink%events, sink%samples_before)
      allocate (sink%values(0, size(columns)), sink%events(0), sink%samples_before(0))
   end subroutine begin_record

   subroutine take_record(sink, values, goes_on)
      class(record_type), intent(inout) :: sink
      real(real64), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      real(real64), allocatable :: more(:, :)
      integer :: old

      old = size(sink%values, 1)
      allocate (more(old + size(values, 1), size(values, 2)))
      more(:old, :) = sink%values
      more(old + 1:, :) = values
      call move_alloc(more, sink%values)
      goes_on = size(sink%values, 1) < sink%most
   end subroutine take_record

   subroutine note_record(sink, event)
      class(record_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      sink%events = [sink%events, event]
      sink%samples_before = [sink%samples_before, size(sink%values, 1)]
   end subroutine note_record

end module sample_record
