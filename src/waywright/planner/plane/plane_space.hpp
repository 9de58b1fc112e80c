// A disc among a problem's obstacles: what planners in the plane see of it. The disc is the vehicle's footprint, or the one around it, which can turn wherever it can
// stand, so that a straight line is free or not whatever the heading.
#pragma once

#include "waywright/map/clearance_field.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Immutable once made; safe to read from many threads. The problem outlives it.
///
/// Law: a line that is called free keeps more than `needed()` between its every point and everything that is blocked; one that is not comes as near as that, up to
/// rounding. (A table of bounds settles most of it, the exact outlines the rest.)
class PlaneSpace {
 public:
  explicit PlaneSpace(const Problem& problem);

  const Problem& problem() const { return problem_; }
  double disc() const { return disc_; }      ///< m, radius of the disc
  double needed() const { return needed_; }  ///< m, that its middle keeps from everything: the disc, what is required, and twice the proof's tolerance
  /// Where a shortest way of the disc can be: within what bounds the world, or around all that is known.
  const Box& region() const { return region_; }
  /// m², no less than what of the region is free for the disc's middle.
  double free_area() const { return free_area_; }

  bool is_free(Vec2 point) const { return is_free(point, needed_); }
  bool is_free(Vec2 from, Vec2 to) const { return is_free(from, to, needed_); }
  /// The same of another distance to be kept. @pre margin ≥ 0
  bool is_free(Vec2 point, double margin) const;
  bool is_free(Vec2 from, Vec2 to, double margin) const;
  /// False where no way of the disc's middle that keeps what is needed joins both places, told by the cells of the table alone: gaps that are too narrow by less than some
  /// cells count as open.
  bool may_join(Vec2 from, Vec2 to) const;
  /// No obstacle is nearer to the point than this, m; 0 where nothing is known.
  double at_least(Vec2 point) const { return std::max(0.0, static_cast<double>(field_.at(point))); }

 private:
  bool keeps(Vec2 from, Vec2 to, double margin) const;  ///< asked of the exact outlines alone

  const Problem& problem_;
  double disc_;
  double needed_;
  Box region_{};
  ClearanceField field_;
  double table_reach_ = 0.0;  ///< m: values up to this tell how near something is, too
  double free_area_ = 0.0;
};

}  // namespace waywright
