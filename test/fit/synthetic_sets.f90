!> The five cases of doc/fitting.md as sets of data: another orbit, other parameters, times and noise for every seed.
module synthetic_sets
   use, intrinsic :: iso_fortran_env, only: int64, wp => real64
   use random_numbers, only: decades, new_stream, stream_type, uniform
   use taylor_motion, only: crossings, pendulum_type, states_at
   implicit none
   private
   public :: set_type, new_set, predict, report

   !> theta: length, gravity, two angles of the start, two speeds, then what the case adds.
   type :: set_type
      integer :: case = 0, rows = 0, columns = 0
      real(wp), allocatable :: theta(:), steps(:)   !! steps: natural sizes
      integer, allocatable :: free(:)               !! Places in theta of what the fit does not know
      real(wp), allocatable :: times(:), measured(:), truth(:)
      real(wp) :: sigma = 0
      character(len=12), allocatable :: names(:)    !! Of `truth`, as the CSV of a fit has them
      character(len=:), allocatable :: scene, table
      character(len=20) :: more = ''                !! What is free beyond that, and cannot be told
   end type set_type

   real(wp), parameter :: pi = acos(-1.0_wp), degree = pi/180, earth_rate = 7.292115e-5_wp

contains

   subroutine new_set(set, case, seed, with_more)
      type(set_type), intent(out) :: set
      integer, intent(in) :: case, seed
      logical, intent(in) :: with_more              !! One parameter more is free
      type(stream_type) :: random
      real(wp) :: rate, sigma_part
      character(len=:), allocatable :: free, given, groups
      integer :: i

      set%case = case
      ! Far from one another for neighbouring seeds.
      random = new_stream(int(modulo((seed + 1000003_int64*case)*2654435761_int64, 1073741789_int64)) + 1)
      allocate (set%theta(9), set%steps(9))
      set%theta = 0
      groups = ''
      select case (case)
      case (1)
         call draw_pendulum(-1.0_wp, 1.3_wp, 1.5_wp, 25.0_wp)
         call draw_wide_start()
         set%rows = int(uniform(random, 60.0_wp, 400.0_wp))
         call draw_times(3.0_wp, 30.0_wp)
         sigma_part = decades(random, -4.0_wp, -2.0_wp)
         set%sigma = set%theta(1)*sigma_part
         set%columns = 3
         free = 'length gravity position velocity'
         given = ''
         set%free = [1, 2, 3, 4, 5, 6]
         set%more = 'density_ratio'
      case (2)
         set%theta(1) = uniform(random, 2.0_wp, 30.0_wp)
         set%theta(2) = uniform(random, 9.78_wp, 9.83_wp)
         rate = sqrt(set%theta(2)/set%theta(1))
         set%theta(3) = uniform(random, 2.0_wp, 6.0_wp)*degree
         set%theta(4) = uniform(random, -pi, pi)
         set%theta(5) = set%theta(3)*set%theta(1)*rate*uniform(random, -0.01_wp, 0.01_wp)
         set%theta(6) = set%theta(3)*set%theta(1)*rate*uniform(random, -0.03_wp, 0.03_wp)
         set%theta(7) = uniform(random, 20.0_wp, 70.0_wp)
         set%rows = int(3600*rate/(2*pi)*uniform(random, 3.0_wp, 7.0_wp))
         set%times = [(3600.0_wp*i/set%rows, i=0, set%rows - 1)]
         set%sigma = decades(random, -3.7_wp, -2.7_wp)
         set%columns = 2
         free = 'length latitude position velocity'
         given = 'gravity = '//number(set%theta(2))
         groups = '&earth_rotation /'//new_line('a')
         set%free = [1, 3, 4, 5, 6, 7]
         set%more = 'extra_length_x'                 ! With extra_length_y: of three lengths the sums are known
      case (3)
         call draw_pendulum(-0.7_wp, 1.0_wp, 3.0_wp, 25.0_wp)
         call draw_wide_start()
         set%theta(7) = rate*decades(random, -2.5_wp, -1.0_wp)
         set%rows = int(uniform(random, 100.0_wp, 400.0_wp))
         call draw_times(4.0_wp, 20.0_wp)
         set%sigma = set%theta(1)*decades(random, -4.0_wp, -2.3_wp)
         set%columns = 3
         free = 'length gravity position velocity linear'
         given = ''
         set%free = [1, 2, 3, 4, 5, 6, 7]
         set%more = 'density_ratio'
      case (4)
         call draw_pendulum(-0.7_wp, 1.0_wp, 3.0_wp, 25.0_wp)
         set%theta(3) = uniform(random, 10.0_wp, 120.0_wp)*degree
         set%theta(7) = rate*decades(random, -3.0_wp, -1.5_wp)
         set%rows = int(uniform(random, 10.0_wp, 60.0_wp))
         allocate (set%times(0))
         set%sigma = decades(random, -4.0_wp, -2.7_wp)/rate
         set%columns = 1
         free = 'gravity linear'
         given = 'length = '//number(set%theta(1))//', '
         if (with_more) given = ''
         given = given//'release_angle = '//number(set%theta(3)/degree)
         set%free = [2, 7]
         set%more = 'length'
      case (5)
         call draw_pendulum(-0.7_wp, 1.0_wp, 9.7_wp, 9.9_wp)
         call draw_wide_start()
         set%theta = [set%theta(:6), decades(random, 1.0_wp, 3.0_wp), uniform(random, -30.0_wp, 30.0_wp), &
            set%theta(1)*uniform(random, -2.0_wp, 2.0_wp), set%theta(1)*uniform(random, -2.0_wp, 2.0_wp)]
         set%steps = [real(wp) :: set%steps, 0]
         set%rows = int(uniform(random, 100.0_wp, 400.0_wp))
         call draw_times(3.0_wp, 20.0_wp)
         set%sigma = set%theta(7)*set%theta(1)*decades(random, -4.0_wp, -3.0_wp)
         set%columns = 2
         free = 'length position velocity offset scale angle'
         given = 'gravity = '//number(set%theta(2))
         groups = "&camera view = 'xz' /"//new_line('a')
         set%free = [1, 3, 4, 5, 6, 7, 8, 9, 10]
         set%more = 'gravity'
      end select
      if (with_more) free = free//' '//trim(set%more)
      if (with_more .and. case == 2) free = free//' extra_length_y'
      if (with_more .and. case == 5) given = ''
      rate = sqrt(set%theta(2)/set%theta(1))
      set%steps(:6) = [set%theta(1), set%theta(2), 1.0_wp, 1.0_wp, set%theta(1)*rate, set%theta(1)*rate]
      if (case == 2) set%steps(5:6) = set%theta(3)*set%steps(5:6)
      if (case == 2) set%steps(3:4) = [set%theta(3), 1.0_wp]
      set%steps(7) = set%theta(7)
      if (case == 2) set%steps(7) = 57
      if (case == 5) set%steps(8:) = [57.0_wp, set%theta(1), set%theta(1)]
      set%names = names_of(case)
      set%truth = report(set, set%theta)
      set%measured = predict(set, set%theta)
      do i = 1, size(set%measured)
         set%measured(i) = set%measured(i) + set%sigma*normal(random)
      end do
      set%scene = '&pendulum '//given//' /'//new_line('a')//groups//"&fit free = '"//free//"', sigma = "// &
         number(set%sigma)//' /'//new_line('a')
      call write_table(set)

   contains

      subroutine draw_pendulum(shortest, longest, weakest, strongest)
         real(wp), intent(in) :: shortest, longest, weakest, strongest   !! Decades of l, then g

         set%theta(1) = decades(random, shortest, longest)
         set%theta(2) = uniform(random, weakest, strongest)
         rate = sqrt(set%theta(2)/set%theta(1))
      end subroutine draw_pendulum

      !> Angles of 20 to 130 degrees; energies of up to 37 degrees above the level of the pivot.
      subroutine draw_wide_start()
         real(wp) :: speed, across, l, g

         l = set%theta(1)
         g = set%theta(2)
         do
            set%theta(3) = uniform(random, 20.0_wp, 130.0_wp)*degree
            set%theta(4) = uniform(random, -pi, pi)
            speed = uniform(random, 0.1_wp, 1.2_wp)*sqrt(g*l)
            across = uniform(random, -pi, pi)
            set%theta(5:6) = speed*[cos(across), sin(across)]
            if (speed**2/2 - g*l*cos(set%theta(3)) < 0.8_wp*g*l) exit
         end do
      end subroutine draw_wide_start

      subroutine draw_times(least, most)
         real(wp), intent(in) :: least, most        !! Small periods
         real(wp) :: span, periods

         periods = uniform(random, least, most)
         ! Fewer rows a period would fit an alias as well.
         set%rows = max(set%rows, nint(5*periods))
         span = 2*pi/rate*periods
         set%times = [(span*i/set%rows, i=0, set%rows - 1)]
      end subroutine draw_times
   end subroutine new_set

   function names_of(case) result(names)
      integer, intent(in) :: case
      character(len=12), allocatable :: names(:)
      character(len=12), parameter :: start(6) = [character(len=12) :: 'position1', 'position2', 'position3', 'velocity1', &
         'velocity2', 'velocity3']

      select case (case)
      case (1)
         names = [character(len=12) :: 'length', 'gravity', start]
      case (2)
         names = [character(len=12) :: 'length', 'latitude', start]
      case (3)
         names = [character(len=12) :: 'length', 'gravity', start, 'linear']
      case (4)
         names = [character(len=12) :: 'gravity', 'linear']
      case (5)
         names = [character(len=12) :: 'length', start, 'offset1', 'offset2', 'scale', 'angle']
      end select
   end function names_of

   !> What a fit reports, at theta.
   function report(set, theta) result(values)
      type(set_type), intent(in) :: set
      real(wp), intent(in) :: theta(:)
      real(wp), allocatable :: values(:)

      select case (set%case)
      case (1)
         values = [theta(1:2), start_of(theta)]
      case (2)
         values = [theta(1), theta(7), start_of(theta)]
      case (3)
         values = [theta(1:2), start_of(theta), theta(7)]
      case (4)
         values = [theta(2), theta(7)]
      case (5)
         values = [theta(1), start_of(theta), theta(9:10), theta(7:8)]
      end select
   end function report

   !> Position and velocity at t = 0.
   function start_of(theta) result(start)
      real(wp), intent(in) :: theta(:)
      real(wp) :: start(6)

      associate (l => theta(1), c => cos(theta(3)), s => sin(theta(3)), cp => cos(theta(4)), sp => sin(theta(4)))
         start(1:3) = l*[s*cp, s*sp, -c]
         start(4:6) = theta(5)*[c*cp, c*sp, s] + theta(6)*[-sp, cp, 0.0_wp]
      end associate
   end function start_of

   !> Everything measured, without noise: row by row.
   function predict(set, theta) result(values)
      type(set_type), intent(in) :: set
      real(wp), intent(in) :: theta(:)
      real(wp), allocatable :: values(:)
      type(pendulum_type) :: pendulum
      real(wp), allocatable :: states(:, :)
      real(wp) :: c, s
      integer :: i

      pendulum%length = theta(1)
      pendulum%gravity = theta(2)
      if (set%case == 2) pendulum%turn = earth_rate*[0.0_wp, cos(theta(7)*degree), sin(theta(7)*degree)]
      if (set%case == 3 .or. set%case == 4) pendulum%linear = theta(7)
      if (set%case == 4) then
         allocate (values(set%rows))
         call crossings(pendulum, start_of(theta), values)
         return
      end if
      allocate (states(6, set%rows))
      call states_at(pendulum, start_of(theta), set%times, states)
      if (set%case == 5) then
         c = theta(7)*cos(theta(8)*degree)
         s = theta(7)*sin(theta(8)*degree)
         values = [(c*(states(1, i) + theta(9)) - s*(states(3, i) + theta(10)), &
            s*(states(1, i) + theta(9)) + c*(states(3, i) + theta(10)), i=1, set%rows)]
      else
         values = reshape(states(:set%columns, :), [set%columns*set%rows])
      end if
   end function predict

   subroutine write_table(set)
      type(set_type), intent(inout) :: set
      character(len=*), parameter :: headers(5) = [character(len=14) :: 't,x,y,z', 't,x,y', 't,x,y,z', 'crossing_time', &
         't,u,v']
      character(len=:), allocatable :: row
      integer :: i, j, at

      allocate (character(len=(set%rows + 1)*26*(set%columns + 1)) :: set%table)
      set%table(:) = trim(headers(set%case))//new_line('a')
      at = len_trim(headers(set%case)) + 1
      do i = 1, set%rows
         row = ''
         if (size(set%times) > 0) row = number(set%times(i))//','
         do j = 1, set%columns
            row = row//number(set%measured((i - 1)*set%columns + j))
            if (j < set%columns) row = row//','
         end do
         set%table(at + 1:at + len(row) + 1) = row//new_line('a')
         at = at + len(row) + 1
      end do
      set%table = set%table(:at)
   end subroutine write_table

   !> By Box and Muller.
   real(wp) function normal(random)
      type(stream_type), intent(inout) :: random
      real(wp) :: radius

      radius = sqrt(-2*log(max(uniform(random, 0.0_wp, 1.0_wp), tiny(1.0_wp))))
      normal = radius*cos(2*pi*uniform(random, 0.0_wp, 1.0_wp))
   end function normal

   function number(value) result(text)
      real(wp), intent(in) :: value
      character(len=24) :: text

      write (text, '(es24.16e3)') value
      text = adjustl(text)
   end function number

end module synthetic_sets
