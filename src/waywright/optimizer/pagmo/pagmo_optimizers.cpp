#include "waywright/optimizer/pagmo/pagmo_optimizers.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/gaco.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>

#include "waywright/optimizer/pagmo/chaotic_swarm.hpp"
#include "waywright/optimizer/pagmo/genetic.hpp"
#include "waywright/optimizer/pagmo/search.hpp"
#include "waywright/optimizer/pagmo/whale.hpp"

namespace waywright {
namespace {

/// What an evaluation leaves behind. Shared by pagmo's copies of the problem.
struct Recorder {
  const CostFunction& cost;
  std::int64_t limit;
  Budget& budget;
  SearchResult result{};

  double evaluate(const std::vector<double>& x) {
    if (result.evaluations >= limit || budget.exhausted()) throw BudgetSpent{};
    double value = cost(x, std::numeric_limits<double>::infinity()).graded;
    if (std::isnan(value)) value = std::numeric_limits<double>::max();
    ++result.evaluations;
    budget.count_evaluations();
    if (result.best.empty() || value < result.cost) {
      result.best = x;
      result.cost = value;
    }
    return value;
  }
};

/// The cost function as a pagmo problem.
struct Problem {
  Recorder* recorder = nullptr;
  pagmo::vector_double low{0.0};
  pagmo::vector_double high{1.0};
  pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {recorder->evaluate(x)}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {low, high}; }
};

/// Makes the algorithm for a number of generations; pagmo's are asked for all of them at once, since some restart on each call.
struct Setting {
  unsigned generations, population, dimension, seed;
  std::vector<bool> periodic;
};
using MakeAlgorithm = std::function<pagmo::algorithm(const Setting&)>;

class PagmoOptimizer final : public Optimizer {
 public:
  PagmoOptimizer(MakeAlgorithm make, int fixed_population, int least_population)
      : make_{std::move(make)}, fixed_population_{fixed_population}, least_population_{least_population} {}

  SearchResult minimise(const CostFunction& cost, const SearchSpace& space, const SearchOptions& options,
                        Budget& budget) const override {
    if (space.dimension() == 0 || options.evaluations < 1) return {};
    Recorder recorder{cost, options.evaluations, budget};
    const int wanted = fixed_population_ > 0 ? fixed_population_ : std::max(options.population, least_population_);
    const auto size = static_cast<unsigned>(std::clamp<std::int64_t>(wanted, 1, options.evaluations));
    PagmoSeeds seeds{options.seed};
    try {
      pagmo::population population = first_population(Problem{&recorder, space.low, space.high}, space, options.seed, size, seeds);
      const auto left = static_cast<unsigned>(std::min<std::int64_t>(options.evaluations - size, 1'000'000'000));
      if (left > 0) make_({left / size + 2, size, static_cast<unsigned>(space.dimension()), seeds.next(), space.periodic}).evolve(population);
    } catch (const BudgetSpent&) {
      // The usual end: the last generation is cut where the budget is.
    } catch (const std::exception&) {
      // An algorithm that refuses its population (too small for its operators) leaves what was found so far.
    }
    return std::move(recorder.result);
  }

 private:
  MakeAlgorithm make_;
  int fixed_population_;
  int least_population_;
};

OptimizerDescription describe(std::string name, std::string summary, MakeAlgorithm make, int fixed_population = 0,
                              int least_population = 1) {
  return {std::move(name), std::move(summary), [make = std::move(make), fixed_population, least_population] {
            return std::unique_ptr<Optimizer>{
                std::make_unique<PagmoOptimizer>(make, fixed_population, least_population)};
          }};
}

pagmo::algorithm whale(const Setting& set, WhaleForm form) {
  // One more generation than there are evaluations for is asked of all algorithms; this one has to know when it ends.
  return pagmo::algorithm{WhaleAlgorithm{std::max(1U, set.generations - 1), set.seed, {}, form}};
}

}  // namespace

std::vector<OptimizerDescription> pagmo_optimizers() {
  return {
      describe("ga", "genetic algorithm: tournament 2, blend crossover 0.9, Gaussian mutation 0.2, one elite",
               [](const Setting& set) {
                 return pagmo::algorithm{BlendGeneticAlgorithm{set.generations, set.seed}};
               },
               0, 2),
      describe("ga_intermediate",
               "genetic algorithm of the waypoint publication: fitness-proportional, intermediate crossover, bounded mutation, two elites; angles go round",
               [](const Setting& set) {
                 return pagmo::algorithm{IntermediateGeneticAlgorithm{set.generations, set.seed, set.periodic}};
               },
               0, 4),
      describe("ga_spline", "genetic algorithm of the safe-A* publication: tournament 2, arithmetic crossover 0.8, Gaussian mutation 0.1 of 5 % of the range, two elites",
               [](const Setting& set) {
                 // Elites are not evaluated again: what they leave is for more generations.
                 const auto size = static_cast<std::uint64_t>(set.population);
                 const std::uint64_t generations = size > ArithmeticGeneticAlgorithm::elites ? set.generations * size / (size - ArithmeticGeneticAlgorithm::elites) + 1 : 1;
                 return pagmo::algorithm{ArithmeticGeneticAlgorithm{static_cast<unsigned>(std::min<std::uint64_t>(generations, 1'000'000'000)), set.seed}};
               },
               0, 4),
      describe("capso", "particle swarm of the safe-A* publication: chaotic factors, weights that follow a cosine, antennae; three evaluations a move",
               [](const Setting& set) {
                 // It has to know when it ends: what it does follows the share of the time that is over.
                 return pagmo::algorithm{ChaoticSwarm{std::max(1U, set.generations / ChaoticSwarm::evaluations_a_move), set.seed}};
               },
               0, 2),
      describe("woa", "whale optimisation algorithm as published: encircles the best, searches about others, spirals; a from 2 to 0, b = 1, thresholds 0.5 and 1; drawn to the middle",
               [](const Setting& set) { return whale(set, WhaleForm::published); }, 0, 2),
      describe("woa_unbiased", "the same about the mean of its agents, each variable with signs and spirals of its own: no place is preferred",
               [](const Setting& set) { return whale(set, WhaleForm::unbiased); }, 0, 2),
      describe("pso", "particle swarm: constriction 0.7298, c1 = c2 = 2.05, speed at most half the range",
               [](const Setting& set) {
                 return pagmo::algorithm{pagmo::pso{set.generations, 0.7298, 2.05, 2.05, 0.5, 5, 1, 4, false, set.seed}};
               },
               0, 2),
      describe("de", "differential evolution rand/1/bin, F = 0.8, CR = 0.9",
               [](const Setting& set) {
                 return pagmo::algorithm{pagmo::de{set.generations, 0.8, 0.9, 7, 0.0, 0.0, set.seed}};
               },
               0, 5),
      describe("sa", "simulated annealing from temperature 1 to 0.01",
               [](const Setting& set) {
                 // Cooled evenly over the whole budget; each temperature moves every variable once.
                 const unsigned temperatures = std::max(1U, set.generations / set.dimension);
                 return pagmo::algorithm{pagmo::simulated_annealing{1.0, 0.01, temperatures, 1, 1, 0.5, set.seed}};
               },
               1),
      describe("aco", "ant colony with an archive of ten Gaussian kernels, q = 0.5",
               [](const Setting& set) {
                 const unsigned kernels = std::min(10U, set.population);
                 return pagmo::algorithm{pagmo::gaco{set.generations, kernels, 0.5, 0.0, 0.01, set.generations, 7,
                                                     1'000'000'000U, 1'000'000'000U, 0.0, false, set.seed}};
               },
               0, 2),
  };
}

}  // namespace waywright
