!> Where a fit may begin, from nothing but the data: a periodogram tells the period, and for shapes of orbits on a grid
!> the closed form tells what the rest is, by linear least squares.
module kyvadlo_fit_guess
   use kyvadlo_fit_guess_direct, only: guess_by_plane, guess_by_polynomials
   use kyvadlo_fit_guess_list, only: guess_type, insert, start_of, view_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_orbit_real64, only: new_orbit_from_energy_above_top, new_orbit_from_heights, orbit_type
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: guess_type, view_type, find_guesses, frequency_peaks

   real(wp), parameter :: pi = acos(-1.0_wp)

contains

   !> The frequencies at which the columns have most power, floating mean taken out, descending [1/s].
   subroutine frequency_peaks(times, columns, peaks, count)
      real(wp), intent(in) :: times(:), columns(:, :)      !! (n), (n, m)
      real(wp), intent(out) :: peaks(:)
      integer, intent(out) :: count
      real(wp) :: span, step, best, previous, top, mean(size(columns, 2)), total
      real(wp), allocatable :: power(:), d(:, :), c(:), s(:), dc(:), ds(:)
      real(wp) :: cc, ss, cs, dcs, dss, det, turn, shortest
      integer :: i, j, k, n, m, crossings, most

      n = size(times)
      m = size(columns, 2)
      count = 0
      span = times(n) - times(1)
      allocate (d(n, m), c(n), s(n), dc(n), ds(n))
      most = 2
      total = 0
      do j = 1, m
         mean(j) = sum(columns(:, j))/n
         d(:, j) = columns(:, j) - mean(j)
         total = total + sum(d(:, j)**2)
         crossings = 0
         do i = 2, n
            if (d(i, j)*d(i - 1, j) < 0) crossings = crossings + 1
         end do
         if (sum(d(:, j)**2) > 0) most = max(most, crossings)
      end do
      if (.not. total > 0) return
      step = 0.15_wp/span
      ! At times evenly spaced, what is beyond Nyquist's frequency is the image of a line below it.
      shortest = minval(times(2:) - times(:n - 1), times(2:) > times(:n - 1))
      k = max(1, min(ceiling(1.6_wp*(most + 2)/(span*step)), floor(min(0.5_wp/(shortest*step), 1e6_wp))))
      allocate (power(k))
      c = cos(2*pi*step*(times - times(1)))
      s = sin(2*pi*step*(times - times(1)))
      dc = c
      ds = s
      do i = 1, k
         cc = sum(c**2) - sum(c)**2/n
         ss = sum(s**2) - sum(s)**2/n
         cs = sum(c*s) - sum(c)*sum(s)/n
         det = cc*ss - cs**2
         power(i) = 0
         if (det > 1e-6_wp*n**2) then
            do j = 1, m
               dcs = dot_product(c, d(:, j))
               dss = dot_product(s, d(:, j))
               power(i) = power(i) + (dcs**2*ss - 2*dcs*dss*cs + dss**2*cc)/det
            end do
         end if
         do j = 1, n
            turn = c(j)*dc(j) - s(j)*ds(j)
            s(j) = s(j)*dc(j) + c(j)*ds(j)
            c(j) = turn
         end do
      end do
      top = huge(top)
      do while (count < size(peaks))
         best = 0
         j = 0
         do i = 1, k
            previous = 0
            if (i > 1) previous = power(i - 1)
            if (power(i) < previous .or. power(i) >= top .or. power(i) <= best) cycle
            if (i < k) then
               if (power(i) < power(i + 1)) cycle
            end if
            best = power(i)
            j = i
         end do
         if (j == 0 .or. best < 0.03_wp*total) exit
         count = count + 1
         peaks(count) = j*step
         ! By a parabola through three values.
         if (j > 1 .and. j < k) then
            turn = power(j - 1) - 2*power(j) + power(j + 1)
            if (turn < 0) peaks(count) = (j + 0.5_wp*(power(j - 1) - power(j + 1))/turn)*step
         end if
         top = best
      end do
   end subroutine frequency_peaks

   !> Pendulums whose motion is like what was seen, the best first. Level 1: from cubics through x, y and z; 2: for
   !> shapes on a grid and the periods that are likely; 3: and others.
   subroutine find_guesses(view, level, guesses, count)
      type(view_type), intent(in) :: view
      integer, intent(in) :: level
      type(guess_type), intent(out) :: guesses(:)
      integer, intent(out) :: count
      !> Highest angles from the downward vertical, and lowest as part of what goes with them [degrees].
      real(wp), parameter :: highest(*) = [2.0_wp, 8.0_wp, 18.0_wp, 30.0_wp, 45.0_wp, 60.0_wp, 75.0_wp, 90.0_wp, &
         105.0_wp, &
         120.0_wp, 135.0_wp, 150.0_wp, 163.0_wp, 173.0_wp]
      real(wp), parameter :: parts(*) = [0.005_wp, 0.15_wp, 0.35_wp, 0.55_wp, 0.75_wp, 0.95_wp]
      real(wp), parameter :: nearby(*) = [1.0_wp, 0.94_wp, 1.06_wp]
      !> Energies over that of rest at the top, in g l: a swing in a plane may go over it.
      real(wp), parameter :: above(*) = [0.02_wp, 0.1_wp, 0.3_wp, 1.0_wp, 3.0_wp, 10.0_wp]
      real(wp) :: peaks(3), upper, lower, rates(30)
      real(wp), allocatable :: columns(:, :), position(:, :), at(:)
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      integer :: found, i, j, k, n, m, tries, phases, most_alike

      n = size(view%times)
      count = 0
      m = 0
      allocate (columns(n, 3), position(3, n), at(n))
      do j = 1, 3
         if (.not. view%has(j)) cycle
         m = m + 1
         columns(:, m) = view%seen(:, j)
      end do
      if (view%is_angle) then
         if (goes_over_the_top(view%seen(:, 1))) then
            columns(:, 2) = cos(columns(:, 1))
            columns(:, 1) = sin(columns(:, 1))
            m = 2
         end if
      end if
      call frequency_peaks(view%times, columns(:, :m), peaks, found)
      if (level == 1 .and. all(view%has)) call guess_by_polynomials(view, peaks(:found), guesses, count)
      if (level == 1) return
      phases = merge(12, 24, level == 2)
      most_alike = merge(5, 3, level == 2)
      if (view%is_line) call guess_by_plane(view, guesses, count)
      do i = 1, size(highest)
         do j = 1, size(parts)
            if (view%is_plane .and. j > 1) exit
            upper = -cos(highest(i)*pi/180)
            lower = -cos(parts(j)*min(highest(i), 180 - highest(i))*pi/180)
            call new_orbit_from_heights(orbit, 1.0_wp, 1.0_wp, upper, lower, error)
            if (.not. allocated(error)) call try_shape()
         end do
      end do
      do i = 1, merge(size(above), 0, view%is_plane)
         call new_orbit_from_energy_above_top(orbit, 1.0_wp, 1.0_wp, above(i), 0.0_wp, error)
         if (.not. allocated(error)) call try_shape()
      end do

   contains

      !> Its period follows from the lines of the periodogram, its phase is tried.
      subroutine try_shape()
         integer :: l, p

         tries = 0
         if (view%length > 0 .and. view%gravity > 0) then
            tries = 1
            rates(1) = sqrt(view%gravity/view%length)
         else
            do k = 1, merge(min(found, 2), found, level == 2)
               do l = 1, merge(1, size(nearby), level == 2)
                  ! The strongest line is that of the mean azimuth, or of the height.
                  rates(tries + 1) = 2*pi*peaks(k)*nearby(l)/(orbit%azimuth_per_period()/orbit%period())
                  rates(tries + 2) = peaks(k)*nearby(l)*orbit%period()
                  tries = tries + 2
               end do
            end do
         end if
         do k = 1, tries
            do p = 0, phases - 1
               at = rates(k)*(view%times - view%times(1)) + orbit%period()*p/phases
               call orbit%locate(at, position)
               call compare(view, orbit, rates(k), orbit%period()*p/phases - rates(k)*view%times(1), position, &
                  most_alike, guesses, count)
            end do
         end do
      end subroutine try_shape
   end subroutine find_guesses

   !> Whether an angle goes around, be it counted on or back by a turn.
   pure logical function goes_over_the_top(angle) result(does)
      real(wp), intent(in) :: angle(:)

      does = maxval(angle) - minval(angle) > 2*pi .or. any(abs(angle(2:) - angle(:size(angle) - 1)) > 1.2_wp*pi)
   end function goes_over_the_top

   !> Fits turn, size, camera and sense of rotation to the unit motion, and keeps the best.
   subroutine compare(view, orbit, rate, phase, position, most_alike, guesses, count)
      type(view_type), intent(in) :: view
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: rate, phase, position(:, :)
      integer, intent(in) :: most_alike                    !! Of one angle of the camera
      type(guess_type), intent(inout) :: guesses(:)
      integer, intent(inout) :: count
      integer :: n, turn, turns, sense, senses
      real(wp) :: size_known, misfit, total, across
      complex(wp) :: factor, shift
      complex(wp), allocatable :: w(:), d(:)
      type(guess_type) :: guess

      n = size(view%times)
      size_known = view%length
      if (.not. size_known > 0 .and. view%gravity > 0) size_known = view%gravity/rate**2
      allocate (w(n), d(n))
      if (view%is_camera) then
         d = cmplx(view%seen(:, 1), view%seen(:, 2), wp)
         turns = merge(1, 8, all(view%axes == [1, 2]))
         senses = merge(2, 1, turns == 1)
      else if (all(view%has(1:2))) then
         d = cmplx(view%seen(:, 1), view%seen(:, 2), wp)
         turns = 1
         senses = 2
      else
         turns = 12
         senses = 2
      end if
      if (view%is_plane) turns = 2
      if (view%is_tension) turns = 1
      if (view%is_tension) senses = 1
      do sense = 1, senses
         do turn = 0, turns - 1
            across = 2*pi*turn/turns
            ! What goes over the top does so in the y-z plane.
            if (view%is_plane .and. orbit%energy() > 1) across = across + pi/2
            shift = 0
            if (view%is_camera .or. all(view%has(1:2))) then
               ! w may be turned and stretched, d = factor w + shift.
               if (view%is_camera .and. turns > 1) then
                  w = seen_from(view, position, across)
                  call match(view, w, d, size_known, factor, shift)
                  call turn_best(view, position, d, factor, shift, across)
                  w = seen_from(view, position, across)
               else
                  w = cmplx(position(1, :), merge(1, -1, sense == 1)*position(2, :), wp)
                  if (view%is_azimuth) w = w/max(abs(w), tiny(1.0_wp))
                  if (view%is_line) w = exp(cmplx(0.0_wp, merge(2, -2, sense == 1)*orbit%apsidal_rate()* &
                     orbit%period()*anint((rate*view%times + phase)/orbit%period()), wp))
               end if
               call match(view, w, d, size_known, factor, shift)
               if (view%is_camera) then
                  misfit = sum(abs(d - factor*w - shift)**2)
                  total = sum(abs(d - sum(d)/n)**2)
                  guess%length = size_known
                  if (.not. size_known > 0) guess%length = abs(factor)/merge(view%scale, 1.0_wp, view%scale > 0)
                  guess%gravity = view%gravity
                  if (.not. view%gravity > 0) guess%gravity = guess%length*rate**2
                  guess%scale = abs(factor)/guess%length
                  guess%angle = atan2(aimag(factor), real(factor))
                  guess%offset = 0
                  if (view%is_offset_free .and. abs(factor) > 0) guess%offset = [real(shift/factor), &
                     aimag(shift/factor)] &
                     *guess%length
                  if (turns == 1) then
                     across = guess%angle - view%angle
                     guess%angle = view%angle
                  end if
               else if (view%is_azimuth .or. view%is_line) then
                  ! On a circle of radius 1: it tells no size.
                  across = atan2(aimag(factor), real(factor))
                  misfit = sum(abs(d - exp(cmplx(0.0_wp, across, wp))*w)**2)
                  total = 4*n
                  if (view%is_line) across = across/2
                  call take_size(view, rate, guess)
               else
                  guess%length = abs(factor)
                  if (view%has(3)) then
                     if (.not. size_known > 0) guess%length = (abs(dot_product(w, d)) + dot_product(position(3, :), &
                        view%seen(:, 3)))/n
                     if (.not. guess%length > 0) cycle
                     factor = factor/abs(factor)*guess%length
                  end if
                  if (.not. abs(factor) > 0) cycle
                  across = atan2(aimag(factor), real(factor))
                  misfit = sum(abs(d - factor*w)**2)
                  total = sum(abs(d)**2)
                  if (view%has(3)) then
                     misfit = misfit + sum((view%seen(:, 3) - guess%length*position(3, :))**2)
                     total = total + sum((view%seen(:, 3) - sum(view%seen(:, 3))/n)**2)
                  end if
                  guess%gravity = view%gravity
                  if (.not. view%gravity > 0) guess%gravity = guess%length*rate**2
               end if
            else if (view%is_tension) then
               call match_tension(view, orbit, rate, position, guess, misfit, total)
            else
               call match_columns(view, position, across, size_known, guess%length, misfit, total)
               guess%gravity = view%gravity
               if (.not. view%gravity > 0) guess%gravity = guess%length*rate**2
            end if
            if (.not. total > 0 .or. .not. guess%length > 0) cycle
            guess%misfit = misfit/total
            if (count == size(guesses)) then
               if (guess%misfit >= guesses(count)%misfit) cycle
            end if
            call start_of(orbit, phase, across, merge(1, -1, sense == 1), guess)
            if (view%is_camera .and. view%is_turn_free) then
               call insert(guesses, count, guess, most_alike)
            else
               call insert(guesses, count, guess)
            end if
         end do
      end do
   end subroutine compare

   !> What a camera that looks horizontally sees of a motion turned about the vertical: across, and i up.
   pure function seen_from(view, position, across) result(w)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: position(:, :), across
      complex(wp) :: w(size(position, 2))

      if (view%axes(1) == 1) then
         w = cmplx(cos(across)*position(1, :) - sin(across)*position(2, :), position(3, :), wp)
      else
         w = cmplx(sin(across)*position(1, :) + cos(across)*position(2, :), position(3, :), wp)
      end if
   end function seen_from

   !> The turn that fits best with a size, an angle and a shift: the least of a sum of squares along the unit circle of
   !> its cosine and sine.
   pure subroutine turn_best(view, position, d, factor, shift, across)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: position(:, :)
      complex(wp), intent(in) :: d(:), factor, shift
      real(wp), intent(inout) :: across
      integer, parameter :: tries = 72
      real(wp) :: seen(size(d)), by(size(d), 2), a(2, 2), b(2), e(2), squares, least, angle
      integer :: i

      if (.not. abs(factor) > 0) return
      seen = real((d - shift)/factor)
      by(:, 1) = position(view%axes(1), :)
      by(:, 2) = merge(-position(2, :), position(1, :), view%axes(1) == 1)
      a = matmul(transpose(by), by)
      b = matmul(seen, by)
      least = huge(least)
      do i = 1, tries
         angle = 2*pi*i/tries
         e = [cos(angle), sin(angle)]
         squares = dot_product(e, matmul(a, e)) - 2*dot_product(b, e)
         if (squares >= least) cycle
         least = squares
         across = angle
      end do
   end subroutine turn_best

   !> Length and gravity of a rate [1/s] where the data tell no more.
   subroutine take_size(view, rate, guess)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: rate
      type(guess_type), intent(inout) :: guess

      guess%length = view%length
      guess%gravity = view%gravity
      if (.not. (view%length > 0 .or. view%gravity > 0)) guess%gravity = view%usual_gravity
      if (.not. guess%length > 0) guess%length = guess%gravity/rate**2
      if (.not. guess%gravity > 0) guess%gravity = guess%length*rate**2
   end subroutine take_size

   !> The tension per mass, g (2 e - 3 z/l): it tells the gravity where length and gravity are both unknown.
   subroutine match_tension(view, orbit, rate, position, guess, misfit, total)
      type(view_type), intent(in) :: view
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: rate, position(:, :)
      type(guess_type), intent(inout) :: guess
      real(wp), intent(out) :: misfit, total
      real(wp) :: model(size(position, 2))

      model = 2*orbit%energy() - 3*position(3, :)
      call take_size(view, rate, guess)
      if (.not. (view%length > 0 .or. view%gravity > 0)) then
         guess%gravity = max(dot_product(model, view%seen(:, 1))/sum(model**2), tiny(1.0_wp))
         guess%length = guess%gravity/rate**2
      end if
      misfit = sum((view%seen(:, 1) - guess%gravity*model)**2)
      total = sum((view%seen(:, 1) - sum(view%seen(:, 1))/size(model))**2)
   end subroutine match_tension

   !> factor and shift of d = factor w + shift, as far as they are free.
   subroutine match(view, w, d, size_known, factor, shift)
      type(view_type), intent(in) :: view
      complex(wp), intent(in) :: w(:), d(:)
      real(wp), intent(in) :: size_known
      complex(wp), intent(out) :: factor, shift
      complex(wp) :: w0, d0
      integer :: n

      n = size(w)
      w0 = 0
      d0 = 0
      if (view%is_camera .and. view%is_offset_free) then
         w0 = sum(w)/n
         d0 = sum(d)/n
      else if (view%is_camera) then
         d0 = view%scale*exp(cmplx(0.0_wp, view%angle, wp))*cmplx(view%offset(1), view%offset(2), wp)
      end if
      factor = dot_product(w - w0, d - d0)/max(sum(abs(w - w0)**2), tiny(1.0_wp))
      if (view%is_camera .and. .not. view%is_turn_free .and. any(view%axes /= [1, 2])) &
         factor = real(factor*exp(cmplx(0.0_wp, -view%angle, wp)))*exp(cmplx(0.0_wp, view%angle, wp))
      if (size_known > 0 .and. abs(factor) > 0) then
         if (.not. view%is_camera) factor = factor/abs(factor)*size_known
         if (view%is_camera .and. view%scale > 0) factor = factor/abs(factor)*size_known*view%scale
      end if
      shift = d0 - factor*w0
   end subroutine match

   !> Single columns for a given turn; the size by least squares if it is not known. An angle has none.
   subroutine match_columns(view, position, across, size_known, length, misfit, total)
      type(view_type), intent(in) :: view
      real(wp), intent(in) :: position(:, :), across, size_known
      real(wp), intent(out) :: length, misfit, total
      real(wp) :: model(size(position, 2), 3), up, down
      integer :: j, n

      n = size(position, 2)
      model(:, 1) = cos(across)*position(1, :) - sin(across)*position(2, :)
      model(:, 2) = sin(across)*position(1, :) + cos(across)*position(2, :)
      model(:, 3) = position(3, :)
      if (view%is_angle) then
         model(:, 1) = atan2(model(:, 1), -model(:, 3))
         length = 1
         if (size_known > 0) length = size_known
      else
         up = 0
         down = 0
         do j = 1, 3
            if (.not. view%has(j)) cycle
            up = up + dot_product(model(:, j), view%seen(:, j))
            down = down + sum(model(:, j)**2)
         end do
         length = up/max(down, tiny(down))
         if (size_known > 0) length = size_known
      end if
      misfit = 0
      total = 0
      do j = 1, 3
         if (.not. view%has(j)) cycle
         total = total + sum((view%seen(:, j) - sum(view%seen(:, j))/n)**2)
         if (view%is_angle) then
            misfit = misfit + sum((modulo(view%seen(:, j) - model(:, j) + pi, 2*pi) - pi)**2)
         else
            misfit = misfit + sum((view%seen(:, j) - length*model(:, j))**2)
         end if
      end do
   end subroutine match_columns

end module kyvadlo_fit_guess
