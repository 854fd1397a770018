!> Pendulums that may have made the data, and how the data were seen.
module kyvadlo_fit_guess_list
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_numbers, only: is_nan
   use kyvadlo_orbit_real64, only: orbit_type
   implicit none
   private
   public :: guess_type, view_type, insert, start_of

   !> A pendulum that may have made the data.
   type :: guess_type
      real(wp) :: length = 1, gravity = 1
      real(wp) :: position(3) = 0, velocity(3) = 0         !! At t = 0
      real(wp) :: scale = 1, angle = 0, offset(2) = 0      !! Of the camera; the angle in radians
      real(wp) :: misfit = huge(1.0_wp)                    !! Sum of squares over that of the data
   end type guess_type

   !> What was seen, and what is known beforehand (0: not).
   type :: view_type
      real(wp), allocatable :: times(:)
      real(wp), allocatable :: seen(:, :)                  !! (n, 3) x, y, z; or u, v and nothing; NaN where not seen
      logical :: has(3) = .false., is_camera = .false., is_angle = .false.
      logical :: is_azimuth = .false.                      !! Seen are its cosine and sine
      logical :: is_line = .false.                         !! ... of twice the azimuth of the line of apsides
      logical :: is_tension = .false.                      !! Seen is that, per mass
      integer :: axes(2) = [1, 3]                          !! Of the camera
      logical :: is_offset_free = .false., is_turn_free = .false.
      real(wp) :: usual_gravity = 0                        !! Where nothing tells it
      real(wp) :: length = 0, gravity = 0, scale = 0, offset(2) = 0, angle = 0
      !> The start, where it is known: another orbit is not looked for.
      logical :: is_plane = .false.
   end type view_type

contains

   !> The start at t = 0 of a unit orbit, turned and stretched.
   subroutine start_of(orbit, phase, across, sense, guess)
      type(orbit_type), intent(in) :: orbit
      real(wp), intent(in) :: phase, across
      integer, intent(in) :: sense
      type(guess_type), intent(inout) :: guess
      real(wp) :: position(3), velocity(3), c, s

      call orbit%locate(phase, position, velocity)
      position(2) = sense*position(2)
      velocity(2) = sense*velocity(2)
      c = cos(across)
      s = sin(across)
      guess%position = guess%length*[c*position(1) - s*position(2), s*position(1) + c*position(2), position(3)]
      guess%velocity = sqrt(guess%length*guess%gravity)*[c*velocity(1) - s*velocity(2), s*velocity(1) + c*velocity(2), &
         velocity(3)]
   end subroutine start_of

   !> Among the best; one like another takes its place or none.
   subroutine insert(guesses, count, guess, most_alike)
      type(guess_type), intent(inout) :: guesses(:)
      integer, intent(inout) :: count
      type(guess_type), intent(in) :: guess
      !> Of one angle of the camera, but for a half turn: a motion nearly along a line in the picture is explained by
      !> many swings across the line of sight, and those along it must not be crowded out.
      integer, intent(in), optional :: most_alike
      integer :: i, at, alike, worst

      if (is_nan(guess%misfit) .or. is_nan(sum(guess%position) + sum(guess%velocity))) return
      do i = 1, count
         if (norm2(guess%position - guesses(i)%position) > 0.25_wp*guess%length) cycle
         if (norm2(guess%velocity - guesses(i)%velocity) > 0.25_wp*sqrt(guess%length*guess%gravity)) cycle
         if (abs(log(guess%gravity*guesses(i)%length/(guess%length*guesses(i)%gravity))) > 0.1_wp) cycle
         if (abs(log(guess%length/guesses(i)%length)) > 0.25_wp) cycle
         if (guess%misfit >= guesses(i)%misfit) return
         guesses(i:count - 1) = guesses(i + 1:count)
         count = count - 1
         exit
      end do
      if (present(most_alike)) then
         alike = 0
         do i = 1, count
            if (abs(sin(guess%angle - guesses(i)%angle)) > 0.3_wp) cycle
            alike = alike + 1
            worst = i
         end do
         if (alike >= most_alike) then
            if (guess%misfit >= guesses(worst)%misfit) return
            guesses(worst:count - 1) = guesses(worst + 1:count)
            count = count - 1
         end if
      end if
      at = count + 1
      do i = 1, count
         if (guess%misfit < guesses(i)%misfit) then
            at = i
            exit
         end if
      end do
      if (at > size(guesses)) return
      count = min(count + 1, size(guesses))
      guesses(at + 1:count) = guesses(at:count - 1)
      guesses(at) = guess
   end subroutine insert

end module kyvadlo_fit_guess_list
