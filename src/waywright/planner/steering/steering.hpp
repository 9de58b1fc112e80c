// Local motions between two states, for planners that search among states: what a motion costs, what it is made of, where one is on
// it. Whether it is free says MotionTest.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/planner/steering/arc_motion.hpp"

namespace waywright {

enum class SteeringKind {
  plane,        ///< straight lines of a disc, turning at corners
  turns,        ///< turn on the spot, drive straight, turn on the spot
  dubins,       ///< Dubins curves, forwards
  reeds_shepp,  ///< Reeds–Shepp curves
};

inline constexpr SteeringKind steering_kinds[] = {SteeringKind::plane, SteeringKind::turns, SteeringKind::dubins, SteeringKind::reeds_shepp};

std::string_view to_string(SteeringKind kind);

/// A state with the unit vector of its heading, for bounds that are asked for of many.
struct Facing {
  Pose pose{};
  Vec2 along{1.0, 0.0};

  Facing() = default;
  explicit Facing(const Pose& p) : pose{p}, along{unit(p.heading)} {}
};

/// Immutable; safe to use from many threads.
///
/// Laws: distance(a, b) is Σ cost of the pieces between(a, b), up to rounding, and no less than the straight distance of the positions;
/// at(a, b, 0) = a, at(a, b, 1) = b.
class Steering {
 public:
  virtual ~Steering() = default;

  virtual SteeringKind kind() const = 0;
  /// What a motion costs: its length, m, and what turning on the spot counts as.
  virtual double distance(const Pose& from, const Pose& to) const = 0;
  /// No chain of motions between them costs less: the distance itself, but where turns on the spot are cheaper in other ways.
  virtual double least(const Pose& from, const Pose& to) const { return distance(from, to); }
  /// The distance where it is no more than `limit`; else that or +∞.
  virtual double distance_under(const Pose& from, const Pose& to, double /*limit*/) const { return distance(from, to); }
  /// No motion between them costs less, up to rounding: a bound told without making the motion.
  virtual double bound(const Facing& from, const Facing& to) const { return waywright::distance(from.pose.position(), to.pose.position()); }
  /// In order; empty where the states are the same. Of the plane one line, whose corners are no turns.
  virtual Pieces between(const Pose& from, const Pose& to) const = 0;
  virtual double cost(const Piece& piece) const { return length(piece); }
  /// The state after the share t in [0, 1] of the motion's cost.
  virtual Pose at(const Pose& from, const Pose& to, double t) const = 0;
  /// The motion back is the same one driven the other way.
  virtual bool is_symmetric() const { return true; }
  /// "Reeds-Shepp curves of 1.252 m turning radius"
  virtual std::string words() const = 0;
  /// "Reeds-Shepp curve": what is missing between two states
  virtual std::string_view piece_word() const = 0;

  /// Without it states are places, and the vehicle turns at each.
  bool has_headings() const { return kind() != SteeringKind::plane; }
  /// Motions join without turning on the spot: a path of them can be cut anywhere.
  bool is_curve() const { return kind() == SteeringKind::dubins || kind() == SteeringKind::reeds_shepp; }
};

struct SteeringOptions {
  double radius = 1.0;     ///< m, of curves, > 0
  double turn_cost = 0.05; ///< m that a radian of turning on the spot counts as, > 0
  double disc = 0.0;       ///< m, radius of the disc in the plane, for words alone
};

std::unique_ptr<const Steering> make_steering(SteeringKind kind, const SteeringOptions& options);

/// The path along states. Of curves, these from state to state. Else lines and turns from the start's pose; into the goal's pose where
/// there is one, and as the last drive has it where its heading is free. Neighbours on one line or circle are one piece.
/// @pre at least one state; the first is at the start, the last at the goal
Path path_along_states(const Steering& steering, const std::vector<Pose>& states, const Pose& start, const std::optional<Pose>& goal);

}  // namespace waywright
