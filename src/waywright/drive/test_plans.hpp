// Judged plans for tests: a forklift's with changes of direction, a trolley's with turns on the spot, a mecanum base's.
#pragma once

#include <gtest/gtest.h>

#include "waywright/curve/bezier.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright::drive_test {

inline Vehicle forklift() {
  Vehicle v;
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.9, 1.0472, 0.7, SteeredAxle::rear};
  v.limits = {1.2, 1.0, 0.5, 0.6, 0.4, 0.8, std::nullopt, 0.8, 1.5};
  return v;
}

inline Vehicle trolley() {
  Vehicle v;
  v.footprint.disc = 0.4;
  v.drive = Differential{0.5};
  v.limits = {1.0, 0.6, 0.5, 0.5, 0.4, 0.8, 0.7, std::nullopt, std::nullopt};
  return v;
}

inline Scenario scenario_of(const Vehicle& vehicle, const Path& path, const std::vector<Vec2>& points = {}) {
  Scenario s;
  s.map.points = points;
  s.vehicle = vehicle;
  s.start = start_pose(path);
  s.mission = end_pose(path);
  return s;
}

inline Plan judged(const Vehicle& vehicle, const Path& path, const std::vector<Vec2>& points = {}) {
  Plan plan = judge(Problem::prepare(scenario_of(vehicle, path, points)).value(), path);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  return plan;
}

/// Backwards on a bend, forwards straight, on an arc whose curvature jumps (the steered wheel turns while it stands), on. `side` −1: the same in a mirror.
inline Path forklift_path(double side = 1.0) {
  const BezierSpan bend = straight_ended_quintic({0, 0}, {4.0, 0}, {4, side * 1.5}, 4.0 * unit(side * 0.6));
  Path path{{{Spline{SplineKind::quintic, {bend}}, -1}}};
  Pose at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() + 1.3 * unit(at.heading)}, 1});
  at = end_pose(path);
  path.pieces.push_back({Arc{at, side * 0.5, 0.8}, 1});
  at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() + 0.9 * unit(at.heading)}, 1});
  return path;
}

/// Straight, turns on the spot to both sides, an arc, straight back.
inline Path trolley_path(double side = 1.0) {
  Path path{{{Line{{0, 0}, {1.5, 0}}, 1}, {Turn{{1.5, 0}, 0.0, side * 1.2}, 0}, {Turn{{1.5, 0}, side * 1.2, side * -0.4}, 0}}};
  path.pieces.push_back({Arc{{1.5, 0, side * 0.8}, side * -0.9, 1.1}, 1});
  const Pose at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() - 0.7 * unit(at.heading)}, -1});
  return path;
}

/// A mecanum base on the trolley's way. (No planner drives sideways yet, and problems of such vehicles are refused: the drive is exchanged in the judged plan.)
inline Vehicle mecanum_base() {
  Vehicle v = trolley();
  v.drive = Mecanum{0.0475, 0.235, 0.15};
  return v;
}
inline Plan mecanum_plan() {
  Plan plan = judged(trolley(), trolley_path());
  plan.scenario.vehicle = mecanum_base();
  return plan;
}
/// The same base sideways, turning slowly.
inline Plan sideways_plan() {
  PoseSequence sequence;
  for (int i = 0; i <= 40; ++i) sequence.poses.push_back({0.02 * i, 0.05 * i, 0.01 * i});
  Plan plan;
  plan.scenario.vehicle = mecanum_base();
  plan.path = Path{{{sequence, 1}}};
  plan.samples = sample(plan.path, 0.4, 5e-4);
  assign_speed(plan.samples, plan.scenario.vehicle);
  return plan;
}

/// Corners of a polyline, each turned at on the spot.
inline Path polyline(const std::vector<Vec2>& corners) {
  Path path;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    if (i > 0) {
      const double from = angle_of(corners[i] - corners[i - 1]), to = angle_of(corners[i + 1] - corners[i]);
      if (from != to) path.pieces.push_back({Turn{corners[i], from, shorter_turn(from, to)}, 0});
    }
    path.pieces.push_back({Line{corners[i], corners[i + 1]}, 1});
  }
  return path;
}

}  // namespace waywright::drive_test
