!> Least squares: what a problem must tell, and its minimum next to a start, by GSL's trust region.
module kyvadlo_least_squares
   use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_funloc, c_funptr, c_int, c_loc, c_ptr, c_size_t
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_lapack, only: dgesvd
   use kyvadlo_numbers, only: is_finite
   implicit none
   private
   public :: least_squares_type, minimise, minimum_type, polish, triangle_of

   !> Residuals as functions of unknowns.
   type, abstract :: least_squares_type
      integer :: residuals = 0, unknowns = 0
      !> Of unknowns that stand at a bound of what they mean: the sign of a slope that pushes them against it;
      !> 0 of others. Set with the derivatives.
      real(wp), allocatable :: outward(:)
   contains
      procedure(evaluate_problem), deferred :: evaluate
   end type least_squares_type

   abstract interface
      !> Residuals, in units of their standard deviations, and their derivatives if asked for.
      subroutine evaluate_problem(problem, x, f, failed, jacobian)
         import :: least_squares_type, wp
         class(least_squares_type), intent(inout) :: problem
         real(wp), intent(in) :: x(:)                       !! (unknowns)
         real(wp), intent(out) :: f(:)                      !! (residuals)
         logical, intent(out) :: failed                     !! There are none at x
         real(wp), intent(out), optional, contiguous :: jacobian(:, :)  !! (unknowns, residuals)
      end subroutine evaluate_problem
   end interface

   !> How a search for a minimum ended.
   type :: minimum_type
      logical :: is_found = .false.
      real(wp) :: squares = huge(1.0_wp)                    !! Sum of the squares of the residuals
      integer :: iterations = 0
   end type minimum_type

   !> What GSL hands on to the two procedures below.
   type :: holder_type
      class(least_squares_type), pointer :: problem => null()
   end type holder_type

   interface
      function gsl_least_squares(n, p, x, residuals, jacobian, params, most, xtol, gtol, ftol, iterations, squares) &
            bind(c, name='kyvadlo_gsl_least_squares') result(status)
         import :: c_double, c_funptr, c_int, c_ptr, c_size_t
         integer(c_size_t), value :: n, p
         real(c_double), intent(inout) :: x(*)
         type(c_funptr), value :: residuals, jacobian
         type(c_ptr), value :: params
         integer(c_int), value :: most
         real(c_double), value :: xtol, gtol, ftol
         integer(c_int), intent(out) :: iterations
         real(c_double), intent(out) :: squares
         integer(c_int) :: status
      end function gsl_least_squares
   end interface

   !> GSL_EMAXITER; GSL_ENOPROG: no step makes the sum less, which at a minimum found to rounding is as it should be.
   integer(c_int), parameter :: status_most = 11, status_no_progress = 27
   !> Of residuals where there are none: so large that no step there is taken.
   real(wp), parameter :: far = 1e30_wp

contains

   !> Moves x to the minimum next to it, to a tolerance; `polish` says whether it is one.
   subroutine minimise(problem, x, minimum, tolerance, most)
      class(least_squares_type), intent(inout), target :: problem
      real(wp), intent(inout) :: x(:)
      type(minimum_type), intent(out) :: minimum
      real(wp), intent(in) :: tolerance                     !! Of a step, of the unknowns
      integer, intent(in) :: most                           !! Iterations
      type(holder_type), target :: holder
      real(wp) :: before(size(x))
      real(c_double) :: squares
      integer(c_int) :: status, iterations

      if (problem%residuals < size(x)) return
      before = x
      holder%problem => problem
      status = gsl_least_squares(int(problem%residuals, c_size_t), int(size(x), c_size_t), x, &
         c_funloc(give_residuals), c_funloc(give_jacobian), c_loc(holder), int(most, c_int), tolerance, 1e-10_wp, &
         1e-14_wp, iterations, squares)
      minimum%iterations = int(iterations)
      if (.not. (is_finite(squares) .and. all(is_finite(x)))) squares = far
      if (squares >= far) then
         x = before
         return
      end if
      minimum%squares = squares
      minimum%is_found = status == 0 .or. status == status_no_progress .or. status == status_most
   end subroutine minimise

   !> Gauss's steps by singular values from where the trust region ended: in a long valley its tests are met early. A
   !> minimum is where such a step would lower the sum by less than a thousandth of a squared sigma.
   subroutine polish(problem, x, minimum, most_steps, near)
      class(least_squares_type), intent(inout) :: problem
      real(wp), intent(inout) :: x(:)
      type(minimum_type), intent(inout) :: minimum
      integer, intent(in) :: most_steps
      !> Near enough is where a step would lower the sum by less; else it is polished to rounding.
      real(wp), intent(in), optional :: near
      integer, parameter :: most_halves = 12
      real(wp), parameter :: small = 1e-3_wp, tiny_part = 1e-9_wp
      real(wp), allocatable :: jacobian(:, :), f(:)
      real(wp) :: normal(size(x), size(x)), s(size(x)), u(1, 1), vt(size(x), size(x)), work(20*size(x)), g(size(x))
      real(wp) :: scale(size(x)), step(size(x)), y(size(x)), decrement, before, part, squares, enough
      integer :: i, k, p, info
      logical :: failed, is_seen

      p = size(x)
      minimum%is_found = .false.
      if (problem%residuals < p) return
      allocate (jacobian(p, problem%residuals), f(problem%residuals))
      is_seen = .false.
      enough = small
      if (present(near)) enough = near
      do i = 1, most_steps
         if (.not. is_seen) call problem%evaluate(x, f, failed, jacobian)
         minimum%is_found = .false.
         if (failed) return
         before = sum(f**2)
         minimum%squares = before
         ! Normal equations of columns of length 1; what they cannot tell apart the sigmas call a valley.
         call normal_equations(jacobian, f, normal, g)
         do k = 1, p
            scale(k) = max(sqrt(normal(k, k)), tiny(1.0_wp)**0.25_wp)
         end do
         if (allocated(problem%outward)) then
            ! Where the sum falls only beyond a bound, the minimum is at the bound.
            do k = 1, p
               if (.not. (abs(problem%outward(k)) > 0 .and. g(k)*problem%outward(k) >= 0)) cycle
               g(k) = 0
               normal(k, :) = 0
               normal(:, k) = 0
            end do
         end if
         g = g/scale
         normal = normal/(spread(scale, 1, p)*spread(scale, 2, p))
         call dgesvd('N', 'A', p, p, normal, p, s, u, 1, vt, p, work, size(work), info)
         if (info /= 0) return
         g = matmul(vt, g)
         where (s > tiny_part*s(1))
            step = g/s
         elsewhere
            step = 0
         end where
         decrement = dot_product(step, g)
         minimum%is_found = decrement < enough*max(1.0_wp, before/problem%residuals)
         if (minimum%is_found .and. present(near)) return
         if (decrement < 1e-3_wp*small) return
         step = matmul(step, vt)/scale
         if (minimum%is_found .and. all(abs(step) < tiny_part**0.5_wp)) then
            ! So near there is nothing to look at: whoever asks for sigmas next evaluates all at x.
            x = x - step
            minimum%squares = before - decrement
            minimum%iterations = minimum%iterations + 1
            return
         end if
         part = 1
         do k = 1, most_halves
            y = x - part*step
            failed = .not. all(abs(y) < far)
            ! The first step is mostly the one, and with derivatives to go on from; where it is the last they are not
            ! needed.
            is_seen = k == 1 .and. .not. minimum%is_found
            if (is_seen .and. .not. failed) then
               call problem%evaluate(y, f, failed, jacobian)
            else if (.not. failed) then
               call problem%evaluate(y, f, failed)
            end if
            squares = huge(squares)
            if (.not. failed) squares = sum(f**2)
            if (squares < before) exit
            part = part/2
         end do
         if (.not. squares < before) return
         x = y
         minimum%squares = squares
         minimum%iterations = minimum%iterations + 1
         if (minimum%is_found .or. before - squares < 1e-12_wp*before) return
      end do
   end subroutine polish

   pure subroutine normal_equations(jacobian, f, normal, g)
      real(wp), intent(in), contiguous :: jacobian(:, :), f(:)
      real(wp), intent(out), contiguous :: normal(:, :), g(:)
      integer :: i, j, k, p
      real(wp) :: a, b, c, d

      p = size(g)
      normal = 0
      g = 0
      ! Four rows at a time: each sum is loaded and stored once for them.
      do i = 1, size(f) - 3, 4
         do j = 1, p
            a = jacobian(j, i)
            b = jacobian(j, i + 1)
            c = jacobian(j, i + 2)
            d = jacobian(j, i + 3)
            do k = j, p
               normal(k, j) = normal(k, j) + (a*jacobian(k, i) + b*jacobian(k, i + 1) + c*jacobian(k, i + 2) + &
                  d*jacobian(k, i + 3))
            end do
            g(j) = g(j) + (a*f(i) + b*f(i + 1) + c*f(i + 2) + d*f(i + 3))
         end do
      end do
      do i = size(f) - modulo(size(f), 4) + 1, size(f)
         do j = 1, p
            normal(j:, j) = normal(j:, j) + jacobian(j, i)*jacobian(j:, i)
         end do
         g = g + f(i)*jacobian(:, i)
      end do
      do j = 2, size(g)
         normal(:j - 1, j) = normal(j, :j - 1)
      end do
   end subroutine normal_equations

   !> R of Q R = J, p by p, by Householder's reflections of a block of rows at a time: it keeps digits that the normal
   !> equations lose.
   pure subroutine triangle_of(jacobian, triangle)
      real(wp), intent(in) :: jacobian(:, :)                !! (p, rows): J, transposed
      real(wp), intent(out) :: triangle(:, :)               !! (p, p)
      integer, parameter :: block = 128
      real(wp) :: a(block, size(jacobian, 1)), top, length, part
      integer :: first, i, j, k, n, p

      p = size(jacobian, 1)
      triangle = 0
      do first = 1, size(jacobian, 2), block
         n = min(block, size(jacobian, 2) - first + 1)
         do i = 1, n
            a(i, :) = jacobian(:, first + i - 1)
         end do
         do k = 1, p
            length = sqrt(triangle(k, k)**2 + dot_product(a(:n, k), a(:n, k)))
            if (.not. length > 0) cycle
            top = triangle(k, k) + sign(length, triangle(k, k))
            triangle(k, k) = -sign(length, triangle(k, k))
            do j = k + 1, p
               part = (top*triangle(k, j) + dot_product(a(:n, k), a(:n, j)))/(length*abs(top))
               triangle(k, j) = triangle(k, j) - part*top
               a(:n, j) = a(:n, j) - part*a(:n, k)
            end do
         end do
      end do
   end subroutine triangle_of

   function give_residuals(x, f, params) bind(c, name='') result(status)
      type(c_ptr), value :: x, f, params
      integer(c_int) :: status
      type(holder_type), pointer :: holder
      real(c_double), pointer :: unknowns(:), residuals(:)
      logical :: failed

      call c_f_pointer(params, holder)
      call c_f_pointer(x, unknowns, [holder%problem%unknowns])
      call c_f_pointer(f, residuals, [holder%problem%residuals])
      failed = .not. all(abs(unknowns) < far)
      if (.not. failed) call holder%problem%evaluate(unknowns, residuals, failed)
      if (.not. failed) failed = .not. sum(abs(residuals)) < far
      if (failed) residuals = far
      status = 0
   end function give_residuals

   function give_jacobian(x, j, params) bind(c, name='') result(status)
      type(c_ptr), value :: x, j, params
      integer(c_int) :: status
      type(holder_type), pointer :: holder
      real(c_double), pointer :: unknowns(:), matrix(:, :)
      real(wp), allocatable :: f(:)
      logical :: failed

      call c_f_pointer(params, holder)
      call c_f_pointer(x, unknowns, [holder%problem%unknowns])
      call c_f_pointer(j, matrix, [holder%problem%unknowns, holder%problem%residuals])
      allocate (f(holder%problem%residuals))
      call holder%problem%evaluate(unknowns, f, failed, matrix)
      status = merge(1_c_int, 0_c_int, failed)
   end function give_jacobian

end module kyvadlo_least_squares
