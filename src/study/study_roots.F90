!> The turning heights from energy and momentum: roots of a cubic, and the gaps between them, by every method.
module kyvadlo_study_roots
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128
   use kyvadlo_orbit, only: orbit_type_real128
   use kyvadlo_status, only: error_type
   use kyvadlo_study_orbits, only: study_orbit_type
   use kyvadlo_study_record, only: add_cell, cell_type, failed, measure, measured, study_type, work_type
   use kyvadlo_study_roots_ours, only: roots_by_cubic, roots_by_energy
   use kyvadlo_study_roots_theirs, only: roots_by_cardano, roots_by_gsl, roots_by_lapack
   use kyvadlo_study_set_up, only: set_up_orbit, study_start_type
   implicit none
   private
   public :: ask_roots, study_cubic_type, built_in_cubics, cubic_of_orbit

   integer, parameter :: q = real128
   include 'study_cubics.inc'

   !> Cubics in a pass: all the same, which no compiler knows.
   integer, parameter :: copies = 8

   integer, parameter :: by_cubic_32 = 1, by_cubic_64 = 2, by_cubic_128 = 3, by_energy_32 = 4, by_energy_64 = 5, &
      by_energy_128 = 6, by_gsl = 7, by_lapack = 8, by_cardano = 9

   !> z**3 + b z**2 + c z + d, and the energy and momentum it was formed from, in units of l and g.
   type :: study_cubic_type
      character(len=64) :: name = ''
      logical :: has_energy = .false.
      real(real64) :: energy = 0, momentum = 0
      real(real64) :: coefficients(3) = 0         !! b, c, d
      ! z2, z1, z3, l + z2, l - z1, z1 - z2, z3 - l
      real(real128) :: of_cubic(7) = 0            !! Of exactly these coefficients
      real(real128) :: of_energy(7) = 0           !! Of exactly this energy and momentum
   end type study_cubic_type

   type, extends(work_type) :: roots_work_type
      integer :: method = 0
      logical :: asks_for_gaps = .false.
      type(study_cubic_type) :: cubics(copies)
      real(real64) :: values(7, copies) = 0 !! Results in single or double precision
      real(real128) :: quads(7, copies) = 0 !! Results in quad precision; 0 where the others are not
      real(real128) :: exact(7) = 0
   contains
      procedure :: pass => roots_pass
      procedure :: error => roots_error
   end type roots_work_type

contains

   !> The cubics of the built-in orbits, and two with nearly equal roots.
   subroutine built_in_cubics(cubics)
      type(study_cubic_type), allocatable, intent(out) :: cubics(:)
      integer :: i

      allocate (cubics(n_cubics))
      do i = 1, n_cubics
         cubics(i)%name = cubic_names(i)
         cubics(i)%energy = given(1, i)
         cubics(i)%momentum = given(2, i)
         cubics(i)%has_energy = any(abs(given(:2, i)) > 0)
         cubics(i)%coefficients = given(3:, i)
         cubics(i)%of_cubic = of_cubic(:, i)
         cubics(i)%of_energy = of_energy(:, i)
      end do
   end subroutine built_in_cubics

   !> The cubic of any orbit; its references are those of our real128 path.
   subroutine cubic_of_orbit(orbit, cubic, has_failed)
      type(study_orbit_type), intent(in) :: orbit
      type(study_cubic_type), intent(out) :: cubic
      logical, intent(out) :: has_failed           !! The rounded numbers are of no orbit, as of conical ones
      type(orbit_type_real128) :: exact
      type(error_type), allocatable :: error
      real(real128) :: energy, momentum

      associate (start => orbit%start)
         call set_up_orbit(study_start_type(1.0_real64, 1.0_real64, start%by_rises, start%first/start%length, &
            start%second/start%length), exact, error)
      end associate
      has_failed = allocated(error)
      if (has_failed) return
      cubic%name = orbit%name
      cubic%has_energy = .true.
      cubic%energy = real(exact%energy(), real64)
      cubic%momentum = real(exact%momentum(), real64)
      energy = cubic%energy
      momentum = cubic%momentum
      cubic%coefficients = real([-energy, -1.0_real128, energy - momentum**2/2], real64)
      call roots_by_cubic(cubic%coefficients, cubic%of_cubic, has_failed)
      call roots_by_energy(cubic%energy, cubic%momentum, cubic%of_energy, has_failed)
   end subroutine cubic_of_orbit

   !> Adds the cells of all methods for one cubic.
   subroutine ask_roots(study, cubic)
      type(study_type), intent(inout) :: study
      type(study_cubic_type), intent(in) :: cubic

      call one(by_cubic_32, 'ours', 'cubic_roots', 'real32')
      call one(by_cubic_64, 'ours', 'cubic_roots', 'real64')
      call one(by_cubic_128, 'ours', 'cubic_roots', 'real128')
      if (cubic%has_energy) then
         call one(by_energy_32, 'ours', 'new_orbit_from_energy', 'real32')
         call one(by_energy_64, 'ours', 'new_orbit_from_energy', 'real64')
         call one(by_energy_128, 'ours', 'new_orbit_from_energy', 'real128')
      end if
      call one(by_cardano, 'cardano', 'cosines', 'real64')
#ifdef KYVADLO_WITH_GSL
      call one(by_gsl, 'gsl_cubic', 'poly_solve_cubic', 'real64')
      call one(by_lapack, 'lapack_dgeev', 'companion', 'real64')
#endif

   contains

      !> One measurement, two cells: the error of the roots and that of the gaps.
      subroutine one(method, name, setting, kind)
         integer, intent(in) :: method
         character(len=*), intent(in) :: name, setting, kind
         type(roots_work_type) :: work
         type(cell_type) :: cell

         work%method = method
         work%results = copies
         work%cubics = cubic
         work%exact = cubic%of_cubic
         if (any(method == [by_energy_32, by_energy_64, by_energy_128])) work%exact = cubic%of_energy
         call measure(study, work, cell_type(question='roots', orbit=cubic%name, method=name, setting=setting, &
            kind=kind))
         cell = study%cells(study%count)
         cell%question = 'gaps'
         work%asks_for_gaps = .true.
         if (cell%outcome == measured) then
            cell%error = work%error()
            if (.not. ieee_is_finite(cell%error)) cell%outcome = failed
         end if
         call add_cell(study, cell)
      end subroutine one
   end subroutine ask_roots

   subroutine roots_pass(work)
      class(roots_work_type), intent(inout) :: work
      real(real64) :: roots(3)
      real(real32) :: singles(7)
      integer :: i

      do i = 1, copies
         associate (cubic => work%cubics(i))
            select case (work%method)
            case (by_cubic_32)
               call roots_by_cubic(cubic%coefficients, singles, work%has_failed)
               work%values(:, i) = singles
            case (by_cubic_64)
               call roots_by_cubic(cubic%coefficients, work%values(:, i), work%has_failed)
            case (by_cubic_128)
               call roots_by_cubic(cubic%coefficients, work%quads(:, i), work%has_failed)
            case (by_energy_32)
               call roots_by_energy(cubic%energy, cubic%momentum, singles, work%has_failed)
               work%values(:, i) = singles
            case (by_energy_64)
               call roots_by_energy(cubic%energy, cubic%momentum, work%values(:, i), work%has_failed)
            case (by_energy_128)
               call roots_by_energy(cubic%energy, cubic%momentum, work%quads(:, i), work%has_failed)
            case default
               select case (work%method)
               case (by_gsl)
                  call roots_by_gsl(cubic%coefficients, roots, work%has_failed)
               case (by_lapack)
                  call roots_by_lapack(cubic%coefficients, roots, work%has_failed)
               case default
                  call roots_by_cardano(cubic%coefficients, roots, work%has_failed)
               end select
               work%values(:, i) = [roots, 1 + roots(1), 1 - roots(2), roots(2) - roots(1), roots(3) - 1]
            end select
         end associate
      end do
      work%sink = work%sink + work%values(1, copies) + real(work%quads(1, copies), real64)
   end subroutine roots_pass

   !> Roots: relative to the length, or to a root beyond it. Gaps: relative to themselves, but to the length where they
   !> are 0.
   function roots_error(work) result(error)
      class(roots_work_type), intent(in) :: work
      real(real64) :: error
      real(real128) :: unit(7), errors(7)
      integer :: i, first, last

      unit(:3) = max(abs(work%exact(:3)), 1.0_real128)
      unit(4:) = merge(abs(work%exact(4:)), 1.0_real128, abs(work%exact(4:)) > 0)
      first = merge(4, 1, work%asks_for_gaps)
      last = merge(7, 3, work%asks_for_gaps)
      error = 0
      do i = 1, copies
         errors = abs(work%values(:, i) + work%quads(:, i) - work%exact)/unit
         error = max(error, real(maxval(errors(first:last)), real64))
         if (.not. all(ieee_is_finite(errors(first:last)))) error = ieee_value(error, ieee_quiet_nan)
         if (.not. error <= huge(error)) return
      end do
   end function roots_error

end module kyvadlo_study_roots
