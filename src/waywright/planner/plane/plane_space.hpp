// A disc among a problem's obstacles: what planners in the plane see of it. The disc is the vehicle's footprint, or the one around it, which can turn wherever it can
// stand, so that a straight line is free or not whatever the heading.
#pragma once

#include <algorithm>

#include "waywright/map/clearance_field.hpp"
#include "waywright/planner/plane/clearance_tiles.hpp"
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
  double at_least(Vec2 point) const { return std::max(0.0, table_.at(point)); }

  /// m that the table is sure of beyond what is needed: as far as that from the point all is free. Not positive where it does not tell.
  double room(Vec2 point) const { return table_.at(point) - needed_; }
  /// What is_free(from, to) is, told at once where the rooms of both ends cover the line. @pre `length` is that of the line, the rooms are those of its ends
  bool is_free(Vec2 from, Vec2 to, double length, double room_from, double room_to) const {
    return room_from + room_to > length || is_free_between(from, to, length, room_from, room_to, needed_, nullptr);
  }
  /// What is learnt of a line beside whether it is free.
  struct Line {
    double hit = -1.0;     ///< m from its beginning to where it is surely blocked; negative where that is not known
    double blocked = 0.0;  ///< m: all that is as near as that to there is
    double around = 0.0;  ///< m: lines from its beginning to places that are nearer to its end than that are free, too
  };
  bool is_free(Vec2 from, Vec2 to, double length, double room_from, double room_to, Line& line) const {
    if (!(room_from + room_to > length)) return is_free_between(from, to, length, room_from, room_to, needed_, &line);
    line.around = std::min({0.5 * (room_from + room_to - length), room_from, room_to});  // both discs reach so far beyond where they meet
    return true;
  }
  double table_cell() const { return field_.cell(); }  ///< m
  /// The table is sure that no place within `off` (m) of the point is free. @pre off ≥ 0
  bool is_surely_blocked(Vec2 point, double off) const { return blocked_around(point) >= off; }
  /// m, the greatest such; negative where the table does not tell.
  double blocked_around(Vec2 point) const { return blocked_around(table_.at(point), needed_); }

 private:
  double blocked_around(double known, double margin) const { return known >= 0.0 ? std::min(margin, table_reach_) - known - slack_ : ClearanceTiles::depth(known); }
  bool is_free_between(Vec2 from, Vec2 to, double length, double room_from, double room_to, double margin, Line* line) const;
  bool keeps(Vec2 from, Vec2 to, double margin, bool is_outside) const;  ///< asked of the exact outlines alone; `is_outside`: `from` is in nothing solid, that is known

  const Problem& problem_;
  double disc_;
  double needed_;
  Box region_{};
  ClearanceField field_;
  ClearanceTiles table_;  ///< the same, for look-ups
  double slack_ = 0.0;    ///< m: of the table, see ClearanceField::slack
  double table_reach_ = 0.0;  ///< m: values up to this tell how near something is, too
  double free_area_ = 0.0;
};

}  // namespace waywright
