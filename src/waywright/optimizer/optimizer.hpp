// Minimising a function of a few bounded variables. One door for our own search and for pagmo's algorithms.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "waywright/core/budget.hpp"

namespace waywright {

/// Box of the decision variables; low[i] < high[i].
struct SearchSpace {
  std::vector<double> low;
  std::vector<double> high;
  std::size_t dimension() const { return low.size(); }
};

/// Finite cost of a point inside the box, smaller is better. Called once per evaluation, from one thread.
using CostFunction = std::function<double(std::span<const double>)>;

struct SearchOptions {
  std::int64_t evaluations = 600;  ///< upper bound on calls of the cost function
  int population = 20;             ///< where the algorithm has one
  std::uint64_t seed = 1;          ///< ignored by deterministic searches
};

struct SearchResult {
  std::vector<double> best;       ///< empty where nothing was evaluated
  double cost = 0.0;
  std::int64_t evaluations = 0;
  std::vector<double> trace;      ///< best cost so far after each evaluation
};

/// Same cost function, space, options: the same result bit for bit. Stops at the budget or when it is exhausted.
class Optimizer {
 public:
  virtual ~Optimizer() = default;
  virtual SearchResult minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                                Budget& budget) const = 0;
};

struct OptimizerDescription {
  std::string name;     ///< as in scenarios: "pattern_search", "de", "pso", "ga", "sa", "aco"
  std::string summary;  ///< one line for `waywright list optimizers`
  std::function<std::unique_ptr<Optimizer>()> make;
};

}  // namespace waywright
