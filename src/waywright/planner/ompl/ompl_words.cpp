#include "waywright/planner/ompl/ompl_words.hpp"

#include <fmt/format.h>

#include <utility>

#include "waywright/planner/steering/way_words.hpp"

namespace waywright::library {
namespace {

std::string counted(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string what_ended(const MotionTest& test, const Budget& budget) {
  if (budget.canceled()) return "it was canceled";
  if (budget.cut_short()) return fmt::format("the {:g} s of its budget were over", *budget.limits().seconds);
  if (test.motions() >= test.limits().motions) return "all candidate motions of its budget were tested";
  return "all footprint placements of its budget were tested";
}

const char* space_word(SteeringKind kind) {
  switch (kind) {
    case SteeringKind::plane: return "Plane";
    case SteeringKind::turns: return "Turns";
    case SteeringKind::dubins: return "Dubins";
    case SteeringKind::reeds_shepp: break;
  }
  return "Reeds-Shepp";
}

/// What was reached, where it grew from: "12 from the start and 3 from the goal" or "12 states in its tree".
std::string states_told(const Told& told) {
  const std::int64_t n = told.search.start_states;
  if (told.planner == SamplingPlanner::bit_star || told.planner == SamplingPlanner::ait_star) return counted(n, "free state", "free states") + " drawn";
  return fmt::format("{} in its {}", counted(n, "state", "states"), told.planner == SamplingPlanner::prm_star ? "roadmap" : "tree");
}

}  // namespace

std::string name_of_alternative(SamplingPlanner planner, SteeringKind kind) { return fmt::format("{}, {}", space_word(kind), label(planner)); }

PlanningFailure failed(const Told& told, const Problem& problem, const Path& nearest, Alternative alternative) {
  PlanningFailure failure;
  failure.failure.status = told.budget.canceled()    ? Status::canceled
                           : told.budget.cut_short() ? Status::timed_out
                                                     : Status::no_path;
  std::string& reason = failure.failure.reason;
  const SamplingResult& search = told.search;
  if (!search.error.empty()) {
    reason = fmt::format("{} could not search: {}", label(told.planner), search.error);
  } else {
    const Pose reached = search.reached.value_or(problem.start());
    failure.failure.pose = reached;
    const std::string states =
        told.planner == SamplingPlanner::rrt_connect
            ? fmt::format("{} from the start and {} from the goal", counted(search.start_states, "state reached", "states reached"), search.goal_states)
            : states_told(told);
    const std::string place = told.steering.has_headings() ? fmt::format("({:.3f}, {:.3f}, {:.4f} rad)", reached.x, reached.y, wrap(reached.heading)) : fmt::format("({:.3f}, {:.3f})", reached.x, reached.y);
    reason = fmt::format(
        "{} found no way from start to goal before {}: {} footprint placements in {} tested, {}; nearest to the goal it came to {}, where {:.2f} m of {} are missing", label(told.planner),
        what_ended(told.test, told.budget), told.test.placements(), counted(told.test.motions(), "motion", "motions"), states, place, search.missing, told.steering.piece_word());
    if (const Blocker blocker = told.test.worst_blocker(); !blocker.name.empty()) {
      reason += fmt::format("; {} stood in the way of {:.0f} % of the blocked placements", blocker.name,
                            100.0 * blocker.share);
      failure.failure.point = blocker.point;
    }
  }
  alternative.outcome = reason + ".";
  alternative.poses = poses_along(nearest);
  failure.explanation.push_back(reason + ".");
  failure.alternatives.push_back(std::move(alternative));
  return failure;
}

std::vector<std::string> explain(const Told& told, const Path& path, std::optional<double> before, bool is_shortest) {
  const WayCounts counts = counts_of(path);
  std::vector<std::string> text;
  text.push_back(fmt::format("This is the path of a sampling planner, {} with {}: another seed gives another path, and a shorter one may exist.", label(told.planner), told.steering.words()));
  if (is_shortest) text.back() = fmt::format("This is the path of a sampling planner, {} with {}: it is the least costly one that such motions can make between its ends.", label(told.planner), told.steering.words());
  std::string metres = fmt::format("It is {:.2f} m long", length(path));
  if (before) metres += fmt::format(", {:.2f} m before it was shortened", *before);
  const std::string with = ", with " + changes_words(counts, !told.steering.is_curve());
  const std::int64_t states = told.search.start_states + told.search.goal_states;
  const std::string reached = states == 0                                  ? std::string{"the motion from start to goal was free"}
                              : told.planner == SamplingPlanner::rrt_connect ? fmt::format("{} reached from start and goal", counted(states, "state was", "states were"))
                                                                           : fmt::format("it ended with {}", states_told(told));
  text.push_back(metres + with +
                 fmt::format("; {} and {} were tested, and {}.", counted(told.test.placements(), "footprint placement", "footprint placements"),
                             counted(told.test.motions(), "candidate motion", "candidate motions"), reached));
  if (std::string jumps = jumps_sentence(counts); !jumps.empty()) text.push_back(std::move(jumps));
  return text;
}

std::string outcome_of(const Path& path) {
  return fmt::format("{:.2f} m, {}.", length(path), changes_words(counts_of(path), false));
}

}  // namespace waywright::library
