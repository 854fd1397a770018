!> Intervals by bootstrap: fits of copies of the data whose rows are drawn from the rows, with replacement.
module kyvadlo_fit_bootstrap
   use, intrinsic :: iso_fortran_env, only: int64
   use kyvadlo_fit_loss, only: loss_squares
   use kyvadlo_fit_model, only: model_type
   use kyvadlo_fit_physics, only: physics_type
   use kyvadlo_fit_search, only: minimise_all
   use kyvadlo_fit_unknowns, only: physics_at
   use kyvadlo_kinds, only: wp => real64
   use kyvadlo_least_squares, only: minimum_type
   use kyvadlo_philox, only: philox_key, philox_uniform
   use kyvadlo_scene_groups, only: settings
   implicit none
   private
   public :: fit_copy

contains

   !> The numbers that fit a copy. Which copy it is decides it alone: copies may be fitted in any order by any thread.
   subroutine fit_copy(model, x, seed, copy, number, is_found)
      type(model_type), intent(in) :: model              !! Around its minimum
      real(wp), intent(in) :: x(:)                       !! The minimum
      integer, intent(in) :: seed
      integer, intent(in) :: copy                        !! From 1 on
      real(wp), intent(out) :: number(:, :)              !! Of all settings
      logical, intent(out) :: is_found
      type(model_type) :: drawn
      type(minimum_type) :: minimum
      type(physics_type) :: physics
      real(wp) :: y(size(x))
      logical :: failed

      drawn = model
      call draw(drawn, philox_key(int(seed, int64), 'bootstrap'), int(copy, int64))
      y = x
      call minimise_all(drawn, y, minimum)
      is_found = minimum%is_found
      call physics_at(drawn%motion, y, number, physics, failed)
      is_found = is_found .and. .not. failed
   end subroutine fit_copy

   !> Draws rows. One that is drawn n times counts n times: its sigmas are those of the mean of n equal readings, or,
   !> where a loss would not see it so, it stands there n times. Priors are drawn anew from their distribution.
   subroutine draw(model, key, copy)
      type(model_type), intent(inout) :: model
      integer(int64), intent(in) :: key(2), copy
      integer, allocatable :: rows(:), times_drawn(:), places(:)
      integer(int64) :: first
      integer :: i, j, row
      real(wp), parameter :: pi = acos(-1.0_wp)

      allocate (times_drawn(maxval(model%all%row)))
      times_drawn = 0
      rows = pack([(i, i=1, size(model%all))], [.true., model%all(2:)%row /= model%all(:size(model%all) - 1)%row])
      rows = model%all(rows)%row
      first = copy*(2*size(times_drawn) + 2*size(model%motion%of) + 2)
      do i = 1, size(rows)
         row = rows(1 + int(size(rows)*philox_uniform(key, first + i)))
         times_drawn(row) = times_drawn(row) + 1
      end do
      first = first + size(rows) + 1
      if (allocated(model%prior)) then
         do i = 1, size(model%prior)
            model%prior_value(i) = model%prior_value(i) + model%prior_sigma(i)*sqrt(-2*log(philox_uniform(key, first + &
               2*i)))*cos(2*pi*philox_uniform(key, first + 2*i + 1))
         end do
      end if
      if (model%loss == loss_squares .or. allocated(model%time_sigma)) then
         places = pack([(i, i=1, size(model%all))], times_drawn(model%all%row) > 0)
         model%all = model%all(places)
         do i = 1, size(model%all)
            associate (one => model%all(i))
               one%sigma = one%sigma/sqrt(real(times_drawn(one%row), wp))
               one%amplitude_sigma = one%amplitude_sigma/sqrt(real(times_drawn(one%row), wp))
            end associate
         end do
         if (allocated(model%time_sigma)) model%time_sigma = model%time_sigma/sqrt(real(max(times_drawn, 1), wp))
      else
         places = [((i, j=1, times_drawn(model%all(i)%row)), i=1, size(model%all))]
         model%all = model%all(places)
      end if
   end subroutine draw

end module kyvadlo_fit_bootstrap
