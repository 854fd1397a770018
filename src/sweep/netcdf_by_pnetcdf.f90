!> NetCDF files of sweeps by PnetCDF: the build with MPI. The only source that knows PnetCDF.
module kyvadlo_sweep_netcdf
   use mpi_f08, only: MPI_COMM_SELF, MPI_INFO_NULL, MPI_Info, MPI_Info_create, MPI_Info_free, MPI_Info_set, &
      MPI_OFFSET_KIND
   use pnetcdf
   use, intrinsic :: iso_fortran_env, only: int8, int64
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_status, only: code_file, error_type, fail
   implicit none
   private
   public :: netcdf_type, create_netcdf, open_netcdf, define_dimension, define_variable, put_text, put_numbers, &
      put_flags, end_definitions, find_variable, get_text, write_doubles, write_bytes, read_doubles, read_bytes, &
      flush_netcdf, close_netcdf, check_netcdf

   logical, parameter, public :: with_netcdf = .true.
   integer, parameter, public :: global = NF90_GLOBAL

   !> An open file. What fails first is kept, the rest does nothing.
   type :: netcdf_type
      private
      integer :: file = 0
      integer :: status = NF90_NOERR
      logical :: is_open = .false.
   end type netcdf_type

contains

   !> A new file in the format CDF-5. Nothing is written into variables that nobody sets.
   subroutine create_netcdf(nc, path)
      type(netcdf_type), intent(out) :: nc
      character(len=*), intent(in) :: path
      type(MPI_Info) :: hints

      ! No room between header and variables: the bytes are those of every other NetCDF library.
      call MPI_Info_create(hints)
      call MPI_Info_set(hints, 'nc_header_align_size', '1')
      call MPI_Info_set(hints, 'nc_var_align_size', '1')
      nc%status = nf90mpi_create(MPI_COMM_SELF%MPI_VAL, path, ior(NF90_CLOBBER, NF90_64BIT_DATA), hints%MPI_VAL, &
         nc%file)
      call MPI_Info_free(hints)
      nc%is_open = nc%status == NF90_NOERR
   end subroutine create_netcdf

   subroutine open_netcdf(nc, path, is_written)
      type(netcdf_type), intent(out) :: nc
      character(len=*), intent(in) :: path
      logical, intent(in) :: is_written

      ! Every rank opens the file for itself: no write waits for another rank.
      nc%status = nf90mpi_open(MPI_COMM_SELF%MPI_VAL, path, merge(NF90_WRITE, NF90_NOWRITE, is_written), &
         MPI_INFO_NULL%MPI_VAL, nc%file)
      nc%is_open = nc%status == NF90_NOERR
      if (nc%is_open) nc%status = nf90mpi_begin_indep_data(nc%file)
   end subroutine open_netcdf

   subroutine keep(nc, status)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: status

      if (nc%status == NF90_NOERR) nc%status = status
   end subroutine keep

   !> Turns what failed into an error.
   subroutine check_netcdf(nc, what, error)
      type(netcdf_type), intent(in) :: nc
      character(len=*), intent(in) :: what
      type(error_type), allocatable, intent(inout) :: error

      if (nc%status == NF90_NOERR .or. allocated(error)) return
      call fail(error, code_file, what//': '//trim(nf90mpi_strerror(nc%status)))
   end subroutine check_netcdf

   subroutine define_dimension(nc, name, count, dimension)
      type(netcdf_type), intent(inout) :: nc
      character(len=*), intent(in) :: name
      integer(int64), intent(in) :: count
      integer, intent(out) :: dimension

      dimension = 0
      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_def_dim(nc%file, name, int(count, MPI_OFFSET_KIND), dimension))
   end subroutine define_dimension

   subroutine define_variable(nc, name, is_byte, dimensions, variable)
      type(netcdf_type), intent(inout) :: nc
      character(len=*), intent(in) :: name
      logical, intent(in) :: is_byte                 !! Else double
      integer, intent(in) :: dimensions(:)           !! The fastest first
      integer, intent(out) :: variable

      variable = 0
      if (nc%status /= NF90_NOERR) return
      call keep(nc, nf90mpi_def_var(nc%file, name, merge(NF90_BYTE, NF90_DOUBLE, is_byte), dimensions, variable))
   end subroutine define_variable

   subroutine put_text(nc, variable, name, text)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      character(len=*), intent(in) :: name, text

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_put_att(nc%file, variable, name, text))
   end subroutine put_text

   subroutine put_numbers(nc, variable, name, numbers)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: numbers(:)

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_put_att(nc%file, variable, name, numbers))
   end subroutine put_numbers

   subroutine put_flags(nc, variable, name, flags)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      character(len=*), intent(in) :: name
      integer(int8), intent(in) :: flags(:)

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_put_att(nc%file, variable, name, flags))
   end subroutine put_flags

   subroutine end_definitions(nc)
      type(netcdf_type), intent(inout) :: nc

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_enddef(nc%file))
      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_begin_indep_data(nc%file))
   end subroutine end_definitions

   !> The number of a variable; 0: there is none.
   subroutine find_variable(nc, name, variable)
      type(netcdf_type), intent(in) :: nc
      character(len=*), intent(in) :: name
      integer, intent(out) :: variable

      variable = 0
      if (nc%status /= NF90_NOERR) return
      if (nf90mpi_inq_varid(nc%file, name, variable) /= NF90_NOERR) variable = 0
   end subroutine find_variable

   !> A text of the whole file; empty: there is none.
   subroutine get_text(nc, name, text)
      type(netcdf_type), intent(in) :: nc
      character(len=*), intent(in) :: name
      character(len=:), allocatable, intent(out) :: text
      integer(MPI_OFFSET_KIND) :: length
      integer :: type_of

      text = ''
      if (nc%status /= NF90_NOERR) return
      if (nf90mpi_inquire_attribute(nc%file, NF90_GLOBAL, name, xtype=type_of, len=length) /= NF90_NOERR) return
      if (type_of /= NF90_CHAR) return
      deallocate (text)
      allocate (character(len=length) :: text)
      if (nf90mpi_get_att(nc%file, NF90_GLOBAL, name, text) /= NF90_NOERR) text = ''
   end subroutine get_text

   subroutine write_doubles(nc, variable, start, count, values)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      integer(int64), intent(in) :: start(:), count(:) !! The fastest dimension first
      real(wp), intent(inout) :: values(:)           !! Come back as they were: PnetCDF turns their bytes in place

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_put_var(nc%file, variable, values, &
         int(start, MPI_OFFSET_KIND), int(count, MPI_OFFSET_KIND)))
   end subroutine write_doubles

   subroutine write_bytes(nc, variable, start, count, values)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      integer(int64), intent(in) :: start(:), count(:)
      integer(int8), intent(inout) :: values(:)

      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_put_var(nc%file, variable, values, &
         int(start, MPI_OFFSET_KIND), int(count, MPI_OFFSET_KIND)))
   end subroutine write_bytes

   subroutine read_doubles(nc, variable, start, count, values)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      integer(int64), intent(in) :: start(:), count(:)
      real(wp), intent(out) :: values(:)

      values = 0
      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_get_var(nc%file, variable, values, &
         int(start, MPI_OFFSET_KIND), int(count, MPI_OFFSET_KIND)))
   end subroutine read_doubles

   subroutine read_bytes(nc, variable, start, count, values)
      type(netcdf_type), intent(inout) :: nc
      integer, intent(in) :: variable
      integer(int64), intent(in) :: start(:), count(:)
      integer(int8), intent(out) :: values(:)

      values = 0
      if (nc%status == NF90_NOERR) call keep(nc, nf90mpi_get_var(nc%file, variable, values, &
         int(start, MPI_OFFSET_KIND), int(count, MPI_OFFSET_KIND)))
   end subroutine read_bytes

   !> What was written before stands in the file before what is written after.
   subroutine flush_netcdf(nc)
      type(netcdf_type), intent(inout) :: nc

      ! Independent writes go straight to the system, one after the other.
      if (.not. nc%is_open) nc%status = NF90_EBADID
   end subroutine flush_netcdf

   subroutine close_netcdf(nc)
      type(netcdf_type), intent(inout) :: nc

      if (nc%is_open) call keep(nc, nf90mpi_close(nc%file))
      nc%is_open = .false.
   end subroutine close_netcdf

end module kyvadlo_sweep_netcdf
