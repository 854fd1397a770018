!> An orbit to a stated accuracy: the kind and the number of terms that reach it at the least cost.
!>
!> The promise, for the exact values of the start and of the time: the position is off by at most `accuracy` l while
!> |time| <= `span`, the period by at most `accuracy` T, velocities by at most 2 `accuracy` max(v_max, sqrt(g l)).
!> What is chosen from, by rising cost of a place at many times (doc/speed.md has the figures):
!>
!>     grade_single real32 vectors, harmonics 0 to 2 of the theta series
!>     grade_short  real64 vectors, harmonics 0 to 2, shorter sines
!>     grade_full   real64 vectors as in `locate` without an accuracy
!>     fine         real64 vectors in double-double arithmetic, up to 2**31 half periods
!>     real128      the scalar form
!>
!> The first two reduce the time by the period in plain real64, which limits the span.
module kyvadlo_accuracy
   use, intrinsic :: iso_fortran_env, only: real32, real64
#ifdef KYVADLO_NO_REAL128
   ! No wider kind here: what is said of it below is never reached.
   use, intrinsic :: iso_fortran_env, only: real128 => real64
   use kyvadlo_orbit_real64, only: orbit_type_real128 => orbit_type
#else
   use, intrinsic :: iso_fortran_env, only: real128
   use kyvadlo_orbit_real128, only: orbit_type_real128 => orbit_type
#endif
   use kyvadlo_accuracy_bounds, only: error_bounds, accuracy_finest_double, accuracy_finest_double_double, &
      accuracy_finest_quad, half_periods
   use kyvadlo_orbit, only: check_sizes
   use kyvadlo_batch_constants
   use kyvadlo_double_double_batch, only: locate_double_double, double_double_limit
   use kyvadlo_double_double_constants, only: wide_batch_type
   use kyvadlo_double_double_start, only: new_double_double
   use kyvadlo_motion_kinds, only: motion_none
   use kyvadlo_numbers_real64, only: is_nan, quiet_nan
   use kyvadlo_orbit_real64, only: orbit_type
   use kyvadlo_start, only: new_orbit, new_rough_orbit
   use kyvadlo_status, only: code_domain, error_type, fail
   implicit none
   private
   public :: accurate_orbit_type, new_orbit_to_accuracy
   public :: accuracy_finest_double, accuracy_finest_double_double, accuracy_finest_quad, accuracy_coarsest

   !> A coarser wish is taken for a mistake: 3 for 1e-3.
   real(real64), parameter :: accuracy_coarsest = 0.1_real64
   !> For finer wishes the set-up keeps T in two parts at once; for coarser ones only if the rounding of T spoils them.
   real(real64), parameter :: finest_rough = 1e-11_real64
   !> Points computed at a time where they must be copied.
   integer, parameter :: strip = 2**16

   !> An orbit and how to evaluate it. Read-only after set-up; any thread may use it.
   type :: accurate_orbit_type
      type(orbit_type) :: orbit                            !! In double precision: kernel, T and advance to the accuracy
      type(wide_batch_type), allocatable :: fine           !! Allocated if double-double arithmetic is the cheapest
      type(orbit_type_real128), allocatable :: wide        !! Allocated if only real128 keeps the accuracy
      real(real64) :: accuracy = 0                         !! As asked for
      real(real64) :: span = 0                             !! As asked for [s]
      real(real64) :: bound = 0                            !! Bound of the position error by the error model, in l
   contains
      procedure, non_overridable :: period => period_to_accuracy
      procedure, non_overridable :: choice_text, kind_text, is_beyond_double, take_wide
      procedure, non_overridable, private :: locate_to_accuracy
      generic :: locate => locate_to_accuracy
#ifndef KYVADLO_NO_REAL128
      procedure, non_overridable :: period_real128, locate_at_real128
      procedure, non_overridable, private :: locate_to_accuracy_real128
      generic :: locate => locate_to_accuracy_real128
#endif
   end type accurate_orbit_type

   interface new_orbit_to_accuracy
      module procedure to_accuracy_from_start, to_accuracy_from_orbit
   end interface new_orbit_to_accuracy

contains

   !> Orbit of any start (`start_heights` and so on, see kyvadlo_start) that keeps an accuracy. The numbers of the start
   !> count as they are, in binary. Needs accuracy_finest_quad <= accuracy <= accuracy_coarsest, span >= 0, and times
   !> that the kind can still tell apart.
   pure subroutine to_accuracy_from_start(plan, start, length, gravity, first, second, accuracy, span, error, rests)
      type(accurate_orbit_type), intent(out) :: plan
      integer, intent(in) :: start                       !! One of the `start_*` constants
      real(real64), intent(in) :: length, gravity        !! l [m], g [m/s2]
      real(real64), intent(in) :: first(:), second(:)    !! What the start takes: (3) of a state, else (1)
      real(real64), intent(in) :: accuracy               !! Of the position relative to l, and of T relative to T
      real(real64), intent(in) :: span                   !! The accuracy is kept for |time| <= span [s]
      type(error_type), allocatable, intent(out) :: error
      real(real64), intent(in), optional :: rests(2)      !! What of l and g their rounding took off [m, m/s2]
      real(real64) :: rest(2)
      logical :: is_kept, is_rough

      is_kept = .false.
      rest = 0
      if (present(rests)) rest = rests
      is_rough = .not. is_nan(accuracy)
      if (is_rough) is_rough = accuracy >= finest_rough
      if (is_rough) then
         call new_rough_orbit(plan%orbit, start, length, gravity, first, second, error, rest)
         if (.not. allocated(error)) call begin(plan, accuracy, span, error)
         if (.not. allocated(error)) call choose(plan, .true., is_kept)
         if (is_kept) return
      end if
      call new_orbit(plan%orbit, start, length, gravity, first, second, error, rest)
      if (.not. allocated(error)) call begin(plan, accuracy, span, error)
      if (.not. allocated(error)) then
         call choose(plan, .false., is_kept)
         if (is_kept) return
         call set_up_fine(plan, start, length, gravity, first, second, rest, is_kept, error)
         if (is_kept) return
      end if
      if (.not. allocated(error)) then
#ifdef KYVADLO_NO_REAL128
         call fail(error, code_domain, &
            'new_orbit_to_accuracy: this build has no quadruple precision; an accuracy of '// &
            trim(text(accuracy_finest_double))//' is kept for 2**52 half periods, and one of '// &
            trim(text(accuracy_finest_double_double))//' for 2**31 where there is a period, got accuracy '// &
            trim(text(accuracy))//' and '// trim(text(half_periods(plan%orbit, plan%span)))//' half periods')
#else
         allocate (plan%wide)
         call new_orbit(plan%wide, start, real(length, real128) + rest(1), real(gravity, real128) + rest(2), &
            real(first, real128), real(second, real128), error)
         if (.not. allocated(error)) call check_wide(plan, error)
#endif
      end if
      if (allocated(error)) call spoil(plan)
   end subroutine to_accuracy_from_start

   !> The same from an orbit in double precision, for an accuracy that double precision keeps.
   pure subroutine to_accuracy_from_orbit(plan, orbit, accuracy, span, error)
      type(accurate_orbit_type), intent(out) :: plan
      type(orbit_type), intent(in) :: orbit              !! Not the `orbit` of another accuracy
      real(real64), intent(in) :: accuracy               !! Of the position relative to l, and of T relative to T
      real(real64), intent(in) :: span                   !! The accuracy is kept for |time| <= span [s]
      type(error_type), allocatable, intent(out) :: error
      logical :: is_kept

      plan%orbit = orbit
      call begin(plan, accuracy, span, error)
      if (allocated(error)) then
         continue
      else if (orbit%kernel%grade /= grade_full) then
         call fail(error, code_domain, 'new_orbit_to_accuracy: need an orbit without an accuracy, got '// &
            'one of '//trim(plan%choice_text()))
      else
         call choose(plan, .false., is_kept)
         if (is_kept) return
         call fail(error, code_domain, 'new_orbit_to_accuracy: an orbit in double precision keeps an accuracy of '// &
            trim(text(accuracy_finest_double))// &
            ' and 2**52 half periods (from its start, real128 keeps more), got accuracy '//trim(text(accuracy)) &
            //' and '//trim(text(half_periods(plan%orbit, plan%span)))//' half periods')
      end if
      call spoil(plan)
   end subroutine to_accuracy_from_orbit

   !> Checks what is asked for and takes it down.
   pure subroutine begin(plan, accuracy, span, error)
      type(accurate_orbit_type), intent(inout) :: plan
      real(real64), intent(in) :: accuracy, span
      type(error_type), allocatable, intent(out) :: error

      plan%accuracy = accuracy
      plan%span = span
      if (is_nan(accuracy)) then
         call fail(error, code_domain, 'new_orbit_to_accuracy: need an accuracy, got NaN')
      else if (.not. (accuracy_finest_quad <= accuracy .and. accuracy <= accuracy_coarsest)) then
         call fail(error, code_domain, 'new_orbit_to_accuracy: need '//trim(text(accuracy_finest_quad))// &
            ' <= accuracy <= '// trim(text(accuracy_coarsest))//', got '//trim(text(accuracy)))
      else if (is_nan(span)) then
         call fail(error, code_domain, 'new_orbit_to_accuracy: need a span, got NaN')
      else if (.not. plan%span >= 0) then
         call fail(error, code_domain, 'new_orbit_to_accuracy: need span >= 0, got '//trim(text(plan%span)))
      end if
   end subroutine begin

   !> The cheapest way of double precision that keeps the accuracy by the error model.
   pure subroutine choose(plan, is_rough, is_kept)
      type(accurate_orbit_type), intent(inout) :: plan
      logical, intent(in) :: is_rough   !! The orbit was set up by `new_rough_orbit`
      logical, intent(out) :: is_kept
      real(real64) :: bounds(0:most_grade)
      integer :: grade

      plan%orbit%kernel%grade = grade_full
      call error_bounds(plan%orbit, plan%span, is_rough, bounds)
      do grade = 1, most_grade
         if (.not. bounds(grade) <= plan%accuracy) cycle
         plan%bound = bounds(grade)
         is_kept = .true.
         call drop_harmonics(plan%orbit%kernel, grade_harmonics(grade))
         plan%orbit%kernel%grade = grade
         if (grade == grade_single) call clear_smallest(plan%orbit%kernel)
         return
      end do
      plan%bound = bounds(grade_full)
      ! Half periods are counted in whole numbers.
      is_kept = plan%bound <= plan%accuracy .and. half_periods(plan%orbit, plan%span) <= 1/epsilon(1.0_real64)
   end subroutine choose

   !> Double-double arithmetic where it keeps the accuracy.
   pure subroutine set_up_fine(plan, start, length, gravity, first, second, rest, is_kept, error)
      type(accurate_orbit_type), intent(inout) :: plan
      integer, intent(in) :: start
      real(real64), intent(in) :: length, gravity, first(:), second(:), rest(2)
      logical, intent(out) :: is_kept
      type(error_type), allocatable, intent(out) :: error

      is_kept = plan%accuracy >= accuracy_finest_double_double
      if (.not. is_kept) return
      allocate (plan%fine)
      call new_double_double(plan%fine, start, length, gravity, first, second, rest, &
         [plan%orbit%start_phase%high, plan%orbit%start_phase%low], error)
      is_kept = .not. allocated(error)
      if (is_kept) is_kept = plan%fine%form /= form_scalar .and. plan%span <= double_double_limit(plan%fine)
      plan%bound = accuracy_finest_double_double
      if (.not. is_kept) deallocate (plan%fine)
   end subroutine set_up_fine

#include "accuracy_harmonics.inc"

#ifndef KYVADLO_NO_REAL128
   !> Whether real128 keeps it: what the start allows, and times that can still be told apart.
   pure subroutine check_wide(plan, error)
      type(accurate_orbit_type), intent(inout) :: plan
      type(error_type), allocatable, intent(out) :: error

      plan%bound = accuracy_finest_quad
      if (half_periods(plan%orbit, plan%span) <= real(1/epsilon(1.0_real128), real64)) return
      call fail(error, code_domain, 'new_orbit_to_accuracy: need a span of at most 2**112 half periods, got '// &
         trim(text(half_periods(plan%orbit, plan%span))))
   end subroutine check_wide
#endif

   !> NaN everywhere: nothing computed from a failed set-up can pass for a number.
   pure subroutine spoil(plan)
      type(accurate_orbit_type), intent(inout) :: plan
      type(orbit_type) :: never_set_up

      if (allocated(plan%wide)) deallocate (plan%wide)
      if (allocated(plan%fine)) deallocate (plan%fine)
      plan%orbit = never_set_up
      plan%bound = quiet_nan
   end subroutine spoil

   !> What was chosen, for people, blanks behind: 'real32 vectors, harmonics 0 to 2'.
   pure function choice_text(plan) result(words)
      class(accurate_orbit_type), intent(in) :: plan
      character(len=34) :: words

      associate (b => plan%orbit%kernel)
         if (allocated(plan%fine)) then
            words = 'double-double vectors'
         else if (allocated(plan%wide)) then
            words = 'real128'
         else if (plan%orbit%motion == motion_none) then
            words = 'none'
         else if (b%form == form_scalar) then
            words = 'real64, point by point'
         else if (b%grade == grade_full) then
            words = 'real64 vectors, all terms'
         else
            words = merge('real32', 'real64', b%grade == grade_single)//' vectors, harmonics 0 to '// &
               achar(iachar('0') + grade_harmonics(b%grade))
         end if
      end associate
   end function choice_text

   !> The kind that holds the places.
   pure function kind_text(plan) result(name)
      class(accurate_orbit_type), intent(in) :: plan
      character(len=7) :: name

      name = 'real64'
      if (plan%orbit%kernel%grade == grade_single) name = 'real32'
      if (plan%is_beyond_double()) name = 'real128'
   end function kind_text

   !> A number in a message.
   pure function text(number)
      real(real64), intent(in) :: number
      character(len=12) :: text

      if (abs(number) > 0 .and. (abs(number) < 1e-98_real64 .or. abs(number) > 1e98_real64)) then
         write (text, '(es12.2e3)') number
      else
         write (text, '(es12.2e2)') number
      end if
      text = adjustl(text)
   end function text

   !> Positions (and velocities) at many times to the accuracy of the set-up: as `locate` of an orbit. Rounding to
   !> real64 may add half a last digit of a coordinate where the accuracy is finer than that. In double-double
   !> arithmetic NaN beyond 2**31 half periods.
   subroutine locate_to_accuracy(plan, time, x, y, z, vx, vy, vz, highest_level, threads)
      class(accurate_orbit_type), intent(in) :: plan
      real(real64), intent(in) :: time(:)                             !! [s] (n)
      real(real64), intent(out), dimension(:) :: x, y, z              !! [m] (n)
      real(real64), intent(out), dimension(:), optional :: vx, vy, vz !! [m/s] (n), all three or none
      integer, intent(in), optional :: highest_level  !! 0 baseline, 1 x86-64-v3, 2 x86-64-v4; the processor's if absent
      integer, intent(in), optional :: threads        !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      real(real128), allocatable :: placed(:, :)
      integer :: first, last, n
      logical :: fit

      if (.not. (allocated(plan%wide) .or. allocated(plan%fine))) then
         if (present(vx) .or. present(vy) .or. present(vz)) then
            call plan%orbit%locate(time, x, y, z, vx, vy, vz, highest_level, threads)
         else
            call plan%orbit%locate(time, x, y, z, highest_level=highest_level, threads=threads)
         end if
         return
      end if
      if (present(vx) .or. present(vy) .or. present(vz)) then
         call check_sizes(size(time), fit, x, y, z, vx, vy, vz)
      else
         call check_sizes(size(time), fit, x, y, z)
      end if
      if (.not. fit) return
      if (allocated(plan%fine)) then
         if (present(vx)) then
            call locate_double_double(plan%fine, time, x, y, z, vx, vy, vz, highest_level, threads)
         else
            call locate_double_double(plan%fine, time, x, y, z, highest_level=highest_level, threads=threads)
         end if
         return
      end if
      allocate (placed(min(size(time), strip), 6))
      do first = 1, size(time), strip
         last = min(size(time), first + strip - 1)
         n = last - first + 1
         if (present(vx)) then
            call plan%wide%locate(real(time(first:last), real128), placed(:n, 1), placed(:n, 2), placed(:n, 3), &
               placed(:n, 4), placed(:n, 5), placed(:n, 6), threads=threads)
            vx(first:last) = real(placed(:n, 4), real64)
            vy(first:last) = real(placed(:n, 5), real64)
            vz(first:last) = real(placed(:n, 6), real64)
         else
            call plan%wide%locate(real(time(first:last), real128), placed(:n, 1), placed(:n, 2), placed(:n, 3), &
               threads=threads)
         end if
         x(first:last) = real(placed(:n, 1), real64)
         y(first:last) = real(placed(:n, 2), real64)
         z(first:last) = real(placed(:n, 3), real64)
      end do
   end subroutine locate_to_accuracy

#ifndef KYVADLO_NO_REAL128
   !> The same without rounding to real64. The times are real64: their exact values count.
   subroutine locate_to_accuracy_real128(plan, time, x, y, z, vx, vy, vz, threads)
      class(accurate_orbit_type), intent(in) :: plan
      real(real64), intent(in) :: time(:)                              !! [s] (n)
      real(real128), intent(out), dimension(:) :: x, y, z              !! [m] (n)
      real(real128), intent(out), dimension(:), optional :: vx, vy, vz !! [m/s] (n), all three or none
      integer, intent(in), optional :: threads  !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      real(real64), allocatable :: placed(:, :)
      logical :: fit

      if (plan%is_beyond_double() .and. present(vx)) then
         call plan%locate_at_real128(real(time, real128), x, y, z, vx, vy, vz, threads=threads)
         return
      else if (plan%is_beyond_double()) then
         call plan%locate_at_real128(real(time, real128), x, y, z, threads=threads)
         return
      end if
      call check_sizes(size(time), fit, x, y, z, vx, vy, vz)
      if (.not. fit) return
      allocate (placed(size(time), 6))
      if (present(vx)) then
         call plan%orbit%locate(time, placed(:, 1), placed(:, 2), placed(:, 3), placed(:, 4), placed(:, 5), &
            placed(:, 6), threads=threads)
         vx = placed(:, 4)
         vy = placed(:, 5)
         vz = placed(:, 6)
      else
         call plan%orbit%locate(time, placed(:, 1), placed(:, 2), placed(:, 3), threads=threads)
      end if
      x = placed(:, 1)
      y = placed(:, 2)
      z = placed(:, 3)
   end subroutine locate_to_accuracy_real128

   !> The same at times in real128, where `is_beyond_double`.
   subroutine locate_at_real128(plan, time, x, y, z, vx, vy, vz, threads)
      class(accurate_orbit_type), intent(in) :: plan
      real(real128), intent(in) :: time(:)                             !! [s] (n)
      real(real128), intent(out), dimension(:) :: x, y, z              !! [m] (n)
      real(real128), intent(out), dimension(:), optional :: vx, vy, vz !! [m/s] (n), all three or none
      integer, intent(in), optional :: threads  !! Sharing a long array: 1 if absent; 0 as many as OpenMP offers
      logical :: fit

      if (present(vx) .or. present(vy) .or. present(vz)) then
         call check_sizes(size(time), fit, x, y, z, vx, vy, vz)
         if (.not. fit) return
         if (allocated(plan%fine)) then
            call locate_double_double(plan%fine, time, x, y, z, vx, vy, vz, threads=threads)
         else
            call plan%wide%locate(time, x, y, z, vx, vy, vz, threads=threads)
         end if
      else
         call check_sizes(size(time), fit, x, y, z)
         if (.not. fit) return
         if (allocated(plan%fine)) then
            call locate_double_double(plan%fine, time, x, y, z, threads=threads)
         else
            call plan%wide%locate(time, x, y, z, threads=threads)
         end if
      end if
   end subroutine locate_at_real128

   !> T, (16) [s], to the accuracy of the set-up.
   pure real(real128) function period_real128(plan) result(period)
      class(accurate_orbit_type), intent(in) :: plan

      if (allocated(plan%wide)) then
         period = plan%wide%period()
      else if (allocated(plan%fine)) then
         period = 2*((real(plan%fine%half(3), real128) + plan%fine%half(2)) + plan%fine%half(1))
      else
         period = plan%period()
      end if
   end function period_real128
#endif

   !> Whether places are computed with more digits than real64 has, and can be told with them.
   pure logical function is_beyond_double(plan) result(is_beyond)
      class(accurate_orbit_type), intent(in) :: plan

      is_beyond = allocated(plan%wide)
#ifndef KYVADLO_NO_REAL128
      is_beyond = is_beyond .or. allocated(plan%fine)
#endif
   end function is_beyond_double

   !> Takes the orbit from `plan%wide`, which was set up anew: of numbers that have more digits than real64.
   pure subroutine take_wide(plan)
      class(accurate_orbit_type), intent(inout) :: plan

#ifndef KYVADLO_NO_REAL128
      if (allocated(plan%fine)) call new_double_double(plan%fine, plan%wide)
#else
      if (allocated(plan%wide)) deallocate (plan%wide)
#endif
   end subroutine take_wide

   !> T, (16) [s], rounded to real64: of real128 accuracy in `plan%wide`.
   elemental real(real64) function period_to_accuracy(plan) result(period)
      class(accurate_orbit_type), intent(in) :: plan

      period = plan%orbit%period()
   end function period_to_accuracy

end module kyvadlo_accuracy
