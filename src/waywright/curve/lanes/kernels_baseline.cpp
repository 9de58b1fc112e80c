#include "waywright/curve/lanes/kernels.inl"

namespace waywright::clothoid_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", moments};

}  // namespace waywright::clothoid_lanes
