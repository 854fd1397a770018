!> A plan: a scene, the axes along which its settings vary, what is measured, and the chunks into which the work is cut.
!> All of it follows from the text of the plan alone.
module kyvadlo_sweep_plan
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_effects, only: effects_type
   use kyvadlo_file_text, only: read_file
   use kyvadlo_group_values, only: refuse
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: entry_type, group_type, parse_groups, place_of
   use kyvadlo_number_text, only: read_number
   use kyvadlo_quantities, only: quantity_inclination, quantity_position
   use kyvadlo_philox, only: checksum
   use kyvadlo_scene_effects, only: effects_of, get_table_paths
   use kyvadlo_scene_groups
   use kyvadlo_scene_orbit, only: numbers_of, numbers_type
   use kyvadlo_scene_reader, only: keep_pendulum, pendulums_from_groups
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_settings_reader, only: settings_from_groups
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   use kyvadlo_sweep_axes, only: axis_normal, axis_type, draw_cloud, most_axes, plain_name, read_axis
   use kyvadlo_sweep_chunks, only: cut_type, new_cut
   use kyvadlo_sweep_measures
   use kyvadlo_text, only: integer_text, shown, text_type
   use kyvadlo_version, only: with_gsl
   implicit none
   private
   public :: plan_type, dimension_type, target_type, read_plan

   !> Columns of an orbit's numbers.
   integer, parameter, public :: column_length = 1, column_gravity = 2, column_first = 3, column_second = 6, &
      column_density_ratio = 9, column_added_mass = 10, orbit_columns = 10

   !> Where the value of an axis stands in the groups of the scene.
   type :: target_type
      integer :: group = 0, entry = 0, value = 0     !! Places in `groups`, its `entries`, their `values`
      integer :: setting = 0, element = 0            !! Place in `settings`; of a vector
      integer :: column = 0                          !! Of an orbit's numbers; 0: none of them
   end type target_type

   !> Axes that run side by side.
   type :: dimension_type
      character(len=:), allocatable :: name
      integer(int64) :: count = 0
      integer :: axes = 0                            !! How many run along it
      integer :: axis = 0                            !! The first of them
   end type dimension_type

   type :: plan_type
      character(len=:), allocatable :: text, file
      type(group_type), allocatable :: groups(:)     !! Of the scene, with something in place of what the axes give
      type(simulation_type) :: scene                 !! The same, read
      type(numbers_type) :: numbers                  !! Of its pendulum
      type(axis_type), allocatable :: axes(:)
      type(target_type), allocatable :: targets(:)   !! Of the axes
      integer, allocatable :: dimension_of(:)        !! Of the axes
      type(dimension_type), allocatable :: dimensions(:)
      type(measure_type), allocatable :: measures(:)
      type(watch_type) :: watch
      type(histogram_type), allocatable :: histograms(:)
      logical :: is_exact = .false., is_sampled = .false. !! Whether something of the orbit, of samples, is measured
      logical :: stores_values = .false.             !! Not everything is a histogram
      logical :: is_period_of_gaps = .false.         !! Nothing but T over the two gaps
      integer(int64) :: points = 1
      type(cut_type) :: cut
      integer :: table_checksum = 0                  !! Of the files of its tables; 0: there is none
   end type plan_type

   !> Points of a chunk at most, where values are stored and where only reductions are; a small sweep has chunks for
   !> some hundred workers all the same.
   integer(int64), parameter :: most_stored = 65536, most_reduced = 1048576, least_exact = 1024
   !> Of scenes: one alone in small sweeps, so that no rank waits for another's chunk.
   integer(int64), parameter :: most_scenes = 64, scenes_per_chunk = 8192
   integer(int64), parameter :: most_chunks = 2_int64**24   !! Whose numbers one rank gives out in half a minute
   integer(int64), parameter :: most_points = 10_int64**15

contains

   !> The plan in a text. Errors (`code_input`), with file and line: those of the scene; an axis, a measure or a
   !> histogram that is not understood.
   subroutine read_plan(text, file, folder, plan, error, pendulum)
      character(len=*), intent(in) :: text
      character(len=*), intent(in) :: file                  !! Name for messages
      character(len=*), intent(in) :: folder                !! Where the files that it names lie
      type(plan_type), intent(out) :: plan
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in), optional :: pendulum    !! Its name or number
      type(group_type), allocatable :: all_groups(:)
      type(pendulum_type), allocatable :: pendulums(:)
      integer :: i, measure

      plan%text = text
      plan%file = file
      if (present(pendulum)) plan%text = text//'! --pendulum '//pendulum
      call parse_groups(text, file, all_groups, error)
      if (.not. allocated(error)) call keep_pendulum(all_groups, file, error, pendulum)
      if (allocated(error)) return
      plan%groups = pack_groups(all_groups)
      call read_axes(all_groups, plan, error)
      if (allocated(error)) return
      call settings_from_groups(plan%groups, file, plan%scene%settings, error)
      if (allocated(error)) return
      call pendulums_from_groups(plan%groups, file, pendulums, error)
      if (allocated(error)) return
      plan%scene%pendulum = pendulums(1)
      plan%scene%text = text
      plan%scene%folder = folder
      call numbers_of(plan%scene%pendulum, plan%numbers, error)
      if (allocated(error)) return
      measure = 0
      do i = 1, size(all_groups)
         if (all_groups(i)%name /= 'measure') cycle
         if (measure > 0) call refuse(error, all_groups(i), all_groups(i)%line, 'a second &measure')
         if (allocated(error)) return
         measure = i
      end do
      if (measure == 0) then
         call fail(error, code_input, file//': no &measure group: what is to be computed?')
         return
      end if
      call read_measure(all_groups(measure), plan%scene%pendulum%start, plan%measures, plan%watch, error)
      if (.not. allocated(error)) call read_histograms(all_groups, plan, error)
      if (.not. allocated(error)) call check_scene(plan, error)
      if (allocated(error)) return
      if (plan%is_sampled) then
         call new_cut(plan%cut, plan%dimensions%count, max(1_int64, min(most_scenes, plan%points/scenes_per_chunk), &
            plan%points/most_chunks))
      else if (plan%stores_values) then
         call new_cut(plan%cut, plan%dimensions%count, min(most_stored, max(least_exact, plan%points/256)))
      else
         call new_cut(plan%cut, plan%dimensions%count, min(most_reduced, max(least_exact, plan%points/1024)))
      end if
   end subroutine read_plan

   pure function pack_groups(groups) result(scene)
      type(group_type), intent(in) :: groups(:)
      type(group_type), allocatable :: scene(:)
      logical :: is_scene(size(groups))
      integer :: i

      do i = 1, size(groups)
         is_scene(i) = all(groups(i)%name /= [character(len=9) :: 'axis', 'measure', 'histogram'])
      end do
      scene = pack(groups, is_scene)
   end function pack_groups

   subroutine read_histograms(groups, plan, error)
      type(group_type), intent(in) :: groups(:)
      type(plan_type), intent(inout) :: plan
      type(error_type), allocatable, intent(out) :: error
      integer :: i, count

      count = 0
      do i = 1, size(groups)
         if (groups(i)%name == 'histogram') count = count + 1
      end do
      allocate (plan%histograms(count))
      count = 0
      do i = 1, size(groups)
         if (groups(i)%name /= 'histogram') cycle
         count = count + 1
         call read_histogram(groups(i), count, plan%measures, plan%histograms(count), error)
         if (allocated(error)) return
      end do
      plan%stores_values = any(plan%measures%histogram == 0)
   end subroutine read_histograms

   !> Reads every &axis, finds where its values go, and what runs side by side.
   subroutine read_axes(groups, plan, error)
      type(group_type), intent(in) :: groups(:)
      type(plan_type), intent(inout) :: plan
      type(error_type), allocatable, intent(out) :: error
      type(dimension_type), allocatable :: dimensions(:)
      character(len=:), allocatable :: name
      logical :: is_definite
      integer, allocatable :: members(:)
      integer :: i, j, k, count, found

      count = 0
      do i = 1, size(groups)
         if (groups(i)%name == 'axis') count = count + 1
      end do
      if (count == 0 .or. count > most_axes) then
         call fail(error, code_input, plan%file//': a sweep needs from 1 to '//integer_text(most_axes)//' &axis groups')
         return
      end if
      allocate (plan%axes(count), plan%targets(count), plan%dimension_of(count), dimensions(count))
      count = 0
      found = 0
      do i = 1, size(groups)
         if (groups(i)%name /= 'axis') cycle
         count = count + 1
         associate (axis => plan%axes(count))
            call read_axis(groups(i), axis, error)
            if (.not. allocated(error)) call find_target(groups(i), plan, axis, plan%targets(count), error)
            if (allocated(error)) return
            do j = 1, count - 1
               if (plan%targets(j)%setting /= plan%targets(count)%setting .or. &
                  plan%targets(j)%element /= plan%targets(count)%element) cycle
               call refuse(error, groups(i), groups(i)%line, 'a second axis of '//axis%name)
               return
            end do
            name = axis%variable
            if (axis%together /= '') name = plain_name(axis%together)
            k = 0
            do j = 1, found
               if (dimensions(j)%name == name) k = j
            end do
            if (k > 0) then
               if (axis%together == '' .or. plan%axes(dimensions(k)%axis)%together /= axis%together) &
                  call refuse(error, groups(i), groups(i)%line, 'the name '//name//' stands for two dimensions')
               if (.not. allocated(error) .and. dimensions(k)%count /= axis%count) call refuse(error, groups(i), &
                  groups(i)%line, "axes together in '"//shown(axis%together)//"' must have one count")
               if (allocated(error)) return
            else
               found = found + 1
               k = found
               dimensions(k)%name = name
               dimensions(k)%count = axis%count
               dimensions(k)%axis = count
            end if
            dimensions(k)%axes = dimensions(k)%axes + 1
            plan%dimension_of(count) = k
         end associate
      end do
      plan%dimensions = dimensions(:found)
      do k = 1, found
         if (real(plan%points, wp)*real(dimensions(k)%count, wp) > real(most_points, wp)) then
            call fail(error, code_input, plan%file//': more than 1e15 points')
            return
         end if
         plan%points = plan%points*dimensions(k)%count
         members = pack([(i, i=1, count)], plan%dimension_of == k .and. plan%axes%kind == axis_normal)
         do i = 1, size(members)
            associate (row => plan%axes(members(i))%covariance)
               if (size(row) == 1 .or. size(row) == size(members)) cycle
               call fail(error, code_input, place_of(plan%file, plan%axes(members(i))%line)//'&axis: covariance ' &
                  //'takes the variance, or a number for each of the '//integer_text(size(members))// &
                  ' normal axes together')
               return
            end associate
         end do
         call draw_cloud(plan%axes, members, is_definite)
         if (is_definite .and. is_symmetric(plan%axes, members)) cycle
         call fail(error, code_input, place_of(plan%file, plan%axes(members(1))%line)// &
            '&axis: the covariance must be symmetric, and no variance negative')
         return
      end do
   end subroutine read_axes

   pure logical function is_symmetric(axes, members)
      type(axis_type), intent(in) :: axes(:)
      integer, intent(in) :: members(:)
      integer :: i, j

      is_symmetric = .true.
      do i = 1, size(members)
         do j = 1, i - 1
            is_symmetric = is_symmetric .and. abs(entry(i, j) - entry(j, i)) <= 0
         end do
      end do

   contains

      pure real(wp) function entry(i, j)
         integer, intent(in) :: i, j

         entry = 0
         if (size(axes(members(i))%covariance) > 1) entry = axes(members(i))%covariance(j)
      end function entry
   end function is_symmetric

   !> Finds the setting of an axis, and puts something that its rule allows in its place.
   pure subroutine find_target(group, plan, axis, target, error)
      type(group_type), intent(in) :: group
      type(plan_type), intent(inout) :: plan
      type(axis_type), intent(inout) :: axis
      type(target_type), intent(out) :: target
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: name, of_group, what
      type(group_type) :: new_group
      type(entry_type) :: new_entry
      integer :: i, j, candidates, in_scene, at

      name = axis%name
      of_group = ''
      at = index(name, '%')
      if (at > 0) of_group = name(:at - 1)
      name = name(at + 1:)
      at = index(name, '(')
      if (at > 0) then
         target%element = index('123', name(at + 1:min(at + 1, len(name))))
         if (name(at:) /= '('//achar(48 + target%element)//')') target%element = -1
         name = name(:at - 1)
      end if
      candidates = 0
      in_scene = 0
      do i = 1, size(settings)
         if (settings(i)%name /= name) cycle
         if (of_group /= '' .and. of_group /= group_names(settings(i)%group)) cycle
         candidates = candidates + 1
         if (in_scene == 0) target%setting = i
         do j = 1, size(plan%groups)
            if (plan%groups(j)%name /= group_names(settings(i)%group)) cycle
            in_scene = in_scene + 1
            target%setting = i
            target%group = j
         end do
      end do
      if (candidates == 0) then
         call refuse(error, group, group%line, "'"//shown(axis%name)//"' is no setting of a scene; " &
            //'kyvadlo simulate --list prints them')
      else if (candidates > 1 .and. in_scene /= 1) then
         call refuse(error, group, group%line, "'"//shown(axis%name)//"' is a setting of several groups; write " &
            //trim(group_names(settings(target%setting)%group))//'%'//name//', for one')
      else if (any(settings(target%setting)%rule == [rule_text, rule_truth])) then
         call refuse(error, group, group%line, shown(axis%name)//' is no number')
      else if (target%element < 0 .or. (target%element > 0 .neqv. settings(target%setting)%values > 1)) then
         what = ' is one number'
         if (settings(target%setting)%values > 1) what = ' is a vector; write '//name//'(1), (2) or (3)'
         call refuse(error, group, group%line, name//what)
      end if
      if (allocated(error)) return
      if (target%group == 0) then
         new_group%file = plan%file
         new_group%name = trim(group_names(settings(target%setting)%group))
         new_group%line = axis%line
         allocate (new_group%entries(0))
         call append_group(plan%groups, new_group)
         target%group = size(plan%groups)
      end if
      associate (there => plan%groups(target%group))
         do i = 1, size(there%entries)
            if (there%entries(i)%name /= name) cycle
            at = max(target%element, 1) - max(there%entries(i)%first, 1) + 1
            if (at < 1 .or. at > size(there%entries(i)%values)) cycle
            target%entry = i
            target%value = at
         end do
         if (target%entry == 0) then
            new_entry%name = name
            new_entry%first = target%element
            new_entry%line = axis%line
            allocate (new_entry%values(1))
            new_entry%values(1)%line = axis%line
            call append_entry(there%entries, new_entry)
            target%entry = size(there%entries)
            target%value = 1
            if (axis%kind == axis_normal .and. .not. axis%has_mean) call refuse(error, group, group%line, &
               'a normal axis needs mean, or a value in the scene')
         else if (axis%kind == axis_normal .and. .not. axis%has_mean) then
            call read_number(there%entries(target%entry)%values(target%value)%text, axis%mean, what)
            if (allocated(what)) call refuse(error, group, there%entries(target%entry)%line, name//': '//what)
         end if
         there%entries(target%entry)%values(target%value)%text = harmless(settings(target%setting)%rule)
      end associate
   end subroutine find_target

   ! (An array constructor with allocatable components in it leaks memory in gfortran 12.)
   pure subroutine append_group(groups, group)
      type(group_type), allocatable, intent(inout) :: groups(:)
      type(group_type), intent(in) :: group
      type(group_type), allocatable :: more(:)

      allocate (more(size(groups) + 1))
      more(:size(groups)) = groups
      more(size(more)) = group
      call move_alloc(more, groups)
   end subroutine append_group

   pure subroutine append_entry(entries, entry)
      type(entry_type), allocatable, intent(inout) :: entries(:)
      type(entry_type), intent(in) :: entry
      type(entry_type), allocatable :: more(:)

      allocate (more(size(entries) + 1))
      more(:size(entries)) = entries
      more(size(more)) = entry
      call move_alloc(more, entries)
   end subroutine append_entry

   !> A number that keeps a rule.
   pure function harmless(rule) result(text)
      integer, intent(in) :: rule
      character(len=1) :: text

      text = '0'
      if (rule == rule_positive .or. rule == rule_any) text = '1'
      if (rule == rule_count) text = '2'
   end function harmless

   !> What the measures ask of the scene.
   subroutine check_scene(plan, error)
      type(plan_type), intent(inout) :: plan
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j

      plan%is_exact = any(is_exact(plan%measures%kind))
      plan%is_sampled = any(.not. is_exact(plan%measures%kind))
      do i = 1, size(plan%measures)
         do j = 1, size(plan%axes)
            if (plan%measures(i)%name == plan%axes(j)%variable) call fail(error, code_input, plan%file// &
               ': '//plan%measures(i)%name//' is the name of an axis and of a quantity')
            if (allocated(error)) return
         end do
      end do
      do i = 1, size(group_names)
         if (.not. plan%is_exact .or. .not. plan%scene%settings%given(i)) cycle
         if (any(i == [output_group, rod_group, buoyancy_group, event_group])) cycle
         call fail(error, code_input, place_of(plan%file, plan%scene%settings%line(i))//'&'//trim(group_names(i))// &
            ': the quantities of an orbit (T, k, ...) are those of a rod without effects; measure samples (greatest_z)')
         return
      end do
      if (plan%scene%settings%given(buoyancy_group) .and. &
         any(plan%measures%kind == exact_period_slope .or. plan%measures%kind == exact_advance_slope)) then
         call fail(error, code_input, place_of(plan%file, plan%scene%settings%line(buoyancy_group))// &
            '&buoyancy: the derivatives of T and advance are those without a fluid')
         return
      end if
      if (plan%is_sampled) call check_effects(plan, error)
      if (allocated(error)) return
      associate (start => starts(plan%scene%pendulum%start))
         do i = 1, size(plan%axes)
            associate (target => plan%targets(i))
               select case (settings(target%setting)%group)
               case (pendulum_group)
                  j = max(target%element, 1) - 1
                  if (settings(target%setting)%name == 'length') target%column = column_length
                  if (settings(target%setting)%name == 'gravity') target%column = column_gravity
                  if (settings(target%setting)%name == start%first) target%column = column_first + j
                  if (settings(target%setting)%name == start%second) target%column = column_second + j
               case (buoyancy_group)
                  if (settings(target%setting)%name == 'density_ratio') target%column = column_density_ratio
                  if (settings(target%setting)%name == 'added_mass') target%column = column_added_mass
               end select
            end associate
         end do
      end associate
      plan%is_period_of_gaps = plan%scene%pendulum%start == start_gaps .and. &
         all(plan%measures%kind == exact_period) .and. all(plan%targets%column == column_first .or. &
         plan%targets%column == column_second)
      if (plan%is_sampled) call choose_quantities(plan)
   end subroutine check_scene

   !> Effects need an integrator, and a table its file.
   subroutine check_effects(plan, error)
      type(plan_type), intent(inout) :: plan
      type(error_type), allocatable, intent(out) :: error
      type(effects_type) :: effects
      character(len=:), allocatable :: note, text
      type(text_type), allocatable :: tables(:)
      integer :: i

      do i = 1, size(group_names)
         if (with_gsl .or. has_closed_form(i) .or. .not. plan%scene%settings%given(i)) cycle
         call fail(error, code_unsupported, place_of(plan%file, plan%scene%settings%line(i))// &
            'this build has no integrator (CMake option KYVADLO_WITH_GSL) for &'//trim(group_names(i)))
         return
      end do
      call effects_of(plan%scene, effects, error, note)
      call get_table_paths(plan%scene, tables)
      do i = 1, merge(0, size(tables), allocated(error))
         call read_file(tables(i)%text, text, error)
         if (allocated(error)) exit
         plan%table_checksum = ieor(plan%table_checksum, int(iand(checksum(text), int(huge(0), int64))))
      end do
   end subroutine check_effects

   !> The quantities that the samples need.
   subroutine choose_quantities(plan)
      type(plan_type), intent(inout) :: plan
      integer, allocatable :: needed(:)
      integer :: i

      allocate (needed(0))
      do i = 1, size(plan%measures)
         associate (measure => plan%measures(i))
            if (any(measure%kind == [sampled_least, sampled_greatest, sampled_first, sampled_last])) &
               call need(measure%quantity)
            if (measure%kind == sampled_crossing_time) call need(plan%watch%quantity)
            if (any(measure%kind == [sampled_swing_amplitude, sampled_swing_azimuth])) then
               call need(quantity_position)
               call need(quantity_inclination)
            end if
         end associate
      end do
      if (size(needed) == 0) call need(quantity_position)   ! The events come with whatever is asked for.
      plan%scene%settings%quantities = needed

   contains

      subroutine need(quantity)
         integer, intent(in) :: quantity

         if (all(needed /= quantity)) needed = [needed, quantity]
      end subroutine need
   end subroutine choose_quantities

end module kyvadlo_sweep_plan
