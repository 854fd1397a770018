!> Any argument of an assertion as one kind of value: numbers, logicals and text of every kind and rank, flattened.
module funit_values
   use, intrinsic :: iso_fortran_env, only: int8, int16, int32, int64, real32, real64
#ifndef KYVADLO_NO_REAL128
   use, intrinsic :: iso_fortran_env, only: real128
#endif
   implicit none
   private
   public :: qp, values_type, flat, one, rounded, image, list, conformable, subscripts

   !> The widest kind that there is.
#ifdef KYVADLO_NO_REAL128
   integer, parameter :: qp = merge(selected_real_kind(18), real64, selected_real_kind(18) > 0)
#else
   integer, parameter :: qp = real128
#endif

   type :: values_type
      character(len=2) :: class = ''           !! As kind_of gives it; blank for an empty array
      complex(qp), allocatable :: v(:)         !! The elements in array order; logicals are 0 or 1
      integer, allocatable :: shape(:)         !! Of the argument
      character(len=:), allocatable :: s       !! The text, where the argument is one
   end type values_type

   !> Elements, shape and kind of any argument of rank 0 to 3.
   interface flat
      module procedure flat_scalar, flat_vector, flat_matrix, flat_cube
   end interface flat

contains

   function flat_scalar(x) result(f)
      class(*), intent(in) :: x
      type(values_type) :: f
      f%class = kind_of(x)
      allocate (f%v(1), f%shape(0))
      f%v(1) = one(x)
      select type (x)
      type is (character(len=*)); f%s = x
      end select
   end function flat_scalar

   function flat_vector(x) result(f)
      class(*), intent(in) :: x(:)
      type(values_type) :: f
      integer :: i
      allocate (f%v(size(x)))
      f%shape = shape(x)
      if (size(x) > 0) f%class = kind_of(x(1))
      do i = 1, size(x)
         f%v(i) = one(x(i))
      end do
   end function flat_vector

   function flat_matrix(x) result(f)
      class(*), intent(in) :: x(:, :)
      type(values_type) :: f, column
      integer :: i
      allocate (f%v(size(x)))
      do i = 1, size(x, 2)
         column = flat_vector(x(:, i))
         f%v((i - 1)*size(x, 1) + 1:i*size(x, 1)) = column%v
         f%class = column%class
      end do
      f%shape = shape(x)
   end function flat_matrix

   function flat_cube(x) result(f)
      class(*), intent(in) :: x(:, :, :)
      type(values_type) :: f, layer
      integer :: i, many
      allocate (f%v(size(x)))
      many = size(x, 1)*size(x, 2)
      do i = 1, size(x, 3)
         layer = flat_matrix(x(:, :, i))
         f%v((i - 1)*many + 1:i*many) = layer%v
         f%class = layer%class
      end do
      f%shape = shape(x)
   end function flat_cube

   !> A scalar of any kind as a complex number; text and derived types give 0.
   pure complex(qp) function one(x)
      class(*), intent(in) :: x
      one = 0
      select type (x)
      type is (integer(int8)); one = x
      type is (integer(int16)); one = x
      type is (integer(int32)); one = x
      type is (integer(int64)); one = x
      type is (real(real32)); one = x
      type is (real(real64)); one = x
#ifndef KYVADLO_WIDEST_IS_DOUBLE
      type is (real(qp)); one = x
#endif
      type is (complex(real32)); one = x
      type is (complex(real64)); one = x
#ifndef KYVADLO_WIDEST_IS_DOUBLE
      type is (complex(qp)); one = x
#endif
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
#ifndef KYVADLO_WIDEST_IS_DOUBLE
      type is (real(qp)); kind_of = 'rq'
#endif
      type is (complex(real32)); kind_of = 'c4'
      type is (complex(real64)); kind_of = 'c8'
#ifndef KYVADLO_WIDEST_IS_DOUBLE
      type is (complex(qp)); kind_of = 'cq'
#endif
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
      case ('rq'); write (b, '(g0)') real(z, qp)
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
