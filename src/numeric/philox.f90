!> Philox4x32-10, a generator that keeps no state: key and counter in, four words of 32 bits out. J. K. Salmon and
!> others, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011). Whoever computes number i gets the
!> same.
module kyvadlo_philox
   use, intrinsic :: iso_fortran_env, only: int64, real64
   implicit none
   private
   public :: philox_words, philox_key, philox_uniform, checksum

   integer(int64), parameter :: word_mask = 4294967295_int64     !! 2**32 - 1

contains

   !> Ten rounds. Every number holds 32 bits.
   pure function philox_words(counter, key) result(words)
      integer(int64), intent(in) :: counter(4), key(2)
      integer(int64) :: words(4)
      integer(int64), parameter :: multipliers(2) = [int(z'D2511F53', int64), int(z'CD9E8D57', int64)]
      integer(int64), parameter :: increments(2) = [int(z'9E3779B9', int64), int(z'BB67AE85', int64)]
      integer(int64) :: round_key(2), high(2), low(2)
      integer :: round

      words = counter
      round_key = key
      do round = 1, 10
         call multiply(multipliers(1), words(1), high(1), low(1))
         call multiply(multipliers(2), words(3), high(2), low(2))
         words = [ieor(ieor(high(2), words(2)), round_key(1)), low(2), &
            ieor(ieor(high(1), words(4)), round_key(2)), low(1)]
         round_key = iand(round_key + increments, word_mask)
      end do
   end function philox_words

   !> The two halves of a product of two words, without leaving int64.
   pure subroutine multiply(a, b, high, low)
      integer(int64), intent(in) :: a, b
      integer(int64), intent(out) :: high, low
      integer(int64), parameter :: half_mask = 65535
      integer(int64) :: lower, upper

      lower = a*iand(b, half_mask)
      upper = a*shiftr(b, 16) + shiftr(lower, 16)
      high = shiftr(upper, 16)
      low = ior(shiftl(iand(upper, half_mask), 16), iand(lower, half_mask))
   end subroutine multiply

   !> The key of a seed and a name: the seed's lower word, and its upper word with the name's checksum.
   pure function philox_key(seed, name) result(key)
      integer(int64), intent(in) :: seed           !! Not negative
      character(len=*), intent(in) :: name
      integer(int64) :: key(2)

      key = [iand(seed, word_mask), ieor(checksum(name), shiftr(seed, 32))]
   end function philox_key

   !> FNV-1a of 32 bits (Fowler, Noll, Vo).
   pure integer(int64) function checksum(text)
      character(len=*), intent(in) :: text
      integer(int64), parameter :: basis = 2166136261_int64, prime = 16777619_int64
      integer :: i

      checksum = basis
      do i = 1, len(text)
         checksum = iand(ieor(checksum, int(iachar(text(i:i)), int64))*prime, word_mask)
      end do
   end function checksum

   !> Number `index` (from 0) of a key, evenly spread between 0 and 1, both excluded: the middle of one of 2**52 parts.
   pure real(real64) function philox_uniform(key, index) result(number)
      integer(int64), intent(in) :: key(2), index
      integer(int64) :: words(4)

      words = philox_words([iand(index, word_mask), shiftr(index, 32), 0_int64, 0_int64], key)
      number = (real(ior(shiftl(words(1), 20), shiftr(words(2), 12)), real64) + 0.5_real64)*2.0_real64**(-52)
   end function philox_uniform

end module kyvadlo_philox
