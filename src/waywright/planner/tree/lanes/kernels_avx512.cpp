#include "waywright/planner/tree/lanes/kernels.inl"

namespace waywright::whale_lanes {

extern const Kernels avx512_kernels;
const Kernels avx512_kernels{"avx512", draw, fly, rank, shade};

}  // namespace waywright::whale_lanes
