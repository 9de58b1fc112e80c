#include "waywright/optimizer/pagmo/genetic.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

/// Twelve uniforms less six: close to a Gaussian, and the same on every machine, as the platform's own is not.
double gaussian(Random& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

}  // namespace

pagmo::population BlendGeneticAlgorithm::evolve(pagmo::population population) const {
  Random random{seed_};
  const auto [low, high] = population.get_problem().get_bounds();
  const auto size = population.size();
  const auto dimension = low.size();
  if (size < 2) return population;
  for (unsigned generation = 0; generation < generations_; ++generation) {
    const auto points = population.get_x();
    const auto values = population.get_f();
    const auto best = population.best_idx();
    const auto tournament = [&] {
      const auto a = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(size) - 1));
      const auto b = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(size) - 1));
      return values[a][0] <= values[b][0] ? a : b;
    };
    for (std::size_t i = 0; i < size; ++i) {
      if (i == best) continue;  // the elite stays as it is
      const auto& a = points[tournament()];
      const auto& b = points[tournament()];
      pagmo::vector_double child = a;
      if (random.uniform() < crossover_probability) {
        for (std::size_t k = 0; k < dimension; ++k) child[k] = a[k] + random.uniform() * (b[k] - a[k]);
      }
      for (std::size_t k = 0; k < dimension; ++k) {
        if (random.uniform() < mutation_probability) child[k] += mutation_width * (high[k] - low[k]) * gaussian(random);
        child[k] = std::clamp(child[k], low[k], high[k]);
      }
      population.set_x(i, child);
    }
  }
  return population;
}

}  // namespace waywright
