// The inner loops of distance questions: an outline against a tree of segments, eight side by side, compiled for each instruction set: the same
// bits from all, because each lane is plain IEEE arithmetic in a fixed order.
#pragma once

#include <cstdint>
#include <span>

namespace waywright::segment_lanes {

inline constexpr int width = 8;
inline constexpr std::uint32_t none = 0xFFFF'FFFFU;
inline constexpr int groups = 4;
inline constexpr int fan = groups * width;  ///< children of a node

/// Eight segments, the last one repeated where there are fewer.
struct alignas(64) Block {
  double ax[width], ay[width], bx[width], by[width];
  double inverse[width];         ///< 1 / squared length; 0 of a point
  std::uint32_t source[width];
  bool ends_begin_others;        ///< each b is the a of another segment of the same source: it need not be looked at twice
};

/// Boxes that are not there are inside out, infinitely far from everything.
struct alignas(64) Boxes {
  double low_x[width], low_y[width], high_x[width], high_y[width];
};

/// Children with their boxes: all blocks or all nodes, few mispredicted steps down instead of many.
struct Node {
  Boxes boxes[groups];
  std::uint32_t child[fan];
  int count;
  bool holds_blocks;
};

struct Tree {
  const Node* nodes = nullptr;   ///< the first is the root
  const Block* blocks = nullptr; ///< block i holds the segments from 8 i on
};
/// Nodes that wait at most, of a tree over 2³² segments: seven levels.
inline constexpr int deepest = 7 * fan;

struct Edge {
  double from_x, from_y, along_x, along_y, inverse;  // not set to 0 beforehand: that would take longer than making some
};

enum class Shape : std::uint8_t { any, convex, rectangle };

/// A closed outline made ready for many questions; one corner or two are a point or a segment.
struct Outline {
  static constexpr int capacity = 24;  ///< edges made beforehand; others are made each time: no outline needs memory of its own
  const double* corner;                ///< x, y of each, in turn
  int corners;
  int edges;                           ///< 0 of a point, 1 of a segment
  Shape shape;
  double low_x, low_y, high_x, high_y;
  Edge ready[capacity];
};

struct Found {
  double squared;         ///< m²; what was given where nothing is nearer
  std::uint32_t segment;  ///< none: nothing is nearer
};

struct Kernels {
  const char* name;
  /// Of eight angles, |angle| < 1e5: the bits that core/elementary gives.
  void (*sin_cos)(const double* angle, double* sin, double* cos);
  /// The segment nearest to the outline's area, if its squared distance is less than `best`; those of the source `without` left out.
  /// `any`: the first that is found to be nearer will do. `hint`: a segment that is likely to be near, or none: looked at first.
  Found (*nearest)(const Tree&, const Outline&, double best, std::uint32_t without, bool any, std::uint32_t hint);
};

/// All that this machine can run, slowest first; the last is the best.
std::span<const Kernels> available();
const Kernels& best();

}  // namespace waywright::segment_lanes
