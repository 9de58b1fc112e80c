// A plan file's claims held against a fresh proof of its own curves.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "waywright/judge/claims.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/judge/legs.hpp"
#include "waywright/judge/zone_speeds.hpp"
#include "waywright/proof/moving_clearance.hpp"

namespace waywright {

namespace {

/// A column of claims as the fresh one has it, where they differ by no more than a sum with `before` rounds. @pre the fresh column does not fall
void take_fresh(std::vector<Sample>& claimed, const std::vector<Sample>& fresh, double Sample::*column, double before) {
  if (!(before > 0.0)) return;
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (before + fresh.back().*column);
  for (Sample& sample : claimed) {
    const auto from = std::lower_bound(fresh.begin(), fresh.end(), sample.*column - rounding, [&](const Sample& s, double value) { return s.*column < value; });
    if (from != fresh.end() && (*from).*column <= sample.*column + rounding) sample.*column = (*from).*column;
  }
}

}  // namespace

Parsed<Verification> verify(const Plan& plan) {
  if (!plan.scenario.legs.empty()) return verify_legs(plan);
  auto problem = Problem::prepare(plan.scenario);
  if (!problem) {
    InputError error = problem.error();
    error.field = "scenario." + error.field;
    return tl::unexpected{error};
  }
  return verify(*problem, plan);
}

Verification verify(const Problem& problem, const Plan& plan) { return verify_part(problem, plan, 0.0, 0.0); }

Verification verify_part(const Problem& problem, Plan plan, double s_before, double t_before) {
  Verification verification;
  if (plan.path.pieces.empty()) {
    verification.fresh = failed_plan(problem, {plan.status, plan.reason, {}, {}});
    verification.findings.push_back(
        fmt::format("the plan holds no path to verify; its status is {}", to_string(plan.status)));
    return verification;
  }
  verification.fresh = judge_as_if_nothing_moved(problem, plan.path);
  const Plan& fresh = verification.fresh;
  std::vector<std::string>& findings = verification.findings;
  if (auto ends = problem.check_ends()) findings.push_back(ends->reason);
  if (fresh.status != Status::solved) findings.push_back(fresh.reason);
  if (!fresh.samples.empty()) {
    std::vector<PoseSpeed> speeds;
    if (problem.zones().limits_speed()) {
      for (const Sample& s : plan.samples) speeds.push_back({s.pose(), s.speed});
    }
    if (auto too_fast = check_zone_speeds(problem, speeds)) findings.push_back(std::move(*too_fast));
    take_fresh(plan.samples, fresh.samples, &Sample::s, s_before);
    take_fresh(plan.samples, fresh.samples, &Sample::t, t_before);
    check_claimed_samples(plan.samples, fresh.samples, problem.vehicle(), problem.footprint().radius(), fresh.certificate.tolerance, findings);
    // What was confirmed of the samples is what this stands on: each within the tolerance of fresh ones, which are within it of the curves.
    if (findings.empty()) {
      for (Violation& meeting : check_in_time(problem, plan.samples, 2.0 * fresh.certificate.tolerance + 1e-5)) findings.push_back(std::move(meeting.sentence));
    }
    if (plan.status != Status::solved && findings.empty()) {
      findings.push_back(fmt::format("the plan says that it is {}, though its path can be proven", to_string(plan.status)));
    }
    check_claimed_metrics(plan, fresh, findings);
  }
  check_claimed_certificate(plan.certificate, fresh.certificate, findings);
  verification.holds = findings.empty();
  return verification;
}

}  // namespace waywright
