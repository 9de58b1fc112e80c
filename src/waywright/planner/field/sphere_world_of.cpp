#include "waywright/planner/field/sphere_world_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double slack = 1.0 + 1e-12;

bool holds(const Disc& disc, Vec2 p) { return distance(disc.centre, p) <= disc.radius * slack; }

Disc through(Vec2 a, Vec2 b) { return {0.5 * (a + b), 0.5 * distance(a, b)}; }

Disc through(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 ab = b - a, ac = c - a;
  const double twice = 2.0 * cross(ab, ac);
  if (twice == 0.0) {  // on one line: the two farthest apart
    const Disc all[] = {through(a, b), through(a, c), through(b, c)};
    return *std::max_element(std::begin(all), std::end(all), [](const Disc& x, const Disc& y) { return x.radius < y.radius; });
  }
  const double b2 = squared_norm(ab), c2 = squared_norm(ac);
  const Vec2 to{(ac.y * b2 - ab.y * c2) / twice, (ab.x * c2 - ac.x * b2) / twice};
  return {a + to, norm(to)};
}

}  // namespace

// Welzl's idea without chance: whoever is outside lies on the rim of the circle of those before.
Disc enclosing_disc(const std::vector<Vec2>& p) {
  Disc disc{p.front(), 0.0};
  for (std::size_t i = 1; i < p.size(); ++i) {
    if (holds(disc, p[i])) continue;
    disc = {p[i], 0.0};
    for (std::size_t j = 0; j < i; ++j) {
      if (holds(disc, p[j])) continue;
      disc = through(p[i], p[j]);
      for (std::size_t k = 0; k < j; ++k) {
        if (!holds(disc, p[k])) disc = through(p[i], p[j], p[k]);
      }
    }
  }
  return disc;
}

tl::expected<CoveringWorld, std::string> covering_world(const PlaneSpace& space, Vec2 start, std::span<const Vec2> goals) {
  using tl::unexpected;
  const Map& map = space.problem().world().map();
  if (!map.grids.empty() || !map.lines.empty() || !map.points.empty()) return unexpected<std::string>{"walls, scan points and cells are no obstacles that a disc covers"};
  CoveringWorld covering;
  const double grown = space.needed();
  std::vector<Vec2> everything{start};
  everything.insert(everything.end(), goals.begin(), goals.end());
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    Disc disc = enclosing_disc(map.obstacles[i]);
    everything.push_back(disc.centre - Vec2{disc.radius, disc.radius});
    everything.push_back(disc.centre + Vec2{disc.radius, disc.radius});
    disc.radius += grown;
    covering.world.obstacles.push_back(disc);
    covering.names.push_back(fmt::format("obstacle {}", i));
  }
  Disc& outside = covering.world.outside;
  if (map.boundaries.empty()) {
    outside = enclosing_disc(everything);
    outside.radius = 1.5 * outside.radius + 4.0 * grown + 1.0;
  } else {
    outside.centre = enclosing_disc(map.boundaries.front()).centre;
    outside.radius = std::numeric_limits<double>::infinity();
    for (const Ring& ring : map.boundaries) {
      for (std::size_t k = 0; k < ring.size(); ++k) outside.radius = std::min(outside.radius, point_segment_distance(outside.centre, ring[k], ring[(k + 1) % ring.size()]));
      if (!contains(ring, outside.centre)) return unexpected{fmt::format("the middle of the boundary, ({:.3f}, {:.3f}), lies outside of it: no disc fills it", outside.centre.x, outside.centre.y)};
    }
    outside.radius -= grown;
    if (!(outside.radius > 0.0)) return unexpected<std::string>{"no disc is left inside the boundary"};
  }
  // What lies wholly beyond the outer disc is of no matter.
  for (std::size_t i = covering.names.size(); i-- > 0;) {
    const Disc& disc = covering.world.obstacles[i];
    if (distance(disc.centre, outside.centre) >= outside.radius + disc.radius) {
      covering.world.obstacles.erase(covering.world.obstacles.begin() + static_cast<std::ptrdiff_t>(i));
      covering.names.erase(covering.names.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  for (std::size_t i = 0; i < covering.names.size(); ++i) {
    const Disc& disc = covering.world.obstacles[i];
    if (distance(disc.centre, outside.centre) + disc.radius >= outside.radius) {
      return unexpected{fmt::format("the disc of {:.3f} m around {} reaches beyond the disc of {:.3f} m that fits into the boundary", disc.radius, covering.names[i], outside.radius)};
    }
    for (std::size_t k = 0; k < i; ++k) {
      const Disc& other = covering.world.obstacles[k];
      if (distance(disc.centre, other.centre) > disc.radius + other.radius) continue;
      return unexpected{fmt::format("the discs of {:.3f} and {:.3f} m around {} and {}, grown by the {:.3f} m that the vehicle needs, meet", other.radius, disc.radius, covering.names[k],
                                    covering.names[i], grown)};
    }
  }
  const NavigationFunction any{covering.world, goals.front(), 1.0};
  const auto reached = std::find_if(goals.begin(), goals.end(), [&](Vec2 goal) { return any.is_free(goal); });
  covering.goal = reached == goals.end() ? goals.front() : *reached;
  for (const auto& [what, place] : {std::pair{"start", start}, std::pair{goals.size() == 1 ? "goal" : "nearest place of the goal's region, like all others of it,", covering.goal}}) {
    const Vec2 at = place;  // a lambda of C++20 may not take a part of a binding, and clang 14 holds to that
    if (any.is_free(at)) continue;
    const auto within = std::find_if(covering.world.obstacles.begin(), covering.world.obstacles.end(), [&](const Disc& d) { return distance(d.centre, at) <= d.radius; });
    return unexpected{within == covering.world.obstacles.end()
                          ? fmt::format("the {} lies beyond the disc of {:.3f} m that fits into the boundary", what, outside.radius)
                          : fmt::format("the {} lies in the disc of {:.3f} m around {}", what, within->radius, covering.names[static_cast<std::size_t>(within - covering.world.obstacles.begin())])};
  }
  return covering;
}

}  // namespace waywright
