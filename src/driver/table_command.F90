!> The command `table`: scenes, the built-in pendulums, or a grid of turning heights, in the kind asked for.
module kyvadlo_table_command_real32
   use, intrinsic :: iso_fortran_env, only: int64, wp => real32
   use kyvadlo_orbit_real32, only: orbit_type
#include "table_command.inc"
end module kyvadlo_table_command_real32

module kyvadlo_table_command_real64
   use, intrinsic :: iso_fortran_env, only: int64, wp => real64
   use kyvadlo_orbit_real64, only: orbit_type
#include "table_command.inc"
end module kyvadlo_table_command_real64

#ifndef KYVADLO_NO_REAL128
module kyvadlo_table_command_real128
   use, intrinsic :: iso_fortran_env, only: int64, wp => real128
   use kyvadlo_orbit_real128, only: orbit_type
#include "table_command.inc"
end module kyvadlo_table_command_real128
#endif

module kyvadlo_table_command
   use, intrinsic :: iso_fortran_env, only: real32, real64
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real128
#endif
   use kyvadlo_built_in_scene, only: built_in_name, built_in_scene
   use kyvadlo_command_line, only: accuracy_option, arguments_type, integer_option, option_given, option_value
   use kyvadlo_number_text, only: read_number
   use kyvadlo_run_files, only: add_input, add_output, check_files, is_netcdf_name, run_files_type
   use kyvadlo_scene, only: pendulum_type
   use kyvadlo_scene_reader, only: choose_pendulum, parse_scene, read_scene
   use kyvadlo_sheet, only: layout_csv, layout_markdown, layout_text
   use kyvadlo_standard_io, only: close_output, discard_output, message, open_output, output_type
   use kyvadlo_status, only: code_input, code_unsupported, error_type, fail
   use kyvadlo_table_command_real32
   use kyvadlo_table_command_real64
#ifndef KYVADLO_NO_REAL128
   use kyvadlo_table_command_real128
#endif
   use kyvadlo_table_options, only: table_options_type
   use kyvadlo_version, only: with_quad
   use kyvadlo_text, only: shown, text_type
   implicit none
   private
   public :: table_command

   !> Characters of a number among the options of a pendulum.
   integer, parameter :: longest_value = 400

contains

   !> Runs the command. On failure nothing has been written.
   subroutine table_command(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(table_options_type) :: options
      type(output_type) :: output
      type(pendulum_type), allocatable :: pendulums(:)
      character(len=:), allocatable :: kind

      call read_options(arguments, options, kind, error)
      if (.not. allocated(error)) call check_all_files(arguments, error)
      if (.not. allocated(error)) call read_all(arguments, pendulums, error)
      if (allocated(error)) return
      call open_output(output, option_value(arguments, '--output', ''), error)
      if (allocated(error)) return
      select case (kind)
      case ('single')
         call tables_in_kind(1.0_real32, arguments, pendulums, options, output, error)
#ifndef KYVADLO_NO_REAL128
      case ('quad')
         call tables_in_kind(1.0_real128, arguments, pendulums, options, output, error)
#endif
      case default
         call tables_in_kind(1.0_real64, arguments, pendulums, options, output, error)
      end select
      if (allocated(error)) then
         call discard_output(output)
      else
         call close_output(output, error)
      end if
   end subroutine table_command

   !> The pendulums of all scenes, in order, or the built-in ones, or the one chosen of them. Notes go to standard
   !> error.
   subroutine read_all(arguments, pendulums, error)
      type(arguments_type), intent(in) :: arguments
      type(pendulum_type), allocatable, intent(out) :: pendulums(:)
      type(error_type), allocatable, intent(out) :: error
      type(pendulum_type), allocatable :: more(:), all(:)
      type(text_type) :: note
      integer :: i, j

      if (option_given(arguments, '--release-angle')) then
         call parse_scene(scene_of_options(arguments), 'options', pendulums, error)
      else if (option_given(arguments, '--upper') .or. size(arguments%operands) == 0) then
         call parse_scene(built_in_scene, built_in_name, pendulums, error)
      end if
      do i = 1, size(arguments%operands)
         if (.not. allocated(pendulums)) allocate (pendulums(0))
         call read_scene(arguments%operands(i)%text, more, error, note)
         if (allocated(error)) return
         if (allocated(note%text)) call message('kyvadlo: '//note%text)
         do j = 1, size(more)
            if (allocated(more(j)%note)) call message('kyvadlo: '//more(j)%note)
         end do
         allocate (all(size(pendulums) + size(more)))
         all(:size(pendulums)) = pendulums
         all(size(pendulums) + 1:) = more
         call move_alloc(all, pendulums)
      end do
      if (option_given(arguments, '--pendulum') .and. .not. allocated(error)) &
         call choose_pendulum(pendulums, option_value(arguments, '--pendulum', ''), error)
   end subroutine read_all

   !> The scene that the options of a pendulum describe, blanks behind. Their values are numbers.
   function scene_of_options(arguments) result(scene)
      type(arguments_type), intent(in) :: arguments
      character(len=200 + 4*longest_value) :: scene

      scene = '&pendulum name="released at '//option_value(arguments, '--release-angle', '0')//' degrees" length='// &
         option_value(arguments, '--length', '1')//' gravity='//option_value(arguments, '--gravity', '9.80665')// &
         ' release_angle='//option_value(arguments, '--release-angle', '0')//' release_speed='// &
         option_value(arguments, '--release-speed', '0')//'/'
   end function scene_of_options

   !> Whether the files of the run go together.
   subroutine check_all_files(arguments, error)
      type(arguments_type), intent(in) :: arguments
      type(error_type), allocatable, intent(out) :: error
      type(run_files_type) :: files
      integer :: i

      do i = 1, size(arguments%operands)
         call add_input(files, 'the scene', arguments%operands(i)%text)
      end do
      if (option_given(arguments, '--output')) &
         call add_output(files, 'option --output', option_value(arguments, '--output', ''))
      call check_files(files, error)
   end subroutine check_all_files

   !> The options that do not depend on the kind, and which of them exclude each other.
   subroutine read_options(arguments, options, kind, error)
      type(arguments_type), intent(in) :: arguments
      type(table_options_type), intent(out) :: options
      character(len=:), allocatable, intent(out) :: kind  !! single, double, quad
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: name
      real(real64) :: accuracy
      !> Of 14 digits of double precision all count, of 32 in quad.
      real(real64), parameter :: least_of_double = 1e-13_real64
      integer, parameter :: most_digits = 32

      kind = option_value(arguments, '--kind', 'double')
      accuracy = 1
      call accuracy_option(arguments, accuracy, error)
      if (allocated(error)) return
      if (accuracy < 1) then
         ! One digit more than the accuracy has, so that rounding adds a tenth of it at most. Single would round the
         ! scene.
         options%digits = min(1 + ceiling(-log10(accuracy)), most_digits)
         kind = 'quad'
         if (accuracy >= least_of_double) kind = 'double'
         if (kind == 'quad' .and. .not. with_quad) then
            call fail(error, code_input, &
               'option --accuracy: this build has no quadruple precision, and double precision keeps 1e-13')
            return
         end if
      end if
#ifdef KYVADLO_NO_REAL128
      if (kind == 'quad') then
         call fail(error, code_unsupported, 'this build has no quadruple precision')
         return
      end if
#endif
      select case (option_value(arguments, '--format', 'text'))
      case ('csv')
         options%layout = layout_csv
      case ('markdown')
         options%layout = layout_markdown
      case default
         options%layout = layout_text
      end select
      options%data_only = option_given(arguments, '--data')
      call integer_option(arguments, '--digits', 1, 100, options%digits, error)
      if (allocated(error)) return
      call integer_option(arguments, '--divisions', 1, 100000000, options%divisions, error)
      if (allocated(error)) return
      if (options%data_only .and. options%divisions > 0) then
         call fail(error, code_input, 'options --data and --divisions exclude each other')
         return
      end if
      call check_starts(arguments, options, error)
      if (allocated(error)) return
      if (.not. option_given(arguments, '--output')) return
      name = option_value(arguments, '--output', '')
      if (name == '') then
         call fail(error, code_input, 'option --output needs the name of a file')
      else if (is_netcdf_name(name)) then
         call fail(error, code_input, 'option --output: a table is text; NetCDF (.nc) comes from simulate')
      end if
   end subroutine read_options

   !> The options of a grid or of a pendulum, and what they exclude.
   subroutine check_starts(arguments, options, error)
      type(arguments_type), intent(in) :: arguments
      type(table_options_type), intent(in) :: options
      type(error_type), allocatable, intent(out) :: error
      logical :: has_grid, has_release, has_scene

      has_grid = option_given(arguments, '--upper') .or. option_given(arguments, '--lower')
      has_release = option_given(arguments, '--release-angle') .or. option_given(arguments, '--release-speed')
      has_scene = size(arguments%operands) > 0 .or. option_given(arguments, '--pendulum')
      if ((has_grid .or. has_release) .and. has_scene) then
         call fail(error, code_input, &
            'give scenes, a grid (--upper, --lower) or a pendulum (--release-angle), one of them')
      else if (has_grid .and. has_release) then
         call fail(error, code_input, 'give a grid (--upper, --lower) or a pendulum (--release-angle), not both')
      else if (has_grid) then
         if (.not. (option_given(arguments, '--upper') .and. option_given(arguments, '--lower'))) then
            call fail(error, code_input, 'a grid needs both --upper A:B:N and --lower A:B:N')
         else if (options%data_only .or. options%divisions > 0) then
            call fail(error, code_input, 'options --data and --divisions do not apply to a grid')
         end if
      else if (has_release) then
         if (.not. option_given(arguments, '--release-angle')) then
            call fail(error, code_input, 'option --release-speed needs --release-angle A too')
            return
         end if
         call check_number(arguments, '--release-angle', error)
         if (.not. allocated(error)) call check_number(arguments, '--release-speed', error)
         if (.not. allocated(error)) call check_number(arguments, '--length', error)
         if (.not. allocated(error)) call check_number(arguments, '--gravity', error)
      else if (option_given(arguments, '--length') .or. option_given(arguments, '--gravity')) then
         call fail(error, code_input, 'options --length and --gravity apply to a grid or a pendulum: give '// &
            '--upper and --lower, or --release-angle, too')
      end if
   end subroutine check_starts

   !> Whether the value of an option is a number; its range is the scene's to check.
   subroutine check_number(arguments, name, error)
      type(arguments_type), intent(in) :: arguments
      character(len=*), intent(in) :: name
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what, text
      real(real64) :: value

      if (.not. option_given(arguments, name)) return
      text = option_value(arguments, name, '')
      call read_number(text, value, what)
      if (.not. allocated(what) .and. len(text) > longest_value) what = 'too long'
      if (allocated(what)) &
         call fail(error, code_input, 'option '//name//" must be a number, got '"//shown(text)//"' ("//what//')')
   end subroutine check_number

end module kyvadlo_table_command
