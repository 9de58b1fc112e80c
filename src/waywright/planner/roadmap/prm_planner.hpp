// Planner `prm`: a probabilistic roadmap in the plane, or among positions with headings.
#pragma once

#include <memory>
#include <string_view>

#include "waywright/planner/planner.hpp"
#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"
#include "waywright/planner/steering/spaces.hpp"

namespace waywright {

struct PrmPlannerOptions {
  RoadmapOptions roadmap{};
  SpaceOptions space{};
  bool shortens = true;  ///< leaves out corners that the ones beside them see each other past; among headings: cuts short by motions
};

/// In the plane for vehicles that can turn on the spot, and the disc around their footprint; in other spaces for any, and the footprint itself.
class PrmPlanner {
 public:
  PrmPlanner(PrmPlannerOptions options, std::uint64_t seed) : options_{options}, seed_{seed} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "prm"; }
  /// The roadmap of as many samples as the scenario's budget or the parameter asks for, up to 20 000; larger ones, and those among headings, grow under a plan's own budget.
  PrmPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  PrmPlannerOptions options_;
  std::uint64_t seed_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription prm_description();

}  // namespace waywright
