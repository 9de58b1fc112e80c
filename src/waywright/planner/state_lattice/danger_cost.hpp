// What a motion costs: its length, more where the footprint is near to something; and whether it is free.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "waywright/map/clearance_along.hpp"
#include "waywright/planner/state_lattice/stretch.hpp"
#include "waywright/proof/collision.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// A metre costs k · (1 + bend · κ²) · (1 + weight · (1 − (c − r) / range)²): κ is the curvature there, c the exact clearance of the whole footprint and r what is
/// required of it; from r + range on there is no danger.
struct DangerCosts {
  double weight = 4.0;
  double range = 0.6;    ///< m, > 0
  double forward = 1.0;  ///< times as much for a metre forwards as it is planned, ≥ 1
  double reverse = 2.0;  ///< and backwards
  double bend = 0.0;     ///< m², ≥ 0
  double change = 1.0;   ///< m that a change of direction counts as
  double turn = 0.3;     ///< m that a radian on the spot counts as

  double each(int direction) const { return direction < 0 ? reverse : forward; }
  /// What a stretch counts as where nothing is near, m.
  double metres_of(const LatticeStretch& stretch) const {
    return stretch.direction == 0 ? turn * std::abs(stretch.turn.angle) : each(stretch.direction) * (length_of(stretch) + bend * bend_of(stretch));
  }
  /// Of a metre. @param beyond what is required, m
  double density(double beyond) const {
    if (beyond >= range) return 1.0;
    const double x = beyond > 0.0 ? 1.0 - beyond / range : 1.0;
    return 1.0 + weight * x * x;
  }
  /// ∫ of density over `length` m that begin `beyond` away and lead straight away from it: no way costs less whose origin is no farther.
  double away(double beyond, double length) const;
};

/// A pose of a motion from the origin, with what comes of the way to it.
struct CostedPose {
  Vec2 offset{};         ///< m, in world axes
  Vec2 course{};         ///< direction of travel, a unit vector in world axes; (0, 0) where it turns on the spot
  double heading = 0.0;  ///< of the vehicle, rad, world
  double way = 0.0;      ///< m of the origin from the one before
  double metres = 0.0;   ///< what the way from the one before counts as where nothing is near
  double sweep = 0.0;    ///< m, no point of the footprint moves farther on that way
};

/// For one thread.
class MotionCost {
 public:
  /// @pre the problem outlives this
  MotionCost(const Problem& problem, const DangerCosts& costs, double margin);

  const DangerCosts& costs() const { return costs_; }
  /// m, kept at least from everything
  double margin() const { return margin_; }
  /// m, of the footprint
  double radius() const { return body_.radius; }
  /// m, a clearance from which on nothing costs more
  double no_danger_from() const { return std::max(margin_, required_ + costs_.range); }

  std::vector<CostedPose> poses_of(const LatticeStretch& stretch, double step) const;

  /// Of a stretch it is no less than this, m.
  double at_least(const LatticeStretch& stretch) const { return stretch.direction == 0 ? costs_.metres_of(stretch) : least_factor() * costs_.metres_of(stretch); }
  /// A metre in any zone counts as no less.
  double least_factor() const { return std::min(1.0, zones_.least_factor()); }
  /// Zones that weigh ways, or tell their direction.
  bool heeds_zones() const { return zones_.weighs() || zones_.directs(); }

  /// Does a zone that is heeded come near to what lies within `reach` m of a place?
  bool zones_near(Vec2 place, double reach) const;

  /// Cost by the trapezoidal rule over the poses, moved by `at`, weighed by the zones that it leads through; empty where the motion is not free, or goes against the direction of a
  /// zone. `is_free_between` is asked where the poses do not tell whether what lies between them keeps the margin.
  template <class Exact>
  std::optional<double> of(std::span<const CostedPose> poses, Vec2 at, Exact&& is_free_between) {
    double sum = 0.0, before = 0.0, cost_before = 0.0;
    bool is_open = false;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const CostedPose& p = poses[i];
      const double clearance = along_.at(make_pose(at + p.offset, p.heading));
      if (!(clearance > margin_)) return std::nullopt;
      const double cost = costs_.density(clearance - required_);
      if (i > 0) {
        double metres = p.metres;
        if (heeds_zones() && zones_near(at + p.offset, p.way)) {
          const auto factor = zone_factor(poses[i - 1], p, at);
          if (!factor) return std::nullopt;
          metres *= *factor;
        }
        sum += 0.5 * metres * (cost_before + cost);
        is_open = is_open || 0.5 * (before + clearance - p.sweep) <= margin_;
      }
      before = clearance;
      cost_before = cost;
    }
    if (is_open && !is_free_between()) return std::nullopt;
    return sum;
  }
  /// Of a stretch in the world, with poses at most `step` m apart.
  std::optional<double> of(const LatticeStretch& stretch, double step);
  /// Proven with the motion's own bounds.
  bool is_free(const LatticeStretch& stretch);

 private:
  /// What the way between two poses counts more or less; empty where it goes against a zone's direction.
  std::optional<double> zone_factor(const CostedPose& from, const CostedPose& to, Vec2 at) const;

  const Problem& problem_;
  const ZoneRules& zones_;
  DangerCosts costs_;
  double required_, margin_;
  SweptBody body_;
  SweepMemory memory_;
  Motion motion_;
  ClearanceAlong along_;
};

/// rad between poses that are looked at.
inline constexpr double look_angle = 0.1;

}  // namespace waywright
