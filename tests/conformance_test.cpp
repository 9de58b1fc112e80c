// What every registered planner keeps, whatever it is: the one test that admits a planner.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

Problem example(const char* name, const PlannerDescription& planner) {
  Scenario scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name).value();
  scenario.planner = {planner.name, {}};
  // Who plans turns on the spot is asked on vehicles that can; what is refused on others has a test of its own.
  if (planner.turns_on_the_spot && std::holds_alternative<Tricycle>(scenario.vehicle.drive)) scenario.vehicle.drive = Differential{0.6};
  return Problem::prepare(std::move(scenario)).value();
}

std::string without_timing(std::string text) {
  const std::size_t begin = text.find("\"timing\"");
  const std::size_t end = text.find('}', begin);
  return text.erase(begin, end - begin);
}

class Conformance : public testing::TestWithParam<std::string> {
 protected:
  const PlannerDescription& planner() const { return *find_planner(GetParam()); }
  bool counts_samples() const {
    return planner().counts_samples && planner().counts_samples(*complete_parameters(planner(), {}));
  }
};

TEST_P(Conformance, IsRegisteredWithDescribedParameters) {
  EXPECT_FALSE(planner().summary.empty());
  for (const ParameterDescription& p : planner().parameters) {
    EXPECT_FALSE(p.summary.empty()) << p.name;
    Parameters one{{p.name, p.default_value}};
    EXPECT_TRUE(complete_parameters(planner(), one)) << p.name << ": the default is out of its own range";
    if (std::holds_alternative<double>(p.default_value)) {
      EXPECT_FALSE(complete_parameters(planner(), {{p.name, p.high * 2.0 + 1.0}})) << p.name;
      EXPECT_FALSE(complete_parameters(planner(), {{p.name, std::string{"word"}}})) << p.name;
    }
    if (!p.choices.empty()) {
      EXPECT_FALSE(complete_parameters(planner(), {{p.name, std::string{"no such choice"}}})) << p.name;
    }
  }
  EXPECT_FALSE(complete_parameters(planner(), {{"no_such_parameter", 1.0}}));
  EXPECT_EQ(planner().make(*complete_parameters(planner(), {}), 1).name(), planner().name);
}

TEST_P(Conformance, SameSeedSameBitsAlsoOnOtherThreads) {
  const Problem problem = example("dock_cluttered.json", planner());
  const std::string first = without_timing(plan_json(*solve(problem)));
  std::string second, third;
  std::thread a{[&] { second = without_timing(plan_json(*solve(problem))); }};
  std::thread b{[&] { third = without_timing(plan_json(*solve(problem))); }};
  a.join();
  b.join();
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
}

TEST_P(Conformance, ResultIsJudgedByVerify) {
  for (const char* name : {"dock_middle.json", "dock_right.json", "goal_pose.json"}) {
    const Problem problem = example(name, planner());
    const Plan plan = *solve(problem);
    EXPECT_EQ(plan.planner, planner().name);
    if (plan.samples.empty()) {
      EXPECT_FALSE(plan.reason.empty());
      continue;
    }
    const Plan read = parse_plan(plan_json(plan), "plan.json").value();
    const Verification verification = verify(read).value();
    EXPECT_EQ(verification.holds, plan.status == Status::solved) << name;
    EXPECT_EQ(verification.fresh.status, plan.status) << name;
  }
}

TEST_P(Conformance, ObeysItsBudget) {
  Scenario scenario = example("dock_cluttered.json", planner()).scenario();
  scenario.budget.evaluations = 10;
  if (counts_samples()) scenario.budget.samples = 10;
  if (planner().counts_expansions) scenario.budget.expansions = 10;
  const Plan plan = *solve(Problem::prepare(scenario).value());
  EXPECT_LE(plan.effort.evaluations, 10);
  EXPECT_GT(plan.effort.evaluations, 0);
  EXPECT_LE(plan.effort.expansions, 10);
  EXPECT_TRUE(plan.reproducible);
}

TEST_P(Conformance, RefusesABudgetOfWorkThatItDoesNotCount) {
  Scenario scenario = example("dock_middle.json", planner()).scenario();
  scenario.budget.expansions = 10;
  const auto expansions = solve(Problem::prepare(scenario).value());
  ASSERT_EQ(expansions.has_value(), planner().counts_expansions);
  if (!expansions) {
    EXPECT_EQ(expansions.error().field, "budget.expansions");
  }
  scenario.budget.expansions.reset();
  scenario.budget.samples = 500;
  const auto samples = solve(Problem::prepare(scenario).value());
  ASSERT_EQ(samples.has_value(), counts_samples());
  if (!samples) {
    EXPECT_EQ(samples.error().field, "budget.samples");
  }
}

TEST_P(Conformance, ObeysCancelAndDeadline) {
  const std::atomic<bool> canceled{true};
  const Plan plan = *solve(example("dock_cluttered.json", planner()), &canceled);
  EXPECT_EQ(plan.status, Status::canceled);
  EXPECT_FALSE(plan.reproducible);
  Scenario scenario = example("dock_cluttered.json", planner()).scenario();
  scenario.budget.seconds = 1e-9;
  const Plan late = *solve(Problem::prepare(scenario).value());
  EXPECT_EQ(late.status, Status::timed_out);
  EXPECT_FALSE(late.reproducible);
}

TEST_P(Conformance, EndsOnAFlagThatIsRaisedWhileItWorks) {
  Scenario scenario = example(planner().passes_waypoints ? "waypoints_high.json" : "dock_impossible.json", planner()).scenario();
  const bool is_over_cells = planner().name == "wavefront" || planner().name == "harmonic" || planner().name == "global_local";
  if (planner().turns_on_the_spot && (counts_samples() || is_over_cells)) {  // nothing can stand before that shelf, which is known at once: a wall without a door
    scenario.map = {};
    scenario.map.boundaries = {rectangle({0, 0}, {10, 6})};
    scenario.map.obstacles = {rectangle({4, 0}, {5, 6})};
    scenario.vehicle.footprint = {{}, 0.3};
    scenario.start = {1, 1, 0};
    scenario.mission = Pose{9, 5, 0};
  }
  for (const ParameterDescription& p : planner().parameters) {
    if (p.name == "evaluations" || p.name == "iterations") scenario.planner.parameters[p.name] = p.high;  // far more than can be done meanwhile
    if (p.name == "samples" && counts_samples()) scenario.planner.parameters[p.name] = p.high;
    if (p.name == "resolution" && planner().counts_expansions) scenario.planner.parameters[p.name] = planner().name == "clearance_optimal" ? 0.03 : planner().name == "wavefront" ? 0.002 : 0.01;  // of motions fewer are searched
  }
  const Problem problem = Problem::prepare(scenario).value();
  const auto& parameters = planner().parameters;
  const bool can_be_long = std::any_of(parameters.begin(), parameters.end(), [](const ParameterDescription& p) {
    return p.name == "evaluations" || p.name == "iterations" || p.name == "samples" || p.name == "checks" || p.name == "resolution";
  });
  std::atomic<bool> cancel{false};
  std::thread other{[&] {
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    cancel = true;
  }};
  const Plan plan = *solve(problem, &cancel);
  other.join();
  if (!can_be_long && plan.status == Status::no_path) GTEST_SKIP() << "it was done before";
  EXPECT_EQ(plan.status, Status::canceled);
  EXPECT_FALSE(plan.reproducible);
  EXPECT_FALSE(plan.reason.empty());
}

TEST_P(Conformance, TakesOverAVehicleThatMoves) {
  Scenario scenario = example("dock_middle.json", planner()).scenario();
  for (const StartMotion motion : {StartMotion{-0.6, 0.1}, StartMotion{0.4, 0.0}, StartMotion{0.4, -0.2}}) {
    scenario.start_motion = motion;
    const Plan plan = *solve(Problem::prepare(scenario).value());
    if (plan.samples.empty()) {
      EXPECT_FALSE(plan.reason.empty());
      continue;
    }
    EXPECT_NEAR(plan.samples.front().speed, std::abs(motion.speed), 1e-3) << planner().name;
    EXPECT_EQ(plan.samples.front().direction, motion.speed < 0.0 ? -1 : 1);
    EXPECT_NEAR(plan.samples.front().curvature, motion.curvature, 1e-6);
    const Plan read = parse_plan(plan_json(plan), "plan.json").value();
    EXPECT_EQ(read.scenario.start_motion.speed, motion.speed);
    const Verification verification = verify(read).value();
    EXPECT_EQ(verification.holds, plan.status == Status::solved) << verification.findings.front();
  }
}

TEST_P(Conformance, FailsWithItsCause) {
  Scenario scenario = example("dock_impossible.json", planner()).scenario();
  if (counts_samples()) scenario.budget.samples = 5000;
  const Plan plan = *solve(Problem::prepare(scenario).value());
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_FALSE(plan.reason.empty());
  EXPECT_TRUE(plan.path.pieces.empty());
}

TEST_P(Conformance, EndsInCollisionOrOutsideAreNamed) {
  const Scenario base = example("dock_middle.json", planner()).scenario();
  const auto status_with = [&](auto change) {
    Scenario s = base;
    change(s);
    const Plan plan = *solve(Problem::prepare(s).value());
    EXPECT_FALSE(plan.reason.empty());
    return plan.status;
  };
  EXPECT_EQ(status_with([](Scenario& s) { s.start = {7.3, 10.0, 0.0}; }), Status::start_in_collision);
  EXPECT_EQ(status_with([](Scenario& s) { s.start = {20.0, 7.0, 0.0}; }), Status::start_outside);
  EXPECT_EQ(status_with([](Scenario& s) { s.map.obstacles.push_back(rectangle({2.5, 6.8}, {3.0, 7.2})); }), Status::goal_in_collision);
  EXPECT_EQ(status_with([](Scenario& s) { s.mission = Pose{30.0, 3.0, 0.0}; }), Status::goal_outside);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const PlannerDescription& p : planners()) all.push_back(p.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Planners, Conformance, testing::ValuesIn(names()), [](const auto& entry) { return entry.param; });

}  // namespace
}  // namespace waywright
