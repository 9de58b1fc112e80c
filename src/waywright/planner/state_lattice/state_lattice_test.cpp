// The lattice against exhaustive search and the exact outlines.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/planner/state_lattice/lattice_search.hpp"
#include "waywright/planner/state_lattice/smoothing.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Scenario small_hall(Random& random, bool is_tricycle) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {5, 4})};
  for (int i = 0; i < 4; ++i) {
    const Ring box = rectangle({0, 0}, {random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)});
    s.map.obstacles.push_back(transformed(box, Frame{make_pose({random.uniform(0.5, 4.5), random.uniform(0.5, 3.5)}, random.uniform(-1, 1))}));
  }
  s.vehicle.footprint.polygon = {{-0.2, -0.15}, {0.4, -0.15}, {0.4, 0.15}, {-0.2, 0.15}};
  if (is_tricycle) {
    s.vehicle.drive = Tricycle{0.4, 0.9, std::nullopt, SteeredAxle::rear};
  } else {
    s.vehicle.drive = Differential{0.3};
  }
  s.clearance = 0.02;
  World world{s.map};
  world.build();
  const auto pose = [&] {
    for (int tries = 0; tries < 10'000; ++tries) {
      const Pose p{random.uniform(0.4, 4.6), random.uniform(0.4, 3.6), random.uniform(-3, 3)};
      if (world.clearance(s.vehicle.footprint, p, 1.0).clearance > 0.03) return p;
    }
    return Pose{};
  };
  s.start = pose();
  s.mission = pose();
  return s;
}

/// A preferred, a penalty and a directed zone somewhere.
void add_zones(Scenario& s, Random& random) {
  const auto area = [&] { return transformed(rectangle({-0.8, -0.6}, {0.8, 0.6}), Frame{make_pose({random.uniform(0.5, 4.5), random.uniform(0.5, 3.5)}, random.uniform(-1, 1))}); };
  s.zones.push_back({ZoneType::preferred, "", area(), 0.0, random.uniform(0.2, 0.9), 1.0});
  s.zones.push_back({ZoneType::penalty, "", area(), 0.0, random.uniform(1.2, 6.0), 1.0});
  s.zones.push_back({ZoneType::directed, "", area(), random.uniform(-3, 3), 1.0, 1.0});
}

LatticeRest rest_of(const LatticeGraph& graph, const MotionCost& cost) { return LatticeRest{graph, graph.options().costs, cost.least_factor()}; }

LatticeOptions coarse() {
  LatticeOptions options;
  options.cell = 0.25;
  options.min_radius = 0.5;
  return options;
}

/// Least costs from the start by relaxing every motion until nothing changes: no queue, no estimate, no bound.
double exhaustive(const LatticeGraph& graph, MotionCost& cost) {
  struct Step {
    std::size_t from, to;
    double cost;
    int direction;
  };
  // States: cell, heading, direction of arrival (0: the start alone, 1 forwards, 2 backwards).
  const auto state = [](std::uint32_t cell, int heading, int arrival) { return (static_cast<std::size_t>(cell) * lattice_headings + static_cast<std::size_t>(heading)) * 3 + static_cast<std::size_t>(arrival); };
  const std::size_t states = graph.cells() * lattice_headings * 3;
  std::vector<double> best(states, infinity);
  best[state(graph.start_cell(), 0, 0)] = 0.0;
  std::vector<std::vector<std::optional<double>>> of_motion(graph.cells() * lattice_headings);
  bool is_changed = true;
  while (is_changed) {
    is_changed = false;
    for (std::uint32_t cell = 0; cell < graph.cells(); ++cell) {
      for (int h = 0; h < lattice_headings; ++h) {
        if (std::min({best[state(cell, h, 0)], best[state(cell, h, 1)], best[state(cell, h, 2)]}) == infinity) continue;
        const auto& primitives = graph.primitives()[static_cast<std::size_t>(h)];
        auto& motions = of_motion[static_cast<std::size_t>(cell) * lattice_headings + static_cast<std::size_t>(h)];
        if (motions.empty()) {
          for (const MotionPrimitive& p : primitives) motions.push_back(graph.moved(cell, p.step) ? cost.of(p.poses, graph.place(cell), [&] { return cost.is_free(graph.stretch(cell, p)); }) : std::nullopt);
        }
        for (std::size_t i = 0; i < primitives.size(); ++i) {
          if (!motions[i]) continue;
          const int direction = primitives[i].stretch.direction;
          for (int arrival = 0; arrival < 3; ++arrival) {
            const double before = best[state(cell, h, arrival)];
            if (before == infinity) continue;
            const int after = direction == 0 ? arrival : direction > 0 ? 1 : 2;
            const double change = arrival == 0 || direction == 0 || after == arrival ? 0.0 : cost.costs().change;
            double& there = best[state(*graph.moved(cell, primitives[i].step), primitives[i].to, after)];
            if (before + *motions[i] + change < there - 1e-12) {
              there = before + *motions[i] + change;
              is_changed = true;
            }
          }
        }
      }
    }
  }
  double least = infinity;
  for (const GoalMotion& m : graph.goal_motions()) {
    double sum = 0.0;
    for (const LatticeStretch& s : m.stretches) sum += cost.of(s, 0.1).value_or(infinity);
    for (int arrival = 0; arrival < 3; ++arrival) {
      const bool is_change = arrival != 0 && m.direction != 0 && (m.direction > 0 ? 1 : 2) != arrival;
      least = std::min(least, best[state(m.cell, m.heading, arrival)] + sum + (is_change ? cost.costs().change : 0.0));
    }
  }
  return least;
}

TEST(MotionPrimitives, EndWhereTheyShouldWithinTheLimitsInEveryHeading) {
  Random random{5};
  for (int i = 0; i < 12; ++i) {
    Scenario s = small_hall(random, i % 2 == 0);
    if (i % 3 == 0) s.vehicle.limits.curvature_rate = random.uniform(1.0, 4.0);
    const Problem problem = Problem::prepare(s).value();
    const LatticeGraph graph{problem, coarse()};
    ASSERT_TRUE(graph.refused().empty()) << graph.refused();
    for (int h = 0; h < lattice_headings; ++h) {
      const auto& all = graph.primitives()[static_cast<std::size_t>(h)];
      int ahead = 0, back = 0, turning = 0;
      for (const MotionPrimitive& p : all) {
        const Pose begin = start_of(p.stretch), end = end_of(p.stretch);
        EXPECT_NEAR(begin.x, 0.0, 1e-12);
        EXPECT_NEAR(wrap(begin.heading - lattice_heading(h)), 0.0, 1e-12);
        EXPECT_NEAR(end.x, p.step.column * graph.cell(), 1e-10);
        EXPECT_NEAR(end.y, p.step.row * graph.cell(), 1e-10);
        EXPECT_NEAR(wrap(end.heading - lattice_heading(p.to)), 0.0, 1e-10);
        if (p.stretch.direction == 0) continue;
        EXPECT_TRUE(are_within(p.stretch.curves, graph.limits()));
        EXPECT_EQ(p.stretch.curves.front().curvature, 0.0);
        EXPECT_NEAR(end_curvature(p.stretch.curves.back()), 0.0, 1e-9);
        for (std::size_t k = 1; k < p.stretch.curves.size(); ++k) EXPECT_NEAR(end_curvature(p.stretch.curves[k - 1]), p.stretch.curves[k].curvature, 1e-9);
        (p.stretch.direction > 0 ? ahead : back) += 1;
        turning += p.to != h ? 1 : 0;
      }
      EXPECT_EQ(ahead, 11) << h;  // straight, two shifts, four turns to each side
      EXPECT_EQ(back, 11) << h;
      EXPECT_GE(turning, 16) << h;
    }
  }
}

// No way of the lattice is better: relaxing all motions of all states until nothing changes finds the same cost.
TEST(LatticeSearch, FindsTheOptimumOfItsGraph) {
  Random random{11};
  int found = 0;
  for (int i = 0; i < 24; ++i) {
    Scenario hall = small_hall(random, i % 2 == 0);
    if (i % 3 == 0) add_zones(hall, random);
    const Problem problem = Problem::prepare(hall).value();
    LatticeOptions options = coarse();
    options.may_reverse = i % 5 != 0;
    options.costs.weight = i % 4 == 1 ? 0.0 : random.uniform(0.0, 20.0);
    options.costs.range = random.uniform(0.1, 1.0);
    options.bend_share = i % 3 == 1 ? random.uniform(0.0, 100.0) : 0.2;
    const LatticeGraph graph{problem, options};
    ASSERT_TRUE(graph.refused().empty()) << graph.refused();
    MotionCost cost{problem, graph.options().costs, graph.margin()};
    const LatticeRest rest = rest_of(graph, cost);
    const double truth = exhaustive(graph, cost);
    Budget budget;
    const LatticeAnswer answer = search_lattice(graph, rest, cost, 0.0, budget);
    if (truth == infinity) {
      EXPECT_EQ(answer.ended, LatticeAnswer::End::exhausted) << i;
      continue;
    }
    ++found;
    ASSERT_EQ(answer.ended, LatticeAnswer::End::found) << i;
    EXPECT_NEAR(answer.cost, truth, 1e-8 * truth) << i;
    EXPECT_NEAR(answer.lower_bound, truth, 1e-8 * truth) << i;
    EXPECT_LE(rest(graph.start_cell()), truth * (1.0 + 1e-9)) << i;
    // A way within a gap is no dearer than that, and says no more than what is true.
    const double gap = random.uniform(0.05, 1.0);
    Budget other;
    const LatticeAnswer quick = search_lattice(graph, rest, cost, gap, other);
    ASSERT_EQ(quick.ended, LatticeAnswer::End::found);
    EXPECT_LE(quick.cost, truth * (1.0 + gap) * (1.0 + 1e-9));
    EXPECT_GE(quick.cost, truth * (1.0 - 1e-9));
    EXPECT_LE(quick.lower_bound, truth * (1.0 + 1e-9));
    EXPECT_GE(quick.lower_bound * (1.0 + gap), quick.cost * (1.0 - 1e-9));
    // Cut short, it still bounds what there can be.
    BudgetLimits few;
    few.expansions = std::max<std::int64_t>(1, answer.expansions / 2);
    Budget small{few};
    const LatticeAnswer part = search_lattice(graph, rest, cost, 0.0, small);
    if (part.ended == LatticeAnswer::End::out_of_budget) {
      EXPECT_LE(part.lower_bound, truth * (1.0 + 1e-9));
      EXPECT_LE(part.expansions, *few.expansions);
    }
  }
  EXPECT_GE(found, 15);
}

// What the search expects of the rest is never more than a motion and the rest after it.
TEST(LatticeRest, IsConsistentWithEveryMotion) {
  Random random{17};
  for (int i = 0; i < 8; ++i) {
    Scenario hall = small_hall(random, i % 2 == 0);
    if (i % 2 == 1) add_zones(hall, random);
    const Problem problem = Problem::prepare(hall).value();
    LatticeOptions options = coarse();
    options.costs.weight = i % 3 == 0 ? 100.0 : random.uniform(1.0, 20.0);
    options.costs.range = random.uniform(0.1, 0.8);
    options.bend_share = i % 2 == 0 ? random.uniform(0.0, 100.0) : 0.2;
    const LatticeGraph graph{problem, options};
    MotionCost cost{problem, graph.options().costs, graph.margin()};
    const LatticeRest rest = rest_of(graph, cost);
    int looked = 0;
    for (std::uint32_t cell = 0; cell < graph.cells(); ++cell) {
      for (int h = 0; h < lattice_headings; ++h) {
        for (const MotionPrimitive& p : graph.primitives()[static_cast<std::size_t>(h)]) {
          const auto there = graph.moved(cell, p.step);
          if (!there) continue;
          const auto motion = cost.of(p.poses, graph.place(cell), [&] { return cost.is_free(graph.stretch(cell, p)); });
          if (!motion) continue;
          ++looked;
          ASSERT_LE(rest(cell), *motion + rest(*there) + 1e-9);
          ASSERT_LE(p.step == LatticeStep{} ? p.metres : rest.motion_at_least(cell, *there, p), *motion + 1e-9);
          ASSERT_GT(graph.clearance_at_most(*there), graph.margin()) << "a state that the footprint can stand in counts as blocked";
        }
      }
      const auto [begin, end] = graph.goal_motions_of(cell);
      for (std::size_t k = begin; k < end; ++k) ASSERT_LE(rest(cell), cost.least_factor() * graph.goal_motions()[k].metres + 1e-9);
    }
    EXPECT_GT(looked, 1000);
  }
}

// A motion that the cost calls free is free: poses all along it, asked one by one.
TEST(MotionCost, WhatItCallsFreeKeepsTheMarginEverywhere) {
  Random random{23};
  int free = 0, blocked = 0, near = 0;
  for (int i = 0; i < 1600; ++i) {
    const Problem problem = Problem::prepare(small_hall(random, true)).value();
    MotionCost cost{problem, DangerCosts{}, 0.025};
    const Pose from{random.uniform(0.5, 4.5), random.uniform(0.5, 3.5), random.uniform(-3, 3)};
    const Pose to{from.x + random.uniform(-2, 2), from.y + random.uniform(-2, 2), random.uniform(-3, 3)};
    auto curves = fitted_within(from, 0.0, to, 0.0, {5.0, infinity});
    if (curves.empty()) continue;
    const LatticeStretch stretch{i % 2 == 0 ? 1 : -1, std::move(curves), {}};
    const bool is_free = cost.of(stretch, 0.1).has_value();
    std::vector<SteppedPose> poses;
    sample_stretch(stretch, 0.001, 0.005, poses);
    double least = infinity;
    for (const SteppedPose& p : poses) least = std::min(least, problem.world().clearance(problem.footprint(), p.pose, 1.0).clearance);
    if (is_free) {
      ++free;
      ASSERT_GT(least, 0.025 - 1e-9) << i;
      near += least < 0.08 ? 1 : 0;
    } else {
      ++blocked;
      ASSERT_LT(least, 0.025 + 1e-3) << i << ": needlessly cautious";
    }
  }
  EXPECT_GT(free, 40);
  EXPECT_GT(blocked, 40);
  EXPECT_GT(near, 3);
}

TEST(DangerCosts, AwayIsTheIntegralOfTheDensity) {
  Random random{29};
  for (int i = 0; i < 200; ++i) {
    const DangerCosts costs{random.uniform(0, 10), random.uniform(0.1, 2.0)};
    const double beyond = random.uniform(0, 2), length = random.uniform(0, 3);
    double sum = 0.0;
    constexpr int n = 4000;
    for (int k = 0; k < n; ++k) sum += costs.density(beyond + length * (k + 0.5) / n) * length / n;
    EXPECT_NEAR(costs.away(beyond, length), sum, 1e-5 * (1.0 + sum));
  }
}

TEST(Smoothing, NeverDearerAlwaysFreeContinuousAndBetweenTheSameEnds) {
  Random random{31};
  int smoothed_ways = 0;
  for (int i = 0; i < 20; ++i) {
    const Problem problem = Problem::prepare(small_hall(random, i % 2 == 0)).value();
    const LatticeGraph graph{problem, coarse()};
    MotionCost cost{problem, graph.options().costs, graph.margin()};
    const LatticeRest rest = rest_of(graph, cost);
    Budget budget;
    const LatticeAnswer answer = search_lattice(graph, rest, cost, 0.0, budget);
    if (answer.ended != LatticeAnswer::End::found) continue;
    const Smoothed way = smoothed(answer.stretches, cost, graph.limits(), budget);
    ++smoothed_ways;
    EXPECT_LE(way.cost, cost_of(answer.stretches, cost));
    Pose at = problem.start();
    double curvature = 0.0;
    for (const LatticeStretch& s : way.stretches) {
      const Pose begin = start_of(s);
      ASSERT_NEAR(distance(begin.position(), at.position()), 0.0, 1e-8);
      ASSERT_NEAR(wrap(begin.heading - at.heading), 0.0, 1e-8);
      at = end_of(s);
      if (s.direction == 0) {
        curvature = 0.0;
        continue;
      }
      ASSERT_NEAR(s.curves.front().curvature, curvature, 1e-7);
      curvature = end_curvature(s.curves.back());
      ASSERT_TRUE(are_within(s.curves, {graph.limits().curvature * (1.0 + 1e-9), graph.limits().curvature_rate}));
      ASSERT_TRUE(cost.is_free(s));
    }
    EXPECT_NEAR(distance(at.position(), problem.goal().position()), 0.0, 1e-8);
    EXPECT_NEAR(wrap(at.heading - problem.goal().heading), 0.0, 1e-8);
  }
  EXPECT_GE(smoothed_ways, 12);
}

}  // namespace
}  // namespace waywright
