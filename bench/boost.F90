!> Boost's side of `kyvadlo-bench --functions`; where its headers were not found it has no function.
module kyvadlo_bench_boost
   use, intrinsic :: iso_fortran_env, only: real64
   use, intrinsic :: iso_c_binding, only: c_int, c_double
   implicit none
   private
   public :: boost_values

#ifdef KYVADLO_WITH_BOOST
   interface
      !> Calls one function of Boost for every row; 0 if it has none for this id, see boost.cpp.
      function kyvadlo_boost_values(id, promotes, rows, x, out) bind(c) result(has)
         import :: c_int, c_double
         integer(c_int), intent(in), value :: id, promotes, rows
         real(c_double), intent(in) :: x(rows, 4)
         real(c_double), intent(inout) :: out(rows, 4)
         integer(c_int) :: has
      end function kyvadlo_boost_values
   end interface
#endif

contains

   !> Boost's values at the arguments of `our_values`, with the modulus in the place of the parameter.
   subroutine boost_values(id, promotes, x, out, has)
      integer, intent(in) :: id
      logical, intent(in) :: promotes         !! Boost as it comes, computing in long double
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: out(:,:)
      logical, intent(out) :: has             !! Boost is here and has the function

#ifdef KYVADLO_WITH_BOOST
      has = kyvadlo_boost_values(int(id, c_int), merge(1_c_int, 0_c_int, promotes), int(size(x, 1), c_int), x, out) /= 0
#else
      has = .false.
      if (id < 0 .and. promotes) out = x ! Every argument is referred to in either build.
#endif
   end subroutine boost_values

end module kyvadlo_bench_boost
