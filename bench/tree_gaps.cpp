// How much longer than the shortest way RRT*'s is, by samples: among 50 octagons and on the five maps of the RRT*-WOA publication. Prints the table of docs/trees.md.
// usage: tree_gaps [SEEDS]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "bench/plane_scene.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/tree/plane_tree.hpp"

int main(int argc, char** argv) {
  using namespace waywright;
  const int seeds = argc > 1 ? std::max(2, std::atoi(argv[1])) : 100;
  fmt::print("| scene | shortest, m | samples | ways found | mean gap, 95 % interval | of informed samples |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& scene : bench::plane_scenes()) {
    Budget budget;
    const double least = least_length(scene->space, budget).metres;
    for (const std::int64_t samples : {1000, 10'000}) {
      fmt::print("| {} | {:.3f} | {}", scene->name, least, samples);
      for (const bool informed : {false, true}) {
        PlaneTree tree;
        int found = 0;
        double sum = 0.0, squares = 0.0;
        for (int seed = 1; seed <= seeds; ++seed) {
          tree.grow(scene->space, {.samples = samples, .informed = informed}, scene->from(), {{scene->to()}}, static_cast<std::uint64_t>(seed), budget,
                    std::numeric_limits<std::int64_t>::max());
          if (!tree.is_found()) continue;
          const double gap = 100.0 * (tree.length() / least - 1.0);
          ++found;
          sum += gap;
          squares += gap * gap;
        }
        const double mean = found > 0 ? sum / found : 0.0;
        const double half = found > 1 ? 1.96 * std::sqrt(std::max(0.0, (squares - found * mean * mean) / (found - 1)) / found) : 0.0;
        if (!informed) fmt::print(" | {} of {}", found, seeds);
        fmt::print(" | {:.2f} ± {:.2f} %", mean, half);
      }
      fmt::print(" |\n");
    }
  }
  return 0;
}
