#include "waywright/planner/steering/search_ends.hpp"

#include <algorithm>

#include "waywright/geometry/polygon.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {
namespace {

constexpr double tight = 0.002;        // m: an end with less than this beyond the required clearance is driven straight
constexpr double straight_run = 0.05;  // m
constexpr double detour = 10.0;        // turning circles' reach that positions are drawn beyond start and goal
constexpr double bounds_slack = 1e-6;  // m, so that poses on the edge are inside

}  // namespace

StateEnd end_of_search(MotionTest& test, const Pose& pose, bool is_start, bool backwards_too) {
  if (test.pose_free_by(pose, tight)) return {pose, std::nullopt};
  for (const double side : {-1.0, 1.0}) {  // backing off first: forks stand in front
    const Vec2 away = pose.position() + side * straight_run * unit(pose.heading);
    const bool forward = (side > 0.0) == is_start;
    if (!forward && !backwards_too) continue;
    const Piece run{is_start ? Line{pose.position(), away} : Line{away, pose.position()}, forward ? 1 : -1};
    const Pose there = make_pose(away, pose.heading);
    if (test.pose_free_by(there, tight) && test.motion_free(std::span{&run, 1})) return {there, run};
  }
  return {pose, std::nullopt};
}

StateEnd goal_with_run(MotionTest& test, const Pose& goal, double run) {
  const Vec2 before = goal.position() - run * unit(goal.heading);
  const Piece piece{Line{before, goal.position()}, 1};
  if (!test.motion_free(std::span{&piece, 1})) return {goal, std::nullopt};
  return {make_pose(before, goal.heading), piece};
}

Path with_runs(const Steering& steering, const StateEnd& start, const Path& middle, const StateEnd& goal) {
  Path path;
  const auto append = [&](const Piece& piece) {
    if (steering.is_curve()) {
      append_merged(path.pieces, piece);
    } else {
      path.pieces.push_back(piece);
    }
  };
  if (start.run) append(*start.run);
  for (const Piece& piece : middle.pieces) append(piece);
  if (goal.run) append(*goal.run);
  return path;
}

Box search_region(const Problem& problem, double radius, bool is_curve) {
  const Vec2 reach{2.0 * radius + problem.footprint().radius(),
                   2.0 * radius + problem.footprint().radius()};
  std::vector<Vec2> points{problem.start().position(), problem.goal().position()};
  if (const FreeGoal* free = problem.free_goal()) points.insert(points.end(), free->area.begin(), free->area.end());
  const Box ends = bounding_box(points);
  const World& world = problem.world();
  Box region{ends.low - detour * reach, ends.high + detour * reach};
  const auto keep_inside = [&region](const Box& box) {
    region.low = {std::max(region.low.x, box.low.x), std::max(region.low.y, box.low.y)};
    region.high = {std::min(region.high.x, box.high.x), std::min(region.high.y, box.high.y)};
  };
  if (world.empty()) {
    keep_inside({ends.low - reach, ends.high + reach});
  } else {
    // Round everything known there may be a way; beyond that there is nothing to go round.
    const Box known = world.bounds();
    const Box around{Vec2{std::min(known.low.x, ends.low.x), std::min(known.low.y, ends.low.y)} - reach,
                     Vec2{std::max(known.high.x, ends.high.x), std::max(known.high.y, ends.high.y)} + reach};
    if (!is_curve) region = around;  // straight ways through a maze lead as far as it does
    keep_inside(around);
  }
  for (const Ring& boundary : world.map().boundaries) keep_inside(bounding_box(boundary));
  for (const CellGrid& grid : world.map().grids) {
    if (!grid.bounds) continue;
    keep_inside(bounding_box({grid.corner(0, 0), grid.corner(grid.columns, 0), grid.corner(0, grid.rows),
                              grid.corner(grid.columns, grid.rows)}));
  }
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission))
    keep_inside(bounding_box(station->area));
  const Vec2 slack{bounds_slack, bounds_slack};
  return {Vec2{std::min(region.low.x, ends.low.x), std::min(region.low.y, ends.low.y)} - slack,
          Vec2{std::max(region.high.x, ends.high.x), std::max(region.high.y, ends.high.y)} + slack};
}

}  // namespace waywright
