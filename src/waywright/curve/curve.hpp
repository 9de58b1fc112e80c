// The curves that paths are made of. Each keeps exactly what defines it; samples are only a view.
//
// A curve is followed in its direction of travel: `course` is the angle of its tangent. Which way the vehicle faces on
// it is the path's matter (path/path.hpp).
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <variant>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

/// Straight from one point to another. from ≠ to.
struct Line {
  Vec2 from{};
  Vec2 to{};
};

/// Constant curvature. `start.heading` is the course at the start; curvature in 1/m, left positive (0: straight);
/// length in m, > 0.
struct Arc {
  Pose start{};
  double curvature = 0.0;
  double length = 0.0;
};

/// Curvature that changes evenly with arc length: κ(s) = curvature + curvature_rate·s. `start.heading` is the course at the start; length in m, > 0.
struct Clothoid {
  Pose start{};
  double curvature = 0.0;       ///< 1/m, at the start, left positive
  double curvature_rate = 0.0;  ///< 1/m²
  double length = 0.0;
};

/// Bézier curve of degree 1 to 5 over u in [0, 1]; control[0..degree] are used.
/// Law: the curve lies in the convex hull of its control points; its tangents lie in the cone of their differences.
struct BezierSpan {
  int degree = 3;
  std::array<Vec2, 6> control{};
};

enum class SplineKind {
  natural_cubic,  ///< C² interpolating cubic with natural ends (the published pattern)
  quintic,        ///< quintic with zero curvature at both ends (our pattern)
};

/// As many as a docking pattern's spline has need no memory of their own.
using Spans = boost::container::small_vector<BezierSpan, 3>;

/// A smooth chain of Bézier spans.
struct Spline {
  SplineKind kind = SplineKind::quintic;
  Spans spans;
};

/// Turning on the spot by `angle` (left positive), from vehicle heading `from`.
struct Turn {
  Vec2 at{};
  double from = 0.0;
  double angle = 0.0;
};

/// Poses from outside, joined by straight interpolation of position and (along the shorter arc) of vehicle heading.
struct PoseSequence {
  std::vector<Pose> poses;  ///< vehicle headings, at least 2
};

using Curve = std::variant<Line, Arc, Clothoid, Spline, Turn, PoseSequence>;

/// Position, course, curvature and dκ/ds at one place of a curve.
struct CurvePoint {
  Vec2 position{};
  double course = 0.0;
  double curvature = 0.0;       ///< 1/m
  double curvature_rate = 0.0;  ///< dκ/ds, 1/m²
};

}  // namespace waywright
