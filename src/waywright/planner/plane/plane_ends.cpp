#include "waywright/planner/plane/plane_ends.hpp"

#include <fmt/format.h>

#include <cmath>

#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/grid/motion_check.hpp"
#include "waywright/planner/plane/rounded_way.hpp"

namespace waywright {
namespace {

constexpr double run_step = 0.02;  // m
constexpr int disc_directions = 32;

/// `is_start`: the run is driven from the pose, else into it.
std::optional<PlaneEnd> end_at(const PlaneSpace& space, const Pose& pose, bool is_start, bool is_heading_free) {
  if (space.is_free(pose.position())) return PlaneEnd{pose.position(), 0};
  const Problem& problem = space.problem();
  const bool any_direction = problem.footprint().is_disc();
  if (is_heading_free && !any_direction) return std::nullopt;  // of a footprint with a shape nobody knows how it is to stand there
  MotionCheck test{problem};
  const double margin = connecting_margin(problem);
  const auto steps = static_cast<int>(longest_run(space) / run_step);
  for (int k = 1; k <= steps; ++k) {
    for (int i = 0; i < (any_direction ? disc_directions : 2); ++i) {
      const double course = any_direction ? pose.heading + i * (two_pi / disc_directions) : i == 0 ? pose.heading + pi : pose.heading;
      const Vec2 there = pose.position() + (k * run_step) * unit(wrap(course));
      if (!space.is_free(there)) continue;
      const bool is_drive_free = is_start ? test.is_drive_free(pose.position(), there, pose.heading, margin) : test.is_drive_free(there, pose.position(), pose.heading, margin);
      if (!is_drive_free) continue;
      if (any_direction) return PlaneEnd{there, 1};  // it turns first
      const bool is_ahead = i == 1;
      return PlaneEnd{there, is_ahead == is_start ? 1 : -1};
    }
  }
  return std::nullopt;
}

/// The runs at the ends without turning, as they were tested; the heading goes from the one to the other between them.
Path slid_path(const PlaneSpace& space, const PlaneEnd& start, const std::vector<Vec2>& points, const PlaneEnd& goal, double beyond) {
  const Problem& problem = space.problem();
  Path path;
  const auto run = [&](Vec2 from, Vec2 to, double heading) {
    if (distance(from, to) > 0.0) path.pieces.push_back({Line{from, to}, 1, HeadingAlong{heading, 0.0}});
  };
  const Pose& from = problem.start();
  const bool is_free = problem.free_goal() != nullptr;
  const double turn = is_free ? 0.0 : shorter_turn(from.heading, problem.goal().heading);
  if (start.run != 0) run(from.position(), start.at, from.heading);
  for (Piece& piece : driven_way(space, points, from.heading, turn, beyond).pieces) path.pieces.push_back(std::move(piece));
  if (goal.run != 0) run(goal.at, problem.goal().position(), is_free ? from.heading : problem.goal().heading);
  return path;
}

}  // namespace

double longest_run(const PlaneSpace& space) { return 6.0 * space.needed() + 0.5; }

std::optional<PlaneEnd> plane_start(const PlaneSpace& space) { return end_at(space, space.problem().start(), true, false); }

std::optional<PlaneEnd> plane_goal(const PlaneSpace& space) { return end_at(space, space.problem().goal(), false, space.problem().free_goal() != nullptr); }

bool disc_serves(const PlaneSpace& space) {
  const auto start = plane_start(space), goal = plane_goal(space);
  return start && goal && space.may_join(start->at, goal->at);
}

Path plane_path(const PlaneSpace& space, const PlaneEnd& start, const std::vector<Vec2>& points, const PlaneEnd& goal, double beyond) {
  const Problem& problem = space.problem();
  if (problem.vehicle().moves_any_way()) return slid_path(space, start, points, goal, beyond);
  std::vector<Action> actions;
  if (start.run != 0) actions.push_back({Action::Kind::drive, 0.0, start.at, start.run});
  for (std::size_t i = 1; i < points.size(); ++i) actions.push_back({Action::Kind::drive, 0.0, points[i], 1});
  if (goal.run != 0) actions.push_back({Action::Kind::drive, 0.0, problem.goal().position(), goal.run});
  return problem.free_goal() != nullptr ? path_along(problem.start(), actions) : path_of(problem.start(), actions, problem.goal());
}

Path rounded_path(const PlaneSpace& space, const PlaneEnd& start, const std::vector<Vec2>& points, const PlaneEnd& goal, double beyond) {
  const Problem& problem = space.problem();
  if (problem.vehicle().moves_any_way() || start.run != 0 || goal.run != 0) return plane_path(space, start, points, goal, beyond);
  Path path = driven_way(space, points, problem.start().heading, problem.free_goal() != nullptr ? 0.0 : shorter_turn(problem.start().heading, problem.goal().heading), beyond);
  const bool ends_in_turn = !path.pieces.empty() && path.pieces.back().direction == 0 && path.pieces.size() > 1;
  if (problem.free_goal() != nullptr && ends_in_turn) path.pieces.pop_back();  // as the last drive has it
  return path;
}

std::optional<std::string> nothing_to_plan(const Problem& problem, std::string_view name) {
  if (!problem.vehicle().can_turn_on_the_spot()) return fmt::format("{} plans straight lines with turns on the spot, which a tricycle cannot drive", name);
  if (problem.free_goal() != nullptr && problem.is_goal(problem.start(), 0.0, 0.0)) return "the start is at the goal already, there is nothing to drive";
  if (problem.free_goal() == nullptr && problem.start() == problem.goal()) return "start and goal are the same pose, there is nothing to drive";
  return std::nullopt;
}

std::string kept_words(const PlaneSpace& space) {
  const double required = space.problem().required_clearance();
  return fmt::format("{:.4f} m and {:.1f} mm more for the proof", required, (space.needed() - space.disc() - required) * 1e3);
}

std::string footprint_sentence(const Problem& problem) {
  if (problem.footprint().is_disc() || problem.free_goal() != nullptr) return {};
  return "prm and rrt_star with the space \"turns\" plan for the footprint itself";
}

PlanningFailure no_room(const PlaneSpace& space, bool is_start) {
  const Problem& problem = space.problem();
  const Pose& pose = is_start ? problem.start() : problem.goal();
  const std::string itself = footprint_sentence(problem);
  return grid::failure(Status::no_path,
                       fmt::format("{} the {} at {} no straight run of up to {:.2f} m leads {} where {} of {:.3f} m can stand and keep {}{}{}", is_start ? "from" : "to", is_start ? "start" : "goal",
                                   grid::place(pose.position()), longest_run(space), is_start ? "to" : "from", problem.footprint().is_disc() ? "the disc" : "the disc around the footprint,",
                                   space.disc(), kept_words(space), itself.empty() ? "" : "; ", itself),
                       pose);
}

std::string run_sentence(const PlaneSpace& space, const PlaneEnd& start, const PlaneEnd& goal) {
  const Problem& problem = space.problem();
  const auto run = [](Vec2 a, Vec2 b, int direction) { return fmt::format("{:.2f} m {}", distance(a, b), direction > 0 ? "forwards" : "backwards"); };
  std::string text = "Where the disc around the footprint cannot stand the vehicle drives straight, tested for the footprint itself: ";
  if (start.run != 0) text += run(problem.start().position(), start.at, start.run) + " from the start";
  if (start.run != 0 && goal.run != 0) text += ", ";
  if (goal.run != 0) text += run(goal.at, problem.goal().position(), goal.run) + " into the goal";
  return text + ".";
}

std::string driving_sentence(const Problem& problem, const Path& path) {
  if (problem.vehicle().moves_any_way()) {
    double turned = 0.0;
    for (const Piece& piece : path.pieces) turned += piece.heading ? std::abs(piece.heading->turn) : 0.0;
    return fmt::format("It is {:.3f} m long, and the vehicle {} while it drives.", length(path), turned > 0.0 ? fmt::format("turns by {:.1f}°", turned * 180.0 / pi) : std::string{"keeps its heading"});
  }
  const Turning turning = turning_of(path);
  return fmt::format("It is {:.3f} m long and turns on the spot {}, {:.1f}° in all.", length(path), turning.turns == 1 ? std::string{"once"} : fmt::format("{} times", turning.turns),
                     turning.angle * 180.0 / pi);
}

double length_of_way(const std::vector<Vec2>& points) {
  double metres = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) metres += distance(points[i - 1], points[i]);
  return metres;
}

std::vector<Vec2> taut_way(std::vector<Vec2> points, const PlaneSpace& space) {
  bool is_changed = true;
  while (is_changed && points.size() > 2) {
    is_changed = false;
    std::vector<Vec2> kept{points.front()};
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (space.is_free(kept.back(), points[i + 1])) {
        is_changed = true;
      } else {
        kept.push_back(points[i]);
      }
    }
    kept.push_back(points.back());
    points = std::move(kept);
  }
  return points;
}

}  // namespace waywright
