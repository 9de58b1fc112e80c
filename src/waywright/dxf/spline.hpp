// B-splines of a drawing as chords whose distance from the curve is bounded.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "waywright/core/pose.hpp"
#include "waywright/dxf/outline.hpp"

namespace waywright::dxf {

/// A NURBS curve as a SPLINE entity holds it.
struct SplineCurve {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec2> controls;
  std::vector<double> weights;  ///< empty: all 1
};

/// Pieces of the curve, each within the hull of its knots; its control points are no farther than `tolerance` from its chord and, but at cusps, follow
/// each other along it. Or what is wrong with the spline.
std::variant<Chain, std::string> pieces(const SplineCurve& curve, double tolerance);

/// The pieces' corners alone: on the curve; the curve is nowhere farther than `tolerance` from the chords, nor the chords from it (each Bézier part lies in
/// the hull of its control points, which is what is measured). Or what is wrong with the spline.
std::variant<std::vector<Vec2>, std::string> chords(const SplineCurve& curve, double tolerance);

}  // namespace waywright::dxf
