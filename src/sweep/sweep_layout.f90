!> The one file of a sweep: header and coordinates first, then for every chunk its values, its reduction, and last its
!> mark. What has no mark counts as not there.
module kyvadlo_sweep_layout
   use, intrinsic :: iso_c_binding, only: c_int
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_scene_groups, only: settings
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_axes, only: axis_values
   use kyvadlo_sweep_chunks, only: chunk_range, chunk_start
   use kyvadlo_sweep_netcdf
   use kyvadlo_sweep_plan, only: plan_type
   use kyvadlo_sweep_reductions
   use kyvadlo_text, only: integer_text
   use kyvadlo_version, only: compiler, compiler_flags, version
   implicit none
   private
   public :: sweep_file_type, create_sweep_file, open_sweep_file, close_sweep_file, write_chunk, read_marks, &
      copy_chunk, finish_sweep_file, is_sweep_finished, fill_value

   !> NetCDF's own fill value of doubles.
   real(wp), parameter :: fill_value = 9.9692099683868690e36_wp
   !> Coordinates of a reduced axis longer than this are not stored: they follow from the plan.
   integer(int64), parameter :: most_coordinates = 1048576
   integer, parameter :: buffer = 65536

   type :: sweep_file_type
      private
      type(netcdf_type) :: nc
      integer, allocatable :: measures(:)        !! Variables by measure; 0: it is a histogram
      integer, allocatable :: axes(:)            !! Coordinates; 0: not stored
      integer, allocatable :: histograms(:, :)   !! (6, histogram): bins and the items of a reduction
      integer, allocatable :: edges(:, :)        !! (2, histogram): lower and upper edges of the bins
      integer :: status = 0, mark = 0, reduction = 0, complete = 0, status_points = 0
      integer(c_int), public :: descriptor = -1  !! Of the rank that holds the file
      logical, public :: is_of_plan = .false.    !! Plan, version and flags are those of this run
      logical, public :: is_opened = .false.     !! It is a NetCDF file
      logical, public :: is_whole = .false.      !! Every variable is there
   end type sweep_file_type

   character(len=*), parameter :: item_names(6) = [character(len=9) :: 'histogram', 'least', 'greatest', 'sum', &
      'below', 'above']

   interface
      subroutine kyvadlo_start_writing(descriptor) bind(c)
         import :: c_int
         integer(c_int), value :: descriptor
      end subroutine kyvadlo_start_writing
   end interface

contains

   !> Header and coordinates of a new file.
   subroutine create_sweep_file(plan, bins, path, error)
      type(plan_type), intent(in) :: plan
      type(bins_type), intent(in) :: bins(:)
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      type(sweep_file_type) :: file
      integer :: dimensions(size(plan%dimensions)), chunk, item, kind, component, bin(size(bins)), i, j
      integer(int8) :: nothing(1)
      character(len=:), allocatable :: auxiliary

      call create_netcdf(file%nc, path)
      do i = 1, size(dimensions)
         call define_dimension(file%nc, plan%dimensions(i)%name, plan%dimensions(i)%count, &
            dimensions(size(dimensions) + 1 - i))
      end do
      call define_dimension(file%nc, 'chunk', plan%cut%chunks, chunk)
      call define_dimension(file%nc, 'reduction_item', int(reduction_size(bins), int64), item)
      call define_dimension(file%nc, 'status_kind', int(status_count, int64), kind)
      allocate (file%axes(size(plan%axes)), file%measures(size(plan%measures)), source=0)
      allocate (file%histograms(6, size(bins)), file%edges(2, size(bins)), source=0)
      call put_text(file%nc, global, 'Conventions', 'CF-1.10')
      call put_text(file%nc, global, 'title', plan%scene%pendulum%name)
      call put_text(file%nc, global, 'source', 'kyvadlo '//version)
      call put_text(file%nc, global, 'compiler', compiler)
      call put_text(file%nc, global, 'flags', compiler_flags)
      call put_text(file%nc, global, 'plan', plan%text)
      if (plan%table_checksum /= 0) call put_text(file%nc, global, 'table_checksum', integer_text(plan%table_checksum))
      auxiliary = ''
      do i = 1, size(plan%axes)
         associate (d => plan%dimension_of(i), axis => plan%axes(i))
            if (.not. plan%stores_values .and. axis%count > most_coordinates) cycle
            call define_variable(file%nc, axis%variable, .false., [dimensions(size(dimensions) + 1 - d)], file%axes(i))
            call put_text(file%nc, file%axes(i), 'units', trim(udunits(settings(plan%targets(i)%setting)%unit)))
            call put_text(file%nc, file%axes(i), 'long_name', trim(settings(plan%targets(i)%setting)%meaning))
            if (axis%variable /= plan%dimensions(d)%name) auxiliary = auxiliary//' '//axis%variable
         end associate
      end do
      call define_variable(file%nc, 'chunk_done', .true., [chunk], file%mark)
      call put_text(file%nc, file%mark, 'long_name', 'whether a chunk of the work is done: written after its data')
      call put_flags(file%nc, file%mark, 'flag_values', [0_int8, 1_int8])
      call put_text(file%nc, file%mark, 'flag_meanings', 'open done')
      call define_variable(file%nc, 'complete', .true., [integer ::], file%complete)
      call put_text(file%nc, file%complete, 'long_name', 'whether every chunk is done and the reductions are summed')
      call put_flags(file%nc, file%complete, 'flag_values', [0_int8, 1_int8])
      call put_text(file%nc, file%complete, 'flag_meanings', 'unfinished finished')
      call define_variable(file%nc, 'chunk_reduction', .false., [item, chunk], file%reduction)
      call put_text(file%nc, file%reduction, 'long_name', &
         'reductions of a chunk: points by status; count, least, greatest, sum, below, above and bins by histogram')
      call define_variable(file%nc, 'status_points', .false., [kind], file%status_points)
      call put_text(file%nc, file%status_points, 'long_name', &
         'points by status: computed, inadmissible, refused, failed')
      call put_text(file%nc, file%status_points, 'units', '1')
      do i = 1, size(bins)
         associate (name => plan%histograms(i)%name, measure => plan%measures(findloc(plan%measures%histogram, i, 1)))
            call define_dimension(file%nc, name//'_bin', int(bins(i)%count, int64), bin(i))
            do j = 1, 2
               call define_variable(file%nc, name//'_bin_'//trim(merge('from', 'to  ', j == 1)), .false., [bin(i)], &
                  file%edges(j, i))
               call put_text(file%nc, file%edges(j, i), 'units', measure%unit)
               call put_text(file%nc, file%edges(j, i), 'long_name', trim(merge('lower', 'upper', j == 1))//' edge')
            end do
            do j = 1, 6
               if (j == 1) then
                  call define_variable(file%nc, name//'_histogram', .false., [bin(i)], file%histograms(j, i))
               else
                  call define_variable(file%nc, name//'_'//trim(item_names(j)), .false., [integer ::], &
                     file%histograms(j, i))
               end if
               call put_text(file%nc, file%histograms(j, i), 'long_name', trim(item_names(j))//' of '//measure%meaning)
               call put_text(file%nc, file%histograms(j, i), 'units', trim(merge(measure%unit//'      ', &
                  '1'//repeat(' ', len(measure%unit) + 5), j >= 2 .and. j <= 4)))
               if (j >= 2 .and. j <= 4) call put_numbers(file%nc, file%histograms(j, i), '_FillValue', [fill_value])
            end do
         end associate
      end do
      do i = 1, size(plan%measures)
         associate (measure => plan%measures(i))
            if (measure%histogram > 0) cycle
            if (measure%components > 1) then
               call define_dimension(file%nc, measure%name//'_component', int(measure%components, int64), component)
               call define_variable(file%nc, measure%name, .false., [component, dimensions], file%measures(i))
            else
               call define_variable(file%nc, measure%name, .false., dimensions, file%measures(i))
            end if
            call put_text(file%nc, file%measures(i), 'units', measure%unit)
            call put_text(file%nc, file%measures(i), 'long_name', measure%meaning)
            call put_numbers(file%nc, file%measures(i), '_FillValue', [fill_value])
            call put_text(file%nc, file%measures(i), 'ancillary_variables', 'status')
            if (auxiliary /= '') call put_text(file%nc, file%measures(i), 'coordinates', auxiliary(2:))
         end associate
      end do
      if (plan%stores_values) then
         call define_variable(file%nc, 'status', .true., dimensions, file%status)
         call put_text(file%nc, file%status, 'long_name', 'why there are values, or none')
         call put_flags(file%nc, file%status, 'flag_values', [integer(int8) :: 0, 1, 2, 3, 4])
         call put_text(file%nc, file%status, 'flag_meanings', 'open computed inadmissible refused failed')
      end if
      call end_definitions(file%nc)
      call write_coordinates(plan, bins, file)
      ! The last variable ends the file.
      nothing = 0
      if (plan%stores_values) call write_bytes(file%nc, file%status, &
         plan%dimensions(size(dimensions):1:-1)%count, spread(1_int64, 1, size(dimensions)), nothing)
      call check_netcdf(file%nc, 'cannot write '//path, error)
      call close_netcdf(file%nc)
      call check_netcdf(file%nc, 'cannot write '//path, error)
   end subroutine create_sweep_file

   !> A unit of the table of settings as UDUNITS writes it, blanks behind.
   pure function udunits(unit) result(text)
      character(len=*), intent(in) :: unit
      character(len=8) :: text

      select case (unit)
      case ('')
         text = '1'
      case ('m/s')
         text = 'm s-1'
      case ('m/s2')
         text = 'm s-2'
      case ('m2/s')
         text = 'm2 s-1'
      case ('m2/s2')
         text = 'm2 s-2'
      case ('rad/s')
         text = 'rad s-1'
      case ('1/s')
         text = 's-1'
      case ('1/m')
         text = 'm-1'
      case ('kg/m3')
         text = 'kg m-3'
      case ('N/m')
         text = 'N m-1'
      case ('deg')
         text = 'degree'
      case default
         text = unit
      end select
   end function udunits

   subroutine write_coordinates(plan, bins, file)
      type(plan_type), intent(in) :: plan
      type(bins_type), intent(in) :: bins(:)
      type(sweep_file_type), intent(inout) :: file
      real(wp), allocatable :: values(:)
      integer(int64) :: first, count
      integer :: i, j

      do i = 1, size(plan%axes)
         first = 0
         do while (first < plan%axes(i)%count .and. file%axes(i) > 0)
            count = min(plan%axes(i)%count - first, int(buffer, int64))
            allocate (values(count))
            call axis_values(plan%axes(i), first, values)
            call write_doubles(file%nc, file%axes(i), [first + 1], [count], values)
            deallocate (values)
            first = first + count
         end do
      end do
      do i = 1, size(bins)
         do j = 1, 2
            call get_edges(bins(i), j - 1, values)
            call write_doubles(file%nc, file%edges(j, i), [1_int64], [int(bins(i)%count, int64)], values)
         end do
      end do
      ! A histogram without values ends the file too.
      if (plan%stores_values .or. size(bins) == 0) return
      values = [real(wp) :: 0]
      call write_doubles(file%nc, file%histograms(6, size(bins)), [integer(int64) ::], [integer(int64) ::], values)
   end subroutine write_coordinates

   pure subroutine get_edges(bins, shift, values)
      type(bins_type), intent(in) :: bins
      integer, intent(in) :: shift                !! 0: the lower ones, 1: the upper ones
      real(wp), allocatable, intent(out) :: values(:)
      integer :: i

      allocate (values(bins%count))
      do i = 1, bins%count
         associate (part => real(i - 1 + shift, wp)/bins%count)
            values(i) = bins%from + (bins%to - bins%from)*part
            if (bins%is_log) values(i) = bins%from*(bins%to/bins%from)**part
         end associate
      end do
   end subroutine get_edges

   !> Opens a file and looks whether it is one of this plan.
   subroutine open_sweep_file(plan, bins, path, is_written, file)
      type(plan_type), intent(in) :: plan
      type(bins_type), intent(in) :: bins(:)
      character(len=*), intent(in) :: path
      logical, intent(in) :: is_written
      type(sweep_file_type), intent(out) :: file
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text
      integer :: i, j

      allocate (file%measures(size(plan%measures)), source=0)
      allocate (file%histograms(6, size(bins)), source=0)
      call open_netcdf(file%nc, path, is_written)
      call check_netcdf(file%nc, path, error)
      file%is_opened = .not. allocated(error)
      if (allocated(error)) return
      call find_variable(file%nc, 'complete', file%complete)
      call find_variable(file%nc, 'chunk_done', file%mark)
      call find_variable(file%nc, 'chunk_reduction', file%reduction)
      call find_variable(file%nc, 'status_points', file%status_points)
      file%is_whole = all([file%complete, file%mark, file%reduction, file%status_points] > 0)
      call get_text(file%nc, 'plan', text)
      file%is_of_plan = file%is_whole .and. text == plan%text .and. len(text) == len(plan%text)
      call get_text(file%nc, 'source', text)
      file%is_of_plan = file%is_of_plan .and. text == 'kyvadlo '//version
      call get_text(file%nc, 'compiler', text)
      file%is_of_plan = file%is_of_plan .and. text == compiler
      call get_text(file%nc, 'flags', text)
      file%is_of_plan = file%is_of_plan .and. text == compiler_flags
      call get_text(file%nc, 'table_checksum', text)
      if (plan%table_checksum == 0) then
         file%is_of_plan = file%is_of_plan .and. text == ''
      else
         file%is_of_plan = file%is_of_plan .and. text == integer_text(plan%table_checksum)
      end if
      if (.not. file%is_of_plan) return
      do i = 1, size(plan%measures)
         if (plan%measures(i)%histogram == 0) call find_variable(file%nc, plan%measures(i)%name, file%measures(i))
      end do
      do i = 1, size(bins)
         do j = 1, 6
            call find_variable(file%nc, plan%histograms(i)%name//'_'//trim(item_names(j)), file%histograms(j, i))
         end do
      end do
      call find_variable(file%nc, 'status', file%status)
   end subroutine open_sweep_file

   subroutine close_sweep_file(file, error)
      type(sweep_file_type), intent(inout) :: file
      type(error_type), allocatable, intent(inout) :: error

      call close_netcdf(file%nc)
      call check_netcdf(file%nc, 'cannot close the file', error)
   end subroutine close_sweep_file

   !> Values, reduction, then the mark.
   subroutine write_chunk(plan, file, found, error)
      type(plan_type), intent(in) :: plan
      type(sweep_file_type), intent(inout) :: file
      type(chunk_type), intent(inout), target :: found  !! NaN becomes the fill value
      type(error_type), allocatable, intent(inout) :: error
      integer(int64), dimension(size(plan%dimensions)) :: start, count
      real(wp), pointer, contiguous :: values(:)
      integer(int8) :: mark(1)
      integer(int64) :: many(2), one(2)
      integer :: i

      call chunk_start(plan%cut, found%chunk, start, count)
      do i = 1, size(plan%measures)
         if (plan%measures(i)%histogram > 0) cycle
         values(1:size(found%stored(i)%values)) => found%stored(i)%values
         where (values /= values) values = fill_value
         if (plan%measures(i)%components > 1) then
            call write_doubles(file%nc, file%measures(i), [1_int64, start], &
               [int(plan%measures(i)%components, int64), count], values)
         else
            call write_doubles(file%nc, file%measures(i), start, count, values)
         end if
      end do
      if (plan%stores_values) call write_bytes(file%nc, file%status, start, count, found%status)
      one = [1_int64, found%chunk + 1]
      many = [size(found%reduction, kind=int64), 1_int64]
      call write_doubles(file%nc, file%reduction, one, many, found%reduction)
      call flush_netcdf(file%nc)
      mark = 1
      call write_bytes(file%nc, file%mark, [found%chunk + 1], [1_int64], mark)
      call flush_netcdf(file%nc)
      call check_netcdf(file%nc, 'cannot write chunk '//integer_text(int(found%chunk)), error)
      call kyvadlo_start_writing(file%descriptor)
   end subroutine write_chunk

   !> The marks of some chunks, from one on (from 0).
   subroutine read_marks(file, first, marks)
      type(sweep_file_type), intent(inout) :: file
      integer(int64), intent(in) :: first
      integer(int8), intent(out) :: marks(:)

      call read_bytes(file%nc, file%mark, [first + 1], [size(marks, kind=int64)], marks)
   end subroutine read_marks

   !> What one file has of a chunk, into another.
   subroutine copy_chunk(plan, from, into, chunk, found, error)
      type(plan_type), intent(in) :: plan
      type(sweep_file_type), intent(inout) :: from, into
      integer(int64), intent(in) :: chunk
      type(chunk_type), intent(inout) :: found       !! Room for it, whose bins are known
      type(error_type), allocatable, intent(inout) :: error
      integer(int64), dimension(size(plan%dimensions)) :: start, count
      integer(int64) :: first, points
      real(wp), allocatable :: values(:)
      integer :: i

      call chunk_start(plan%cut, chunk, start, count)
      call chunk_range(plan%cut, chunk, first, points)
      found%chunk = chunk
      if (allocated(found%stored)) deallocate (found%stored)
      if (allocated(found%status)) deallocate (found%status)
      allocate (found%stored(size(plan%measures)), found%status(merge(points, 0_int64, plan%stores_values)))
      do i = 1, size(plan%measures)
         if (plan%measures(i)%histogram > 0) cycle
         associate (m => plan%measures(i)%components)
            allocate (values(m*points))
            if (m > 1) then
               call read_doubles(from%nc, from%measures(i), [1_int64, start], [int(m, int64), count], values)
            else
               call read_doubles(from%nc, from%measures(i), start, count, values)
            end if
            found%stored(i)%values = reshape(values, [int(m, int64), points])
            deallocate (values)
         end associate
      end do
      if (plan%stores_values) call read_bytes(from%nc, from%status, start, count, found%status)
      call read_doubles(from%nc, from%reduction, [1_int64, chunk + 1], [size(found%reduction, kind=int64), 1_int64], &
         found%reduction)
      call check_netcdf(from%nc, 'cannot read a part', error)
      if (.not. allocated(error)) call write_chunk(plan, into, found, error)
   end subroutine copy_chunk

   !> Whether the file says that it is finished.
   logical function is_sweep_finished(file)
      type(sweep_file_type), intent(inout) :: file
      integer(int8) :: complete(1)

      call read_bytes(file%nc, file%complete, [integer(int64) ::], [integer(int64) ::], complete)
      is_sweep_finished = complete(1) == 1
   end function is_sweep_finished

   !> Where every chunk is done: sums the reductions in the order of the chunks and says that the file is finished.
   subroutine finish_sweep_file(plan, bins, file, missing, error)
      type(plan_type), intent(in) :: plan
      type(bins_type), intent(in) :: bins(:)
      type(sweep_file_type), intent(inout) :: file
      integer(int64), intent(out) :: missing         !! Chunks that are not done
      type(error_type), allocatable, intent(inout) :: error
      integer(int8), allocatable :: marks(:)
      integer(int8) :: complete(1)
      real(wp) :: total(reduction_size(bins)), more(reduction_size(bins)), one(1)
      real(wp), allocatable :: parts(:)              !! Reductions of some chunks
      integer(int64) :: chunk, chunks, first, many
      integer :: i, j, at

      missing = 0
      first = 0
      do while (first < plan%cut%chunks)
         allocate (marks(min(plan%cut%chunks - first, int(buffer, int64))))
         call read_marks(file, first, marks)
         missing = missing + count(marks /= 1)
         first = first + size(marks)
         deallocate (marks)
      end do
      call check_netcdf(file%nc, 'cannot read the file', error)
      if (missing > 0 .or. allocated(error)) return
      many = max(1, buffer/size(total))
      allocate (parts(size(total)*many))
      first = 0
      do while (first < plan%cut%chunks)
         chunks = min(many, plan%cut%chunks - first)
         call read_doubles(file%nc, file%reduction, [1_int64, first + 1], [size(total, kind=int64), chunks], &
            parts(:size(total)*chunks))
         do chunk = 1, chunks
            associate (part => parts((chunk - 1)*size(total) + 1:chunk*size(total)))
               if (first + chunk == 1) total = part
               if (first + chunk > 1) call merge_reductions(bins, total, part)
            end associate
         end do
         first = first + chunks
      end do
      more = total
      call write_doubles(file%nc, file%status_points, [1_int64], [int(status_count, int64)], total(:status_count))
      at = status_count
      do i = 1, size(bins)
         call write_doubles(file%nc, file%histograms(1, i), [1_int64], [int(bins(i)%count, int64)], &
            total(at + items + 1:at + items + bins(i)%count))
         do j = 2, 6
            one = total(at + j)
            if (j <= item_sum .and. .not. more(at + item_count) > 0) one = fill_value
            call write_doubles(file%nc, file%histograms(j, i), [integer(int64) ::], [integer(int64) ::], one)
         end do
         at = at + items + bins(i)%count
      end do
      call flush_netcdf(file%nc)
      complete = 1
      call write_bytes(file%nc, file%complete, [integer(int64) ::], [integer(int64) ::], complete)
      call flush_netcdf(file%nc)
      call check_netcdf(file%nc, 'cannot finish the file', error)
   end subroutine finish_sweep_file

end module kyvadlo_sweep_layout
