// What pagmo's algorithms have in common here.
#pragma once

#include <exception>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

#include "waywright/core/random.hpp"
#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

/// Leaves pagmo's loops when the work is done; caught right outside them.
struct BudgetSpent : std::exception {};

/// Seeds for pagmo, of a search's own.
class PagmoSeeds {
 public:
  explicit PagmoSeeds(std::uint64_t seed) : random_{Random::stream(seed, 0)} {}
  unsigned next() { return static_cast<unsigned>(random_.next() >> 33); }

 private:
  Random random_;
};

/// `size` points of the space, each evaluated as it is drawn. Drawn here and not by pagmo, so that all algorithms start from the same points
/// for the same seed.
template <class Problem>
pagmo::population first_population(Problem problem, const SearchSpace& space, std::uint64_t seed, unsigned size, PagmoSeeds& seeds) {
  pagmo::population population{pagmo::problem{std::move(problem)}, 0, seeds.next()};
  Random points = Random::stream(seed, 1);
  for (unsigned i = 0; i < size; ++i) {
    pagmo::vector_double x(space.dimension());
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = points.uniform(space.low[k], space.high[k]);
    population.push_back(x);
  }
  return population;
}

}  // namespace waywright
