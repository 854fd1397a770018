!> Everything public of the core under one name: `use kyvadlo`.
module kyvadlo
   use kyvadlo_kinds
   use kyvadlo_status
   implicit none
   public
end module kyvadlo
