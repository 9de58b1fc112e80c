// Every figure of merit of a path, each with its formula.
#pragma once

#include <functional>
#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

struct Metrics {
  double length = 0.0;                    ///< m, arc length of the exact curves
  double min_clearance = 0.0;             ///< m, least exact clearance over the samples, capped at clearance_cap
  double mean_clearance = 0.0;            ///< m, clearance (capped at clearance_cap) averaged over arc length, trapezoidal
  double max_curvature = 0.0;             ///< 1/m, greatest |κ| over the samples
  double max_curvature_rate = 0.0;        ///< 1/m², greatest |dκ/ds| over the samples
  double curvature_change = 0.0;          ///< 1/m, Σ|Δκ| inside each piece
  double curvature_change_printed = 0.0;  ///< 1/m², Σ|Δκ|/Δs with samples 0.05 m apart: the form printed in the publication
  double turning = 0.0;                   ///< rad, Σ|Δheading|
  int direction_changes = 0;              ///< changes of sign of the driving direction (turns on the spot do not count)
  double collision_risk = 0.0;            ///< m, ∫ exp(−½ (d/q)²) ds with d the clearance and q = risk_scale
  double travel_time = 0.0;               ///< s
};

inline constexpr double clearance_cap = 10.0;  ///< m; clearance beyond it says nothing more
inline constexpr double risk_scale = 0.5;      ///< m

/// Clearance at each sample, m, capped at clearance_cap; `at` tells that of one.
std::vector<double> clearances(const std::vector<Sample>& samples, const std::function<double(const Sample&)>& at);

/// @pre samples come from path and carry t
Metrics measure(const Path& path, const std::vector<Sample>& samples, const std::vector<double>& clearances);

}  // namespace waywright
