// A leaf of a tree of stars drawn in onto the piece that it grows from, with the free space about it: one step of the way from trees of stars to stars.
//
// Source of the idea: E. Rimon, D. E. Koditschek: Exact robot navigation using artificial potential functions, IEEE T-RA 8 (1992), §VI, who draw leaves in by analytic
// switches. This form is ours: it cannot fold, whatever its parameters, and moves nothing but what is next to the leaf.
#pragma once

#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Where a map takes a place, with its Jacobian: ∂x'/∂x, ∂x'/∂y, ∂y'/∂x, ∂y'/∂y.
struct PlaneImage {
  Vec2 at{};
  double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
  double determinant() const { return xx * yy - xy * yx; }
};

/// The leaf is a convex polygon of which the edge from a to b is the cut that it is drawn in to. Lines that all meet in one point (or are parallel) lead from the cut through
/// the leaf: that through a at x = slope_a·h and that through b at x = ℓ + slope_b·h, with x along the cut, h off it into the leaf, ℓ its length. With Δ = slope_b − slope_a
/// each line has its s = (x − h·slope_a)/(ℓ + h·Δ) in [0, 1]; with η = h·ℓ/(ℓ + h·Δ) straight lines stay straight, so that the leaf is what lies under a concave line of edges
/// η = ρ(s) with ρ(0) = ρ(1) = 0. On each line, which leaves the leaf at H(s) = ρℓ/(ℓ − ρΔ), the collar H ≤ h ≤ (1 + collar)·H is stretched onto 0 ≤ h ≤ (1 + collar)·H.
///
/// Laws: the identity beyond the collar; one to one and without folds (det J = (1 + 1/collar)·(ℓ + h'Δ)/(ℓ + hΔ) > 0) on all but the leaf's inside; the leaf's rim goes to
/// the cut.
class LeafPurge {
 public:
  /// Empty where the lines do not lead through the leaf: they meet in it, or leave it more than once.
  /// @pre leaf convex, counter-clockwise; its edge from leaf[0] to leaf[1] is the cut
  static std::optional<LeafPurge> of(const Ring& leaf, double slope_a, double slope_b);

  /// How much farther than the rim, as its share, the lines can be followed: to where they meet; infinite where they do not.
  double reach() const;
  /// No more than the least h/H(s) on a segment, and hardly less; infinite where it is beside the lines.
  double nearest(Vec2 from, Vec2 to) const;
  void set_collar(double collar) { collar_ = collar; }
  double collar() const { return collar_; }
  /// How much the map shears next to the leaf's rim, at most: ‖J‖²/det J, 2 where it does not.
  double shear() const;

  PlaneImage at(Vec2 q) const;
  /// The place that is taken there.
  Vec2 back(Vec2 q) const;
  /// In the leaf or on its rim or on the cut, which is within what is blocked before it is drawn in.
  bool holds(Vec2 q) const { return contains(leaf_, q); }
  const Ring& leaf() const { return leaf_; }

 private:
  LeafPurge() = default;
  struct Local {
    double x = 0.0, h = 0.0;
  };
  Local local(Vec2 q) const { return {dot(q - leaf_[0], along_), cross(along_, q - leaf_[0])}; }
  /// The edge of the rim over s, its index. @pre 0 ≤ s ≤ 1
  std::size_t edge_at(double s) const;
  double rim_at(double s) const;
  double height(double eta) const { return eta * length_ / (length_ - eta * spread_); }  ///< h

  Ring leaf_;
  Vec2 along_{};
  double length_ = 0.0, slope_ = 0.0, spread_ = 0.0;  ///< ℓ, slope_a, Δ
  std::vector<double> s_, rim_;                       ///< corners of the rim, from a to b
  double collar_ = 1.0;
};

}  // namespace waywright
