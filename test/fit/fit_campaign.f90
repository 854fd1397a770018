!> Synthetic sets of five cases (synthetic_sets.f90), fitted from no guess: how many end in the right minimum, whether the
!> error bars are true, and how near they are to the least that any method can have.
!>
!>     fit_campaign SETS [CASE]           the figures; status 1 if one is not what doc/fitting.md says
!>     fit_campaign SETS CASE --from SEED the seeds from that on
!>     fit_campaign SETS [CASE] --more    one parameter more is free, and must be named as undetermined
!>     fit_campaign --write CASE SEED     set.nml and set.csv
!>
!> A minimum is right where every number is within 6 sigmas of the truth. (A camera along y shows y and -y alike: the mirror
!> image is as right.) The least sigmas are those of Cramer and Rao at the truth, by the integrator that made the data.
program fit_campaign
   use, intrinsic :: iso_fortran_env, only: output_unit, wp => real64
   use kyvadlo_fit, only: fit_measurements, fit_result_type
   use kyvadlo_fit_data, only: fit_data_type, parse_fit_data
   use kyvadlo_fit_request, only: fit_request_type, parse_fit_request
   use kyvadlo_quantiles, only: median
   use kyvadlo_status, only: error_type
   use synthetic_sets, only: new_set, predict, report, set_type
   implicit none
   integer :: sets, case, only_case, i, faults, seed, first_seed
   character(len=40) :: word
   logical :: with_more

   sets = 25
   only_case = 0
   with_more = .false.
   call get_command_argument(1, word)
   if (word == '--write') then
      call get_command_argument(2, word)
      read (word, *) case
      call get_command_argument(3, word)
      read (word, *) seed
      call write_set(case, seed)
      stop
   end if
   if (word /= '') read (word, *) sets
   first_seed = 1
   do i = 2, command_argument_count()
      call get_command_argument(i, word)
      if (word == '--more') then
         with_more = .true.
      else if (word == '--from') then
         call get_command_argument(i + 1, word)
         read (word, *) first_seed
         exit
      else
         read (word, *) only_case
      end if
   end do
   faults = 0
   do case = 1, 5
      if (only_case /= 0 .and. case /= only_case) cycle
      if (with_more) then
         call run_with_more(case, sets)
      else
         call run(case, sets)
      end if
   end do
   if (faults > 0) stop 1, quiet=.true.

contains

   subroutine run(case, sets)
      integer, intent(in) :: case, sets
      type(set_type) :: set
      real(wp), allocatable :: pull(:), pulls(:, :), ratio(:), ratios(:, :), values(:), sigmas(:), least(:)
      real(wp) :: milliseconds(sets), mean, width
      integer :: seed, right, i, near
      real(wp) :: begun, ended
      type(fit_result_type) :: result
      character(len=300) :: wrong(20)
      character(len=:), allocatable :: fault

      right = 0
      near = 0
      do seed = first_seed, first_seed + sets - 1
         call new_set(set, case, seed, .false.)
         if (seed == first_seed) allocate (pulls(size(set%truth), sets), ratios(size(set%truth), sets))
         call cpu_time(begun)
         call fit(set, result, fault)
         call cpu_time(ended)
         milliseconds(seed - first_seed + 1) = 1e3_wp*(ended - begun)
         if (fault == '') then
            call numbers_of(result, values, sigmas)
            pull = (values - set%truth)/sigmas
            if (case == 5) then
               ! position and velocity along y
               if (abs(values(3) + set%truth(3)) + abs(values(6) + set%truth(6)) < &
                  abs(values(3) - set%truth(3)) + abs(values(6) - set%truth(6))) values([3, 6]) = -values([3, 6])
               pull = (values - set%truth)/sigmas
            end if
            if (size(result%undetermined) > 0) fault = 'undetermined '//result%undetermined(1)%text
            if (.not. all(abs(pull) < 6)) fault = fault//' pulls'
            if (fault /= '') then
               write (wrong(1), '(a,f9.3,a,*(es10.2))') fault, result%chi2/result%dof, ' chi2/dof,', pull
               fault = trim(wrong(1))
            end if
         end if
         if (fault == '') then
            right = right + 1
            pulls(:, right) = pull
            least = least_sigmas(set)
            ratio = sigmas/least
            ratios(:, right) = ratio
            if (all(ratio > 0.9_wp .and. ratio < 1.1_wp)) then
               near = near + 1
            else
               write (output_unit, '(a,i0,a,*(f7.3))') '   set ', seed, ': sigmas over the least:', ratio
            end if
         else
            write (output_unit, '(a,i0,2a)') '   set ', seed, ': ', fault
         end if
         if (mod(seed, 100) == 0) flush (output_unit)
      end do
      write (output_unit, '(a,i0,a,i0,a,i0,a,i0,a,f0.1,a,f0.1,a)') 'case ', case, ': ', right, ' of ', sets, &
         ' right; sigmas within 10 % of the least in ', near, '; ', median(milliseconds), ' ms the median, ', &
         maxval(milliseconds), ' the longest'
      if (right < sets) faults = faults + 1
      if (near < right) faults = faults + 1
      if (right < 2) return
      do i = 1, size(pulls, 1)
         mean = sum(pulls(i, :right))/right
         width = sqrt(sum((pulls(i, :right) - mean)**2)/(right - 1))
         write (output_unit, '(3x,a12,a,f7.3,a,f6.3,a,f6.3,a,f6.3)') set%names(i), ' pull', mean, ' +-', width, &
            '   sigma over the least', minval(ratios(i, :right)), ' to', maxval(ratios(i, :right))
         ! Of n pulls the mean varies by 1/sqrt(n), the width by 1/sqrt(2 n); four of these are allowed.
         if (.not. abs(mean) < max(0.1_wp, 4/sqrt(real(sets, wp)))) faults = faults + 1
         if (.not. abs(width - 1) < max(0.07_wp, 4/sqrt(2*real(sets, wp)))) faults = faults + 1
      end do
   end subroutine run

   subroutine run_with_more(case, sets)
      integer, intent(in) :: case, sets
      type(set_type) :: set
      type(fit_result_type) :: result
      character(len=:), allocatable :: fault
      integer :: seed, right, i
      logical :: named, silent

      right = 0
      do seed = 1, sets
         call new_set(set, case, seed, .true.)
         call fit(set, result, fault)
         if (fault == '') then
            named = .false.
            do i = 1, size(result%undetermined)
               if (index('/'//result%undetermined(i)%text//'/', '/'//trim(set%more)//'/') > 0) named = .true.
            end do
            silent = .false.
            do i = 1, size(result%of)
               if (result%of(i)%name == set%more) silent = .not. result%of(i)%is_known(1)
            end do
            if (.not. named) fault = trim(set%more)//' is not named'
            if (.not. silent) fault = fault//' '//trim(set%more)//' has a sigma'
         end if
         if (fault == '') then
            right = right + 1
         else
            write (output_unit, '(a,i0,2a)') '   set ', seed, ': ', fault
         end if
      end do
      write (output_unit, '(a,i0,3a,i0,a,i0)') 'case ', case, ' with ', trim(set%more), &
         ' free too: found undetermined in ', right, ' of ', sets
      if (right < sets) faults = faults + 1
   end subroutine run_with_more

   subroutine fit(set, result, fault)
      type(set_type), intent(in) :: set
      type(fit_result_type), intent(out) :: result
      character(len=:), allocatable, intent(out) :: fault
      type(fit_request_type) :: request
      type(fit_data_type) :: data
      type(error_type), allocatable :: error

      fault = ''
      call parse_fit_request(set%scene, 'set.nml', request, error)
      if (.not. allocated(error)) call parse_fit_data(set%table, 'set.csv', data, error)
      if (.not. allocated(error)) call fit_measurements(request, data, result, error)
      if (allocated(error)) then
         fault = error%message
      else if (.not. result%is_converged) then
         fault = 'no minimum'
      end if
   end subroutine fit

   subroutine numbers_of(result, values, sigmas)
      type(fit_result_type), intent(in) :: result
      real(wp), allocatable, intent(out) :: values(:), sigmas(:)
      integer :: i

      allocate (values(0), sigmas(0))
      do i = 1, size(result%of)
         associate (one => result%of(i))
            values = [values, one%value(:one%elements)]
            sigmas = [sigmas, one%sigma(:one%elements)]
         end associate
      end do
   end subroutine numbers_of

   !> Standard deviations of what a fit reports, by the bound of Cramer and Rao: from F = J'J/sigma**2.
   function least_sigmas(set) result(sigmas)
      type(set_type), intent(in) :: set
      real(wp), allocatable :: sigmas(:)
      real(wp), allocatable :: j(:, :), r(:, :), f(:, :), inverse(:, :), up(:), down(:)
      real(wp) :: h
      integer :: i, k, p

      p = size(set%free)
      allocate (j(size(set%measured), p), r(size(set%truth), p))
      do i = 1, p
         up = set%theta
         down = set%theta
         h = 1e-5_wp*set%steps(set%free(i))
         up(set%free(i)) = up(set%free(i)) + h
         down(set%free(i)) = down(set%free(i)) - h
         ! In steps of 1: sizes of one another.
         j(:, i) = (predict(set, up) - predict(set, down))/(2e-5_wp*set%sigma)
         r(:, i) = (report(set, up) - report(set, down))/2e-5_wp
      end do
      do i = 1, p
         h = norm2(j(:, i))
         j(:, i) = j(:, i)/h
         r(:, i) = r(:, i)/h
      end do
      f = matmul(transpose(j), j)
      allocate (inverse(p, p))
      inverse = 0
      do i = 1, p
         inverse(i, i) = 1
      end do
      ! Gauss and Jordan; f is positive definite with a diagonal of ones.
      do i = 1, p
         inverse(i, :) = inverse(i, :)/f(i, i)
         f(i, :) = f(i, :)/f(i, i)
         do k = 1, p
            if (k == i) cycle
            inverse(k, :) = inverse(k, :) - f(k, i)*inverse(i, :)
            f(k, :) = f(k, :) - f(k, i)*f(i, :)
         end do
      end do
      sigmas = sqrt([(dot_product(r(i, :), matmul(inverse, r(i, :))), i=1, size(r, 1))])
   end function least_sigmas

   subroutine write_set(case, seed)
      integer, intent(in) :: case, seed
      type(set_type) :: set
      integer :: unit, i

      call new_set(set, case, seed, .false.)
      open (newunit=unit, file='set.nml', access='stream', form='unformatted', status='replace')
      write (unit) set%scene
      close (unit)
      open (newunit=unit, file='set.csv', access='stream', form='unformatted', status='replace')
      write (unit) set%table
      close (unit)
      do i = 1, size(set%truth)
         write (output_unit, '(a,es25.16)') set%names(i), set%truth(i)
      end do
   end subroutine write_set

end program fit_campaign
