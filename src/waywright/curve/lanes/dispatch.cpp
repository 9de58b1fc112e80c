#include "waywright/core/instruction_sets.hpp"
#include "waywright/curve/lanes/kernels.hpp"

namespace waywright::clothoid_lanes {
#include "waywright/core/lanes/dispatch.inl"
}  // namespace waywright::clothoid_lanes
