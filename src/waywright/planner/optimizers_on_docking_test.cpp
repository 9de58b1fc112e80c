// Every optimiser on the published docking problem: 300 evaluations, 30 seeds (acceptance checks of the method's specification).
#include <gtest/gtest.h>

#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/published_docking.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

using fixture::Id;

class OptimizersOnDocking : public testing::TestWithParam<std::string> {};

int hits(const Problem& problem, const std::string& optimizer, double wanted) {
  PublishedDockingOptions options;
  options.sides = SideChoice::left;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Budget budget;
    const auto result =
        PublishedDockingPlanner{options, std::shared_ptr<const Optimizer>{find_optimizer(optimizer)->make()}, seed}.plan(problem, budget);
    EXPECT_LE(budget.evaluations(), 300);
    if (result && *result->alternatives.front().cost <= wanted) ++count;
  }
  return count;
}

TEST_P(OptimizersOnDocking, FindsTheOptimumOfTheFreeStation) {
  const int found = hits(fixture::problem(Id::d0), GetParam(), 0.975);
  RecordProperty("hits", found);
  EXPECT_GE(found, 27);
}

TEST_P(OptimizersOnDocking, FindsTheNarrowWayOfTheClutteredStation) {
  const int found = hits(fixture::problem(Id::d2), GetParam(), 1.03);
  RecordProperty("hits", found);
  // The published knock-out has hardly a slope (hit poses over poses): with 300 evaluations the five metaheuristics find the
  // 150 feasible of 26 196 grid points in 2 to 16 of 30 seeds. The lattice does without luck.
  EXPECT_GE(found, GetParam() == "lattice_search" ? 27 : 1);
}

INSTANTIATE_TEST_SUITE_P(All, OptimizersOnDocking, testing::Values("lattice_search", "ga", "pso", "de", "sa", "aco"),
                         [](const auto& entry) { return entry.param; });

}  // namespace
}  // namespace waywright
