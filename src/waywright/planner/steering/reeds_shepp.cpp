#include "waywright/planner/steering/reeds_shepp.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "waywright/core/elementary.hpp"
#include "waywright/curve/arc.hpp"
#include "waywright/planner/steering/pose_order.hpp"

namespace waywright {
namespace {

constexpr double least_segment = 1e-10;  // m: what is shorter is rounding of the words' angles, not a piece
constexpr double least_part = 1e-9;      // m
constexpr double sign_slack = 1e-12;     // radii: a length of the wrong sign by no more is 0
constexpr double rounding = 1e-11;       // radii: what a turn of the wrong sign may move the end by
constexpr double most_slack = 1e-3;      // rad, of such a turn
constexpr double least_gain = 1e-11;     // radii: a longer word of no less length is no better

constexpr int left = 1, right = -1, straight = 0;

/// A goal in the frame of the start, in radii, its heading with sine and cosine.
struct Target {
  double x, y, heading, sin, cos;

  /// Words to the mirrored goals are words to the goal with lengths of the other sign (time < 0: x axis
  /// turned about) or with left and right exchanged (side < 0: y axis turned about).
  Target mirrored(int time, int side) const {
    const double turn = time * side;
    return {time * x, side * y, turn * heading, turn * sin, cos};
  }
  /// Words to it are words to the goal in the opposite order.
  Target reversed() const { return {x * cos + y * sin, x * sin - y * cos, heading, sin, cos}; }
};

double arc_cosine(double c) { return arc_tangent(std::sqrt((1.0 - c) * (1.0 + c)), c); }
double arc_sine(double s) { return arc_tangent(s, std::sqrt((1.0 - s) * (1.0 + s))); }

/// Collects the shortest word over all families and symmetries.
class Search {
 public:
  /// Words of `limit` radii and more are none.
  explicit Search(const Target& goal, double limit = std::numeric_limits<double>::infinity()) : limit_{limit} {
    // Words with few parts first: later ones have to be shorter.
    for_each_symmetry(goal, [this](const Target& g) {
      if (!reverse_) turn_straight_turn(g);
      three_turns(g);
    });
    for_each_symmetry(goal, [this](const Target& g) {
      two_turns_straight_turn(g);
      if (reverse_) return;
      four_turns(g);
      two_turns_straight_two_turns(g);
    });
  }
  const ReedsSheppWord& best() const { return best_; }

 private:
  template <class Families>
  void for_each_symmetry(const Target& goal, const Families& families) {
    for (const bool reverse : {false, true}) {
      for (const int time : {1, -1}) {
        for (const int side : {1, -1}) {
          reverse_ = reverse;
          time_ = time;
          side_ = side;
          families((reverse ? goal.reversed() : goal).mirrored(time, side));
        }
      }
    }
  }

  /// Is a word that has parts of this length together still of use? Asked before its angles are made.
  bool is_worth(double parts) const { return parts < limit_; }

  void offer(std::initializer_list<ReedsSheppWord::Part> parts) {
    double length = 0.0;
    for (const auto& part : parts) length += std::abs(part.length);
    if (!is_worth(length)) return;
    best_.length = length;
    limit_ = length - least_gain;
    best_.count = parts.size();
    std::size_t i = reverse_ ? parts.size() : 0;
    for (const auto& part : parts) {
      best_.parts[reverse_ ? --i : i++] = {side_ * part.side, time_ * part.length};
    }
  }

  void turn_straight_turn(const Target& g) {
    {  // 8.1: L+ S+ L+
      const Vec2 between{g.x - g.sin, g.y - 1.0 + g.cos};
      if (const double u = norm(between); is_worth(u)) {
        const double t = angle_of(between);
        const double v = wrap(g.heading - t);
        // The nearer the centres, the more rounding is in the angle: one turn is none and the other all of it, so that the heading stays exact.
        const double slack = std::max(sign_slack, std::min(most_slack, rounding / u));
        if (t >= -sign_slack && v >= -sign_slack) {
          offer({{left, t}, {straight, u}, {left, v}});
        } else if (std::abs(t) <= slack && g.heading >= -sign_slack) {
          offer({{straight, u}, {left, g.heading}});
        } else if (std::abs(v) <= slack && g.heading >= -sign_slack) {
          offer({{left, g.heading}, {straight, u}});
        }
      }
    }
    {  // 8.2: L+ S+ R+
      const Vec2 between{g.x + g.sin, g.y - 1.0 - g.cos};
      const double r = norm(between);
      if (r < 2.0) return;
      const double u = std::sqrt((r - 2.0) * (r + 2.0));
      if (!is_worth(u)) return;
      const double t = wrap(angle_of(between) + arc_tangent(2.0, u));
      const double v = wrap(t - g.heading);
      if (t >= -sign_slack && v >= -sign_slack) offer({{left, t}, {straight, u}, {right, v}});
    }
  }

  void three_turns(const Target& g) {  // 8.3, 8.4: L+ R− L±
    const Vec2 between{g.x - g.sin, g.y - 1.0 + g.cos};
    const double r = norm(between);
    if (r > 4.0) return;
    const double u = -2.0 * arc_sine(0.25 * r);
    if (!is_worth(-u)) return;
    const double t = wrap(angle_of(between) + 0.5 * u + pi);
    const double v = wrap(g.heading - t + u);
    if (t >= -sign_slack) offer({{left, t}, {right, u}, {left, v}});
  }

  void two_turns_straight_turn(const Target& g) {
    {  // 8.9: L+ R−(π/2) S− L−
      const Vec2 between{g.x - g.sin, g.y - 1.0 + g.cos};
      const double r = norm(between);
      if (r >= 2.0) {
        const double chord = std::sqrt((r - 2.0) * (r + 2.0));
        const double u = 2.0 - chord;
        if (u <= sign_slack && is_worth(0.5 * pi + std::abs(u))) {
          const double t = wrap(angle_of(between) + arc_tangent(chord, -2.0));
          const double v = wrap(g.heading - 0.5 * pi - t);
          if (t >= -sign_slack && v <= sign_slack) offer({{left, t}, {right, -0.5 * pi}, {straight, u}, {left, v}});
        }
      }
    }
    {  // 8.10: L+ R−(π/2) S− R−
      const Vec2 between{1.0 + g.cos - g.y, g.x + g.sin};
      const double u = 2.0 - norm(between);
      if (u > sign_slack || !is_worth(0.5 * pi + std::abs(u))) return;
      const double t = angle_of(between);
      const double v = wrap(t + 0.5 * pi - g.heading);
      if (t >= -sign_slack && v <= sign_slack) offer({{left, t}, {right, -0.5 * pi}, {straight, u}, {right, v}});
    }
  }

  /// First and last turn of a word of four turns whose inner ones are u and v (the paper's τ and ω).
  static std::pair<double, double> outer_turns(double u, double v, double xi, double eta, double heading) {
    const SinCos of_u = sin_cos(u);
    const SinCos of_v = sin_cos(v);
    const SinCos of_d = sin_cos(wrap(u - v));
    const double a = of_u.sin - of_d.sin;
    const double b = of_u.cos - of_d.cos - 1.0;
    const double angle = arc_tangent(eta * a - xi * b, xi * a + eta * b);
    const double tau = wrap(2.0 * (of_d.cos - of_v.cos - of_u.cos) + 3.0 < 0.0 ? angle + pi : angle);
    return {tau, wrap(tau - u + v - heading)};
  }

  void four_turns(const Target& g) {
    const double xi = g.x + g.sin;
    const double eta = g.y - 1.0 - g.cos;
    const double squared = xi * xi + eta * eta;
    if (const double rho = 0.25 * (2.0 + std::sqrt(squared)); rho <= 1.0) {  // 8.7: L+ R+(u) L−(u) R−
      const double u = arc_cosine(rho);
      if (is_worth(u + u)) {
        const auto [t, v] = outer_turns(u, -u, xi, eta, g.heading);
        if (t >= -sign_slack && v <= sign_slack) offer({{left, t}, {right, u}, {left, -u}, {right, v}});
      }
    }
    if (const double rho = (20.0 - squared) / 16.0; rho >= 0.0 && rho <= 1.0) {  // 8.8: L+ R−(u) L−(u) R+
      const double u = -arc_cosine(rho);
      if (!is_worth(-u - u)) return;
      const auto [t, v] = outer_turns(u, u, xi, eta, g.heading);
      if (t >= -sign_slack && v >= -sign_slack) offer({{left, t}, {right, u}, {left, u}, {right, v}});
    }
  }

  void two_turns_straight_two_turns(const Target& g) {  // 8.11: L+ R−(π/2) S− L−(π/2) R+
    const double xi = g.x + g.sin;
    const double eta = g.y - 1.0 - g.cos;
    const double r = norm({xi, eta});
    if (r < 2.0) return;
    const double u = 4.0 - std::sqrt((r - 2.0) * (r + 2.0));
    if (u > sign_slack || !is_worth(pi + std::abs(u))) return;
    const double t = wrap(arc_tangent((4.0 - u) * xi - 2.0 * eta, -2.0 * xi + (u - 4.0) * eta));
    const double v = wrap(t - g.heading);
    if (t >= -sign_slack && v >= -sign_slack) {
      offer({{left, t}, {right, -0.5 * pi}, {straight, u}, {left, -0.5 * pi}, {right, v}});
    }
  }

  int time_ = 1;
  int side_ = 1;
  bool reverse_ = false;
  double limit_;  ///< radii
  ReedsSheppWord best_;
};

Pose facing(const CurvePoint& point, int direction) {
  return make_pose(point.position, direction < 0 ? wrap(point.course + pi) : point.course);
}

CurvePoint evaluate(const Piece& piece, double s) {
  if (const auto* arc = std::get_if<Arc>(&piece.curve)) return waywright::evaluate(*arc, s);
  return waywright::evaluate(std::get<Line>(piece.curve), s);
}

Piece cut(const Piece& piece, double begin, double end) {
  const CurvePoint start = evaluate(piece, begin);
  if (const auto* arc = std::get_if<Arc>(&piece.curve)) {
    return {Arc{make_pose(start.position, start.course), arc->curvature, end - begin}, piece.direction};
  }
  return {Line{start.position, evaluate(piece, end).position}, piece.direction};
}

bool goes_on(const Piece& a, const Piece& b) {
  if (a.direction != b.direction || a.curve.index() != b.curve.index()) return false;
  const auto* arc = std::get_if<Arc>(&a.curve);
  return arc == nullptr || arc->curvature == std::get<Arc>(b.curve).curvature;
}

}  // namespace

namespace {

Target target(const Pose& from, const Pose& to, double radius) {
  const Vec2 there = (1.0 / radius) * Frame{from}.unrotate(to.position() - from.position());
  const double heading = shorter_turn(from.heading, to.heading);
  const SinCos of_heading = sin_cos(heading);
  return {there.x, there.y, heading, of_heading.sin, of_heading.cos};
}

ReedsSheppWord driven_back(ReedsSheppWord word) {
  std::reverse(word.parts.begin(), word.parts.begin() + static_cast<std::ptrdiff_t>(word.count));
  for (TurningPart& part : word.parts) part.length = -part.length;
  return word;
}

}  // namespace

ReedsSheppWord ReedsShepp::shortest(const Pose& from, const Pose& to) const {
  return comes_first(from, to) ? Search{target(from, to, radius_)}.best() : driven_back(Search{target(to, from, radius_)}.best());
}

double ReedsShepp::distance_under(const Pose& from, const Pose& to, double limit) const {
  // A little more than the limit: the same word as without one wherever it counts.
  const Target there = comes_first(from, to) ? target(from, to, radius_) : target(to, from, radius_);
  const ReedsSheppWord word = Search{there, limit / radius_ + 1e-9}.best();
  return word.count > 0 ? radius_ * word.length : std::numeric_limits<double>::infinity();
}

Pieces ReedsShepp::between(const Pose& from, const Pose& to) const {
  const ReedsSheppWord word = shortest(from, to);
  return turning_pieces(from, std::span{word.parts.data(), word.count}, radius_);
}

Pieces turning_pieces(const Pose& from, std::span<const TurningPart> parts, double radius) {
  Pieces pieces;
  Pose pose = from;
  for (const TurningPart& part : parts) {
    const double metres = radius * std::abs(part.length);
    if (metres < least_segment) continue;
    Piece piece;
    piece.direction = part.length > 0.0 ? 1 : -1;
    const Pose start =
        make_pose(pose.position(), piece.direction > 0 ? pose.heading : wrap(pose.heading + pi));
    if (part.side == straight) {
      const Line line{start.position(), start.position() + metres * unit(start.heading)};
      piece.curve = line;
      pose = make_pose(line.to, pose.heading);  // that of two near points far from the origin is worse
    } else {
      // Curvature in the direction of travel: a left curve driven backwards bends the course to the right.
      piece.curve = Arc{start, static_cast<double>(part.side * piece.direction) / radius, metres};
      pose = end_pose(piece);
    }
    append_merged(pieces, piece);
  }
  return pieces;
}

void append_merged(Pieces& pieces, const Piece& piece) {
  if (pieces.empty() || !goes_on(pieces.back(), piece)) {
    pieces.push_back(piece);
    return;
  }
  Curve& last = pieces.back().curve;
  if (auto* arc = std::get_if<Arc>(&last)) {
    arc->length += std::get<Arc>(piece.curve).length;
  } else {
    std::get<Line>(last).to = std::get<Line>(piece.curve).to;
  }
}

Pieces part_of(const Pieces& pieces, double begin, double end) {
  Pieces part;
  double before = 0.0;
  for (const Piece& piece : pieces) {
    const double metres = length(piece);
    const double from = std::clamp(begin - before, 0.0, metres);
    const double to = std::clamp(end - before, 0.0, metres);
    if (from <= 0.0 && to >= metres) {
      part.push_back(piece);
    } else if (to - from >= least_part) {
      part.push_back(cut(piece, from, to));
    }
    before += metres;
  }
  return part;
}

Pose pose_at(const Pieces& pieces, double s) {
  for (const Piece& piece : pieces) {
    const double metres = length(piece);
    if (s <= metres) return facing(evaluate(piece, std::max(0.0, s)), piece.direction);
    s -= metres;
  }
  return end_pose(pieces.back());
}

}  // namespace waywright
