!> Where a search may start: the model of a request and its data, and numbers that the data or the scene suggest.
module kyvadlo_fit_places
   use kyvadlo_fit_data
   use kyvadlo_fit_guess, only: find_guesses, frequency_peaks, guess_type, view_type
   use kyvadlo_fit_model, only: measurement_type, model_type
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_unknowns, only: form_above, form_below, form_between, form_logarithm, form_plain, unknown_position, &
      unknown_type, unknown_velocity, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_orbit_real64, only: new_orbit_from_release, orbit_type
   use kyvadlo_quantiles, only: median
   use kyvadlo_scene_groups
   use kyvadlo_status, only: error_type
   implicit none
   private
   public :: place_type, most_guesses, new_model, sigma_groups, effect_guesses, guess_places

   !> A place to start from: the numbers of all settings.
   type :: place_type
      real(wp) :: number(3, size(settings)) = 0
      real(wp) :: squares = huge(1.0_wp)
   end type place_type

   !> Columns of one group have one standard deviation where it is estimated.
   integer, parameter :: sigma_groups(column_period) = [1, 1, 1, 2, 3, 4, 4, 5, 6, 7, 8, 9]
   integer, parameter :: most_guesses = 24
   real(wp), parameter :: degree = acos(-1.0_wp)/180

contains

   !> The model of a request and its data. Sigmas to be estimated are a hundredth of the spread for now.
   subroutine new_model(model, request, data, is_estimated)
      type(model_type), intent(out) :: model
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      logical, intent(out) :: is_estimated(:)            !! (column_period)
      real(wp) :: spread(column_period), unit(columns), alone(column_period)
      integer :: i, j, n, k

      unit = 1
      if (request%in_degrees) where (is_angle) unit = degree
      is_estimated = .false.
      alone = 0
      do j = 1, column_period
         if (data%has(j)) alone(j) = spread_of(data%value(:data%rows, j))*unit(j)
      end do
      do j = 1, column_period
         spread(j) = maxval(alone, sigma_groups == sigma_groups(j))
         if (is_event(j) .or. j == column_period) spread(j) = spread(j)/max(data%rows, 1)
         if (.not. spread(j) > 0) spread(j) = 1
      end do
      allocate (model%all(data%rows*count(data%has(:column_period))))
      n = 0
      do i = 1, data%rows
         do j = 1, column_period
            if (.not. data%has(j)) cycle
            if (is_nan(data%value(i, j))) cycle
            n = n + 1
            associate (one => model%all(n))
               one%column = j
               one%row = i
               one%value = data%value(i, j)*unit(j)
               one%time = data%value(i, column_t)
               if (is_event(j)) one%time = one%value
               if (j == column_period) one%time = -huge(1.0_wp)
               if (j == column_period) one%amplitude = data%value(i, column_amplitude)*unit(column_amplitude)
               if (j == column_period) then
                  one%amplitude_sigma = request%sigma(column_amplitude)*unit(column_amplitude)
                  if (.not. is_nan(data%sigma(i, column_amplitude))) &
                     one%amplitude_sigma = data%sigma(i, column_amplitude)*unit(column_amplitude)
               end if
               if (.not. is_nan(data%sigma(i, j))) then
                  one%sigma = data%sigma(i, j)*unit(j)
               else if (request%sigma(j) > 0) then
                  one%sigma = request%sigma(j)*unit(j)
               else
                  one%sigma = 0.01_wp*spread(j)
                  is_estimated(j) = .true.
               end if
            end associate
         end do
      end do
      if (n < size(model%all)) model%all = model%all(:n)
      model%is_ascending = all(model%all(2:)%time >= model%all(:n - 1)%time)
      if (data%has_sigma(column_t) .or. request%sigma(column_t) > 0) then
         allocate (model%time_sigma(data%rows), model%delay(data%rows))
         model%delay = 0
         model%time_sigma = data%sigma(:data%rows, column_t)
         where (is_nan(model%time_sigma)) model%time_sigma = request%sigma(column_t)
      end if
      model%axes = request%axes
      model%loss = request%loss
      model%loss_scale = request%loss_scale
      call new_unknowns(model%motion, request, .not. any(data%has([column_x, column_y, column_z, column_azimuth, &
         column_u, column_v, column_tension, column_plane])))
      model%unknowns = size(model%motion%of)
      k = count([(request%free(i)%prior_sigma > 0, i=1, size(request%free))])
      if (k > 0) then
         allocate (model%prior(k), model%prior_value(k), model%prior_sigma(k))
         k = 0
         do j = 1, size(model%motion%of)
            associate (free => request%free(model%motion%of(j)%free))
               if (.not. free%prior_sigma > 0) cycle
               k = k + 1
               model%prior(k) = j
               model%prior_value(k) = free%prior
               model%prior_sigma(k) = free%prior_sigma
            end associate
         end do
      end if
   end subroutine new_model

   !> The unknowns of a request.
   subroutine new_unknowns(unknowns, request, is_plane)
      type(unknowns_type), intent(out) :: unknowns
      type(fit_request_type), intent(in) :: request
      logical, intent(in) :: is_plane
      integer :: i, j, count
      type(unknown_type) :: one

      unknowns%number = request%number
      unknowns%effects = request%settings%effects
      unknowns%given = request%settings%given
      unknowns%start = request%pendulum%start
      unknowns%start_values = request%pendulum%values
      unknowns%has_state = request%pendulum%start == start_state
      unknowns%is_plane = is_plane
      unknowns%is_exact = all(has_closed_form .or. .not. unknowns%given)
      allocate (unknowns%of(0))
      do i = 1, size(request%free)
         associate (free => request%free(i), setting => settings(request%free(i)%setting))
            one = unknown_type()
            one%free = i
            one%setting = free%setting
            if (setting%group == pendulum_group .and. (setting%name == 'position' .or. setting%name == 'velocity')) then
               one%kind = merge(unknown_position, unknown_velocity, setting%name == 'position')
               if (one%kind == unknown_position) unknowns%is_position_free = .true.
               if (one%kind == unknown_velocity) unknowns%is_velocity_free = .true.
               count = merge(1, 2, is_plane)
            else
               count = setting%values
               select case (setting%rule)
               case (rule_positive)
                  one%form = form_logarithm
               case (rule_not_negative)
                  one%form = form_above
               case (rule_latitude)
                  one%form = form_between
                  one%least = -90
                  one%most = 90
               case (rule_fraction, rule_part)
                  one%form = form_between
                  one%most = 1
               end select
               if (free%least > -huge(1.0_wp) .or. free%most < huge(1.0_wp)) then
                  if (one%form == form_between) then
                     one%least = max(one%least, free%least)
                     one%most = min(one%most, free%most)
                  else if (free%least > -huge(1.0_wp) .and. free%most < huge(1.0_wp)) then
                     one%form = form_between
                     one%least = free%least
                     one%most = free%most
                  else if (free%least > -huge(1.0_wp)) then
                     one%form = form_above
                     one%least = free%least
                  else if (one%form == form_plain) then
                     one%form = form_below
                     one%most = free%most
                  else
                     one%least = 0
                     one%most = free%most
                     one%form = form_between
                  end if
               end if
            end if
            do j = 1, count
               one%element = j
               unknowns%of = [unknowns%of, one]
            end do
         end associate
      end do
   end subroutine new_unknowns

   pure real(wp) function spread_of(values)
      real(wp), intent(in) :: values(:)
      real(wp) :: mean
      integer :: i, n

      n = 0
      mean = 0
      do i = 1, size(values)
         if (.not. abs(values(i)) >= 0) cycle
         n = n + 1
         mean = mean + values(i)
      end do
      mean = mean/max(n, 1)
      spread_of = 0
      do i = 1, size(values)
         if (abs(values(i)) >= 0) spread_of = spread_of + (values(i) - mean)**2
      end do
      spread_of = sqrt(spread_of/max(n, 1))
   end function spread_of

   !> Coefficients of effects that nobody guessed: small ones of the right size.
   subroutine effect_guesses(request, number)
      type(fit_request_type), intent(in) :: request
      real(wp), intent(inout) :: number(:, :)
      real(wp) :: length, gravity
      integer :: i

      length = number(1, setting_place(pendulum_group, 'length'))
      gravity = number(1, setting_place(pendulum_group, 'gravity'))
      do i = 1, size(request%free)
         associate (free => request%free(i), setting => settings(request%free(i)%setting))
            if (free%is_given) cycle
            if (setting%group == air_group .and. setting%name == 'linear') &
               number(1, free%setting) = 0.003_wp*sqrt(gravity/length)
            if (setting%group == air_group .and. setting%name == 'quadratic') number(1, free%setting) = 0.003_wp/length
            if (setting%group == anisotropic_support_group) number(1, free%setting) = 1e-3_wp*length
            if (setting%group == buoyancy_group .and. setting%name == 'density_ratio') number(1, free%setting) = 0.05_wp
         end associate
      end do
   end subroutine effect_guesses

   !> Starts from the data, at levels that cost more and more: those of `find_guesses`.
   subroutine guess_places(model, request, level, places, count)
      type(model_type), intent(in) :: model
      type(fit_request_type), intent(in) :: request
      integer, intent(in) :: level
      type(place_type), intent(out) :: places(:)
      integer, intent(out) :: count
      type(view_type) :: view
      type(guess_type) :: guesses(most_guesses)
      integer :: i

      count = 0
      ! Cubics go through short pieces of many rows; the grid compares each of its shapes with all rows.
      call look(model, request, merge(600, 110, level == 1), view)
      if (model%motion%has_state .and. size(view%times) >= 4 .and. any(view%has)) then
         call find_guesses(view, level, guesses(:merge(most_guesses, 10, level == 3)), count)
         do i = 1, count
            places(i)%number = request%number
            associate (guess => guesses(i), number => places(i)%number)
               call put('length', guess%length)
               call put('gravity', guess%gravity)
               if (model%motion%is_position_free) number(:, setting_place(pendulum_group, 'position')) = guess%position
               if (model%motion%is_velocity_free) number(:, setting_place(pendulum_group, 'velocity')) = guess%velocity
               if (is_free(request, camera_group, 'scale')) number(1, setting_place(camera_group, 'scale')) = &
                  guess%scale
               if (is_free(request, camera_group, 'angle')) number(1, setting_place(camera_group, 'angle')) = &
                  guess%angle/degree
               if (is_free(request, camera_group, 'offset')) number(:2, setting_place(camera_group, 'offset')) = &
                  guess%offset
            end associate
            call effect_guesses(request, places(i)%number)
         end do
      end if
      if (count == 0 .and. level == 2) call guess_by_periods(model, request, view, places, count)

   contains

      subroutine put(name, value)
         character(len=*), intent(in) :: name
         real(wp), intent(in) :: value

         if (is_free(request, pendulum_group, name)) places(i)%number(1, setting_place(pendulum_group, name)) = value
      end subroutine put
   end subroutine guess_places

   pure logical function is_free(request, group, name)
      type(fit_request_type), intent(in) :: request
      integer, intent(in) :: group
      character(len=*), intent(in) :: name

      is_free = any(request%free%setting == setting_place(group, name))
   end function is_free

   !> The first ten periods or so, thinned out, as the guesses take them.
   subroutine look(model, request, most_rows, view)
      type(model_type), intent(in) :: model
      type(fit_request_type), intent(in) :: request
      integer, intent(in) :: most_rows
      type(view_type), intent(out) :: view
      integer, allocatable :: rows(:)
      real(wp), allocatable :: table(:, :), times(:)
      integer :: i, j, n, last, crossings, column(3), step, most, best
      real(wp) :: mean
      logical :: has(columns)

      has = .false.
      do i = 1, size(model%all)
         has(model%all(i)%column) = .true.
      end do
      view%is_plane = model%motion%is_plane
      column = 0
      if (any(has([column_u, column_v]))) then
         view%is_camera = .true.
         column(:2) = [column_u, column_v]
      else if (any(has(column_x:column_z))) then
         column = [column_x, column_y, column_z]
      else if (has(column_angle)) then
         column(1) = column_angle
         view%is_angle = .true.
      else if (has(column_azimuth)) then
         ! Its cosine and its sine.
         column(:2) = column_azimuth
         view%is_azimuth = .true.
      else if (has(column_tension)) then
         column(1) = column_tension
         view%is_tension = .true.
      else if (has(column_plane)) then
         ! Of twice the angle, whose half turns count for nothing.
         column(:2) = column_plane
         view%is_line = .true.
      end if
      where (column > 0) column = merge(column, 0, has(max(column, 1)))
      view%has = column > 0
      if (view%is_camera) view%has(3) = .false.
      n = maxval(model%all%row)
      allocate (table(n, 3), times(n))
      table = -huge(1.0_wp)
      times = 0
      do i = 1, size(model%all)
         do j = 1, 3
            if (column(j) > 0 .and. model%all(i)%column == column(j)) then
               table(model%all(i)%row, j) = model%all(i)%value
               times(model%all(i)%row) = model%all(i)%time
            end if
         end do
      end do
      if (view%is_azimuth .or. view%is_line) then
         where (table(:, 1) > -huge(1.0_wp))
            table(:, 2) = sin(merge(2, 1, view%is_line)*table(:, 1))
            table(:, 1) = cos(merge(2, 1, view%is_line)*table(:, 1))
         end where
      end if
      rows = pack([(i, i=1, n)], all(table > -huge(1.0_wp) .or. spread(column == 0, 1, n), 2))
      n = size(rows)
      last = n
      if (n > 0) then
         ! Ten periods: twenty passages through the mean of the column that swings most.
         best = 0
         most = 0
         mean = -1
         do j = 1, 3
            if (column(j) == 0) cycle
            if (spread_of(table(rows, j)) > mean) then
               mean = spread_of(table(rows, j))
               best = j
            end if
         end do
         if (best > 0) then
            mean = sum(table(rows, best))/n
            crossings = 0
            do i = 2, n
               if ((table(rows(i), best) - mean)*(table(rows(i - 1), best) - mean) < 0) crossings = crossings + 1
               last = i
               if (crossings >= 14 .and. i >= 40) exit
            end do
         end if
      end if
      step = max(1, last/most_rows)
      rows = rows(1:last:step)
      view%times = times(rows)
      view%seen = table(rows, :)
      do j = 1, 3
         if (column(j) == 0) view%seen(:, j) = 0
      end do
      if (view%is_camera) view%has(1:2) = column(1:2) > 0
      view%axes = model%axes
      view%usual_gravity = request%number(1, setting_place(pendulum_group, 'gravity'))
      if (.not. is_free(request, pendulum_group, 'length')) view%length = request%number(1, &
         setting_place(pendulum_group, 'length'))
      if (.not. is_free(request, pendulum_group, 'gravity')) view%gravity = request%number(1, &
         setting_place(pendulum_group, 'gravity'))
      if (.not. view%is_camera) return
      view%is_offset_free = is_free(request, camera_group, 'offset')
      view%is_turn_free = is_free(request, camera_group, 'angle')
      if (.not. is_free(request, camera_group, 'scale')) view%scale = request%number(1, setting_place(camera_group, &
         'scale'))
      view%angle = request%number(1, setting_place(camera_group, 'angle'))*degree
      view%offset = request%number(:2, setting_place(camera_group, 'offset'))
   end subroutine look

   !> Starts that only the period decides: of times alone, or where the scene has the start.
   subroutine guess_by_periods(model, request, view, places, count)
      type(model_type), intent(in) :: model
      type(fit_request_type), intent(in) :: request
      type(view_type), intent(in) :: view
      type(place_type), intent(inout) :: places(:)
      integer, intent(out) :: count
      real(wp), parameter :: angles(*) = [20.0_wp, 60.0_wp, 5.0_wp]
      real(wp) :: periods(16), peaks(3), rate, unit, length, gravity, first
      real(wp), allocatable :: times(:)
      integer :: n, i, j, found, tries
      type(orbit_type) :: orbit
      type(error_type), allocatable :: error
      logical :: is_amplitude_free

      n = 0
      if (any(model%all%column == column_period)) then
         i = findloc(model%all%column, column_period, 1)
         periods(1) = model%all(i)%value
         n = 1
      end if
      do j = column_turning_time, column_crossing_time
         times = pack(model%all%value, model%all%column == j)
         if (size(times) < 2) cycle
         ! Of the first events, whose amplitude is the nearest to that of the start; then of all.
         i = min(size(times), 4)
         first = median(times(2:i) - times(:i - 1))
         periods(n + 1:n + 3) = [2*first, first, 4*first]
         n = n + 3
         if (j == column_crossing_time .and. .not. model%motion%is_position_free) then
            periods(n + 1) = 4*times(1)
            n = n + 1
         end if
         periods(n + 1) = 2*median(times(2:) - times(:size(times) - 1))
         periods(n + 2:n + 4) = periods(1)*[0.97_wp, 1.03_wp, 0.94_wp]
         n = n + 4
         exit
      end do
      if (n == 0 .and. any(view%has) .and. size(view%times) > 3) then
         call frequency_peaks(view%times, view%seen(:, pack([1, 2, 3], view%has)), peaks, found)
         do i = 1, min(found, 3)
            periods(n + 1:n + 2) = [1/peaks(i), 2/peaks(i)]
            n = n + 2
         end do
      end if
      is_amplitude_free = is_free(request, pendulum_group, 'release_angle') .or. model%motion%is_position_free
      count = 0
      tries = merge(size(angles), 1, is_amplitude_free)
      do j = 1, tries
         do i = 1, n
            if (count == size(places)) exit
            unit = angles(j)
            if (.not. is_amplitude_free .and. model%motion%start == start_release) &
               unit = max(abs(request%number(1, setting_place(pendulum_group, 'release_angle'))), 1e-3_wp)
            if (any(model%all%column == column_period)) unit = max(abs(model%all(findloc(model%all%column, &
               column_period, 1))%amplitude)/degree, 1e-3_wp)
            call new_orbit_from_release(orbit, 1.0_wp, 1.0_wp, min(unit, 179.0_wp), 0.0_wp, error)
            if (allocated(error)) cycle
            rate = 2*orbit%period()/periods(i)
            length = request%number(1, setting_place(pendulum_group, 'length'))
            gravity = request%number(1, setting_place(pendulum_group, 'gravity'))
            if (is_free(request, pendulum_group, 'gravity')) then
               gravity = length*rate**2
            else if (is_free(request, pendulum_group, 'length')) then
               length = gravity/rate**2
            end if
            if (is_free(request, pendulum_group, 'length') .and. is_free(request, pendulum_group, 'gravity')) then
               gravity = 9.80665_wp
               length = gravity/rate**2
            end if
            count = count + 1
            places(count)%number = request%number
            places(count)%number(1, setting_place(pendulum_group, 'length')) = length
            places(count)%number(1, setting_place(pendulum_group, 'gravity')) = gravity
            if (is_free(request, pendulum_group, 'release_angle')) &
               places(count)%number(1, setting_place(pendulum_group, 'release_angle')) = angles(j)
            if (model%motion%is_position_free) places(count)%number(:, setting_place(pendulum_group, 'position')) = &
               length*[sin(angles(j)*degree), 0.0_wp, -cos(angles(j)*degree)]
            call effect_guesses(request, places(count)%number)
         end do
      end do
      if (count > 0) return
      count = 1
      places(1)%number = request%number
      call effect_guesses(request, places(1)%number)
   end subroutine guess_by_periods

end module kyvadlo_fit_places
