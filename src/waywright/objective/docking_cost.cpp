#include "waywright/objective/docking_cost.hpp"
#include "waywright/core/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {

PathMeasures measure_samples(const std::vector<Sample>& samples) {
  PathMeasures m;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    m.max_curvature = std::max(m.max_curvature, std::abs(samples[i].curvature));
    if (i == 0) continue;
    const Sample& before = samples[i - 1];
    const double step = samples[i].s - before.s;
    m.length += step;
    if (samples[i].direction != before.direction || step <= 0.0) continue;
    const double change = std::abs(samples[i].curvature - before.curvature);
    m.curvature_change += change;
    m.curvature_change_printed += change / step;
  }
  return m;
}

double normalised_cost(const PathMeasures& path, const PathMeasures& reference, DockingWeights weights) {
  return weights.curvature * path.curvature_change / std::max(reference.curvature_change, 1e-3) +
         weights.length * path.length / reference.length;
}

double exponential_cost(const PathMeasures& path, const PathMeasures& reference, DockingWeights weights, double alpha,
                        double beta) {
  return weights.curvature * exponential(alpha * (path.curvature_change - reference.curvature_change)) +
         weights.length * exponential(beta * (path.length - reference.length));
}

}  // namespace waywright
