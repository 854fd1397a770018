!> One orbit as CSV: times, positions and velocities over some periods of the height.
!>
!>    orbit_to_csv [UPPER LOWER [PERIODS [ROWS_PER_PERIOD]]]      heights in metres, of a pendulum of 1 m
program orbit_to_csv
   use, intrinsic :: iso_fortran_env, only: error_unit, wp => real64
   use kyvadlo, only: kyvadlo_error_type, new_orbit_from_heights, orbit_type
   implicit none
   type(orbit_type) :: orbit
   type(kyvadlo_error_type), allocatable :: error
   real(wp) :: upper, lower
   real(wp), allocatable :: time(:), position(:, :), velocity(:, :)
   integer :: periods, rows, i

   upper = 0.3_wp
   lower = -0.8_wp
   periods = 1
   rows = 8
   call read_arguments()

   ! Set up once: everything that does not change with time. A rule that is broken is named with the values.
   call new_orbit_from_heights(orbit, 1.0_wp, 9.80665_wp, upper, lower, error)
   if (allocated(error)) then
      write (error_unit, '(2a)') 'orbit_to_csv: ', error%message
      stop 2
   end if

   ! Evaluate many: whole arrays of times go to the vector kernels.
   time = [(orbit%period()*i/rows, i = 0, periods*rows)]
   allocate (position(3, size(time)), velocity(3, size(time)))
   call orbit%locate(time, position, velocity)

   print '(a)', 't,x,y,z,vx,vy,vz'
   do i = 1, size(time)
      print '(*(es23.16, :, ","))', time(i), position(:, i), velocity(:, i)
   end do
   deallocate (time, position, velocity)

contains

   subroutine read_arguments()
      character(len=40) :: text(4)
      integer :: count, status

      text = ''
      count = command_argument_count()
      do i = 1, min(count, 4)
         call get_command_argument(i, text(i))
      end do
      status = 0
      if (count >= 2) read (text(:2), *, iostat=status) upper, lower
      if (status == 0 .and. count >= 3) read (text(3), *, iostat=status) periods
      if (status == 0 .and. count >= 4) read (text(4), *, iostat=status) rows
      if (status /= 0 .or. count == 1 .or. count > 4 .or. periods < 1 .or. rows < 1) then
         write (error_unit, '(a)') 'Usage: orbit_to_csv [UPPER LOWER [PERIODS [ROWS_PER_PERIOD]]]'
         stop 2
      end if
   end subroutine read_arguments
end program orbit_to_csv
