// The scenes that docking is measured on: a 12 × 14 m station with 12 boxes, or with 500 scan points; the same for the planner and for
// the yardstick.
#pragma once

#include <cstdint>
#include <vector>

#include "bench/yardstick/plain.hpp"
#include "waywright/core/random.hpp"
#include "waywright/planner/docking/pattern.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::bench {

enum class Clutter { boxes, points };

/// `boxes` of 0.3 to 1 m, or 500 points in ten clusters.
Scenario docking_scenario(Clutter clutter, std::uint64_t seed, std::size_t boxes = 12);

/// What the yardstick is told of a problem; it asks for `clearance`.
yardstick::Scene scene_of(const Problem& problem, double clearance);
yardstick::Candidate candidate_of(const DockingPattern& pattern);

/// A transition anywhere beside the shelf, on either side.
DockingPattern random_pattern(const Problem& problem, const DockingTask& task, Random& random);

}  // namespace waywright::bench
