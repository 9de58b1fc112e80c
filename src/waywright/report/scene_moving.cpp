#include "waywright/report/scene_moving.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/closest_approach.hpp"

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

constexpr double about_ticks = 8.0;  // on the vehicle's way

/// 1, 2 or 5 times a power of ten.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double k : {1.0, 2.0, 5.0}) {
    if (k * power >= least) return k * power;
  }
  return 10.0 * power;
}

/// Strokes across a way at round times, with the times; those that fall together (of what stands) have one stroke and the time from the first to the last.
void draw_ticks(SvgWriter& svg, Labels& labels, double end, const Box& region, std::string_view style, const auto& pose_of, const auto& across) {
  constexpr double together = 12.0, half = 6.0;  // px
  if (!(end > 0.0)) return;
  const double step = round_step(end / about_ticks);
  const int count = static_cast<int>(std::floor(end / step * (1.0 + 1e-9)));
  for (int k = 1; k <= count;) {
    const Pose pose = pose_of(k * step);
    int last = k;
    while (last < count && distance(svg.view()(pose.position()), svg.view()(pose_of((last + 1) * step).position())) < together) ++last;
    const Vec2 at = pose.position();
    if (region.contains(at)) {
      const Vec2 aside = (half / svg.view().scale) * across(k * step);
      svg.line(at - aside, at + aside, style);
      const std::string text = last == k ? fmt::format("{} s", fixed(k * step)) : fmt::format("{}–{} s", fixed(k * step), fixed(last * step));
      labels.add({{text, "note"}, LabelRank::tick, {}, 0.0, at, {aside.x, -aside.y}, half + 2.0, 0.0});
    }
    k = last + 1;
  }
}

/// Where a motion leads next to, or came from; a unit vector.
Vec2 course_at(const auto& pose_of, double t, double end) {
  constexpr double soon = 0.05;  // s
  const Vec2 way = pose_of(std::min(end, t + soon)).position() - pose_of(std::max(0.0, t - soon)).position();
  return norm(way) > 0.0 ? (1.0 / norm(way)) * way : unit(pose_of(t).heading);
}

void draw_times(SvgWriter& svg, Labels& labels, double end, const Box& region, std::string_view style, const auto& pose_of) {
  draw_ticks(svg, labels, end, region, style, pose_of, [&](double t) { return left_of(course_at(pose_of, t, end)); });
}

/// Both at the moment of their closest approach, with a line between them.
bool draw_meetings(SvgWriter& svg, Labels& labels, const Problem& problem, const Plan& plan, const Box& region) {
  constexpr std::size_t most = 8;
  constexpr double far = 3.0;  // m: what never comes nearer is no meeting
  std::size_t drawn = 0;
  for (const ClosestApproach& c : closest_approaches(problem, plan.samples)) {
    if (drawn == most || (drawn > 0 && c.distance > far) || c.distance >= closest_cap) break;
    if (!region.contains(c.on_other)) continue;
    ++drawn;
    const Ring vehicle = outline_at(problem.footprint(), c.vehicle), other = outline_at(plan.scenario.moving[c.obstacle].footprint, c.other);
    svg.polygon(vehicle, "meeting");
    svg.polygon(other, "meeting");
    svg.line(c.on_vehicle, c.on_other, "meetingline");
    svg.dot(c.on_vehicle, 2.6, "meetingdot");
    svg.dot(c.on_other, 2.6, "meetingdot");
    for (const Ring& outline : {vehicle, other}) labels.keep_off(outline, true);
    const Vec2 way = c.on_other - c.on_vehicle, aside = left_of(way);
    labels.add({{fmt::format("{:.2f} m at {:.1f} s", c.distance, c.t), "meetingtext"}, LabelRank::spot, {}, 0.0, 0.5 * (c.on_vehicle + c.on_other), {aside.x, -aside.y}, 12.0});
  }
  return drawn > 0;
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

bool draw_moving(SvgWriter& svg, Labels& labels, const Problem& problem, const Plan& plan, const Box& region) {
  const std::vector<MovingObstacle>& moving = plan.scenario.moving;
  if (moving.empty()) return false;
  constexpr std::size_t most_timed = 20;  // more tracks with times on them would hide the map
  const double end = plan.samples.empty() ? 0.0 : plan.samples.back().t;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const MovingObstacle& obstacle = moving[i];
    const std::vector<Vec2> way = way_until(obstacle, end);
    const bool moves = way.front() != way.back() || way.size() > 2;
    if (moves) {
      svg.polyline(way, "movingway");
      labels.keep_off(way, false);
    }
    for (const Wait& wait : plan.waits) {
      if (wait.obstacle == i) svg.polygon(outline_at(obstacle.footprint, obstacle.at(wait.from)), "movinglater");
    }
    svg.polygon(outline_at(obstacle.footprint, obstacle.at(end)), "movinglater");
    svg.polygon(outline_at(obstacle.footprint, obstacle.at(0.0)), "moving");
    if (moves && moving.size() <= most_timed) draw_times(svg, labels, end, region, "movingtick", [&](double t) { return obstacle.at(t); });
    // Beside its outline: on it, the name would hide where it stands.
    const Box box = bounding_box(outline_at(obstacle.footprint, obstacle.at(0.0)));
    labels.add({{title_of(obstacle, i), "note"}, LabelRank::thing, {}, 0.0, {box.high.x, 0.5 * (box.low.y + box.high.y)}, {1.0, 0.0}, 8.0});
  }
  if (plan.samples.empty()) return false;
  draw_times(svg, labels, end, region, "waytick", [&](double t) { return pose_at(plan.samples, t); });
  return draw_meetings(svg, labels, problem, plan, region);
}

void draw_waits(SvgWriter& svg, Labels& labels, const Plan& plan) {
  for (const Wait& wait : plan.waits) {
    svg.square(wait.pose.position(), 9.0, "wait");
    const Vec2 beside = left_of(unit(wait.pose.heading));
    labels.add({{fmt::format("waits {:.1f} s", wait.until - wait.from), "note", fmt::format("from {:.1f} s on", wait.from)}, LabelRank::thing, {}, 0.0, wait.pose.position(), {beside.x, -beside.y}});
  }
}

std::vector<LegendEntry> moving_legend(const Plan& plan, bool has_meetings) {
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
  if (!plan.scenario.moving.empty() && !plan.samples.empty()) entries.push_back({"waytick", Shape::line, "at the same times after the start"});
  if (has_meetings) entries.push_back({"meeting", Shape::box, "both where they come nearest to each other: gap as predicted, time"});
  if (!plan.waits.empty()) entries.push_back({"wait", Shape::square, "waits for what moves"});
  return entries;
}

}  // namespace waywright
