!> Random changes of scenes, pivot tables, requests of eval and options, handed to the readers in one process: millions
!> of inputs in minutes, under the sanitizers.
!>
!>    attacks_fuzz scene|simulation|table|request|options|all COUNT [FIRST]
!>
!> Input number i is the same in every run; what goes wrong ends the program, and the last number printed says where. It
!> must run in a folder of its own: `table` writes a file.
program attacks_fuzz
   use, intrinsic :: iso_fortran_env, only: error_unit, int64, output_unit, real32, real64
   use kyvadlo_command_line, only: arguments_type, sort_words
   use kyvadlo_eval, only: answer_request
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_reader, only: parse_scene
   use kyvadlo_simulation, only: parse_simulation, simulation_type
   use kyvadlo_simulation_path, only: choose_path, path_type
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: append, text_type
   implicit none

   character(len=*), parameter :: lf = new_line('a')
   integer, parameter :: longest = 4096
   character(len=80), parameter :: words(*) = [character(len=80) :: '1e400', '-0', 'nan', '1e-400', '99999999999', &
      '10000*1', '3*', "'", '"', "''", '&', '/', '!', '=', ',', '(1)', '(1:3)', '(-1)', '1e300', '-1e300', '4.9e-324', &
      '.true.', '.f.', '1d0', '1q0', 'inf', '&end', '&output', '&pendulum', '#', '0', '1', '-1', '0.5', '+', '-', '.', &
      'e', '1e', '--', '=', achar(0), achar(9), achar(10), achar(13), achar(127), char(255), char(239)//char(187)// &
      char(191), 'position=', 'velocity=', 'z_upper=', 'length=', 'gravity=', 'duration=', 'samples=', 'name=', &
      '2147483648', '9223372036854775808', '1e-16', '0.9999999999999999', '--kind', '--output', 'quad', 'single', 'K', &
      'theta', 'Pi', 'cubic', 'state']
   character(len=400), parameter :: scenes(*) = [character(len=400) :: &
      "&pendulum name='swing', length=1, z_upper=0.3, z_lower=-0.8 /", &
      '&pendulum length=67 gravity=9.81 release_angle=2.5 release_speed=0.05 / ! Foucault', &
      '&pendulum length=1 position=0.6,0,-0.8 velocity=3*0.5 /'//lf//'&output duration=2 samples=9'// &
      " quantities='position azimuth energy' /"//lf//'&string restitution=0.5 /', &
      '&pendulum length=1 energy_above_top=0.1 momentum=0.2 /'//lf// &
      '&air linear=0.1 quadratic=0.2 / &wind velocity=1,2,3 /', '&pendulum length=1 z_upper=-0.2 z_lower=-0.8 /'//lf// &
      '&earth_rotation latitude=48.85 / &buoyancy density_ratio=0.1 '// &
      'added_mass=0.5 / &elastic stiffness=1000 mass=1 /', '&pendulum length=1 z_upper=-0.2 z_lower=-0.8 /'//lf// &
      '&moving_pivot amplitude=0.1,0,0 frequency=3*0.5 phase=3*90 '// &
      'relative=.true. / &anisotropic_support extra_length_x=0.1 / &turning_frame rate=0.1 / &output samples=3 /']
   character(len=400), parameter :: tables(*) = [character(len=400) :: '0 0 0 0'//lf//'1,0.5,0,0'//lf// &
      '2 1 0 0 # end'//lf, '0 0 0 0'//lf//'0.5 1e-3 2e-3 3e-3'//lf//lf//'1 0 0 0'//lf//'9 0 0 0']
   character(len=400), parameter :: requests(*) = [character(len=400) :: 'K 0.5', 'Piinc 0.5 1.2 0.3', 'jacobi 3 0.7', &
      'theta 3 0.2 0.1', 'cubic 1 2 3 4', 'turning 1 9.8 1 1', 'orbit 1 9.8 0.3 -0.8', 'position 1 9.8 0.3 -0.8 12', &
      'state 1 9.8 0.6 0 -0.8 0 1 0 3', 'passage_height 1 9.8 0.3 -0.8 0', 'rj 1 2 3 4', 'heuman 1 0.5', 'zeta 1 0.5']
   character(len=400), parameter :: options(*) = [character(len=400) :: 'table --kind quad --divisions 4 scene.nml', &
      'simulate scene.nml --output=out.csv --events e --explain', 'eval --kind single K 0.5 -- -1', &
      'table --upper -0.9:0.9:19 --lower=-1:0:11 --format csv', 'study --quick --seconds 1e-3 --output d', '--help', &
      '-h']

   character(len=*), parameter :: kinds(*) = [character(len=10) :: 'scene', 'simulation', 'table', 'request', 'options']
   integer(int64) :: state
   integer(int64) :: first, count, i, accepted
   integer :: k
   character(len=32) :: kind, word

   call get_command_argument(1, kind)
   call get_command_argument(2, word)
   read (word, *) count
   first = 1
   if (command_argument_count() > 2) then
      call get_command_argument(3, word)
      read (word, *) first
   end if
   if (all(kinds /= kind) .and. &
      kind /= 'all') error stop 'attacks_fuzz scene|simulation|table|request|options|all COUNT [FIRST]'
   do k = 1, size(kinds)
      if (kind == 'all' .or. kind == kinds(k)) call try_all(kinds(k))
   end do

contains

   !> Every input of a kind.
   subroutine try_all(kind)
      character(len=*), intent(in) :: kind
      integer :: j, k

      accepted = 0
      do i = first, first + count - 1
         if (modulo(i - first, 10000_int64) == 0) then
            write (error_unit, '(2a,i0)') trim(kind), ' ', i
            flush (error_unit)
         end if
         state = ieor(1442695040888963407_int64, ieor(i, ishft(i, 32)))
         do j = 1, 4
            k = random(2)
         end do
         select case (kind)
         case ('scene')
            call try_scene(changed(scenes))
         case ('simulation')
            call try_simulation(changed(scenes))
         case ('table')
            call try_table(changed(tables))
         case ('request')
            call try_request(changed(requests))
         case default
            call try_options(changed(options))
         end select
      end do
      write (output_unit, '(a,2(1x,i0),a)') trim(kind), count, accepted, ' accepted, the rest refused'
   end subroutine try_all

   !> A number from 0 to n - 1.
   integer function random(n)
      integer, intent(in) :: n

      state = ieor(state, ishft(state, 13))
      state = ieor(state, ishft(state, -7))
      state = ieor(state, ishft(state, 17))
      random = int(modulo(ishft(state, -16), int(n, int64)))
   end function random

   !> One of the seeds, changed in one to four places.
   function changed(seeds) result(text)
      character(len=*), intent(in) :: seeds(:)
      character(len=:), allocatable :: text, other
      integer :: j, at, length

      text = trim(seeds(1 + random(size(seeds))))
      do j = 0, random(4)
         at = random(len(text) + 1)
         length = min(random(12), len(text) - at)
         select case (random(8))
         case (0)
            if (at < len(text)) text(at + 1:at + 1) = char(random(256))
         case (1)
            text = text(:at)//text(at + length + 1:)
         case (2)
            text = text(:at)//text(at + 1:at + length)//text(at + 1:)
         case (3, 4)
            text = text(:at)//trim(words(1 + random(size(words))))//text(at + 1:)
         case (5)
            text = text(:at)//trim(words(1 + random(size(words))))//text(at + length + 1:)
         case (6)
            if (random(4) == 0) text = text(:at)
         case default
            other = trim(seeds(1 + random(size(seeds))))
            text = text(:at)//other(min(len(other), 1 + random(len(other))):)
         end select
         if (len(text) > longest) text = text(:longest)
      end do
   end function changed

   subroutine note(error)
      type(error_type), allocatable, intent(in) :: error

      if (.not. allocated(error)) accepted = accepted + 1
      if (allocated(error)) then
         if (len_trim(error%message) == 0) error stop 'a refusal without a word'
      end if
   end subroutine note

   subroutine try_scene(text)
      character(len=*), intent(in) :: text
      type(pendulum_type), allocatable :: pendulums(:)
      type(error_type), allocatable :: error

      call parse_scene(text, 'fuzz', pendulums, error)
      call note(error)
   end subroutine try_scene

   !> With the orbit, and the flights of a string.
   subroutine try_simulation(text)
      character(len=*), intent(in) :: text
      type(simulation_type) :: simulation
      type(path_type) :: path
      type(error_type), allocatable :: error

      call parse_simulation(text, 'fuzz', simulation, error)
      if (.not. allocated(error)) then
         if (.not. allocated(simulation%settings%table)) call choose_path(simulation, path, error)
      end if
      call note(error)
   end subroutine try_simulation

   subroutine try_table(text)
      character(len=*), intent(in) :: text
      type(simulation_type) :: simulation
      type(path_type) :: path
      type(error_type), allocatable :: error
      integer :: unit

      open (newunit=unit, file='fuzz.table', access='stream', status='replace', action='write')
      write (unit) text
      close (unit)
      call parse_simulation('&pendulum length=1 z_upper=0 z_lower=-0.5 / &output duration=1 samples=2 / '// &
         "&moving_pivot table='fuzz.table' /", 'fuzz', simulation, error)
      if (.not. allocated(error)) call choose_path(simulation, path, error)
      call note(error)
   end subroutine try_table

   subroutine try_request(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: answer
      logical :: failed

      call answer_request(1.0_real64, text, .false., answer, failed)
      if (.not. failed) accepted = accepted + 1
      if (len(answer) == 0 .and. text /= '') error stop 'a request without an answer'
      call answer_request(1.0_real32, text, .true., answer, failed)
   end subroutine try_request

   subroutine try_options(text)
      character(len=*), intent(in) :: text
      type(text_type), allocatable :: list(:)
      type(arguments_type) :: arguments
      type(error_type), allocatable :: error
      integer :: begin, length

      allocate (list(0))
      begin = 1
      do while (begin <= len(text))
         length = index(text(begin:)//' ', ' ') - 1
         call append(list, text(begin:begin + length - 1))
         begin = begin + length + 1
      end do
      call sort_words(list, arguments, error)
      call note(error)
   end subroutine try_options

end program attacks_fuzz
