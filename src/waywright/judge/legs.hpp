// The judged legs of a mission become one plan, and one plan is taken apart again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/judge.hpp"
#include "waywright/scenario/legs.hpp"

namespace waywright {

struct JudgedLeg {
  LegBegin begin;
  Pose end{};  ///< where the vehicle stands after it
  Plan plan;   ///< of the leg's own problem; its scenario is not looked at
};

/// One plan of a mission's legs, in order, as far as they came. Where each has a path, the path is all of them one after another, with samples
/// whose s and t go on; else there is none, and what the legs before it drove is kept for the picture. Laws: lengths, times, turning, changes of
/// curvature, risk, checked lengths and efforts are sums; clearances and greatest values the worst of any leg; the mean clearance is that of the
/// legs' weighted by length; changes of direction count those between legs too. The first leg that is not solved gives status and reason.
/// @pre at least one leg
Plan join_legs(const Scenario& mission, std::vector<JudgedLeg> legs);

/// What stands before a leg's sentences in the explanation, and tells its figures.
std::string leg_headline(const Scenario& mission, const std::vector<LegResult>& legs, std::size_t index);

/// Of the sentences behind those of the last leg: "On all legs: …", "On legs 1 and 3: …", "The load …, left where leg 1 ends, …".
bool tells_of_several_legs(const std::string& sentence);

/// A leg's part of a plan's path, samples and claims as a plan of its own, samples beginning at s = t = 0. Empty where the plan is not made of
/// its legs: a part is missing, or left over.
std::optional<std::vector<Plan>> parts_of(const Plan& plan);

/// verify() of such a part, before which so many metres and seconds lie: its s and t have gone through a sum with these, and are taken as the
/// fresh ones where they differ from them by no more than that rounds. (From standing a step's time goes with the root of its length.)
Verification verify_part(const Problem& problem, Plan part, double s_before, double t_before);

/// verify() of a plan with legs.
Parsed<Verification> verify_legs(const Plan& plan);

}  // namespace waywright
