// Kernels of the waypoint planner against the frozen yardstick, in one run on one thread; prints the table of docs/performance.md.
// usage: waypoints_bench [Google Benchmark's options]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "bench/yardstick/plain_waypoints.hpp"
#include "waywright/core/random.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/waypoint/candidates.hpp"

namespace waywright::bench {
namespace {

constexpr int legs = 5, candidates = 50, pairs = 1000;

/// A hall of 37 boxes and its border: 152 segments. Five legs through it.
Scenario hall() {
  Random random{7};
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {24, 16})};
  while (s.map.obstacles.size() < 37) {
    const Vec2 at{random.uniform(1, 23), random.uniform(1, 15)};
    if (std::abs(at.y - 8.0) < 1.6) continue;  // a way through the middle
    s.map.obstacles.push_back(rectangle(at - Vec2{0.4, 0.4}, at + Vec2{random.uniform(0.1, 0.4), random.uniform(0.1, 0.4)}));
  }
  s.vehicle.footprint.polygon = {{-0.9, -0.275}, {0.9, -0.275}, {0.9, 0.275}, {-0.9, 0.275}};
  s.vehicle.drive = Differential{0.45};
  s.start = {1.5, 8.0, 0.0};
  s.mission = Pose{22.0, 8.0, 0.0};
  for (int i = 1; i < legs; ++i) s.waypoints.push_back({1.5 + 4.1 * i, i % 2 == 0 ? 7.6 : 8.4});
  return s;
}

struct Setting {
  Problem problem = Problem::prepare(hall()).value();
  yardstick::Hall plain;
  std::vector<std::vector<double>> courses, with_bends;
  std::vector<std::vector<Pose>> samples;
  std::vector<std::pair<Pose, Pose>> pairs_of_poses;

  Setting() {
    const auto polygon = [](const Ring& ring) {
      yardstick::Polygon p;
      for (const Vec2 v : ring) p.emplace_back(v.x, v.y);
      return p;
    };
    plain.footprint = polygon(problem.footprint().polygon);
    plain.objects.push_back(polygon(problem.scenario().map.boundaries.front()));
    for (const Ring& ring : problem.scenario().map.obstacles) plain.objects.push_back(polygon(ring));
    Random random{1};
    WaypointOptions g1;
    g1.continuity = Continuity::g1;
    const WaypointCandidates chains{problem, g1};
    for (int i = 0; i < candidates; ++i) {
      std::vector<double> x;
      for (int k = 1; k < legs; ++k) x.push_back(random.uniform(-0.8, 0.8));
      courses.push_back(x);
      for (int k = 1; k < legs; ++k) x.push_back(random.uniform(-0.3, 0.3));
      with_bends.push_back(x);
      sample_evenly(*chains.chain_at(courses.back()), 100, samples.emplace_back());
    }
    for (int i = 0; i < pairs; ++i) {
      pairs_of_poses.push_back({{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)}, {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)}});
    }
  }
};

const Setting& setting() {
  static const Setting all;
  return all;
}

std::vector<yardstick::Pose> plain_poses(const std::vector<Pose>& poses) {
  std::vector<yardstick::Pose> plain;
  for (const Pose& p : poses) plain.push_back({p.x, p.y, p.heading});
  return plain;
}

void distances_by(benchmark::State& state, yardstick::Distances (*distances)(const yardstick::Hall&, const std::vector<yardstick::Pose>&)) {
  std::vector<std::vector<yardstick::Pose>> all;
  for (const auto& poses : setting().samples) all.push_back(plain_poses(poses));
  for (auto _ : state) {
    for (const auto& poses : all) benchmark::DoNotOptimize(distances(setting().plain, poses).distance.data());
  }
  state.SetItemsProcessed(state.iterations() * candidates);
}

void distances_ours(benchmark::State& state, FitnessForm form) {
  MapObjects objects{setting().problem};
  TrajectoryMeasures measures;
  for (auto _ : state) {
    for (const auto& poses : setting().samples) {
      objects.measure(poses, form, false, measures);
      benchmark::DoNotOptimize(measures.distance.data());
    }
  }
  state.SetItemsProcessed(state.iterations() * candidates);
}

void objective_ours(benchmark::State& state, WaypointObjective objective, Continuity continuity) {
  WaypointOptions options;
  options.objective = objective;
  options.continuity = continuity;
  WaypointCandidates evaluated{setting().problem, options};
  for (auto _ : state) {
    for (const auto& x : continuity == Continuity::g2 ? setting().with_bends : setting().courses) benchmark::DoNotOptimize(evaluated.evaluate(x).graded);
  }
  state.SetItemsProcessed(state.iterations() * candidates);
}

std::vector<yardstick::Pose> plain_poses_through(const std::vector<double>& courses) {
  const Scenario& s = setting().problem.scenario();
  std::vector<yardstick::Pose> through{{s.start.x, s.start.y, s.start.heading}};
  for (std::size_t i = 0; i < courses.size(); ++i) through.push_back({s.waypoints[i].x, s.waypoints[i].y, courses[i]});
  const Pose goal = setting().problem.goal();
  through.push_back({goal.x, goal.y, goal.heading});
  return through;
}

void objective_plain(benchmark::State& state) {
  std::vector<std::vector<yardstick::Pose>> all;
  for (const auto& courses : setting().courses) all.push_back(plain_poses_through(courses));
  for (auto _ : state) {
    for (const auto& through : all) benchmark::DoNotOptimize(yardstick::candidate_plain(setting().plain, through, 100));
  }
  state.SetItemsProcessed(state.iterations() * candidates);
}

/// The publication's genetic algorithm as the planner runs it; a generation of 50.
void generations_ours(benchmark::State& state) {
  constexpr int generations = 20;
  WaypointOptions options;
  options.objective = WaypointObjective::pwavg;
  options.continuity = Continuity::g1;
  WaypointCandidates evaluated{setting().problem, options};
  const auto optimizer = find_optimizer("ga_intermediate")->make();
  std::int64_t done = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    Budget budget;
    const SearchOptions search{candidates * (generations + 1), candidates, ++seed};
    done += optimizer->minimise([&](std::span<const double> x, double) { return evaluated.evaluate(x); }, evaluated.space(), search, budget).evaluations;
  }
  state.SetItemsProcessed(done / candidates);
}

void fit_plain(benchmark::State& state) {
  for (auto _ : state) {
    for (const auto& [a, b] : setting().pairs_of_poses) benchmark::DoNotOptimize(yardstick::fit_textbook({a.x, a.y, a.heading}, {b.x, b.y, b.heading}).length);
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}
void fit_ours(benchmark::State& state) {
  for (auto _ : state) {
    for (const auto& [a, b] : setting().pairs_of_poses) benchmark::DoNotOptimize(fit_clothoid(a, b)->length);
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}

void fit_ours_in_batches(benchmark::State& state) {
  std::vector<Pose> from, to;
  for (const auto& [a, b] : setting().pairs_of_poses) {
    from.push_back(a);
    to.push_back(b);
  }
  std::vector<std::optional<Clothoid>> fitted(pairs);
  for (auto _ : state) {
    fit_clothoid_batch(from, to, fitted);
    benchmark::DoNotOptimize(fitted.data());
  }
  state.SetItemsProcessed(state.iterations() * pairs);
}

/// Keeps the medians; the console stays quiet.
class Medians : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      const auto rate = run.counters.find("items_per_second");
      if (rate != run.counters.end()) micros[run.run_name.function_name] = 1e6 / rate->second.value;
    }
  }
  std::map<std::string, double> micros;  ///< per item
};

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  using namespace waywright;
  using namespace waywright::bench;
  const auto add = [](const char* name, auto function) { benchmark::RegisterBenchmark(name, function)->MinTime(0.05)->Repetitions(7)->ReportAggregatesOnly(true); };
  add("distances, plain", [](benchmark::State& s) { distances_by(s, yardstick::distances_plain); });
  add("distances, bounding boxes first", [](benchmark::State& s) { distances_by(s, yardstick::distances_boxes_first); });
  add("distances, ours, whole footprint", [](benchmark::State& s) { distances_ours(s, FitnessForm::corrected); });
  add("distances, ours, corners", [](benchmark::State& s) { distances_ours(s, FitnessForm::published); });
  add("candidate, pwavg, plain", objective_plain);
  add("generation of 50, ours", generations_ours);
  add("candidate, pwavg, one clothoid a leg", [](benchmark::State& s) { objective_ours(s, WaypointObjective::pwavg, Continuity::g1); });
  add("candidate, metres, three clothoids a leg", [](benchmark::State& s) { objective_ours(s, WaypointObjective::metres, Continuity::g2); });
  add("clothoid fit, textbook", fit_plain);
  add("clothoid fit, ours", fit_ours);
  add("clothoid fit, ours, in batches", fit_ours_in_batches);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  fmt::print("| median CPU time | µs | times faster |\n| --- | --- | --- |\n");
  const auto row = [&](const char* name, const char* against) {
    const double mine = medians.micros[name];
    fmt::print("| {} | {:.3f} | {} |\n", name, mine, against == nullptr ? "" : fmt::format("{:.1f}", medians.micros[against] / mine));
  };
  row("distances, plain", nullptr);
  row("distances, bounding boxes first", "distances, plain");
  row("distances, ours, whole footprint", "distances, plain");
  row("distances, ours, corners", "distances, plain");
  row("candidate, pwavg, plain", nullptr);
  row("candidate, pwavg, one clothoid a leg", "candidate, pwavg, plain");
  medians.micros["generation of 50, plain, without its own work"] = candidates * medians.micros["candidate, pwavg, plain"];
  row("generation of 50, plain, without its own work", nullptr);
  row("generation of 50, ours", "generation of 50, plain, without its own work");
  row("candidate, metres, three clothoids a leg", nullptr);
  row("clothoid fit, textbook", nullptr);
  row("clothoid fit, ours", "clothoid fit, textbook");
  row("clothoid fit, ours, in batches", "clothoid fit, textbook");
  return 0;
}
