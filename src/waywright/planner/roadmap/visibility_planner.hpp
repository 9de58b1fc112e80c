// Planner `visibility_graph`: the shortest way of a disc in the plane, as lines and arcs.
#pragma once

#include <memory>
#include <string_view>

#include "waywright/planner/planner.hpp"

namespace waywright {

/// For vehicles that can turn on the spot, and the disc around their footprint. There is no shorter way for that disc (with twice the proof's tolerance to spare).
class VisibilityPlanner {
 public:
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "visibility_graph"; }
  /// Corners, and of maps with up to some hundred of them which see which.
  VisibilityPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription visibility_graph_description();

}  // namespace waywright
