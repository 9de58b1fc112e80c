// Down navigation functions, whatever map they are seen through: by steps that are shorter near rims, off saddles to a side, with the κ whose way is best.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "waywright/planner/field/descent.hpp"
#include "waywright/planner/field/sphere_world.hpp"

namespace waywright {

/// A function to be followed. All but `step`, `rim` and `goal` may be asked at places where a descent stays alone.
struct NavigationSlope {
  std::function<std::optional<Vec2>(Vec2, double)> step;       ///< where it leads from there, by so many m; empty where it leads nowhere
  std::function<double(Vec2)> rim;                             ///< m, to the nearest rim
  std::function<std::optional<Vec2>(Vec2)> off;                ///< from a saddle: a unit vector; empty where the place is near none
  std::function<std::optional<Vec2>(Vec2, double)> minimum;    ///< the minimum within so many m of there
  Vec2 goal{};
  double radius = 1.0;      ///< m, of the world: what steps are measured by
  std::size_t saddles = 0;  ///< that there may be
};

struct NavigationSteps {
  DescentOptions descent{};
  double step = 0.002;           ///< in radii of the world
  std::int64_t most = 200'000;   ///< of one descent
};

/// Steps that a descent may take now: what is told, or what is left of the budget's evaluations where that is less.
std::int64_t steps_left(std::int64_t most, const Budget& budget);
/// The budget has a limit of evaluations, and it is reached.
bool is_used_up(const Budget& budget);

/// Where it stays within ten steps' length it is in a local minimum only if Newton's method comes to one no farther off than that, by gradient and Hessian; else it has stalled.
/// Who runs into a saddle leaves it to a side.
Descent follow(const NavigationSlope& field, Vec2 start, const NavigationSteps& steps, Budget& budget);
Descent follow(const NavigationFunction& function, Vec2 start, const NavigationSteps& steps, Budget& budget);

/// A way down, with what is told when it is chosen.
struct FollowedWay {
  Descent descent;
  double kappa = 0.0;
  double length = std::numeric_limits<double>::infinity();  ///< m; infinite where it does not come to the goal
  double room = 0.0;                                        ///< m, to the nearest rim, of its points
};
inline constexpr double longer_allowed = 1.1;  ///< of a way that keeps farther away, over the shortest

/// Of the ways that are at most a tenth longer than the shortest the one that keeps farthest from all rims. Where none leads to the goal, the first. It ends early, with what
/// there is, where the budget is over, and where two have stalled (or used up their steps) and none has come to the goal: that is the map's doing, and not κ's.
FollowedWay best_way(const std::vector<double>& kappas, const std::function<Descent(double)>& down, const std::function<double(Vec2)>& rim, Budget& budget);

}  // namespace waywright
