#include "waywright/judge/left_behind.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/path/remainder.hpp"

namespace waywright {
namespace {

constexpr double beyond = 1e-3;    // m over what is required, where the vehicle counts as clear: room for the proof's tolerance
constexpr double rounding = 2e-6;  // m, of the bound where a curve keeps the clearance exactly

/// The leg's vehicle and margins with that load alone.
Parsed<Problem> beside(const Scenario& mission, const LegBegin& begin, const LeftLoad& load, const Pose& start, const Pose& end) {
  Scenario alone;
  alone.vehicle = mission.vehicle;
  alone.carried_load = begin.load;
  alone.clearance = mission.clearance;
  alone.pose_error = mission.pose_error;
  alone.map.obstacles = {outline_of(mission, load)};
  alone.start = start;
  alone.mission = end;
  return Problem::prepare(std::move(alone));
}

}  // namespace

std::vector<LeftBehind> check_left_behind(const Scenario& mission, const LegBegin& begin, const Problem& problem, const Path& path) {
  std::vector<LeftBehind> found;
  if (path.pieces.empty() || !can_be_sampled(path, problem.footprint().radius(), ProofOptions{}.tolerance)) return found;
  const std::vector<LeftLoad> behind = left_behind_on(mission, begin.index, begin.left);
  if (behind.empty()) return found;
  const std::vector<Sample> samples = sample(path, problem.footprint().radius(), ProofOptions{}.tolerance);
  for (const LeftLoad& load : behind) {
    LeftBehind& here = found.emplace_back(LeftBehind{load, std::nullopt, std::nullopt});
    const auto whole = beside(mission, begin, load, start_pose(path), end_pose(path));
    if (!whole) continue;
    const double enough = problem.required_clearance() + beyond;
    const auto clear = std::find_if(samples.begin(), samples.end(), [&](const Sample& s) {
      return s.direction != 0 && whole->world().is_free(whole->footprint(), s.pose(), enough);
    });
    if (clear == samples.end()) continue;
    here.clear_after = clear->s;
    const Path rest = remainder(path, clear->s);
    const auto of_rest = beside(mission, begin, load, start_pose(rest), end_pose(rest));
    const Certificate proven = prove(*of_rest, rest).certificate;
    if (proven.collision_free && proven.clearance >= mission.clearance - rounding) continue;
    here.violation = fmt::format("it comes back to {}{}, which it had got clear of after {:.2f} m; let a leg end where the vehicle is clear of it: on legs after that the load is an "
                                 "obstacle to the planner, too",
                                 title_of(load), proven.tightest ? fmt::format(" at ({:.3f}, {:.3f})", proven.tightest->x, proven.tightest->y) : "", *here.clear_after);
  }
  return found;
}

void judge_left_behind(const Scenario& mission, const LegBegin& begin, const Problem& problem, Plan& plan) {
  for (const LeftBehind& each : check_left_behind(mission, begin, problem, plan.path)) {
    if (each.violation) {
      if (plan.status == Status::solved) plan.status = Status::unproven;
      plan.reason += (plan.reason.empty() ? "" : "; ") + *each.violation;
    }
    plan.explanation.push_back(!each.clear_after ? fmt::format("The vehicle stays in {} all the way; nothing is proven of the two.", title_of(each.load))
                               : each.violation  ? fmt::format("This path is not proven: {}.", *each.violation)
                                                 : fmt::format("The vehicle stands in {} when it begins, and is clear of it after {:.2f} m: up to there nothing is proven of the "
                                                               "two, from there on that the clearance is kept from it.",
                                                               title_of(each.load), *each.clear_after));
  }
}

}  // namespace waywright
