!> The rows of `kyvadlo-bench --functions`, and how a row is printed.
module kyvadlo_bench_rows
   use, intrinsic :: iso_fortran_env, only: real64
   use kyvadlo_bench_rivals, only: quoted, quoted_sine, rival_type
   use kyvadlo_function_ids
   implicit none
   private
   public :: row_type, rows, by_modulus, print_head, print_row

   type :: row_type
      integer :: id
      character(len=24) :: name
      character(len=8) :: arguments        !! How they are drawn
      integer :: parameter_at = 0          !! Which of them is the parameter m, for libraries that take k
      integer :: columns = 1               !! Values
      logical :: is_absolute = .false.     !! Values of order one with zeros: errors in epsilons, not ulps
   end type row_type

   type(row_type), parameter :: rows(*) = [ &
      row_type(id_rc, 'R_C', 'carlson'), &
      row_type(id_rf, 'R_F', 'carlson'), &
      row_type(id_rd, 'R_D', 'carlson'), &
      row_type(id_rj, 'R_J', 'carlson'), &
      row_type(id_rj, 'R_J, p < 0', 'p < 0'), &
      row_type(id_rg, 'R_G', 'carlson'), &
      row_type(id_k, 'K(m)', 'm', 1), &
      row_type(id_kc, 'K(1-m)', 'm', 0), &
      row_type(id_e, 'E(m)', 'm', 1), &
      row_type(id_d, 'D(m)', 'm', 1), &
      row_type(id_b, 'B(m)', 'm', 1), &
      row_type(id_nome, 'nome q(m)', 'm', 1), &
      row_type(id_pi, 'Pi(n, m)', 'n m', 2), &
      row_type(id_f, 'F(phi, m)', 'phi m', 2), &
      row_type(id_einc, 'E(phi, m)', 'phi m', 2), &
      row_type(id_dinc, 'D(phi, m)', 'phi m', 2), &
      row_type(id_piinc, 'Pi(n, phi, m)', 'n phi m', 3), &
      row_type(id_zeta, 'Jacobi zeta', 'phi m', 2, 1, .true.), &
      row_type(id_lambda, 'Heuman lambda', 'phi m', 2), &
      row_type(id_jacobi, 'sn cn dn (u, m)', 'u m', 2, 3, .true.), &
      row_type(id_jacobi_am, 'sn cn dn am (u, m)', 'u m', 2, 3, .true.), &
      row_type(id_jacobic, 'sn cn dn (u, 1-m)', 'u m', 0, 3, .true.), &
      row_type(id_set_up, 'sn cn dn, m set up', 'set-up', 2, 3, .true.), &
      row_type(id_theta, 'theta_3(v, q)', 'v q')]

contains

   !> Whether a library takes the modulus where we take the parameter.
   elemental function by_modulus(row, library) result(is_so)
      integer, intent(in) :: row, library  !! 1 GSL, 2 and 3 Boost
      logical :: is_so

      is_so = rows(row)%parameter_at > 0
      if (library == 1) is_so = is_so .and. all(rows(row)%id /= [id_jacobi, id_jacobi_am, id_set_up])
   end function by_modulus

   subroutine print_head(unit)
      integer, intent(in) :: unit

      write (unit, '(a)') &
         'Elliptic functions, double precision, one call at benign arguments. S is one scalar sine, measured', &
         'beside. Columns of other libraries are their time over ours: above 1, kyvadlo is faster. GSL and Boost', &
         '(without promotion, and as it comes) run here; Fukushima and the fastest of the rest are quoted in S from', &
         'another machine. Errors are the worst of some hundred arguments, each library held to its own, in ulps,', &
         'or in epsilons where marked *.', ''
      write (unit, '(a20,2a8,3a9,a11,2x,a20,3x,3a8)') 'function            ', 'ns', 'S', 'GSL', 'Boost np', 'Boost', &
         'Fukushima', 'fastest quoted      ', 'error', 'GSL', 'Boost np'
   end subroutine print_head

   subroutine print_row(unit, row, ours, sine, theirs, has, error)
      integer, intent(in) :: unit, row
      real(real64), intent(in) :: ours, sine, theirs(3)  !! ns
      logical, intent(in) :: has(3)                      !! Which of theirs were measured
      real(real64), intent(in) :: error(0:2)             !! Ours, GSL, Boost without promotion; < 0: none
      character(len=9) :: ratio(3)
      character(len=8) :: errors(0:2)
      character(len=20) :: best
      character(len=11) :: fukushima
      type(rival_type) :: rival
      real(real64) :: ours_in_sines
      integer :: i

      ours_in_sines = ours/sine
      ratio = '-'
      do i = 1, 3
         if (has(i)) write (ratio(i), '(f9.2)') theirs(i)/ours
      end do
      errors = '-'
      do i = 0, 2
         if (error(i) >= 0) write (errors(i), '(f8.2)') min(error(i), 99999.0_real64)
      end do
      fukushima = '-'
      rival = quoted(rows(row)%name, 'Fukushima')
      if (rival%ns > 0) write (fukushima, '(f11.2)') rival%ns/quoted_sine/ours_in_sines
      best = '-'
      rival = quoted(rows(row)%name)
      if (rival%ns > 0) then
         write (best, '(f5.2)') rival%ns/quoted_sine/ours_in_sines
         best = trim(best)//' '//rival%library
      end if
      write (unit, '(a20,f8.1,f8.2,3a9,a11,2x,a20,3x,3a8,a)') rows(row)%name(:20), ours, ours_in_sines, &
         adjustr(ratio), adjustr(fukushima), best, adjustr(errors), merge(' *', '  ', rows(row)%is_absolute)
   end subroutine print_row

end module kyvadlo_bench_rows
