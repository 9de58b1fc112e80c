// Genetic algorithms as pagmo algorithms: what pagmo's own has no operators for.
#pragma once

#include <pagmo/population.hpp>
#include <string>
#include <utility>
#include <vector>

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

/// Parents with probability ∝ 1/(1 + f − f_min) (the publication gives no inversion), child a + w(b − a) with one w in [0, 1) per variable, each
/// variable moved with probability 0.2 by at most 20 % of its range, two elites. Periodic variables take the shorter way round (waypoint
/// publication, §5, corrected).
class IntermediateGeneticAlgorithm {
 public:
  explicit IntermediateGeneticAlgorithm(unsigned generations = 1, unsigned seed = 1, std::vector<bool> periodic = {})
      : generations_{generations}, seed_{seed}, periodic_{std::move(periodic)} {}
  pagmo::population evolve(pagmo::population population) const;
  std::string get_name() const { return "genetic algorithm with intermediate crossover"; }

 private:
  static constexpr double mutation_probability = 0.2;
  static constexpr double mutation_reach = 0.2;  // of the range
  static constexpr std::size_t elites = 2;
  unsigned generations_;
  unsigned seed_;
  std::vector<bool> periodic_;
};

/// Tournament of two, whole arithmetic crossover with probability 0.8 (child αa + (1 − α)b, one α a child; else a), each variable moved with probability
/// 0.1 by a Gaussian of σ = 5 % of its range, two elites (the safe-A* publication's GA on B-splines, reconstructed).
class ArithmeticGeneticAlgorithm {
 public:
  explicit ArithmeticGeneticAlgorithm(unsigned generations = 1, unsigned seed = 1) : generations_{generations}, seed_{seed} {}
  pagmo::population evolve(pagmo::population population) const;
  std::string get_name() const { return "genetic algorithm with arithmetic crossover"; }

  static constexpr std::size_t elites = 2;

 private:
  static constexpr double crossover_probability = 0.8;
  static constexpr double mutation_probability = 0.1;
  static constexpr double mutation_width = 0.05;  // of the range
  unsigned generations_;
  unsigned seed_;
};

}  // namespace waywright
