#include "waywright/geometry/convex_partition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace waywright {
namespace {

using Triangle = std::array<std::size_t, 3>;
using Edge = std::pair<std::size_t, std::size_t>;
constexpr int passes = 200;               // of flips; they end by themselves but for rounding
constexpr double straight = 1e-9;         // rad: less of a turn is none
constexpr double alike = 1e-12;           // of what decides a flip: less is rounding

double turn(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// To the left by more than a hair.
bool turns_left(Vec2 a, Vec2 b, Vec2 c) { return turn(a, b, c) > straight * norm(b - a) * norm(c - b); }

bool in_triangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) { return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0; }

std::optional<std::vector<Triangle>> triangles_of(const Ring& ring, const std::function<bool()>& stops) {
  std::vector<std::size_t> rest(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) rest[i] = i;
  std::vector<Triangle> all;
  while (rest.size() > 3) {
    if (stops && stops()) return std::nullopt;
    const std::size_t n = rest.size();
    const auto corner = [&](std::size_t i) { return ring[rest[i % n]]; };
    // Only corners that turn inwards can lie in an ear.
    std::vector<std::size_t> inward;
    for (std::size_t i = 0; i < n; ++i) {
      if (turn(corner(i + n - 1), corner(i), corner(i + 1)) <= 0.0) inward.push_back(i);
    }
    const auto is_ear = [&](std::size_t i) {
      const Vec2 a = corner(i + n - 1), b = corner(i), c = corner(i + 1);
      if (turn(a, b, c) <= 0.0) return false;
      return std::none_of(inward.begin(), inward.end(), [&](std::size_t k) {
        const Vec2 p = corner(k);
        return p != a && p != b && p != c && in_triangle(p, a, b, c);
      });
    };
    std::size_t ear = 0;
    while (ear < n && !is_ear(ear)) ++ear;
    if (ear == n) return std::nullopt;
    all.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  all.push_back({rest[0], rest[1], rest[2]});
  return all;
}

/// Does d lie in the circle through a, b, c (counter-clockwise)?
bool in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 u = a - d, v = b - d, w = c - d;
  const double uu = squared_norm(u), vv = squared_norm(v), ww = squared_norm(w);
  const double value = uu * cross(v, w) - vv * cross(u, w) + ww * cross(u, v);
  const double size = uu * (std::abs(v.x * w.y) + std::abs(v.y * w.x)) + vv * (std::abs(u.x * w.y) + std::abs(u.y * w.x)) + ww * (std::abs(u.x * v.y) + std::abs(u.y * v.x));
  return value > alike * size;
}

Edge edge_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Turned until its first edge is the one between a and b.
Triangle turned_to(const Triangle& t, const Edge& edge) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (edge_of(t[k], t[(k + 1) % 3]) == edge) return {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  }
  return t;
}

std::map<Edge, std::vector<std::size_t>> beside(const std::vector<Triangle>& triangles) {
  std::map<Edge, std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) all[edge_of(triangles[i][k], triangles[i][(k + 1) % 3])].push_back(i);
  }
  return all;
}

void flip(const Ring& ring, std::vector<Triangle>& triangles) {
  for (int pass = 0; pass < passes; ++pass) {
    bool is_done = true;
    std::vector<bool> touched(triangles.size(), false);
    for (const auto& [edge, sides] : beside(triangles)) {
      if (sides.size() != 2 || touched[sides[0]] || touched[sides[1]]) continue;
      const Triangle s = turned_to(triangles[sides[0]], edge), t = turned_to(triangles[sides[1]], edge);
      const std::size_t a = s[0], b = s[1], c = s[2], d = t[2];  // c left of a → b, d right of it
      if (turn(ring[d], ring[b], ring[c]) <= 0.0 || turn(ring[c], ring[a], ring[d]) <= 0.0 || !in_circle(ring[a], ring[b], ring[c], ring[d])) continue;
      triangles[sides[0]] = {c, a, d};
      triangles[sides[1]] = {d, b, c};
      touched[sides[0]] = touched[sides[1]] = true;
      is_done = false;
    }
    if (is_done) return;
  }
}

/// The cycle without its edge from a to b, from b on to a.
std::vector<std::size_t> opened(const std::vector<std::size_t>& cycle, std::size_t a, std::size_t b) {
  const std::size_t n = cycle.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (cycle[i] != a || cycle[(i + 1) % n] != b) continue;
    std::vector<std::size_t> open;
    for (std::size_t k = 1; k <= n; ++k) open.push_back(cycle[(i + k) % n]);
    return open;
  }
  return {};
}

}  // namespace

std::optional<ConvexPartition> convex_partition(const Ring& ring, const std::function<bool()>& stops) {
  if (ring.size() < 3) return std::nullopt;
  auto triangles = triangles_of(ring, stops);
  if (!triangles) return std::nullopt;
  flip(ring, *triangles);
  struct Diagonal {
    double length = 0.0;
    Edge edge;
    std::size_t one = 0, other = 0;
  };
  std::vector<Diagonal> diagonals;
  for (const auto& [edge, sides] : beside(*triangles)) {
    if (sides.size() == 2) diagonals.push_back({distance(ring[edge.first], ring[edge.second]), edge, sides[0], sides[1]});
  }
  std::stable_sort(diagonals.begin(), diagonals.end(), [](const Diagonal& a, const Diagonal& b) { return a.length > b.length; });
  std::vector<std::vector<std::size_t>> cycles;
  std::vector<std::size_t> now(triangles->size());  // which cycle a triangle has become part of
  for (std::size_t i = 0; i < triangles->size(); ++i) {
    cycles.emplace_back((*triangles)[i].begin(), (*triangles)[i].end());
    now[i] = i;
  }
  ConvexPartition partition;
  std::vector<Diagonal> kept;
  for (const Diagonal& d : diagonals) {
    const std::size_t one = now[d.one], other = now[d.other];
    auto [a, b] = d.edge;
    auto first = opened(cycles[one], a, b);
    if (first.empty()) {
      std::swap(a, b);
      first = opened(cycles[one], a, b);
    }
    const auto second = opened(cycles[other], b, a);  // from a on to b
    if (first.size() < 3 || second.size() < 3) return std::nullopt;
    // b … a of the one, then a … b of the other.
    const bool is_convex_at_a = turns_left(ring[first[first.size() - 2]], ring[a], ring[second[1]]);
    const bool is_convex_at_b = turns_left(ring[second[second.size() - 2]], ring[b], ring[first[1]]);
    if (!is_convex_at_a || !is_convex_at_b) {
      kept.push_back(d);
      continue;
    }
    first.insert(first.end(), second.begin() + 1, second.end() - 1);
    cycles[one] = std::move(first);
    cycles[other].clear();
    for (std::size_t& n : now) n = n == other ? one : n;
  }
  std::vector<std::size_t> number(cycles.size());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    if (cycles[i].empty()) continue;
    number[i] = partition.parts.size();
    partition.parts.push_back(cycles[i]);
  }
  for (const Diagonal& d : kept) {
    const std::size_t one = number[now[d.one]], other = number[now[d.other]];
    const auto [a, b] = d.edge;
    const bool is_left = !opened(partition.parts[one], a, b).empty();
    partition.cuts.push_back({a, b, is_left ? one : other, is_left ? other : one});
  }
  return partition;
}

}  // namespace waywright
