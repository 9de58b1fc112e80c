#include "waywright/planner/tree/lanes/kernels.inl"

namespace waywright::whale_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", draw, fly, rank, shade};

}  // namespace waywright::whale_lanes
