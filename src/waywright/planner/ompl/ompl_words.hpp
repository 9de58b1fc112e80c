// What the planners of OMPL tell of their search.
#pragma once

#include <string>
#include <vector>

#include "waywright/planner/ompl/sampling_search.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright::library {

struct Told {
  SamplingPlanner planner = SamplingPlanner::rrt_connect;
  const Steering& steering;
  const MotionTest& test;
  const Budget& budget;
  const SamplingResult& search;
};

/// "Reeds-Shepp, RRTConnect"
std::string name_of_alternative(SamplingPlanner planner, SteeringKind kind);

PlanningFailure failed(const Told& told, const Problem& problem, const Path& nearest, Alternative alternative);

/// `before`: m, where the path was shortened. `is_shortest`: no chain of such motions between the same ends can be shorter.
std::vector<std::string> explain(const Told& told, const Path& path, std::optional<double> before, bool is_shortest);

/// "12.34 m, 2 changes of direction."
std::string outcome_of(const Path& path);

}  // namespace waywright::library
