#include "waywright/geometry/obstacle_index.hpp"

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr std::uint32_t width = segment_lanes::width;

struct Candidate {
  double squared = 0.0;
  Vec2 on{};
};

Candidate point_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length2 = squared_norm(d);
  const double t = length2 > 0.0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  const Vec2 q = a + t * d;
  return {squared_norm(p - q), q};
}

/// Proper or touching crossing by orientation signs; collinear overlap is left to the end-point distances, which are 0 there.
bool cross_each_other(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1) {
  const double d0 = cross(b1 - b0, a0 - b0);
  const double d1 = cross(b1 - b0, a1 - b0);
  const double e0 = cross(a1 - a0, b0 - a0);
  const double e1 = cross(a1 - a0, b1 - a0);
  return ((d0 > 0.0) != (d1 > 0.0)) && ((e0 > 0.0) != (e1 > 0.0));
}

/// Squared distance of two segments and the nearest point of b.
Candidate segment_to_segment(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1) {
  if (cross_each_other(a0, a1, b0, b1)) {
    const Vec2 r = a1 - a0;
    const Vec2 s = b1 - b0;
    const double denominator = cross(s, r);
    const double u = denominator != 0.0 ? std::clamp(cross(a0 - b0, r) / denominator, 0.0, 1.0) : 0.0;
    return {0.0, b0 + u * s};
  }
  Candidate best = point_to_segment(a0, b0, b1);
  if (const Candidate c = point_to_segment(a1, b0, b1); c.squared < best.squared) best = c;
  if (const Candidate c = point_to_segment(b0, a0, a1); c.squared < best.squared) best = {c.squared, b0};
  if (const Candidate c = point_to_segment(b1, a0, a1); c.squared < best.squared) best = {c.squared, b1};
  return best;
}

/// As good as a rectangle: what it is off by is rounding of coordinates up to `extent`, across its short side too. Distances are off by no more than
/// twice that.
bool is_rectangle(const segment_lanes::Edge* edge, double extent) {
  const double by = 6e-16 * extent;
  const segment_lanes::Edge &e = edge[0], &f = edge[1], &g = edge[2], &h = edge[3];
  const auto are_opposite = [by](double a, double b) { return std::abs(a + b) <= by; };
  const double least = std::min(std::max(std::abs(e.along_x), std::abs(e.along_y)), std::max(std::abs(f.along_x), std::abs(f.along_y)));
  return are_opposite(e.along_x, g.along_x) && are_opposite(e.along_y, g.along_y) && are_opposite(f.along_x, h.along_x) &&
         are_opposite(f.along_y, h.along_y) && std::abs(e.along_x * f.along_x + e.along_y * f.along_y) <= by * least && least > by;
}

/// Turns left only, once round; edges without length do not count.
bool is_convex_outline(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  Vec2 first{}, before{};
  bool turns = false;
  int changes = 0;            // of the direction along x
  double sign = 0.0, first_sign = 0.0;
  const auto is_fine = [&](Vec2 d) {
    const double turn = cross(before, d);
    turns = turns || turn > 0.0;
    return turn > 0.0 || (turn == 0.0 && dot(before, d) > 0.0);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 d = ring[i + 1 < n ? i + 1 : 0] - ring[i];
    if (d == Vec2{}) continue;
    if (before == Vec2{}) {
      first = d;
    } else if (!is_fine(d)) {
      return false;
    }
    before = d;
    if (d.x == 0.0) continue;
    const double own = d.x > 0.0 ? 1.0 : -1.0;
    if (first_sign == 0.0) first_sign = own;
    changes += sign != 0.0 && own != sign ? 1 : 0;
    sign = own;
  }
  changes += sign != first_sign ? 1 : 0;
  return before != Vec2{} && is_fine(first) && turns && changes <= 2;
}

/// A limit's square, which is not 0 where the limit is not.
double squared_limit(double limit) { return std::max(limit * limit, std::numeric_limits<double>::min()); }

/// Where a segment is nearest to a ring's area.
Vec2 nearest_on(const Segment& s, std::span<const Vec2> ring) {
  const std::size_t edges = ring.size() < 3 ? ring.size() - 1 : ring.size();
  Candidate best = point_to_segment(ring.front(), s.a, s.b);
  for (const Vec2 end : {s.a, s.b}) {
    if (ring.size() > 2 && contains(ring, end)) return end;
  }
  for (std::size_t i = 0; i < edges; ++i) {
    const Candidate c = segment_to_segment(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], s.a, s.b);
    if (c.squared < best.squared) best = c;
  }
  return best.on;
}

/// The corners of a ring as the kernels read them.
static_assert(sizeof(Vec2) == 2 * sizeof(double));

const segment_lanes::Kernels& kernels() {
  static const segment_lanes::Kernels& widest = segment_lanes::best();
  return widest;
}

}  // namespace

void make_ready(std::span<const Vec2> ring, segment_lanes::Outline& outline) {
  using segment_lanes::Shape;
  const std::size_t corners = ring.size();
  const std::size_t edges = corners < 3 ? corners - 1 : corners;
  outline.corner = &ring.front().x;
  outline.corners = static_cast<int>(corners);
  outline.edges = static_cast<int>(edges);
  outline.low_x = outline.high_x = ring.front().x;
  outline.low_y = outline.high_y = ring.front().y;
  for (const Vec2 p : ring) {
    outline.low_x = std::min(outline.low_x, p.x);
    outline.low_y = std::min(outline.low_y, p.y);
    outline.high_x = std::max(outline.high_x, p.x);
    outline.high_y = std::max(outline.high_y, p.y);
  }
  const auto along = [&](std::size_t i) { return ring[i + 1 < corners ? i + 1 : 0] - ring[i]; };
  for (std::size_t i = 0; i < std::min<std::size_t>(edges, segment_lanes::Outline::capacity); ++i) {
    const Vec2 d = along(i);
    const double squared = squared_norm(d);
    outline.ready[i] = {ring[i].x, ring[i].y, d.x, d.y, squared > 0.0 ? 1.0 / squared : 0.0};
  }
  outline.shape = corners >= 3 && is_convex_outline(ring) ? Shape::convex : Shape::any;  // a ring without area has no inside
  if (corners != 4 || outline.shape != Shape::convex) return;
  const double extent = std::max(std::max(std::abs(outline.low_x), std::abs(outline.high_x)), std::max(std::abs(outline.low_y), std::abs(outline.high_y)));
  if (is_rectangle(outline.ready, extent)) outline.shape = Shape::rectangle;
}

double point_segment_distance(Vec2 p, Vec2 a, Vec2 b, Vec2* on) {
  const Candidate c = point_to_segment(p, a, b);
  if (on != nullptr) *on = c.on;
  return std::sqrt(c.squared);
}

double segment_distance(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1, Vec2* on_b) {
  const Candidate c = segment_to_segment(a0, a1, b0, b1);
  if (on_b != nullptr) *on_b = c.on;
  return std::sqrt(c.squared);
}

ObstacleIndex::ObstacleIndex(std::vector<Segment> segments) : segments_{std::move(segments)} {
  if (segments_.empty()) return;
  const auto count = static_cast<std::uint32_t>(segments_.size());
  nodes_.reserve(count / 64 + 2);
  build(0, count);
  blocks_.resize((count + width - 1) / width);
  for (std::uint32_t i = 0; i < blocks_.size() * width; ++i) {
    segment_lanes::Block& block = blocks_[i / width];
    const std::uint32_t lane = i % width;
    const Segment& s = segments_[std::min(i, count - 1)];
    block.ax[lane] = s.a.x;
    block.ay[lane] = s.a.y;
    block.bx[lane] = s.b.x;
    block.by[lane] = s.b.y;
    const double squared = squared_norm(s.b - s.a);
    block.inverse[lane] = squared > 0.0 ? 1.0 / squared : 0.0;
    block.source[lane] = s.source;
    block.ends_begin_others = (lane == 0 || block.ends_begin_others) && (s.end_begins_another || s.a == s.b);
  }
  bounds_ = box_of(0, count);
}

/// A node: up to 32 parts, each but the last a multiple of eight segments; blocks where so many are enough, nodes else.
std::uint32_t ObstacleIndex::build(std::uint32_t begin, std::uint32_t end) {
  struct Part {
    std::uint32_t begin, end;
    std::uint32_t size() const { return end - begin; }
  };
  constexpr std::uint32_t fan = segment_lanes::fan;
  const bool holds_blocks = end - begin <= fan * width;
  const std::uint32_t enough = holds_blocks ? width : fan * width;
  boost::container::static_vector<Part, fan> parts{{begin, end}};
  while (parts.size() < fan) {
    const auto most = std::max_element(parts.begin(), parts.end(), [](Part l, Part r) { return l.size() < r.size(); });
    const Part part = *most;
    if (part.size() <= enough) break;
    // Split by half along the longer side: depth stays logarithmic whatever the data, so that recursion and waiting places are bounded.
    const Box box = box_of(part.begin, part.end);
    const bool along_x = box.high.x - box.low.x >= box.high.y - box.low.y;
    const std::uint32_t blocks = (part.size() + width - 1) / width;
    const std::uint32_t middle = part.begin + (blocks + 1) / 2 * width;
    const auto key = [along_x](const Segment& s) { return along_x ? s.a.x + s.b.x : s.a.y + s.b.y; };
    std::nth_element(segments_.begin() + part.begin, segments_.begin() + middle, segments_.begin() + part.end,
                     [&](const Segment& l, const Segment& r) { return key(l) < key(r); });
    *most = {part.begin, middle};
    parts.insert(most + 1, Part{middle, part.end});
  }
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_[index].count = static_cast<int>(parts.size());
  nodes_[index].holds_blocks = holds_blocks;
  for (std::uint32_t k = 0; k < fan; ++k) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const bool is_there = k < parts.size();
    const Box box = is_there ? box_of(parts[k].begin, parts[k].end) : Box{{infinity, infinity}, {-infinity, -infinity}};
    const std::uint32_t child = !is_there ? 0 : holds_blocks ? parts[k].begin / width : build(parts[k].begin, parts[k].end);
    segment_lanes::Boxes& boxes = nodes_[index].boxes[k / width];
    const std::uint32_t lane = k % width;
    boxes.low_x[lane] = box.low.x;
    boxes.low_y[lane] = box.low.y;
    boxes.high_x[lane] = box.high.x;
    boxes.high_y[lane] = box.high.y;
    nodes_[index].child[k] = child;
  }
  return index;
}

Box ObstacleIndex::box_of(std::uint32_t begin, std::uint32_t end) const {
  Box box{segments_[begin].a, segments_[begin].a};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Vec2 p : {segments_[i].a, segments_[i].b}) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

segment_lanes::Found ObstacleIndex::find(std::span<const Vec2> ring, double squared, std::size_t without, bool any) const {
  segment_lanes::Outline outline;
  make_ready(ring, outline);
  const auto source = static_cast<std::uint32_t>(std::min<std::size_t>(without, segment_lanes::none));
  return kernels().nearest(tree(), outline, squared, source, any, segment_lanes::none);
}

Nearest ObstacleIndex::nearest(std::span<const Vec2> ring, double limit, std::size_t without) const {
  Nearest answer;
  answer.distance = limit;
  if (nodes_.empty() || ring.empty() || !(limit > 0.0)) return answer;
  const segment_lanes::Found found = find(ring, squared_limit(limit), without, false);
  if (found.segment == segment_lanes::none) return answer;
  const Segment& s = segments_[found.segment];
  return {std::sqrt(found.squared), nearest_on(s, ring), s.source, true};
}

double ObstacleIndex::distance(std::span<const Vec2> ring, double limit, std::size_t without) const {
  if (nodes_.empty() || ring.empty() || !(limit > 0.0)) return limit;
  const segment_lanes::Found found = find(ring, squared_limit(limit), without, false);
  return found.segment == segment_lanes::none ? limit : std::sqrt(found.squared);
}

double ObstacleIndex::distance(const segment_lanes::Outline& outline, double limit, std::uint32_t& hint) const {
  if (nodes_.empty() || !(limit > 0.0)) return limit;
  const segment_lanes::Found found = kernels().nearest(tree(), outline, squared_limit(limit), segment_lanes::none, false, hint);
  if (found.segment == segment_lanes::none) return limit;
  hint = found.segment;
  return std::sqrt(found.squared);
}

bool ObstacleIndex::is_clear(std::span<const Vec2> ring, double margin) const {
  if (nodes_.empty() || ring.empty()) return true;
  // "≤ margin is a hit": look just beyond the margin.
  const double limit = std::nextafter(std::max(margin, 0.0), std::numeric_limits<double>::infinity());
  const double squared = squared_limit(limit);
  return find(ring, squared, segment_lanes::none, true).segment == segment_lanes::none;
}

}  // namespace waywright
