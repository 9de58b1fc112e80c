#include "waywright/planner/docking/lanes/kernels.inl"

namespace waywright::lanes {

extern const Kernels avx512_kernels;
const Kernels avx512_kernels{"avx512", trace, screen};

}  // namespace waywright::lanes
