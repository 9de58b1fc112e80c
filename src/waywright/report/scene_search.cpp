#include "waywright/report/scene_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "waywright/report/scene_zones.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_lines = 12'000;  // in one picture
constexpr int frames = 48;
constexpr double moving = 8.0, standing = 2.5;  // s, of what moves, and of the end

using Stroke = SearchPicture::Line;

std::string strokes(const SvgWriter& svg, const std::vector<Stroke>& lines) {
  std::string d;
  for (const Stroke& line : lines) {
    const auto add = [&](char how, Vec2 point) {
      const Vec2 p = svg.view()(point);
      d += fmt::format("{}{} {}", how, fixed(p.x, 1), fixed(p.y, 1));
    };
    add('M', line.from);
    for (const Vec2 point : line.bend) add('L', point);
    add('L', line.to);
  }
  return d;
}

/// Most happens in the first steps: time runs as the root of the step.
int frame_of(std::uint32_t step, std::uint32_t steps) {
  if (step == SearchPicture::never) return frames + 1;
  return static_cast<int>(std::lround(frames * std::sqrt(static_cast<double>(std::min(step, steps)) / std::max(1U, steps))));
}

/// A group that is to be seen from one frame to before another.
std::string shown(int born, int gone, const std::string& content) {
  constexpr double whole = moving + standing;
  const bool stays = gone > frames;
  const auto share = [](int frame) { return frame / static_cast<double>(frames) * moving / whole; };
  const double from = share(born), to = stays ? 1.0 : share(gone);
  std::string values = "hidden;visible", times = fmt::format("0;{:.4f}", from);
  if (born <= 0) values = "visible", times = "0";
  if (!stays) {
    values += ";hidden";
    times += fmt::format(";{:.4f}", to);
  }
  return fmt::format("<g visibility=\"{}\"><animate attributeName=\"visibility\" calcMode=\"discrete\" dur=\"{:g}s\" repeatCount=\"indefinite\" values=\"{}\" keyTimes=\"{}\"/>\n{}</g>\n",
                     stays ? "visible" : "hidden", whole, values, times, content);
}

std::string polyline(const SvgWriter& svg, const std::vector<Vec2>& points, const char* style) {
  SvgWriter one{svg.view()};
  one.polyline(points, style);
  return one.take();
}

}  // namespace

void draw_search(SvgWriter& svg, const SearchPicture& search) {
  std::vector<Stroke> left;
  for (const Stroke& line : search.lines) {
    if (line.gone == SearchPicture::never && left.size() < most_lines) left.push_back(line);
  }
  if (!left.empty()) svg.raw(fmt::format("<path class=\"searchline\" d=\"{}\"/>\n", strokes(svg, left)));
  if (search.swarms.empty()) return;
  for (const std::vector<Vec2>& agent : search.swarms.back().agents) svg.polyline(agent, "searchagent");
}

std::vector<LegendEntry> search_legend(const SearchPicture& search) {
  using Shape = LegendEntry::Shape;
  std::vector<LegendEntry> entries;
  const auto left = static_cast<std::size_t>(std::count_if(search.lines.begin(), search.lines.end(), [](const Stroke& line) { return line.gone == SearchPicture::never; }));
  if (left > 0) entries.push_back({"searchline", Shape::line, search.name + (left > most_lines ? fmt::format(", the first {} of {} lines", most_lines, left) : std::string{})});
  if (!search.swarms.empty()) entries.push_back({"searchagent", Shape::line, "agents where they ended"});
  return entries;
}

std::string search_svg(const Problem& problem, const Plan& plan, double width) {
  const SearchPicture& search = *plan.search;
  const Canvas canvas = canvas_for(problem, {&plan}, width);
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  draw_zone_areas(svg, problem.scenario().zones);
  draw_map(svg, problem.scenario(), canvas.region, false);
  std::map<std::pair<int, int>, std::vector<Stroke>> together;
  for (std::size_t i = 0; i < std::min(search.lines.size(), 2 * most_lines); ++i) {
    const int born = frame_of(search.lines[i].born, search.steps), gone = frame_of(search.lines[i].gone, search.steps);
    if (born < gone) together[{born, gone}].push_back(search.lines[i]);
  }
  for (const auto& [time, lines] : together) svg.raw(shown(time.first, time.second, fmt::format("<path class=\"searchline\" d=\"{}\"/>\n", strokes(svg, lines))));
  const auto in_turn = [&](const auto& items, const auto& content) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const int born = frame_of(items[i].born, search.steps), gone = i + 1 < items.size() ? frame_of(items[i + 1].born, search.steps) : frames + 1;
      if (born < gone) svg.raw(shown(born, gone, content(items[i])));
    }
  };
  in_turn(search.swarms, [&](const SearchPicture::Swarm& swarm) {
    std::string all;
    for (const std::vector<Vec2>& agent : swarm.agents) all += polyline(svg, agent, "searchagent");
    return all;
  });
  in_turn(search.ways, [&](const SearchPicture::Way& way) { return polyline(svg, way.points, "fwd"); });
  draw_vehicle(svg, problem.footprint(), problem.first_pose(), "S");
  draw_goal(svg, problem, plan, "G");
  svg.close_group();
  draw_axes(svg, canvas);
  draw_scale(svg, canvas);
  std::vector<LegendEntry> legend{{"searchline", LegendEntry::Shape::line, search.name}};
  if (!search.swarms.empty()) legend.push_back({"searchagent", LegendEntry::Shape::line, "agents of the whale optimisation algorithm"});
  if (!search.ways.empty()) legend.push_back({"fwd", LegendEntry::Shape::line, "best way so far"});
  legend.push_back({"", LegendEntry::Shape::none, fmt::format("the search in {:g} s, its beginning slower", moving)});
  const double whole = std::max(canvas.width, 480.0);
  const double end = draw_legend(svg, legend, whole, canvas.height + 40.0);
  return framed(svg.take(), whole, end + 14.0, problem.scenario().name + ": the search");
}

}  // namespace waywright
