#include "waywright/planner/ompl/ompl_planner.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "waywright/judge/judge.hpp"
#include "waywright/planner/steering/search_ends.hpp"
#include "waywright/planner/steering/shortcut.hpp"

namespace waywright {
namespace {

constexpr SamplingPlanner all_planners[] = {SamplingPlanner::rrt_connect, SamplingPlanner::rrt_star, SamplingPlanner::informed_rrt_star, SamplingPlanner::bit_star,
                                            SamplingPlanner::ait_star,    SamplingPlanner::prm_star, SamplingPlanner::kpiece};

std::string name_of(SamplingPlanner planner) { return std::string{OmplPlanner{planner, {}, 0}.name()}; }

Scenario in_a_hall() {
  Scenario s;
  s.vehicle.name = "carrier";
  s.vehicle.footprint.polygon = rectangle({-0.4, -0.25}, {0.4, 0.25});
  s.vehicle.drive = Differential{0.4};
  s.vehicle.limits.curvature = 2.0;
  s.map.boundaries.push_back(rectangle({0, 0}, {8, 5}));
  s.start = {1.0, 1.0, 0.0};
  s.mission = Pose{7.0, 4.0, 0.5};
  s.clearance = 0.02;
  return s;
}

Scenario with_a_gap() {
  Scenario s = in_a_hall();
  s.map.obstacles = {rectangle({3.9, -0.5}, {4.1, 0.5}), rectangle({3.9, 1.8}, {4.1, 5.5})};
  return s;
}

/// Two metres long, 1.15 m wide; the disc around the footprint takes 0.98 m.
Scenario with_a_corridor() {
  Scenario s = in_a_hall();
  s.map.obstacles = {rectangle({3.0, -0.5}, {5.0, 0.8}), rectangle({3.0, 1.95}, {5.0, 5.5})};
  return s;
}

Problem prepared(const Scenario& scenario) { return Problem::prepare(scenario).value(); }

/// Footprint placements: planners that draw in batches spend far more time on each.
std::int64_t work_of(SamplingPlanner planner) {
  if (planner == SamplingPlanner::bit_star || planner == SamplingPlanner::ait_star) return 2000;
  return is_optimising(planner) ? 6000 : 20000;
}

OmplOptions in_space(std::optional<SteeringKind> space, std::int64_t checks = 20000) {
  OmplOptions options;
  options.space = space;
  options.checks = checks;
  return options;
}

PlanningResult plan_with(const Problem& problem, SamplingPlanner planner, const OmplOptions& options, std::uint64_t seed = 1, BudgetLimits limits = {}) {
  Budget budget{limits};
  return OmplPlanner{planner, options, seed}.plan(problem, budget);
}

void expect_solved(const Problem& problem, const PlanningResult& result, const std::string& what) {
  ASSERT_TRUE(result) << what << ": " << result.error().failure.reason;
  const Plan plan = judge(problem, result->path);
  EXPECT_EQ(plan.status, Status::solved) << what << ": " << plan.reason;
  EXPECT_FALSE(result->explanation.empty());
  ASSERT_EQ(result->alternatives.size(), 1u);
  EXPECT_TRUE(result->alternatives[0].chosen);
  EXPECT_NEAR(*result->alternatives[0].cost, length(result->path), 1e-12);
}

std::string text_of(const PlanningResult& result) {
  std::string text;
  for (const std::string& line : result ? result->explanation : result.error().explanation) text += line + "\n";
  return text;
}

bool same_bits(const Path& a, const Path& b) {
  if (a.pieces.size() != b.pieces.size()) return false;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    const Piece &p = a.pieces[i], &q = b.pieces[i];
    if (p.direction != q.direction || p.curve.index() != q.curve.index() || start_pose(p) != start_pose(q) || end_pose(p) != end_pose(q)) return false;
  }
  return true;
}

class EveryPlanner : public testing::TestWithParam<SamplingPlanner> {};

TEST_P(EveryPlanner, SolvesInEverySpace) {
  for (const SteeringKind space : steering_kinds) {
    if (space == SteeringKind::dubins && GetParam() == SamplingPlanner::prm_star) continue;
    int hall = 0;
    for (const Scenario& scenario : {in_a_hall(), with_a_gap(), with_a_corridor()}) {
      const Problem problem = prepared(scenario);
      ASSERT_FALSE(problem.check_ends());
      const PlanningResult result = plan_with(problem, GetParam(), in_space(space, work_of(GetParam())));
      expect_solved(problem, result, name_of(GetParam()) + " in " + std::string{to_string(space)} + ", hall " + std::to_string(hall++));
      if (!result) continue;
      for (const Piece& piece : result->path.pieces) {
        const bool is_turn = std::holds_alternative<Turn>(piece.curve), is_arc = std::holds_alternative<Arc>(piece.curve);
        EXPECT_FALSE(space == SteeringKind::plane || space == SteeringKind::turns ? is_arc : is_turn);
        EXPECT_FALSE(piece.direction < 0 && (space == SteeringKind::plane || space == SteeringKind::dubins));
      }
    }
  }
}

/// Out of a pocket, where motions are tested one way and driven the other.
TEST(RoadmapOfOmpl, DrivesMotionsBackAsTheyWereTested) {
  Scenario s;
  s.vehicle.footprint.polygon = rectangle({-1.3, -0.4}, {0.9, 0.4});
  s.vehicle.drive = Tricycle{1.1, 1.2, {}, SteeredAxle::rear};
  s.vehicle.limits.curvature = 0.9;
  s.map.boundaries.push_back(rectangle({0, 0}, {12, 8}));
  s.map.obstacles.push_back({{4, 1.5}, {9, 1.5}, {9, 6.5}, {4, 6.5}, {4, 5.5}, {8, 5.5}, {8, 2.5}, {4, 2.5}});
  s.start = {6, 4, 0};
  s.mission = Pose{10.8, 4, 0};
  const Problem problem = prepared(s);
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const PlanningResult result = plan_with(problem, SamplingPlanner::prm_star, in_space(SteeringKind::reeds_shepp, 40000), seed);
    if (!result) continue;  // its budget was too small
    expect_solved(problem, result, "seed " + std::to_string(seed));
    ++solved;
  }
  EXPECT_GE(solved, 4);
}

TEST_P(EveryPlanner, SameSeedSameBitsWhateverRunsBeside) {
  const SteeringKind space = GetParam() == SamplingPlanner::prm_star ? SteeringKind::turns : SteeringKind::reeds_shepp;
  const Problem problem = prepared(with_a_gap());
  OmplOptions options = in_space(space);
  options.checks = work_of(GetParam()) < 20000 ? 1000 : 3000;
  const PlanningResult first = plan_with(problem, GetParam(), options, 5), other = plan_with(problem, GetParam(), options, 6);
  ASSERT_TRUE(first && other) << text_of(first) << text_of(other);
  EXPECT_FALSE(same_bits(first->path, other->path));
  // Others beside it set the library's seed and make generators all the time.
  std::vector<std::optional<PlanningResult>> results(6);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < results.size(); ++k) {
    threads.emplace_back([&, k] { results[k] = k % 3 == 2 ? plan_with(problem, SamplingPlanner::rrt_connect, options, k) : plan_with(problem, GetParam(), options, 5 + k % 3); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (k % 3 == 2) continue;
    ASSERT_TRUE(*results[k]);
    EXPECT_TRUE(same_bits((*results[k])->path, k % 3 == 0 ? first->path : other->path)) << k;
    EXPECT_EQ((*results[k])->explanation, k % 3 == 0 ? first->explanation : other->explanation);
  }
}

/// The goal stands in a closed box.
Scenario walled_in() {
  Scenario s = in_a_hall();
  s.map.lines.push_back({{5.5, 2.5}, {7.9, 2.5}, {7.9, 4.9}, {5.5, 4.9}, {5.5, 2.5}});
  s.mission = Pose{6.7, 3.7, 0.5};
  return s;
}

TEST_P(EveryPlanner, NoWayIsAFailureWithItsCause) {
  const Problem problem = prepared(walled_in());
  ASSERT_FALSE(problem.check_ends());
  for (const SteeringKind space : {SteeringKind::plane, SteeringKind::reeds_shepp}) {
    OmplOptions options = in_space(space);
    options.checks = 2000;
    const PlanningResult result = plan_with(problem, GetParam(), options);
    ASSERT_FALSE(result);
    const Failure& failure = result.error().failure;
    EXPECT_EQ(failure.status, Status::no_path);
    EXPECT_NE(failure.reason.find("found no way from start to goal before all footprint placements of its budget were tested: 2000"), std::string::npos) << failure.reason;
    EXPECT_NE(failure.reason.find(" stood in the way of "), std::string::npos) << failure.reason;
    ASSERT_TRUE(failure.pose && failure.point) << failure.reason;
    const double missing = distance(failure.pose->position(), problem.goal().position());
    EXPECT_LT(missing, distance(problem.start().position(), problem.goal().position())) << failure.reason;
    EXPECT_GT(missing, 1.2);
    ASSERT_EQ(result.error().alternatives.size(), 1u);
    EXPECT_FALSE(result.error().explanation.empty());
  }
}

TEST_P(EveryPlanner, WorkStaysWithinTheBudget) {
  const Problem blocked = prepared(walled_in()), open = prepared(with_a_gap());
  for (const SteeringKind space : {SteeringKind::turns, SteeringKind::reeds_shepp}) {
    OmplOptions options = in_space(space);
    options.checks = 300;  // where motions are counted placements end a search that tests none
    for (const std::int64_t limit : {1, 3, 17, 250}) {
      for (const Problem* problem : {&blocked, &open}) {
        BudgetLimits motions;
        motions.evaluations = limit;
        Budget budget{motions};
        const PlanningResult result = OmplPlanner{GetParam(), options, 1}.plan(*problem, budget);
        EXPECT_LE(budget.evaluations(), limit);
        EXPECT_GE(budget.evaluations(), 1);
        EXPECT_FALSE(budget.cut_short());
        BudgetLimits placements;
        placements.samples = limit;
        const PlanningResult by_samples = plan_with(*problem, GetParam(), in_space(space), 1, placements);
        if (by_samples) expect_solved(*problem, by_samples, name_of(GetParam()));
      }
    }
  }
}

TEST_P(EveryPlanner, CancelAndClockEndItSoon) {
  const Problem problem = prepared(walled_in());
  OmplOptions endless = in_space(SteeringKind::reeds_shepp);
  endless.checks = 1'000'000'000;
  std::atomic<bool> flag{false};
  Budget canceled{{}, &flag};
  std::thread raise{[&flag] {
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    flag = true;
  }};
  const PlanningResult stopped = OmplPlanner{GetParam(), endless, 1}.plan(problem, canceled);
  raise.join();
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().failure.status, Status::canceled);
  BudgetLimits seconds;
  seconds.seconds = 0.05;
  Budget clock{seconds};
  const PlanningResult late = OmplPlanner{GetParam(), endless, 1}.plan(problem, clock);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().failure.status, Status::timed_out);
  EXPECT_LT(clock.elapsed(), 5.0);
}

TEST_P(EveryPlanner, FreeGoalsInThePlane) {
  Scenario point = with_a_gap();
  point.mission = FreeGoal{{{7.0, 4.0}}};
  Scenario region = with_a_gap();
  region.mission = FreeGoal{rectangle({6.0, 3.0}, {7.2, 4.2})};
  for (const Scenario& scenario : {point, region}) {
    const Problem problem = prepared(scenario);
    ASSERT_FALSE(problem.check_ends());
    const PlanningResult result = plan_with(problem, GetParam(), in_space(std::nullopt, work_of(GetParam())));
    expect_solved(problem, result, name_of(GetParam()));
    if (result) {
      EXPECT_TRUE(problem.is_goal(end_pose(result->path), 1e-6, 1e-6));
    }
  }
  const PlanningResult refused = plan_with(prepared(point), GetParam(), in_space(SteeringKind::turns));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().failure.reason.find("leaves the heading free"), std::string::npos);
}

/// Of all planners that go on to shorten, without shortcuts.
TEST_P(EveryPlanner, OptimisingPlannersComeNearTheOptimum) {
  if (!is_optimising(GetParam())) return;
  for (const SteeringKind space : {SteeringKind::plane, SteeringKind::reeds_shepp}) {
    // Nothing in the way: the planner itself, without the look at the motion from start to goal.
    Scenario empty = in_a_hall();
    empty.map = {};
    const Problem problem = prepared(empty);
    const auto steering = make_steering(space, {0.5005, 0.05, 0.5});
    Budget budget;
    MotionTest test{problem, {2 * work_of(GetParam()), 1'000'000'000, 0.001}, budget, space == SteeringKind::plane ? Footprint{{}, problem.footprint().radius()} : problem.footprint()};
    const SamplingResult found =
        sampling_search(GetParam(), {}, {problem.start(), {problem.goal()}, search_region(problem, space == SteeringKind::plane ? 0.0 : 0.5, space != SteeringKind::plane)}, *steering, test, 3);
    ASSERT_FALSE(found.states.empty()) << found.error;
    EXPECT_LE(cost_of(*steering, found.states), 1.02 * steering->distance(problem.start(), problem.goal())) << to_string(space);
  }
  // Round the end of a wall: two tangents and an arc about its end.
  Scenario wall = in_a_hall();
  wall.map = {};
  wall.map.boundaries.push_back(rectangle({-4, -4}, {4, 4}));
  wall.map.lines.push_back({{0.0, -4.0}, {0.0, 1.0}});
  wall.vehicle.footprint = Footprint{{}, 0.3};
  wall.start = {-2.0, 0.0, 0.0};
  wall.mission = Pose{2.0, 0.0, 0.0};
  const double away = std::sqrt(5.0), reach = 0.32, tangent = std::sqrt(away * away - reach * reach);
  const double optimum = 2.0 * tangent + reach * (pi + 2.0 * std::atan2(1.0, 2.0) - 2.0 * std::acos(reach / away));
  const PlanningResult result = plan_with(prepared(wall), GetParam(), in_space(std::nullopt, work_of(GetParam())));
  expect_solved(prepared(wall), result, name_of(GetParam()));
  if (result) {
    EXPECT_GE(length(result->path), optimum - 1e-3);
    EXPECT_LE(length(result->path), 1.03 * optimum);
  }
}

TEST_P(EveryPlanner, ATricycleIsAnsweredInCurvesAndRefusedElsewhere) {
  Scenario scenario = in_a_hall();
  scenario.vehicle.drive = Tricycle{0.4, 0.675, std::nullopt, SteeredAxle::front};
  const Problem problem = prepared(scenario);
  expect_solved(problem, plan_with(problem, GetParam(), in_space(std::nullopt, work_of(GetParam()))), name_of(GetParam()));
  for (const SteeringKind space : {SteeringKind::plane, SteeringKind::turns}) {
    const PlanningResult refused = plan_with(problem, GetParam(), in_space(space));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().failure.status, Status::no_path);
    EXPECT_NE(refused.error().failure.reason.find("which a tricycle cannot drive"), std::string::npos);
  }
}

TEST_P(EveryPlanner, IsDescribedAndTakesTheLibrarysParameters) {
  for (const PlannerDescription& description : ompl_planner_descriptions()) {
    if (description.name != name_of(GetParam())) continue;
    Parameters parameters;
    for (const ParameterDescription& p : description.parameters) {
      parameters[p.name] = p.default_value;
      // Flags the other way, and other numbers in range: the library takes them all.
      if (const auto* flag = std::get_if<bool>(&p.default_value)) parameters[p.name] = p.name == "simplify" ? *flag : !*flag;
    }
    parameters["checks"] = static_cast<double>(work_of(GetParam()));
    const Problem problem = prepared(with_a_gap());
    Budget budget;
    const PlanningResult result = description.make(parameters, 2).plan(problem, budget);
    expect_solved(problem, result, description.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Ompl, EveryPlanner, testing::ValuesIn(all_planners), [](const auto& entry) { return name_of(entry.param); });

TEST(OmplPlanner, WhatDubinsCurvesCannotDriveIsRefused) {
  const PlanningResult roadmap = plan_with(prepared(in_a_hall()), SamplingPlanner::prm_star, in_space(SteeringKind::dubins));
  ASSERT_FALSE(roadmap);
  EXPECT_NE(roadmap.error().failure.reason.find("Dubins curves lead forwards alone"), std::string::npos);
}

TEST(OmplPlanner, ADiscTooWideIsTold) {
  Scenario scenario = in_a_hall();
  scenario.map.obstacles.push_back(rectangle({0.8, 1.3}, {1.2, 1.5}));  // beside the start: the footprint fits, the disc around it does not
  const Problem problem = prepared(scenario);
  ASSERT_FALSE(problem.check_ends());
  const PlanningResult refused = plan_with(problem, SamplingPlanner::rrt_star, in_space(SteeringKind::plane));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().failure.reason.find("does not keep the required clearance at the start"), std::string::npos) << refused.error().failure.reason;
}

}  // namespace
}  // namespace waywright
