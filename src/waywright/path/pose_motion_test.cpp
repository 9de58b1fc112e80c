#include "waywright/path/pose_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/curve/arc.hpp"
#include "waywright/path/path.hpp"

namespace waywright {
namespace {

PoseSequence arc_poses(double curvature, double length, int steps, int direction) {
  PoseSequence sequence;
  for (int i = 0; i <= steps; ++i) {
    const CurvePoint p = evaluate(Arc{{1.0, 2.0, 3.0}, curvature, length}, length * i / steps);
    sequence.poses.push_back(make_pose(p.position, wrap(p.course + (direction < 0 ? pi : 0.0))));
  }
  return sequence;
}

TEST(PoseMotion, OnAnArcNothingSlides) {
  for (const int direction : {1, -1}) {
    const auto motion = motion_along(arc_poses(0.7, 3.0, 60, direction), direction);
    EXPECT_NEAR(motion.back().progress, 3.0, 1e-3);
    EXPECT_NEAR(motion.back().sideways, 0.0, 1e-12);
    EXPECT_NEAR(motion.back().turned, 2.1, 1e-12);
  }
}

TEST(PoseMotion, CurvatureIsEstimatedWhereItIsConstantAndWhereItRises) {
  for (const auto& e : estimated_curvature(arc_poses(0.7, 3.0, 600, -1), -1)) {
    EXPECT_NEAR(e.curvature, 0.7, 1e-4);
    EXPECT_NEAR(e.rate, 0.0, 1e-3);
  }
  PoseSequence clothoid;  // κ = 0.9 s
  Pose at{};
  for (int i = 0; i <= 2000; ++i) {
    if (i % 25 == 0) clothoid.poses.push_back(at);
    const double turn = 0.9 * (i + 0.5) * 1e-3 * 1e-3;
    at = make_pose(at.position() + 1e-3 * unit(at.heading + 0.5 * turn), at.heading + turn);
  }
  const auto estimates = estimated_curvature(clothoid, 1);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    EXPECT_NEAR(estimates[i].curvature, 0.9 * 0.025 * static_cast<double>(i), 2e-3);
    EXPECT_NEAR(estimates[i].rate, 0.9, 1e-2);
  }
}

TEST(PoseMotion, FewPosesAndPosesWithoutProgressGiveFiniteEstimates) {
  const PoseSequence two{{{0, 0, 0}, {1, 0, 0.2}}};
  EXPECT_NEAR(estimated_curvature(two, 1)[0].curvature, 0.2, 2e-3);
  for (const PoseSequence& odd :
       {PoseSequence{{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}}, PoseSequence{{{0, 0, 0}, {0, 0, 0}}},
        PoseSequence{{{0, 0, 0}, {-1, 0, 0}, {-2, 0, 0.1}}},
        PoseSequence{{{0, 0, 0}, {1e-7, 0, 0.1}, {2, 0, 0.1}}}}) {
    for (const auto& e : estimated_curvature(odd, 1))
      EXPECT_TRUE(std::isfinite(e.curvature) && std::isfinite(e.rate));
  }
}

TEST(PoseMotion, ThinnedPosesKeepTheirDistanceAndTheEnds) {
  const auto motion = motion_along(arc_poses(0.0, 1.0, 10'000, 1), 1);
  const auto nodes = thinned(motion);
  EXPECT_EQ(nodes.front(), 0U);
  EXPECT_EQ(nodes.back(), 10'000U);
  EXPECT_GE(nodes.size(), 98U);
  EXPECT_LE(nodes.size(), 101U);
}

}  // namespace
}  // namespace waywright
