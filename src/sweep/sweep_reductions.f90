!> What a chunk leaves: values, status, and the reductions of what is not stored. Sums are taken in groups whose order
!> is fixed.
module kyvadlo_sweep_reductions
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_reduction_kernel_baseline, only: groups_baseline => reduce_groups, places_baseline => sum_of_places, &
      numbers_baseline => count_of_numbers
   use kyvadlo_reduction_kernel_v3, only: groups_v3 => reduce_groups, places_v3 => sum_of_places, &
      numbers_v3 => count_of_numbers
   use kyvadlo_reduction_kernel_v4, only: groups_v4 => reduce_groups, places_v4 => sum_of_places, &
      numbers_v4 => count_of_numbers
   implicit none
   private
   public :: chunk_type, values_type, bins_type, new_bins, begin_reduction, reduce_block, end_reduction, &
      reduce_groups, merge_reductions, reduction_size

   !> 0, what a new file is full of: not computed yet.
   integer, parameter, public :: status_computed = 1, status_inadmissible = 2, status_refused = 3, status_failed = 4
   integer, parameter, public :: status_count = 4
   character(len=*), parameter, public :: status_words(status_count) = [character(len=12) :: 'computed', &
      'inadmissible', 'refused', 'failed']

   !> Points that are computed together, and those whose bins are looked for together.
   integer, parameter, public :: block_points = 2048, group_points = 64

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

   !> Neighbours often fall into one bin: each is counted in a row of its own, they do not wait for one another.
   integer, parameter :: ways = 4

   !> The bins of a histogram, ready to count.
   type :: bins_type
      integer :: count = 0
      logical :: is_log = .false.
      real(wp) :: from = 0, to = 0, per_unit = 0
      integer, allocatable :: counts(:, :)           !! Of a chunk: below, the bins, above, NaN; by way
   end type bins_type

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

   !> Before the values of a chunk.
   pure subroutine begin_reduction(bins, reduction)
      type(bins_type), intent(inout) :: bins
      real(wp), intent(out) :: reduction(:)          !! Items and bins

      reduction = 0
      reduction(item_least) = huge(1.0_wp)
      reduction(item_greatest) = -huge(1.0_wp)
      if (.not. allocated(bins%counts)) allocate (bins%counts(0:bins%count + 2, ways))
      bins%counts = 0
   end subroutine begin_reduction

   !> Adds a block of values. NaN: there is none. The last bin has its upper edge in it.
   pure subroutine reduce_block(bins, values, reduction)
      type(bins_type), intent(inout) :: bins
      real(wp), intent(in), contiguous :: values(:)
      real(wp), intent(inout) :: reduction(:)        !! Items and bins
      real(wp), dimension(block_points/group_points) :: least, greatest, total
      integer :: g, first, last, low, high, above

      call reduce_groups(values, least, greatest, total)
      do g = 1, size(values)/group_points
         first = (g - 1)*group_points + 1
         last = g*group_points
         if (total(g) /= total(g)) then
            if (count_of_numbers(values(first:last)) > 0) then
               call reduce_each(bins, values(first:last), reduction)
            else
               bins%counts(bins%count + 2, 1) = bins%counts(bins%count + 2, 1) + group_points
            end if
            cycle
         end if
         reduction(item_count) = reduction(item_count) + group_points
         reduction(item_sum) = reduction(item_sum) + total(g)
         if (least(g) < reduction(item_least)) reduction(item_least) = least(g)
         if (greatest(g) > reduction(item_greatest)) reduction(item_greatest) = greatest(g)
         low = place_of(bins, least(g))
         high = place_of(bins, greatest(g))
         if (low == high) then
            bins%counts(low, 1) = bins%counts(low, 1) + group_points
         else if (high == low + 1 .and. low > 0 .and. high <= bins%count .and. .not. bins%is_log) then
            ! Between two bins the sum of the places tells how many lie in which.
            above = sum_of_places(bins, values(first:last)) - group_points*(low - 1)
            bins%counts(low, 1) = bins%counts(low, 1) + (group_points - above)
            bins%counts(high, 1) = bins%counts(high, 1) + above
         else
            call count_each(bins, values(first:last))
         end if
      end do
      call reduce_each(bins, values(size(values)/group_points*group_points + 1:), reduction)
   end subroutine reduce_block

   !> After the values of a chunk: the bins.
   pure subroutine end_reduction(bins, reduction)
      type(bins_type), intent(in) :: bins
      real(wp), intent(inout) :: reduction(:)        !! Items and bins

      associate (counts => bins%counts, n => bins%count)
         reduction(item_below) = sum(counts(0, :))
         reduction(item_above) = sum(counts(n + 1, :))
         reduction(items + 1:) = sum(counts(1:n, :), 2)
      end associate
   end subroutine end_reduction

   !> Value by value: those of a group with NaN, and what is less than a group.
   pure subroutine reduce_each(bins, values, reduction)
      type(bins_type), intent(inout) :: bins
      real(wp), intent(in) :: values(:)
      real(wp), intent(inout) :: reduction(:)
      integer :: i

      do i = 1, size(values)
         associate (x => values(i))
            if (x /= x) cycle
            reduction(item_count) = reduction(item_count) + 1
            reduction(item_sum) = reduction(item_sum) + x
            if (x < reduction(item_least)) reduction(item_least) = x
            if (x > reduction(item_greatest)) reduction(item_greatest) = x
         end associate
      end do
      call count_each(bins, values)
   end subroutine reduce_each

   pure subroutine count_each(bins, values)
      type(bins_type), intent(inout) :: bins
      real(wp), intent(in) :: values(:)
      integer :: place(group_points)
      integer :: i, way

      do i = 1, size(values)
         place(i) = place_of(bins, values(i))
      end do
      do i = 1, size(values)
         way = mod(i, ways) + 1
         bins%counts(place(i), way) = bins%counts(place(i), way) + 1
      end do
   end subroutine count_each

   !> The bin of a value: 0 below the first, one more than there are above the last, two more for NaN.
   pure integer function place_of(bins, x) result(place)
      type(bins_type), intent(in) :: bins
      real(wp), intent(in) :: x

      ! < of a NaN would trap.
      if (x /= x) then
         place = bins%count + 2
      else if (x < bins%from) then
         place = 0
      else if (x > bins%to) then
         place = bins%count + 1
      else if (bins%is_log) then
         place = min(int(log(x/bins%from)*bins%per_unit), bins%count - 1) + 1
      else
         place = min(int((x - bins%from)*bins%per_unit), bins%count - 1) + 1
      end if
   end function place_of

   !> Least, greatest and sum of each whole group of a block, by the vectors that the processor has.
   pure subroutine reduce_groups(values, least, greatest, total)
      real(wp), intent(in), contiguous :: values(:)
      real(wp), intent(out), dimension(block_points/group_points) :: least, greatest, total

      select case (vector_level())
      case (2)
         call groups_v4(size(values)/group_points, values, least, greatest, total)
      case (1)
         call groups_v3(size(values)/group_points, values, least, greatest, total)
      case default
         call groups_baseline(size(values)/group_points, values, least, greatest, total)
      end select
   end subroutine reduce_groups

   pure integer function sum_of_places(bins, values) result(places)
      type(bins_type), intent(in) :: bins
      real(wp), intent(in), contiguous :: values(:)

      select case (vector_level())
      case (2)
         places = places_v4(values, bins%from, bins%per_unit, bins%count - 1)
      case (1)
         places = places_v3(values, bins%from, bins%per_unit, bins%count - 1)
      case default
         places = places_baseline(values, bins%from, bins%per_unit, bins%count - 1)
      end select
   end function sum_of_places

   pure integer function count_of_numbers(values) result(numbers)
      real(wp), intent(in), contiguous :: values(:)

      select case (vector_level())
      case (2)
         numbers = numbers_v4(values)
      case (1)
         numbers = numbers_v3(values)
      case default
         numbers = numbers_baseline(values)
      end select
   end function count_of_numbers

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
