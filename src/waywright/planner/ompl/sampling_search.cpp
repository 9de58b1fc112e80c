#include "waywright/planner/ompl/sampling_search.hpp"

#include <ompl/base/PlannerData.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <exception>
#include <mutex>

#include "waywright/planner/ompl/library.hpp"
#include "waywright/planner/ompl/roadmap.hpp"

namespace waywright {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

std::mutex& ompl_mutex() {
  static std::mutex one;
  return one;
}

/// OMPL has one place for messages in the process: silent while any search runs, then as it was.
class Silence {
 public:
  Silence() {
    const std::lock_guard lock{ompl_mutex()};
    if (searches()++ == 0) ompl::msg::noOutputHandler();
  }
  ~Silence() {
    const std::lock_guard lock{ompl_mutex()};
    if (--searches() == 0) ompl::msg::restorePreviousOutputHandler();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static int& searches() {
    static int count = 0;
    return count;
  }
};

std::shared_ptr<ob::Planner> make_planner(SamplingPlanner planner, const ob::SpaceInformationPtr& si, const Steering& steering, const MotionTest& test) {
  switch (planner) {
    case SamplingPlanner::rrt_connect: return std::make_shared<og::RRTConnect>(si);
    case SamplingPlanner::rrt_star: return std::make_shared<og::RRTstar>(si);
    case SamplingPlanner::informed_rrt_star: return std::make_shared<og::InformedRRTstar>(si);
    case SamplingPlanner::bit_star: return std::make_shared<og::BITstar>(si);
    case SamplingPlanner::ait_star: return std::make_shared<og::AITstar>(si);
    case SamplingPlanner::prm_star: return std::make_shared<library::Roadmap>(si, steering, test);
    case SamplingPlanner::kpiece: break;
  }
  return std::make_shared<og::KPIECE1>(si);
}

/// One search, with what the library keeps pointers to.
class Search {
 public:
  Search(SamplingPlanner planner, const SamplingQuery& query, const Steering& steering, MotionTest& test)
      : kind_{planner}, query_{query}, steering_{steering}, test_{test}, states_{steering} {}

  SamplingResult run(const LibraryParameters& parameters, std::uint64_t seed) {
    auto space = library::make_space(steering_, query_.region);
    si_ = std::make_shared<ob::SpaceInformation>(space);
    validity_ = std::make_shared<library::Validity>(si_, steering_, test_);
    motions_ = std::make_shared<library::ContinuousMotion>(si_, steering_, test_, query_.goals);
    si_->setStateValidityChecker(validity_);
    si_->setMotionValidator(motions_);
    si_->setup();
    if (!define(seed)) return std::move(result_);

    // All generators draw their seeds from one global of the process when they are made: they are made here, one search at a time. The search
    // itself makes none (all samplers are this one, or draw by our own generator), and runs beside others.
    std::unique_lock seeding{ompl_mutex()};
    ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0x7FFFFFFEULL) + 1);
    const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
    space->setStateSamplerAllocator([sampler](const ob::StateSpace*) { return sampler; });
    const std::shared_ptr<ob::Planner> planner = make_planner(kind_, si_, steering_, test_);
    for (const auto& [name, value] : parameters) {
      if (!planner->params().setParam(name, value)) {
        result_.error = planner->getName() + " does not take " + name + " = " + value;
        return std::move(result_);
      }
    }
    planner->setProblemDefinition(definition_);
    planner->setup();
    seeding.unlock();
    const auto* roadmap = dynamic_cast<const library::Roadmap*>(planner.get());
    const ob::PlannerTerminationCondition stop{[this, roadmap] { return test_.spent() || (is_enough() && (roadmap != nullptr ? roadmap->has_way() : motions_->has_reached_goal())); }};
    const ob::PlannerStatus status = planner->solve(stop);
    count_states(*planner);
    take_answer(*planner, status);
    return std::move(result_);
  }

 private:
  /// The work that a search that has a way may do is done.
  bool is_enough() const {
    const auto share = [this](std::int64_t limit) { return (1.0 - query_.kept) * static_cast<double>(limit); };
    return query_.kept > 0.0 && is_optimising(kind_) &&
           (static_cast<double>(test_.placements()) >= share(test_.limits().placements) || static_cast<double>(test_.motions()) >= share(test_.limits().motions));
  }

  /// False where an end is none.
  bool define(std::uint64_t seed) {
    ob::ScopedState<> start{si_};
    states_.assign(start.get(), query_.start);
    // An end that OMPL does not take would make it wait for another one for ever.
    if (!is_end(start.get(), "start")) return false;
    definition_ = std::make_shared<ob::ProblemDefinition>(si_);
    definition_->addStartState(start);
    auto goals = std::make_shared<ob::GoalStates>(si_);
    ob::ScopedState<> goal{si_};
    for (const Pose& pose : query_.goals) {
      states_.assign(goal.get(), pose);
      if (!is_end(goal.get(), "goal")) return false;
      if (query_.goals.size() > 1) goals->addState(goal);
    }
    if (query_.goals.size() > 1) {
      goals->setThreshold(library::at_goal);
      definition_->setGoal(goals);
    } else {
      definition_->setGoalState(goal, library::at_goal);
    }
    if (is_optimising(kind_)) definition_->setOptimizationObjective(std::make_shared<library::Cost>(si_, steering_, query_.start, query_.goals, query_.region, seed));
    return true;
  }

  bool is_end(const ob::State* state, const char* name) {
    if ((si_->satisfiesBounds(state) && si_->isValid(state)) || test_.spent()) return true;
    result_.error = std::string{"the "} + name + " pose does not keep the required clearance";
    return false;
  }

  void count_states(const ob::Planner& planner) {
    if (kind_ == SamplingPlanner::bit_star || kind_ == SamplingPlanner::ait_star) {
      result_.start_states = validity_->free_states();  // AIT* would keep what it tells for ever
      return;
    }
    if (kind_ == SamplingPlanner::prm_star) {
      result_.start_states = static_cast<std::int64_t>(static_cast<const library::Roadmap&>(planner).milestoneCount());
      return;
    }
    ob::PlannerData data{si_};
    planner.getPlannerData(data);
    for (unsigned i = 0; i < data.numVertices(); ++i) {
      // RRTConnect tags the vertices of the start's tree with 1, of the goal's with 2.
      ++(kind_ != SamplingPlanner::rrt_connect || data.getVertex(i).getTag() == 1 ? result_.start_states : result_.goal_states);
    }
  }

  std::vector<Pose> poses_of(og::PathGeometric& path) const {
    std::vector<Pose> poses;
    for (const ob::State* state : path.getStates()) poses.push_back(states_.pose(state));
    return poses;
  }

  void take_answer(ob::Planner& planner, const ob::PlannerStatus& status) {
    auto* found = dynamic_cast<og::PathGeometric*>(definition_->getSolutionPath().get());
    if (found != nullptr && definition_->hasExactSolution() && !definition_->hasApproximateSolution()) {
      result_.states = poses_of(*found);
      return;
    }
    if (found != nullptr) result_.nearest = poses_of(*found);
    if (result_.nearest.size() > 1) {
      result_.reached = result_.nearest.back();
    } else if (kind_ == SamplingPlanner::prm_star) {
      for (const Pose& pose : static_cast<library::Roadmap&>(planner).joined_to_start()) {
        if (!result_.reached || library::missing_to(steering_, pose, query_.goals) < library::missing_to(steering_, *result_.reached, query_.goals)) result_.reached = pose;
      }
    } else if (kind_ != SamplingPlanner::rrt_connect) {  // they grow from the start alone
      result_.reached = motions_->nearest();
    }
    result_.missing = library::missing_to(steering_, result_.reached.value_or(query_.start), query_.goals);
    if (found == nullptr && !test_.spent()) result_.error = "it ended with \"" + status.asString() + "\"";
  }

  SamplingPlanner kind_;
  const SamplingQuery& query_;
  const Steering& steering_;
  MotionTest& test_;
  library::States states_;
  ob::SpaceInformationPtr si_;
  std::shared_ptr<library::Validity> validity_;
  std::shared_ptr<library::ContinuousMotion> motions_;
  ob::ProblemDefinitionPtr definition_;
  SamplingResult result_;
};

}  // namespace

std::string_view label(SamplingPlanner planner) {
  switch (planner) {
    case SamplingPlanner::rrt_connect: return "RRTConnect";
    case SamplingPlanner::rrt_star: return "RRT*";
    case SamplingPlanner::informed_rrt_star: return "Informed RRT*";
    case SamplingPlanner::bit_star: return "BIT*";
    case SamplingPlanner::ait_star: return "AIT*";
    case SamplingPlanner::prm_star: return "PRM*";
    case SamplingPlanner::kpiece: break;
  }
  return "KPIECE";
}

bool is_optimising(SamplingPlanner planner) { return planner != SamplingPlanner::rrt_connect && planner != SamplingPlanner::kpiece; }

SamplingResult sampling_search(SamplingPlanner planner, const LibraryParameters& parameters, const SamplingQuery& query, const Steering& steering, MotionTest& test,
                             std::uint64_t seed) {
  const Silence silence;
  try {
    return Search{planner, query, steering, test}.run(parameters, seed);
  } catch (const std::exception& error) {
    SamplingResult failed;
    failed.error = error.what();
    return failed;
  }
}

}  // namespace waywright
