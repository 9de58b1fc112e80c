#include "waywright/dxf/outline.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/core/angle.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright::dxf {
namespace {

constexpr double eighth_turn = 0.41421356237309503;  // bulge of 90°
constexpr int deepest = 60;                          // halvings of a piece: a hundred would not change it any more

class Chords {
 public:
  Chords(Side side, double tolerance, std::size_t most) : side_{side}, tolerance_{tolerance}, most_{most} {}

  void corner(Vec2 p) { points_.push_back(p); }

  /// From the last corner on.
  void conic(Vec2 from, Vec2 control, Vec2 to, double weight) {
    add(from, control, to, weight, beside(from, control, to), true, 0);
  }

  /// A chain of control points, each farther along the chord than the one before: their hull to one side. What a block's insertion stretches and shears keeps
  /// an order by some linear function from corner to corner, which is all that the scan needs.
  void hull(Vec2 from, const std::vector<Vec2>& controls, Vec2 to) {
    const std::size_t first = points_.size();
    const double turn = side_ == Side::left ? 1.0 : -1.0;
    points_.push_back(from);
    const auto push = [&](Vec2 p) {
      while (points_.size() > first + 1 && turn * cross(points_.back() - points_[points_.size() - 2], p - points_.back()) >= 0.0) points_.pop_back();
      points_.push_back(p);
    };
    if (side_ != Side::on) {
      for (const Vec2 c : controls) {
        if (beside(from, c, to)) push(c);
      }
    }
    push(to);
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(first));  // it was there already
  }

  bool full() const { return points_.size() > most_; }
  Polyline take() { return std::move(points_); }

 private:
  /// On the side where nothing of the curve may be.
  bool beside(Vec2 from, Vec2 p, Vec2 to) const {
    const double at = cross(to - from, p - from);
    return side_ == Side::left ? at > 0.0 : side_ == Side::right && at < 0.0;
  }

  void add(Vec2 from, Vec2 control, Vec2 to, double weight, bool tangents, bool last, int depth) {
    if (full()) return;
    // The curve is farthest from its chord at its middle, where its tangent is parallel to it; the control point is the farther from there.
    const double height = distance(control, 0.5 * (from + to)) / (1.0 + weight);
    if (depth >= deepest || (tangents ? height : weight * height) <= tolerance_) {
      if (tangents) points_.push_back(control);
      // Between two tangents of one curve the corner lies on the line that joins their ends.
      if (!tangents || last) points_.push_back(to);
      return;
    }
    const double k = 1.0 / (1.0 + weight);
    const Vec2 before = k * (from + weight * control), after = k * (to + weight * control), middle = 0.5 * (before + after);
    const double half = std::sqrt(0.5 * (1.0 + weight));
    add(from, before, middle, half, tangents, false, depth + 1);
    add(middle, after, to, half, tangents, last, depth + 1);
  }

  Side side_;
  double tolerance_;
  std::size_t most_;
  Polyline points_;
};

/// Share of the triangle of a conic's corners and control point that lies between the conic and its chord.
double share_of(double weight) {
  if (weight > 0.999) return 2.0 / 3.0;  // nearly a parabola: to a part in a thousand
  const double sine = std::sqrt(1.0 - weight * weight), half = arc_tangent(sine, weight);
  return (half - sine * weight) * weight / (sine * sine * sine);
}

}  // namespace

Chain chain_of(const Polyline& line) {
  Chain chain;
  chain.reserve(line.size());
  for (const Vec2 p : line) chain.push_back({p});
  return chain;
}

void add_arc(Chain& chain, Vec2 to, double bulge) {
  const Vec2 from = chain.back().at, middle = 0.5 * (from + to), across = 0.5 * left_of(to - from);
  if (std::abs(bulge) > 1.0001 * eighth_turn) {
    const double half = bulge / (1.0 + std::sqrt(1.0 + bulge * bulge));
    add_arc(chain, middle - bulge * across, half);
    add_arc(chain, to, half);
    return;
  }
  if (bulge != 0.0) chain.push_back({middle - 2.0 * bulge / (1.0 - bulge * bulge) * across, (1.0 - bulge * bulge) / (1.0 + bulge * bulge)});
  chain.push_back({to});
}

Chain elliptic_arc(Vec2 center, Vec2 major, Vec2 minor, double from, double sweep) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / (0.5 * pi) - 1e-9)));
  const double half = 0.5 * sweep / pieces, weight = sin_cos(half).cos;
  Chain chain;
  for (int i = 0; i <= 2 * pieces; ++i) {
    const SinCos u = sin_cos(from + i * half);
    const Vec2 out = u.cos * major + u.sin * minor;
    if (i % 2 == 0) chain.push_back({center + out});
    else chain.push_back({center + (1.0 / weight) * out, weight});
  }
  if (sweep >= two_pi) chain.back() = chain.front();
  return chain;
}

std::optional<Polyline> chords_of(const Chain& chain, bool closed, Side side, double tolerance, std::size_t most) {
  Chords chords{side, tolerance, most};
  if (chain.empty()) return Polyline{};
  chords.corner(chain.front().at);
  std::vector<Vec2> controls;
  const std::size_t end = closed ? chain.size() + 1 : chain.size();
  for (std::size_t i = 1, from = 0; i < end; ++i) {
    const Knot& knot = chain[i % chain.size()];
    if (knot.weight != 0.0) {
      controls.push_back(knot.at);
      continue;
    }
    const double weight = chain[i - 1].weight;
    if (controls.empty()) chords.corner(knot.at);
    else if (weight > 0.0) chords.conic(chain[from].at, controls.front(), knot.at, weight);
    else chords.hull(chain[from].at, controls, knot.at);
    controls.clear();
    from = i;
    if (chords.full()) return std::nullopt;
  }
  Polyline points = chords.take();
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

double signed_area(const Chain& chain) {
  if (chain.empty()) return 0.0;
  const Vec2 origin = chain.front().at;
  double twice = 0.0;
  for (std::size_t i = 0, from = 0; i < chain.size(); ++i) {
    const Knot& next = chain[(i + 1) % chain.size()];
    if (next.weight != 0.0) continue;
    const Vec2 a = chain[from].at - origin, b = next.at - origin;
    twice += cross(a, b);
    if (chain[i].weight > 0.0) {
      const Vec2 control = chain[i].at - origin;
      twice += share_of(chain[i].weight) * (cross(a, control) + cross(control, b) - cross(a, b));
    }
    from = i + 1;
  }
  return 0.5 * twice;
}

}  // namespace waywright::dxf
