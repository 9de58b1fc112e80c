#include "waywright/planner/field/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

/// m, how far the latest `window` points reach.
double extent(const std::vector<Vec2>& points, std::size_t window) {
  Vec2 low = points.back(), high = low;
  for (std::size_t i = points.size() - window; i < points.size(); ++i) {
    low = {std::min(low.x, points[i].x), std::min(low.y, points[i].y)};
    high = {std::max(high.x, points[i].x), std::max(high.y, points[i].y)};
  }
  return distance(low, high);
}

/// m that they are long.
double travelled(const std::vector<Vec2>& points, std::size_t window) {
  double way = 0.0;
  for (std::size_t i = points.size() - window + 1; i < points.size(); ++i) way += distance(points[i - 1], points[i]);
  return way;
}

constexpr double rests_under = 0.1;    // share of the greatest speed, on average
constexpr double straight_over = 0.5;  // extent, as a share of the way

}  // namespace

void keep_bounded(std::vector<Vec2>& points) {
  if (points.size() <= most_descent_points) return;
  const std::size_t early = points.size() - most_descent_points / 4;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); i += i < early ? 2 : 1) points[kept++] = points[i];
  points.resize(kept);
}

Descent descend(const std::function<std::optional<FieldStep>(Vec2)>& field, Vec2 start, Vec2 goal, const DescentOptions& options, std::int64_t most_steps, Budget& budget) {
  Descent descent;
  descent.points.push_back(start);
  descent.last = start;
  const auto window = static_cast<std::size_t>(options.window);
  double lowest = std::numeric_limits<double>::infinity();
  std::int64_t since = 0;
  const auto ends = [&](DescentEnd why) {
    descent.ended = why;
    return descent;
  };
  while (descent.steps < most_steps) {
    if (distance(descent.last, goal) < options.goal_tolerance) return ends(DescentEnd::goal);
    if ((descent.steps & 63) == 0 && budget.exhausted()) return ends(budget.canceled() ? DescentEnd::canceled : DescentEnd::timed_out);
    const auto step = field(descent.last);
    ++descent.steps;
    budget.count_evaluations();
    if (!step) return ends(DescentEnd::blocked);
    if (step->potential < lowest - 1e-9 * std::max(1.0, std::abs(step->potential))) {
      lowest = step->potential;
      since = 0;
    } else if (++since > options.patience) {
      return ends(DescentEnd::oscillation);
    }
    Vec2 velocity = step->velocity;
    if (const double fast = norm(velocity); fast > options.speed) velocity = (options.speed / fast) * velocity;
    descent.last = descent.last + options.period * velocity;
    descent.points.push_back(descent.last);
    keep_bounded(descent.points);
    if (descent.points.size() <= window || descent.points.size() % 16 != 0) continue;
    const double reach = extent(descent.points, window);
    if (reach >= options.trapped_within * options.speed * options.period * options.window) continue;
    const double way = travelled(descent.points, window);
    if (options.may_creep && reach > straight_over * way) continue;
    // What rests hardly moves; what is thrown to and fro is fast.
    return ends(way < rests_under * options.speed * options.period * options.window ? DescentEnd::local_minimum : DescentEnd::oscillation);
  }
  return ends(DescentEnd::steps);
}

}  // namespace waywright
