// The map of the picture, and the frame around it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/geometry/pole.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/io/lane_courses.hpp"
#include "waywright/report/scene_parts.hpp"
#include "waywright/report/spots.hpp"

namespace waywright {
namespace {

constexpr double margin = 1.0;            // m around what is shown, at least
constexpr double margin_share = 0.02;     // of its longer side
constexpr std::size_t most_runs = 40000;  // of cells
constexpr std::size_t most_numbers = 60;  // of obstacles and lines: more would hide the map

void add_ring(std::vector<Vec2>& points, const Ring& ring) { points.insert(points.end(), ring.begin(), ring.end()); }

/// Of all that stands on a path: start, goal, and some of its poses.
void add_ways(std::vector<Vec2>& points, const Problem& problem, const std::vector<const Plan*>& plans) {
  add_ring(points, outline_at(problem.footprint(), problem.first_pose()));
  if (const FreeGoal* free = problem.free_goal()) add_ring(points, free->area);
  else add_ring(points, outline_at(problem.footprint(), problem.last_pose()));
  for (const Plan* plan : plans) {
    if (plan->replanned) {
      for (const Pose& pose : plan->replanned->driven) points.push_back(pose.position());
    }
    for (std::size_t i = 0; i < plan->samples.size(); i += 10) add_ring(points, outline_at(problem.footprint(), plan->samples[i].pose()));
  }
}

/// What must be seen: start, goal, station, path; the map is cropped to it.
std::vector<Vec2> seen_of(const Problem& problem, const std::vector<const Plan*>& plans) {
  const Scenario& scenario = problem.scenario();
  std::vector<Vec2> points;
  add_ways(points, problem, plans);
  if (const auto* station = std::get_if<Station>(&scenario.mission)) {
    add_ring(points, station->area);
    add_ring(points, station->shelf.outline());
  }
  return points;
}

/// What there is of the map beyond what must be seen: its boundary; without one its lines and obstacles; the lanes. Cells may reach far beyond what anybody drew.
std::vector<Vec2> extent_of(const Map& map, const std::vector<Polyline>& lanes) {
  std::vector<Vec2> points;
  if (!map.boundaries.empty()) {
    add_ring(points, map.boundaries.front());
  } else if (!map.lines.empty()) {
    for (const Polyline& line : map.lines) add_ring(points, line);
    for (const Ring& ring : map.obstacles) add_ring(points, ring);
  }
  for (const Polyline& lane : lanes) add_ring(points, lane);
  return points;
}

Box region_of(const Map& map, const std::vector<Vec2>& seen, const std::vector<Polyline>& lanes) {
  Box box = bounding_box(seen);
  if (const std::vector<Vec2> all = extent_of(map, lanes); !all.empty()) {
    const Box whole = bounding_box(all);
    const double larger = lanes.empty() ? 3.0 : 4.0;  // where lanes lead says more than what is beside the way
    if (norm(whole.high - whole.low) < larger * norm(box.high - box.low)) {
      const std::vector<Vec2> points{box.low, box.high, whole.low, whole.high};
      box = bounding_box(points);
    }
  }
  const double about = std::max(margin, margin_share * std::max(box.high.x - box.low.x, box.high.y - box.low.y));
  return {box.low - Vec2{about, about}, box.high + Vec2{about, about}};
}

void draw_cells(SvgWriter& svg, const CellGrid& grid, const Box& region) {
  // Rows and columns that the region can touch, in the grid's frame.
  const Frame frame{grid.origin};
  std::vector<Vec2> local;
  for (const Vec2 p : rectangle(region.low, region.high)) local.push_back(frame.to_local(p));
  const Box box = bounding_box(local);
  const auto clamped = [](double v, int most) {
    return static_cast<int>(std::clamp(std::floor(v), 0.0, static_cast<double>(most)));
  };
  const int c0 = clamped(box.low.x / grid.cell, grid.columns);
  const int c1 = clamped(box.high.x / grid.cell + 1.0, grid.columns);
  const int r0 = clamped(grid.rows - box.high.y / grid.cell, grid.rows);
  const int r1 = clamped(grid.rows - box.low.y / grid.cell + 1.0, grid.rows);
  for (const std::uint8_t kind : {std::uint8_t{2}, std::uint8_t{1}}) {
    std::vector<Ring> runs;
    for (int r = r0; r < r1 && runs.size() < most_runs; ++r) {
      const auto* row = grid.blocked.data() + static_cast<std::ptrdiff_t>(r) * grid.columns;
      for (int c = c0; c < c1; ++c) {
        if (row[c] != kind) continue;
        const int first = c;
        while (c < c1 && row[c] == kind) ++c;
        runs.push_back(
            {grid.corner(first, r + 1), grid.corner(c, r + 1), grid.corner(c, r), grid.corner(first, r)});
      }
    }
    svg.union_of(runs, kind == 1 ? "cell" : "unknown");
  }
}

/// 1, 2 or 5 times a power of ten, at most `metres`.
double round_length(double metres) {
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  for (const double k : {5.0, 2.0, 1.0}) {
    if (k * power <= metres) return k * power;
  }
  return power;
}

/// What of a ring lies in sight: the largest part.
Ring seen_part(const Ring& ring, const Box& region) {
  const Box box = bounding_box(ring);
  if (ring.size() < 3 || (region.contains(box.low) && region.contains(box.high))) return ring;
  std::vector<Ring> parts{ring};
  for (const auto& [normal, offset] : {std::pair{Vec2{1.0, 0.0}, region.low.x}, std::pair{Vec2{-1.0, 0.0}, -region.high.x}, std::pair{Vec2{0.0, 1.0}, region.low.y}, std::pair{Vec2{0.0, -1.0}, -region.high.y}}) {
    std::vector<Ring> left;
    for (const Ring& part : parts) {
      for (Ring& piece : clip_half_plane(part, normal, offset)) left.push_back(std::move(piece));
    }
    parts = std::move(left);
  }
  const auto largest = std::max_element(parts.begin(), parts.end(), [](const Ring& a, const Ring& b) { return signed_area(a) < signed_area(b); });
  return largest == parts.end() ? Ring{} : *largest;
}

/// Places along a line that lie in sight: the middle of it, then others.
std::vector<Vec2> places_along(const Polyline& line, const Box& region) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += distance(line[i], line[i + 1]);
  std::vector<Vec2> places;
  for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
    double left = share * length;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double piece = distance(line[i], line[i + 1]);
      if (left > piece && i + 2 < line.size()) {
        left -= piece;
        continue;
      }
      const Vec2 at = piece > 0.0 ? line[i] + std::min(1.0, left / piece) * (line[i + 1] - line[i]) : line[i];
      if (region.contains(at)) places.push_back(at);
      break;
    }
  }
  return places;
}

}  // namespace

bool name_obstacles(Labels& labels, const View& view, const Map& map, const Box& region, const std::string& tightest) {
  if (map.obstacles.size() + map.lines.size() > most_numbers) return false;
  constexpr double precise = 1.0, near = 40.0;  // px
  bool any = false;
  const auto add = [&](Labels::Wish wish, const std::string& source) {
    wish.rank = source == tightest ? LabelRank::spot : wish.rank;
    labels.add(std::move(wish));
    any = true;
  };
  for (const Ring& ring : map.obstacles) labels.keep_off(ring, true);
  for (const Polyline& line : map.lines) labels.keep_off(line, false);
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const Ring part = map.obstacles[i].empty() ? Ring{} : seen_part(map.obstacles[i], region);
    if (part.empty()) continue;
    const Vec2 at = pole_of_inaccessibility(part, precise / view.scale);
    if (!region.contains(at)) continue;
    const std::string number = fmt::format("{}", i);
    add({{number, "number"}, LabelRank::number, {at}, Labels::anywhere, at, {1.0, -1.0}, 6.0, near}, "obstacle " + number);
  }
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    const std::vector<Vec2> places = places_along(map.lines[i], region);
    if (places.empty()) continue;
    const std::string name = fmt::format("line {}", i);
    const Vec2 along = map.lines[i].back() - map.lines[i].front();
    add({{name, "number"}, LabelRank::other, {}, 0.0, places.front(), std::abs(along.x) > std::abs(along.y) ? Vec2{0.0, -1.0} : Vec2{1.0, 0.0}, 4.0, near}, name);
  }
  return any;
}

Ring outline_at(const Footprint& footprint, const Pose& pose) {
  if (!footprint.is_disc()) return transformed(footprint.polygon, Frame{pose});
  Ring ring;
  for (int i = 0; i < 36; ++i) ring.push_back(pose.position() + footprint.disc * unit(two_pi * i / 36.0));
  return ring;
}

namespace {

Canvas canvas_of(const Box& region, double scale) {
  return {{region.low.x - left_gutter / scale, region.high.y, scale}, region, left_gutter + (region.high.x - region.low.x) * scale, (region.high.y - region.low.y) * scale + bottom_gutter};
}

}  // namespace

Canvas canvas_for(const Problem& problem, const std::vector<const Plan*>& plans, double width) {
  return canvas_for(problem.scenario().map, seen_of(problem, plans), width, lane_courses_of(problem.scenario().meta).courses);
}

Canvas canvas_for(const Map& map, const std::vector<Vec2>& seen, double width, const std::vector<Polyline>& lanes) {
  Box region = region_of(map, seen, lanes);
  Vec2 size = region.high - region.low;
  // A way along a hall is a thread: what lies beside it is shown, too.
  constexpr double thinnest = 0.3;
  const double more_up = 0.5 * std::max(0.0, thinnest * size.x - size.y), more_across = 0.5 * std::max(0.0, thinnest * size.y - size.x);
  region = {region.low - Vec2{more_across, more_up}, region.high + Vec2{more_across, more_up}};
  size = region.high - region.low;
  return canvas_of(region, std::min((width - left_gutter) / size.x, 1.1 * width / size.y));
}

Canvas small_canvas(const Problem& problem, const Plan& plan) {
  std::vector<Vec2> points;
  add_ways(points, problem, {&plan});
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) add_ring(points, station->shelf.outline());
  for (const Spot& spot : blocked_spots(problem, plan)) add_ring(points, outline_at(problem.footprint(), spot.pose));
  return small_canvas(points);
}

Canvas small_canvas(const std::vector<Vec2>& seen) {
  constexpr double usual = 210.0, most = 420.0;     // px, of a square one
  constexpr double usual_extent = 15.0;             // m, from where it grows
  constexpr double tallest = 2.0, widest = 6.0;     // height to width and width to height: what is thinner gets more of the map
  constexpr double flat = 2.0, least_height = 150.0, most_width = 900.0;  // from where on it is wide, and by how much; px
  constexpr double least_margin = 0.7, share = 0.06;  // m; of the longer side
  const Box box = bounding_box(seen);
  const Vec2 middle = 0.5 * (box.low + box.high), inner = box.high - box.low;
  const double margin_here = std::max(least_margin, share * std::max(inner.x, inner.y));
  Vec2 size = inner + 2.0 * Vec2{margin_here, margin_here};
  size = {std::max(size.x, size.y / tallest), std::max(size.y, size.x / widest)};
  const double aspect = size.x / size.y, side = std::clamp(usual * std::sqrt(std::max(size.x, size.y) / usual_extent), usual, most);
  const double height = aspect >= flat ? std::min(std::max(least_height, side / std::sqrt(aspect)), most_width / aspect) : side / std::sqrt(aspect);
  return canvas_of({middle - 0.5 * size, middle + 0.5 * size}, height / size.y);
}

void open_map(SvgWriter& svg, const Canvas& canvas) {
  svg.raw(fmt::format(
      "<defs><clipPath id=\"map\"><rect x=\"{}\" width=\"{}\" height=\"{}\"/></clipPath></defs>\n",
      fixed(left_gutter), fixed(canvas.width - left_gutter), fixed(canvas.height - bottom_gutter)));
  svg.open_group("map", "clip-path=\"url(#map)\"");
}

void draw_map_cells(SvgWriter& svg, const Map& map, const Box& region) {
  for (const CellGrid& grid : map.grids) draw_cells(svg, grid, region);
}

void draw_map(SvgWriter& svg, const Map& map, const Box& region) {
  draw_map_cells(svg, map, region);
  for (const Ring& ring : map.obstacles) svg.polygon(ring, "obstacle");
  for (const Ring& ring : map.boundaries) svg.polygon(ring, "boundary");
  for (const Polyline& line : map.lines) svg.polyline(line, "wall");
  for (const Vec2 p : map.points) {
    if (region.contains(p)) svg.dot(p, 1.8, "point");
  }
}

void draw_station(SvgWriter& svg, const Station& station) {
  svg.polygon(station.area, "area");
  const Ring shelf = station.shelf.outline();
  svg.polygon(shelf, "shelf");
  if (station.insertion) {
    for (const auto& [right, left] : station.insertion->pockets)
      svg.polygon(transformed(rectangle({-station.shelf.depth, right}, {0.0, left}), station.shelf.face()), "pocket");
  }
  svg.line(shelf[1], shelf[2], "face");
}

void draw_map(SvgWriter& svg, const Scenario& scenario, const Box& region) {
  draw_map(svg, scenario.map, region);
  if (const auto* station = std::get_if<Station>(&scenario.mission)) draw_station(svg, *station);
}

void draw_axes(SvgWriter& svg, const Canvas& canvas) {
  const double step = 2.0 * round_length(60.0 / canvas.view.scale);
  const double bottom = canvas.height - bottom_gutter;
  svg.raw(fmt::format("<rect class=\"frame\" x=\"{}\" y=\"0.5\" width=\"{}\" height=\"{}\"/>\n",
                      fixed(left_gutter), fixed(canvas.width - left_gutter - 0.5), fixed(bottom - 0.5)));
  const auto first = [&](double low) { return std::ceil(low / step) * step; };
  for (double x = first(canvas.region.low.x); x <= canvas.region.high.x; x += step) {
    const double at = canvas.view({x, 0.0}).x;
    if (at < left_gutter + 8.0 || at > canvas.width - 12.0) continue;
    svg.raw(
        fmt::format("<line class=\"axis\" x1=\"{0}\" y1=\"{1}\" x2=\"{0}\" y2=\"{2}\"/><text class=\"small "
                    "middle\" x=\"{0}\" y=\"{3}\">{4}</text>\n",
                    fixed(at), fixed(bottom), fixed(bottom - 6), fixed(bottom + 15), fixed(x, 3)));
  }
  for (double y = first(canvas.region.low.y); y <= canvas.region.high.y; y += step) {
    const double at = canvas.view({0.0, y}).y;
    if (at < 8.0 || at > bottom - 4.0) continue;  // the number would be cut off, or stand on the other axis
    svg.raw(
        fmt::format("<line class=\"axis\" x1=\"{1}\" y1=\"{0}\" x2=\"{2}\" y2=\"{0}\"/><text class=\"small "
                    "end\" x=\"{3}\" y=\"{4}\">{5}</text>\n",
                    fixed(at), fixed(left_gutter), fixed(left_gutter + 6), fixed(left_gutter - 5),
                    fixed(at + 4), fixed(y, 3)));
  }
}

void draw_scale(SvgWriter& svg, const Canvas& canvas) {
  const double metres = round_length(0.2 * canvas.width / canvas.view.scale);
  const double pixels = metres * canvas.view.scale;
  const double y = canvas.height + 14.0;
  svg.raw(
      fmt::format("<line class=\"bar\" x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\"/><text class=\"small\" "
                  "x=\"{3}\" y=\"{4}\">{5} m; coordinates in m, x right, y up</text>\n",
                  fixed(left_gutter), fixed(y), fixed(left_gutter + pixels), fixed(left_gutter + pixels + 8),
                  fixed(y + 4), fixed(metres)));
}

OverlayStroke overlay_stroke(std::size_t i) {
  static constexpr std::array<const char*, 8> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a828a", "#b3a100"};
  OverlayStroke stroke{palette[i % palette.size()], {}};
  // Once the colours are used up: dashes, then dashes with one dot, with two …
  const std::size_t round = i / palette.size();
  if (round > 0) stroke.dashes = "12 5";
  for (std::size_t dot = 1; dot < round; ++dot) stroke.dashes += " 3 5";
  return stroke;
}

std::string stroke_attributes(const OverlayStroke& stroke) {
  return fmt::format("stroke=\"{}\"{}", stroke.colour, stroke.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes));
}

void draw_waypoints(SvgWriter& svg, const Scenario& scenario, Labels& labels) {
  for (std::size_t i = 0; i < scenario.waypoints.size(); ++i) {
    const Vec2 at = scenario.waypoints[i];
    if (scenario.waypoint_radius > 0.0) svg.polygon(outline_at({{}, scenario.waypoint_radius}, make_pose(at, 0.0)), "waypointring");
    svg.dot(at, 4.0, "waypoint");
    labels.add({{fmt::format("{}", i + 1), "name"}, LabelRank::end, {}, 0.0, at, {1.0, -1.0}, 8.0});
  }
}

}  // namespace waywright
