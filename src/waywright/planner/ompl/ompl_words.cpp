#include "waywright/planner/ompl/ompl_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright::library {
namespace {

constexpr double picture_tolerance = 0.01;  // m

std::string counted(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

struct Counts {
  int direction_changes = 0;
  int curvature_jumps = 0;  ///< while the direction stays
  int turns = 0;            ///< on the spot
  double turning = 0.0;     ///< rad, in all
};

Counts count(const Path& path) {
  Counts counts;
  int direction = 0;
  const Piece* before = nullptr;
  for (const Piece& piece : path.pieces) {
    if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
      ++counts.turns;
      counts.turning += std::abs(turn->angle);
      before = nullptr;
      continue;
    }
    if (direction != 0 && piece.direction != direction) {
      ++counts.direction_changes;
    } else if (before != nullptr && end_curvature(*before) != start_curvature(piece)) {
      ++counts.curvature_jumps;
    }
    direction = piece.direction;
    before = &piece;
  }
  return counts;
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

std::vector<Pose> picture_of(const Path& path) {
  std::vector<Pose> poses;
  if (path.pieces.empty()) return poses;
  for (const Sample& s : sample(path, 0.0, picture_tolerance, 0.12)) poses.push_back(s.pose());
  return poses;
}

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
    const std::string place = told.steering.has_headings() ? fmt::format("({:.3f}, {:.3f}, {:.4f} rad)", reached.x, reached.y, reached.heading) : fmt::format("({:.3f}, {:.3f})", reached.x, reached.y);
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
  alternative.poses = picture_of(nearest);
  failure.explanation.push_back(reason + ".");
  failure.alternatives.push_back(std::move(alternative));
  return failure;
}

std::vector<std::string> explain(const Told& told, const Path& path, std::optional<double> before, bool is_shortest) {
  const Counts counts = count(path);
  std::vector<std::string> text;
  text.push_back(fmt::format("This is the path of a sampling planner, {} with {}: another seed gives another path, and a shorter one may exist.", label(told.planner), told.steering.words()));
  if (is_shortest) text.back() = fmt::format("This is the path of a sampling planner, {} with {}: it is the least costly one that such motions can make between its ends.", label(told.planner), told.steering.words());
  std::string metres = fmt::format("It is {:.2f} m long", length(path));
  if (before) metres += fmt::format(", {:.2f} m before it was shortened", *before);
  std::string with = fmt::format(", with {}", counted(counts.direction_changes, "change of direction", "changes of direction"));
  if (!told.steering.is_curve()) with += fmt::format(" and {}, {:.1f}° in all", counted(counts.turns, "turn on the spot", "turns on the spot"), counts.turning * 180.0 / pi);
  const std::int64_t states = told.search.start_states + told.search.goal_states;
  const std::string reached = told.planner == SamplingPlanner::rrt_connect ? fmt::format("{} reached from start and goal", counted(states, "state was", "states were"))
                              : states == 0                                ? std::string{"the motion from start to goal was free"}
                                                                           : fmt::format("it ended with {}", states_told(told));
  text.push_back(metres + with +
                 fmt::format("; {} and {} were tested, and {}.", counted(told.test.placements(), "footprint placement", "footprint placements"),
                             counted(told.test.motions(), "candidate motion", "candidate motions"), reached));
  if (counts.curvature_jumps > 0) {
    text.push_back(fmt::format(
        "Its curvature jumps at {} between changes of direction: there a vehicle whose steering takes "
        "time stops and turns the steered wheel.",
        counted(counts.curvature_jumps, "place", "places")));
  }
  return text;
}

std::string outcome_of(const Path& path) {
  return fmt::format("{:.2f} m, {}.", length(path), counted(count(path).direction_changes, "change of direction", "changes of direction"));
}

}  // namespace waywright::library
