// What grid planners say when they find nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "waywright/planner/grid/grid_search.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright::grid {

PlanningFailure failure(Status status, std::string reason, std::optional<Pose> pose = {});

/// "1 expansion", "2 expansions".
std::string counted(std::int64_t n, const char* what);
std::string place(Vec2 p);
const char* of_neighbours(Neighbours n);

/// Nothing found: in words. `at_once`: known from components, without a search.
PlanningFailure nothing_found(SearchEnd ended, bool at_once, std::int64_t expansions, const Budget& budget, double cell, const std::string& what_fits);

}  // namespace waywright::grid
