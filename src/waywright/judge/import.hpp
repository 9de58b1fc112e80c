// Anyone's poses under our judgement.
#pragma once

#include "waywright/judge/judge.hpp"

namespace waywright {

/// Poses of the vehicle's control point become poses of its origin; first and last pose are moved onto the scenario's start and
/// goal where they are within 0.01 m and 0.01 rad of them (said in the explanation); then judged like any path.
Plan judge_imported(const Problem& problem, Path path);

}  // namespace waywright
