!> Samples on their way to a file, watched: a line on the terminal says how far they are, and a full disk ends the run.
module kyvadlo_watched_samples
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_standard_io, only: has_failed, is_on_terminal, is_terminal, output_type
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: watched_samples_type, new_watch, stop_watch

   type, extends(sample_sink_type) :: watched_samples_type
      private
      class(sample_sink_type), pointer :: samples => null()
      class(sample_sink_type), pointer :: picture => null()  !! Not associated: none is drawn
      integer :: columns = 0                           !! Those for `samples`; the picture may need more
      type(output_type), pointer :: output => null()
      integer(int64) :: total = 0, done = 0
      integer(int64) :: start = 0, last_line = 0       !! Counts of the clock
      logical :: shows = .false.                       !! To a terminal, which shows nothing else
      logical :: has_line = .false.
   contains
      procedure :: begin => begin_watched
      procedure :: take => take_watched
      procedure :: note => note_watched
   end type watched_samples_type

   !> The first line after so many seconds, then so many between two.
   real(wp), parameter :: patience = 1, pause = 0.2_wp

contains

   !> Hands on to `samples`, which writes to `output`, and to a picture; all must outlive the result.
   function new_watch(samples, output, total, columns, picture) result(watch)
      class(sample_sink_type), intent(in), target :: samples
      type(output_type), intent(in), target :: output
      integer(int64), intent(in) :: total              !! Samples that will come
      integer, intent(in) :: columns                   !! The first so many are those asked for
      class(sample_sink_type), intent(in), target, optional :: picture
      type(watched_samples_type) :: watch

      watch%samples => samples
      watch%output => output
      watch%total = total
      watch%columns = columns
      if (present(picture)) watch%picture => picture
      watch%shows = is_terminal(2)
      if (is_on_terminal(output)) watch%shows = .false.
      call system_clock(watch%start)
      watch%last_line = watch%start
   end function new_watch

   subroutine begin_watched(sink, columns)
      class(watched_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      call sink%samples%begin(columns(:sink%columns))
      if (associated(sink%picture)) call sink%picture%begin(columns)
   end subroutine begin_watched

   subroutine take_watched(sink, values, goes_on)
      class(watched_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on

      if (associated(sink%picture)) call sink%picture%take(values, goes_on)
      call sink%samples%take(values(:, :sink%columns), goes_on)
      if (has_failed(sink%output)) goes_on = .false.
      sink%done = sink%done + size(values, 1)
      if (sink%shows) call show(sink)
   end subroutine take_watched

   subroutine note_watched(sink, event)
      class(watched_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event

      call sink%samples%note(event)
      if (associated(sink%picture)) call sink%picture%note(event)
   end subroutine note_watched

   !> `  12 %  1.2e+06 samples/s  34 s left`, over the line before.
   subroutine show(watch)
      type(watched_samples_type), intent(inout) :: watch
      integer(int64) :: now, rate
      real(wp) :: seconds
      character(len=48) :: line

      call system_clock(now, rate)
      seconds = real(now - watch%start, wp)/rate
      if (seconds < patience .or. real(now - watch%last_line, wp)/rate < pause) return
      watch%last_line = now
      line = integer_text(int(100*watch%done/watch%total))//' %  '//digits_text(watch%done/seconds, 3)//' samples/s  ' &
         //integer_text(nint(seconds*(watch%total - watch%done)/watch%done))//' s left'
      write (error_unit, '(a)', advance='no') achar(13)//line
      flush (error_unit)
      watch%has_line = .true.
   end subroutine show

   !> Takes the line away.
   subroutine stop_watch(watch)
      type(watched_samples_type), intent(inout) :: watch

      if (.not. watch%has_line) return
      write (error_unit, '(a)', advance='no') achar(13)//repeat(' ', 48)//achar(13)
      flush (error_unit)
   end subroutine stop_watch

end module kyvadlo_watched_samples
