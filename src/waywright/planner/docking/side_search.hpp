// What both forms of the docking planner share: the search box of a side, and the sides' story for the explanation.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/docking/partition.hpp"
#include "waywright/planner/docking/pattern_options.hpp"

namespace waywright {

/// What the search on one side of the shelf came to.
struct SideOutcome {
  Side side = Side::left;
  bool searched = false;   ///< at least one candidate was looked at
  bool feasible = false;
  double cost = 0.0;       ///< objective of the best path; graded where not feasible
  Pose transition{};       ///< world
  Path path;               ///< best path found, also where it is not feasible
  std::string sentence;    ///< what happened, for the explanation
  std::string refusal;     ///< why what was found does not stand, where the proof or the vehicle's speed says so
  std::optional<Contact> contact;  ///< what the best infeasible one meets first …
  double reach = 0.0;              ///< … after so many metres
};

/// Box over a zone's polygons in the shelf's frame, with a third variable for the heading where its range is positive.
SearchSpace search_space(const TransitionZone& zone, double heading_range);

/// The decision vector as a vehicle pose in the world: a point outside the polygons is taken to their nearest point.
Placement transition_placement(const DockingTask& task, const TransitionZone& zone, std::span<const double> x);
Pose transition_pose(const DockingTask& task, const TransitionZone& zone, std::span<const double> x);

bool is_wanted(SideChoice choice, Side side);

/// Shares the work between the sides that are searched.
class SideShares {
 public:
  /// Each side gets `evaluations`, or an equal share of what the scenario's budget leaves; a quarter of that is kept where a second choice
  /// stands by.
  SideShares(const std::vector<TransitionZone>& zones, SideChoice sides, std::int64_t evaluations, const Budget& budget, bool second_choice);
  /// Evaluations for the next side, ≥ 0.
  std::int64_t next();

 private:
  std::optional<std::int64_t> left_;  ///< of the budget
  std::int64_t evaluations_;
  std::int64_t sides_ = 0;            ///< to come
};

/// Why a side was not searched: nothing was left of the budget, the clock or the flag ended the run.
std::string not_searched_sentence(Side side, const Budget& budget);

/// Why a side was left out, with figures.
std::string left_out_sentence(const TransitionZone& zone);

/// Where the vehicle is after so many metres, about.
struct RoughPose {
  double driven = 0.0;
  Pose pose{};
};
/// Poses of a path of splines about `step` metres apart, however sharply it bends: for pictures and words, also of what cannot be driven.
std::vector<RoughPose> rough_poses(const Path& path, double step);

/// "the left side: cost 0.97" and so on, for report and plan file.
std::vector<Alternative> alternatives_of(const DockingTask& task, const std::vector<SideOutcome>& outcomes,
                                         const SideOutcome* chosen);

/// Best feasible outcome, or nullptr; equal costs: the left side.
const SideOutcome* best_of(const std::vector<SideOutcome>& outcomes);

/// "0.05 m" and the like: what stands in the way of a side's best path.
std::string contact_words(const Problem& problem, const Contact& contact);

}  // namespace waywright
