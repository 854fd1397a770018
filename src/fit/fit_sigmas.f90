!> Standard deviations of what was fitted, and what the data cannot tell.
module kyvadlo_fit_sigmas
   use kyvadlo_chi2, only: chi2_probability
   use kyvadlo_fit_known, only: say_known
   use kyvadlo_fit_loss, only: loss_squares
   use kyvadlo_fit_physics, only: direction_type, physics_type
   use kyvadlo_fit_request, only: fit_request_type
   use kyvadlo_fit_result, only: fit_result_type
   use kyvadlo_fit_unknowns, only: form_logarithm, form_plain, numbers_at, physics_at, place_at, unknown_position, &
      unknown_scalar, unknown_velocity, unknowns_type
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_lapack, only: dgesvd
   use kyvadlo_least_squares, only: triangle_of
   use kyvadlo_numbers, only: quiet_nan_real64
   use kyvadlo_scene_groups
   use kyvadlo_text, only: append, text_type
   implicit none
   private
   public :: find_sigmas, name_results

contains

   !> The covariance by the singular values of the derivatives in natural units. A direction that could be changed by
   !> its natural size within one sigma is not determined.
   subroutine find_sigmas(result, request)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      real(wp), parameter :: least_singular = 1, rounding = 1e-11_wp, least_part = 0.3_wp
      real(wp), allocatable :: jacobian(:, :), f(:), d(:, :), spread_of(:, :), parts(:)
      real(wp) :: s(size(result%x)), vt(size(result%x), size(result%x)), u(1, 1), number(3, size(settings)), natural
      real(wp) :: triangle(size(result%x), size(result%x)), work(20*size(result%x))
      real(wp) :: part, floor, rates(size(result%x)), growth
      type(unknowns_type) :: motion
      type(physics_type) :: physics
      type(direction_type) :: directions(size(result%x))
      logical :: failed, is_out(size(result%x)), is_plain
      integer :: p, m, i, j, k, n, info
      character(len=:), allocatable :: names

      p = size(result%x)
      motion = result%model%motion
      ! By the settings themselves: bounds have no part in sigmas.
      call numbers_at(motion, result%x, number, rates)
      call physics_at(motion, result%x, number, physics, failed)
      motion%number = number
      do j = 1, p
         if (motion%of(j)%form /= form_logarithm) motion%of(j)%form = form_plain
      end do
      call place_at(motion, result%x)
      result%model%motion = motion
      result%number = number
      call name_results(result, request)
      m = result%model%residuals
      allocate (jacobian(p, m), f(m))
      call result%model%evaluate(result%x, f, failed, jacobian)
      if (allocated(result%undetermined)) deallocate (result%undetermined)
      n = result%of(size(result%of))%first + result%of(size(result%of))%elements - 1
      if (allocated(result%covariance)) deallocate (result%covariance)
      allocate (result%undetermined(0), result%covariance(n, n))
      result%covariance = quiet_nan_real64
      result%known = ''
      if (.not. failed) call keep_residuals(result, f)
      if (.not. failed) call triangle_of(jacobian, triangle)
      if (.not. failed) call dgesvd('N', 'A', p, p, triangle, p, s, u, 1, vt, p, work, size(work), info)
      if (.not. failed) failed = info /= 0
      if (failed) then
         result%is_converged = .false.
         return
      end if
      result%condition = s(1)/max(s(p), 1e-290_wp*max(s(1), 1.0_wp))
      is_out = s < max(least_singular, rounding*s(1))
      floor = max(rounding*s(1), tiny(1.0_wp))
      call physics_at(motion, result%x, number, physics, failed, directions)
      allocate (d(n, p), parts(n))
      d = 0
      call numbers_at(motion, result%x, number, rates)
      do i = 1, size(result%of)
         associate (one => result%of(i))
            select case (kind_of(one%setting))
            case (unknown_position)
               do j = 1, p
                  d(one%first:one%first + 2, j) = directions(j)%change%position
               end do
            case (unknown_velocity)
               do j = 1, p
                  d(one%first:one%first + 2, j) = directions(j)%change%velocity
               end do
            case default
               do j = 1, p
                  if (motion%of(j)%setting == one%setting) d(one%first + motion%of(j)%element - 1, j) = &
                     rates(j)
               end do
            end select
         end associate
      end do
      ! (n, p) each element along each direction.
      spread_of = matmul(d, transpose(vt))
      result%covariance = 0
      do j = 1, p
         if (is_out(j)) cycle
         do k = 1, n
            result%covariance(:, k) = result%covariance(:, k) + spread_of(:, j)*spread_of(k, j)/s(j)**2
         end do
      end do
      do i = 1, size(result%of)
         associate (one => result%of(i))
            do k = 1, one%elements
               natural = natural_size(one%setting, one%first + k - 1)
               part = sqrt(sum((spread_of(one%first + k - 1, :)/max(s, floor))**2, is_out))
               parts(one%first + k - 1) = part
               one%is_known(k) = .not. part > least_part*natural
               if (one%is_known(k)) result%covariance(one%first + k - 1, one%first + k - 1) = &
                  result%covariance(one%first + k - 1, one%first + k - 1) + &
                  sum((spread_of(one%first + k - 1, :)/s)**2, is_out .and. s > floor)
               one%sigma(k) = sqrt(result%covariance(one%first + k - 1, one%first + k - 1))
               if (.not. one%is_known(k)) one%sigma(k) = quiet_nan_real64
            end do
         end associate
      end do
      do j = p, 1, -1
         if (.not. is_out(j)) exit
         names = ''
         do i = 1, size(result%of)
            associate (one => result%of(i))
               ! Position and velocity grow with the length: that is the length's, not theirs.
               growth = 0
               if (kind_of(one%setting) /= unknown_scalar) growth = growth_of_length(spread_of(:, j))
               is_plain = .true.
               do k = 1, one%elements
                  ! Of an unknown number, those directions that matter.
                  if (.not. one%is_known(k) .and. abs(spread_of(one%first + k - 1, j) - growth*one%value(k)) > &
                     0.1_wp*max(s(j), floor)*parts(one%first + k - 1)) is_plain = .false.
               end do
               if (.not. is_plain) names = names//'/'//trim(one%name)
            end associate
         end do
         if (len(names) > 1) call add_new(result%undetermined, names(2:))
      end do
      call say_known(result, spread_of, s, is_out)

   contains

      integer function kind_of(setting)
         integer, intent(in) :: setting

         kind_of = unknown_scalar
         if (setting == setting_place(pendulum_group, 'position')) kind_of = unknown_position
         if (setting == setting_place(pendulum_group, 'velocity')) kind_of = unknown_velocity
      end function kind_of

      !> Relative, along a direction; 0 where the length is known.
      real(wp) function growth_of_length(along) result(growth)
         real(wp), intent(in) :: along(:)
         integer :: i

         i = findloc(result%of%setting, setting_place(pendulum_group, 'length'), 1)
         growth = 0
         if (i > 0) growth = along(result%of(i)%first)/physics%length
      end function growth_of_length

      real(wp) function natural_size(setting, row)
         integer, intent(in) :: setting, row

         select case (kind_of(setting))
         case (unknown_position)
            natural_size = physics%length
         case (unknown_velocity)
            natural_size = max(sqrt(physics%gravity*physics%length), norm2(physics%velocity))
         case default
            natural_size = maxval(abs(d(row, :)))
         end select
      end function natural_size
   end subroutine find_sigmas

   subroutine add_new(texts, text)
      type(text_type), allocatable, intent(inout) :: texts(:)
      character(len=*), intent(in) :: text
      integer :: i

      do i = 1, size(texts)
         if (texts(i)%text == text) return
      end do
      call append(texts, text)
   end subroutine add_new

   !> Names and values of the free settings.
   subroutine name_results(result, request)
      type(fit_result_type), intent(inout) :: result
      type(fit_request_type), intent(in) :: request
      integer :: i, first

      if (allocated(result%of)) deallocate (result%of)
      allocate (result%of(size(request%free)))
      first = 1
      do i = 1, size(request%free)
         associate (one => result%of(i))
            one%name = request%free(i)%name
            one%setting = request%free(i)%setting
            one%elements = settings(one%setting)%values
            one%first = first
            one%value = result%number(:, one%setting)
            one%sigma = quiet_nan_real64
            first = first + one%elements
         end associate
      end do
   end subroutine name_results

   !> Predictions, at the delays, residuals, chi2 and its probability: of the evaluation just made.
   subroutine keep_residuals(result, squared)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(in) :: squared(:)                 !! Whose squares the fit made least
      real(wp) :: f(size(squared))
      logical :: failed
      integer :: n

      n = size(result%model%used)
      result%predicted = result%model%h
      f = squared
      if (result%model%loss /= loss_squares) then
         associate (loss => result%model%loss)
            n = loss
            loss = loss_squares
            call result%model%evaluate(result%x, f, failed)
            loss = n
         end associate
      end if
      result%residual = -f(:size(result%model%used))
      result%chi2 = sum(f**2)
      result%p_value = chi2_probability(result%chi2, result%dof)
   end subroutine keep_residuals

end module kyvadlo_fit_sigmas
