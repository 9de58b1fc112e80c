// Corners of obstacles that a taut way of a disc may bend around.
#pragma once

#include <optional>
#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Around a corner the disc's middle moves on an arc about it. Which arc is told by the directions from the corner to its ends.
struct Corner {
  Vec2 at{};
  Vec2 first{}, last{};    ///< of length 1; the arc goes counter-clockwise from one to the other, by π at most
  bool is_point = false;   ///< of nothing else: the whole circle
  bool is_open = false;    ///< all of its arc is free

  /// Does its arc hold this direction (of length 1)?
  bool holds(Vec2 direction) const;
};

/// Which way tests of arcs err: what is called free is (for ways), or what is not is not (for lower bounds).
enum class Rounding { safe, optimistic };

/// All corners whose arcs of `radius` are free somewhere, by what is farther than `margin` from everything. Those of obstacles' insides, hidden under others, and of
/// the boundary's outside are left out. In an order that depends on the map alone.
std::vector<Corner> corners_of(const PlaneSpace& space, double radius, double margin, Rounding rounding);

/// Is an arc about a point free, from direction `from`, `angle` rad on (counter-clockwise positive)? Told by chords. Safe: what is called free keeps `margin`, and is
/// called so where it keeps half of what `radius` is beyond `margin` more; optimistic: what is not called free does not keep `margin`.
bool is_arc_free(const PlaneSpace& space, Vec2 center, double radius, Vec2 from, double angle, double margin, Rounding rounding);

}  // namespace waywright
