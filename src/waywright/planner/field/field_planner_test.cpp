// The worlds of the publication with the results of its reconstruction, for a point; and with a mecanum base.
#include "waywright/planner/field/field_planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

#include "waywright/judge/judge.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/planner/field/sphere_world_of.hpp"
#include "waywright/planner/field/star_world_of.hpp"
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

// The U of the trap, of three rectangles that touch, is a tree of stars; so are an L, a T, an S and a comb, a hall with wings, and obstacles that are too near to each other or to a wall.
TEST(StarNavigationPlanner, PassesTreesOfStars) {
  const auto trap = driven(scenario("APF-2", 0), star(0.0, 0.0));
  ASSERT_TRUE(trap);
  EXPECT_LT(trap->length, 14.0);
  struct Case {
    const char* name;
    Ring boundary;
    std::vector<Ring> obstacles;
    Vec2 start, goal;
  };
  const Ring hall = rectangle({0, 0}, {10, 10});
  std::vector<Case> cases{
      {"U as one", hall, {{{3, 3}, {5.4, 3}, {5.4, 7}, {3, 7}, {3, 6.6}, {5, 6.6}, {5, 3.4}, {3, 3.4}}}, {4.2, 5}, {8.5, 5}},
      {"into a U", hall, {{{3, 3}, {5.4, 3}, {5.4, 7}, {3, 7}, {3, 6.6}, {5, 6.6}, {5, 3.4}, {3, 3.4}}}, {8.5, 5}, {4.2, 5}},
      {"S", hall, {{{3, 3}, {7, 3}, {7, 5.3}, {3.5, 5.3}, {3.5, 7}, {7, 7}, {7, 7.5}, {3, 7.5}, {3, 4.8}, {6.5, 4.8}, {6.5, 3.5}, {3, 3.5}}}, {4, 4.2}, {6, 6.2}},
      {"comb", hall, {{{2, 2}, {8, 2}, {8, 6}, {7.6, 6}, {7.6, 2.4}, {6, 2.4}, {6, 6}, {5.6, 6}, {5.6, 2.4}, {4, 2.4}, {4, 6}, {3.6, 6}, {3.6, 2.4}, {2.4, 2.4}, {2.4, 6}, {2, 6}}}, {3, 3.2}, {6.8, 3.2}},
      {"near to each other", hall, {rectangle({4, 2}, {4.5, 4.8}), rectangle({4, 5}, {4.5, 8}), rectangle({2, 8.1}, {4.3, 8.4})}, {3, 5}, {8, 5}},
      {"near to the wall", hall, {rectangle({4, 0.1}, {4.5, 7}), rectangle({7, 3}, {7.5, 9.9})}, {2, 2}, {9, 8}},
      {"hall of two wings", {{0, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 3}, {3, 3}, {3, 10}, {0, 10}}, {rectangle({4.8, 1.3}, {5.2, 1.7})}, {1.5, 9}, {8.5, 9}},
  };
  for (const Case& c : cases) {
    for (const double radius : {0.0, 0.3}) {
      Scenario s = scenario("APF-1", 0);
      s.map.boundaries = {c.boundary};
      s.map.obstacles = c.obstacles;
      s.vehicle.footprint.disc = radius;
      s.start = make_pose(c.start, 0.0);
      s.mission = make_pose(c.goal, 0.0);
      std::string why;
      const auto found = driven(s, star(0.0, 0.0), &why);
      if (radius == 0.0 && std::string{c.name}.starts_with("near")) continue;  // there is room between for a point
      EXPECT_TRUE(found) << c.name << " " << radius << ": " << why;
      if (found) std::printf("%s, radius %g: %.2f m, %.3f m clear\n", c.name, radius, found->length, found->clearance);
    }
  }
}

TEST(StarNavigationPlanner, SaysWhereStartAndGoalAreApart) {
  Scenario s = scenario("APF-1", 0);
  s.map.obstacles = {rectangle({4, 0.1}, {4.5, 4.9}), rectangle({4, 5.1}, {4.5, 9.9})};
  s.vehicle.footprint.disc = 0.3;
  std::string why;
  EXPECT_FALSE(driven(s, star(0.0, 0.0), &why));
  EXPECT_NE(why.find("in areas that are apart"), std::string::npos) << why;
  // What encloses neither is filled.
  s.map.obstacles = {rectangle({4, 3}, {4.5, 7}), rectangle({4, 3}, {7, 3.4}), rectangle({6.6, 3}, {7, 7}), rectangle({4, 6.6}, {7, 7})};
  EXPECT_TRUE(driven(s, star(0.0, 0.0)));
  s.start = make_pose(Vec2{5.5, 5}, 0.0);
  EXPECT_FALSE(driven(s, star(0.0, 0.0), &why));
  EXPECT_NE(why.find("in areas that are apart"), std::string::npos) << why;
}

// A goal nearer to an obstacle than its repulsion reaches: as published it cannot be reached, since the goal is no rest. 0.25 m before a wall, on the line across it, the force is
// (ρ − 0.25) − 0.1·(1/ρ − 1/0.8)/ρ² at ρ from the wall, and is nought at ρ = 0.5138.
TEST(PotentialFieldPlanner, ReachesAGoalBesideAnObstacleWhereRepulsionIsWeighed) {
  Scenario s = scenario("APF-1", 0);
  s.map.obstacles = {rectangle({6, 2}, {7, 8})};
  s.start = make_pose(Vec2{1, 5}, 0.0);
  s.mission = make_pose(Vec2{5.75, 5}, 0.0);
  double low = 0.25, high = 0.8;
  for (int k = 0; k < 60; ++k) {
    const double rho = 0.5 * (low + high);
    (rho - 0.25 - 0.1 * (1.0 / rho - 1.25) / (rho * rho) > 0.0 ? high : low) = rho;
  }
  EXPECT_NEAR(low, 0.5138, 0.0001);
  expect_trap(s, potential(0.1), {6.0 - low, 5.0}, 0.002);
  FieldPlannerOptions weighed = potential(0.1);
  weighed.potential.reaches_goal = true;
  const auto found = driven(s, weighed);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->length, 4.75, 0.01);
  EXPECT_NEAR(found->clearance, 0.25, 0.001);
  // In the reconstruction's world of polygons, with the goal 0.36 m beside one of them.
  s = scenario("APF-1", 0);
  s.mission = make_pose(Vec2{1.8, 1.95}, 0.0);
  std::string why;
  EXPECT_FALSE(driven(s, potential(0.1), &why));
  EXPECT_NE(why.find("trapped"), std::string::npos) << why;
  const auto beside = driven(s, weighed, &why);
  ASSERT_TRUE(beside) << why;
  std::printf("beside a polygon: %.2f m, %.3f m clear\n", beside->length, beside->clearance);
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

/// A polygon whose edges are drawn in by a distance: grown by it again it is as it was, but for its corners, which are round.
Ring drawn_in(const Ring& ring, double by) {
  Ring smaller;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = ring[i], in = p - ring[(i + ring.size() - 1) % ring.size()], out = ring[(i + 1) % ring.size()] - p;
    const Vec2 u = (1.0 / norm(in)) * left_of(in), v = (1.0 / norm(out)) * left_of(out);
    smaller.push_back(p + (by / (1.0 + dot(u, v))) * (u + v));
  }
  return smaller;
}

/// The world, twenty times as large, for a mecanum base of 0.58 × 0.38 m: drawn in by the disc around it, so that the places where its middle can be are those of a point in the
/// world itself, twenty times as large.
constexpr double times = 20.0;
Scenario with_base(const std::string& name, std::size_t task) {
  Scenario s = scenario(name, task, times);
  s.vehicle.footprint = {rectangle({-0.29, -0.19}, {0.29, 0.19}), 0.0};
  const double disc = norm(Vec2{0.29, 0.19});
  for (Ring& ring : s.map.obstacles) ring = drawn_in(ring, disc);
  for (Ring& ring : s.map.boundaries) ring = drawn_in(ring, -disc);
  return s;
}

struct Way {
  double length = 0.0, room = 0.0;
};
/// Planned and proven; the room is that of the disc's middle beyond what the disc needs.
std::optional<Way> way_of(Scenario s, const FieldPlannerOptions& options) {
  const Problem problem = Problem::prepare(std::move(s)).value();
  Budget budget;
  const PlanningResult result = FieldPlanner{"field", options}.plan(problem, budget);
  if (!result) return std::nullopt;
  EXPECT_TRUE(prove(problem, result->path).holds());
  const PlaneSpace space{problem};
  Way way{length(result->path), 1e300};
  const double step = length(result->path) / 4000;
  for (const Sample& at : sample(result->path, 0.0, 1.0, step)) way.room = std::min(way.room, distance_to_polygons(space, at.pose().position()));
  return way;
}

// Lengths in the field scale with the world, forces with the fourth power of it.
TEST(FieldPlanners, DriveAMecanumBaseThroughTheWorldsAsAPointThroughSmallerOnes) {
  FieldPlannerOptions large = potential(0.1 * times * times * times * times);
  large.potential.conic_from *= times;
  large.potential.reach *= times;
  large.descent.speed *= times;
  large.descent.goal_tolerance *= times;
  struct Case {
    const char* world;
    std::size_t task;
    FieldPlannerOptions point, base;
  };
  for (const Case& c : {Case{"NF-TWO", 0, navigation(8.0), navigation(8.0)}, Case{"NF-S3", 0, navigation(8.0), navigation(8.0)}, Case{"NF-S3", 1, navigation(4.0), navigation(4.0)},
                        Case{"NF-ST", 0, star(8.0, 1e6), star(8.0, 1e6)}, Case{"NF-ST", 1, star(8.0, 1e6), star(8.0, 1e6)}, Case{"APF-1", 0, potential(0.1), large},
                        Case{"APF-2", 1, potential(0.1), large}, Case{"APF-2", 2, potential(0.1), large}}) {
    // Of a point in the same large world, too: what ways are thinned by is 2 mm in each.
    const auto small = way_of(scenario(c.world, c.task), c.point), point = way_of(scenario(c.world, c.task, times), c.base), base = way_of(with_base(c.world, c.task), c.base);
    ASSERT_TRUE(small && point && base) << c.world << " " << c.task;
    std::printf("%s %zu: %.3f, %.3f and %.3f m, %.4f, %.4f and %.4f m clear\n", c.world, c.task, small->length, point->length, base->length, small->room, point->room, base->room);
    EXPECT_NEAR(base->length, times * small->length, 0.01 * times * small->length) << c.world << " " << c.task;
    EXPECT_NEAR(base->length, point->length, 0.01 * point->length) << c.world << " " << c.task;
    EXPECT_NEAR(base->room, point->room, 0.01 * point->room) << c.world << " " << c.task;
    EXPECT_NEAR(base->room, times * small->room, 0.01 * times * small->room + 0.0025 * times) << c.world << " " << c.task;
  }
  expect_trap(with_base("APF-2", 0), large, times * Vec2{4.62, 5.00}, 0.02 * times);
}

TEST(FieldPlanners, CriticalPointsForAMecanumBaseAreThoseOfAPoint) {
  const auto covering = [](Scenario s) {
    const Problem problem = Problem::prepare(std::move(s)).value();
    return covering_world(PlaneSpace{problem}, problem.start().position(), problem.goal().position()).value().world;
  };
  for (const auto& [name, task, kappas] : {std::tuple{"NF-S3", std::size_t{0}, std::vector<double>{2, 3, 4, 5, 6, 7, 8, 10}}, std::tuple{"NF-S3", std::size_t{1}, std::vector<double>{2, 3, 6, 10}},
                                           std::tuple{"NF-TWO", std::size_t{0}, std::vector<double>{3, 4, 5, 6, 8, 12}}}) {
    const Scenario small = scenario(name, task), large = with_base(name, task);
    const SphereWorld point = covering(small), base = covering(large);
    const Vec2 goal = std::get<Pose>(small.mission).position();
    for (const double kappa : kappas) {
      const auto points = critical_points({point, goal, kappa}), bases = critical_points({base, times * goal, kappa});
      ASSERT_EQ(points.size(), bases.size()) << name << kappa;
      for (const CriticalPoint& c : points) {
        EXPECT_TRUE(std::any_of(bases.begin(), bases.end(), [&](const CriticalPoint& b) { return b.is_minimum == c.is_minimum && distance(b.at, times * c.at) < 0.01 * times; })) << name << kappa;
      }
    }
  }
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
