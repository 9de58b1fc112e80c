// A mission's legs as places that may be visited in another order: what belongs together, what has to come first, what may be carried.
#pragma once

#include <string>
#include <vector>

#include "waywright/planner/visiting_order.hpp"
#include "waywright/scenario/legs.hpp"

namespace waywright {

inline constexpr std::size_t most_ordered = 200;  ///< places

/// Legs that stay together: a way out of a shelf belongs to the leg that went in.
struct LegGroup {
  std::size_t first = 0, count = 1;
};

/// A mission whose order is asked for. Each leg keeps the load that it is driven with: one that takes a load, those driven with it and the one that
/// leaves it are a job, and the vehicle carries one load at a time. What is taken where one was set down, or set down where one was taken, in the
/// order given, stays after that.
struct OrderedLegs {
  std::size_t fixed = 0;          ///< legs before all others: the way out of the shelf in which the mission begins
  std::vector<LegGroup> groups;   ///< in the order given
  VisitProblem visits;            ///< its lengths are not known yet: no_way all of them
  LegBegin start;                 ///< what follows the fixed legs
  std::vector<std::vector<LegBegin>> after;  ///< by group and leg of the group: what follows it, with no more of the loads set down before than its own
};

/// Refuses what can be planned in the order given alone: more than most_ordered places, and goals that leave the place or, of vehicles that are
/// not round, the heading free, since the ways from there depend on the way there. @pre check_legs holds
Parsed<OrderedLegs> ordered_legs(const Scenario& mission);

/// The mission with its legs in the order of these groups, and where each stood before.
struct Reordered {
  Scenario mission;
  std::vector<std::size_t> given_as;
};
Reordered in_order(const Scenario& mission, const OrderedLegs& ordered, const std::vector<std::size_t>& order);

/// "leg 3 (goods)", "legs 3 and 4 (goods)"; counted in the order given.
std::string group_label(const Scenario& mission, const LegGroup& group);

}  // namespace waywright
