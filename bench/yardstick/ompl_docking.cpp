#include "bench/yardstick/ompl_docking.hpp"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <ctime>

namespace yardstick {
namespace ob = ompl::base;
namespace og = ompl::geometric;

OmplRun rrt_connect_simplified(const waywright::Problem& problem, std::uint32_t seed, double limit, double spacing) {
  using waywright::Pose;
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(seed);
  auto space = std::make_shared<ob::ReedsSheppStateSpace>(1.0 / problem.vehicle().max_curvature());
  const waywright::Box box = waywright::bounding_box(std::get<waywright::Station>(problem.scenario().mission).area);
  ob::RealVectorBounds bounds{2};
  bounds.setLow(0, box.low.x);
  bounds.setLow(1, box.low.y);
  bounds.setHigh(0, box.high.x);
  bounds.setHigh(1, box.high.y);
  space->setBounds(bounds);
  og::SimpleSetup setup{space};
  const double required = problem.required_clearance() - 1e-6;
  setup.setStateValidityChecker([&problem, required](const ob::State* state) {
    const auto* s = state->as<ob::SE2StateSpace::StateType>();
    return problem.world().is_free(problem.footprint(), Pose{s->getX(), s->getY(), s->getYaw()}, required);
  });
  setup.getSpaceInformation()->setStateValidityCheckingResolution(spacing / space->getMaximumExtent());
  const auto state_of = [&](const Pose& p) {
    ob::ScopedState<ob::SE2StateSpace> state{space};
    state->setX(p.x);
    state->setY(p.y);
    state->setYaw(p.heading >= waywright::pi ? p.heading - 2.0 * waywright::pi : p.heading);
    return state;
  };
  setup.setStartAndGoalStates(state_of(problem.start()), state_of(problem.goal()));
  setup.setPlanner(std::make_shared<og::RRTConnect>(setup.getSpaceInformation()));
  setup.setup();
  OmplRun run;
  const std::clock_t begin = std::clock();
  run.solved = setup.solve(limit) == ob::PlannerStatus::EXACT_SOLUTION;
  if (run.solved) setup.simplifySolution();
  run.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  if (run.solved) run.length = setup.getSolutionPath().length();
  return run;
}

}  // namespace yardstick
