#include "waywright/planner/grid/sight.hpp"

#include <array>
#include <cmath>

namespace waywright {

bool Sight::is_free(Vec2 from, Vec2 to, double margin) const {
  const double needed = radius_ + margin;
  const double whole = distance(from, to);
  const double shortest = 0.25 * frame_.cell;  // smaller steps than this do not pay
  const Vec2 way = whole > 0.0 ? (1.0 / whole) * (to - from) : Vec2{};
  for (double s = 0.0;;) {
    const Vec2 at = from + s * way;
    const Cell c = frame_.cell_at(at);
    if (!frame_.contains(c)) break;
    const double off = distance(at, frame_.centre(c));
    if (bounds_.at_most(c) + off <= needed) return false;
    const double step = bounds_.at_least(c) - off - needed;
    if (step < shortest) break;
    s += step;
    if (s >= whole) return true;
  }
  const std::array<Vec2, 2> line{from, to};
  return problem_.world().is_free(line, needed);
}

double length_of(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

double cost_of(const std::vector<Vec2>& points, const ZoneRules& zones) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += zones.cost(points[i - 1], points[i]);
  return sum;
}

std::vector<Vec2> pulled_taut(std::vector<Vec2> points, const Sight& sight, double margin, double end_margin, const ZoneRules* zones) {
  const auto is_no_worse = [&](Vec2 from, Vec2 past, Vec2 to) {
    return zones == nullptr || (zones->may_be_driven(from, to) && zones->cost(from, to) <= zones->cost(from, past) + zones->cost(past, to));
  };
  constexpr int most_passes = 20;
  for (int pass = 0; pass < most_passes; ++pass) {
    std::vector<Vec2> kept{points.front()};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const bool is_end = kept.size() == 1 || i + 2 == points.size();
      if (!is_no_worse(kept.back(), points[i], points[i + 1]) || !sight.is_free(kept.back(), points[i + 1], is_end ? end_margin : margin)) kept.push_back(points[i]);
    }
    kept.push_back(points.back());
    const bool is_done = kept.size() == points.size();
    points = std::move(kept);
    if (is_done) break;
  }
  return points;
}

}  // namespace waywright
