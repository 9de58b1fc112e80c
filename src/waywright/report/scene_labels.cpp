// What is written in the picture beside what it names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/geometry/polygon.hpp"
#include "waywright/report/scene_parts.hpp"

namespace waywright {

namespace {

/// Where a text begins, or ends where it grows to the left, on its base line; px.
struct LabelPlace {
  double x = 0.0, y = 0.0;
  bool from_right = false;
  Box box{};
};

/// `d` is a unit vector; `off`: so much farther away.
LabelPlace label_place(const Canvas& canvas, Vec2 point, Vec2 d, const Label& label, double off) {
  const double letter = label.style_class == "note" ? 7.0 : 10.0;  // px, at least what most letters take: nothing is cut off at the edge
  const double needed = std::max(letter * static_cast<double>(label.text.size()),
                                 6.9 * static_cast<double>(label.below.size()));
  const Vec2 at = canvas.view(point);
  const double x = at.x + (12.0 + off) * d.x - (d.x < -0.3 ? needed : d.x < 0.3 ? 0.5 * needed : 0.0);
  double y = at.y + (16.0 + off) * d.y + 5.0;
  if (!label.below.empty() && d.y < -0.3) y -= 14.0;  // the second line stays above the point too
  double kept = std::clamp(x, left_gutter + 4.0, std::max(left_gutter + 4.0, canvas.width - needed - 4.0));
  // Moved along, it would stand on what it names.
  if (std::abs(kept - x) > 0.3 * needed) y += d.y < 0.0 ? -26.0 : 14.0;
  y = std::clamp(y, 16.0, canvas.height - bottom_gutter - 6.0);
  // On a narrow page letters are larger: near the right edge they grow to the left.
  const bool from_right = kept + 2.6 * needed > canvas.width;
  const double below = label.below.empty() ? 3.0 : 18.0;
  return {from_right ? kept + needed : kept, y, from_right, {{kept, y - 12.0}, {kept + needed, y + below}}};
}

}  // namespace

void label_beside(SvgWriter& svg, const Canvas& canvas, Vec2 point, Vec2 away, const Label& label, LabelRoom* room) {
  const double length = norm(away);
  const Vec2 d = length > 0.0 ? (1.0 / length) * away : Vec2{0.0, 1.0};
  LabelPlace best = label_place(canvas, point, d, label, 0.0);
  if (room != nullptr) {
    constexpr double eighth = two_pi / 8.0;
    constexpr double turned = 0.25, farther = 0.6;  // of a hidden point each: what is nearer to the side that was asked for is better
    double least = room->hidden_by(best.box);
    bool is_far = false;
    for (const double off : {0.0, 14.0, 30.0}) {
      for (const int k : {0, 1, -1, 2, -2, 3, -3, 4}) {
        const LabelPlace place = label_place(canvas, point, unit(angle_of(d) + k * eighth), label, off);
        const double hides = room->hidden_by(place.box) + turned * std::abs(k) + farther * off / 14.0;
        if (hides >= least) continue;
        least = hides;
        best = place;
        is_far = off > 0.0;
      }
    }
    room->take(best.box);
    if (is_far) {  // which place it names is not seen otherwise
      const Vec2 at = canvas.view(point), end{std::clamp(at.x, best.box.low.x, best.box.high.x), std::clamp(at.y, best.box.low.y, best.box.high.y)};
      svg.raw(fmt::format("<line class=\"leader\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", fixed(at.x), fixed(at.y), fixed(end.x), fixed(end.y)));
    }
  }
  const std::string anchor = best.from_right ? " end" : "";
  svg.label(point, Vec2{best.x, best.y} - canvas.view(point), label.text, label.style_class + anchor);
  if (label.below.empty()) return;
  svg.raw(fmt::format("<text class=\"{} note{}\" x=\"{}\" y=\"{}\" dy=\"1.2em\">{}</text>\n",
                      label.style_class, anchor, fixed(best.x), fixed(best.y), escaped(label.below)));
}

Vec2 point_on(const Footprint& footprint, const Pose& pose, Vec2 obstacle) {
  if (!footprint.is_disc()) return nearest_in(outline_at(footprint, pose), obstacle);
  const Vec2 d = obstacle - pose.position();
  return norm(d) > 0.0 ? pose.position() + std::min(1.0, footprint.disc / norm(d)) * d : pose.position();
}

void draw_tightest_spot(SvgWriter& svg, const Canvas& canvas, const Footprint& footprint, const Certificate& c, bool has_pose_error, bool is_proven, LabelRoom* room) {
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
  label_beside(svg, canvas, c.tightest_point, away,
               {c.collision_free && !second_line ? fmt::format("{:.1f} mm{}", 1000.0 * c.clearance, is_proven ? " proven" : "") : gap > 0.0 ? fmt::format("{:.1f} mm", 1000.0 * gap) : "touches", "tighttext",
                second_line ? fmt::format("{:.1f} with pose error", 1000.0 * c.clearance) : ""},
               room);
}

}  // namespace waywright
