#include "waywright/planner/field/star_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double share = 0.6;        // of what is between (as squares), that the collar takes at most
constexpr double finest = 0.004;     // of the world's size, between places of others' rims that are looked at
constexpr double most_of_least = 0.9;  // of a boundary's least radius

}  // namespace

StarRounding::StarRounding(const Ring& star, Vec2 centre, bool is_boundary, const std::vector<Ring>& others) : star_{star, centre, 0.0, is_boundary}, is_boundary_{is_boundary} {
  const double least = star_.least_rim(), greatest = star_.greatest_rim();
  // room² that is there: the least of ±(|p − c|² − ρ²) at others.
  double free = is_boundary ? most_of_least * least * least / share : greatest * greatest / share;
  double size = greatest;
  for (const Ring& ring : others) {
    const Box box = bounding_box(ring);
    size = std::max(size, distance(box.low, box.high));
  }
  for (const Ring& ring : others) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const int steps = 1 + static_cast<int>(distance(a, b) / (finest * size));
      for (int k = 0; k < steps; ++k) {
        const Vec2 p = a + (static_cast<double>(k) / steps) * (b - a);
        if (p == centre) continue;
        const double rim = star_.rim(p).value, off = squared_norm(p - centre) - rim * rim;
        free = std::min(free, is_boundary ? -off : off);
      }
    }
  }
  room_ = std::sqrt(std::max(1e-12 * greatest * greatest, share * free));
  const double end = std::sqrt(is_boundary ? greatest * greatest - room_ * room_ : least * least + room_ * room_);
  disc_ = {centre, 0.5 * (end + (is_boundary ? greatest : least))};
}

PlaneImage StarRounding::at(Vec2 q) const {
  if (q == disc_.centre) return {q};
  const double r = distance(q, disc_.centre);
  const Dual rim = star_.rim(q), squared = rim * rim + constant(is_boundary_ ? -room_ * room_ : room_ * room_);
  if (is_boundary_ ? r * r <= squared.value : r * r >= squared.value) return {q};
  const Dual end = square_root(squared), x{q.x - disc_.centre.x, 1.0, 0.0}, y{q.y - disc_.centre.y, 0.0, 1.0}, far = square_root(x * x + y * y);
  const Dual stretch = (constant(disc_.radius) + (far - rim) * (end - constant(disc_.radius)) / (end - rim)) / far;
  const Dual to_x = stretch * x, to_y = stretch * y;
  return {disc_.centre + Vec2{to_x.value, to_y.value}, to_x.dx, to_x.dy, to_y.dx, to_y.dy};
}

Vec2 StarRounding::back(Vec2 q) const {
  if (q == disc_.centre) return q;
  const double r = distance(q, disc_.centre), rim = star_.rim(q).value, end = std::sqrt(rim * rim + (is_boundary_ ? -room_ * room_ : room_ * room_));
  if (is_boundary_ ? r <= end : r >= end) return q;
  const double was = rim + (r - disc_.radius) * (end - rim) / (end - disc_.radius);
  return disc_.centre + (was / r) * (q - disc_.centre);
}

bool StarRounding::holds(Vec2 q) const {
  if (q == disc_.centre) return !is_boundary_;
  const double r = distance(q, disc_.centre), rim = star_.rim(q).value;
  return is_boundary_ ? r >= rim : r <= rim;
}

}  // namespace waywright
