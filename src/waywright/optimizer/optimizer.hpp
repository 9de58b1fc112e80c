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
  std::vector<bool> periodic = {};  ///< variables of which both ends are the same (angles); empty: none. Only some algorithms care
  std::size_t dimension() const { return low.size(); }
};

/// What an evaluation says of a point. Finite.
struct Evaluation {
  double objective = 0.0;  ///< what is minimised among the feasible points
  double violation = 0.0;  ///< how far from feasible, ≥ 0; 0: feasible. The steadier it grows the better
  double graded = 0.0;     ///< both in one number, for searches that know of no constraints: every feasible point under every other one
};

/// Asked once per evaluation, from one thread. Where the objective is at least `enough` the rest may be left out (violation 0, graded as
/// if feasible): who passes a finite `enough` has no use for such a point.
using CostFunction = std::function<Evaluation(std::span<const double>, double enough)>;

struct SearchOptions {
  std::int64_t evaluations = 600;  ///< upper bound on calls of the cost function
  int population = 20;             ///< where the algorithm has one
  std::uint64_t seed = 1;          ///< ignored by deterministic searches
};

struct SearchResult {
  std::vector<double> best;  ///< empty where nothing was evaluated
  double cost = 0.0;         ///< its graded cost
  std::int64_t evaluations = 0;
};

/// A search that can be halted and taken up again: two searches side by side, the better one gets what is left.
class ResumableSearch {
 public:
  virtual ~ResumableSearch() = default;
  /// Goes on until `evaluations` in all are done, or the budget is exhausted. The cost function is the same each time.
  virtual void advance(const CostFunction& cost, std::int64_t evaluations, Budget& budget) = 0;
  virtual const SearchResult& result() const = 0;
  /// Its evaluations become more: it goes on from what it knows. Nothing is allocated as below.
  virtual void extend(std::int64_t evaluations) = 0;
  /// Halted before its first evaluation again, in the same space: as begun anew, in the memory that it has. Allocates nothing where it was
  /// begun with at least as many evaluations.
  virtual void start_over(const SearchOptions& options) = 0;
};

/// Same cost function, space, options: the same result bit for bit. Stops at the budget or when it is exhausted.
class Optimizer {
 public:
  virtual ~Optimizer() = default;
  virtual SearchResult minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                                Budget& budget) const = 0;
  /// The same search, halted before its first evaluation; nullptr where the algorithm cannot be halted.
  virtual std::unique_ptr<ResumableSearch> begin(const SearchSpace&, const SearchOptions&) const { return nullptr; }
};

struct OptimizerDescription {
  std::string name;     ///< as in scenarios: "pattern_search", "de", "pso", "ga", "sa", "aco"
  std::string summary;  ///< one line for `waywright list optimizers`
  std::function<std::unique_ptr<Optimizer>()> make;
};

}  // namespace waywright
