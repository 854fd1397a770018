!> A whole file as one text.
module kyvadlo_file_text
   use kyvadlo_status, only: code_file, code_input, error_type, fail
   implicit none
   private
   public :: file_name, read_file

contains

   !> A path as messages name it.
   pure function file_name(path) result(name)
      character(len=*), intent(in) :: path
      character(len=merge(14, len(path), path == '-')) :: name

      name = path
      if (path == '-') name = 'standard input'
   end function file_name

   !> All bytes of a file. Errors: it cannot be read, is empty, or larger than 64 MiB.
   subroutine read_file(path, text, error)
      character(len=*), intent(in) :: path
      character(len=:), allocatable, intent(out) :: text
      type(error_type), allocatable, intent(out) :: error
      integer, parameter :: largest = 2**26
      character(len=256) :: reason
      character(len=:), allocatable :: larger
      character(len=1) :: byte
      integer :: unit, status, length

      reason = ''
      if (path == '-') then
         open (newunit=unit, file='/dev/stdin', access='stream', form='unformatted', action='read', status='old', &
            iostat=status, iomsg=reason)
      else
         open (newunit=unit, file=path, access='stream', form='unformatted', action='read', status='old', &
            iostat=status, iomsg=reason)
      end if
      if (status /= 0) then
         text = ''
         call fail(error, code_file, 'cannot read '//file_name(path)//': '//system_reason(reason))
         return
      end if
      length = 0
      allocate (character(len=4096) :: text)
      do
         read (unit, iostat=status, iomsg=reason) byte
         if (is_iostat_end(status)) exit
         if (status /= 0) then
            call fail(error, code_file, 'cannot read '//file_name(path)//': '//system_reason(reason))
            exit
         end if
         if (length == len(text)) then
            if (length >= largest) then
               call fail(error, code_file, file_name(path)//': larger than 64 MiB; a scene is a short text')
               exit
            end if
            allocate (character(len=2*length) :: larger)
            larger(:length) = text
            call move_alloc(larger, text)
         end if
         length = length + 1
         text(length:length) = byte
      end do
      close (unit)
      if (allocated(error)) return
      text = text(:length)
      if (length == 0) call fail(error, code_input, file_name(path)//': the file is empty')
   end subroutine read_file

   !> The system's words, blanks behind, out of gfortran's `Cannot open file 'x': No such file or directory`.
   pure function system_reason(message) result(reason)
      character(len=*), intent(in) :: message
      character(len=len(message)) :: reason

      reason = message(index(message, ''': ') + 1:)
      if (index(message, ''': ') > 0) reason = reason(3:)
   end function system_reason

end module kyvadlo_file_text
