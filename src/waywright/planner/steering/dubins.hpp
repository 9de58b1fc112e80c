// Dubins curves: the shortest ways of a car with one least turning radius that drives forwards alone.
//
// Source: L. E. Dubins: On curves of minimal length with a constraint on average curvature, and with prescribed
// initial and terminal positions and tangents, American Journal of Mathematics 79 (1957).
#pragma once

#include <array>

#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {

/// A shortest word: up to three turns or straight parts, each driven forwards.
struct DubinsWord {
  std::array<TurningPart, 3> parts{};  ///< every length ≥ 0
  std::size_t count = 0;
  double length = 0.0;                 ///< Σ length of parts, in radii
};

/// Curves of one turning radius, from the elementary functions of core/: the same bits on every processor.
///
/// Laws: the pieces start at `from` and end within 2e-9 radii and 1e-9 rad of `to`; their lengths add up to distance(from, to)
/// up to 1e-9 m; every curvature is exactly 0 or ±1/radius, every direction forwards; never shorter than
/// the Reeds–Shepp curve; both poses mirrored, or exchanged and turned about, keep the length. No metric: the way back is
/// another one.
class Dubins {
 public:
  /// @pre radius > 0, m
  explicit Dubins(double radius) : radius_{radius} {}

  double radius() const { return radius_; }
  DubinsWord shortest(const Pose& from, const Pose& to) const;
  /// Lines and arcs, neighbours on one line or circle merged; empty where the poses are the same.
  Pieces between(const Pose& from, const Pose& to) const;
  /// m
  double distance(const Pose& from, const Pose& to) const { return radius_ * shortest(from, to).length; }

 private:
  double radius_;
};

}  // namespace waywright
