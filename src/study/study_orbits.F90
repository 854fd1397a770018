!> The orbits of a study: built-in ones with stored references, and those of scene files, held to our real128 path.
module kyvadlo_study_orbits
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   use kyvadlo_motion_kinds, only: motion_plane_rotation, motion_rest, motion_upright
   use kyvadlo_orbit, only: orbit_type, orbit_type_real128
   use kyvadlo_status, only: code_unsupported, error_type, fail
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_orbit, only: pendulum_orbit
   use kyvadlo_study_set_up, only: set_up_orbit, study_start_type
   implicit none
   private
   public :: study_orbit_type, built_in_orbits, orbit_from_pendulum, n_times, one_period, thousand_periods

   integer, parameter :: q = real128
   include 'study_reference.inc'
   include 'study_positions.inc'

   !> Second index of `times` and third of `positions`: within one period, and within the 1000th.
   integer, parameter :: one_period = 1, thousand_periods = 2

   type :: study_orbit_type
      character(len=64) :: name = ''
      type(study_start_type) :: start              !! What every method is given
      logical :: is_built_in = .true.              !! The references below are mpmath's; else our real128 path's
      type(orbit_type) :: orbit                    !! In double precision
      real(real128) :: period = 0                  !! T [s]
      real(real128) :: advance = 0                 !! lambda T
      real(real64) :: times(n_times, 2) = 0        !! [s] from an upper turning point, of 24 binary digits each
      real(real128) :: positions(3, n_times, 2) = 0 !! [m] azimuth 0 at t = 0
   end type study_orbit_type

contains

   !> A typical orbit, one near the conical, near the plane, near the upright, a small oscillation, an energetic one and
   !> a plane one; the references are stored.
   subroutine built_in_orbits(orbits)
      type(study_orbit_type), allocatable, intent(out) :: orbits(:)
      type(error_type), allocatable :: error
      integer :: i

      allocate (orbits(n_orbits))
      do i = 1, n_orbits
         orbits(i)%name = orbit_names(i)
         orbits(i)%start = study_start_type(1.0_real64, built_in_gravity, by_rises(i), first_of_start(i), &
            second_of_start(i))
         call set_up_orbit(orbits(i)%start, orbits(i)%orbit, error)
         orbits(i)%period = periods(i)
         orbits(i)%advance = advances(i)
         orbits(i)%times = moments(:, :, i)
      end do
      ! In the order of orbit_names.
      orbits(1)%positions = positions_typical
      orbits(2)%positions = positions_near_conical
      orbits(3)%positions = positions_near_plane
      orbits(4)%positions = positions_near_upright
      orbits(5)%positions = positions_small
      orbits(6)%positions = positions_energetic
      orbits(7)%positions = positions_plane
   end subroutine built_in_orbits

   !> The orbit of a pendulum of a scene, from an upper turning point on; its gaps are rounded to double precision
   !> first. An orbit without a period, or whose gaps do not determine it, is refused.
   subroutine orbit_from_pendulum(pendulum, study_orbit, error)
      type(pendulum_type), intent(in) :: pendulum
      type(study_orbit_type), intent(out) :: study_orbit
      type(error_type), allocatable, intent(out) :: error
      type(orbit_type_real128) :: exact
      integer, parameter :: periods_before(2) = [0, 999]
      integer :: i, span

      call pendulum_orbit(pendulum, exact, error)
      if (allocated(error)) return
      study_orbit%name = pendulum%name
      if (any(exact%motion == [motion_plane_rotation, motion_rest, motion_upright]) .or. &
         .not. ieee_is_finite(exact%period())) then
         call fail(error, code_unsupported, "study: the pendulum '"//trim(study_orbit%name)// &
            "' must swing: rest and motion over the top in a plane have nothing to compare")
         return
      end if
      study_orbit%is_built_in = .false.
      associate (start => study_orbit%start)
         start%length = real(exact%length, real64)
         start%gravity = real(exact%gravity, real64)
         start%by_rises = exact%turning%upper_rise < exact%length
         start%first = real(merge(exact%turning%upper_rise, exact%turning%upper_gap, start%by_rises), real64)
         start%second = real(exact%turning%lower_rise, real64)
         call set_up_orbit(start, study_orbit%orbit, error)
         if (.not. allocated(error)) call set_up_orbit(start, exact, error)
      end associate
      if (allocated(error)) return
      study_orbit%period = exact%period()
      study_orbit%advance = exact%apsidal_advance()
      do span = 1, 2
         do i = 1, n_times
            study_orbit%times(i, span) = &
               real(real(study_orbit%period*(periods_before(span) + real(i, real128)/n_times), real32), real64)
            call exact%locate(real(study_orbit%times(i, span), real128), study_orbit%positions(:, i, span))
         end do
      end do
   end subroutine orbit_from_pendulum

end module kyvadlo_study_orbits
