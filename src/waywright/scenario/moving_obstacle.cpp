#include "waywright/scenario/moving_obstacle.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

using Place = MovingObstacle::Place;

Pose blend(const Place& a, const Place& b, double t) {
  const double share = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0);
  return make_pose(a.pose.position() + share * (b.pose.position() - a.pose.position()), wrap(a.pose.heading + share * shorter_turn(a.pose.heading, b.pose.heading)));
}

}  // namespace

Pose MovingObstacle::at(double t) const {
  if (t <= track.front().t) return track.front().pose;
  const auto after = std::upper_bound(track.begin(), track.end(), t, [](double time, const Place& p) { return time < p.t; });
  if (after == track.end()) return make_pose(track.back().pose.position() + (t - track.back().t) * velocity, track.back().pose.heading);
  return blend(*(after - 1), *after, t);
}

std::optional<double> MovingObstacle::stands_from() const {
  if (velocity != Vec2{} || spread > 0.0) return std::nullopt;
  return track.back().t;
}

std::string title_of(const MovingObstacle& obstacle, std::size_t index) {
  return obstacle.name.empty() ? "moving obstacle " + std::to_string(index + 1) : obstacle.name;
}

MovingObstacle seen_from(const MovingObstacle& obstacle, double now) {
  MovingObstacle seen = obstacle;
  seen.track.clear();
  seen.seen = std::max(obstacle.seen - now, -latest_time);
  if (obstacle.track.front().t <= now) seen.track.push_back({0.0, obstacle.at(now)});
  for (const Place& p : obstacle.track) {
    if (p.t > now || seen.track.empty()) seen.track.push_back({std::max(0.0, p.t - now), p.pose});
  }
  return seen;
}

MovingPlaces::MovingPlaces(const MovingObstacle& obstacle) : obstacle_{&obstacle}, radius_{obstacle.footprint.radius()} {
  speeds_.push_back(0.0);
  const std::vector<MovingObstacle::Place>& track = obstacle.track;
  for (std::size_t i = 0; i < track.size(); ++i) {
    breaks_.push_back(track[i].t);
    if (i + 1 == track.size()) {
      speeds_.push_back(norm(obstacle.velocity));
    } else {
      const double path = distance(track[i].pose.position(), track[i + 1].pose.position()) + radius_ * std::abs(shorter_turn(track[i].pose.heading, track[i + 1].pose.heading));
      speeds_.push_back(path / (track[i + 1].t - track[i].t));
    }
    fastest_ = std::max(fastest_, speeds_.back());
  }
}

MovingPlaces::Stretch MovingPlaces::between(double begin, double end) const {
  const double middle = 0.5 * (begin + end);
  const auto first = static_cast<std::size_t>(std::upper_bound(breaks_.begin(), breaks_.end(), begin) - breaks_.begin());
  double speed = 0.0;
  for (std::size_t i = first; i < speeds_.size(); ++i) {
    speed = std::max(speed, speeds_[i]);
    if (i < breaks_.size() && breaks_[i] >= end) break;
  }
  return {obstacle_->at(middle), speed * 0.5 * (end - begin) + obstacle_->off_by(end)};
}

}  // namespace waywright
