#include "waywright/planner/ompl/ompl_planner.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "tests/oracle/brute_force.hpp"
#include "waywright/core/random.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"
#include "waywright/planner/steering/search_ends.hpp"

namespace waywright {
namespace {

Vehicle forklift() {
  Vehicle v;
  v.name = "forklift";
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.9, 1.0, std::nullopt, SteeredAxle::rear};
  v.limits.curvature = 0.8;
  return v;
}

Scenario between(const Pose& start, const Pose& goal) {
  Scenario s;
  s.vehicle = forklift();
  s.start = start;
  s.mission = goal;
  return s;
}

/// The shelf looks along +x, so that the docked heading is π exactly; boxes stand where the usual manoeuvre
/// would go.
Scenario station() {
  Scenario s = between({8.0, 0.0, 0.0}, {});
  Station station;
  station.area = rectangle({-1.5, -5.0}, {10.5, 5.0});
  station.shelf = {{-0.6, 0.0}, 0.0, 1.2, 2.7, 0.1, 0.0};
  s.map.obstacles = {rectangle({3.6, -2.6}, {4.4, -1.4}), rectangle({5.2, 2.2}, {6.4, 3.0}),
                     rectangle({7.5, -4.9}, {8.8, -3.6})};
  s.map.points = {{3.0, 3.4}, {3.1, 3.45}, {9.8, 3.0}};
  s.mission = station;
  s.clearance = 0.05;
  return s;
}

/// The same with a box in the way of the motion that leads there at once.
Scenario behind_a_box() {
  Scenario s = station();
  s.map.obstacles.push_back(rectangle({4.4, -1.0}, {5.0, 1.0}));
  return s;
}

Problem prepared(const Scenario& scenario) { return Problem::prepare(scenario).value(); }

BudgetLimits samples(std::int64_t n) {
  BudgetLimits limits;
  limits.samples = n;
  return limits;
}

PlanningResult plan_with(const Problem& problem, std::uint64_t seed = 1,
                         const OmplOptions& options = {}, BudgetLimits limits = {}) {
  Budget budget{limits};
  return OmplPlanner{SamplingPlanner::rrt_connect, options, seed}.plan(problem, budget);
}

bool same_bits(const Path& a, const Path& b) {
  if (a.pieces.size() != b.pieces.size()) return false;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    const Piece& p = a.pieces[i];
    const Piece& q = b.pieces[i];
    if (p.direction != q.direction || p.curve.index() != q.curve.index()) return false;
    if (const auto* arc = std::get_if<Arc>(&p.curve)) {
      const auto& other = std::get<Arc>(q.curve);
      if (arc->start != other.start || arc->curvature != other.curvature || arc->length != other.length)
        return false;
    } else {
      const auto& line = std::get<Line>(p.curve);
      const auto& other = std::get<Line>(q.curve);
      if (line.from != other.from || line.to != other.to) return false;
    }
  }
  return true;
}

double brute_force_clearance(const Problem& problem, const Path& path) {
  std::vector<Ring> areas;
  std::vector<Ring> shelves;
  if (const auto* s = std::get_if<Station>(&problem.scenario().mission)) {
    areas.push_back(s->area);
    shelves.push_back(s->shelf.outline());
  }
  return oracle_path_clearance(problem.world().map(), areas, shelves, problem.vehicle().footprint, path,
                               0.001);
}

void expect_solved(const Problem& problem, const PlanningResult& result) {
  ASSERT_TRUE(result) << result.error().failure.reason;
  const Plan plan = judge(problem, result->path);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_LT(distance(end_pose(result->path).position(), problem.goal().position()), 1e-9);
  EXPECT_LT(std::abs(shorter_turn(end_pose(result->path).heading, problem.goal().heading)), 1e-9);
  for (std::size_t i = 1; i < result->path.pieces.size(); ++i) {  // merged where they can be
    const Piece& a = result->path.pieces[i - 1];
    const Piece& b = result->path.pieces[i];
    EXPECT_FALSE(a.direction == b.direction && a.curve.index() == b.curve.index() &&
                 end_curvature(a) == start_curvature(b));
  }
}

TEST(RrtConnect, InAnEmptyWorldThePathIsTheShortestReedsSheppCurve) {
  Random random{21};
  const ReedsShepp curves{1.001 / 0.8};
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Pose start{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)};
    const Pose goal{random.uniform(-5, 5), random.uniform(-5, 5), i % 3 == 0 ? pi : random.uniform(-pi, pi)};
    const Problem problem = prepared(between(start, goal));
    const PlanningResult result = plan_with(problem, i);
    expect_solved(problem, result);
    EXPECT_NEAR(length(result->path), curves.distance(start, goal), 1e-6);
  }
}

TEST(RrtConnect, DocksAtAShelfWhoseDockedHeadingIsPi) {
  const Problem problem = prepared(station());
  ASSERT_EQ(problem.goal().heading, pi);
  ASSERT_FALSE(problem.check_ends());
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const PlanningResult result = plan_with(problem, seed);
    expect_solved(problem, result);
    EXPECT_GE(brute_force_clearance(problem, result->path), 0.05);
    EXPECT_EQ(result->alternatives.size(), 1u);
    EXPECT_TRUE(result->alternatives[0].chosen);
    EXPECT_NEAR(*result->alternatives[0].cost, length(result->path), 1e-12);
    EXPECT_FALSE(result->alternatives[0].poses.empty());
    EXPECT_NE(result->explanation[0].find("sampling planner"), std::string::npos);
  }
}

TEST(RrtConnect, RandomRoomsAreSolvedAndProvenOrFailWithACause) {
  Random random{22};
  int solved = 0;
  for (int i = 0; i < 40; ++i) {
    Scenario s = between({random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)},
                         {random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)});
    s.map.boundaries.push_back(rectangle({-9, -9}, {9, 9}));
    for (int k = 0; k < 8; ++k) {
      const Vec2 half{random.uniform(0.1, 0.8), random.uniform(0.1, 0.8)};
      const Pose at{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(-pi, pi)};
      s.map.obstacles.push_back(transformed(rectangle(-half, half), Frame{at}));
    }
    s.clearance = random.uniform(0.0, 0.1);
    s.pose_error = {0.01, 0.01, 0.005};
    const Problem problem = prepared(s);
    if (problem.check_ends()) continue;
    const PlanningResult result = plan_with(problem, static_cast<std::uint64_t>(i), {}, samples(20000));
    if (!result) {
      EXPECT_EQ(result.error().failure.status, Status::no_path);
      continue;
    }
    expect_solved(problem, result);
    EXPECT_GE(brute_force_clearance(problem, result->path), problem.required_clearance());
    ++solved;
  }
  EXPECT_GE(solved, 15);
}

TEST(RrtConnect, ShorteningHelpsAndCanBeLeftOut) {
  const Problem problem = prepared(behind_a_box());
  OmplOptions plain;
  plain.simplify = false;
  const PlanningResult found = plan_with(problem, 4, plain);
  const PlanningResult shortened = plan_with(problem, 4);
  expect_solved(problem, found);
  expect_solved(problem, shortened);
  EXPECT_LT(length(shortened->path), length(found->path));
}

TEST(RrtConnect, SameSeedSameBitsWhateverRanBeforeOrRunsBeside) {
  const Problem problem = prepared(behind_a_box());
  const PlanningResult first = plan_with(problem, 5);
  ASSERT_TRUE(first);
  const PlanningResult other = plan_with(problem, 6);
  ASSERT_TRUE(other);
  EXPECT_FALSE(same_bits(first->path, other->path));
  const PlanningResult again = plan_with(problem, 5);
  ASSERT_TRUE(again);
  EXPECT_TRUE(same_bits(first->path, again->path));
  EXPECT_EQ(first->explanation, again->explanation);

  std::vector<std::optional<PlanningResult>> results(8);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < results.size(); ++k) {
    threads.emplace_back([&, k] { results[k] = plan_with(problem, 5 + k % 2); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < results.size(); ++k) {
    ASSERT_TRUE(results[k] && *results[k]);
    EXPECT_TRUE(same_bits((*results[k])->path, k % 2 == 0 ? first->path : other->path)) << k;
  }
}

/// The goal stands in a closed box.
Scenario walled_in() {
  Scenario s = between({0.0, 0.0, 0.0}, {8.0, 0.0, 0.0});
  s.map.boundaries.push_back(rectangle({-5, -5}, {13, 5}));
  s.map.lines.push_back({{4.0, -3.0}, {12.0, -3.0}, {12.0, 3.0}, {4.0, 3.0}, {4.0, -3.0}});
  return s;
}

TEST(RrtConnect, NoWayIsAFailureWithItsCause) {
  const Problem problem = prepared(walled_in());
  ASSERT_FALSE(problem.check_ends());
  Budget budget{samples(5000)};
  const PlanningResult result = OmplPlanner{SamplingPlanner::rrt_connect, {}, 1}.plan(problem, budget);
  ASSERT_FALSE(result);
  const PlanningFailure& failure = result.error();
  EXPECT_EQ(failure.failure.status, Status::no_path);
  EXPECT_NE(failure.failure.reason.find("5000 footprint placements"), std::string::npos)
      << failure.failure.reason;
  EXPECT_NE(failure.failure.reason.find("line 0 stood in the way"), std::string::npos)
      << failure.failure.reason;
  EXPECT_NE(failure.failure.reason.find("m of Reeds-Shepp curve are missing"), std::string::npos)
      << failure.failure.reason;
  ASSERT_TRUE(failure.failure.pose && failure.failure.point);
  EXPECT_LT(failure.failure.pose->x, 4.0);  // as far as the start's tree can come
  ASSERT_EQ(failure.alternatives.size(), 1u);
  EXPECT_FALSE(failure.alternatives[0].chosen);
  EXPECT_FALSE(failure.explanation.empty());
}

TEST(RrtConnect, WorkStaysWithinTheBudget) {
  const Problem blocked = prepared(walled_in());
  const Problem open = prepared(station());
  for (const std::int64_t limit : {1, 2, 3, 17, 250}) {
    for (const Problem* problem : {&blocked, &open}) {
      BudgetLimits motions;
      motions.evaluations = limit;
      Budget budget{motions};
      const PlanningResult result = OmplPlanner{SamplingPlanner::rrt_connect, {}, 1}.plan(*problem, budget);
      EXPECT_LE(budget.evaluations(), limit);
      EXPECT_FALSE(budget.cut_short());
      if (problem == &blocked) {
        EXPECT_EQ(budget.evaluations(), limit);
      }
      if (!result) {
        EXPECT_EQ(result.error().failure.status, Status::no_path);
      }
      const PlanningResult by_samples = plan_with(*problem, 1, {}, samples(limit));
      if (by_samples) expect_solved(*problem, by_samples);
    }
  }
  EXPECT_FALSE(plan_with(open, 1, {}, samples(5)));
  EXPECT_TRUE(plan_with(open, 1, {}, samples(20000)));
}

TEST(RrtConnect, CancelAndClockEndIt) {
  const Problem problem = prepared(walled_in());
  OmplOptions endless;
  endless.checks = 1'000'000'000;
  const std::atomic<bool> raised{true};
  Budget canceled{{}, &raised};
  const PlanningResult none = OmplPlanner{SamplingPlanner::rrt_connect, endless, 1}.plan(problem, canceled);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().failure.status, Status::canceled);

  std::atomic<bool> flag{false};
  Budget later{{}, &flag};
  std::thread raise{[&flag] {
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    flag = true;
  }};
  const PlanningResult stopped = OmplPlanner{SamplingPlanner::rrt_connect, endless, 1}.plan(problem, later);
  raise.join();
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().failure.status, Status::canceled);

  BudgetLimits seconds;
  seconds.seconds = 0.05;
  Budget clock{seconds};
  const PlanningResult late = OmplPlanner{SamplingPlanner::rrt_connect, endless, 1}.plan(problem, clock);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().failure.status, Status::timed_out);
  EXPECT_TRUE(clock.cut_short());
  EXPECT_LT(clock.elapsed(), 5.0);
}

TEST(RrtConnect, UnusualEndsAndVehicles) {
  // Start and goal are one pose: nothing to drive, said so.
  const PlanningResult same = plan_with(prepared(between({1.0, 2.0, 0.5}, {1.0, 2.0, 0.5})));
  ASSERT_FALSE(same);
  EXPECT_NE(same.error().failure.reason.find("same pose"), std::string::npos);
  // An end that does not keep the clearance is refused, not waited for.
  Scenario touching = walled_in();
  touching.mission = Pose{4.1, 0.0, 0.0};
  const PlanningResult refused = plan_with(prepared(touching));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().failure.reason.find("goal pose"), std::string::npos);
  // No curvature limit, a disc.
  Scenario free_turning = between({0.0, 0.0, -pi}, {3.0, 1.0, 0.5 * pi});
  free_turning.vehicle = {};
  free_turning.vehicle.footprint.disc = 0.4;
  free_turning.map.obstacles.push_back(rectangle({1.0, -1.0}, {1.5, 3.0}));
  const Problem turning = prepared(free_turning);
  OmplOptions bending;
  bending.space = SteeringKind::reeds_shepp;
  const PlanningResult round = plan_with(turning, 1, bending);
  expect_solved(turning, round);
  for (const Piece& piece : round->path.pieces) EXPECT_LE(std::abs(start_curvature(piece)), 1.0 / 0.3 + 1e-9);
  // A vehicle that cannot turn has no Reeds-Shepp curves.
  Scenario rail = between({0.0, 0.0, 0.0}, {-4.0, 0.0, 0.0});
  rail.vehicle.limits.curvature = 0.0;
  const PlanningResult none = plan_with(prepared(rail));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().failure.status, Status::no_path);
  EXPECT_NE(none.error().failure.reason.find("curvature limit"), std::string::npos);
  // One that hardly turns, and coordinates of a large site.
  Scenario wide = between({9e5, -9e5, 1.0}, {9e5 + 30.0, -9e5 + 3.0, 1.2});
  wide.vehicle.limits.curvature = 0.01;
  expect_solved(prepared(wide), plan_with(prepared(wide)));
}

TEST(RrtConnect, GapThatIsJustTheClearance) {
  Scenario s = station();
  std::get<Station>(s.mission).shelf.gap = 0.05;
  const Problem problem = prepared(s);
  ASSERT_FALSE(problem.check_ends());
  expect_solved(problem, plan_with(problem));
}

TEST(RrtConnect, AWayRoundAWallInTheOpen) {
  Scenario s = between({-6.0, 0.0, 0.0}, {6.0, 0.0, 0.0});
  s.map.lines.push_back({{0.0, -8.0}, {0.0, 8.0}});
  const Problem problem = prepared(s);
  const Box region = search_region(problem, 1.25);
  EXPECT_LT(region.low.y, -10.0);  // room to pass beyond the wall's ends
  EXPECT_GT(region.high.y, 10.0);
  expect_solved(problem, plan_with(problem));
  // A boundary is not sampled beyond.
  s.map.boundaries.push_back(rectangle({-9, -12}, {9, 11}));
  const Box inside = search_region(prepared(s), 1.25);
  EXPECT_NEAR(inside.low.y, -12.0, 1e-5);
  EXPECT_NEAR(inside.high.y, 11.0, 1e-5);
}

TEST(RrtConnect, DescriptionMatchesTheOptions) {
  const PlannerDescription description = ompl_planner_descriptions().front();
  EXPECT_EQ(description.name, "ompl_rrt_connect");
  Parameters parameters;
  for (const ParameterDescription& p : description.parameters) {
    parameters[p.name] = p.default_value;
    if (const auto* number = std::get_if<double>(&p.default_value)) {
      EXPECT_GE(*number, p.low) << p.name;
      EXPECT_LE(*number, p.high) << p.name;
    }
    EXPECT_FALSE(p.summary.empty());
  }
  const AnyPlanner planner = description.make(parameters, 5);
  EXPECT_EQ(planner.name(), description.name);
  const Problem problem = prepared(station());
  Budget budget;
  const PlanningResult made = planner.plan(problem, budget);
  const PlanningResult direct = plan_with(problem, 5);
  ASSERT_TRUE(made && direct);
  EXPECT_TRUE(same_bits(made->path, direct->path));
}

}  // namespace
}  // namespace waywright
