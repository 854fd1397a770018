!> What other libraries reach, as quoted in `peers.dat`.
module peers
   implicit none
   private
   public :: peer_type, read_peers, peer_cell

   type :: peer_type
      character(len=8) :: function = ''    !! As in the file: prefix, `_`, and k, m or mc
      character(len=16) :: library = ''
      character(len=12) :: benign = '', hard = ''
      integer :: errors = 0, nans = 0, gross = 0, points = 0
   end type peer_type

contains

   subroutine read_peers(path, peer)
      character(len=*), intent(in) :: path
      type(peer_type), allocatable, intent(out) :: peer(:)
      type(peer_type) :: one
      character(len=200) :: line
      integer :: unit, status

      allocate (peer(0))
      open (newunit=unit, file=path, status='old', action='read')
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (line(1:1) == '#') cycle
         read (line, *) one%function, one%library, one%benign, one%hard, one%errors, one%nans, one%gross, one%points
         peer = [peer, one]
      end do
      close (unit)
   end subroutine read_peers

   !> `benign / hard`, and how many of the hard points fail; empty if the library has no such function.
   function peer_cell(peer, question, part, library) result(cell)
      type(peer_type), intent(in) :: peer(:)
      character(len=*), intent(in) :: question  !! Our reference file
      integer, intent(in) :: part
      character(len=*), intent(in) :: library
      character(len=:), allocatable :: cell, name
      character(len=64) :: line
      integer :: i, failing
      character(len=4), parameter :: complete(4) = ['K', 'E', 'D', 'B'], incomplete(4) = ['Fi', 'Ei', 'Di', '? ']
      character(len=4), parameter :: jacobi(4) = ['J.sn', 'J.cn', 'J.dn', 'J.am']

      cell = ''
      select case (question)
      case ('carlson_rc', 'carlson_rf', 'carlson_rd', 'carlson_rj', 'carlson_rg')
         name = question(9:)
      case ('complete', 'complete_c')
         name = trim(complete(part))//'_'
      case ('complete_pi', 'complete_pi_c')
         name = 'P_'
      case ('incomplete', 'incomplete_c')
         name = trim(incomplete(part))//'_'
      case ('incomplete_pi', 'incomplete_pi_c')
         name = 'Pi_'
      case ('zeta', 'zeta_c')
         name = 'Z_'
      case ('jacobi', 'jacobic')
         name = trim(jacobi(part))//'_'
      case default
         return
      end select
      do i = 1, size(peer)
         if (peer(i)%library /= library) cycle
         if (question(1:2) == 'ca') then
            if (peer(i)%function /= name) cycle
         else if (question(len(question):) == 'c') then
            if (peer(i)%function /= name//'mc') cycle
         else
            if (peer(i)%function /= name//'k' .and. peer(i)%function /= name//'m') cycle
         end if
         cell = trim(peer(i)%benign)//' / '//trim(peer(i)%hard)
         failing = peer(i)%errors + peer(i)%nans + peer(i)%gross
         if (failing > 0) then
            write (line, '(", ", i0, " of ", i0, " fail")') failing, peer(i)%points
            cell = cell//trim(line)
         end if
         return
      end do
   end function peer_cell

end module peers
