#include "waywright/planner/docking/pattern.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/bezier.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

Spline without_empty(std::vector<BezierSpan> spans) {
  std::erase_if(spans, [](const BezierSpan& s) { return s.degree == 1 && s.control[0] == s.control[1]; });
  return {SplineKind::quintic, std::move(spans)};
}

}  // namespace

PatternPoints pattern_points(const Pose& start, const Pose& dock, const Pose& transition, const PatternLeads& leads) {
  const Vec2 s = start.position();
  const Vec2 t = transition.position();
  const Vec2 d = dock.position();
  const Vec2 s_o = s - leads.start * unit(start.heading);
  const Vec2 t_o = t + leads.transition * unit(transition.heading);
  const Vec2 d_o = d - leads.dock * unit(dock.heading);
  return {{s, s_o, t_o, t}, {t, t_o, d_o, d}};
}

double transition_heading(Side side, double dock_heading, double offset) {
  const double sign = side == Side::left ? 1.0 : -1.0;
  return wrap(dock_heading + sign * (0.5 * pi + offset));
}

std::array<Spline, 2> published_pattern(const Pose& start, const Pose& dock, const Pose& transition,
                                        const PatternLeads& leads) {
  const PatternPoints points = pattern_points(start, dock, transition, leads);
  return {Spline{SplineKind::natural_cubic, natural_cubic(points.back)},
          Spline{SplineKind::natural_cubic, natural_cubic(points.forth)}};
}

BezierSpan joining_quintic(Vec2 from, double from_course, Vec2 to, double to_course) {
  const Vec2 chord = to - from;
  const double along = angle_of(chord);
  const double alpha = wrap(from_course - along);
  const double beta = wrap(to_course - along);
  // Tangent length over chord that makes Σ|Δκ| least, fitted over symmetric turns and S-curves of up to 90° from the chord:
  // t = 1 − cos(half the turn), and the S part of the two angles.
  const double t = 1.0 - sin_cos(std::min(0.5 * std::abs(alpha - beta), 0.5 * pi)).cos;
  const double s = 1.0 - sin_cos(std::min(0.5 * std::abs(alpha + beta), 0.5 * pi)).cos;
  const double length = norm(chord) * (0.92 + 0.45 * t + 0.25 * t * t + 0.95 * t * t * t * t + 0.3 * s);
  return straight_ended_quintic(from, length * unit(from_course), to, length * unit(to_course));
}

DockingPattern docking_pattern(const Pose& start, const Pose& dock, const Pose& transition, const PatternLeads& leads) {
  DockingPattern pattern{pattern_points(start, dock, transition, leads), {}, {}};
  const auto& [back, forth] = pattern.points;
  pattern.back = joining_quintic(back[1], wrap(start.heading + pi), back[2], wrap(transition.heading + pi));
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
