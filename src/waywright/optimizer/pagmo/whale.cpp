#include "waywright/optimizer/pagmo/whale.hpp"

#include <algorithm>
#include <vector>

namespace waywright {

pagmo::population WhaleAlgorithm::evolve(pagmo::population population) const {
  WhaleCounts counts;
  return evolve(std::move(population), counts);
}

pagmo::population WhaleAlgorithm::evolve(pagmo::population population, WhaleCounts& counts) const {
  const pagmo::problem& problem = population.get_problem();
  const auto [low, high] = problem.get_bounds();
  const std::size_t size = population.size(), dimension = low.size();
  if (size == 0) return population;
  std::vector<double> places;
  std::vector<double> values;
  places.reserve(size * dimension);
  for (const auto& x : population.get_x()) places.insert(places.end(), x.begin(), x.end());
  for (const auto& f : population.get_f()) values.push_back(f[0]);
  pagmo::vector_double best = population.get_x()[population.best_idx()];
  std::vector<double> mean(form_ == WhaleForm::unbiased ? dimension : 0);
  WhaleAgents agents{low, high, places, best, population.get_f()[population.best_idx()][0], mean};
  Random random{seed_};
  pagmo::vector_double x(dimension);
  counts = whale_search(
      parameters_, iterations_, agents, random,
      [&](std::size_t i, std::span<const double> place) {
        x.assign(place.begin(), place.end());
        return values[i] = problem.fitness(x)[0];
      },
      [](std::size_t) { return false; });
  if (std::find(values.begin(), values.end(), agents.best_value) == values.end()) {
    const auto worst = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
    std::copy(best.begin(), best.end(), agents.place(worst).begin());
    values[worst] = agents.best_value;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const auto place = agents.place(i);
    population.set_xf(i, pagmo::vector_double(place.begin(), place.end()), {values[i]});
  }
  return population;
}

}  // namespace waywright
