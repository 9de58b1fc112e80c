// Body of the kernels; included once for each instruction set. No function of the standard library is called here: an inline one, compiled for
// a wide instruction set, could be the copy that the linker keeps for everyone.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "waywright/core/lanes/sin_cos.inl"
#include "waywright/geometry/lanes/kernels.hpp"

#define WAYWRIGHT_INLINE inline __attribute__((always_inline))

namespace waywright::segment_lanes {
namespace {

#include "waywright/core/lanes/doubles.inl"

WAYWRIGHT_INLINE Doubles unit_clamped(Doubles t) { return lesser(greater(t, Doubles{}), Doubles{} + 1.0); }

/// Squared distance of boxes to the outline's.
WAYWRIGHT_INLINE Doubles squared_gap(const Outline& o, Doubles low_x, Doubles low_y, Doubles high_x, Doubles high_y) {
  const Doubles dx = greater(greater(low_x - o.high_x, o.low_x - high_x), Doubles{});
  const Doubles dy = greater(greater(low_y - o.high_y, o.low_y - high_y), Doubles{});
  return dx * dx + dy * dy;
}

WAYWRIGHT_INLINE Edge edge(const Outline& o, int i) {
  if (i < Outline::capacity) return o.ready[i];
  const int next = i + 1 < o.corners ? i + 1 : 0;
  const double x = o.corner[2 * i], y = o.corner[2 * i + 1];
  const double dx = o.corner[2 * next] - x, dy = o.corner[2 * next + 1] - y;
  const double squared = dx * dx + dy * dy;
  return {x, y, dx, dy, squared > 0.0 ? 1.0 / squared : 0.0};
}

/// Both ends of an edge as its neighbours have them: what is decided by signs has to be decided alike on both sides of a corner.
struct Ends {
  double ax, ay, bx, by;
  double dx() const { return bx - ax; }
  double dy() const { return by - ay; }
};
WAYWRIGHT_INLINE Ends ends(const Outline& o, int i) {
  const int next = i + 1 < o.corners ? i + 1 : 0;
  return {o.corner[2 * i], o.corner[2 * i + 1], o.corner[2 * next], o.corner[2 * next + 1]};
}

/// Squared distance of points to the area; 0 inside.
template <Shape shape>
WAYWRIGHT_INLINE Doubles to_area(const Outline& o, Doubles x, Doubles y) {
  if constexpr (shape == Shape::rectangle) {
    const Edge& e = o.ready[0];
    const Edge& f = o.ready[1];
    const Doubles rx = x - e.from_x, ry = y - e.from_y;
    const Doubles u = (rx * e.along_x + ry * e.along_y) * e.inverse, v = (rx * f.along_x + ry * f.along_y) * f.inverse;
    const Doubles along = unit_clamped(u), across = unit_clamped(v);
    const Doubles off_x = rx - along * e.along_x - across * f.along_x, off_y = ry - along * e.along_y - across * f.along_y;
    const Doubles squared = off_x * off_x + off_y * off_y;
    const Mask is_inside = (u == along) & (v == across);  // what is left over there is rounding
    return is_inside ? Doubles{} : squared;
  }
  if (o.edges == 0) {
    const Doubles dx = x - o.corner[0], dy = y - o.corner[1];
    return dx * dx + dy * dy;
  }
  Doubles least = Doubles{} + __builtin_inf();
  Doubles least_left = Doubles{} + __builtin_inf();  // least cross product: not negative inside
  Mask is_odd{};
  for (int i = 0; i < o.edges; ++i) {
    const Edge e = edge(o, i);
    const Doubles rx = x - e.from_x, ry = y - e.from_y;
    const Doubles along = unit_clamped((rx * e.along_x + ry * e.along_y) * e.inverse);
    const Doubles off_x = rx - along * e.along_x, off_y = ry - along * e.along_y;
    least = lesser(least, off_x * off_x + off_y * off_y);
    const Ends own = ends(o, i);
    if constexpr (shape == Shape::convex) {
      least_left = lesser(least_left, own.dx() * (y - own.ay) - own.dy() * (x - own.ax));
    } else if (o.edges > 2) {
      // A ray to the right crosses the edge.
      const Mask straddles = (own.ay > y) ^ (own.by > y);
      const Mask is_left = (x - own.ax) * own.dy() < (y - own.ay) * own.dx();
      is_odd ^= straddles & (own.dy() > 0.0 ? is_left : ~is_left);
    }
  }
  if constexpr (shape == Shape::convex) return least_left >= 0.0 ? Doubles{} : least;
  return is_odd ? Doubles{} : least;
}

/// Which segments cross an edge. (Those that lie along one have distance 0 of the ends.)
WAYWRIGHT_INLINE Mask crossing(const Outline& o, Doubles ax, Doubles ay, Doubles bx, Doubles by) {
  const Doubles dx = bx - ax, dy = by - ay;
  Mask crosses{};
  for (int i = 0; i < o.edges; ++i) {
    const Ends e = ends(o, i);
    const Mask from_left = dx * (e.ay - ay) - dy * (e.ax - ax) > 0.0;
    const Mask to_left = dx * (e.by - ay) - dy * (e.bx - ax) > 0.0;
    const Mask a_left = e.dx() * (ay - e.ay) - e.dy() * (ax - e.ax) > 0.0;
    const Mask b_left = e.dx() * (by - e.ay) - e.dy() * (bx - e.ax) > 0.0;
    crosses |= (from_left ^ to_left) & (a_left ^ b_left);
  }
  return crosses;
}

template <Shape shape>
WAYWRIGHT_INLINE void look(const Block& block, std::uint32_t first, const Outline& o, std::uint32_t without, Found& found) {
  const double before = found.squared;  // for all eight, however many are looked at together: the same ones on every machine
  for (int k = 0; k < width; k += native) {
    const Doubles ax = load(block.ax + k), ay = load(block.ay + k), bx = load(block.bx + k), by = load(block.by + k);
    const Doubles gap = squared_gap(o, lesser(ax, bx), lesser(ay, by), greater(ax, bx), greater(ay, by));
    unsigned wanted = less_bits(gap, Doubles{} + before);
    if (wanted == 0) continue;
    Doubles squared = to_area<shape>(o, ax, ay);
    if (!block.ends_begin_others) squared = lesser(squared, to_area<shape>(o, bx, by));
    const Doubles dx = bx - ax, dy = by - ay, inverse = load(block.inverse + k);
    // Corners beside a segment; beyond its ends these are what is nearest.
    const Doubles length2 = dx * dx + dy * dy;
    Doubles beside = Doubles{} + __builtin_inf();
    for (int c = 0; c < o.corners; ++c) {
      const Doubles rx = o.corner[2 * c] - ax, ry = o.corner[2 * c + 1] - ay;
      const Doubles along = rx * dx + ry * dy, across = rx * dy - ry * dx;
      const Mask is_beside = (along > 0.0) & (along < length2);
      beside = lesser(beside, is_beside ? across * across : Doubles{} + __builtin_inf());
    }
    squared = lesser(beside * inverse, squared);  // of a point that is not a number: the second stays
    if (o.edges > 0 && bits(gap <= 0.0) != 0) squared = ((gap <= 0.0) & crossing(o, ax, ay, bx, by)) ? Doubles{} : squared;
    wanted &= less_bits(squared, Doubles{} + before);
    for (; wanted != 0; wanted &= wanted - 1) {
      const int lane = __builtin_ctz(wanted);
      if (!(squared[lane] < found.squared) || block.source[k + lane] == without) continue;
      found = {squared[lane], first + static_cast<std::uint32_t>(k + lane)};
    }
  }
}

template <Shape shape>
Found nearest_of(const Tree& tree, const Outline& o, double best, std::uint32_t without, bool any, std::uint32_t hint) {
  struct Waiting {
    double gap;
    std::uint32_t node;
  };
  Waiting waiting[deepest];
  int count = 0;
  Found found{best, none};
  const std::uint32_t seen = hint == none ? none : hint / width;
  if (seen != none) {
    look<shape>(tree.blocks[seen], seen * width, o, without, found);
    if (found.squared == 0.0 || (any && found.segment != none)) return found;
  }
  waiting[count++] = {0.0, 0};
  while (count > 0) {
    const Waiting next = waiting[--count];
    if (next.gap >= found.squared) continue;
    const Node& node = tree.nodes[next.node];
    alignas(64) double gaps[fan];
    unsigned wanted = 0;
    for (int k = 0; k < node.count; k += native) {
      const Boxes& b = node.boxes[k / width];
      const int i = k % width;
      const Doubles gap = squared_gap(o, load(b.low_x + i), load(b.low_y + i), load(b.high_x + i), load(b.high_y + i));
      __builtin_memcpy(gaps + k, &gap, sizeof gap);
      wanted |= less_bits(gap, Doubles{} + found.squared) << k;
    }
    if (wanted == 0) continue;
    // The nearest comes first: of the others few are wanted then. Where something near is known they are few anyway.
    int nearest = __builtin_ctz(wanted);
    for (unsigned others = found.segment == none ? wanted & (wanted - 1) : 0; others != 0; others &= others - 1) {
      const int k = __builtin_ctz(others);
      nearest = gaps[k] < gaps[nearest] ? k : nearest;
    }
    wanted &= ~(1U << nearest);
    if (!node.holds_blocks) {
      for (; wanted != 0; wanted &= wanted - 1) {
        const int k = __builtin_ctz(wanted);
        waiting[count++] = {gaps[k], node.child[k]};
      }
      waiting[count++] = {gaps[nearest], node.child[nearest]};
      continue;
    }
    for (int k = nearest;; wanted &= wanted - 1) {
      if (gaps[k] < found.squared && node.child[k] != seen) {
        look<shape>(tree.blocks[node.child[k]], node.child[k] * width, o, without, found);
        if (found.squared == 0.0 || (any && found.segment != none)) return found;
      }
      if (wanted == 0) break;
      k = __builtin_ctz(wanted);
    }
  }
  return found;
}

Found nearest(const Tree& tree, const Outline& o, double best, std::uint32_t without, bool any, std::uint32_t hint) {
  switch (o.shape) {
    case Shape::rectangle: return nearest_of<Shape::rectangle>(tree, o, best, without, any, hint);
    case Shape::convex: return nearest_of<Shape::convex>(tree, o, best, without, any, hint);
    case Shape::any: break;
  }
  return nearest_of<Shape::any>(tree, o, best, without, any, hint);
}

void sin_cos(const double* angle, double* sin, double* cos) {
  eight_lanes::Doubles x;
  __builtin_memcpy(&x, angle, sizeof x);
  const eight_lanes::SinCosLanes of = eight_lanes::sin_cos(x);
  __builtin_memcpy(sin, &of.sin, sizeof x);
  __builtin_memcpy(cos, &of.cos, sizeof x);
}

}  // namespace
}  // namespace waywright::segment_lanes

#undef WAYWRIGHT_INLINE
