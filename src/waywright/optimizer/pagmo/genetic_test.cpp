#include "waywright/optimizer/pagmo/genetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <pagmo/problem.hpp>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

constexpr double low = -1.0, high = 3.0;

/// Whose values are what the test says: the first variable, or the distance from the middle.
struct Bowl {
  bool is_flat = false;
  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    double sum = 0.0;
    for (const double v : x) sum += (v - 1.2) * (v - 1.2);
    return {is_flat ? 0.0 : sum};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const { return {{low, low}, {high, high}}; }
};

pagmo::population population_of(const Bowl& bowl, const std::vector<pagmo::vector_double>& points) {
  pagmo::population population{pagmo::problem{bowl}, 0, 1};
  for (const auto& x : points) population.push_back(x);
  return population;
}

std::vector<pagmo::vector_double> random_points(std::size_t n, std::uint64_t seed) {
  Random random{seed};
  std::vector<pagmo::vector_double> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({random.uniform(low, high), random.uniform(low, high)});
  return points;
}

bool holds(const pagmo::population& population, const pagmo::vector_double& x) {
  const auto all = population.get_x();
  return std::find(all.begin(), all.end(), x) != all.end();
}

TEST(IntermediateGeneticAlgorithm, TheTwoBestStayAsTheyAre) {
  int others = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    auto points = random_points(12, seed);
    const pagmo::population before = population_of({}, points);
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return Bowl{}.fitness(a)[0] < Bowl{}.fitness(b)[0]; });
    const pagmo::population after = IntermediateGeneticAlgorithm{1, seed}.evolve(before);
    EXPECT_TRUE(holds(after, points[0]));
    EXPECT_TRUE(holds(after, points[1]));
    for (std::size_t i = 2; i < points.size(); ++i) others += holds(after, points[i]) ? 1 : 0;
    // So the best never gets worse, over any number of generations.
    double best = before.champion_f()[0];
    for (const unsigned generations : {2U, 5U, 20U}) {
      const double now = IntermediateGeneticAlgorithm{generations, seed}.evolve(before).champion_f()[0];
      EXPECT_LE(now, best);
      best = now;
    }
  }
  EXPECT_LT(others, 30) << "all but the two best are replaced, of 300; a child of one parent with itself is that parent";
}

TEST(IntermediateGeneticAlgorithm, PeriodicVariablesTakeTheShorterWayRound) {
  constexpr double range = high - low, near = 0.01;
  constexpr double reach = 0.2 * range + near;  // of a mutation, from an end
  int around = 0, between = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    // All near the two ends of both variables; the first alone goes round.
    Random random{seed};
    std::vector<pagmo::vector_double> points;
    for (int i = 0; i < 8; ++i) {
      const auto end = [&] { return random.uniform() < 0.5 ? low + random.uniform(0, near) : high - random.uniform(0, near); };
      points.push_back({end(), end()});
    }
    const pagmo::population after = IntermediateGeneticAlgorithm{1, seed, {true, false}}.evolve(population_of({true}, points));
    for (const auto& x : after.get_x()) {
      for (const double v : x) {
        EXPECT_GE(v, low);
        EXPECT_LE(v, high);
      }
      EXPECT_LE(std::min(x[0] - low, high - x[0]), reach);
      around += std::min(x[0] - low, high - x[0]) > near ? 1 : 0;
      between += std::min(x[1] - low, high - x[1]) > reach ? 1 : 0;
    }
  }
  EXPECT_GT(around, 0) << "mutation moves it over the seam and back into the range";
  EXPECT_GT(between, 100) << "a variable that does not go round is mixed between its ends";
}

TEST(IntermediateGeneticAlgorithm, ChildrenLieBetweenTheirParentsButForMutation) {
  // Of two parents far from the ends: each variable within theirs, or moved by at most a fifth of the range.
  const std::vector<pagmo::vector_double> points{{0.9, 1.0}, {1.1, 1.4}, {0.9, 1.4}, {1.1, 1.0}};
  int within = 0, moved = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const pagmo::population after = IntermediateGeneticAlgorithm{1, seed, {false, false}}.evolve(population_of({true}, points));
    for (std::size_t i = 2; i < 4; ++i) {
      const double v = after.get_x()[i][0];
      EXPECT_GE(v, 0.9 - 0.2 * (high - low));
      EXPECT_LE(v, 1.1 + 0.2 * (high - low));
      ++(v >= 0.9 && v <= 1.1 ? within : moved);
    }
  }
  EXPECT_NEAR(static_cast<double>(moved) / (within + moved), 0.2 * 0.87, 0.06);  // of the mutations some stay between
}

TEST(IntermediateGeneticAlgorithm, GoodParentsAreChosenMoreOften) {
  // One far better than the others, which are alike and far away: its share of parenthood is 1 against 1/(1 + 400).
  std::vector<pagmo::vector_double> points(10, {3.0, 3.0});
  points[4] = {1.2, 1.2};
  int near = 0, all = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const pagmo::population after = IntermediateGeneticAlgorithm{1, seed}.evolve(population_of({}, points));
    for (const auto& x : after.get_x()) {
      near += std::abs(x[0] - 1.2) < 0.9 ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GT(near, all / 4);
}

TEST(IntermediateGeneticAlgorithm, ASeedGivesTheSameBits) {
  const auto points = random_points(10, 7);
  const auto of = [&](unsigned seed) { return IntermediateGeneticAlgorithm{8, seed, {true, true}}.evolve(population_of({}, points)).get_x(); };
  EXPECT_EQ(of(5), of(5));
  EXPECT_NE(of(5), of(6));
  // Fewer than the elites: nothing to do.
  EXPECT_EQ(IntermediateGeneticAlgorithm{3}.evolve(population_of({}, random_points(2, 1))).get_x(), random_points(2, 1));
}

}  // namespace
}  // namespace waywright
