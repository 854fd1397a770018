!> When the bob passes through a height or an azimuth, and when it turns next.
!>
!> `wp` is the caller's kind, `cp` the kind that computes: real32 orbits are computed in real64.
submodule (kyvadlo_orbit_real32) kyvadlo_passage_real32
   use kyvadlo_carlson_rf_real64, only: rf_series
   use kyvadlo_numbers_real32, only: is_finite, is_nan
#include "passage.inc"
end submodule kyvadlo_passage_real32

submodule (kyvadlo_orbit_real64) kyvadlo_passage_real64
   use kyvadlo_carlson_rf_real64, only: rf_series
   use kyvadlo_numbers_real64, only: is_finite, is_nan
#include "passage.inc"
end submodule kyvadlo_passage_real64

#ifndef KYVADLO_NO_REAL128
submodule (kyvadlo_orbit_real128) kyvadlo_passage_real128
   use kyvadlo_carlson_rf_real128, only: rf_series
   use kyvadlo_numbers_real128, only: is_finite, is_nan
#include "passage.inc"
end submodule kyvadlo_passage_real128
#endif
