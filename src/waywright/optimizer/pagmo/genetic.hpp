// A genetic algorithm as a pagmo algorithm: what pagmo's own has no operator for.
#pragma once

#include <pagmo/population.hpp>
#include <string>

namespace waywright {

/// Tournament of two, blend crossover x = a + r(b − a) with one r per variable, Gaussian mutation with σ = 0.1 of the range,
/// one elite (reconstruction of the docking publication's GA).
class BlendGeneticAlgorithm {
 public:
  explicit BlendGeneticAlgorithm(unsigned generations = 1, unsigned seed = 1) : generations_{generations}, seed_{seed} {}
  pagmo::population evolve(pagmo::population population) const;
  std::string get_name() const { return "genetic algorithm with blend crossover"; }

 private:
  static constexpr double crossover_probability = 0.9;
  static constexpr double mutation_probability = 0.2;
  static constexpr double mutation_width = 0.1;
  unsigned generations_;
  unsigned seed_;
};

}  // namespace waywright
