// The worlds of the publication with the results of its reconstruction, for a point; and with a mecanum base.
#include "waywright/planner/field/field_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/judge/judge.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Scenario scenario(const std::string& name, std::size_t task, double scale = 1.0) {
  FieldWorld world = field_world(name).value();
  Scenario s;
  s.map = std::move(world.map);
  for (auto* rings : {&s.map.boundaries, &s.map.obstacles}) {
    for (Ring& ring : *rings) {
      for (Vec2& p : ring) p = scale * p;
    }
  }
  s.vehicle.footprint.disc = 0.0;
  s.vehicle.drive = Mecanum{0.05, 0.24, 0.15};
  s.start = make_pose(scale * world.tasks[task].start, 0.0);
  s.mission = make_pose(scale * world.tasks[task].goal, 0.0);
  return s;
}

FieldPlannerOptions potential(double repulsion) {
  FieldPlannerOptions o;
  o.potential.repulsion = repulsion;
  o.potential.repels_walls = false;
  return o;
}
FieldPlannerOptions navigation(double kappa) {
  FieldPlannerOptions o;
  o.method = FieldMethod::navigation;
  o.kappa = kappa;
  return o;
}

struct Driven {
  double length = 0.0, clearance = 0.0;
};
/// Planned and proven.
std::optional<Driven> driven(Scenario s, const FieldPlannerOptions& options, std::string* why = nullptr, std::optional<Pose>* where = nullptr) {
  const Problem problem = Problem::prepare(std::move(s)).value();
  Budget budget;
  const PlanningResult result = FieldPlanner{"field", options}.plan(problem, budget);
  if (!result) {
    if (why != nullptr) *why = result.error().failure.reason;
    if (where != nullptr) *where = result.error().failure.pose;
    return std::nullopt;
  }
  const Proof proof = prove(problem, result->path);
  EXPECT_TRUE(proof.holds()) << (proof.violations.empty() ? "" : proof.violations.front().sentence);
  return Driven{length(result->path), proof.certificate.clearance};
}

void expect_trap(Scenario s, const FieldPlannerOptions& options, Vec2 at, double off) {
  std::string why;
  std::optional<Pose> where;
  EXPECT_FALSE(driven(std::move(s), options, &why, &where));
  EXPECT_NE(why.find("local minimum"), std::string::npos) << why;
  ASSERT_TRUE(where);
  EXPECT_LT(distance(where->position(), at), off) << where->x << ", " << where->y;
}

// The way to the goal's very middle is counted here; the reconstruction stops 0.05 m before it.
TEST(PotentialFieldPlanner, DrivesTheReconstructionsWays) {
  const auto one = driven(scenario("APF-1", 0), potential(0.1));
  ASSERT_TRUE(one);
  EXPECT_NEAR(one->length, 12.72 + 0.05, 0.03);
  EXPECT_NEAR(one->clearance, 0.377, 0.003);
  const auto over = driven(scenario("APF-2", 1), potential(0.1)), under = driven(scenario("APF-2", 2), potential(0.1));
  ASSERT_TRUE(over && under);
  EXPECT_NEAR(over->length, 7.57 + 0.05, 0.03);
  EXPECT_NEAR(over->clearance, 0.486, 0.003);
  EXPECT_NEAR(under->length, 7.97 + 0.05, 0.03);
  EXPECT_NEAR(under->clearance, 0.502, 0.003);
  EXPECT_TRUE(driven(scenario("NF-TWO", 0), potential(0.02)));  // whether it is a trap hangs on the weights
}

TEST(PotentialFieldPlanner, TellsTrapsAsTraps) {
  expect_trap(scenario("APF-1", 0), potential(0.05), {7.60, 6.56}, 0.03);
  expect_trap(scenario("APF-2", 0), potential(0.1), {4.62, 5.00}, 0.02);
  expect_trap(scenario("NF-TWO", 0), potential(0.1), {-0.609, 0.0}, 0.02);
  expect_trap(scenario("NF-TWO", 1), potential(0.1), {-0.609, 0.0}, 0.03);
}

TEST(NavigationFunctionPlanner, DrivesTheReconstructionsWays) {
  struct Case {
    const char* world;
    std::size_t task;
    double kappa, length, clearance;
  };
  for (const Case& c : {Case{"NF-TWO", 0, 8, 5.98, 0.200}, Case{"NF-TWO", 1, 8, 6.02, 0.200}, Case{"NF-S3", 0, 8, 8.68, 0.219}, Case{"NF-S3", 0, 10, 8.64, 0.176}, Case{"NF-S3", 1, 4, 4.66, 0.668}}) {
    const auto found = driven(scenario(c.world, c.task), navigation(c.kappa));
    ASSERT_TRUE(found) << c.world << c.kappa;
    EXPECT_NEAR(found->length, c.length + 0.02, 0.02) << c.world << c.kappa;
    EXPECT_NEAR(found->clearance, c.clearance, 0.004) << c.world << c.kappa;
  }
}

TEST(NavigationFunctionPlanner, PassesTheTrapOfThePotentialField) {
  EXPECT_FALSE(driven(scenario("NF-TWO", 0), potential(0.1)));
  EXPECT_TRUE(driven(scenario("NF-TWO", 0), navigation(0.0)));
}

// A start on the axis runs into the saddle between the discs: whoever stands there leaves it sideways.
TEST(NavigationFunctionPlanner, LeavesASaddleThatItRanInto) {
  for (const double kappa : {3.0, 4.0}) EXPECT_TRUE(driven(scenario("NF-TWO", 0), navigation(kappa))) << kappa;
}

TEST(NavigationFunctionPlanner, AnotherMinimumThanTheGoalIsTold) {
  std::string why;
  std::optional<Pose> where;
  EXPECT_FALSE(driven(scenario("NF-TWO", 0), navigation(5.0), &why, &where));
  EXPECT_NE(why.find("local minimum"), std::string::npos) << why;
  ASSERT_TRUE(where);
  EXPECT_LT(distance(where->position(), {-1.475, 0.0}), 0.02);
}

TEST(NavigationFunctionPlanner, SaysWhatDoesNotFitIntoDiscs) {
  std::string why;
  EXPECT_FALSE(driven(scenario("APF-2", 0), navigation(0.0), &why));
  EXPECT_NE(why.find("meet"), std::string::npos) << why;
}

FieldPlannerOptions star(double kappa, double lambda) {
  FieldPlannerOptions o;
  o.method = FieldMethod::star;
  o.kappa = kappa;
  o.lambda = lambda;
  return o;
}

TEST(StarNavigationPlanner, DrivesTheReconstructionsWays) {
  const auto behind = driven(scenario("NF-ST", 0), star(8.0, 1e6)), between = driven(scenario("NF-ST", 1), star(8.0, 1e6));
  ASSERT_TRUE(behind && between);
  EXPECT_NEAR(behind->length, 8.52 + 0.02, 0.02);
  EXPECT_NEAR(between->length, 4.64 + 0.02, 0.02);
}

TEST(StarNavigationPlanner, FindsItsOwnMapAndFunction) {
  for (const std::size_t task : {0u, 1u}) EXPECT_TRUE(driven(scenario("NF-ST", task), star(0.0, 0.0))) << task;
}

// A hall with corners and polygons in it: the boundary is a star, too.
TEST(StarNavigationPlanner, ReachesTheGoalAmongPolygonsInAHall) { EXPECT_TRUE(driven(scenario("APF-1", 0), star(0.0, 0.0))); }

TEST(StarNavigationPlanner, SaysWhatIsNoStar) {
  Scenario s = scenario("APF-1", 0);
  s.map.obstacles = {{{4, 4}, {8, 4}, {8, 7}, {7, 7}, {7, 5}, {5, 5}, {5, 7}, {4, 7}}};
  std::string why;
  EXPECT_FALSE(driven(s, star(0.0, 0.0), &why));
  EXPECT_NE(why.find("obstacle 0 is not star-shaped"), std::string::npos) << why;
  EXPECT_FALSE(driven(scenario("APF-2", 0), star(0.0, 0.0), &why));
  EXPECT_NE(why.find("no separate stars"), std::string::npos) << why;
}

// Arcs are as wide as the vehicle can drive; where there is no room for such a one it stands at the corner.
TEST(FieldPlanners, KeepALimitOfCurvature) {
  Scenario s = scenario("NF-S3", 0);
  s.vehicle.drive = Differential{0.4};
  s.vehicle.limits.curvature = 1.6;
  EXPECT_TRUE(driven(s, navigation(8.0)));
  EXPECT_TRUE(driven(s, potential(0.1)));
}

// Steps of any size: who gets on steadily is not trapped.
TEST(PotentialFieldPlanner, ShortStepsAreNoTrap) {
  FieldPlannerOptions slow = potential(0.1);
  slow.descent.speed = 0.02;
  slow.descent.period = 0.05;
  Scenario s = scenario("APF-2", 1);
  EXPECT_TRUE(driven(s, slow));
}

/// The share of a grid of starts in the free space that is led to the goal.
double converging(const std::string& name, std::size_t task, const FieldPlannerOptions& options, int side, double reach) {
  const Scenario base = scenario(name, task);
  int asked = 0, led = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      Scenario s = base;
      s.start = {reach * (2.0 * (i + 0.5) / side - 1.0), reach * (2.0 * (j + 0.5) / side - 1.0), 0.0};
      const Problem problem = Problem::prepare(std::move(s)).value();
      if (!PlaneSpace{problem}.is_free(problem.start().position())) continue;
      ++asked;
      Budget budget;
      led += FieldPlanner{"field", options}.plan(problem, budget) ? 1 : 0;
    }
  }
  return static_cast<double>(led) / asked;
}

TEST(NavigationFunctionPlanner, LeadsEveryStartToTheGoal) {
  EXPECT_EQ(converging("NF-S3", 0, navigation(8.0), 6, 4.9), 1.0);
  EXPECT_EQ(converging("NF-TWO", 0, navigation(8.0), 6, 4.9), 1.0);
  EXPECT_LT(converging("NF-TWO", 0, potential(0.1), 6, 4.9), 1.0);  // the potential field does not
}

// The place of a region that is nearest may lie in an obstacle's disc, where others do not.
TEST(FieldPlanners, GoToAnyPlaceOfARegionThatIsFreeInTheirWorld) {
  Scenario s = scenario("NF-TWO", 0);
  s.map.boundaries = {rectangle({-5, -5}, {5, 5})};
  s.map.obstacles = {rectangle({0, 0}, {1, 1})};
  s.start = {-3, 0.5, 0};
  s.mission = FreeGoal{rectangle({-0.1, 0.45}, {-0.05, 3.0})};  // by the square, whose disc holds its lower end
  for (const FieldPlannerOptions& options : {navigation(8.0), navigation(0.0), star(8.0, 0.0), potential(0.1)}) {
    std::string why;
    EXPECT_TRUE(driven(s, options, &why)) << why;
  }
  s.mission = FreeGoal{rectangle({-0.1, 0.45}, {-0.05, 0.55})};
  std::string why;
  EXPECT_FALSE(driven(s, navigation(8.0), &why));
  EXPECT_NE(why.find("the nearest place of the goal's region, like all others of it, lies in the disc of 0.708 m around obstacle 0"), std::string::npos) << why;
  EXPECT_TRUE(driven(s, star(8.0, 0.0), &why)) << why;
}

// However many steps, the memory that they take is bounded, and what is kept leads from the start to the end in order.
TEST(Descent, OfManyStepsKeepsABoundedNumberOfPoints) {
  DescentOptions options;
  options.speed = 1e-6;
  options.period = 1.0;
  options.may_creep = true;
  Budget budget;
  const std::int64_t steps = 3 * static_cast<std::int64_t>(most_descent_points);
  const Descent descent = descend([](Vec2 q) { return FieldStep{{1.0, 0.0}, 10.0 - q.x}; }, {0, 0}, {10, 0}, options, steps, budget);
  EXPECT_EQ(descent.ended, DescentEnd::steps);
  EXPECT_EQ(descent.steps, steps);
  EXPECT_LE(descent.points.size(), most_descent_points);
  EXPECT_GT(descent.points.size(), most_descent_points / 2);
  EXPECT_EQ(descent.points.front(), (Vec2{0, 0}));
  EXPECT_EQ(descent.points.back(), descent.last);
  EXPECT_NEAR(descent.last.x, 1e-6 * static_cast<double>(steps), 1e-9);
  EXPECT_TRUE(std::is_sorted(descent.points.begin(), descent.points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; }));
}

// Worlds ten times as large, with a base of 0.58 × 0.38 m that keeps its heading or turns while it drives.
TEST(FieldPlanners, DriveAMecanumBaseThroughScaledWorlds) {
  for (const double end : {0.0, 2.0}) {
    Scenario s = scenario("NF-S3", 0, 10.0);
    s.vehicle.footprint = {rectangle({-0.29, -0.19}, {0.29, 0.19}), 0.0};
    std::get<Pose>(s.mission).heading = end;
    const auto found = driven(std::move(s), navigation(8.0));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->length, 86.9, 1.5);
  }
}

}  // namespace
}  // namespace waywright
