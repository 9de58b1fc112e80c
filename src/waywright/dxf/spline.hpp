// B-splines of a drawing as chords whose distance from the curve is bounded.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright::dxf {

/// A NURBS curve as a SPLINE entity holds it.
struct SplineCurve {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec2> controls;
  std::vector<double> weights;  ///< empty: all 1
};

/// Corners on the curve; the curve is nowhere farther than `tolerance` from the chords, nor the chords from it (each Bézier part lies in
/// the hull of its control points, which is what is measured). Or what is wrong with the spline.
std::variant<std::vector<Vec2>, std::string> chords(const SplineCurve& curve, double tolerance);

}  // namespace waywright::dxf
