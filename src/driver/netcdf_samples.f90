!> Samples as a NetCDF file, in the way of the CF conventions. The only source that knows NetCDF.
module kyvadlo_netcdf_samples
   use netcdf
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: code_file, code_unsupported, error_type, fail
   use kyvadlo_version, only: version
   implicit none
   private
   public :: netcdf_samples_type, new_netcdf, finish_netcdf, discard_netcdf

   !> A variable for each column over the dimension `time`, the events over `event`.
   type, extends(sample_sink_type) :: netcdf_samples_type
      private
      integer :: file = 0
      integer :: status = 0                            !! First one that was no success
      integer(int64) :: samples = 0                    !! That will come
      integer :: taken = 0, events = 0                 !! So far
      integer, allocatable :: variables(:)
      integer :: event_variables(6) = 0
      integer, allocatable :: value_variables(:)       !! Of the columns behind the time, at events asked for
      character(len=64), allocatable :: kinds(:)       !! What happens, by number
      logical :: has_requests = .false., may_end = .false. !! Events are asked for, one of which ends the simulation
      character(len=:), allocatable :: title, text, method
   contains
      procedure :: begin => begin_netcdf
      procedure :: take => take_netcdf
      procedure :: note => note_netcdf
   end type netcdf_samples_type

   !> What happens to a string.
   character(len=64), parameter :: kinds_of_string(4) = [character(len=64) :: 'slack', 'taut', 'rebound', &
      'taut after rattling']

contains

   !> Creates the file. `name` is where it is written until it is whole.
   subroutine new_netcdf(sink, name, simulation, method, error)
      type(netcdf_samples_type), intent(out) :: sink
      character(len=*), intent(in) :: name
      type(simulation_type), intent(in) :: simulation
      character(len=*), intent(in) :: method           !! How the samples are computed, in words
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      sink%title = simulation%pendulum%name
      sink%text = simulation%text
      sink%method = method
      sink%samples = simulation%settings%samples
      sink%kinds = kinds_of_string
      do i = 1, size(simulation%settings%events)
         sink%kinds = [sink%kinds, simulation%settings%events(i)%names]
      end do
      sink%has_requests = size(simulation%settings%events) > 0
      sink%may_end = any(simulation%settings%events%stops)
      if (sink%samples > huge(0)) then
         call fail(error, code_unsupported, 'a NetCDF file takes 2147483647 samples; write CSV')
         return
      end if
      call keep(sink, nf90_create(name, ior(NF90_CLOBBER, NF90_NETCDF4), sink%file))
      if (sink%status /= NF90_NOERR) call fail(error, code_file, 'NetCDF: '//trim(nf90_strerror(sink%status)))
   end subroutine new_netcdf

   !> Dimensions, variables, attributes.
   subroutine begin_netcdf(sink, columns)
      class(netcdf_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)
      integer :: time, event, i, j
      character(len=:), allocatable :: meanings

      call keep(sink, nf90_def_dim(sink%file, 'time', merge(NF90_UNLIMITED, int(sink%samples), sink%may_end), time))
      call keep(sink, nf90_def_dim(sink%file, 'event', NF90_UNLIMITED, event))
      call put_text(sink, NF90_GLOBAL, 'Conventions', 'CF-1.10')
      call put_text(sink, NF90_GLOBAL, 'title', sink%title)
      call put_text(sink, NF90_GLOBAL, 'source', 'kyvadlo '//version//': '//sink%method)
      call put_text(sink, NF90_GLOBAL, 'scene', sink%text)
      allocate (sink%variables(size(columns)))
      do i = 1, size(columns)
         if (i == 1) then
            call keep(sink, nf90_def_var(sink%file, 'time', NF90_DOUBLE, [time], sink%variables(i)))
            call put_text(sink, sink%variables(i), 'axis', 'T')
         else
            call keep(sink, nf90_def_var(sink%file, trim(columns(i)%name), NF90_DOUBLE, [time], sink%variables(i)))
         end if
         call put_text(sink, sink%variables(i), 'units', trim(columns(i)%unit))
         call put_text(sink, sink%variables(i), 'long_name', trim(columns(i)%meaning))
      end do
      call define_event(1, 'event_time', NF90_DOUBLE, 's', 'time of an event')
      call define_event(2, 'event_x', NF90_DOUBLE, 'm', 'its place')
      call define_event(3, 'event_y', NF90_DOUBLE, 'm', 'its place')
      call define_event(4, 'event_z', NF90_DOUBLE, 'm', 'its place')
      call define_event(5, 'event_energy_lost', NF90_DOUBLE, 'm2 s-2', 'energy per mass that a string lost')
      call define_event(6, 'event_kind', NF90_INT, '1', 'what happened')
      call keep(sink, nf90_put_att(sink%file, sink%event_variables(6), 'flag_values', [(i, i=1, size(sink%kinds))]))
      meanings = ''
      do i = 1, size(sink%kinds)
         meanings = meanings//' '//trim(sink%kinds(i))
         do j = len(meanings) - len_trim(sink%kinds(i)) + 1, len(meanings)
            if (meanings(j:j) == ' ') meanings(j:j) = '_'
         end do
      end do
      call put_text(sink, sink%event_variables(6), 'flag_meanings', meanings(2:))
      allocate (sink%value_variables(size(columns)), source=0)
      do i = 2, merge(size(columns), 0, sink%has_requests)
         if (any(columns(i)%name == ['x', 'y', 'z'])) cycle
         call keep(sink, nf90_def_var(sink%file, 'event_'//trim(columns(i)%name), NF90_DOUBLE, [event], &
            sink%value_variables(i)))
         call put_text(sink, sink%value_variables(i), 'units', trim(columns(i)%unit))
         call put_text(sink, sink%value_variables(i), 'long_name', 'at events asked for: '//trim(columns(i)%meaning))
      end do
      call keep(sink, nf90_enddef(sink%file))

   contains

      subroutine define_event(i, name, kind, unit, meaning)
         integer, intent(in) :: i, kind
         character(len=*), intent(in) :: name, unit, meaning

         call keep(sink, nf90_def_var(sink%file, name, kind, [event], sink%event_variables(i)))
         call put_text(sink, sink%event_variables(i), 'units', unit)
         call put_text(sink, sink%event_variables(i), 'long_name', meaning)
      end subroutine define_event
   end subroutine begin_netcdf

   subroutine put_text(sink, variable, name, text)
      class(netcdf_samples_type), intent(inout) :: sink
      integer, intent(in) :: variable
      character(len=*), intent(in) :: name, text

      call keep(sink, nf90_put_att(sink%file, variable, name, text))
   end subroutine put_text

   subroutine take_netcdf(sink, values, goes_on)
      class(netcdf_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      integer :: i

      do i = 1, size(values, 2)
         call keep(sink, nf90_put_var(sink%file, sink%variables(i), values(:, i), start=[sink%taken + 1], &
            count=[size(values, 1)]))
      end do
      sink%taken = sink%taken + size(values, 1)
      goes_on = sink%status == NF90_NOERR
   end subroutine take_netcdf

   subroutine note_netcdf(sink, event)
      class(netcdf_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event
      real(wp) :: numbers(5), value
      integer :: i

      sink%events = sink%events + 1
      numbers = [event%time, event%position, event%energy_lost]
      if (event%request > 0) numbers(5) = quiet_nan_real64
      do i = 1, 5
         call keep(sink, nf90_put_var(sink%file, sink%event_variables(i), numbers(i:i), start=[sink%events], count=[1]))
      end do
      call keep(sink, nf90_put_var(sink%file, sink%event_variables(6), [findloc(sink%kinds == event%what, .true., 1)], &
         start=[sink%events], count=[1]))
      do i = 1, size(sink%value_variables)
         if (sink%value_variables(i) == 0) cycle
         value = quiet_nan_real64
         if (event%request > 0) value = event%values(i)
         call keep(sink, nf90_put_var(sink%file, sink%value_variables(i), [value], start=[sink%events], count=[1]))
      end do
   end subroutine note_netcdf

   !> Ends the file; it has its final name only after that. Error: the first that NetCDF reported.
   subroutine finish_netcdf(sink, error)
      type(netcdf_samples_type), intent(inout) :: sink
      type(error_type), allocatable, intent(out) :: error

      call keep(sink, nf90_close(sink%file))
      if (sink%status /= NF90_NOERR) call fail(error, code_file, 'NetCDF: '//trim(nf90_strerror(sink%status)))
   end subroutine finish_netcdf

   !> Lets go of the file.
   subroutine discard_netcdf(sink)
      type(netcdf_samples_type), intent(inout) :: sink

      sink%status = nf90_close(sink%file)
   end subroutine discard_netcdf

   !> Remembers the first failure.
   subroutine keep(sink, status)
      class(netcdf_samples_type), intent(inout) :: sink
      integer, intent(in) :: status

      if (sink%status == NF90_NOERR) sink%status = status
   end subroutine keep

end module kyvadlo_netcdf_samples
