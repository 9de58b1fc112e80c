#include "waywright/planner/tree/whale_steering.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double blocked_weight = 10.0;

}  // namespace

WhaleSteering::WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options)
    : space_{space}, options_{options}, per_radius_{options.sample_weight / options.radius}, per_diagonal_{options.goal_weight / norm(space.region().high - space.region().low)} {
  agents_.reserve(static_cast<std::size_t>(options.population));
}

double WhaleSteering::cost(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal) const {
  double sum = per_radius_ * distance(x, sample) + per_diagonal_ * distance(x, goal);
  if (!space_.is_free(near, x)) sum += options_.near_weight + (space_.is_free(x) ? 0.0 : blocked_weight);
  if (!space_.is_free(x, goal)) sum += options_.view_weight;
  return sum;
}

/// The same cost, term by term, no further than to where it is no better than the best: only the best one matters to the moves.
void WhaleSteering::look(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal, Best& best) {
  ++evaluations_;
  double sum = per_radius_ * distance(x, sample) + per_diagonal_ * distance(x, goal);
  if (!(sum < best.cost)) return;
  // Where a place that does not see the goal can be no better, that is asked first: most do not.
  const bool must_see = !(sum + options_.view_weight < best.cost);
  const auto sees_goal = [&] {
    if (shadow_.light() == goal && shadow_.is_dark(x)) return false;
    ++lines_;
    return space_.is_free(x, goal);
  };
  if (must_see && !sees_goal()) return;
  ++lines_;
  if (!space_.is_free(near, x)) {
    sum += options_.near_weight;
    if (!(sum < best.cost)) return;
    if (!space_.is_free(x)) sum += blocked_weight;
    if (!(sum < best.cost)) return;
  }
  if (!must_see && !sees_goal()) sum += options_.view_weight;
  if (sum < best.cost) best = {x, sum};
}

Vec2 WhaleSteering::into_disc(Vec2 x, Vec2 middle) const {
  const Vec2 off = x - middle;
  const double squared = squared_norm(off);
  return squared > options_.radius * options_.radius ? middle + (options_.radius / std::sqrt(squared)) * off : x;
}

Vec2 WhaleSteering::aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  if (has_goal_ && last_goal_ == goal && !(shadow_.light() == goal && shadow_.is_ready())) shadow_ = Shadow{space_, goal};
  has_goal_ = true;
  last_goal_ = goal;
  Best best{sample, std::numeric_limits<double>::infinity()};
  agents_.clear();
  for (int i = 0; i < options_.population; ++i) {
    Vec2 q{};
    do q = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    while (squared_norm(q) > 1.0);
    agents_.push_back(sample + options_.radius * q);
    look(agents_.back(), near, sample, goal, best);
  }
  const std::array<double, 2> low{sample.x - options_.radius, sample.y - options_.radius}, high{sample.x + options_.radius, sample.y + options_.radius};
  for (int t = 0; t < options_.iterations; ++t) {
    const double reach = whale_reach(options_.whale.start, static_cast<std::size_t>(t), static_cast<std::size_t>(options_.iterations));
    const Vec2 leader = best.at;
    for (Vec2& agent : agents_) {
      const WhaleStep step = whale_step(options_.whale, reach, WhaleDraws::from(random));
      const Vec2 target = step.move == WhaleMove::search ? agents_[static_cast<std::size_t>(random.integer(0, options_.population - 1))] : leader;
      std::array<double, 2> x{agent.x, agent.y};
      make_whale_step(step, std::array{target.x, target.y}, low, high, x);
      agent = into_disc({x[0], x[1]}, sample);
    }
    for (const Vec2 agent : agents_) look(agent, near, sample, goal, best);
  }
  return best.at;
}

}  // namespace waywright
