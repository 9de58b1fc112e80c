#include "waywright/judge/judge.hpp"

#include <chrono>

#include "waywright/core/version.hpp"
#include "waywright/judge/entry.hpp"
#include "waywright/map/clearance_along.hpp"
#include "waywright/metrics/metrics.hpp"
#include "waywright/proof/limits.hpp"
#include "waywright/proof/moving_clearance.hpp"
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

/// `waits`: among what moves, else as if nothing did.
Plan made_of(const Problem& problem, Path path, const Proof& proof, bool waits, const std::atomic<bool>* cancel, std::span<const WantedWait> wanted, const Pace* pace = nullptr) {
  Plan plan = empty_plan(problem);
  plan.certificate = proof.certificate;
  if (plan.certificate.tightest) plan.tightest_obstacle = problem.world().source_name(plan.certificate.tightest_source);
  plan.status = proof.holds() ? Status::solved : Status::unproven;
  plan.reason = joined(proof.violations);
  const bool is_canceled = cancel != nullptr && cancel->load() && !proof.holds();
  if (is_canceled) {
    // What was found is kept; half a proof says nothing of it.
    plan.status = Status::canceled;
    plan.reason = "canceled before the path was proven; the path is kept, and verify can prove it";
    plan.certificate = {};
    plan.tightest_obstacle.clear();
  }
  plan.path = std::move(path);
  if (!proof.measurable) return plan;

  const Vehicle& vehicle = problem.vehicle();
  const double tolerance = proof.certificate.tolerance;
  plan.samples = sample(plan.path, problem.footprint().radius(), tolerance);
  const auto& motion = problem.motion();
  SpeedWorkspace timing;
  const LimitsAlong along = zone_limits(problem, plan.samples, tolerance);
  const auto fail = [&plan](const std::string& sentence) {
    plan.status = Status::unproven;
    plan.reason += (plan.reason.empty() ? "" : "; ") + sentence;
  };
  const auto violation = is_canceled ? std::nullopt : check_entry(problem, plan.samples, timing, along);
  if (violation) fail(violation->sentence);
  if (!waits || problem.scenario().moving.empty() || violation || is_canceled) {
    assign_speed(plan.samples, vehicle, motion ? motion->speed : 0.0, timing, along);
  } else {
    std::optional<Timed> paced;
    if (pace != nullptr) {
      paced = timed_at_pace(problem, plan.samples, along, *pace);
      if (!check_in_time(problem, paced->samples, tolerance).empty()) paced.reset();
    }
    Timed timed = paced ? std::move(*paced) : timed_past_moving(problem, plan.samples, along, tolerance, wanted, cancel);
    plan.samples = std::move(timed.samples);
    plan.waits = std::move(timed.waits);
    plan.hindrance = timed.hindrance;
    if (plan.hindrance) {
      fail(hindrance_sentence(problem, *plan.hindrance));
    } else if (!paced) {
      for (const Violation& meeting : check_in_time(problem, plan.samples, tolerance)) fail(meeting.sentence);
    }
  }
  plan.metrics = measure(plan.path, plan.samples, clearances_along(problem, plan.path, plan.samples));
  return plan;
}

Proof proof_of(const Problem& problem, const Path& path, const std::atomic<bool>* cancel, double& seconds) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  ProofOptions options;
  options.cancel = cancel;
  Proof proof = prove(problem, path, options);
  seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return proof;
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

Plan judge(const Problem& problem, Path path, const std::atomic<bool>* cancel, std::span<const WantedWait> wanted, const Pace* pace) {
  double proven_in = 0.0;
  const Proof proof = proof_of(problem, path, cancel, proven_in);
  Plan plan = made_of(problem, std::move(path), proof, true, cancel, wanted, pace);
  plan.timing.prove = proven_in;
  return plan;
}

Plan judge_as_if_nothing_moved(const Problem& problem, Path path) {
  double proven_in = 0.0;
  const Proof proof = proof_of(problem, path, nullptr, proven_in);
  Plan plan = made_of(problem, std::move(path), proof, false, nullptr, {});
  plan.timing.prove = proven_in;
  return plan;
}

Plan judge_proven(const Problem& problem, Path path, const Proof& proof, const std::atomic<bool>* cancel, std::span<const WantedWait> wanted, const Pace* pace) {
  return made_of(problem, std::move(path), proof, true, cancel, wanted, pace);
}

}  // namespace waywright
