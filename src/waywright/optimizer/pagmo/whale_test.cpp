// `woa` and `woa_unbiased` on standard functions, through the door that planners use, and the algorithm by itself.
#include "waywright/optimizer/pagmo/whale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <pagmo/problem.hpp>

#include "waywright/core/elementary.hpp"
#include "waywright/core/pose.hpp"
#include "waywright/optimizer/pagmo/pagmo_optimizers.hpp"

namespace waywright {
namespace {

// All least, 0, at the origin.
double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return sum;
}
double rosenbrock(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    const double a = x[k] + 1.0, b = x[k + 1] + 1.0;
    sum += 100.0 * (b - a * a) * (b - a * a) + (1.0 - a) * (1.0 - a);
  }
  return sum;
}
double rastrigin(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v + 10.0 * (1.0 - sin_cos(2.0 * pi * v).cos);
  return sum;
}
double ackley(std::span<const double> x) {
  double squares = 0.0, cosines = 0.0;
  for (const double v : x) {
    squares += v * v;
    cosines += sin_cos(2.0 * pi * v).cos;
  }
  const auto n = static_cast<double>(x.size());
  return 20.0 * (1.0 - exponential(-0.2 * std::sqrt(squares / n))) + exponential(1.0) - exponential(cosines / n);
}
using Function = double (*)(std::span<const double>);
struct Case {
  const char* name;
  Function of;
};
constexpr Case cases[] = {{"sphere", sphere}, {"Rosenbrock", rosenbrock}, {"Rastrigin", rastrigin}, {"Ackley", ackley}};

constexpr std::int64_t evaluations = 3000;
constexpr double half = 5.0;

/// The optimum is at ±`off` (signs alternate), the bounds are `half` to both sides of `middle`.
SearchResult search(const std::string& name, Function function, std::size_t dimension, double off, double middle, std::uint64_t seed) {
  for (const OptimizerDescription& o : pagmo_optimizers()) {
    if (o.name != name) continue;
    Budget budget;
    std::vector<double> moved(dimension);
    const SearchSpace space{std::vector<double>(dimension, middle - half), std::vector<double>(dimension, middle + half)};
    return o.make()->minimise(
        [&](std::span<const double> x, double) {
          for (std::size_t k = 0; k < x.size(); ++k) {
            EXPECT_TRUE(x[k] >= space.low[k] && x[k] <= space.high[k]);
            moved[k] = x[k] - middle - (k % 2 == 0 ? off : -off);
          }
          const double value = function(moved);
          return Evaluation{value, 0.0, value};
        },
        space, {.evaluations = evaluations, .population = 30, .seed = seed}, budget);
  }
  ADD_FAILURE() << name << " is not registered";
  return {};
}

double median(const std::string& name, Function function, std::size_t dimension, double off) {
  std::vector<double> values;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) values.push_back(search(name, function, dimension, off, 0.0, seed).cost);
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Off the middle the unbiased form's median is at most this times what it is there.
constexpr double factor = 20.0;
constexpr double floor_of_values = 1e-9;  // below which it does not matter

TEST(WhaleAlgorithm, UnbiasedItFindsOptimaOffTheMiddleAsWellAsThere) {
  for (const Case& c : cases) {
    for (const std::size_t dimension : {2U, 5U, 10U}) {
      const double centred = median("woa_unbiased", c.of, dimension, 0.0), shifted = median("woa_unbiased", c.of, dimension, 1.7);
      EXPECT_LT(shifted, factor * std::max(centred, floor_of_values)) << c.name << " in " << dimension;
    }
  }
}

TEST(WhaleAlgorithm, UnbiasedItIsOfTheOrderOfDifferentialEvolution) {
  for (const Case& c : cases) {
    for (const std::size_t dimension : {5U, 10U}) {
      EXPECT_LT(median("woa_unbiased", c.of, dimension, 1.7), 3.0 * std::max(median("de", c.of, dimension, 1.7), floor_of_values)) << c.name << " in " << dimension;
    }
  }
}

TEST(WhaleAlgorithm, AsPublishedItIsDrawnToTheMiddleOfTheBounds) {
  // What the documentation says of it. In the middle better than anything else here, off it worse by orders of magnitude.
  for (const std::size_t dimension : {5U, 10U}) {
    const double centred = median("woa", sphere, dimension, 0.0), shifted = median("woa", sphere, dimension, 1.7);
    EXPECT_LT(centred, 1e-12);
    EXPECT_GT(shifted, 1e6 * centred);
    EXPECT_LT(shifted, 0.5 * 1.7 * 1.7 * static_cast<double>(dimension)) << "but better than the middle";
  }
}

TEST(WhaleAlgorithm, BoundsThatMoveWithTheOptimumChangeNothing) {
  // Whole numbers and a power of two: the moved coordinates are exact at the start; chaos of rounding grows after.
  for (const std::string name : {"woa", "woa_unbiased"}) {
    std::vector<double> here, there;
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
      here.push_back(search(name, ackley, 5, 1.7, 0.0, seed).cost);
      there.push_back(search(name, ackley, 5, 1.7, 64.0, seed).cost);
    }
    std::sort(here.begin(), here.end());
    std::sort(there.begin(), there.end());
    EXPECT_LT(there[7], 4.0 * here[7] + 1e-6) << name;
    EXPECT_GT(there[7], 0.25 * here[7] - 1e-6) << name;
  }
}

TEST(WhaleAlgorithm, ASeedGivesTheSameBits) {
  for (const std::string name : {"woa", "woa_unbiased"}) {
    const SearchResult first = search(name, rastrigin, 6, 0.7, 0.0, 3), again = search(name, rastrigin, 6, 0.7, 0.0, 3), other = search(name, rastrigin, 6, 0.7, 0.0, 4);
    EXPECT_EQ(first.best, again.best);
    EXPECT_EQ(first.cost, again.cost);
    EXPECT_NE(first.best, other.best);
    EXPECT_EQ(first.evaluations, evaluations);
  }
}

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

TEST(WhaleAlgorithm, TheBestPlaceIsInThePopulationAfterwards) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const pagmo::population before = some(8, seed);
    double best = std::numeric_limits<double>::infinity();
    for (const unsigned iterations : {0U, 1U, 3U, 10U}) {
      // Fewer iterations are no beginning of more: the reach falls faster. None may lose the best that was there.
      const pagmo::population after = WhaleAlgorithm{iterations, seed}.evolve(before);
      best = after.get_f()[after.best_idx()][0];
      EXPECT_LE(best, before.get_f()[before.best_idx()][0]);
      EXPECT_EQ(best, after.champion_f()[0]);
      for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(after.get_f()[i], Bowl{}.fitness(after.get_x()[i]));
      EXPECT_EQ(after.get_problem().get_fevals(), 8U + 8U * iterations);
    }
  }
  EXPECT_EQ(WhaleAlgorithm{5}.evolve(some(0, 1)).size(), 0U);
}

TEST(WhaleAlgorithm, ThresholdsSettleItsMoves) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  WhaleCounts searches, encircles, both;
  WhaleAlgorithm{10, 1, {.choice = 1.0, .threshold = 0.0}}.evolve(some(8, 1), searches);
  WhaleAlgorithm{10, 1, {.choice = 1.0, .threshold = infinity}}.evolve(some(8, 1), encircles);
  WhaleAlgorithm{400, 1}.evolve(some(8, 1), both);
  EXPECT_EQ(searches.searches, 80);
  EXPECT_EQ(searches.encircles + searches.spirals, 0);
  EXPECT_EQ(encircles.encircles, 80);
  EXPECT_EQ(encircles.searches + encircles.spirals, 0);
  // By default half are spirals; of the others |A| < 1 surely in the second half, and with probability 1/a before: ln 2 / 2 + 1/2 in all.
  const double all = 3200.0;
  EXPECT_NEAR(static_cast<double>(both.spirals) / all, 0.5, 0.03);
  EXPECT_NEAR(static_cast<double>(both.encircles) / all, 0.5 * (0.5 + 0.5 * std::log(2.0)), 0.03);
}

TEST(WhaleAlgorithm, EndsAtTheEvaluationThatRaisesTheFlagAndKeepsItsBudget) {
  for (const OptimizerDescription& o : pagmo_optimizers()) {
    if (o.name != "woa" && o.name != "woa_unbiased") continue;
    for (const std::int64_t limit : {1, 2, 7, 30, 31, 100}) {
      Budget budget;
      const SearchResult r = o.make()->minimise([](std::span<const double> x, double) { return Evaluation{sphere(x), 0.0, sphere(x)}; },
                                                {{-1.0, -1.0}, {2.0, 2.0}}, {.evaluations = limit, .population = 30, .seed = 1}, budget);
      EXPECT_EQ(r.evaluations, limit);
    }
    std::atomic<bool> cancel{false};
    Budget budget{{}, &cancel};
    int asked = 0;
    const SearchResult r = o.make()->minimise(
        [&](std::span<const double> x, double) {
          if (++asked == 123) cancel = true;
          return Evaluation{sphere(x), 0.0, sphere(x)};
        },
        {{-1.0, -1.0}, {2.0, 2.0}}, {.evaluations = 5000, .population = 30, .seed = 1}, budget);
    EXPECT_EQ(r.evaluations, 123);
  }
}

}  // namespace
}  // namespace waywright
