#include "waywright/geometry/lanes/kernels.inl"

namespace waywright::segment_lanes {

extern const Kernels avx512_kernels;
const Kernels avx512_kernels{"avx512", sin_cos, nearest};

}  // namespace waywright::segment_lanes
