// The safe-A* publication's figures of merit of compared plans, and how much less each has than the first, in percent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/study/compare.hpp"

namespace waywright {

/// Medians over the runs of a contestant that have a path, proven or not.
struct Merits {
  std::size_t scenario = 0, contestant = 0;
  double length = 0.0;   ///< m
  double turning = 0.0;  ///< rad
  double risk = 0.0;     ///< m, Metrics::collision_risk
  double power = 0.0;    ///< %, what is left: residual_power of length and turning
  double time = 0.0;     ///< s, as driven
};
/// In the order of scenarios and contestants; who has no path is left out.
std::vector<Merits> merits_of(const std::vector<Run>& runs, std::size_t scenarios, std::size_t contestants);

/// Percent less than the first contestant with a path in the same scenario, by the publication's formulas (21) to (26).
struct Reductions {
  double length = 0.0, turning = 0.0, risk = 0.0, power = 0.0, time = 0.0;
};
Reductions reductions(const Merits& reference, const Merits& proposed);

/// A table for a terminal of one scenario's contestants; empty where fewer than two have a path.
std::string merits_text(const std::vector<Merits>& merits, std::size_t scenario, const std::vector<std::string>& names);
/// The percentages of one scenario as bars, one group a figure of merit; empty where fewer than two have a path.
std::string merits_svg(const std::vector<Merits>& merits, std::size_t scenario, const std::vector<std::string>& names, const std::string& title, double width = 860.0);

}  // namespace waywright
