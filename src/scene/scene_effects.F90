!> The effects of a scene as the numerical part of the library takes them.
module kyvadlo_scene_effects
   use kyvadlo_effects, only: effects_type
   use kyvadlo_file_text, only: read_file
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: digits_text, read_number, shortest_text
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_pivot_table, only: new_pivot_table
#endif
   use kyvadlo_scene_groups, only: moving_pivot_group
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: lower_case, shown, split_words
   implicit none
   private
   public :: effects_of, get_table_path

   character(len=*), parameter :: line_feed = achar(10), &
      letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'

contains

   !> Reads the table of the pivot too. Errors: of that file.
   subroutine effects_of(simulation, effects, error, note)
      type(simulation_type), intent(in) :: simulation
      type(effects_type), intent(out) :: effects
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable, intent(out) :: note   !! Allocated where the table has a step

      effects = simulation%settings%effects
      if (allocated(simulation%settings%table)) call read_table(simulation, effects, error, note)
   end subroutine effects_of

   !> The path of the pivot's table, counted from the folder of the scene; not allocated where there is none.
   subroutine get_table_path(simulation, path)
      type(simulation_type), intent(in) :: simulation
      character(len=:), allocatable, intent(out) :: path

      if (.not. allocated(simulation%settings%table)) return
      path = simulation%settings%table
      if (path(1:1) /= '/') path = simulation%folder//path
   end subroutine get_table_path

   !> A table of the pivot: a line for each time, `t x y z` in s and m, separated by blanks or commas; blank lines, what
   !> follows a # or ! and a byte order mark are left out. A first line of words is a head: `t x y z`, and perhaps more,
   !> which is not read.
   subroutine read_table(simulation, effects, error, note)
      type(simulation_type), intent(in) :: simulation
      type(effects_type), intent(inout) :: effects
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable, intent(out) :: note
      character(len=:), allocatable :: text, path
      real(wp), allocatable :: rows(:, :), more(:, :)
      real(wp) :: row(4)
      integer :: first, last, line, count, found
      logical :: has_head

      call get_table_path(simulation, path)
      call read_file(path, text, error)
      if (allocated(error)) then
         error%message = place_of(simulation%settings%file, simulation%settings%line(moving_pivot_group)) &
            //'&moving_pivot: '//error%message
         return
      end if
      allocate (rows(4, 64))
      count = 0
      line = 0
      first = 1
      has_head = .false.
      if (index(text, char(239)//char(187)//char(191)) == 1) first = 4
      do while (first <= len(text))
         line = line + 1
         last = first + index(text(first:), line_feed) - 2
         if (last < first - 1) last = len(text)
         call read_row(text(first:last), count == 0 .and. .not. has_head, has_head, row, found, error)
         if (.not. allocated(error) .and. found > 0 .and. count > 0) then
            if (.not. row(1) > rows(1, count)) call fail(error, code_input, &
               'the times of the table must ascend, got '// shortest_text(row(1))//' after '// &
               shortest_text(rows(1, count)))
         end if
         if (allocated(error)) then
            error%message = place_of(path, line)//error%message
            return
         end if
         first = last + 2
         if (found == 0) cycle
         if (count == size(rows, 2)) then
            allocate (more(4, 2*count))
            more(:, :count) = rows
            call move_alloc(more, rows)
         end if
         count = count + 1
         rows(:, count) = row
      end do
#ifdef KYVADLO_WITH_GSL
      call new_pivot_table(effects, rows(1, :count), rows(2:, :count), error)
      if (allocated(error)) error%message = path//': '//error%message
#else
      ! Enough to say that there is one: without the integrator nothing comes of it.
      effects%pivot_times = rows(1, :count)
#endif
      if (.not. allocated(error)) call look_for_step(path, rows(:, :count), note)
   end subroutine read_table

   !> A spline overshoots far beside a step: where the pivot is a thousand times as fast as on the average.
   subroutine look_for_step(path, rows, note)
      character(len=*), intent(in) :: path
      real(wp), intent(in) :: rows(:, :)
      character(len=:), allocatable, intent(out) :: note
      real(wp) :: speed(size(rows, 2) - 1), distance(size(rows, 2) - 1)
      integer :: i

      do i = 1, size(speed)
         distance(i) = norm2(rows(2:, i + 1) - rows(2:, i))
         speed(i) = distance(i)/(rows(1, i + 1) - rows(1, i))
      end do
      i = maxloc(speed, 1)
      if (speed(i)*(rows(1, size(rows, 2)) - rows(1, 1)) > 1000*sum(distance)) &
         note = path//': a step: the pivot moves '//trim(digits_text(distance(i), 3))//' m from t = ' &
         //shortest_text(rows(1, i))//' to '//shortest_text(rows(1, i + 1))//' s; the spline overshoots beside it'
   end subroutine look_for_step

   !> Four numbers of a line, or the words of a head.
   subroutine read_row(line, may_be_head, has_head, row, count, error)
      character(len=*), intent(in) :: line
      logical, intent(in) :: may_be_head
      logical, intent(inout) :: has_head
      real(wp), intent(out) :: row(4)
      integer, intent(out) :: count                        !! Numbers found: 0 or 4
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: between = ' ,'//achar(9)//achar(13)
      character(len=:), allocatable :: what
      integer :: first, last, length

      row = 0
      count = 0
      length = scan(line, '#!') - 1
      if (length < 0) length = len(line)
      last = 0
      do
         first = verify(line(last + 1:length), between)
         if (first == 0) exit
         first = last + first
         last = first + scan(line(first:length), between) - 2
         if (last < first) last = length
         count = count + 1
         if (count > 4) exit
         if (may_be_head .and. count == 1 .and. verify(line(first:first), letters) == 0) then
            call read_head(line(:length), has_head, error)
            count = 0
            return
         end if
         call read_number(line(first:last), row(count), what)
         if (.not. allocated(what)) cycle
         call fail(error, code_input, 'a number is expected, got '//shown(line(first:last))//' ('//what//')')
         return
      end do
      if (count == 5 .and. has_head) count = 4
      if (count /= 0 .and. count /= 4) &
         call fail(error, code_input, 'a line of the table has 4 numbers, t x y z, got '//shown(line))
   end subroutine read_row

   !> A head begins with t, x, y, z: kyvadlo's own CSV.
   subroutine read_head(line, has_head, error)
      character(len=*), intent(in) :: line
      logical, intent(inout) :: has_head
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: first(:), last(:)
      character(len=:), allocatable :: blank, begin
      integer :: i, count

      blank = lower_case(line)
      do i = 1, len(blank)
         if (blank(i:i) == ',') blank(i:i) = ' '
      end do
      call split_words(blank, first, last, count)
      begin = ''
      do i = 1, min(count, 4)
         begin = begin//' '//blank(first(i):last(i))
      end do
      has_head = .true.
      if (begin /= ' t x y z') &
         call fail(error, code_input, 'a line of the table has 4 numbers, t x y z, or is a head t,x,y,z, got '// &
         shown(line))
   end subroutine read_head

end module kyvadlo_scene_effects
