#include "waywright/curve/lanes/kernels.inl"

namespace waywright::clothoid_lanes {

extern const Kernels avx2_kernels;
const Kernels avx2_kernels{"avx2", moments, fit, steps};

}  // namespace waywright::clothoid_lanes
