#include "waywright/planner/spline/spline_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double degrees = 180.0 / pi;

Status status_of(const Budget& budget) { return budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path; }

std::string list_of(std::span<const Vec2> points) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) text += fmt::format("{}({:.2f}, {:.2f})", i == 0 ? "" : ", ", points[i].x, points[i].y);
  return text;
}

std::string bends_of(const Problem& problem, const SplineCandidates::Parts& parts) {
  std::string text = fmt::format("curvature is at most {:.4f} 1/m", parts.curvature);
  if (const double limit = problem.vehicle().max_curvature(); std::isfinite(limit)) text += fmt::format(" (the vehicle can {:.4f})", limit);
  if (const auto& rate = problem.vehicle().limits.curvature_rate) text += fmt::format(", its rate at most {:.4f} 1/m² (limit {:.4f})", parts.curvature_rate, *rate);
  return text;
}

}  // namespace

std::string curve_name(SplineForm form, SplineEnds ends) {
  return form == SplineForm::bspline ? "B-spline" : ends == SplineEnds::kept ? "cubic spline" : "natural cubic spline";
}

std::string points_sentence(const SplineOptions& options, std::span<const Vec2> points, double chosen, const Evaluation& of_plainest, std::int64_t looked, bool is_guided) {
  const bool is_ours = options.objective == SplineObjective::metres;
  const std::string value = fmt::format("{} is {:.6g} here", is_ours ? "Length, nearness and bends in metres: the sum" : "The publication's fitness (27)", chosen);
  const char* line = is_guided ? "the shortest way around obstacles" : "the straight line";
  if (looked == 1) return fmt::format("Only the curve with its control points on {} was looked at: {}. {}.", line, list_of(points), value);
  return fmt::format("Of {} curves the one with the control points {} costs least. {}, and {} with the control points on {}.", looked, list_of(points), value,
                     of_plainest.violation > 0.0 ? "not feasible" : fmt::format("{:.6g}", of_plainest.objective), line);
}

std::string parts_sentence(const SplineCandidates::Parts& parts) {
  std::string text = fmt::format("Of that {:.3f} m are its length, {:.3f} m for being near to things, {:.3f} m for bends", parts.length, parts.nearness, parts.bends);
  if (parts.turns > 0.0) text += fmt::format(", {:.3f} m for turning on the spot", parts.turns);
  return text + ".";
}

std::string curve_sentence(const Problem& problem, const SplineOptions& options, const SplineCurve& curve, const SplineCandidates::Parts& parts, SplineEnds ends) {
  std::string text = fmt::format("The {} has {} spans and no jump of curvature: {}.", curve_name(options.curve, ends), curve.spans.size(), bends_of(problem, parts));
  switch (ends) {
    case SplineEnds::turned:
      if (curve.start_turn == 0.0 && curve.end_turn == 0.0) break;
      text += fmt::format(" The vehicle turns on the spot by {:.1f}° at the start and {:.1f}° at the goal.", curve.start_turn * degrees, curve.end_turn * degrees);
      break;
    case SplineEnds::kept: text += " It begins and ends in the headings asked for, since the vehicle cannot turn on the spot."; break;
    case SplineEnds::ignored: text += " As published it takes no heed of the headings at start and goal, and this vehicle cannot turn on the spot."; break;
  }
  return text;
}

std::string fitness_sentence(const SplineMeasures& m, const SplineWeights& k, int samples) {
  return fmt::format("f = {:.4g} · length {:.3f} m + {:.4g} · risk {:.4f} + {:.4g} · time {:.2f} s + {:.4g} · turning {:.3f} rad − {:.4g} · energy {:.2f} %{}.", k.length, m.length, k.risk, m.risk, k.time,
                     m.time, k.turning, m.turning, k.energy, m.energy,
                     m.collisions == 0 ? fmt::format("; none of {} samples touches anything", samples) : fmt::format(" + {:g} for each of {} samples of {} that touch", collision_penalty, m.collisions, samples));
}

std::vector<Pose> picture_of(const Problem& problem, const SplineCurve& curve) {
  std::vector<SplineSample> samples;
  double length = 0.0;
  for (const BezierSpan& span : curve.spans) length += distance(span.control[0], span.control[3]);
  sample_by_step(problem, curve, std::max(0.12, length / 1000.0), samples);
  std::vector<Pose> poses;
  for (const SplineSample& s : samples) poses.push_back(s.pose);
  return poses;
}

PlanningFailure failure_of(const Problem& problem, const SplineOptions& options, SplineCandidates& candidates, const SplineCurve& curve, std::int64_t looked, const Budget& budget) {
  PlanningFailure failure;
  failure.failure.status = status_of(budget);
  const SplineCandidates::Parts parts = candidates.parts_of(curve);
  std::string why;
  if (parts.is_beyond_limits) {
    why = fmt::format("bends too much, where 1 % of the limits is kept in hand: {}", bends_of(problem, parts));
  } else {
    const SplineCandidates::Tightest tightest = candidates.tightest_of(curve);
    const Contact& contact = tightest.contact;
    if (std::isfinite(contact.clearance)) {
      const std::string at = fmt::format("{} at ({:.3f}, {:.3f})", problem.world().source_name(contact.source), contact.point.x, contact.point.y);
      why = contact.clearance >= problem.required_clearance() && contact.clearance > 0.0 ? fmt::format("comes too near to something between the poses looked at, near {}", at)
            : contact.clearance > 0.0 ? fmt::format("comes as near as {:.4f} m to {}, and {:.4f} m are required", contact.clearance, at, problem.required_clearance())
                                      : fmt::format("touches {}", at);
      failure.failure.pose = tightest.pose;
      failure.failure.point = contact.point;
    } else {
      why = "has a cusp";
    }
  }
  const std::string name = curve_name(options.curve, candidates.ends());
  failure.failure.reason = looked == 1 ? fmt::format("the only {} that was looked at cannot be driven: it {}", name, why)
                                       : fmt::format("of {} {}s with {} control points none can be driven; the best one {}", looked, name, options.control_points, why);
  failure.explanation.push_back(curve_sentence(problem, options, curve, parts, candidates.ends()));
  failure.alternatives.push_back({looked == 1 ? "the only candidate" : "best candidate", false, std::nullopt, "It " + why + ".", picture_of(problem, curve), {}});
  return failure;
}

PlanningFailure failure_without_curve(std::int64_t looked, const Budget& budget) {
  PlanningFailure failure;
  failure.failure.status = status_of(budget);
  failure.failure.reason = looked == 0 ? "the search was ended before it looked at a curve" : "no curve that was looked at has a course everywhere: control points coincide";
  return failure;
}

}  // namespace waywright
