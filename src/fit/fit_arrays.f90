!> Measurements from arrays of a program.
module kyvadlo_fit_arrays
   use kyvadlo_fit_data, only: column_place, columns, fit_data_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite, is_nan, quiet_nan_real64
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: integer_text, lower_case, shown, split_words
   implicit none
   private
   public :: new_fit_data

contains

   !> Data as `parse_fit_data` would read them. Errors (`code_input`): a column that is unknown or named twice; with its
   !> row, a number that is infinite, or a standard deviation that is not positive.
   subroutine new_fit_data(names, rows, table, data, error)
      character(len=*), intent(in) :: names             !! Of the columns, `t x y sigma_x`, between blanks or commas
      integer, intent(in) :: rows
      real(wp), intent(in) :: table(*)                  !! (columns named, rows); NaN: no number there
      type(fit_data_type), intent(out) :: data
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: words
      integer, allocatable :: first(:), last(:)
      integer :: i, j, count
      logical :: is_sigma
      real(wp) :: value

      data%file = 'table'
      data%rows = rows
      words = lower_case(names)
      do i = 1, len(words)
         if (words(i:i) == ',') words(i:i) = ' '
      end do
      call split_words(words, first, last, count)
      allocate (data%value(max(rows, 1), columns), data%sigma(max(rows, 1), columns))
      data%line = [(i, i=1, max(rows, 1))]
      data%value = quiet_nan_real64
      data%sigma = quiet_nan_real64
      if (rows < 0) then
         call fail(error, code_input, 'table: its number of rows is '//integer_text(rows))
         return
      end if
      do j = 1, count
         associate (name => words(first(j):last(j)))
            is_sigma = index(name, 'sigma_') == 1
            i = column_place(name(merge(7, 1, is_sigma):))
            if (i == 0) then
               call fail(error, code_input, 'table: unknown column '//shown(name))
            else if (merge(data%has_sigma(i), data%has(i), is_sigma)) then
               call fail(error, code_input, 'table: column '//name//' given twice')
            end if
            if (allocated(error)) return
            if (is_sigma) then
               data%has_sigma(i) = .true.
               data%sigma(:rows, i) = table(j:j + count*(rows - 1):count)
            else
               data%has(i) = .true.
               data%value(:rows, i) = table(j:j + count*(rows - 1):count)
            end if
         end associate
      end do
      do j = 1, columns
         do i = 1, rows
            value = merge(data%value(i, j), 1.0_wp, data%has(j))
            if (.not. (is_finite(value) .or. is_nan(value))) call fail(error, code_input, 'table:'//integer_text(i)// &
               ': a value is infinite')
            value = merge(data%sigma(i, j), 1.0_wp, data%has_sigma(j))
            if (allocated(error)) return
            if (is_nan(value)) cycle
            if (.not. (is_finite(value) .and. value > 0)) call fail(error, code_input, 'table:'//integer_text(i)// &
               ': a standard deviation must be positive')
            if (allocated(error)) return
         end do
      end do
   end subroutine new_fit_data

end module kyvadlo_fit_arrays
