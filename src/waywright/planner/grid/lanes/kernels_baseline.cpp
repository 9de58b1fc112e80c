#include "waywright/planner/grid/lanes/kernels.inl"

namespace waywright::move_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", leave};

}  // namespace waywright::move_lanes
