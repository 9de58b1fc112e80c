// Segments and points in a hierarchy of boxes, asked for their distance to a moving outline.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// A piece of an obstacle's outline; a == b is a point.
struct Segment {
  Vec2 a{};
  Vec2 b{};
  std::uint32_t source = 0;  ///< who owns it, for messages
};

struct Nearest {
  double distance = 0.0;           ///< m; 0 on contact
  Vec2 point{};                    ///< on the obstacle
  std::uint32_t source = 0;
  bool found = false;              ///< something nearer than the limit was found
};

class ObstacleIndex {
 public:
  ObstacleIndex() = default;
  explicit ObstacleIndex(std::vector<Segment> segments);

  bool empty() const { return segments_.empty(); }
  std::size_t size() const { return segments_.size(); }
  const std::vector<Segment>& segments() const { return segments_; }
  const Box& bounds() const { return nodes_.front().box; }  ///< @pre not empty

  /// Nearest segment to the area of a closed ring (world frame; one point or two are a point or a segment), exact, looked
  /// for below `limit`, segments of the source `without` left out. Laws: distance ≥ 0; unchanged by a rigid motion of both up to
  /// rounding; 0 where they overlap.
  Nearest nearest(std::span<const Vec2> ring, double limit, std::size_t without = static_cast<std::size_t>(-1)) const;
  /// True where nothing is within `margin` (≤) of the ring's area.
  bool is_clear(std::span<const Vec2> ring, double margin) const;

  /// Calls `seen(segment)` for every segment that may be within `distance` of a point.
  template <class Seen>
  void visit(Vec2 point, double distance, Seen&& seen) const {
    traverse([=](const Box& box) { return squared_distance(box, point) <= distance * distance; },
             [&](const Segment& s) {
               seen(s);
               return true;
             });
  }
  /// True where `is_fine(segment)` is so for every segment whose own box meets `box`.
  template <class IsFine>
  bool all_of(const Box& box, IsFine&& is_fine) const {
    return traverse([&](const Box& other) { return meet(box, other); },
                    [&](const Segment& s) {
                      const Box own{{std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y)}, {std::max(s.a.x, s.b.x), std::max(s.a.y, s.b.y)}};
                      return !meet(box, own) || is_fine(s);
                    });
  }

 private:
  static constexpr std::size_t deepest = 128;  ///< entries of a traversal's stack: the tree is balanced
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: first segment; inner: right child (left child is the next node)
    std::uint32_t count = 0;  ///< 0: inner
  };
  /// Leaves of the boxes that are wanted; ends, false, where `go_on` does not want to.
  template <class Wanted, class GoOn>
  bool traverse(Wanted&& wanted, GoOn&& go_on) const {
    if (nodes_.empty()) return true;
    std::array<std::uint32_t, deepest> stack;
    std::size_t top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const std::uint32_t index = stack[--top];
      const Node& node = nodes_[index];
      if (!wanted(node.box)) continue;
      if (node.count == 0) {
        stack[top++] = index + 1;
        stack[top++] = node.first;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (!go_on(segments_[i])) return false;
      }
    }
    return true;
  }
  static bool meet(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }
  static double squared_distance(const Box& box, Vec2 point) {
    const double dx = std::max({0.0, box.low.x - point.x, point.x - box.high.x});
    const double dy = std::max({0.0, box.low.y - point.y, point.y - box.high.y});
    return dx * dx + dy * dy;
  }
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<Segment> segments_;
  std::vector<Node> nodes_;
};

/// Least distance between two closed segments; 0 where they cross. `on_b` receives the nearest point of b.
double segment_distance(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1, Vec2* on_b = nullptr);
double point_segment_distance(Vec2 p, Vec2 a, Vec2 b, Vec2* on = nullptr);

}  // namespace waywright
