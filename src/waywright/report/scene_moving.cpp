#include "waywright/report/scene_moving.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waywright {
namespace {

/// Its places up to a time: where its motion changes, and at the end.
std::vector<Vec2> way_until(const MovingObstacle& obstacle, double end) {
  std::vector<Vec2> way{obstacle.at(0.0).position()};
  for (const MovingObstacle::Place& place : obstacle.track) {
    if (place.t > 0.0 && place.t < end) way.push_back(place.pose.position());
  }
  way.push_back(obstacle.at(end).position());
  return way;
}

}  // namespace

void draw_replanned(SvgWriter& svg, const Replanned& replanned) {
  if (replanned.driven.size() > 1) {
    std::vector<Vec2> points;
    for (const Pose& p : replanned.driven) points.push_back(p.position());
    svg.polyline(points, "driven");
  }
  for (const Ring& ring : replanned.obstacles) {
    if (ring.size() == 1) svg.dot(ring.front(), 3.0, "appeareddot");
    else svg.polygon(ring, "appeared");
  }
  for (const Polyline& line : replanned.lines) svg.polyline(line, "appearedline");
}

void draw_moving(SvgWriter& svg, const Canvas& canvas, const Plan& plan, LabelRoom& room) {
  const double end = plan.samples.empty() ? 0.0 : plan.samples.back().t;
  for (std::size_t i = 0; i < plan.scenario.moving.size(); ++i) {
    const MovingObstacle& obstacle = plan.scenario.moving[i];
    const std::vector<Vec2> way = way_until(obstacle, end);
    if (way.front() != way.back() || way.size() > 2) svg.polyline(way, "movingway");
    for (const Wait& wait : plan.waits) {
      if (wait.obstacle == i) svg.polygon(outline_at(obstacle.footprint, obstacle.at(wait.from)), "movinglater");
    }
    svg.polygon(outline_at(obstacle.footprint, obstacle.at(end)), "movinglater");
    svg.polygon(outline_at(obstacle.footprint, obstacle.at(0.0)), "moving");
    // Beside its outline: on it, the name would hide where it stands.
    const Ring there = outline_at(obstacle.footprint, obstacle.at(0.0));
    const Box box = bounding_box(there);
    const Vec2 left_top = canvas.view({box.low.x, box.high.y}), right_bottom = canvas.view({box.high.x, box.low.y});
    room.take(Box{left_top, right_bottom});
    label_beside(svg, canvas, {box.high.x, 0.5 * (box.low.y + box.high.y)}, {1.0, 0.0}, {title_of(obstacle, i), "note"}, &room);
  }
}

void draw_waits(SvgWriter& svg, const Canvas& canvas, const Plan& plan, LabelRoom& room) {
  for (const Wait& wait : plan.waits) {
    svg.square(wait.pose.position(), 9.0, "wait");
    const Vec2 beside = left_of(unit(wait.pose.heading));
    label_beside(svg, canvas, wait.pose.position(), {beside.x, -beside.y}, {fmt::format("waits {:.1f} s", wait.until - wait.from), "note", fmt::format("from {:.1f} s on", wait.from)}, &room);
  }
}

std::vector<LegendEntry> moving_legend(const Plan& plan) {
  using Shape = LegendEntry::Shape;
  std::vector<LegendEntry> entries;
  if (plan.replanned) {
    if (plan.replanned->driven.size() > 1) entries.push_back({"driven", Shape::line, "driven already"});
    if (!plan.replanned->obstacles.empty() || !plan.replanned->lines.empty()) entries.push_back({"appeared", Shape::box, "new obstacle"});
  }
  if (!plan.scenario.moving.empty()) {
    entries.push_back({"moving", Shape::box, "moves: at the start"});
    entries.push_back({"movinglater", Shape::box, plan.waits.empty() ? "at the plan's end" : "when the vehicle stops, and at the plan's end"});
  }
  if (!plan.waits.empty()) entries.push_back({"wait", Shape::square, "waits for what moves"});
  return entries;
}

}  // namespace waywright
