// A mission in legs, planned leg by leg.
#pragma once

#include <atomic>

#include "waywright/judge/plan.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/scenario/legs.hpp"

namespace waywright {

/// Completes the parameters of the mission's planner and of the legs' own. Refuses, before any work begins, what would be refused of a leg: what
/// its planner does not take (missions, parameters, kinds of work), and what check_legs refuses.
Parsed<void> complete_legs(Scenario& mission);

/// One leg solved, judged among the loads that stand there, and what follows it.
struct SolvedLeg {
  Plan plan;  ///< with the leg's own scenario
  LegBegin next;
};
Parsed<SolvedLeg> solve_leg(const Scenario& mission, const LegBegin& begin, const World& of_map, const std::atomic<bool>* cancel = nullptr);

/// Solves the legs one after another, each with the whole budget, as far as each ends at its goal; one plan of them all. Where their order is asked for
/// it is chosen first (order_legs.hpp), and the plan's scenario has the legs in it. Errors are those of complete_legs; everything else is a plan with
/// its status. @pre the scenario has legs
Parsed<Plan> solve_legs(const Scenario& scenario, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
