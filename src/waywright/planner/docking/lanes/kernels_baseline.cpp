#include "waywright/planner/docking/lanes/kernels.inl"

namespace waywright::lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", trace, screen};

}  // namespace waywright::lanes
