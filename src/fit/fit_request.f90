!> What a scene asks a fit for: which settings are free, what is known of them, and how the data were seen.
module kyvadlo_fit_request
   use kyvadlo_fit_data, only: column_names, column_amplitude, columns
   use kyvadlo_fit_loss, only: loss_squares
   use kyvadlo_group_values, only: read_group, refuse, set_defaults
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: entry_type, group_type, parse_groups, place_of
   use kyvadlo_number_text, only: read_number
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_groups
   use kyvadlo_scene_reader, only: keep_pendulum, pendulums_from_groups
   use kyvadlo_scene_settings, only: settings_type, value_of_name_type
   use kyvadlo_scene_settings_reader, only: settings_from_groups
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   use kyvadlo_text, only: lower_case, shown, split_words, text_type
   implicit none
   private
   public :: fit_request_type, free_type, parse_fit_request

   character(len=8), parameter :: loss_names(3) = [character(len=8) :: 'squares', 'huber', 'cauchy']
   !> Ninety-five per cent efficient for normal errors (P. J. Huber 1964; P. W. Holland and R. E. Welsch 1977).
   real(wp), parameter :: loss_scales(3) = [1.0_wp, 1.345_wp, 2.385_wp]

   !> A setting that is free.
   type :: free_type
      integer :: setting = 0                          !! Place in `settings`
      character(len=40) :: name = ''                  !! As asked for
      logical :: is_given = .false.                   !! The scene has a guess
      real(wp) :: least = -huge(1.0_wp), most = huge(1.0_wp)
      real(wp) :: prior = 0, prior_sigma = 0          !! prior_sigma 0: none
      logical :: has_prior = .false.                  !! A value was given
   end type free_type

   type :: fit_request_type
      character(len=:), allocatable :: file, text
      character(len=:), allocatable :: choice         !! Name or number of the pendulum, where one was asked for
      integer :: line = 0                             !! Of &fit
      type(settings_type) :: settings
      type(pendulum_type) :: pendulum
      real(wp) :: number(3, size(settings)) = 0       !! Values of all settings; those of free ones are guesses
      type(free_type), allocatable :: free(:)
      real(wp) :: sigma(columns) = 0                  !! Where the table has none; 0: to be estimated
      logical :: in_degrees = .false.                 !! The angles of the data
      integer :: loss = loss_squares
      real(wp) :: loss_scale = 1
      logical :: has_start = .true.                   !! Periods of given amplitudes need none
      logical :: has_camera = .false.
      integer :: axes(2) = [1, 3]                     !! What u and v show
   end type fit_request_type

   real(wp), parameter :: nothing = -huge(1.0_wp)

contains

   !> The scene of a fit. Errors (`code_input`), with file and line: those of a scene; no &fit; a name in `free` that no
   !> group has, or several have; a bound or prior of what is not free.
   subroutine parse_fit_request(text, file, request, error, pendulum)
      character(len=*), intent(in) :: text, file
      type(fit_request_type), intent(out) :: request
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in), optional :: pendulum   !! Its name or number
      type(group_type), allocatable :: groups(:)
      type(pendulum_type), allocatable :: pendulums(:)
      type(value_of_name_type) :: values(size(settings))
      integer :: i, fit

      request%file = file
      request%text = text
      if (present(pendulum)) request%choice = pendulum
      call parse_groups(text, file, groups, error)
      if (.not. allocated(error)) call keep_pendulum(groups, file, error, pendulum)
      if (allocated(error)) return
      fit = 0
      do i = 1, size(groups)
         if (groups(i)%name == 'fit') fit = i
      end do
      if (fit == 0) then
         call fail(error, code_input, file//': no &fit group; it says what is free')
         return
      end if
      request%line = groups(fit)%line
      call read_free(groups, fit, request, error)
      if (allocated(error)) return
      call complete_groups(groups, request)
      call settings_from_groups(groups, file, request%settings, error)
      if (.not. allocated(error)) call pendulums_from_groups(groups, file, pendulums, error)
      if (.not. allocated(error) .and. request%settings%given(body_group)) call fail(error, code_unsupported, &
         place_of(file, request%settings%line(body_group))//'a fit does not take &body; free length instead')
      if (allocated(error)) return
      request%pendulum = pendulums(1)
      call set_defaults(values)
      do i = 1, size(groups)
         associate (place => findloc(group_names == groups(i)%name, .true., 1))
            if (place /= fit_group) then
               call read_group(groups(i), place, values, error)
            else
               call read_fit_group(groups(i), values, request, error)
            end if
         end associate
         if (allocated(error)) return
      end do
      do i = 1, size(settings)
         request%number(:, i) = values(i)%number
      end do
      call take_choices(groups(fit), values, request, error)
      if (.not. allocated(error)) call check_request(request, groups(fit), error)
   end subroutine parse_fit_request

   !> The names of `free`.
   subroutine read_free(groups, fit, request, error)
      type(group_type), intent(in) :: groups(:)
      integer, intent(in) :: fit
      type(fit_request_type), intent(inout) :: request
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: words
      integer, allocatable :: first(:), last(:)
      integer :: i, j, count, line
      type(free_type) :: free

      allocate (request%free(0))
      words = ''
      line = groups(fit)%line
      do i = 1, size(groups(fit)%entries)
         if (groups(fit)%entries(i)%name /= 'free') cycle
         words = lower_case(groups(fit)%entries(i)%values(1)%text)
         line = groups(fit)%entries(i)%line
      end do
      do i = 1, len(words)
         if (words(i:i) == ',') words(i:i) = ' '
      end do
      call split_words(words, first, last, count)
      if (count == 0) call refuse(error, groups(fit), line, 'free names no setting')
      do i = 1, count
         free = free_type()
         free%name = words(first(i):last(i))
         call find_setting(groups, groups(fit), line, free, error)
         if (allocated(error)) return
         do j = 1, size(request%free)
            if (request%free(j)%setting == free%setting) call refuse(error, groups(fit), line, &
               'free names '//trim(free%name)//' twice')
         end do
         if (allocated(error)) return
         request%free = [request%free, free]
      end do
   end subroutine read_free

   !> `name` or `group.name`. A plain name is that of &pendulum if it has it, else of the one group of the scene, else
   !> of
   !> the one group of all that has it.
   subroutine find_setting(groups, fit, line, free, error)
      type(group_type), intent(in) :: groups(:), fit
      integer, intent(in) :: line
      type(free_type), intent(inout) :: free
      type(error_type), allocatable, intent(out) :: error
      integer :: i, point, found, in_scene, anywhere, among_scene, among_all
      logical :: stands

      point = index(free%name, '.')
      found = 0
      if (point > 0) then
         i = findloc(group_names == free%name(:point - 1), .true., 1)
         if (i > 0) found = setting_place(i, trim(free%name(point + 1:)))
      else
         found = setting_place(pendulum_group, trim(free%name))
         among_scene = 0
         among_all = 0
         do i = 1, size(settings)
            if (settings(i)%name /= free%name .or. any(settings(i)%group == [pendulum_group, output_group, &
               fit_group])) &
               cycle
            stands = any_named(groups, group_names(settings(i)%group))
            among_all = among_all + 1
            anywhere = i
            if (stands) among_scene = among_scene + 1
            if (stands) in_scene = i
         end do
         if (found > 0) then
            continue
         else if (among_scene == 1) then
            found = in_scene
         else if (among_scene == 0 .and. among_all == 1) then
            found = anywhere
         else if (among_all > 0) then
            call refuse(error, fit, line, &
               'free: several groups have '//trim(free%name)//'; write group.'//trim(free%name))
            return
         end if
      end if
      if (found > 0) then
         if (any(settings(found)%rule == [rule_text, rule_truth, rule_count]) .or. &
            any(settings(found)%group == [output_group, fit_group])) found = 0
      end if
      if (found == 0) then
         call refuse(error, fit, line, 'free: no setting is named '//shown(trim(free%name))// &
            '; kyvadlo simulate --list names them')
         return
      end if
      free%setting = found
   end subroutine find_setting

   pure logical function any_named(groups, name)
      type(group_type), intent(in) :: groups(:)
      character(len=*), intent(in) :: name
      integer :: i

      any_named = .false.
      do i = 1, size(groups)
         if (groups(i)%name == name) any_named = .true.
      end do
   end function any_named

   !> Gives what is free and missing a value, so that the scene can be read, and notes what was given.
   subroutine complete_groups(groups, request)
      type(group_type), allocatable, intent(inout) :: groups(:)
      type(fit_request_type), intent(inout) :: request
      integer :: i, state

      do i = 1, size(request%free)
         associate (free => request%free(i), setting => settings(request%free(i)%setting))
            if (.not. any_named(groups, group_names(setting%group))) call add_group(groups, &
               group_names(setting%group), &
               request)
            call ensure(groups, setting, free%is_given)
            if (free%setting == setting_place(camera_group, 'scale') .and. .not. free%is_given) cycle
         end associate
      end do
      state = 0
      do i = 1, size(request%free)
         if (settings(request%free(i)%setting)%group /= pendulum_group) cycle
         if (settings(request%free(i)%setting)%name == 'position') state = state + 1
         if (settings(request%free(i)%setting)%name == 'velocity') state = state + 2
      end do
      if (state == 1) call ensure_named(groups, 'velocity')
      if (state == 2) call ensure_named(groups, 'position')
      do i = 1, size(groups)
         if (groups(i)%name /= 'pendulum') cycle
         request%has_start = any_start(groups(i))
         if (.not. request%has_start) call ensure_named(groups, 'release_angle')
         return
      end do
   end subroutine complete_groups

   pure logical function any_start(group) result(has)
      type(group_type), intent(in) :: group
      integer :: i

      has = .false.
      do i = 1, size(group%entries)
         if (any(starts%first == group%entries(i)%name .or. starts%second == group%entries(i)%name)) has = .true.
      end do
   end function any_start

   subroutine ensure_named(groups, name)
      type(group_type), intent(inout) :: groups(:)
      character(len=*), intent(in) :: name
      logical :: is_given

      call ensure(groups, settings(setting_place(pendulum_group, name)), is_given)
   end subroutine ensure_named

   subroutine add_group(groups, name, request)
      type(group_type), allocatable, intent(inout) :: groups(:)
      character(len=*), intent(in) :: name
      type(fit_request_type), intent(in) :: request
      type(group_type), allocatable :: more(:)

      allocate (more(size(groups) + 1))
      more(:size(groups)) = groups
      more(size(more))%file = request%file
      more(size(more))%name = trim(name)
      more(size(more))%line = request%line
      allocate (more(size(more))%entries(0))
      call move_alloc(more, groups)
   end subroutine add_group

   !> A value that keeps the rules, where there is none.
   subroutine ensure(groups, setting, is_given)
      type(group_type), intent(inout) :: groups(:)
      type(setting_type), intent(in) :: setting
      logical, intent(out) :: is_given
      type(entry_type), allocatable :: more(:)
      integer :: i, j

      is_given = .false.
      do i = 1, size(groups)
         if (groups(i)%name /= group_names(setting%group)) cycle
         do j = 1, size(groups(i)%entries)
            if (groups(i)%entries(j)%name == setting%name) is_given = .true.
         end do
         if (is_given) return
         allocate (more(size(groups(i)%entries) + 1))
         more(:size(more) - 1) = groups(i)%entries
         associate (entry => more(size(more)))
            entry%name = trim(setting%name)
            entry%line = groups(i)%line
            allocate (entry%values(setting%values))
            do j = 1, setting%values
               entry%values(j)%line = entry%line
               entry%values(j)%text = '0'
               if (setting%name == 'position' .and. j == 3) entry%values(j)%text = '-1'
               if (any(setting%rule == [rule_positive])) entry%values(j)%text = '1'
               if (setting%name == 'gravity') entry%values(j)%text = '9.80665'
               if (setting%name == 'latitude') entry%values(j)%text = '45'
               if (setting%name == 'release_angle') entry%values(j)%text = '20'
            end do
         end associate
         call move_alloc(more, groups(i)%entries)
         return
      end do
   end subroutine ensure

   !> &fit: bounds and priors apart from what the table of settings knows.
   subroutine read_fit_group(group, values, request, error)
      type(group_type), intent(in) :: group
      type(value_of_name_type), intent(inout) :: values(size(settings))
      type(fit_request_type), intent(inout) :: request
      type(error_type), allocatable, intent(out) :: error
      type(group_type) :: rest
      character(len=*), parameter :: prefixes(4) = [character(len=12) :: 'least_', 'most_', 'prior_sigma_', 'prior_']
      character(len=:), allocatable :: what, name
      logical :: keep(size(group%entries))
      real(wp) :: number
      integer :: i, j, k

      keep = .true.
      do i = 1, size(group%entries)
         do j = 1, size(prefixes)
            if (index(group%entries(i)%name, trim(prefixes(j))) /= 1) cycle
            keep(i) = .false.
            name = group%entries(i)%name(len_trim(prefixes(j)) + 1:)
            call read_number(group%entries(i)%values(1)%text, number, what)
            if (.not. allocated(what) .and. size(group%entries(i)%values) > 1) what = 'one number'
            if (.not. allocated(what) .and. j == 3 .and. .not. number > 0) what = 'it must be positive'
            if (allocated(what)) then
               call refuse(error, group, group%entries(i)%line, &
                  group%entries(i)%name//" must be a finite number, got '" &
                  //shown(group%entries(i)%values(1)%text)//"' ("//what//')')
               return
            end if
            do k = 1, size(request%free)
               associate (free => request%free(k))
                  if (settings(free%setting)%name /= name .or. settings(free%setting)%values /= 1) cycle
                  if (j == 1) free%least = number
                  if (j == 2) free%most = number
                  if (j == 3) free%prior_sigma = number
                  if (j == 4) free%prior = number
                  if (j == 4) free%has_prior = .true.
                  name = ''
               end associate
            end do
            if (name /= '') call refuse(error, group, group%entries(i)%line, group%entries(i)%name// &
               ': no free setting of one number has that name')
            exit
         end do
         if (allocated(error)) return
      end do
      rest = group
      rest%entries = group%entries(pack([(i, i=1, size(keep))], keep))
      call read_group(rest, fit_group, values, error)
      do k = 1, size(request%free)
         if (allocated(error)) return
         name = trim(settings(request%free(k)%setting)%name)
         associate (free => request%free(k))
            if (.not. free%least < free%most) call refuse(error, group, group%line, &
               'least_'//name//' must be below most_'//name)
            if (.not. allocated(error) .and. (free%has_prior .neqv. free%prior_sigma > 0)) call refuse(error, group, &
               group%line, 'prior_'//name//' and prior_sigma_'//name//' go together')
         end associate
      end do
   end subroutine read_fit_group

   !> Sigmas, units, loss, camera.
   subroutine take_choices(fit, values, request, error)
      type(group_type), intent(in) :: fit
      type(value_of_name_type), intent(in) :: values(size(settings))
      type(fit_request_type), intent(inout) :: request
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: first(:), last(:)
      integer :: i, place, count
      character(len=:), allocatable :: text

      do i = 1, columns
         place = setting_place(fit_group, 'sigma_'//trim(column_names(i)))
         if (values(place)%line(1) > 0) then
            request%sigma(i) = values(place)%number(1)
         else if (i < column_amplitude) then
            place = setting_place(fit_group, 'sigma')
            if (values(place)%line(1) > 0) request%sigma(i) = values(place)%number(1)
         end if
      end do
      place = setting_place(fit_group, 'units')
      if (values(place)%line(1) > 0) then
         text = lower_case(values(place)%text(1)%text)
         call split_words(text, first, last, count)
         do i = 1, count
            select case (text(first(i):last(i)))
            case ('degrees')
               request%in_degrees = .true.
            case ('radians', 'pixels', 'metres', 'seconds')
               continue
            case default
               call refuse(error, fit, values(place)%line(1), &
                  'units are degrees or radians, pixels, metres, seconds; got '// &
                  shown(text))
               return
            end select
         end do
      end if
      place = setting_place(fit_group, 'loss')
      if (values(place)%line(1) > 0) then
         request%loss = findloc(loss_names == lower_case(trim(values(place)%text(1)%text)), .true., 1)
         if (request%loss == 0) then
            call refuse(error, fit, values(place)%line(1), 'loss must be squares, huber or cauchy, got '// &
               shown(values(place)%text(1)%text))
            return
         end if
      end if
      request%loss_scale = loss_scales(request%loss)
      place = setting_place(fit_group, 'loss_scale')
      if (values(place)%line(1) > 0) request%loss_scale = values(place)%number(1)
      request%has_camera = request%settings%given(camera_group)
      if (.not. request%has_camera) return
      place = setting_place(camera_group, 'view')
      select case (lower_case(trim(values(place)%text(1)%text)))
      case ('xz')
         request%axes = [1, 3]
      case ('yz')
         request%axes = [2, 3]
      case ('xy')
         request%axes = [1, 2]
      case default
         call fail(error, code_input, place_of(request%file, values(place)%line(1))// &
            '&camera: view must be xz, yz or xy, got '//shown(values(place)%text(1)%text))
      end select
   end subroutine take_choices

   subroutine check_request(request, fit, error)
      type(fit_request_type), intent(in) :: request
      type(group_type), intent(in) :: fit
      type(error_type), allocatable, intent(out) :: error
      integer :: k

      do k = 1, size(request%free)
         associate (free => request%free(k), setting => settings(request%free(k)%setting))
            if (setting%group == pendulum_group .and. setting%name /= 'length' .and. setting%name /= 'gravity') then
               if (starts(request%pendulum%start)%first /= setting%name .and. &
                  starts(request%pendulum%start)%second /= setting%name) call refuse(error, fit, fit%line, &
                  'free: '//trim(setting%name)//' is not the start of the scene')
            end if
            if (.not. allocated(error) .and. setting%group == moving_pivot_group .and. all(setting%name /= &
               ['amplitude', 'frequency', 'phase    '])) call refuse(error, fit, fit%line, &
               'free: of &moving_pivot, amplitude, frequency and phase may be free')
            if (.not. allocated(error) .and. setting%group == air_group .and. all(setting%name /= ['linear   ', &
               'quadratic'])) &
               call refuse(error, fit, fit%line, 'free: of &air, linear and quadratic may be free')
            if (allocated(error)) return
         end associate
      end do
      if (allocated(request%settings%table) .or. allocated(request%settings%hoist_table)) call fail(error, &
         code_unsupported, request%file//': a fit does not take a table of the pivot or of the length')
      if (.not. allocated(error) .and. request%settings%effects%is_string .and. &
         request%settings%effects%restitution > nothing .and. request%settings%effects%stiffness > 0) &
         call fail(error, code_unsupported, request%file//': a fit does not take an elastic string')
   end subroutine check_request

end module kyvadlo_fit_request
