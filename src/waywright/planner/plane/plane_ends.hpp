// From true poses to where the disc of a PlaneSpace can stand, and back: the ends of ways in the plane.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

/// Where a way in the plane begins or ends, and the straight run between there and the pose itself.
struct PlaneEnd {
  Vec2 at{};
  int run = 0;  ///< direction in which the run is driven: +1 forwards, −1 backwards; 0: there is none, `at` is the pose's position
};

/// Where the disc cannot stand at the pose, but the exact footprint can (a docked pose, one beside a wall), as short a straight run as leads to where it can: along the
/// pose's heading, of a footprint that is a disc in any of 32 directions. Empty where no run of up to `longest_run` metres does.
std::optional<PlaneEnd> plane_start(const PlaneSpace& space);
/// @pre the goal is a pose or a point
std::optional<PlaneEnd> plane_goal(const PlaneSpace& space);
/// m
double longest_run(const PlaneSpace& space);

/// Does the disc serve: can it stand at both ends, or where runs from there lead, and may a way of it join them?
bool disc_serves(const PlaneSpace& space);

/// A path along corners: lines with turns on the spot; of a vehicle that moves any way lines and arcs (see rounded_way.hpp) on which its heading goes evenly from the
/// start's to the goal's. `points` go from start.at to goal.at (where the goal's heading is free, to where the way ends); arcs keep `beyond` m more than is needed.
Path plane_path(const PlaneSpace& space, const PlaneEnd& start, const std::vector<Vec2>& points, const PlaneEnd& goal, double beyond = 0.0);

/// The same with corners rounded by arcs where there is room, for ways with many of them. (Where a run leads from the start or into the goal, a vehicle that does not
/// move any way drives corners.)
Path rounded_path(const PlaneSpace& space, const PlaneEnd& start, const std::vector<Vec2>& points, const PlaneEnd& goal, double beyond = 0.0);

/// Why `name` plans nothing at all here: a vehicle that cannot turn on the spot, nothing to drive. Empty where it can go on.
std::optional<std::string> nothing_to_plan(const Problem& problem, std::string_view name);

/// "0.0200 m and 0.2 mm more for the proof": what a way of the disc keeps.
std::string kept_words(const PlaneSpace& space);
/// Which planners plan for the footprint itself; empty where it is a disc, or the goal leaves the heading free.
std::string footprint_sentence(const Problem& problem);

/// That no run leads from the start, or into the goal, to where the disc can stand.
PlanningFailure no_room(const PlaneSpace& space, bool is_start);
/// What the runs at the ends are for. @pre there is one
std::string run_sentence(const PlaneSpace& space, const PlaneEnd& start, const PlaneEnd& goal);

/// "It is 8.062 m long and turns on the spot once, 12.3° in all."
std::string driving_sentence(const Problem& problem, const Path& path);

/// m
double length_of_way(const std::vector<Vec2>& points);

/// The same ends, fewer corners: each is left out that the ones before and after it see each other past, until none can be. Never longer.
std::vector<Vec2> taut_way(std::vector<Vec2> points, const PlaneSpace& space);

}  // namespace waywright
