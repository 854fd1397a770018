!> Random starts of every regime of the pendulum, and what is promised there.
module hard_regimes
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_start_kinds, only: start_heights, start_gaps, start_rises, start_energy, start_above_top => start_energy_above_top, &
      start_state
   use random_numbers, only: stream_type, uniform, decades
   implicit none
   private
   public :: start_type, regimes, draw_start, title_of_regime
   public :: measures, of_constants, of_rate, of_position, of_velocity, of_late_position, of_late_velocity, of_azimuth, &
      of_own_size, of_laws, promises, promises_of
   public :: start_heights, start_gaps, start_rises, start_energy, start_above_top, start_state

   type :: start_type
      integer :: way = start_heights
      real(real64) :: length = 1, gravity = 1
      real(real64) :: a(6) = 0  !! The two numbers of the start, or position and velocity
   end type start_type

   !> What is measured.
   integer, parameter :: measures = 9
   integer, parameter :: of_constants = 1      !! T, k', K, lambda T [ulp]
   integer, parameter :: of_rate = 2           !! A [ulp]
   integer, parameter :: of_position = 3       !! x, y, z to 1000 T [eps l]
   integer, parameter :: of_velocity = 4       !! vx, vy, vz to 1000 T [eps v_max]
   integer, parameter :: of_late_position = 5  !! The same from 1000 T to 1e9 T
   integer, parameter :: of_late_velocity = 6
   integer, parameter :: of_azimuth = 7        !! phi to 1e9 T, beyond 8 eps and the condition in t [ulp]
   integer, parameter :: of_own_size = 8       !! Small swings: x, y, l+z [eps of their largest]; nearly plane: the small coordinate
   integer, parameter :: of_laws = 9           !! Energy, angular momentum, length [eps of their scales]

   !> What is promised of each. Of A 4 ulp of lambda T are promised, and 64 of itself where it is small.
   real(real64), parameter :: promises(measures) = [4.0_real64, 64.0_real64, 8.0_real64, 16.0_real64, 32.0_real64, 64.0_real64, &
      8.0_real64, 16.0_real64, 64.0_real64]

   character(len=16), parameter :: regimes(12) = [character(len=16) :: 'typical', 'near_conical', 'near_plane', 'near_upright', &
      'near_rotation', 'small', 'energetic', 'extreme_scales', 'quarter_periods', 'states', 'poles', 'rest']

contains

   !> From a state 16 eps l are promised instead of 8 (beyond what its rounding makes, which is nothing here: both kinds start from
   !> the same numbers).
   function promises_of(regime) result(promise)
      character(len=*), intent(in) :: regime
      real(real64) :: promise(measures)

      promise = promises
      if (regime == 'states') promise(of_position) = 16
   end function promises_of

   !> A start of the regime. `reach` says how far exponents go in the kind asked for: 1 in double precision.
   type(start_type) function draw_start(regime, stream, reach) result(s)
      character(len=*), intent(in) :: regime
      type(stream_type), intent(inout) :: stream
      real(real64), intent(in) :: reach
      real(real64) :: x, y, angle

      s%gravity = 9.80665_real64
      select case (regime)
      case ('typical', 'quarter_periods')
         s%length = uniform(stream, 0.1_real64, 70.0_real64)
         call between_turning_heights(s, stream)
      case ('near_conical')
         x = uniform(stream, 0.02_real64, 0.95_real64)
         y = decades(stream, -16.0_real64, -1.0_real64)
         s%way = start_rises
         s%a(1) = x*(1 + y)
         s%a(2) = x
         if (uniform(stream, 0.0_real64, 1.0_real64) < 0.5_real64) then
            s%way = start_heights
            s%a(:2) = [-x, -x - (1 - x)*y]
         end if
      case ('near_plane')
         s%way = start_gaps
         s%a(1) = uniform(stream, 0.1_real64, 1.9_real64)
         s%a(2) = min(s%a(1), 2 - s%a(1))*decades(stream, -290*reach, -1.0_real64)
      case ('near_upright')
         s%way = start_gaps
         s%a(1) = decades(stream, -290*reach, -1.0_real64)
         s%a(2) = s%a(1)*merge(uniform(stream, 0.0_real64, 1.0_real64), decades(stream, -5.0_real64, 0.0_real64), &
            uniform(stream, 0.0_real64, 1.0_real64) < 0.5_real64)
      case ('near_rotation')
         s%way = start_above_top
         s%a(1) = decades(stream, -60*reach, 2.0_real64)*s%gravity
         s%a(2) = decades(stream, -140*reach, -1.0_real64)
      case ('small')
         s%way = start_rises
         s%a(1) = decades(stream, -140*reach, -2.0_real64)
         s%a(2) = s%a(1)*merge(uniform(stream, 0.0_real64, 1.0_real64), decades(stream, -17.0_real64, 0.0_real64), &
            uniform(stream, 0.0_real64, 1.0_real64) < 0.5_real64)
      case ('energetic')
         s%way = start_energy
         x = decades(stream, 0.5_real64, 100*reach)
         s%a(1) = x*s%gravity
         s%a(2) = sqrt(2*s%a(1))*uniform(stream, 1e-3_real64, 0.999_real64)
      case ('extreme_scales')
         s%length = decades(stream, -100*reach, 100*reach)
         s%gravity = decades(stream, -100*reach, 100*reach)
         call between_turning_heights(s, stream)
      case ('states')
         ! Any place on the sphere and any velocity along it, as far as rounded numbers lie there
         s%way = start_state
         s%length = uniform(stream, 0.1_real64, 70.0_real64)
         x = uniform(stream, 0.0_real64, 3.14_real64)
         y = uniform(stream, -3.1_real64, 3.1_real64)
         angle = uniform(stream, -3.1_real64, 3.1_real64)
         s%a(:3) = s%length*[sin(x)*cos(y), sin(x)*sin(y), cos(x)]
         s%a(4:) = cos(angle)*[cos(x)*cos(y), cos(x)*sin(y), -sin(x)] + sin(angle)*[-sin(y), cos(y), 0.0_real64]
         s%a(4:) = s%a(4:)*sqrt(s%gravity*s%length)*decades(stream, -3.0_real64, 1.0_real64)
      case ('poles')
         ! Through the lowest point, or through the highest
         s%way = start_state
         angle = uniform(stream, -3.1_real64, 3.1_real64)
         x = uniform(stream, 0.01_real64, 8.0_real64)
         y = merge(-1, 1, uniform(stream, 0.0_real64, 1.0_real64) < 0.7_real64)
         s%a = [0.0_real64, 0.0_real64, y, x*cos(angle), x*sin(angle), 0.0_real64]
      case ('rest')
         ! At rest below, at rest above, and on the way to the top for ever
         s%way = start_state
         x = uniform(stream, 0.0_real64, 3.0_real64)
         if (x < 1) s%a = [0, 0, -1, 0, 0, 0]
         if (1 <= x .and. x < 2) s%a = [0, 0, 1, 0, 0, 0]
         if (2 <= x) then
            s%way = start_energy
            s%gravity = decades(stream, -3.0_real64, 3.0_real64)
            s%a(:2) = [s%gravity, 0.0_real64]
         end if
      case default
         error stop 'draw_start: no such regime'
      end select
   end function draw_start

   subroutine between_turning_heights(s, stream)
      type(start_type), intent(inout) :: s
      type(stream_type), intent(inout) :: stream

      s%way = start_heights
      s%a(2) = -uniform(stream, 0.0_real64, 1.0_real64)
      s%a(1) = s%a(2) + uniform(stream, 0.0_real64, 1.0_real64)*2*abs(s%a(2))
      s%a(:2) = s%a(:2)*s%length
   end subroutine between_turning_heights

   function title_of_regime(regime) result(title)
      character(len=*), intent(in) :: regime
      character(len=:), allocatable :: title

      select case (regime)
      case ('near_conical')
         title = 'near conical'
      case ('near_plane')
         title = 'near plane'
      case ('near_upright')
         title = 'near upright'
      case ('near_rotation')
         title = 'near rotation'
      case ('extreme_scales')
         title = 'extreme scales'
      case ('quarter_periods')
         title = 'at T/4, T/2, T'
      case ('states')
         title = 'from a state'
      case ('poles')
         title = 'through a pole'
      case ('rest')
         title = 'rest, separatrix'
      case default
         title = trim(regime)
      end select
   end function title_of_regime

end module hard_regimes
