// Trade-offs of one mission: length against clearance against curvature, as proven plans.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/judge/plan.hpp"

namespace waywright {

struct ParetoOptions {
  std::int64_t evaluations = 8000;  ///< where neither budget nor planner name them
  int population = 60;
  std::size_t points = 12;  ///< plans of the front, at most
  const std::atomic<bool>* cancel = nullptr;
};

struct Front {
  std::vector<Plan> plans;       ///< proven, none better in length, proven clearance and greatest curvature than another; by length
  std::int64_t evaluations = 0;
  std::size_t found = 0;         ///< candidates on the search's own front
  std::size_t refused = 0;       ///< of those looked at, by the proof
  bool is_cut_short = false;
  std::string reason;            ///< why there is no plan; empty where there is one
};

/// Has the scenario's planner candidates to trade? Only waypoint_clothoid has.
Parsed<void> check_pareto(const Scenario& scenario);

/// Error where it has not, or its parameters are wrong.
Parsed<Front> pareto(const Problem& problem, const ParetoOptions& options);

/// As a table for a terminal, and one line a plan for a CSV (length, clearance, curvature, …).
std::string front_text(const Front& front);
std::string front_csv(const Front& front);
/// Clearance over length, curvature as the size of the dots, numbered as the plans are.
std::string front_svg(const Front& front, double width);

}  // namespace waywright
