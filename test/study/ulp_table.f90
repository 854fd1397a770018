!> Prints the page doc/accuracy_tables.md: the worst error of every function, set of arguments and kind against the references in
!> test/reference, beside what is promised and what other libraries reach.
!>
!>     cd test/reference; ulp_table FILE...     (reference files without .dat)
!>
!> Exit status 1 if a promise is broken; the lines concerned go to standard error.
program ulp_table
   use, intrinsic :: iso_fortran_env, only: real32, real64, real128, output_unit, error_unit
   use errors_found, only: findings_type, finding_type, kinds
   use measure_rows, only: measure
   use peers, only: peer_type, read_peers, peer_cell
   use promises, only: promise_of, promise_type, label_of, title_of, is_elliptic
   use study_pages, only: write_machine, number_text
   implicit none

   character(len=20), allocatable :: questions(:)
   type(findings_type), allocatable :: findings(:)
   integer :: i, broken

   if (command_argument_count() < 1) error stop 'usage: ulp_table FILE...'
   allocate (questions(command_argument_count()), findings(command_argument_count()))
   do i = 1, size(questions)
      call get_command_argument(i, questions(i))
   end do
   broken = 0
   do i = 1, size(questions)
      call measure(trim(questions(i)), 1.0_real32, findings(i))
      call measure(trim(questions(i)), 1.0_real64, findings(i))
      call measure(trim(questions(i)), 1.0_real128, findings(i))
   end do

   call write_head()
   write (output_unit, '(a)') '## Beside other libraries', ''
   call write_peers()
   write (output_unit, '(a)') '## Elliptic functions, set by set', ''
   do i = 1, size(questions)
      if (is_elliptic(questions(i))) call write_question(trim(questions(i)), findings(i))
   end do
   write (output_unit, '(a)') '## The pendulum, regime by regime', ''
   do i = 1, size(questions)
      if (.not. is_elliptic(questions(i))) call write_question(trim(questions(i)), findings(i))
   end do
   deallocate (questions, findings)   ! the leak sanitizer counts what a main program keeps
   if (broken > 0) then
      write (error_unit, '(i0, a)') broken, ' promises are broken'
      stop 1, quiet=.true.
   end if

contains

   subroutine write_head()
      write (output_unit, '(a)') '# Accuracy: the tables', ''
      call write_machine('cmake --build build/release --target accuracy_page')
      write (output_unit, '(a)') &
         'Errors are in units in the last place (ulps) of the result, the largest of all rows of a set. The references are', &
         'values to 40 digits at the exact binary arguments, from mpmath, Arb or FLINT (`test/reference`, with the scripts', &
         'that made them). Where a function is ill-conditioned its value moves by more than an ulp when an argument moves by', &
         'half an ulp (the *condition*); where that is so the promise allows for it, and errors are given *beyond*', &
         'that allowance, and raw. The test `accuracy_keeps_its_promises` runs this program and fails if a promise is broken', &
         'or a result is NaN.', '', &
         'The rows of these tables are few. Many more, 20 000 a set in single precision and 2000 in double and in quadruple,', &
         'are compared with Arb by', '', &
         '```text', &
         'ctest --test-dir build/release -R functions_keep_their_promises_in_thousands_of_arguments --verbose', &
         '```', '', &
         'which takes an hour of one core, Python, python-flint and mpmath; `test/reference/function_campaign.py` says how to', &
         'ask for single functions or fewer rows. Nothing is promised of a ratio of Jacobian functions whose pole lies within', &
         'half an ulp of the argument.', '', &
         'In the tables of single sets every cell reads single / double / quad; the promise stands in the head of the column.', &
         'Quad errors are whole ulps, as the references are rounded to quad when they are read.', ''
   end subroutine write_head

   !> One row for each set, one column for each part of the answer: single / double / quad. Where the promise allows for the
   !> condition these are the errors beyond it, and the last column has the raw ones.
   subroutine write_question(question, found)
      character(len=*), intent(in) :: question
      type(findings_type), intent(in) :: found
      type(promise_type) :: promise
      character(len=:), allocatable :: line, rule
      real(real64) :: raw
      integer :: i, j, part, parts, rows(3)
      logical :: conditioned

      parts = maxval(found%line%part)
      conditioned = any([(any_slack(found, part), part=1, parts)]) .and. index(question, 'turning') == 0
      line = '| set | rows |'
      rule = '|---|---|'
      do part = 1, parts
         line = line//' '//label_of(question, part)//': '//promise_text(promise_of(question, part, ''))//' |'
         rule = rule//'---|'
      end do
      if (conditioned) then
         line = line//' double, raw |'
         rule = rule//'---|'
      end if
      write (output_unit, '(a)') '### '//title_of(question), '', line, rule
      do i = 1, size(found%line)
         if (any(found%line(:i - 1)%set == found%line(i)%set)) cycle
         line = ''
         raw = 0
         rows = 0
         do part = 1, parts
            line = line//' '
            do j = i, size(found%line)
               associate (f => found%line(j))
                  if (f%set /= found%line(i)%set .or. f%part /= part) cycle
                  promise = promise_of(question, part, f%set)
                  line = line//three(f%rows, merge(f%beyond, f%raw, conditioned))
                  raw = max(raw, f%raw(2))
                  ! Every row of a file gives part 1; of positions, those later than 1000 periods give part 3.
                  if (part == 1 .or. part == 3 .and. index(question, 'position') == 1) rows = rows + f%rows
                  if (all(f%beyond <= promise%ulp)) cycle
                  broken = broken + 1
                  write (error_unit, '(a)') question//', '//trim(f%set)//', '//label_of(question, part)//': ' &
                     //three(f%rows, f%beyond)//', promised '//promise_text(promise)
               end associate
            end do
            line = line//' |'
         end do
         if (conditioned) line = line//' '//number_text(raw)//' |'
         write (output_unit, '(a)') '| '//trim(found%line(i)%set)//' | '//rows_text(rows)//' |'//line
      end do
      if (index(question, 'turning') == 1) write (output_unit, '(a)') '', 'Raw errors.'
      if (index(question, 'ratios') == 1) write (output_unit, '(a)') '', &
         'Against quotients of the references of sn, cn, dn; the condition is the sum of those of both.'
      if (question == 'carlson_rj') write (output_unit, '(a)') '', 'For p < 0 (sets `negative_`) the promise is 6 + condition.'
      if (question == 'cubic') write (output_unit, '(a)') '', 'The count must be right; for the sets `exact_` 4 without condition.'
      write (output_unit, '(a)') ''
   end subroutine write_question

   function promise_text(promise) result(text)
      type(promise_type), intent(in) :: promise
      character(len=:), allocatable :: text

      text = number_text(promise%ulp)
      if (promise%eps > 0) text = text//' + '//number_text(promise%eps)//' eps'
      if (promise%slack > 0 .and. promise%slack <= 1) text = text//' + condition'
      if (promise%slack > 1) text = text//' + '//number_text(promise%slack)//' condition'
   end function promise_text

   !> One number for each kind that has rows.
   function three(rows, errors) result(text)
      integer, intent(in) :: rows(3)
      real(real64), intent(in) :: errors(3)
      character(len=:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, size(kinds)
         if (k > 1) text = text//' / '
         if (rows(k) == 0) text = text//'-'
         if (rows(k) > 0) text = text//number_text(errors(k))
      end do
   end function three

   function rows_text(rows) result(text)
      integer, intent(in) :: rows(3)
      character(len=:), allocatable :: text
      character(len=40) :: line

      write (line, '(i0, ", ", i0, ", ", i0)') rows
      text = trim(line)
   end function rows_text

   !> One line for each function in double precision; the others as in `test/study/peers.dat`.
   subroutine write_peers()
      type(peer_type), allocatable :: peer(:)
      character(len=:), allocatable :: line
      character(len=15), parameter :: columns(7) = [character(len=15) :: 'gsl', 'boost', 'boost_nopromote', 'scipy', &
         'fukushima', 'geographiclib', 'slatec']
      real(real64) :: benign, hard, beyond
      integer :: part, c
      !> No other library was measured.
      character(len=20), parameter :: unpaired(9) = [character(len=20) :: 'cubic', 'theta', 'theta_complex', 'ratios', &
         'ratiosc', 'bulirsch_cel', 'bulirsch_el1', 'bulirsch_el2', 'bulirsch_el3']

      call read_peers('../study/peers.dat', peer)
      write (output_unit, '(a)') &
         'Double precision: the largest error in ulps on benign arguments / on all hard sets, raw. For kyvadlo the number', &
         'in brackets is the largest error beyond the allowance for the condition, where the promise has one. The columns', &
         'of the other libraries are quoted from one measurement (`test/study/peers.dat` says which versions and', &
         'arguments; another, larger draw of the same kinds of sets). `fail` counts points with an error status, NaN, or', &
         'an error above 1e-6, which are not in the figure before it. Libraries that take the modulus k instead of m are', &
         'scored at their own k.', '', &
         '| function | kyvadlo | GSL | Boost | Boost, no long double | SciPy | Fukushima | GeographicLib | SLATEC |', &
         '|---|---|---|---|---|---|---|---|---|'
      do i = 1, size(questions)
         if (.not. is_elliptic(questions(i)) .or. any(questions(i) == unpaired)) cycle
         do part = 1, maxval(findings(i)%line%part)
            benign = maxval(findings(i)%line%raw(2), mask=findings(i)%line%part == part .and. is_benign(findings(i)%line))
            hard = maxval(findings(i)%line%raw(2), mask=findings(i)%line%part == part .and. is_hard(findings(i)%line))
            beyond = maxval(findings(i)%line%beyond(2), mask=findings(i)%line%part == part)
            line = '| '//label_of(questions(i), part)//of_what(questions(i))//' | '//number_text(max(benign, 0.0_real64)) &
               //' / '//number_text(max(hard, 0.0_real64))
            if (any_slack(findings(i), part)) line = line//' ('//number_text(beyond)//')'
            line = line//' |'
            do c = 1, size(columns)
               line = line//' '//peer_cell(peer, trim(questions(i)), part, trim(columns(c)))//' |'
            end do
            write (output_unit, '(a)') line
         end do
      end do
      write (output_unit, '(a)') ''
   end subroutine write_peers

   elemental logical function is_benign(line)
      type(finding_type), intent(in) :: line

      is_benign = line%set(1:6) == 'benign'
   end function is_benign

   !> The sets that the other libraries were measured on, by kind: no draws next to zeros of Jacobi's functions.
   elemental logical function is_hard(line)
      type(finding_type), intent(in) :: line

      is_hard = .not. is_benign(line)
      if (line%question == 'jacobi') is_hard = line%set(1:5) == 'hard_'
      if (line%question == 'jacobic') is_hard = line%set == 'hard_mc'
   end function is_hard

   logical function any_slack(found, part)
      type(findings_type), intent(in) :: found
      integer, intent(in) :: part
      type(promise_type) :: promise
      integer :: j

      any_slack = .false.
      do j = 1, size(found%line)
         if (found%line(j)%part /= part) cycle
         promise = promise_of(trim(found%line(j)%question), part, found%line(j)%set)
         any_slack = any_slack .or. promise%slack > 0
      end do
   end function any_slack

   !> What the functions with several sets of arguments are given.
   function of_what(question) result(text)
      character(len=*), intent(in) :: question
      character(len=:), allocatable :: text

      select case (question)
      case ('complete', 'nome')
         text = '(m)'
      case ('complete_c', 'nome_c')
         text = ' of 1-m'
      case ('complete_pi')
         text = '(n, m)'
      case ('complete_pi_c')
         text = '(n) of 1-m'
      case ('incomplete')
         text = '(phi, m)'
      case ('incomplete_c')
         text = '(phi) of 1-m'
      case ('incomplete_pi')
         text = '(n, phi, m)'
      case ('incomplete_pi_c')
         text = '(n, phi) of 1-m'
      case ('jacobi', 'zeta')
         text = '(u, m)'
      case ('jacobic', 'zeta_c')
         text = '(u) of 1-m'
      case ('lambda')
         text = '(phi, m)'
      case ('lambda_c')
         text = '(phi) of 1-m'
      case default
         text = ''
      end select
   end function of_what

end program ulp_table
