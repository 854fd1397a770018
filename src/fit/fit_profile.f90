!> Intervals by profile likelihood: how far one number may go before chi2, at its minimum over all the others, has grown
!> by 1.
module kyvadlo_fit_profile
   use kyvadlo_fit_model, only: model_type, use_until
   use kyvadlo_fit_physics, only: physics_type
   use kyvadlo_fit_unknowns, only: physics_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: minimise, minimum_type, polish
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene_groups, only: settings
   implicit none
   private
   public :: profile_end

   !> A model with one measurement more: that an element of a setting is `target` +- `width`. The minimum of both is the
   !> minimum of the data alone among all motions with the same value of that element: a point of the profile, with
   !> nothing held fixed.
   type, extends(model_type) :: pulled_type
      integer :: setting = 0, element = 1
      real(wp) :: target = 0, width = 1
   contains
      procedure :: evaluate => evaluate_pulled
   end type pulled_type

contains

   !> One end of an interval of 68.27 per cent. NaN: chi2 does not grow by 1 on this side.
   subroutine profile_end(model, x, setting, element, best, sigma, least, side, ends)
      type(model_type), intent(in) :: model             !! Around its minimum
      real(wp), intent(in) :: x(:)                      !! Where searches begin, near the minimum
      integer, intent(in) :: setting, element
      real(wp), intent(in) :: best                      !! The element's value at the minimum
      real(wp), intent(in) :: sigma                     !! And its standard deviation, from the covariance
      real(wp), intent(in) :: least                     !! chi2 there, or the sum of the losses
      integer, intent(in) :: side                       !! -1 or 1
      real(wp), intent(out) :: ends
      type(pulled_type) :: pulled
      type(minimum_type) :: minimum
      real(wp) :: y(size(x)), squares, distance, root, below, above, root_below, root_above, last
      integer :: tries
      logical :: failed
      integer, parameter :: most_tries = 25
      !> Of the root of what chi2 has grown by, which is to be 1.
      real(wp), parameter :: close = 1e-4_wp

      ends = quiet_nan_real64
      pulled%model_type = model
      call use_until(pulled%model_type, huge(1.0_wp), 1)
      pulled%residuals = pulled%residuals + 1
      pulled%setting = setting
      pulled%element = element
      pulled%width = sigma
      ! Were chi2 a parabola, a pull towards two sigmas with a width of one would end at one.
      distance = 2*sigma
      below = 0
      root_below = 0
      above = huge(above)
      root_above = 0
      last = best
      do tries = 1, most_tries
         pulled%target = best + side*distance
         y = x
         call minimise(pulled, y, minimum, 1e-9_wp, 100)
         if (minimum%is_found) call polish(pulled, y, minimum, 30)
         failed = .not. minimum%is_found
         if (.not. failed) call look(y, squares, ends, failed)
         if (failed) then
            ! Too far at once.
            above = distance
            root_above = 0
            distance = (below + distance)/2
            cycle
         end if
         root = sqrt(max(squares - least, 0.0_wp))
         if (abs(root - 1) < close) return
         if (root < 1) then
            ! A pull that grows and moves it no more: it is at a bound.
            if (tries > 1 .and. above >= huge(above) .and. abs(ends - last) < 1e-3_wp*sigma) exit
            last = ends
            below = distance
            root_below = root
         else
            above = distance
            root_above = root
         end if
         if (above < huge(above)) then
            distance = (below + above)/2
            if (root_above > 0) distance = below + (above - below)*min(0.9_wp, max(0.1_wp, (1 - root_below)/ &
               (root_above - root_below)))
         else
            distance = distance*min(3.0_wp, 1.05_wp/max(root, 0.1_wp))
            if (distance > 1e6_wp*sigma) exit
         end if
      end do
      ends = quiet_nan_real64

   contains

      !> chi2 of the data and the element's value.
      subroutine look(x, squares, value, failed)
         real(wp), intent(in) :: x(:)
         real(wp), intent(out) :: squares, value
         logical, intent(out) :: failed
         real(wp) :: f(pulled%residuals - 1), number(3, size(settings))
         type(physics_type) :: physics

         call pulled%model_type%evaluate(x, f, failed)
         squares = sum(f**2)
         if (.not. failed) call physics_at(pulled%motion, x, number, physics, failed)
         value = number(element, setting)
      end subroutine look
   end subroutine profile_end

   subroutine evaluate_pulled(problem, x, f, failed, jacobian)
      class(pulled_type), intent(inout) :: problem
      real(wp), intent(in) :: x(:)
      real(wp), intent(out) :: f(:)
      logical, intent(out) :: failed
      real(wp), intent(out), optional, contiguous :: jacobian(:, :)
      !> Of an unknown in its natural unit; the numbers are short closed forms of them.
      real(wp), parameter :: step = 1e-6_wp
      integer :: j, n
      real(wp) :: y(size(x))

      n = size(f) - 1
      if (present(jacobian)) then
         call problem%model_type%evaluate(x, f(:n), failed, jacobian(:, :n))
      else
         call problem%model_type%evaluate(x, f(:n), failed)
      end if
      if (failed) return
      f(n + 1) = (value_at(x) - problem%target)/problem%width
      if (.not. present(jacobian)) return
      do j = 1, size(x)
         y = x
         y(j) = x(j) + step
         jacobian(j, n + 1) = value_at(y)
         y(j) = x(j) - step
         jacobian(j, n + 1) = (jacobian(j, n + 1) - value_at(y))/(2*step*problem%width)
      end do

   contains

      real(wp) function value_at(x)
         real(wp), intent(in) :: x(:)
         real(wp) :: number(3, size(settings))
         type(physics_type) :: physics
         logical :: failed

         call physics_at(problem%motion, x, number, physics, failed)
         value_at = number(problem%element, problem%setting)
      end function value_at
   end subroutine evaluate_pulled

end module kyvadlo_fit_profile
