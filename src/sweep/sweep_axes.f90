!> The axes of a sweep: which setting takes which values. Every value follows from the plan and its index alone.
module kyvadlo_sweep_axes
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_decimal_grid, only: grid_point, grid_type, new_grid
   use kyvadlo_pairs_real64, only: pair_type, two_product, two_sum
   use kyvadlo_group_values, only: refuse
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: entry_type, group_type
   use kyvadlo_normal_quantile, only: normal_quantile
   use kyvadlo_number_text, only: read_number
   use kyvadlo_numbers, only: is_finite
   use kyvadlo_philox, only: philox_key, philox_uniform
   use kyvadlo_sample_times, only: rounded_off
   use kyvadlo_status, only: error_type
   use kyvadlo_text, only: integer_text, lower_case, shown
   implicit none
   private
   public :: axis_type, read_axis, axis_values, draw_cloud, number_of, text_of, count_of, plain_name, most_axes

   integer, parameter :: most_axes = 64

   integer, parameter, public :: axis_linear = 1, axis_log = 2, axis_list = 3, axis_uniform = 4, axis_normal = 5

   type :: axis_type
      character(len=:), allocatable :: name          !! Lower case, without blanks: frequency(1)
      character(len=:), allocatable :: variable      !! In the file: frequency_1
      character(len=:), allocatable :: together      !! Empty: alone
      integer :: line = 0                            !! Of the group, for messages
      integer :: kind = 0                            !! One of the `axis_*` constants
      integer(int64) :: count = 0
      logical :: is_log = .false.                    !! A uniform one over the logarithm
      real(wp) :: from = 0, to = 0
      real(wp) :: rest(2) = 0                        !! What rounding took off `from` and `to` as they were typed
      type(grid_type) :: grid                        !! Of a linear one: of the decimals as they were typed
      real(wp), allocatable :: list(:)
      integer(int64) :: key(2) = 0                   !! Of the generator
      real(wp) :: mean = 0
      logical :: has_mean = .false.
      real(wp), allocatable :: covariance(:)         !! Of a normal axis, with those of the same cloud in order
      real(wp), allocatable :: factors(:)            !! Row of the triangular factor of the covariance
      integer(int64), allocatable :: keys(:, :)      !! Of the axes that the factors belong to
   end type axis_type

contains

   !> Reads one &axis. What the setting is, and the scene's value of it, is found by the plan.
   pure subroutine read_axis(group, axis, error)
      type(group_type), intent(in) :: group
      type(axis_type), intent(out) :: axis
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: known(*) = [character(len=10) :: 'name', 'from', 'to', 'count', 'scale', &
         'values', 'random', 'seed', 'covariance', 'together', 'mean', 'deviation']
      character(len=:), allocatable :: scale, random
      integer(int64) :: seed
      integer :: given(size(known))   !! Places of the entries, 0: none
      integer :: i

      axis%line = group%line
      axis%name = ''
      axis%together = ''
      scale = 'linear'
      random = ''
      seed = 0
      given = 0
      do i = 1, size(group%entries)
         associate (entry => group%entries(i), place => findloc(known == group%entries(i)%name, .true., 1))
            if (place == 0) then
               call refuse(error, group, entry%line, 'unknown name '//shown(entry%name)//'; known are '// &
                  'name, from, to, count, scale, values, random, seed, mean, deviation, covariance, together')
            else if (given(place) > 0) then
               call refuse(error, group, entry%line, trim(known(place))//' given twice')
            end if
            if (allocated(error)) return
            given(place) = i
            select case (trim(known(place)))
            case ('name')
               call text_of(group, entry, axis%name, error)
            case ('scale')
               call text_of(group, entry, scale, error)
            case ('random')
               call text_of(group, entry, random, error)
            case ('together')
               call text_of(group, entry, axis%together, error)
            case ('from')
               call number_of(group, entry, axis%from, error)
            case ('to')
               call number_of(group, entry, axis%to, error)
            case ('mean')
               call number_of(group, entry, axis%mean, error)
               axis%has_mean = .true.
            case ('deviation')
               axis%covariance = [0.0_wp]
               call number_of(group, entry, axis%covariance(1), error)
               axis%covariance = axis%covariance**2
            case ('count')
               call count_of(group, entry, 1_int64, int(huge(0), int64), axis%count, error)
            case ('seed')
               call count_of(group, entry, 0_int64, 2_int64**53, seed, error)
            case ('values')
               call numbers_of(group, entry, axis%list, error)
            case default
               call numbers_of(group, entry, axis%covariance, error)
            end select
            if (allocated(error)) return
         end associate
      end do
      if (axis%name == '') then
         call refuse(error, group, group%line, 'name is missing: the setting that takes the values')
         return
      end if
      axis%variable = plain_name(axis%name)
      axis%key = philox_key(seed, axis%name)
      axis%is_log = scale == 'log'
      if (scale /= 'linear' .and. scale /= 'log') then
         call refuse(error, group, group%line, "scale must be 'linear' or 'log', got '"//shown(scale)//"'")
      else if (is_given('values')) then
         axis%kind = axis_list
         axis%count = size(axis%list)
         if (any_of(['from  ', 'to    ', 'count ', 'scale ', 'random'])) call refuse(error, group, group%line, &
            'values without from, to, count, scale and random')
      else if (random == 'normal') then
         axis%kind = axis_normal
         if (any_of(['from  ', 'to    ', 'scale ']) .or. is_given('covariance') .and. is_given('deviation') .or. &
            .not. allocated(axis%covariance)) call refuse(error, group, group%line, &
            'a normal axis takes count, seed, mean (without it the value of the scene) and deviation or covariance')
      else if (random == 'uniform' .or. random == '') then
         axis%kind = merge(axis_uniform, merge(axis_log, axis_linear, axis%is_log), random == 'uniform')
         if (.not. (is_given('from') .and. is_given('to'))) call refuse(error, group, group%line, &
            'give values, or from, to and count, or random')
      else
         call refuse(error, group, group%line, "random must be 'uniform' or 'normal', got '"//shown(random)//"'")
      end if
      if (allocated(error)) return
      if (.not. is_given('count') .and. axis%kind /= axis_list) then
         call refuse(error, group, group%line, 'count is missing')
      else if (axis%is_log .and. .not. (axis%from*axis%to > 0)) then
         call refuse(error, group, group%line, 'a logarithmic axis needs from and to of one sign, not 0')
      else if (is_given('seed') .and. random == '') then
         call refuse(error, group, group%line, 'seed without random')
      else if (axis%kind /= axis_normal .and. any_of(['mean      ', 'deviation ', 'covariance'])) then
         call refuse(error, group, group%line, "mean, deviation and covariance belong to random = 'normal'")
      else if (axis%kind == axis_linear) then
         associate (from => group%entries(given(2)), to => group%entries(given(3)))
            call new_grid(axis%grid, from%values(1)%text, to%values(1)%text, max(axis%count - 1, 1_int64))
            axis%rest = [rounded_off(from%values(1)%text, axis%from), rounded_off(to%values(1)%text, axis%to)]
         end associate
      end if

   contains

      pure logical function is_given(name)
         character(len=*), intent(in) :: name

         is_given = given(findloc(known == name, .true., 1)) > 0
      end function is_given

      pure logical function any_of(names)
         character(len=*), intent(in) :: names(:)
         integer :: i

         any_of = .false.
         do i = 1, size(names)
            any_of = any_of .or. is_given(names(i))
         end do
      end function any_of
   end subroutine read_axis

   pure subroutine make_plain(name, plain)
      character(len=*), intent(in) :: name
      character(len=len(name)), intent(out) :: plain
      integer :: i, count
      logical :: is_pending

      plain = ''
      count = 0
      is_pending = .false.
      do i = 1, len(name)
         if (scan(name(i:i), '()%.,: ') > 0) then
            is_pending = count > 0
            cycle
         end if
         if (is_pending) then
            count = count + 1
            plain(count:count) = '_'
         end if
         is_pending = .false.
         count = count + 1
         plain(count:count) = name(i:i)
      end do
   end subroutine make_plain

   pure integer function plain_length(name)
      character(len=*), intent(in) :: name
      character(len=len(name)) :: wide

      call make_plain(name, wide)
      plain_length = len_trim(wide)
   end function plain_length

   !> The name of a variable: letters, figures and single underscores.
   pure function plain_name(name) result(plain)
      character(len=*), intent(in) :: name
      character(len=len(name)) :: wide
      character(len=plain_length(name)) :: plain

      call make_plain(name, wide)
      plain = wide
   end function plain_name

   !> A text in quotation marks, in lower case without blanks around it.
   pure subroutine text_of(group, entry, text, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      character(len=:), allocatable, intent(out) :: text
      type(error_type), allocatable, intent(out) :: error

      text = ''
      if (size(entry%values) /= 1 .or. entry%first > 0 .or. .not. entry%values(1)%quoted) then
         call refuse(error, group, entry%line, entry%name//' must be a text in quotation marks')
         return
      end if
      text = trim(adjustl(lower_case(entry%values(1)%text)))
      if (text == '') call refuse(error, group, entry%line, entry%name//' must not be empty')
   end subroutine text_of

   pure subroutine number_of(group, entry, value, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      real(wp), intent(out) :: value
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:)

      value = 0
      call numbers_of(group, entry, values, error)
      if (allocated(error)) return
      if (size(values) /= 1) call refuse(error, group, entry%line, entry%name//' takes one number')
      value = values(1)
   end subroutine number_of

   pure subroutine numbers_of(group, entry, values, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      real(wp), allocatable, intent(out) :: values(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what
      integer :: i

      allocate (values(size(entry%values)), source=0.0_wp)
      if (entry%first > 0) call refuse(error, group, entry%line, entry%name//' has no elements')
      do i = 1, size(values)
         if (allocated(error)) return
         what = 'a text'
         if (.not. entry%values(i)%quoted) call read_number(entry%values(i)%text, values(i), what)
         if (allocated(what)) call refuse(error, group, entry%values(i)%line, entry%name// &
            " must be a finite number, got '"//shown(entry%values(i)%text)//"' ("//what//')')
      end do
   end subroutine numbers_of

   !> A whole number in a range.
   pure subroutine count_of(group, entry, least, most, count, error)
      type(group_type), intent(in) :: group
      type(entry_type), intent(in) :: entry
      integer(int64), intent(in) :: least, most
      integer(int64), intent(out) :: count
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value

      count = least
      call number_of(group, entry, value, error)
      if (allocated(error)) return
      if (value >= real(least, wp) .and. value <= real(most, wp) .and. abs(value - anint(value)) <= 0) then
         count = nint(value, int64)
      else
         call refuse(error, group, entry%line, entry%name//' must be a whole number from '// &
            integer_text(int(least))//' on, got '//shown(entry%values(1)%text))
      end if
   end subroutine count_of

   !> Some values of an axis, from an index on (from 0): each from its index alone.
   pure subroutine axis_values(axis, first, values)
      type(axis_type), intent(in) :: axis
      integer(int64), intent(in) :: first
      real(wp), intent(out) :: values(:)
      real(wp) :: parts, normal
      integer(int64) :: index
      integer :: i, j

      parts = real(max(axis%count - 1, 1_int64), wp)
      select case (axis%kind)
      case (axis_list)
         values = axis%list(first + 1:first + size(values))
      case (axis_linear)
         do i = 1, size(values)
            values(i) = linear_value(axis, first + i - 1)
         end do
      case (axis_log)
         do i = 1, size(values)
            index = first + i - 1
            values(i) = axis%from*(axis%to/axis%from)**(real(index, wp)/parts)
            if (index == axis%count - 1 .and. index > 0) values(i) = axis%to
         end do
      case (axis_uniform)
         do i = 1, size(values)
            values(i) = philox_uniform(axis%key, first + i - 1)
            if (axis%is_log) then
               values(i) = axis%from*(axis%to/axis%from)**values(i)
            else
               values(i) = axis%from + (axis%to - axis%from)*values(i)
            end if
         end do
      case default
         do i = 1, size(values)
            values(i) = axis%mean
            do j = 1, size(axis%factors)
               if (abs(axis%factors(j)) <= 0) cycle
               normal = normal_quantile(philox_uniform(axis%keys(:, j), first + i - 1))
               values(i) = values(i) + axis%factors(j)*normal
            end do
         end do
      end select
   end subroutine axis_values

   !> Between the decimals as they were typed, (A (n - i) + B i)/n, rounded once: in pairs, and where those leave open
   !> to which side, or digits cancel, in whole numbers.
   pure real(wp) function linear_value(axis, index) result(value)
      type(axis_type), intent(in) :: axis
      integer(int64), intent(in) :: index
      type(pair_type) :: left, right, total, product
      real(wp) :: parts, before, after, low
      character(len=:), allocatable :: ignored
      logical :: is_sure
      !> Products of smaller numbers lose their low parts.
      real(wp), parameter :: small = 1e-250_wp

      parts = real(max(axis%count - 1, 1_int64), wp)
      after = real(index, wp)
      before = parts - after
      left = two_product(axis%from, before)
      right = two_product(axis%to, after)
      total = two_sum(left%high, right%high)
      total = two_sum(total%high, total%low + ((left%low + axis%rest(1)*before) + (right%low + axis%rest(2)*after)))
      value = total%high/parts
      product = two_product(value, parts)
      low = ((total%high - product%high) + (total%low - product%low))/parts
      total = two_sum(value, low)
      value = total%high
      is_sure = is_finite(total%low)
      if (is_sure) is_sure = abs(value) > max(small, 1e-6_wp*max(abs(axis%from), abs(axis%to)))
      if (is_sure) is_sure = all(abs(abs(total%low) - spacing(value)*[0.5_wp, 0.25_wp]) > 1e-7_wp*spacing(value))
      if (.not. is_sure) call read_number(trim(grid_point(axis%grid, index)), value, ignored)
   end function linear_value

   !> The triangular factor of the covariance of the normal axes of one cloud, by Cholesky; of one alone its deviation.
   pure subroutine draw_cloud(axes, members, is_definite)
      type(axis_type), intent(inout) :: axes(:)
      integer, intent(in) :: members(:)              !! Places in `axes` of the normal axes that vary together
      logical, intent(out) :: is_definite
      real(wp) :: factor(size(members), size(members)), rest
      integer :: i, j, n

      n = size(members)
      factor = 0
      is_definite = .true.
      do i = 1, n
         associate (row => axes(members(i))%covariance)
            do j = 1, i
               rest = 0
               ! One number is the variance.
               if (size(row) > 1) then
                  rest = row(j)
               else if (i == j) then
                  rest = row(1)
               end if
               rest = rest - dot_product(factor(i, :j - 1), factor(j, :j - 1))
               if (i == j) then
                  is_definite = is_definite .and. rest >= -n*epsilon(rest)*abs(row(min(i, size(row))))
                  factor(i, i) = sqrt(max(rest, 0.0_wp))
               else if (factor(j, j) > 0) then
                  factor(i, j) = rest/factor(j, j)
               else
                  is_definite = is_definite .and. abs(rest) <= n*epsilon(rest)*abs(row(min(i, size(row))))
               end if
            end do
         end associate
      end do
      do i = 1, n
         associate (axis => axes(members(i)))
            axis%factors = factor(i, :i)
            allocate (axis%keys(2, i))
            do j = 1, i
               axis%keys(:, j) = axes(members(j))%key
            end do
         end associate
      end do
   end subroutine draw_cloud

end module kyvadlo_sweep_axes
