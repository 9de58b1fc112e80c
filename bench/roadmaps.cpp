// Roadmaps in the plane: when lines are tested, and how long diagrams take to be made and searched, in one run on one thread.
// usage: roadmaps_bench [Google Benchmark's options]
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>

#include "bench/plane_scene.hpp"
#include "waywright/core/random.hpp"
#include "waywright/geometry/voronoi.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"
#include "waywright/planner/roadmap/voronoi_roadmap.hpp"

namespace waywright::bench {
namespace {

constexpr int seeds = 20;
constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

/// Drawing, and lines tested when the search takes them.
void prm_lazy(benchmark::State& state) {
  double lines = 0.0, metres = 0.0;
  int found = 0;
  const auto once = [&](std::uint64_t seed) {
    Budget budget;
    const ProbabilisticRoadmap roadmap{scene().space, {.samples = state.range(0)}, seed, budget};
    return roadmap.shortest(start, {{goal}}, budget, no_limit);
  };
  std::uint64_t seed = 0;
  for (auto _ : state) benchmark::DoNotOptimize(once(1 + seed++ % seeds));
  for (std::uint64_t s = 1; s <= seeds; ++s) {
    const RoadmapAnswer answer = once(s);
    lines += static_cast<double>(answer.lines) / seeds;
    if (answer.ended != RoadmapEnd::found) continue;
    ++found;
    metres += answer.length;
  }
  Budget budget;
  state.counters["lines"] = lines;
  state.counters["found"] = found;
  state.counters["times_least"] = found > 0 ? metres / found / least_length(scene().space, budget).metres : 0.0;
}
BENCHMARK(prm_lazy)->Arg(300)->Arg(1000)->Arg(3000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Drawing, and every line tested; without a search.
void prm_all_lines(benchmark::State& state) {
  std::uint64_t seed = 0;
  double lines = 0.0;
  for (auto _ : state) {
    Budget budget;
    const ProbabilisticRoadmap roadmap{scene().space, {.samples = state.range(0)}, 1 + seed++ % seeds, budget};
    std::int64_t tested = 0, free = 0;
    for (std::uint32_t i = 0; i < roadmap.size(); ++i) {
      for (const std::uint32_t k : roadmap.neighbours_of(i)) {
        if (k < i) continue;
        ++tested;
        free += scene().space.is_free(roadmap.places()[i], roadmap.places()[k]) ? 1 : 0;
      }
    }
    benchmark::DoNotOptimize(free);
    lines = static_cast<double>(tested);
  }
  state.counters["lines"] = lines;
}
BENCHMARK(prm_all_lines)->Arg(300)->Arg(1000)->Arg(3000)->Arg(10000)->Unit(benchmark::kMillisecond);

/// Separate polygons of ten sides, so many sides in all.
void voronoi_diagram(benchmark::State& state) {
  std::vector<Segment> segments;
  Random random{3};
  const auto across = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(state.range(0)) / 10.0)));
  for (int i = 0; static_cast<std::int64_t>(segments.size()) < state.range(0); ++i) {
    const Vec2 middle{i % across + 0.5, i / across + 0.5};
    Ring ring;
    for (int k = 0; k < 10; ++k) ring.push_back(middle + random.uniform(0.15, 0.4) * unit(wrap(two_pi * k / 10.0)));
    for (std::size_t k = 0; k < ring.size(); ++k) segments.push_back({ring[k], ring[(k + 1) % ring.size()]});
  }
  std::size_t edges = 0;
  for (auto _ : state) edges = VoronoiDiagram::of(segments)->edges().size();
  state.counters["edges"] = static_cast<double>(edges);
}
BENCHMARK(voronoi_diagram)->Arg(400)->Arg(4000)->Arg(40000)->Arg(100000)->Unit(benchmark::kMillisecond);

void voronoi_roadmap(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(VoronoiRoadmap{scene().space}.lines());
}
BENCHMARK(voronoi_roadmap)->Unit(benchmark::kMillisecond);

void voronoi_query(benchmark::State& state) {
  const VoronoiRoadmap roadmap{scene().space};
  double expansions = 0.0;
  for (auto _ : state) {
    Budget budget;
    expansions = static_cast<double>(roadmap.shortest(start, {{goal}}, 0.0, budget).expansions);
  }
  state.counters["expansions"] = expansions;
}
BENCHMARK(voronoi_query)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace waywright::bench

BENCHMARK_MAIN();
