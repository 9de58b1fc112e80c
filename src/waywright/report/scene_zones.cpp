#include "waywright/report/scene_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/core/result.hpp"
#include "waywright/geometry/convex_parts.hpp"

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

/// A point inside: the middle of the box where that is, else of the largest convex part.
Vec2 inner_point(const Ring& area) {
  const Box box = bounding_box(area);
  const Vec2 middle = 0.5 * (box.low + box.high);
  if (contains(area, middle)) return middle;
  const std::vector<Ring> parts = convex_parts(area);
  const auto largest = std::max_element(parts.begin(), parts.end(), [](const Ring& a, const Ring& b) { return signed_area(a) < signed_area(b); });
  Vec2 sum{};
  for (const Vec2 p : *largest) sum = sum + p;
  return (1.0 / static_cast<double>(largest->size())) * sum;
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

std::string label_of(const Zone& zone) {
  std::string value;
  switch (zone.type) {
    case ZoneType::forbidden:
    case ZoneType::directed: break;
    case ZoneType::preferred:
    case ZoneType::penalty: value = fmt::format("× {:g}", zone.factor); break;
    case ZoneType::speed_limit: value = fmt::format("{:g} m/s", zone.speed); break;
  }
  const std::string name = one_line(zone.name);
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

void draw_zone_names(SvgWriter& svg, const std::vector<Zone>& zones, const Box& region, LabelRoom& room) {
  // Where many zones lie beside each other (lanes of a plant) not all names have room: those of one-way zones, which have arrows, give way to others.
  std::vector<const Zone*> in_turn;
  for (const bool are_directed : {false, true}) {
    for (const Zone& zone : zones) {
      if ((zone.type == ZoneType::directed) == are_directed) in_turn.push_back(&zone);
    }
  }
  std::vector<Box> written;  // px
  const auto meet = [](const Box& a, const Box& b) { return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y; };
  const Vec2 left_top = svg.view()({region.low.x, region.high.y}), right_bottom = svg.view()({region.high.x, region.low.y});
  constexpr std::size_t few = 8;  // one-way zones: then each name is wanted
  const bool are_many = std::count_if(zones.begin(), zones.end(), [](const Zone& z) { return z.type == ZoneType::directed; }) > static_cast<std::ptrdiff_t>(few);
  /// Where it would stand, moved into the picture; empty: there is no room.
  const auto room_for = [&](Vec2 at, const Zone& zone, const std::string& text) -> std::optional<Vec2> {
    const Vec2 half{3.4 * static_cast<double>(text.size()) + 3.0, 8.0};
    Vec2 middle = svg.view()(at);
    middle.x = std::clamp(middle.x, left_top.x + half.x + 2.0, std::max(left_top.x + half.x + 2.0, right_bottom.x - half.x - 2.0));
    const Box box{middle - half, middle + half};
    if (box.high.x > right_bottom.x) return std::nullopt;
    if (std::any_of(written.begin(), written.end(), [&](const Box& b) { return meet(b, box); })) return std::nullopt;
    if (zone.type == ZoneType::directed && are_many) {
      const Box area = bounding_box(zone.area);
      const Vec2 size = svg.view().scale * (area.high - area.low);
      if (2.0 * half.x > size.x + 8.0 || 2.0 * half.y > size.y + 4.0 || room.hidden_by(box) > 0.0) return std::nullopt;
    }
    written.push_back(box);
    room.take(box);
    return middle;
  };
  for (const Zone* const one : in_turn) {
    const Zone& zone = *one;
    const std::string text = label_of(zone);
    if (text.empty()) continue;
    // Along the upper edge, else along the lower one, where fewer paths pass than through the middle.
    const Box box = bounding_box(zone.area);
    const double x = 0.5 * (std::max(box.low.x, region.low.x) + std::min(box.high.x, region.high.x)), off = 12.0 / svg.view().scale;
    Vec2 at = inner_point(zone.area);
    for (const Vec2 edge : {Vec2{x, box.low.y + off}, Vec2{x, box.high.y - off}}) {
      if (contains(zone.area, edge) && region.contains(edge)) at = edge;
    }
    if (!region.contains(at)) continue;
    if (const auto middle = room_for(at, zone, text)) svg.label(at, *middle - svg.view()(at) + Vec2{0.0, 4.0}, text, "note middle");
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
