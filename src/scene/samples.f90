!> Who takes the samples of a simulation: block by block, with the events between them in the order of time.
module kyvadlo_samples
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: sample_sink_type, column_type, scene_event_type, longest_cell

   !> The longest number of 34 figures with its sign, point and exponent.
   integer, parameter :: longest_cell = 44

   !> A column of numbers.
   type :: column_type
      character(len=56) :: name = ''
      character(len=16) :: unit = ''     !! As UDUNITS writes it
      character(len=80) :: meaning = ''
   end type column_type

   !> Something that happened between two samples: to a string, or what an &event asks for.
   type :: scene_event_type
      real(wp) :: time = 0               !! [s]
      integer :: request = 0             !! Number of the &event; 0: of a string
      character(len=64) :: what = ''
      real(wp) :: position(3) = 0        !! [m]
      real(wp) :: energy_lost = 0        !! Per mass [m2/s2]
      real(wp), allocatable :: values(:) !! Of an &event: the columns of the samples there
      !> These, and the position, with figures that no double holds; not allocated: there are none
      character(len=longest_cell), allocatable :: cells(:), position_cells(:)
   end type scene_event_type

   type, abstract :: sample_sink_type
   contains
      procedure(begin_samples), deferred :: begin
      procedure(take_samples), deferred :: take
      procedure :: take_written
      procedure(note_event), deferred :: note
   end type sample_sink_type

   abstract interface
      !> Called once, before all others.
      subroutine begin_samples(sink, columns)
         import :: sample_sink_type, column_type
         class(sample_sink_type), intent(inout) :: sink
         type(column_type), intent(in) :: columns(:)     !! The first is the time
      end subroutine begin_samples

      !> Some samples.
      subroutine take_samples(sink, values, goes_on)
         import :: sample_sink_type, wp
         class(sample_sink_type), intent(inout) :: sink
         real(wp), intent(in) :: values(:, :)            !! (sample, column)
         logical, intent(out) :: goes_on                 !! .false.: no more are wanted
      end subroutine take_samples

      !> An event later than the samples before it, and not later than those that follow.
      subroutine note_event(sink, event)
         import :: sample_sink_type, scene_event_type
         class(sample_sink_type), intent(inout) :: sink
         type(scene_event_type), intent(in) :: event
      end subroutine note_event
   end interface

contains

   !> Some samples as text too, with figures that no double holds: for who writes them; others take the numbers.
   subroutine take_written(sink, values, cells, goes_on)
      class(sample_sink_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)            !! (sample, column)
      character(len=*), intent(in) :: cells(:, :)     !! The same; blank: does not exist
      logical, intent(out) :: goes_on                 !! .false.: no more are wanted

      call sink%take(values, goes_on)
      if (size(cells) == 0) goes_on = .false.
   end subroutine take_written

end module kyvadlo_samples
