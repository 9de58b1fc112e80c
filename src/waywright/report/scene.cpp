#include "waywright/report/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/geometry/polygon.hpp"

namespace waywright {
namespace {

constexpr double margin = 1.0;          // m around what is shown
constexpr double sweep_step = 0.03;     // m between the footprints of the swept area
constexpr double ghost_step = 0.75;     // m between drawn outlines
constexpr std::size_t most_runs = 40000;  // of cells
constexpr double legend_height = 78.0;  // px

constexpr std::array<const char*, 8> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a828a", "#b3a100"};

Ring outline_at(const Footprint& footprint, const Pose& pose) {
  if (!footprint.is_disc()) return transformed(footprint.polygon, Frame{pose});
  Ring ring;
  for (int i = 0; i < 36; ++i) ring.push_back(pose.position() + footprint.disc * unit(two_pi * i / 36.0));
  return ring;
}

/// What must be seen: start, goal, station, path; the map is cropped to it.
Box region_of(const Problem& problem, const std::vector<const Plan*>& plans) {
  const Scenario& scenario = problem.scenario();
  std::vector<Vec2> points;
  const auto add = [&](const Ring& ring) { points.insert(points.end(), ring.begin(), ring.end()); };
  add(outline_at(problem.footprint(), problem.first_pose()));
  add(outline_at(problem.footprint(), problem.last_pose()));
  if (const auto* station = std::get_if<Station>(&scenario.mission)) {
    add(station->area);
    add(station->shelf.outline());
  }
  for (const Plan* plan : plans) {
    for (std::size_t i = 0; i < plan->samples.size(); i += 10) add(outline_at(problem.footprint(), plan->samples[i].pose()));
  }
  Box box = bounding_box(points);
  // A map that is not much larger is shown whole.
  if (!scenario.map.boundaries.empty()) {
    const Box whole = bounding_box(scenario.map.boundaries.front());
    if (norm(whole.high - whole.low) < 3.0 * norm(box.high - box.low)) {
      points = {box.low, box.high, whole.low, whole.high};
      box = bounding_box(points);
    }
  }
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

void draw_cells(SvgWriter& svg, const CellGrid& grid, const Box& region) {
  // Rows and columns that the region can touch, in the grid's frame.
  const Frame frame{grid.origin};
  std::vector<Vec2> local;
  for (const Vec2 p : rectangle(region.low, region.high)) local.push_back(frame.to_local(p));
  const Box box = bounding_box(local);
  const auto clamped = [](double v, int most) { return static_cast<int>(std::clamp(std::floor(v), 0.0, static_cast<double>(most))); };
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
        runs.push_back({grid.corner(first, r + 1), grid.corner(c, r + 1), grid.corner(c, r), grid.corner(first, r)});
      }
    }
    svg.union_of(runs, kind == 1 ? "cell" : "unknown");
  }
}

void draw_map(SvgWriter& svg, const Scenario& scenario, const Box& region) {
  for (const CellGrid& grid : scenario.map.grids) draw_cells(svg, grid, region);
  for (const Ring& ring : scenario.map.obstacles) svg.polygon(ring, "obstacle");
  for (const Ring& ring : scenario.map.boundaries) svg.polygon(ring, "boundary");
  for (const Polyline& line : scenario.map.lines) svg.polyline(line, "wall");
  for (const Vec2 p : scenario.map.points) {
    if (region.contains(p)) svg.dot(p, 1.8, "point");
  }
  if (const auto* station = std::get_if<Station>(&scenario.mission)) {
    svg.polygon(station->area, "area");
    const Ring shelf = station->shelf.outline();
    svg.polygon(shelf, "shelf");
    if (station->insertion) {
      for (const auto& [right, left] : station->insertion->pockets) {
        svg.polygon(transformed(rectangle({-station->shelf.depth, right}, {0.0, left}), station->shelf.face()), "pocket");
      }
    }
    svg.line(shelf[1], shelf[2], "face");
  }
}

void draw_vehicle(SvgWriter& svg, const Footprint& footprint, const Pose& pose, const char* name) {
  svg.polygon(outline_at(footprint, pose), "vehicle");
  const Frame frame{pose};
  const double front = footprint.front();
  const Vec2 tip = frame.to_world(Vec2{front, 0.0});
  svg.line(pose.position(), tip, "heading");
  const double head = std::min(0.25, 0.3 * std::max(front, 0.2));
  svg.polyline({frame.to_world(Vec2{front - head, 0.6 * head}), tip, frame.to_world(Vec2{front - head, -0.6 * head})}, "heading");
  svg.label(pose.position(), {6.0, -6.0}, name, "name");
}

/// Runs of equal direction as polylines.
void draw_path(SvgWriter& svg, const std::vector<Sample>& samples) {
  for (std::size_t i = 0; i < samples.size();) {
    std::size_t end = i;
    std::vector<Vec2> points;
    while (end < samples.size() && samples[end].direction == samples[i].direction) points.push_back(samples[end++].pose().position());
    svg.polyline(points, samples[i].direction > 0 ? "fwd" : samples[i].direction < 0 ? "back" : "turn");
    i = end;
  }
  double next = 0.6;
  for (const Sample& s : samples) {  // arrow heads in the direction of travel
    if (s.s < next || s.direction == 0) continue;
    next = s.s + 1.5;
    const Frame frame{make_pose({s.x, s.y}, s.course)};
    const double a = 7.0 / svg.view().scale;
    svg.polygon({frame.to_world(Vec2{a, 0.0}), frame.to_world(Vec2{-a, 0.75 * a}), frame.to_world(Vec2{-a, -0.75 * a})},
                s.direction > 0 ? "fwdmark" : "backmark");
  }
}

void draw_sweep(SvgWriter& svg, const Footprint& footprint, const std::vector<Sample>& samples) {
  std::vector<Ring> rings;
  std::vector<Ring> ghosts;
  double next = 0.0;
  double next_ghost = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (s.s < next && i + 1 < samples.size() && s.direction != 0) continue;
    next = s.s + sweep_step;
    rings.push_back(outline_at(footprint, s.pose()));
    if (s.s >= next_ghost) {
      next_ghost = s.s + ghost_step;
      ghosts.push_back(rings.back());
    }
  }
  svg.union_of(rings, "sweep");
  for (const Ring& ghost : ghosts) svg.polygon(ghost, "ghost");
}

double round_length(double metres) {
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  for (const double k : {5.0, 2.0, 1.0}) {
    if (k * power <= metres) return k * power;
  }
  return power;
}

void draw_scale(SvgWriter& svg, double width, double height) {
  const double metres = round_length(0.2 * width / svg.view().scale);
  const double pixels = metres * svg.view().scale;
  const double y = height + 20.0;
  svg.raw(fmt::format("<line class=\"bar\" x1=\"12\" y1=\"{0}\" x2=\"{1}\" y2=\"{0}\"/><text class=\"small\" x=\"{2}\" y=\"{3}\">{4} m</text>\n",
                      fixed(y), fixed(12 + pixels), fixed(18 + pixels), fixed(y + 4), fixed(metres)));
  svg.raw(fmt::format("<g class=\"heading\"><path d=\"M{0} {1}h24m-5 -3l5 3l-5 3M{0} {1}v-24m-3 5l3 -5l3 5\" fill=\"none\"/></g>"
                      "<text class=\"small\" x=\"{2}\" y=\"{3}\">x</text><text class=\"small\" x=\"{4}\" y=\"{5}\">y</text>\n",
                      fixed(width - 50), fixed(height + 34), fixed(width - 22), fixed(height + 38), fixed(width - 62), fixed(height + 14)));
}

struct LegendEntry {
  const char* style;
  const char* shape;  // "line" or "box"
  const char* text;
};

void draw_legend(SvgWriter& svg, const std::vector<LegendEntry>& entries, double width, double height) {
  double x = 12.0;
  double y = height + 46.0;
  for (const LegendEntry& e : entries) {
    const double needed = 36.0 + 6.6 * static_cast<double>(std::string_view{e.text}.size());
    if (x + needed > width - 12.0) {
      x = 12.0;
      y += 20.0;
    }
    if (std::string_view{e.shape} == "line") {
      svg.raw(fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>", e.style, fixed(x), fixed(y - 4), fixed(x + 22), fixed(y - 4)));
    } else {
      svg.raw(fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"22\" height=\"11\"/>", e.style, fixed(x), fixed(y - 10)));
    }
    svg.raw(fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", fixed(x + 28), fixed(y), e.text));
    x += needed;
  }
}

std::string framed(std::string body, double width, double height, std::string_view title) {
  return fmt::format("<svg class=\"ww\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\">\n"
                     "<title>{2}</title>\n<style>{3}</style>\n<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{4}</svg>\n",
                     fixed(width), fixed(height), escaped(title), picture_styles(), body);
}

struct Canvas {
  View view;
  Box region;
  double width, height;  // px of the map itself
};

Canvas canvas_for(const Box& region, double width) {
  const double w = region.high.x - region.low.x;
  const double h = region.high.y - region.low.y;
  const double scale = std::min(width / w, 1.1 * width / h);
  return {{region.low.x, region.high.y, scale}, region, std::max(w * scale, 480.0), h * scale};
}

void open_map(SvgWriter& svg, const Canvas& canvas) {
  svg.raw(fmt::format("<defs><clipPath id=\"map\"><rect width=\"{}\" height=\"{}\"/></clipPath></defs>\n", fixed(canvas.width), fixed(canvas.height)));
  svg.open_group("map", "clip-path=\"url(#map)\"");
}

}  // namespace

std::string scene_svg(const Problem& problem, const Plan& plan, double width) {
  const Scenario& scenario = problem.scenario();
  const Footprint& footprint = problem.footprint();
  const Canvas canvas = canvas_for(region_of(problem, {&plan}), width);
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  bool zones = false;
  bool others = false;
  for (const Alternative& a : plan.alternatives) {
    if (a.zone.size() < 3) continue;
    svg.polygon(a.zone, "zone");
    zones = true;
  }
  draw_map(svg, scenario, canvas.region);
  draw_sweep(svg, footprint, plan.samples);
  for (const Alternative& a : plan.alternatives) {
    if (a.chosen || a.poses.size() < 2) continue;
    others = true;
    std::vector<Vec2> points;
    for (const Pose& p : a.poses) points.push_back(p.position());
    svg.polyline(points, "alt");
    svg.label(points[points.size() / 2], {8.0, 0.0}, a.cost ? fmt::format("{}: {:.3f}", a.name, *a.cost) : a.name + ": not possible", "note");
  }
  draw_path(svg, plan.samples);
  for (std::size_t i = 1; i < plan.samples.size(); ++i) {
    if (is_direction_change(plan.samples[i - 1], plan.samples[i])) draw_vehicle(svg, footprint, plan.samples[i].pose(), "T");
  }
  draw_vehicle(svg, footprint, problem.first_pose(), "S");
  draw_vehicle(svg, footprint, problem.last_pose(), problem.is_driven_back() ? "E" : "D");
  const Certificate& c = plan.certificate;
  const bool tight = !plan.samples.empty() && c.tightest && !c.tightest_obstacle.empty();
  if (tight) {
    // From the obstacle's point to the footprint's nearest point.
    Vec2 on = c.tightest->position();
    if (footprint.is_disc()) {
      const Vec2 d = c.tightest_point - on;
      if (norm(d) > 0.0) on = on + (footprint.disc / norm(d)) * d;
    } else {
      on = nearest_in(outline_at(footprint, *c.tightest), c.tightest_point);
    }
    svg.polygon(outline_at(footprint, *c.tightest), "ghost");
    svg.line(on, c.tightest_point, "tight");
    svg.dot(c.tightest_point, 3.5, "tightdot");
    // Beyond the obstacle's point, away from the vehicle and its name.
    const Vec2 away = c.tightest_point - on;
    const double length = norm(away);
    const Vec2 direction = length > 0.0 ? Vec2{away.x / length, -away.y / length} : Vec2{0.0, 1.0};
    const Vec2 offset{12.0 * direction.x - (direction.x < -0.3 ? 52.0 : direction.x < 0.3 ? 24.0 : 0.0), 14.0 * direction.y + 5.0};
    svg.label(c.tightest_point, offset, fmt::format("{:.0f} mm", 1000.0 * length), "tighttext name");
  }
  svg.close_group();
  draw_scale(svg, canvas.width, canvas.height);
  std::vector<LegendEntry> legend;
  if (!plan.samples.empty()) {
    legend.push_back({"back", "line", "backwards (chassis first)"});
    legend.push_back({"fwd", "line", "forwards (forks first)"});
    legend.push_back({"sweep", "box", "swept by the footprint"});
  }
  if (std::holds_alternative<Station>(scenario.mission)) {
    legend.push_back({"shelf", "box", "shelf, loading face bold"});
    if (std::get<Station>(scenario.mission).insertion) legend.push_back({"pocket", "box", "pocket"});
    legend.push_back({"area", "line", "station"});
  }
  if (zones) legend.push_back({"zone", "box", "candidate sides"});
  if (others) legend.push_back({"alt", "line", "best on the other side"});
  if (tight) legend.push_back({"tight", "line", "tightest spot"});
  draw_legend(svg, legend, canvas.width, canvas.height);
  return framed(svg.take(), canvas.width, canvas.height + legend_height, scenario.name);
}

std::string overlay_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans, double width) {
  std::vector<const Plan*> all;
  for (const auto& [name, plan] : plans) all.push_back(plan);
  const Scenario& scenario = problem.scenario();
  const Canvas canvas = canvas_for(region_of(problem, all), width);
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  draw_map(svg, scenario, canvas.region);
  std::string legend;
  double y = canvas.height + 46.0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const auto& [name, plan] = plans[i];
    const char* colour = palette[i % palette.size()];
    if (!plan->samples.empty()) {
      std::vector<Vec2> points;
      for (const Sample& s : plan->samples) points.push_back({s.x, s.y});
      svg.coloured_polyline(points, colour);
    }
    legend += fmt::format("<line x1=\"12\" y1=\"{0}\" x2=\"40\" y2=\"{0}\" stroke=\"{1}\" stroke-width=\"3\"/><text class=\"small\" x=\"48\" y=\"{2}\">{3} ({4})</text>\n",
                          fixed(y - 4), colour, fixed(y), escaped(name), to_string(plan->status));
    y += 18.0;
  }
  draw_vehicle(svg, problem.footprint(), problem.first_pose(), "S");
  draw_vehicle(svg, problem.footprint(), problem.last_pose(), problem.is_driven_back() ? "E" : "D");
  svg.close_group();
  draw_scale(svg, canvas.width, canvas.height);
  svg.raw(legend);
  return framed(svg.take(), canvas.width, y + 6.0, scenario.name);
}

}  // namespace waywright
