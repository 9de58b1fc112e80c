// The local field among what moves: drawn along a global way, pushed off by what stands and by what moves, as it is then and as it will be.
//
// Sources: the navigation-field publication, §1.2 and its conclusion (a global planner against local minima, a local one for what moves); O. Khatib: Real-time obstacle
// avoidance for manipulators and mobile robots, IJRR 5 (1986); the look ahead in time follows P. Fiorini, Z. Shiller: Motion planning in dynamic environments using velocity
// obstacles, IJRR 17 (1998). What is combined how is ours.
#pragma once

#include <optional>
#include <vector>

#include "waywright/planner/field/free_motion.hpp"
#include "waywright/planner/field/movers.hpp"
#include "waywright/planner/field/potential.hpp"
#include "waywright/planner/field/way_ahead.hpp"

namespace waywright {

struct LocalFieldOptions {
  double look_ahead = 1.0;         ///< m of the way, to the place that attracts
  double repulsion = 0.1;          ///< k_r of what stands, m⁴/s
  double reach = 0.8;              ///< ρ₀ of what stands, m, and at most the room that the way has
  double moving_repulsion = 0.1;   ///< k_r of what moves, m⁴/s
  double moving_reach = 1.2;       ///< ρ₀ of what moves, m
  double horizon = 4.0;            ///< s, that a velocity is looked at ahead
  double period = 0.1;             ///< s, of each motion
};

/// What the field is to do differently for a while.
struct LocalOrder {
  enum class Kind { hold, other_side };
  Kind kind = Kind::hold;     ///< hold: nothing attracts
  double from = 0.0, until = 0.0;  ///< s
  std::size_t obstacle = 0;   ///< whose other side is taken
};

class LocalField {
 public:
  LocalField(const PlaneSpace& space, const Movers& movers, const FreeMotion& motion, const LocalFieldOptions& options) : space_{space}, movers_{movers}, motion_{motion}, options_{options} {}

  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  struct Choice {
    FreeStep step;
    std::size_t pushed_by = nobody;  ///< of what moves, who pushed most
    std::size_t kept_by = nobody;    ///< who kept it from what the field asked for
    bool is_met = false;             ///< the step cannot be shown to be clear of what moves …
    std::size_t met = nobody;        ///< … namely of this one
    bool is_lost = false;            ///< the way is out of sight
  };
  /// On which side each of what moves is passed, once that is settled: 1 with it to the right, −1 to the left, 0 not settled; an element for each.
  using Sides = std::vector<signed char>;
  /// The next motion from a state. `s`: where along the way the vehicle is; `top`: m/s.
  Choice next(const FreeState& from, const WayAhead& way, double s, double top, const std::vector<LocalOrder>& orders, Sides& sides) const;
  /// The last motions, onto the end of the way; empty where they cannot be driven, or are not clear.
  std::optional<FreeStep> arrive(const FreeState& from, Vec2 goal, double top) const;

 private:
  struct Wanted {
    Vec2 velocity{};
    std::size_t pushed_by = nobody;
    bool is_lost = false;
  };
  Vec2 push(std::size_t i, const FreeState& from, double reach, Vec2 along, const std::vector<LocalOrder>& orders, signed char& side) const;
  /// m, of the room that the way has beside an obstacle that stands, at most `most`; empty of one that moves, or stands in the way.
  std::optional<double> room_beside(std::size_t i, double t, const WayAhead& way, double s, double target, double most) const;
  signed char side_of(std::size_t i, Vec2 disc, double t, Vec2 axis, Vec2 along) const;
  struct Outlook {
    double clear = 0.0;            ///< s from now on, that it stays clear of what moves
    double least = 0.0;            ///< m, of gaps until then, at most what is comfortable
    std::size_t obstacle = nobody; ///< who it is not clear of then
    bool is_free = false;          ///< of what stands, until it could have stopped
  };
  struct Nearby {
    std::size_t obstacle = nobody;
    double comfortable = 0.0;  ///< m: nearer than that costs
    bool is_passed = false;    ///< it stands beside the way: the vehicle stops before it, as before what stands for ever
  };
  /// Is the line clear of those that stand beside the way?
  bool is_seen(const FreeState& from, Vec2 to, const std::vector<Nearby>& about) const;
  Outlook outlook(const FreeState& from, Vec2 velocity, double top, const std::vector<Nearby>& about) const;
  std::vector<Nearby> about(const FreeState& from) const;
  Wanted wanted(const FreeState& from, const WayAhead& way, double s, double top, const std::vector<LocalOrder>& orders, const std::vector<Nearby>& about, Sides& sides) const;
  /// The first that stands beside the way and would be come too near to.
  std::size_t hit_on(const FreeState& from, const FreeStep& step, const std::vector<Nearby>& about) const;
  bool is_step_free(const FreeState& from, const FreeStep& step) const;
  /// The first of those about that the step cannot be shown to be clear of.
  std::size_t met_on(const FreeState& from, const FreeStep& step, const std::vector<Nearby>& about) const;

  const PlaneSpace& space_;
  const Movers& movers_;
  const FreeMotion& motion_;
  LocalFieldOptions options_;
};

}  // namespace waywright
