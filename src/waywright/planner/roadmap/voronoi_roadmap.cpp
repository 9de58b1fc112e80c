#include "waywright/planner/roadmap/voronoi_roadmap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace waywright {
namespace {

constexpr double longest_line = 0.25;      // m, along the diagram
constexpr double lines_across = 2000.0;    // of a wide map they are longer
constexpr std::size_t most_joins = 8;      // lines from an end to the diagram that are free
constexpr int most_tried = 64;             // of an end
constexpr int region_places = 16;          // across a goal region, that are looked at where the diagram does not lead into it
constexpr double away_precision = 1e-6;    // m
constexpr int clock_every = 64;            // expansions

bool is_bounded(const World& world) {
  for (const CellGrid& grid : world.map().grids) {
    if (grid.bounds) return true;
  }
  return std::any_of(world.index().segments().begin(), world.index().segments().end(), [&](const Segment& s) { return world.is_boundary(s.source); });
}

}  // namespace

VoronoiRoadmap::VoronoiRoadmap(const PlaneSpace& space) : space_{space} {
  const World& world = space.problem().world();
  std::vector<Segment> segments = world.index().segments();
  if (segments.size() > most_segments) {
    refusal_ = fmt::format("the map has {} edges, and a Voronoi diagram is made of at most {}", segments.size(), most_segments);
    return;
  }
  const Box& region = space.region();
  if (!is_bounded(world)) {
    has_frame_ = true;
    const Ring frame = rectangle(region.low, region.high);
    for (std::size_t i = 0; i < frame.size(); ++i) segments.push_back({frame[i], frame[(i + 1) % frame.size()], 0});
  }
  for (Segment& s : segments) s.end_begins_another = false;
  diagram_ = VoronoiDiagram::of(segments);
  sites_ = ObstacleIndex{std::move(segments)};
  if (!diagram_) {
    refusal_ = fmt::format("the map's edges cross each other so often within {:.0e} m that no Voronoi diagram is made of them", VoronoiDiagram::least_unit);
    return;
  }
  const Vec2 size = region.high - region.low;
  spacing_ = std::max(longest_line, std::max(size.x, size.y) / lines_across);
  lay_out();
}

double VoronoiRoadmap::clearance(Vec2 at) const {
  const std::array<Vec2, 1> point{at};
  return sites_.distance(point, std::numeric_limits<double>::infinity());
}

/// Places along all edges, and links between them where the disc fits.
void VoronoiRoadmap::lay_out() {
  const double needed = space_.needed() + 2.0 * diagram_->error();
  std::vector<std::pair<std::uint32_t, Link>> links;
  const std::vector<VoronoiEdge>& edges = diagram_->edges();
  std::vector<std::uint32_t> place_of_vertex(diagram_->vertices().size(), none);
  const auto add = [&](const VoronoiPlace& place, std::uint32_t edge) {
    places_.push_back(place);
    edge_of_.push_back(edge);
    return static_cast<std::uint32_t>(places_.size() - 1);
  };
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const VoronoiEdge& edge = edges[e];
    const double least = edge.left.is_point() && edge.right.is_point() ? 0.5 * distance(edge.left.a, edge.right.a) : 0.0;
    const Vec2 from = diagram_->vertices()[edge.from], to = diagram_->vertices()[edge.to];
    const double at_from = distance(edge.left, from), at_to = distance(edge.left, to);
    if (std::max({least, at_from, at_to}) <= needed) continue;  // the clearance is greatest at one of the ends
    // No outline crosses the diagram: what begins within something solid stays there.
    if (space_.problem().world().is_blocked(at_from > at_to ? from : to)) continue;
    const std::vector<VoronoiPlace> places = diagram_->places(edge, spacing_, sagitta);
    std::uint32_t before = none;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!(places[i].clearance > needed)) {
        before = none;
        continue;
      }
      std::uint32_t here;
      if (i == 0 || i + 1 == places.size()) {
        std::uint32_t& of_vertex = place_of_vertex[i == 0 ? edge.from : edge.to];
        if (of_vertex == none) of_vertex = add(places[i], e);
        here = of_vertex;
      } else {
        here = add(places[i], e);
      }
      if (before != none && before != here && space_.is_free(places_[before].at, places_[here].at)) {
        links.push_back({before, {here, e}});
        links.push_back({here, {before, e}});
      }
      before = here;
    }
  }
  first_.assign(places_.size() + 1, 0);
  for (const auto& [from, link] : links) ++first_[from + 1];
  for (std::size_t i = 0; i < places_.size(); ++i) first_[i + 1] += first_[i];
  std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
  links_.resize(links.size());
  for (const auto& [from, link] : links) links_[fill[from]++] = link;
}

std::vector<std::pair<Vec2, Vec2>> VoronoiRoadmap::line_list() const {
  std::vector<std::pair<Vec2, Vec2>> all;
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
      if (i < links_[k].to) all.emplace_back(places_[i].at, places_[links_[k].to].at);
    }
  }
  return all;
}

/// Straight away from the nearest site, as far as that stays the nearest: there the diagram is.
Vec2 VoronoiRoadmap::away_from_nearest(Vec2 from) const {
  const std::array<Vec2, 1> point{from};
  const Nearest nearest = sites_.nearest(point, std::numeric_limits<double>::infinity());
  if (!nearest.found || !(nearest.distance > 0.0)) return from;
  const Vec2 along = (1.0 / nearest.distance) * (from - nearest.point);
  const auto is_nearest = [&](double t) { return clearance(from + t * along) >= nearest.distance + t - away_precision; };
  double near = 0.0, far = away_precision;
  const Box& region = space_.region();
  const double across = norm(region.high - region.low);
  while (far < across && is_nearest(far)) {
    near = far;
    far *= 2.0;
  }
  while (far - near > away_precision) {
    const double half = 0.5 * (near + far);
    (is_nearest(half) ? near : far) = half;
  }
  return from + near * along;
}

/// The shortest free lines to different edges of the diagram, none longer than twice the shortest, and the way straight from the nearest obstacle.
std::vector<VoronoiRoadmap::Join> VoronoiRoadmap::joins(Vec2 from, std::int64_t& lines) const {
  std::vector<Join> all;
  const auto is_free = [&](Vec2 a, Vec2 b) {
    if (a == b) return true;
    ++lines;
    return space_.is_free(a, b);
  };
  /// Of each edge its place nearest to `to`, near ones first.
  const auto nearest_places = [&](Vec2 to) {
    std::vector<std::pair<double, std::uint32_t>> of_edge(diagram_->edges().size(), {std::numeric_limits<double>::infinity(), none});
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      if (first_[i] == first_[i + 1]) continue;
      auto& best = of_edge[edge_of_[i]];
      best = std::min(best, {squared_norm(places_[i].at - to), i});
    }
    std::erase_if(of_edge, [](const auto& entry) { return entry.second == none; });
    const std::size_t kept = std::min<std::size_t>(of_edge.size(), most_tried);
    std::partial_sort(of_edge.begin(), of_edge.begin() + static_cast<std::ptrdiff_t>(kept), of_edge.end());
    of_edge.resize(kept);
    return of_edge;
  };
  for (const auto& [squared, place] : nearest_places(from)) {
    const double length = std::sqrt(squared);
    if (!all.empty() && (all.size() >= most_joins || length > 2.0 * all.front().length + spacing_)) break;
    if (is_free(from, places_[place].at)) all.push_back({place, from, {}, length});
  }
  const Vec2 over = away_from_nearest(from);
  if (over != from && is_free(from, over)) {
    std::size_t found = 0;
    for (const auto& [squared, place] : nearest_places(over)) {
      if (found == 2) break;
      if (!is_free(over, places_[place].at)) continue;
      all.push_back({place, from, over, distance(from, over) + std::sqrt(squared)});
      ++found;
    }
  }
  return all;
}

std::vector<VoronoiRoadmap::Join> VoronoiRoadmap::joins(const PlaneTarget& goal, std::int64_t& lines) const {
  if (goal.is_point()) return joins(goal.area.front(), lines);
  std::vector<Join> all;
  std::vector<std::pair<double, std::uint32_t>> outside;
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    if (first_[i] == first_[i + 1]) continue;
    const Vec2 at = places_[i].at, end = goal.nearest(at);
    const double off = distance(at, end);
    if (off <= 0.0) all.push_back({i, end, {}, 0.0});
    else outside.emplace_back(off, i);
  }
  if (!all.empty()) return all;
  const std::size_t tried = std::min<std::size_t>(outside.size(), most_tried);
  std::partial_sort(outside.begin(), outside.begin() + static_cast<std::ptrdiff_t>(tried), outside.end());
  for (std::size_t k = 0; k < tried; ++k) {
    const Vec2 at = places_[outside[k].second].at, end = goal.nearest(at);
    ++lines;
    if (space_.is_free(at, end)) all.push_back({outside[k].second, end, {}, outside[k].first});
  }
  // Places all over the region, as ends of their own.
  const Box box = bounding_box(goal.area);
  for (int row = 0; row < region_places; ++row) {
    for (int column = 0; column < region_places; ++column) {
      const Vec2 at{box.low.x + (column + 0.5) / region_places * (box.high.x - box.low.x), box.low.y + (row + 0.5) / region_places * (box.high.y - box.low.y)};
      if (goal.nearest(at) != at || !space_.is_free(at)) continue;
      const std::vector<Join> here = joins(at, lines);
      all.insert(all.end(), here.begin(), here.end());
    }
  }
  return all;
}

double VoronoiRoadmap::cost(Vec2 from, double clearance_from, Vec2 to, double clearance_to, double weight) const {
  const double length = distance(from, to);
  if (!(weight > 0.0)) return length;
  return length * (1.0 + 0.5 * weight * (1.0 / clearance_from + 1.0 / clearance_to));
}

/// A* over the places, with the joins of both ends.
class VoronoiSearch {
 public:
  VoronoiSearch(const VoronoiRoadmap& map, const PlaneTarget& goal, double weight) : map_{map}, goal_{goal}, weight_{weight} {}

  VoronoiAnswer run(Vec2 start, Budget& budget, std::optional<std::int64_t> expansions) {
    const Vec2 straight = goal_.nearest(start);
    const std::vector<Join> begin = map_.joins(start, answer_.lines), end = map_.joins(goal_, answer_.lines);
    const auto shortest_of = [](const std::vector<Join>& joins) {
      double least = std::numeric_limits<double>::infinity();
      for (const Join& j : joins) least = std::min(least, j.length);
      return least;
    };
    // Who is nearer to the goal than to the diagram drives there.
    if (distance(start, straight) <= shortest_of(begin) + shortest_of(end)) {
      ++answer_.lines;
      if (map_.space_.is_free(start, straight)) {
        answer_.ended = VoronoiEnd::found;
        answer_.way = {{start, map_.clearance(start), false, {}}};
        if (straight != start) answer_.way.push_back({straight, map_.clearance(straight), false, {}});
        return std::move(answer_);
      }
    }
    answer_.ended = begin.empty() ? VoronoiEnd::no_start : end.empty() ? VoronoiEnd::no_goal : search(start, begin, end, budget, expansions);
    return std::move(answer_);
  }

 private:
  using Join = VoronoiRoadmap::Join;
  static constexpr std::uint32_t none = VoronoiRoadmap::none;
  struct Entry {
    double estimate, cost;
    std::uint32_t place, parent, by;  // by: the edge, or which join
    bool operator<(const Entry& o) const {
      if (estimate != o.estimate) return estimate > o.estimate;
      if (cost != o.cost) return cost < o.cost;
      if (place != o.place) return place > o.place;
      if (parent != o.parent) return parent > o.parent;
      return by > o.by;
    }
  };
  struct Settled {
    std::uint32_t parent = none, by = none;
    double cost = std::numeric_limits<double>::infinity();
  };

  double join_cost(const Join& join) const {
    const VoronoiPlace& place = map_.places_[join.place];
    const double clearance = map_.clearance(join.end);
    if (!join.over) return map_.cost(join.end, clearance, place.at, place.clearance, weight_);
    const double half = map_.clearance(*join.over);
    return map_.cost(join.end, clearance, *join.over, half, weight_) + map_.cost(*join.over, half, place.at, place.clearance, weight_);
  }

  void offer(const Entry& entry, Vec2 at) {
    if (std::isfinite(settled_[entry.place].cost)) return;
    waiting_.push({entry.cost + distance(at, goal_.nearest(at)), entry.cost, entry.place, entry.parent, entry.by});
  }

  VoronoiEnd search(Vec2 start, const std::vector<Join>& begin, const std::vector<Join>& end, Budget& budget, std::optional<std::int64_t> expansions) {
    const auto goal = static_cast<std::uint32_t>(map_.places_.size());
    settled_.assign(map_.places_.size() + 1, {});
    std::vector<std::pair<std::uint32_t, std::uint32_t>> into;  // place, join
    for (std::uint32_t i = 0; i < end.size(); ++i) into.emplace_back(end[i].place, i);
    std::sort(into.begin(), into.end());
    for (std::uint32_t i = 0; i < begin.size(); ++i) offer({0.0, join_cost(begin[i]), begin[i].place, none, i}, map_.places_[begin[i].place].at);
    while (!waiting_.empty()) {
      if (answer_.expansions % clock_every == 0 && budget.exhausted()) return VoronoiEnd::stopped;
      const Entry next = waiting_.top();
      waiting_.pop();
      if (std::isfinite(settled_[next.place].cost)) continue;
      settled_[next.place] = {next.parent, next.by, next.cost};
      if (next.place == goal) {
        retrace(start, begin, end);
        return VoronoiEnd::found;
      }
      if (expansions && answer_.expansions >= *expansions) return VoronoiEnd::expansions;
      ++answer_.expansions;
      const VoronoiPlace& here = map_.places_[next.place];
      for (auto it = std::lower_bound(into.begin(), into.end(), std::pair{next.place, std::uint32_t{0}}); it != into.end() && it->first == next.place; ++it) {
        offer({0.0, next.cost + join_cost(end[it->second]), goal, next.place, it->second}, end[it->second].end);
      }
      for (std::uint32_t k = map_.first_[next.place]; k < map_.first_[next.place + 1]; ++k) {
        const VoronoiRoadmap::Link& link = map_.links_[k];
        const VoronoiPlace& there = map_.places_[link.to];
        offer({0.0, next.cost + map_.cost(here.at, here.clearance, there.at, there.clearance, weight_), link.to, next.place, link.edge}, there.at);
      }
    }
    return VoronoiEnd::unreachable;
  }

  void retrace(Vec2 start, const std::vector<Join>& begin, const std::vector<Join>& end) {
    const auto goal = static_cast<std::uint32_t>(map_.places_.size());
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = settled_[goal].parent; i != none; i = settled_[i].parent) places.push_back(i);
    std::reverse(places.begin(), places.end());
    const auto step_to = [&](Vec2 at) {
      if (answer_.way.back().at != at) answer_.way.push_back({at, map_.clearance(at), false, {}});
    };
    answer_.way = {{start, map_.clearance(start), false, {}}};
    const Join& first = begin[settled_[places.front()].by];
    if (first.over) step_to(*first.over);
    step_to(map_.places_[places.front()].at);
    // Stretches of one edge are one step.
    const std::vector<VoronoiEdge>& edges = map_.diagram_->edges();
    for (std::size_t i = 1; i < places.size();) {
      const std::uint32_t edge = settled_[places[i]].by;
      const Vec2 from = map_.places_[places[i - 1]].at;
      double least = std::min(map_.places_[places[i - 1]].clearance, map_.places_[places[i]].clearance);
      while (i + 1 < places.size() && settled_[places[i + 1]].by == edge) least = std::min(least, map_.places_[places[++i]].clearance);
      const Vec2 to = map_.places_[places[i]].at;
      if (to != from) answer_.way.push_back({to, least, true, control_point(edges[edge], from, to)});
      ++i;
    }
    const Join& last = end[settled_[goal].by];
    if (last.over) step_to(*last.over);
    step_to(last.end);
  }

  const VoronoiRoadmap& map_;
  const PlaneTarget& goal_;
  double weight_;
  std::vector<Settled> settled_;
  std::priority_queue<Entry> waiting_;
  VoronoiAnswer answer_;
};

VoronoiAnswer VoronoiRoadmap::shortest(Vec2 start, const PlaneTarget& goal, double weight, Budget& budget, std::optional<std::int64_t> expansions) const {
  return VoronoiSearch{*this, goal, weight}.run(start, budget, expansions);
}

}  // namespace waywright
