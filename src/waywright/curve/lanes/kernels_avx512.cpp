#include "waywright/curve/lanes/kernels.inl"

namespace waywright::clothoid_lanes {

extern const Kernels avx512_kernels;
const Kernels avx512_kernels{"avx512", moments, fit, steps};

}  // namespace waywright::clothoid_lanes
