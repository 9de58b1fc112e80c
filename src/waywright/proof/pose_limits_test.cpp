#include "waywright/proof/pose_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Vehicle tricycle() {
  Vehicle v;
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.9, 1.0472, 0.7, SteeredAxle::rear};
  v.limits.curvature = 0.8;
  v.limits.curvature_rate = 1.5;
  return v;
}

/// A drive by its curvature over length, a pose every `step` metres.
PoseSequence drive(double length, double step, const std::function<double(double)>& curvature,
                   int direction = 1, Pose at = {}) {
  PoseSequence sequence{{at}};
  const int fine = 20;
  const int steps = static_cast<int>(std::lround(length / step));
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < fine; ++k) {
      const double ds = direction * step / fine;
      const double turn = curvature((i + (k + 0.5) / fine) * step) * step / fine;
      at = make_pose(at.position() + ds * unit(at.heading + 0.5 * turn), wrap(at.heading + turn));
    }
    sequence.poses.push_back(at);
  }
  return sequence;
}

PoseSequence noisy(PoseSequence sequence, double position, double heading, std::uint64_t seed) {
  Random random{seed};
  for (Pose& p : sequence.poses) {
    p = {p.x + random.uniform(-position, position), p.y + random.uniform(-position, position),
         p.heading + random.uniform(-heading, heading)};
  }
  return sequence;
}

bool keeps(const Path& path, const Vehicle& vehicle = tricycle()) {
  return check_pose_sequences(vehicle, path).empty();
}
bool keeps(const PoseSequence& sequence, const Vehicle& vehicle = tricycle()) {
  return keeps(Path{{{sequence, 1}}}, vehicle);
}

/// Curvature that rises and falls within the limits of the vehicle.
double gentle(double s) { return 0.75 * std::sin(1.8 * s); }

TEST(PoseLimits, DrivesWithinTheLimitsAreKeptAtAnyDensityAndWithNoise) {
  for (const double step : {0.001, 0.01, 0.05, 0.1}) {
    EXPECT_TRUE(keeps(drive(6.0, step, gentle))) << step;
    EXPECT_TRUE(keeps(Path{{{drive(6.0, step, gentle, -1), -1}}})) << step;
    EXPECT_TRUE(keeps(drive(6.0, step, [](double) { return 0.8; }))) << step;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      EXPECT_TRUE(keeps(noisy(drive(6.0, step, gentle), 0.003, 0.002, seed))) << step << ' ' << seed;
  }
}

TEST(PoseLimits, SlidingSidewaysIsFoundHoweverDenseThePoses) {
  for (const int rows : {2, 7, 1601, 100'000}) {
    PoseSequence sideways, oblique;
    for (int i = 0; i < rows; ++i) {
      const double t = static_cast<double>(i) / (rows - 1);
      sideways.poses.push_back({0.0, 3.0 * t, 0.0});
      oblique.poses.push_back({3.0 * t, 0.3 * t, 0.0});
    }
    EXPECT_FALSE(keeps(sideways)) << rows;
    EXPECT_FALSE(keeps(oblique)) << rows;
    Vehicle mecanum = tricycle();
    mecanum.drive = Mecanum{0.1, 0.3, 0.3};
    EXPECT_TRUE(keeps(sideways, mecanum));
  }
}

TEST(PoseLimits, SlidingInManyShortStrokesIsFound) {
  Path path;
  Pose at{};
  for (int stroke = 0; stroke < 60; ++stroke) {
    const int direction = stroke % 2 == 0 ? 1 : -1;
    const Pose next{at.x + 0.1 * direction, at.y + 0.005, 0.0};
    path.pieces.push_back({PoseSequence{{at, next}}, direction});
    at = next;
  }
  EXPECT_FALSE(keeps(path));
}

TEST(PoseLimits, MovingAgainstTheDirectionIsFoundHoweverDenseThePoses) {
  for (const int rows : {2, 1601, 100'000}) {
    PoseSequence back;
    for (int i = 0; i < rows; ++i) back.poses.push_back({-3.0 * i / (rows - 1), 0.0, 0.0});
    EXPECT_FALSE(keeps(Path{{{back, 1}}})) << rows;
    EXPECT_TRUE(keeps(Path{{{back, -1}}})) << rows;
  }
  // There, a little back, and on.
  EXPECT_FALSE(keeps(PoseSequence{{{0, 0, 0}, {1.0, 0, 0}, {0.95, 0, 0}, {2.0, 0, 0}}}));
  EXPECT_TRUE(keeps(PoseSequence{{{0, 0, 0}, {1.0, 0, 0}, {0.996, 0, 0}, {2.0, 0, 0}}}));
  // Back as a whole, by less than noise.
  EXPECT_FALSE(keeps(PoseSequence{{{0, 0, 0}, {-0.004, 0, 0}}}));
}

TEST(PoseLimits, CurvatureOverTheLimitIsFoundInShortStrokesSpotsAndLongDrives) {
  Path strokes;
  Pose at{};
  for (int stroke = 0; stroke < 8; ++stroke) {
    const int direction = stroke % 2 == 0 ? 1 : -1;
    const PoseSequence sequence = drive(
        0.2, 0.02, [](double) { return 5.0; }, direction, at);
    at = sequence.poses.back();
    strokes.pieces.push_back({sequence, direction});
  }
  EXPECT_FALSE(keeps(strokes));
  Vehicle free = tricycle();
  free.limits.curvature_rate.reset();
  // Turning by 0.1 rad on 1 mm in the middle of a straight drive.
  EXPECT_FALSE(keeps(drive(2.0, 0.001, [](double s) { return s > 1.0 && s < 1.001 ? 100.0 : 0.0; }), free));
  EXPECT_FALSE(keeps(drive(4.0, 0.01, [](double) { return 0.83; }), free));
  EXPECT_TRUE(keeps(drive(4.0, 0.01, [](double) { return 0.8; }), free));
  // Two strokes that turn the same way count as one: 0.03 rad too much in each of many pieces of 2 cm.
  Path split;
  at = {};
  for (int stroke = 0; stroke < 30; ++stroke) {
    const int direction = stroke % 2 == 0 ? 1 : -1;
    const PoseSequence sequence = drive(
        0.02, 0.02, [](double) { return 1.2; }, direction, at);
    at = sequence.poses.back();
    split.pieces.push_back({sequence, direction});
  }
  EXPECT_FALSE(keeps(split, free));
}

TEST(PoseLimits, CurvatureRateOverTheLimitIsFound) {
  const auto slalom = [](double s) { return std::fmod(s, 0.6) < 0.3 ? 0.79 : -0.79; };
  Vehicle free = tricycle();
  free.limits.curvature_rate.reset();
  for (const double step : {0.002, 0.01, 0.05}) {
    EXPECT_FALSE(keeps(drive(3.6, step, slalom))) << step;
    EXPECT_TRUE(keeps(drive(3.6, step, slalom), free)) << step;
    EXPECT_FALSE(keeps(drive(4.0, step, [](double s) { return s < 2.0 ? 0.0 : 0.5; }))) << step;
    // Rising at twice the limit, and at the limit.
    EXPECT_FALSE(keeps(drive(2.0, step, [](double s) {
      return std::clamp(-0.75 + 3.0 * (s - 0.5), -0.75, 0.75);
    }))) << step;
    EXPECT_TRUE(keeps(drive(2.0, step, [](double s) {
      return std::clamp(-0.75 + 1.5 * (s - 0.5), -0.75, 0.75);
    }))) << step;
  }
}

}  // namespace
}  // namespace waywright
