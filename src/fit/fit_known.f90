!> Of numbers that data do not tell, what they tell of them together.
module kyvadlo_fit_known
   use kyvadlo_fit_result, only: digits_by, element_name, fit_result_type, sigma_digits
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_number_text, only: digits_text
   use kyvadlo_scene_groups, only: pendulum_group, setting_place, settings
   implicit none
   private
   public :: say_known

contains

   !> Of every two numbers that go together: their ratio or product, their sum or difference where they have one unit,
   !> else the sum with a factor that is known near this minimum. Of positions and velocities: in lengths.
   subroutine say_known(result, spread_of, s, is_out)
      type(fit_result_type), intent(inout) :: result
      real(wp), intent(in) :: spread_of(:, :)            !! (elements, directions) along singular directions
      real(wp), intent(in) :: s(:)                       !! Singular values
      logical, intent(in) :: is_out(:)                   !! The directions of the valley
      !> What the valley moves less than so, of what it moves the numbers themselves, is known.
      real(wp), parameter :: little = 0.05_wp
      real(wp) :: along(size(s))
      integer, allocatable :: of(:), element(:)          !! Of all unknown numbers
      integer :: i, k, length

      result%known = ''
      length = setting_place(pendulum_group, 'length')
      of = [((i, k=1, result%of(i)%elements), i=1, size(result%of))]
      element = [((k, k=1, result%of(i)%elements), i=1, size(result%of))]
      i = size(of)
      of = pack(of, [(.not. result%of(of(k))%is_known(element(k)), k=1, i)])
      element = pack(element, .not. [((result%of(i)%is_known(k), k=1, result%of(i)%elements), i=1, size(result%of))])
      do i = 1, size(of)
         do k = 1, size(of)
            if (is_state(of(k))) then
               if (result%of(of(i))%setting == length) call try_ratio(of(k), element(k), of(i), 1)
            else if (k > i .and. .not. is_state(of(i))) then
               call try_pair(of(i), element(i), of(k), element(k))
            end if
         end do
      end do
      if (len(result%known) > 2) result%known = result%known(:len(result%known) - 2)

   contains

      !> Below it singular values are rounding.
      real(wp) function smallest()
         smallest = max(1e-11_wp*s(1), tiny(1.0_wp))
      end function smallest

      !> How far the valley moves something.
      real(wp) function out(along)
         real(wp), intent(in) :: along(:)

         out = sqrt(sum((along/max(s, smallest()))**2, is_out))
      end function out

      !> Position and velocity, which come in threes.
      logical function is_state(i)
         integer, intent(in) :: i

         is_state = any(result%of(i)%setting == [setting_place(pendulum_group, 'position'), &
            setting_place(pendulum_group, 'velocity')])
      end function is_state

      !> What is known of two numbers, element m of setting i and element n of setting k: the first that is.
      subroutine try_pair(i, m, k, n)
         integer, intent(in) :: i, m, k, n
         integer :: before
         real(wp) :: factor

         before = len(result%known)
         associate (a => result%of(i), b => result%of(k), va => spread_of(result%of(i)%first + m - 1, :), &
               vb => spread_of(result%of(k)%first + n - 1, :))
            if (a%value(m) > 0 .and. b%value(n) > 0) then
               call try_ratio(i, m, k, n)
               along = va/a%value(m) + vb/b%value(n)
               if (out(along) < little) call say(element_name(a, m)//'*'//element_name(b, n), a%value(m)*b%value(n), &
                  along*a%value(m)*b%value(n))
            end if
            if (len(result%known) > before) return
            if (settings(a%setting)%unit == settings(b%setting)%unit) then
               call try_sum(i, m, k, n, 1.0_wp)
               call try_sum(i, m, k, n, -1.0_wp)
            end if
            if (len(result%known) > before .or. .not. out(vb) > 0) return
            factor = -sum(va*vb/max(s, smallest())**2, is_out)/out(vb)**2
            if (abs(factor) > 0) call try_sum(i, m, k, n, factor)
         end associate
      end subroutine try_pair

      !> Element m of setting i over element n of setting k.
      subroutine try_ratio(i, m, k, n)
         integer, intent(in) :: i, m, k, n

         associate (a => result%of(i), b => result%of(k))
            if (a%is_known(m) .or. b%is_known(n) .or. .not. abs(a%value(m)*b%value(n)) > 0) return
            along = (spread_of(a%first + m - 1, :) - a%value(m)/b%value(n)*spread_of(b%first + n - 1, :))/b%value(n)
            if (out(along) < little*norm2(a%value(:a%elements))/abs(b%value(n))) &
               call say(element_name(a, m)//'/'//element_name(b, n), a%value(m)/b%value(n), along)
         end associate
      end subroutine try_ratio

      !> The sum of two, the second times a factor.
      subroutine try_sum(i, m, k, n, factor)
         integer, intent(in) :: i, m, k, n
         real(wp), intent(in) :: factor
         character(len=:), allocatable :: text

         associate (a => result%of(i), b => result%of(k), va => spread_of(result%of(i)%first + m - 1, :), &
               vb => spread_of(result%of(k)%first + n - 1, :))
            along = va + factor*vb
            if (.not. out(along) < little*min(out(va), out(factor*vb))) return
            text = element_name(a, m)//merge(' + ', ' - ', factor > 0)
            if (abs(factor) < 1 .or. abs(factor) > 1) text = text//digits_text(abs(factor), 4)//'*'
            call say(text//element_name(b, n), a%value(m) + factor*b%value(n), along)
         end associate
      end subroutine try_sum

      subroutine say(what, value, along)
         character(len=*), intent(in) :: what
         real(wp), intent(in) :: value, along(:)
         real(wp) :: sigma

         sigma = sqrt(sum((along/s)**2, .not. is_out))
         result%known = result%known//what//' = '//digits_text(value, digits_by(value, sigma))//' +- '// &
            digits_text(sigma, sigma_digits)//'; '
      end subroutine say
   end subroutine say_known

end module kyvadlo_fit_known
