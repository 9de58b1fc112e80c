#include "waywright/planner/field/star_world.hpp"

#include <algorithm>

namespace waywright {
namespace {

constexpr double least_lambda = 1e2, most_lambda = 1e12;

/// (|q − c| / rim)²: under 1 within the star.
Dual share_of(const Star& star, Vec2 q) {
  const Vec2 c = star.centre();
  const Dual x{q.x - c.x, 1.0, 0.0}, y{q.y - c.y, 0.0, 1.0}, rim = star.rim(q);
  return (x * x + y * y) / (rim * rim);
}

}  // namespace

StarMap::StarMap(const StarWorld& world, Vec2 goal, double lambda) : world_{world}, goal_{goal}, lambda_{lambda} {
  model_.outside = {world.outside.centre(), world.outside.greatest_rim()};
  for (const Star& star : world.obstacles) model_.obstacles.push_back({star.centre(), star.least_rim()});
}

bool StarMap::is_free(Vec2 q) const {
  if (q == world_.outside.centre()) return std::none_of(world_.obstacles.begin(), world_.obstacles.end(), [&](const Star& s) { return q == s.centre() || distance(q, s.centre()) <= s.rim(q).value; });
  if (distance(q, world_.outside.centre()) >= world_.outside.rim(q).value) return false;
  return std::none_of(world_.obstacles.begin(), world_.obstacles.end(), [&](const Star& s) { return q == s.centre() || distance(q, s.centre()) <= s.rim(q).value; });
}

StarMap::Image StarMap::at(Vec2 q) const {
  const Dual qx{q.x, 1.0, 0.0}, qy{q.y, 0.0, 1.0};
  const std::size_t n = world_.obstacles.size();
  // β of each, the outside's last, and the radius that Tᵢ gives q over its distance from the centre.
  std::vector<Dual> betas(n + 1), stretches(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    const bool is_outside = i == n;
    const Star& star = is_outside ? world_.outside : world_.obstacles[i];
    if (q == star.centre()) {  // of the outside alone: T is smooth there, but its derivative is not 1
      betas[i] = constant(1.0);
      stretches[i] = constant(0.0);
      continue;
    }
    const Dual share = share_of(star, q);
    betas[i] = is_outside ? constant(1.0) - share : share - constant(1.0);
    const Vec2 c = star.centre();
    const Dual x = qx - constant(c.x), y = qy - constant(c.y);
    const double radius = is_outside ? model_.outside.radius : model_.obstacles[i].radius;
    stretches[i] = constant(radius) * share / square_root(x * x + y * y);
  }
  const Dual gx = qx - constant(goal_.x), gy = qy - constant(goal_.y);
  const Dual gamma = (gx * gx + gy * gy) / constant(model_.outside.radius * model_.outside.radius);
  Dual hx = qx, hy = qy;
  for (std::size_t i = 0; i <= n; ++i) {
    Dual others = gamma;
    for (std::size_t k = 0; k <= n; ++k) {
      if (k != i) others = others * betas[k];
    }
    const Dual sigma = others / (others + constant(lambda_) * betas[i]);
    const Vec2 c = (i == n ? world_.outside : world_.obstacles[i]).centre();
    const Dual x = qx - constant(c.x), y = qy - constant(c.y), less = stretches[i] - constant(1.0);
    hx = hx + sigma * less * x;
    hy = hy + sigma * less * y;
  }
  return {{hx.value, hy.value}, hx.dx, hx.dy, hy.dx, hy.dy};
}

ChosenLambda choose_lambda(const StarWorld& world, Vec2 goal, int side, const std::function<bool()>& stops) {
  const Vec2 middle = world.outside.centre();
  const double reach = world.outside.greatest_rim();
  ChosenLambda chosen;
  for (double lambda = least_lambda; lambda <= most_lambda; lambda *= 10.0) {
    chosen = {lambda, true};
    const StarMap map{world, goal, lambda};
    for (int j = 0; j < side && chosen.is_shown; ++j) {
      if (stops && stops()) return {lambda, false};
      for (int i = 0; i < side && chosen.is_shown; ++i) {
        const Vec2 q = middle + reach * Vec2{2.0 * (i + 0.5) / side - 1.0, 2.0 * (j + 0.5) / side - 1.0};
        if (map.is_free(q)) chosen.is_shown = map.at(q).determinant() > 0.0;
      }
    }
    if (chosen.is_shown) return chosen;
  }
  return chosen;
}

Vec2 StarNavigation::slope(Vec2 q) const {
  const StarMap::Image image = map_.at(q);
  const Vec2 g = function_.slope(image.at);
  return {image.xx * g.x + image.yx * g.y, image.xy * g.x + image.yy * g.y};
}

}  // namespace waywright
