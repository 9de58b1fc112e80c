// The docking publication's two costs of a path against a reference path (equations 3.7–3.12, corrected).
#pragma once

#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

/// What the costs are made of.
struct PathMeasures {
  double length = 0.0;                    ///< m, over both splines
  double curvature_change = 0.0;          ///< 1/m, Σ|Δκ| inside each spline
  double curvature_change_printed = 0.0;  ///< 1/m², Σ|Δκ|/Δs as printed in (3.3)
  double max_curvature = 0.0;             ///< 1/m
};

struct DockingWeights {
  double curvature = 0.7;
  double length = 0.3;
};

/// Σ over samples; pairs across a change of direction do not count. Source: (3.1)–(3.4).
PathMeasures measure_samples(const std::vector<Sample>& samples);

/// Cost B, recommended by the publication: ω_c·cc/cc_ref + ω_L·L/L_ref (3.10)–(3.12). 1 for the reference itself when the
/// weights add up to 1. cc_ref is taken as at least 1e-3 1/m. @pre reference.length > 0
double normalised_cost(const PathMeasures& path, const PathMeasures& reference, DockingWeights weights = {});

/// Cost A: ω_c·exp(α(cc − cc_ref)) + ω_L·exp(β(L − L_ref)) (3.7)–(3.9) in SI: α = 2 m, β = 0.7 1/m.
double exponential_cost(const PathMeasures& path, const PathMeasures& reference, DockingWeights weights = {},
                        double alpha = 2.0, double beta = 0.7);

}  // namespace waywright
