// Whole plans of random stations (`waywright generate station`, seeds 1 to N) where a pattern serves, problem and planner prepared: both sides,
// three variables, proof, samples, speed; against OMPL's RRTConnect with simplification on the same stations, one thread, in turn, its motions tested every
// centimetre (at which most of its paths stand a finer check) and every 5 cm (as is usual). Prints the table of docs/performance.md.
// usage: plans [N]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "bench/yardstick/ompl_docking.hpp"
#include "waywright/docking/docking.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/study/generate.hpp"
#include "waywright/study/summary.hpp"

namespace {

using namespace waywright;

constexpr int repetitions = 5;   // of ours, the median counts
constexpr int ompl_seeds = 2;
constexpr double spacings[] = {0.01, 0.05};  // m
constexpr double ompl_limit = 5.0;  // s

struct Others {
  double spacing = 0.0;
  std::vector<double> ms{}, ratios{}, lengths{};
  int unsolved = 0;
};

/// CPU time in s: the machine may have other work.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double since(double begin) { return 1000.0 * (now() - begin); }

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void row(const char* name, const std::vector<double>& ms) {
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", name, ms.size(), percentile(ms, 0.5), percentile(ms, 0.95), percentile(ms, 0.99),
             percentile(ms, 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  const int wanted = argc > 1 ? std::max(1, std::atoi(argv[1])) : 200;
  std::vector<double> ours, told, proofs, preparations;
  std::vector<Others> others;
  for (const double spacing : spacings) others.push_back({.spacing = spacing});
  for (int seed = 1; seed <= wanted; ++seed) {
    auto scenario = generate_station(static_cast<std::uint64_t>(seed));
    if (!scenario) return 2;
    scenario->planner.parameters["fallback"] = false;
    const auto problem = Problem::prepare(*scenario);
    if (!problem || problem->check_ends()) return 2;
    const auto parameters = complete_parameters(scenario->planner);
    const double preparing = now();
    const AnyPlanner planner = find_planner("pattern_docking")->make(*parameters, scenario->seed).prepared(*problem);
    preparations.push_back(since(preparing));
    const auto docking = Docking::prepare(*scenario);
    if (!docking) return 2;
    auto session = DockingSession::on(*docking);
    if (!session) return 2;
    std::vector<double> times, told_times, proof_times;
    double length = 0.0;
    for (int i = 0; i < repetitions; ++i) {
      const double planning = now();
      if (session->plan().status != Status::solved) break;
      times.push_back(since(planning));
      Budget budget;
      const double telling = now();
      const PlanningResult result = planner.plan(*problem, budget);
      if (!result) return 1;
      const double proving = now();
      const Proof proof = prove(*problem, result->path);
      proof_times.push_back(since(proving));
      told_times.push_back(since(telling));
      if (!proof.holds()) return 1;
      length = waywright::length(result->path);
    }
    if (times.empty()) continue;
    ours.push_back(percentile(times, 0.5));
    told.push_back(percentile(told_times, 0.5));
    proofs.push_back(percentile(proof_times, 0.5));
    for (Others& o : others) {
      for (int s = 1; s <= ompl_seeds; ++s) {
        const yardstick::OmplRun run = yardstick::rrt_connect_simplified(*problem, static_cast<std::uint32_t>(s), ompl_limit, o.spacing);
        if (!run.solved) {
          ++o.unsolved;
          continue;
        }
        o.ms.push_back(1000.0 * run.seconds);
        o.ratios.push_back(o.ms.back() / ours.back());
        o.lengths.push_back(run.length / length);
      }
    }
  }
  fmt::print("| CPU time in ms | runs | median | 95 % | 99 % | worst |\n| --- | --- | --- | --- | --- | --- |\n");
  row("ours: plan, proof, samples and speed", ours);
  row("ours with explanation and alternatives, proven once more", told);
  row("… of this the proof", proofs);
  row("preparation of the planner", preparations);
  for (const Others& o : others) row(fmt::format("OMPL RRTConnect, simplified, tested every {} m", o.spacing).c_str(), o.ms);
  for (const Others& o : others) {
    fmt::print("\nOMPL tested every {} m over ours: median {:.1f} (quartiles {:.1f}–{:.1f}); its path over ours in length: median {:.2f}; none found: {}.\n",
               o.spacing, percentile(o.ratios, 0.5), percentile(o.ratios, 0.25), percentile(o.ratios, 0.75), percentile(o.lengths, 0.5), o.unsolved);
  }
  return 0;
}
