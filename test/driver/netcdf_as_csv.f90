!> Prints a NetCDF file of `kyvadlo simulate` as CSV: samples, or with `events` the events; with `attributes` what describes it.
program netcdf_as_csv
   use, intrinsic :: iso_fortran_env, only: output_unit, real64
   use netcdf
   use kyvadlo_number_text, only: shortest_text
   implicit none

   call print_file()

contains

   !> Everything; procedures free what they allocate, the main program would not.
   subroutine print_file()
      character(len=200) :: path, what
      character(len=NF90_MAX_NAME) :: dimension, name, unit
      character(len=:), allocatable :: text
      integer :: file, variables, i, j, length, dimensions(1), wanted
      real(real64), allocatable :: column(:), values(:, :)

      call get_command_argument(1, path)
      call get_command_argument(2, what)
      call check(nf90_open(trim(path), NF90_NOWRITE, file))
      if (what == 'attributes') then
         call print_text(file, NF90_GLOBAL, 'Conventions')
         call print_text(file, NF90_GLOBAL, 'title')
         call print_text(file, NF90_GLOBAL, 'scene')
      end if
      dimension = 'time'
      if (what == 'events') dimension = 'event'
      call check(nf90_inq_dimid(file, trim(dimension), wanted))
      call check(nf90_inquire_dimension(file, wanted, len=length))
      call check(nf90_inquire(file, nVariables=variables))
      allocate (values(length, 0), column(length))
      do i = 1, variables
         call check(nf90_inquire_variable(file, i, name=name, dimids=dimensions))
         if (what == 'attributes') then
            unit = ''
            call check(nf90_get_att(file, i, 'units', unit))
            write (output_unit, '(a)') trim(name)//' '//trim(unit)
            if (name == 'event_kind') call print_text(file, i, 'flag_meanings')
         end if
         if (dimensions(1) /= wanted) cycle
         call check(nf90_get_var(file, i, column))
         values = reshape([values, column], [length, size(values, 2) + 1])
      end do
      if (what == 'attributes') length = 0
      do i = 1, length
         text = shortest_text(values(i, 1))
         do j = 2, size(values, 2)
            text = text//','//shortest_text(values(i, j))
         end do
         write (output_unit, '(a)') text
      end do
      call check(nf90_close(file))
   end subroutine print_file

   subroutine check(status)
      integer, intent(in) :: status

      if (status /= NF90_NOERR) error stop 'NetCDF failed'
   end subroutine check

   subroutine print_text(file, variable, attribute)
      integer, intent(in) :: file, variable
      character(len=*), intent(in) :: attribute
      character(len=:), allocatable :: text
      integer :: length

      call check(nf90_inquire_attribute(file, variable, attribute, len=length))
      allocate (character(len=length) :: text)
      call check(nf90_get_att(file, variable, attribute, text))
      write (output_unit, '(a)') text
   end subroutine print_text

end program netcdf_as_csv
