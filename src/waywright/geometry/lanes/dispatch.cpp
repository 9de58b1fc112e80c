#include "waywright/core/instruction_sets.hpp"
#include "waywright/geometry/lanes/kernels.hpp"

namespace waywright::segment_lanes {
#include "waywright/core/lanes/dispatch.inl"
}  // namespace waywright::segment_lanes
