!> Carlson's symmetric elliptic integrals RC, RF, RD, RJ, RG (DLMF chapter 19, sections 15 to 29), elemental in real32,
!> real64 and real128.
module kyvadlo_carlson
   use kyvadlo_carlson_rc, only: carlson_rc
   use kyvadlo_carlson_rf, only: carlson_rf
   use kyvadlo_carlson_rd, only: carlson_rd, carlson_rg
   use kyvadlo_carlson_rj, only: carlson_rj
   implicit none
   private
   public :: carlson_rc, carlson_rf, carlson_rd, carlson_rj, carlson_rg
end module kyvadlo_carlson
