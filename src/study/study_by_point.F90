!> Places point by point from other formulas than the theta series: sn, cn, dn and the polar-angle series; elliptic
!> integrals of the third kind; the textbook's small oscillations.
module kyvadlo_study_by_point
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
   use kyvadlo_batch_constants, only: form_scalar
   use kyvadlo_carlson_rf_real64, only: carlson_rf
   use kyvadlo_carlson_rj_real64, only: carlson_rj
   use kyvadlo_complete_pi_real64, only: elliptic_pic
   use kyvadlo_incomplete_pi_real64, only: elliptic_piincc
   use kyvadlo_jacobi_real64, only: jacobi_evaluate, jacobi_functionsc, jacobi_type, new_jacobic
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_status, only: error_type
   use kyvadlo_pairs, only: pair, value, operator(*), operator(-)
   use kyvadlo_study_orbits, only: study_orbit_type, n_times
   use kyvadlo_study_places, only: places_type, ask, farthest
   use kyvadlo_study_record, only: study_type
   use kyvadlo_study_set_up, only: set_up_orbit
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl, only: fgsl_prec_double, fgsl_sf_elljac_e, fgsl_sf_ellint_p, fgsl_sf_ellint_pcomp
#endif
   implicit none
   private
   public :: ask_jacobi_series, ask_carlson_point, ask_small_angle

   integer, parameter :: wp = real64
   real(wp), parameter :: pi = acos(-1.0_wp)

   !> What all of them have in common.
   type, abstract, extends(places_type) :: point_type
      real(wp), dimension(n_times) :: x = 0, y = 0, z = 0
   contains
      procedure :: error => point_error
   end type point_type

   !> The paper's own way, (15) and (35).
   type, extends(point_type) :: jacobi_series_type
      integer :: terms = 0               !! Arctangents in either sum of the azimuth at most
   contains
      procedure :: pass => jacobi_series_pass
   end type jacobi_series_type

   !> Whose integrals of the third kind.
   integer, parameter :: by_carlson = 1, by_legendre = 2, by_gsl = 3
   character(len=*), parameter :: integral_names(3) = [character(len=8) :: 'carlson', 'legendre', 'gsl']

   !> n and 1 - n, of which either may hold digits that the other has lost.
   type :: characteristic_type
      real(wp) :: value = 0, complement = 1
   end type characteristic_type

   type, extends(point_type) :: integrals_type
      integer :: by = by_carlson
   contains
      procedure :: pass => integrals_pass
   end type integrals_type

   !> Ellipse; its period corrected for the amplitude; turning with Airy's precession besides.
   integer, parameter :: harmonic = 1, amplitude = 2, airy = 3
   character(len=*), parameter :: formula_names(3) = [character(len=9) :: 'harmonic', 'amplitude', 'airy']

   type, extends(point_type) :: small_angle_type
      integer :: formula = harmonic
   contains
      procedure :: pass => small_angle_pass
   end type small_angle_type

contains

   !> The height by sn, cn, dn and the azimuth by the polar-angle series with 1, 2, ... arctangents.
   subroutine ask_jacobi_series(study, orbit, span)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span
      type(jacobi_series_type), allocatable :: work
      character(len=12) :: setting
      integer :: most

      allocate (work)
      most = max(orbit%orbit%polar_angle_terms(), 1)
      do
         work%terms = work%terms + merge(max(most - 1, 1), 1, study%quick .and. work%terms == 1)
         write (setting, '(i0,a)') work%terms, merge(' term ', ' terms', work%terms == 1)
         call ask(study, work, orbit, span, 'jacobi_series', trim(setting), 'real64')
         if (work%terms >= most) exit
      end do
   end subroutine ask_jacobi_series

   !> Two integrals of the third kind a point: by R_F and R_J, by Pi, by GSL's Pi.
   subroutine ask_carlson_point(study, orbit, span)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span
      type(integrals_type), allocatable :: work

      allocate (work)
      do while (work%by <= by_gsl)
#ifndef KYVADLO_WITH_GSL
         if (work%by == by_gsl) exit
#endif
         call ask(study, work, orbit, span, 'carlson_point', trim(integral_names(work%by)), 'real64')
         work%by = work%by + 1
      end do
   end subroutine ask_carlson_point

   subroutine ask_small_angle(study, orbit, span)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span
      type(small_angle_type), allocatable :: work
      integer :: formula

      allocate (work)
      do formula = harmonic, airy
         work%formula = formula
         call ask(study, work, orbit, span, 'small_angle', trim(formula_names(formula)), 'real64')
      end do
   end subroutine ask_small_angle

   !> Time since the passage of a turning point that comes after `turns` periods, without the rounding of T.
   pure real(wp) function since(orbit, time, turns)
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: time, turns

      since = value(pair(time) - orbit%period_pair*turns)
   end function since

   !> l + z = l + z2 + (z1 - z2) cd**2 w, l - z = l - z1 + (z1 - z2) k'**2 sd**2 w.
   subroutine jacobi_series_pass(work)
      class(jacobi_series_type), intent(inout) :: work
      type(error_type), allocatable :: error
      type(orbit_type) :: orbit
      type(jacobi_type) :: jacobi
      real(wp) :: rate, sn, cn, dn, am, up, down, phi
      integer :: i

      call set_up_orbit(work%start, orbit, error)
      work%has_failed = allocated(error)
      orbit%terms = min(orbit%terms, work%terms)
      orbit%kernel%form = form_scalar   ! It knows the whole azimuth.
      jacobi = new_jacobic(orbit%complementary_parameter)
      rate = orbit%phase_rate()
      associate (turning => orbit%turning)
         do i = 1, n_times
            call jacobi_evaluate(jacobi, rate*since(orbit, work%times(i), &
               anint(work%times(i)/orbit%period_pair%high)), sn, cn, dn, am)
            up = turning%lower_rise + turning%swing*(cn/dn)**2
            down = turning%upper_gap + turning%swing*orbit%complementary_parameter*(sn/dn)**2
            phi = orbit%azimuth(work%times(i))
            call set_place(work, i, up, down, phi)
         end do
      end associate
      work%evaluations = n_times*work%terms
      work%sink = work%sink + sum(work%x) + sum(work%y) + sum(work%z)
   end subroutine jacobi_series_pass

   !> From the nearest lowest point, dphi = c2/2l (1/(l - z) + 1/(l + z)) dt with z = z2 + (z1 - z2) sn**2 w. In a plane
   !> through the vertical c2 and l + z2 vanish: the integrals have no value, but their limit is half a turn at the
   !> lowest point.
   subroutine integrals_pass(work)
      class(integrals_type), intent(inout) :: work
      type(error_type), allocatable :: error
      type(orbit_type) :: orbit
      type(characteristic_type) :: n(2)
      real(wp) :: rate, factor(2), half, turns, sn, cn, dn, am, phi
      logical :: is_plane
      integer :: i

      call set_up_orbit(work%start, orbit, error)
      work%has_failed = allocated(error)
      rate = orbit%phase_rate()
      associate (turning => orbit%turning, m => orbit%parameter, mc => orbit%complementary_parameter)
         is_plane = .not. turning%lower_rise > 0
         if (.not. is_plane) then
            n = [characteristic_type(turning%swing/turning%lower_gap, turning%upper_gap/turning%lower_gap), &
               characteristic_type(-turning%swing/turning%lower_rise, turning%upper_rise/turning%lower_rise)]
            factor = orbit%momentum()/(2*orbit%length*rate)/[turning%lower_gap, turning%lower_rise]
            half = factor(1)*complete_third(work%by, n(1), m, mc) + factor(2)*complete_third(work%by, n(2), m, mc)
         end if
         do i = 1, n_times
            turns = anint(work%times(i)/orbit%period_pair%high - 0.5_wp) + 0.5_wp
            call jacobi_by(work%by, rate*since(orbit, work%times(i), turns), m, mc, sn, cn, dn, am)
            if (is_plane) then
               phi = turns*pi + sign(pi/2, sn)
            else
               phi = 2*turns*half + factor(1)*third(work%by, n(1), am, m, mc, sn, cn, dn) &
                  + factor(2)*third(work%by, n(2), am, m, mc, sn, cn, dn)
            end if
            call set_place(work, i, turning%lower_rise + turning%swing*sn**2, turning%upper_gap + turning%swing*cn**2, &
               phi)
         end do
      end associate
      work%evaluations = 2*n_times
      work%sink = work%sink + sum(work%x) + sum(work%y) + sum(work%z)
   end subroutine integrals_pass

   !> sn, cn, dn and the amplitude in (-pi, pi].
   subroutine jacobi_by(by, argument, m, mc, sn, cn, dn, am)
      integer, intent(in) :: by
      real(wp), intent(in) :: argument, m, mc
      real(wp), intent(out) :: sn, cn, dn, am
#ifdef KYVADLO_WITH_GSL
      integer :: status

      if (by == by_gsl) then
         status = fgsl_sf_elljac_e(argument, m, sn, cn, dn)
         if (status /= 0) sn = huge(sn)
         am = atan2(sn, cn)
         return
      end if
#endif
      call jacobi_functionsc(argument, mc, sn, cn, dn, am)
      if (by < 0) sn = huge(sn)*m ! Every argument is referred to in either build.
   end subroutine jacobi_by

   !> Pi(n; am, m) of an amplitude up to pi/2; R_F and R_J by DLMF 19.25.14. Carlson's integrals take complements of m
   !> and n as they are, Legendre's that of m, GSL's none.
   real(wp) function third(by, n, am, m, mc, sn, cn, dn)
      integer, intent(in) :: by
      type(characteristic_type), intent(in) :: n
      real(wp), intent(in) :: am, m, mc, sn, cn, dn

      select case (by)
      case (by_carlson)
         third = sn*(carlson_rf(cn**2, dn**2, 1.0_wp) &
            + n%value*sn**2/3*carlson_rj(cn**2, dn**2, 1.0_wp, cn**2 + n%complement*sn**2))
#ifdef KYVADLO_WITH_GSL
      case (by_gsl)
         third = fgsl_sf_ellint_p(am, sqrt(m), -n%value, fgsl_prec_double)
#endif
      case default
         third = elliptic_piincc(n%value, am, mc)
         if (by < 0) third = m
      end select
   end function third

   !> Pi(n, m); by DLMF 19.25.2.
   real(wp) function complete_third(by, n, m, mc)
      integer, intent(in) :: by
      type(characteristic_type), intent(in) :: n
      real(wp), intent(in) :: m, mc

      select case (by)
      case (by_carlson)
         complete_third = carlson_rf(0.0_wp, mc, 1.0_wp) + n%value/3*carlson_rj(0.0_wp, mc, 1.0_wp, n%complement)
#ifdef KYVADLO_WITH_GSL
      case (by_gsl)
         complete_third = fgsl_sf_ellint_pcomp(sqrt(m), -n%value, fgsl_prec_double)
#endif
      case default
         complete_third = elliptic_pic(n%value, mc)
         if (by < 0) complete_third = m
      end select
   end function complete_third

   !> Harmonic with rate sqrt(g/l); with the rate and the precession of PAPER's section 8: period of the ellipse times
   !> 1 + (a**2 + b**2)/16 l**2, and 3/8 a b/l**2 of the rate (Airy 1851), a and b the radii of the turning circles.
   subroutine small_angle_pass(work)
      class(small_angle_type), intent(inout) :: work
      real(wp) :: a, b, rate, turn, angle, along, across, l, up(2), down(2)
      integer :: i

      l = work%start%length
      up = [work%start%first, work%start%second]
      if (.not. work%start%by_rises) up(1) = 2*l - up(1)
      down = 2*l - up
      if (.not. work%start%by_rises) down(1) = work%start%first
      a = sqrt(up(1)*down(1))
      b = sqrt(up(2)*down(2))
      rate = sqrt(work%start%gravity/l)
      turn = 0
      if (work%formula == airy) turn = 0.375_wp*a*b/l**2*rate
      if (work%formula >= amplitude) rate = rate/(1 + (a**2 + b**2)/(16*l**2))
      do i = 1, n_times
         along = a*cos(rate*work%times(i))
         across = b*sin(rate*work%times(i))
         work%z(i) = -sqrt(max(l**2 - along**2 - across**2, 0.0_wp))
         angle = turn*work%times(i)
         work%x(i) = along*cos(angle) - across*sin(angle)
         work%y(i) = along*sin(angle) + across*cos(angle)
      end do
      work%evaluations = n_times
      work%sink = work%sink + sum(work%x) + sum(work%y) + sum(work%z)
   end subroutine small_angle_pass

   !> The place at given distances from the lowest and the highest level.
   pure subroutine set_place(work, i, up, down, phi)
      class(point_type), intent(inout) :: work
      integer, intent(in) :: i
      real(wp), intent(in) :: up, down, phi
      real(wp) :: radius

      radius = sqrt(up)*sqrt(down)
      work%x(i) = radius*cos(phi)
      work%y(i) = radius*sin(phi)
      work%z(i) = merge(up - work%start%length, work%start%length - down, up < down)
   end subroutine set_place

   function point_error(work) result(error)
      class(point_type), intent(in) :: work
      real(real64) :: error

      error = farthest(work, real(work%x, real128), real(work%y, real128), real(work%z, real128))
   end function point_error

end module kyvadlo_study_by_point
