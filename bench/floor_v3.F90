!> The floor of the places, compiled as the batch kernel of the same level.
module kyvadlo_bench_floor_v3
#include "floor.inc"
end module kyvadlo_bench_floor_v3
