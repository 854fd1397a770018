!> Random orbits of a regime against the library's own quadruple precision, in two kinds.
module campaign_real32
   use, intrinsic :: iso_fortran_env, only: wp => real32, real64, real128
#define own_type orbit_type_real32
#include "campaign.inc"
#undef own_type
end module campaign_real32

module campaign_real64
   use, intrinsic :: iso_fortran_env, only: wp => real64, real64, real128
#define own_type orbit_type
#include "campaign.inc"
#undef own_type
end module campaign_real64

module campaign
   use campaign_real32
   use campaign_real64
   implicit none
   public
end module campaign
