!> The requests that `kyvadlo eval` answers: names, arguments, results and domains, in words. What they compute stands
!> in `eval.inc`.
module kyvadlo_eval_requests
   implicit none
   private
   public :: request_type, requests, request_index, argument_count, most_arguments

   type :: request_type
      character(len=28) :: name
      character(len=28) :: arguments   !! Names, separated by one blank
      character(len=48) :: results     !! Symbols, separated by one blank, or words
      character(len=96) :: domain      !! The rule whose breach gives NaN
   end type request_type

   !> No request takes more arguments.
   integer, parameter :: most_arguments = 9


   character(len=*), parameter :: orbit_results = "T k k' K q A phi(T) lambda*T"
   character(len=*), parameter :: incomplete_domain = 'm <= 1, or m sin(phi)^2 <= 1 from 0 to phi'
   character(len=*), parameter :: azimuth_domain = 'a bob at rest has no azimuth'
   character(len=*), parameter :: place_results = 'x y z vx vy vz'
   character(len=*), parameter :: period_slopes = 'dT/dl dT/dg dT/da dT/db, then of lambda*T'
   character(len=*), parameter :: position_slopes = '30: rows x y z vx vy vz, columns l g a b t'
   character(len=*), parameter :: slope_domain = 'NaN where there is no derivative'
   character(len=*), parameter :: turning_results = 'z2 z1 z3 l+z2 l-z1 z1-z2 z3-z1 z3-l'

   type(request_type), parameter :: requests(*) = [ &
      request_type('rc', 'x y', 'R_C', 'x >= 0'), &
      request_type('rf', 'x y z', 'R_F', 'x, y, z >= 0'), &
      request_type('rd', 'x y z', 'R_D', 'x, y, z >= 0'), &
      request_type('rj', 'x y z p', 'R_J', 'x, y, z >= 0'), &
      request_type('rg', 'x y z', 'R_G', 'x, y, z >= 0'), &
      request_type('K', 'm', 'K', 'm <= 1'), &
      request_type('E', 'm', 'E', 'm <= 1'), &
      request_type('Kc', 'mc', 'K', 'mc >= 0'), &
      request_type('Ec', 'mc', 'E', 'mc >= 0'), &
      request_type('D', 'm', 'D', 'm <= 1'), &
      request_type('Dc', 'mc', 'D', 'mc >= 0'), &
      request_type('B', 'm', 'B', 'm <= 1'), &
      request_type('Bc', 'mc', 'B', 'mc >= 0'), &
      request_type('Pi', 'n m', 'Pi', 'm <= 1'), &
      request_type('Pic', 'n mc', 'Pi', 'mc >= 0'), &
      request_type('F', 'phi m', 'F', incomplete_domain), &
      request_type('Fc', 'phi mc', 'F', incomplete_domain), &
      request_type('Einc', 'phi m', 'E', incomplete_domain), &
      request_type('Eincc', 'phi mc', 'E', incomplete_domain), &
      request_type('Dinc', 'phi m', 'D', incomplete_domain), &
      request_type('Dincc', 'phi mc', 'D', incomplete_domain), &
      request_type('Binc', 'phi m', 'B', incomplete_domain), &
      request_type('Bincc', 'phi mc', 'B', incomplete_domain), &
      request_type('Piinc', 'n phi m', 'Pi', incomplete_domain), &
      request_type('Piincc', 'n phi mc', 'Pi', incomplete_domain), &
      request_type('cel', 'kc p a b', 'cel', 'finite arguments'), &
      request_type('el1', 'x kc', 'el1', 'kc finite'), &
      request_type('el2', 'x kc a b', 'el2', 'kc, a and b finite'), &
      request_type('el3', 'x kc p', 'el3', 'kc and p finite'), &
      request_type('nome', 'm', 'q', 'm <= 1'), &
      request_type('nomec', 'mc', 'q', 'mc >= 0'), &
      request_type('jacobi', 'u m', 'sn cn dn am', 'u and m finite'), &
      request_type('jacobic', 'u mc', 'sn cn dn am', 'u and mc finite'), &
      request_type('zeta', 'u m', 'Z', 'm <= 1'), &
      request_type('zetac', 'u mc', 'Z', 'mc >= 0'), &
      request_type('heuman', 'phi m', 'Lambda_0', '0 <= m <= 1'), &
      request_type('heumanc', 'phi mc', 'Lambda_0', '0 <= mc <= 1'), &
      request_type('theta', 'i v q', 'theta_i(v, q)', 'i = 1, 2, 3 or 4, 0 <= q < 1'), &
      request_type('cubic', 'a b c d', 'count roots, ascending', ''), &
      request_type('turning', 'l g c1 c2', turning_results, ''), &
      request_type('turning_top', 'l g c1-gl c2', turning_results, ''), &
      request_type('turning_bottom', 'l g c1+gl c2', turning_results, ''), &
      request_type('orbit', 'l g z1 z2', orbit_results, ''), &
      request_type('orbit_gaps', 'l g l-z1 l+z2', orbit_results, ''), &
      request_type('orbit_rises', 'l g l+z1 l+z2', orbit_results, ''), &
      request_type('orbit_release', 'l g angle speed', orbit_results, ''), &
      request_type('azimuth', 'l g z1 z2 t', 'phi', azimuth_domain), &
      request_type('azimuth_gaps', 'l g l-z1 l+z2 t', 'phi', azimuth_domain), &
      request_type('azimuth_rises', 'l g l+z1 l+z2 t', 'phi', azimuth_domain), &
      request_type('position', 'l g z1 z2 t', place_results, ''), &
      request_type('position_gaps', 'l g l-z1 l+z2 t', place_results, ''), &
      request_type('position_rises', 'l g l+z1 l+z2 t', place_results, ''), &
      request_type('state', 'l g x y z vx vy vz t', place_results, ''), &
      request_type('orbit_derivatives', 'l g z1 z2', period_slopes, slope_domain), &
      request_type('orbit_derivatives_gaps', 'l g l-z1 l+z2', period_slopes, slope_domain), &
      request_type('orbit_derivatives_rises', 'l g l+z1 l+z2', period_slopes, slope_domain), &
      request_type('position_derivatives', 'l g z1 z2 t', position_slopes, slope_domain), &
      request_type('position_derivatives_gaps', 'l g l-z1 l+z2 t', position_slopes, slope_domain), &
      request_type('position_derivatives_rises', 'l g l+z1 l+z2 t', position_slopes, slope_domain), &
      request_type('state_derivatives', 'l g x y z vx vy vz t', '54: rows x ... vz, columns x ... vz l g t', ''), &
      request_type('passage_height', 'l g z1 z2 z', 't', 'z2 <= z <= z1'), &
      request_type('passage_azimuth', 'l g z1 z2 phi', 't', 'phi >= 0, and no bob at rest')]

contains

   !> Place of a name in `requests`, or 0. Upper and lower case differ.
   pure integer function request_index(name) result(place)
      character(len=*), intent(in) :: name
      integer :: i

      place = 0
      if (name == '') return
      do i = 1, size(requests)
         if (requests(i)%name == name) then
            place = i
            return
         end if
      end do
   end function request_index

   !> How many arguments a request takes.
   pure integer function argument_count(place) result(count)
      integer, intent(in) :: place  !! In `requests`
      integer :: i

      count = 1
      do i = 2, len_trim(requests(place)%arguments)
         if (requests(place)%arguments(i:i) == ' ') count = count + 1
      end do
   end function argument_count

end module kyvadlo_eval_requests
