!> The files of one run, read and written, compared before it begins: no output destroys an input, another output, or
!> what somebody else wrote.
module kyvadlo_run_files
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char
   use kyvadlo_status, only: code_file, code_input, error_type, fail
   use kyvadlo_standard_io, only: message
   implicit none
   private
   public :: run_files_type, add_input, add_output, check_files, is_netcdf_name, is_ordinary, is_ordinary_or_new

   type :: run_file_type
      character(len=:), allocatable :: role       !! In messages: `option --output`, `the scene`
      character(len=:), allocatable :: path
      integer :: descriptor = -1                  !! Of a standard stream, in place of the path
      logical :: is_written = .false.
      character(len=:), allocatable :: mark       !! How an old file must begin to be replaced; empty: anyhow
   end type run_file_type

   type :: run_files_type
      private
      type(run_file_type), allocatable :: files(:)
   end type run_files_type

   interface
      function kyvadlo_same_file(one, one_descriptor, other, other_descriptor) bind(c) result(same)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: one(*), other(*)
         integer(c_int), value :: one_descriptor, other_descriptor
         integer(c_int) :: same
      end function kyvadlo_same_file
      function kyvadlo_kind_of_file(path) bind(c) result(kind)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int) :: kind
      end function kyvadlo_kind_of_file
      function kyvadlo_begins_with(path, mark) bind(c) result(does)
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*), mark(*)
         integer(c_int) :: does
      end function kyvadlo_begins_with
   end interface

   integer(c_int), parameter :: kind_absent = 0, kind_ordinary = 1, kind_pipe = 2

contains

   !> Notes a file that is read; `-` is standard input. Opening a named pipe waits until somebody writes: that is said.
   subroutine add_input(files, role, path)
      type(run_files_type), intent(inout) :: files
      character(len=*), intent(in) :: role, path

      call add(files, role, path, .false., '')
      if (path == '-') files%files(size(files%files))%descriptor = 0
      if (path == '-') return
      if (kyvadlo_kind_of_file(path//c_null_char) == kind_pipe) &
         call message('kyvadlo: '//path//' is a pipe: waiting for what is written into it')
   end subroutine add_input

   !> Notes a file that is written; `-` and no path are standard output. With a mark an old file is replaced only if it
   !> begins so.
   subroutine add_output(files, role, path, mark)
      type(run_files_type), intent(inout) :: files
      character(len=*), intent(in) :: role, path
      character(len=*), intent(in), optional :: mark

      if (present(mark)) then
         call add(files, role, path, .true., mark)
      else
         call add(files, role, path, .true., '')
      end if
      if (path == '-' .or. path == '') files%files(size(files%files))%descriptor = 1
   end subroutine add_output

   subroutine add(files, role, path, is_written, mark)
      type(run_files_type), intent(inout) :: files
      character(len=*), intent(in) :: role, path, mark
      logical, intent(in) :: is_written
      type(run_file_type), allocatable :: more(:)
      integer :: count

      if (.not. allocated(files%files)) allocate (files%files(0))
      count = size(files%files)
      allocate (more(count + 1))
      more(:count) = files%files
      more(count + 1)%role = role
      more(count + 1)%path = path
      more(count + 1)%is_written = is_written
      more(count + 1)%mark = mark
      call move_alloc(more, files%files)
   end subroutine add

   !> Refuses two names of one file, unless both are only read, and helpers that would replace what we did not write.
   subroutine check_files(files, error)
      type(run_files_type), intent(in) :: files
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j

      if (.not. allocated(files%files)) return
      do i = 1, size(files%files)
         associate (one => files%files(i))
            do j = 1, i - 1
               associate (other => files%files(j))
                  if (.not. (one%is_written .or. other%is_written)) cycle
                  if (kyvadlo_same_file(one%path//c_null_char, int(one%descriptor, c_int), other%path//c_null_char, &
                     int(other%descriptor, c_int)) == 0) cycle
                  call fail(error, code_input, other%role//' and '//one%role//' are one file: '//named(one, other))
                  return
               end associate
            end do
            if (one%mark == '') cycle
            if (kyvadlo_kind_of_file(one%path//c_null_char) == kind_absent) cycle
            if (kyvadlo_begins_with(one%path//c_null_char, one%mark//c_null_char) /= 0) cycle
            call fail(error, code_file, one%role//' would replace '//one%path// &
               ', which kyvadlo did not write; remove it or choose another name')
            return
         end associate
      end do
   end subroutine check_files

   !> The path of one of two files: a standard stream has none.
   function named(one, other) result(path)
      type(run_file_type), intent(in) :: one, other
      character(len=:), allocatable :: path

      path = one%path
      if (one%descriptor >= 0) path = other%path
   end function named

   !> Whether a file is to be NetCDF, by its ending.
   pure logical function is_netcdf_name(name)
      character(len=*), intent(in) :: name

      is_netcdf_name = .false.
      if (len(name) > 3) is_netcdf_name = name(len(name) - 2:) == '.nc'
   end function is_netcdf_name

   !> Whether there is an ordinary file of this name.
   logical function is_ordinary(path)
      character(len=*), intent(in) :: path

      is_ordinary = kyvadlo_kind_of_file(path//c_null_char) == kind_ordinary
   end function is_ordinary

   !> Whether there is an ordinary file of this name, or nothing.
   logical function is_ordinary_or_new(path)
      character(len=*), intent(in) :: path
      integer(c_int) :: kind

      kind = kyvadlo_kind_of_file(path//c_null_char)
      is_ordinary_or_new = kind == kind_absent .or. kind == kind_ordinary
   end function is_ordinary_or_new

end module kyvadlo_run_files
