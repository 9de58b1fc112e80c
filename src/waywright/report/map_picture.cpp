#include "waywright/report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/scene_parts.hpp"

namespace waywright {
namespace {

/// What there is to see: of cells those of which something is known.
class Extent {
 public:
  void add(Vec2 p) {
    box_.low = any_ ? Vec2{std::min(box_.low.x, p.x), std::min(box_.low.y, p.y)} : p;
    box_.high = any_ ? Vec2{std::max(box_.high.x, p.x), std::max(box_.high.y, p.y)} : p;
    any_ = true;
  }
  void add(const Map& map) {
    for (const auto* lists : {&map.boundaries, &map.obstacles, &map.lines}) {
      for (const auto& list : *lists) {
        for (const Vec2 p : list) add(p);
      }
    }
    for (const Vec2 p : map.points) add(p);
    for (const CellGrid& grid : map.grids) add(grid);
  }
  void add(const LaneGraph& lanes) {
    for (const LanePlace& place : lanes.places) add(place.at);
    for (const Lane& lane : lanes.lanes) {
      for (const Vec2 p : lane.course) add(p);
    }
    for (const LaneStation& station : lanes.stations) add(station.at);
  }
  Box with_margin() const {
    const double margin = std::max(0.04 * norm(box_.high - box_.low), 1e-3);
    return {box_.low - Vec2{margin, margin}, box_.high + Vec2{margin, margin}};
  }

 private:
  void add(const CellGrid& grid) {
    constexpr std::uint8_t unknown = 2;
    int left = grid.columns, right = -1, top = grid.rows, bottom = -1;
    for (int r = 0; r < grid.rows; ++r) {
      const auto* row = grid.blocked.data() + static_cast<std::ptrdiff_t>(r) * grid.columns;
      for (int c = 0; c < grid.columns; ++c) {
        if (row[c] == unknown) continue;
        left = std::min(left, c);
        right = std::max(right, c + 1);
        top = std::min(top, r);
        bottom = std::max(bottom, r + 1);
      }
    }
    if (right < 0) left = top = 0, right = grid.columns, bottom = grid.rows;
    for (const int c : {left, right}) {
      for (const int r : {top, bottom}) add(grid.corner(c, r));
    }
  }
  Box box_{};
  bool any_ = false;
};

void draw_placed(SvgWriter& svg, const Map& map) {
  for (const Ring& ring : map.obstacles) svg.polygon(ring, "placed");
  for (const Ring& ring : map.boundaries) svg.polygon(ring, "placedbound");
  for (const Polyline& line : map.lines) svg.polyline(line, "placedline");
  for (const Vec2 p : map.points) svg.dot(p, 1.8, "fwdmark");
}

/// An arrow head of some pixels in the middle of a lane; of one that is driven both ways none.
void draw_arrow(SvgWriter& svg, const Lane& lane, double pixel) {
  double half = 0.5 * length(lane);
  for (std::size_t i = 0; i + 1 < lane.course.size(); ++i) {
    const Vec2 way = lane.course[i + 1] - lane.course[i];
    const double piece = norm(way);
    if (piece < half || !(piece > 0.0)) {
      half -= piece;
      continue;
    }
    const Vec2 along = (1.0 / piece) * way, tip = lane.course[i] + half * along + (4.0 * pixel) * along, back = tip - (9.0 * pixel) * along;
    svg.polygon({tip, back + (4.0 * pixel) * left_of(along), back - (4.0 * pixel) * left_of(along)}, "fwdmark");
    return;
  }
}

/// Lanes, places and stations; names where there is room for them, left of their places near the `right` edge (px).
void draw_lanes(SvgWriter& svg, const LaneGraph& graph, double right) {
  constexpr double shortest_arrow = 18.0, room = 26.0;  // px
  const double pixel = 1.0 / svg.view().scale;
  for (const Lane& lane : graph.lanes) svg.polyline(lane.course, "placedline");
  for (const Lane& lane : graph.lanes) {
    if (!lane.is_both_ways && length(lane) > shortest_arrow * pixel) draw_arrow(svg, lane, pixel);
  }
  std::vector<Vec2> written;
  const auto name = [&](Vec2 at, const std::string& text) {
    if (std::any_of(written.begin(), written.end(), [&](Vec2 other) { return std::abs(other.x - at.x) < 4.0 * room * pixel && std::abs(other.y - at.y) < 0.6 * room * pixel; })) return;
    written.push_back(at);
    const bool at_right = svg.view()(at).x > right - 7.0 * static_cast<double>(text.size()) - 8.0;
    svg.label(at, {at_right ? -6.0 : 6.0, -5.0}, text, at_right ? "note end" : "note");
  };
  for (const LaneStation& station : graph.stations) {
    for (const std::size_t place : station.places) svg.line(station.at, graph.places[place].at, "spotline");
  }
  for (const LanePlace& place : graph.places) svg.dot(place.at, 3.0, "fwdmark");
  for (const LaneStation& station : graph.stations) {
    svg.square(station.at, 9.0, "placed");
    name(station.at, station.name);
  }
  for (const LanePlace& place : graph.places) name(place.at, place.name);
}

}  // namespace

std::string map_svg(const MapPicture& picture, double width) {
  Extent extent;
  extent.add(*picture.map);
  for (const MapPicture::Pair& pair : picture.pairs) {
    extent.add(pair.placed);
    extent.add(pair.meant);
  }
  if (picture.below != nullptr) extent.add(*picture.below);
  if (picture.lanes != nullptr) extent.add(*picture.lanes);
  const Box region = extent.with_margin();
  const Vec2 size = region.high - region.low;
  const double scale = std::min((width - left_gutter) / size.x, 1.1 * width / size.y);
  const Canvas canvas{{region.low.x - left_gutter / scale, region.high.y, scale}, region, left_gutter + size.x * scale, size.y * scale + bottom_gutter};
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  using Shape = LegendEntry::Shape;
  std::vector<LegendEntry> legend;
  const Map& map = *picture.map;
  if (picture.below != nullptr) {
    svg.open_group("below", "opacity=\"0.5\"");  // or the other would not be seen on it
    draw_map(svg, *picture.below, region);
    svg.close_group();
    draw_map_cells(svg, map, region);
    draw_placed(svg, map);
    legend.push_back({"cell", Shape::box, picture.below_name});
    if (!map.obstacles.empty()) legend.push_back({"placed", Shape::box, picture.name + ": solid"});
    if (!map.lines.empty()) legend.push_back({"placedline", Shape::line, picture.name + ": walls"});
    if (!map.boundaries.empty()) legend.push_back({"placedbound", Shape::line, picture.name + ": boundary"});
  } else {
    draw_map(svg, map, region);
    if (!map.obstacles.empty()) legend.push_back({"obstacle", Shape::box, "obstacles"});
    if (!map.lines.empty()) legend.push_back({"wall", Shape::line, "walls"});
    if (!map.boundaries.empty()) legend.push_back({"boundary", Shape::line, "boundary"});
    if (!map.grids.empty()) legend.push_back({"cell", Shape::box, "occupied cells"});
  }
  if (std::any_of(map.grids.begin(), map.grids.end(), [](const CellGrid& g) { return std::find(g.blocked.begin(), g.blocked.end(), 2) != g.blocked.end(); }))
    legend.push_back({"unknown", Shape::box, "unknown"});
  if (picture.lanes != nullptr) {
    draw_lanes(svg, *picture.lanes, canvas.width);
    legend.push_back({"placedline", Shape::line, "lanes; an arrow: one way"});
    legend.push_back({"fwdmark", Shape::dot, "places"});
    if (!picture.lanes->stations.empty()) legend.push_back({"placed", Shape::box, "stations"});
  }
  for (std::size_t i = 0; i < picture.pairs.size(); ++i) {
    const Vec2 at = picture.pairs[i].meant;
    svg.polyline({picture.pairs[i].placed, at}, "spotline");
    svg.dot(at, 4.5, "spot");
    const bool known = map.alignment && i < map.alignment->residuals.size();
    const bool at_right = canvas.view(at).x > canvas.width - 100.0, at_top = canvas.view(at).y < 24.0;
    svg.label(at, {at_right ? -8.0 : 8.0, at_top ? 18.0 : -6.0}, known ? fmt::format("{}: {:.0f} mm", i + 1, 1e3 * map.alignment->residuals[i]) : fmt::format("{}", i + 1), at_right ? "name end" : "name");
  }
  if (!picture.pairs.empty()) legend.push_back({"spot", Shape::dot, "where pairs of points should lie, and a line to where they do"});
  svg.close_group();
  draw_axes(svg, canvas);
  draw_scale(svg, canvas);
  const double whole = std::max(canvas.width, 480.0);
  const double end = draw_legend(svg, legend, whole, canvas.height + 40.0);
  return framed(svg.take(), whole, end + 14.0, picture.name);
}

}  // namespace waywright
