// Anyone's poses under our judgement.
#pragma once

#include "waywright/judge/judge.hpp"
#include "waywright/judge/zone_speeds.hpp"

namespace waywright {

/// Poses of the vehicle's control point become poses of its origin; first and last pose are moved onto the scenario's start and
/// goal where they are within 0.01 m and 0.01 rad of them (said in the explanation); then judged like any path. `speeds`: of poses of the control
/// point, where they are known; they are held against the zones that limit speed, and nothing else (the plan's own profile is the fastest that is allowed).
Plan judge_imported(const Problem& problem, Path path, std::vector<PoseSpeed> speeds = {});

}  // namespace waywright
