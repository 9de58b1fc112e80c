// The global variant carried on: corners of a way are dropped, inserted and moved, until no more is gained.
#pragma once

#include "waywright/planner/tree/whale_refinement.hpp"

namespace waywright {

struct ImprovedWay {
  std::vector<Vec2> points;
  int rounds = 0;
  std::int64_t evaluations = 0;
  std::vector<std::vector<std::vector<Vec2>>> agents;  ///< ways of all after each iteration, for pictures
  std::vector<std::vector<Vec2>> ways;                ///< after each round
};

/// Each round leaves out corners that their neighbours see each other past, puts one before and one behind each that is left (at most `bound` away, no farther than half
/// way to the next), and has the whale optimisation algorithm move them all, within a bound that halves when a round gained less than a thousandth. It ends after
/// `rounds`, or where the bound is under a millimetre.
///
/// Laws: never longer than the way given, ends where it ends, free where that is; same arguments, same bits.
ImprovedWay improved_way(const std::vector<Vec2>& way, const PlaneSpace& space, const WhaleRefinementOptions& options, int rounds, std::uint64_t seed, Budget& budget);

}  // namespace waywright
