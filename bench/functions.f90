!> `kyvadlo-bench --functions`: the elliptic functions timed beside GSL and Boost where they are linked in, and beside
!> what was measured once of other libraries, in units of a scalar sine of the C library.
module kyvadlo_bench_functions
   use, intrinsic :: iso_fortran_env, only: int64, real64, real128
   use kyvadlo, only: elliptic_f
   use kyvadlo_bench_rows, only: rows, by_modulus, print_head, print_row
   use kyvadlo_function_ids, only: id_zeta, points, set_ups
   use kyvadlo_function_values, only: our_values
   use kyvadlo_function_values_gsl, only: gsl_values
   use kyvadlo_bench_boost, only: boost_values
   use kyvadlo_stopwatch, only: median, nanoseconds_since
   implicit none
   private
   public :: bench_functions

contains

   !> Measures and prints the table. Every figure is a median; all columns of a row are measured in turn, pass by pass.
   subroutine bench_functions(unit, quick)
      integer, intent(in) :: unit    !! Where to print
      logical, intent(in) :: quick   !! A tenth of the passes: to see that it runs, not to measure
      real(real64), allocatable :: x(:,:), by_k(:,:), out(:,:), ours(:), theirs(:,:), sine(:), sines(:)
      real(real64) :: checksum, error(0:2)
      integer :: row, pass, passes, library, checked, i
      logical :: has(3)

      passes = merge(3, 31, quick)
      checked = merge(50, 400, quick)
      allocate (x(points, 4), out(points, 4), ours(passes), theirs(passes, 3), sine(passes))
      sines = [(6.28_real64*i/points, i=1, points)]
      checksum = 0
      call print_head(unit)
      do row = 1, size(rows)
         call draw(row, x)
         by_k = with_modulus(row, x)
         out = 0
         has = .true.
         has(1) = rows(row)%arguments /= 'p < 0' ! GSL has no principal values.
         do pass = 0, passes ! The first pass warms the caches and is not counted.
            call time_sine(sines, sine(max(pass, 1)), checksum)
            call time_ours(row, x, out, ours(max(pass, 1)), checksum)
            do library = 1, 3
               if (.not. has(library)) cycle
               if (by_modulus(row, library)) then
                  call time_theirs(row, library, by_k, out, theirs(max(pass, 1), library), checksum, has(library))
               else
                  call time_theirs(row, library, x, out, theirs(max(pass, 1), library), checksum, has(library))
               end if
            end do
         end do
         error = -1
         call our_values(rows(row)%id, x, out)
         error(0) = worst_error(row, x(:checked, :), out(:checked, :), .false.)
         do library = 1, 2
            if (.not. has(library)) cycle
            if (by_modulus(row, library)) then
               call their_values(row, library, by_k, out, has(library))
            else
               call their_values(row, library, x, out, has(library))
            end if
            error(library) = worst_error(row, x(:checked, :), out(:checked, :), by_modulus(row, library))
         end do
         call print_row(unit, row, median(ours), median(sine), [(median(theirs(:, library)), library=1, 3)], has, error)
      end do
      write (unit, '(a,es22.15)') 'Sum of all values computed: ', checksum
   end subroutine bench_functions

   !> Nanoseconds a call of the scalar sine.
   subroutine time_sine(x, time, checksum)
      real(real64), intent(in) :: x(:)
      real(real64), intent(out) :: time
      real(real64), intent(inout) :: checksum
      real(real64) :: total
      integer(int64) :: start
      integer :: i

      call system_clock(start)
      total = 0
      do i = 1, size(x)
         total = total + sin(x(i))
      end do
      time = nanoseconds_since(start)/size(x)
      checksum = checksum + total
   end subroutine time_sine

   !> Nanoseconds a call of our function.
   subroutine time_ours(row, x, out, time, checksum)
      integer, intent(in) :: row
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: out(:,:), checksum
      real(real64), intent(out) :: time
      integer(int64) :: start

      call system_clock(start)
      call our_values(rows(row)%id, x, out)
      time = nanoseconds_since(start)/size(x, 1)
      checksum = checksum + sum(out)
   end subroutine time_ours

   !> Nanoseconds a call of a library's function; `has` is false if the library is not here or has no such function.
   subroutine time_theirs(row, library, x, out, time, checksum, has)
      integer, intent(in) :: row, library
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: out(:,:), checksum
      real(real64), intent(out) :: time
      logical, intent(out) :: has
      integer(int64) :: start

      call system_clock(start)
      call their_values(row, library, x, out, has)
      time = nanoseconds_since(start)/size(x, 1)
      if (has) checksum = checksum + sum(out)
   end subroutine time_theirs

   subroutine their_values(row, library, x, out, has)
      integer, intent(in) :: row, library  !! 1 GSL, 2 Boost without promotion, 3 Boost as it comes
      real(real64), intent(in) :: x(:,:)
      real(real64), intent(inout) :: out(:,:)
      logical, intent(out) :: has

      if (library == 1) then
         call gsl_values(rows(row)%id, x, out, has)
      else
         call boost_values(rows(row)%id, library == 3, x, out, has)
      end if
   end subroutine their_values

   !> The arguments with the modulus in place of the parameter.
   pure function with_modulus(row, x) result(y)
      integer, intent(in) :: row
      real(real64), intent(in) :: x(:,:)
      real(real64) :: y(size(x, 1), size(x, 2))
      integer :: at

      y = x
      at = rows(row)%parameter_at
      if (at > 0) y(:, at) = sqrt(x(:, at))
   end function with_modulus

   !> Worst distance from the value in quad precision: in ulps, or for values of order one that vanish somewhere in
   !> epsilons. A library that takes the modulus is held to the parameter that is exactly the square of its modulus.
   function worst_error(row, arguments, values, is_by_modulus) result(worst)
      integer, intent(in) :: row
      real(real64), intent(in) :: arguments(:,:), values(:,:)
      logical, intent(in) :: is_by_modulus
      real(real64) :: worst
      real(real128), dimension(size(values, 1), 4) :: x, exact, unit
      integer :: at, columns

      x = arguments
      at = rows(row)%parameter_at
      if (is_by_modulus .and. at > 0) x(:, at) = real(sqrt(arguments(:, at)), real128)**2
      if (rows(row)%id == id_zeta .and. is_by_modulus) x(:, 3) = elliptic_f(x(:, 1), x(:, 2))
      exact = 0
      call our_values(rows(row)%id, x, exact)
      unit = spacing(real(exact, real64))
      if (rows(row)%is_absolute) unit = epsilon(1.0_real64)
      columns = rows(row)%columns
      worst = real(maxval(abs(values(:, :columns) - exact(:, :columns))/unit(:, :columns)), real64)
   end function worst_error

   !> The arguments of a row: benign ones, the same in every run.
   subroutine draw(row, x)
      integer, intent(in) :: row
      real(real64), intent(out) :: x(:,:)
      integer :: i, seed_size

      call random_seed(size=seed_size)
      call random_seed(put=[(1953*i, i=1, seed_size)])
      call random_number(x)
      select case (rows(row)%arguments)
      case ('carlson')
         x = 10*x
      case ('p < 0')
         x = 10*x
         x(:, 4) = -x(:, 4)
      case ('m')
         continue
      case ('n m') ! Characteristic -2 ... 0.9
         x(:, 2) = x(:, 1)
         x(:, 1) = -2 + 2.9_real64*x(:, 3)
      case ('phi m')
         x(:, 1) = 1.5_real64*x(:, 1)
      case ('n phi m')
         x(:, 1) = -2 + 2.9_real64*x(:, 1)
         x(:, 2) = 1.5_real64*x(:, 2)
      case ('u m')
         x(:, 1) = -5 + 10*x(:, 1)
      case ('set-up')
         x(:, 1) = -5 + 10*x(:, 1)
         do i = 1, size(x, 1)
            x(i, 2) = x((i - 1)/(points/set_ups)*(points/set_ups) + 1, 2)
         end do
      case ('v q')
         x(:, 1) = -4 + 8*x(:, 1)
         x(:, 2) = 0.5_real64*x(:, 2)
      end select
      if (rows(row)%id == id_zeta) x(:, 3) = elliptic_f(x(:, 1), x(:, 2)) ! Ours takes u, Boost the amplitude.
   end subroutine draw

end module kyvadlo_bench_functions
