#include "waywright/geometry/lanes/kernels.inl"

namespace waywright::segment_lanes {

extern const Kernels baseline_kernels;
const Kernels baseline_kernels{"baseline", sin_cos, nearest};

}  // namespace waywright::segment_lanes
