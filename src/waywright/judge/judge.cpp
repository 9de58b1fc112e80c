#include "waywright/judge/judge.hpp"

#include <chrono>

#include "waywright/core/version.hpp"
#include "waywright/judge/entry.hpp"
#include "waywright/map/clearance_along.hpp"
#include "waywright/metrics/metrics.hpp"
#include "waywright/proof/limits.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr std::size_t sentences_in_reason = 3;

Plan empty_plan(const Problem& problem) {
  Plan plan;
  plan.version = version;
  plan.scenario = problem.scenario();
  plan.seed = problem.scenario().seed;
  plan.planner = problem.scenario().planner.name;
  plan.parameters = problem.scenario().planner.parameters;
  return plan;
}

std::string joined(const std::vector<Violation>& violations) {
  std::string text;
  for (std::size_t i = 0; i < violations.size() && i < sentences_in_reason; ++i) {
    if (i > 0) text += "; ";
    text += violations[i].sentence;
  }
  if (violations.size() > sentences_in_reason) {
    text += "; and " + std::to_string(violations.size() - sentences_in_reason) + " more";
  }
  return text;
}

}  // namespace

std::vector<double> clearances_along(const Problem& problem, const Path& path, const std::vector<Sample>& samples) {
  const std::optional<std::size_t> pocket_piece = problem.pocket_piece(path);
  ClearanceAlong along{problem.world(), problem.footprint(), clearance_cap};
  return clearances(samples, [&](const Sample& s) {
    const bool in_shelf = pocket_piece == s.piece && s.pose().position() != problem.pocket()->outer.position();
    if (!in_shelf) return along.at(s.pose());
    return contacts_at(*problem.pocket(), problem.world(), problem.footprint(), s.pose(), clearance_cap).vehicle.clearance;
  });
}

Plan failed_plan(const Problem& problem, const Failure& failure) {
  Plan plan = empty_plan(problem);
  plan.status = failure.status;
  plan.reason = failure.reason;
  return plan;
}

Plan judge(const Problem& problem, Path path, const std::atomic<bool>* cancel) {
  using Clock = std::chrono::steady_clock;
  Plan plan = empty_plan(problem);
  const auto begin = Clock::now();
  ProofOptions options;
  options.cancel = cancel;
  const Proof proof = prove(problem, path, options);
  plan.timing.prove = std::chrono::duration<double>(Clock::now() - begin).count();
  plan.certificate = proof.certificate;
  if (plan.certificate.tightest) plan.tightest_obstacle = problem.world().source_name(plan.certificate.tightest_source);
  plan.status = proof.holds() ? Status::solved : Status::unproven;
  plan.reason = joined(proof.violations);
  if (cancel != nullptr && cancel->load() && !proof.holds()) {
    // What was found is kept; half a proof says nothing of it.
    plan.status = Status::canceled;
    plan.reason = "canceled before the path was proven; the path is kept, and verify can prove it";
    plan.certificate = {};
    plan.tightest_obstacle.clear();
  }
  plan.path = std::move(path);
  if (!proof.measurable) return plan;

  const Vehicle& vehicle = problem.vehicle();
  plan.samples = sample(plan.path, problem.footprint().radius(), proof.certificate.tolerance);
  const auto& motion = problem.motion();
  SpeedWorkspace timing;
  const LimitsAlong along = zone_limits(problem, plan.samples, proof.certificate.tolerance);
  if (auto violation = plan.status == Status::canceled ? std::nullopt : check_entry(problem, plan.samples, timing, along)) {
    plan.status = Status::unproven;
    plan.reason += (plan.reason.empty() ? "" : "; ") + violation->sentence;
  }
  assign_speed(plan.samples, vehicle, motion ? motion->speed : 0.0, timing, along);
  plan.metrics = measure(plan.path, plan.samples, clearances_along(problem, plan.path, plan.samples));
  return plan;
}

}  // namespace waywright
