// Segments and points in a hierarchy of boxes, asked for their distance to a moving outline.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/geometry/lanes/kernels.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// A piece of an obstacle's outline; a == b is a point.
struct Segment {
  Vec2 a{};
  Vec2 b{};
  std::uint32_t source = 0;  ///< who owns it, for messages
  bool end_begins_another = false;  ///< b is the a of another segment of the same source, as in a ring: it need not be looked at twice
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
  const Box& bounds() const { return bounds_; }  ///< @pre not empty

  segment_lanes::Tree tree() const { return {nodes_.data(), blocks_.data()}; }  ///< as the kernels take it. @pre not empty

  /// Nearest segment to the area of a closed ring (world frame; one point or two are a point or a segment), exact, looked
  /// for below `limit`, segments of the source `without` left out. Laws: distance ≥ 0; unchanged by a rigid motion of both up to
  /// rounding; 0 where they overlap.
  Nearest nearest(std::span<const Vec2> ring, double limit, std::size_t without = static_cast<std::size_t>(-1)) const;
  /// The distance alone: cheaper. `limit` where nothing is nearer.
  double distance(std::span<const Vec2> ring, double limit, std::size_t without = static_cast<std::size_t>(-1)) const;
  /// For an outline that is ready. `hint` (segment_lanes::none at first): which segment was nearest the last time.
  double distance(const segment_lanes::Outline& outline, double limit, std::uint32_t& hint) const;
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
  /// Segments of the blocks whose boxes are wanted; ends, false, where `go_on` does not want to.
  template <class Wanted, class GoOn>
  bool traverse(Wanted&& wanted, GoOn&& go_on) const {
    if (nodes_.empty()) return true;
    std::array<std::uint32_t, segment_lanes::deepest> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const segment_lanes::Node& node = nodes_[waiting[--count]];
      for (int k = 0; k < node.count; ++k) {
        const segment_lanes::Boxes& b = node.boxes[k / segment_lanes::width];
        const int lane = k % segment_lanes::width;
        if (!wanted(Box{{b.low_x[lane], b.low_y[lane]}, {b.high_x[lane], b.high_y[lane]}})) continue;
        if (!node.holds_blocks) {
          waiting[count++] = node.child[k];
          continue;
        }
        const std::size_t first = static_cast<std::size_t>(node.child[k]) * segment_lanes::width;
        for (std::size_t i = first; i < std::min(segments_.size(), first + segment_lanes::width); ++i) {
          if (!go_on(segments_[i])) return false;
        }
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
  Box box_of(std::uint32_t begin, std::uint32_t end) const;
  segment_lanes::Found find(std::span<const Vec2> ring, double squared, std::size_t without, bool any) const;

  std::vector<Segment> segments_;  ///< eight after eight in the blocks
  std::vector<segment_lanes::Node> nodes_;
  std::vector<segment_lanes::Block> blocks_;
  Box bounds_{};
};

/// An outline as the kernels take it, which looks at the ring's corners. @pre the ring, not empty, outlives it unmoved
void make_ready(std::span<const Vec2> ring, segment_lanes::Outline& outline);

/// Least distance between two closed segments; 0 where they cross. `on_b` receives the nearest point of b.
double segment_distance(Vec2 a0, Vec2 a1, Vec2 b0, Vec2 b1, Vec2* on_b = nullptr);
double point_segment_distance(Vec2 p, Vec2 a, Vec2 b, Vec2* on = nullptr);

}  // namespace waywright
