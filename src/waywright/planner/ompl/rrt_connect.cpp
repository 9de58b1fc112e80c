#include "waywright/planner/ompl/rrt_connect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "waywright/planner/steering/shortcut.hpp"
#include "waywright/planner/ompl/tree_search.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

constexpr double least_curvature =
    1e-3;  // 1/m: on larger circles the words' rounding is no longer small against tolerances
constexpr double tight =
    0.002;  // m: an end with less than this beyond the required clearance is driven straight
constexpr double straight_run = 0.05;       // m
constexpr double picture_tolerance = 0.01;  // m

std::string counted(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

struct Counts {
  int direction_changes = 0;
  int curvature_jumps = 0;  ///< while the direction stays
};

Counts count(const Path& path) {
  Counts counts;
  for (std::size_t i = 1; i < path.pieces.size(); ++i) {
    const Piece& a = path.pieces[i - 1];
    const Piece& b = path.pieces[i];
    if (a.direction != b.direction) {
      ++counts.direction_changes;
    } else if (end_curvature(a) != start_curvature(b)) {
      ++counts.curvature_jumps;
    }
  }
  return counts;
}

std::vector<Pose> picture_of(const Path& path) {
  std::vector<Pose> poses;
  if (path.pieces.empty()) return poses;
  for (const Sample& s : sample(path, 0.0, picture_tolerance, 0.12)) poses.push_back(s.pose());
  return poses;
}

double turning_radius(double curvature, const RrtConnectOptions& options) {
  return std::isfinite(curvature) ? options.radius_factor / curvature : options.radius_without_limit;
}

/// An end of the task that just keeps its clearance, as a docked pose may, and the straight run between it
/// and `pose`: on a line the clearance there is the same as at the end itself, on an arc it could be shown
/// only up to the proof's tolerance.
struct End {
  Pose pose;
  std::optional<Piece> run;
};

End end_of_search(MotionTest& test, const Pose& pose, bool is_start) {
  if (test.pose_free_by(pose, tight)) return {pose, std::nullopt};
  for (const double side : {-1.0, 1.0}) {  // backing off first: forks stand in front
    const Vec2 away = pose.position() + side * straight_run * unit(pose.heading);
    const bool forward = (side > 0.0) == is_start;
    const Piece run{is_start ? Line{pose.position(), away} : Line{away, pose.position()}, forward ? 1 : -1};
    const Pose there = make_pose(away, pose.heading);
    if (test.pose_free_by(there, tight) && test.motion_free(std::span{&run, 1})) return {there, run};
  }
  return {pose, std::nullopt};
}

/// The goal with a straight run forwards into it; the pose of the goal itself where that run is not free.
End goal_with_run(MotionTest& test, const Pose& goal, double run) {
  const Vec2 before = goal.position() - run * unit(goal.heading);
  const Piece piece{Line{before, goal.position()}, 1};
  if (!test.motion_free(std::span{&piece, 1})) return {goal, std::nullopt};
  return {make_pose(before, goal.heading), piece};
}

Path with_runs(const End& start, const Path& middle, const End& goal) {
  Path path;
  if (start.run) append_merged(path.pieces, *start.run);
  for (const Piece& piece : middle.pieces) append_merged(path.pieces, piece);
  if (goal.run) append_merged(path.pieces, *goal.run);
  return path;
}

std::string what_ended(const MotionTest& test, const Budget& budget) {
  if (budget.canceled()) return "it was canceled";
  if (budget.cut_short()) return fmt::format("the {:g} s of its budget were over", *budget.limits().seconds);
  if (test.motions() >= test.limits().motions) return "all candidate motions of its budget were tested";
  return "all footprint placements of its budget were tested";
}

PlanningFailure failed(const Problem& problem, const TreeSearchResult& search, const MotionTest& test,
                       const Budget& budget, Alternative alternative) {
  PlanningFailure failure;
  failure.failure.status = budget.canceled()    ? Status::canceled
                           : budget.cut_short() ? Status::timed_out
                                                : Status::no_path;
  std::string& reason = failure.failure.reason;
  if (!search.error.empty()) {
    reason = fmt::format("RRTConnect could not search: {}", search.error);
  } else {
    const Pose reached = search.nearest.pieces.empty() ? problem.start() : end_pose(search.nearest);
    failure.failure.pose = reached;
    reason = fmt::format(
        "RRTConnect found no way from start to goal before {}: {} footprint placements in {} tested, {} from "
        "the start and {} "
        "from the goal; nearest to the goal it came to ({:.3f}, {:.3f}, {:.4f} rad), where {:.2f} m of "
        "Reeds-Shepp curve are missing",
        what_ended(test, budget), test.placements(), counted(test.motions(), "motion", "motions"),
        counted(search.start_states, "state reached", "states reached"), search.goal_states, reached.x,
        reached.y, reached.heading, search.missing);
    if (const Blocker blocker = test.worst_blocker(); !blocker.name.empty()) {
      reason += fmt::format("; {} stood in the way of {:.0f} % of the blocked placements", blocker.name,
                            100.0 * blocker.share);
      failure.failure.point = blocker.point;
    }
  }
  alternative.outcome = reason + ".";
  alternative.poses = picture_of(search.nearest);
  failure.explanation.push_back(reason + ".");
  failure.alternatives.push_back(std::move(alternative));
  return failure;
}

std::vector<std::string> explain(const Path& found, const Path& path, const Counts& counts, double radius,
                                 bool simplify, const TreeSearchResult& search, const MotionTest& test) {
  std::vector<std::string> text;
  text.push_back(
      fmt::format("This is the path of a sampling planner, RRTConnect with Reeds-Shepp curves of {:.3f} m "
                  "turning radius: "
                  "another seed gives another path, and a shorter one may exist.",
                  radius));
  std::string metres = fmt::format("It is {:.2f} m long", length(path));
  if (simplify) metres += fmt::format(", {:.2f} m before it was shortened", length(found));
  text.push_back(metres +
                 fmt::format(", with {}; {} and {} were tested, and {} reached from start and goal.",
                             counted(counts.direction_changes, "change of direction", "changes of direction"),
                             counted(test.placements(), "footprint placement", "footprint placements"),
                             counted(test.motions(), "candidate motion", "candidate motions"),
                             counted(search.start_states + search.goal_states, "state was", "states were")));
  if (counts.curvature_jumps > 0) {
    text.push_back(fmt::format(
        "Its curvature jumps at {} between changes of direction: there a vehicle whose steering takes "
        "time stops and turns the steered wheel.",
        counted(counts.curvature_jumps, "place", "places")));
  }
  return text;
}

}  // namespace

PlanningResult RrtConnectPlanner::plan(const Problem& problem, Budget& budget) const {
  const double curvature = problem.vehicle().max_curvature();
  Alternative alternative;
  alternative.name = "Reeds-Shepp, RRTConnect";
  MotionTestLimits limits;
  limits.placements = budget.limits().samples.value_or(options_.checks);
  limits.motions = budget.evaluations_left().value_or(std::numeric_limits<std::int64_t>::max());
  limits.resolution = options_.resolution;
  MotionTest test{problem, limits, budget};
  const ReedsShepp curves{turning_radius(std::max(curvature, least_curvature), options_)};

  TreeSearchResult search;
  End start{problem.start(), std::nullopt};
  End goal{problem.goal(), std::nullopt};
  if (curvature < least_curvature) {
    search.error = fmt::format(
        "the vehicle's curvature limit of {:g} 1/m is under the {:g} 1/m that Reeds-Shepp curves need",
        curvature, least_curvature);
  } else if (curves.between(problem.start(), problem.goal()).empty()) {
    search.error = "start and goal are the same pose, there is nothing to drive";
  } else {
    start = end_of_search(test, problem.start(), true);
    goal = options_.goal_straight > 0.0 ? goal_with_run(test, problem.goal(), options_.goal_straight) : end_of_search(test, problem.goal(), false);
    if (options_.goal_straight > 0.0 && !goal.run) {
      search.error = fmt::format("the straight run of {:g} m into the goal is not free", options_.goal_straight);
    }
  }
  if (search.error.empty()) {
    search = tree_search(problem, {start.pose, goal.pose}, curves, test, options_.range, seed_);
  }
  if (!search.path || (search.path->pieces.empty() && !start.run && !goal.run)) {
    budget.count_evaluations(test.motions());
    return tl::unexpected{failed(problem, search, test, budget, std::move(alternative))};
  }

  const Path found = with_runs(start, *search.path, goal);
  Planned planned;
  planned.path = found;
  if (options_.simplify && !search.path->pieces.empty()) {
    planned.path = with_runs(start, shortened(*search.path, curves, test, options_.shortcuts, seed_), goal);
  }
  budget.count_evaluations(test.motions());
  const Counts counts = count(planned.path);
  planned.explanation =
      explain(found, planned.path, counts, curves.radius(), options_.simplify, search, test);
  alternative.chosen = true;
  alternative.cost = length(planned.path);
  alternative.is_length = true;
  alternative.outcome =
      fmt::format("{:.2f} m, {}.", *alternative.cost,
                  counted(counts.direction_changes, "change of direction", "changes of direction"));
  alternative.poses = picture_of(planned.path);
  planned.alternatives.push_back(std::move(alternative));
  return planned;
}

PlannerDescription rrt_connect_description() {
  constexpr RrtConnectOptions defaults;
  return {
      "ompl_rrt_connect",
      "RRTConnect with Reeds-Shepp curves by OMPL, shortened; for any goal pose, stops to steer where the "
      "curvature jumps",
      {
          {.name = "radius_factor",
           .default_value = defaults.radius_factor,
           .summary = "turning radius over the least one that the vehicle can drive",
           .low = 1.0,
           .high = 100.0},
          {.name = "radius_without_limit",
           .default_value = defaults.radius_without_limit,
           .summary = "turning radius of a vehicle without a curvature limit",
           .unit = "m",
           .low = 0.01,
           .high = 100.0},
          {.name = "range",
           .default_value = defaults.range,
           .summary = "longest motion that a tree grows by at once; 0: a fifth of the extent searched",
           .unit = "m",
           .low = 0.0,
           .high = 1e4},
          {.name = "resolution",
           .default_value = defaults.resolution,
           .summary = "motions are tested down to this length; passages that are wider by less are missed",
           .unit = "m",
           .low = 1e-4,
           .high = 0.1},
          {.name = "checks",
           .default_value = static_cast<double>(defaults.checks),
           .summary = "footprint placements that may be tested; budget.samples takes its place",
           .low = 1,
           .high = 1e9,
           .whole = true},
          {.name = "goal_straight",
           .default_value = defaults.goal_straight,
           .summary = "length of the straight run forwards into the goal; 0: as it comes",
           .unit = "m",
           .low = 0.0,
           .high = 20.0},
          {.name = "simplify", .default_value = defaults.simplify, .summary = "shorten the path found"},
          {.name = "shortcuts",
           .default_value = static_cast<double>(defaults.shortcuts),
           .summary = "shortcuts tried on the path found",
           .low = 0,
           .high = 1e6,
           .whole = true},
      },
      [](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
        RrtConnectOptions options;
        options.radius_factor = number_of(p, "radius_factor");
        options.radius_without_limit = number_of(p, "radius_without_limit");
        options.range = number_of(p, "range");
        options.resolution = number_of(p, "resolution");
        options.checks = whole_number_of(p, "checks");
        options.goal_straight = number_of(p, "goal_straight");
        options.simplify = flag_of(p, "simplify");
        options.shortcuts = static_cast<int>(number_of(p, "shortcuts"));
        return RrtConnectPlanner{options, seed};
      },
      [](const Parameters&) { return true; }};
}

}  // namespace waywright
