#include "waywright/planner/docking/cost_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-6;  // share by which a bound is lowered: single precision of what it is held against
constexpr int last_sample = lanes::samples - 1;

/// Weights of chord, first and last tangent in p, p′ and p″ at a parameter.
struct Weights {
  double e, a, c, e1, a1, c1, e2, a2, c2;
};
Weights weights_at(double u) {
  const double u2 = u * u, u3 = u2 * u, u4 = u2 * u2, u5 = u4 * u;
  return {10 * u3 - 15 * u4 + 6 * u5,   u - 6 * u3 + 8 * u4 - 3 * u5,    -4 * u3 + 7 * u4 - 3 * u5,
          30 * u2 - 60 * u3 + 30 * u4,  1 - 18 * u2 + 32 * u3 - 15 * u4, -12 * u2 + 28 * u3 - 15 * u4,
          60 * u - 180 * u2 + 120 * u3, -36 * u + 96 * u2 - 60 * u3,     -24 * u + 84 * u2 - 60 * u3};
}

/// Bounds on 1 − cos of half an angle, clipped at a half turn, and on its slope, for an angle within `off` of `angle`.
struct Missing {
  double most, slope;
};
Missing missing(double angle, double off) {
  const SinCos at = sin_cos(std::min(0.5 * (std::abs(angle) + off), 0.5 * pi));
  return {1.0 - at.cos, 0.5 * at.sin};
}

struct Range {
  double low, high;
};

}  // namespace

/// All quintics of a box between a first and a last point, as the one at its middle and how far they can be from it.
struct PatternBounds::Family {
  Vec2 from{}, chord{};
  Vec2 first{}, last{};                   ///< courses at the middle
  double from_off = 0.0, to_off = 0.0;    ///< m
  double first_off = 0.0, last_off = 0.0; ///< rad
  double tangent = 0.0, tangent_off = 0.0;  ///< m, length of both tangents
  bool is_bounded = false;                ///< false: nothing can be said

  void finish() {
    const double far = norm(chord), off = from_off + to_off;
    if (far <= off) return;
    const double along = angle_of(chord);
    const double turned = 1.01 * arc_tangent(off, std::sqrt(far * far - off * off));
    const double alpha = wrap(angle_of(first) - along), beta = wrap(angle_of(last) - along);
    const double alpha_off = turned + first_off, beta_off = turned + last_off;
    // m jumps where an angle passes a half turn.
    if (std::abs(alpha) + alpha_off >= pi || std::abs(beta) + beta_off >= pi) return;
    const BezierSpan span = joining_quintic({}, first, chord, last);
    tangent = 5.0 * norm(span.control[1] - span.control[0]);
    const Missing t = missing(alpha - beta, alpha_off + beta_off), s = missing(alpha + beta, alpha_off + beta_off);
    const double slope = (0.45 + 0.5 * t.most + 3.8 * t.most * t.most * t.most) * t.slope + 0.3 * s.slope;  // of m
    const double m_off = slope * (alpha_off + beta_off);
    tangent_off = (tangent / far) * off + m_off * (far + off);
    is_bounded = true;
  }
  /// e·chord + tangent·(a·first + c·last) at the middle, and how far the others' are from it.
  Vec2 sum(double e, double a, double c) const { return e * chord + tangent * (a * first + c * last); }
  double off(double e, double a, double c) const {
    return std::abs(e) * (from_off + to_off) + tangent_off * norm(a * first + c * last) +
           (tangent + tangent_off) * (std::abs(a) * first_off + std::abs(c) * last_off);
  }

  double length_bound() const {
    constexpr int parts = 16;
    double length = 0.0;
    Weights before = weights_at(0.0);
    for (int i = 1; i <= parts; ++i) {
      const Weights w = weights_at(static_cast<double>(i) / parts);
      const double e = w.e - before.e, a = w.a - before.a, c = w.c - before.c;
      length += std::max(0.0, norm(sum(e, a, c)) - off(e, a, c));
      before = w;
    }
    return std::max(norm(chord) - from_off - to_off, length);
  }
  double curvature_at(const Weights& w) const {
    const Vec2 p1 = sum(w.e1, w.a1, w.c1);
    const double speed = norm(p1);
    return speed > 0.0 ? cross(p1, sum(w.e2, w.a2, w.c2)) / (speed * speed * speed) : infinity;
  }
  Range curvatures_at(const Weights& w) const {
    const Vec2 p1 = sum(w.e1, w.a1, w.c1), p2 = sum(w.e2, w.a2, w.c2);
    const double off1 = off(w.e1, w.a1, w.c1), off2 = off(w.e2, w.a2, w.c2);
    const double slow = norm(p1) - off1, fast = norm(p1) + off1;
    if (!(slow > 0.0)) return {-infinity, infinity};
    const double turn = cross(p1, p2);
    const double turn_off = norm(p1) * off2 + norm(p2) * off1 + off1 * off2;
    const double low = turn - turn_off, high = turn + turn_off;
    const auto over = [](double value, double speed) { return value / (speed * speed * speed); };
    return {over(low, low > 0.0 ? fast : slow), over(high, high > 0.0 ? slow : fast)};
  }
  double change_bound() const {
    Range before{0.0, 0.0};  // no curvature at both ends
    double change = 0.0, k0 = 0.0;
    Weights here = weights_at(1.0 / last_sample);
    double k1 = curvature_at(here);
    for (int i = 1; i < last_sample; ++i) {
      const Weights next = weights_at(static_cast<double>(i + 1) / last_sample);
      const double k2 = i + 1 < last_sample ? curvature_at(next) : 0.0;
      if ((k1 - k0) * (k2 - k1) < 0.0) {
        if (const Range range = curvatures_at(here); std::isfinite(range.low)) {
          change += std::max({0.0, range.low - before.high, before.low - range.high});
          before = range;
        }
      }
      k0 = k1;
      k1 = k2;
      here = next;
    }
    return change + std::max({0.0, -before.high, before.low});
  }
};

PatternBounds::PatternBounds(const PreparedDocking& prepared, Side side, const PatternLeads& leads)
    : prepared_{prepared}, start_{placement_of(prepared.task().start)}, dock_{placement_of(prepared.task().dock)}, side_{side}, leads_{leads} {}

std::array<PatternBounds::Family, 2> PatternBounds::families_of(const TransitionBox& box) const {
  const double half_turn = 0.5 * (box.offset_high - box.offset_low);
  const Vec2 heading = unit(transition_heading(side_, prepared_.task().dock.heading, 0.5 * (box.offset_low + box.offset_high)));
  const Vec2 middle = 0.5 * (box.low + box.high) + leads_.transition * heading;
  const double radius = 0.5 * norm(box.high - box.low) + leads_.transition * half_turn;
  Family back, forth;
  back.from = start_.position - leads_.start * start_.heading;
  back.chord = middle - back.from;
  back.first = -start_.heading;
  back.last = -heading;
  back.to_off = radius;
  back.last_off = half_turn;
  forth.from = middle;
  forth.chord = dock_.position - leads_.dock * dock_.heading - middle;
  forth.first = heading;
  forth.last = dock_.heading;
  forth.from_off = radius;
  forth.first_off = half_turn;
  back.finish();
  forth.finish();
  return {back, forth};
}

PatternBound PatternBounds::over(const TransitionBox& box) const {
  PatternBound bound;
  bound.length = leads_.start + leads_.dock + 2.0 * leads_.transition;
  for (const Family& family : families_of(box)) {
    if (!family.is_bounded) {
      bound.length += std::max(0.0, norm(family.chord) - family.from_off - family.to_off);
      continue;
    }
    bound.length += family.length_bound();
    bound.curvature_change += family.change_bound();
  }
  return {bound.length * (1.0 - rounding), bound.curvature_change * (1.0 - rounding)};
}

bool PatternBounds::all_collide(const TransitionBox& box) const {
  constexpr int stride = 3;
  const ClearanceField& field = prepared_.field();
  const Frame& frame = prepared_.task().frame;
  const lanes::Discs discs = prepared_.fine();
  const std::array<Family, 2> families = families_of(box);
  for (std::size_t k = 0; k < 2; ++k) {
    const Family& f = families[k];
    if (!f.is_bounded) continue;
    for (int i = 0; i <= last_sample; i += stride) {
      const Weights w = weights_at(static_cast<double>(i) / last_sample);
      const Vec2 p1 = f.sum(w.e1, w.a1, w.c1);
      const double speed = norm(p1), speed_off = f.off(w.e1, w.a1, w.c1);
      if (!(speed_off < 0.9 * speed)) continue;
      const double turned = 1.01 * arc_tangent(speed_off, std::sqrt(speed * speed - speed_off * speed_off));
      // The point moves with the family's first one too.
      const double moved = f.off(w.e, w.a, w.c) + f.from_off * (1.0 + std::abs(w.e));
      const Vec2 position = frame.to_world(f.from + f.sum(w.e, w.a, w.c));
      const Vec2 heading = frame.rotate((k == 0 ? -1.0 / speed : 1.0 / speed) * p1);
      for (int d = 0; d < discs.count; ++d) {
        const lanes::Disc& disc = discs.first[d];
        const Vec2 centre = position + static_cast<double>(disc.x) * heading + static_cast<double>(disc.y) * left_of(heading);
        const double value = static_cast<double>(field.at(centre));
        if (value >= 0.0 && value + moved + static_cast<double>(disc.reach) * turned <= static_cast<double>(disc.inner)) return true;
      }
    }
  }
  return false;
}

}  // namespace waywright
