// PRM* without a thread and without a clock.
#pragma once

#include <ompl/geometric/planners/prm/PRMstar.h>

#include <vector>

#include "waywright/planner/ompl/library.hpp"

namespace waywright::library {

/// The library's PRM* looks for ways in a thread of its own, and grows and expands its roadmap by turns of some tenths of a second, so that no
/// two runs are the same. This one grows and expands by turns of footprint placements, two parts to one as the library does by time, and
/// looks for the shortest way after each.
class Roadmap final : public ompl::geometric::PRMstar {
 public:
  Roadmap(const ob::SpaceInformationPtr& si, const Steering& steering, const MotionTest& test) : PRMstar{si}, states_{steering}, test_{test} {}

  /// Start and goal are joined.
  bool has_way() const { return has_way_; }

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& stop) override;

  /// All states that the start is joined to.
  std::vector<Pose> joined_to_start();

 private:
  States states_;
  const MotionTest& test_;
  bool has_way_ = false;
};

}  // namespace waywright::library
