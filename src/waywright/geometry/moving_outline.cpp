#include "waywright/geometry/moving_outline.hpp"

#include <algorithm>

namespace waywright {

MovingOutline::MovingOutline(std::span<const Vec2> corners) : body_(corners.begin(), corners.end()), world_(body_) {
  make_ready(world_, placed_);
  // Of a rectangle two are looked at.
  const int used = placed_.shape == segment_lanes::Shape::rectangle ? 2 : std::min(placed_.edges, segment_lanes::Outline::capacity);
  edges_.assign(placed_.ready, placed_.ready + used);
}

void MovingOutline::place(const Pose& pose, double sin, double cos) {
  const auto turned = [=](double x, double y) { return Vec2{cos * x - sin * y, sin * x + cos * y}; };
  Vec2 low{}, high{};
  for (std::size_t i = 0; i < body_.size(); ++i) {
    const Vec2 at = pose.position() + turned(body_[i].x, body_[i].y);
    world_[i] = at;
    low = i == 0 ? at : Vec2{std::min(low.x, at.x), std::min(low.y, at.y)};
    high = i == 0 ? at : Vec2{std::max(high.x, at.x), std::max(high.y, at.y)};
    if (i >= edges_.size()) continue;
    const Vec2 along = turned(edges_[i].along_x, edges_[i].along_y);
    placed_.ready[i] = {at.x, at.y, along.x, along.y, edges_[i].inverse};
  }
  placed_.low_x = low.x;
  placed_.low_y = low.y;
  placed_.high_x = high.x;
  placed_.high_y = high.y;
}

}  // namespace waywright
