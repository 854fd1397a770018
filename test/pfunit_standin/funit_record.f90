!> What happened: the failures of the running test, and the totals of the run.
module funit_record
   use, intrinsic :: iso_fortran_env, only: output_unit
   use, intrinsic :: iso_c_binding, only: c_int
   implicit none
   private
   public :: SourceLocation, throw, catch, anyExceptions
   public :: run_test, skip_test, begin_test, end_test, run_suites

   character(len=*), parameter :: nl = new_line('a')

   !> Where an assertion stands.
   type :: SourceLocation
      character(len=255) :: fileName = '<unknown file>'
      integer :: lineNumber = -1
   end type SourceLocation

   type :: exception_type
      character(len=:), allocatable :: message, location
   end type exception_type

   abstract interface
      subroutine test_procedure()
      end subroutine test_procedure
   end interface

   interface
      !> C's exit: STOP would write after the totals, which must come last.
      subroutine exit_quietly(status) bind(c, name='exit')
         import :: c_int
         integer(c_int), value :: status
      end subroutine exit_quietly
   end interface

   type(exception_type), allocatable :: exceptions(:)   !! Of the running test
   character(len=:), allocatable :: running             !! Its name
   character(len=:), allocatable :: filter              !! Only tests whose name contains this are run
   character(len=:), allocatable :: report              !! The failures so far, shown at the end
   integer :: passed = 0, failed = 0, skipped = 0

contains

   !> Adds a failure to the running test.
   subroutine throw(message, location)
      character(len=*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location
      type(exception_type) :: e
      character(len=16) :: number
      e%message = message
      e%location = '<unknown location>'
      if (present(location)) then
         write (number, '(i0)') location%lineNumber
         e%location = trim(location%fileName)//':'//trim(number)
      end if
      if (.not. allocated(exceptions)) allocate (exceptions(0))
      exceptions = [exceptions, e]
   end subroutine throw

   !> Has the running test failed?
   logical function anyExceptions()
      anyExceptions = .false.
      if (allocated(exceptions)) anyExceptions = size(exceptions) > 0
   end function anyExceptions

   !> Takes one exception (with this message) off the list.
   logical function catch(message)
      character(len=*), intent(in), optional :: message
      integer :: i
      catch = .false.
      if (.not. anyExceptions()) return
      do i = 1, size(exceptions)
         catch = .true.
         if (present(message)) catch = exceptions(i)%message == message
         if (catch) exit
      end do
      if (catch) exceptions = [exceptions(:i - 1), exceptions(i + 1:)]
   end function catch

   !> Runs one test between its set-up and tear-down.
   subroutine run_test(name, method, setUp, tearDown)
      character(len=*), intent(in) :: name
      procedure(test_procedure) :: method
      procedure(test_procedure), optional :: setUp, tearDown
      if (.not. begin_test(name)) return
      if (present(setUp)) call setUp()
      if (.not. anyExceptions()) then
         call method()
         if (present(tearDown)) call tearDown()
      end if
      call end_test()
   end subroutine run_test

   !> Starts a test, if the filter lets it run.
   logical function begin_test(name)
      character(len=*), intent(in) :: name
      begin_test = index(name, filter) > 0
      if (allocated(exceptions)) deallocate (exceptions)
      running = name
   end function begin_test

   !> Writes how the test went and adds it to the totals.
   subroutine end_test()
      integer :: i
      if (anyExceptions()) then
         failed = failed + 1
         write (output_unit, '(2a)') 'FAIL  ', running
         do i = 1, size(exceptions)
            report = report//nl//'Failure in: '//running//nl//'  Location: ['//exceptions(i)%location//']'//nl// &
               exceptions(i)%message//nl
         end do
      else
         passed = passed + 1
         write (output_unit, '(2a)') 'pass  ', running
      end if
      flush (output_unit)
   end subroutine end_test

   !> Counts a disabled test.
   subroutine skip_test(name)
      character(len=*), intent(in) :: name
      if (.not. begin_test(name)) return
      skipped = skipped + 1
      write (output_unit, '(2a)') 'skip  ', name
   end subroutine skip_test

   !> The whole run: `suites` calls run_test for every test. Options: --filter NAME; pFUnit's --verbose is accepted.
   !> The last line is `N passed, N failed`, with `, N skipped` where tests are disabled; exit status 2 if one failed.
   subroutine run_suites(suites)
      procedure(test_procedure) :: suites
      character(len=256) :: arg
      integer :: i
      filter = ''
      report = ''
      do i = 1, command_argument_count()
         call get_command_argument(i, arg)
         if (arg == '--filter' .or. arg == '-f') then
            call get_command_argument(i + 1, arg)
            filter = trim(arg)
         end if
      end do
      call suites()
      if (report /= '') write (output_unit, '(a)') report
      write (output_unit, '(i0,a,i0,a)', advance='no') passed, ' passed, ', failed, ' failed'
      if (skipped > 0) write (output_unit, '(", ",i0," skipped")', advance='no') skipped
      write (output_unit, '(a)') ''
      flush (output_unit)
      if (failed > 0) call exit_quietly(2_c_int)
   end subroutine run_suites

end module funit_record
