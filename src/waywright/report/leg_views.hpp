// What pictures and charts need of each leg of a mission; its problem is made and let go again, since a thousand of them have no room.
#pragma once

#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/report/spots.hpp"

namespace waywright {

struct LegView {
  Footprint footprint;           ///< of the vehicle with what it carries
  const Footprint* load = nullptr;  ///< of what it carries alone, of the plan's vehicle; may be none
  Pose first{}, last{};
  std::vector<Sample> samples;   ///< s and t from the leg's beginning; empty where it has no path
  std::vector<double> clearance;  ///< m, at each sample; empty where the plan has no whole path
  std::vector<double> zone_speed;  ///< m/s, where zones limit it at the samples; likewise, and empty without such zones
  double required = 0.0;         ///< m of clearance
  double margin = 0.0;           ///< m of it, for the pose error
  std::vector<Spot> blocked;     ///< of a leg that failed
  Ring set_down;                 ///< the load that is left where it ends; empty: none
};

/// Of the legs that the plan tells of, in order; fewer where its scenario cannot be prepared. `plan` outlives them.
std::vector<LegView> leg_views(const Plan& plan, bool with_clearance);

}  // namespace waywright
