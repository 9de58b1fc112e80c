// A load that was set down stands there: from when on it is an obstacle, and when it is taken up again.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "waywright/scenario/scenario.hpp"

namespace waywright {

struct LeftLoad {
  std::string name;       ///< of the vehicle's loads
  std::size_t leg = 0;    ///< at whose end it was set down
  Pose pose{};            ///< of the vehicle then
  bool is_clear = false;  ///< the vehicle has ended a leg out of it since
};

/// Where it stands. Empty where the vehicle has no such load.
Ring outline_of(const Scenario& mission, const LeftLoad& load);
/// "the load "crate" left where leg 2 ends"
std::string title_of(const LeftLoad& load);

/// Does the leg take this load up again? It does where at its end it takes one of that name whose outline overlaps this one. A goal that leaves the
/// heading or the place free does not, since nobody knows before where the load would be.
bool is_taken_again(const Scenario& mission, std::size_t leg, const LeftLoad& load);

/// Do two of them overlap or touch?
bool is_touching(const Scenario& mission, const LeftLoad& a, const LeftLoad& b);

/// The loads that are obstacles on a leg: those that the vehicle has got clear of, and does not take up again there.
std::vector<LeftLoad> standing_on(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left);
/// Those that the vehicle stands in when the leg begins.
std::vector<LeftLoad> left_behind_on(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left);

/// What stands after a leg that has ended at `end`, with `carried` up to there.
std::vector<LeftLoad> left_after(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left, const std::string& carried, const Pose& end);

}  // namespace waywright
