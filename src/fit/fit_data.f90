!> Measurements: a table of numbers, as text or as arrays, each with its standard deviation.
module kyvadlo_fit_data
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: read_number
   use kyvadlo_numbers, only: is_finite, is_nan, quiet_nan_real64
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, lower_case, shown
   implicit none
   private
   public :: fit_data_type, parse_fit_data, check_fit_data, column_place, column_names, columns, is_angle, is_event
   public :: column_x, column_y, column_z, column_azimuth, column_angle, column_u, column_v, column_tension, &
      column_plane, column_turning_time, column_crossing_time, column_period, column_amplitude, column_t

   !> Places in `column_names`. The first twelve are measured; amplitude goes with period, t with the others.
   integer, parameter :: column_x = 1, column_y = 2, column_z = 3, column_azimuth = 4, column_angle = 5, column_u = 6, &
      column_v = 7, column_tension = 8, column_plane = 9, column_turning_time = 10, column_crossing_time = 11, &
      column_period = 12, column_amplitude = 13, column_t = 14
   integer, parameter :: columns = 14
   character(len=13), parameter :: column_names(columns) = [character(len=13) :: 'x', 'y', 'z', 'azimuth', 'angle', &
      'u', 'v', 'tension', 'plane', 'turning_time', 'crossing_time', 'period', 'amplitude', 't']
   logical, parameter :: is_angle(columns) = [.false., .false., .false., .true., .true., .false., .false., .false., &
      .true., .false., .false., .false., .true., .false.]
   logical, parameter :: is_event(columns) = [.false., .false., .false., .false., .false., .false., .false., .false., &
      .false., .true., .true., .false., .false., .false.]

   !> Numbers in SI units and as they stand in the table; NaN: none.
   type :: fit_data_type
      character(len=:), allocatable :: file           !! For messages
      integer :: rows = 0, header_line = 0
      logical :: has(columns) = .false., has_sigma(columns) = .false.
      real(wp), allocatable :: value(:, :)            !! (rows, columns)
      real(wp), allocatable :: sigma(:, :)            !! (rows, columns)
      integer, allocatable :: line(:)                 !! Of each row, for messages
   end type fit_data_type

contains

   !> Place of a name in `column_names`, or 0.
   pure integer function column_place(name) result(place)
      character(len=*), intent(in) :: name

      place = findloc(column_names == name, .true., 1)
   end function column_place

   !> A table of text: one header line, then a line a row, separated by commas, or by blanks; # begins a comment.
   !> Between
   !> commas a cell may be empty. Errors, with file and line: an unknown or repeated column, a cell that is no number,
   !> too
   !> many or too few cells.
   subroutine parse_fit_data(text, file, data, error)
      character(len=*), intent(in) :: text, file
      type(fit_data_type), intent(out) :: data
      type(error_type), allocatable, intent(out) :: error
      integer :: place(2*columns), cells_wanted, cells, first(100), last(100), at, ends, line, i, k, rows, stop_at
      logical :: by_comma, has_header
      character(len=:), allocatable :: what

      data%file = file
      rows = 1
      do i = 1, len(text)
         if (text(i:i) == achar(10)) rows = rows + 1
      end do
      allocate (data%value(rows, columns), data%sigma(rows, columns), data%line(rows))
      data%value = quiet_nan_real64
      data%sigma = quiet_nan_real64
      do i = 1, len(text)
         if (iachar(text(i:i)) < 32 .and. scan(text(i:i), achar(9)//achar(10)//achar(12)//achar(13)) == 0) then
            call fail(error, code_input, place_of(file, 1 + count([(text(k:k) == achar(10), k=1, i)]))// &
               'not a text file (byte '//integer_text(iachar(text(i:i)))//')')
            return
         end if
      end do
      has_header = .false.
      by_comma = .false.
      cells_wanted = 0
      line = 0
      at = 1
      if (len(text) >= 3) then
         if (all([ichar(text(1:1)), ichar(text(2:2)), ichar(text(3:3))] == [239, 187, 191])) at = 4
      end if
      do while (at <= len(text))
         line = line + 1
         ends = index(text(at:), achar(10))
         ends = merge(len(text), at + ends - 2, ends == 0)
         stop_at = ends
         i = index(text(at:ends), '#')
         if (i > 0) stop_at = at + i - 2
         if (verify(text(at:stop_at), ' '//achar(9)//achar(13)) > 0) then
            if (.not. has_header) by_comma = index(text(at:stop_at), ',') > 0
            call split_cells(text, at, stop_at, by_comma, first, last, cells)
            if (.not. has_header) then
               has_header = .true.
               data%header_line = line
               cells_wanted = cells
               call read_header(text, first, last, cells, file, line, data, place, error)
            else if (cells /= cells_wanted) then
               call fail(error, code_input, place_of(file, line)//'a row has '//integer_text(cells_wanted)// &
                  ' cells, as the header, got '//integer_text(cells))
            else
               data%rows = data%rows + 1
               data%line(data%rows) = line
               do i = 1, cells_wanted
                  if (last(i) < first(i)) cycle
                  if (place(i) > columns) then
                     call read_number(text(first(i):last(i)), data%sigma(data%rows, place(i) - columns), what)
                     if (.not. allocated(what) .and. .not. data%sigma(data%rows, place(i) - columns) > 0) &
                        what = 'a standard deviation is positive'
                  else
                     call read_number(text(first(i):last(i)), data%value(data%rows, place(i)), what)
                  end if
                  if (.not. allocated(what)) cycle
                  call fail(error, code_input, place_of(file, line)//trim(name_of(place(i)))// &
                     " must be a finite number, got '"//shown(text(first(i):last(i)))//"' ("//what//')')
                  return
               end do
            end if
            if (allocated(error)) return
         end if
         at = ends + 2
      end do
      if (.not. has_header) call fail(error, code_input, &
         file//': a header line with the names of the columns is missing')
   end subroutine parse_fit_data

   !> Positions of the cells of a line; one that is empty has first > last.
   pure subroutine split_cells(text, from, to, by_comma, first, last, cells)
      character(len=*), intent(in) :: text
      integer, intent(in) :: from, to
      logical, intent(in) :: by_comma
      integer, intent(out) :: first(:), last(:), cells
      character(len=*), parameter :: blanks = ' '//achar(9)//achar(13)
      integer :: at, length

      cells = 0
      at = from
      do while (cells < size(first))
         if (by_comma) then
            length = index(text(at:to), ',') - 1
            if (length < 0) length = to - at + 1
         else
            if (at > to) exit
            length = verify(text(at:to), blanks) - 1
            if (length < 0) exit
            at = at + length
            length = scan(text(at:to), blanks) - 1
            if (length < 0) length = to - at + 1
         end if
         cells = cells + 1
         first(cells) = at
         last(cells) = at + length - 1
         do while (first(cells) <= last(cells))
            if (scan(text(first(cells):first(cells)), blanks) == 0) exit
            first(cells) = first(cells) + 1
         end do
         do while (first(cells) <= last(cells))
            if (scan(text(last(cells):last(cells)), blanks) == 0) exit
            last(cells) = last(cells) - 1
         end do
         at = at + length + 1
         if (by_comma .and. at > to + 1) exit
      end do
   end subroutine split_cells

   !> The columns of the header: places, or places + `columns` for standard deviations.
   subroutine read_header(text, first, last, cells, file, line, data, place, error)
      character(len=*), intent(in) :: text, file
      integer, intent(in) :: first(:), last(:), cells, line
      type(fit_data_type), intent(inout) :: data
      integer, intent(out) :: place(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i
      character(len=:), allocatable :: name

      place = 0
      do i = 1, cells
         name = lower_case(text(first(i):last(i)))
         if (i <= size(place)) then
            place(i) = column_place(name)
            if (place(i) == 0 .and. index(name, 'sigma_') == 1) then
               place(i) = column_place(name(7:))
               if (place(i) > 0) place(i) = place(i) + columns
            end if
         end if
         if (i > size(place)) then
            call fail(error, code_input, place_of(file, line)//'too many columns')
         else if (place(i) == 0) then
            call fail(error, code_input, place_of(file, line)//'unknown column '//shown(name)//'; known are '// &
               trim(known_columns())//', each also as sigma_...')
         else if (any(place(:i - 1) == place(i))) then
            call fail(error, code_input, place_of(file, line)//'column '//name//' given twice')
         end if
         if (allocated(error)) return
         if (place(i) > columns) then
            data%has_sigma(place(i) - columns) = .true.
         else
            data%has(place(i)) = .true.
         end if
      end do
   end subroutine read_header

   !> What must hold of any data. Errors, with file and line: nothing measured, measured columns without t, a sigma
   !> without its column, one row, times that do not ascend, values that are all equal.
   subroutine check_fit_data(data, error)
      type(fit_data_type), intent(in) :: data
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j, count
      real(wp) :: before, value

      do j = 1, columns
         if (data%has_sigma(j) .and. .not. data%has(j)) call fail(error, code_input, place_of(data%file, &
            data%header_line)//'sigma_'//trim(column_names(j))//' without '//trim(column_names(j)))
         if (allocated(error)) return
      end do
      if (.not. any(data%has(:column_period))) then
         call fail(error, code_input, place_of(data%file, data%header_line)//'no measured column; known are '// &
            trim(known_columns()))
      else if (any(data%has(:column_plane)) .and. .not. data%has(column_t)) then
         call fail(error, code_input, place_of(data%file, data%header_line)//'the column t is missing')
      else if (data%has(column_period) .neqv. data%has(column_amplitude)) then
         call fail(error, code_input, place_of(data%file, data%header_line)//'period and amplitude go together')
      else if (data%rows < 2) then
         call fail(error, code_input, place_of(data%file, data%header_line)//'at least two rows are needed, got '// &
            integer_text(data%rows))
      end if
      if (allocated(error)) return
      do i = 1, data%rows
         if (.not. data%has(column_period)) exit
         associate (period => data%value(i, column_period), amplitude => data%value(i, column_amplitude))
            if (is_nan(period) .and. is_nan(amplitude)) cycle
            if (.not. (is_nan(period) .or. is_nan(amplitude))) then
               if (period > 0 .and. amplitude > 0) cycle
            end if
            call fail(error, code_input, place_of(data%file, data%line(i))// &
               'period and amplitude must both be given, and positive')
         end associate
         return
      end do
      do j = 1, columns
         if (j == column_amplitude .or. .not. data%has(j)) cycle
         count = 0
         before = -huge(before)
         do i = 1, data%rows
            value = data%value(i, j)
            if (is_nan(value)) then
               if (j == column_t .and. any(is_finite(data%value(i, :column_plane)))) call fail(error, code_input, &
                  place_of(data%file, data%line(i))//'t is missing beside a measured value')
               if (allocated(error)) return
               cycle
            end if
            count = count + 1
            if ((j == column_t .or. is_event(j)) .and. .not. value > before) then
               call fail(error, code_input, place_of(data%file, data%line(i))//trim(column_names(j))// &
                  ' must ascend from row to row')
               return
            end if
            before = value
         end do
         if (count == 0) then
            call fail(error, code_input, place_of(data%file, data%header_line)//'column '// &
               trim(column_names(j))//' is empty')
         end if
         if (allocated(error)) return
      end do
      if (.not. any(data%has(column_turning_time:column_period))) then
         do j = 1, column_plane
            if (.not. data%has(j)) cycle
            if (maxval(data%value(:data%rows, j), .not. is_nan(data%value(:data%rows, j))) > &
               minval(data%value(:data%rows, j), .not. is_nan(data%value(:data%rows, j)))) return
         end do
         call fail(error, code_input, place_of(data%file, data%header_line)// &
            'all values of each column are equal: nothing moves')
      end if
   end subroutine check_fit_data

   pure function name_of(place) result(text)
      integer, intent(in) :: place
      character(len=20) :: text

      if (place > columns) then
         text = 'sigma_'//column_names(place - columns)
      else
         text = column_names(place)
      end if
   end function name_of

   !> Blanks behind.
   pure function known_columns() result(text)
      character(len=16*columns) :: text
      integer :: i

      text = 't'
      do i = 1, columns - 1
         text = trim(text)//', '//column_names(i)
      end do
   end function known_columns

end module kyvadlo_fit_data
