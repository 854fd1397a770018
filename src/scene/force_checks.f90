!> Which forces a scene can be asked for.
module kyvadlo_force_checks
   use kyvadlo_namelist_file, only: place_of
   use kyvadlo_quantities, only: quantity_pivot_force, quantity_tension
   use kyvadlo_scene_groups
   use kyvadlo_scene_settings, only: is_extended, settings_type
   use kyvadlo_status, only: code_input, error_type, fail
   implicit none
   private
   public :: check_forces

contains

   !> Error: a force is asked for that the scene does not tell.
   pure subroutine check_forces(settings, error)
      type(settings_type), intent(in) :: settings
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what
      integer :: i

      associate (asked => settings%quantities)
         what = ''
         if (any(asked == quantity_pivot_force)) then
            if (.not. settings%number(1, setting_place(body_group, 'mass')) > 0) &
               what = 'pivot_force needs mass of &body'
            if (settings%given(anisotropic_support_group)) &
               what = 'pivot_force and &anisotropic_support exclude each other, which has two pivots'
         end if
         if (is_extended(settings)) then
            if (any(asked == quantity_tension)) what = 'a body has no tension; ask for pivot_force'
            do i = 1, size(group_names)
               if (.not. settings%given(i) .or. all(i /= [air_group, earth_rotation_group, buoyancy_group])) cycle
               if (any(asked == quantity_pivot_force)) what = 'pivot_force of a body and &'//trim(group_names(i))// &
                  ' exclude each other: where that acts on the body is not told'
            end do
         end if
         if (allocated(settings%differentiated) .and. settings%given(body_group)) then
            if (any(settings%differentiated == quantity_tension)) what = 'with &body the tension has no derivatives'
         end if
         if (what /= '') call fail(error, code_input, place_of(settings%file, settings%line(output_group))// &
            '&output: quantities: '//what)
      end associate
   end subroutine check_forces

end module kyvadlo_force_checks
