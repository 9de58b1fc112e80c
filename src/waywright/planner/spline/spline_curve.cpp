#include "waywright/planner/spline/spline_curve.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/bezier.hpp"
#include "waywright/curve/bspline.hpp"

namespace waywright {
namespace {

constexpr double least_chord = 1e-6;    // m between points
constexpr double least_turn = 1e-9;     // rad
constexpr double turn_step = 0.1;       // rad between samples
constexpr double most_in_span = 2000.0; // samples

double start_course(const Spans& spans) { return angle_of(spans.front().control[1] - spans.front().control[0]); }
double end_course(const Spans& spans) { return angle_of(spans.back().control[3] - spans.back().control[2]); }

double turn_between(double from, double to) {
  const double turn = shorter_turn(from, to);
  return std::abs(turn) < least_turn ? 0.0 : turn;
}

void add_turn(Vec2 at, double from, double turn, std::vector<SplineSample>& samples) {
  const double steps = std::ceil(std::abs(turn) / turn_step);
  for (int i = 1; i <= static_cast<int>(steps); ++i) samples.push_back({make_pose(at, from + turn * i / steps), 0.0, 0.0, 0.0});
}

}  // namespace

std::optional<SplineCurve> spline_curve(const Problem& problem, SplineForm form, SplineEnds ends, std::span<const Vec2> control_points, std::array<double, 2> leads) {
  const Pose start = problem.start(), goal = problem.goal();
  std::vector<Vec2> points;
  points.reserve(control_points.size() + 4);
  points.push_back(start.position());
  const bool has_leads = form == SplineForm::bspline && ends == SplineEnds::kept;
  if (has_leads) points.push_back(start.position() + leads[0] * unit(start.heading));
  points.insert(points.end(), control_points.begin(), control_points.end());
  if (has_leads) points.push_back(goal.position() - leads[1] * unit(goal.heading));
  points.push_back(goal.position());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!(distance(points[i], points[i + 1]) > least_chord)) return std::nullopt;
  }
  SplineCurve curve;
  if (form == SplineForm::bspline) curve.spans = bspline_spans(points);
  else curve.spans = ends == SplineEnds::kept ? clamped_cubic(points, start.heading, goal.heading) : natural_cubic(points);
  const BezierSpan &first = curve.spans.front(), &last = curve.spans.back();
  if (!(distance(first.control[0], first.control[1]) > least_chord && distance(last.control[2], last.control[3]) > least_chord)) return std::nullopt;
  if (ends == SplineEnds::turned) {
    curve.start_turn = turn_between(start.heading, start_course(curve.spans));
    curve.end_turn = turn_between(end_course(curve.spans), goal.heading);
  }
  return curve;
}

Path path_of(const Problem& problem, const SplineCurve& curve) {
  const Pose start = problem.start(), goal = problem.goal();
  Path path;
  if (curve.start_turn != 0.0) path.pieces.push_back({Turn{start.position(), start.heading, curve.start_turn}, 0});
  path.pieces.push_back({Spline{SplineKind::natural_cubic, curve.spans}, 1});
  if (curve.end_turn != 0.0) path.pieces.push_back({Turn{goal.position(), end_course(curve.spans), curve.end_turn}, 0});
  return path;
}

void sample_by_step(const Problem& problem, const SplineCurve& curve, double step, std::vector<SplineSample>& samples) {
  samples.clear();
  if (curve.start_turn != 0.0) {
    samples.push_back({problem.start(), 0.0, 0.0, 0.0});
    add_turn(problem.start().position(), problem.start().heading, curve.start_turn, samples);
  }
  for (std::size_t s = 0; s < curve.spans.size(); ++s) {
    const SpanDerivatives span{curve.spans[s]};
    const double parts = std::clamp(std::ceil(control_length(curve.spans[s]) / step), 2.0, most_in_span);
    for (int i = s == 0 ? 0 : 1; i <= static_cast<int>(parts); ++i) {
      const CurvePoint p = curve_point(span.at(i / parts));
      const double along = s == 0 && i == 0 ? 0.0 : distance(samples.back().pose.position(), p.position);
      samples.push_back({make_pose(p.position, p.course), along, p.curvature, p.curvature_rate});
    }
  }
  add_turn(problem.goal().position(), samples.back().pose.heading, curve.end_turn, samples);
}

void sample_by_parameter(SplineForm form, const SplineCurve& curve, std::size_t count, std::vector<Pose>& poses) {
  poses.clear();
  std::vector<double> ends;  // of spans, in the parameter
  double whole = 0.0;
  for (const BezierSpan& span : curve.spans) ends.push_back(whole += form == SplineForm::cubic ? distance(span.control[0], span.control[3]) : 1.0);
  std::size_t s = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = whole * static_cast<double>(i) / static_cast<double>(count - 1);
    while (s + 1 < ends.size() && at > ends[s]) ++s;
    const double begin = s == 0 ? 0.0 : ends[s - 1];
    const CurvePoint p = evaluate(curve.spans[s], std::clamp((at - begin) / (ends[s] - begin), 0.0, 1.0));
    poses.push_back(make_pose(p.position, p.course));
  }
}

}  // namespace waywright
