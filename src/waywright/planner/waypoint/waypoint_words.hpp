// What a plan through waypoints says of itself, and why there is none.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/waypoint/candidates.hpp"

namespace waywright {

/// "1 candidate", "2 candidates".
std::string counted(std::int64_t n, const char* one);

/// Which courses were chosen among how many candidates, for which objective, and what it is with the courses in the middle of their ranges; without
/// waypoints that there is nothing to choose.
std::string courses_sentence(const Problem& problem, WaypointObjective objective, std::span<const double> x, const Evaluation& chosen, const Evaluation& of_middle, std::int64_t looked);

/// Curvature and its rate, with the vehicle's limits.
std::string limits_sentence(const Problem& problem, const Clothoids& chain, Continuity continuity);

/// How near the footprint's corners come.
std::string measures_sentence(const TrajectoryMeasures& measures);

/// A chain as poses, for the picture.
std::vector<Pose> picture_of(const Clothoids& chain);

/// A waypoint that has to be met where nothing can be: no search would help.
std::optional<PlanningFailure> blocked_waypoint(const Problem& problem);

/// Why a chain that is not feasible cannot be driven: "touches obstacle 8 at (8.700, 1.900)"; and where, if it is at one place.
struct Refusal {
  std::string why;
  std::optional<WaypointCandidates::Tightest> where;
};
Refusal refusal_of(const Problem& problem, WaypointCandidates& candidates, const Clothoids& chain);

/// Why the best of the candidates looked at cannot be driven.
PlanningFailure failure_of(const Problem& problem, WaypointCandidates& candidates, const Clothoids& chain, std::int64_t looked, const Budget& budget);

/// Where not even a chain was found; `unsolved`: a leg that has none, if one is known.
PlanningFailure failure_without_chain(const Problem& problem, std::int64_t looked, std::optional<std::size_t> unsolved, const Budget& budget);

}  // namespace waywright
