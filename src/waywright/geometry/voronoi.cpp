#include "waywright/geometry/voronoi.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <limits>

#include "waywright/geometry/voronoi_noding.hpp"

namespace waywright {
namespace {

constexpr int deepest = 40;  // halvings of a curved edge
constexpr double straight_enough = 1e-9;  // m: a parabola with its focus so near to its directrix is a line

/// A parabola in its own frame: x along the directrix, from below the focus; y from the directrix to the side of the focus.
struct Parabola {
  Vec2 foot{}, along{}, up{};
  double height = 0.0;  // of the focus, m

  Parabola(Vec2 focus, const VoronoiSite& directrix) {
    along = (1.0 / distance(directrix.a, directrix.b)) * (directrix.b - directrix.a);
    up = left_of(along);
    height = dot(focus - directrix.a, up);
    foot = focus - height * up;
    if (height < 0.0) {
      height = -height;
      up = -up;
    }
  }
  bool is_line() const { return height < straight_enough; }
  double x_of(Vec2 p) const { return dot(p - foot, along); }
  double y_at(double x) const { return (x * x + height * height) / (2.0 * height); }
  Vec2 at(double x) const { return foot + x * along + y_at(x) * up; }
};

Parabola parabola_of(const VoronoiEdge& edge) { return edge.left.is_point() ? Parabola{edge.left.a, edge.right} : Parabola{edge.right.a, edge.left}; }

/// How sharp a ridge the clearance has there: the sine of half the angle between the directions to both sites.
double sharpness(const VoronoiEdge& edge, Vec2 at) {
  const Vec2 p = nearest(edge.left, at), q = nearest(edge.right, at);
  const double both = distance(at, p) + distance(at, q);
  return both > 0.0 ? distance(p, q) / both : 0.0;
}

}  // namespace

double distance(const VoronoiSite& site, Vec2 from) { return distance(nearest(site, from), from); }

Vec2 nearest(const VoronoiSite& site, Vec2 to) {
  if (site.is_point()) return site.a;
  const Vec2 along = site.b - site.a;
  return site.a + std::clamp(dot(to - site.a, along) / squared_norm(along), 0.0, 1.0) * along;
}

std::optional<Vec2> control_point(const VoronoiEdge& edge, Vec2 from, Vec2 to) {
  if (edge.is_straight()) return std::nullopt;
  const Parabola parabola = parabola_of(edge);
  if (parabola.is_line()) return std::nullopt;
  // Tangents in x0 and x1 of y = (x² + h²)/2h meet at ((x0 + x1)/2, (x0 x1 + h²)/2h).
  const double x0 = parabola.x_of(from), x1 = parabola.x_of(to);
  return parabola.foot + 0.5 * (x0 + x1) * parabola.along + (x0 * x1 + parabola.height * parabola.height) / (2.0 * parabola.height) * parabola.up;
}

std::optional<VoronoiDiagram> VoronoiDiagram::of(std::span<const Segment> segments) {
  VoronoiDiagram diagram;
  diagram.unit_ = least_unit;
  if (segments.empty()) return diagram;
  Vec2 low = segments.front().a, high = low;
  for (const Segment& s : segments) {
    low = {std::min({low.x, s.a.x, s.b.x}), std::min({low.y, s.a.y, s.b.y})};
    high = {std::max({high.x, s.a.x, s.b.x}), std::max({high.y, s.a.y, s.b.y})};
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  while (diagram.unit_ * 0x1p29 < extent) diagram.unit_ *= 2.0;
  const double unit = diagram.unit_, per_unit = 1.0 / unit;
  // Middle of the map on the grid, so that maps that are on the grid stay what they are.
  const Vec2 middle{unit * std::floor(0.5 * (low.x + high.x) * per_unit), unit * std::floor(0.5 * (low.y + high.y) * per_unit)};
  const auto to_grid = [&](Vec2 p) {
    return GridPoint{static_cast<std::int32_t>(std::floor((p.x - middle.x) * per_unit + 0.5)), static_cast<std::int32_t>(std::floor((p.y - middle.y) * per_unit + 0.5))};
  };
  const auto from_grid = [&](GridPoint p) { return middle + unit * Vec2{double(p.x), double(p.y)}; };
  std::vector<GridSegment> whole;
  whole.reserve(segments.size());
  for (const Segment& s : segments) whole.push_back({to_grid(s.a), to_grid(s.b)});
  const std::optional<Noded> nodes = noded(std::move(whole));
  if (!nodes) return std::nullopt;
  diagram.error_ = (1.0 + nodes->rounds) * 0.70711 * unit;

  boost::polygon::voronoi_builder<std::int32_t> builder;
  for (const GridSegment& s : nodes->segments) {
    diagram.sites_.push_back({from_grid(s.a), from_grid(s.b)});
    if (s.a == s.b) builder.insert_point(s.a.x, s.a.y);
    else builder.insert_segment(s.a.x, s.a.y, s.b.x, s.b.y);
  }
  boost::polygon::voronoi_diagram<double> made;
  builder.construct(&made);
  diagram.vertices_.reserve(made.vertices().size());
  for (const auto& v : made.vertices()) diagram.vertices_.push_back(middle + unit * Vec2{v.x(), v.y()});
  const auto site_of = [&](const auto& cell) {
    const VoronoiSite& site = diagram.sites_[cell.source_index()];
    switch (cell.source_category()) {
      case boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT: return VoronoiSite{site.a, site.a};
      case boost::polygon::SOURCE_CATEGORY_SEGMENT_END_POINT: return VoronoiSite{site.b, site.b};
      default: return site;
    }
  };
  const auto* first = made.vertices().empty() ? nullptr : &made.vertices().front();
  for (const auto& edge : made.edges()) {
    if (&edge > edge.twin() || !edge.is_finite() || !edge.is_primary()) continue;
    diagram.edges_.push_back({static_cast<std::uint32_t>(edge.vertex0() - first), static_cast<std::uint32_t>(edge.vertex1() - first), site_of(*edge.cell()), site_of(*edge.twin()->cell())});
  }
  diagram.prune();
  return diagram;
}

/// Blind ends that are nearly flat go, and what ends blindly then.
void VoronoiDiagram::prune() {
  const std::size_t n = vertices_.size();
  std::vector<std::uint32_t> first(n + 1, 0), of_vertex(2 * edges_.size());
  for (const VoronoiEdge& e : edges_) {
    ++first[e.from];
    ++first[e.to];
  }
  std::vector<std::uint32_t> degree(first.begin(), first.end() - 1);
  for (std::size_t i = 0, sum = 0; i <= n; ++i) {
    const std::size_t here = first[i];
    first[i] = static_cast<std::uint32_t>(sum);
    sum += here;
  }
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    of_vertex[fill[edges_[i].from]++] = i;
    of_vertex[fill[edges_[i].to]++] = i;
  }
  std::vector<bool> is_gone(edges_.size(), false);
  std::vector<std::uint32_t> blind;
  for (std::uint32_t v = 0; v < n; ++v) {
    if (degree[v] == 1) blind.push_back(v);
  }
  while (!blind.empty()) {
    const std::uint32_t v = blind.back();
    blind.pop_back();
    if (degree[v] != 1) continue;
    for (std::uint32_t k = first[v]; k < first[v + 1]; ++k) {
      const std::uint32_t e = of_vertex[k];
      if (is_gone[e]) continue;
      const std::uint32_t other = edges_[e].from == v ? edges_[e].to : edges_[e].from;
      const bool is_inner = distance(edges_[e].left, vertices_[other]) >= distance(edges_[e].left, vertices_[v]);
      if (sharpness(edges_[e], vertices_[is_inner ? other : v]) >= 0.5 * flat) break;
      is_gone[e] = true;
      --degree[v];
      if (--degree[other] == 1) blind.push_back(other);
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (!is_gone[i]) edges_[kept++] = edges_[i];
  }
  edges_.resize(kept);
}

std::vector<VoronoiPlace> VoronoiDiagram::places(const VoronoiEdge& edge, double spacing, double sagitta) const {
  const Vec2 from = vertices_[edge.from], to = vertices_[edge.to];
  const auto place = [&edge](Vec2 at) { return VoronoiPlace{at, std::min(distance(edge.left, at), distance(edge.right, at))}; };
  std::vector<VoronoiPlace> all{place(from)};
  const auto straight_to = [&](Vec2 end) {
    const Vec2 begin = all.back().at;
    const double parts = std::max(1.0, std::ceil(distance(begin, end) / spacing));
    for (double i = 1.0; i < parts; i += 1.0) all.push_back(place(begin + (i / parts) * (end - begin)));
    all.push_back(place(end));
  };
  if (edge.is_straight()) {
    // Between two points the least clearance is half way between them.
    if (edge.left.is_point()) {
      const Vec2 middle = 0.5 * (edge.left.a + edge.right.a), along = to - from;
      const double squared = squared_norm(along), share = squared > 0.0 ? dot(middle - from, along) / squared : 0.0;
      if (share > 0.0 && share < 1.0) straight_to(from + share * along);
    }
    straight_to(to);
    return all;
  }
  const Parabola parabola = parabola_of(edge);
  if (parabola.is_line()) {
    straight_to(to);
    return all;
  }
  // The edge is halved in x until it is near enough to its chord: over dx it is dx²/8h above it, less by the slope across.
  struct Part {
    double x0, x1;
    int depth;
  };
  const double h = parabola.height, x0 = parabola.x_of(from), x1 = parabola.x_of(to);
  std::vector<Part> waiting;
  if (x0 * x1 < 0.0) waiting = {{0.0, x1, 0}, {x0, 0.0, 0}};
  else waiting = {{x0, x1, 0}};
  while (!waiting.empty()) {
    const Part part = waiting.back();
    waiting.pop_back();
    const double dx = part.x1 - part.x0, slope = 0.5 * (part.x0 + part.x1) / h, stretch = std::sqrt(1.0 + slope * slope);
    const bool is_fine = dx * dx / (8.0 * h) <= sagitta * stretch && std::abs(dx) * stretch <= spacing;
    if (!is_fine && part.depth < deepest) {
      const double half = 0.5 * (part.x0 + part.x1);
      waiting.push_back({half, part.x1, part.depth + 1});
      waiting.push_back({part.x0, half, part.depth + 1});
      continue;
    }
    all.push_back(place(part.x1 == x1 ? to : parabola.at(part.x1)));
  }
  return all;
}

}  // namespace waywright
