#include "waywright/proof/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Pose vehicle_pose(const CurvePoint& point, int direction) {
  return make_pose(point.position, direction < 0 ? point.course + pi : point.course);
}

/// Relative slack of quotients of bounds.
constexpr double quotient_rounding = 1e-12;
constexpr double unit_roundoff = 0x1p-53;

/// How far the span's control points are from those of the straight, evenly driven segment between its ends.
double bow(const BezierSpan& span) {
  double greatest = 0.0;
  const auto n = static_cast<std::size_t>(span.degree);
  for (std::size_t i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n);
    const Vec2 even = span.control[0] + t * (span.control[n] - span.control[0]);
    greatest = std::max(greatest, distance(span.control[i], even));
  }
  return greatest;
}

}  // namespace

MotionInterval MotionInterval::make(Polynomial polynomial, int direction) {
  MotionInterval interval;
  interval.direction_ = direction;
  const CurvePoint a = evaluate(polynomial.span, 0.0);
  const CurvePoint b = evaluate(polynomial.span, 1.0);
  interval.begin_ = vehicle_pose(a, direction);
  interval.end_ = vehicle_pose(b, direction);
  // The continuous heading differs from the wrapped one by a multiple of 2π; intervals that turn by more than π at once have
  // a deviation so large that they are halved before it matters.
  interval.end_.heading = interval.begin_.heading + shorter_turn(interval.begin_.heading, interval.end_.heading);
  interval.curve_ = std::make_shared<const Polynomial>(std::move(polynomial));
  return interval;
}

MotionInterval MotionInterval::make(const Arc& arc, int direction) {
  MotionInterval interval;
  interval.direction_ = direction;
  interval.begin_ = vehicle_pose(evaluate(arc, 0.0), direction);
  interval.end_ = vehicle_pose(evaluate(arc, arc.length), direction);
  interval.end_.heading = interval.begin_.heading + arc.curvature * arc.length;
  interval.curve_ = Circular{arc};
  return interval;
}

std::vector<MotionInterval> MotionInterval::of(const Piece& piece) {
  std::vector<MotionInterval> intervals;
  const auto straight = [&](const Pose& a, const Pose& b) {
    MotionInterval interval;
    interval.direction_ = piece.direction;
    interval.begin_ = a;
    interval.end_ = b;
    intervals.push_back(std::move(interval));
  };
  std::visit(
      [&](const auto& curve) {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          straight(start_pose(piece), end_pose(piece));
        } else if constexpr (std::is_same_v<C, Arc>) {
          intervals.push_back(make(curve, piece.direction));
        } else if constexpr (std::is_same_v<C, Turn>) {
          straight(make_pose(curve.at, curve.from), make_pose(curve.at, curve.from + curve.angle));
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          for (std::size_t i = 0; i + 1 < curve.poses.size(); ++i) {
            const Pose& a = curve.poses[i];
            Pose b = curve.poses[i + 1];
            b.heading = a.heading + shorter_turn(a.heading, b.heading);
            straight(a, b);
          }
        } else {
          for (const BezierSpan& span : curve.spans) {
            if (span.degree == 1) {
              const Piece line{Line{span.control[0], span.control[1]}, piece.direction};
              straight(start_pose(line), end_pose(line));
              continue;
            }
            intervals.push_back(make(Polynomial{span, SpanBounds{span}}, piece.direction));
          }
        }
      },
      piece.curve);
  return intervals;
}

double MotionInterval::deviation(double radius) const {
  const double turned = std::abs(end_.heading - begin_.heading);
  // Rotating a point evenly by `turned` leaves the chord between its two places by at most radius·turned²/8.
  const double chord = radius * turned * turned / 8.0;
  if (std::holds_alternative<Straight>(curve_)) return chord;
  if (const auto* circular = std::get_if<Circular>(&curve_)) {
    return chord + std::abs(circular->arc.curvature) * circular->arc.length * circular->arc.length / 8.0;
  }
  const Polynomial& p = *polynomial();
  // Position: difference from the even segment lies in the hull of the control points' differences.
  // Heading: θ′ = N/D lies in [m, M] on the interval (u from 0 to 1), so θ leaves its chord by at most (M − m)/4. The true
  // turn is also within (M − m)/2 of `turned`, which rules out a lost multiple of 2π when the bound is under π.
  const double d_low = p.bounds.speed2.low();
  if (!(d_low > 0.0)) return infinity;
  const double d_high = p.bounds.speed2.high();
  const double n_low = p.bounds.turn.low();
  const double n_high = p.bounds.turn.high();
  const double rate_low = n_low < 0.0 ? n_low / d_low : n_low / d_high;
  const double rate_high = n_high > 0.0 ? n_high / d_low : n_high / d_high;
  if (std::max(std::abs(rate_low), std::abs(rate_high)) > pi) return infinity;
  const double heading = 0.25 * (rate_high - rate_low) * (1.0 + quotient_rounding);
  return chord + bow(p.span) + radius * heading;
}

std::pair<MotionInterval, MotionInterval> MotionInterval::halve() const {
  auto both = halves();
  both.first.depth_ = both.second.depth_ = depth_ + 1;
  return both;
}

std::pair<MotionInterval, MotionInterval> MotionInterval::halves() const {
  if (const Polynomial* p = polynomial()) {
    const auto [left, right] = waywright::halve(p->span);
    auto [left_bounds, right_bounds] = p->bounds.halves();
    return {make(Polynomial{left, std::move(left_bounds)}, direction_), make(Polynomial{right, std::move(right_bounds)}, direction_)};
  }
  if (const auto* c = std::get_if<Circular>(&curve_)) {
    const double half = 0.5 * c->arc.length;
    Arc left = c->arc;
    Arc right = c->arc;
    left.length = right.length = half;
    const CurvePoint middle = evaluate(c->arc, half);
    right.start = make_pose(middle.position, c->arc.start.heading + c->arc.curvature * half);
    return {make(left, direction_), make(right, direction_)};
  }
  MotionInterval left = *this;
  MotionInterval right = *this;
  left.end_ = make_pose(0.5 * (begin_.position() + end_.position()), 0.5 * (begin_.heading + end_.heading));
  right.begin_ = left.end_;
  return {left, right};
}

const MotionInterval::Polynomial* MotionInterval::polynomial() const {
  const auto* p = std::get_if<std::shared_ptr<const Polynomial>>(&curve_);
  return p == nullptr ? nullptr : p->get();
}

bool MotionInterval::is_translation() const { return std::holds_alternative<Straight>(curve_) && begin_.heading == end_.heading; }

double MotionInterval::rounding(double radius) const {
  double reach = std::max({std::abs(begin_.x), std::abs(begin_.y), std::abs(end_.x), std::abs(end_.y)});
  double heading = unit_roundoff * std::max(std::abs(begin_.heading), std::abs(end_.heading));
  if (const auto* circular = std::get_if<Circular>(&curve_)) reach += circular->arc.length;
  if (const Polynomial* p = polynomial()) {
    // Control points of the halves are rounded, and a tangent is their difference. Without a bound on speed there is none on turning.
    for (std::size_t i = 0; i <= static_cast<std::size_t>(p->span.degree); ++i) {
      reach = std::max({reach, std::abs(p->span.control[i].x), std::abs(p->span.control[i].y)});
    }
    const double slowest = p->bounds.speed2.low();
    heading += slowest > 0.0 ? 16.0 * unit_roundoff * reach / std::sqrt(slowest) : pi;
  }
  return 1e-14 * (reach + radius) + 4.0 * radius * heading;
}

double MotionInterval::curvature_bound() const {
  if (const auto* circular = std::get_if<Circular>(&curve_)) return std::abs(circular->arc.curvature);
  const Polynomial* p = polynomial();
  return p == nullptr ? 0.0 : p->bounds.curvature();
}

double MotionInterval::curvature_rate_bound() const {
  const Polynomial* p = polynomial();
  return p == nullptr ? 0.0 : p->bounds.curvature_rate();
}

double MotionInterval::curvature_at(double u) const {
  if (const auto* circular = std::get_if<Circular>(&curve_)) return circular->arc.curvature;
  if (const Polynomial* p = polynomial()) return evaluate(p->span, u).curvature;
  return 0.0;
}

double MotionInterval::curvature_at_begin() const { return curvature_at(0.0); }
double MotionInterval::curvature_at_end() const { return curvature_at(1.0); }

double MotionInterval::curvature_rate_at_begin() const {
  const Polynomial* p = polynomial();
  return p == nullptr ? 0.0 : evaluate(p->span, 0.0).curvature_rate;
}

double MotionInterval::length() const {
  if (const auto* circular = std::get_if<Circular>(&curve_)) return circular->arc.length;
  if (const Polynomial* p = polynomial()) return arc_length(p->span);
  return distance(begin_.position(), end_.position());
}

}  // namespace waywright
