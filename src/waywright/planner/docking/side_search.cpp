#include "waywright/planner/docking/side_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/curve/bezier.hpp"

namespace waywright {

SearchSpace search_space(const TransitionZone& zone, double heading_range) {
  std::vector<Vec2> corners;
  for (const Ring& polygon : zone.polygons) corners.insert(corners.end(), polygon.begin(), polygon.end());
  const Box box = bounding_box(corners);
  SearchSpace space{{box.low.x, box.low.y}, {box.high.x, box.high.y}};
  if (heading_range > 0.0) {
    space.low.push_back(-heading_range);
    space.high.push_back(heading_range);
  }
  return space;
}

Placement transition_placement(const DockingTask& task, const TransitionZone& zone, std::span<const double> x) {
  const Vec2 wanted{x[0], x[1]};
  Vec2 nearest = wanted;
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& polygon : zone.polygons) {
    const Vec2 p = nearest_in(polygon, wanted);
    if (const double d = distance(p, wanted); d < least) {
      least = d;
      nearest = p;
    }
  }
  // transition_heading() as a unit vector.
  const double sign = zone.side == Side::left ? 1.0 : -1.0;
  const Vec2 across = sign * left_of(task.dock_heading);
  const SinCos offset = sin_cos(x.size() > 2 ? sign * x[2] : 0.0);
  return {task.frame.to_world(nearest), task.frame.rotate(offset.cos * across + offset.sin * left_of(across))};
}

Pose transition_pose(const DockingTask& task, const TransitionZone& zone, std::span<const double> x) {
  const Placement at = transition_placement(task, zone, x);
  return make_pose(at.position, angle_of(at.heading));
}

bool is_wanted(SideChoice choice, Side side) {
  return choice == SideChoice::both || (choice == SideChoice::left) == (side == Side::left);
}

SideShares::SideShares(const std::vector<TransitionZone>& zones, SideChoice sides, std::int64_t evaluations, const Budget& budget, bool second_choice)
    : evaluations_{evaluations} {
  sides_ = std::count_if(zones.begin(), zones.end(), [&](const TransitionZone& z) { return !z.left_out() && is_wanted(sides, z.side); });
  if (const auto all = budget.evaluations_left()) left_ = second_choice ? *all - *all / 4 : *all;
}

std::int64_t SideShares::next() {
  if (!left_) return evaluations_;
  const std::int64_t share = sides_ > 0 ? (*left_ + sides_ - 1) / sides_ : 0;
  *left_ -= share;
  if (sides_ > 0) --sides_;
  return share;
}

std::string not_searched_sentence(Side side, const Budget& budget) {
  const char* why = budget.canceled() ? "the run was stopped" : budget.cut_short() ? "the time was up" : "the budget was spent";
  return fmt::format("The {} side was not searched: {}.", to_string(side), why);
}

std::string left_out_sentence(const TransitionZone& zone) {
  if (zone.width == 0.0) {
    return fmt::format("The {} side of the {} was left out: there is no free area.", to_string(zone.side), zone.of);
  }
  return fmt::format(
      "The {} side of the {} was left out: it is {:.3f} m wide, and the footprint's least width with the clearance on both "
      "sides is {:.3f} m; {:.3f} m are missing.",
      to_string(zone.side), zone.of, zone.width, zone.needed, zone.needed - zone.width);
}

std::vector<RoughPose> rough_poses(const Path& path, double step) {
  constexpr double longest = 1e3;  // m: beyond it steps are longer
  std::vector<RoughPose> poses;
  double driven = 0.0;
  for (const Piece& piece : path.pieces) {
    const auto* spline = std::get_if<Spline>(&piece.curve);
    if (spline == nullptr) continue;
    for (const BezierSpan& span : spline->spans) {
      const int parts = 1 + static_cast<int>(std::min(arc_length(span), longest) / step);
      Vec2 before = span.control[0];
      for (int i = 0; i <= parts; ++i) {
        const CurvePoint at = evaluate(span, static_cast<double>(i) / parts);
        driven += distance(before, at.position);
        before = at.position;
        poses.push_back({driven, make_pose(at.position, piece.direction < 0 ? wrap(at.course + pi) : at.course)});
      }
    }
  }
  return poses;
}

std::vector<Alternative> alternatives_of(const DockingTask& task, const std::vector<SideOutcome>& outcomes,
                                         const SideOutcome* chosen) {
  std::vector<Alternative> alternatives;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const SideOutcome& outcome = outcomes[i];
    Alternative a;
    a.name = fmt::format("{} side", to_string(outcome.side));
    a.chosen = &outcome == chosen;
    if (outcome.feasible) a.cost = outcome.cost;
    a.outcome = outcome.sentence;
    for (const RoughPose& p : rough_poses(outcome.path, 0.12)) a.poses.push_back(p.pose);
    const TransitionZone& zone = task.zones[i];
    if (!zone.polygons.empty()) a.zone = transformed(zone.polygons.front(), task.frame);
    alternatives.push_back(std::move(a));
  }
  return alternatives;
}

const SideOutcome* best_of(const std::vector<SideOutcome>& outcomes) {
  const SideOutcome* best = nullptr;
  for (const SideOutcome& outcome : outcomes) {
    if (outcome.feasible && (best == nullptr || outcome.cost < best->cost)) best = &outcome;
  }
  return best;
}

std::string contact_words(const Problem& problem, const Contact& contact) {
  return fmt::format("{} at ({:.2f}, {:.2f})", problem.world().source_name(contact.source), contact.point.x,
                     contact.point.y);
}

}  // namespace waywright
