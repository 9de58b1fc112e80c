#include "waywright/map/field_worlds.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr int corners = 96;
constexpr double world_radius = 5.0;  // m

/// The radius at an angle, of a curve about its centre.
template <class Radius>
Ring round_ring(Vec2 centre, Radius&& radius) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = i * (two_pi / corners);
    ring.push_back(centre + radius(angle) * unit(angle));
  }
  return ring;
}
Ring disc(Vec2 centre, double radius) {
  return round_ring(centre, [=](double) { return radius; });
}
/// Touches the circle from outside with the middles of its edges.
Ring disc_around(Vec2 centre, double radius) { return disc(centre, radius / sin_cos(pi / corners).cos); }

double fourth(double x) { return x * x * x * x; }
double rounded_box(double angle) {
  const SinCos a = sin_cos(angle);
  return 1.0 / std::sqrt(std::sqrt(fourth(std::abs(a.cos) / 0.9) + fourth(std::abs(a.sin) / 0.55)));
}
double flower(double angle, double size, double depth, int petals) { return size * (1.0 + depth * sin_cos(petals * angle).cos); }

const Vec2 three[] = {{-1.5, 1.3}, {0.2, -1.6}, {1.9, 1.2}};
const std::vector<PublishedTask> behind_and_between{{{-3.6, -2.0}, {3.4, 2.6}}, {{-3.6, -2.0}, {0.2, 0.7}}};

std::vector<FieldWorld> worlds() {
  std::vector<FieldWorld> all;
  const auto add = [&](const char* name, const char* about, Ring boundary, std::vector<Ring> obstacles, std::vector<PublishedTask> tasks) {
    FieldWorld world{name, about, {}, std::move(tasks)};
    world.map.boundaries = {std::move(boundary)};
    world.map.obstacles = std::move(obstacles);
    all.push_back(std::move(world));
  };
  const Ring hall = rectangle({0, 0}, {10, 10});
  add("APF-1", "polygons and a disc", hall,
      {{{2.0, 1.5}, {3.2, 1.2}, {3.6, 2.2}, {2.6, 2.8}},
       {{4.6, 4.2}, {5.8, 3.6}, {6.4, 4.6}, {5.6, 5.6}, {4.8, 5.2}},
       {{1.6, 5.4}, {2.8, 5.0}, {3.0, 6.4}, {1.8, 6.8}},
       {{6.8, 7.4}, {7.8, 6.8}, {8.4, 7.8}, {7.4, 8.6}},
       {{6.6, 1.4}, {8.0, 1.6}, {7.8, 2.8}, {6.8, 2.6}},
       disc({4.4, 7.8}, 0.6)},
      {{{0.8, 0.8}, {9.2, 9.2}}});
  add("APF-2", "a U that opens to the left", hall, {rectangle({5.0, 3.0}, {5.4, 7.0}), rectangle({3.0, 6.6}, {5.0, 7.0}), rectangle({3.0, 3.0}, {5.0, 3.4})},
      {{{1.0, 5.0}, {8.5, 5.0}}, {{1.0, 7.6}, {8.5, 6.8}}, {{1.0, 1.5}, {8.5, 4.0}}});
  add("NF-TWO", "two discs", disc_around({0, 0}, world_radius), {disc({0, 0.9}, 0.7), disc({0, -0.9}, 0.7)}, {{{-3, 0}, {3, 0}}, {{-3, 0.3}, {3, 0}}});
  add("NF-S3", "three discs", disc_around({0, 0}, world_radius), {disc(three[0], 0.8), disc(three[1], 1.0), disc(three[2], 0.7)}, behind_and_between);
  add("NF-ST", "three stars", disc_around({0, 0}, world_radius),
      {round_ring(three[0], rounded_box), round_ring(three[1], [](double a) { return flower(a, 0.85, 0.3, 5); }), round_ring(three[2], [](double a) { return flower(a, 0.6, 0.25, 3); })},
      behind_and_between);
  return all;
}

const std::vector<FieldWorld>& all_worlds() {
  static const std::vector<FieldWorld> all = worlds();
  return all;
}

}  // namespace

const std::vector<std::string>& field_world_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const FieldWorld& world : all_worlds()) all.push_back(world.name);
    return all;
  }();
  return names;
}

std::optional<FieldWorld> field_world(std::string_view name) {
  const auto& all = all_worlds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const FieldWorld& world) { return world.name == name; });
  if (found == all.end()) return std::nullopt;
  return *found;
}

}  // namespace waywright
