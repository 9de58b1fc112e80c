#include "waywright/core/instruction_sets.hpp"
#include "waywright/planner/grid/lanes/kernels.hpp"

namespace waywright::move_lanes {
#include "waywright/core/lanes/dispatch.inl"
}  // namespace waywright::move_lanes
