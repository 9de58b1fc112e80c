// What moves in the picture: the vehicle, its path, what it sweeps.
#include <algorithm>

#include "waywright/report/scene_parts.hpp"

namespace waywright {
namespace {

constexpr double sweep_step = 0.03;  // m between the footprints of the swept area
constexpr double ghost_step = 0.75;  // m between drawn outlines
constexpr double arrow_step = 1.5;        // m between arrow heads
constexpr double least_arrow_gap = 34.0;  // px, where that is too near

}  // namespace

void draw_vehicle(SvgWriter& svg, const Footprint& footprint, const Pose& pose) {
  svg.polygon(outline_at(footprint, pose), "vehicle");
  const Frame frame{pose};
  const double front = footprint.front();
  const Vec2 tip = frame.to_world(Vec2{front, 0.0});
  svg.line(pose.position(), tip, "heading");
  const double head = std::min(0.25, 0.3 * std::max(front, 0.2));
  svg.polyline(
      {frame.to_world(Vec2{front - head, 0.6 * head}), tip, frame.to_world(Vec2{front - head, -0.6 * head})},
      "heading");
}

Vec2 draw_goal(SvgWriter& svg, const Problem& problem, const Plan& plan) {
  const FreeGoal* free = problem.free_goal();
  if (free == nullptr) {
    draw_vehicle(svg, problem.footprint(), problem.last_pose());
    return problem.last_pose().position();
  }
  if (free->is_point()) svg.dot(free->area.front(), 4.0, "waypoint");
  else svg.polygon(free->area, "region");
  if (plan.samples.empty()) return problem.goal().position();
  draw_vehicle(svg, problem.footprint(), plan.samples.back().pose());
  return plan.samples.back().pose().position();
}

/// Runs of equal direction as polylines.
void draw_path(SvgWriter& svg, const std::vector<Sample>& samples) {
  for (std::size_t i = 0; i < samples.size();) {
    std::size_t end = i;
    std::vector<Vec2> points;
    while (end < samples.size() && samples[end].direction == samples[i].direction)
      points.push_back(samples[end++].pose().position());
    svg.polyline(points, samples[i].direction > 0 ? "fwd" : samples[i].direction < 0 ? "back" : "turn");
    i = end;
  }
  double next = 0.6;
  for (const Sample& s : samples) {  // arrow heads in the direction of travel
    if (s.s < next || s.direction == 0) continue;
    next = s.s + std::max(arrow_step, least_arrow_gap / svg.view().scale);
    const Frame frame{make_pose({s.x, s.y}, s.course)};
    const double a = 7.0 / svg.view().scale;
    svg.polygon({frame.to_world(Vec2{a, 0.0}), frame.to_world(Vec2{-a, 0.75 * a}),
                 frame.to_world(Vec2{-a, -0.75 * a})},
                s.direction > 0 ? "fwdmark" : "backmark");
  }
}

void draw_sweep(SvgWriter& svg, const Footprint& footprint, const std::vector<Sample>& samples) {
  std::vector<Ring> rings;
  std::vector<Ring> ghosts;
  double next = 0.0;
  double next_ghost = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (s.s < next && i + 1 < samples.size() && s.direction != 0) continue;
    next = s.s + sweep_step;
    rings.push_back(outline_at(footprint, s.pose()));
    if (s.s >= next_ghost) {
      next_ghost = s.s + ghost_step;
      ghosts.push_back(rings.back());
    }
  }
  svg.union_of(rings, "sweep");
  for (const Ring& ghost : ghosts) svg.polygon(ghost, "ghost");
}

}  // namespace waywright
