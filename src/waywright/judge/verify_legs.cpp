// A plan with legs: each judged again as a plan of its own, their borders, and what the whole claims of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/judge/claims.hpp"
#include "waywright/judge/left_behind.hpp"
#include "waywright/judge/legs.hpp"

namespace waywright {
namespace {

constexpr double number_slack = 1e-6;  // m, rad, s: rounding of what was written by another program

bool is_same(const Pose& a, const Pose& b) { return distance(a.position(), b.position()) <= number_slack && std::abs(shorter_turn(a.heading, b.heading)) <= number_slack; }

std::string words(const Pose& p) { return fmt::format("({:.6f}, {:.6f}, {:.6f})", p.x, p.y, p.heading); }
std::string words(const std::string& load) { return load.empty() ? "no load" : fmt::format("the load \"{}\"", load); }

/// What the plan's record of a leg says of it, against what the scenario makes of it.
void check_record(const LegResult& claimed, const LegBegin& begin, const Leg& given, const Pose& end, const auto& find) {
  if (claimed.name != given.name) find(fmt::format("its record is called \"{}\", the leg \"{}\"", claimed.name, given.name));
  if (claimed.load != begin.load) find(fmt::format("its record says that {} is carried, and by the scenario it is {}", words(claimed.load), words(begin.load)));
  if (!is_same(claimed.start, begin.pose)) find(fmt::format("its record begins at {}, the leg at {}", words(claimed.start), words(begin.pose)));
  if (!is_same(claimed.end, end)) find(fmt::format("its record ends at {}, the leg at {}", words(claimed.end), words(end)));
}

/// s and t of the samples go on where the leg before has ended. @pre both have samples
void check_going_on(const std::vector<Sample>& samples, std::size_t first, const auto& find) {
  const Sample& before = samples[first - 1];
  const Sample& here = samples[first];
  if (std::abs(here.s - before.s) > number_slack) find(fmt::format("its samples begin at s = {} m, where those of the leg before end at {} m", here.s, before.s));
  if (std::abs(here.t - before.t) > number_slack) find(fmt::format("its samples begin at t = {} s, where those of the leg before end at {} s", here.t, before.t));
}

}  // namespace

Parsed<Verification> verify_legs(const Plan& plan) {
  const Scenario& mission = plan.scenario;
  const auto refuse = [](InputError error) {
    error.field = "scenario." + error.field;
    return tl::unexpected{std::move(error)};
  };
  if (auto checked = check_legs(mission); !checked) return refuse(checked.error());
  Verification verification;
  std::vector<std::string>& findings = verification.findings;
  verification.fresh.scenario = mission;
  verification.fresh.status = plan.status;
  verification.fresh.reason = plan.reason;
  if (plan.path.pieces.empty()) {
    findings.push_back(fmt::format("the plan holds no path to verify; its status is {}", to_string(plan.status)));
    return verification;
  }
  verification.fresh.status = Status::unproven;
  if (plan.legs.size() != mission.legs.size()) {
    findings.push_back(fmt::format("the plan tells of {} legs, and the mission has {}", plan.legs.size(), mission.legs.size()));
    verification.fresh.reason = findings.back();
    return verification;
  }
  auto parts = parts_of(plan);
  if (!parts) {
    findings.emplace_back("the plan's pieces and samples are not those of its legs, one after another: some are missing or left over");
    verification.fresh.reason = findings.back();
    return verification;
  }
  const World of_map{mission.map};
  std::vector<JudgedLeg> fresh;
  LegBegin begin = first_leg(mission);
  std::size_t first_sample = 0;
  for (std::size_t i = 0; i < parts->size(); ++i) {
    auto problem = prepare_leg(mission, begin, of_map);
    if (!problem) return refuse(problem.error());
    const auto find = [&](const std::string& what) { findings.push_back(fmt::format("{}: {}", leg_label(mission, i), what)); };
    const Sample before = first_sample > 0 ? plan.samples[first_sample - 1] : Sample{};
    Plan& part = (*parts)[i];
    const std::vector<LeftBehind> behind = check_left_behind(mission, begin, *problem, part.path);
    // What the leg's own problem does not know of may be all that is not proven.
    const bool comes_back = std::any_of(behind.begin(), behind.end(), [](const LeftBehind& each) { return each.violation.has_value(); });
    if (comes_back && part.status == Status::unproven) part.status = Status::solved;
    Verification of_leg = verify_part(*problem, part, before.s, before.t);
    for (const std::string& finding : of_leg.findings) find(finding);
    for (const LeftBehind& each : behind) {
      if (each.violation) find(*each.violation);
    }
    judge_left_behind(mission, begin, *problem, of_leg.fresh);
    const Pose end = end_of(*problem, (*parts)[i].path);
    check_record(plan.legs[i], begin, mission.legs[i], end, find);
    if (first_sample > 0 && !(*parts)[i].samples.empty()) check_going_on(plan.samples, first_sample, find);
    first_sample += (*parts)[i].samples.size();
    of_leg.fresh.scenario = {};  // with its map
    fresh.push_back({begin, end, std::move(of_leg.fresh)});
    begin = next_leg(mission, begin, end);
  }
  const auto last_load = check_last_load(mission, begin, of_map);
  if (!last_load) return refuse(last_load.error());
  if (*last_load) findings.push_back(fmt::format("{}: {}", leg_label(mission, mission.legs.size() - 1), (*last_load)->reason));
  verification.fresh = join_legs(mission, std::move(fresh));
  Plan& whole = verification.fresh;
  if (*last_load && whole.status == Status::solved) {
    whole.status = Status::unproven;
    whole.reason = findings.back();
  }
  if (whole.status == Status::solved && plan.status != Status::solved && findings.empty()) {
    findings.push_back(fmt::format("the plan says that it is {}, though its path can be proven", to_string(plan.status)));
  } else if (whole.status != Status::solved && findings.empty()) {
    findings.push_back(whole.reason);
  }
  if (!whole.samples.empty()) check_claimed_metrics(plan, whole, findings);
  check_claimed_certificate(plan.certificate, whole.certificate, findings);
  verification.holds = findings.empty();
  return verification;
}

}  // namespace waywright
