// Navigation functions on worlds of discs: CPU time of a step and the error of the gradient against the number of obstacles; prints the table of docs/fields.md.
// usage: fields
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/planner/field/sphere_world.hpp"

namespace waywright::bench {
namespace {

SphereWorld discs(int n, Random& random) {
  const double size = 20.0 / std::sqrt(static_cast<double>(n) + 4.0);  // so that all find room
  SphereWorld world{{{0, 0}, 10}, {}};
  while (static_cast<int>(world.obstacles.size()) < n) {
    const Disc disc{random.uniform(0.0, 9.0) * unit(random.uniform(-pi, pi)), random.uniform(0.05, 0.15) * size};
    bool apart = norm(disc.centre) + disc.radius < 9.9 && distance(disc.centre, {9.5, 0}) > disc.radius + 0.2;
    for (const Disc& other : world.obstacles) apart = apart && distance(disc.centre, other.centre) > disc.radius + other.radius + 0.02;
    if (apart) world.obstacles.push_back(disc);
  }
  return world;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run() {
  fmt::print("| discs | ns a step | relative error of the gradient, median, greatest of 2000 | choosing κ, ms | κ that lead to the goal |\n| --- | --- | --- | --- | --- |\n");
  for (const int n : {1, 3, 10, 30, 100}) {
    Random random{static_cast<std::uint64_t>(n)};
    const SphereWorld world = discs(n, random);
    const NavigationFunction function{world, {9.5, 0}, 8.0};
    std::vector<Vec2> places;
    while (places.size() < 2000) {
      const Vec2 q{random.uniform(-10, 10), random.uniform(-10, 10)};
      if (function.distance_to_rim(q) > 0.05) places.push_back(q);
    }
    const double begin = seconds();
    double sum = 0.0;
    constexpr int rounds = 200;
    for (int k = 0; k < rounds; ++k) {
      for (const Vec2 q : places) sum += function.slope(q).x + function.distance_to_rim(q);
    }
    const double step = (seconds() - begin) / rounds / static_cast<double>(places.size());
    std::vector<double> errors;
    for (const Vec2 q : places) {
      constexpr double h = 1e-5;
      const Vec2 g = function.gradient(q), dx{h, 0}, dy{0, h};
      const Vec2 d{(function.value(q + dx) - function.value(q - dx)) / (2 * h), (function.value(q + dy) - function.value(q - dy)) / (2 * h)};
      // Where it is flat to the last digit differences tell nothing.
      if (norm(g) > 1e-6) errors.push_back(distance(g, d) / norm(g));
    }
    std::sort(errors.begin(), errors.end());
    const double chosen = seconds();
    const std::vector<double> kappas = kappas_that_lead_to_goal(world, {9.5, 0});
    const double took = seconds() - chosen;
    const std::string which = kappas.empty() ? "none shown" : kappas.front() > 20.0 ? fmt::format("{:g}", fmt::join(kappas, ", ")) : fmt::format("{} of the 19 up to 20", kappas.size());
    fmt::print("| {} | {:.0f} | {:.0e}, {:.0e} | {:.0f} | {} |\n", n, 1e9 * step, errors[errors.size() / 2], errors.back(), 1e3 * took, which);
    if (!std::isfinite(sum)) fmt::print("not finite\n");
  }
}

}  // namespace
}  // namespace waywright::bench

int main() {
  waywright::bench::run();
  return 0;
}
