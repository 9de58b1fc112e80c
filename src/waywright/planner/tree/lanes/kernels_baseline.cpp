#include "waywright/planner/tree/lanes/kernels.inl"

namespace waywright::whale_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", draw, move, sift};

}  // namespace waywright::whale_lanes
