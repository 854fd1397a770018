!> The effects of a scene as the numerical part of the library takes them.
module kyvadlo_scene_effects
   use kyvadlo_effects, only: effects_type
   use kyvadlo_file_text, only: read_file
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: digits_text, read_number, shortest_text
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_motion_tables, only: new_hoist_table, new_pivot_table
#endif
   use kyvadlo_scene_groups, only: group_names, hoist_group, moving_pivot_group
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: append, integer_text, lower_case, shown, split_words, text_type
   implicit none
   private
   public :: effects_of, get_table_paths

   character(len=*), parameter :: line_feed = achar(10), &
      letters = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'

contains

   !> Reads the tables too. Errors: of those files.
   subroutine effects_of(simulation, effects, error, note, first_length)
      type(simulation_type), intent(in) :: simulation
      type(effects_type), intent(out) :: effects
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable, intent(out) :: note   !! Allocated where the table has a step
      real(wp), intent(out), optional :: first_length      !! At time 0, of a table of lengths; 0 without one [m]
      real(wp), allocatable :: rows(:, :)
      character(len=:), allocatable :: path

      effects = simulation%settings%effects
      if (present(first_length)) first_length = 0
      if (allocated(simulation%settings%table)) then
         path = path_of(simulation, simulation%settings%table)
         associate (order => simulation%settings%table_order)
            if (order == 0) call read_table(simulation, moving_pivot_group, path, ' t x y z', rows, error)
            if (order == 1) call read_table(simulation, moving_pivot_group, path, ' t vx vy vz', rows, error)
            if (order == 2) call read_table(simulation, moving_pivot_group, path, ' t ax ay az', rows, error)
         end associate
#ifdef KYVADLO_WITH_GSL
         if (.not. allocated(error)) call new_pivot_table(effects, rows(1, :), rows(2:, :), error, &
            simulation%settings%table_order, simulation%settings%table_is_linear)
#else
         ! Enough to say that there is one: without the integrator nothing comes of it.
         if (.not. allocated(error)) effects%pivot_times = rows(1, :)
#endif
         call say_where(path, error)
         if (.not. allocated(error) .and. simulation%settings%table_order == 0 .and. &
            .not. simulation%settings%table_is_linear) call look_for_step(path, rows, note)
      end if
      if (allocated(simulation%settings%hoist_table) .and. .not. allocated(error)) then
         path = path_of(simulation, simulation%settings%hoist_table)
         call read_table(simulation, hoist_group, path, ' t length', rows, error)
#ifdef KYVADLO_WITH_GSL
         if (.not. allocated(error)) call new_hoist_table(effects, rows(1, :), rows(2, :), error, first_length)
#else
         if (.not. allocated(error)) effects%hoist%times = rows(1, :)
#endif
         call say_where(path, error)
      end if
   end subroutine effects_of

   !> Errors of a table as a whole.
   subroutine say_where(path, error)
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(inout) :: error

      if (.not. allocated(error)) return
      if (index(error%message, path) == 0) error%message = path//': '//error%message
   end subroutine say_where

   !> The paths of the tables, counted from the folder of the scene.
   subroutine get_table_paths(simulation, paths)
      type(simulation_type), intent(in) :: simulation
      type(text_type), allocatable, intent(out) :: paths(:)

      allocate (paths(0))
      if (allocated(simulation%settings%table)) call append(paths, path_of(simulation, simulation%settings%table))
      if (allocated(simulation%settings%hoist_table)) call append(paths, path_of(simulation, &
         simulation%settings%hoist_table))
   end subroutine get_table_paths

   pure function path_of(simulation, table) result(path)
      type(simulation_type), intent(in) :: simulation
      character(len=*), intent(in) :: table
      character(len=len(table) + merge(0, len(simulation%folder), table(1:1) == '/')) :: path

      path = table
      if (table(1:1) /= '/') path = simulation%folder//table
   end function path_of

   !> A table: a line for each time, `t x y z` or other names, SI units, separated by blanks or commas; blank lines,
   !> what follows a # or ! and a byte order mark are left out. A first line of words is a head: those names, and
   !> perhaps more, whose columns are not read.
   subroutine read_table(simulation, group, path, names, rows, error)
      type(simulation_type), intent(in) :: simulation
      integer, intent(in) :: group                         !! That asks for it
      character(len=*), intent(in) :: path
      character(len=*), intent(in) :: names                !! Of the columns, a blank before each
      real(wp), allocatable, intent(out) :: rows(:, :)     !! (columns, n)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      real(wp), allocatable :: more(:, :), row(:)
      integer :: first, last, line, count, found, columns, i
      logical :: has_head

      call read_file(path, text, error)
      if (allocated(error)) then
         error%message = place_of(simulation%settings%file, simulation%settings%line(group))//'&'// &
            trim(group_names(group))//': '//error%message
         return
      end if
      columns = 0
      do i = 1, len(names)
         if (names(i:i) == ' ') columns = columns + 1
      end do
      allocate (rows(columns, 64), row(columns))
      count = 0
      line = 0
      first = 1
      has_head = .false.
      if (index(text, char(239)//char(187)//char(191)) == 1) first = 4
      do while (first <= len(text))
         line = line + 1
         last = first + index(text(first:), line_feed) - 2
         if (last < first - 1) last = len(text)
         call read_row(text(first:last), count == 0 .and. .not. has_head, names, has_head, row, found, error)
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
            allocate (more(columns, 2*count))
            more(:, :count) = rows
            call move_alloc(more, rows)
         end if
         count = count + 1
         rows(:, count) = row
      end do
      rows = rows(:, :count)
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

   !> The numbers of a line, or the words of a head.
   subroutine read_row(line, may_be_head, names, has_head, row, count, error)
      character(len=*), intent(in) :: line
      logical, intent(in) :: may_be_head
      character(len=*), intent(in) :: names                !! Of the columns, a blank before each
      logical, intent(inout) :: has_head
      real(wp), intent(out) :: row(:)
      integer, intent(out) :: count                        !! Numbers found: none or all
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
         if (count > size(row)) exit
         if (may_be_head .and. count == 1 .and. verify(line(first:first), letters) == 0) then
            call read_head(line(:length), names, size(row), has_head, error)
            count = 0
            return
         end if
         call read_number(line(first:last), row(count), what)
         if (.not. allocated(what)) cycle
         call fail(error, code_input, 'a number is expected, got '//shown(line(first:last))//' ('//what//')')
         return
      end do
      if (count == size(row) + 1 .and. has_head) count = size(row)
      if (count /= 0 .and. count /= size(row)) call fail(error, code_input, 'a line of the table has '// &
         integer_text(size(row))//' numbers,'//names//', got '//shown(line))
   end subroutine read_row

   !> A head begins with those names, as kyvadlo's own CSV does.
   subroutine read_head(line, names, columns, has_head, error)
      character(len=*), intent(in) :: line, names
      integer, intent(in) :: columns
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
      do i = 1, min(count, columns)
         begin = begin//' '//blank(first(i):last(i))
      end do
      has_head = .true.
      if (begin == names) return
      blank = names(2:)
      do i = 1, len(blank)
         if (blank(i:i) == ' ') blank(i:i) = ','
      end do
      call fail(error, code_input, 'a line of the table has '//integer_text(columns)//' numbers,'//names// &
         ', or is a head '//blank//', got '//shown(line))
   end subroutine read_head

end module kyvadlo_scene_effects
