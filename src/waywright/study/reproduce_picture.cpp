#include <fmt/format.h>

#include <cmath>

#include "waywright/report/scene_parts.hpp"
#include "waywright/study/reproduce_safe_astar.hpp"

namespace waywright::reproduction {
namespace {

/// Without the points on straight parts.
std::vector<Vec2> bends_of(const std::vector<Vec2>& points) {
  std::vector<Vec2> bends;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && i + 1 < points.size() && std::abs(cross(points[i] - points[i - 1], points[i + 1] - points[i])) < 1e-9) continue;
    bends.push_back(points[i]);
  }
  return bends;
}

/// px; those below are wider, so that ways that are the same show at both sides.
double stroke_width(std::size_t method) { return 6.5 - 1.6 * static_cast<double>(method); }

}  // namespace

std::string svg(const std::vector<Experiment>& experiments, double width) {
  constexpr double gap = 16.0, title = 40.0, legend = 52.0;  // px
  constexpr std::size_t columns = 3;
  const double side = (width - gap * (columns + 1)) / columns;
  std::string body;
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const Experiment& e = experiments[i];
    const double x = gap + static_cast<double>(i % columns) * (side + gap), y = legend + static_cast<double>(i / columns) * (side + title + gap) + title;
    const double nodes = e.grid.columns;
    SvgWriter panel{{-0.5, e.grid.rows - 0.5, side / nodes}};
    panel.open_group("map", fmt::format("transform=\"translate({} {})\"", fixed(x), fixed(y)));
    panel.raw(fmt::format("<rect class=\"floor\" width=\"{0}\" height=\"{1}\" fill=\"none\" stroke=\"#888\"/>\n", fixed(side), fixed(side * e.grid.rows / nodes)));
    const Box region{{-1.0, -1.0}, {nodes, static_cast<double>(e.grid.rows)}};
    const auto cells = [&](const CellGrid& grid) {
      Map map;
      map.grids = {grid};
      draw_map_cells(panel, map, region);
    };
    const bool has_two = e.own_grid.blocked != e.grid.blocked;
    if (has_two) {
      panel.raw("<g opacity=\".35\">\n");
      cells(e.own_grid);
      panel.raw("</g>\n");
    }
    cells(e.grid);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      for (const std::vector<Vec2>& leg : e.ours[m].legs) panel.stroked_polyline(bends_of(leg), stroke_attributes(overlay_stroke(m)), stroke_width(m));
    }
    for (const Vec2 p : e.ours[own].boundary) panel.raw(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"2.4\" fill=\"none\" stroke=\"{}\"/>\n", fixed(panel.view()(p).x), fixed(panel.view()(p).y), overlay_stroke(own).colour));
    panel.label(e.legs.front().start, {6.0, 12.0}, "S", "small");
    if (e.legs.size() > 1) {
      const Vec2 at = panel.view()(e.legs.front().goal);
      panel.raw(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"2\"/>\n", fixed(at.x), fixed(at.y)));
    }
    panel.label(e.legs.back().goal, {-4.0, -6.0}, "G", "small");
    panel.close_group();
    body += panel.take();
    body += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{}</text>\n", fixed(x), fixed(y - 22.0), escaped(e.label));
    std::string lengths;
    for (std::size_t m = 0; m < methods.size(); ++m) lengths += fmt::format("{}{:.1f}", m == 0 ? "" : " · ", e.ours[m].figures[length]);
    body += fmt::format("<text class=\"small\" x=\"{}\" y=\"{}\">{} m</text>\n", fixed(x), fixed(y - 7.0), lengths);
  }
  double x = gap;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    body += fmt::format("<line x1=\"{0}\" y1=\"24\" x2=\"{1}\" y2=\"24\" {2} stroke-width=\"{5:g}\"/><text class=\"small\" x=\"{3}\" y=\"28\">{4}</text>\n", fixed(x), fixed(x + 34.0),
                        stroke_attributes(overlay_stroke(m)), fixed(x + 40.0), methods[m], stroke_width(m));
    x += 110.0;
  }
  body += fmt::format("<circle cx=\"{}\" cy=\"24\" r=\"3\" fill=\"none\" stroke=\"{}\"/><text class=\"small\" x=\"{}\" y=\"28\">boundary point of SHA*</text>\n", fixed(x + 6.0), overlay_stroke(own).colour, fixed(x + 16.0));
  x += 190.0;
  body += fmt::format("<circle cx=\"{}\" cy=\"24\" r=\"4\" fill=\"#fff\" stroke=\"#000\" stroke-width=\"2\"/><text class=\"small\" x=\"{}\" y=\"28\">goods; lengths are in the order of the methods</text>\n", fixed(x + 6.0), fixed(x + 16.0));
  const std::size_t rows = (experiments.size() + columns - 1) / columns;
  return framed(std::move(body), width, legend + static_cast<double>(rows) * (side + title + gap), "Experiments of the safe-A* publication");
}

}  // namespace waywright::reproduction
