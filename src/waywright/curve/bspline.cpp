#include "waywright/curve/bspline.hpp"

#include <algorithm>
#include <array>

namespace waywright {
namespace {

/// The polar form of the cubic between knots k and k + 1 (Ramshaw 1987): a Bézier point is its value where all but some arguments are the lower end.
/// `d`: control points k … k + 3.
Vec2 polar(std::array<Vec2, 4> d, double k, double last, const std::array<double, 3>& at) {
  const auto knot = [&](int i) { return std::clamp(k + static_cast<double>(i), 0.0, last); };  // i knots after the lower end
  for (int level = 1; level <= 3; ++level) {
    const double u = at[static_cast<std::size_t>(level - 1)];
    for (int j = 3; j >= level; --j) {
      const double low = knot(j - 3), high = knot(j + 1 - level);
      const double share = (u - low) / (high - low);
      d[static_cast<std::size_t>(j)] = d[static_cast<std::size_t>(j - 1)] + share * (d[static_cast<std::size_t>(j)] - d[static_cast<std::size_t>(j - 1)]);
    }
  }
  return d[3];
}

}  // namespace

Spans bspline_spans(std::span<const Vec2> points) {
  const std::size_t count = points.size() - 3;
  const auto last = static_cast<double>(count);
  Spans spans;
  for (std::size_t k = 0; k < count; ++k) {
    const std::array<Vec2, 4> d{points[k], points[k + 1], points[k + 2], points[k + 3]};
    const auto a = static_cast<double>(k), b = a + 1.0;
    BezierSpan span{3, {polar(d, a, last, {a, a, a}), polar(d, a, last, {a, a, b}), polar(d, a, last, {a, b, b}), polar(d, a, last, {b, b, b})}};
    // Neighbours share their ends, and the whole curve the control points', bit for bit.
    if (!spans.empty()) span.control[0] = spans.back().control[3];
    if (k == 0) span.control[0] = points.front();
    if (k + 1 == count) span.control[3] = points.back();
    spans.push_back(span);
  }
  return spans;
}

}  // namespace waywright
