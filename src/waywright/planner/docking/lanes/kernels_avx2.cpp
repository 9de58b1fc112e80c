#include "waywright/planner/docking/lanes/kernels.inl"

namespace waywright::lanes {

extern const Kernels avx2_kernels;
const Kernels avx2_kernels{"avx2", trace, screen};

}  // namespace waywright::lanes
