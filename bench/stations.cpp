// Plans random stations (`waywright generate station`, seeds 1 to N) one after the other on one thread and prints the table of
// docs/performance.md. usage: stations [N]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "waywright/planner/registry.hpp"
#include "waywright/study/generate.hpp"
#include "waywright/study/summary.hpp"

int main(int argc, char** argv) {
  using namespace waywright;
  const int wanted = argc > 1 ? std::max(1, std::atoi(argv[1])) : 200;
  std::size_t solved = 0, second = 0, unproven = 0;
  std::vector<double> pattern_times, second_times, failed_times, proofs;
  for (int seed = 1; seed <= wanted; ++seed) {
    const auto scenario = generate_station(static_cast<std::uint64_t>(seed));
    if (!scenario) return 2;
    const auto problem = Problem::prepare(*scenario);
    if (!problem) return 2;
    const auto plan = solve(*problem);
    if (!plan) return 2;
    const double ms = 1000.0 * plan->timing.plan;
    if (plan->status == Status::unproven) ++unproven;
    if (plan->status != Status::solved) {
      failed_times.push_back(ms);
      continue;
    }
    ++solved;
    proofs.push_back(1000.0 * plan->timing.prove);
    const bool by_pattern = !plan->explanation.empty() && plan->explanation.front().find("second choice") == std::string::npos;
    if (!by_pattern) ++second;
    (by_pattern ? pattern_times : second_times).push_back(ms);
  }
  const auto share = [&](const char* name, std::size_t hits) {
    const Share s = share_of(hits, static_cast<std::size_t>(wanted));
    fmt::print("| {} | {} of {} | {:.1f} % | {:.1f}–{:.1f} % |\n", name, hits, wanted, 100.0 * static_cast<double>(hits) / wanted, 100.0 * s.low, 100.0 * s.high);
  };
  fmt::print("| outcome | stations | share | 95 % interval |\n| --- | --- | --- | --- |\n");
  share("solved and proven", solved);
  share("… of these by the second choice", second);
  share("a path that the proof refused", unproven);
  share("no path", static_cast<std::size_t>(wanted) - solved - unproven);
  fmt::print("\n| time in ms | runs | median | upper quartile | worst |\n| --- | --- | --- | --- | --- |\n");
  const auto row = [](const char* name, std::vector<double> values) {
    const double worst = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
    const Spread s = spread_of(values);
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} |\n", name, values.size(), s.median, s.high_quartile, worst);
  };
  row("planning, a pattern serves", pattern_times);
  row("planning, second choice", second_times);
  row("planning, no path", failed_times);
  row("proof", proofs);
  return 0;
}
