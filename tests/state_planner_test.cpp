// `rrt`, `rrt_star` and `prm` among positions with headings, on whole scenarios: proven, no shorter than the bound, through where no disc fits, honest where there is no way.
#include <gtest/gtest.h>

#include <map>
#include <thread>

#include "tests/grid_scenarios.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {
namespace {

using test::hall;
using test::planned;

const std::vector<std::string> names{"rrt", "rrt_star", "prm"};
const std::vector<std::string> spaces{"turns", "dubins", "reeds_shepp"};

Parameters in(const std::string& space, const std::string& name) {
  Parameters parameters;
  if (!space.empty()) parameters["space"] = space;
  if (name == "rrt_star") parameters["iterations"] = 1200.0;
  return parameters;
}

/// Why nothing is planned: of what is refused beforehand the sentence, else the plan's reason; empty where a path was found.
std::string refusal(Scenario scenario, const std::string& planner, const std::string& space) {
  scenario.planner = {planner, {{"space", space}}};
  const auto plan = solve(Problem::prepare(std::move(scenario)).value());
  return plan ? plan->reason : plan.error().message();
}

Scenario example(const std::string& name) { return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name).value(); }

TEST(StatePlanners, EveryPathIsProvenAndNoneIsShorterThanTheBound) {
  Random random{71};
  std::map<std::string, int> solved;
  int halls = 0;
  for (int i = 0; i < 10; ++i) {
    Scenario s = hall(random, Footprint{{{-0.3, -0.25}, {0.6, -0.25}, {0.6, 0.25}, {-0.3, 0.25}}, 0.0}, i % 2 == 0 ? 0.05 : 0.0, 3 + i % 6);
    const bool is_tricycle = i % 3 == 0;
    if (is_tricycle) s.vehicle.drive = Tricycle{0.8, 1.0};
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    ++halls;
    const PlaneSpace space{problem};
    Budget budget;
    const LeastLength least = least_length(space, budget);
    for (const std::string& name : names) {
      for (const std::string& motions : spaces) {
        if (is_tricycle && motions == "turns") {
          EXPECT_NE(refusal(s, name, motions).find("which a tricycle cannot drive"), std::string::npos);
          continue;
        }
        const Plan plan = planned(s, name, in(motions, name));
        ASSERT_TRUE(plan.status == Status::solved || plan.status == Status::no_path) << name << " " << motions << " " << i << ": " << plan.reason;
        if (plan.status != Status::solved) continue;
        ++solved[name + " " + motions];
        EXPECT_FALSE(least.is_unreachable);
        EXPECT_GE(plan.metrics.length, least.metres - 1e-6) << name << " " << motions << " " << i;
        EXPECT_TRUE(verify(plan).value().holds) << name << " " << motions << " " << i;
        for (const Piece& piece : plan.path.pieces) {
          EXPECT_FALSE(motions == "turns" ? std::holds_alternative<Arc>(piece.curve) : std::holds_alternative<Turn>(piece.curve));
          EXPECT_FALSE(motions == "dubins" && piece.direction < 0);
        }
      }
    }
  }
  EXPECT_GE(halls, 8);
  for (const std::string& name : names) {
    for (const std::string& motions : spaces) EXPECT_GE(solved[name + " " + motions], motions == "reeds_shepp" ? halls - 2 : halls / 2) << name << " " << motions;
  }
}

TEST(StatePlanners, AutoTakesTheSpaceThatServes) {
  const auto has = [](const Plan& plan, const char* words) { return plan.explanation.front().find(words) != std::string::npos; };
  for (const std::string& name : names) {
    // A gap of 1.2 m, the disc around the wheelchair takes 1.73 m.
    Parameters parameters = in("", name);
    if (name == "prm") parameters["samples"] = 4000.0;
    if (name == "rrt_star") parameters["iterations"] = 3000.0;
    const Plan narrow = planned(example("rrt_woa/wheelchair_3.json"), name, parameters);
    ASSERT_EQ(narrow.status, Status::solved) << name << ": " << narrow.reason;
    EXPECT_TRUE(has(narrow, "turns on the spot")) << narrow.explanation.front();
    parameters["space"] = std::string{"plane"};
    EXPECT_EQ(planned(example("rrt_woa/wheelchair_3.json"), name, parameters).status, Status::no_path) << name;
    // Where the disc gets through it stays in the plane: the same as if that had been asked for.
    const Scenario wide = example("rrt_woa/wheelchair_4.json");
    parameters.erase("space");
    const Plan chosen = planned(wide, name, parameters);
    parameters["space"] = std::string{"plane"};
    const Plan asked = planned(wide, name, parameters);
    ASSERT_EQ(chosen.status, Status::solved) << name << ": " << chosen.reason;
    EXPECT_TRUE(has(chosen, "the disc around the footprint"));
    EXPECT_EQ(chosen.metrics.length, asked.metrics.length);
    EXPECT_EQ(chosen.explanation, asked.explanation);
    const Plan docked = planned(example("dock_cluttered.json"), name, in("", name));
    ASSERT_EQ(docked.status, Status::solved) << name << ": " << docked.reason;
    EXPECT_TRUE(has(docked, "Reeds-Shepp"));
    EXPECT_TRUE(verify(docked).value().holds);
  }
}

TEST(StatePlanners, RefusalsAreThoseOfTheLibrarysPlanners) {
  Scenario free = example("goal_pose.json"), steered = free;
  steered.vehicle.drive = Tricycle{0.8, 1.0};
  free.mission = FreeGoal{{std::get<Pose>(free.mission).position()}};
  Scenario both = steered;
  both.mission = free.mission;
  for (const std::string& name : names) {
    for (const auto& [scenario, space] : {std::pair{free, "reeds_shepp"}, {free, "turns"}, {steered, "plane"}, {steered, "turns"}, {both, "auto"},
                                          {both, "plane"}, {example("undock_loaded.json"), "dubins"}}) {
      std::string words = refusal(scenario, "ompl_rrt_star", space);
      ASSERT_FALSE(words.empty()) << space;
      if (const std::size_t at = words.find("ompl_rrt_star"); at != std::string::npos) words.replace(at, std::string{"ompl_rrt_star"}.size(), name);
      EXPECT_EQ(refusal(scenario, name, space), words);
    }
  }
}

TEST(StatePlanners, RrtStarIsNoLongerThanRrtOnTheSameSeed) {
  Scenario s = example("dock_cluttered.json");
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    s.seed = seed;
    const Parameters plain{{"iterations", 3000.0}, {"shorten", false}};
    const Plan rrt = planned(s, "rrt", plain), star = planned(s, "rrt_star", plain);
    ASSERT_EQ(rrt.status, Status::solved) << rrt.reason;
    ASSERT_EQ(star.status, Status::solved) << star.reason;
    EXPECT_LE(star.metrics.length, rrt.metrics.length + 1e-9) << seed;
  }
}

TEST(StatePlanners, AShutDoorIsNamedAsNoWayAtAllAndWorkIsKept) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({4, 0}, {5, 2.7}), rectangle({4, 3.0}, {5, 6})};  // a gap of 0.3 m
  s.vehicle.footprint.polygon = rectangle({-0.3, -0.25}, {0.6, 0.25});
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{9, 5, 0};
  for (const std::string& name : names) {
    s.budget.samples = 300;
    s.budget.evaluations.reset();
    const Plan plan = planned(s, name);  // turns: the disc cannot pass
    EXPECT_EQ(plan.status, Status::no_path) << name;
    EXPECT_NE(plan.reason.find("none at all"), std::string::npos) << name << ": " << plan.reason;
    EXPECT_NE(plan.reason.find(name == "prm" ? "300 states" : "all 300 samples were drawn"), std::string::npos) << plan.reason;
    EXPECT_NE(plan.reason.find("nearest to the goal it came to"), std::string::npos) << plan.reason;
    s.budget.samples.reset();
    s.budget.evaluations = 25;
    const Plan few = planned(s, name);
    EXPECT_LE(few.effort.evaluations, 25);
    EXPECT_NE(few.reason.find("of its budget were tested"), std::string::npos) << few.reason;
  }
  s.budget = {};
  for (const std::string& name : names) {
    Scenario longer = s;
    longer.planner = {name, {{name == "prm" ? "samples" : "iterations", name == "prm" ? 1e5 : 1e7}, {"space", std::string{"reeds_shepp"}}}};
    const Problem problem = Problem::prepare(longer).value();
    std::atomic<bool> cancel{false};
    std::chrono::steady_clock::time_point raised;
    std::thread other{[&] {
      std::this_thread::sleep_for(std::chrono::milliseconds{100});
      raised = std::chrono::steady_clock::now();
      cancel = true;
    }};
    const Plan plan = *solve(problem, &cancel);
    other.join();
    EXPECT_EQ(plan.status, Status::canceled) << name;
    EXPECT_LT(std::chrono::steady_clock::now() - raised, std::chrono::seconds{2}) << name;
  }
}

}  // namespace
}  // namespace waywright
