#include "waywright/planner/grid/lanes/kernels.inl"

namespace waywright::move_lanes {

extern const Kernels avx512_kernels;
const Kernels avx512_kernels{"avx512", leave};

}  // namespace waywright::move_lanes
