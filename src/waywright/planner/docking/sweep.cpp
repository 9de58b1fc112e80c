#include "waywright/planner/docking/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

constexpr int most_halvings = 4;  // to a 256th of what a stretch bows

constexpr std::size_t most_corners = 16;  // of a convex part that is tested by separating lines

Vec2 placed(const auto& at, Vec2 p) { return at.position + p.x * at.heading + p.y * left_of(at.heading); }

/// How far a pose between can be from the straight interpolation of both ends, with half as much again for what the derivatives do
/// between them.
double bow(const SweptQuintic::State& a, const SweptQuintic::State& b, double h, double radius) {
  const double position = h * h / 8.0 * std::max(norm(a.acceleration), norm(b.acceleration));
  const double turned = h * std::max(std::abs(a.turn_rate), std::abs(b.turn_rate));
  const double heading = h / 8.0 * std::abs(b.turn_rate - a.turn_rate);
  return 1.5 * (position + radius * (turned * turned / 8.0 + heading));
}

/// A line that no corner reaches, `away` before it: what lies beyond it is clear. The axis is not of unit length.
struct Border {
  Vec2 axis{};
  double from = 0.0;
  bool leaves_beyond(const Segment& s) const { return std::min(dot(axis, s.a), dot(axis, s.b)) > from; }
};

Border border_along(std::span<const Vec2> corners, Vec2 axis, double away) {
  double reach = dot(axis, corners[0]);
  for (const Vec2 c : corners.subspan(1)) reach = std::max(reach, dot(axis, c));
  return {axis, reach + away * norm(axis)};
}

/// Borders that left something beyond them; the next segment is often there too.
class KnownBorders {
 public:
  bool leave_beyond(const Segment& s) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (borders_[i].leaves_beyond(s)) return true;
    }
    return false;
  }
  bool try_border(const Border& border, const Segment& s) {
    if (!border.leaves_beyond(s)) return false;
    borders_[next_] = border;
    next_ = (next_ + 1) % borders_.size();
    count_ = std::min(count_ + 1, borders_.size());
    return true;
  }

 private:
  std::array<Border, 4> borders_{};
  std::size_t count_ = 0, next_ = 0;
};

}  // namespace

SweptQuintic::State SweptQuintic::at(double u) const {
  const Derivatives d = derivatives(span, u);
  const double speed2 = squared_norm(d.d1);
  State state;
  state.position = d.p;
  state.acceleration = d.d2;
  if (speed2 > 0.0) {
    state.heading = ((direction < 0 ? -1.0 : 1.0) / std::sqrt(speed2)) * d.d1;
    state.turn_rate = cross(d.d1, d.d2) / speed2;
  }
  return state;
}

Sweep::Sweep(const PreparedDocking& prepared) : prepared_{prepared} {
  std::size_t most = 0;
  for (const Ring& part : prepared.parts()) most = std::max(most, part.size());
  corners_.reserve(2 * most);
  hull_.reserve(4 * most);
}

bool Sweep::hulls_are_clear(const State& a, const State& b, double margin) {
  for (const Ring& part : prepared_.parts()) {
    corners_.clear();
    for (const Vec2 p : part) corners_.push_back(placed(a, p));
    for (const Vec2 p : part) corners_.push_back(placed(b, p));
    convex_hull(corners_, hull_);
    if (!prepared_.problem().world().is_free(hull_, margin + prepared_.disc())) return false;
  }
  return true;
}

bool Sweep::between(const SweptQuintic& quintic, double u0, const State& a, double u1, const State& b, double margin,
                    int halvings) {
  const Placement first{a.position, a.heading}, last{b.position, b.heading};
  if (is_surely_clear(first, last, margin, bow(a, b, u1 - u0, prepared_.radius()))) return true;
  return halvings > 0 && is_free(last, margin) && both_halves(quintic, u0, a, u1, b, margin, halvings - 1);
}

bool Sweep::both_halves(const SweptQuintic& quintic, double u0, const State& a, double u1, const State& b, double margin, int halvings) {
  const double u = 0.5 * (u0 + u1);
  const State middle = quintic.at(u);
  return between(quintic, u0, a, u, middle, margin, halvings) && between(quintic, u, middle, u1, b, margin, halvings);
}

bool Sweep::is_free(const Placement& pose, double margin) {
  // What stands wholly inside something solid is known from the field: only what crosses its outline is asked about here.
  const double away = margin + prepared_.disc();
  std::array<Vec2, most_corners> corners;
  for (const Ring& part : prepared_.parts()) {
    const std::size_t n = part.size();
    if (n > most_corners) {
      corners_.clear();
      for (const Vec2 p : part) corners_.push_back(placed(pose, p));
      if (!prepared_.problem().world().index().is_clear(corners_, away)) return false;
      continue;
    }
    for (std::size_t i = 0; i < n; ++i) corners[i] = placed(pose, part[i]);
    if (!all_beyond({corners.data(), n}, n, away)) return false;
  }
  return true;
}

bool Sweep::is_surely_clear(const Placement& a, const Placement& b, double margin, double bow) const {
  const double away = margin + bow + prepared_.disc();
  std::array<Vec2, 2 * most_corners> corners;
  for (const Ring& part : prepared_.parts()) {
    const std::size_t n = part.size();
    if (n > most_corners) return false;
    for (std::size_t i = 0; i < n; ++i) {
      corners[i] = placed(a, part[i]);
      corners[n + i] = placed(b, part[i]);
    }
    if (!all_beyond({corners.data(), 2 * n}, n, away)) return false;
  }
  return true;
}

/// Is every obstacle beyond a line that is `away` from all corners, which are those of convex polygons of n corners each? Lines along the
/// polygons' edges and across the way from the corner that is nearest: of one polygon, some line separates whatever is farther.
bool Sweep::all_beyond(std::span<const Vec2> corners, std::size_t n, double away) const {
  Box box{corners[0], corners[0]};
  for (const Vec2 c : corners.subspan(1)) box = {{std::min(box.low.x, c.x), std::min(box.low.y, c.y)}, {std::max(box.high.x, c.x), std::max(box.high.y, c.y)}};
  box = {box.low - Vec2{away, away}, box.high + Vec2{away, away}};
  KnownBorders known;
  return prepared_.problem().world().index().all_of(box, [&](const Segment& s) {
    if (known.leave_beyond(s)) return true;
    // From the nearest corner: exact where that is what comes nearest.
    Vec2 nearest{};
    double least = std::numeric_limits<double>::infinity();
    const Vec2 d = s.b - s.a;
    const double inverse = d == Vec2{} ? 0.0 : 1.0 / squared_norm(d);
    for (const Vec2 c : corners) {
      const Vec2 to = s.a + std::clamp(dot(c - s.a, d) * inverse, 0.0, 1.0) * d - c;
      if (const double squared = squared_norm(to); squared < least) {
        least = squared;
        nearest = to;
      }
    }
    if (least <= away * away) return false;
    if (known.try_border(border_along(corners, nearest, away), s)) return true;
    for (std::size_t first = 0; first < corners.size(); first += n) {
      for (std::size_t i = 0; i < n; ++i) {
        const Vec2 edge = corners[first + (i + 1) % n] - corners[first + i];
        if (known.try_border(border_along(corners, {edge.y, -edge.x}, away), s)) return true;
      }
    }
    return false;
  });
}

bool Sweep::is_clear(const SweptQuintic& quintic, double u0, double u1, double margin) {
  return both_halves(quintic, u0, quintic.at(u0), u1, quintic.at(u1), margin, most_halvings - 1);
}

bool Sweep::is_clear(Vec2 from, Vec2 to, Vec2 heading, double margin) {
  return hulls_are_clear({from, heading, {}, 0.0}, {to, heading, {}, 0.0}, margin);
}

}  // namespace waywright
