#include "waywright/core/instruction_sets.hpp"
#include "waywright/planner/tree/lanes/kernels.hpp"

namespace waywright::whale_lanes {
#include "waywright/core/lanes/dispatch.inl"
}  // namespace waywright::whale_lanes
