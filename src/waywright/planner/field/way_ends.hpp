// How plans of this folder begin and end, whichever field leads between.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/grid/connection.hpp"
#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {

/// Where a way between the middles of cells begins and ends.
struct CellEnds {
  PlaneEnd start{}, goal{};                 ///< the goal's tells nothing where it is a region
  bool is_region = false;
  std::vector<DiscConnection> from, goals;  ///< not empty; the goals' middles are free, those of a region cost nothing
};

/// The error is the plan itself where start and goal are one place, or why nothing can be planned. `refused`: why there are no cells; empty: there are.
tl::expected<CellEnds, PlanningResult> cell_ends(const PlaneSpace& space, const GridFrame& frame, const std::string& refused, std::string_view name, Budget& budget);

/// "… for a disc of 0.190 m that keeps 0.050 m", and why no other planner would find a way, where that is known.
PlanningFailure not_connected(const PlaneSpace& space, const std::string& reason, Budget& budget);

/// With what each of them says of its path: of the runs at its ends, how long it is, and than which none can be shorter.
PlanningResult finished_plan(const PlaneSpace& space, Path path, const PlaneEnd& start, const PlaneEnd& goal, std::vector<std::string> text, Budget& budget);

}  // namespace waywright
