!> The orbits on which others run too, and the closed form by GSL.
module kyvadlo_bench_peers
   use, intrinsic :: iso_fortran_env, only: real64
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl
#endif
   implicit none
   private
   public :: peer_type, peers, gsl_motion

   !> Orbits with l = g = 1; rivals.txt has their times.
   type :: peer_type
      character(len=10) :: name
      real(real64) :: upper, lower    !! z1, z2
   end type peer_type

   type(peer_type), parameter :: peers(4) = [ &
      peer_type('typical', 0.2_real64, -0.9_real64), peer_type('conical', -0.5_real64, -0.5001_real64), &
      peer_type('plane', 0.3_real64, -0.9999999_real64), peer_type('separatrix', 0.999999_real64, -0.99999999_real64)]

contains

   !> The motion from the lower turning point by GSL's sn, cn, dn and two integrals of the third kind a point, as a user
   !> of GSL would write it; l = g = 1.
   subroutine gsl_motion(upper, lower, period, time, x, y, z, has)
      real(real64), intent(in) :: upper, lower, period, time(:)
      real(real64), intent(out), dimension(size(time)) :: x, y, z
      logical, intent(out) :: has
#ifdef KYVADLO_WITH_GSL
      real(real64) :: outer, rate, momentum, m, k, whole(2), n(2), t, turns, sn, cn, dn, amplitude, phi, across
      integer :: i, j, status

      has = .true.
      outer = -(upper*lower + 1)/(upper + lower)
      rate = sqrt((outer - lower)/2)
      momentum = sqrt(-2*(upper + lower)*(upper + outer)*(lower + outer))
      m = (upper - lower)/(outer - lower)
      k = sqrt(m)
      n = (upper - lower)/[1 - lower, -1 - lower]
      whole = [(fgsl_sf_ellint_pcomp(k, -n(j), fgsl_prec_double), j=1, 2)]
      do i = 1, size(time)
         turns = anint(time(i)/period)
         t = time(i) - turns*period
         status = fgsl_sf_elljac_e(rate*t, m, sn, cn, dn)
         amplitude = atan2(sn, cn)
         phi = 0
         do j = 1, 2
            phi = phi + (2*turns*whole(j) + fgsl_sf_ellint_p(amplitude, k, -n(j), fgsl_prec_double)) &
               /merge(1 - lower, 1 + lower, j == 1)
         end do
         phi = phi*momentum/(2*rate)
         z(i) = lower + (upper - lower)*sn**2
         across = sqrt((1 - z(i))*(1 + z(i)))
         x(i) = across*cos(phi)
         y(i) = across*sin(phi)
      end do
#else
      x = 0
      y = 0
      z = 0
      has = size(time) < 0 .and. upper + lower + period < 0
#endif
   end subroutine gsl_motion
end module kyvadlo_bench_peers
