// The whale optimisation algorithm (Mirjalili and Lewis, The whale optimization algorithm, Advances in Engineering Software 2016, with the parameters that
// the RRT*-WOA publication varies) as a pagmo algorithm.
#pragma once

#include <pagmo/population.hpp>
#include <string>

#include "waywright/optimizer/whale_search.hpp"

namespace waywright {

/// Moves as in optimizer/whale_step.hpp, in either form. Agents move whether or not that is better for them; the best place of
/// all is kept beside them and, where none of them is there, takes the place of the worst one at the end. Single objective, no constraints.
class WhaleAlgorithm {
 public:
  explicit WhaleAlgorithm(unsigned iterations = 1, unsigned seed = 1, WhaleParameters parameters = {}, WhaleForm form = WhaleForm::published)
      : iterations_{iterations}, seed_{seed}, parameters_{parameters}, form_{form} {}
  pagmo::population evolve(pagmo::population population) const;
  /// The same, and how many moves of each kind it made.
  pagmo::population evolve(pagmo::population population, WhaleCounts& counts) const;
  std::string get_name() const { return "whale optimisation algorithm"; }

 private:
  unsigned iterations_;
  unsigned seed_;
  WhaleParameters parameters_;
  WhaleForm form_;
};

}  // namespace waywright
