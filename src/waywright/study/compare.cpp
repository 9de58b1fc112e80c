#include "waywright/study/compare.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <tuple>

#include "waywright/core/budget.hpp"
#include "waywright/judge/import.hpp"
#include "waywright/planner/threads.hpp"
#include "waywright/study/outside.hpp"

namespace waywright {
namespace {

/// One contestant on one scenario with one seed, judged like all others.
Plan run_one(const Problem& problem, const Contestant& contestant, std::uint64_t seed,
             const CompareOptions& options) {
  Scenario scenario = problem.scenario();
  scenario.seed = seed;
  if (options.budget.evaluations) scenario.budget.evaluations = options.budget.evaluations;
  if (options.budget.samples) scenario.budget.samples = options.budget.samples;
  if (options.budget.seconds) scenario.budget.seconds = options.budget.seconds;
  const BudgetLimits& limits = scenario.budget;
  if (!limits.evaluations && !limits.samples && !limits.seconds)
    scenario.budget.evaluations = options.default_evaluations;
  scenario.planner = {contestant.planner, contestant.parameters};
  auto prepared = Problem::prepare(std::move(scenario));
  if (!prepared) return failed_plan(problem, {Status::no_path, prepared.error().message(), {}, {}});
  if (!contestant.command.empty()) return run_outside(*prepared, contestant.command, options.cancel);
  auto plan = solve(*prepared, options.cancel);
  if (!plan) return failed_plan(*prepared, {Status::no_path, plan.error().message(), {}, {}});
  return std::move(*plan);
}

}  // namespace

std::vector<Run> compare(const std::vector<Problem>& problems, const std::vector<Contestant>& contestants,
                         const CompareOptions& options) {
  std::vector<Run> all;
  for (int k = 0; k < options.runs; ++k) {
    for (std::size_t p = 0; p < problems.size(); ++p) {
      for (std::size_t c = 0; c < contestants.size(); ++c) {
        all.push_back({p, c, problems[p].scenario().seed + static_cast<std::uint64_t>(k), {}});
      }
    }
  }
  std::vector<std::uint8_t> finished(all.size(), 0);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex progress_mutex;
  const auto work = [&] {
    for (;;) {
      const std::size_t i = next.fetch_add(1);
      if (i >= all.size() || (options.cancel != nullptr && options.cancel->load())) return;
      all[i].plan = run_one(problems[all[i].scenario], contestants[all[i].contestant], all[i].seed, options);
      if (all[i].plan.status == Status::canceled) return;
      // The scenario with its map is the problem's; runs by the thousand need not carry it.
      all[i].plan.scenario.map = {};
      finished[i] = 1;
      const std::lock_guard lock{progress_mutex};
      ++done;
      if (options.progress) options.progress(done, all.size());
    }
  };
  on_threads(options.threads, all.size(), work);
  std::vector<Run> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (finished[i] != 0) kept.push_back(std::move(all[i]));
  }
  std::stable_sort(kept.begin(), kept.end(), [](const Run& a, const Run& b) {
    return std::tie(a.scenario, a.contestant) < std::tie(b.scenario, b.contestant);
  });
  return kept;
}

}  // namespace waywright
