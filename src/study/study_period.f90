!> How long is T, the time from lowest to lowest point: every method, its error and its time.
module kyvadlo_study_period
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128, real32
   use kyvadlo_accuracy, only: accurate_orbit_type
   use kyvadlo_motion_kinds, only: motion_plane_libration
   use kyvadlo_orbit, only: orbit_type, orbit_type_real32, orbit_type_real128
   use kyvadlo_periods, only: orbit_period_from_gaps, orbits_period_from_gaps
   use kyvadlo_status, only: error_type
   use kyvadlo_study_accuracy, only: accuracies, accuracy_names, set_up_to_accuracy
   use kyvadlo_study_period_gsl, only: free_table, gauss_period, gsl_k_period, gsl_table_type, has_gsl, new_table, &
      qag_period
   use kyvadlo_study_period_methods
   use kyvadlo_text, only: integer_length, integer_text
   use kyvadlo_study_orbits, only: study_orbit_type
   use kyvadlo_study_record, only: cell_type, measure, study_type, work_type
   use kyvadlo_study_set_up, only: set_up_orbit, study_start_type
   implicit none
   private
   public :: ask_period

   !> Orbits in a pass: all the same, which no compiler knows. Whole groups of the batch kernels.
   integer, parameter :: copies = 64

   integer, parameter :: by_set_up_32 = 1, by_set_up_64 = 2, by_set_up_128 = 3, by_gaps = 4, by_agm = 5, &
      by_carlson = 6, by_gsl = 7, by_gauss = 8, by_qag = 9, by_amplitude = 10, by_sine = 11, by_ellipse = 12, &
      by_gaps_of_many = 13, by_accuracy = 14

   type, extends(work_type) :: period_work_type
      integer :: method = 0
      integer :: count = 0                  !! Of iterations, terms, nodes; mode of GSL's integrals
      real(real64) :: tolerance = 0         !! Of the adaptive quadrature; the accuracy asked for
      type(gsl_table_type) :: table
      type(study_start_type) :: starts(copies)
      real(real64) :: found(copies) = 0     !! Results in single or double precision
      real(real128) :: quads(copies) = 0    !! Results in quad precision; 0 where the others are not
      real(real128) :: exact = 0
   contains
      procedure :: pass => period_pass
      procedure :: error => period_error
   end type period_work_type

contains

   !> Adds the cells of all methods for one orbit.
   subroutine ask_period(study, orbit)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, parameter :: levels(*) = [1, 2, 3, 4, 5, 6, 7]
      integer, parameter :: duplications(*) = [1, 2, 3, 4, 5, 6, 7, 8, 10, 12]
      ! Rules that GSL has tables of; others it computes, that of 48 nodes to 12 digits only.
      integer, parameter :: nodes(*) = [4, 6, 8, 10, 12, 16, 20, 32, 64]
      integer, parameter :: sine_terms(*) = [1, 2, 4, 8, 16, 32, 64, 128]
      ! GSL refuses a relative tolerance below 50 epsilon, 1.1e-14.
      integer, parameter :: decades(*) = [3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13]
      character(len=6), parameter :: modes(0:2) = ['double', 'single', 'approx']
      type(accurate_orbit_type) :: chosen
      character(len=8) :: tolerance_text
      logical :: has_failed
      integer :: i

      call one(by_set_up_32, 0, 'closed_form', 'set-up', 'real32')
      call one(by_set_up_64, 0, 'closed_form', 'set-up', 'real64')
      call one(by_gaps, 0, 'closed_form', 'orbit_period_from_gaps', 'real64')
      call one(by_gaps_of_many, 0, 'closed_form', 'orbits_period_from_gaps', 'real64')
      call one(by_set_up_128, 0, 'closed_form', 'set-up', 'real128')
      ! By the set-up of an orbit to an accuracy; of no span, as nothing is asked but T.
      do i = merge(2, 1, study%quick), size(accuracies), merge(2, 1, study%quick)
         call set_up_to_accuracy(orbit%start, accuracies(i), 0.0_real64, chosen, has_failed)
         call one(by_accuracy, i, 'closed_form', 'accuracy '//trim(accuracy_names(i)), period_kind(chosen))
      end do
      do i = 1, size(levels)
         if (study%quick .and. mod(i, 2) == 0) cycle
         call one(by_agm, levels(i), 'agm_terms', numbered('', levels(i)), 'real64')
      end do
      do i = 1, size(duplications)
         if (study%quick .and. mod(i, 3) /= 1) cycle
         call one(by_carlson, duplications(i), 'carlson_early', numbered('', duplications(i)), 'real64')
      end do
      if (has_gsl) then
         do i = 2, 0, -1
            call one(by_gsl, i, 'gsl_ellint', 'K '//modes(i), 'real64')
         end do
         do i = 1, size(nodes)
            if (study%quick .and. mod(i, 4) /= 1) cycle
            call one(by_gauss, nodes(i), 'gauss_legendre', numbered('', nodes(i)), 'real64')
         end do
         do i = 1, size(decades)
            if (study%quick .and. mod(i, 4) /= 3) cycle
            write (tolerance_text, '("1e-",i0)') decades(i)
            call one(by_qag, decades(i), 'gsl_qag', tolerance_text, 'real64')
         end do
      end if
      do i = 0, 2
         call one(by_ellipse, i, 'series', numbered('ellipse ', i), 'real64')
      end do
      if (orbit%orbit%motion /= motion_plane_libration) return
      do i = 0, 6
         if (study%quick .and. mod(i, 3) /= 0) cycle
         call one(by_amplitude, i, 'series', numbered('amplitude ', i), 'real64')
      end do
      do i = 1, size(sine_terms)
         if (study%quick .and. mod(i, 3) /= 1) cycle
         call one(by_sine, sine_terms(i), 'series', numbered('sine ', sine_terms(i)), 'real64')
      end do

   contains

      subroutine one(method, count, name, setting, kind)
         integer, intent(in) :: method, count
         character(len=*), intent(in) :: name, setting, kind
         type(period_work_type) :: work
         type(cell_type) :: cell

         work%method = method
         work%count = count
         work%results = copies
         work%starts = orbit%start
         work%exact = orbit%period
         if (method == by_gauss) call new_table(work%table, count)
         if (method == by_qag) then
            call new_table(work%table, 0)
            work%tolerance = 10.0_real64**(-count)
         end if
         if (method == by_accuracy) work%tolerance = accuracies(count)
         cell = cell_type(question='period', orbit=orbit%name, method=name, setting=setting, kind=kind)
         call measure(study, work, cell)
         call free_table(work%table)
      end subroutine one
   end subroutine ask_period

   !> The kind of T: places in single precision have theirs from double.
   function period_kind(orbit) result(name)
      type(accurate_orbit_type), intent(in) :: orbit
      character(len=7) :: name

      name = merge('real128', 'real64 ', orbit%is_beyond_double())
   end function period_kind

   !> A setting: a word, which may be empty, and a number.
   function numbered(word, number) result(text)
      character(len=*), intent(in) :: word
      integer, intent(in) :: number
      character(len=len(word) + integer_length(number)) :: text

      text = word//integer_text(number)
   end function numbered

   subroutine period_pass(work)
      class(period_work_type), intent(inout) :: work
      type(orbit_type_real32) :: single
      type(orbit_type) :: double
      type(orbit_type_real128) :: quad
      type(accurate_orbit_type) :: accurate
      type(error_type), allocatable :: error
      real(real64) :: gaps(copies, 2)
      integer(int64) :: evaluations
      integer :: i

      work%evaluations = 0
      select case (work%method)
      case (by_set_up_32)
         do i = 1, copies
            call set_up_orbit(work%starts(i), single, error)
            work%found(i) = single%period()
         end do
      case (by_set_up_64)
         do i = 1, copies
            call set_up_orbit(work%starts(i), double, error)
            work%found(i) = double%period()
         end do
      case (by_set_up_128)
         do i = 1, copies
            call set_up_orbit(work%starts(i), quad, error)
            work%quads(i) = quad%period()
         end do
      case (by_accuracy)
         do i = 1, copies
            call set_up_to_accuracy(work%starts(i), work%tolerance, 0.0_real64, accurate, work%has_failed)
            if (accurate%is_beyond_double()) then
               work%quads(i) = accurate%period_real128()
            else
               work%found(i) = accurate%period()
            end if
         end do
      case (by_gaps_of_many)
         do i = 1, copies
            gaps(i, 1) = upper_gap(work%starts(i))
            gaps(i, 2) = work%starts(i)%second
         end do
         call orbits_period_from_gaps(work%starts(1)%length, work%starts(1)%gravity, gaps(:, 1), gaps(:, 2), work%found)
      case default
         do i = 1, copies
            associate (start => work%starts(i))
               evaluations = work%count
               select case (work%method)
               case (by_gaps)
                  work%found(i) = orbit_period_from_gaps(start%length, start%gravity, upper_gap(start), start%second)
               case (by_agm)
                  work%found(i) = agm_period(start, work%count)
               case (by_carlson)
                  work%found(i) = carlson_period(start, work%count)
               case (by_gsl)
                  work%found(i) = gsl_k_period(unit_time(start), swings_of(start), work%count)
                  evaluations = 0
               case (by_gauss)
                  work%found(i) = gauss_period(unit_time(start), swings_of(start), work%table)
               case (by_qag)
                  call qag_period(unit_time(start), swings_of(start), work%table, work%tolerance, work%found(i), &
                     evaluations, work%has_failed)
               case (by_amplitude)
                  work%found(i) = amplitude_series(start, work%count)
               case (by_sine)
                  work%found(i) = sine_series(start, work%count)
               case (by_ellipse)
                  work%found(i) = ellipse_series(start, work%count)
               end select
            end associate
         end do
         work%evaluations = evaluations
      end select
      work%sink = work%sink + work%found(copies) + real(work%quads(copies), real64)
   end subroutine period_pass

   pure real(real64) function upper_gap(start)
      type(study_start_type), intent(in) :: start

      upper_gap = merge(2*start%length - start%first, start%first, start%by_rises)
   end function upper_gap

   !> Relative.
   function period_error(work) result(error)
      class(period_work_type), intent(in) :: work
      real(real64) :: error

      error = real(maxval(abs((work%found + work%quads)/work%exact - 1)), real64)
      if (.not. all(ieee_is_finite(work%found + work%quads))) error = ieee_value(error, ieee_quiet_nan)
   end function period_error
end module kyvadlo_study_period
