!> The lower table of `kyvadlo-bench --scenes`: what the text of a number costs, alone, in a row of CSV, and by
!> `std::to_chars` of C++ where this build found it.
module kyvadlo_bench_text
   use, intrinsic :: iso_fortran_env, only: int64
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_decimal, only: longest_decimal, put_shortest
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_sample_text, only: csv_samples_type, new_csv_samples
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   use kyvadlo_text, only: counting_sink_type
   implicit none
   private
   public :: bench_text

   integer, parameter :: samples = 2048, columns = 7
   integer, parameter :: shortest_row = 1, rows_row = 2, theirs_row = 3

#ifdef KYVADLO_WITH_TO_CHARS
   interface
      !> The bytes written.
      function kyvadlo_to_chars(value, text, size) bind(c) result(length)
         import :: c_char, c_double, c_int
         real(c_double), value :: value
         character(kind=c_char), intent(out) :: text(*)
         integer(c_int), value :: size
         integer(c_int) :: length
      end function kyvadlo_to_chars
   end interface
#endif

contains

   !> Medians over passes; all rows are measured in turn.
   subroutine bench_text(unit, passes, checksum)
      integer, intent(in) :: unit, passes
      real(wp), intent(inout) :: checksum
      real(wp) :: times(passes, 3), t(3)
      real(wp), allocatable :: values(:, :)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer(int64) :: bytes
      integer :: row, pass, i

      call new_orbit_from_heights(orbit, 1.0_wp, 9.80665_wp, 0.3_wp, -0.8_wp, error)
      allocate (values(samples, columns))
      values(:, 1) = [(0.01_wp*i, i=0, samples - 1)]
      call orbit%locate(values(:, 1), values(:, 2), values(:, 3), values(:, 4), values(:, 5), values(:, 6), &
         values(:, 7))
      bytes = 0
      do pass = 0, passes  ! The first warms the caches and is not counted.
         do row = 1, 3
            call measure(row, values, times(max(pass, 1), row), bytes)
         end do
      end do
      do row = 1, 3
         t(row) = median(times(:, row))
      end do
      checksum = checksum + real(bytes, wp)
      write (unit, '(/,a,/)') 'Text of the numbers of time, position and velocity; ns a number.'
      write (unit, '(a48,f10.1)') 'shortest text that reads back                   ', t(shortest_row)
      write (unit, '(a48,f10.1,f16.2,a)') 'rows of CSV                                     ', t(rows_row), &
         t(rows_row)/t(shortest_row), ' times that'
#ifdef KYVADLO_WITH_TO_CHARS
      write (unit, '(a48,f10.1,f16.2,a)') 'std::to_chars                                   ', t(theirs_row), &
         t(shortest_row)/t(theirs_row), ' times it takes ours'
#endif
   end subroutine bench_text

   !> Nanoseconds a number.
   subroutine measure(row, values, time, bytes)
      integer, intent(in) :: row
      real(wp), intent(in) :: values(:, :)
      real(wp), intent(out) :: time
      integer(int64), intent(inout) :: bytes
      type(counting_sink_type), target :: no_lines
      type(csv_samples_type) :: lines
      character(len=longest_decimal) :: text
#ifdef KYVADLO_WITH_TO_CHARS
      character(kind=c_char) :: theirs(32)
#endif
      integer(int64) :: start
      integer :: i, j, length
      logical :: goes_on

      lines = new_csv_samples(no_lines)
      if (row == rows_row) call lines%take(values(:1, :), goes_on)
      call system_clock(start)
      select case (row)
      case (shortest_row)
         do j = 1, columns
            do i = 1, samples
               call put_shortest(values(i, j), text, length)
               bytes = bytes + length
            end do
         end do
      case (rows_row)
         call lines%take(values, goes_on)
#ifdef KYVADLO_WITH_TO_CHARS
      case (theirs_row)
         do j = 1, columns
            do i = 1, samples
               bytes = bytes + kyvadlo_to_chars(values(i, j), theirs, size(theirs, kind=c_int))
            end do
         end do
#endif
      end select
      time = nanoseconds_since(start)/size(values)
      bytes = bytes + no_lines%bytes
   end subroutine measure

end module kyvadlo_bench_text
