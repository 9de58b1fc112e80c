// From a path, whoever made it, to a judged plan: samples, speed, metrics, proof, status.
#pragma once

#include <atomic>
#include <span>

#include "waywright/judge/pace.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/judge/waits.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Fills path, samples (with t and speed), metrics, certificate, status, reason, version, scenario, timing.prove.
/// Nothing here knows of planners.
/// Once `cancel` is raised, the plan ends as canceled, without samples.
/// Among moving obstacles the times are those of timed_past_moving, with what waits are wanted; where there are none that serve, the plan is unproven and tells its hindrance.
/// `pace`: the planner's own times, which are taken where the proof in time holds for them.
Plan judge(const Problem& problem, Path path, const std::atomic<bool>* cancel = nullptr, std::span<const WantedWait> wanted = {}, const Pace* pace = nullptr);
/// The same with the fastest profile, whatever moves: what `verify` holds other times against.
Plan judge_as_if_nothing_moved(const Problem& problem, Path path);
/// judge() of a path that was proven elsewhere: samples, speed, metrics and status of it.
Plan judge_proven(const Problem& problem, Path path, const Proof& proof, const std::atomic<bool>* cancel = nullptr, std::span<const WantedWait> wanted = {}, const Pace* pace = nullptr);

/// Clearance of what drives at each sample of a path, m, capped; on the stretch in a shelf's pocket that of everything but the forks.
std::vector<double> clearances_along(const Problem& problem, const Path& path, const std::vector<Sample>& samples);

/// A plan without a path.
Plan failed_plan(const Problem& problem, const Failure& failure);

/// What `verify` reports: the plan file's own claims held against a fresh proof.
struct Verification {
  bool holds = false;
  std::vector<std::string> findings;  ///< what does not hold, one sentence each; empty where it holds
  Plan fresh;                         ///< the path judged anew
};
/// Re-proves `plan` (path from its pieces; samples, metrics and certificate checked against them).
/// Error where the scenario inside it cannot be prepared.
Parsed<Verification> verify(const Plan& plan);
/// The same of a plan without legs whose problem is there already.
Verification verify(const Problem& problem, const Plan& plan);

}  // namespace waywright
