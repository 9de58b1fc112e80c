#include "waywright/planner/grid/way_to_goal.hpp"

#include <fmt/format.h>

#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/grid/grid_words.hpp"

namespace waywright::grid {

Path way_to_goal(const Problem& problem, std::vector<Action> actions) {
  const FreeGoal* free = problem.free_goal();
  if (free == nullptr) return path_of(problem.start(), actions, problem.goal());
  if (free->is_point()) actions.push_back({Action::Kind::drive, 0.0, problem.goal().position(), 1});  // of a footprint with a shape it is there already
  return path_along(problem.start(), actions);
}

std::string length_sentence(const Problem& problem, const Path& path) {
  const Turning turning = turning_of(path);
  return fmt::format("It is {:.3f} m long, the straight line from start to goal {:.3f} m, less than which no way can be; it turns on the spot {}, {:.1f}° in all.", length(path), least_way(problem),
                     turning.turns == 1 ? std::string{"once"} : fmt::format("{} times", turning.turns), turning.angle * 180.0 / pi);
}

std::string disc_sentence(double radius) {
  return fmt::format("It was searched for the disc around the footprint, {:.3f} m, which can turn wherever it can stand; astar finds narrower ways.", radius);
}

PlanningFailure not_connected(const Problem& problem, const GridFrame& frame, bool is_start, const std::string& of_what) {
  const Pose& pose = is_start ? problem.start() : problem.goal();
  if (const FreeGoal* free = problem.free_goal(); !is_start && free != nullptr && !free->is_point()) {
    return failure(Status::no_path, fmt::format("no cell of {:g} m has its middle in the goal's region; try a finer resolution", frame.cell), pose);
  }
  return failure(Status::no_path,
                 fmt::format("{} the {} at {} no straight drive {} the middle of a cell of {:g} m around it{}; try a finer resolution", is_start ? "from" : "to", is_start ? "start" : "goal",
                             place(pose.position()), is_start ? "leads to" : "leads from", frame.cell, of_what),
                 pose);
}

}  // namespace waywright::grid
