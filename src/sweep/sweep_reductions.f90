!> What a chunk leaves: values, status, and the reductions of what is not stored. Sums are taken in lanes and blocks
!> whose order is fixed.
module kyvadlo_sweep_reductions
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: chunk_type, values_type, bins_type, new_bins, reduce_block, merge_reductions, reduction_size

   integer, parameter, public :: status_computed = 0, status_inadmissible = 1, status_refused = 2, status_failed = 3
   integer, parameter, public :: status_count = 4
   character(len=*), parameter, public :: status_words(status_count) = [character(len=12) :: 'computed', &
      'inadmissible', 'refused', 'failed']

   !> Points that are computed together.
   integer, parameter, public :: block_points = 4096

   !> Items of a reduction before its bins.
   integer, parameter, public :: item_count = 1, item_least = 2, item_greatest = 3, item_sum = 4, item_below = 5, &
      item_above = 6, items = 6

   type :: values_type
      real(wp), allocatable :: values(:, :)          !! (component, point)
   end type values_type

   !> All that is written of a chunk.
   type :: chunk_type
      integer(int64) :: chunk = 0, count = 0
      type(values_type), allocatable :: stored(:)    !! By measure; those of histograms are empty
      integer(int8), allocatable :: status(:)        !! (point)
      real(wp), allocatable :: reduction(:)          !! Counts by status, then items and bins of each histogram
   end type chunk_type

   !> The bins of a histogram, ready to count.
   type :: bins_type
      integer :: count = 0
      logical :: is_log = .false.
      real(wp) :: from = 0, to = 0, per_unit = 0
   end type bins_type

   integer, parameter :: lanes = 8, ways = 4

contains

   pure integer function reduction_size(bins) result(count)
      type(bins_type), intent(in) :: bins(:)

      count = status_count + sum(items + bins%count)
   end function reduction_size

   pure function new_bins(from, to, count, is_log) result(bins)
      real(wp), intent(in) :: from, to
      integer, intent(in) :: count
      logical, intent(in) :: is_log
      type(bins_type) :: bins

      bins%count = count
      bins%is_log = is_log
      bins%from = from
      bins%to = to
      bins%per_unit = count/(to - from)
      if (is_log) bins%per_unit = count/log(to/from)
   end function new_bins

   !> Adds a block of values. NaN: there is none. The last bin has its upper edge in it.
   pure subroutine reduce_block(bins, values, reduction)
      type(bins_type), intent(in) :: bins
      real(wp), intent(in) :: values(:)
      real(wp), intent(inout) :: reduction(:)        !! Items and bins
      real(wp), dimension(lanes) :: least, greatest, total, found
      real(wp) :: x, known, position
      integer, allocatable :: counts(:, :)
      integer :: place(block_points)
      integer :: i, lane, whole, n

      n = size(values)
      whole = n/lanes*lanes
      least = huge(x)
      greatest = -huge(x)
      total = 0
      found = 0
      do i = 1, whole, lanes
         do lane = 1, lanes
            x = values(i + lane - 1)
            found(lane) = found(lane) + merge(1.0_wp, 0.0_wp, x == x)
            total(lane) = total(lane) + merge(x, 0.0_wp, x == x)
            ! In the place of a NaN, of which < would trap, what changes nothing.
            known = merge(x, least(lane), x == x)
            least(lane) = merge(known, least(lane), known < least(lane))
            known = merge(x, greatest(lane), x == x)
            greatest(lane) = merge(known, greatest(lane), known > greatest(lane))
         end do
      end do
      do i = whole + 1, n
         lane = i - whole
         x = values(i)
         if (x /= x) cycle
         if (x < least(lane)) least(lane) = x
         if (x > greatest(lane)) greatest(lane) = x
         found(lane) = found(lane) + 1
         total(lane) = total(lane) + x
      end do
      if (bins%is_log) then
         do i = 1, n
            place(i) = bins%count + 2
            x = values(i)
            if (x /= x) cycle
            place(i) = merge(0, bins%count + 1, x < bins%from)
            if (x >= bins%from .and. x <= bins%to) place(i) = min(int(log(x/bins%from)*bins%per_unit) + 1, bins%count)
         end do
      else
         do i = 1, n
            x = values(i)
            known = merge(x, bins%from, x == x)
            position = (known - bins%from)*bins%per_unit
            position = merge(position, 0.0_wp, known >= bins%from)
            position = merge(position, 0.0_wp, known <= bins%to)
            place(i) = min(int(position), bins%count - 1) + 1
            place(i) = merge(place(i), 0, known >= bins%from)
            place(i) = merge(place(i), bins%count + 1, .not. known > bins%to)
            place(i) = merge(place(i), bins%count + 2, x == x)
         end do
      end if
      allocate (counts(0:bins%count + 2, ways), source=0)
      whole = n/ways*ways
      ! Neighbours often fall into one bin: each in a row of its own, they do not wait for one another.
      do i = 1, whole, ways
         counts(place(i), 1) = counts(place(i), 1) + 1
         counts(place(i + 1), 2) = counts(place(i + 1), 2) + 1
         counts(place(i + 2), 3) = counts(place(i + 2), 3) + 1
         counts(place(i + 3), 4) = counts(place(i + 3), 4) + 1
      end do
      do i = whole + 1, n
         counts(place(i), 1) = counts(place(i), 1) + 1
      end do
      reduction(item_count) = reduction(item_count) + sum(found)
      reduction(item_least) = min(reduction(item_least), minval(least))
      reduction(item_greatest) = max(reduction(item_greatest), maxval(greatest))
      do lane = 1, lanes
         reduction(item_sum) = reduction(item_sum) + total(lane)
      end do
      reduction(item_below) = reduction(item_below) + sum(counts(0, :))
      reduction(item_above) = reduction(item_above) + sum(counts(bins%count + 1, :))
      do i = 1, ways
         reduction(items + 1:) = reduction(items + 1:) + counts(1:bins%count, i)
      end do
   end subroutine reduce_block

   !> Adds the reduction of a chunk to those of the chunks before it.
   pure subroutine merge_reductions(bins, total, more)
      type(bins_type), intent(in) :: bins(:)
      real(wp), intent(inout) :: total(:)
      real(wp), intent(in) :: more(:)
      real(wp) :: least, greatest
      integer :: i, at

      at = status_count
      total(:at) = total(:at) + more(:at)
      do i = 1, size(bins)
         least = min(total(at + item_least), more(at + item_least))
         greatest = max(total(at + item_greatest), more(at + item_greatest))
         associate (last => at + items + bins(i)%count)
            total(at + 1:last) = total(at + 1:last) + more(at + 1:last)
            total(at + item_least) = least
            total(at + item_greatest) = greatest
            at = last
         end associate
      end do
   end subroutine merge_reductions

end module kyvadlo_sweep_reductions
