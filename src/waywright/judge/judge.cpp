#include "waywright/judge/judge.hpp"

#include <chrono>

#include "waywright/core/version.hpp"
#include "waywright/metrics/metrics.hpp"
#include "waywright/proof/limits.hpp"
#include "waywright/speed/speed.hpp"

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

Plan failed_plan(const Problem& problem, const Failure& failure) {
  Plan plan = empty_plan(problem);
  plan.status = failure.status;
  plan.reason = failure.reason;
  return plan;
}

Plan judge(const Problem& problem, Path path) {
  using Clock = std::chrono::steady_clock;
  Plan plan = empty_plan(problem);
  const auto begin = Clock::now();
  const Proof proof = prove(problem, path);
  plan.timing.prove = std::chrono::duration<double>(Clock::now() - begin).count();
  plan.certificate = proof.certificate;
  plan.status = proof.holds() ? Status::solved : Status::unproven;
  plan.reason = joined(proof.violations);
  plan.path = std::move(path);
  if (!check_form(plan.path).empty()) return plan;

  const Vehicle& vehicle = problem.vehicle();
  plan.samples = sample(plan.path, vehicle.footprint.radius(), proof.certificate.tolerance);
  assign_speed(plan.samples, vehicle);
  plan.metrics = measure(plan.path, plan.samples, clearances(plan.samples, problem.world(), vehicle.footprint));
  return plan;
}

}  // namespace waywright
