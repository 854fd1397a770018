!> What errors of times, and a loss, make of residuals in sigmas and of their derivatives.
module kyvadlo_fit_loss
   use kyvadlo_kinds, only: wp => real64
   implicit none
   private
   public :: allow_for_row, soften, loss_squares, loss_huber, loss_cauchy

   integer, parameter :: loss_squares = 1, loss_huber = 2, loss_cauchy = 3

contains

   !> The errors of t: the residuals of one row together, by the inverse root of 1 + a a', a the rates in sigmas. That
   !> is what remains of the latent time once it is where it fits best (the delay moves the row there).
   pure subroutine allow_for_row(a, delay, f, jacobian)
      real(wp), intent(in) :: a(:)                       !! Sigmas that one sigma of t makes
      real(wp), intent(in) :: delay                      !! Of the latent time, in sigmas
      real(wp), intent(inout) :: f(:)
      real(wp), intent(inout), optional :: jacobian(:, :)
      real(wp) :: square, factor

      ! Back to the time that was read.
      f = f - a*delay
      square = sum(a**2)
      if (.not. square > 0) return
      factor = (1 - 1/sqrt(1 + square))/square
      f = f - factor*dot_product(a, f)*a
      if (present(jacobian)) jacobian = jacobian - factor*spread(matmul(jacobian, a), 2, size(a))*spread(a, 1, &
         size(jacobian, 1))
   end subroutine allow_for_row

   !> A residual r becomes sqrt(2 rho(r)), whose square sums to the loss.
   pure subroutine soften(loss, scale, f, jacobian)
      integer, intent(in) :: loss
      real(wp), intent(in) :: scale
      real(wp), intent(inout) :: f
      real(wp), intent(inout), optional :: jacobian(:)
      real(wp) :: r, slope

      r = abs(f)/scale
      slope = 1
      if (loss == loss_huber .and. r > 1) then
         slope = 1/sqrt(2*r - 1)
         f = sign(scale*sqrt(2*r - 1), f)
      else if (loss == loss_cauchy .and. r > 1e-4_wp) then
         slope = r/((1 + r**2)*sqrt(log(1 + r**2)))
         f = sign(scale*sqrt(log(1 + r**2)), f)
      end if
      if (present(jacobian)) jacobian = jacobian*slope
   end subroutine soften

end module kyvadlo_fit_loss
