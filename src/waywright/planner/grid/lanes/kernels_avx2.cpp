#include "waywright/planner/grid/lanes/kernels.inl"

namespace waywright::move_lanes {

extern const Kernels avx2_kernels;
const Kernels avx2_kernels{"avx2", leave};

}  // namespace waywright::move_lanes
