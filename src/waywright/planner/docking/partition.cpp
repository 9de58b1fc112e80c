#include "waywright/planner/docking/partition.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

/// Where a goal pose is docked at without a station: the boundary that holds start and goal, else their surroundings.
Ring surroundings(const Problem& problem, const Frame& frame) {
  for (const Ring& boundary : problem.scenario().map.boundaries) {
    if (contains(boundary, problem.goal().position())) {
      Ring ring;
      for (const Vec2 p : boundary) ring.push_back(frame.to_local(p));
      return ring;
    }
  }
  const double curvature = problem.vehicle().max_curvature();
  const double radius = std::isfinite(curvature) && curvature > 0.0 ? 1.0 / curvature : 1.0;
  const double reach = 6.0 * radius + 2.0 * problem.footprint().radius();
  Box box = bounding_box({frame.to_local(problem.start().position()), frame.to_local(problem.goal().position())});
  return rectangle(box.low - Vec2{reach, reach}, box.high + Vec2{reach, reach});
}

}  // namespace

const char* to_string(Side side) { return side == Side::left ? "left" : "right"; }

std::vector<Ring> clip_beside(const Ring& area, double shelf_right, double shelf_left, Side side) {
  return side == Side::left ? clip_half_plane(area, {0.0, 1.0}, shelf_left)
                            : clip_half_plane(area, {0.0, -1.0}, -shelf_right);
}

DockingTask partition(const Problem& problem) {
  DockingTask task;
  Ring area;
  double half_width = 0.0;
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) {
    task.frame = station->shelf.face();
    half_width = 0.5 * station->shelf.width;
    for (const Vec2 p : station->area) area.push_back(task.frame.to_local(p));
  } else {
    const Pose& goal = problem.goal();
    const Vec2 tips = Frame{goal}.to_world(Vec2{problem.footprint().front(), 0.0});
    task.frame = Frame{make_pose(tips, goal.heading + pi)};
    area = surroundings(problem, task.frame);
  }
  task.start = task.frame.to_local(problem.start());
  task.dock = task.frame.to_local(problem.goal());
  task.dock_heading = unit(task.dock.heading);
  const double needed = problem.footprint().least_width() + 2.0 * problem.scenario().clearance;
  for (const Side side : {Side::left, Side::right}) {
    TransitionZone zone;
    zone.side = side;
    zone.of = std::holds_alternative<Station>(problem.scenario().mission) ? "shelf" : "goal";
    zone.needed = needed;
    for (Ring& polygon : clip_beside(area, -half_width, half_width, side)) {
      const double width = least_width(polygon);
      zone.width = std::max(zone.width, width);
      if (width >= needed) zone.polygons.push_back(std::move(polygon));
    }
    task.zones.push_back(std::move(zone));
  }
  return task;
}

}  // namespace waywright
