// Grid searches and the distance transform against the frozen yardsticks, in one run on one thread; prints the table of docs/performance.md.
// usage: grid_bench [Google Benchmark's options]
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "bench/yardstick/plain_grid.hpp"
#include "waywright/core/random.hpp"
#include "waywright/map/distance_field.hpp"
#include "waywright/planner/grid/grid_search.hpp"

#ifdef WAYWRIGHT_HAS_OPENCV
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#endif

namespace waywright::bench {
namespace {

/// A hall of boxes of 6 to 14 cells, a fifth of it blocked, free at two opposite corners.
std::vector<std::uint8_t> boxes(int side) {
  Random random{1};
  const auto n = static_cast<std::size_t>(side);
  std::vector<std::uint8_t> blocked(n * n, 0);
  std::size_t count = 0;
  while (count < blocked.size() / 5) {
    const std::int64_t w = random.integer(6, 14), h = random.integer(6, 14), x = random.integer(0, side - w), y = random.integer(0, side - h);
    for (std::int64_t j = y; j < y + h; ++j) {
      for (std::int64_t i = x; i < x + w; ++i) {
        std::uint8_t& cell = blocked[static_cast<std::size_t>(j) * n + static_cast<std::size_t>(i)];
        count += cell == 0 ? 1 : 0;
        cell = 1;
      }
    }
  }
  for (std::size_t j = 0; j < 8; ++j) {
    for (std::size_t i = 0; i < 8; ++i) blocked[j * n + i] = blocked[(n - 1 - j) * n + n - 1 - i] = 0;
  }
  return blocked;
}

/// Quadratic in nearness within five cells, at most twice the length.
std::vector<std::uint16_t> dangers(int side, const std::vector<std::uint8_t>& blocked) {
  const DistanceField field{side, side, blocked, true};
  std::vector<std::uint16_t> danger;
  for (const std::int32_t squared : field.values()) {
    const double nearness = std::max(0.0, 1.0 - std::sqrt(static_cast<double>(squared)) / 5.0);
    danger.push_back(static_cast<std::uint16_t>(512.0 * nearness * nearness));
  }
  return danger;
}

struct Setting {
  yardstick::Grid plain;
  GridGraph graph;
  GridQuery query;
  int start = 0, goal = 0;

  Setting(int side, int neighbours, bool danger) {
    plain.columns = plain.rows = side;
    plain.blocked = boxes(side);
    plain.neighbours = neighbours;
    graph = GridGraph{side, side, plain.blocked, static_cast<Neighbours>(neighbours), CornerRule::strict};
    if (danger) {
      const std::vector<std::uint16_t> fixed = dangers(side, plain.blocked);
      for (const std::uint16_t d : fixed) plain.danger.push_back(static_cast<float>(d) / 256.0F);
      graph.set_danger(fixed);
    }
    start = side + 1;
    goal = (side - 2) * side + side - 2;
    query.starts = {{{1, 1}, 0.0}};
    query.goals = {{{side - 2, side - 2}, 0.0}};
  }
};

void ours(benchmark::State& state, int side, int neighbours, bool danger) {
  const Setting setting{side, neighbours, danger};
  GridSearch search;
  GridAnswer answer;
  for (auto _ : state) benchmark::DoNotOptimize(answer = search.run(setting.graph, setting.query));
  state.counters["expansions"] = static_cast<double>(answer.expansions);
  state.counters["cost"] = answer.cost;
}

template <class Search>
void theirs(benchmark::State& state, int side, int neighbours, bool danger, Search search) {
  const Setting setting{side, neighbours, danger};
  yardstick::Found found;
  for (auto _ : state) benchmark::DoNotOptimize(found = search(setting.plain, setting.start, setting.goal, false));
  state.counters["expansions"] = static_cast<double>(found.expansions);
  state.counters["cost"] = found.cost;
}

void preparation(benchmark::State& state, int side, int neighbours) {
  const std::vector<std::uint8_t> blocked = boxes(side);
  for (auto _ : state) benchmark::DoNotOptimize(GridGraph{side, side, blocked, static_cast<Neighbours>(neighbours), CornerRule::strict});
}

constexpr int field_side = 2000;

std::vector<std::uint8_t> sprinkled(double share) {
  Random random{1};
  std::vector<std::uint8_t> blocked(static_cast<std::size_t>(field_side) * field_side);
  for (std::uint8_t& b : blocked) b = random.uniform() < share ? 1 : 0;
  return blocked;
}

void field_ours(benchmark::State& state, std::vector<std::uint8_t> blocked) {
  DistanceField field;
  for (auto _ : state) field.assign(field_side, field_side, blocked, false);
}

#ifdef WAYWRIGHT_HAS_OPENCV
void field_opencv(benchmark::State& state, std::vector<std::uint8_t> blocked) {
  cv::setNumThreads(1);
  cv::Mat free(field_side, field_side, CV_8U), distances;
  for (std::size_t i = 0; i < blocked.size(); ++i) free.data[i] = blocked[i] != 0 ? 0 : 255;
  for (auto _ : state) cv::distanceTransform(free, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
}
#endif

/// Medians of CPU time by name.
class Table : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Aggregate && run.aggregate_name == "median") medians_[run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
    ConsoleReporter::ReportRuns(runs);
  }
  void print() const {
    if (medians_.empty()) return;
    fmt::print("\n| map, neighbours | textbook ms | heap ms | ours ms | against textbook | against heap |\n| --- | --- | --- | --- | --- | --- |\n");
    for (const auto& [name, time] : medians_) {
      if (name.rfind("ours ", 0) != 0) continue;
      const std::string what = name.substr(5);
      const double textbook = of("textbook " + what), heap = of("heap " + what);
      fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} | {:.1f} | {:.1f} |\n", what, textbook, heap, time, textbook / time, heap / time);
    }
    fmt::print("\n| distance field {} x {} | OpenCV precise ms | ours ms | ratio |\n| --- | --- | --- | --- |\n", field_side, field_side);
    for (const auto& [name, time] : medians_) {
      if (name.rfind("field ", 0) != 0) continue;
      const double opencv = of("opencv " + name.substr(6));
      fmt::print("| {} | {:.1f} | {:.2f} | {:.1f} |\n", name.substr(6), opencv, time, opencv / time);
    }
  }

 private:
  double of(const std::string& name) const {
    const auto it = medians_.find(name);
    return it == medians_.end() ? std::nan("") : it->second;
  }
  std::map<std::string, double> medians_;
};

void add(const std::string& name, auto&& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->Repetitions(5)->ReportAggregatesOnly()->MinTime(0.2);
}

}  // namespace
}  // namespace waywright::bench

int main(int argc, char** argv) {
  using namespace waywright::bench;
  for (const int side : {200, 1000, 4000}) {
    for (const int neighbours : {8, 16}) {
      for (const bool danger : {false, true}) {
        const std::string what = fmt::format("{:4}² {:2}{}", side, neighbours, danger ? " danger" : "");
        add("ours " + what, [=](benchmark::State& s) { ours(s, side, neighbours, danger); });
        add("heap " + what, [=](benchmark::State& s) { theirs(s, side, neighbours, danger, yardstick::heap_astar); });
        add("textbook " + what, [=](benchmark::State& s) { theirs(s, side, neighbours, danger, yardstick::textbook_astar); });
      }
      add(fmt::format("prepare {:4}² {:2}", side, neighbours), [=](benchmark::State& s) { preparation(s, side, neighbours); });
    }
  }
  const std::vector<std::pair<std::string, std::vector<std::uint8_t>>> fields{
      {"30 % blocked", sprinkled(0.3)}, {"3 % blocked", sprinkled(0.03)}, {"0.3 % blocked", sprinkled(0.003)}, {"0.1 % blocked", sprinkled(0.001)},
      {"0.001 % blocked", sprinkled(0.00001)}, {"boxes", boxes(field_side)}};
  for (const auto& [name, blocked] : fields) {
    add("field " + name, [blocked](benchmark::State& s) { field_ours(s, blocked); });
#ifdef WAYWRIGHT_HAS_OPENCV
    add("opencv " + name, [blocked](benchmark::State& s) { field_opencv(s, blocked); });
#endif
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  table.print();
}
