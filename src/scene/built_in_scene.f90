!> The pendulums that `kyvadlo table` shows when no scene is given, as the text of a scene file.
module kyvadlo_built_in_scene
   implicit none
   private
   public :: built_in_scene, built_in_name

   character(len=*), parameter :: nl = new_line('a')

   !> What messages call it.
   character(len=*), parameter :: built_in_name = 'built-in scene'

   !> Foucault's bob was released at rest in the turning room: seen without the room's rotation it has the speed of its
   !> place, 3 m times 7.292115e-5/s times the sine of the latitude, 48.85 degrees.
   character(len=*), parameter :: built_in_scene = &
      '&pendulum name = "Foucault''s pendulum, Pantheon, 67 m", length = 67, '// &
      'release_angle = 2.5663, release_speed = 1.6473e-4 /'//nl// &
      '&pendulum name = "laboratory pendulum of 1 m, wide swing", length = 1, z_upper = 0.3, z_lower = -0.8 /'//nl// &
      '&pendulum name = "conical pendulum of 1 m at 60 degrees", length = 1, z_upper = -0.5, z_lower = -0.5 /'//nl// &
      '&pendulum name = "plane pendulum of 1 m, released at 120 degrees", length = 1, '// &
      'release_angle = 120, release_speed = 0 /'//nl// &
      '&pendulum name = "pendulum of 1 m passing near the upright", length = 1, upper_gap = 1e-6, lower_rise = 1e-9 /'

end module kyvadlo_built_in_scene
