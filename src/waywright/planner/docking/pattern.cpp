#include "waywright/planner/docking/pattern.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/bezier.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

Spline without_empty(Spans spans) {
  const auto is_empty = [](const BezierSpan& s) { return s.degree == 1 && s.control[0] == s.control[1]; };
  spans.erase(std::remove_if(spans.begin(), spans.end(), is_empty), spans.end());
  return {SplineKind::quintic, std::move(spans)};
}

}  // namespace

PatternPoints pattern_points(const Placement& start, const Placement& dock, const Placement& transition, const PatternLeads& leads) {
  const Vec2 s_o = start.position - leads.start * start.heading;
  const Vec2 t_o = transition.position + leads.transition * transition.heading;
  const Vec2 d_o = dock.position - leads.dock * dock.heading;
  return {{start.position, s_o, t_o, transition.position}, {transition.position, t_o, d_o, dock.position}};
}

double transition_heading(Side side, double dock_heading, double offset) {
  const double sign = side == Side::left ? 1.0 : -1.0;
  return wrap(dock_heading + sign * (0.5 * pi + offset));
}

std::array<Spline, 2> published_pattern(const Pose& start, const Pose& dock, const Pose& transition,
                                        const PatternLeads& leads) {
  const PatternPoints points = pattern_points(placement_of(start), placement_of(dock), placement_of(transition), leads);
  return {Spline{SplineKind::natural_cubic, natural_cubic(points.back)},
          Spline{SplineKind::natural_cubic, natural_cubic(points.forth)}};
}

BezierSpan joining_quintic(Vec2 from, Vec2 from_course, Vec2 to, Vec2 to_course, double start_curvature) {
  const Vec2 chord = to - from;
  const double distance = norm(chord);
  const Vec2 along = distance > 0.0 ? (1.0 / distance) * chord : from_course;
  // α, β: angles of the courses from the chord, in (−π, π].
  const double cos_a = dot(along, from_course), sin_a = cross(along, from_course);
  const double cos_b = dot(along, to_course), sin_b = cross(along, to_course);
  // Tangent length over chord that makes Σ|Δκ| least, fitted over symmetric turns and S-curves of up to 90° from the chord:
  // t = 1 − cos(half the turn α − β), and s the same of the S part α + β; 1 from half turns on.
  const auto missing = [](double cosine, bool beyond) { return beyond ? 1.0 : 1.0 - std::sqrt(std::max(0.0, 0.5 * (1.0 + cosine))); };
  const bool left_a = sin_a >= 0.0, left_b = sin_b >= 0.0;
  const double sin_turn = sin_a * cos_b - cos_a * sin_b;
  const double sin_sum = sin_a * cos_b + cos_a * sin_b;
  const double t = missing(cos_a * cos_b + sin_a * sin_b, left_a != left_b && (sin_turn < 0.0) == left_a && sin_turn != 0.0);
  const double s = missing(cos_a * cos_b - sin_a * sin_b, left_a == left_b && (sin_sum < 0.0) == left_a && sin_sum != 0.0);
  const double length = distance * (0.92 + 0.45 * t + 0.25 * t * t + 0.95 * t * t * t * t + 0.3 * s);
  const Vec2 first = length * from_course, last = length * to_course;
  return start_curvature == 0.0 ? straight_ended_quintic(from, first, to, last) : straight_ending_quintic(from, first, start_curvature, to, last);
}

DockingPattern docking_pattern(const PatternStart& start, const Placement& dock, const Placement& transition, const PatternLeads& leads) {
  PatternLeads used = leads;
  if (start.curvature != 0.0) used.start = 0.0;
  DockingPattern pattern{pattern_points(start.at, dock, transition, used), {}, {}, start.curvature != 0.0};
  const auto& [back, forth] = pattern.points;
  pattern.back = joining_quintic(back[1], -start.at.heading, back[2], -transition.heading, start.curvature);
  pattern.forth = joining_quintic(forth[1], transition.heading, forth[2], dock.heading);
  return pattern;
}

std::array<Spline, 2> splines_of(const DockingPattern& pattern) {
  const auto& [back, forth] = pattern.points;
  return {without_empty({straight_span(back[0], back[1]), pattern.back, straight_span(back[2], back[3])}),
          without_empty({straight_span(forth[0], forth[1]), pattern.forth, straight_span(forth[2], forth[3])})};
}

std::array<Spline, 2> straight_ended_pattern(const Pose& start, const Pose& dock, const Pose& transition,
                                             const PatternLeads& leads) {
  return splines_of(docking_pattern(start, dock, transition, leads));
}

Path pattern_path(std::array<Spline, 2> splines) {
  return {{{std::move(splines[0]), -1}, {std::move(splines[1]), 1}}};
}

}  // namespace waywright
