#include "waywright/core/instruction_sets.hpp"
#include "waywright/planner/docking/lanes/kernels.hpp"

namespace waywright::lanes {
#include "waywright/core/lanes/dispatch.inl"
}  // namespace waywright::lanes
