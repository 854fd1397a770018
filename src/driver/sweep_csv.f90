!> A small sweep as CSV.
module kyvadlo_sweep_csv
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: shortest_text
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_ranks, only: gather_bits, ranks_type
   use kyvadlo_standard_io, only: close_output, open_output, output_type
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_axes, only: axis_values
   use kyvadlo_sweep_plan, only: plan_type
   use kyvadlo_sweep_reductions, only: status_words
   use kyvadlo_sweep_run, only: cells_type
   implicit none
   private
   public :: gather_cells, write_csv

contains

   !> What the ranks have computed, on rank 0.
   subroutine gather_cells(ranks, cells)
      type(ranks_type), intent(in) :: ranks
      type(cells_type), intent(inout) :: cells
      integer :: i

      ! Column by column: no copy of the whole.
      if (ranks%count == 1) return
      do i = 1, size(cells%bits, 1)
         block
            integer(int64), allocatable :: bits(:)
            bits = cells%bits(i, :)
            call gather_bits(ranks, bits)
            cells%bits(i, :) = bits
         end block
      end do
   end subroutine gather_cells

   !> Coordinates, values and status of every point; what is not there is empty.
   subroutine write_csv(plan, path, cells, error)
      type(plan_type), intent(in) :: plan
      character(len=*), intent(in) :: path
      type(cells_type), intent(in) :: cells
      type(error_type), allocatable, intent(out) :: error
      type(output_type) :: output
      character(len=:), allocatable :: line
      character(len=8) :: number
      real(wp) :: value(1)
      integer(int64) :: point, index
      integer :: i, j

      call open_output(output, path, error)
      if (allocated(error)) return
      line = ''
      do i = 1, size(plan%axes)
         line = line//plan%axes(i)%variable//','
      end do
      do i = 1, size(plan%measures)
         do j = 1, plan%measures(i)%components
            write (number, '("_",i0)') j
            line = line//plan%measures(i)%name
            if (plan%measures(i)%components > 1) line = line//trim(number)
            line = line//','
         end do
      end do
      call output%put(line//'status')
      do point = 1, plan%points
         line = ''
         do i = 1, size(plan%axes)
            index = (point - 1)/product(plan%dimensions(plan%dimension_of(i) + 1:)%count)
            call axis_values(plan%axes(i), mod(index, plan%axes(i)%count), value)
            line = line//shortest_text(value(1))//','
         end do
         do i = 1, size(cells%bits, 1) - 1
            value(1) = transfer(cells%bits(i, point), value(1))
            if (.not. is_nan(value(1))) line = line//shortest_text(value(1))
            line = line//','
         end do
         call output%put(line//trim(status_words(int(cells%bits(size(cells%bits, 1), point)))))
      end do
      call close_output(output, error)
   end subroutine write_csv

end module kyvadlo_sweep_csv
