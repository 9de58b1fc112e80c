// What keeping a tree of RRT* is worth when a box appears on its way: lines tested, CPU time and length, against a new tree.
// usage: kept_trees [SEEDS]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <vector>

#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/tree/kept_tree.hpp"

namespace waywright::bench {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t samples = 10'000;
constexpr double driven = 8.0, ahead = 4.0, side = 1.5;  // m: when the box appears, how far away, how large

double now_ms() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Vec2 along(const std::vector<Vec2>& way, double metres) {
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const double here = distance(way[i], way[i + 1]);
    if (here >= metres && here > 0.0) return way[i] + (metres / here) * (way[i + 1] - way[i]);
    metres -= here;
  }
  return way.back();
}

struct Row {
  std::vector<double> lines, ms, over;
  void add(double n, double t, double o) {
    lines.push_back(n);
    ms.push_back(t);
    over.push_back(o);
  }
  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
  }
};

void run_map(const Scenario& scenario, const char* name, int seeds) {
  const Problem before = Problem::prepare(scenario).value();
  const PlaneSpace old_space{before};
  const Vec2 goal = before.goal().position();
  Row anew, kept, grown;
  std::vector<double> share, prepared;
  int runs = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Budget budget;
    PlaneTree tree;
    tree.grow(old_space, {.samples = samples}, before.start().position(), {{goal}}, static_cast<std::uint64_t>(seed), budget, no_limit);
    if (!tree.is_found()) continue;
    const Vec2 root = along(tree.way(), driven), middle = along(tree.way(), driven + ahead);
    const Ring box = rectangle(middle - Vec2{0.5 * side, 0.5 * side}, middle + Vec2{0.5 * side, 0.5 * side});
    Scenario changed = scenario;
    changed.map.obstacles.push_back(box);
    changed.start = make_pose(root, 0.0);
    const Problem after = Problem::prepare(changed).value();
    double begin = now_ms();
    const PlaneSpace space{after};
    prepared.push_back(now_ms() - begin);
    if (!space.is_free(root) || !space.is_free(goal)) continue;
    const LeastLength least = least_length(space, budget);
    if (least.is_unreachable) continue;
    Map only;
    only.obstacles = {box};
    World appeared{only};
    appeared.build();

    PlaneTree other;
    begin = now_ms();
    other.grow(space, {.samples = samples}, root, {{goal}}, static_cast<std::uint64_t>(seed), budget, no_limit);
    const double anew_ms = now_ms() - begin;
    KeptTree upkeep;
    upkeep.take(tree);
    begin = now_ms();
    upkeep.carry_over(space, appeared, root, 1.0, {{goal}});
    const double kept_ms = now_ms() - begin;
    const double kept_lines = static_cast<double>(upkeep.statistics().lines + upkeep.statistics().near);
    PlaneTree as_is, more;
    as_is.grow_on(upkeep.nodes(), space, {.samples = 0}, {{goal}}, static_cast<std::uint64_t>(seed), budget, no_limit);
    begin = now_ms();
    more.grow_on(upkeep.nodes(), space, {.samples = samples / 10}, {{goal}}, static_cast<std::uint64_t>(seed), budget, no_limit);
    const double more_ms = now_ms() - begin;
    if (!other.is_found() || !as_is.is_found() || !more.is_found()) {
      fmt::print("{} seed {}: anew {}, kept {}, grown {}\n", name, seed, other.is_found(), as_is.is_found(), more.is_found());
      continue;
    }
    ++runs;
    share.push_back(100.0 * static_cast<double>(upkeep.statistics().cut) / static_cast<double>(tree.size()));
    anew.add(static_cast<double>(other.statistics().edges), anew_ms, other.length() / least.metres - 1.0);
    kept.add(kept_lines, kept_ms, as_is.length() / least.metres - 1.0);
    grown.add(kept_lines + static_cast<double>(more.statistics().edges), kept_ms + more_ms, more.length() / least.metres - 1.0);
  }
  fmt::print("| {} | {} | {:.1f} % | {:.1f} |", name, runs, Row::median(share), Row::median(prepared));
  for (const Row* row : {&anew, &kept, &grown}) fmt::print(" {:.0f}, {:.1f}, {:.2f} % |", Row::median(row->lines), Row::median(row->ms), 100.0 * Row::median(row->over));
  fmt::print("\n");
}

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  using namespace waywright;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  fmt::print("{} samples; a box of {} m appears {} m ahead after {} m. Medians: lines tested, CPU ms, length over the shortest possible\n\n", bench::samples, bench::side, bench::ahead, bench::driven);
  fmt::print("| map | runs | edges cut | space, ms | anew | kept as it is | kept, and {} samples more |\n| --- | --- | --- | --- | --- | --- | --- |\n", bench::samples / 10);
  for (const char* name : {"WOA-1", "WOA-2", "WOA-3", "WOA-4", "WOA-5"}) {
    Scenario s;
    s.map = whale_map(name)->map;
    s.vehicle.footprint = {{}, 0.2};
    s.vehicle.drive = Differential{0.4};
    s.start = {1.5, 1.5, 0.0};
    s.mission = Pose{18.5, 18.5, 0.0};
    bench::run_map(s, name, seeds);
  }
}
