#include "waywright/geometry/obstacle_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr std::uint32_t leaf_size = 4;

Box box_of(const Segment& s) {
  return {{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)}, {std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}};
}

void grow(Box& box, const Box& other) {
  box.low.x = std::min(box.low.x, other.low.x);
  box.low.y = std::min(box.low.y, other.low.y);
  box.high.x = std::max(box.high.x, other.high.x);
  box.high.y = std::max(box.high.y, other.high.y);
}

inline double squared_gap(const Box& a, const Box& b) {
  const double dx = std::max(std::max(0.0, a.low.x - b.high.x), b.low.x - a.high.x);
  const double dy = std::max(std::max(0.0, a.low.y - b.high.y), b.low.y - a.high.y);
  return dx * dx + dy * dy;
}

Box box_of(std::span<const Vec2> ring) {
  Box box{ring.front(), ring.front()};
  for (const Vec2 p : ring.subspan(1)) grow(box, {p, p});
  return box;
}

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

/// An outline made ready for many distance questions: edge vectors and their inverse squared lengths.
class Outline {
 public:
  explicit Outline(std::span<const Vec2> ring) : ring_{ring}, edges_{ring.size() < 3 ? ring.size() - 1 : ring.size()} {
    for (std::size_t i = 0; i < std::min(edges_, capacity); ++i) ready_[i] = make_edge(i);
    convex_ = ring.size() >= 3;
    for (std::size_t i = 0; convex_ && i < edges_; ++i) convex_ = cross(edge(i).d(), edge(next(i)).d()) >= 0.0;
  }

  /// Squared distance of a point to the area; 0 inside.
  double squared_distance(Vec2 q) const {
    if (edges_ == 0) return squared_norm(q - ring_[0]);
    double best = std::numeric_limits<double>::infinity();
    bool left_of_all = convex_;
    bool odd = false;
    for (std::size_t i = 0; i < edges_; ++i) {
      const Edge e = edge(i);
      const Vec2 d = e.d();
      const Vec2 r = q - e.a();
      const double along = std::clamp(dot(r, d) * e.inverse, 0.0, 1.0);
      best = std::min(best, squared_norm(r - along * d));
      if (convex_) {
        left_of_all = left_of_all && cross(d, r) >= 0.0;
      } else if (edges_ > 2) {
        if ((e.a().y > q.y) != (e.b().y > q.y) && (r.x * d.y < r.y * d.x) == (d.y > 0.0)) odd = !odd;
      }
    }
    return left_of_all || odd ? 0.0 : best;
  }

  /// Squared distance of a segment to the area, and the segment's nearest point. `apart`: their boxes do not meet.
  Candidate nearest(const Segment& s, bool apart) const {
    Candidate c{squared_distance(s.a), s.a};
    if (s.a == s.b || c.squared == 0.0) return c;
    if (const double at_b = squared_distance(s.b); at_b < c.squared) c = {at_b, s.b};
    if (c.squared == 0.0) return c;
    for (std::size_t i = 0; !apart && i < edges_; ++i) {
      const Edge e = edge(i);
      if (!cross_each_other(e.a(), e.b(), s.a, s.b)) continue;
      return segment_to_segment(e.a(), e.b(), s.a, s.b);
    }
    const Vec2 d = s.b - s.a;
    const double inverse = 1.0 / squared_norm(d);
    for (const Vec2 p : ring_) {
      const Vec2 q = s.a + std::clamp(dot(p - s.a, d) * inverse, 0.0, 1.0) * d;
      if (const double squared = squared_norm(p - q); squared < c.squared) c = {squared, q};
    }
    return c;
  }

 private:
  struct Edge {
    double from_x, from_y, along_x, along_y, inverse;  // not set to 0 beforehand: that would take longer than making some
    Vec2 a() const { return {from_x, from_y}; }
    Vec2 d() const { return {along_x, along_y}; }
    Vec2 b() const { return a() + d(); }
  };
  static constexpr std::size_t capacity = 24;

  std::size_t next(std::size_t i) const { return i + 1 < ring_.size() ? i + 1 : 0; }
  Edge make_edge(std::size_t i) const {
    const Vec2 a = ring_[i];
    const Vec2 d = ring_[next(i)] - a;
    const double length2 = squared_norm(d);
    return {a.x, a.y, d.x, d.y, length2 > 0.0 ? 1.0 / length2 : 0.0};
  }
  /// Those beyond the capacity are made each time: no outline needs memory of its own.
  Edge edge(std::size_t i) const { return i < capacity ? ready_[i] : make_edge(i); }

  std::span<const Vec2> ring_;
  std::size_t edges_;
  bool convex_ = false;
  std::array<Edge, capacity> ready_;
};

}  // namespace

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
  nodes_.reserve(segments_.size());
  build(0, static_cast<std::uint32_t>(segments_.size()));
}

std::uint32_t ObstacleIndex::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box = box_of(segments_[begin]);
  for (std::uint32_t i = begin + 1; i < end; ++i) grow(box, box_of(segments_[i]));
  nodes_[index].box = box;
  if (end - begin <= leaf_size) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return index;
  }
  // Median split along the longer side: depth stays logarithmic whatever the data, so that recursion and stack are bounded.
  const bool along_x = box.high.x - box.low.x >= box.high.y - box.low.y;
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto key = [along_x](const Segment& s) { return along_x ? s.a.x + s.b.x : s.a.y + s.b.y; };
  std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                   [&](const Segment& l, const Segment& r) { return key(l) < key(r); });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[index].first = right;
  return index;
}

Nearest ObstacleIndex::nearest(std::span<const Vec2> ring, double limit, std::size_t without) const {
  Nearest answer;
  answer.distance = limit;
  if (nodes_.empty() || ring.empty() || !(limit > 0.0)) return answer;
  const Box box = box_of(ring);
  const Outline outline{ring};
  double best = limit * limit;
  struct Entry {
    std::uint32_t node;
    double gap;
  };
  std::array<Entry, 128> stack;
  std::size_t top = 0;
  stack[top++] = {0, squared_gap(nodes_[0].box, box)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.gap >= best) continue;
    const Node& node = nodes_[entry.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const Segment& s = segments_[i];
        if (s.source == without) continue;
        const double gap = squared_gap(box_of(s), box);
        if (gap >= best) continue;
        const Candidate c = outline.nearest(s, gap > 0.0);
        if (c.squared < best) {
          best = c.squared;
          answer.point = c.on;
          answer.source = s.source;
          answer.found = true;
          if (best == 0.0) {
            answer.distance = 0.0;
            return answer;
          }
        }
      }
      continue;
    }
    Entry left{entry.node + 1, squared_gap(nodes_[entry.node + 1].box, box)};
    Entry right{node.first, squared_gap(nodes_[node.first].box, box)};
    if (left.gap < right.gap) std::swap(left, right);  // the nearer one is popped first
    if (left.gap < best) stack[top++] = left;
    if (right.gap < best) stack[top++] = right;
  }
  if (answer.found) answer.distance = std::sqrt(best);
  return answer;
}

bool ObstacleIndex::is_clear(std::span<const Vec2> ring, double margin) const {
  if (nodes_.empty() || ring.empty()) return true;
  // "≤ margin is a hit": look just beyond the margin.
  const double limit = std::nextafter(std::max(margin, 0.0), std::numeric_limits<double>::infinity());
  const Box box = box_of(ring);
  const Outline outline{ring};
  const double limit2 = margin > 0.0 ? limit * limit : std::numeric_limits<double>::min();
  std::array<std::uint32_t, 128> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::uint32_t index = stack[--top];
    const Node& node = nodes_[index];
    if (squared_gap(node.box, box) >= limit2) continue;
    if (node.count == 0) {
      stack[top++] = index + 1;
      stack[top++] = node.first;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const Segment& s = segments_[i];
      const double gap = squared_gap(box_of(s), box);
      if (gap < limit2 && outline.nearest(s, gap > 0.0).squared < limit2) return false;
    }
  }
  return true;
}

}  // namespace waywright
