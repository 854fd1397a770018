!> The position question put to the closed form with a stated accuracy: is it kept, and what does it save?
module kyvadlo_study_accuracy
   use, intrinsic :: iso_fortran_env, only: real64, real128
   use kyvadlo_accuracy, only: accuracy_finest_double, accurate_orbit_type, new_orbit_to_accuracy
   use kyvadlo_start_kinds, only: start_gaps, start_rises
   use kyvadlo_status, only: error_type
   use kyvadlo_study_orbits, only: study_orbit_type, n_times
   use kyvadlo_study_places, only: places_type, ask, farthest
   use kyvadlo_study_record, only: study_type
   use kyvadlo_study_start, only: study_start_type
   implicit none
   private
   public :: ask_accuracies, set_up_to_accuracy, accuracies, accuracy_names

   !> What is asked for, and what it is called; a quick study asks for every second one, 1e-6 first.
   real(real64), parameter :: accuracies(8) = [1e-3_real64, 1e-6_real64, 1e-9_real64, 1e-12_real64, 1e-15_real64, &
      1e-20_real64, 1e-25_real64, 1e-30_real64]
   character(len=5), parameter :: accuracy_names(8) = [character(len=5) :: '1e-3', '1e-6', '1e-9', '1e-12', '1e-15', &
      '1e-20', '1e-25', '1e-30']

   type, extends(places_type) :: accurate_type
      type(accurate_orbit_type) :: orbit
      real(real64) :: accuracy = 0
      logical :: is_set_up = .false.     !! The orbit is given: the set-up is not counted
      real(real64), dimension(n_times) :: x = 0, y = 0, z = 0
      real(real128), dimension(n_times) :: x_wide = 0, y_wide = 0, z_wide = 0
   contains
      procedure :: pass => accurate_pass
      procedure :: error => accurate_error
   end type accurate_type

contains

   !> Cells of the method `closed_form`, settings `accuracy 1e-6` (set-up counted) and `to 1e-6 after set-up`. The span
   !> is that of the times asked for; the kind is what was chosen.
   subroutine ask_accuracies(study, orbit, span)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span
      type(accurate_type), allocatable :: work
      integer :: i

      allocate (work)
      work%start = orbit%start
      work%times = orbit%times(:, span)
      do i = merge(2, 1, study%quick), size(accuracies), merge(2, 1, study%quick)
         work%accuracy = accuracies(i)
         call set_up(work)
         work%is_set_up = .false.
         call ask(study, work, orbit, span, 'closed_form', 'accuracy '//trim(accuracy_names(i)), work%orbit%kind_text())
         work%is_set_up = .true.
         call ask(study, work, orbit, span, 'closed_form', 'to '//trim(accuracy_names(i))//' after set-up', &
            work%orbit%kind_text())
      end do
   end subroutine ask_accuracies

   subroutine accurate_pass(work)
      class(accurate_type), intent(inout) :: work

      work%evaluations = n_times
      if (.not. work%is_set_up) call set_up(work)
      if (work%accuracy < accuracy_finest_double) then
         call work%orbit%locate(work%times, work%x_wide, work%y_wide, work%z_wide)
         work%sink = work%sink + real(sum(work%x_wide) + sum(work%y_wide) + sum(work%z_wide), real64)
      else
         call work%orbit%locate(work%times, work%x, work%y, work%z)
         work%sink = work%sink + (sum(work%x) + sum(work%y) + sum(work%z))
      end if
   end subroutine accurate_pass

   function accurate_error(work) result(error)
      class(accurate_type), intent(in) :: work
      real(real64) :: error

      if (work%accuracy < accuracy_finest_double) then
         error = farthest(work, work%x_wide, work%y_wide, work%z_wide)
      else
         error = farthest(work, real(work%x, real128), real(work%y, real128), real(work%z, real128))
      end if
   end function accurate_error

   subroutine set_up(work)
      type(accurate_type), intent(inout) :: work

      call set_up_to_accuracy(work%start, work%accuracy, maxval(abs(work%times)), work%orbit, work%has_failed)
   end subroutine set_up

   !> The orbit of a start that keeps an accuracy for |time| <= span.
   subroutine set_up_to_accuracy(start, accuracy, span, orbit, has_failed)
      type(study_start_type), intent(in) :: start
      real(real64), intent(in) :: accuracy, span
      type(accurate_orbit_type), intent(out) :: orbit
      logical, intent(out) :: has_failed
      type(error_type), allocatable :: error

      call new_orbit_to_accuracy(orbit, merge(start_rises, start_gaps, start%by_rises), start%length, start%gravity, &
         [start%first], [start%second], accuracy, span, error)
      has_failed = allocated(error)
   end subroutine set_up_to_accuracy
end module kyvadlo_study_accuracy
