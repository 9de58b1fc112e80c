// Reeds–Shepp curves: the shortest ways of a car with one least turning radius that drives forwards and
// backwards.
//
// Source: J. A. Reeds, L. A. Shepp: Optimal paths for a car that goes both forwards and backwards, Pacific
// Journal of Mathematics 145 (1990), formulas 8.1–8.11 and their symmetries.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

/// A turn on the circle to one side, or a straight part.
struct TurningPart {
  int side = 0;         ///< 1 left, −1 right, 0 straight
  double length = 0.0;  ///< in radii, rad of turning where side ≠ 0; negative: backwards
};

/// A shortest word: up to five parts, each a turn with a signed length.
struct ReedsSheppWord {
  using Part = TurningPart;
  std::array<Part, 5> parts{};
  std::size_t count = 0;
  double length = 0.0;  ///< Σ|length of parts|, in radii
};

/// Curves of one turning radius. Additions, multiplications, divisions, square roots and the elementary
/// functions of core/ alone: the same bits on every processor.
///
/// Laws: the pieces start at `from` and end within 1e-9 (m, rad) of `to` for radii up to some metres, each
/// begins where the one before ends; their lengths add up to distance(from, to) up to 1e-9 m; every curvature
/// is exactly 0 or ±1/radius; exchanging both ends keeps the length; distance is a metric up to rounding.
class ReedsShepp {
 public:
  /// @pre radius > 0, m
  explicit ReedsShepp(double radius) : radius_{radius} {}

  double radius() const { return radius_; }
  /// Among words of one length (up to 1e-11 radii) one with few parts.
  ReedsSheppWord shortest(const Pose& from, const Pose& to) const;
  /// Lines and arcs with their directions, neighbours on one line or circle merged; empty where the poses are
  /// the same.
  Pieces between(const Pose& from, const Pose& to) const;
  /// m
  double distance(const Pose& from, const Pose& to) const { return radius_ * shortest(from, to).length; }
  /// The distance where it is no more than `limit`, m; else that or +∞. Sooner told.
  double distance_under(const Pose& from, const Pose& to, double limit) const;

 private:
  double radius_;
};

/// The lines and arcs of parts driven one after the other, neighbours on one line or circle merged.
Pieces turning_pieces(const Pose& from, std::span<const TurningPart> parts, double radius);

/// Appends a line or an arc; where it goes on on the last one's line or circle in the same direction, both
/// become one piece.
/// @pre `piece` begins where `pieces` end
void append_merged(Pieces& pieces, const Piece& piece);

/// The part of a path of lines and arcs from `begin` to `end` metres after its start. Parts under 1e-9 m are
/// left out.
Pieces part_of(const Pieces& pieces, double begin, double end);

/// The vehicle's pose `s` metres after the start. @pre lines and arcs alone, at least one
Pose pose_at(const Pieces& pieces, double s);

}  // namespace waywright
