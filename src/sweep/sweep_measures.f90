!> What a sweep measures at every point: the words of `quantities` in &measure, and the histograms kept instead.
module kyvadlo_sweep_measures
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_group_values, only: refuse
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: entry_type, group_type
   use kyvadlo_quantities, only: quantities
   use kyvadlo_scene_groups, only: setting_place, settings, pendulum_group, start_energy_above_bottom, &
      start_energy_above_top, start_state, starts
   use kyvadlo_status, only: error_type
   use kyvadlo_sweep_axes, only: count_of, number_of, plain_name, text_of
   use kyvadlo_text, only: shown, split_words
   implicit none
   private
   public :: measure_type, histogram_type, watch_type, read_measure, read_histogram, is_exact

   !> Of the orbit, in closed form.
   integer, parameter, public :: exact_period = 1, exact_modulus = 2, exact_complementary_modulus = 3, &
      exact_quarter_period = 4, exact_nome = 5, exact_azimuth_rate = 6, exact_azimuth_per_period = 7, &
      exact_advance = 8, exact_turning = 9, exact_heights = 10, exact_rates = 11, exact_period_slope = 12, &
      exact_advance_slope = 13
   !> Of the samples of a simulation.
   integer, parameter, public :: sampled_least = 21, sampled_greatest = 22, sampled_first = 23, sampled_last = 24, &
      sampled_slack_time = 25, sampled_crossing_time = 26, sampled_swing_amplitude = 27, sampled_swing_azimuth = 28, &
      sampled_energy_lost = 29, sampled_contacts = 30

   type :: word_type
      character(len=23) :: name = ''
      integer :: kind = 0
      integer :: components = 1
      character(len=7) :: unit = ''      !! As UDUNITS writes it
      character(len=80) :: meaning = ''
   end type word_type

   type(word_type), parameter :: words(*) = [ &
      word_type('T', exact_period, 1, 's', 'period, from one highest point to the next'), &
      word_type('k', exact_modulus, 1, '1', 'modulus'), &
      word_type('complementary_modulus', exact_complementary_modulus, 1, '1', 'complementary modulus'), &
      word_type('K', exact_quarter_period, 1, '1', 'complete integral K of the modulus'), &
      word_type('q', exact_nome, 1, '1', 'nome'), &
      word_type('A', exact_azimuth_rate, 1, 'rad s-1', 'steady rate of the azimuth'), &
      word_type('phi_T', exact_azimuth_per_period, 1, 'rad', 'azimuth from one highest point to the next'), &
      word_type('advance', exact_advance, 1, 'rad', 'advance of the apsides in a period, phi_T less pi'), &
      word_type('turning', exact_turning, 8, 'm', 'z2, z1, z3, l + z2, l - z1, z1 - z2, z3 - z1, z3 - l'), &
      word_type('heights', exact_heights, 2, 'm', 'turning heights: upper z1, lower z2'), &
      word_type('rates', exact_rates, 3, 'rad s-1', 'rates of phase 2 K/T, azimuth A, apsides advance/T'), &
      word_type('slack_time', sampled_slack_time, 1, 's', 'time when the string first goes slack'), &
      word_type('crossing_time', sampled_crossing_time, 1, 's', 'time when the quantity first crosses the level'), &
      word_type('swing_amplitude', sampled_swing_amplitude, 1, 'rad', 'inclination at the next turning point'), &
      word_type('swing_azimuth', sampled_swing_azimuth, 1, 'rad', &
      'azimuth of the line of the swing there, above -pi/2, at most pi/2'), &
      word_type('energy_lost', sampled_energy_lost, 1, 'm2 s-2', 'energy per mass lost where the string goes taut'), &
      word_type('contacts', sampled_contacts, 1, '1', 'how often the string goes taut or rebounds')]

   character(len=*), parameter :: ends(4) = [character(len=9) :: 'least', 'greatest', 'first', 'last']

   !> One word of `quantities`.
   type :: measure_type
      character(len=:), allocatable :: name      !! Of the variable
      integer :: kind = 0                        !! One of the constants above
      integer :: components = 1
      integer :: slope = 0                       !! Of a derivative: its column among those of the core
      integer :: quantity = 0, column = 0        !! Of a sampled one: place in `quantities`, which of its columns
      character(len=:), allocatable :: unit, meaning
      integer :: histogram = 0                   !! Place among the histograms; 0: values are stored
   end type measure_type

   !> What is watched for `crossing_time`, `swing_amplitude` and `swing_azimuth`.
   type :: watch_type
      integer :: quantity = 0, column = 0        !! `crossing`
      real(wp) :: level = 0
      real(wp) :: time = 0                       !! `at` [s]
   end type watch_type

   !> One &histogram.
   type :: histogram_type
      character(len=:), allocatable :: name      !! Of the quantity
      integer :: line = 0
      real(wp) :: from = 0, to = 0
      integer :: bins = 0
      logical :: is_log = .false.
   end type histogram_type

contains

   !> Of the orbit; else of samples.
   pure elemental logical function is_exact(kind)
      integer, intent(in) :: kind

      is_exact = kind < sampled_least
   end function is_exact

   !> Reads &measure.
   pure subroutine read_measure(group, start, measures, watch, error)
      type(group_type), intent(in) :: group
      integer, intent(in) :: start                             !! Of the pendulum
      type(measure_type), allocatable, intent(out) :: measures(:)
      type(watch_type), intent(out) :: watch
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: known(*) = [character(len=10) :: 'quantities', 'crossing', 'level', 'at']
      character(len=:), allocatable :: text
      integer, allocatable :: first(:), last(:)
      integer :: i, j, count

      allocate (measures(0))
      do i = 1, size(group%entries)
         associate (entry => group%entries(i))
            if (any(known == entry%name)) then
               do j = 1, i - 1
                  if (group%entries(j)%name == entry%name) call refuse(error, group, entry%line, entry%name// &
                     ' given twice')
               end do
            else
               call refuse(error, group, entry%line, 'unknown name '//shown(entry%name)// &
                  '; known are quantities, crossing, level, at')
            end if
            if (allocated(error)) return
            select case (entry%name)
            case ('quantities')
               if (size(entry%values) /= 1 .or. .not. entry%values(1)%quoted) then
                  call refuse(error, group, entry%line, 'quantities must be a text in quotation marks')
                  return
               end if
               text = entry%values(1)%text
               do j = 1, len(text)
                  if (text(j:j) == ',') text(j:j) = ' '
               end do
               call split_words(text, first, last, count)
               deallocate (measures)
               allocate (measures(count))
               do j = 1, count
                  call read_word(group, entry, text(first(j):last(j)), start, measures(j), error)
                  if (allocated(error)) return
                  if (.not. any_named(measures(:j - 1), measures(j)%name)) cycle
                  call refuse(error, group, entry%line, 'quantities names '//measures(j)%name//' twice')
                  return
               end do
            case ('crossing')
               call text_of(group, entry, text, error)
               if (allocated(error)) return
               call find_column(text, watch%quantity, watch%column)
               if (watch%quantity == 0) call refuse(error, group, entry%line, "crossing must be the name of a column " &
                  //"of simulate, got '"//shown(text)//"'")
            case ('level')
               call number_of(group, entry, watch%level, error)
            case default
               call number_of(group, entry, watch%time, error)
               if (.not. allocated(error) .and. .not. watch%time >= 0) call refuse(error, group, entry%line, &
                  'at must not be negative')
            end select
            if (allocated(error)) return
         end associate
      end do
      if (size(measures) == 0) then
         call refuse(error, group, group%line, 'quantities is missing')
      else if (any(measures%kind == sampled_crossing_time) .and. watch%quantity == 0) then
         call refuse(error, group, group%line, 'crossing_time needs crossing, the name of a column, and level')
      end if
   end subroutine read_measure

   pure logical function any_named(measures, name)
      type(measure_type), intent(in) :: measures(:)
      character(len=*), intent(in) :: name
      integer :: i

      any_named = .false.
      do i = 1, size(measures)
         if (measures(i)%name == name) any_named = .true.
      end do
   end function any_named

   pure subroutine read_word(group, entry, word, start, measure, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      character(len=*), intent(in) :: word
      integer, intent(in) :: start
      type(measure_type), intent(out) :: measure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: of
      integer :: i, place

      measure%name = plain_name(word)
      place = findloc(words%name == measure%name, .true., 1)
      if (place > 0) then
         measure%kind = words(place)%kind
         measure%components = words(place)%components
         measure%unit = trim(words(place)%unit)
         measure%meaning = trim(words(place)%meaning)
         return
      end if
      do i = 1, size(ends)
         if (index(measure%name, trim(ends(i))//'_') /= 1) cycle
         of = measure%name(len_trim(ends(i)) + 2:)
         call find_column(of, measure%quantity, measure%column)
         if (measure%quantity == 0) exit
         measure%kind = sampled_least - 1 + i
         measure%unit = trim(quantities(measure%quantity)%unit)
         measure%meaning = trim(ends(i))//' value: '//trim(quantities(measure%quantity)%meaning)
         return
      end do
      call read_slope(measure, start)
      if (measure%kind > 0) return
      call refuse(error, group, entry%line, "quantities: unknown word '"//shown(word)//"'; known are "// &
         trim(known_words())//', least_, greatest_, first_, last_ before a column of simulate ' &
         //'(least_tension), dT_d and dadvance_d before length, gravity and the names of the start')
   end subroutine read_word

   !> `dT_dlength`, `dadvance_dz_upper`, `dT_dvelocity_2`.
   pure subroutine read_slope(measure, start)
      type(measure_type), intent(inout) :: measure
      integer, intent(in) :: start
      character(len=:), allocatable :: of, unit
      integer :: place

      if (index(measure%name, 'dT_d') == 1) then
         of = measure%name(5:)
         measure%unit = 's'
      else if (index(measure%name, 'dadvance_d') == 1) then
         of = measure%name(11:)
         measure%unit = 'rad'
      else
         return
      end if
      select case (start)
      case (start_state)
         measure%slope = findloc([character(len=10) :: 'position_1', 'position_2', 'position_3', 'velocity_1', &
            'velocity_2', 'velocity_3', 'length', 'gravity'] == of, .true., 1)
      case (start_energy_above_top, start_energy_above_bottom)
         ! An energy from a point that the length moves has none.
      case default
         measure%slope = findloc([character(len=19) :: 'length', 'gravity', starts(start)%first, &
            starts(start)%second] == of, .true., 1)
      end select
      if (measure%slope == 0) return
      measure%kind = merge(exact_period_slope, exact_advance_slope, measure%unit == 's')
      measure%meaning = 'derivative of '//merge('T      ', 'advance', measure%unit == 's')
      measure%meaning = trim(measure%meaning)//' with respect to '//of
      if (start == start_state .and. measure%slope < 7) of = of(:len(of) - 2)
      place = setting_place(pendulum_group, of)
      select case (settings(place)%unit)
      case ('m/s2')
         unit = 'm-1 s2'
      case ('m2/s2')
         unit = 'm-2 s2'
      case ('m2/s')
         unit = 'm-2 s'
      case ('m/s')
         unit = 'm-1 s'
      case ('deg')
         unit = 'degree-1'
      case default
         unit = 'm-1'
      end select
      measure%unit = measure%unit//' '//unit
   end subroutine read_slope

   !> The quantity of `simulate` and its column of this name; 0: there is none.
   pure subroutine find_column(name, quantity, column)
      character(len=*), intent(in) :: name
      integer, intent(out) :: quantity, column

      do quantity = 1, size(quantities)
         do column = 1, quantities(quantity)%columns
            if (quantities(quantity)%column_names(column) == name) return
         end do
      end do
      quantity = 0
      column = 0
   end subroutine find_column

   !> Blanks behind.
   pure function known_words() result(text)
      character(len=25*size(words)) :: text
      integer :: i

      text = words(1)%name
      do i = 2, size(words)
         text = trim(text)//', '//words(i)%name
      end do
   end function known_words

   !> Reads one &histogram and marks the measure that it stands for.
   pure subroutine read_histogram(group, place, measures, histogram, error)
      type(group_type), intent(in) :: group
      integer, intent(in) :: place                             !! Among the histograms
      type(measure_type), intent(inout) :: measures(:)
      type(histogram_type), intent(out) :: histogram
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: scale
      integer(int64) :: count
      logical :: has_from, has_to
      integer :: i

      histogram%line = group%line
      histogram%name = ''
      has_from = .false.
      has_to = .false.
      do i = 1, size(group%entries)
         associate (entry => group%entries(i))
            select case (entry%name)
            case ('quantity', 'name')
               if (size(entry%values) == 1) histogram%name = plain_name(trim(adjustl(entry%values(1)%text)))
            case ('from')
               call number_of(group, entry, histogram%from, error)
               has_from = .true.
            case ('to')
               call number_of(group, entry, histogram%to, error)
               has_to = .true.
            case ('count', 'bins')
               call count_of(group, entry, 1_int64, 10000_int64, count, error)
               histogram%bins = int(count)
            case ('scale')
               call text_of(group, entry, scale, error)
               if (allocated(error)) return
               histogram%is_log = scale == 'log'
               if (scale /= 'log' .and. scale /= 'linear') call refuse(error, group, entry%line, &
                  "scale must be 'linear' or 'log', got '"//shown(scale)//"'")
            case default
               call refuse(error, group, entry%line, 'unknown name '//shown(entry%name)// &
                  '; known are quantity, from, to, count, scale')
            end select
            if (allocated(error)) return
         end associate
      end do
      i = 0
      if (histogram%name /= '') i = place_named(measures, histogram%name)
      if (histogram%name == '') then
         call refuse(error, group, group%line, 'quantity is missing: a word of quantities in &measure')
      else if (i == 0) then
         call refuse(error, group, group%line, "quantity '"//shown(histogram%name)//"' is no word of quantities in " &
            //'&measure')
      else if (measures(i)%components > 1) then
         call refuse(error, group, group%line, histogram%name//' is more than one number: no histogram')
      else if (measures(i)%histogram > 0) then
         call refuse(error, group, group%line, 'a second histogram of '//histogram%name)
      else if (.not. (has_from .and. has_to .and. histogram%from < histogram%to) .or. histogram%bins == 0) then
         call refuse(error, group, group%line, 'from, to, greater, and count are needed')
      else if (histogram%is_log .and. .not. histogram%from > 0) then
         call refuse(error, group, group%line, 'a logarithmic histogram needs from above 0')
      else
         measures(i)%histogram = place
      end if
   end subroutine read_histogram

   pure integer function place_named(measures, name) result(place)
      type(measure_type), intent(in) :: measures(:)
      character(len=*), intent(in) :: name

      do place = size(measures), 1, -1
         if (measures(place)%name == name) return
      end do
   end function place_named

end module kyvadlo_sweep_measures
