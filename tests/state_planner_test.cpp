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

/// The disc around the vehicle takes 1.61 m, and gets through if at all where few samples fall; the vehicle is 0.8 m wide.
Scenario among_splinters() {
  Scenario s;
  s.vehicle.footprint.polygon = rectangle({-0.7, -0.4}, {0.5, 0.4});
  s.vehicle.drive = Differential{0.6};
  s.map.boundaries = {rectangle({0, 0}, {12, 8})};
  s.map.obstacles = {{{6.71, 5.46}, {6.55, 5.53}, {6.34, 5.37}, {6.34, 5.36}, {6.42, 5.15}, {6.72, 5.2}, {6.75, 5.25}},
                     {{6.24, 4.68}, {5.62, 4.5}, {6.37, 3.87}},
                     {{5.29, 5.46}, {5.21, 5.64}, {4.84, 5.28}},
                     {{8.46, 2.37}, {8.35, 2.42}, {7.94, 2.4}},
                     {{8.02, 5.12}, {7.98, 4.03}, {8.65, 4.21}, {8.76, 4.45}},
                     {{4.7, 1.84}, {4.59, 1.42}, {4.6, 1.41}, {4.97, 1.3}},
                     {{7.59, 1.11}, {6.89, 1.41}, {6.58, 0.99}, {6.95, 0.42}},
                     {{9.38, 0.68}, {9.37, 0.71}, {8.48, 1.05}, {8.36, 0.39}, {8.96, 0.13}},
                     {{2.81, 1.92}, {2.56, 1.73}, {2.56, 1.66}, {2.91, 1.45}},
                     {{8.54, 2.19}, {8.51, 2.26}, {8.3, 1.89}, {8.37, 1.9}, {8.46, 1.94}, {8.53, 2.05}},
                     {{4.59, 4.78}, {4.58, 4.78}, {4.39, 4.38}, {5.01, 4.32}},
                     {{4.08, 1.25}, {3.48, 1.46}, {3.17, 1.06}, {3.56, 0.53}},
                     {{6.12, 6.58}, {6.16, 6.34}, {6.54, 6.24}},
                     {{5.38, 1.36}, {4.98, 1.31}, {5.76, 0.8}}};
  s.start = {1.0, 1.0, 0.3};
  s.mission = Pose{11, 7, 1.2};
  return s;
}

TEST(StatePlanners, TheFootprintItselfIsTriedWhereTheDiscFindsNoWay) {
  const Plan plan = planned(among_splinters(), "prm", {});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_TRUE(verify(plan).value().holds);
  ASSERT_GE(plan.explanation.size(), 2U);
  EXPECT_NE(plan.explanation[1].find("The footprint itself was searched for in the space \"turns\""), std::string::npos) << plan.explanation[1];
  EXPECT_NE(plan.explanation[1].find("the disc around the footprint"), std::string::npos) << plan.explanation[1];
  // Asked for the disc it stays with it, and says who would not.
  const Plan disc = planned(among_splinters(), "prm", {{"space", std::string{"plane"}}});
  EXPECT_EQ(disc.status, Status::no_path);
  EXPECT_NE(disc.reason.find("plan for the footprint itself"), std::string::npos) << disc.reason;
  // Of a budget of samples it gets what the disc left: nothing.
  Scenario limited = among_splinters();
  limited.budget.samples = 1000;
  const Plan spent = planned(limited, "prm", {});
  EXPECT_EQ(spent.status, Status::no_path);
  EXPECT_NE(spent.reason.find("plan for the footprint itself"), std::string::npos) << spent.reason;
  EXPECT_EQ(spent.reason.find("before that"), std::string::npos) << spent.reason;
  // Where neither finds one both are told.
  const Plan neither = planned(among_splinters(), "rrt_star", {{"iterations", 20.0}});
  EXPECT_EQ(neither.status, Status::no_path);
  EXPECT_NE(neither.reason.find("before that, for the disc around the footprint, RRT* found no way"), std::string::npos) << neither.reason;
  for (const char* name : {"visibility_graph", "voronoi"}) {
    Scenario gap = among_splinters();
    gap.map.obstacles = {rectangle({5.5, 0}, {6.5, 3.4}), rectangle({5.5, 4.6}, {6.5, 8})};  // 1.2 m
    const Plan shut = planned(gap, name, {});
    EXPECT_EQ(shut.status, Status::no_path);
    EXPECT_NE(shut.reason.find("prm and rrt_star with the space \"turns\" plan for the footprint itself"), std::string::npos) << shut.reason;
    EXPECT_NE(shut.reason.find("0.0000 m and 1.0 mm more for the proof"), std::string::npos) << shut.reason;
  }
}

TEST(StatePlanners, SayOfABudgetTheNumberThatWasGiven) {
  Scenario s = among_splinters();
  s.budget.evaluations = 10;
  const Plan whales = planned(s, "rrt_star_woa_global", {});
  EXPECT_NE(whales.reason.find("5 of the 10 evaluations of its budget were used, the others being kept for moving the corners of a way"), std::string::npos) << whales.reason;
  const Plan tree = planned(s, "rrt_star", {{"space", std::string{"turns"}}});
  EXPECT_NE(tree.reason.find("9 of the 10 motions of its budget were tested, the others being kept for shortening a way"), std::string::npos) << tree.reason;
  EXPECT_NE(planned(s, "rrt_star", {{"space", std::string{"plane"}}}).reason.find("all 10 evaluations of its budget were used"), std::string::npos);
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
