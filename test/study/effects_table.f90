!> Prints the table of doc/effects.md: what every effect costs beside the closed form and beside GSL's own driver, and
!> how far the motion is from an independent integration in quadruple precision. Fails if an error is above what the
!> page promises.
!>
!>    effects_table          measure and print
!>    effects_table quick    a few passes, errors alone decide
program effects_table
   use, intrinsic :: iso_fortran_env, only: output_unit, real64
   use kyvadlo, error_type => kyvadlo_error_type
   use kyvadlo_effects
   use kyvadlo_motion_tables
   use effects_race
   use study_pages, only: write_machine
   implicit none
   character(len=16) :: word
   logical :: holds

   call get_command_argument(1, word)
   holds = .true.
   call run(merge(1, 41, word == 'quick'))
   flush (output_unit)
   if (.not. holds) error stop 'effects_table: an error is above its bound'

contains

   subroutine run(passes)
      integer, intent(in) :: passes
      type(effects_type) :: effects
      type(error_type), allocatable :: error
      real(real64) :: closed
      real(real64), parameter :: knots(9) = [0.0_real64, 5.0_real64, 10.0_real64, 15.0_real64, 25.0_real64, &
         30.0_real64, 40.0_real64, 50.0_real64, 60.0_real64]
      real(real64) :: points(3, 9)

      call write_machine('cmake --build build/release --target effects_page')
      write (output_unit, &
         '(a)') '| effect | path | ns per sample, close | of closed form | of GSL | ns per sample, far '// &
         '| of GSL | error | of GSL |', '|---|---|---|---|---|---|---|---|---|'
      call closed_form(passes, closed)
      effects = effects_type()
      call row('none, integrated all the same', effects, rod, passes, closed)
      effects%linear_drag = 0.02_real64
      effects%quadratic_drag = 0.01_real64
      call row('air', effects, air, passes, closed)
      effects%wind = [2.0_real64, 1.0_real64, 0.0_real64]
      call row('air and wind', effects, air, passes, closed)
      call row('air and wind, works asked for', effects, air, passes, closed, with_work=.true.)
      effects = effects_type(turn_rate=earth_turn_rate(48.85_real64, 7.292115e-5_real64))
      call row('rotation of the Earth', effects, earth, passes, closed)
      effects = effects_type(pivot_amplitude=[0.02_real64, 0.0_real64, 0.0_real64], &
         pivot_frequency=[0.7_real64, 0.0_real64, 0.0_real64])
      call row('moving pivot, harmonic', effects, shaken, passes, closed)
      points = 0
      points(1, :) = 0.05_real64*[0, 1, 3, 2, -1, 0, 2, 1, 0]
      effects = effects_type()
      call new_pivot_table(effects, knots, points, error)
      call row('moving pivot, table', effects, any_kind, passes, closed)
      call row('elastic', effects_type(stiffness=1000.0_real64), spring, passes, closed)
      call row('anisotropic support', effects_type(extra_length=[0.02_real64, 0.01_real64]), any_kind, passes, closed)
      call row('buoyancy beside air', effects_type(linear_drag=0.02_real64, density_ratio=0.125_real64, &
         added_mass=0.5_real64), any_kind, passes, closed)
      call row('string beside air, taut', effects_type(is_string=.true., linear_drag=0.02_real64, &
         quadratic_drag=0.01_real64), air, passes, closed)
      effects = effects_type(linear_drag=0.02_real64, quadratic_drag=0.01_real64, &
         wind=[2.0_real64, 1.0_real64, 0.0_real64], turn_rate=earth_turn_rate(48.85_real64, 7.292115e-5_real64), &
         pivot_amplitude=[0.02_real64, 0.0_real64, 0.0_real64], pivot_frequency=[0.7_real64, 0.0_real64, 0.0_real64], &
         extra_length=[0.02_real64, 0.01_real64], density_ratio=0.125_real64, added_mass=0.5_real64)
      call row('all but elastic', effects, any_kind, passes, closed)
      effects%stiffness = 1000
      call row('all', effects, any_kind, passes, closed)
   end subroutine run

   !> What the closed form costs, alone, in a fluid and seen from a turning frame.
   subroutine closed_form(passes, alone)
      integer, intent(in) :: passes
      real(real64), intent(out) :: alone
      real(real64) :: times(2), worst
      character(len=40), parameter :: names(3) = [character(len=40) :: 'none', 'buoyancy', 'turning frame']
      integer :: kind

      do kind = 1, 3
         call time_closed_form(kind, passes, times, worst)
         if (kind == 1) alone = times(1)
         holds = holds .and. worst <= bound
         write (output_unit, '(3a,f8.1,a,f8.2,a,f8.1,a,es8.1,a)') '| ', trim(names(kind)), ' | closed form |', &
            times(1), ' |', times(1)/alone, ' | |', times(2), ' | |', worst, ' | |'
      end do
   end subroutine closed_form

   subroutine row(name, effects, which, passes, closed, with_work)
      character(len=*), intent(in) :: name
      type(effects_type), intent(in) :: effects
      integer, intent(in) :: which, passes
      real(real64), intent(in) :: closed    !! Cost of a sample of the closed form [ns]
      logical, intent(in), optional :: with_work
      real(real64) :: ours(2), theirs(2), worst, worst_of_gsl
      logical :: works

      works = .false.
      if (present(with_work)) works = with_work
      call race(effects, which, works, passes, ours, theirs, worst, worst_of_gsl)
      holds = holds .and. worst <= bound
      write (output_unit, '(3a,f8.1,a,f8.2,a,f8.2,a,f8.1,a,f8.2,a,es8.1,a,es8.1,a)') '| ', name, ' | integrated |', &
         ours(1), ' |', ours(1)/closed, ' |', ours(1)/theirs(1), ' |', ours(2), ' |', ours(2)/theirs(2), ' |', worst, &
         ' |', worst_of_gsl, ' |'
   end subroutine row

end program effects_table
