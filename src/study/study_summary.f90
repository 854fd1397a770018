!> What a study says in words: which method is the cheapest at an accuracy, and by how much it beats the next.
module kyvadlo_study_summary
   use, intrinsic :: iso_fortran_env, only: int64, real64
   use kyvadlo_study_record, only: capped, cell_type, failed, measured, study_type
   use kyvadlo_text, only: append, text_sink_type, text_type
   implicit none
   private
   public :: write_summary, accuracies, names_in, cheapest, standing_type, question_title

   !> The accuracies a reader may want.
   real(real64), parameter :: accuracies(5) = [1e-3_real64, 1e-6_real64, 1e-9_real64, 1e-12_real64, 1e-15_real64]

   !> Settings with these words are measured, but not compared with methods that set up too.
   character(len=*), parameter :: without_set_up = 'after set-up'

   !> Settings of the closed form that begin so name the accuracy asked for.
   character(len=*), parameter :: asking = 'accuracy '

   !> The first and the second method at an accuracy; blank where there is none.
   type :: standing_type
      character(len=16) :: first = '', second = ''
      real(real64) :: first_time = 0, second_time = 0 !! ns a result: of one orbit, or the geometric mean of all
   end type standing_type

contains

   !> One section for each question.
   subroutine write_summary(study, sink)
      type(study_type), intent(in) :: study
      class(text_sink_type), intent(inout) :: sink
      type(text_type), allocatable :: questions(:), orbits(:)
      integer :: i

      call names_in(study, 'question', '', questions)
      do i = 1, size(questions)
         call names_in(study, 'orbit', questions(i)%text, orbits)
         if (i > 1) call sink%put('')
         call sink%put(trim(question_title(questions(i)%text)))
         call sink%put('')
         call write_overall(study, questions(i)%text, orbits, sink)
         call sink%put('')
         call write_by_orbit(study, questions(i)%text, orbits, sink)
      end do
      call write_kept(study, questions, sink)
      call write_missing(study, sink)
      call sink%put("Of settings `"//without_set_up// &
         "` the summary takes no notice: every method pays for its own set-up.")
   end subroutine write_summary

   !> The question in words, and what its errors are.
   function question_title(question) result(title)
      character(len=*), intent(in) :: question
      character(len=104) :: title

      select case (question)
      case ('position')
         title = 'Position at times within one period; error relative to the length'
      case ('position_1000')
         title = 'Position at times within the 1000th period; error relative to the length'
      case ('period')
         title = 'Period; relative error'
      case ('roots')
         title = 'Turning heights from energy and momentum; error relative to the length, or to a root beyond it'
      case ('gaps')
         title = 'Gaps between turning heights and poles; relative error'
      case ('functions')
         title = 'Elliptic functions; relative error, of sn, cn, dn absolute'
      case default
         title = question
      end select
   end function question_title

   !> The distinct questions, orbits or methods of the record, in the order in which they appear.
   subroutine names_in(study, what, question, names)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: what         !! question, orbit, method
      character(len=*), intent(in) :: question     !! Only of this question; blank: of all
      type(text_type), allocatable, intent(out) :: names(:)
      character(len=64) :: name
      integer :: i, j

      allocate (names(0))
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (question /= '' .and. cell%question /= question) cycle
            select case (what)
            case ('question')
               name = cell%question
            case ('orbit')
               name = cell%orbit
            case default
               name = cell%method
            end select
         end associate
         do j = size(names), 1, -1
            if (names(j)%text == name) exit
         end do
         if (j == 0) call append(names, trim(name))
      end do
   end subroutine names_in

   !> The cheapest two methods whose error is at most `accuracy`, each at its cheapest setting and kind: on one orbit,
   !> or on every one of several, then by the geometric mean of their times.
   function cheapest(study, question, orbits, accuracy) result(standing)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(text_type), intent(in) :: orbits(:)
      real(real64), intent(in) :: accuracy
      type(standing_type) :: standing
      type(text_type), allocatable :: methods(:)
      real(real64) :: mean, time
      integer :: i, j

      call names_in(study, 'method', question, methods)
      do i = 1, size(methods)
         mean = 0
         do j = 1, size(orbits)
            time = least_time(study, question, orbits(j)%text, methods(i)%text, accuracy)
            if (.not. time < huge(time)) exit
            mean = mean + log(time)/size(orbits)
         end do
         if (j <= size(orbits)) cycle
         mean = exp(mean)
         if (standing%first == '' .or. mean < standing%first_time) then
            standing%second = standing%first
            standing%second_time = standing%first_time
            standing%first = methods(i)%text
            standing%first_time = mean
         else if (standing%second == '' .or. mean < standing%second_time) then
            standing%second = methods(i)%text
            standing%second_time = mean
         end if
      end do
   end function cheapest

   !> Median time [ns] of the cheapest setting and kind; `huge` if none is accurate enough.
   pure function least_time(study, question, orbit, method, accuracy) result(time)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question, orbit, method
      real(real64), intent(in) :: accuracy
      real(real64) :: time
      integer :: i

      time = huge(time)
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (cell%outcome /= measured .or. .not. cell%error <= accuracy) cycle
            if (cell%question /= question .or. cell%method /= method .or. cell%orbit /= orbit) cycle
            if (index(cell%setting, without_set_up) > 0) cycle
            time = min(time, max(cell%ns_median, tiny(time)))
         end associate
      end do
   end function least_time

   !> Methods that reach the accuracy everywhere.
   subroutine write_overall(study, question, orbits, sink)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(text_type), intent(in) :: orbits(:)
      class(text_sink_type), intent(inout) :: sink
      type(standing_type) :: standing
      character(len=120) :: line
      integer :: i

      write (line, '(2x,a10,2x,a16,a12,2x,a16,a10)') 'error     ', 'cheapest on all ', 'ns', 'next            ', 'takes'
      call sink%put(trim(line))
      do i = 1, size(accuracies)
         standing = cheapest(study, question, orbits, accuracies(i))
         if (standing%first == '') then
            write (line, '(2x,es7.0e2,5x,a)') accuracies(i), 'no method on all'
         else if (standing%second == '') then
            write (line, '(2x,es7.0e2,5x,a16,a12,2x,a)') accuracies(i), standing%first, &
               number_text(standing%first_time), 'no other on all'
         else
            write (line, '(2x,es7.0e2,5x,a16,a12,2x,a16,a10)') accuracies(i), standing%first, &
               number_text(standing%first_time), standing%second, ratio_text(standing%second_time/standing%first_time)
         end if
         call sink%put(trim(line))
      end do
   end subroutine write_overall

   !> A line for each orbit, a column for each accuracy: the cheapest method, and how many times as long the next takes.
   subroutine write_by_orbit(study, question, orbits, sink)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(text_type), intent(in) :: orbits(:)
      class(text_sink_type), intent(inout) :: sink
      integer, parameter :: width = 22
      type(standing_type) :: standing
      character(len=:), allocatable :: line
      character(len=width) :: column
      integer :: i, j, first

      first = max(6, maxval([(len(orbits(i)%text), i=1, size(orbits))])) + 2
      line = '  '//padded(merge('function', 'orbit   ', question == 'functions'), first)
      do j = 1, size(accuracies)
         write (column, '(es7.0e2)') accuracies(j)
         line = line//column
      end do
      call sink%put(trim(line))
      do i = 1, size(orbits)
         line = '  '//padded(orbits(i)%text, first)
         do j = 1, size(accuracies)
            standing = cheapest(study, question, orbits(i:i), accuracies(j))
            column = '-'
            if (standing%first /= '') column = trim(standing%first)//' alone'
            if (standing%second /= '') &
               column = trim(standing%first)//' '//ratio_text(standing%second_time/standing%first_time)
            line = line//column
         end do
         call sink%put(trim(line))
      end do
   end subroutine write_by_orbit

   !> Whether the closed form keeps the accuracies asked for, and what that saves: times as multiples of those of double
   !> precision without an accuracy.
   subroutine write_kept(study, questions, sink)
      type(study_type), intent(in) :: study
      type(text_type), intent(in) :: questions(:)
      class(text_sink_type), intent(inout) :: sink
      type(text_type), allocatable :: asked(:)
      character(len=120) :: line
      character(len=:), allocatable :: full
      real(real64) :: time, after
      integer :: i, j

      do i = 1, size(questions)
         call accuracies_asked(study, questions(i)%text, asked)
         if (size(asked) == 0) cycle
         call sink%put('')
         call sink%put('closed_form to a stated accuracy. '//trim(question_title(questions(i)%text)))
         call sink%put('')
         write (line, '(2x,a10,a18,2(a13,a11))') 'asked for ', 'worst error', 'ns', 'of double', without_set_up, &
            'of double'
         call sink%put(trim(line))
         full = 'batch'
         if (questions(i)%text == 'period') full = 'set-up'
         do j = 1, size(asked)
            associate (question => questions(i)%text, accuracy => asked(j)%text)
               time = mean_time(study, question, asking//accuracy, '')
               after = mean_time(study, question, 'to '//accuracy//' '//without_set_up, '')
               write (line, '(2x,a10,a18,a13,a11)') accuracy//'         ', &
                  error_text(study, question, asking//accuracy), number_text(time), &
                  times_text(time, mean_time(study, question, full, 'real64'))
               if (after > 0) write (line(55:), '(a13,a11)') number_text(after), &
                  times_text(after, mean_time(study, question, full//' '//without_set_up, 'real64'))
            end associate
            call sink%put(trim(line))
         end do
      end do
   end subroutine write_kept

   !> `1e-6` of the settings `accuracy 1e-6`, in the order in which they appear.
   subroutine accuracies_asked(study, question, asked)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question
      type(text_type), allocatable, intent(out) :: asked(:)
      integer :: i, j

      allocate (asked(0))
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (cell%question /= question .or. index(cell%setting, asking) /= 1) cycle
            do j = size(asked), 1, -1
               if (asked(j)%text == cell%setting(len(asking) + 1:)) exit
            end do
            if (j == 0) call append(asked, trim(cell%setting(len(asking) + 1:)))
         end associate
      end do
   end subroutine accuracies_asked

   !> The worst of all orbits, of a setting in any kind. On a user's own orbit real128 is what all are held to.
   pure function error_text(study, question, setting) result(text)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question, setting
      character(len=16) :: text
      real(real64) :: worst
      integer :: i
      logical :: is_reference

      worst = 0
      is_reference = .true.
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (cell%question /= question .or. cell%setting /= setting) cycle
            worst = max(worst, cell%error)
            is_reference = is_reference .and. cell%kind == 'real128' .and. cell%error <= 0
            if (cell%outcome == measured) cycle
            text = merge('          failed', '          capped', cell%outcome == failed)
            return
         end associate
      end do
      write (text, '(es16.1e2)') worst
      if (is_reference) text = 'is the reference'
   end function error_text

   !> Geometric mean of the times of a setting on all orbits [ns]; 0 if nobody measured it.
   pure real(real64) function mean_time(study, question, setting, kind)
      type(study_type), intent(in) :: study
      character(len=*), intent(in) :: question, setting
      character(len=*), intent(in) :: kind         !! Blank: any
      real(real64) :: sum
      integer :: i, n

      sum = 0
      n = 0
      do i = 1, study%count
         associate (cell => study%cells(i))
            if (cell%question /= question .or. cell%setting /= setting .or. cell%outcome /= measured) cycle
            if (cell%kind /= kind .and. kind /= '') cycle
            sum = sum + log(max(cell%ns_median, tiny(sum)))
            n = n + 1
         end associate
      end do
      mean_time = 0
      if (n > 0) mean_time = exp(sum/n)
   end function mean_time

   !> How many cells have no numbers, and why.
   subroutine write_missing(study, sink)
      type(study_type), intent(in) :: study
      class(text_sink_type), intent(inout) :: sink
      character(len=120) :: line

      write (line, '(i0,a,i0,a,i0,a)') study%count, ' cells; ', count(study%cells(:study%count)%outcome == capped), &
         ' capped: would take too long; ', count(study%cells(:study%count)%outcome == failed), ' failed: no result'
      call sink%put('')
      call sink%put(trim(line))
   end subroutine write_missing

   !> Three digits.
   pure function number_text(x) result(text)
      real(real64), intent(in) :: x
      character(len=12) :: text

      if (x < 99.95_real64) then
         write (text, '(f12.1)') x
      else if (x < 1e9_real64) then
         write (text, '(i12)') nint(x, int64)
      else
         write (text, '(es12.2)') x
      end if
   end function number_text

   pure function ratio_text(x) result(text)
      real(real64), intent(in) :: x
      character(len=11) :: text
      character(len=12) :: number

      if (x < 10) then
         write (number, '(f4.1)') x
      else
         number = number_text(min(x, 1e9_real64))
      end if
      number = adjustl(number)
      text = 'x'//number(:10)
   end function ratio_text

   !> A time as a multiple of another, if both were measured.
   pure function times_text(time, unit) result(text)
      real(real64), intent(in) :: time, unit
      character(len=11) :: text

      text = ''
      if (time > 0 .and. unit > 0) text = ratio_text(time/unit)
      text = adjustr(text)
   end function times_text

   pure function padded(text, width) result(wide)
      character(len=*), intent(in) :: text
      integer, intent(in) :: width
      character(len=width) :: wide

      wide = text
   end function padded

end module kyvadlo_study_summary
