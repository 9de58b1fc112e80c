// The legs of a mission in the order in which they are driven best.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/planner/ordered_legs.hpp"

namespace waywright {

struct ChosenOrder {
  Scenario mission;    ///< in the order chosen; as given where there is none
  VisitingOrder order;
  bool is_found = false;
  bool is_canceled = false;
  Failure failure;     ///< where none was found: what no order reaches, and why
  std::vector<std::string> sentences;
  Effort effort;       ///< of all the ways planned
  bool reproducible = true;
};

/// Plans the way from each place to each that may be next, each once, by the leg's planner with the whole budget, on `threads` threads (0: one a core; the same
/// answer on any number), and chooses the order by their lengths. Loads that were set down further back than on the leg before are not on these ways. @pre complete_legs holds; the mission's order is not `given`
Parsed<ChosenOrder> choose_order(const Scenario& mission, const std::atomic<bool>* cancel = nullptr, unsigned threads = 0);

}  // namespace waywright
