!> Texts for pages of man.
module kyvadlo_roff
   implicit none
   private
   public :: roff, upper_case

contains

   !> A text that roff prints as it is.
   pure function roff(text) result(safe)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: safe
      integer :: i

      safe = ''
      if (index(text, '.') == 1) safe = '\&'      ! a line that begins so would be a macro
      do i = 1, len(text)
         select case (text(i:i))
         case ('-')
            safe = safe//'\-'
         case ('\')
            safe = safe//'\e'
         case ('''')
            safe = safe//'\(aq'
         case ('`')
            safe = safe//'\(ga'
         case default
            safe = safe//text(i:i)
         end select
      end do
   end function roff

   pure function upper_case(text) result(upper)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: upper
      integer :: i

      upper = text
      do i = 1, len(text)
         if (text(i:i) >= 'a' .and. text(i:i) <= 'z') upper(i:i) = achar(iachar(text(i:i)) - 32)
      end do
   end function upper_case

end module kyvadlo_roff
