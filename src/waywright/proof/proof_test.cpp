#include "waywright/proof/proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <list>

#include "tests/oracle/brute_force.hpp"
#include "tests/oracle/random_motions.hpp"
#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/proof/collision.hpp"
#include "waywright/proof/limits.hpp"

namespace waywright {
namespace {

using namespace random_motions;

/// Bounds against dense sampling by the independent oracle: never above the truth, at most the tolerance below it.
void bounds_hold(int runs, std::uint64_t seed, double step) {
  Random random{seed};
  int free = 0;
  for (int i = 0; i < runs; ++i) {
    const Map map = random_map(random, {.boxes = 6, .points = 10});
    const Path path = random_path(random);
    const Footprint footprint = random_footprint(random);
    const Problem problem = problem_for(map, path, footprint);
    const Proof proof = prove(problem, path);
    const double truth = oracle_path_clearance(map, {}, {}, footprint, path, step);
    ASSERT_LE(proof.certificate.clearance, truth + 1e-9) << "seed " << seed << " run " << i;
    if (proof.certificate.collision_free) {
      ++free;
      ASSERT_GT(truth, 0.0) << "seed " << seed << " run " << i;
    }
    if (samples_needed(path, footprint.radius(), proof.certificate.tolerance) > static_cast<double>(most_samples)) continue;  // nearly a cusp: refused
    // The oracle's samples can miss the least clearance by half its step.
    ASSERT_GE(proof.certificate.clearance, truth - proof.certificate.tolerance - step)
        << "seed " << seed << " run " << i << ": " << (proof.violations.empty() ? "" : proof.violations.front().sentence);
  }
  EXPECT_GT(free, runs / 50);
}

TEST(Proof, BoundIsNeverWrongAndHardlyCautious) { bounds_hold(300, 11, 0.004); }

/// Boundaries, lines, turned grids; pose sequences, turns on the spot, changes of direction; far from the origin.
TEST(Proof, BoundIsNeverWrongInAnyKindOfWorldOnAnyKindOfPiece) {
  Random random{41};
  int free = 0;
  for (int i = 0; i < 150; ++i) {
    const Vec2 far = i % 3 == 0 ? Vec2{random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4)} : Vec2{};
    Map map = random_map(random, {.boxes = 2, .points = 3, .lines = 0, .grids = 0});
    map.boundaries = {rectangle({-14, -14}, {14, 14})};
    map.lines = {{{random.uniform(-6, 6), random.uniform(-6, 6)}, {random.uniform(-6, 6), random.uniform(-6, 6)}}};
    CellGrid grid{"grid", 9, 7, 0.5, {random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)}, std::vector<std::uint8_t>(63, 0), false};
    for (std::uint8_t& cell : grid.blocked) cell = random.uniform() < 0.1 ? 1 : 0;
    map.grids = {grid};
    for (std::vector<Ring>* rings : {&map.boundaries, &map.obstacles, &map.lines}) {
      for (Ring& ring : *rings) ring = transformed(ring, Frame{make_pose(far, 0.0)});
    }
    for (Vec2& p : map.points) p = p + far;
    map.grids[0].origin = make_pose(map.grids[0].origin.position() + far, map.grids[0].origin.heading);

    Path path;
    Pose at = make_pose(far + Vec2{random.uniform(-3, 3), random.uniform(-3, 3)}, random.uniform(-pi, pi));
    const Pose first = at;
    for (int k = 0; k < 3; ++k) {
      const int direction = random.uniform() < 0.5 ? 1 : -1;
      const double kind = random.uniform();
      const Pose course = make_pose(at.position(), direction > 0 ? at.heading : wrap(at.heading + pi));
      if (kind < 0.25) {
        path.pieces.push_back({Turn{at.position(), at.heading, random.uniform(-3, 3)}, 0});
      } else if (kind < 0.5) {
        path.pieces.push_back({Arc{course, random.uniform(-0.8, 0.8), random.uniform(0.2, 2.0)}, direction});
      } else {
        PoseSequence sequence{{at}};
        for (int n = 0; n < 4; ++n) {
          const Pose& p = sequence.poses.back();
          sequence.poses.push_back(make_pose(p.position() + random.uniform(0.1, 0.6) * unit(random.uniform(-pi, pi)), wrap(p.heading + random.uniform(-1, 1))));
        }
        path.pieces.push_back({sequence, direction});
      }
      at = end_pose(path);
    }
    ASSERT_EQ(start_pose(path).position(), first.position());
    Footprint footprint;
    if (random.uniform() < 0.5) footprint.polygon = rectangle({-0.6, -0.3}, {0.4, 0.3});
    else footprint.disc = random.uniform(0.0, 0.5);
    constexpr double step = 0.003;
    const Proof proof = prove(problem_for(map, path, footprint), path);
    const double truth = oracle_path_clearance(map, {}, {}, footprint, path, step);
    ASSERT_LE(proof.certificate.clearance, truth + 1e-9) << i;
    ASSERT_GE(proof.certificate.clearance, truth - proof.certificate.tolerance - step) << i;
    free += proof.certificate.collision_free ? 1 : 0;
  }
  EXPECT_GT(free, 10);
}

TEST(Proof, ClearanceOfStraightMotionIsExact) {
  Map map;
  map.points = {{5.0, 0.95}};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  const Proof proof = prove(problem_for(map, path, forklift().footprint), path);
  EXPECT_TRUE(proof.holds());
  EXPECT_NEAR(proof.certificate.clearance, 0.5, 1e-9);
  EXPECT_NEAR(proof.certificate.checked_length, 10.0, 1e-9);
}

// Where nothing is to spare: a disc of 0.3 m on an arc of 2 m radius past a point 2.4 m from the arc's centre.
TEST(Proof, ClearanceThatAnArcMeetsExactlyIsProven) {
  Map map;
  map.points = {2.4 * unit(0.7)};
  const Path path{{{Arc{Pose{2.0, 0.0, 0.5 * pi}, 0.5, 3.0}, 1}}};
  Footprint disc;
  disc.disc = 0.3;
  Scenario s = problem_for(map, path, disc).scenario();
  s.clearance = 0.1;
  EXPECT_TRUE(prove(Problem::prepare(s).value(), path).holds());
  s.clearance = 0.1 + 3e-6;
  EXPECT_FALSE(prove(Problem::prepare(s).value(), path).holds());
}

TEST(Proof, AThinWallBetweenSamplesIsFound) {
  Map map;
  map.lines = {{{3.0123, -5.0}, {3.0123, 5.0}}};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  const Proof proof = prove(problem_for(map, path, forklift().footprint), path);
  EXPECT_FALSE(proof.certificate.collision_free);
  EXPECT_EQ(World{map}.source_name(proof.certificate.tightest_source), "line 0");
}

TEST(Proof, TouchingCountsAsCollision) {
  Map map;
  map.obstacles = {rectangle({2.0, 0.45}, {3.0, 1.0})};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  EXPECT_FALSE(prove(problem_for(map, path, forklift().footprint), path).certificate.collision_free);
}

TEST(Proof, PoseErrorIsTakenOffAndHoldsForEveryPoseWithinIt) {
  Map map;
  map.points = {{5.0, 0.75}, {2.0, -0.8}};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  Scenario s = problem_for(map, path, forklift().footprint).scenario();
  s.pose_error = {0.03, 0.02, 0.02};
  const Problem problem = Problem::prepare(s).value();
  const Proof proof = prove(problem, path);
  ASSERT_TRUE(proof.certificate.collision_free);
  Random random{5};
  for (int i = 0; i < 4000; ++i) {
    const Frame nominal{Pose{random.uniform(0, 10), 0.0, 0.0}};
    const Pose off = nominal.to_world(Pose{random.uniform(-0.02, 0.02), random.uniform(-0.03, 0.03), random.uniform(-0.02, 0.02)});
    EXPECT_GE(problem.world().clearance(s.vehicle.footprint, off, 10.0).clearance, proof.certificate.clearance);
  }
}

TEST(Proof, ClearanceMetExactlyAtTheGoalStands) {
  Map map;
  map.obstacles = {rectangle({10.5, -1.0}, {11.0, 1.0})};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  Scenario s = problem_for(map, path, forklift().footprint).scenario();
  s.clearance = 0.1;
  const Proof proof = prove(Problem::prepare(s).value(), path);
  EXPECT_TRUE(proof.holds()) << proof.violations.front().sentence;
}

TEST(Limits, CurvatureOverTheLimitIsFoundBetweenSamples) {
  const BezierSpan sharp = straight_ended_quintic({0, 0}, {3.0, 0}, {2, 2}, {0, 3.0});
  const Path path{{{Spline{SplineKind::quintic, {sharp}}, 1}}};
  double peak = 0.0;
  double rate = 0.0;
  for (int i = 0; i <= 100000; ++i) {
    const CurvePoint p = evaluate(sharp, i / 1e5);
    peak = std::max(peak, std::abs(p.curvature));
    rate = std::max(rate, std::abs(p.curvature_rate));
  }
  Vehicle v = forklift();
  std::get<Tricycle>(v.drive).max_steering = 1.5;
  v.limits.curvature = peak * (1.0 + 1e-5);
  EXPECT_TRUE(check_limits(v, path, Motion{path}).empty());
  v.limits.curvature = peak * (1.0 - 1e-5);
  EXPECT_FALSE(check_limits(v, path, Motion{path}).empty());
  v.limits.curvature = 10.0;
  v.limits.curvature_rate = rate * (1.0 + 1e-5);
  EXPECT_TRUE(check_limits(v, path, Motion{path}).empty());
  v.limits.curvature_rate = rate * (1.0 - 1e-5);
  EXPECT_FALSE(check_limits(v, path, Motion{path}).empty());
}

TEST(Limits, SidewaysMotionAndTurningOnTheSpotAreRefusedForATricycle) {
  const Path sideways{{{PoseSequence{{{0, 0, 0}, {0.0, 0.5, 0}}}, 1}}};
  EXPECT_FALSE(check_limits(forklift(), sideways, Motion{sideways}).empty());
  const Path turn{{{Turn{{0, 0}, 0.0, 1.0}, 0}}};
  EXPECT_FALSE(check_limits(forklift(), turn, Motion{turn}).empty());
  Vehicle differential = forklift();
  differential.drive = Differential{0.6};
  EXPECT_TRUE(check_limits(differential, turn, Motion{turn}).empty());
  differential.drive = Mecanum{0.1, 0.3, 0.3};
  EXPECT_TRUE(check_limits(differential, sideways, Motion{sideways}).empty());
}

TEST(Proof, GapsWrongEndsAndBrokenNumbersAreViolations) {
  const Map map;
  const Path good{{{Line{{0, 0}, {2, 0}}, 1}, {Line{{2, 0}, {4, 0}}, 1}}};
  const Problem problem = problem_for(map, good, forklift().footprint);
  EXPECT_TRUE(prove(problem, good).holds());
  EXPECT_FALSE(prove(problem, {{{Line{{0, 0}, {2, 0}}, 1}, {Line{{2.01, 0}, {4, 0}}, 1}}}).holds());
  EXPECT_FALSE(prove(problem, {{{Line{{0, 0}, {2, 0}}, 1}}}).holds());
  EXPECT_FALSE(prove(problem, {}).holds());
  EXPECT_FALSE(prove(problem, {{{Line{{0, 0}, {std::nan(""), 0}}, 1}}}).holds());
  EXPECT_FALSE(prove(problem, {{{Line{{0, 0}, {0, 0}}, 1}}}).holds());
  EXPECT_FALSE(prove(problem, {{{Spline{SplineKind::quintic, {}}, 1}}}).holds());
  EXPECT_FALSE(prove(problem, {{{Line{{0, 0}, {4, 0}}, 0}}}).holds());
}

TEST(Proof, ACuspIsRefusedInBoundedWork) {
  // Control points that fold back: the speed vanishes inside.
  const BezierSpan cusp{3, {Vec2{0, 0}, {4, 0}, {-2, 0.0}, {2, 0}}};
  const Path path{{{Spline{SplineKind::natural_cubic, {cusp}}, 1}}};
  const Proof proof = prove(problem_for({}, path, forklift().footprint), path);
  EXPECT_FALSE(proof.holds());
}

// The heading flips where a straight cubic turns back: rounding must not make a positive speed of the double root there.
TEST(Proof, AStraightCubicThatTurnsBackIsRefusedWhateverItsNumbers) {
  Random random{3};
  int folded = 0;
  for (int i = 0; i < 400; ++i) {
    const double first = random.uniform(1.0, 6.0);
    const double second = random.uniform(-4.0, 1.0);
    const double a = first, b = second - first, c = 3.0 - second;
    if (!(b * b > 1.01 * a * c && b < 0.0 && c > 0.0)) continue;
    ++folded;
    const Pose placed{random.uniform(-3, 3), random.uniform(-3, 3), i % 2 == 0 ? 0.0 : random.uniform(-pi, pi)};
    BezierSpan fold{3, {Vec2{0, 0}, {first, 0}, {second, 0}, {3, 0}}};
    for (Vec2& p : fold.control) p = Frame{placed}.to_world(p);
    const Path path{{{Spline{SplineKind::natural_cubic, {fold}}, 1}}};
    EXPECT_FALSE(prove(problem_for({}, path, forklift().footprint), path).holds()) << first << ' ' << second;
    Vehicle v = forklift();
    EXPECT_FALSE(check_limits(v, path, Motion{path}).empty()) << first << ' ' << second;
    SweepMemory memory;
    EXPECT_FALSE(swept_clearance(World{}, SweptBody{forklift().footprint}, Motion{path}.intervals(), {}, memory).complete) << first << ' ' << second;
  }
  EXPECT_GT(folded, 100);
}

TEST(Proof, WhatNeedsTooManySamplesIsRefusedBeforeAnythingIsLookedAt) {
  const auto judged = [](const Path& path) { return prove(problem_for({}, path, forklift().footprint), path); };
  const Proof long_line = judged({{{Line{{0, 0}, {2000, 0}}, 1}}});
  EXPECT_TRUE(long_line.holds());
  EXPECT_TRUE(long_line.measurable);
  Path endless;
  for (int i = 0; i < 60; ++i) endless.pieces.push_back({i % 2 == 0 ? Line{{0, 0}, {1e7, 0}} : Line{{1e7, 0}, {0, 0}}, i % 2 == 0 ? 1 : -1});
  const Proof refused = judged(endless);
  EXPECT_FALSE(refused.measurable);
  ASSERT_EQ(refused.violations.size(), 1U);
  EXPECT_NE(refused.violations[0].sentence.find("too long"), std::string::npos) << refused.violations[0].sentence;
  EXPECT_FALSE(judged({{{PoseSequence{{{0, 0, 0}, {1e6, 0, 0}, {0, 1e6, 0}}}, 1}}}).measurable);
  // Its heading would be rounding: the arc goes round 10 000 000 times.
  EXPECT_FALSE(judged({{{Arc{{}, 1e6, 63.0}, 1}}}).measurable);
}

TEST(Proof, ACanceledProofIsUndecided) {
  const Path path{{{Arc{{}, 0.3, 4.0}, 1}}};
  const Problem problem = problem_for({}, path, forklift().footprint);
  std::atomic<bool> cancel{false};
  ProofOptions options;
  options.cancel = &cancel;
  EXPECT_TRUE(prove(problem, path, options).holds());
  cancel = true;
  EXPECT_FALSE(prove(problem, path, options).holds());
  EXPECT_FALSE(prove(problem, path, options).certificate.collision_free);
}

TEST(Proof, AWorkspaceLeavesNothingBehind) {
  Random random{31};
  const Footprint footprint = random_footprint(random);
  const Problem problem = problem_for(random_map(random, {.boxes = 6, .points = 10}), random_path(random), footprint);
  ProofWorkspace workspace{problem};
  for (int i = 0; i < 200; ++i) {
    const Path path = random_path(random);
    const Proof fresh = prove(problem, path), again = prove(problem, path, {}, workspace);
    EXPECT_EQ(fresh.certificate.clearance, again.certificate.clearance) << i;
    EXPECT_EQ(fresh.certificate.checked_length, again.certificate.checked_length) << i;
    EXPECT_EQ(fresh.certificate.tightest, again.certificate.tightest) << i;
    EXPECT_EQ(fresh.certificate.tightest_source, again.certificate.tightest_source) << i;
    ASSERT_EQ(fresh.violations.size(), again.violations.size()) << i;
    for (std::size_t k = 0; k < fresh.violations.size(); ++k) EXPECT_EQ(fresh.violations[k].sentence, again.violations[k].sentence);
  }
}

TEST(Proof, NothingNearIsNoTightestPlace) {
  Map map;
  map.points = {{5.0, 90.0}};
  const Path path{{{Line{{0, 0}, {10, 0}}, 1}}};
  const Proof proof = prove(problem_for(map, path, forklift().footprint), path);
  EXPECT_TRUE(proof.holds());
  EXPECT_FALSE(proof.certificate.tightest.has_value());
  EXPECT_EQ(proof.certificate.tightest_source, World::nothing);
  map.points = {{5.0, 9.0}};
  EXPECT_TRUE(prove(problem_for(map, path, forklift().footprint), path).certificate.tightest.has_value());
}

// What a straight stretch meets exactly is certified, whatever is curved on the way there.
TEST(Proof, AClearanceThatIsMetExactlyIsCertified) {
  Random random{9};
  for (int i = 0; i < 200; ++i) {
    const Frame placed{Pose{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-pi, pi)}};
    const double gap = std::round(random.uniform(0.02, 0.5) * 1000.0) / 1000.0;
    Map map;
    map.obstacles = {transformed(rectangle({4.4 + gap, -1.0}, {6.0, 1.0}), placed)};
    const Pose bend_start = placed.to_world(Pose{0.0, -2.0, 0.3});
    const Vec2 middle = placed.to_world(Vec2{3.0, 0.0});
    const BezierSpan bend = straight_ended_quintic(bend_start.position(), 3.0 * unit(bend_start.heading), middle, 3.0 * unit(placed.heading()));
    const Path path{{{Spline{SplineKind::quintic, {bend}}, 1}, {Line{middle, placed.to_world(Vec2{4.0, 0.0})}, 1}}};
    Scenario s = problem_for(map, path, forklift().footprint).scenario();
    s.vehicle.limits.curvature.reset();
    s.clearance = gap;
    if (i % 2 == 0) s.pose_error.longitudinal = 0.5 * gap, s.clearance = 0.5 * gap;
    const Proof proof = prove(Problem::prepare(s).value(), path);
    ASSERT_TRUE(proof.certificate.collision_free);
    EXPECT_GE(proof.certificate.clearance, s.clearance) << i;
    EXPECT_LE(proof.certificate.clearance, s.clearance + 1e-12) << i;
  }
}

// A line to the end of the allowed coordinates is rounded like its ends, not like the vehicle's place.
TEST(Proof, RoundingOfFarObstaclesIsAllowedFor) {
  Random random{4};
  for (int i = 0; i < 200; ++i) {
    // Exactly 0.5 m from a disc of 0.3 m at the origin: through (0.8 cos a, 0.8 sin a), at right angles to that.
    const double a = random.uniform(-pi, pi);
    const Vec2 near = 0.8 * unit(a);
    Map map;
    map.lines = {{near - 7e5 * unit(a + 0.5 * pi), near + 7e5 * unit(a + 0.5 * pi)}};
    const Path path{{{Arc{{0.0, 0.0, a + 0.5 * pi}, 1.0, 0.01}, 1}}};
    Footprint disc;
    disc.disc = 0.3;
    const Ring& line = map.lines[0];
    const long double dx = static_cast<long double>(line[1].x) - line[0].x, dy = static_cast<long double>(line[1].y) - line[0].y;
    const long double truth = std::abs(dx * line[0].y - dy * line[0].x) / std::sqrt(dx * dx + dy * dy) - 0.3L;
    EXPECT_LE(static_cast<long double>(prove(problem_for(map, path, disc), path).certificate.clearance), truth) << i;
  }
}

TEST(Limits, ACurvatureJumpInsideAPieceIsRefusedWhereSteeringTakesTime) {
  const double h = 4.0 / 3.0 * std::tan(0.25) * 2.0;
  const Vec2 end{2.0 + 2.0 * std::sin(1.0), 2.0 - 2.0 * std::cos(1.0)};
  const BezierSpan bend{3, {Vec2{2, 0}, {2.0 + h, 0}, end - h * unit(1.0), end}};
  const Path path{{{Spline{SplineKind::quintic, {straight_span({0, 0}, {2, 0}), bend}}, 1}}};
  Vehicle v = forklift();
  EXPECT_TRUE(check_limits(v, path, Motion{path}).empty());
  std::get<Tricycle>(v.drive).max_steering_rate = 0.1;
  EXPECT_FALSE(check_limits(v, path, Motion{path}).empty());
}

TEST(MotionInterval, EveryPoseIsWithinItsDeviation) {
  Random random{21};
  for (int i = 0; i < 2000; ++i) {
    const Path path = random_path(random);
    for (const Piece& piece : path.pieces) {
      const Motion motion{Path{{piece}}};
      std::list<MotionHalves> levels;
      const MotionInterval* part = &motion.intervals().back();
      for (int level = 0; level < 3; ++level) {
        levels.emplace_back(*part);
        part = random.uniform() < 0.5 ? &levels.back().left : &levels.back().right;
      }
      const MotionInterval& m = *part;
      const MotionHalves halves{m};
      const MotionInterval &left = halves.left, &right = halves.right;
      const double radius = 2.0;
      const double deviation = m.deviation(radius);
      if (!std::isfinite(deviation)) continue;
      // λ = ½ is where the halves meet: a body point's true place against the middle of its two end places.
      for (const Vec2 body : {Vec2{radius, 0}, Vec2{0, -radius}, Vec2{-1.2, 1.2}}) {
        const Vec2 even = 0.5 * (Frame{m.begin()}.to_world(body) + Frame{m.end()}.to_world(body));
        EXPECT_LE(distance(even, Frame{right.begin()}.to_world(body)), deviation + 1e-9);
      }
      EXPECT_NEAR(distance(left.end().position(), right.begin().position()), 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace waywright
