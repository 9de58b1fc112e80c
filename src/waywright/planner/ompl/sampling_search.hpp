// The planners of OMPL between states of any steering.
//
// Sources: I. A. Șucan, M. Moll, L. E. Kavraki: The Open Motion Planning Library, IEEE Robotics & Automation Magazine 19 (2012); of the
// planners: J. J. Kuffner, S. M. LaValle: RRT-Connect, ICRA 2000; S. Karaman, E. Frazzoli: Sampling-based Algorithms for Optimal Motion
// Planning, International Journal of Robotics Research 30 (2011) (RRT*, PRM*); J. D. Gammell, T. D. Barfoot, S. S. Srinivasa: Informed
// Sampling for Asymptotically Optimal Path Planning, IEEE Transactions on Robotics 34 (2018); the same: Batch Informed Trees (BIT*),
// International Journal of Robotics Research 39 (2020); M. P. Strub, J. D. Gammell: Adaptively Informed Trees (AIT*), ICRA 2020;
// I. A. Șucan, L. E. Kavraki: Kinodynamic Motion Planning by Interior-Exterior Cell Exploration, WAFR 2008 (KPIECE).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/planner/steering/steering.hpp"

namespace waywright {

enum class SamplingPlanner { rrt_connect, rrt_star, informed_rrt_star, bit_star, ait_star, prm_star, kpiece };

/// "RRT*"
std::string_view label(SamplingPlanner planner);
/// It goes on after a first way, to shorten it.
bool is_optimising(SamplingPlanner planner);

/// The library's own parameters by its own names.
using LibraryParameters = std::map<std::string, std::string>;

struct SamplingQuery {
  Pose start{};
  std::vector<Pose> goals;  ///< at least one; any of them will do
  Box region{};             ///< where positions are drawn
  double kept = 0.0;        ///< share of the work, in [0, 1), that optimising planners leave once they have a way, for shortcuts
};

struct SamplingResult {
  std::vector<Pose> states;        ///< from the start to a goal; empty where no way was found
  std::vector<Pose> nearest;       ///< else: to the state nearest to the goal that was reached; may be empty
  std::optional<Pose> reached{};   ///< that state
  double missing = 0.0;            ///< m, what a motion from there to the goal would cost
  std::int64_t start_states = 0;   ///< of RRTConnect: in the tree that grew from the start; else all states of tree or roadmap, or drawn
  std::int64_t goal_states = 0;    ///< of RRTConnect: in the tree that grew from the goal
  std::string error;               ///< what the library refused; empty in a healthy run
};

/// Ends where a way is found, of optimising planners where none can be shorter, or where the test's limits are spent. Every motion of the
/// way has been called free by `test`. Same arguments, same bits.
SamplingResult sampling_search(SamplingPlanner planner, const LibraryParameters& parameters, const SamplingQuery& query, const Steering& steering, MotionTest& test,
                             std::uint64_t seed);

}  // namespace waywright
