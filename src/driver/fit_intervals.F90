!> The intervals of a fit, by profile likelihood or by bootstrap: many small fits, shared among threads, with a line on
!> the terminal that says how far they are.
module kyvadlo_fit_intervals
   use, intrinsic :: iso_fortran_env, only: error_unit, int64
!$ use omp_lib, only: omp_get_max_threads
   use kyvadlo_fit_bootstrap, only: fit_copy
   use kyvadlo_fit_data, only: column_period, fit_data_type
   use kyvadlo_fit_model, only: model_type
   use kyvadlo_fit_places, only: new_model
   use kyvadlo_fit_profile, only: profile_end
   use kyvadlo_fit_request, only: fit_request_type, free_type
   use kyvadlo_fit_result, only: fit_result_type
   use kyvadlo_fit_unknowns, only: place_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_finite, is_nan, quiet_nan_real64
   use kyvadlo_quantiles, only: quantile_between, sort
   use kyvadlo_scene_groups
   use kyvadlo_standard_io, only: is_terminal, terminal_width
   use kyvadlo_text, only: integer_text
   implicit none
   private
   public :: find_profile, find_bootstrap

   type :: progress_type
      integer :: done = 0, total = 0
      integer(int64) :: start = 0, last_line = 0       !! Counts of the clock
      logical :: shows = .false., has_line = .false.
   end type progress_type

   !> Of an interval of 68.27 per cent, as one sigma on both sides of a normal number has.
   real(wp), parameter :: parts(2) = [0.158655253931457_wp, 0.841344746068543_wp]

contains

   !> By profile likelihood, for every number whose sigma is known.
   subroutine find_profile(result, request, data, threads)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      integer, intent(in) :: threads                   !! 0: all there are
      type(progress_type) :: progress
      type(model_type) :: model
      integer, allocatable :: tasks(:, :)              !! (3, n): free setting, element, side
      real(wp), allocatable :: ends(:), x(:)
      real(wp) :: least
      integer :: i, k, n, side

      call keep_bounds(result, request, data, model, x)
      least = least_squares(result)
      n = 2*sum(result%of%elements)
      allocate (tasks(3, n), ends(n))
      n = 0
      do i = 1, size(result%of)
         associate (one => result%of(i))
            one%least = quiet_nan_real64
            one%most = quiet_nan_real64
            do k = 1, one%elements
               if (.not. (one%is_known(k) .and. is_finite(one%sigma(k)))) cycle   ! Comparing a NaN may trap.
               one%least(k) = one%value(k)
               one%most(k) = one%value(k)
               if (.not. one%sigma(k) > 0) cycle
               do side = -1, 1, 2
                  n = n + 1
                  tasks(:, n) = [i, k, side]
               end do
            end do
         end associate
      end do
      call begin(progress, n)
      !$omp parallel do num_threads(thread_number(threads, n)) schedule(dynamic) default(shared)
      do i = 1, n
         associate (one => result%of(tasks(1, i)))
            call profile_end(model, x, one%setting, tasks(2, i), one%value(tasks(2, i)), one%sigma(tasks(2, i)), &
               least, tasks(3, i), ends(i))
         end associate
         !$omp critical (kyvadlo_fit_progress)
         call show(progress)
         !$omp end critical (kyvadlo_fit_progress)
      end do
      !$omp end parallel do
      call finish(progress)
      do i = 1, n
         associate (one => result%of(tasks(1, i)), free => request%free(tasks(1, i)), k => tasks(2, i))
            if (tasks(3, i) < 0) one%least(k) = within(free, ends(i), -1)
            if (tasks(3, i) > 0) one%most(k) = within(free, ends(i), 1)
         end associate
      end do
      result%has_intervals = .true.
      result%intervals = 'profile likelihood, 68.27 %: chi2 grows by 1'
   end subroutine find_profile

   !> By bootstrap, of the numbers that the data tell.
   subroutine find_bootstrap(result, request, data, copies, seed, threads)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      integer, intent(in) :: copies, seed
      integer, intent(in) :: threads                   !! 0: all there are
      type(progress_type) :: progress
      type(model_type) :: model
      real(wp), allocatable :: numbers(:, :, :), x(:), sorted(:)
      logical, allocatable :: is_found(:)
      integer :: i, k

      call keep_bounds(result, request, data, model, x)
      allocate (numbers(3, size(settings), copies), is_found(copies))
      call begin(progress, copies)
      !$omp parallel do num_threads(thread_number(threads, copies)) schedule(dynamic) default(shared)
      do i = 1, copies
         call fit_copy(model, x, seed, i, numbers(:, :, i), is_found(i))
         !$omp critical (kyvadlo_fit_progress)
         call show(progress)
         !$omp end critical (kyvadlo_fit_progress)
      end do
      !$omp end parallel do
      call finish(progress)
      do i = 1, size(result%of)
         associate (one => result%of(i), free => request%free(i))
            one%least = quiet_nan_real64
            one%most = quiet_nan_real64
            do k = 1, one%elements
               if (.not. one%is_known(k) .or. 2*count(is_found) < copies) cycle
               sorted = pack(numbers(k, one%setting, :), is_found)
               call sort(sorted)
               one%least(k) = within(free, quantile_between(sorted, parts(1)), -1)
               one%most(k) = within(free, quantile_between(sorted, parts(2)), 1)
            end do
         end associate
      end do
      result%has_intervals = .true.
      result%intervals = 'bootstrap of the rows, 68.27 % of '//integer_text(count(is_found))//' fits, seed '// &
         integer_text(seed)
      if (.not. all(is_found)) result%intervals = result%intervals//'; '//integer_text(count(.not. is_found))// &
         ' more found no minimum'
   end subroutine find_bootstrap

   !> The sum of squares at the minimum, of losses where there are any; and of priors.
   real(wp) function least_squares(result)
      type(fit_result_type), intent(in) :: result
      type(model_type) :: model
      real(wp) :: f(result%model%residuals)
      logical :: failed

      model = result%model
      call model%evaluate(result%x, f, failed)
      least_squares = sum(f**2)
   end function least_squares

   !> The model in unknowns that keep the bounds (sigmas are found without), and where searches begin: the minimum, a
   !> little away from bounds.
   subroutine keep_bounds(result, request, data, model, x)
      type(fit_result_type), intent(in) :: result
      type(fit_request_type), intent(in) :: request
      type(fit_data_type), intent(in) :: data
      type(model_type), intent(out) :: model
      real(wp), allocatable, intent(out) :: x(:)
      type(model_type) :: fresh
      logical :: is_estimated(column_period)

      call new_model(fresh, request, data, is_estimated)
      model = result%model
      model%motion%of = fresh%motion%of
      model%unknowns = size(model%motion%of)
      model%motion%number = result%number
      allocate (x(size(model%motion%of)))
      call place_at(model%motion, x, away=1.0_wp)
   end subroutine keep_bounds

   !> An end, or the bound of its setting that comes before it.
   pure real(wp) function within(free, value, side) result(ends)
      type(free_type), intent(in) :: free
      real(wp), intent(in) :: value                    !! NaN: none
      integer, intent(in) :: side
      real(wp) :: bound

      bound = merge(free%most, free%least, side > 0)
      select case (settings(free%setting)%rule)
      case (rule_positive, rule_not_negative)
         if (side < 0) bound = max(bound, 0.0_wp)
      case (rule_latitude)
         bound = side*min(90.0_wp, side*bound)
      case (rule_fraction, rule_part)
         if (side < 0) bound = max(bound, 0.0_wp)
         if (side > 0) bound = min(bound, 1.0_wp)
      end select
      ends = value
      if (abs(bound) >= huge(bound)) return
      if (is_nan(value)) then
         ends = bound
      else if (side*(value - bound) > 0) then
         ends = bound
      end if
   end function within

   integer function thread_number(wanted, tasks) result(threads)
      integer, intent(in) :: wanted, tasks

      threads = wanted
!$    if (wanted == 0) threads = omp_get_max_threads()
      threads = max(1, min(threads, tasks))
   end function thread_number

   subroutine begin(progress, total)
      type(progress_type), intent(out) :: progress
      integer, intent(in) :: total

      progress%total = total
      progress%shows = is_terminal(2)
      call system_clock(progress%start)
      progress%last_line = progress%start
   end subroutine begin

   !> One more is done: `12 %  34 s left`, over the line before, after a second and then five times a second.
   subroutine show(progress)
      type(progress_type), intent(inout) :: progress
      integer(int64) :: now, rate
      real(wp) :: seconds, part
      character(len=40) :: line

      progress%done = progress%done + 1
      if (.not. progress%shows) return
      call system_clock(now, rate)
      seconds = real(now - progress%start, wp)/rate
      if (seconds < 1 .or. real(now - progress%last_line, wp) < 0.2_wp*rate) return
      progress%last_line = now
      part = real(progress%done, wp)/progress%total
      write (line, '(i0," of ",i0," fits  ",i0," s left")') progress%done, progress%total, nint(seconds*(1 - part)/part)
      write (error_unit, '(a)', advance='no') achar(13)//line(:min(len(line), terminal_width() - 1))
      flush (error_unit)
      progress%has_line = .true.
   end subroutine show

   subroutine finish(progress)
      type(progress_type), intent(in) :: progress

      if (progress%has_line) write (error_unit, '(a)', advance='no') achar(13)//repeat(' ', &
         min(40, terminal_width() - 1))//achar(13)
   end subroutine finish

end module kyvadlo_fit_intervals
