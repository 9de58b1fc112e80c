#include "waywright/planner/docking/pattern_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "waywright/judge/entry.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

/// Where a path first comes nearer to something than it may, to 2 cm: for words, which the search has no time for.
struct FirstContact {
  double driven = 0.0;  ///< m
  std::optional<Contact> contact;
};
FirstContact first_contact(const PreparedDocking& prepared, const Path& path) {
  const Problem& problem = prepared.problem();
  for (const RoughPose& at : rough_poses(path, 0.02)) {
    if (prepared.is_surely_clear(at.pose) || problem.world().is_free(problem.footprint(), at.pose, problem.required_clearance())) continue;
    const Contact contact = problem.world().clearance(problem.footprint(), at.pose, problem.required_clearance() + 0.01);
    if (contact.clearance < problem.required_clearance()) return {at.driven, contact};
  }
  return {};
}

std::string infeasible_sentence(const Problem& problem, const SideOutcome& outcome, const SideFound& found) {
  const CandidateScore& score = found.score;
  std::string text = fmt::format("On the {} side no pattern fits: of {} candidates the best", to_string(outcome.side), found.evaluations);
  if (outcome.contact) {
    text += fmt::format(" came {:.1f} of {:.1f} m before it met {}", outcome.reach, score.measures.length, contact_words(problem, *outcome.contact));
  } else {
    const double limit = problem.vehicle().max_curvature();
    std::vector<std::string> needs;
    if (score.measures.max_curvature > limit) {
      needs.push_back(fmt::format("a curvature of {:.3f} 1/m (limit {:.3f})", score.measures.max_curvature, limit));
    }
    if (score.entry_excess > 0.0) needs.push_back(fmt::format("a slower start than at {:.2f} m/s", problem.motion()->speed));
    if (const auto rate = problem.vehicle().limits.curvature_rate; rate && score.max_curvature_rate > *rate) {
      needs.push_back(fmt::format("a curvature rate of {:.3f} 1/m² (limit {:.3f})", score.max_curvature_rate, *rate));
    }
    text += needs.empty() ? " needs as much curvature as the limits allow, and no reserve is left" : fmt::format(" needs {}", fmt::join(needs, " and "));
  }
  return text + ".";
}

/// Why the best of a side was refused.
std::string refusal_of(const Problem& problem, const SideFound& found, bool in_motion) {
  const Path whole = problem.whole_path(path_of(found), in_motion);
  const Proof proof = prove(problem, whole);
  if (!proof.violations.empty()) return proof.violations.front().sentence;
  SpeedWorkspace timing;
  const std::vector<Sample> samples = sample(whole, problem.footprint().radius(), proof.certificate.tolerance);
  const auto too_fast = check_entry(problem, samples, timing, zone_limits(problem, samples, proof.certificate.tolerance));
  return too_fast ? too_fast->sentence : "the proof did not confirm it";
}

SideOutcome outcome_of(const PreparedDocking& prepared, const TransitionZone& zone, const SideFound& found, const PatternSolver& solver, const Budget& budget) {
  const Problem& problem = prepared.problem();
  SideOutcome outcome;
  outcome.side = zone.side;
  if (!found.wanted && !solver.can_stop() && !zone.left_out()) {
    outcome.sentence = fmt::format("The {} side was not searched: the vehicle cannot come to rest in time.", to_string(zone.side));
    return outcome;
  }
  if (!found.wanted) {
    outcome.sentence = zone.left_out() ? left_out_sentence(zone) : fmt::format("The {} side was not asked for.", to_string(zone.side));
    return outcome;
  }
  if (!found.searched) {
    outcome.sentence = not_searched_sentence(zone.side, budget);
    return outcome;
  }
  const CandidateScore& score = found.score;
  outcome.searched = true;
  outcome.path = path_of(found);
  outcome.transition = make_pose(found.transition.position, angle_of(found.transition.heading));
  outcome.feasible = found.feasible && !found.refused;
  outcome.cost = found.cost;
  if (!score.free) {
    const FirstContact first = first_contact(prepared, outcome.path);
    // The search wants a little more room than is required: then where that is missing.
    outcome.contact = first.contact ? first.contact : problem.world().clearance(problem.footprint(), score.blocked_at, 1.0);
    outcome.reach = first.contact ? first.driven : score.reach * score.measures.length;
  }
  if (found.feasible) {
    outcome.sentence = fmt::format(
        "On the {} side the best of {} candidates costs {:.4f}: {:.2f} m long, change of curvature {:.3f} 1/m, greatest "
        "curvature {:.3f} 1/m.",
        to_string(zone.side), found.evaluations, outcome.cost, score.measures.length, score.measures.curvature_change, score.measures.max_curvature);
  } else {
    outcome.sentence = infeasible_sentence(problem, outcome, found);
  }
  if (found.given_up) outcome.sentence += " The search there was ended, as the other side is better by far.";
  if (found.refused) {
    outcome.refusal = refusal_of(problem, found, solver.in_motion());
    outcome.sentence += fmt::format(" It does not stand: {}.", outcome.refusal);
  }
  return outcome;
}

/// How a vehicle that moves comes to the pattern.
std::vector<std::string> entry_sentences(const Problem& problem, const PatternSolver& solver) {
  const auto& motion = problem.motion();
  if (!motion) return {};
  const char* way = problem.scenario().start_motion.word();
  if (!solver.can_stop() && !solver.in_motion()) return {};
  if (solver.in_motion()) {
    return {fmt::format("The vehicle moves {} at {:.2f} m/s with a curvature of {:.3f} 1/m when the plan begins, and goes on from there without stopping.", way,
                        motion->speed, motion->curvature)};
  }
  return {fmt::format("The vehicle moves {} at {:.2f} m/s when the plan begins and first stops, over {:.2f} m with the curvature that it has ({:.3f} 1/m), since {}.", way,
                      motion->speed, length(problem.stopping_stretch()), motion->curvature,
                      solver.tried_in_motion() ? "no pattern that begins in motion was found" : "a docking pattern begins backwards")};
}

}  // namespace

const char* pattern_name(const Problem& problem) { return std::holds_alternative<Station>(problem.scenario().mission) ? "docking pattern" : "pattern with one change of direction"; }

std::vector<SideOutcome> outcomes_of(const PreparedDocking& prepared, const PatternSolver& solver, const Budget& budget) {
  std::vector<SideOutcome> outcomes;
  const std::vector<TransitionZone>& zones = prepared.task().zones;
  for (std::size_t i = 0; i < zones.size(); ++i) outcomes.push_back(outcome_of(prepared, zones[i], solver.sides()[i], solver, budget));
  return outcomes;
}

std::vector<std::string> explain(const Problem& problem, const PatternDockingOptions& options, const PatternSolver& solver, const SideOutcome& best,
                                 const std::vector<SideOutcome>& outcomes, const char* of) {
  std::vector<std::string> text = entry_sentences(problem, solver);
  const SideOutcome* other = nullptr;
  for (const SideOutcome& outcome : outcomes) {
    if (&outcome != &best) other = &outcome;
  }
  if (other != nullptr && other->feasible) {
    const double more = 100.0 * (other->cost / best.cost - 1.0);
    text.push_back(more < 0.05 ? fmt::format("Both sides of the {} cost the same, {:.4f}; the {} one was taken.", of, best.cost, to_string(best.side))
                               : fmt::format("The {} side of the {} was chosen: its cost is {:.4f}, the {} side's {:.4f} ({:.1f} % more).", to_string(best.side),
                                             of, best.cost, to_string(other->side), other->cost, more));
  } else if (other != nullptr && other->searched) {
    text.push_back(fmt::format("The {} side of the {} was chosen because nothing was found on the other one.", to_string(best.side), of));
  } else {
    text.push_back(fmt::format("The {} side of the {} was taken; the other one was not looked at.", to_string(best.side), of));
  }
  const double back = length(best.path.pieces[0]);
  const double forth = length(best.path.pieces[1]);
  const Pose& docked = problem.goal();
  // Only at a shelf are there forks that come first, and a pose that is docked.
  const bool docks = std::holds_alternative<Station>(problem.scenario().mission);
  const char* forwards = docks && !problem.vehicle().footprint.is_disc() ? "forks first" : "forwards";
  text.push_back(
      problem.is_driven_back()
          ? fmt::format("The vehicle backs {:.2f} m from the docked pose ({:.3f}, {:.3f}) to the transition point ({:.3f}, {:.3f}), the first {:.2f} m "
                        "straight, stops, and drives {:.2f} m {} to the last pose.",
                        forth, docked.x, docked.y, best.transition.x, best.transition.y, options.leads.dock, back, forwards)
          : fmt::format("The vehicle backs {:.2f} m to the transition point ({:.3f}, {:.3f}), stops, and drives {:.2f} m {} into the "
                        "{} ({:.3f}, {:.3f}); the last {:.2f} m are straight.",
                        back, best.transition.x, best.transition.y, forth, forwards, docks ? "docked pose" : "goal pose", docked.x, docked.y, options.leads.dock));
  text.push_back(fmt::format("The cost is {:.2g} × change of curvature + {:.2g} × length, each over that of the reference "
                             "pattern{}; among the candidates that keep every limit and {:.3f} m from everything it is the "
                             "least found.",
                             options.weights.curvature, options.weights.length,
                             options.objective == DockingObjective::normalised ? "" : " by the exponential form",
                             problem.required_clearance()));
  for (const SideOutcome& outcome : outcomes) text.push_back(outcome.sentence);
  return text;
}

PlanningFailure failure_of(const Problem& problem, const DockingTask& task, const PatternSolver& solver, const std::vector<SideOutcome>& outcomes,
                           const Budget& budget) {
  PlanningFailure failure;
  failure.explanation = entry_sentences(problem, solver);
  std::vector<std::string> sides;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const SideOutcome& outcome = outcomes[i];
    failure.explanation.push_back(outcome.sentence);
    if (outcome.contact && !failure.failure.point) failure.failure.point = outcome.contact->point;
    const std::string why = task.zones[i].left_out() ? "too narrow"
                            : !outcome.searched      ? "not searched"
                            : outcome.contact        ? "blocked by " + contact_words(problem, *outcome.contact)
                            : !outcome.refusal.empty() ? "refused (" + outcome.refusal + ")"
                            : solver.sides()[i].score.entry_excess > 0.0 ? "too short or too bent for the speed that the vehicle has"
                                                                         : "over the limit of curvature or its rate";
    sides.push_back(fmt::format("{} side {}", to_string(outcome.side), why));
  }
  failure.failure.status = budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path;
  failure.failure.reason = fmt::format("no {} fits: {}", pattern_name(problem), fmt::join(sides, ", "));
  if (const auto stop = problem.check_stop()) {
    failure.failure.reason += "; " + stop->reason;
    failure.failure.point = stop->point;
  }
  failure.alternatives = alternatives_of(task, outcomes, nullptr);
  return failure;
}

std::string optimality_sentence(const Optimality& o) {
  return fmt::format("Branch and bound over {} boxes of transition points and headings: no docking pattern of this form on the sides searched costs less than "
                     "{:.4f}, so this one is at most {:.1f} % above the optimum.",
                     o.boxes, o.lower_bound, 100.0 * o.gap());
}

}  // namespace waywright
