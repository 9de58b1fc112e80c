// Missions in legs, as a user has them: planned, verified, refused.
#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "tests/command_line.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/judge/legs.hpp"
#include "waywright/planner/solve_legs.hpp"

namespace waywright {
namespace {

std::string example_file(const std::string& name) { return std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name; }

const Scenario& example_mission() {
  static const Scenario scenario = read_scenario(example_file("mission_warehouse.json")).value();
  return scenario;
}

const Plan& example_plan() {
  static const Plan plan = solve_legs(example_mission()).value();
  return plan;
}

TEST(Mission, TheExampleIsSolvedAndVerifies) {
  const Plan& plan = example_plan();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_EQ(plan.legs.size(), 3U);
  EXPECT_EQ(plan.legs[0].load, "");
  EXPECT_EQ(plan.legs[1].load, "crosswise pallet");
  EXPECT_EQ(plan.legs[2].load, "crosswise pallet");
  EXPECT_EQ(plan.legs[2].planner, "waypoint_clothoid");
  EXPECT_TRUE(plan.certificate.pocket_clearance);
  const auto read = parse_plan(plan_json(plan), "plan.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(plan_json(*read), plan_json(plan));
  const auto verified = verify(*read);
  ASSERT_TRUE(verified) << verified.error().message();
  EXPECT_TRUE(verified->holds) << verified->findings.front();
}

/// Each leg planned by hand, as a user without legs would: the plan's parts are those plans, bit for bit.
TEST(Mission, EachPartIsThePlanOfItsOwnScenario) {
  const Plan& whole = example_plan();
  const auto parts = parts_of(whole);
  ASSERT_TRUE(parts);
  const Scenario& mission = example_mission();
  double length = 0.0, time = 0.0;
  for (std::size_t i = 0; i < mission.legs.size(); ++i) {
    const Leg& leg = mission.legs[i];
    Scenario alone = mission;
    alone.legs.clear();
    alone.mission = leg.mission;
    alone.waypoints = leg.waypoints;
    alone.start = i == 0 ? mission.start : i == 1 ? leg.exit : std::get<Station>(mission.legs[1].mission).manoeuvre == Manoeuvre::undock ? mission.legs[1].exit : Pose{};
    alone.carried_load = i == 0 ? "" : "crosswise pallet";
    if (leg.planner) alone.planner = *leg.planner;
    // The shelf of the first two legs stands on the way of the third.
    if (i == 2) alone.map.obstacles.push_back(std::get<Station>(mission.legs[0].mission).shelf.outline());
    const Plan plan = solve(Problem::prepare(alone).value()).value();
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    EXPECT_EQ(test::fingerprint(plan.path.pieces), test::fingerprint((*parts)[i].path.pieces)) << i;
    EXPECT_EQ(plan.metrics.length, whole.legs[i].metrics.length);
    EXPECT_EQ(plan.certificate.clearance, whole.legs[i].certificate.clearance);
    length += plan.metrics.length;
    time += plan.metrics.travel_time;
  }
  EXPECT_EQ(whole.metrics.length, length);
  EXPECT_EQ(whole.metrics.travel_time, time);
}

TEST(Mission, OneLegIsThePlainMissionBitForBit) {
  for (const char* name : {"dock_middle.json", "undock_loaded.json", "goal_pose.json", "waypoints_low.json"}) {
    const Scenario plain = read_scenario(example_file(name)).value();
    Scenario one = plain;
    Leg leg;
    leg.mission = plain.mission;
    leg.waypoints = plain.waypoints;
    leg.waypoint_radius = plain.waypoint_radius;
    if (const auto* station = std::get_if<Station>(&plain.mission); station != nullptr && station->manoeuvre == Manoeuvre::undock) {
      leg.exit = plain.start;
      one.start = Problem::prepare(plain).value().first_pose();
    }
    one.mission = Pose{};
    one.waypoints.clear();
    one.legs = {leg};
    const Plan a = solve(Problem::prepare(plain).value()).value();
    const Plan b = solve_legs(one).value();
    ASSERT_EQ(b.status, Status::solved) << name << ": " << b.reason;
    EXPECT_EQ(test::fingerprint(a.path.pieces), test::fingerprint(b.path.pieces)) << name;
    EXPECT_EQ(test::fingerprint(a.samples), test::fingerprint(b.samples)) << name;
    EXPECT_EQ(a.metrics.mean_clearance, b.metrics.mean_clearance) << name;
    EXPECT_EQ(a.certificate.clearance, b.certificate.clearance) << name;
    EXPECT_EQ(a.effort.evaluations, b.effort.evaluations) << name;
    EXPECT_TRUE(verify(b).value().holds) << name;
  }
}

std::string without_timing(Plan plan) {
  plan.timing = {};
  return plan_json(plan);
}

TEST(Mission, TheSameBitsOnEveryThread) {
  const std::string expected = without_timing(example_plan());
  std::vector<std::string> found(2);
  std::vector<std::thread> threads;
  for (std::string& text : found) threads.emplace_back([&text] { text = without_timing(solve_legs(example_mission()).value()); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : found) EXPECT_EQ(text, expected);
}

TEST(Mission, ALegThatFailsSaysWhichAndKeepsThoseBefore) {
  Scenario s = example_mission();
  s.map.obstacles.push_back(rectangle({13.6, 5.0}, {14.9, 9.0}));  // the door is shut
  s.legs[2].waypoints = {};
  s.legs[2].planner = PlannerChoice{"pattern_docking", {{"fallback", false}}};
  const Plan plan = solve_legs(s).value();
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_EQ(plan.reason.rfind("leg 3 of 3 (goods → exit): ", 0), 0U) << plan.reason;
  EXPECT_TRUE(plan.path.pieces.empty());
  ASSERT_EQ(plan.legs.size(), 3U);
  EXPECT_EQ(plan.legs[1].status, Status::solved);
  EXPECT_GT(plan.legs[1].metrics.length, 1.0);
  EXPECT_EQ(plan.explanation.front().rfind("Leg 1 of 3 (parking → goods)", 0), 0U);
  const auto read = parse_plan(plan_json(plan), "plan.json");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(plan_json(*read), plan_json(plan));
  EXPECT_FALSE(verify(*read).value().holds);
}

TEST(Mission, ALoadThatDoesNotFitWhereItIsTakenIsTold) {
  Scenario s = example_mission();
  s.legs.erase(s.legs.begin());
  s.legs.front() = Leg{};
  s.legs.front().mission = Pose{8.8, 6.6, 0.0};
  s.legs.front().load = "crosswise pallet";
  s.start = {6.8, 6.6, 0.0};
  s.map.points.push_back({8.8, 6.6 + 0.55});  // beside the truck, inside of its load
  const Plan plan = solve_legs(s).value();
  EXPECT_EQ(plan.status, Status::start_in_collision);
  EXPECT_EQ(plan.reason.rfind("leg 2 of 2 (goods → exit): the load \"crosswise pallet\", taken where leg 1 ends, does not fit there: ", 0), 0U) << plan.reason;
  s.legs.pop_back();
  const Plan last = solve_legs(s).value();
  EXPECT_EQ(last.status, Status::goal_in_collision);
  EXPECT_EQ(last.reason.rfind("leg 1 of 1: the load \"crosswise pallet\", taken at its end, does not fit there: ", 0), 0U) << last.reason;
  s.map.points.clear();
  EXPECT_EQ(solve_legs(s).value().status, Status::solved);
}

/// Loads are exchanged where the vehicle stands: by a tricycle, which turns on no spot, and by whatever planner.
TEST(Mission, ALegMayChangeTheLoadWhereItStands) {
  for (const char* planner : {"pattern_docking", "ompl_rrt_connect", "clearance_optimal"}) {
    Scenario s = example_mission();
    s.legs.resize(3);
    for (Leg& leg : s.legs) leg = Leg{};
    s.planner = PlannerChoice{planner, {}};
    s.start = {8.8, 6.6, 0.0};
    s.carried_load = "pallet";
    s.legs[0].mission = s.start;
    s.legs[0].load = "";
    s.legs[1].mission = s.start;
    s.legs[1].load = "crosswise pallet";
    s.legs[2].mission = Pose{10.8, 6.6, 0.0};
    s.legs[2].planner = PlannerChoice{"ompl_rrt_connect", {}};
    const Plan plan = solve_legs(s).value();
    ASSERT_EQ(plan.legs.size(), 3U) << planner << plan.reason;
    EXPECT_EQ(plan.legs[0].status, Status::solved) << plan.reason;
    EXPECT_EQ(plan.legs[0].metrics.length, 0.0);
    EXPECT_EQ(plan.legs[0].metrics.travel_time, 0.0);
    EXPECT_EQ(plan.legs[2].load, "crosswise pallet");
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    const auto read = parse_plan(plan_json(plan), "plan.json");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(verify(*read).value().holds) << verify(*read).value().findings.front();
    s.map.points.push_back({8.8, 6.6 + 0.55});  // beside the truck and its pallet, inside of the crosswise one
    const Plan blocked = solve_legs(s).value();
    EXPECT_EQ(blocked.status, Status::start_in_collision) << blocked.reason;
  }
}

class MissionOnTheCommandLine : public test::CommandLine {
 protected:
  test::Json mission() const {
    test::Json s = test::Json::parse(test::slurp(example("mission_warehouse.json")));
    s["vehicle"] = example("vehicles/pallet_truck_crosswise.json");
    return s;
  }
};

TEST_F(MissionOnTheCommandLine, OnePlanFileAndOneReportForTheWhole) {
  const auto o = run("plan " + write(mission()) + " -o out");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  for (const char* word : {"leg 1 ", "leg 3 ", "crosswise pallet", "goods → exit", "Leg 2 of 3 (out of the goods)"}) EXPECT_NE(o.out.find(word), std::string::npos) << word << "\n" << o.out;
  EXPECT_EQ(run("verify out/plan.json").status, 0);
  const std::string report = test::slurp(folder_ / "out" / "report.html");
  for (const char* word : {"<h2>Legs</h2>", "class=\"load\"", "class=\"badge\"", "goods → exit", "3300 kg", "Clearance in m"}) EXPECT_NE(report.find(word), std::string::npos) << word;
  test::Json plan = test::Json::parse(test::slurp(folder_ / "out" / "plan.json"));
  EXPECT_EQ(plan["legs"].size(), 3U);
  plan["legs"][1]["load"] = nullptr;
  const auto found = run("verify " + write(plan, "false.json"));
  EXPECT_EQ(found.status, 1);
  EXPECT_NE(found.out.find("leg 2 of 3 (out of the goods): its record says that no load is carried"), std::string::npos) << found.out;
}

/// Where there is neither a fork nor a station, no sentence tells of one.
TEST_F(MissionOnTheCommandLine, ACarrierIsPlannedForAsOne) {
  test::Json s = mission();
  s["vehicle"] = example("vehicles/trolley_agv.json");
  s["legs"] = {{{"goal", {9.5, 12.0, 0.0}}}, {{"goal", {4.0, 12.0, 3.1}}}};
  s["start"] = {4.0, 5.0, 0.0};
  auto o = run("plan " + write(s) + " -o out");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("Leg 2 of 2, without a load, by astar: "), std::string::npos) << o.out;
  s["planner"] = {{"name", "pattern_docking"}};
  o = run("plan " + write(s) + " -o out");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  for (const char* word : {"fork", "docked", "docking pattern"}) EXPECT_EQ(o.out.find(word), std::string::npos) << word << "\n" << o.out;
}

TEST_F(MissionOnTheCommandLine, ASiteMayHaveSuchMissions) {
  const auto o = run("check " + write(mission()) + " -o site");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("1 place: 1 solved and proven"), std::string::npos) << o.out;
  EXPECT_NE(run("check s.json -o site").out.find("1 taken over, 0 planned"), std::string::npos);
}

TEST_F(MissionOnTheCommandLine, CommandsOfOneMissionRefuseLegsInOneSentence) {
  write(mission());
  std::ofstream{folder_ / "p.csv"} << "x,y,heading\n0,0,0\n1,0,0\n";
  refused(run("import p.csv --scenario s.json"), {"s.json: legs: poses from outside do not tell where a leg ends"});
  refused(run("compare s.json"), {"s.json: legs: planners are compared on one mission"});
  refused(run("pareto s.json"), {"s.json: legs: trade-offs are those of one mission"});
  ASSERT_EQ(run("plan s.json -o out").status, 0);
  refused(run("replan out/plan.json --at 1"), {"plan.json: scenario.legs: a mission in legs is not planned anew"});
}

TEST_F(MissionOnTheCommandLine, WhatIsWrongIsOneSentence) {
  const std::pair<std::function<void(test::Json&)>, const char*> wrong[] = {
      {[](auto& s) { s["legs"][0]["load"] = "barrel"; }, "s.json: legs[0].load: the vehicle has no load \"barrel\""},
      {[](auto& s) { s["legs"][1]["planner"] = {{"name", "astra"}}; }, "s.json: legs[1].planner.name: \"astra\" is not known"},
      {[](auto& s) { s["legs"][2]["planner"] = {{"name", "astar"}}; }, "s.json: legs[2].planner.name: astar does not plan through waypoints"},
      {[](auto& s) { s["legs"][2]["planner"] = {{"name", "astar"}}, s["legs"][2].erase("waypoints"); },
       "s.json: legs[2].planner.name: astar plans straight lines with turns on the spot, which a tricycle cannot drive (allowed: pattern_docking, "},
      {[](auto& s) { s["legs"][2]["planner"] = {{"name", "ompl_rrt_connect"}, {"space", "plane"}}, s["legs"][2].erase("waypoints"); },
       "s.json: legs[2].planner.space: in the space \"plane\" ompl_rrt_connect plans straight lines with turns on the spot, which a tricycle cannot drive (allowed: reeds_shepp, dubins)"},
      {[](auto& s) { s["legs"][2]["goal"] = {28.2, 7.9}, s["legs"][2].erase("waypoints"); }, "s.json: legs[2].goal: it leaves the heading free, which planners take for vehicles that turn"},
      {[](auto& s) { s["legs"][2]["planner"] = {{"name", "waypoint_clothoid"}, {"samples", -1}}; }, "s.json: legs[2].planner.samples: -1 is out of range"},
      {[](auto& s) { s["budget"] = {{"expansions", 5}}; }, "s.json: budget.expansions: leg 1 of 3 (parking → goods): pattern_docking counts no expansions"},
      {[](auto& s) { s["legs"].erase(0); }, "s.json: legs[0].station: the way out of the shelf begins at"},
      {[](auto& s) { s["legs"][0]["station"]["shelf"]["gap"] = 0.01; }, "s.json: legs[0].station.shelf.gap: 0.01 m is under the clearance"},
      {[](auto& s) { s["planner"] = {{"name", "pattern_docking"}, {"evaluations", 0}}; }, "s.json: planner.evaluations: 0 is out of range"},
  };
  for (const auto& [change, sentence] : wrong) {
    test::Json s = mission();
    change(s);
    refused(run("plan " + write(s)), {sentence});
  }
  test::Json s = mission();
  for (auto& leg : s["legs"]) leg["planner"] = {{"name", "ompl_rrt_connect"}};
  s["legs"][2].erase("waypoints");
  write(s);
  refused(run("plan s.json --planner astar"), {"--planner: every leg names a planner of its own"});
  refused(run("plan s.json --set evaluations=3"), {"--set: every leg names a planner of its own"});
}

}  // namespace
}  // namespace waywright
