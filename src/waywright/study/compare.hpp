// Many runs side by side under one validity check and one budget.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {

/// One contestant: a planner with its parameters, or an outside program (`exec:CMD`: scenario JSON on
/// standard input, CSV of poses on standard output).
struct Contestant {
  std::string label;    ///< unique, as shown
  std::string planner;  ///< registry name, or empty for an outside program
  Parameters parameters;
  std::string command;  ///< of an outside program
  std::vector<std::string> settings = {};  ///< "key=value" of the parameters that were named, as in the label
};

struct Run {
  std::size_t scenario = 0;
  std::size_t contestant = 0;
  std::uint64_t seed = 0;
  Plan plan;  ///< judged by the same proof for all
};

struct CompareOptions {
  int runs = 1;                                     ///< seeds base, base+1, …
  unsigned threads = 0;                             ///< 0: all cores
  BudgetLimits budget;                              ///< the same for all; an absent field is the scenario's
  std::optional<std::int64_t> default_evaluations;  ///< for all where neither names a budget
  std::function<void(std::size_t, std::size_t)> progress;  ///< done, total
  const std::atomic<bool>* cancel = nullptr;
};

/// The work goes round by seed, so that what is finished when it is cut short can be compared. The runs come
/// back by scenario, contestant and seed whatever the number of threads; what was canceled is left out.
std::vector<Run> compare(const std::vector<Problem>& problems, const std::vector<Contestant>& contestants,
                         const CompareOptions& options);

}  // namespace waywright
