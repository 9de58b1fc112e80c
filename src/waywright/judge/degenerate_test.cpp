// Motions of no length, of no turn, with control points in one place, too small and too large: a proof ends with numbers, and is not wrong.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/random_motions.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/proof/limits.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

using namespace random_motions;

Spline spline(const std::vector<Vec2>& control) {
  BezierSpan span;
  span.degree = static_cast<int>(control.size()) - 1;
  std::copy(control.begin(), control.end(), span.control.begin());
  return {SplineKind::quintic, {span}};
}

Pieces awkward_pieces() {
  const Vec2 far{1e6, -1e6};
  return {
      {Line{{0, 0}, {1e-300, 0}}, 1},
      {Line{{0, 0}, {5e-324, 5e-324}}, 1},
      {Line{{0, 0}, {1e-9, 0}}, 1},
      {Line{-1.0 * far, far}, -1},
      {Arc{{0, 0, 0}, 0.0, 1.0}, 1},
      {Arc{{0, 0, 0}, 1e-300, 1.0}, 1},
      {Arc{{0, 0, 0}, 1e9, 1e-9}, 1},
      {Arc{{0, 0, 0}, 1e4, 0.1}, 1},       // a thousand radians
      {Arc{{0, 0, 0}, 1e-6, 1e6}, -1},
      {Arc{{1e6, 1e6, 3.0}, 0.5, 1e-12}, 1},
      {Turn{{0, 0}, 0.0, 0.0}, 0},
      {Turn{{0, 0}, 0.0, 1e-15}, 0},
      {Turn{{0, 0}, 0.0, 1e3}, 0},
      {PoseSequence{{{0, 0, 0}, {0, 0, 0}}}, 1},
      {PoseSequence{{{0, 0, 0}, {0, 0, 3.0}, {1e-12, 0, -3.0}, {1e-12, 0, -3.0}}}, 1},
      {PoseSequence{{{0, 0, pi}, {1e6, 0, -pi}}}, 1},
      {spline({{0, 0}, {0, 0}, {0, 0}, {0, 0}}), 1},
      {spline({{0, 0}, {0, 0}, {0, 0}, {1, 1}}), 1},
      {spline({{0, 0}, {1, 0}, {1, 0}, {0, 0}}), 1},              // there and back on one line
      {spline({{0, 0}, {1, 0}, {2, 0}, {3, 0}}), 1},              // straight
      {spline({{0, 0}, {4, 0}, {-2, 0}, {2, 0}}), 1},             // a cusp on a line
      {spline({{0, 0}, {1, 1}, {0, 1}, {1, 0}}), 1},              // a cusp
      {spline({{0, 0}, {1e-9, 0}, {1e-9, 1e-9}, {2e-9, 1e-9}}), 1},
      {spline({{0, 0}, {1e-200, 0}, {1e-200, 1e-200}, {0, 1e-200}}), 1},
      {spline({{0, 0}, {1e6, 0}, {1e6, 1e6}, {0, 1e6}, {0, 0}, {1e6, 0}}), 1},
      {spline({{0, 0}, {3, 0}}), 1},
      {spline({{0, 0}, {0, 0}}), 1},
  };
}

std::vector<Footprint> footprints() {
  return {forklift().footprint, {{}, 0.0}, {{}, 1e-9}, {{}, 1e3}, {l_shape(), 0.0}, {{{-1, 0}, {1, 0}, {0, 1e-9}}, 0.0}, {rectangle({-1e-9, -1e-9}, {1e-9, 1e-9}), 0.0}};
}

std::vector<Map> maps() {
  Map empty, cluttered, touching;
  cluttered.obstacles = {rectangle({0.5, 0.6}, {1.5, 1.2}), {{-1, 2}, {1, 2}, {0, 2.000001}}};
  cluttered.points = {{3.0, 0.0}, {3.0, 0.0}, {-5.0, 1e-9}};
  cluttered.lines = {{{-10.0, 4.0}, {-10.0, 4.0}}, {{2, -2}, {2, -2.5}, {2, -2}}};
  touching.points = {{0.0, 0.0}};
  return {empty, cluttered, touching};
}

TEST(DegenerateProof, EndsWithNumbersWhateverTheCurve) {
  for (const Piece& piece : awkward_pieces()) {
    for (const Footprint& footprint : footprints()) {
      for (const Map& map : maps()) {
        const Path path{{piece}};
        if (!check_form(path).empty()) {
          EXPECT_FALSE(prove(problem_for(map, {{{Line{{0, 0}, {1, 0}}, 1}}}, footprint), path).holds());
          continue;
        }
        Scenario scenario = problem_for(map, path, footprint).scenario();
        scenario.vehicle.limits.curvature_rate = 1.0;
        const Plan plan = judge(Problem::prepare(scenario).value(), path);
        const Certificate& c = plan.certificate;
        ASSERT_TRUE(std::isfinite(c.clearance) && c.clearance >= 0.0 && c.clearance <= 10.0);
        ASSERT_TRUE(std::isfinite(c.checked_length));
        ASSERT_EQ(plan.status == Status::solved, plan.reason.empty());
        if (plan.status == Status::solved) {
          ASSERT_TRUE(c.collision_free);
        }
        for (const Sample& s : plan.samples) ASSERT_TRUE(is_finite(s.pose()) && std::isfinite(s.t) && std::isfinite(s.speed));
        if (!map.points.empty() && map.points.front() == Vec2{} && plan.status == Status::solved) {
          // A point where the motion begins is touched by all of these footprints, or the motion is elsewhere.
          EXPECT_GT(norm(start_pose(path).position()), 1.0);
        }
      }
    }
  }
}

TEST(DegenerateProof, WhatHasNoSizeStillHoldsWhereItIsFree) {
  Map map;
  map.points = {{0.0, 1.0}};
  for (const double length : {1e-300, 1e-12, 1e-9, 1e-6}) {
    const Path path{{{Line{{0, 0}, {length, 0}}, 1}}};
    const Proof proof = prove(problem_for(map, path, {{}, 0.25}), path);
    EXPECT_TRUE(proof.holds()) << length << ": " << proof.violations.front().sentence;
    EXPECT_NEAR(proof.certificate.clearance, 0.75, 1e-6);
  }
  // Twenty kilometres long, 0.2 m beside a wall of two thousand.
  map.lines = {{{-1e6, 0.5}, {1e6, 0.5}}};
  map.points.clear();
  const Path path{{{Line{{-1e4, 0}, {1e4, 0}}, 1}}};
  const Proof proof = prove(problem_for(map, path, {{}, 0.3}), path);
  EXPECT_TRUE(proof.holds());
  EXPECT_NEAR(proof.certificate.clearance, 0.2, 1e-6);
  // Two thousand kilometres would take too many samples: refused with that reason, not judged in part.
  const Path endless{{{Line{{-1e6, 0}, {1e6, 0}}, 1}}};
  const Proof refused = prove(problem_for(map, endless, {{}, 0.3}), endless);
  EXPECT_FALSE(refused.holds());
  ASSERT_FALSE(refused.violations.empty());
  EXPECT_NE(refused.violations.front().sentence.find("samples"), std::string::npos) << refused.violations.front().sentence;
}

}  // namespace
}  // namespace waywright
