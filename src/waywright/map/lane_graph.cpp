#include "waywright/map/lane_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

namespace waywright {
namespace {

constexpr double usual_share = 1.0 / 40.0, least_usual = 0.01, most_usual_cells = 4e6;  // of a corridor's width; m
constexpr double most_cells = 67'108'864.0;
constexpr int longest_side = 16384;         // cells
constexpr double most_work = 4e9;           // cells looked at
constexpr std::size_t most_named = 12;      // in a sentence
constexpr double half_diagonal = 0.7071067811865476;  // of a cell

double length_of(const Polyline& course) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) sum += distance(course[i], course[i + 1]);
  return sum;
}

std::string named(const LaneGraph& graph, const std::vector<std::size_t>& places) {
  std::string text;
  for (std::size_t i = 0; i < std::min(places.size(), most_named); ++i) text += (i == 0 ? "" : ", ") + graph.places[places[i]].name;
  if (places.size() > most_named) text += fmt::format(" and {} more", places.size() - most_named);
  return text;
}

/// What of a row of cells lies in the strip: between the least and the greatest x of it, so that few cells are looked at in vain.
std::optional<std::pair<double, double>> span_at(Vec2 a, Vec2 b, double radius, double y) {
  if (a.y > b.y) std::swap(a, b);
  if (y < a.y - radius || y > b.y + radius) return std::nullopt;
  const double rise = b.y - a.y;
  const auto at = [&](double height) { return rise > 0.0 ? a.x + std::clamp((height - a.y) / rise, 0.0, 1.0) * (b.x - a.x) : a.x; };
  const double first = rise > 0.0 ? at(y - radius) : a.x, last = rise > 0.0 ? at(y + radius) : b.x;
  return std::pair{std::min(first, last) - radius, std::max(first, last) + radius};
}

double squared_distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double whole = squared_norm(along);
  const double t = whole > 0.0 ? std::clamp(dot(p - a, along) / whole, 0.0, 1.0) : 0.0;
  return squared_norm(p - (a + t * along));
}

}  // namespace

double length(const Lane& lane) { return length_of(lane.course); }

double first_heading(const Lane& lane) {
  for (std::size_t i = 1; i < lane.course.size(); ++i) {
    if (const Vec2 way = lane.course[i] - lane.course.front(); squared_norm(way) > 0.0) return angle_of(way);
  }
  return 0.0;
}

double last_heading(const Lane& lane) {
  for (std::size_t i = lane.course.size(); i-- > 1;) {
    if (const Vec2 way = lane.course.back() - lane.course[i - 1]; squared_norm(way) > 0.0) return angle_of(way);
  }
  return 0.0;
}

std::optional<std::size_t> place_named(const LaneGraph& graph, const std::string& name) {
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    if (graph.places[i].name == name) return i;
  }
  for (const LaneStation& station : graph.stations) {
    if (station.name == name && !station.places.empty()) return station.places.front();
  }
  return std::nullopt;
}

std::optional<LaneRoute> shortest_route(const LaneGraph& graph, std::size_t from, std::size_t to) {
  const std::size_t n = graph.places.size();
  struct Way {
    std::size_t lane, next;
    bool is_backwards;
  };
  std::vector<std::vector<Way>> ways(n);
  for (std::size_t i = 0; i < graph.lanes.size(); ++i) {
    const Lane& lane = graph.lanes[i];
    ways[lane.from].push_back({i, lane.to, false});
    if (lane.is_both_ways) ways[lane.to].push_back({i, lane.from, true});
  }
  struct Arrival {
    LaneRoute::Step step;
    std::size_t before = 0;
  };
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<Arrival> arrivals(n);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[from] = 0.0;
  open.push({0.0, from});
  while (!open.empty()) {
    const auto [so_far, place] = open.top();
    open.pop();
    if (so_far > cost[place]) continue;
    if (place == to) break;
    for (const Way& way : ways[place]) {
      const double sum = so_far + length(graph.lanes[way.lane]);
      if (sum >= cost[way.next]) continue;
      cost[way.next] = sum;
      arrivals[way.next] = {{way.lane, way.is_backwards}, place};
      open.push({sum, way.next});
    }
  }
  if (!std::isfinite(cost[to])) return std::nullopt;
  LaneRoute route;
  route.length = cost[to];
  for (std::size_t place = to; place != from; place = arrivals[place].before) {
    route.places.push_back(place);
    route.steps.push_back(arrivals[place].step);
  }
  route.places.push_back(from);
  std::reverse(route.places.begin(), route.places.end());
  std::reverse(route.steps.begin(), route.steps.end());
  return route;
}

std::vector<std::string> describe(const LaneGraph& graph) {
  if (graph.empty()) return {};
  std::vector<std::size_t> leaving(graph.places.size(), 0), arriving(graph.places.size(), 0);
  std::size_t both = 0;
  double metres = 0.0;
  for (const Lane& lane : graph.lanes) {
    metres += length(lane);
    both += lane.is_both_ways ? 1 : 0;
    ++leaving[lane.from];
    ++arriving[lane.to];
    if (!lane.is_both_ways) continue;
    ++leaving[lane.to];
    ++arriving[lane.from];
  }
  std::vector<std::size_t> ends, begins;
  for (std::size_t i = 0; i < graph.places.size(); ++i) {
    if (leaving[i] == 0 && arriving[i] > 0) ends.push_back(i);
    if (arriving[i] == 0 && leaving[i] > 0) begins.push_back(i);
  }
  std::vector<std::string> said{fmt::format("{} place{}, {} lane{} of {:.1f} m in all, {} of them one way", graph.places.size(), graph.places.size() == 1 ? "" : "s", graph.lanes.size(),
                                            graph.lanes.size() == 1 ? "" : "s", metres, graph.lanes.size() - both)};
  if (!graph.stations.empty()) said.push_back(fmt::format("{} station{} beside them", graph.stations.size(), graph.stations.size() == 1 ? "" : "s"));
  if (!graph.vehicles.empty()) {
    std::string text;
    for (std::size_t i = 0; i < std::min(graph.vehicles.size(), most_named); ++i) {
      const LaneVehicle& v = graph.vehicles[i];
      text += fmt::format("{}{} ({:g} x {:g} m{})", i == 0 ? "" : ", ", v.name, v.length, v.width, v.speed ? fmt::format(", {:g} m/s", *v.speed) : "");
    }
    said.push_back("vehicles: " + text + (graph.vehicles.size() > most_named ? fmt::format(" and {} more", graph.vehicles.size() - most_named) : ""));
  }
  if (!ends.empty()) said.push_back("no lane leads on from " + named(graph, ends));
  if (!begins.empty()) said.push_back("no lane leads to " + named(graph, begins));
  return said;
}

Box bounding_box(const LaneGraph& graph) {
  Box box{graph.places.front().at, graph.places.front().at};
  const auto add = [&](Vec2 p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  };
  for (const LanePlace& place : graph.places) add(place.at);
  for (const Lane& lane : graph.lanes) {
    for (const Vec2 p : lane.course) add(p);
  }
  return box;
}

double corridor_cell(const LaneGraph& graph, double width) {
  const Box box = bounding_box(graph);
  double cell = std::max(least_usual, usual_share * width);
  const double x = box.high.x - box.low.x + width, y = box.high.y - box.low.y + width;
  while ((x / cell) * (y / cell) > most_usual_cells || std::max(x, y) / cell > longest_side - 4) cell *= 2.0;
  return cell;
}

Parsed<CellGrid> lane_corridors(const LaneGraph& graph, double width, double cell) {
  const auto refuse = [](std::string problem, std::string allowed) { return tl::unexpected{InputError{"", "", std::move(problem), std::move(allowed)}}; };
  if (graph.lanes.empty()) return refuse("there are no lanes to drive along", "a file with lanes");
  if (!(width >= 4.0 * cell)) return refuse(fmt::format("it is {:g} m, less than four cells of {:g} m", width, cell), fmt::format("{:g} m or more, or smaller cells", 4.0 * cell));
  Box box = bounding_box(graph);
  const double radius = 0.5 * width;
  box.low = box.low - Vec2{radius + cell, radius + cell};
  box.high = box.high + Vec2{radius + cell, radius + cell};
  const double columns = std::ceil((box.high.x - box.low.x) / cell), rows = std::ceil((box.high.y - box.low.y) / cell);
  if (!(std::max(columns, rows) <= longest_side) || !(columns * rows <= most_cells)) {
    return refuse(fmt::format("it would have {:.0f} x {:.0f} cells of {:g} m", columns, rows, cell), fmt::format("at most {} a side and {:.0f} in all: larger cells", longest_side, most_cells));
  }
  CellGrid grid;
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  grid.cell = cell;
  grid.origin = {box.low.x, box.low.y, 0.0};
  grid.blocked.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 1);
  const double keeps = radius - half_diagonal * cell;  // of a cell's middle, so that all of it lies in the strip
  double work = 0.0;
  for (const Lane& lane : graph.lanes) {
    for (std::size_t i = 0; i + 1 < lane.course.size(); ++i) {
      const Vec2 a = lane.course[i] - box.low, b = lane.course[i + 1] - box.low;
      const int lowest = std::max(0, static_cast<int>((std::min(a.y, b.y) - keeps) / cell) - 1);
      const int highest = std::min(grid.rows - 1, static_cast<int>((std::max(a.y, b.y) + keeps) / cell) + 1);
      for (int up = lowest; up <= highest; ++up) {
        const double y = (up + 0.5) * cell;
        const auto span = span_at(a, b, keeps, y);
        if (!span) continue;
        const int left = std::max(0, static_cast<int>(span->first / cell) - 1), right = std::min(grid.columns - 1, static_cast<int>(span->second / cell) + 1);
        work += right - left + 1;
        if (work > most_work) return refuse("there are too many lanes for cells so small", "larger cells");
        auto* row = grid.blocked.data() + static_cast<std::size_t>(grid.rows - 1 - up) * static_cast<std::size_t>(grid.columns);
        for (int c = left; c <= right; ++c) {
          if (squared_distance({(c + 0.5) * cell, y}, a, b) <= keeps * keeps) row[c] = 0;
        }
      }
    }
  }
  return grid;
}

void append(LaneGraph& graph, LaneGraph more) {
  const std::size_t first = graph.places.size();
  for (Lane& lane : more.lanes) {
    lane.from += first;
    lane.to += first;
  }
  for (LaneStation& station : more.stations) {
    for (std::size_t& place : station.places) place += first;
  }
  const auto move_all = [](auto& to, auto& from) { to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end())); };
  move_all(graph.places, more.places);
  move_all(graph.lanes, more.lanes);
  move_all(graph.stations, more.stations);
  move_all(graph.vehicles, more.vehicles);
}

void transform(LaneGraph& graph, const Pose& pose) {
  const Frame frame{pose};
  for (LanePlace& place : graph.places) {
    place.at = frame.to_world(place.at);
    if (place.heading) place.heading = wrap(*place.heading + pose.heading);
  }
  for (Lane& lane : graph.lanes) {
    for (Vec2& p : lane.course) p = frame.to_world(p);
  }
  for (LaneStation& station : graph.stations) station.at = frame.to_world(station.at);
}

}  // namespace waywright
