// A scenario's zones made ready for questions. (Forbidden ones are obstacles of the problem's World.)
#pragma once

#include <string>
#include <vector>

#include "waywright/geometry/box_table.hpp"
#include "waywright/map/world.hpp"
#include "waywright/scenario/zone.hpp"

namespace waywright {

/// What a plan may differ from the rule of a directed zone: an origin no deeper inside than this is not inside, and 90° are meant up to this.
inline constexpr double zone_depth = 1e-3;   ///< m
inline constexpr double zone_course = 1e-3;  ///< rad

/// Immutable; safe to read from many threads.
class ZoneRules {
 public:
  ZoneRules() = default;
  explicit ZoneRules(const std::vector<Zone>& zones);

  bool directs() const { return !directed_.empty(); }
  bool weighs() const { return !weighed_.empty(); }
  bool limits_speed() const { return !limits_.empty(); }

  /// Nothing on the map costs less than this a metre, or more than that: factors of zones that overlap multiply, bounded to least_product and most_product.
  double least_factor() const { return least_factor_; }
  double most_factor() const { return most_factor_; }
  static constexpr double least_product = 1e-4, most_product = 1e6;

  /// What a metre costs at a point. A point within a micrometre of a zone's outline is outside of it.
  double factor_at(Vec2 point) const;
  /// What the straight way costs, m: each part of it by the zones that it lies in, cut exactly where it crosses their outlines.
  double cost(Vec2 from, Vec2 to) const;
  /// Does the straight way break no directed zone's rule? By a hundredth stricter than the judge, so that rounding decides nothing.
  bool may_be_driven(Vec2 from, Vec2 to) const;
  static constexpr double planned_depth = 0.99 * zone_depth, planned_course = 0.99 * zone_course;

  struct Directed {
    std::string title;
    Ring area;
    Box box;
    double direction = 0.0;
    Vec2 along{};  ///< the same as a unit vector
    /// Is a course, a vector of any length > 0, more than 90° (and `more` rad) off?
    bool is_against(Vec2 course, double more) const { return dot(course, along) < -more * norm(course); }
  };
  const std::vector<Directed>& directed() const { return directed_; }

  struct Weighed {
    Ring area;
    Box box;
    double factor = 1.0;
  };
  const std::vector<Weighed>& weighed() const { return weighed_; }

  struct SpeedLimit {
    std::string title;
    World area;  ///< solid
    Box box;
    double speed = 0.0;  ///< m/s
  };
  const std::vector<SpeedLimit>& limits() const { return limits_; }

 private:
  std::vector<Directed> directed_;
  std::vector<Weighed> weighed_;
  BoxTable directed_near_, weighed_near_;  ///< where there are hundreds of zones (lanes of a plant), few are near a way
  std::vector<SpeedLimit> limits_;
  double least_factor_ = 1.0, most_factor_ = 1.0;
};

/// Do two boxes have a point in common, the first one grown by `by`?
inline bool meet(const Box& a, const Box& b, double by = 0.0) {
  return a.low.x - by <= b.high.x && b.low.x <= a.high.x + by && a.low.y - by <= b.high.y && b.low.y <= a.high.y + by;
}

}  // namespace waywright
