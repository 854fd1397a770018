!> Everything public of the core under one name: `use kyvadlo`.
module kyvadlo
   use kyvadlo_kinds
   use kyvadlo_status
   use kyvadlo_carlson
   use kyvadlo_complete
   use kyvadlo_nome
   use kyvadlo_jacobi
   use kyvadlo_jacobi_ratios
   use kyvadlo_theta
   use kyvadlo_cubic
   use kyvadlo_orbit
   use kyvadlo_motion
   implicit none
   public
end module kyvadlo
