!> The command `study`: asks every question of every orbit, prints the summary and writes record and pictures.
module kyvadlo_study_command
   use, intrinsic :: iso_fortran_env, only: error_unit, real64
   use kyvadlo_command_line, only: arguments_type, option_given, option_value
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: read_number
   use kyvadlo_gnuplot, only: draw_picture
   use kyvadlo_quoting, only: is_printable
   use kyvadlo_run_files, only: add_input, add_output, check_files, run_files_type
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_reader, only: choose_pendulum, read_scene
   use kyvadlo_standard_io, only: close_output, is_terminal, make_folder, message, open_output, output_type, &
      terminal_width
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_study_csv, only: write_csv, write_machine
   use kyvadlo_study_functions, only: ask_functions
   use kyvadlo_study_orbits, only: built_in_orbits, orbit_from_pendulum, study_orbit_type
   use kyvadlo_study_period, only: ask_period
   use kyvadlo_study_plots, only: write_plot
   use kyvadlo_study_position, only: study_position
   use kyvadlo_study_record, only: cell_type, study_type
   use kyvadlo_study_roots, only: ask_roots, built_in_cubics, cubic_of_orbit, study_cubic_type
   use kyvadlo_study_summary, only: names_in, write_summary
   use kyvadlo_text, only: shown, text_type
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_gsl, only: fgsl_error_handler_t, fgsl_set_error_handler_off
#endif
   implicit none
   private
   public :: study_command

   !> The questions that may be asked.
   character(len=*), parameter :: all_questions(*) = [character(len=13) :: 'position', 'position_1000', 'period', &
      'roots', 'gaps', 'functions']
   !> Seconds of measuring a cell, and of the longest pass, with which `--quick` stays under 20 s on two cores of a
   !> common server; with those of `study_type` the full study stays under 5 minutes.
   real(real64), parameter :: quick_seconds = 0.002_real64, quick_cap = 0.03_real64

contains

   !> Runs the command. What is wrong with options or scenes is found before anything is measured, and no file is
   !> written then.
   subroutine study_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(study_type) :: study
      type(study_orbit_type), allocatable :: orbits(:)
      type(study_cubic_type), allocatable :: cubics(:)
      type(error_type), allocatable :: of_files
      type(output_type) :: output, record
      character(len=:), allocatable :: folder
      integer :: i
#ifdef KYVADLO_WITH_GSL
      type(fgsl_error_handler_t) :: old

      old = fgsl_set_error_handler_off()
#endif
      study%quick = option_given(arguments, '--quick')
      if (study%quick) then
         study%seconds = quick_seconds
         study%cap = quick_cap
      end if
      call seconds_option(arguments, study, error)
      if (allocated(error)) return
      call read_orbits(arguments, orbits, cubics, error)
      if (allocated(error)) return
      folder = ''
      if (option_given(arguments, '--output')) then
         folder = option_value(arguments, '--output', '')
         call make_folder(folder, error)
         if (.not. allocated(error)) call check_folder(arguments, folder, error)
         if (.not. allocated(error)) call open_output(record, folder//'/study.csv', error)
         if (allocated(error)) return
      end if
      if (is_terminal(2)) study%progress => show_progress

      do i = 1, size(orbits)
         call study_position(study, orbits(i))
      end do
      do i = 1, size(orbits)
         call ask_period(study, orbits(i))
      end do
      do i = 1, size(cubics)
         call ask_roots(study, cubics(i))
      end do
      if (size(arguments%operands) == 0) call ask_functions(study)
      if (is_terminal(2)) write (error_unit, '(a)', advance='no') achar(13)//repeat(' ', progress_width())//achar(13)

      if (folder /= '') then
         call write_files(study, folder, size(arguments%operands) > 0, record, of_files)
      end if
      call open_output(output, '', error)
      if (allocated(error)) return
      call write_machine('', output)
#ifndef KYVADLO_WITH_GSL
      call output%put('This build has no GSL: its methods and LAPACK''s are left out.')
#endif
      call output%put('')
      call write_summary(study, output)
      call put_checksum(study, output)
      call close_output(output, error)
      ! What was measured is printed, whatever became of the files.
      if (allocated(of_files)) call move_alloc(of_files, error)
   end subroutine study_command

   !> `--seconds S`: of measuring each cell, with a cap in proportion.
   subroutine seconds_option(arguments, study, error)
      type(arguments_type), intent(in) :: arguments
      type(study_type), intent(inout) :: study
      type(error_type), allocatable, intent(out) :: error
      real(real64), parameter :: longest = 60
      real(real64) :: seconds
      character(len=:), allocatable :: what, text

      if (.not. option_given(arguments, '--seconds')) return
      text = option_value(arguments, '--seconds', '')
      call read_number(text, seconds, what)
      if (.not. allocated(what)) then
         if (.not. (seconds > 0 .and. seconds <= longest)) what = 'more than 0, 60 at most'
      end if
      if (allocated(what)) then
         call fail(error, code_input, "option --seconds must be a number of seconds, got '"//shown(text)//"' ("// &
            what//')')
         return
      end if
      study%cap = max(study%cap, 5*seconds)
      study%seconds = seconds
   end subroutine seconds_option

   !> The pendulums of the scenes named, or the built-in orbits.
   subroutine read_orbits(arguments, orbits, cubics, error)
      type(arguments_type), intent(in) :: arguments
      type(study_orbit_type), allocatable, intent(out) :: orbits(:)
      type(study_cubic_type), allocatable, intent(out) :: cubics(:)
      type(error_type), allocatable, intent(out) :: error
      type(pendulum_type), allocatable :: pendulums(:)
      type(study_orbit_type) :: orbit
      type(study_cubic_type) :: cubic
      logical :: has_failed
      integer :: i, j

      if (size(arguments%operands) == 0) then
         call built_in_orbits(orbits)
         call built_in_cubics(cubics)
         return
      end if
      allocate (orbits(0), cubics(0))
      do i = 1, size(arguments%operands)
         call read_scene(arguments%operands(i)%text, pendulums, error)
         if (option_given(arguments, '--pendulum') .and. .not. allocated(error)) &
            call choose_pendulum(pendulums, option_value(arguments, '--pendulum', ''), error)
         if (allocated(error)) return
         do j = 1, size(pendulums)
            if (allocated(pendulums(j)%note)) call message('kyvadlo: '//pendulums(j)%note)
            call orbit_from_pendulum(pendulums(j), orbit, error)
            if (allocated(error)) then
               error%message = place_of(pendulums(j)%file, pendulums(j)%line)//'&pendulum: '//error%message
               return
            end if
            if (.not. is_printable(pendulums(j)%name)) then
               call fail(error, code_input, place_of(pendulums(j)%file, pendulums(j)%line)// &
                  "&pendulum: its name must be UTF-8 without control characters, got '"//pendulums(j)%name//"'")
               return
            end if
            if (any(orbits%name == orbit%name)) orbit%name = trim(orbit%name)//' of '//arguments%operands(i)%text
            if (any(orbits%name == orbit%name)) then
               call fail(error, code_input, "study: two pendulums are named '"//trim(orbit%name)//"'")
               return
            end if
            orbits = [orbits, orbit]
            call cubic_of_orbit(orbit, cubic, has_failed)
            if (has_failed) then
               call message("kyvadlo: study: not asked for turning heights of '"//trim(orbit%name)// &
                  "': of its energy and momentum in double precision there is no orbit")
            else
               cubics = [cubics, cubic]
            end if
         end do
      end do
   end subroutine read_orbits

   !> Whether the folder takes our files, and has none in their place that we did not write.
   subroutine check_folder(arguments, folder, error)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: folder
      type(error_type), allocatable, intent(out) :: error
      type(run_files_type) :: files
      integer :: i

      do i = 1, size(arguments%operands)
         call add_input(files, 'the scene', arguments%operands(i)%text)
      end do
      call add_output(files, 'option --output', folder//'/study.csv', '# kyvadlo ')
      do i = 1, size(all_questions)
         associate (stem => folder//'/study_'//trim(all_questions(i)))
            call add_output(files, 'option --output', stem//'.gp', '# Written by kyvadlo study')
            call add_output(files, 'option --output', stem//'.svg')
            call add_output(files, 'option --output', stem//'.png')
         end associate
      end do
      call check_files(files, error)
   end subroutine check_folder

   !> study.csv, and for each question a script of gnuplot, drawn if there is gnuplot.
   subroutine write_files(study, folder, has_own_orbits, record, error)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: folder
      logical, intent(in) :: has_own_orbits
      type(output_type), intent(inout) :: record             !! study.csv
      type(error_type), allocatable, intent(out) :: error
      type(text_type), allocatable :: questions(:)
      type(error_type), allocatable :: of_picture, failure
      type(output_type) :: output
      character(len=:), allocatable :: stem
      logical :: has_gnuplot
      integer :: i

      call write_csv(study, has_own_orbits, record)
      call close_output(record, error)
      if (allocated(error)) return
      call names_in(study, 'question', '', questions)
      has_gnuplot = .true.
      do i = 1, size(questions)
         stem = folder//'/study_'//questions(i)%text
         call open_output(output, stem//'.gp', error)
         if (allocated(error)) return
         call write_plot(study, questions(i)%text, output)
         call close_output(output, error)
         if (allocated(error)) return
         if (has_gnuplot) call draw_picture(stem//'.gp', stem//'.svg', has_gnuplot, of_picture)
         if (has_gnuplot .and. .not. allocated(of_picture)) &
            call draw_picture(stem//'.gp', stem//'.png', has_gnuplot, of_picture)
         if (allocated(of_picture) .and. .not. allocated(failure)) call move_alloc(of_picture, failure)
      end do
      if (.not. has_gnuplot) &
         call message('kyvadlo: no gnuplot here to draw the pictures; where there is: gnuplot study_*.gp')
      if (allocated(failure)) call move_alloc(failure, error)
   end subroutine write_files

   !> What is being measured, on the same line of the terminal.
   subroutine show_progress(count, cell)
      integer, intent(in) :: count
      type(cell_type), intent(in) :: cell
      character(len=200) :: line

      write (line, '(i0,9a)') count + 1, '  ', trim(cell%question), '  ', trim(cell%orbit), '  ', trim(cell%method), &
         ' ', trim(cell%setting), ' '//trim(cell%kind)
      write (error_unit, '(2a)', advance='no') achar(13), line(:progress_width())
      flush (error_unit)
   end subroutine show_progress

   !> Columns of a line that does not wrap.
   integer function progress_width()

      progress_width = min(terminal_width() - 1, 78)
   end function progress_width

   !> So that nothing measured can have been left out.
   subroutine put_checksum(study, output)
      type(study_type), intent(in) :: study
      type(output_type), intent(inout) :: output
      character(len=80) :: line

      write (line, '(a,es22.15)') 'Sum of what was computed: ', study%checksum
      call output%put(trim(line))
   end subroutine put_checksum

end module kyvadlo_study_command
