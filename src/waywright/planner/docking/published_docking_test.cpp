// The publication's fixtures (reconstruction of its stations; tables 7.3 and 7.4 of the specification of the method).
#include "waywright/planner/docking/published_docking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/curve/bezier.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

using fixture::Id;

constexpr double segment = 0.05;

std::vector<Sample> samples_at(const Problem& problem, const DockingTask& task, Side side, Vec2 t, double step = segment) {
  const Pose transition = task.frame.to_world(make_pose(t, transition_heading(side, task.dock.heading)));
  return published_samples(published_pattern(problem.start(), problem.goal(), transition), step);
}

struct Row {
  double x, y, length, tv, curvature, cost_b, cost_b_equal, cost_a;
};
constexpr Row rows[] = {
    {4.0, 3.5, 12.033, 2.461, 0.533, 1.0000, 1.0000, 1.0000},   {4.5, 3.8, 12.464, 2.324, 0.487, 0.9719, 0.9901, 0.9381},
    {5.0, 4.5, 13.683, 2.383, 0.680, 1.0191, 1.0528, 1.5515},   {3.0, 3.0, 11.614, 3.431, 1.014, 1.2656, 1.1798, 5.099},
    {2.0, 2.5, 11.660, 8.147, 3.018, 2.6085, 2.1400, 6.1e4},    {2.5, 4.5, 14.310, 3.855, 1.368, 1.4534, 1.3780, 12.86},
    {6.5, 4.0, 13.485, 4.392, 1.599, 1.5857, 1.4528, 34.16},    {6.5, 2.5, 11.219, 5.495, 1.914, 1.8428, 1.5827, 302.4},
    {4.0, 2.5, 10.692, 3.405, 0.869, 1.2351, 1.1361, 4.743},    {3.5, 4.5, 13.801, 2.578, 0.799, 1.0773, 1.0972, 1.919},
};

TEST(PublishedDocking, TenTransitionPointsMatchTheTable) {
  const Problem problem = fixture::problem(Id::d0);
  const DockingTask task = partition(problem);
  for (const Side side : {Side::left, Side::right}) {
    const PathMeasures reference = published_reference(problem, task, side, segment);
    for (const Row& row : rows) {
      const double sign = side == Side::left ? 1.0 : -1.0;
      const PathMeasures m = measure_samples(samples_at(problem, task, side, {row.x, sign * row.y}));
      EXPECT_NEAR(m.length, row.length, 1e-3 * row.length);
      EXPECT_NEAR(m.curvature_change, row.tv, 0.01 * row.tv);
      EXPECT_NEAR(m.max_curvature, row.curvature, 0.01 * row.curvature);
      EXPECT_NEAR(normalised_cost(m, reference), row.cost_b, 0.01 * row.cost_b);
      EXPECT_NEAR(normalised_cost(m, reference, {0.5, 0.5}), row.cost_b_equal, 0.01 * row.cost_b_equal);
      // The exponential magnifies the 1 % that TV may be off: e^(2·0.01·TV).
      EXPECT_NEAR(std::log(exponential_cost(m, reference) / row.cost_a), 0.0, 0.02 * row.tv + 0.01);
    }
  }
}

TEST(PublishedDocking, ClampedEndsMatchTheFirstRow) {
  const Problem problem = fixture::problem(Id::d0);
  const DockingTask task = partition(problem);
  const Pose t{4.0, 3.5, transition_heading(Side::left, task.dock.heading)};
  const PatternPoints p = pattern_points(placement_of(task.start), placement_of(task.dock), placement_of(t), published_leads);
  const std::array<Spline, 2> splines{Spline{SplineKind::natural_cubic, clamped_cubic(p.back, pi, t.heading + pi)},
                                      Spline{SplineKind::natural_cubic, clamped_cubic(p.forth, t.heading, pi)}};
  const PathMeasures m = measure_samples(published_samples(splines, segment));
  EXPECT_NEAR(m.length, 12.064, 1e-3 * 12.064);
  EXPECT_NEAR(m.curvature_change, 3.654, 0.01 * 3.654);
  EXPECT_NEAR(m.max_curvature, 0.586, 0.01 * 0.586);
}

TEST(PublishedDocking, NaturalEndsMissTheHeadingsAsStated) {
  const Problem problem = fixture::problem(Id::d0);
  const DockingTask task = partition(problem);
  const auto s = samples_at(problem, task, Side::left, {4.0, 3.5});
  const double degree = pi / 180.0;
  EXPECT_NEAR(std::abs(shorter_turn(problem.start().heading, s.front().heading)), 3.5 * degree, 0.1 * degree);
  EXPECT_NEAR(std::abs(shorter_turn(problem.goal().heading, s.back().heading)), 7.1 * degree, 0.1 * degree);
}

TEST(PublishedDocking, ChangeOfCurvatureDoesNotDependOnTheStepAndThePrintedFormDoes) {
  const Problem problem = fixture::problem(Id::d0);
  const DockingTask task = partition(problem);
  const PathMeasures coarse = measure_samples(samples_at(problem, task, Side::left, {4.0, 3.5}, 0.05));
  const PathMeasures fine = measure_samples(samples_at(problem, task, Side::left, {4.0, 3.5}, 0.025));
  EXPECT_NEAR(fine.curvature_change, coarse.curvature_change, 0.01 * coarse.curvature_change);
  EXPECT_NEAR(fine.curvature_change_printed, 2.0 * coarse.curvature_change_printed, 0.02 * fine.curvature_change_printed);
  EXPECT_NEAR(coarse.curvature_change_printed, 49.3, 0.5);
}

TEST(PublishedDocking, TheReferenceCostsOne) {
  const Problem problem = fixture::problem(Id::d2);
  const DockingTask task = partition(problem);
  const PathMeasures reference = published_reference(problem, task, Side::left, segment);
  EXPECT_DOUBLE_EQ(normalised_cost(reference, reference), 1.0);
  EXPECT_DOUBLE_EQ(exponential_cost(reference, reference), 1.0);
}

TEST(PublishedDocking, AnyScanPointInTheFootprintKnocksOutWhateverTheOrder) {
  for (const bool first : {true, false}) {
    Scenario scenario = fixture::station(Id::d1);
    const Vec2 on_path{4.0, 3.5};
    scenario.map.points.insert(first ? scenario.map.points.begin() : scenario.map.points.end(), on_path);
    const Problem problem = Problem::prepare(scenario).value();
    const DockingTask task = partition(problem);
    const PublishedScore score = published_evaluation(problem, samples_at(problem, task, Side::left, {4.0, 3.5}),
                                                      published_reference(problem, task, Side::left, segment), {});
    EXPECT_GE(score.cost, 1e3);
    EXPECT_GT(score.hits, 0U);
  }
}

struct Grid {
  double x0, x1, y0, y1, step;
};

/// Best feasible cost of a side over a grid of transition points, and how many are feasible.
std::pair<double, int> grid_search(const Problem& problem, Side side, const Grid& grid) {
  const DockingTask task = partition(problem);
  const PathMeasures reference = published_reference(problem, task, side, segment);
  double best = 1e9;
  int feasible = 0;
  for (double x = grid.x0; x < grid.x1 + 1e-9; x += grid.step) {
    for (double y = grid.y0; y < grid.y1 + 1e-9; y += grid.step) {
      const Vec2 t{x, side == Side::left ? y : -y};
      const PublishedScore score = published_evaluation(problem, samples_at(problem, task, side, t), reference, {});
      if (!score.feasible()) continue;
      ++feasible;
      best = std::min(best, score.cost);
    }
  }
  return {best, feasible};
}

TEST(PublishedDocking, GridSearchFindsTheStatedOptima) {
  // The table's grid is 0.05 m over the whole side. Here: every fourth point each way, so counts are about a sixteenth; and the
  // full density around the stated optimum of the narrowest station.
  const Grid coarse{-1.4, 10.4, 1.4, 6.9, 0.2};
  const auto [d0, d0_count] = grid_search(fixture::problem(Id::d0), Side::left, coarse);
  EXPECT_NEAR(d0, 0.968, 0.004);
  EXPECT_NEAR(d0_count, 1626 / 16, 20);
  const auto [d1, d1_count] = grid_search(fixture::problem(Id::d1), Side::left, coarse);
  EXPECT_NEAR(d1, 0.979, 0.006);
  EXPECT_NEAR(d1_count, 552 / 16, 12);
  const auto [d2, d2_count] = grid_search(fixture::problem(Id::d2), Side::left, {3.5, 4.5, 2.8, 3.8, 0.05});
  EXPECT_NEAR(d2, 1.022, 0.003);
  EXPECT_GT(d2_count, 50);
  EXPECT_EQ(grid_search(fixture::problem(Id::d2), Side::right, coarse).second, 0);
}

TEST(PublishedDocking, BlockedSideAloneFailsAndNeverCollides) {
  const Problem problem = fixture::problem(Id::d2);
  PublishedDockingOptions options;
  options.sides = SideChoice::right;
  Budget budget;
  const PlanningResult result = PublishedDockingPlanner{options, std::make_shared<LatticeSearch>(), 1}.plan(problem, budget);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().failure.status, Status::no_path);
}

TEST(Partition, NarrowSideIsDroppedWithFigures) {
  const Problem problem = fixture::problem(Id::d3);
  const DockingTask task = partition(problem);
  ASSERT_EQ(task.zones.size(), 2U);
  EXPECT_TRUE(task.zones[0].left_out());
  EXPECT_NEAR(task.zones[0].width, 0.85, 1e-9);
  EXPECT_NEAR(task.zones[0].needed, 0.90, 1e-12);
  EXPECT_NE(left_out_sentence(task.zones[0]).find("0.050 m are missing"), std::string::npos);
  EXPECT_FALSE(task.zones[1].left_out());
}

TEST(Partition, IsTheSameInAnyFrame) {
  const DockingTask a = partition(fixture::problem(Id::d2));
  const DockingTask b = partition(fixture::problem(Id::d2, {12.5, -4.0, 37.0 * pi / 180.0}));
  for (std::size_t z = 0; z < 2; ++z) {
    ASSERT_EQ(a.zones[z].polygons.size(), 1U);
    ASSERT_EQ(b.zones[z].polygons.size(), 1U);
    ASSERT_EQ(a.zones[z].polygons[0].size(), 4U);
    EXPECT_NEAR(a.zones[z].width, 5.65, 1e-9);
    EXPECT_NEAR(b.zones[z].width, 5.65, 1e-9);
    EXPECT_NEAR(signed_area(b.zones[z].polygons[0]), 12.0 * 5.65, 1e-8);
  }
}

}  // namespace
}  // namespace waywright
