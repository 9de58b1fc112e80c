#include "waywright/planner/docking/optimality.hpp"

#include <gtest/gtest.h>

#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/pattern_search.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

using fixture::Id;

double searched(const PreparedDocking& prepared, const PatternDockingOptions& options, std::int64_t evaluations) {
  Budget budget;
  const LatticeSearch optimizer;
  PatternSearch search{prepared, options, optimizer};
  auto& sides = search.search({{placement_of(prepared.problem().start())}}, evaluations, 1, false, budget);
  const SideFound* best = best_of(sides);
  return best == nullptr ? 1e9 : best->cost;
}

void nothing_found_is_under_the_bound(std::initializer_list<Id> stations, double wanted) {
  for (const Id id : stations) {
    const Problem problem = fixture::problem(id);
    const PreparedDocking prepared{problem};
    for (const auto& [range, objective] : {std::pair{1.0, DockingObjective::normalised}, std::pair{0.0, DockingObjective::normalised},
                                           std::pair{0.0, DockingObjective::exponential}}) {
      PatternDockingOptions options;
      options.heading_range = range;
      options.objective = objective;
      options.gap = wanted;
      const double cost = searched(prepared, options, 600);
      const double better = searched(prepared, options, 8000);
      Budget budget;
      const Optimality o = bound_optimum(prepared, options, reference_measures(prepared, options.leads), cost, budget);
      EXPECT_EQ(o.cost, cost);
      EXPECT_LE(o.lower_bound, better);
      EXPECT_TRUE(o.gap() <= options.gap * (1.0 + 1e-9) || o.boxes >= 400'000) << o.gap();
      EXPECT_LT(o.gap(), 0.5) << "a bound that is far from everything is of no use";
    }
  }
}
TEST(Optimality, NothingThatASearchFindsIsUnderTheBound) { nothing_found_is_under_the_bound({Id::d1, Id::d2}, 0.25); }
TEST(Optimality, NothingThatASearchFindsIsUnderTheBoundFull) { nothing_found_is_under_the_bound({Id::d0, Id::d1, Id::d2, Id::d3}, 0.08); }

TEST(Optimality, AFlagEndsItWithWhatIsKnown) {
  const Problem problem = fixture::problem(Id::d1);
  const PreparedDocking prepared{problem};
  PatternDockingOptions options;
  options.gap = 0.001;
  std::atomic<bool> cancel{true};
  Budget budget{{}, &cancel};
  const Optimality o = bound_optimum(prepared, options, reference_measures(prepared, options.leads), 1.0, budget);
  EXPECT_EQ(o.lower_bound, 0.0);
  EXPECT_LT(o.boxes, 10);
}

TEST(Optimality, StandsWithTheAnswerWhereItIsAskedFor) {
  const Problem problem = fixture::problem(Id::d2);
  PatternDockingOptions options;
  options.gap = 0.2;
  Budget budget;
  const auto with = PatternDockingPlanner{options, std::make_shared<LatticeSearch>(), 1}.plan(problem, budget);
  ASSERT_TRUE(with && with->optimality);
  EXPECT_LE(with->optimality->gap(), 0.2 + 1e-9);
  EXPECT_NE(with->explanation.back().find("above the optimum"), std::string::npos);
  options.gap = 0.0;
  const auto without = PatternDockingPlanner{options, std::make_shared<LatticeSearch>(), 1}.plan(problem, budget);
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->optimality);
}

}  // namespace
}  // namespace waywright
