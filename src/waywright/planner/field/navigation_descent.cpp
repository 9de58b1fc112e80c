#include "waywright/planner/field/navigation_descent.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {
namespace {

constexpr double rim_share = 0.2;        // of the distance to the nearest rim, that a step is long at most
constexpr double shortest_step = 1e-6;   // of the world's radius
constexpr std::size_t enough_stalls = 2;

std::optional<Vec2> along(Vec2 way, Vec2 q, double long_) {
  const double steep = norm(way);
  if (!(steep > 0.0) || !std::isfinite(steep)) return std::nullopt;
  return q + (long_ / steep) * way;
}

}  // namespace

std::int64_t steps_left(std::int64_t most, const Budget& budget) {
  const auto left = budget.evaluations_left();
  return left ? std::min(most, *left) : most;
}

bool is_used_up(const Budget& budget) { return budget.evaluations_left() == std::int64_t{0}; }

Descent follow(const NavigationSlope& field, Vec2 start, const NavigationSteps& options, Budget& budget) {
  DescentOptions steps = options.descent;
  steps.period = 1.0;
  steps.speed = options.step * field.radius;
  steps.goal_tolerance = 2.0 * steps.speed;
  const double about = 10.0 * steps.speed;  // m, of a saddle: what the steps are in which it is stuck
  steps.trapped_within = about / (steps.speed * steps.period * steps.window);
  steps.patience = std::numeric_limits<int>::max();
  steps.may_creep = true;
  const std::int64_t most = steps_left(options.most, budget);
  const auto down = [&](Vec2 q) -> std::optional<FieldStep> {
    const double rim = field.rim(q);
    if (!(rim > 0.0)) return std::nullopt;
    const auto next = field.step(q, std::clamp(rim_share * rim, shortest_step * field.radius, steps.speed));
    return next ? FieldStep{*next - q, 0.0} : FieldStep{};
  };
  Descent all;
  all.points = {start};
  all.last = start;
  for (std::size_t saddles = 0;; ++saddles) {
    Descent next = descend(down, all.last, field.goal, steps, most - all.steps, budget);
    all.ended = next.ended;
    all.last = next.last;
    all.steps += next.steps;
    all.points.insert(all.points.end(), next.points.begin() + 1, next.points.end());
    keep_bounded(all.points);
    const bool is_stuck = next.ended == DescentEnd::local_minimum || next.ended == DescentEnd::oscillation;
    if (!is_stuck) return all;
    // Steps of one length do not rest in a minimum, and to and fro along a rim is none.
    all.minimum = field.minimum(all.last, about);
    all.ended = all.minimum ? DescentEnd::local_minimum : DescentEnd::stalled;
    if (all.minimum) return all;
    const auto aside = field.off(all.last);
    if (!aside || saddles > field.saddles) return all;
    // The steps about the saddle are left out, with the way to it alone.
    while (all.points.size() > 1 && distance(all.points.back(), all.last) < about) all.points.pop_back();
    const Vec2 off = std::min(2.0 * about, 0.5 * field.rim(all.last)) * *aside;
    all.last = all.last + off;
    all.points.push_back(all.last);
  }
}

Descent follow(const NavigationFunction& function, Vec2 start, const NavigationSteps& steps, Budget& budget) {
  const auto step = [&](Vec2 q, double long_) { return along(-function.slope(q), q, long_); };
  const auto rim = [&](Vec2 q) { return function.distance_to_rim(q); };
  const auto off = [&](Vec2 q) { return way_off(function.curvature(q)); };
  const auto minimum = [&](Vec2 q, double within) { return minimum_near([&](Vec2 p) { return function.slope(p); }, [&](Vec2 p) { return function.curvature(p); }, rim, q, within); };
  return follow(NavigationSlope{step, rim, off, minimum, function.goal(), function.world().outside.radius, function.world().obstacles.size()}, start, steps, budget);
}

FollowedWay best_way(const std::vector<double>& kappas, const std::function<Descent(double)>& down, const std::function<double(Vec2)>& rim, Budget& budget) {
  // Kept are those alone that may be chosen still, whatever comes: a descent can be long.
  std::vector<FollowedWay> open;
  double shortest = std::numeric_limits<double>::infinity();
  std::size_t stalls = 0;
  for (const double kappa : kappas) {
    FollowedWay tried{down(kappa), kappa};
    if (tried.descent.ended == DescentEnd::goal) {
      tried.length = length_of_way(tried.descent.points);
      tried.room = std::numeric_limits<double>::infinity();
      for (const Vec2 p : tried.descent.points) tried.room = std::min(tried.room, rim(p));
      shortest = std::min(shortest, tried.length);
    }
    stalls += tried.descent.ended == DescentEnd::stalled || tried.descent.ended == DescentEnd::steps ? 1 : 0;
    if (open.empty() || std::isfinite(tried.length)) {
      std::erase_if(open, [&](const FollowedWay& other) { return !(other.length <= longer_allowed * shortest) || (other.length >= tried.length && other.room < tried.room); });
      const bool is_less = std::any_of(open.begin(), open.end(), [&](const FollowedWay& other) { return other.length <= tried.length && other.room >= tried.room; });
      if (open.empty() || (!is_less && tried.length <= longer_allowed * shortest)) open.push_back(std::move(tried));
    }
    if (budget.exhausted() || is_used_up(budget) || (stalls >= enough_stalls && !std::isfinite(shortest))) break;
  }
  return *std::max_element(open.begin(), open.end(), [](const FollowedWay& a, const FollowedWay& b) { return a.room < b.room; });
}

}  // namespace waywright
