#include "waywright/planner/field/way_ends.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/grid/motion_check.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {

using grid::failure;

tl::expected<CellEnds, PlanningResult> cell_ends(const PlaneSpace& space, const GridFrame& frame, const std::string& refused, std::string_view name, Budget& budget) {
  const Problem& problem = space.problem();
  const auto ends_with = [](PlanningResult result) { return tl::unexpected<PlanningResult>{std::move(result)}; };
  const auto fails = [&](PlanningFailure why) { return ends_with(tl::unexpected{std::move(why)}); };
  if (auto reason = nothing_to_plan(problem, name)) return fails(failure(Status::no_path, std::move(*reason)));
  if (!refused.empty()) return fails(failure(Status::no_path, refused));
  if (budget.exhausted()) return fails(grid::nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, 0, budget, frame.cell, ""));
  budget.count_evaluations();
  CellEnds ends;
  ends.is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
  const auto start = plane_start(space);
  const auto goal = ends.is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space);
  if (!start || !goal) return fails(no_room(space, !start));
  ends.start = *start;
  ends.goal = *goal;
  if (!ends.is_region && start->run == 0 && goal->run == 0 && start->at == goal->at) {  // nothing but a turn
    Planned planned;
    planned.path = plane_path(space, *start, {start->at}, *goal);
    planned.explanation.push_back("Start and goal are one place: the vehicle turns there.");
    return ends_with(std::move(planned));
  }
  MotionCheck test{problem, Footprint{{}, space.disc()}};
  ends.from = disc_connections(problem, frame, start->at, true, test);
  if (ends.is_region) {
    for (const Cell c : region_cells(problem, frame)) ends.goals.push_back({c, 0.0});
  } else {
    ends.goals = disc_connections(problem, frame, goal->at, false, test);
  }
  std::erase_if(ends.goals, [&](const DiscConnection& c) { return !space.is_free(frame.centre(c.cell)); });
  if (ends.from.empty() || ends.goals.empty()) {
    return fails(failure(Status::no_path, fmt::format("around the {} there is no cell of {:g} m whose middle is free and can be driven to; try a finer resolution", ends.from.empty() ? "start" : "goal", frame.cell),
                         ends.from.empty() ? problem.start() : problem.goal()));
  }
  return ends;
}

PlanningFailure not_connected(const PlaneSpace& space, const std::string& reason, Budget& budget) {
  const Problem& problem = space.problem();
  std::string whole = fmt::format("{}, for {} of {:.3f} m that keeps {:.3f} m", reason, problem.footprint().is_disc() ? "a disc" : "the disc around the footprint,", space.disc(), problem.required_clearance());
  if (const std::string more = unreachable_sentence(least_length(space, budget), problem); !more.empty()) whole += "; " + more;
  return failure(Status::no_path, std::move(whole));
}

PlanningResult finished_plan(const PlaneSpace& space, Path path, const PlaneEnd& start, const PlaneEnd& goal, std::vector<std::string> text, Budget& budget) {
  if (path.pieces.empty()) return tl::unexpected{failure(Status::no_path, "start and goal are the same place, there is nothing to drive")};
  if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space, start, goal));
  text.push_back(driving_sentence(space.problem(), path));
  if (std::string bound = bound_sentence(least_length(space, budget), length(path)); !bound.empty()) text.push_back(std::move(bound));
  Planned planned;
  planned.path = std::move(path);
  planned.explanation = std::move(text);
  return planned;
}

}  // namespace waywright
