!> What accuracy is promised: for each part of each reference file `ulp` units plus `slack` times the condition of the row.
module promises
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: promise_type, promise_of, label_of, title_of, is_elliptic

   type :: promise_type
      real(real64) :: ulp = 0    !! Units in the last place (for positions eps l, for velocities eps v_max)
      real(real64) :: slack = 0  !! Times the change that half an ulp of each argument makes
      real(real64) :: eps = 0    !! Besides, in units of epsilon
   end type promise_type

contains

   logical function is_elliptic(question)
      character(len=*), intent(in) :: question

      select case (question(:index(question//'_', '_') - 1))
      case ('turning', 'orbit', 'azimuth', 'position', 'state', 'passage')
         is_elliptic = .false.
      case default
         is_elliptic = .true.
      end select
   end function is_elliptic

   !> The bound for a part of the answers. Conditions count where the value of the function is ill-conditioned by nature.
   type(promise_type) function promise_of(question, part, set) result(promise)
      character(len=*), intent(in) :: question, set
      integer, intent(in) :: part

      select case (question)
      case ('carlson_rc', 'carlson_rf', 'carlson_rg', 'complete', 'complete_c')
         promise = promise_type(4)
      case ('carlson_rd')
         promise = promise_type(5)
      case ('carlson_rj')
         promise = promise_type(6)
         if (index(set, 'negative') == 1) promise%slack = 1
      case ('nome', 'nome_c')
         promise = promise_type(6)
      case ('cubic')
         promise = promise_type(4, slack=1)
         if (part == 1 .or. index(set, 'exact_') == 1) promise%slack = 0
         if (part == 1) promise%ulp = 0
      case ('turning_energy', 'turning_top', 'turning_bottom')
         promise = promise_type(4, slack=1)
      case ('orbit_heights', 'orbit_gaps', 'orbit_rises')
         promise = promise_type(4)
         ! A is measured in ulps of itself: where it is small (near rotation, energetic) 64 are promised.
         if (part == 5) promise%ulp = 6
         if (part == 6) promise%ulp = 64
      case ('azimuth_heights', 'azimuth_gaps', 'azimuth_rises')
         promise = promise_type(8, slack=1, eps=8)
      case ('position_heights', 'position_gaps', 'position_rises')
         promise = promise_type(merge(8, 16, mod(part, 2) == 1)*merge(1, 4, part <= 2))
      case ('state')
         promise = promise_type(16, slack=8)
      case ('passage_height', 'passage_azimuth')
         promise = promise_type(8, slack=1)
      case default
         promise = promise_type(8, slack=4)
      end select
   end function promise_of

   !> The name of a part of the answer.
   function label_of(question, part) result(label)
      character(len=*), intent(in) :: question
      integer, intent(in) :: part
      character(len=:), allocatable :: label

      select case (question)
      case ('carlson_rc', 'carlson_rf', 'carlson_rd', 'carlson_rj', 'carlson_rg')
         label = 'R'//achar(iachar(question(10:10)) - 32)
      case ('complete', 'complete_c')
         label = word('K E D B')
      case ('complete_pi', 'complete_pi_c')
         label = 'Pi'
      case ('incomplete', 'incomplete_c')
         label = word('F E D B')
      case ('incomplete_pi', 'incomplete_pi_c')
         label = 'Pi'
      case ('nome', 'nome_c')
         label = 'q'
      case ('bulirsch_cel', 'bulirsch_el1', 'bulirsch_el2', 'bulirsch_el3')
         label = question(10:)
      case ('zeta', 'zeta_c')
         label = 'Z'
      case ('lambda', 'lambda_c')
         label = 'Lambda_0'
      case ('jacobi', 'jacobic')
         label = word('sn cn dn am')
      case ('ratios', 'ratiosc')
         label = word('ns nc nd sc cs sd ds cd dc')
      case ('theta', 'theta_complex')
         label = word('theta theta''')
      case ('cubic')
         label = word('count root_1 root_2 root_3')
      case ('turning_energy', 'turning_top', 'turning_bottom')
         label = word('z2 z1 z3 l+z2 l-z1 z1-z2 z3-z1 z3-l')
      case ('orbit_heights', 'orbit_gaps', 'orbit_rises')
         label = word('T k k'' K q A phi(T) lambda*T')
      case ('azimuth_heights', 'azimuth_gaps', 'azimuth_rises')
         label = 'phi'
      case ('position_heights', 'position_gaps', 'position_rises')
         label = trim(merge('position', 'velocity', mod(part, 2) == 1))//merge(' to 1000 T', ' to 1e9 T ', part <= 2)
      case ('state')
         label = word('position velocity')
      case ('passage_height', 'passage_azimuth')
         label = 't'
      case default
         label = '?'
      end select
      label = trim(label)

   contains

      function word(words)
         character(len=*), intent(in) :: words
         character(len=:), allocatable :: word
         integer :: i, start

         word = words//' '
         do i = 2, part
            start = index(word, ' ') + 1
            word = word(start:)
         end do
         word = word(:index(word, ' ') - 1)
      end function word
   end function label_of

   !> The arguments of a question, in words.
   function title_of(question) result(title)
      character(len=*), intent(in) :: question
      character(len=:), allocatable :: title

      select case (question)
      case ('carlson_rc')
         title = 'RC(x, y)'
      case ('carlson_rf')
         title = 'RF(x, y, z)'
      case ('carlson_rd')
         title = 'RD(x, y, z)'
      case ('carlson_rj')
         title = 'RJ(x, y, z, p)'
      case ('carlson_rg')
         title = 'RG(x, y, z)'
      case ('complete')
         title = 'Complete integrals K, E, D, B of the parameter m'
      case ('complete_c')
         title = 'Complete integrals K, E, D, B of the complementary parameter 1-m'
      case ('complete_pi')
         title = 'Complete Pi(n, m)'
      case ('complete_pi_c')
         title = 'Complete Pi(n) of 1-m'
      case ('incomplete')
         title = 'F, E, D, B of amplitude phi and parameter m'
      case ('incomplete_c')
         title = 'F, E, D, B of amplitude phi and 1-m'
      case ('incomplete_pi')
         title = 'Pi(n, phi, m)'
      case ('incomplete_pi_c')
         title = 'Pi(n, phi) of 1-m'
      case ('bulirsch_cel')
         title = 'Bulirsch''s cel(kc, p, a, b)'
      case ('bulirsch_el1')
         title = 'Bulirsch''s el1(x, kc)'
      case ('bulirsch_el2')
         title = 'Bulirsch''s el2(x, kc, a, b)'
      case ('bulirsch_el3')
         title = 'Bulirsch''s el3(x, kc, p)'
      case ('zeta')
         title = 'Jacobi''s zeta function Z(u, m)'
      case ('zeta_c')
         title = 'Jacobi''s zeta function Z(u) of 1-m'
      case ('lambda')
         title = 'Heuman''s lambda function Lambda_0(phi, m)'
      case ('lambda_c')
         title = 'Heuman''s lambda function Lambda_0(phi) of 1-m'
      case ('nome')
         title = 'Nome of the parameter m'
      case ('nome_c')
         title = 'Nome of the complementary parameter 1-m'
      case ('jacobi')
         title = 'sn, cn, dn, am of argument u and parameter m'
      case ('jacobic')
         title = 'sn, cn, dn, am of argument u and 1-m'
      case ('ratios')
         title = 'The other nine of the twelve Jacobian functions, of u and m'
      case ('ratiosc')
         title = 'The other nine of the twelve Jacobian functions, of u and 1-m'
      case ('theta')
         title = 'theta_1 ... theta_4 of real v, and their derivatives'
      case ('theta_complex')
         title = 'theta_1 ... theta_4 of complex v, and their derivatives (ulps of the modulus)'
      case ('cubic')
         title = 'Distinct real roots of a cubic'
      case ('turning_energy')
         title = 'Turning heights and gaps from c1 and c2'
      case ('turning_top')
         title = 'Turning heights and gaps from c1 - g l and c2'
      case ('turning_bottom')
         title = 'Turning heights and gaps from c1 + g l and c2'
      case ('orbit_heights')
         title = 'Constants of an orbit from z1, z2'
      case ('orbit_gaps')
         title = 'Constants of an orbit from l-z1, l+z2'
      case ('orbit_rises')
         title = 'Constants of an orbit from l+z1, l+z2'
      case ('azimuth_heights')
         title = 'phi(t) from z1, z2'
      case ('azimuth_gaps')
         title = 'phi(t) from l-z1, l+z2'
      case ('azimuth_rises')
         title = 'phi(t) from l+z1, l+z2'
      case ('position_heights')
         title = 'Position (in eps l) and velocity (in eps v_max) from z1, z2'
      case ('position_gaps')
         title = 'Position (in eps l) and velocity (in eps v_max) from l-z1, l+z2'
      case ('position_rises')
         title = 'Position (in eps l) and velocity (in eps v_max) from l+z1, l+z2'
      case ('state')
         title = 'Position (in eps l) and velocity (in eps v_max) from a position and a velocity'
      case ('passage_height')
         title = 'First passage through a height (in eps T)'
      case ('passage_azimuth')
         title = 'First passage through an azimuth (in eps T)'
      case default
         title = question
      end select
   end function title_of

end module promises
