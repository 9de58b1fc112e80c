#include "waywright/planner/steering/dubins.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

/// rad: a turn that is a full one but for rounding is none. Rounding grows where ends are near to each other; what is left out moves the end by as much as the way is long.
constexpr double full_turn_slack = 5e-10;
constexpr double most_slack = 1e-3;        // rad, of any turn
constexpr double no_distance = 1e-10;      // radii: between centres that are one but for rounding
constexpr double least_gain = 1e-11;       // radii: a longer word of no less length is no better

constexpr int left = 1, right = -1, straight = 0;

/// In [0, 2π].
double forwards(double angle) {
  const double turn = wrap(angle);
  return turn < 0.0 ? turn + two_pi : turn;
}
/// The same, but 0 where rounding may have made a full turn of none. `reach`: radii, of what comes after the turn.
double forwards(double angle, double reach) {
  const double turn = forwards(angle);
  return turn >= two_pi - full_turn_slack / (1.0 + reach) ? 0.0 : turn;
}
/// A turn beside a straight part of `r` radii that is none or a full one but for rounding.
bool is_none(double turn, double r) {
  const double slack = std::min(most_slack, full_turn_slack / r);
  return turn <= 0.0 || turn >= two_pi - slack;
}

double arc_cosine(double c) { return arc_tangent(std::sqrt((1.0 - c) * (1.0 + c)), c); }

/// A goal in the frame of the start, in radii.
struct Target {
  double x, y, heading, sin, cos;
  /// Words to it are words to the goal with left and right exchanged.
  Target mirrored() const { return {x, -y, -heading, -sin, cos}; }
};

class Search {
 public:
  explicit Search(const Target& goal) {
    for (const int side : {1, -1}) {
      side_ = side;
      words(side > 0 ? goal : goal.mirrored());
    }
  }
  const DubinsWord& best() const { return best_; }

 private:
  void offer(std::initializer_list<TurningPart> parts) {
    double length = 0.0;
    for (const auto& part : parts) length += part.length;
    if (best_.count > 0 && length >= best_.length - least_gain) return;
    best_ = {};
    best_.length = length;
    for (const auto& part : parts) best_.parts[best_.count++] = {side_ * part.side, part.length};
  }

  /// Those that begin to the left. The start's left circle has its centre at (0, 1).
  void words(const Target& g) {
    {  // Left, straight or right, left: both circles to the left.
      const Vec2 between{g.x - g.sin, g.y + g.cos - 1.0};
      const double r = norm(between);
      if (r <= no_distance) {
        offer({{left, forwards(g.heading, 0.0)}});
      } else {
        const double course = angle_of(between);
        const double before = forwards(course), after = forwards(g.heading - course);
        // The nearer the centres, the more rounding is in the course: one turn is none and the other all of it, so that the heading stays exact.
        if (is_none(before, r)) {
          offer({{straight, r}, {left, forwards(g.heading, 0.0)}});
        } else if (is_none(after, r)) {
          offer({{left, forwards(g.heading, 0.0)}, {straight, r}});
        } else {
          offer({{left, before}, {straight, r}, {left, after}});
        }
        if (r <= 4.0) {
          // The middle circle touches both: its centre is the top of a triangle with sides 2, 2, r.
          const double base = arc_cosine(0.25 * r);
          const double first = course + base + 0.5 * pi;
          const double middle = pi + 2.0 * base;
          offer({{left, forwards(first, 4.0)}, {right, middle}, {left, forwards(g.heading - first + middle, 0.0)}});
        }
      }
    }
    // Left, straight, right.
    const Vec2 between{g.x + g.sin, g.y - g.cos - 1.0};
    const double r = norm(between);
    if (r < 2.0 - no_distance) return;  // both circles touch where the way is two arcs: rounding must not lose it
    const double u = std::sqrt(std::max(0.0, (r - 2.0) * (r + 2.0)));
    const double course = angle_of(between) + arc_tangent(2.0, u);
    offer({{left, forwards(course, u)}, {straight, u}, {right, forwards(course - g.heading, 0.0)}});
  }

  int side_ = 1;
  DubinsWord best_;
};

}  // namespace

DubinsWord Dubins::shortest(const Pose& from, const Pose& to) const {
  const Vec2 there = (1.0 / radius_) * Frame{from}.unrotate(to.position() - from.position());
  const double heading = shorter_turn(from.heading, to.heading);
  const SinCos of_heading = sin_cos(heading);
  return Search{{there.x, there.y, heading, of_heading.sin, of_heading.cos}}.best();
}

Pieces Dubins::between(const Pose& from, const Pose& to) const {
  const DubinsWord word = shortest(from, to);
  return turning_pieces(from, std::span{word.parts.data(), word.count}, radius_);
}

}  // namespace waywright
