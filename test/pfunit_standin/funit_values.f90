!> Any argument of an assertion as one kind of value: numbers, logicals and text of every kind and rank, flattened.
module funit_values
   use, intrinsic :: iso_fortran_env, only: int8, int16, int32, int64, real32, real64, real128
   implicit none
   private
   public :: qp, values_type, flat, one, rounded, image, list, conformable, subscripts

   integer, parameter :: qp = real128

   type :: values_type
      character(len=2) :: class = ''           !! As kind_of gives it; blank for an empty array
      complex(qp), allocatable :: v(:)         !! The elements in array order; logicals are 0 or 1
      integer, allocatable :: shape(:)         !! Of the argument
      character(len=:), allocatable :: s       !! The text, where the argument is one
      logical :: supported = .true.            !! False for a rank that is not read here
   end type values_type

contains

   !> Elements, shape and kind of `x`, of rank 0 to 3.
   function flat(x) result(f)
      class(*), intent(in) :: x(..)
      type(values_type) :: f
      allocate (f%shape, source=shape(x))
      select rank (x)
      rank (0)
         f%class = kind_of(x)
         f%v = [one(x)]
         select type (x)
         type is (character(len=*)); f%s = x
         end select
      rank (1)
         if (size(x) > 0) f%class = kind_of(x(1))
         f%v = one(x)
      rank (2)
         if (size(x) > 0) f%class = kind_of(x(1, 1))
         f%v = reshape(one(x), [size(x)])
      rank (3)
         if (size(x) > 0) f%class = kind_of(x(1, 1, 1))
         f%v = reshape(one(x), [size(x)])
      rank default
         f%supported = .false.
         f%v = [complex(qp) ::]
      end select
   end function flat

   !> A scalar of any kind as a complex number; text and derived types give 0.
   elemental complex(qp) function one(x)
      class(*), intent(in) :: x
      one = 0
      select type (x)
      type is (integer(int8)); one = x
      type is (integer(int16)); one = x
      type is (integer(int32)); one = x
      type is (integer(int64)); one = x
      type is (real(real32)); one = x
      type is (real(real64)); one = x
      type is (real(real128)); one = x
      type is (complex(real32)); one = x
      type is (complex(real64)); one = x
      type is (complex(real128)); one = x
      type is (logical); one = merge(1, 0, x)
      end select
   end function one

   !> Two letters for type and kind: r8 is real64, i4 int32, l a logical, s text, ? anything else.
   pure character(len=2) function kind_of(x)
      class(*), intent(in) :: x
      select type (x)
      type is (integer(int8)); kind_of = 'i1'
      type is (integer(int16)); kind_of = 'i2'
      type is (integer(int32)); kind_of = 'i4'
      type is (integer(int64)); kind_of = 'i8'
      type is (real(real32)); kind_of = 'r4'
      type is (real(real64)); kind_of = 'r8'
      type is (real(real128)); kind_of = 'rq'
      type is (complex(real32)); kind_of = 'c4'
      type is (complex(real64)); kind_of = 'c8'
      type is (complex(real128)); kind_of = 'cq'
      type is (logical); kind_of = 'l'
      type is (character(len=*)); kind_of = 's'
      class default; kind_of = '?'
      end select
   end function kind_of

   !> z as the kind named by `class` holds it.
   pure complex(qp) function rounded(z, class)
      complex(qp), intent(in) :: z
      character(len=2), intent(in) :: class
      select case (class(2:2))
      case ('4'); rounded = cmplx(z, kind=real32)
      case ('8'); rounded = cmplx(z, kind=real64)
      case default; rounded = z
      end select
      if (class(1:1) == 'i') rounded = z
   end function rounded

   !> A value as a message shows it, in the digits of its kind.
   function image(z, class) result(text)
      complex(qp), intent(in) :: z
      character(len=2), intent(in) :: class
      character(len=:), allocatable :: text
      character(100) :: b
      select case (class)
      case ('r4'); write (b, '(g0)') real(z, real32)
      case ('r8'); write (b, '(g0)') real(z, real64)
      case ('rq'); write (b, '(g0)') real(z, real128)
      case ('c4'); write (b, '("(",g0,",",g0,")")') cmplx(z, kind=real32)
      case ('c8'); write (b, '("(",g0,",",g0,")")') cmplx(z, kind=real64)
      case ('cq'); write (b, '("(",g0,",",g0,")")') z
      case ('l'); b = merge('true ', 'false', real(z) > 0)
      case default; write (b, '(i0)') int(z, int64)
      end select
      text = trim(b)
   end function image

   !> [1, 2, 3]
   function list(n) result(text)
      integer, intent(in) :: n(:)
      character(len=:), allocatable :: text
      character(100) :: b
      write (b, '("[",*(i0,:,", "))') n
      text = trim(b)//']'
   end function list

   !> The same shape?
   pure logical function conformable(a, b)
      integer, intent(in) :: a(:), b(:)
      conformable = size(a) == size(b)
      if (conformable) conformable = all(a == b)
   end function conformable

   !> Subscripts of element `i`, in array order, of an array of this shape.
   pure function subscripts(i, shape) result(s)
      integer, intent(in) :: i, shape(:)
      integer :: s(size(shape)), k, rest
      rest = i - 1
      do k = 1, size(shape)
         s(k) = mod(rest, shape(k)) + 1
         rest = rest/shape(k)
      end do
   end function subscripts

end module funit_values
