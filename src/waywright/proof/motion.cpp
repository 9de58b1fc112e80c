#include "waywright/proof/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Pose vehicle_pose(Vec2 position, double course, int direction) { return make_pose(position, direction < 0 ? course + pi : course); }

/// At an end of a span, where its tangent is `along`.
Pose pose_at_end(Vec2 position, Vec2 along, int direction) {
  return vehicle_pose(position, squared_norm(along) > 0.0 ? angle_of(along) : 0.0, direction);
}
Pose begin_of(const BezierSpan& span, int direction) {
  return pose_at_end(span.control[0], span.control[1] - span.control[0], direction);
}
Pose end_of(const BezierSpan& span, int direction) {
  const auto n = static_cast<std::size_t>(span.degree);
  return pose_at_end(span.control[n], span.control[n] - span.control[n - 1], direction);
}

/// The continuous heading differs from the wrapped one by a multiple of 2π; intervals that turn by more than π at once have
/// a deviation so large that they are halved before it matters.
Pose continued(const Pose& begin, Pose end) {
  if (std::abs(end.heading - begin.heading) > pi) end.heading = begin.heading + shorter_turn(begin.heading, end.heading);
  return end;
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

MotionInterval MotionInterval::straight(const Pose& begin, const Pose& end, int direction) {
  MotionInterval interval;
  interval.begin_ = begin;
  interval.end_ = end;
  interval.direction_ = direction;
  return interval;
}

MotionInterval MotionInterval::of(const Clothoid& clothoid, int direction) {
  const CurvePoint a = evaluate(clothoid, 0.0);
  const CurvePoint b = evaluate(clothoid, clothoid.length);
  MotionInterval interval = straight(vehicle_pose(a.position, a.course, direction), vehicle_pose(b.position, b.course, direction), direction);
  interval.end_.heading = interval.begin_.heading + clothoid.length * (clothoid.curvature + 0.5 * clothoid.curvature_rate * clothoid.length);
  interval.curve_ = clothoid;
  interval.whole_length_ = clothoid.length;
  interval.whole_turning_ = greatest_curvature(clothoid) * clothoid.length + std::abs(clothoid.start.heading);
  return interval;
}

void MotionInterval::head_evenly(double from, double to) {
  faces_along_ = false;
  begin_.heading = from;
  end_.heading = to;
}

MotionInterval MotionInterval::of(const BoundedSpan& span, int direction) {
  const Pose begin = begin_of(span.span, direction);
  MotionInterval interval = straight(begin, continued(begin, end_of(span.span, direction)), direction);
  interval.curve_ = &span;
  return interval;
}

void Motion::reserve(std::size_t pieces, std::size_t curves) {
  begins_.reserve(pieces + 1);
  intervals_.reserve(curves);
  spans_.reserve(curves);
}

void Motion::assign(const Path& path) {
  begins_.clear();
  intervals_.clear();
  spans_.clear();
  std::size_t spans = 0;
  for (const Piece& piece : path.pieces) {
    if (const auto* spline = std::get_if<Spline>(&piece.curve)) spans += spline->spans.size();
  }
  spans_.reserve(spans);  // intervals point to them
  for (const Piece& piece : path.pieces) {
    begins_.push_back(intervals_.size());
    add(piece);
  }
  begins_.push_back(intervals_.size());
}

std::span<const MotionInterval> Motion::intervals(std::size_t first, std::size_t last) const {
  return intervals().subspan(begins_[first], begins_[last] - begins_[first]);
}

void Motion::add(const Piece& piece) {
  const auto straight = [&](const Pose& a, const Pose& b) { intervals_.push_back(MotionInterval::straight(a, b, piece.direction)); };
  std::visit(
      [&](const auto& curve) {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          Pose begin = start_pose(piece), end = end_pose(piece);
          if (piece.heading) {
            begin.heading = piece.heading->from;
            end.heading = piece.heading->from + piece.heading->turn;
          }
          straight(begin, end);
        } else if constexpr (std::is_same_v<C, Arc>) {
          intervals_.push_back(MotionInterval::of(Clothoid{curve.start, curve.curvature, 0.0, curve.length}, piece.direction));
          if (piece.heading) intervals_.back().head_evenly(piece.heading->from, piece.heading->from + piece.heading->turn);
        } else if constexpr (std::is_same_v<C, Clothoid>) {
          intervals_.push_back(MotionInterval::of(curve, piece.direction));
        } else if constexpr (std::is_same_v<C, Turn>) {
          straight(make_pose(curve.at, curve.from), make_pose(curve.at, curve.from + curve.angle));
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          for (std::size_t i = 0; i + 1 < curve.poses.size(); ++i) straight(curve.poses[i], continued(curve.poses[i], curve.poses[i + 1]));
        } else {
          for (const BezierSpan& span : curve.spans) {
            if (span.degree == 1) {
              const double heading = wrap(begin_of(span, piece.direction).heading);
              straight(make_pose(span.control[0], heading), make_pose(span.control[1], heading));
              continue;
            }
            spans_.push_back({span, CurvatureBounds{span}});
            intervals_.push_back(MotionInterval::of(spans_.back(), piece.direction));
          }
        }
      },
      piece.curve);
}

double MotionInterval::deviation(double radius) const {
  const double turned = std::abs(end_.heading - begin_.heading);
  // (Where the vehicle does not face along an arc, its heading is that even turning itself.) Rotating a point evenly by `turned` leaves the chord between its two places by at most radius·turned²/8.
  const double chord = radius * turned * turned / 8.0;
  if (std::holds_alternative<Straight>(curve_)) return chord;
  if (const auto* c = std::get_if<Clothoid>(&curve_)) {
    // Position and heading leave their chords by at most |κ|l²/8 and |κ′|l²/8.
    return chord + (greatest_curvature(*c) + radius * std::abs(c->curvature_rate)) * c->length * c->length / 8.0;
  }
  const BoundedSpan& p = *span();
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

MotionHalves::MotionHalves(const MotionInterval& whole) : left{whole}, right{whole} {
  if (const BoundedSpan* p = whole.span()) {
    std::tie(left_span_.span, right_span_.span) = halve(p->span);
    p->bounds.halve(left_span_.bounds, right_span_.bounds);
    left.end_ = right.begin_ = continued(whole.begin_, begin_of(right_span_.span, whole.direction_));
    right.end_ = continued(right.begin_, whole.end_);
    left.curve_ = &left_span_;
    right.curve_ = &right_span_;
  } else if (const auto* c = std::get_if<Clothoid>(&whole.curve_)) {
    const double half = 0.5 * c->length;
    Clothoid first = *c;
    Clothoid second = *c;
    first.length = second.length = half;
    second.start = make_pose(evaluate(*c, half).position, course_at(*c, half));
    second.curvature = c->curvature + c->curvature_rate * half;
    left = MotionInterval::of(first, whole.direction_);
    right = MotionInterval::of(second, whole.direction_);
    left.whole_length_ = right.whole_length_ = whole.whole_length_;
    left.whole_turning_ = right.whole_turning_ = whole.whole_turning_;
    if (!whole.faces_along_) {
      const double middle = 0.5 * (whole.begin_.heading + whole.end_.heading);
      left.head_evenly(whole.begin_.heading, middle);
      right.head_evenly(middle, whole.end_.heading);
    }
  } else {
    left.end_ = right.begin_ =
        make_pose(0.5 * (whole.begin_.position() + whole.end_.position()), 0.5 * (whole.begin_.heading + whole.end_.heading));
  }
  left.depth_ = right.depth_ = whole.depth_ + 1;
}

const BoundedSpan* MotionInterval::span() const {
  const auto* p = std::get_if<const BoundedSpan*>(&curve_);
  return p == nullptr ? nullptr : *p;
}

bool MotionInterval::is_translation() const { return std::holds_alternative<Straight>(curve_) && begin_.heading == end_.heading; }

double MotionInterval::rounding(double radius) const {
  double reach = std::max({std::abs(begin_.x), std::abs(begin_.y), std::abs(end_.x), std::abs(end_.y)});
  double heading = unit_roundoff * std::max(std::abs(begin_.heading), std::abs(end_.heading));
  // Of an integral 2e-14 of the way, and what a rounded course does over it.
  if (std::holds_alternative<Clothoid>(curve_)) {
    reach += whole_length_ * (3.0 + 0.1 * whole_turning_);
    heading += unit_roundoff * whole_turning_;
  }
  if (const BoundedSpan* p = span()) {
    // Control points are rounded at each halving, and a tangent is their difference. Without a bound on speed there is none on turning.
    for (std::size_t i = 0; i <= static_cast<std::size_t>(p->span.degree); ++i) {
      reach = std::max({reach, std::abs(p->span.control[i].x), std::abs(p->span.control[i].y)});
    }
    const double slowest = p->bounds.speed2.low();
    heading += slowest > 0.0 ? 16.0 * (1.0 + depth_) * unit_roundoff * reach / std::sqrt(slowest) : pi;
  }
  return 1e-14 * (1.0 + 0.1 * depth_) * (reach + radius) + 4.0 * radius * heading;
}

double MotionInterval::course_at_begin() const {
  if (!faces_along_) return std::get<Clothoid>(curve_).start.heading;
  return direction_ < 0 ? begin_.heading + pi : begin_.heading;
}

double MotionInterval::course_at_end() const {
  if (!faces_along_) {
    const Clothoid& c = std::get<Clothoid>(curve_);
    return c.start.heading + c.length * (c.curvature + 0.5 * c.curvature_rate * c.length);
  }
  return direction_ < 0 ? end_.heading + pi : end_.heading;
}

double MotionInterval::curvature_at_begin() const {
  if (const auto* c = std::get_if<Clothoid>(&curve_)) return c->curvature;
  return span() == nullptr ? 0.0 : evaluate(span()->span, 0.0).curvature;
}

double MotionInterval::curvature_rate() const {
  const auto* c = std::get_if<Clothoid>(&curve_);
  return c == nullptr ? 0.0 : c->curvature_rate;
}

double MotionInterval::curvature_at_end() const {
  if (const auto* c = std::get_if<Clothoid>(&curve_)) return end_curvature(*c);
  return span() == nullptr ? curvature_at_begin() : evaluate(span()->span, 1.0).curvature;
}

Pose MotionInterval::pose_at(double u) const {
  const CurvePoint point = evaluate(span()->span, u);
  return vehicle_pose(point.position, point.course, direction_);
}

double MotionInterval::length() const {
  if (const auto* c = std::get_if<Clothoid>(&curve_)) return c->length;
  if (const BoundedSpan* p = span()) return arc_length(p->span);
  return distance(begin_.position(), end_.position());
}

}  // namespace waywright
