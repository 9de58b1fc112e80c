// Star-shaped polygons: from where all of one is seen, and how far its rim is in each direction.
#pragma once

#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// The places of a polygon from which all of it is seen: convex; empty where there is none (the polygon is not star-shaped) or less than a hair of one.
/// @pre simple, counter-clockwise
Ring kernel_of(const Ring& ring);

/// The same without that hair being looked for, cheaply: what is left may be a line or a point.
Ring places_that_see_all(const Ring& ring);

/// The middle of the largest circle in a convex polygon, and its radius (Chebyshev centre). @pre convex, counter-clockwise, of positive area
struct InnerCircle {
  Vec2 centre{};
  double radius = 0.0;
};
InnerCircle largest_circle_in(const Ring& convex);

/// A number and its derivatives by x and y.
struct Dual {
  double value = 0.0, dx = 0.0, dy = 0.0;
};
Dual operator+(const Dual& a, const Dual& b);
Dual operator-(const Dual& a, const Dual& b);
Dual operator*(const Dual& a, const Dual& b);
Dual operator/(const Dual& a, const Dual& b);
Dual square_root(const Dual& a);
inline Dual constant(double value) { return {value, 0.0, 0.0}; }

/// A polygon that is seen whole from a centre, grown by a distance (rounded at its corners) or, as a boundary, what is left within it by that distance.
///
/// Law: a place is blocked by the grown polygon, or beyond the shrunk boundary as it is seen from the centre, where it is farther out than the rim in its direction is
/// not: for obstacles nearer, for boundaries farther.
class Star {
 public:
  /// @pre the centre is in the ring's kernel; distance ≥ 0; for a boundary the centre is farther than that from its edges
  Star(Ring ring, Vec2 centre, double distance, bool is_boundary);

  Vec2 centre() const { return centre_; }
  /// m, from the centre to the rim on the way through q, with its derivatives by q. @pre q ≠ centre
  Dual rim(Vec2 q) const;
  /// m; the least and greatest of it.
  double least_rim() const { return least_; }
  double greatest_rim() const { return greatest_; }

 private:
  Ring ring_;
  Vec2 centre_;
  double distance_;
  bool is_boundary_;
  double least_ = 0.0, greatest_ = 0.0;
};

}  // namespace waywright
