#include "waywright/curve/span_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

TEST(SpanBounds, PeaksAreOverEverySampleAndHardlyMore) {
  Random random{2};
  int finite = 0;
  for (int i = 0; i < 400; ++i) {
    BezierSpan span;
    span.degree = static_cast<int>(random.integer(1, 5));
    for (Vec2& p : span.control) p = {random.uniform(-3, 3), random.uniform(-3, 3)};
    const CurvaturePeaks peaks = curvature_peaks(span);
    double curvature = 0.0, rate = 0.0;
    for (int k = 0; k <= 20'000; ++k) {
      const CurvePoint p = evaluate(span, k / 20'000.0);
      curvature = std::max(curvature, std::abs(p.curvature));
      rate = std::max(rate, std::abs(p.curvature_rate));
    }
    EXPECT_GE(peaks.curvature, curvature * (1.0 - 1e-9));
    EXPECT_GE(peaks.rate, rate * (1.0 - 1e-9));
    const CurvaturePeaks coarse = coarse_curvature_peaks(span);
    EXPECT_GE(coarse.curvature, curvature * (1.0 - 1e-9));
    EXPECT_GE(coarse.rate, rate * (1.0 - 1e-9));
    if (!std::isfinite(peaks.rate) || curvature > 100.0)
      continue;  // samples step over peaks narrower than they are apart
    ++finite;
    EXPECT_LE(peaks.curvature, 1.06 * curvature + 0.011) << i;
    EXPECT_LE(peaks.rate, 1.06 * rate + 0.011) << i;
  }
  EXPECT_GT(finite, 200);
}

TEST(SpanBounds, ThereIsNoBoundWhereTheSpeedVanishes) {
  Random random{5};
  for (int i = 0; i < 200; ++i) {
    // x′ has a root inside; y′ is 0, or has the same root.
    const double root = random.uniform(0.05, 0.95), slope = random.uniform(0.5, 3.0),
                 side = i % 2 == 0 ? 0.0 : random.uniform(-1.0, 1.0);
    const double end = slope * (0.5 - root);
    BezierSpan span{2, {Vec2{0, 0}, {-0.5 * slope * root, -0.5 * side * slope * root}, {end, side * end}}};
    EXPECT_TRUE(std::isinf(curvature_peaks(span).curvature)) << root;
    // However often it is halved towards the root.
    CurvatureBounds part{span};
    double low = 0.0, width = 1.0;
    for (int k = 0; k < 60; ++k) {
      EXPECT_TRUE(std::isinf(part.greatest())) << root << ' ' << k;
      CurvatureBounds left, right;
      part.halve(left, right);
      width *= 0.5;
      const bool in_right = root >= low + width;
      part = in_right ? right : left;
      if (in_right) low += width;
    }
  }
}

}  // namespace
}  // namespace waywright
