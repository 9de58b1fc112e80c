#include "waywright/report/scene_lanes.hpp"

#include <algorithm>

#include "waywright/io/lane_courses.hpp"

namespace waywright {
namespace {

struct Middle {
  Vec2 at{}, along{};
  double length = 0.0;
};

/// Halfway along a course.
Middle middle_of(const Polyline& course) {
  Middle middle;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) middle.length += distance(course[i], course[i + 1]);
  double left = 0.5 * middle.length;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const double piece = distance(course[i], course[i + 1]);
    if (piece < left || !(piece > 0.0)) {
      left -= piece;
      continue;
    }
    middle.along = (1.0 / piece) * (course[i + 1] - course[i]);
    middle.at = course[i] + left * middle.along;
    return middle;
  }
  return middle;
}

void draw_head(SvgWriter& svg, const Middle& middle, std::string_view style) {
  const double pixel = 1.0 / svg.view().scale;
  const Vec2 tip = middle.at + (4.0 * pixel) * middle.along, back = tip - (9.0 * pixel) * middle.along, aside = (4.0 * pixel) * left_of(middle.along);
  svg.polygon({tip, back + aside, back - aside}, style);
}

}  // namespace

void draw_course_arrow(SvgWriter& svg, const Polyline& course, double shortest, std::string_view style) {
  const Middle middle = middle_of(course);
  if (middle.length * svg.view().scale > shortest && norm(middle.along) > 0.0) draw_head(svg, middle, style);
}

bool draw_lane_courses(SvgWriter& svg, const std::string& meta, const std::vector<Zone>& zones) {
  constexpr double shortest = 18.0;  // px
  const LaneCourses lanes = lane_courses_of(meta);
  for (const Polyline& course : lanes.courses) svg.polyline(course, "lane");
  for (std::size_t i = 0; i < lanes.courses.size(); ++i) {
    if (lanes.one_way[i] == 0) continue;
    const Vec2 at = middle_of(lanes.courses[i]).at;
    const bool has_zone = std::any_of(zones.begin(), zones.end(), [&](const Zone& z) { return z.type == ZoneType::directed && contains(z.area, at); });
    if (!has_zone) draw_course_arrow(svg, lanes.courses[i], shortest, "lanehead");
  }
  return !lanes.courses.empty();
}

std::vector<LegendEntry> lane_legend() { return {{"lane", LegendEntry::Shape::line, "lane; an arrow: one way"}}; }

}  // namespace waywright
