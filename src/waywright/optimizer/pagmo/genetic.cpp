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

pagmo::population IntermediateGeneticAlgorithm::evolve(pagmo::population population) const {
  Random random{seed_};
  const auto [low, high] = population.get_problem().get_bounds();
  const std::size_t size = population.size();
  const std::size_t dimension = low.size();
  if (size <= elites) return population;
  std::vector<std::size_t> order(size);
  std::vector<double> shares(size);
  // What pagmo keeps is copied once; parents stay as they are while their generation is replaced.
  std::vector<pagmo::vector_double> points = population.get_x(), parents;
  std::vector<double> values;
  for (const pagmo::vector_double& f : population.get_f()) values.push_back(f[0]);
  const pagmo::problem& problem = population.get_problem();
  pagmo::vector_double child(dimension);
  for (unsigned generation = 0; generation < generations_; ++generation) {
    parents = points;
    for (std::size_t i = 0; i < size; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    const double least = values[order.front()];
    double all = 0.0;
    for (std::size_t i = 0; i < size; ++i) shares[i] = all += 1.0 / (1.0 + (values[i] - least));
    const auto parent = [&]() -> const pagmo::vector_double& {
      const auto at = std::lower_bound(shares.begin(), shares.end(), random.uniform() * all);
      return parents[std::min(size - 1, static_cast<std::size_t>(at - shares.begin()))];
    };
    for (std::size_t rank = elites; rank < size; ++rank) {
      const auto& a = parent();
      const auto& b = parent();
      for (std::size_t k = 0; k < dimension; ++k) {
        const double range = high[k] - low[k];
        const bool goes_round = k < periodic_.size() && periodic_[k];
        double way = b[k] - a[k];
        if (goes_round) way = std::remainder(way, range);
        double x = a[k] + random.uniform() * way;
        if (random.uniform() < mutation_probability) x += random.uniform(-mutation_reach, mutation_reach) * range;
        if (goes_round) x -= range * std::floor((x - low[k]) / range);
        child[k] = std::clamp(x, low[k], high[k]);
      }
      values[order[rank]] = problem.fitness(child)[0];
      points[order[rank]] = child;
    }
  }
  for (std::size_t i = 0; i < size; ++i) population.set_xf(i, points[i], {values[i]});
  return population;
}

pagmo::population ArithmeticGeneticAlgorithm::evolve(pagmo::population population) const {
  Random random{seed_};
  const auto [low, high] = population.get_problem().get_bounds();
  const std::size_t size = population.size();
  if (size <= elites) return population;
  std::vector<std::size_t> order(size);
  for (unsigned generation = 0; generation < generations_; ++generation) {
    const auto points = population.get_x();
    const auto values = population.get_f();
    for (std::size_t i = 0; i < size; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a][0] < values[b][0]; });
    const auto tournament = [&]() -> const pagmo::vector_double& {
      const auto a = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(size) - 1));
      const auto b = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(size) - 1));
      return points[values[a][0] <= values[b][0] ? a : b];
    };
    for (std::size_t rank = elites; rank < size; ++rank) {
      pagmo::vector_double child = tournament();
      const auto& other = tournament();
      const bool is_crossed = random.uniform() < crossover_probability;
      const double share = random.uniform();
      for (std::size_t k = 0; k < child.size(); ++k) {
        if (is_crossed) child[k] = share * child[k] + (1.0 - share) * other[k];
        if (random.uniform() < mutation_probability) child[k] += mutation_width * (high[k] - low[k]) * gaussian(random);
        child[k] = std::clamp(child[k], low[k], high[k]);
      }
      population.set_x(order[rank], child);
    }
  }
  return population;
}

}  // namespace waywright
