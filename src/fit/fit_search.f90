!> The search for the best minimum: guesses from the data or the scene, each followed over longer and longer parts of
!> the data, as a start that is right over three periods is right enough for eight.
module kyvadlo_fit_search
   use kyvadlo_fit_data
   use kyvadlo_fit_model, only: count_until, model_type, use_until
   use kyvadlo_fit_physics, only: physics_type
   use kyvadlo_fit_places, only: effect_guesses, guess_places, most_guesses, place_type
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_unknowns, only: form_logarithm, numbers_at, physics_at, place_at, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: minimise, minimum_type, polish
   use kyvadlo_scene_groups
   implicit none
   private
   public :: search, is_still, minimise_all

   !> Of more measurements than `many` about `thin` are taken first.
   integer, parameter :: many = 3000, thin = 1500

contains

   !> The best minimum of all the data. x is around `model%motion`.
   subroutine search(model, request, has_sigmas, x, best, others)
      type(model_type), intent(inout) :: model
      type(fit_request_type), intent(in) :: request
      logical, intent(in) :: has_sigmas                      !! Else they are yet to be estimated
      real(wp), allocatable, intent(out) :: x(:)
      type(minimum_type), intent(out) :: best
      real(wp), allocatable, intent(out) :: others(:, :, :)  !! Numbers of other minima that were found
      type(place_type) :: places(most_guesses + 1), kept(2*most_guesses)
      type(minimum_type) :: minimum
      real(wp) :: period, little, variation, hopeless
      integer :: count, i, j, k, n_kept, steps, done, begun
      logical :: is_timed

      allocate (x(size(model%motion%of)))
      little = merge(1e-3_wp, 1e-2_wp, has_sigmas)
      variation = variation_of(model)
      is_timed = all(is_event(model%all%column))
      n_kept = 0
      best%squares = huge(1.0_wp)
      do steps = 1, 4
         if (steps == 1) then
            ! The scene's own numbers first, where it has them all.
            if (.not. all(request%free%is_given .or. settings(request%free%setting)%group /= pendulum_group)) cycle
            if (.not. all(request%free%is_given .or. settings(request%free%setting)%group /= camera_group)) cycle
            count = 1
            places(1)%number = request%number
            call effect_guesses(request, places(1)%number)
         else
            call guess_places(model, request, steps - 1, places, count)
         end if
         done = 0
         do while (done < count)
            begun = done + 1
            do i = begun, count
               call follow(model, places(i), x, 1, minimum, period)
               places(i)%squares = minimum%squares
               done = i
               ! Of events the slowest swing is wanted, which is among them all.
               if (begun == 1 .and. looks_good(model, minimum%squares) .and. .not. is_timed) exit
            end do
            call rank(places(begun:done), is_timed)
            do i = begun, min(done, begun + 4)
               if (places(i)%squares < huge(1.0_wp)) call try(places(i))
               if (is_done()) exit
            end do
            if (is_done()) exit
         end do
         if (is_done()) exit
      end do
      if (n_kept > 0 .and. .not. (has_sigmas .and. is_done())) then
         ! The other sense of rotation, which a narrow ellipse hides at first.
         i = minloc(kept(:n_kept)%squares, 1)
         places(1) = kept(i)
         associate (p => places(1)%number(:, setting_place(pendulum_group, 'position')), &
               v => places(1)%number(:, setting_place(pendulum_group, 'velocity')))
            if (model%motion%is_velocity_free .and. norm2(p(:2)) > 0) then
               v(:2) = v(:2) - 2*(p(1)*v(2) - p(2)*v(1))/dot_product(p(:2), p(:2))*[-p(2), p(1)]
               call try(places(1))
            end if
         end associate
      end if
      if (n_kept == 0) then
         best = minimum_type()
         allocate (others(3, size(settings), 0))
         return
      end if
      i = minloc(kept(:n_kept)%squares, 1)
      model%motion%number = kept(i)%number
      call use_until(model, huge(1.0_wp), 1)
      call place_at(model%motion, x)
      j = 0
      allocate (others(3, size(settings), n_kept))
      do steps = 1, n_kept
         if (steps == i .or. kept(steps)%squares > 1.3_wp*kept(i)%squares + 20) cycle
         if (is_same(model%motion, kept(steps)%number, kept(i)%number)) cycle
         if (any([(is_same(model%motion, kept(steps)%number, others(:, :, k)), k=1, j)])) cycle
         j = j + 1
         others(:, :, j) = kept(steps)%number
      end do
      others = others(:, :, :j)

   contains

      subroutine try(place)
         type(place_type), intent(inout) :: place

         if (n_kept == size(kept)) return
         ! Nobody waits for what is many times worse than the best.
         hopeless = huge(hopeless)
         if (best%is_found) hopeless = 20*max(1.0_wp, best%squares/size(model%all))
         call follow(model, place, x, 2, minimum, period, hopeless)
         if (.not. minimum%squares < huge(1.0_wp)) return
         ! At rest nothing has a slope, and what moves is not explained.
         if (is_still(model, place%number) .and. .not. looks_good(model, minimum%squares)) return
         n_kept = n_kept + 1
         kept(n_kept) = place
         kept(n_kept)%squares = minimum%squares
         if (minimum%squares < best%squares) best = minimum
      end subroutine try

      !> As good as its sigmas say, to three deviations of chi2; or three starts led to it, and it explains the data but
      !> for little: else all starts are tried, as several may lead to the same alias.
      logical function is_done()
         real(wp) :: free
         integer :: k, alike

         alike = 0
         do k = 1, n_kept
            if (kept(k)%squares < best%squares*(1 + 1e-6_wp) + 1e-3_wp) alike = alike + 1
         end do
         free = max(1, size(model%all) - size(x))
         is_done = best%is_found .and. (best%squares < free + 3*sqrt(2*free) .or. (alike >= 3 .and. &
            (steps == 4 .or. best%squares < little*variation .or. .not. variation > 0)))
      end function is_done
   end subroutine search

   !> The sum of squares about the mean of each column, in sigmas; of events and periods, which have none, 0.
   pure real(wp) function variation_of(model) result(variation)
      type(model_type), intent(in) :: model
      real(wp) :: sums(columns), counts(columns)
      integer :: i

      variation = 0
      sums = 0
      counts = 0
      do i = 1, size(model%all)
         associate (one => model%all(i))
            if (is_event(one%column) .or. one%column == column_period) return
            sums(one%column) = sums(one%column) + one%value
            counts(one%column) = counts(one%column) + 1
         end associate
      end do
      sums = sums/max(counts, 1.0_wp)
      do i = 1, size(model%all)
         associate (one => model%all(i))
            variation = variation + ((one%value - sums(one%column))/one%sigma)**2
         end associate
      end do
   end function variation_of

   !> By squares. A swing twice as fast has all events of one too, and others that were missed: of what explains events
   !> about as well as the best the slowest comes first.
   subroutine rank(places, is_timed)
      type(place_type), intent(inout) :: places(:)
      logical, intent(in) :: is_timed
      type(place_type) :: swap
      real(wp), parameter :: about = 30
      real(wp) :: order(size(places)), key
      integer :: i, j

      order = places%squares
      do i = 1, size(places)
         if (is_timed .and. places(i)%squares < about*max(minval(places%squares), 1.0_wp)) order(i) = &
            -places(i)%number(1, setting_place(pendulum_group, 'length'))/places(i)%number(1, &
            setting_place(pendulum_group, 'gravity'))
      end do
      do i = 2, size(places)
         swap = places(i)
         key = order(i)
         j = i - 1
         do while (j >= 1)
            if (order(j) <= key) exit
            places(j + 1) = places(j)
            order(j + 1) = order(j)
            j = j - 1
         end do
         places(j + 1) = swap
         order(j + 1) = key
      end do
   end subroutine rank

   logical function is_same(motion, one, other)
      type(unknowns_type), intent(in) :: motion
      real(wp), intent(in) :: one(:, :), other(:, :)
      integer :: j, k

      is_same = .true.
      do j = 1, size(motion%of)
         k = motion%of(j)%setting
         if (any(abs(one(:, k) - other(:, k)) > 1e-3_wp*max(maxval(abs(one(:, k))), maxval(abs(other(:, k))), &
            1e-6_wp))) &
            is_same = .false.
      end do
   end function is_same

   !> Whether residuals are as large as their sigmas say. (Estimated ones are a hundredth of the motion for now.)
   logical function looks_good(model, squares)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: squares
      integer :: free

      free = max(1, size(model%used) - size(model%motion%of))
      looks_good = squares < free*(1.3_wp + 6/sqrt(real(free, wp)))
   end function looks_good

   !> Whether a start is free, and is found to be at rest at the lowest point.
   pure logical function is_still(model, number)
      type(model_type), intent(in) :: model
      real(wp), intent(in) :: number(:, :)
      real(wp), parameter :: little = 1e-6_wp            !! Of the length, and of the speed of a wide swing
      real(wp) :: length, speed

      is_still = .false.
      if (.not. model%motion%has_state) return
      length = number(1, setting_place(pendulum_group, 'length'))
      speed = sqrt(length*number(1, setting_place(pendulum_group, 'gravity')))
      is_still = norm2(number(:2, setting_place(pendulum_group, 'position'))) < little*length .and. &
         norm2(number(:, setting_place(pendulum_group, 'velocity'))) < little*speed
   end function is_still

   !> Follows a start: stage 1 over the first periods, stage 2 from there to all data.
   subroutine follow(model, place, x, stage, minimum, period, hopeless)
      type(model_type), intent(inout) :: model
      type(place_type), intent(inout) :: place
      real(wp), intent(inout) :: x(:)
      integer, intent(in) :: stage
      type(minimum_type), intent(out) :: minimum
      real(wp), intent(out) :: period
      real(wp), intent(in), optional :: hopeless            !! A sum of squares a residual with which it is given up
      real(wp) :: first, last, until, growth, whole
      logical :: has_leapt
      integer :: window
      integer, parameter :: most_windows = 40

      model%motion%number = place%number
      period = 2*acos(-1.0_wp)*sqrt(place%number(1, setting_place(pendulum_group, 'length'))/place%number(1, &
         setting_place(pendulum_group, 'gravity')))
      call first_window(model, size(x), stage, period, first, last, until, growth)
      ! Events count from the nearest ones, by whatever number of them the motion is late: never leap there.
      has_leapt = stage == 1 .or. growth < 2
      whole = part_of(last)
      do window = 1, most_windows
         if (stage == 2 .and. (until >= last .or. window == most_windows)) then
            call begin_last_window(model, x, whole)
            call finish(model, x, minimum)
            if (minimum%squares < huge(1.0_wp)) call keep(model, place, x)
            return
         end if
         call search_window(model, place, x, stage, until, part_of(until), minimum)
         if (present(hopeless)) then
            if (minimum%squares/max(1, size(model%used)) > hopeless) minimum%squares = huge(1.0_wp)
         end if
         if (.not. minimum%squares < huge(1.0_wp)) return
         call keep(model, place, x)
         if (stage == 1) return
         if (.not. has_leapt .and. looks_good(model, minimum%squares)) then
            ! A frequency that explains some periods to their sigmas is often right for all.
            has_leapt = .true.
            call begin_last_window(model, x, whole)
            call leap(model, x, minimum)
            if (minimum%is_found) then
               call keep(model, place, x)
               return
            end if
         end if
         until = first + growth*(until - first)
      end do

   contains

      !> Two and a half periods over the time until then, 1 at most.
      real(wp) function part_of(until) result(part)
         real(wp), intent(in) :: until

         part = 2.5_wp*period/max(until - first, 2.5_wp*period, tiny(period))
      end function part_of
   end subroutine follow

   !> Until when a search begins to look, and how its windows grow.
   subroutine first_window(model, unknowns, stage, period, first, last, until, growth)
      type(model_type), intent(in) :: model
      integer, intent(in) :: unknowns, stage
      real(wp), intent(in) :: period
      real(wp), intent(out) :: first, last                  !! Times
      real(wp), intent(out) :: until, growth
      real(wp) :: scale
      integer :: rows, timeless

      timeless = count_until(model, -huge(first))
      if (model%is_ascending) then
         last = model%all(size(model%all))%time
         first = model%all(min(timeless + 1, size(model%all)))%time
      else
         first = minval(model%all%time, model%all%time > -huge(first))
         last = maxval(model%all%time)
         if (.not. last > -huge(last)) first = last
      end if
      until = first + merge(6.0_wp, 2.5_wp, stage == 2)*period
      ! Enough measurements to say something.
      rows = 4*unknowns + 8
      growth = 2.7_wp
      if (all(is_event(model%all%column))) then
         ! An amplitude that decays changes the period: a few more events at a time.
         rows = 2*unknowns + 2
         growth = 1.5_wp
         until = first + 1.5_wp*period
      end if
      scale = 1
      do while (count_until(model, until) - timeless < rows .and. until < last)
         scale = 1.5_wp*scale
         until = first + 2.5_wp*scale*period
      end do
   end subroutine first_window

   !> The minimum of what was measured until a time, thinned out. Springs hold what it does not tell.
   subroutine search_window(model, place, x, stage, until, part, minimum)
      type(model_type), intent(inout) :: model
      type(place_type), intent(in) :: place
      real(wp), intent(inout) :: x(:)
      integer, intent(in) :: stage
      real(wp), intent(in) :: until
      real(wp), intent(in) :: part                          !! Some periods over the window
      type(minimum_type), intent(out) :: minimum
      logical :: was_exact
      real(wp) :: begun(size(x))
      integer, parameter :: most_rows = 300, few_steps = 4

      call use_until(model, until, max(1, count_until(model, until)/max(most_rows, 12*size(x))))
      ! What a coefficient does in a window is to be small where it begins.
      model%motion%number = place%number
      call place_at(model%motion, x, away=part)
      was_exact = model%motion%is_exact
      model%motion%is_exact = was_exact .or. stage == 1
      call set_tolerance(model, .false.)
      allocate (model%pull(size(x)), model%pull_to(size(x)))
      model%pull = merge(10.0_wp, 3.0_wp, model%motion%of%form == form_logarithm)
      model%pull_to = x
      model%residuals = model%residuals + size(x)
      begun = x
      if (stage == 2) call polish(model, x, minimum, few_steps, near=0.1_wp)
      if (.not. minimum%is_found) then
         x = begun
         call minimise(model, x, minimum, 1e-4_wp, 40)
      end if
      deallocate (model%pull, model%pull_to)
      model%motion%is_exact = was_exact
   end subroutine search_window

   subroutine begin_last_window(model, x, part)
      type(model_type), intent(inout) :: model
      real(wp), intent(inout) :: x(:)
      real(wp), intent(in) :: part                          !! Some periods over the window

      call use_until(model, huge(1.0_wp), 1)
      call place_at(model%motion, x, away=part)
      call set_tolerance(model, .true.)
   end subroutine begin_last_window

   !> The numbers at x become those of the place and of the model.
   subroutine keep(model, place, x)
      type(model_type), intent(inout) :: model
      type(place_type), intent(inout) :: place
      real(wp), intent(in) :: x(:)
      real(wp) :: rates(size(x))

      call numbers_of_start(model%motion, x, place%number, rates)
      model%motion%number = place%number
   end subroutine keep

   !> From a motion that is right for some periods to the minimum of all data by a few of Gauss's steps, first for some
   !> rows of them. It is found only where it explains the data.
   subroutine leap(model, x, minimum)
      type(model_type), intent(inout) :: model
      real(wp), intent(inout) :: x(:)
      type(minimum_type), intent(out) :: minimum
      integer, parameter :: few_steps = 4

      if (size(model%used) > many) then
         call use_until(model, huge(1.0_wp), size(model%used)/thin)
         call polish(model, x, minimum, few_steps, near=1.0_wp)
         if (minimum%is_found) minimum%is_found = looks_good(model, minimum%squares)
         call use_until(model, huge(1.0_wp), 1)
         if (.not. minimum%is_found) return
      end if
      call polish(model, x, minimum, few_steps)
      if (minimum%is_found) minimum%is_found = looks_good(model, minimum%squares)
   end subroutine leap

   !> To the minimum of all data. What shorter times and fewer rows tell is near: a few of Gauss's steps; else the
   !> trust region first.
   subroutine finish(model, x, minimum)
      type(model_type), intent(inout) :: model
      real(wp), intent(inout) :: x(:)
      type(minimum_type), intent(out) :: minimum
      real(wp) :: begun(size(x))
      integer, parameter :: few_steps = 4, most_steps = 30

      begun = x
      if (size(model%used) > many) then
         call use_until(model, huge(1.0_wp), size(model%used)/thin)
         call minimise(model, x, minimum, 1e-6_wp, 30)
         if (.not. minimum%squares < huge(1.0_wp)) x = begun
         call use_until(model, huge(1.0_wp), 1)
      end if
      call polish(model, x, minimum, few_steps)
      if (minimum%is_found) return
      if (.not. minimum%squares < huge(1.0_wp)) x = begun
      call minimise(model, x, minimum, 1e-7_wp, 100)
      if (minimum%is_found) call polish(model, x, minimum, most_steps)
   end subroutine finish

   !> Coordinates around where x is now.
   subroutine rebase(model, x)
      type(model_type), intent(inout) :: model
      real(wp), intent(inout) :: x(:)
      real(wp) :: number(3, size(settings)), rates(size(x))

      call numbers_of_start(model%motion, x, number, rates)
      model%motion%number = number
      call place_at(model%motion, x)
   end subroutine rebase

   subroutine numbers_of_start(motion, x, number, rates)
      type(unknowns_type), intent(in) :: motion
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: number(:, :), rates(:)
      type(physics_type) :: physics
      logical :: failed

      call numbers_at(motion, x, number, rates)
      call physics_at(motion, x, number, physics, failed)
   end subroutine numbers_of_start

   !> A step's tolerance far below the sigmas.
   subroutine set_tolerance(model, is_last)
      type(model_type), intent(inout) :: model
      logical, intent(in) :: is_last
      real(wp) :: part
      integer :: i

      if (model%motion%is_exact) return
      part = 1
      do i = 1, size(model%all)
         associate (one => model%all(i))
            if (one%column <= column_z) part = min(part, one%sigma/model%motion%number(1, &
               setting_place(pendulum_group, &
               'length')))
            if (one%column == column_u .or. one%column == column_v) part = min(part, 1e-3_wp)
            if (one%column == column_azimuth .or. one%column == column_angle .or. one%column == column_plane) &
               part = min(part, one%sigma)
            if (is_event(one%column)) part = min(part, 0.1_wp*one%sigma)
         end associate
      end do
      model%motion%tolerance = max(1e-12_wp, min(1e-8_wp, merge(1e-6_wp, 1e-5_wp, is_last)*part))
   end subroutine set_tolerance

   !> One more search from x over everything, for sigmas, delays or data that changed.
   subroutine minimise_all(model, x, minimum)
      type(model_type), intent(inout) :: model
      real(wp), intent(inout) :: x(:)
      type(minimum_type), intent(out) :: minimum

      call use_until(model, huge(1.0_wp), 1)
      call set_tolerance(model, .true.)
      call finish(model, x, minimum)
      if (minimum%squares < huge(1.0_wp)) call rebase(model, x)
   end subroutine minimise_all

end module kyvadlo_fit_search
