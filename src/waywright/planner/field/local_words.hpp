// What became of a drive down the local field, in words.
#pragma once

#include <string>
#include <vector>

#include "waywright/planner/field/local_drive.hpp"

namespace waywright {

/// Why it came to no end: where, when, because of whom.
std::string local_end_sentence(const LocalDrive& drive, const Movers& movers);

/// How it went: how often the way was left, because of what, how far; ways planned anew; how near it came to what moves, and when. `samples`: of the plan with their times;
/// none where nothing moves.
std::vector<std::string> local_words(const PlaneSpace& space, const LocalDrive& drive, const Movers& movers, const FreeMotion& motion, const std::vector<Sample>& samples);

}  // namespace waywright
