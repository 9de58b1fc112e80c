#include "waywright/curve/bspline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

/// The sum of control points with the basis functions of Cox and de Boor, by their recursion: shares nothing with the spans.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) return (u >= knots[i] && u < knots[i + 1]) || (u == knots.back() && knots[i] < u && knots[i + 1] == u) ? 1.0 : 0.0;
  const auto d = static_cast<std::size_t>(degree);
  double sum = 0.0;
  if (knots[i + d] > knots[i]) sum += (u - knots[i]) / (knots[i + d] - knots[i]) * basis(knots, i, degree - 1, u);
  if (knots[i + d + 1] > knots[i + 1]) sum += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * basis(knots, i + 1, degree - 1, u);
  return sum;
}

Vec2 by_basis(const std::vector<Vec2>& points, double u) {
  const std::size_t last = points.size() - 3;
  std::vector<double> knots(3, 0.0);
  for (std::size_t k = 0; k <= last; ++k) knots.push_back(static_cast<double>(k));
  knots.insert(knots.end(), 3, static_cast<double>(last));
  Vec2 sum{};
  for (std::size_t i = 0; i < points.size(); ++i) sum = sum + basis(knots, i, 3, u) * points[i];
  return sum;
}

TEST(BSpline, SpansAreTheCurveOfItsBasis) {
  Random random{5};
  for (std::size_t n = 4; n <= 14; ++n) {
    for (int k = 0; k < 20; ++k) {
      std::vector<Vec2> points;
      for (std::size_t i = 0; i < n; ++i) points.push_back({random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0)});
      const Spans spans = bspline_spans(points);
      ASSERT_EQ(spans.size(), n - 3);
      EXPECT_EQ(spans.front().control[0], points.front());
      EXPECT_EQ(spans.back().control[3], points.back());
      for (std::size_t s = 0; s < spans.size(); ++s) {
        for (double u = 0.0; u <= 1.0; u += 0.125) {
          EXPECT_LT(distance(derivatives(spans[s], u).p, by_basis(points, static_cast<double>(s) + u)), 1e-12 * 100.0) << n << " " << s << " " << u;
        }
        if (s == 0) continue;
        // C²: of spans of the same length in the parameter, the first two derivatives.
        const Derivatives before = derivatives(spans[s - 1], 1.0), after = derivatives(spans[s], 0.0);
        EXPECT_EQ(spans[s - 1].control[3], spans[s].control[0]);
        EXPECT_LT(norm(before.d1 - after.d1), 1e-11);
        EXPECT_LT(norm(before.d2 - after.d2), 1e-10);
      }
    }
  }
}

TEST(BSpline, EndsPointAtTheirNeighbours) {
  const std::vector<Vec2> points{{0, 0}, {1, 2}, {4, 3}, {6, -1}, {8, 0}, {9, 5}};
  const Spans spans = bspline_spans(points);
  EXPECT_NEAR(cross(derivatives(spans.front(), 0.0).d1, points[1] - points[0]), 0.0, 1e-12);
  EXPECT_NEAR(cross(derivatives(spans.back(), 1.0).d1, points[5] - points[4]), 0.0, 1e-12);
  // Of four points it is their Bézier curve.
  const Spans one = bspline_spans(std::span{points}.first(4));
  ASSERT_EQ(one.size(), 1U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(distance(one[0].control[i], points[i]), 1e-14);
}

}  // namespace
}  // namespace waywright
