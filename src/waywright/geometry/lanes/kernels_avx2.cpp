#include "waywright/geometry/lanes/kernels.inl"

namespace waywright::segment_lanes {

extern const Kernels avx2_kernels;
const Kernels avx2_kernels{"avx2", sin_cos, nearest};

}  // namespace waywright::segment_lanes
