// `capso` and `ga_spline` on standard functions, through the door that planners use; and the algorithms by themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <pagmo/problem.hpp>

#include "waywright/core/elementary.hpp"
#include "waywright/core/pose.hpp"
#include "waywright/core/random.hpp"
#include "waywright/optimizer/pagmo/chaotic_swarm.hpp"
#include "waywright/optimizer/pagmo/genetic.hpp"
#include "waywright/optimizer/pagmo/pagmo_optimizers.hpp"

namespace waywright {
namespace {

constexpr std::size_t dimension = 8;

/// Least, 0, at a place that is neither the middle nor a corner.
double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (x[k] - 0.7) * (x[k] - 0.7);
  return sum;
}
double rastrigin(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += (v - 0.7) * (v - 0.7) + 10.0 * (1.0 - sin_cos(2.0 * pi * (v - 0.7)).cos);
  return sum;
}
/// Least at a corner of the box.
double slope(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v;
  return sum;
}

SearchSpace box() { return {std::vector<double>(dimension, -5.12), std::vector<double>(dimension, 5.12)}; }

class SplineOptimizers : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Optimizer> optimizer() const {
    for (const OptimizerDescription& o : pagmo_optimizers()) {
      if (o.name == GetParam()) return o.make();
    }
    return nullptr;
  }
  SearchResult search(double (*function)(std::span<const double>), std::int64_t evaluations, std::uint64_t seed, Budget& budget) const {
    SearchOptions options;
    options.evaluations = evaluations;
    options.population = 30;
    options.seed = seed;
    const SearchSpace space = box();
    return optimizer()->minimise(
        [&](std::span<const double> x, double) {
          for (std::size_t k = 0; k < x.size(); ++k) {
            EXPECT_GE(x[k], space.low[k]);
            EXPECT_LE(x[k], space.high[k]);
          }
          const double value = function(x);
          return Evaluation{value, 0.0, value};
        },
        space, options, budget);
  }
};

double best_of_random(double (*function)(std::span<const double>), int evaluations, std::uint64_t seed) {
  Random random{seed};
  double best = std::numeric_limits<double>::infinity();
  std::vector<double> x(dimension);
  for (int i = 0; i < evaluations; ++i) {
    for (double& v : x) v = random.uniform(-5.12, 5.12);
    best = std::min(best, function(x));
  }
  return best;
}

TEST_P(SplineOptimizers, AreBetterThanAsManyRandomPoints) {
  double spheres = 0.0, random_spheres = 0.0, rastrigins = 0.0, random_rastrigins = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Budget a, b;
    const SearchResult of_sphere = search(sphere, 3000, seed, a), of_rastrigin = search(rastrigin, 3000, seed, b);
    const double random_sphere = best_of_random(sphere, 3000, seed), random_rastrigin = best_of_random(rastrigin, 3000, seed);
    EXPECT_LT(of_sphere.cost, 0.25 * random_sphere) << seed;
    EXPECT_LT(of_rastrigin.cost, random_rastrigin) << seed;
    EXPECT_EQ(of_sphere.cost, sphere(of_sphere.best));
    spheres += of_sphere.cost;
    random_spheres += random_sphere;
    rastrigins += of_rastrigin.cost;
    random_rastrigins += random_rastrigin;
  }
  EXPECT_LT(spheres, 0.1 * random_spheres);
  EXPECT_LT(rastrigins, 0.7 * random_rastrigins);
}

TEST_P(SplineOptimizers, KeepTheirBoundsWhereTheBestIsInACorner) {
  Budget budget;
  EXPECT_LT(search(slope, 3000, 1, budget).cost, -0.97 * 5.12 * dimension);
}

TEST_P(SplineOptimizers, ASeedGivesTheSameBits) {
  Budget a, b, c;
  const SearchResult first = search(rastrigin, 700, 3, a), again = search(rastrigin, 700, 3, b), other = search(rastrigin, 700, 4, c);
  EXPECT_EQ(first.best, again.best);
  EXPECT_EQ(first.cost, again.cost);
  EXPECT_NE(first.best, other.best);
}

TEST_P(SplineOptimizers, KeepTheirBudget) {
  for (const std::int64_t evaluations : {1, 2, 3, 29, 30, 31, 100, 1000}) {
    Budget budget;
    const SearchResult result = search(sphere, evaluations, 1, budget);
    EXPECT_LE(result.evaluations, evaluations);
    EXPECT_GT(result.evaluations, evaluations - 2 * 30) << "less than an iteration is left";
    EXPECT_GE(result.evaluations, 1);
    EXPECT_EQ(budget.evaluations(), result.evaluations);
    EXPECT_EQ(result.best.size(), dimension);
  }
  std::atomic<bool> cancel{true};
  Budget canceled{{}, &cancel};
  EXPECT_EQ(search(sphere, 1000, 1, canceled).evaluations, 0);
}

TEST_P(SplineOptimizers, EndAtTheEvaluationThatRaisesTheFlag) {
  std::atomic<bool> cancel{false};
  Budget budget{{}, &cancel};
  SearchOptions options;
  options.evaluations = 5000;
  options.population = 30;
  int asked = 0;
  const SearchResult result = optimizer()->minimise(
      [&](std::span<const double> x, double) {
        if (++asked == 123) cancel = true;
        const double value = sphere(x);
        return Evaluation{value, 0.0, value};
      },
      box(), options, budget);
  EXPECT_EQ(result.evaluations, 123);
  EXPECT_EQ(result.best.size(), dimension);
}

INSTANTIATE_TEST_SUITE_P(Both, SplineOptimizers, testing::Values("capso", "ga_spline"), [](const auto& entry) { return entry.param; });

struct Bowl {
  pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {(x[0] - 1.2) * (x[0] - 1.2) + (x[1] - 1.2) * (x[1] - 1.2)}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {{-1.0, -1.0}, {3.0, 3.0}}; }
};

pagmo::population some(std::size_t n, std::uint64_t seed) {
  Random random{seed};
  pagmo::population population{pagmo::problem{Bowl{}}, 0, 1};
  for (std::size_t i = 0; i < n; ++i) population.push_back({random.uniform(-1.0, 3.0), random.uniform(-1.0, 3.0)});
  return population;
}

TEST(ChaoticSwarm, EachParticleKeepsItsBestPlace) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const pagmo::population before = some(10, seed), after = ChaoticSwarm{4, seed}.evolve(before);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_LE(after.get_f()[i][0], before.get_f()[i][0]);
      EXPECT_EQ(after.get_f()[i], Bowl{}.fitness(after.get_x()[i]));
    }
    EXPECT_EQ(after.get_problem().get_fevals(), 10U + 4U * 10U * ChaoticSwarm::evaluations_a_move);
  }
}

TEST(ChaoticSwarm, AntennaeLeadASingleParticleDownhill) {
  // Its own best place and the swarm's are where it is, or behind it: what moves it downhill is what its antennae feel.
  int nearer = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const pagmo::population before = some(1, seed);
    nearer += ChaoticSwarm{30, seed}.evolve(before).get_f()[0][0] < 0.25 * before.get_f()[0][0] ? 1 : 0;
  }
  EXPECT_GT(nearer, 40);
}

TEST(ArithmeticGeneticAlgorithm, TheTwoBestStayAndChildrenLieOnTheLineBetweenTheirParentsButForMutation) {
  int on_line = 0, all = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    // All parents on a diagonal, so that arithmetic crossover stays on it and one weight a variable would not.
    Random random{seed};
    pagmo::population before{pagmo::problem{Bowl{}}, 0, 1};
    for (int i = 0; i < 10; ++i) {
      const double v = random.uniform(-1.0, 3.0);
      before.push_back({v, v});
    }
    const pagmo::population after = ArithmeticGeneticAlgorithm{1, seed}.evolve(before);
    auto values = before.get_f();
    std::sort(values.begin(), values.end());
    auto now = after.get_f();
    std::sort(now.begin(), now.end());
    EXPECT_LE(now[0], values[0]);
    EXPECT_LE(now[1], values[1]);
    for (const auto& x : after.get_x()) {
      on_line += std::abs(x[0] - x[1]) < 1e-12 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(on_line) / all, (2.0 + 8.0 * 0.81) / 10.0, 0.04);  // two elites; no mutation of either variable
}

}  // namespace
}  // namespace waywright
