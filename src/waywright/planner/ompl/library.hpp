// What OMPL's planners are given: spaces, tests and costs of any steering.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/planner/steering/steering.hpp"

namespace waywright::library {

namespace ob = ompl::base;

inline constexpr double at_goal = 1e-9;  // m, of cost

/// Between poses and the library's states: of SE(2), or of the plane.
class States {
 public:
  explicit States(const Steering& steering) : has_headings_{steering.has_headings()} {}
  Pose pose(const ob::State* state) const;
  void assign(ob::State* state, const Pose& pose) const;

 private:
  bool has_headings_;
};

/// With our own curves: those of the library have other last bits on processors with fused multiply-add. KPIECE's cells are of positions.
ob::StateSpacePtr make_space(const Steering& steering, const Box& region);

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, const Steering& steering, MotionTest& test) : ob::StateValidityChecker{si}, states_{steering}, test_{test} {}
  bool isValid(const ob::State* state) const override;
  std::int64_t free_states() const { return free_states_; }

 private:
  States states_;
  MotionTest& test_;
  mutable std::int64_t free_states_ = 0;
};

/// Whole motions by MotionTest, and the end nearest to a goal of those that were free.
class ContinuousMotion final : public ob::MotionValidator {
 public:
  ContinuousMotion(const ob::SpaceInformationPtr& si, const Steering& steering, MotionTest& test, const std::vector<Pose>& goals)
      : ob::MotionValidator{si}, states_{steering}, steering_{steering}, test_{test}, goals_{goals} {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override;
  /// Where it is not free, the part before the first obstacle, which is tested as a motion of its own.
  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override;

  const std::optional<Pose>& nearest() const { return nearest_; }
  /// Some motion led into a goal.
  bool has_reached_goal() const { return nearest_ && missing_ <= at_goal; }

 private:
  bool is_free(const Pose& from, const Pose& to, const Pieces& pieces) const;

  States states_;
  const Steering& steering_;
  MotionTest& test_;
  const std::vector<Pose>& goals_;
  mutable std::optional<Pose> nearest_;
  mutable double missing_ = 0.0;
};

/// m that is missing from a state to the nearest goal.
double missing_to(const Steering& steering, const Pose& from, const std::vector<Pose>& goals);

/// The steering's cost, summed along the way. Draws states that can shorten it from an ellipse about start and goal, by a generator of its own.
class Cost final : public ob::OptimizationObjective {
 public:
  Cost(const ob::SpaceInformationPtr& si, const Steering& steering, const Pose& start, const std::vector<Pose>& goals, const Box& region, std::uint64_t seed);

  ob::Cost stateCost(const ob::State*) const override { return identityCost(); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override;
  ob::Cost motionCostHeuristic(const ob::State* from, const ob::State* to) const override;
  ob::InformedSamplerPtr allocInformedStateSampler(const ob::ProblemDefinitionPtr& definition, unsigned int calls) const override;

 private:
  States states_;
  const Steering& steering_;
  Pose start_;
  const std::vector<Pose>& goals_;
  Box region_;
  std::uint64_t seed_;
};

}  // namespace waywright::library
