#include "bench/yardstick/ompl_plane.hpp"

#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace yardstick {
namespace ob = ompl::base;
namespace og = ompl::geometric;
namespace {

using Plane = ob::RealVectorStateSpace;

waywright::Vec2 place_of(const ob::State* state) {
  const auto* s = state->as<Plane::StateType>();
  return {s->values[0], s->values[1]};
}

class Lines : public ob::MotionValidator {
 public:
  Lines(const ob::SpaceInformationPtr& si, const waywright::PlaneSpace& space) : MotionValidator{si}, space_{space} {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override { return space_.is_free(place_of(a), place_of(b)); }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    last.second = 0.0;
    return checkMotion(a, b);
  }

 private:
  const waywright::PlaneSpace& space_;
};

/// What PlaneTree draws.
class OurPlaces : public ob::StateSampler {
 public:
  OurPlaces(const ob::StateSpace* states, const waywright::PlaneSpace& space, std::uint64_t seed)
      : ob::StateSampler{states}, space_{space}, random_{waywright::Random::stream(seed, 0)} {}
  void sampleUniform(ob::State* state) override {
    const waywright::Box& region = space_.region();
    waywright::Vec2 p{};
    do p = {random_.uniform(region.low.x, region.high.x), random_.uniform(region.low.y, region.high.y)};
    while (!space_.is_free(p));
    auto* s = state->as<Plane::StateType>();
    s->values[0] = p.x;
    s->values[1] = p.y;
  }
  void sampleUniformNear(ob::State* state, const ob::State*, double) override { sampleUniform(state); }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  const waywright::PlaneSpace& space_;
  waywright::Random random_;
};

}  // namespace

OmplPlaneRun rrt_star(const waywright::PlaneSpace& space, waywright::Vec2 start, waywright::Vec2 goal, unsigned samples, double range, std::uint32_t seed, bool is_same, bool counts_nodes) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(seed);
  auto plane = std::make_shared<Plane>(2);
  ob::RealVectorBounds bounds{2};
  const waywright::Box& region = space.region();
  bounds.setLow(0, region.low.x);
  bounds.setLow(1, region.low.y);
  bounds.setHigh(0, region.high.x);
  bounds.setHigh(1, region.high.y);
  plane->setBounds(bounds);
  if (is_same) plane->setStateSamplerAllocator([&space, seed](const ob::StateSpace* states) { return std::make_shared<OurPlaces>(states, space, seed); });
  auto si = std::make_shared<ob::SpaceInformation>(plane);
  si->setStateValidityChecker([&space](const ob::State* state) { return space.is_free(place_of(state)); });
  si->setMotionValidator(std::make_shared<Lines>(si, space));
  si->setup();
  const auto state_of = [&](waywright::Vec2 p) {
    ob::ScopedState<Plane> state{plane};
    state[0] = p.x;
    state[1] = p.y;
    return state;
  };
  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  definition->setStartAndGoalStates(state_of(start), state_of(goal), 1e-6);
  definition->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
  og::RRTstar planner{si};
  planner.setRange(range);
  planner.setGoalBias(0.01);  // without any it never draws the goal and finds nothing
  planner.setKNearest(false);
  if (is_same) {
    const double ours = 1.0001 * 2.0 * std::sqrt(1.5) * std::sqrt(space.free_area() / waywright::pi);
    planner.setRewireFactor(ours / std::sqrt(3.0 * plane->getMeasure() / waywright::pi));
  }
  planner.setProblemDefinition(definition);
  planner.setup();
  planner.solve(ob::PlannerTerminationCondition{[&] { return planner.numIterations() >= samples; }});
  OmplPlaneRun run;
  run.iterations = planner.numIterations();
  if (counts_nodes) {
    ob::PlannerData data{si};
    planner.getPlannerData(data);
    run.nodes = data.numVertices();
  }
  if (definition->hasExactSolution()) run.length = definition->getSolutionPath()->as<og::PathGeometric>()->length();
  return run;
}

}  // namespace yardstick
