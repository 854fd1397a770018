!> Samples as lines of CSV.
module kyvadlo_sample_text
   use kyvadlo_decimal, only: longest_decimal, put_shortest
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: padded_shortest, shortest_text
   use kyvadlo_samples, only: column_type, longest_cell, sample_sink_type, scene_event_type
   use kyvadlo_text, only: text_sink_type, text_type
   use kyvadlo_threads, only: thread_count
   implicit none
   private
   public :: csv_samples_type, new_csv_samples

   !> A head with the names of the columns, then a line for each sample; numbers in the shortest form that reads back
   !> exactly, nothing for what does not exist. Events are comment lines, or rows of a sheet of their own.
   type, extends(sample_sink_type) :: csv_samples_type
      private
      class(text_sink_type), pointer :: lines => null()
      class(text_sink_type), pointer :: events => null()     !! Not associated: events become comment lines
      logical :: with_values = .false.                       !! Their rows have the quantities
      logical, allocatable :: is_more(:)                     !! Columns that `event_head` has not
      type(text_type), allocatable :: strips(:)              !! Buffers
      integer :: threads = 1                                 !! 0: as many as OpenMP offers
   contains
      procedure :: begin => begin_csv
      procedure :: take => take_csv
      procedure :: take_written => take_written_csv
      procedure :: note => note_csv
   end type csv_samples_type

   character(len=*), parameter :: event_head = 't,event,x,y,z,energy_lost'
   character(len=*), parameter :: line_end = new_line('a')
   !> Threads share the work in strips of so many lines: 0.2 ms each.
   integer, parameter :: strip_size = 512

contains

   !> Lines to a sink that must outlive the result; events to another one if it is given.
   function new_csv_samples(lines, events, threads, with_values) result(sink)
      class(text_sink_type), intent(in), target :: lines
      class(text_sink_type), intent(in), target, optional :: events
      !> To share the lines of a long block: 1 if absent; 0 as many as OpenMP offers
      integer, intent(in), optional :: threads
      logical, intent(in), optional :: with_values   !! In the rows of the events asked for (default .false.)
      type(csv_samples_type) :: sink

      sink%lines => lines
      if (present(threads)) sink%threads = threads
      if (present(events)) sink%events => events
      if (present(with_values)) sink%with_values = with_values
   end function new_csv_samples

   subroutine begin_csv(sink, columns)
      class(csv_samples_type), intent(inout) :: sink
      type(column_type), intent(in) :: columns(:)
      character(len=:), allocatable :: line
      integer :: i

      line = trim(columns(1)%name)
      do i = 2, size(columns)
         line = line//','//trim(columns(i)%name)
      end do
      call sink%lines%put(line)
      if (.not. associated(sink%events)) return
      line = event_head
      sink%is_more = [(sink%with_values .and. all(columns(i)%name /= [character(len=1) :: 't', 'x', 'y', 'z']), &
         i=1, size(columns))]
      do i = 1, size(columns)
         if (sink%is_more(i)) line = line//','//trim(columns(i)%name)
      end do
      call sink%events%put(line)
   end subroutine begin_csv

   subroutine take_csv(sink, values, goes_on)
      class(csv_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      logical, intent(out) :: goes_on
      integer :: used((size(values, 1) + strip_size - 1)/strip_size)
      integer :: strip, sharing

      goes_on = .true.
      call make_room(sink, size(used), size(values, 2))
      sharing = thread_count(sink%threads, size(values, 1), size(used))
      !$omp parallel do schedule(dynamic) num_threads(sharing) if(sharing > 1)
      do strip = 1, size(used)
         call write_lines(values(strip_size*(strip - 1) + 1:min(strip_size*strip, size(values, 1)), :), &
            sink%strips(strip)%text, used(strip))
      end do
      do strip = 1, size(used)
         call sink%lines%put(sink%strips(strip)%text(:used(strip)))
      end do
   end subroutine take_csv

   subroutine take_written_csv(sink, values, cells, goes_on)
      class(csv_samples_type), intent(inout) :: sink
      real(wp), intent(in) :: values(:, :)
      character(len=*), intent(in) :: cells(:, :)
      logical, intent(out) :: goes_on
      character(len=size(cells, 2)*(len(cells) + 1)) :: line
      integer :: i, j

      goes_on = size(values, 1) == size(cells, 1)
      do i = 1, size(cells, 1)
         line = cells(i, 1)
         do j = 2, size(cells, 2)
            line = trim(line)//','//cells(i, j)
         end do
         call sink%lines%put(trim(line))
      end do
   end subroutine take_written_csv

   !> Buffers for so many strips.
   subroutine make_room(sink, strips, columns)
      type(csv_samples_type), intent(inout) :: sink
      integer, intent(in) :: strips, columns
      type(text_type), allocatable :: more(:)
      integer :: i, old

      old = 0
      if (allocated(sink%strips)) old = size(sink%strips)
      if (strips <= old) return
      allocate (more(strips))
      do i = 1, old
         call move_alloc(sink%strips(i)%text, more(i)%text)
      end do
      do i = old + 1, strips
         allocate (character(len=strip_size*columns*(longest_decimal + 1)) :: more(i)%text)
      end do
      call move_alloc(more, sink%strips)
   end subroutine make_room

   !> Some lines, the last without its end: the sink adds it.
   pure subroutine write_lines(values, buffer, used)
      real(wp), intent(in) :: values(:, :)
      character(len=*), intent(inout) :: buffer
      integer, intent(out) :: used
      integer :: i, j

      used = 0
      do i = 1, size(values, 1)
         do j = 1, size(values, 2)
            call put_number(values(i, j), buffer, used)
            if (j == size(values, 2)) exit
            used = used + 1
            buffer(used:used) = ','
         end do
         if (i == size(values, 1)) exit
         used = used + 1
         buffer(used:used) = line_end
      end do
   end subroutine write_lines

   subroutine note_csv(sink, event)
      class(csv_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event
      character(len=:), allocatable :: lost

      if (associated(sink%events)) then
         call put_event(sink, event)
      else
         lost = ''
         if (event%request == 0) lost = ', energy lost = '//shortest_text(event%energy_lost)//' m2/s2'
         call sink%lines%put('# '//trim(event%what)//': t = '//trim(event_text(event%cells, 1, event%time))// &
            ' s, x = '//trim(event_text(event%position_cells, 1, event%position(1)))//' m, y = '// &
            trim(event_text(event%position_cells, 2, event%position(2)))//' m, z = '// &
            trim(event_text(event%position_cells, 3, event%position(3)))//' m'//lost)
      end if
   end subroutine note_csv

   !> A number of an event: as text where that has more figures.
   pure function event_text(cells, i, value) result(text)
      character(len=*), intent(in), optional :: cells(:)     !! Not there: of the number
      integer, intent(in) :: i
      real(wp), intent(in) :: value
      character(len=longest_cell) :: text

      text = ''
      if (present(cells)) then
         text = cells(i)
      else if (value == value) then
         text = shortest_text(value + 0)   ! A zero loses its sign
      end if
   end function event_text

   !> A row of the sheet of events. One of the string has no quantities, one that was asked for loses no energy.
   subroutine put_event(sink, event)
      class(csv_samples_type), intent(inout) :: sink
      type(scene_event_type), intent(in) :: event
      character(len=:), allocatable :: row
      integer :: i

      row = trim(event_text(event%cells, 1, event%time))//','//trim(event%what)//','
      do i = 1, 3
         row = row//trim(event_text(event%position_cells, i, event%position(i)))//','
      end do
      if (event%request == 0) row = row//shortest_text(event%energy_lost)
      do i = 1, size(sink%is_more)
         if (.not. sink%is_more(i)) cycle
         row = row//','
         if (event%request == 0) cycle
         row = row//trim(event_text(event%cells, i, event%values(i)))
      end do
      call sink%events%put(row)
   end subroutine put_event

   !> Appends a number to a buffer.
   pure subroutine put_number(value, buffer, used)
      real(wp), intent(in) :: value
      character(len=*), intent(inout) :: buffer
      integer, intent(inout) :: used
      character(len=longest_decimal + 1) :: text
      integer :: length

      call put_shortest(value, buffer(used + 1:), length)
      if (length == 0 .and. value == value) then
         text = '0e+00'                          ! zero without a sign
         if (abs(value) > 0) text = padded_shortest(value)
         length = len_trim(text)
         buffer(used + 1:used + length) = text
      end if
      used = used + length
   end subroutine put_number

end module kyvadlo_sample_text
