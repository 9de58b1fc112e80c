#include "waywright/planner/docking/cost_bound.hpp"

#include <gtest/gtest.h>

#include <array>

#include "waywright/core/random.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

TEST(PatternBounds, NoPatternOfABoxIsUnderItsBound) {
  const Problem problem = fixture::problem(fixture::Id::d0);
  const PreparedDocking prepared{problem};
  CandidateEvaluator evaluator{prepared};
  Random random{4};
  for (const PatternLeads& leads : {PatternLeads{}, PatternLeads{0.4, 0.3, 0.5}}) {
    for (const TransitionZone& zone : prepared.task().zones) {
      const PatternBounds bounds{prepared, zone.side, leads};
      const SearchSpace space = search_space(zone, 1.0);
      double closest = 0.0;
      for (int i = 0; i < 400; ++i) {
        const double size = random.uniform() * random.uniform() * random.uniform();  // of the space: small ones are tight
        TransitionBox box;
        std::array<double, 3> low{}, high{};
        for (std::size_t k = 0; k < 3; ++k) {
          const double span = size * (space.high[k] - space.low[k]);
          low[k] = random.uniform(space.low[k], space.high[k] - span);
          high[k] = low[k] + span;
        }
        box = {{low[0], low[1]}, {high[0], high[1]}, low[2], high[2]};
        const PatternBound bound = bounds.over(box);
        for (int j = 0; j < 40; ++j) {
          std::array<double, 3> x{};
          for (std::size_t k = 0; k < 3; ++k) x[k] = j == 0 ? low[k] : random.uniform(low[k], high[k]);
          const PathMeasures m =
              evaluator.measure(docking_pattern(placement_of(problem.start()), placement_of(problem.goal()), transition_placement(prepared.task(), zone, x), leads)).measures;
          ASSERT_LE(bound.length, m.length) << i;
          ASSERT_LE(bound.curvature_change, m.curvature_change) << i;
          closest = std::max(closest, bound.length / m.length);
        }
      }
      EXPECT_GT(closest, 0.97) << "a bound that is far from everything is of no use";
    }
  }
}

TEST(PatternBounds, SmallBoxesHaveTightBounds) {
  const Problem problem = fixture::problem(fixture::Id::d0);
  const PreparedDocking prepared{problem};
  CandidateEvaluator evaluator{prepared};
  const TransitionZone& zone = prepared.task().zones[0];
  const PatternBounds bounds{prepared, zone.side, {}};
  const std::array<double, 3> x{4.3, 3.6, 0.1};
  const PathMeasures m =
      evaluator.measure(docking_pattern(placement_of(problem.start()), placement_of(problem.goal()), transition_placement(prepared.task(), zone, x), {})).measures;
  const PatternBound bound = bounds.over({{x[0] - 0.01, x[1] - 0.01}, {x[0] + 0.01, x[1] + 0.01}, x[2] - 0.003, x[2] + 0.003});
  std::printf("length %.4f of %.4f, change of curvature %.4f of %.4f\n", bound.length, m.length, bound.curvature_change, m.curvature_change);
  EXPECT_GT(bound.length, 0.9 * m.length);
  EXPECT_GT(bound.curvature_change, 0.6 * m.curvature_change);
}

TEST(PatternBounds, WhereAllAreSaidToCollideNoneIsFree) {
  const Problem problem = fixture::problem(fixture::Id::d2);
  const PreparedDocking prepared{problem};
  CandidateEvaluator evaluator{prepared};
  Random random{9};
  int said = 0, free = 0;
  for (const TransitionZone& zone : prepared.task().zones) {
    const PatternBounds bounds{prepared, zone.side, {}};
    const SearchSpace space = search_space(zone, 1.0);
    for (int i = 0; i < 2000; ++i) {
      const double size = 0.1 * random.uniform();
      std::array<double, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        const double span = size * (space.high[k] - space.low[k]);
        low[k] = random.uniform(space.low[k], space.high[k] - span);
        high[k] = low[k] + span;
      }
      if (!bounds.all_collide({{low[0], low[1]}, {high[0], high[1]}, low[2], high[2]})) continue;
      ++said;
      for (int j = 0; j < 20; ++j) {
        std::array<double, 3> x{};
        for (std::size_t k = 0; k < 3; ++k) x[k] = random.uniform(low[k], high[k]);
        const auto pattern = docking_pattern(placement_of(problem.start()), placement_of(problem.goal()), transition_placement(prepared.task(), zone, x), PatternLeads{});
        free += evaluator.evaluate(pattern).free ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(free, 0);
  EXPECT_GT(said, 400) << "it does say so";
}

}  // namespace
}  // namespace waywright
