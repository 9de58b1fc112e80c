// A mission in legs: each is a problem of its own, which begins where the one before has ended, with the load that is carried then.
#pragma once

#include <optional>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/scenario/left_load.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

inline constexpr std::size_t most_legs = 1000;

/// Where a leg begins, and with which load.
struct LegBegin {
  std::size_t index = 0;  ///< of the leg; one past the last: where the mission has ended
  Pose pose{};
  std::string load;       ///< empty: none
  std::vector<LeftLoad> left{};  ///< what was set down on legs before, and stands there
};

LegBegin first_leg(const Scenario& mission);
/// What follows a leg that has ended at `end`.
LegBegin next_leg(const Scenario& mission, const LegBegin& leg, const Pose& end);

/// Where a leg ends: the problem's last pose, or of a goal that leaves it open where the path leads. (Without one what stands for the goal.)
Pose end_of(const Problem& problem, const Path& path);

/// A leg that ends where it begins, at rest and on no way through anything, and changes the load: the vehicle stands.
bool is_standing(const Scenario& mission, const LegBegin& leg);

/// "leg 2 of 3 (goods → exit)"
std::string leg_label(const Scenario& mission, std::size_t index);
/// A leg's planner: its own, or the mission's.
const PlannerChoice& planner_of(const Scenario& mission, const Leg& leg);
/// The same error, its field named as it stands in the mission.
InputError error_of_leg(const Scenario& mission, const LegBegin& leg, InputError error);

/// The leg as a scenario of its own. What every leg shares goes with it: vehicle, clearance, pose error, budget (each leg has the whole of it),
/// seed, map. The shelves of the other legs' stations stand on its map, since they are there all the time, and so do loads that were set down on
/// legs before, once the vehicle has got clear of them.
Scenario leg_scenario(const Scenario& mission, const LegBegin& leg);

/// Ready to be planned; `of_map` is World{mission.map}, not built. Refuses a way out of a shelf that does not begin where the vehicle stands.
Parsed<Problem> prepare_leg(const Scenario& mission, const LegBegin& leg, const World& of_map);

/// What prepare_leg would refuse of any leg, found without the map: to be asked before work begins. Refuses more than most_legs, and a load that is taken
/// while one is carried.
Parsed<void> check_legs(const Scenario& mission);

/// A leg that begins with a load just taken and cannot stand there: said so.
Failure told_of_load(const Scenario& mission, const LegBegin& leg, Failure failure);

/// A load that is taken where the mission ends has no leg that would show whether it fits there. @pre `end` is what follows the last leg
Parsed<std::optional<Failure>> check_last_load(const Scenario& mission, const LegBegin& end, const World& of_map);

}  // namespace waywright
