!> Guesses that need no search: from cubics through short pieces of x, y, z; from how fast the plane of a swing turns.
module kyvadlo_fit_guess_direct
   use kyvadlo_fit_guess_list, only: guess_type, insert, start_of, view_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: new_orbit_from_heights, orbit_type
   use kyvadlo_state_real64, only: new_orbit_from_state
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: guess_by_plane, guess_by_polynomials

   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   !> Of the azimuth of the line of apsides: where it is at t = 0, and ellipses that turn as fast. How large they are
   !> it hardly tells, and where the bob is not at all: there are some of each size.
   subroutine guess_by_plane(view, guesses, count)
      type(view_type), intent(in) :: view
      type(guess_type), intent(inout) :: guesses(:)
      integer, intent(inout) :: count
      real(wp), parameter :: sizes(*) = [5.0_wp, 20.0_wp, 50.0_wp] !! Degrees
      real(wp), parameter :: parts(*) = [0.0_wp, 0.02_wp, 0.05_wp, 0.1_wp, 0.2_wp, 0.3_wp, 0.45_wp, 0.6_wp, 0.8_wp]
      real(wp) :: line(size(view%times)), rate, at_start, middle, turn
      type(guess_type) :: guess
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer :: i, j, n

      n = size(view%times)
      line = atan2(view%seen(:, 2), view%seen(:, 1))/2
      do i = 2, n
         line(i) = line(i) - pi*anint((line(i) - line(i - 1))/pi)
      end do
      middle = sum(view%times)/n
      rate = dot_product(view%times - middle, line)/sum((view%times - middle)**2)
      at_start = sum(line)/n - rate*middle
      guess%length = merge(view%length, 1.0_wp, view%length > 0)
      guess%gravity = merge(view%gravity, view%usual_gravity, view%gravity > 0)
      do i = 1, size(sizes)
         do j = 1, size(parts)
            call new_orbit_from_heights(orbit, 1.0_wp, 1.0_wp, -cos(sizes(i)*pi/180), &
               -cos(parts(j)*sizes(i)*pi/180), error)
            if (allocated(error)) cycle
            turn = orbit%apsidal_rate()*sqrt(guess%gravity/guess%length)
            turn = sign(turn, rate)
            guess%misfit = sum(sin(line - at_start - turn*view%times + (turn - rate)*middle)**2)/n
            call start_of(orbit, 0.0_wp, at_start + (rate - turn)*middle, merge(1, -1, rate > 0), guess)
            call insert(guesses, count, guess)
         end do
      end do
   end subroutine guess_by_plane

   !> Of x, y, z seen often enough: the length from the distances, gravity and a state from cubics through short pieces.
   subroutine guess_by_polynomials(view, peaks, guesses, count)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: peaks(:)
      type(guess_type), intent(inout) :: guesses(:)
      integer, intent(inout) :: count
      type(guess_type) :: guess
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer :: first, last, n, j, k, pieces
      real(wp) :: length, t, a(4, 4), b(4, 3), power(4), up, down, pull(3), across(3), best, p(3), v(3), at
      real(wp) :: where_to(3), speed(3), when

      n = size(view%times)
      if (size(peaks) == 0) return
      length = sum(norm2(view%seen, dim=2))/n
      if (view%length > 0) length = view%length
      up = 0
      down = 0
      best = -1
      pieces = 0
      first = 1
      do while (first <= n - 5)
         last = first
         do while (last < n)
            if (view%times(last + 1) - view%times(first) > 0.22_wp/peaks(1)) exit
            last = last + 1
         end do
         if (last - first >= 5) then
            t = (view%times(first) + view%times(last))/2
            a = 0
            b = 0
            do k = first, last
               power = ((view%times(k) - t)*peaks(1))**[0, 1, 2, 3]
               do j = 1, 4
                  a(:, j) = a(:, j) + power*power(j)
               end do
               do j = 1, 3
                  b(:, j) = b(:, j) + power*view%seen(k, j)
               end do
            end do
            call solve(a, b)
            p = b(1, :)
            v = b(2, :)*peaks(1)
            pull = 2*b(3, :)*peaks(1)**2
            across = [0.0_wp, 0.0_wp, 1.0_wp] - p(3)/dot_product(p, p)*p
            up = up - dot_product(pull, across)
            down = down + dot_product(across, across)
            pieces = pieces + 1
            if (pieces == 1) then
               where_to = p
               speed = v
               when = t
            end if
         end if
         first = max(last, first + 1)
      end do
      if (pieces == 0 .or. .not. down > 0) return
      at = up/down
      if (view%gravity > 0) at = view%gravity
      if (.not. at > 0) return
      guess%length = length
      guess%gravity = at
      where_to = where_to/norm2(where_to)*length
      speed = speed - dot_product(speed, where_to)/length**2*where_to
      call new_orbit_from_state(orbit, length, at, where_to, speed, error)
      if (allocated(error)) return
      call orbit%locate(-when, guess%position, guess%velocity)
      guess%misfit = 0
      do k = 1, n
         call orbit%locate(view%times(k) - when, p)
         guess%misfit = guess%misfit + sum((p - view%seen(k, :))**2)
      end do
      up = 0
      do j = 1, 3
         up = up + sum((view%seen(:, j) - sum(view%seen(:, j))/n)**2)
      end do
      guess%misfit = guess%misfit/up
      call insert(guesses, count, guess)
   end subroutine guess_by_polynomials

   !> Gauss's elimination of a small positive definite matrix.
   pure subroutine solve(a, b)
      real(wp), intent(inout) :: a(:, :), b(:, :)
      integer :: i, j

      do i = 1, size(a, 1)
         if (.not. abs(a(i, i)) > 0) return
         do j = 1, size(a, 1)
            if (j == i) cycle
            b(j, :) = b(j, :) - a(j, i)/a(i, i)*b(i, :)
            a(j, :) = a(j, :) - a(j, i)/a(i, i)*a(i, :)
         end do
      end do
      do i = 1, size(a, 1)
         b(i, :) = b(i, :)/a(i, i)
      end do
   end subroutine solve

end module kyvadlo_fit_guess_direct
