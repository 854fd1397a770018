!> An orbit for the double-double kernels from any start.
module kyvadlo_double_double_start
   use, intrinsic :: iso_fortran_env, only: cp => real64, real64
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real128
   use kyvadlo_orbit_real128, only: orbit_type_real128 => orbit_type, harmonics_type_real128 => harmonics_type
   use kyvadlo_pairs_real128, only: pair_type_real128 => pair_type, value_real128 => value
#endif
   use kyvadlo_batch_dispatch, only: vector_level
   use kyvadlo_double_double_angle, only: quarter_turns
   use kyvadlo_double_double_constants, only: wide_batch_type, wide_block_size
   use kyvadlo_double_double_dispatch, only: wide_rates_groups
   use kyvadlo_double_double_numbers, number_type => pair_type
   use kyvadlo_double_double_orbit
   use kyvadlo_gaps_double_double
   use kyvadlo_motion_kinds, only: motion_none, motion_conical, motion_separatrix, motion_rest, motion_upright
   use kyvadlo_start_kinds
   use kyvadlo_status, only: error_type
   use kyvadlo_three_part, only: pair_type, pi_pair, scaled, operator(+), operator(-), operator(*), operator(/)
   implicit none
   private
   public :: new_double_double

   interface new_double_double
      module procedure from_start
#ifndef KYVADLO_NO_REAL128
      module procedure from_real128
#endif
   end interface new_double_double

contains

   !> The constants of an orbit of any start, whose numbers count as they are, in binary. `form_scalar` where there is
   !> no closed form in polynomials, or where a gap is so small that its last digits leave the range.
   pure subroutine from_start(b, start, length, gravity, first, second, rests, phase, error)
      type(wide_batch_type), intent(out) :: b
      integer, intent(in) :: start                     !! One of the `start_*` constants
      real(real64), intent(in) :: length, gravity      !! l [m], g [m/s2]
      real(real64), intent(in) :: first(:), second(:)  !! What the start takes: (3) of a state, else (1)
      real(real64), intent(in) :: rests(2)             !! What of l and g their rounding took off [m, m/s2]
      real(real64), intent(in) :: phase(2)             !! Of a state: time since an upper turning point, nearly [s]
      type(error_type), allocatable, intent(out) :: error
      type(gaps_type) :: gaps
      type(orbit_type) :: orbit
      type(pair_type) :: below_upper, above_lower, placed(3), moving(3), momentum
      logical :: is_upper

      is_upper = .true.
      select case (start)
      case (start_heights)
         call gaps_from_heights(gaps, length, gravity, first(1), second(1), error, rests)
      case (start_gaps)
         call gaps_from_gaps(gaps, length, gravity, first(1), second(1), error, rests)
      case (start_rises)
         call gaps_from_rises(gaps, length, gravity, first(1), second(1), error, rests)
      case (start_energy)
         call gaps_from_energy(gaps, length, gravity, first(1), second(1), energy_is_total, error, rests)
      case (start_energy_above_top)
         call gaps_from_energy(gaps, length, gravity, first(1), second(1), energy_is_above_top, error, rests)
      case (start_energy_above_bottom)
         call gaps_from_energy(gaps, length, gravity, first(1), second(1), energy_is_above_bottom, error, rests)
      case (start_release)
         call gaps_from_release(gaps, length, gravity, first(1), second(1), is_upper, error, rests)
      case default
         call gaps_from_state(gaps, length, gravity, first, second, below_upper, above_lower, placed, moving, error, &
            rests)
      end select
      if (allocated(error)) return
      call set_up(orbit, gaps)
      if (orbit%motion == motion_none) return
      call set_kernel(b, orbit)
      select case (start)
      case (start_energy, start_energy_above_top, start_energy_above_bottom)
         if (second(1) < 0) b%mirror = -1
      case (start_release)
         if (merge(-second(1), second(1), first(1) < 0) < 0) b%mirror = -1
         if (.not. is_upper) then
            b%time = value(scaled(orbit%period_pair, -1))
            b%angle = value(orbit%advance/pi_pair + 1.0_cp)
         end if
         ! The other side: half a turn.
         if (first(1) < 0) b%angle = b%angle + (-2)*b%mirror
      case (start_state)
         momentum = placed(1)*moving(2) - placed(2)*moving(1)
         if (momentum%high < 0) b%mirror = -1
         call set_start(b, orbit, placed, moving, phase)
      end select
   end subroutine from_start

#ifndef KYVADLO_NO_REAL128
   !> The constants of an orbit in quadruple precision.
   pure subroutine from_real128(b, orbit)
      type(wide_batch_type), intent(out) :: b
      type(orbit_type_real128), intent(in) :: orbit
      type(orbit_type) :: copy
      real(real128), parameter :: quarters = 2/acos(-1.0_real128)

      if (any(orbit%motion == [motion_none, motion_separatrix, motion_rest, motion_upright])) return
      copy%motion = orbit%motion
      copy%is_dual = orbit%is_dual
      copy%is_rotation_like = orbit%is_rotation_like
      copy%gaps%length_power = orbit%gaps%length_power
      copy%gaps%length = in_three_parts(orbit%gaps%length)
      copy%gaps%upper_rise = in_three_parts(orbit%gaps%upper_rise)
      copy%gaps%upper_gap = in_three_parts(orbit%gaps%upper_gap)
      copy%period_pair = in_three_parts(orbit%period_pair)
      copy%advance = in_three_parts(orbit%advance)
      copy%rate_period = in_three_parts(orbit%rate_period)
      copy%stretch = in_two_parts(orbit%stretch)
      copy%turn_period = in_two_parts(orbit%turn_period)
      copy%bottom = harmonics_of(orbit%bottom)
      copy%top = harmonics_of(orbit%top)
      call set_kernel(b, copy)
      b%time = in_two_parts(value_real128(orbit%start_phase))
      b%angle = in_two_parts(orbit%start_azimuth*quarters)
      if (orbit%is_mirrored) b%mirror = -1
   end subroutine from_real128

   pure type(harmonics_type) function harmonics_of(series) result(copy)
      type(harmonics_type_real128), intent(in) :: series

      copy%f_is_odd = series%f_is_odd
      copy%p_cos = in_two_parts(series%p_cos)
      copy%p_sin = in_two_parts(series%p_sin)
      copy%f_cos = in_two_parts(series%f_cos)
      copy%f_sin = in_two_parts(series%f_sin)
   end function harmonics_of

   elemental type(number_type) function in_two_parts(x) result(p)
      real(real128), intent(in) :: x

      p%high = real(x, real64)
      p%low = real(x - p%high, real64)
   end function in_two_parts

   elemental type(pair_type) function in_three_parts(x) result(p)
      type(pair_type_real128), intent(in) :: x
      real(real128) :: rest

      p%high = real(x%high, real64)
      rest = (x%high - p%high) + x%low
      p%low = real(rest, real64)
      p%lowest = real(rest - p%low, real64)
   end function in_three_parts
#endif

   !> The phase and the azimuth of a state: the phase that double precision knows, corrected by Newton's method along
   !> the motion, and the turn that brings the standard orbit to the start, as `turn_start` of `kyvadlo_state`.
   pure subroutine set_start(b, orbit, placed, moving, phase)
      type(wide_batch_type), intent(inout) :: b
      type(orbit_type), intent(in) :: orbit
      type(pair_type), intent(in) :: placed(3), moving(3)
      real(cp), intent(in) :: phase(2)
      type(number_type) :: start(3), rate(3), pull, along, across, side
      real(cp), dimension(wide_block_size, 2) :: at_start, x, y, z, vx, vy, vz
      real(cp) :: square, rise, rise_rate, bend
      integer :: step
      integer, parameter :: steps = 2  ! From 2**-53: each doubles the digits

      associate (gaps => orbit%gaps)
         start = value(scaled(placed, 2*gaps%length_power))
         rate = value(scaled(moving, gaps%length_power + gaps%gravity_power))
         pull = value(scaled(gaps%gravity/gaps%length, 2*(gaps%gravity_power - gaps%length_power)))
      end associate
      b%time = number_type(phase(1), phase(2))
      at_start = 0
      do step = 0, steps
         call wide_rates_groups(vector_level(), b, 1, at_start, x, y, z, vx, vy, vz)
         if (step == steps .or. orbit%motion == motion_conical) exit
         ! Least squares of what is missing of height and rate, weighed by g/l; near the poles from the
         ! distance to the axis, which keeps its digits in small swings.
         side = wide(z)
         rise = to_real(start(3) - side)
         rise_rate = to_real(rate(3) - wide(vz))
         if (abs(side%high) > 0.49_cp*b%diameter%high) then
            rise = -to_real((start(1)*start(1) + start(2)*start(2)) - (wide(x)*wide(x) + wide(y)*wide(y))) &
               /(start(3)%high + side%high)
            rise_rate = -to_real((start(1)*rate(1) + start(2)*rate(2)) - (wide(x)*wide(vx) + wide(y)*wide(vy)))
            rise_rate = (rise_rate - rise*rate(3)%high)/side%high
         end if
         square = 4*(vx(1, 1)**2 + vy(1, 1)**2 + vz(1, 1)**2)/b%diameter%high**2
         bend = -square*z(1, 1) - pull%high*2*(x(1, 1)**2 + y(1, 1)**2)/b%diameter%high
         b%time = b%time + (pull%high*rise*vz(1, 1) + rise_rate*bend)/(pull%high*vz(1, 1)**2 + bend**2)
      end do
      along = pull*(start(1)*wide(x) + start(2)*wide(y)) + (rate(1)*wide(vx) + rate(2)*wide(vy))
      across = pull*(start(2)*wide(x) - start(1)*wide(y)) + (rate(2)*wide(vx) - rate(1)*wide(vy))
      b%angle = (-b%mirror)*quarter_turns(across, along)

   contains

      pure type(number_type) function wide(placed_there)
         real(cp), intent(in) :: placed_there(:, :)

         wide = number_type(placed_there(1, 1), placed_there(1, 2))
      end function wide
   end subroutine set_start

   pure real(cp) function to_real(p)
      type(number_type), intent(in) :: p

      to_real = p%high + p%low
   end function to_real
end module kyvadlo_double_double_start
