// Of two poses the one that a motion between them is computed from, so that the way back is the way there, driven the other way.
#pragma once

#include <cmath>

#include "waywright/core/pose.hpp"

namespace waywright {

/// Told from where each has the other, which no motion of the whole changes; only of pairs that look the same from both sides (within 1e-9) by their coordinates. For any two
/// poses that differ true in exactly one order.
inline bool comes_first(const Pose& a, const Pose& b) {
  constexpr double same = 1e-9;  // m, rad
  const Vec2 there = Frame{a}.to_local(b.position()), back = Frame{b}.to_local(a.position());
  if (std::abs(there.x - back.x) > same) return there.x < back.x;
  if (std::abs(there.y - back.y) > same) return there.y < back.y;
  const double turn = shorter_turn(a.heading, b.heading);
  if (std::abs(turn) > same && std::abs(turn) < pi - same) return turn < 0.0;
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.heading <= b.heading;
}

}  // namespace waywright
