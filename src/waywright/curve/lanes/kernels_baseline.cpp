#include "waywright/curve/lanes/kernels.inl"

namespace waywright::clothoid_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", moments, fit, steps};

}  // namespace waywright::clothoid_lanes
