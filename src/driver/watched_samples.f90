!> Samples on their way to a file, watched: a line on the terminal says how far they are, and where only a picture is
!> wanted they end there.
module kyvadlo_watched_samples
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_samples, only: column_type, sample_sink_type, scene_event_type
   use kyvadlo_standard_io, only: terminal_width
   implicit none
   private
   public :: watched_samples_type, new_watch, stop_watch

   type, extends(sample_sink_type) :: watched_samples_type
      private
      class(sample_sink_type), pointer :: samples => null()  !! Not associated: only the picture is wanted
      class(sample_sink_type), pointer :: picture => null()  !! Not associated: none is drawn
      class(sample_sink_type), pointer :: summary => null()  !! Not associated: none is made
      integer :: requests = 0                          !! Events for `samples`; the summary may need more
      integer :: columns = 0                           !! Those for `samples`; the picture may need more
      integer(int64) :: total = 0, done = 0
      integer(int64) :: start = 0, last_line = 0       !! Counts of the clock
      logical :: shows = .false.                       !! To a terminal, which shows nothing else
      logical :: has_line = .false.
   contains
      procedure :: begin => begin_watched
      procedure :: take => take_watched
      procedure :: take_written => take_written_watched
      procedure :: note => note_watched
   end type watched_samples_type

   !> The first line after so many seconds, then so many between two.
   real(wp), parameter :: patience = 1, pause = 0.2_wp

contains

   !> Hands on to `samples`, if there are any, and to a picture; all must outlive the result.
   function new_watch(samples, shows, total, columns, requests, picture, summary) result(watch)
      class(sample_sink_type), intent(in), pointer :: samples
      logical, intent(in) :: shows                     !! Lines on the terminal
      integer(int64), intent(in) :: total              !! Samples that will come
      integer, intent(in) :: columns                   !! The first so many are those asked for
      integer, intent(in) :: requests                  !! The first so many events are those asked for
      class(sample_sink_type), intent(in), pointer :: picture, summary
      type(watched_samples_type) :: watch

      watch%samples => samples
      watch%total = total
      watch%columns = columns
      watch%requests = requests
      watch%picture => picture
      watch%summary => summary
      watch%shows = shows
      call system_clock(watch%start)
      watch%last_line = watch%start
   end function new_watch

   subroutine begin_watched(sink, columns)
      class(watched_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)

      if (associated(sink%samples)) call sink%samples%begin(columns(:sink%columns))
      if (associated(sink%picture)) call sink%picture%begin(columns)
      if (associated(sink%summary)) call sink%summary%begin(columns)
   end subroutine begin_watched

   subroutine take_watched(sink, values, goes_on)
      class(watched_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on

      goes_on = .true.
      if (associated(sink%summary)) call sink%summary%take(values, goes_on)
      if (associated(sink%picture)) call sink%picture%take(values, goes_on)
      if (associated(sink%samples)) call sink%samples%take(values(:, :sink%columns), goes_on)
      sink%done = sink%done + size(values, 1)
      if (sink%shows) call show(sink)
   end subroutine take_watched

   subroutine take_written_watched(sink, values, cells, goes_on)
      class(watched_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      character(len=*), intent(in) :: cells(:, :)
      logical, intent(out) :: goes_on

      goes_on = .true.
      if (associated(sink%summary)) call sink%summary%take(values, goes_on)
      if (associated(sink%picture)) call sink%picture%take(values, goes_on)
      if (associated(sink%samples)) call sink%samples%take_written(values(:, :sink%columns), cells(:, :sink%columns), &
         goes_on)
      sink%done = sink%done + size(values, 1)
      if (sink%shows) call show(sink)
   end subroutine take_written_watched

   subroutine note_watched(sink, event)
      class(watched_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event
      type(scene_event_type) :: seen

      if (associated(sink%summary)) call sink%summary%note(event)
      if (event%request > sink%requests) return
      seen = event
      if (allocated(seen%values)) seen%values = seen%values(:sink%columns)
      if (allocated(seen%cells)) seen%cells = seen%cells(:sink%columns)
      if (associated(sink%samples)) call sink%samples%note(seen)
      if (associated(sink%picture)) call sink%picture%note(seen)
   end subroutine note_watched

   !> `12 %  1.20E+06 samples/s  34 s left`, over the line before.
   subroutine show(watch)
      type(watched_samples_type), intent(inout) :: watch
      integer(int64) :: now, rate
      real(wp) :: seconds
      character(len=39) :: line

      call system_clock(now, rate)
      seconds = real(now - watch%start, wp)/rate
      if (seconds < patience .or. real(now - watch%last_line, wp)/rate < pause) return
      watch%last_line = now
      line = progress_line(real(watch%done, wp), real(watch%total, wp), seconds)
      write (error_unit, '(a)', advance='no') achar(13)//line(:min(len(line), terminal_width() - 1))
      flush (error_unit)
      watch%has_line = .true.
   end subroutine show

   !> What has been done and what is left; it fits 40 columns, however long that takes.
   pure function progress_line(done, total, seconds) result(line)
      real(wp), intent(in) :: done, total, seconds
      character(len=39) :: line
      real(wp), parameter :: in_seconds(4) = [1.0_wp, 60.0_wp, 3600.0_wp, 86400.0_wp]
      character(len=*), parameter :: names(4) = [character(len=3) :: 's', 'min', 'h', 'd']
      real(wp) :: left
      integer :: unit

      left = seconds*(total - done)/done
      unit = max(1, count(left >= 2*in_seconds))
      left = left/in_seconds(unit)
      if (left < 1e5_wp) then
         write (line, '(i0," %  ",es8.2," samples/s  ",i0,1x,a,a)') int(100*(done/total)), done/seconds, nint(left), &
            trim(names(unit)), ' left'
      else
         write (line, '(i0," %  ",es8.2," samples/s  ",es7.1,a)') int(100*(done/total)), done/seconds, left, ' d left'
      end if
   end function progress_line

   !> Takes the line away.
   subroutine stop_watch(watch)
      type(watched_samples_type), intent(inout) :: watch

      if (.not. watch%has_line) return
      write (error_unit, '(a)', advance='no') achar(13)//repeat(' ', min(39, terminal_width() - 1))//achar(13)
      flush (error_unit)
   end subroutine stop_watch

end module kyvadlo_watched_samples
