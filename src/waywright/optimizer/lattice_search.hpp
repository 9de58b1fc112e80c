// `lattice_search`: our deterministic default for two to six bounded variables. Standard library only.
//
// 1. A Kronecker lattice of low discrepancy (the R_d sequence of Roberts: multiples of the powers of 1/φ_d modulo 1, where φ_d is
//    the real root of x^(d+1) = x + 1) covers the box with `lattice_share` of the evaluations, the middle of the box first.
// 2. The best lattice points that are not neighbours of a better one each start a compass search: steps along the axes, doubled
//    while they succeed, halved when all fail. Rounds of equal work; after each round the worse half of the starts is given up.
// 3. What is left polishes the best, until the step is under `finest` of the box.
// Where nothing under `good_enough` is known, every second round goes on with the lattice instead, so that a search in a station
// with few ways through does not die in a dead end.
#pragma once

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

struct LatticeSearchOptions {
  double lattice_share = 0.4;   ///< of the evaluations for step 1
  int starts = 6;               ///< of compass searches
  double first_step = 0.08;     ///< of the box
  double finest = 1e-5;         ///< of the box
  double good_enough = 100.0;   ///< costs under it are feasible (graded costs put everything else above)
};

class LatticeSearch final : public Optimizer {
 public:
  explicit LatticeSearch(LatticeSearchOptions options = {}) : options_{options} {}
  SearchResult minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                        Budget& budget) const override;

 private:
  LatticeSearchOptions options_;
};

OptimizerDescription lattice_search_description();

}  // namespace waywright
