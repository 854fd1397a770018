!> Of numbers that data do not tell, what they tell of them together.
module kyvadlo_fit_known
   use kyvadlo_fit_result, only: element_name, fit_result_type
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
      real(wp) :: along(size(s)), factor
      integer :: i, k, m, length, before
      logical :: is_said

      result%known = ''
      length = setting_place(pendulum_group, 'length')
      do i = 1, size(result%of)
         if (result%of(i)%elements > 1) cycle
         associate (a => result%of(i), va => spread_of(result%of(i)%first, :))
            if (a%is_known(1)) cycle
            do k = 1, size(result%of)
               if (result%of(k)%elements > 1 .and. a%setting == length) then
                  do m = 1, result%of(k)%elements
                     call try_ratio(k, m, i, 1)
                  end do
               end if
               if (k <= i .or. result%of(k)%elements > 1 .or. result%of(k)%is_known(1)) cycle
               before = len(result%known)
               associate (b => result%of(k), vb => spread_of(result%of(k)%first, :))
                  if (a%value(1) > 0 .and. b%value(1) > 0) then
                     call try_ratio(i, 1, k, 1)
                     along = va/a%value(1) + vb/b%value(1)
                     if (out(along) < little) call say(trim(a%name)//'*'//trim(b%name), a%value(1)*b%value(1), &
                        along*a%value(1)*b%value(1))
                  end if
                  is_said = len(result%known) > before
                  if (is_said) cycle
                  if (settings(a%setting)%unit == settings(b%setting)%unit) then
                     call try_sum('+', 1.0_wp)
                     call try_sum('-', -1.0_wp)
                  end if
                  is_said = len(result%known) > before
                  if (is_said .or. .not. out(vb) > 0) cycle
                  factor = -sum(va*vb/max(s, smallest())**2, is_out)/out(vb)**2
                  if (factor > 0) call try_sum('+', factor)
                  if (factor < 0) call try_sum('-', factor)
               end associate
            end do
         end associate
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
      subroutine try_sum(sign_of, factor)
         character(len=1), intent(in) :: sign_of
         real(wp), intent(in) :: factor

         associate (a => result%of(i), b => result%of(k))
            along = spread_of(a%first, :) + factor*spread_of(b%first, :)
            if (.not. out(along) < little*min(out(spread_of(a%first, :)), out(factor*spread_of(b%first, :)))) return
            if (abs(factor) < 1 .or. abs(factor) > 1) then
               call say(trim(a%name)//' '//sign_of//' '//digits_text(abs(factor), 4)//'*'//trim(b%name), &
                  a%value(1) + factor*b%value(1), along)
            else
               call say(trim(a%name)//' '//sign_of//' '//trim(b%name), a%value(1) + factor*b%value(1), along)
            end if
         end associate
      end subroutine try_sum

      subroutine say(what, value, along)
         character(len=*), intent(in) :: what
         real(wp), intent(in) :: value, along(:)

         result%known = result%known//what//' = '//digits_text(value, 7)//' +- '// &
            digits_text(sqrt(sum((along/s)**2, .not. is_out)), 3)//'; '
      end subroutine say
   end subroutine say_known

end module kyvadlo_fit_known
