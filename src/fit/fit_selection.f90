!> Measurements of a fit, and which of them are in use.
module kyvadlo_fit_selection
   use kyvadlo_fit_data, only: column_period, column_plane, column_tension, is_event
   use kyvadlo_fit_loss, only: loss_squares
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: least_squares_type
   implicit none
   private
   public :: measurement_type, selection_type, use_until, count_until, make_room, leave_room

   !> One measured number.
   type :: measurement_type
      integer :: column = 0, row = 0, time_place = 0      !! Place among the times
      real(wp) :: value = 0, sigma = 1, time = 0          !! Of an event its time is the value
      real(wp) :: amplitude = 0, amplitude_sigma = 0      !! Beside a period
   end type measurement_type

   !> All of them, and those up to some time that are in use.
   type, extends(least_squares_type), abstract :: selection_type
      type(measurement_type), allocatable :: all(:)       !! By column and row, those of a row together, times ascending
      logical :: is_ascending = .false.                   !! Their times are
      integer, allocatable :: used(:)                     !! Places in `all`
      real(wp), allocatable :: times(:)                   !! Of rows in use, ascending
      real(wp), allocatable :: time_sigma(:), delay(:)    !! Of each: sigma of t, the latent time less t
      integer :: axes(2) = [1, 3]
      integer :: loss = loss_squares
      real(wp) :: loss_scale = 1
      real(wp), allocatable :: pull(:), pull_to(:)        !! Weak springs that hold unknowns where few data do not
      integer, allocatable :: prior(:)                    !! Unknowns with one
      real(wp), allocatable :: prior_value(:), prior_sigma(:)
      !> Whether there are such columns among those in use.
      logical :: has_forces = .false., has_events = .false., has_periods = .false.
      !> Room that evaluations share: of each measurement in use the prediction and its rate, of each time in hand the
      !> state and its derivatives.
      real(wp), allocatable :: h(:), rates(:), states(:, :), matrices(:, :, :)
   end type selection_type

contains

   !> Takes into use what was measured until a time, one in `stride` rows.
   subroutine use_until(model, until, stride)
      class(selection_type), intent(inout) :: model
      real(wp), intent(in) :: until
      integer, intent(in) :: stride
      integer, allocatable :: used(:)
      real(wp), allocatable :: times(:)
      integer :: i, n, row, rows, seen
      logical :: is_wanted

      model%has_forces = .false.
      model%has_events = .false.
      model%has_periods = .false.
      n = size(model%all)
      if (model%is_ascending .and. until < huge(until)) n = count_until(model, until)
      allocate (used(n), times(n))
      n = 0
      rows = 0
      row = 0
      seen = 0
      is_wanted = .true.
      do i = 1, size(model%all)
         associate (one => model%all(i))
            if (one%time > until) then
               if (model%is_ascending) exit
               cycle
            end if
            if (stride > 1) then
               if (one%row /= seen) is_wanted = modulo(one%row, stride) == 0
               seen = one%row
               if (.not. is_wanted) cycle
            end if
            n = n + 1
            used(n) = i
            one%time_place = 0
            if (one%column == column_tension .or. one%column == column_plane) model%has_forces = .true.
            if (is_event(one%column)) model%has_events = .true.
            if (one%column == column_period) model%has_periods = .true.
            if (is_event(one%column) .or. one%column == column_period) cycle
            if (one%row /= row) then
               rows = rows + 1
               times(rows) = one%time
               row = one%row
            end if
            one%time_place = rows
         end associate
      end do
      call move_alloc(used, model%used)
      call move_alloc(times, model%times)
      if (n < size(model%used)) model%used = model%used(:n)
      if (rows < size(model%times)) model%times = model%times(:rows)
      model%residuals = n
      if (allocated(model%prior)) model%residuals = model%residuals + size(model%prior)
      if (allocated(model%pull)) model%residuals = model%residuals + size(model%pull)
   end subroutine use_until

   !> How many measurements there are until a time.
   pure integer function count_until(model, until) result(n)
      class(selection_type), intent(in) :: model
      real(wp), intent(in) :: until
      integer :: above, middle

      if (.not. model%is_ascending) then
         n = count(model%all%time <= until)
         return
      end if
      n = 0
      above = size(model%all) + 1
      do while (above - n > 1)
         middle = (n + above)/2
         if (model%all(middle)%time <= until) then
            n = middle
         else
            above = middle
         end if
      end do
   end function count_until

   !> For the states of so many times, and their derivatives.
   subroutine make_room(model, times, unknowns, rows, with_derivatives)
      class(selection_type), intent(inout) :: model
      integer, intent(in) :: times, unknowns, rows
      logical, intent(in) :: with_derivatives

      if (allocated(model%states)) then
         if (size(model%states, 2) < times) deallocate (model%states)
      end if
      if (.not. allocated(model%states)) allocate (model%states(6, times))
      if (.not. with_derivatives) return
      if (allocated(model%matrices)) then
         if (size(model%matrices, 1) /= rows .or. size(model%matrices, 2) /= unknowns .or. &
            size(model%matrices, 3) < times) deallocate (model%matrices)
      end if
      if (.not. allocated(model%matrices)) allocate (model%matrices(rows, unknowns, times))
   end subroutine make_room

   !> Gives up what evaluations share: it is many times the data.
   subroutine leave_room(model)
      class(selection_type), intent(inout) :: model

      if (allocated(model%h)) deallocate (model%h, model%rates)
      if (allocated(model%states)) deallocate (model%states)
      if (allocated(model%matrices)) deallocate (model%matrices)
   end subroutine leave_room

end module kyvadlo_fit_selection
