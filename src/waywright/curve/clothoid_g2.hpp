// The G2 Hermite problem by three clothoids.
#pragma once

#include <array>
#include <optional>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// A pose (its heading a course) with the curvature that a curve has there, 1/m.
struct CurvaturePose {
  Pose pose{};
  double curvature = 0.0;
};

using ClothoidTriple = std::array<Clothoid, 3>;

/// Three clothoids from one pose and curvature to another, joined with continuous course and curvature; the outer ones take a quarter of the length
/// each. Of the solutions the one near the single clothoid that joins the poses (the idea of Bertolazzi and Frego, On the G2 Hermite
/// interpolation problem with clothoids, J. Comput. Appl. Math. 341 (2018); here the lengths have fixed shares and two curvatures are free).
/// nullopt where Newton's method finds none. Its end misses `to` by less than 1e-10 of the length.
std::optional<ClothoidTriple> fit_clothoids(const CurvaturePose& from, const CurvaturePose& to);

}  // namespace waywright
