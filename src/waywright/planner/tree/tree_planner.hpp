// Planners `rrt`, `rrt_star`, `rrt_star_woa_local` and `rrt_star_woa_global`: trees in the plane or, of the first two, among positions with headings, and the whale
// optimisation algorithm as the RRT*-WOA publication joins it with trees in the plane: in each extension of the tree, or on the way that it found.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "waywright/planner/planner.hpp"
#include "waywright/planner/steering/spaces.hpp"
#include "waywright/planner/tree/plane_tree.hpp"
#include "waywright/planner/tree/whale_refinement.hpp"
#include "waywright/planner/tree/whale_steering.hpp"

namespace waywright {

enum class TreeMethod { rrt, rrt_star, woa_local, woa_global };

struct TreePlannerOptions {
  TreeMethod method = TreeMethod::rrt_star;
  PlaneTreeOptions tree{};
  SpaceOptions space{};  ///< of `rrt` and `rrt_star`; the others plan in the plane
  bool shortens = true;  ///< leaves out corners that the ones beside them see each other past; among headings: cuts short by motions
  WhaleSteeringOptions steering{};
  WhaleRefinementOptions refinement{};
  int rounds = 0;  ///< of the global variant carried on; 0: as published
};

/// In the plane for vehicles that can turn on the spot, and the disc around their footprint; in other spaces for any, and the footprint itself.
class TreePlanner {
 public:
  TreePlanner(std::string name, TreePlannerOptions options, std::uint64_t seed) : name_{std::move(name)}, options_{options}, seed_{seed} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return name_; }
  TreePlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  std::string name_;
  TreePlannerOptions options_;
  std::uint64_t seed_;
  std::shared_ptr<const Ready> ready_;
};

std::vector<PlannerDescription> tree_planner_descriptions();

}  // namespace waywright
