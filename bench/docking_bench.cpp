// Kernels of docking against the frozen yardstick, in one run on one thread; prints the table of docs/performance.md.
// usage: docking_bench [Google Benchmark's options]
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "bench/docking_scene.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright::bench {
namespace {

constexpr int candidates = 1000;
constexpr std::uint64_t seed = 2;

/// One of the two scenes with everything that the measurements share.
struct Setting {
  Problem problem;
  PreparedDocking prepared;
  yardstick::Scene scene;
  std::vector<DockingPattern> patterns;

  explicit Setting(Clutter clutter)
      : problem{Problem::prepare(docking_scenario(clutter, seed)).value()},
        prepared{problem},
        scene{scene_of(problem, prepared.wanted_clearance())} {
    Random random{1};
    for (int i = 0; i < candidates; ++i) patterns.push_back(random_pattern(problem, prepared.task(), random));
  }
};

const Setting& setting(Clutter clutter) {
  static const Setting boxes{Clutter::boxes};
  static const Setting points{Clutter::points};
  return clutter == Clutter::boxes ? boxes : points;
}

template <class Evaluate>
void each_candidate(benchmark::State& state, const Setting& s, const Evaluate& evaluate) {
  for (auto _ : state) {
    for (const DockingPattern& pattern : s.patterns) benchmark::DoNotOptimize(evaluate(pattern));
  }
  state.SetItemsProcessed(state.iterations() * candidates);
}

void candidate_plain(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  each_candidate(state, s, [&](const DockingPattern& p) {
    return yardstick::evaluate_plain(s.scene, candidate_of(p), lanes::samples).hits;
  });
}
void candidate_boxes_first(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  each_candidate(state, s, [&](const DockingPattern& p) {
    return yardstick::evaluate_boxes_first(s.scene, candidate_of(p), lanes::samples).hits;
  });
}
void candidate_ours(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  CandidateEvaluator evaluator{s.prepared};
  each_candidate(state, s, [&](const DockingPattern& p) { return evaluator.evaluate(p).free; });
}

constexpr int population = 20;
constexpr int generations = 30;

/// The published way: flat knock-outs on top of length and change of curvature.
struct PlainProblem {
  const Setting* s = nullptr;
  const TransitionZone* zone = nullptr;
  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    const DockingPattern p = docking_pattern(placement_of(s->problem.start()), placement_of(s->problem.goal()), transition_placement(s->prepared.task(), *zone, x), {});
    const yardstick::Verdict v = yardstick::evaluate_plain(s->scene, candidate_of(p), lanes::samples);
    const double knock_out = v.hits > 0 ? 1000.0 : v.max_curvature > s->problem.vehicle().max_curvature() ? 100.0 : 0.0;
    return {0.7 * v.curvature_change / 2.4 + 0.3 * v.length / 12.0 + knock_out};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const SearchSpace space = search_space(*zone, 0.0);
    return {space.low, space.high};
  }
};

void side_pagmo_de_on_plain(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  for (auto _ : state) {
    pagmo::population pop{pagmo::problem{PlainProblem{&s, &s.prepared.task().zones[0]}}, population, 1U};
    pagmo::algorithm de{pagmo::de{generations - 1, 0.8, 0.9, 2, 0.0, 0.0, 1U}};
    benchmark::DoNotOptimize(de.evolve(pop).champion_f()[0]);
  }
}
void side_ours(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  const TransitionZone& zone = s.prepared.task().zones[0];
  CandidateEvaluator evaluator{s.prepared};
  const Placement start = placement_of(s.problem.start());
  const Placement dock = placement_of(s.problem.goal());
  const CostFunction cost = [&](std::span<const double> x, double enough) {
    const DockingPattern pattern = docking_pattern(start, dock, transition_placement(s.prepared.task(), zone, x), {});
    return evaluation_of(evaluator, pattern, enough, [](const PathMeasures& m) { return 0.7 * m.curvature_change / 2.4 + 0.3 * m.length / 12.0; });
  };
  for (auto _ : state) {
    Budget budget;
    SearchOptions options;
    options.evaluations = population * generations;
    benchmark::DoNotOptimize(LatticeSearch{}.minimise(cost, search_space(zone, 0.0), options, budget).cost);
  }
}

/// The best feasible of the candidates: about 15 m.
const Path& docking_path(const Setting& s) {
  static std::map<const Setting*, Path> paths;
  const auto [entry, is_new] = paths.try_emplace(&s);
  if (is_new) {
    CandidateEvaluator evaluator{s.prepared};
    double least = 1e9;
    for (const DockingPattern& p : s.patterns) {
      const CandidateScore score = evaluator.evaluate(p);
      if (!score.feasible() || std::abs(score.measures.length - 15.0) >= least) continue;
      least = std::abs(score.measures.length - 15.0);
      entry->second = pattern_path(splines_of(p));
    }
  }
  return entry->second;
}

void proof_sampling(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  const Path& path = docking_path(s);
  std::vector<std::pair<yardstick::Point, yardstick::Point>> poses;
  for (const Sample& at : sample(path, 0.0, 1.0, 0.05)) {
    const Vec2 heading = unit(at.heading);
    poses.push_back({{at.x, at.y}, {heading.x, heading.y}});
  }
  for (auto _ : state) {
    double least = 1e9;
    for (const auto& [position, heading] : poses) least = std::min(least, yardstick::distance_at(s.scene, position, heading));
    benchmark::DoNotOptimize(least);
  }
}
void proof_ours(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  const Path& path = docking_path(s);
  ProofWorkspace workspace{s.problem};
  for (auto _ : state) benchmark::DoNotOptimize(prove(s.problem, path, {}, workspace).certificate.clearance);
}
void proof_sampling_ours(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  std::vector<Pose> poses;
  for (const Sample& at : sample(docking_path(s), 0.0, 1.0, 0.05)) poses.push_back(at.pose());
  for (auto _ : state) {
    double least = 1e9;
    for (const Pose& pose : poses) least = std::min(least, s.problem.world().least_clearance(s.problem.vehicle().footprint, pose, least));
    benchmark::DoNotOptimize(least);
  }
}
void preparation(benchmark::State& state, Clutter clutter) {
  const Setting& s = setting(clutter);
  for (auto _ : state) benchmark::DoNotOptimize(PreparedDocking{s.problem}.field().columns());
}

struct Row {
  const char* name;
  const char* yardstick;  ///< row it is measured against; nullptr: none
  void (*run)(benchmark::State&, Clutter);
  double each = 1.0;      ///< measurements in an iteration
};
constexpr Row rows[] = {
    {"candidate, plain", nullptr, candidate_plain, candidates},
    {"candidate, bounding boxes first", nullptr, candidate_boxes_first, candidates},
    {"candidate, ours", "candidate, plain", candidate_ours, candidates},
    {"the same", "candidate, bounding boxes first", candidate_ours, candidates},
    {"side 20 × 30, pagmo's DE on plain", nullptr, side_pagmo_de_on_plain},
    {"side 600 evaluations, ours", "side 20 × 30, pagmo's DE on plain", side_ours},
    {"sampling every 5 cm, plain", nullptr, proof_sampling},
    {"sampling every 5 cm, our distance", nullptr, proof_sampling_ours},
    {"proof with limits, ours", "sampling every 5 cm, plain", proof_ours},
    {"preparation of a problem", nullptr, preparation},
};

class Table final : public benchmark::ConsoleReporter {
 public:
  Table() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "median") {
        medians_[run.run_name.function_name] = run.GetAdjustedCPUTime();
      }
    }
  }
  void print() const {
    fmt::print("| median CPU time in µs | 12 boxes | 500 scan points | times faster than | 12 boxes | 500 scan points |\n"
               "| --- | --- | --- | --- | --- | --- |\n");
    for (const Row& row : rows) {
      const auto boxes = of(row.name, "boxes", row.each), points = of(row.name, "points", row.each);
      if (!boxes || !points) continue;
      std::string line = fmt::format("| {} | {:.3g} | {:.3g} |", row.name, *boxes, *points);
      if (row.yardstick != nullptr) {
        const Row* other = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) { return std::string{r.name} == row.yardstick; });
        line += fmt::format(" {} | {:.1f} | {:.1f} |", row.yardstick, *of(other->name, "boxes", other->each) / *boxes,
                            *of(other->name, "points", other->each) / *points);
      } else {
        line += " | | |";
      }
      fmt::print("{}\n", line);
    }
  }

 private:
  std::optional<double> of(const std::string& name, const char* scene, double each) const {
    const auto found = medians_.find(name + "/" + scene);
    if (found == medians_.end()) return std::nullopt;
    return found->second / each / 1000.0;  // ns → µs
  }
  std::map<std::string, double> medians_;
};

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  using namespace waywright::bench;
  for (const Row& row : rows) {
    for (const Clutter clutter : {Clutter::boxes, Clutter::points}) {
      benchmark::RegisterBenchmark((std::string{row.name} + (clutter == Clutter::boxes ? "/boxes" : "/points")).c_str(),
                                   [&row, clutter](benchmark::State& state) { row.run(state, clutter); })
          ->Repetitions(7)
          ->MinTime(0.05);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  table.print();
  return 0;
}
