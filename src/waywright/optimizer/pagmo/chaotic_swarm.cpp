#include "waywright/optimizer/pagmo/chaotic_swarm.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "waywright/core/elementary.hpp"
#include "waywright/core/random.hpp"

namespace waywright {
namespace {

/// z ← 4z(1 − z), one number after another. Rounding ends in a fixed point of the map sooner or later: there it begins anew.
class LogisticMap {
 public:
  double next(Random& random) {
    z_ = 4.0 * z_ * (1.0 - z_);
    if (!(z_ > 1e-12) || z_ == 0.75) z_ = random.uniform(0.01, 0.49);
    return z_;
  }

 private:
  double z_ = 0.7;
};

/// A direction that prefers none: sums of twelve uniforms are close to Gaussian, and the same on every machine.
void random_direction(Random& random, std::vector<double>& b) {
  double squares = 0.0;
  while (!(squares > 1e-6)) {
    squares = 0.0;
    for (double& v : b) {
      v = -6.0;
      for (int i = 0; i < 12; ++i) v += random.uniform();
      squares += v * v;
    }
  }
  const double inverse = 1.0 / std::sqrt(squares);
  for (double& v : b) v *= inverse;
}

double sign_of(double v) { return v > 0.0 ? 1.0 : v < 0.0 ? -1.0 : 0.0; }

}  // namespace

pagmo::population ChaoticSwarm::evolve(pagmo::population population) const {
  Random random{seed_};
  LogisticMap chaos;
  const pagmo::problem& problem = population.get_problem();
  const auto [low, high] = problem.get_bounds();
  const std::size_t size = population.size(), dimension = low.size();
  if (size == 0) return population;
  std::vector<pagmo::vector_double> places = population.get_x();
  std::vector<pagmo::vector_double> best = places;
  std::vector<double> best_values;
  for (const auto& f : population.get_f()) best_values.push_back(f[0]);
  std::vector<std::vector<double>> speeds(size, std::vector<double>(dimension, 0.0));
  std::size_t leader = population.best_idx();
  std::vector<double> b(dimension);
  pagmo::vector_double right(dimension), left(dimension);
  double share = reach;
  for (unsigned t = 0; t < iterations_; ++t) {
    const SinCos phase = sin_cos(0.5 * std::numbers::pi * static_cast<double>(t) / static_cast<double>(iterations_));
    const double inertia = 0.4 + 0.5 * phase.cos, own = 1.5 + phase.cos, common = 1.5 + phase.sin;
    for (std::size_t i = 0; i < size; ++i) {
      auto& x = places[i];
      random_direction(random, b);
      for (std::size_t k = 0; k < dimension; ++k) {
        const double step = share * (high[k] - low[k]) * b[k];
        right[k] = std::clamp(x[k] + step, low[k], high[k]);
        left[k] = std::clamp(x[k] - step, low[k], high[k]);
      }
      const double felt = sign_of(problem.fitness(right)[0] - problem.fitness(left)[0]);
      for (std::size_t k = 0; k < dimension; ++k) {
        const double range = high[k] - low[k];
        const double z1 = chaos.next(random), z2 = chaos.next(random);
        double& v = speeds[i][k];
        v = inertia * v + own * z1 * (best[i][k] - x[k]) + common * z2 * (best[leader][k] - x[k]) - share * range * b[k] * felt;
        v = std::clamp(v, -fastest * range, fastest * range);
        const double wanted = x[k] + v;
        x[k] = std::clamp(wanted, low[k], high[k]);
        if (x[k] != wanted) v = 0.0;
      }
      const double value = problem.fitness(x)[0];
      if (value < best_values[i]) {
        best[i] = x;
        best_values[i] = value;
        if (value < best_values[leader]) leader = i;
      }
    }
    share *= fading;
  }
  for (std::size_t i = 0; i < size; ++i) population.set_xf(i, best[i], {best_values[i]});
  return population;
}

}  // namespace waywright
