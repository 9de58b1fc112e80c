// `lattice_search`: our deterministic default for two to six bounded variables with an objective and a violation. Standard library only.
//
// 1. A Kronecker lattice of low discrepancy (the R_d sequence of Roberts: multiples of the powers of 1/φ_d modulo 1, where φ_d is
//    the real root of x^(d+1) = x + 1) covers the box, the middle of the box first. Points whose objective alone is no better than the best
//    feasible one lead nowhere and are forgotten.
// 2. The best of its points that are not neighbours of each other each start a simplex search (Nelder and Mead 1965) on the merit: the
//    objective, and where a point violates something a cliff and a price for how much. The cliff keeps a simplex from settling just
//    outside of what is feasible, the price leads it there; a collapsed simplex is built anew, smaller and turned about. After rounds
//    of equal work the worse half is given up, until one is left.
// 3. More lattice points, the next starts, and so on; the last tenth of the evaluations goes to the best simplex of all.
#pragma once

#include <array>

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

struct LatticeSearchOptions {
  double lattice_share = 0.1;   ///< of the evaluations for the first lattice
  double more_lattice = 0.3;    ///< of the evaluations that the starts before took, for each further one
  double cliff = 1.0;           ///< of the merit where something is violated: as much as objectives differ
  double price = 1.0;           ///< of the merit for a violation of 1
  double raise = 4.0;           ///< of cliff and price, where the best simplex ends where something is violated
  int starts = 8;               ///< at a time
  double apart = 0.7;           ///< least distance of two starts, of that of lattice points
  int work = 12;                ///< evaluations a variable for each start in a round
  double polish_share = 0.1;    ///< of the evaluations for the best simplex at the end
  double rebuilt = 0.25;        ///< size of a simplex that is built anew
  double finest = 1e-4;         ///< of the box: smaller ones are not built
};

class LatticeSearch final : public Optimizer {
 public:
  static constexpr std::size_t most_variables = 6;  ///< more: nothing is evaluated
  explicit LatticeSearch(LatticeSearchOptions options = {}) : options_{options} {}
  SearchResult minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                        Budget& budget) const override;
  std::unique_ptr<ResumableSearch> begin(const SearchSpace& space, const SearchOptions& options) const override;

 private:
  LatticeSearchOptions options_;
};

OptimizerDescription lattice_search_description();

}  // namespace waywright
