!> The effects of a scene as the numerical part of the library takes them.
module kyvadlo_scene_effects
   use kyvadlo_effects, only: air_coefficients, earth_turn_rate, effects_type
   use kyvadlo_file_text, only: read_file
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_number_text, only: read_number, shortest_text
#ifdef KYVADLO_WITH_GSL
   use kyvadlo_pivot_table, only: new_pivot_table
#endif
   use kyvadlo_scene_groups
   use kyvadlo_simulation, only: simulation_type
   use kyvadlo_status, only: code_input, error_type, fail
   use kyvadlo_text, only: shown, split_words
   implicit none
   private
   public :: effects_of

   real(wp), parameter :: degree = acos(-1.0_wp)/180
   character(len=*), parameter :: line_feed = achar(10)

contains

   !> Reads the table of the pivot too. Errors: of that file.
   subroutine effects_of(simulation, effects, error)
      type(simulation_type), intent(in) :: simulation
      type(effects_type), intent(out) :: effects
      type(error_type), allocatable, intent(out) :: error

      associate (settings => simulation%settings)
         effects%is_string = settings%given(string_group)
         effects%restitution = settings%restitution
         effects%density_ratio = settings%density_ratio
         effects%added_mass = settings%added_mass
         effects%linear_drag = settings%linear_drag
         effects%quadratic_drag = settings%quadratic_drag
         if (settings%diameter > 0) call air_coefficients(settings%diameter, settings%mass, settings%density, &
            settings%viscosity, effects%linear_drag, effects%quadratic_drag)
         effects%wind = settings%wind
         if (settings%given(earth_rotation_group)) &
            effects%turn_rate = earth_turn_rate(settings%latitude, settings%earth_rate)
         effects%pivot_amplitude = settings%amplitude
         effects%pivot_frequency = settings%frequency
         effects%pivot_phase = settings%phase*degree
         if (settings%given(elastic_group)) effects%stiffness = settings%stiffness/settings%elastic_mass
         effects%extra_length = settings%extra_length
         if (allocated(settings%table)) call read_table(simulation, effects, error)
      end associate
   end subroutine effects_of

   !> A table of the pivot: a line for each time, `t x y z` in s and m, separated by blanks or commas; blank lines and what
   !> follows a # are left out. Its place is counted from the folder of the scene.
   subroutine read_table(simulation, effects, error)
      type(simulation_type), intent(in) :: simulation
      type(effects_type), intent(inout) :: effects
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text, path
      real(wp), allocatable :: rows(:, :), more(:, :)
      real(wp) :: row(4)
      character(len=:), allocatable :: place
      integer :: first, length, line, count

      path = simulation%settings%table
      if (path(1:1) /= '/') path = simulation%folder//path
      call read_file(path, text, error)
      if (allocated(error)) then
         error%message = place_of(simulation%settings%file, simulation%settings%line(moving_pivot_group)) &
            //'&moving_pivot: '//error%message
         return
      end if
      allocate (rows(4, 64))
      count = 0
      line = 0
      first = 1
      do while (first <= len(text))
         line = line + 1
         length = index(text(first:), line_feed) - 1
         if (length < 0) length = len(text) - first + 1
         place = place_of(path, line)
         call read_row(text(first:first + length - 1), place, row, length, error)
         if (allocated(error)) return
         first = first + index(text(first:)//line_feed, line_feed)
         if (length == 0) cycle
         if (count > 0) then
            if (.not. row(1) > rows(1, count)) then
               call fail(error, code_input, place//'the times of the table must ascend, got '//shortest_text(row(1))//' after ' &
                  //shortest_text(rows(1, count)))
               return
            end if
         end if
         if (count == size(rows, 2)) then
            allocate (more(4, 2*count))
            more(:, :count) = rows
            call move_alloc(more, rows)
         end if
         count = count + 1
         rows(:, count) = row
      end do
#ifdef KYVADLO_WITH_GSL
      call new_pivot_table(effects, rows(1, :count), rows(2:, :count), error)
      if (allocated(error)) error%message = path//': '//error%message
#else
      ! Enough to say that there is one: without the integrator nothing comes of it.
      effects%pivot_times = rows(1, :count)
#endif
   end subroutine read_table

   !> Four numbers of a line.
   subroutine read_row(line, place, row, count, error)
      character(len=*), intent(in) :: line, place
      real(wp), intent(out) :: row(4)
      integer, intent(out) :: count                        !! Numbers found: 0 or 4
      type(error_type), allocatable, intent(out) :: error
      character(len=len(line)) :: blank
      character(len=:), allocatable :: what
      integer, allocatable :: first(:), last(:)
      integer :: i

      blank = line
      do i = 1, len(blank)
         if (blank(i:i) == ',') blank(i:i) = ' '
         if (blank(i:i) == '#') blank(i:) = ''
      end do
      call split_words(blank, first, last, count)
      row = 0
      if (count /= 0 .and. count /= 4) then
         call fail(error, code_input, place//'a line of the table has 4 numbers, t x y z, got '//shown(line))
         return
      end if
      do i = 1, count
         call read_number(blank(first(i):last(i)), row(i), what)
         if (.not. allocated(what)) cycle
         call fail(error, code_input, place//'a number is expected, got '//shown(blank(first(i):last(i)))//' ('//what//')')
         return
      end do
   end subroutine read_row

end module kyvadlo_scene_effects
