// One prepared problem, many threads: every planner of the registry gives the same bits on each of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "waywright/docking/docking.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

constexpr std::size_t threads = 8;

/// What a planner makes of a problem, but for the times it took.
std::string planned_by(const PlannerDescription& planner, const Parameters& parameters, const Problem& problem) {
  Budget budget{problem.scenario().budget};
  const PlanningResult result = planner.make(*complete_parameters(planner, parameters), 1).plan(problem, budget);
  if (!result) return result.error().failure.reason + "\n";
  Plan plan = judge(problem, problem.whole_path(result->path, result->begins_in_motion));
  plan.timing = {};
  plan.explanation = result->explanation;
  return plan_json(plan) + "\n";
}

/// Every planner, with every optimiser where it takes one.
std::string planned_by_all(const Problem& problem) {
  std::string text;
  for (const PlannerDescription& planner : planners()) {
    const auto& known = planner.parameters;
    const auto optimizer = std::find_if(known.begin(), known.end(), [](const ParameterDescription& p) { return p.name == "optimizer"; });
    if (optimizer == known.end()) {
      text += planned_by(planner, {}, problem);
      continue;
    }
    for (const std::string& name : optimizer->choices) text += planned_by(planner, {{"optimizer", name}}, problem);
  }
  return text;
}

class Threads : public testing::TestWithParam<const char*> {};

TEST_P(Threads, EightPlanOnOneProblemAndGetTheSameBits) {
  Scenario scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + GetParam()).value();
  scenario.budget.evaluations = 60;
  scenario.budget.samples = 600;
  const Problem problem = Problem::prepare(scenario).value();
  std::vector<std::string> texts(threads);
  std::vector<std::thread> running;
  for (std::string& text : texts) running.emplace_back([&problem, &text] { text = planned_by_all(problem); });
  for (std::thread& thread : running) thread.join();
  const std::string alone = planned_by_all(problem);
  EXPECT_NE(alone.find("\"solved\""), std::string::npos);
  for (const std::string& text : texts) EXPECT_EQ(text, alone);
}

TEST(Sessions, EightSessionsOnOneDockingPlanAndReplanTheSame) {
  const auto docking = Docking::prepare(read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/dock_cluttered.json").value());
  ASSERT_TRUE(docking);
  const auto travel_times = [&] {
    auto session = DockingSession::on(*docking);
    const DockingPlan plan = session->plan();
    // Carried on from where it begins: the same station serves.
    return std::pair{plan.travel_time, session->replan(plan, 0.0).travel_time};
  };
  std::vector<std::pair<double, double>> found(threads);
  std::vector<std::thread> running;
  for (auto& one : found) running.emplace_back([&] { one = travel_times(); });
  for (std::thread& thread : running) thread.join();
  const auto alone = travel_times();
  EXPECT_GT(alone.first, 0.0);
  for (const auto& one : found) EXPECT_EQ(one, alone);
}

INSTANTIATE_TEST_SUITE_P(Examples, Threads, testing::Values("dock_cluttered.json", "undock_loaded.json", "goal_pose.json"));

}  // namespace
}  // namespace waywright
