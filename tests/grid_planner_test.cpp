// `dijkstra` and `astar` from problem to proven plan.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <thread>

#include "tests/grid_scenarios.hpp"
#include "tests/outside_data.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

using namespace waywright::test;

const Footprint box{{{-0.6, -0.25}, {0.4, -0.25}, {0.4, 0.25}, {-0.6, 0.25}}, 0.0};
const Footprint notched{{{-0.5, -0.3}, {0.6, -0.3}, {0.6, 0.3}, {0.1, 0.05}, {-0.5, 0.3}}, 0.0};

/// m, of the way over the cells alone, as the first sentence tells it to a millimetre: its ends are joined straight afterwards.
double told_cost(const Plan& plan) {
  const std::string& sentence = plan.explanation.front();
  const std::size_t at = sentence.find("neighbours: ");
  return at == std::string::npos ? -1.0 : std::stod(sentence.substr(at + 12));
}

// The planner never leaves the proof anything to refuse, and A* is as good as Dijkstra.
TEST(GridPlanner, EveryWayFoundIsProvenAndAStarCostsWhatDijkstraCosts) {
  Random random{21};
  int solved = 0, none = 0;
  for (int i = 0; i < 60; ++i) {
    const Footprint& footprint = i % 3 == 0 ? disc : i % 3 == 1 ? box : notched;
    Scenario s = hall(random, footprint, i % 4 == 0 ? 0.0 : 0.05, 14);
    if (i % 5 == 0) s.pose_error = {0.01, 0.01, 0.01};
    const Parameters parameters{{"neighbours", i % 2 == 0 ? 8.0 : 16.0}, {"resolution", 0.2}};
    const Plan a = planned(s, "astar", parameters), d = planned(s, "dijkstra", parameters);
    ASSERT_EQ(a.status, d.status) << i << ": " << a.reason << " / " << d.reason;
    ASSERT_NE(a.status, Status::unproven) << i << ": " << a.reason;
    if (a.status != Status::solved) {
      ++none;
      ASSERT_FALSE(a.reason.empty());
      continue;
    }
    ++solved;
    ASSERT_LE(a.effort.expansions, d.effort.expansions);
    if (footprint.is_disc()) {
      // Of ways over the cells that cost the same each may be joined otherwise to its ends, which makes neither longer.
      ASSERT_NEAR(told_cost(a), told_cost(d), 1e-3);
      ASSERT_GT(told_cost(a), 0.0);
      for (const Plan* plan : {&a, &d}) ASSERT_LE(plan->metrics.length, told_cost(*plan) + 6e-4) << i;
    }
    const Pose end = end_pose(a.path);
    const Pose goal = std::get<Pose>(s.mission);
    ASSERT_LE(distance(end.position(), goal.position()), 1e-9);
    ASSERT_LE(std::abs(shorter_turn(end.heading, goal.heading)), 1e-9);
    ASSERT_GE(a.metrics.length, distance(s.start.position(), goal.position()) - 1e-9);
    if (i % 6 == 0) {
      const Plan read = parse_plan(plan_json(a), "plan.json").value();
      ASSERT_TRUE(verify(read)->holds);
      ASSERT_EQ(read.effort.expansions, a.effort.expansions);
    }
  }
  EXPECT_GT(solved, 35);
}

// Where start and goal lie off the middles of the cells nothing is driven to the middles and back.
TEST(GridPlanner, EndsOffTheMiddlesHaveNoStubs) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 6})};
  s.vehicle.drive = Differential{0.5};
  for (const Footprint& footprint : {disc, box}) {
    s.vehicle.footprint = footprint;
    for (const double off : {0.015, -0.02, 0.0249}) {
      s.start = {2.025 + off, 3.025 + off, 0};
      s.mission = Pose{10.025 + off, 3.025 + off, 0};
      for (const char* planner : {"astar", "dijkstra", "danger_astar", "block_astar", "safe_astar"}) {
        const Plan plan = planned(s, planner, {{"resolution", 0.05}});
        ASSERT_EQ(plan.status, Status::solved) << planner << plan.reason;
        EXPECT_NEAR(plan.metrics.length, 8.0, 1e-9) << planner;
        EXPECT_LE(plan.metrics.turning, 1e-9) << planner;
      }
    }
  }
  // On the middles the way is the cells' own: 3 m straight and 5 m askew, as 8 neighbours have it.
  s.vehicle.footprint = disc;
  s.start = {2.025, 0.525, 0};
  s.mission = Pose{10.025, 5.525, 0};
  EXPECT_NEAR(planned(s, "astar", {{"resolution", 0.05}, {"neighbours", 8.0}}).metrics.length, 3.0 + 5.0 * std::sqrt(2.0), 1e-6);
}

// An end is joined as far as the footprint can be proven to get straight, and no farther: around a wall, through a door it was searched through.
TEST(GridPlanner, JoinedEndsStayFree) {
  Random random{5};
  int solved = 0, shorter = 0;
  for (int i = 0; i < 60; ++i) {
    Scenario s = hall(random, i % 2 == 0 ? disc : notched, i % 3 == 0 ? 0.0 : 0.05, 20);
    const bool goes_back = i % 4 == 1;
    if (i % 5 == 0) s.zones.push_back({ZoneType::penalty, "", rectangle({4, 2}, {8, 7}), 0.0, 3.0, 0.0});
    const Plan plan = planned(s, "astar", {{"neighbours", 8.0}, {"resolution", 0.15}, {"reverse_cost", goes_back ? 1.0 : 3.0}});
    ASSERT_NE(plan.status, Status::unproven) << i << ": " << plan.reason;
    if (plan.status != Status::solved) continue;
    ++solved;
    if (i % 2 == 0 && i % 5 != 0) shorter += plan.metrics.length < told_cost(plan) - 1e-3 ? 1 : 0;
  }
  EXPECT_GT(solved, 35);
  EXPECT_GT(shorter, 8);
}

TEST(GridPlanner, AnyAnglesAreNeverLongerAndOftenMuchShorter) {
  Random random{31};
  int solved = 0, shorter = 0;
  for (int i = 0; i < 60; ++i) {
    const Scenario s = hall(random, disc, i % 2 == 0 ? 0.0 : 0.05, 14);
    const Parameters parameters{{"neighbours", i % 3 == 0 ? 16.0 : 8.0}, {"resolution", i % 4 == 0 ? 0.1 : 0.25}};
    const Plan grid = planned(s, "astar", parameters), any = planned(s, "theta_star", parameters);
    ASSERT_EQ(any.status, grid.status) << i << ": " << any.reason;
    if (grid.status != Status::solved) continue;
    ++solved;
    ASSERT_LE(any.metrics.length, grid.metrics.length + 1e-9) << i;
    ASSERT_GE(any.metrics.length, distance(s.start.position(), std::get<Pose>(s.mission).position()) - 1e-9);
    shorter += any.metrics.length < 0.99 * std::max(grid.metrics.length, told_cost(grid)) ? 1 : 0;  // than the way over the cells
  }
  EXPECT_GT(solved, 40);
  EXPECT_GT(shorter, 20);
}

// The shortest way past one corner is known: two tangents to the circle around it, and what the lattice cannot have of the arc between.
TEST(GridPlanner, AnyAnglesComeNearTheTautWayAroundACorner) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 10})};
  s.map.obstacles = {rectangle({4, 0.01}, {6, 5})};
  s.vehicle.footprint = disc;
  s.vehicle.drive = Differential{0.5};
  s.start = {1.0, 3.0, 0};
  s.mission = Pose{9.0, 3.0, 0};
  // From (1, 3) over the corners' tops at height 5.301, each of radius 0.301 around (4, 5) and (6, 5).
  const double r = 0.301, reach = std::hypot(3.0, 2.0), tangent = std::sqrt(reach * reach - r * r);
  const double turned = std::atan2(2.0, 3.0) + std::asin(r / reach);
  const double taut = 2.0 * (tangent + r * turned) + 2.0;
  const Plan any = planned(s, "theta_star", {{"resolution", 0.05}});
  ASSERT_EQ(any.status, Status::solved) << any.reason;
  EXPECT_GE(any.metrics.length, taut - 0.003);  // the start's own leg may come nearer by a millimetre
  EXPECT_LE(any.metrics.length, taut + 0.06);
}

// A hall of cells, turned and shifted: native cells, poses off their middles.
TEST(GridPlanner, PlansOnTheMapsOwnCellsWhereverTheyLie) {
  Random random{4};
  int solved = 0;
  for (int i = 0; i < 20; ++i) {
    Scenario s;
    CellGrid grid;
    grid.name = "hall";
    grid.columns = 60;
    grid.rows = 40;
    grid.cell = 0.2;
    grid.origin = {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3, 3)};
    for (int k = 0; k < 2400; ++k) grid.blocked.push_back(random.uniform() < 0.02 ? 1 : 0);
    s.map.grids = {grid};
    s.vehicle.footprint = i % 2 == 0 ? Footprint{{}, 0.25} : box;
    s.vehicle.drive = Differential{0.5};
    World world{s.map};
    world.build();
    const auto pose = [&] {
      for (;;) {
        const Vec2 at = grid.corner(random.uniform(2, 58), random.uniform(2, 38));
        const Pose p = make_pose(at, random.uniform(-3, 3));
        if (world.clearance(s.vehicle.footprint, p, 1.0).clearance > 1e-4) return p;
      }
    };
    s.start = pose();
    s.mission = pose();
    const Plan plan = planned(s, "astar", {{"neighbours", 8.0}});
    ASSERT_NE(plan.status, Status::unproven) << i << ": " << plan.reason;
    solved += plan.status == Status::solved ? 1 : 0;
  }
  EXPECT_GT(solved, 12);
}

// Real maps, read in place: halls with ragged walls, unknown cells, rotated origins.
TEST(GridPlanner, RealMapsArePlannedOnAndProven) {
  const auto folder = test::outside_data("ros_maps");
  if (!folder) GTEST_SKIP() << test::no_outside_data;
  Random random{12};
  for (const char* name : {"nav2/depot.yaml", "ipa_factory/map.yaml", "aws_hospital/hospital.yaml", "stata_basement/stata_basement.yaml", "nav2/warehouse.yaml"}) {
    SCOPED_TRACE(name);
    Scenario s;
    s.map = read_map(*folder / name).value();
    s.vehicle.drive = Differential{0.4};
    s.clearance = 0.05;
    const World world{s.map};
    World built = world;
    built.build();
    const CellGrid& grid = s.map.grids.front();
    int solved = 0;
    for (const auto& [planner, footprint] : {std::pair{"astar", disc}, std::pair{"theta_star", disc}, std::pair{"astar", Footprint{{{-0.5, -0.25}, {0.4, -0.25}, {0.4, 0.25}, {-0.5, 0.25}}, 0.0}}}) {
      s.vehicle.footprint = footprint;
      const auto pose = [&] {
        for (;;) {
          const Pose p = make_pose(grid.corner(random.uniform(0, grid.columns), random.uniform(0, grid.rows)), random.uniform(-3, 3));
          if (built.clearance(footprint, p, 0.6).clearance > 0.3) return p;
        }
      };
      s.start = pose();
      do {
        s.mission = pose();
      } while (distance(s.start.position(), std::get<Pose>(s.mission).position()) > 15.0);
      s.planner = {planner, {}};
      const Plan plan = *solve(Problem::prepare(s, &world).value());
      EXPECT_NE(plan.status, Status::unproven) << plan.reason;
      EXPECT_TRUE(plan.status == Status::solved || plan.status == Status::no_path) << to_string(plan.status) << ": " << plan.reason;
      solved += plan.status == Status::solved ? 1 : 0;
    }
    EXPECT_GE(solved, 1);
  }
}

/// A box of walls around the goal, with a door of this width.
Scenario room(double door) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 8})};
  const double low = 4.0 - 0.5 * door, high = 4.0 + 0.5 * door;
  s.map.obstacles = {rectangle({6, 0.01}, {6.2, low}), rectangle({6, high}, {6.2, 7.99})};
  s.vehicle.footprint = disc;
  s.vehicle.drive = Differential{0.5};
  s.start = {1, 1, 0};
  s.mission = Pose{9, 7, 0};
  return s;
}

TEST(GridPlanner, AGoalThatCannotBeReachedIsSaidAtOnce) {
  const Plan plan = planned(room(0.5), "astar", {{"resolution", 0.05}});
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_EQ(plan.effort.expansions, 0);
  EXPECT_NE(plan.reason.find("without a search"), std::string::npos) << plan.reason;
}

// A door 5 mm wider than the disc is found where the cells' middles lie in its middle line.
TEST(GridPlanner, FindsADoorThatIsMillimetresWiderThanTheDisc) {
  EXPECT_EQ(planned(room(0.605), "astar", {{"resolution", 0.32}}).status, Status::solved);
  EXPECT_EQ(planned(room(0.6005), "astar", {{"resolution", 0.32}}).status, Status::no_path);
}

TEST(GridPlanner, RefusesWhatCannotTurnOnTheSpot) {
  Scenario s = room(2.0);
  s.vehicle.drive = Tricycle{1.0, 1.0};
  const auto taken = check_mission("astar", s);
  ASSERT_FALSE(taken);
  const std::string sentence = taken.error().message();
  EXPECT_EQ(sentence.rfind("planner.name: astar plans straight lines with turns on the spot, which a tricycle cannot drive (allowed: pattern_docking, ", 0), 0U) << sentence;
  for (const char* able : {"ompl_rrt_connect", "clearance_optimal", "waypoint_clothoid"}) EXPECT_NE(sentence.find(able), std::string::npos) << able;
  for (const char* unable : {"dijkstra", "visibility_graph", "rrt_star_woa_local"}) EXPECT_EQ(sentence.find(unable), std::string::npos) << unable;
  s.mission = FreeGoal{{{2.0, 2.0}}};
  EXPECT_EQ(check_mission("astar", s).error().message(),
            "goal: it leaves the heading free, which planners take for vehicles that turn on the spot, and a tricycle cannot (allowed: a pose [x, y, heading])");
}

TEST(GridPlanner, GoesStraightOrTurnsWhereThatIsAll) {
  Scenario s = room(2.0);
  s.mission = Pose{1.07, 1.03, 2.0};
  const Plan near = planned(s, "astar");
  ASSERT_EQ(near.status, Status::solved) << near.reason;
  EXPECT_NEAR(near.metrics.length, std::sqrt(0.07 * 0.07 + 0.03 * 0.03), 1e-9);
  s.mission = Pose{1, 1, 2.0};
  const Plan turn = planned(s, "astar");
  ASSERT_EQ(turn.status, Status::solved) << turn.reason;
  EXPECT_EQ(turn.path.pieces.size(), 1U);
  s.mission = s.start;
  EXPECT_EQ(planned(s, "astar").status, Status::no_path);
}

// An aisle that the footprint fits into and cannot turn in: it backs out.
TEST(GridPlanner, BacksOutOfAnAisleThatItCannotTurnIn) {
  Scenario s;
  s.map.boundaries = {{{0, 0}, {6, 0}, {6, 2}, {9, 2}, {9, 2.6}, {6, 2.6}, {6, 5}, {0, 5}}};
  s.vehicle.footprint = box;
  s.vehicle.drive = Differential{0.5};
  s.start = {8.0, 2.3, 0.0};
  s.mission = Pose{2, 4, 3.0};
  const Plan plan = planned(s, "astar", {{"resolution", 0.1}});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_EQ(plan.path.pieces.front().direction, -1);
  const Plan never = planned(s, "astar", {{"resolution", 0.1}, {"reverse_cost", 0.0}});
  EXPECT_EQ(never.status, Status::no_path);
  // And forwards out, where it stands the other way round.
  s.start.heading = pi;
  const Plan forwards = planned(s, "astar", {{"resolution", 0.1}, {"reverse_cost", 0.0}});
  EXPECT_EQ(forwards.status, Status::solved) << forwards.reason;
}

TEST(GridPlanner, TooFineAResolutionIsRefusedWithFigures) {
  for (const char* name : {"astar", "dijkstra", "theta_star", "danger_astar", "block_astar", "safe_astar", "wavefront", "harmonic", "clearance_optimal"}) {
    Scenario s = room(2.0);
    s.planner = {name, {{"resolution", 0.0001}}};
    const Problem problem = Problem::prepare(s).value();
    const auto plan = solve(problem);
    ASSERT_FALSE(plan) << name << ": that nothing was searched is no answer that there is no path";
    EXPECT_EQ(plan.error().field, "planner.resolution") << name;
    EXPECT_NE(plan.error().problem.find("resolution"), std::string::npos) << plan.error().problem;
    EXPECT_NE(plan.error().allowed.find("0, or "), std::string::npos) << plan.error().allowed;
  }
}

TEST(GridPlanner, RefusesANumberOfNeighboursThatThereIsNot) {
  const auto parameters = complete_parameters(*find_planner("astar"), {{"neighbours", 6.0}});
  ASSERT_FALSE(parameters);
  EXPECT_EQ(parameters.error().message(), "planner.neighbours: 6 is not one of them (allowed: 4, 8, 16)");
}

TEST(GridPlanner, APreparedOnePlansTheSameFromManyThreads) {
  Random random{2};
  Scenario s = hall(random, box, 0.02, 10);
  s.planner = {"astar", {}};
  const Problem problem = Problem::prepare(s).value();
  const PlannerDescription& description = *find_planner("astar");
  const AnyPlanner ready = description.make(*complete_parameters(description, {}), 1).prepared(problem);
  std::vector<std::vector<std::string>> texts(4);
  std::vector<std::thread> threads;
  for (auto& text : texts) {
    threads.emplace_back([&] {
      for (int i = 0; i < 3; ++i) {
        Budget budget;
        const PlanningResult result = ready.plan(problem, budget);
        text.push_back(result ? std::to_string(length(result->path)) + std::to_string(budget.expansions()) : "none");
      }
    });
  }
  for (std::thread& t : threads) t.join();
  for (const auto& text : texts) EXPECT_EQ(text, std::vector<std::string>(3, texts[0][0]));
  EXPECT_NE(texts[0][0], "none");
}

}  // namespace
}  // namespace waywright
