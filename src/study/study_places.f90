!> The position question of a study: where the bob is at `n_times` times, and how far from there a method puts it.
module kyvadlo_study_places
   use, intrinsic :: iso_fortran_env, only: real64, real128
   use kyvadlo_study_record, only: work_type, study_type, cell_type, measure
   use kyvadlo_study_orbits, only: study_orbit_type, n_times
   use kyvadlo_study_start, only: study_start_type
   implicit none
   private
   public :: places_type, ask, farthest, span_questions

   !> Names of the question: times in the first period, and in the 1000th.
   character(len=*), parameter :: span_questions(2) = [character(len=13) :: 'position', 'position_1000']

   !> A method that is asked for places. One pass is everything from the numbers of the start on, set-up included.
   type, abstract, extends(work_type) :: places_type
      type(study_start_type) :: start
      real(real64) :: times(n_times) = 0        !! [s] from an upper turning point, where the azimuth is 0
      real(real128) :: exact(3, n_times) = 0    !! Places [m]
   end type places_type

contains

   !> Gives a method the question about an orbit and measures the answer.
   subroutine ask(study, work, orbit, span, method, setting, kind)
      type(study_type), intent(inout) :: study
      class(places_type), intent(inout) :: work
      type(study_orbit_type), intent(in) :: orbit
      integer, intent(in) :: span                          !! `one_period` or `thousand_periods`
      character(len=*), intent(in) :: method, setting, kind

      work%start = orbit%start
      work%times = orbit%times(:, span)
      work%exact = orbit%positions(:, :, span)
      work%results = n_times
      call measure(study, work, cell_type(question=span_questions(span), orbit=orbit%name, method=method, &
         setting=setting, kind=kind))
   end subroutine ask

   !> The greatest distance of a place from where it should be, relative to the length.
   pure real(real64) function farthest(work, x, y, z)
      class(places_type), intent(in) :: work
      real(real128), intent(in), dimension(:) :: x, y, z   !! (n_times) [m]
      real(real128) :: distance(n_times)

      distance = sqrt((x - work%exact(1, :))**2 + (y - work%exact(2, :))**2 + (z - work%exact(3, :))**2)
      farthest = real(maxval(distance)/work%start%length, real64)
      ! maxval passes over NaN.
      if (.not. all(distance <= huge(distance))) farthest = real(sum(distance), real64)
   end function farthest

end module kyvadlo_study_places
