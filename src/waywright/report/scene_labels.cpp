// What is written in the picture beside what it names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/geometry/polygon.hpp"
#include "waywright/report/scene_parts.hpp"

namespace waywright {

Labels labels_for(const Canvas& canvas) {
  constexpr double edge = 3.0;  // px
  return {canvas.view, {{left_gutter + edge, edge}, {canvas.width - edge, canvas.height - bottom_gutter - edge}}};
}

void name_end(Labels& labels, Vec2 point, const std::string& name) { 
  constexpr double heed = 0.25;  // a letter on an outline is found sooner than one away from it
  labels.add({{name, "name"}, LabelRank::end, {}, 0.0, point, {1.0, -1.0}, 7.0, Labels::anywhere, heed});
}

Vec2 point_on(const Footprint& footprint, const Pose& pose, Vec2 obstacle) {
  if (!footprint.is_disc()) return nearest_in(outline_at(footprint, pose), obstacle);
  const Vec2 d = obstacle - pose.position();
  return norm(d) > 0.0 ? pose.position() + std::min(1.0, footprint.disc / norm(d)) * d : pose.position();
}

void draw_tightest_spot(SvgWriter& svg, Labels& labels, const Footprint& footprint, const Certificate& c, bool has_pose_error, bool is_proven) {
  const Vec2 on = point_on(footprint, *c.tightest, c.tightest_point);
  const double gap = distance(on, c.tightest_point);
  svg.polygon(outline_at(footprint, *c.tightest), c.collision_free ? "ghost" : "hit");
  svg.line(on, c.tightest_point, "tight");
  svg.dot(c.tightest_point, c.collision_free ? 3.5 : 4.5, "tightdot");
  // Straight beside the vehicle the name leans to the side of it on which the spot lies.
  const Box body = bounding_box(outline_at(footprint, *c.tightest));
  const Vec2 from_middle = on - 0.5 * (body.low + body.high);
  const Vec2 away{c.tightest_point.x - on.x, on.y - c.tightest_point.y - 1e-3 * from_middle.y};
  const bool second_line = c.collision_free && has_pose_error;
  constexpr double heed = 0.4;  // it may cross an outline, rather than be far off
  const std::string measure = c.collision_free && !second_line ? fmt::format("{:.1f} mm{}", 1000.0 * c.clearance, is_proven ? " proven" : "") : gap > 0.0 ? fmt::format("{:.1f} mm", 1000.0 * gap) : "touches";
  labels.add({{measure, "tighttext", second_line ? fmt::format("{:.1f} with pose error", 1000.0 * c.clearance) : ""}, LabelRank::tightest, {}, 0.0, c.tightest_point, away, 14.0, Labels::anywhere, heed});
}

}  // namespace waywright
