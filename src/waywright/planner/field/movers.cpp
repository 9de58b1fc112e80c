#include "waywright/planner/field/movers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double moment = 0.02;  // s, over which a velocity is taken
constexpr int corners = 24;

}  // namespace

Movers::Movers(const PlaneSpace& space, double beside) : obstacles_{space.problem().scenario().moving}, kept_{space.needed() + beside}, beside_{beside} {
  for (const MovingObstacle& obstacle : obstacles_) radii_.push_back(obstacle.footprint.radius());
}

Movers::Near Movers::at(std::size_t i, Vec2 disc, double t, double cap) const {
  const MovingObstacle& obstacle = obstacles_[i];
  const Pose pose = obstacle.at(t);
  const double kept = kept_ + obstacle.off_by(t), between = distance(disc, pose.position());
  if (obstacle.footprint.is_disc() || between - radii_[i] - kept > cap) {
    const double radius = obstacle.footprint.is_disc() ? obstacle.footprint.disc : radii_[i];
    const Vec2 towards = between > 0.0 ? (1.0 / between) * (disc - pose.position()) : Vec2{1.0, 0.0};
    return {between - radius - kept, pose.position() + radius * towards};
  }
  const Frame frame{pose};
  const Vec2 local = frame.to_local(disc);
  const Ring& ring = obstacle.footprint.polygon;
  double least = std::numeric_limits<double>::infinity();
  Vec2 nearest{};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    Vec2 point;
    const double away = point_segment_distance(local, ring[k], ring[(k + 1) % ring.size()], &point);
    if (away < least) {
      least = away;
      nearest = point;
    }
  }
  if (contains(ring, local)) least = -least;
  return {least - kept, frame.to_world(nearest)};
}

Vec2 Movers::velocity(std::size_t i, double t) const {
  const MovingObstacle& obstacle = obstacles_[i];
  return (1.0 / moment) * (obstacle.at(t + moment).position() - obstacle.at(t).position());
}

bool Movers::stands(std::size_t i, double t, double seconds) const {
  const MovingObstacle& obstacle = obstacles_[i];
  const Pose now = obstacle.at(t);
  if (obstacle.at(t + seconds) != now) return false;
  return std::all_of(obstacle.track.begin(), obstacle.track.end(), [&](const MovingObstacle::Place& p) { return p.t <= t || p.t >= t + seconds || p.pose == now; });
}

Ring Movers::outline(std::size_t i, double t, double room) const {
  const MovingObstacle& obstacle = obstacles_[i];
  const Pose pose = obstacle.at(t);
  const bool is_disc = obstacle.footprint.is_disc();
  const double radius = std::max(1e-3, room + beside_ + obstacle.off_by(t) + (is_disc ? obstacle.footprint.disc : 0.0)) / sin_cos(pi / corners).cos;
  std::vector<Vec2> points;
  for (const Vec2 middle : is_disc ? Ring{pose.position()} : transformed(obstacle.footprint.polygon, Frame{pose})) {
    for (int k = 0; k < corners; ++k) points.push_back(middle + radius * unit(two_pi * k / corners));
  }
  return convex_hull(std::move(points));
}

}  // namespace waywright
