#include "waywright/report/map_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/report/scene_lanes.hpp"

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

/// Lanes, places and stations.
void draw_lanes(SvgWriter& svg, Labels& labels, const LaneGraph& graph) {
  constexpr double shortest_arrow = 18.0, gap = 7.0, half = 5.0;  // px
  for (const Lane& lane : graph.lanes) {
    svg.polyline(lane.course, "placedline");
    labels.keep_off(lane.course, false);
  }
  for (const Lane& lane : graph.lanes) {
    if (!lane.is_both_ways) draw_course_arrow(svg, lane.course, shortest_arrow, "fwdmark");
  }
  for (const LaneStation& station : graph.stations) {
    for (const std::size_t place : station.places) svg.line(station.at, graph.places[place].at, "spotline");
  }
  for (const LanePlace& place : graph.places) {
    svg.dot(place.at, 3.0, "fwdmark");
    for (const Vec2 off : {Vec2{0, 0}, Vec2{3, 0}, Vec2{-3, 0}, Vec2{0, 3}, Vec2{0, -3}}) labels.room().take(svg.view()(place.at) + off);
    labels.add({{place.name, "note"}, LabelRank::thing, {}, 0.0, place.at, {1.0, -1.0}, gap, 0.0});
  }
  for (const LaneStation& station : graph.stations) {
    svg.square(station.at, 9.0, "placed");
    const Vec2 at = svg.view()(station.at), reach{half, half};
    labels.room().take(Box{at - reach, at + reach});
    labels.add({{station.name, "note"}, LabelRank::spot, {}, 0.0, station.at, {1.0, -1.0}, gap + half, 0.0});
  }
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
  Labels labels = labels_for(canvas);
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
    draw_lanes(svg, labels, *picture.lanes);
    legend.push_back({"placedline", Shape::line, "lanes; an arrow: one way"});
    legend.push_back({"fwdmark", Shape::dot, "places"});
    if (!picture.lanes->stations.empty()) legend.push_back({"placed", Shape::box, "stations"});
  }
  for (std::size_t i = 0; i < picture.pairs.size(); ++i) {
    const Vec2 at = picture.pairs[i].meant;
    svg.polyline({picture.pairs[i].placed, at}, "spotline");
    svg.dot(at, 4.5, "spot");
    const bool known = map.alignment && i < map.alignment->residuals.size();
    labels.add({{known ? fmt::format("{}: {:.0f} mm", i + 1, 1e3 * map.alignment->residuals[i]) : fmt::format("{}", i + 1), "name"}, LabelRank::end, {}, 0.0, at, {1.0, -1.0}, 8.0});
  }
  if (!picture.pairs.empty()) legend.push_back({"spot", Shape::dot, "where pairs of points should lie, and a line to where they do"});
  if (labels.write(svg) > 0) legend.push_back({"", Shape::none, "names are left out where they have no room"});
  svg.close_group();
  draw_axes(svg, canvas);
  draw_scale(svg, canvas);
  const double whole = std::max(canvas.width, 480.0);
  const double end = draw_legend(svg, legend, whole, canvas.height + 40.0);
  return framed(svg.take(), whole, end + 14.0, picture.name);
}

}  // namespace waywright
