#include "waywright/report/scene_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/result.hpp"
#include "waywright/geometry/pole.hpp"
#include "waywright/report/text_size.hpp"

namespace waywright {
namespace {

const char* style_of(ZoneType type) {
  switch (type) {
    case ZoneType::forbidden: return "zoneforbidden";
    case ZoneType::directed: return "zonedirected";
    case ZoneType::preferred: return "zonepreferred";
    case ZoneType::penalty: return "zonepenalty";
    case ZoneType::speed_limit: return "zonespeed";
  }
  return "";
}

/// A point inside: the middle of the box where that is, else the one farthest from the outline.
Vec2 inner_point(const Ring& area) {
  const Box box = bounding_box(area);
  const Vec2 middle = 0.5 * (box.low + box.high);
  return contains(area, middle) ? middle : pole_of_inaccessibility(area, 0.02 * norm(box.high - box.low));
}

/// Arrows along the direction, one after another through the zone's middle.
void draw_arrows(SvgWriter& svg, const Zone& zone) {
  const double scale = svg.view().scale;
  const Vec2 along = unit(zone.direction), across = left_of(along), middle = inner_point(zone.area);
  const double length = 34.0 / scale, apart = 110.0 / scale, head = 9.0 / scale;
  const auto draw_at = [&](Vec2 at, double long_as) {
    const Vec2 tail = at - (0.5 * long_as) * along, tip = at + (0.5 * long_as) * along;
    svg.line(tail, tip - (0.6 * head) * along, "zonearrow");
    svg.polygon({tip, tip - head * along + (0.5 * head) * across, tip - head * along - (0.5 * head) * across}, "zonearrowhead");
  };
  const auto fits = [&](Vec2 at) { return contains(zone.area, at - (0.7 * length) * along) && contains(zone.area, at) && contains(zone.area, at + (0.7 * length) * along); };
  constexpr int most = 40;
  bool is_any = false;
  for (const double side : {0.5, -0.5}) {  // none in the middle, where the name stands
    for (int k = 0; k < most; ++k) {
      const Vec2 at = middle + (side * (1 + 2 * k) * apart) * along;
      if (!fits(at)) break;
      draw_at(at, length);
      is_any = true;
    }
  }
  if (!is_any) draw_at(middle, fits(middle) ? length : 0.6 * length);
}

/// What its type limits: "× 0.5", "0.4 m/s".
std::string value_of(const Zone& zone) {
  switch (zone.type) {
    case ZoneType::forbidden:
    case ZoneType::directed: return {};
    case ZoneType::preferred:
    case ZoneType::penalty: return fmt::format("× {:g}", zone.factor);
    case ZoneType::speed_limit: return fmt::format("{:g} m/s", zone.speed);
  }
  return {};
}

std::string label_of(const Zone& zone) {
  const std::string name = one_line(zone.name), value = value_of(zone);
  return name.empty() || value.empty() ? name + value : name + ", " + value;
}

}  // namespace

void draw_zone_areas(SvgWriter& svg, const std::vector<Zone>& zones) {
  if (zones.empty()) return;
  // Drawn with the colours of the page's style, which follow its light and dark.
  svg.raw("<defs><pattern id=\"zonehatch\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect class=\"zonehatchline\" width=\"2\" height=\"8\"/></pattern></defs>\n");
  for (const Zone& zone : zones) {
    svg.polygon(zone.area, style_of(zone.type));
    if (zone.type == ZoneType::directed) draw_arrows(svg, zone);
  }
}

void name_zones(Labels& labels, const View& view, const std::vector<Zone>& zones, const Box& region) {
  constexpr std::size_t few = 8;  // one-way zones: then each name is wanted
  constexpr double near = 60.0;   // px
  const bool are_many = std::count_if(zones.begin(), zones.end(), [](const Zone& z) { return z.type == ZoneType::directed; }) > static_cast<std::ptrdiff_t>(few);
  for (const Zone& zone : zones) {
    const bool is_directed = zone.type == ZoneType::directed;
    std::string text = label_of(zone);
    const Box box = bounding_box(zone.area);
    const Vec2 size = view.scale * (box.high - box.low);
    if (are_many && (text_width(text, 12.0, false) > size.x + 2.0 || size.y < 12.0)) {
      text = value_of(zone);  // among many a long name would hide those beside it
      if (text.empty()) continue;
    }
    // Along the upper edge, else along the lower one, where fewer paths pass than through the middle.
    const double x = 0.5 * (std::max(box.low.x, region.low.x) + std::min(box.high.x, region.high.x)), off = 12.0 / view.scale;
    const Vec2 inner = inner_point(zone.area);
    Labels::Wish wish{{text, "note"}, is_directed ? LabelRank::tick : LabelRank::zone, {}, is_directed && are_many ? 0.0 : Labels::anywhere, inner, {0.0, -1.0}, 10.0, is_directed ? -1.0 : near};
    for (const Vec2 edge : {Vec2{x, box.high.y - off}, Vec2{x, box.low.y + off}}) {
      if (contains(zone.area, edge) && region.contains(edge)) wish.middles.push_back(edge);
    }
    if (region.contains(inner)) wish.middles.push_back(inner);
    if (wish.middles.empty()) continue;
    wish.point = wish.middles.back();
    labels.add(std::move(wish));
  }
}

std::vector<LegendEntry> zone_legend(const std::vector<Zone>& zones) {
  std::vector<LegendEntry> entries;
  for (const ZoneType type : zone_types) {
    if (std::none_of(zones.begin(), zones.end(), [&](const Zone& z) { return z.type == type; })) continue;
    const char* text = type == ZoneType::forbidden ? "forbidden zone"
                       : type == ZoneType::directed ? "one way, along the arrows"
                       : type == ZoneType::preferred ? "preferred, a metre costs less"
                       : type == ZoneType::penalty ? "penalty, a metre costs more"
                                                   : "speed limit";
    entries.push_back({style_of(type), LegendEntry::Shape::box, text});
  }
  return entries;
}

}  // namespace waywright
