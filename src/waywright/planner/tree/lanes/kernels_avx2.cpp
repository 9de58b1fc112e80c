#include "waywright/planner/tree/lanes/kernels.inl"

namespace waywright::whale_lanes {

extern const Kernels avx2_kernels;
const Kernels avx2_kernels{"avx2", draw, fly, rank, shade};

}  // namespace waywright::whale_lanes
