// Trees, whales and the visibility graph: our RRT* against OMPL's on the same check, the whale optimisation algorithm against plain loops, in one run on one thread.
// usage: trees [Google Benchmark's options]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <limits>

#include "bench/plane_scene.hpp"
#include "bench/yardstick/ompl_plane.hpp"
#include "bench/yardstick/plain_whale.hpp"
#include "waywright/core/random.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"
#include "waywright/planner/tree/plane_tree.hpp"
#include "waywright/planner/tree/whale_refinement.hpp"
#include "waywright/planner/tree/whale_steering.hpp"

namespace waywright::bench {
namespace {

constexpr int seeds = 20;
constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

void prepare_space(benchmark::State& state) {
  const Problem& problem = scene().problem;
  for (auto _ : state) benchmark::DoNotOptimize(PlaneSpace{problem}.free_area());
}
BENCHMARK(prepare_space)->Unit(benchmark::kMillisecond);

void rrt_star_ours(benchmark::State& state) {
  PlaneTree tree;
  std::uint64_t seed = 0;
  double metres = 0.0;
  for (auto _ : state) {
    Budget budget;
    tree.grow(scene().space, {.samples = state.range(0)}, start, {{goal}}, 1 + seed++ % seeds, budget, no_limit);
    benchmark::DoNotOptimize(tree.length());
  }
  int found = 0;
  double nodes = 0.0;
  for (std::uint64_t s = 1; s <= seeds; ++s) {
    Budget budget;
    tree.grow(scene().space, {.samples = state.range(0)}, start, {{goal}}, s, budget, no_limit);
    nodes += static_cast<double>(tree.size()) / seeds;
    if (!tree.is_found()) continue;
    ++found;
    metres += tree.length();
  }
  state.counters["mean_m"] = found > 0 ? metres / found : 0.0;
  state.counters["found"] = found;
  state.counters["nodes"] = nodes;
}
BENCHMARK(rrt_star_ours)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// same 1: the places that ours draws, in the same order, and our radius; 0: as it comes, with its own.
void rrt_star_ompl(benchmark::State& state) {
  std::uint32_t seed = 0;
  const auto samples = static_cast<unsigned>(state.range(0));
  const bool is_same = state.range(1) != 0;
  const auto run = [&](std::uint32_t s, bool counts_nodes) { return yardstick::rrt_star(scene().space, start, goal, samples, 1.0, s, is_same, counts_nodes); };
  for (auto _ : state) benchmark::DoNotOptimize(run(1 + seed++ % seeds, false).length);
  int found = 0;
  double metres = 0.0, nodes = 0.0;
  for (std::uint32_t s = 1; s <= seeds; ++s) {
    const yardstick::OmplPlaneRun one = run(s, true);
    found += one.length > 0.0 ? 1 : 0;
    metres += one.length;
    nodes += static_cast<double>(one.nodes) / seeds;
  }
  state.counters["mean_m"] = found > 0 ? metres / found : 0.0;
  state.counters["found"] = found;
  state.counters["nodes"] = nodes;
}
BENCHMARK(rrt_star_ompl)->ArgNames({"", "same"})->ArgsProduct({{1000, 10000}, {0, 1}})->Unit(benchmark::kMillisecond);

/// With the publication's radius, its extensions to the samples or aimed by whales.
void grow_published(benchmark::State& state, bool ends_with_first, std::int64_t samples) {
  const PlaneScene& on = *plane_scenes()[static_cast<std::size_t>(state.range(0))];
  const bool is_local = state.range(1) != 0;
  PlaneTree tree;
  std::uint64_t seed = 0;
  double drawn = 0.0;
  const auto grow = [&](std::uint64_t s) {
    Budget budget;
    WhaleSteering steering{on.space, {}};
    tree.grow(on.space, {.samples = samples, .radius = 1.5, .first_path = ends_with_first, .straight_first = false}, on.from(), {{on.to()}}, s, budget, no_limit, is_local ? &steering : nullptr);
    benchmark::DoNotOptimize(tree.length());
  };
  for (auto _ : state) grow(1 + seed++ % seeds);
  for (std::uint64_t s = 1; s <= seeds; ++s) {
    grow(s);
    drawn += static_cast<double>(tree.statistics().samples) / seeds;
  }
  state.SetLabel(on.name);
  state.counters["samples"] = drawn;
}
void first_path(benchmark::State& state) { grow_published(state, true, 10'000); }
BENCHMARK(first_path)->ArgNames({"map", "local"})->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}})->Unit(benchmark::kMillisecond);
void whole_tree(benchmark::State& state) { grow_published(state, false, 2000); }
BENCHMARK(whole_tree)->ArgNames({"map", "local"})->ArgsProduct({{0, 1, 2, 3, 4, 5}, {0, 1}})->Unit(benchmark::kMillisecond);

/// A way of 20 points through the scene.
std::vector<Vec2> way() {
  PlaneTree tree;
  for (std::uint64_t seed = 1;; ++seed) {
    Budget budget;
    tree.grow(scene().space, {.step = 1.9, .radius = 1.5, .first_path = true}, start, {{goal}}, seed, budget, no_limit);
    if (tree.way().size() == 20) return tree.way();
  }
}

void whale_on_a_way_ours(benchmark::State& state) {
  const std::vector<Vec2> points = way();
  WhaleRefinement refinement;
  std::uint64_t seed = 0;
  double metres = 0.0;
  for (auto _ : state) {
    Budget budget;
    metres = length_of_way(refinement.refined(points, scene().space, {}, 1 + seed++ % 200, budget));
  }
  state.counters["before_m"] = length_of_way(points);
  metres = 0.0;
  for (std::uint64_t s = 1; s <= 200; ++s) {
    Budget budget;
    metres += length_of_way(refinement.refined(points, scene().space, {}, s, budget)) / 200.0;
  }
  state.counters["mean_m"] = metres;
}
BENCHMARK(whale_on_a_way_ours)->Unit(benchmark::kMicrosecond);

void whale_on_a_way_plain(benchmark::State& state) {
  std::vector<Eigen::Vector2d> points;
  for (const Vec2 p : way()) points.emplace_back(p.x, p.y);
  yardstick::WhaleScene plain;
  for (const Ring& ring : scene().problem.world().map().obstacles) {
    auto& polygon = plain.obstacles.emplace_back();
    for (const Vec2 p : ring) polygon.emplace_back(p.x, p.y);
  }
  plain.radius = scene().space.needed();
  unsigned seed = 0;
  for (auto _ : state) benchmark::DoNotOptimize(yardstick::whale_plain(plain, points, 10, 10, 2.5, 1 + seed++ % 200).length);
  double metres = 0.0;
  for (unsigned s = 1; s <= 200; ++s) metres += yardstick::whale_plain(plain, points, 10, 10, 2.5, s).length / 200.0;
  state.counters["mean_m"] = metres;
}
BENCHMARK(whale_on_a_way_plain)->Unit(benchmark::kMicrosecond);

void visibility_preparation(benchmark::State& state) {
  const PlaneSpace& space = scene().space;
  std::size_t tangents = 0;
  for (auto _ : state) {
    TangentGraph graph{space, space.needed(), space.needed() - 5e-4};
    graph.see_all();
    tangents = graph.tangents();
  }
  state.counters["tangents"] = static_cast<double>(tangents);
}
BENCHMARK(visibility_preparation)->Unit(benchmark::kMillisecond);

void visibility_query(benchmark::State& state) {
  const PlaneSpace& space = scene().space;
  TangentGraph graph{space, space.needed(), space.needed() - 5e-4};
  if (state.range(0) != 0) graph.see_all();
  Random random{3};
  std::vector<std::pair<Vec2, Vec2>> queries;
  while (queries.size() < 100) {
    const Vec2 a{random.uniform(0.5, 19.5), random.uniform(0.5, 19.5)}, b{random.uniform(0.5, 19.5), random.uniform(0.5, 19.5)};
    if (space.is_free(a) && space.is_free(b)) queries.emplace_back(a, b);
  }
  std::size_t i = 0;
  double metres = 0.0;
  for (auto _ : state) {
    Budget budget;
    const auto& [a, b] = queries[i++ % queries.size()];
    metres += graph.shortest(a, {{b}}, budget).way.length;
  }
  benchmark::DoNotOptimize(metres);
}
BENCHMARK(visibility_query)->ArgName("prepared")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace waywright::bench

BENCHMARK_MAIN();
