#include "waywright/planner/ompl/roadmap.hpp"

#include <ompl/base/PlannerTerminationCondition.h>

namespace waywright::library {

ob::PlannerStatus Roadmap::solve(const ob::PlannerTerminationCondition& stop) {
  constexpr std::int64_t turn = 500;  // footprint placements
  constexpr std::size_t bounces = 5;  // as many as the library takes
  checkValidity();
  while (const ob::State* state = pis_.nextStart()) startM_.push_back(addMilestone(si_->cloneState(state)));
  if (startM_.empty()) return ob::PlannerStatus::INVALID_START;
  do {
    if (const ob::State* state = pis_.nextGoal()) goalM_.push_back(addMilestone(si_->cloneState(state)));
  } while (pis_.haveMoreGoalStates());
  if (goalM_.empty()) return ob::PlannerStatus::INVALID_GOAL;

  if (!sampler_) sampler_ = si_->allocValidStateSampler();
  if (!simpleSampler_) simpleSampler_ = si_->allocStateSampler();
  std::vector<ob::State*> work(bounces);
  si_->allocStates(work);
  ob::PathPtr best;
  bool is_satisfied = false;
  bool grows = true;
  while (!stop() && !is_satisfied) {
    const std::int64_t until = test_.placements() + (grows ? 2 : 1) * turn;
    const ob::PlannerTerminationCondition end{[&] { return stop() || test_.placements() >= until; }};
    if (grows) {
      growRoadmap(end, work.front());
    } else {
      expandRoadmap(end, work);
    }
    grows = !grows;
    ob::PathPtr found;
    is_satisfied = maybeConstructSolution(startM_, goalM_, found);
    if (found) best = found;
    has_way_ = best != nullptr;
  }
  si_->freeStates(work);
  if (!best) return ob::PlannerStatus::TIMEOUT;
  ob::PlannerSolution solution{best};
  solution.setPlannerName(getName());
  pdef_->addSolutionPath(solution);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

std::vector<Pose> Roadmap::joined_to_start() {
  std::vector<Pose> poses;
  for (Vertex v = 0; v < milestoneCount(); ++v) {
    for (const Vertex start : startM_) {
      if (!sameComponent(start, v)) continue;
      poses.push_back(states_.pose(stateProperty_[v]));
      break;
    }
  }
  return poses;
}

}  // namespace waywright::library
