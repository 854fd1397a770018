!> The record of a study as CSV, with what made it in comments.
module kyvadlo_study_csv
   use kyvadlo_study_record, only: csv_header, csv_line, study_type
   use kyvadlo_text, only: text_sink_type
   use kyvadlo_version, only: compiler, compiler_flags, version
   implicit none
   private
   public :: write_csv, write_machine, processor

contains

   !> Comments, the header, a line for each cell.
   subroutine write_csv(study, has_own_orbits, sink)
      type(study_type), intent(in) :: study
      logical, intent(in) :: has_own_orbits      !! The orbits are those of scenes
      class(text_sink_type), intent(inout) :: sink
      character(len=100) :: line
      integer :: i

      call write_machine('# ', sink)
      write (line, '(a,f0.3,a,f0.3,a)') '# Each cell measured for ', study%seconds, &
         ' s; capped: one pass takes over ', study%cap, ' s.'
      call sink%put(trim(line))
      call sink%put('# Times in nanoseconds a result: median, lower and upper quartile of the passes.')
      if (has_own_orbits) then
         call sink%put('# Orbits of scenes: errors against our real128 path, so those of real128 say nothing.')
      else
         call sink%put('# Errors against values of mpmath at 36 digits or more.')
      end if
      call sink%put(csv_header)
      do i = 1, study%count
         call sink%put(trim(csv_line(study%cells(i))))
      end do
   end subroutine write_csv

   !> Program, compiler, flags and processor.
   subroutine write_machine(mark, sink)
      character(len=*), intent(in) :: mark       !! In front of every line
      class(text_sink_type), intent(inout) :: sink

      call sink%put(mark//'kyvadlo '//version//', '//compiler)
      call sink%put(mark//trim(adjustl(compiler_flags)))
      call sink%put(mark//trim(processor()))
   end subroutine write_machine

   !> What Linux calls the processor.
   function processor() result(name)
      character(len=256) :: name, line
      integer :: unit, status

      name = 'an unknown processor'
      open (newunit=unit, file='/proc/cpuinfo', status='old', action='read', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (line(:10) /= 'model name') cycle
         name = adjustl(line(index(line, ':') + 1:))
         exit
      end do
      close (unit)
   end function processor

end module kyvadlo_study_csv
