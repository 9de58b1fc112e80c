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

/// May zones be forgotten on a straight line: it breaks no rule of theirs, and no metre of it costs more than one?
bool is_plain_line(const ZoneRules& zones, Vec2 from, Vec2 to);
/// What zones did to a way that a search of cells found: its length and cost, that it goes against no direction. Empty where no zone directs or weighs.
std::string zone_sentence(const Problem& problem, const Path& path);

/// Nothing found: in words. `at_once`: known from components, without a search.
PlanningFailure nothing_found(SearchEnd ended, bool at_once, std::int64_t expansions, const Budget& budget, double cell, const std::string& what_fits);

}  // namespace waywright::grid
