#include "waywright/planner/ompl/tree_search.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <exception>
#include <mutex>

namespace waywright {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double detour = 10.0;  // turning circles' reach that positions are drawn beyond start and goal
constexpr double bounds_slack = 1e-6;  // m, so that poses on the edge are inside

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

Pose pose_of(const ob::State* state) {
  const auto* s = state->as<ob::SE2StateSpace::StateType>();
  return {s->getX(), s->getY(), s->getYaw()};
}

/// OMPL's headings are in [−π, π), ours in (−π, π]: π itself, a frequent docked heading, would be out of its
/// bounds.
void assign(ob::State* state, const Pose& pose) {
  auto* s = state->as<ob::SE2StateSpace::StateType>();
  const double heading = wrap(pose.heading);
  s->setXY(pose.x, pose.y);
  s->setYaw(heading >= pi ? -pi : heading);
}

/// SE(2) with our own Reeds–Shepp curves: those of the library have other last bits on processors with fused
/// multiply-add.
class Space final : public ob::SE2StateSpace {
 public:
  explicit Space(const ReedsShepp& curves) : curves_{curves} {}

  double distance(const ob::State* from, const ob::State* to) const override {
    return curves_.distance(pose_of(from), pose_of(to));
  }
  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override {
    const Pieces pieces = curves_.between(pose_of(from), pose_of(to));
    if (t >= 1.0 || pieces.empty()) {
      if (to != state) copyState(state, to);
    } else {
      assign(state, t <= 0.0 ? pose_of(from) : pose_at(pieces, t * length(Path{pieces})));
    }
  }

 private:
  const ReedsShepp& curves_;
};

class Validity final : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& si, MotionTest& test) : ob::StateValidityChecker{si}, test_{test} {}
  bool isValid(const ob::State* state) const override { return test_.pose_free(pose_of(state)); }

 private:
  MotionTest& test_;
};

class ContinuousMotion final : public ob::MotionValidator {
 public:
  ContinuousMotion(const ob::SpaceInformationPtr& si, const ReedsShepp& curves, MotionTest& test)
      : ob::MotionValidator{si}, curves_{curves}, test_{test} {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return test_.motion_free(curves_.between(pose_of(from), pose_of(to)));
  }
  /// RRTConnect does not ask for the last valid state: where the motion is blocked, it is the first.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    last.second = 0.0;
    if (last.first != nullptr) si_->copyState(last.first, from);
    return false;
  }

 private:
  const ReedsShepp& curves_;
  MotionTest& test_;
};

Path exact_path(const ReedsShepp& curves, og::PathGeometric& found) {
  const std::vector<ob::State*>& states = found.getStates();
  Path path;
  for (std::size_t i = 0; i + 1 < states.size(); ++i) {
    for (const Piece& piece : curves.between(pose_of(states[i]), pose_of(states[i + 1]))) {
      append_merged(path.pieces, piece);
    }
  }
  return path;
}

/// RRTConnect tags the vertices of the start's tree with 1, of the goal's with 2.
void count_states(const og::RRTConnect& planner, const ob::SpaceInformationPtr& si,
                  TreeSearchResult& result) {
  ob::PlannerData data{si};
  planner.getPlannerData(data);
  for (unsigned i = 0; i < data.numVertices(); ++i) {
    ++(data.getVertex(i).getTag() == 1 ? result.start_states : result.goal_states);
  }
}

void run(const Problem& problem, const PosePair& ends, const ReedsShepp& curves, MotionTest& test,
         double range, std::uint64_t seed, TreeSearchResult& result) {
  auto space = std::make_shared<Space>(curves);
  const Box region = search_region(problem, curves.radius());
  ob::RealVectorBounds bounds{2};
  bounds.setLow(0, region.low.x);
  bounds.setLow(1, region.low.y);
  bounds.setHigh(0, region.high.x);
  bounds.setHigh(1, region.high.y);
  space->setBounds(bounds);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<Validity>(si, test));
  si->setMotionValidator(std::make_shared<ContinuousMotion>(si, curves, test));
  si->setup();

  ob::ScopedState<Space> start{space};
  ob::ScopedState<Space> goal{space};
  assign(start.get(), ends.start);
  assign(goal.get(), ends.goal);
  // An end that OMPL does not take would make it wait for another one for ever.
  for (const auto& [state, name] : {std::pair{&start, "start"}, std::pair{&goal, "goal"}}) {
    if (si->satisfiesBounds(state->get()) && si->isValid(state->get())) continue;
    if (test.spent()) break;
    result.error = std::string{"the "} + name + " pose does not keep the required clearance";
    return;
  }
  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  definition->setStartAndGoalStates(start, goal, 1e-9);

  // All generators draw their seeds from one global of the process when they are made: they are made here,
  // one search at a time. The search itself makes none (its sampler is made here too), and runs beside
  // others.
  std::unique_lock seeding{ompl_mutex()};
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(seed % 0x7FFFFFFEULL) + 1);
  const ob::StateSamplerPtr sampler = space->allocDefaultStateSampler();
  space->setStateSamplerAllocator([sampler](const ob::StateSpace*) { return sampler; });
  og::RRTConnect planner{si};
  if (range > 0.0) planner.setRange(range);
  planner.setProblemDefinition(definition);
  planner.setup();
  seeding.unlock();
  const ob::PlannerTerminationCondition stop{[&test] { return test.spent(); }};
  const ob::PlannerStatus status = planner.solve(stop);
  count_states(planner, si, result);

  auto* found = dynamic_cast<og::PathGeometric*>(definition->getSolutionPath().get());
  if (found != nullptr && status == ob::PlannerStatus::EXACT_SOLUTION) {
    result.path = exact_path(curves, *found);
  } else if (found != nullptr) {
    result.nearest = exact_path(curves, *found);
  }
  const Pose reached = result.nearest.pieces.empty() ? ends.start : end_pose(result.nearest);
  if (!result.path) result.missing = curves.distance(reached, ends.goal);
}

}  // namespace

Box search_region(const Problem& problem, double radius) {
  const Vec2 reach{2.0 * radius + problem.footprint().radius(),
                   2.0 * radius + problem.footprint().radius()};
  const Box ends = bounding_box({problem.start().position(), problem.goal().position()});
  Box region{ends.low - detour * reach, ends.high + detour * reach};
  const auto keep_inside = [&region](const Box& box) {
    region.low = {std::max(region.low.x, box.low.x), std::max(region.low.y, box.low.y)};
    region.high = {std::min(region.high.x, box.high.x), std::min(region.high.y, box.high.y)};
  };
  const World& world = problem.world();
  if (world.empty()) {
    keep_inside({ends.low - reach, ends.high + reach});
  } else {
    // Round everything known there may be a way; beyond that there is nothing to go round.
    const Box known = world.bounds();
    keep_inside({Vec2{std::min(known.low.x, ends.low.x), std::min(known.low.y, ends.low.y)} - reach,
                 Vec2{std::max(known.high.x, ends.high.x), std::max(known.high.y, ends.high.y)} + reach});
  }
  for (const Ring& boundary : world.map().boundaries) keep_inside(bounding_box(boundary));
  for (const CellGrid& grid : world.map().grids) {
    if (!grid.bounds) continue;
    keep_inside(bounding_box({grid.corner(0, 0), grid.corner(grid.columns, 0), grid.corner(0, grid.rows),
                              grid.corner(grid.columns, grid.rows)}));
  }
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission))
    keep_inside(bounding_box(station->area));
  const Vec2 slack{bounds_slack, bounds_slack};
  return {Vec2{std::min(region.low.x, ends.low.x), std::min(region.low.y, ends.low.y)} - slack,
          Vec2{std::max(region.high.x, ends.high.x), std::max(region.high.y, ends.high.y)} + slack};
}

TreeSearchResult tree_search(const Problem& problem, const PosePair& ends, const ReedsShepp& curves,
                             MotionTest& test, double range, std::uint64_t seed) {
  const Silence silence;
  TreeSearchResult result;
  try {
    run(problem, ends, curves, test, range, seed, result);
  } catch (const std::exception& error) {
    result.path.reset();
    result.error = error.what();
  }
  return result;
}

}  // namespace waywright
