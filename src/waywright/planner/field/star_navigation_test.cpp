// `star_navigation` among random L, T, Z, plus and star shapes; its budget, and that of the other planners of this folder; what it says where it does not come to the goal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "waywright/core/random.hpp"
#include "waywright/geometry/obstacle_index.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/planner/field/field_planner.hpp"
#include "waywright/planner/field/global_local.hpp"
#include "waywright/planner/field/harmonic_planner.hpp"
#include "waywright/planner/field/navigation_descent.hpp"
#include "waywright/planner/field/sphere_world_of.hpp"
#include "waywright/planner/field/star_world_of.hpp"
#include "waywright/planner/field/straightened_way.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/visibility_planner.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Ring l_shape(double wide, double high, double arm) { return {{0, 0}, {wide, 0}, {wide, arm}, {arm, arm}, {arm, high}, {0, high}}; }
Ring t_shape(double wide, double high, double arm) {
  return {{-arm / 2, 0}, {arm / 2, 0}, {arm / 2, high - arm}, {wide / 2, high - arm}, {wide / 2, high}, {-wide / 2, high}, {-wide / 2, high - arm}, {-arm / 2, high - arm}};
}
Ring z_shape(double wide, double high, double arm) {
  return {{0, 0}, {wide, 0}, {wide, high - arm}, {2 * wide - arm, high - arm}, {2 * wide - arm, high}, {wide - arm, high}, {wide - arm, arm}, {0, arm}};
}
Ring plus_shape(double wide, double high, double arm) {
  const double a = wide / 2, b = high / 2, w = arm / 2;
  return {{-w, -b}, {w, -b}, {w, -w}, {a, -w}, {a, w}, {w, w}, {w, b}, {-w, b}, {-w, w}, {-a, w}, {-a, -w}, {-w, -w}};
}
Ring star_shape(double wide, double inner, int spikes) {
  Ring ring;
  for (int i = 0; i < 2 * spikes; ++i) ring.push_back(0.5 * (i % 2 == 0 ? wide : inner) * unit(i * pi / spikes));
  return ring;
}
Ring turned_about_its_middle(const Ring& ring, Vec2 to, double angle) {
  const Box box = bounding_box(ring);
  Ring moved;
  for (const Vec2 p : ring) {
    const Vec2 q = p - 0.5 * (box.low + box.high);
    moved.push_back(to + q.x * unit(angle) + q.y * left_of(unit(angle)));
  }
  return moved;
}

struct Named {
  std::string name;
  Ring ring;
};
Named any_shape(Random& random) {
  const double wide = random.uniform(1.5, 6.0), high = random.uniform(1.5, 6.0), arm = random.uniform(0.1, 0.35) * std::min(wide, high);
  switch (random.integer(0, 4)) {
    case 0: return {"L", l_shape(wide, high, arm)};
    case 1: return {"T", t_shape(wide, high, arm)};
    case 2: return {"Z", z_shape(0.6 * wide, high, std::min(arm, 0.3 * wide))};
    case 3: return {"plus", plus_shape(wide, high, arm)};
    default: return {"star", star_shape(wide, std::max(0.2 * wide, arm), static_cast<int>(random.integer(3, 8)))};
  }
}

Scenario hall_with(std::vector<Ring> obstacles, double disc, Vec2 start, Vec2 goal) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {14, 10})};
  s.map.obstacles = std::move(obstacles);
  s.vehicle.footprint.disc = disc;
  s.vehicle.drive = Mecanum{0.05, 0.24, 0.15};
  s.start = make_pose(start, 0.0);
  s.mission = make_pose(goal, 0.0);
  return s;
}

/// Is there a way that keeps 2 cm more than is required?
bool is_passable(Scenario s) {
  s.clearance += 0.02;
  const auto problem = Problem::prepare(std::move(s));
  if (!problem) return false;
  const PlaneSpace space{*problem};
  if (!space.is_free(problem->start().position()) || !space.is_free(problem->goal().position())) return false;
  Budget budget;
  return VisibilityPlanner{}.plan(*problem, budget).has_value();
}

FieldPlannerOptions star_options(double kappa = 0.0, double lambda = 0.0) {
  FieldPlannerOptions o;
  o.method = FieldMethod::star;
  o.kappa = kappa;
  o.lambda = lambda;
  return o;
}

struct Answer {
  std::string reason;  ///< empty: it is at the goal, and that is proven
  double length = 0.0;
  std::vector<std::string> text;
};
Answer answer_of(const Scenario& s, const FieldPlannerOptions& options) {
  const Problem problem = Problem::prepare(s).value();
  Budget budget{s.budget};
  const PlanningResult result = FieldPlanner{"star_navigation", options}.plan(problem, budget);
  if (!result) return {result.error().failure.reason, 0.0, result.error().explanation};
  const Proof proof = prove(problem, result->path);
  return {proof.holds() ? "" : "not proven: " + proof.violations.front().sentence, length(result->path), result->explanation};
}

bool says(const std::vector<std::string>& text, const std::string& what) {
  return std::any_of(text.begin(), text.end(), [&](const std::string& s) { return s.find(what) != std::string::npos; });
}

/// Worlds of one to `most` shapes anywhere, which may overlap each other and the walls; starts and goals anywhere that is free, 3 m apart.
void expect_all_to_the_goal(std::uint64_t first, int worlds, std::int64_t most) {
  struct Count {
    int asked = 0, led = 0;
  };
  std::map<std::string, Count> counts;
  Count all;
  for (std::uint64_t seed = first; all.asked < worlds; ++seed) {
    Random random{seed};
    std::vector<Ring> rings;
    std::string names;
    for (std::int64_t n = random.integer(1, most); n > 0; --n) {
      const Named shape = any_shape(random);
      const double angle = random.uniform(0, 1) < 0.4 ? 0.5 * pi * static_cast<double>(random.integer(0, 3)) : random.uniform(-pi, pi);
      rings.push_back(turned_about_its_middle(shape.ring, {random.uniform(2.5, 11.5), random.uniform(2.5, 7.5)}, angle));
      names = names.empty() ? shape.name : "several";
    }
    const double disc = random.uniform(0, 1) < 0.3 ? 0.0 : random.uniform(0.1, 0.4);
    std::optional<Scenario> s;
    for (int k = 0; k < 50 && !s; ++k) {
      const Vec2 start{random.uniform(0.2, 13.8), random.uniform(0.2, 9.8)}, goal{random.uniform(0.2, 13.8), random.uniform(0.2, 9.8)};
      if (distance(start, goal) < 3.0) continue;
      s = hall_with(rings, disc, start, goal);
      if (!is_passable(*s)) s.reset();
    }
    if (!s) continue;
    const Answer answer = answer_of(*s, star_options());
    EXPECT_EQ(answer.reason, "") << "seed " << seed << ", " << names;
    for (Count* c : {&all, &counts[names]}) {
      ++c->asked;
      c->led += answer.reason.empty() ? 1 : 0;
    }
  }
  for (const auto& [name, count] : counts) std::printf("%s: %d of %d\n", name.c_str(), count.led, count.asked);
  std::printf("all: %d of %d\n", all.led, all.asked);
}

TEST(StarNavigation, ComesToTheGoalAmongShapesOfAnyKind) { expect_all_to_the_goal(1, 12, 3); }
TEST(StarNavigationFull, ComesToTheGoalAmongOneOfFiveHundredShapes) { expect_all_to_the_goal(10'000, 500, 1); }
TEST(StarNavigationFull, ComesToTheGoalAmongUpToFiveShapesInFiveHundredWorlds) { expect_all_to_the_goal(20'000, 500, 5); }

// One L or T between start and goal: the published map stretches an arm's sides so much that steps down the gradient go to and fro beside it.
TEST(StarNavigation, PassesOneLOrTFromBehind) {
  const Vec2 left{1.5, 5.0}, right{12.5, 5.2};
  for (const Ring& ring : {l_shape(4, 6, 1), l_shape(5, 5, 0.4), t_shape(5, 5, 0.5)}) {
    for (const double angle : {0.0, 0.9, pi}) {
      const Scenario s = hall_with({turned_about_its_middle(ring, {7, 5}, angle)}, 0.3, angle == 0.9 ? left : right, angle == 0.9 ? right : left);
      const Answer found = answer_of(s, star_options());
      EXPECT_EQ(found.reason, "") << angle;
    }
  }
}

// Where λ is told it is the published map's turn first.
TEST(StarNavigation, GoesOverToTreesWhereThePublishedMapStallsAndSaysSo) {
  const Scenario s = hall_with({{{5, 2}, {9, 2}, {9, 3}, {6, 3}, {6, 8}, {5, 8}}}, 0.3, {12, 8}, {2, 3});
  const Answer found = answer_of(s, star_options(0.0, 100.0));
  EXPECT_EQ(found.reason, "");
  EXPECT_TRUE(says(found.text, "does not lead to the goal: it stalls at (6.3"));
  EXPECT_TRUE(says(found.text, "m from the rim of obstacle 0"));
  EXPECT_TRUE(says(found.text, "seen as trees of stars"));
  EXPECT_FALSE(says(found.text, "local minimum"));
}

TEST(StarNavigation, TakesTreesWhereThePublishedMapLeadsByADetourAndSaysSo) {
  const Scenario s = hall_with({rectangle({3, 4.8}, {9, 5.2}), rectangle({1, 1}, {2, 2})}, 0.2, {6.4, 2.5}, {6.4, 7.5});
  const Answer found = answer_of(s, star_options());
  EXPECT_EQ(found.reason, "");
  EXPECT_TRUE(says(found.text, "Down the published map from stars to discs the way is "));
  EXPECT_TRUE(says(found.text, "As trees of stars"));
  // Around its nearer end the shortest way is 7.7 m long.
  EXPECT_LT(found.length, 9.0);
  const Answer told = answer_of(s, star_options(0.0, 10.0));  // whoever tells λ gets the published map
  EXPECT_EQ(told.reason, "");
  EXPECT_FALSE(says(told.text, "trees"));
  EXPECT_GT(told.length, 2.0 * found.length);
}

// Where stars are convex the published map alone is looked at, but for detours.
TEST(StarNavigation, KeepsToThePublishedMapAmongConvexStars) {
  const Answer found = answer_of(hall_with({rectangle({5, 3}, {6.5, 5}), rectangle({8, 5}, {9.5, 7})}, 0.3, {2, 4}, {12, 6}), star_options());
  EXPECT_EQ(found.reason, "");
  EXPECT_TRUE(says(found.text, "is the least power of ten with which the map"));
  EXPECT_FALSE(says(found.text, "trees"));
}

TEST(MinimumNear, IsFoundByGradientAndHessianAlone) {
  // The publication's world of two discs, where κ = 5 leaves a minimum before them.
  Scenario s;
  s.map = field_world("NF-TWO").value().map;
  s.vehicle.footprint.disc = 0.0;
  s.vehicle.drive = Mecanum{0.05, 0.24, 0.15};
  const PublishedTask task = field_world("NF-TWO").value().tasks[0];
  s.start = make_pose(task.start, 0.0);
  s.mission = make_pose(task.goal, 0.0);
  const Problem problem = Problem::prepare(std::move(s)).value();
  const auto covering = covering_world(PlaneSpace{problem}, task.start, task.goal).value();
  const NavigationFunction function{covering.world, task.goal, 5.0};
  const auto near = [&](Vec2 q, double within) {
    return minimum_near([&](Vec2 p) { return function.slope(p); }, [&](Vec2 p) { return function.curvature(p); }, [&](Vec2 p) { return function.distance_to_rim(p); }, q, within);
  };
  int minima = 0;
  for (const CriticalPoint& c : critical_points(function)) {
    const auto found = near(c.at + Vec2{0.002, 0.001}, 0.05);
    EXPECT_EQ(found.has_value(), c.is_minimum);
    if (found) {
      EXPECT_LT(distance(*found, c.at), 1e-6);
    }
    minima += c.is_minimum ? 1 : 0;
    EXPECT_FALSE(near(c.at + Vec2{0.3, 0.0}, 0.05));
  }
  EXPECT_GT(minima, 0);
}

TEST(TreeMap, ALineIsFreeWhereItMeetsNoRim) {
  const Ring outside = rectangle({0, 0}, {10, 10}), l = {{2, 2}, {6, 2}, {6, 2.5}, {2.5, 2.5}, {2.5, 7}, {2, 7}};
  const TreeMap map = TreeMap::of(outside, {l}).value();
  Random random{4};
  int met = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vec2 a{random.uniform(0, 10), random.uniform(0, 10)}, b{random.uniform(0, 10), random.uniform(0, 10)};
    if (!map.is_free(a) || !map.is_free(b)) continue;
    bool is_free = true;
    for (int i = 1; i < 2000; ++i) is_free = is_free && map.is_free(a + (i / 2000.0) * (b - a));
    met += is_free ? 0 : 1;
    if (map.is_free(a, b)) {
      EXPECT_TRUE(is_free);
    } else if (is_free) {  // it cuts a corner between two places that were looked at
      double nearest = 1e300;
      for (const Vec2 p : l) nearest = std::min(nearest, point_segment_distance(p, a, b));
      EXPECT_LT(nearest, 0.01);
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_FALSE(map.is_free({1, 7}, {3, 7}));  // along an edge
  EXPECT_TRUE(map.is_free({1, 7.01}, {3, 7.01}));
}

TEST(StraightenedWay, IsNoLongerAndComesNoNearer) {
  const Problem problem = Problem::prepare(hall_with({{{5, 2}, {9, 2}, {9, 3}, {6, 3}, {6, 8}, {5, 8}}, rectangle({10, 5}, {10.5, 9})}, 0.3, {12, 8}, {2, 3})).value();
  const PlaneSpace space{problem};
  Random random{8};
  int shorter = 0;
  for (int k = 0; k < 200; ++k) {
    std::vector<Vec2> points;
    for (Vec2 first{}; points.empty();) {
      first = {random.uniform(0.5, 13.5), random.uniform(0.5, 9.5)};
      if (space.is_free(first)) points.push_back(first);
    }
    while (points.size() < 40) {
      const Vec2 next = points.back() + random.uniform(0.1, 1.2) * unit(random.uniform(-pi, pi));
      if (space.is_free(next) && space.is_free(points.back(), next)) points.push_back(next);
    }
    const std::vector<Vec2> straight = straightened_way(space, points);
    EXPECT_EQ(straight.front(), points.front());
    EXPECT_EQ(straight.back(), points.back());
    EXPECT_LE(length_of_way(straight), length_of_way(points) + 1e-9);
    shorter += length_of_way(straight) < 0.7 * length_of_way(points) ? 1 : 0;
    // Its corners are the way's, in order, and each line keeps what the run between them kept at its points, or is one of the way's own.
    std::size_t at = 0;
    for (std::size_t i = 1; i < straight.size(); ++i) {
      const auto to = static_cast<std::size_t>(std::find(points.begin() + static_cast<std::ptrdiff_t>(at) + 1, points.end(), straight[i]) - points.begin());
      ASSERT_LT(to, points.size());
      double least = 1e300;
      for (std::size_t j = at; j <= to; ++j) least = std::min(least, distance_to_polygons(space, points[j]));
      for (int j = 0; j <= 200 && to > at + 1; ++j) EXPECT_GE(distance_to_polygons(space, points[at] + (j / 200.0) * (points[to] - points[at])), least - 1e-6);
      at = to;
    }
  }
  EXPECT_GT(shorter, 100);
}

// One limit for all that a run tries: each κ, each map, all that is grown, each place of a region.
TEST(FieldPlanners, KeepOneLimitOfEvaluationsAndSayWhenItIsReached) {
  Scenario s = hall_with({{{5, 2}, {9, 2}, {9, 3}, {6, 3}, {6, 8}, {5, 8}}}, 0.3, {12, 8}, {2, 3});
  FieldPlannerOptions discs, down;
  discs.method = FieldMethod::navigation;
  down.method = FieldMethod::potential;
  Scenario round = hall_with({rectangle({6, 4}, {7, 5})}, 0.3, {12, 5}, {2, 5.2});
  round.map.boundaries = {rectangle({-8, -10}, {22, 20})};
  Scenario region = round;
  region.mission = FreeGoal{rectangle({1.5, 4}, {2.5, 6})};
  struct Case {
    const char* name;
    Scenario scenario;
    AnyPlanner planner;
    bool is_led;  ///< a limit can be too small for it
  };
  const std::vector<Case> cases{{"star", s, FieldPlanner{"star_navigation", star_options()}, true},
                                {"star, published", s, FieldPlanner{"star_navigation", star_options(0.0, 100.0)}, true},
                                {"discs", round, FieldPlanner{"navigation_function", discs}, true},
                                {"potential", round, FieldPlanner{"potential_field", down}, true},
                                {"potential, region", region, FieldPlanner{"potential_field", down}, true},
                                {"harmonic", s, HarmonicPlanner{HarmonicOptions{}}, false},
                                {"global_local", s, GlobalLocalPlanner{GlobalLocalOptions{.global = GlobalWay::star_navigation}}, false}};
  for (const Case& c : cases) {
    for (const std::int64_t limit : {1, 50, 2000, 5000}) {
      Scenario limited = c.scenario;
      limited.budget.evaluations = limit;
      const Problem problem = Problem::prepare(limited).value();
      Budget budget{limited.budget};
      const PlanningResult result = c.planner.plan(problem, budget);
      EXPECT_LE(budget.evaluations(), limit) << c.name;
      if (limit <= 50 && c.is_led) {
        ASSERT_FALSE(result) << c.name;
        EXPECT_EQ(result.error().failure.status, Status::no_path);
        EXPECT_NE(result.error().failure.reason.find(limit == 1 ? "the limit of 1 evaluation was reached" : "the limit of 50 evaluations was reached"), std::string::npos) << c.name << ": " << result.error().failure.reason;
      }
      if (limit == 5000) {
        EXPECT_TRUE(result) << c.name << ": " << (result ? "" : result.error().failure.reason);
      }
    }
  }
}

}  // namespace
}  // namespace waywright
