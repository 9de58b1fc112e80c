#include "waywright/planner/spline/spline_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/planner/spline/guide.hpp"
#include "waywright/planner/waypoint/nearness.hpp"

namespace waywright {
namespace {

constexpr double infeasible = 1e20;  // graded cost from where on a candidate is not feasible: no objective comes near
constexpr double unsolvable = 1e30;  // of a candidate without a curve, all of it
constexpr double spare = 0.99;       // of limits, for what is between the poses looked at
constexpr double slots = 1.5;        // how many places a point may be from its own along the line
constexpr double least_slot = 1.5;   // m, the same where start and goal are near to each other
constexpr double farthest = 1e6;     // m

double share_over(double value, double limit) { return std::isfinite(limit) ? std::max(0.0, value / (spare * limit) - 1.0) : 0.0; }

SplineEnds ends_for(const Problem& problem, SplineObjective objective) {
  if (problem.vehicle().can_turn_on_the_spot()) return SplineEnds::turned;
  return objective == SplineObjective::metres ? SplineEnds::kept : SplineEnds::ignored;
}

}  // namespace

SplineCandidates::SplineCandidates(const Problem& problem, const SplineOptions& options, const std::vector<Vec2>& guide)
    : problem_{problem}, options_{options}, ends_{ends_for(problem, options.objective)}, measurer_{problem} {
  const Vec2 start = problem.start().position(), goal = problem.goal().position();
  const double reach = 2.0 * problem.footprint().radius();
  Box box = problem.world().empty() ? Box{start, start} : problem.world().bounds();
  box.low = {std::min({box.low.x, start.x, goal.x}), std::min({box.low.y, start.y, goal.y})};
  box.high = {std::max({box.high.x, start.x, goal.x}), std::max({box.high.y, start.y, goal.y})};
  // A map of no width is none that control points could be looked for in.
  if (problem.world().empty() || !(box.high.x - box.low.x > reach)) box = {box.low - Vec2{reach, 0.0}, box.high + Vec2{reach, 0.0}};
  if (problem.world().empty() || !(box.high.y - box.low.y > reach)) box = {box.low - Vec2{0.0, reach}, box.high + Vec2{0.0, reach}};
  if (options.space != ControlSpace::map) add_places(guide, box);
  for (int i = 0; i < options.control_points; ++i) {
    const bool is_in_map = options.space == ControlSpace::map;
    space_.low.insert(space_.low.end(), {is_in_map ? box.low.x : -1.0, is_in_map ? box.low.y : -1.0});
    space_.high.insert(space_.high.end(), {is_in_map ? box.high.x : 1.0, is_in_map ? box.high.y : 1.0});
  }
  if (options.curve == SplineForm::bspline && ends_ == SplineEnds::kept) {
    const double longest = std::max(0.5 * distance(start, goal), reach);
    space_.low.insert(space_.low.end(), 2, 0.02 * longest);
    space_.high.insert(space_.high.end(), 2, longest);
  }
}

void SplineCandidates::add_places(const std::vector<Vec2>& guide, const Box& box) {
  const Vec2 start = problem_.start().position(), goal = problem_.goal().position();
  const auto count = static_cast<std::size_t>(options_.control_points);
  const double straight = distance(start, goal);
  const bool is_guided = guide.size() >= 2;
  std::vector<Vec2> way{start};
  for (std::size_t i = 1; i <= count && !is_guided; ++i) way.push_back(start + (static_cast<double>(i) / static_cast<double>(count + 1)) * (goal - start));
  if (is_guided) {
    for (const Vec2 p : points_along(guide, count)) way.push_back(p);
  }
  way.push_back(goal);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) length += distance(way[i], way[i + 1]);
  const double slot = slots * std::max(length / static_cast<double>(count + 1), least_slot);
  for (std::size_t i = 1; i <= count; ++i) {
    Place place{way[i], way[i + 1] - way[i - 1], slot, slot, slot};
    const double by = norm(place.along);
    place.along = by > 1e-9 ? (1.0 / by) * place.along : straight > 1e-9 ? (1.0 / straight) * (goal - start) : unit(problem_.start().heading);
    for (const Vec2 corner : {box.low, Vec2{box.high.x, box.low.y}, box.high, Vec2{box.low.x, box.high.y}}) {
      if (is_guided) break;  // it knows the side
      const double aside = dot(corner - place.at, left_of(place.along));
      place.left = std::max(place.left, aside);
      place.right = std::max(place.right, -aside);
    }
    places_.push_back(place);
  }
}

std::vector<double> SplineCandidates::plainest() const {
  std::vector<double> x;
  const Vec2 start = problem_.start().position(), goal = problem_.goal().position();
  for (int i = 0; i < options_.control_points; ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(options_.control_points + 1);
    const Vec2 at = options_.space == ControlSpace::map ? start + share * (goal - start) : Vec2{};
    x.insert(x.end(), {at.x, at.y});
  }
  for (std::size_t i = x.size(); i < space_.dimension(); ++i) x.push_back(0.75 * space_.low[i] + 0.25 * space_.high[i]);
  return x;
}

std::vector<Vec2> SplineCandidates::control_points(std::span<const double> x) const {
  std::vector<Vec2> points(static_cast<std::size_t>(options_.control_points));
  const auto squared = [](double v) { return v * std::abs(v); };  // half of what is drawn lies within a quarter of the width
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = x[2 * i], v = x[2 * i + 1];
    if (options_.space == ControlSpace::map) {
      points[i] = {u, v};
      continue;
    }
    const Place& place = places_[i];
    points[i] = place.at + (squared(u) * place.ahead) * place.along + (squared(v) * (v < 0.0 ? place.right : place.left)) * left_of(place.along);
  }
  if (options_.space == ControlSpace::map) {
    const Vec2 start = problem_.start().position(), along = problem_.goal().position() - start;
    std::stable_sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) { return dot(a - start, along) < dot(b - start, along); });
  }
  return points;
}

std::optional<SplineCurve> SplineCandidates::curve_at(std::span<const double> x) const {
  const std::size_t points = 2 * static_cast<std::size_t>(options_.control_points);
  std::array<double, 2> leads{};
  if (space_.dimension() > points) leads = {x[points], x[points + 1]};
  return spline_curve(problem_, options_.curve, ends_, control_points(x), leads);
}

/// Steady in the pose: from the nearest edge to the vehicle's origin, and beyond where that is inside of something.
double SplineCandidates::depth_of(const Pose& pose) const {
  const Vec2 at = pose.position();
  const double radius = problem_.footprint().radius();
  const double to_edge = std::min(farthest, problem_.world().index().nearest(std::span{&at, 1}, std::numeric_limits<double>::infinity()).distance);
  return problem_.world().is_blocked(at) ? radius + to_edge : std::max(1e-6, radius - to_edge);
}

SplineCandidates::Parts SplineCandidates::parts_of(const SplineCurve& curve) {
  sample_by_step(problem_, curve, options_.step, samples_);
  const double radius = problem_.footprint().radius();
  Nearness nearness{problem_, options_.wanted_clearance, [this](const Pose& pose) { return depth_of(pose); }};
  Parts parts;
  double moved = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const SplineSample& here = samples_[i];
    parts.curvature = std::max(parts.curvature, std::abs(here.curvature));
    parts.curvature_rate = std::max(parts.curvature_rate, std::abs(here.curvature_rate));
    if (i == 0) continue;
    const SplineSample& before = samples_[i - 1];
    parts.length += here.along;
    parts.bends += 0.5 * here.along * (here.curvature * here.curvature + before.curvature * before.curvature);
    // A turn on the spot is as long as the way of the outermost point.
    const double along = here.along > 0.0 ? here.along : radius * std::abs(shorter_turn(before.pose.heading, here.pose.heading));
    moved += along;
    nearness.add(before.pose, here.pose, along, i == 1, i + 1 == samples_.size());
  }
  parts.nearness = options_.clearance_weight * nearness.barrier();
  parts.bends *= options_.bend_weight;
  parts.turns = options_.turn_cost * (std::abs(curve.start_turn) + std::abs(curve.end_turn));
  parts.clearance = nearness.least();
  double over = share_over(parts.curvature, problem_.vehicle().max_curvature());
  if (const auto& rate = problem_.vehicle().limits.curvature_rate) over += share_over(parts.curvature_rate, *rate);
  parts.is_beyond_limits = over > 0.0;
  parts.violation = over + nearness.lacking() / moved;
  return parts;
}

Evaluation SplineCandidates::in_metres(std::span<const double> x) {
  const auto curve = curve_at(x);
  if (!curve) return {unsolvable, unsolvable, unsolvable};
  const Parts parts = parts_of(*curve);
  const double objective = std::min(parts.sum(), 0.01 * infeasible);  // a cusp's bends know no limit
  const double violation = std::min(parts.violation, 1e6);
  return {objective, violation, violation > 0.0 ? infeasible * (1.0 + violation) : objective};
}

SplineMeasures SplineCandidates::measures_of(const SplineCurve& curve) {
  sample_by_parameter(options_.curve, curve, static_cast<std::size_t>(options_.samples), poses_);
  return measurer_.measure(poses_);
}

SplineCandidates::Tightest SplineCandidates::tightest_of(const SplineCurve& curve) {
  sample_by_step(problem_, curve, options_.step, samples_);
  Tightest tightest;
  tightest.contact.clearance = std::numeric_limits<double>::infinity();
  for (const SplineSample& sample : samples_) {
    const Contact contact = problem_.world().clearance(problem_.footprint(), sample.pose, 10.0);
    if (contact.clearance < tightest.contact.clearance) tightest = {sample.pose, contact};
  }
  return tightest;
}

}  // namespace waywright
