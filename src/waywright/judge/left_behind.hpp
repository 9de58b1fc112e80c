// The leg that drives out of a load which the vehicle has just set down: such a load cannot be an obstacle at once, since the vehicle stands in it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/legs.hpp"

namespace waywright {

struct LeftBehind {
  LeftLoad load;
  std::optional<double> clear_after;     ///< m of the leg's path, after which the footprint keeps its distance from the load; empty: never
  std::optional<std::string> violation;  ///< that it comes back to it later
};

/// Of each load that the vehicle stands in when the leg begins: where it gets clear of it, and the proof, by the same bounds as everything else, that
/// it keeps the clearance from there on. Up to there nothing is proven of the two. `problem` is the leg's own.
std::vector<LeftBehind> check_left_behind(const Scenario& mission, const LegBegin& begin, const Problem& problem, const Path& path);

/// The same of a judged leg: a sentence each, and status and reason where it comes back.
void judge_left_behind(const Scenario& mission, const LegBegin& begin, const Problem& problem, Plan& plan);

}  // namespace waywright
