// The footprint swept along a short motion, asked of the world: what a search asks where the clearance field leaves a motion open.
#pragma once

#include <span>
#include <vector>

#include "waywright/curve/curve.hpp"
#include "waywright/planner/docking/pattern.hpp"
#include "waywright/planner/docking/prepared.hpp"

namespace waywright {

/// A quintic as a motion of the vehicle.
struct SweptQuintic {
  struct State {
    Vec2 position{};
    Vec2 heading{1.0, 0.0};   ///< unit
    Vec2 acceleration{};      ///< d²p/du²
    double turn_rate = 0.0;   ///< dθ/du
  };
  const BezierSpan& span;
  int direction = 1;
  State at(double u) const;
};

/// Hulls of the footprint's convex parts at both ends of a stretch hold every pose between, but for a bow that shrinks with the square of
/// the stretch and is allowed for here from the curve's derivatives at both ends. (The proof bounds it rigorously.) Reuses its
/// memory.
class Sweep {
 public:
  explicit Sweep(const PreparedDocking& prepared);

  /// True where the footprint keeps more than `margin` from everything for u in [u0, u1]: asked of both halves of the stretch, which are halved
  /// a few times before it says no.
  bool is_clear(const SweptQuintic& quintic, double u0, double u1, double margin);
  /// The same for a straight motion with one heading (a unit vector).
  bool is_clear(Vec2 from, Vec2 to, Vec2 heading, double margin);

  /// True where the footprint at a pose keeps more than `margin` from everything.
  bool is_free(const Placement& pose, double margin);
  /// A sufficient test for a short motion between two poses that leaves their straight interpolation by at most `bow`: every obstacle lies
  /// beyond a line that is `margin` + `bow` away from the footprint's convex parts at both ends.
  bool is_surely_clear(const Placement& a, const Placement& b, double margin, double bow) const;

 private:
  using State = SweptQuintic::State;
  bool between(const SweptQuintic& quintic, double u0, const State& a, double u1, const State& b, double margin, int halvings);
  bool both_halves(const SweptQuintic& quintic, double u0, const State& a, double u1, const State& b, double margin, int halvings);
  bool all_beyond(std::span<const Vec2> corners, std::size_t n, double away) const;
  bool hulls_are_clear(const State& a, const State& b, double margin);

  const PreparedDocking& prepared_;
  std::vector<Vec2> corners_;
  Ring hull_;
};

}  // namespace waywright
