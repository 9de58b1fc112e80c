// What others do for the same question: OMPL's RRTConnect in its Reeds-Shepp space, with OMPL's own simplification, as its manual sets it
// up. The footprint is tested by our exact check every `spacing` m. FROZEN like the rest of this folder.
#pragma once

#include <cstdint>

#include "waywright/scenario/problem.hpp"

namespace yardstick {

struct OmplRun {
  bool solved = false;
  double seconds = 0.0;  ///< CPU time of solve and simplify, set-up left out
  double length = 0.0;   ///< m
};

/// One run within `limit` seconds; seeds OMPL's process-wide generator.
OmplRun rrt_connect_simplified(const waywright::Problem& problem, std::uint32_t seed, double limit, double spacing);

}  // namespace yardstick
