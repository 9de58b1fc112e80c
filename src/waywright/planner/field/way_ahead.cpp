#include "waywright/planner/field/way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double spacing = 0.1;  // m

}  // namespace

WayAhead::WayAhead(const PlaneSpace& space, const std::vector<Vec2>& points, double cap) {
  points_.push_back(points.front());
  s_.push_back(0.0);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 from = points[i - 1], to = points[i];
    const double way = distance(from, to);
    if (!(way > 0.0)) continue;
    const int parts = std::max(1, static_cast<int>(std::ceil(way / spacing)));
    const double before = s_.back();
    for (int k = 1; k <= parts; ++k) {
      points_.push_back(k == parts ? to : from + (static_cast<double>(k) / parts) * (to - from));
      s_.push_back(before + way * k / parts);
    }
  }
  const Problem& problem = space.problem();
  const Footprint disc{{}, space.disc()};
  for (const Vec2 p : points_) room_.push_back(std::clamp(problem.world().least_clearance(disc, make_pose(p, 0.0), cap + problem.required_clearance()) - problem.required_clearance(), 0.0, cap));
}

std::size_t WayAhead::index(double s) const {
  const auto after = std::upper_bound(s_.begin(), s_.end(), s);
  return after == s_.begin() ? 0 : static_cast<std::size_t>(after - s_.begin()) - 1;
}

Vec2 WayAhead::at(double s) const {
  const std::size_t i = index(s);
  if (i + 1 >= points_.size()) return points_.back();
  if (s <= s_[i]) return points_[i];
  return points_[i] + ((s - s_[i]) / (s_[i + 1] - s_[i])) * (points_[i + 1] - points_[i]);
}

double WayAhead::nearest(Vec2 point, double from, double to) const {
  double least = std::numeric_limits<double>::infinity(), best = std::clamp(from, 0.0, length());
  for (std::size_t i = index(from); i + 1 < points_.size() && s_[i] <= to; ++i) {
    Vec2 on;
    const double away = point_segment_distance(point, points_[i], points_[i + 1], &on);
    if (away < least) {
      least = away;
      best = s_[i] + distance(points_[i], on);
    }
  }
  return best;
}

double WayAhead::room(double from, double to) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = index(from); i < points_.size() && (s_[i] <= to || !std::isfinite(least)); ++i) least = std::min(least, room_[i]);
  return least;
}

}  // namespace waywright
