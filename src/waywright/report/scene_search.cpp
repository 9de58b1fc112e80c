#include "waywright/report/scene_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "waywright/report/scene_zones.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_lines = 12'000;  // in one picture
constexpr std::size_t most_dots = 1200;     // of agents, in a still picture
constexpr int frames = 48;
constexpr int lasting = 4;  // frames, that places are seen
constexpr double moving = 8.0, standing = 2.5;  // s, of what moves, and of the end

using Stroke = SearchPicture::Line;

/// Those that may be seen; of too many evenly fewer, with how many there are.
struct Seen {
  std::vector<Stroke> lines;
  std::size_t all = 0;
};
Seen seen_of(const std::vector<Stroke>& lines, const Box& region, bool at_the_end, std::size_t most) {
  Seen seen;
  for (const Stroke& line : lines) {
    if (at_the_end && line.gone != SearchPicture::never) continue;
    const bool beside = std::max(line.from.x, line.to.x) < region.low.x || std::min(line.from.x, line.to.x) > region.high.x || std::max(line.from.y, line.to.y) < region.low.y ||
                        std::min(line.from.y, line.to.y) > region.high.y;
    if (!beside) seen.lines.push_back(line);
  }
  seen.all = seen.lines.size();
  if (seen.all > most) {
    for (std::size_t i = 0; i < most; ++i) seen.lines[i] = seen.lines[i * seen.all / most];
    seen.lines.resize(most);
  }
  return seen;
}

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

using Swarm = SearchPicture::Swarm;

bool holds_places(const Swarm& swarm) { return !swarm.agents.empty() && swarm.agents.front().size() == 1; }

/// Places, and the corners of ways, as dots: strokes without length and with round ends.
std::string dots_of(const SvgWriter& svg, const Swarm& swarm) {
  std::string dots;
  for (const std::vector<Vec2>& agent : swarm.agents) {
    const std::size_t ends = agent.size() == 1 ? 0 : 1;
    for (std::size_t i = ends; i + ends < agent.size(); ++i) {
      const Vec2 at = svg.view()(agent[i]);
      dots += fmt::format("M{} {}h0", fixed(at.x, 1), fixed(at.y, 1));
    }
  }
  return dots;
}
std::string places(const std::string& dots) { return dots.empty() ? std::string{} : fmt::format("<path class=\"searchplace\" d=\"{}\"/>\n", dots); }

/// Of a still picture: swarms spread over the search, so many that their dots can be told apart.
std::size_t each_drawn(const SearchPicture& search) {
  std::size_t dots = 0;
  for (const Swarm& swarm : search.swarms) {
    for (const std::vector<Vec2>& agent : swarm.agents) dots += agent.size() == 1 ? 1 : agent.size() - std::min<std::size_t>(2, agent.size());
  }
  return std::max<std::size_t>(1, (dots + most_dots - 1) / most_dots);
}

LegendEntry swarm_entry(const SearchPicture& search, std::size_t drawn) {
  const char* const what = holds_places(search.swarms.front()) ? "where the whale optimisation algorithm's agents ended" : "corners of the whale optimisation algorithm's agents";
  const char* const when = holds_places(search.swarms.front()) ? "of the tree's extensions" : "of its iterations";
  return {"searchplace", LegendEntry::Shape::line, fmt::format("{} in {} {}", what, drawn, when)};
}

}  // namespace

void draw_search(SvgWriter& svg, const SearchPicture& search, const Box& region) {
  const std::vector<Stroke> left = seen_of(search.lines, region, true, most_lines).lines;
  if (!left.empty()) svg.raw(fmt::format("<path class=\"searchline\" d=\"{}\"/>\n", strokes(svg, left)));
  if (search.swarms.empty()) return;
  const std::size_t each = each_drawn(search);
  std::string dots;
  for (std::size_t i = 0; i < search.swarms.size(); i += each) dots += dots_of(svg, search.swarms[i]);
  svg.raw(places(dots));
}

std::vector<LegendEntry> search_legend(const SearchPicture& search, const Box& region) {
  using Shape = LegendEntry::Shape;
  std::vector<LegendEntry> entries;
  const std::size_t left = seen_of(search.lines, region, true, most_lines).all;
  if (left > 0) entries.push_back({"searchline", Shape::line, search.name + (left > most_lines ? fmt::format(", {} of {} lines", most_lines, left) : std::string{})});
  if (!search.swarms.empty()) entries.push_back(swarm_entry(search, (search.swarms.size() + each_drawn(search) - 1) / each_drawn(search)));
  return entries;
}

std::string search_svg(const Problem& problem, const Plan& plan, double width) {
  const SearchPicture& search = *plan.search;
  const Canvas canvas = canvas_for(problem, {&plan}, width);
  SvgWriter svg{canvas.view};
  open_map(svg, canvas);
  draw_zone_areas(svg, problem.scenario().zones);
  draw_map(svg, problem.scenario(), canvas.region);
  std::map<std::pair<int, int>, std::vector<Stroke>> together;
  for (const Stroke& line : seen_of(search.lines, canvas.region, false, 2 * most_lines).lines) {
    const int born = frame_of(line.born, search.steps), gone = frame_of(line.gone, search.steps);
    if (born < gone) together[{born, gone}].push_back(line);
  }
  for (const auto& [time, lines] : together) svg.raw(shown(time.first, time.second, fmt::format("<path class=\"searchline\" d=\"{}\"/>\n", strokes(svg, lines))));
  const auto in_turn = [&](const auto& items, const auto& content) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const int born = frame_of(items[i].born, search.steps), gone = i + 1 < items.size() ? frame_of(items[i + 1].born, search.steps) : frames + 1;
      if (born < gone) svg.raw(shown(born, gone, content(items[i])));
    }
  };
  in_turn(search.ways, [&](const SearchPicture::Way& way) { return polyline(svg, way.points, "fwd"); });
  // Swarms that come in the same frame are seen together.
  for (std::size_t first = 0; first < search.swarms.size();) {
    const int born = frame_of(search.swarms[first].born, search.steps);
    std::size_t next = first + 1;
    while (next < search.swarms.size() && frame_of(search.swarms[next].born, search.steps) == born) ++next;
    const int gone = next < search.swarms.size() ? frame_of(search.swarms[next].born, search.steps) : frames + 1;
    // Places are spread over the search, ways all in one place.
    std::string all, dots;
    for (std::size_t i = holds_places(search.swarms[first]) ? first : next - 1; i < next; ++i) {
      for (const std::vector<Vec2>& agent : search.swarms[i].agents) {
        if (agent.size() > 1) all += polyline(svg, agent, "searchagent");
      }
      dots += dots_of(svg, search.swarms[i]);
    }
    svg.raw(shown(born, holds_places(search.swarms[first]) ? born + lasting : gone, all + places(dots)));
    first = next;
  }
  Labels labels = labels_for(canvas);
  draw_vehicle(svg, problem.footprint(), problem.first_pose());
  name_end(labels, problem.first_pose().position(), "S");
  name_end(labels, draw_goal(svg, problem, plan), "G");
  labels.write(svg);
  svg.close_group();
  draw_axes(svg, canvas);
  draw_scale(svg, canvas);
  std::vector<LegendEntry> legend{{"searchline", LegendEntry::Shape::line, search.name}};
  if (!search.swarms.empty()) legend.push_back(swarm_entry(search, search.swarms.size()));
  if (!search.ways.empty()) legend.push_back({"fwd", LegendEntry::Shape::line, "best way so far"});
  legend.push_back({"", LegendEntry::Shape::none, fmt::format("the search in {:g} s, its beginning slower", moving)});
  const double whole = std::max(canvas.width, 480.0);
  const double end = draw_legend(svg, legend, whole, canvas.height + 40.0);
  return framed(svg.take(), whole, end + 14.0, problem.scenario().name + ": the search");
}

}  // namespace waywright
