#include "waywright/planner/steering/steering.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/brute_force.hpp"
#include "waywright/core/random.hpp"
#include "waywright/planner/steering/shortcut.hpp"

namespace waywright {
namespace {

constexpr MotionTestLimits no_limits{1'000'000'000, 1'000'000'000, 0.001};
constexpr double turn_cost = 0.2;

std::unique_ptr<const Steering> make(SteeringKind kind) { return make_steering(kind, {0.7, turn_cost, 0.5}); }

/// Every third one on a raster of places and quarter turns, where ways to turn are as good as each other.
Pose pose_of(Random& random, int i) {
  if (i % 3 == 0) return {static_cast<double>(random.integer(-3, 3)), static_cast<double>(random.integer(-3, 3)), wrap(0.5 * pi * static_cast<double>(random.integer(-1, 2)))};
  return {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-pi, pi)};
}

class EverySteering : public testing::TestWithParam<SteeringKind> {};

TEST_P(EverySteering, CostsWhatItsPiecesCost) {
  const auto steering = make(GetParam());
  EXPECT_EQ(steering->kind(), GetParam());
  Random random{41};
  for (int i = 0; i < 3000; ++i) {
    const Pose a = pose_of(random, i), b = pose_of(random, i);
    double cost = 0.0;
    const Pieces pieces = steering->between(a, b);
    for (const Piece& piece : pieces) cost += steering->cost(piece);
    const double whole = steering->distance(a, b);
    EXPECT_NEAR(cost, whole, 1e-8);
    EXPECT_GE(whole, distance(a.position(), b.position()) - 1e-9);
    EXPECT_LE(steering->least(a, b), whole + 1e-9);
    const Pose c = pose_of(random, i);
    EXPECT_LE(steering->least(a, c), whole + steering->distance(b, c) + 1e-8);  // no chain costs less
    if (steering->is_symmetric()) {
      EXPECT_NEAR(steering->distance(b, a), whole, 1e-8);
    }
    if (!pieces.empty() && steering->has_headings()) {
      EXPECT_LT(distance(start_pose(pieces.front()).position(), a.position()), 1e-9);
      EXPECT_LT(std::abs(shorter_turn(start_pose(pieces.front()).heading, a.heading)), 1e-9);
      EXPECT_LT(distance(end_pose(pieces.back()).position(), b.position()), 1e-9);
      EXPECT_LT(std::abs(shorter_turn(end_pose(pieces.back()).heading, b.heading)), 1e-9);
    }
  }
}

TEST_P(EverySteering, PartsOfAMotionAreMotions) {
  const auto steering = make(GetParam());
  Random random{42};
  for (int i = 0; i < 3000; ++i) {
    const Pose a = pose_of(random, i), b = pose_of(random, i);
    const double whole = steering->distance(a, b), t = random.uniform();
    EXPECT_EQ(steering->at(a, b, 1.0), b);
    EXPECT_EQ(steering->at(a, b, 0.0).position(), a.position());
    const Pose middle = steering->at(a, b, t);
    EXPECT_NEAR(steering->distance(a, middle), t * whole, 1e-6);
    EXPECT_NEAR(steering->distance(middle, b), (1.0 - t) * whole, 1e-6);
  }
}

TEST_P(EverySteering, APathAlongStatesIsContinuousAndEndsWhereItIsToEnd) {
  const auto steering = make(GetParam());
  Random random{43};
  for (int i = 0; i < 300; ++i) {
    std::vector<Pose> states;
    for (int k = 0; k < 5; ++k) states.push_back(pose_of(random, i));
    const Path path = path_along_states(*steering, states, states.front(), states.back());
    ASSERT_FALSE(path.pieces.empty());
    const auto same = [](const Pose& a, const Pose& b) { return distance(a.position(), b.position()) < 1e-8 && std::abs(shorter_turn(a.heading, b.heading)) < 1e-8; };
    EXPECT_TRUE(same(start_pose(path), states.front()));
    EXPECT_TRUE(same(end_pose(path), states.back()));
    for (std::size_t k = 1; k < path.pieces.size(); ++k) EXPECT_TRUE(same(end_pose(path.pieces[k - 1]), start_pose(path.pieces[k]))) << k;
    double metres = 0.0;
    for (std::size_t k = 1; k < states.size(); ++k) {
      for (const Piece& piece : steering->between(states[k - 1], states[k])) metres += length(piece);
    }
    EXPECT_NEAR(length(path), metres, 1e-8);
    const Path open = path_along_states(*steering, states, states.front(), std::nullopt);
    EXPECT_LT(distance(end_pose(open).position(), states.back().position()), 1e-8);
  }
}

/// Among motions that cost the same, too, of which grids of poses have many.
TEST_P(EverySteering, TheMotionBackIsTheSameOneDrivenTheOtherWay) {
  const auto steering = make(GetParam());
  if (!steering->is_symmetric()) return;
  Random random{44};
  for (int i = 0; i < 5000; ++i) {
    const Pose a = pose_of(random, i), b = pose_of(random, i);
    const Pieces there = steering->between(a, b), back = steering->between(b, a);
    EXPECT_EQ(steering->distance(a, b), steering->distance(b, a));
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t k = 0; k < there.size(); ++k) {
      const Piece &one = there[k], &other = back[there.size() - 1 - k];
      ASSERT_EQ(one.curve.index(), other.curve.index());
      EXPECT_EQ(one.direction, steering->has_headings() ? -other.direction : other.direction);
      EXPECT_NEAR(length(one), length(other), 1e-9);
      EXPECT_LT(distance(start_pose(one).position(), end_pose(other).position()), 1e-9);
      if (!steering->has_headings()) continue;
      EXPECT_LT(std::abs(shorter_turn(start_pose(one).heading, end_pose(other).heading)), 1e-9);
      if (const auto* turn = std::get_if<Turn>(&one.curve)) {
        EXPECT_EQ(turn->angle, -std::get<Turn>(other.curve).angle);
      } else if (const auto* arc = std::get_if<Arc>(&one.curve)) {
        EXPECT_EQ(arc->curvature, -std::get<Arc>(other.curve).curvature);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EverySteering, testing::ValuesIn(steering_kinds), [](const auto& entry) { return std::string{to_string(entry.param)}; });

TEST(PlaneSteering, StraightRunsAreOneLine) {
  const auto steering = make(SteeringKind::plane);
  const Pose start{0, 0, 0.3};
  const Path path = path_along_states(*steering, {start, {1, 1, 0}, {2, 2, 0}, {2, 5, 0}}, start, Pose{2, 5, 0.0});
  ASSERT_EQ(path.pieces.size(), 5u);  // turn, line, turn, line, turn
  EXPECT_TRUE(std::holds_alternative<Turn>(path.pieces[0].curve));
  EXPECT_NEAR(length(path.pieces[1]), std::sqrt(8.0), 1e-12);
}

Problem problem_with(Random& random, Footprint footprint, double clearance) {
  Scenario scenario;
  for (int i = 0; i < 2; ++i) {
    const Vec2 half{random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)};
    scenario.map.obstacles.push_back(transformed(rectangle(-half, half), Frame{Pose{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-pi, pi)}}));
  }
  for (int i = 0; i < 3; ++i) scenario.map.points.push_back({random.uniform(-5, 5), random.uniform(-5, 5)});
  scenario.vehicle.footprint = std::move(footprint);
  scenario.start = {50.0, 50.0, 0.0};
  scenario.mission = Pose{60.0, 50.0, 0.0};
  scenario.clearance = clearance;
  return Problem::prepare(scenario).value();
}

TEST(MotionTestOfTurns, FreeMeansFreeAndBlockedMeansNearlyBlocked) {
  Random random{45};
  const auto steering = make(SteeringKind::turns);
  const Footprint footprint{rectangle({-0.9, -0.35}, {0.4, 0.35}), 0.0};
  int free = 0, blocked = 0, stopped = 0;
  for (int i = 0; i < 150; ++i) {
    const double clearance = i % 2 == 0 ? 0.0 : 0.1;
    const Problem problem = problem_with(random, footprint, clearance);
    const Pose a{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-pi, pi)}, b{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-pi, pi)};
    const Pieces pieces = steering->between(a, b);
    Budget budget;
    MotionTest test{problem, no_limits, budget};
    const double truth = oracle_path_clearance(problem.world().map(), {}, {}, footprint, Path{pieces}, 0.002);
    if (test.motion_free(pieces)) {
      ++free;
      EXPECT_GE(truth, clearance);
      continue;
    }
    ++blocked;
    EXPECT_LE(truth, clearance + 0.005);
    // What lies before the place where it stops is free.
    Pieces before;
    for (std::size_t k = 0; k < test.stop().piece; ++k) before.push_back(pieces[k]);
    EXPECT_GE(test.stop().share, 0.0);
    EXPECT_LE(test.stop().share, 1.0);
    if (before.empty()) continue;
    ++stopped;
    EXPECT_TRUE(test.motion_free(before));
  }
  EXPECT_GE(free, 25);
  EXPECT_GE(blocked, 25);
  EXPECT_GE(stopped, 10);
}

TEST(ShortcutOverStates, NeverCostsMoreStaysFreeAndTakesAWayThatIsThere) {
  Random random{46};
  for (const SteeringKind kind : {SteeringKind::plane, SteeringKind::turns}) {
    const auto steering = make(kind);
    const Footprint footprint = kind == SteeringKind::plane ? Footprint{{}, 0.4} : Footprint{rectangle({-0.6, -0.3}, {0.4, 0.3}), 0.0};
    int tried = 0, shorter = 0;
    for (int i = 0; i < 300 && tried < 15; ++i) {
      const Problem problem = problem_with(random, footprint, 0.05);
      Budget budget;
      MotionTest test{problem, no_limits, budget};
      std::vector<Pose> states;
      bool is_free = true;
      for (int k = 0; k < 5; ++k) {
        states.push_back({random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-pi, pi)});
        is_free = is_free && (k == 0 || test.motion_free(steering->between(states[states.size() - 2], states.back())));
      }
      if (!is_free) continue;
      ++tried;
      const std::vector<Pose> better = shortened(states, *steering, test, 200, 7);
      EXPECT_EQ(better.front(), states.front());
      EXPECT_EQ(better.back(), states.back());
      EXPECT_LE(cost_of(*steering, better), cost_of(*steering, states) + 1e-9);
      shorter += cost_of(*steering, better) < 0.9 * cost_of(*steering, states) ? 1 : 0;
      const Path path = path_along_states(*steering, better, better.front(), better.back());
      EXPECT_GT(oracle_path_clearance(problem.world().map(), {}, {}, footprint, path, 0.005), 0.05 - 1e-9);
    }
    EXPECT_GE(tried, 10);
    EXPECT_GE(shorter, tried / 2);
  }
}

}  // namespace
}  // namespace waywright
