!> Order among numbers: sorted, the middle one, quantiles.
module kyvadlo_quantiles
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: median, quantile, quantile_between, sort

contains

   !> The middle value, of two middle ones the smaller. `huge` for no value.
   pure real(wp) function median(values)
      real(wp), intent(in) :: values(:)

      median = quantile(values, 0.5_wp)
   end function median

   !> The smallest value that is at least as great as this share of all. `huge` for no value.
   pure real(wp) function quantile(values, share)
      real(wp), intent(in) :: values(:)
      real(wp), intent(in) :: share      !! 0: the least, 1: the greatest
      real(wp) :: sorted(size(values))

      quantile = huge(quantile)
      if (size(values) == 0) return
      sorted = values
      call sort(sorted)
      quantile = sorted(min(max(ceiling(share*size(sorted)), 1), size(sorted)))
   end function quantile

   !> The value below which a share of sorted ones lies, by a straight line between neighbours.
   pure real(wp) function quantile_between(sorted, share) result(value)
      real(wp), intent(in) :: sorted(:)
      real(wp), intent(in) :: share
      real(wp) :: place
      integer :: j

      place = 1 + share*(size(sorted) - 1)
      j = max(1, min(int(place), size(sorted) - 1))
      value = sorted(j) + (place - j)*(sorted(min(j + 1, size(sorted))) - sorted(j))
   end function quantile_between

   !> Ascending, by a heap (J. W. J. Williams, Comm. ACM 7 (1964) 347).
   pure subroutine sort(values)
      real(wp), intent(inout) :: values(:)
      real(wp) :: top
      integer :: i

      do i = size(values)/2, 1, -1
         call sift(values, i)
      end do
      do i = size(values), 2, -1
         top = values(1)
         values(1) = values(i)
         values(i) = top
         call sift(values(:i - 1), 1)
      end do
   end subroutine sort

   !> Down to where it is above both below it.
   pure subroutine sift(values, from)
      real(wp), intent(inout) :: values(:)
      integer, intent(in) :: from
      real(wp) :: moved
      integer :: i, below

      moved = values(from)
      i = from
      do
         below = 2*i
         if (below > size(values)) exit
         if (below < size(values)) then
            if (values(below + 1) > values(below)) below = below + 1
         end if
         if (values(below) <= moved) exit
         values(i) = values(below)
         i = below
      end do
      values(i) = moved
   end subroutine sift

end module kyvadlo_quantiles
