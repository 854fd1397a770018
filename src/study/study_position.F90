!> The question where the bob is, put to every method that knows: in the first period, and in the 1000th.
module kyvadlo_study_position
   use kyvadlo_study_accuracy, only: ask_accuracies
   use kyvadlo_study_by_point, only: ask_jacobi_series, ask_carlson_point, ask_small_angle
   use kyvadlo_study_closed_real32, only: ask_closed_form_real32 => ask_closed_form
   use kyvadlo_study_closed_real64, only: ask_closed_form, ask_theta_terms
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_study_closed_real128, only: ask_closed_form_real128 => ask_closed_form, &
      ask_theta_terms_real128 => ask_theta_terms
#endif
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_study_integrators, only: ask_integrators
#endif
   use kyvadlo_study_orbits, only: study_orbit_type, one_period, thousand_periods
   use kyvadlo_study_record, only: study_type
   implicit none
   private
   public :: study_position

contains

   !> Adds the cells of the questions `position` and `position_1000` about one orbit. Error: the greatest distance from
   !> the reference, relative to the length. Evaluations: of the right side by integrators; of the others terms, or
   !> places.
   subroutine study_position(study, orbit)
      type(study_type), intent(inout) :: study
      type(study_orbit_type), intent(in) :: orbit
      integer :: span

      do span = one_period, thousand_periods
         call ask_closed_form_real32(study, orbit, span)
         call ask_closed_form(study, orbit, span)
         call ask_closed_form_real128(study, orbit, span)
         call ask_accuracies(study, orbit, span)
         call ask_theta_terms(study, orbit, span, 1)
         ! Up to four terms both kinds differ in their time only.
         call ask_theta_terms_real128(study, orbit, span, 4)
         call ask_jacobi_series(study, orbit, span)
         call ask_carlson_point(study, orbit, span)
         call ask_small_angle(study, orbit, span)
#ifdef KYVADLO_WITH_GSL
         call ask_integrators(study, orbit, span)
#endif
      end do
   end subroutine study_position

end module kyvadlo_study_position
