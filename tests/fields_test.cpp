// Fields and vehicles that move any way, from the command line: plans, plan files, what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/command_line.hpp"
#include "waywright/io/plan_io.hpp"

namespace waywright {
namespace {

using nlohmann::json;
using waywright::test::CommandLine;

const std::string examples = std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/fields/";

json read(const std::filesystem::path& file) {
  std::ifstream in{file};
  return json::parse(in);
}

TEST_F(CommandLine, FieldsPlanTheirExamples) {
  for (const char* name : {"mecanum_warehouse", "mecanum_discs", "point_stars", "mecanum_crossing", "mecanum_wings"}) {
    const auto planned = run("plan " + examples + name + ".json -o " + name);
    ASSERT_EQ(planned.status, 0) << name << planned.out << planned.err;
    EXPECT_EQ(run(std::string{"verify "} + name + "/plan.json").status, 0) << name;
  }
  const auto trapped = run("plan " + examples + "point_trap.json -o trap");
  EXPECT_EQ(trapped.status, 1);
  EXPECT_NE(trapped.out.find("trapped in a local minimum at (4.62"), std::string::npos) << trapped.out;
  for (const char* other : {"harmonic", "wavefront", "visibility_graph", "star_navigation", "global_local"}) EXPECT_EQ(run("plan " + examples + "point_trap.json -o t --planner " + other).status, 0) << other;
}

// On a map of cells; with times of its own, which the file carries and commands keep; and honest where nothing serves.
TEST_F(CommandLine, AGlobalWayUnderALocalFieldIsDrivenInTime) {
  const auto on_cells = run("plan " + examples + "mecanum_warehouse.json --planner global_local -o cells");
  ASSERT_EQ(on_cells.status, 0) << on_cells.out << on_cells.err;
  EXPECT_EQ(on_cells.out.find("came to no end"), std::string::npos) << on_cells.out;
  EXPECT_EQ(run("verify cells/plan.json").status, 0);
  ASSERT_EQ(run("plan " + examples + "mecanum_crossing.json -o o").status, 0);
  const json plan = read(folder_ / "o/plan.json");
  EXPECT_EQ(plan["planner"]["name"], "global_local");
  EXPECT_EQ(plan["meta"]["alternatives"][0]["name"], "global way, harmonic");
  bool tells_nearest = false;
  for (const json& sentence : plan["explanation"]) tells_nearest = tells_nearest || sentence.get<std::string>().find("Nearest to what moves: ") == 0;
  EXPECT_TRUE(tells_nearest);
  EXPECT_EQ(run("controls o/plan.json -o c").status, 0);
  // Driven a second later than told, it is no longer proven: the times are what was shown to be clear.
  json late = plan;
  late["scenario"]["moving"][0]["track"] = json::array({{2.2, 5.8, 8.4}, {10.2, 5.8, 0.6}});
  std::ofstream{folder_ / "late.json"} << late;
  EXPECT_EQ(run("verify late.json").status, 1);
  // Nobody gets past in a corridor that is as wide as the vehicle.
  json narrow = plan["scenario"];
  narrow["map"] = {{"polygons", {{"boundary", {{0, 0}, {20, 0}, {20, 1.2}, {0, 1.2}}}}}};
  narrow["start"] = {1, 0.6, 0};
  narrow["goal"] = {19, 0.6, 0};
  narrow["moving"] = json::array({{{"name", "person"}, {"footprint", {{"disc", 0.3}}}, {"track", {{0, 19, 0.6}}}, {"velocity", {-0.5, 0}}}});
  std::ofstream{folder_ / "narrow.json"} << narrow;
  const auto met = run("plan narrow.json -o n");
  EXPECT_EQ(met.status, 1) << met.err;
  EXPECT_NE(met.out.find("unproven"), std::string::npos) << met.out;
  EXPECT_NE(met.out.find("the local field came to no end either: person comes too near to the vehicle"), std::string::npos) << met.out;
}

// The heading along the path stands in the file, exactly; the samples follow it, their course is the way's.
TEST_F(CommandLine, AHeadingOfItsOwnIsWrittenReadAndVerified) {
  ASSERT_EQ(run("plan " + examples + "mecanum_discs.json -o o").status, 0);
  const json plan = read(folder_ / "o/plan.json");
  double turned = 0.0;
  for (const json& piece : plan["path"]["pieces"]) {
    ASSERT_TRUE(piece.contains("heading")) << piece;
    turned += piece["heading"]["turn"].get<double>();
  }
  EXPECT_NEAR(turned, 3.0, 1e-9);
  const json& samples = plan["path"]["samples"];
  EXPECT_EQ(samples["heading"].front(), 0.0);
  EXPECT_NEAR(samples["heading"].back().get<double>(), 3.0, 1e-9);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < samples["s"].size(); ++i) apart += std::abs(shorter_turn(samples["heading"][i].get<double>(), samples["course"][i].get<double>())) > 0.1 ? 1 : 0;
  EXPECT_GT(apart, samples["s"].size() / 2);
  const Plan back = parse_plan(plan.dump(), "plan.json").value();
  EXPECT_EQ(plan_json(back), plan_json(parse_plan(plan_json(back), "plan.json").value()));
  // A heading that is not the samples' is found out.
  json lie = plan;
  lie["path"]["pieces"][0]["heading"]["from"] = 0.3;
  std::ofstream{folder_ / "lie.json"} << lie;
  EXPECT_EQ(run("verify lie.json").status, 1);
}

TEST_F(CommandLine, AHeadingThatCannotBeIsRefused) {
  ASSERT_EQ(run("plan " + examples + "mecanum_discs.json -o o").status, 0);
  const json plan = read(folder_ / "o/plan.json");
  const auto broken = [&](auto change, const std::vector<std::string>& words) {
    json j = plan;
    change(j["path"]["pieces"][0]);
    std::ofstream{folder_ / "b.json"} << j;
    refused(run("verify b.json"), words);
  };
  broken([](json& piece) { piece["direction"] = -1; }, {"path.pieces[0].heading", "backwards"});
  broken([](json& piece) { piece["heading"] = 3; }, {"path.pieces[0].heading"});
  broken([](json& piece) { piece["heading"].erase("turn"); }, {"path.pieces[0].heading.turn", "missing"});
  broken([](json& piece) { piece["heading"]["turn"] = 1e9; }, {"path.pieces[0].heading.turn", "range"});
  // A vehicle that must face along cannot drive it: proven wrong, not refused.
  json other = plan;
  other["scenario"]["vehicle"]["drive"] = {{"type", "differential"}, {"track", 0.3}};
  std::ofstream{folder_ / "d.json"} << other;
  const auto verified = run("verify d.json");
  EXPECT_EQ(verified.status, 1);
  EXPECT_NE((verified.out + verified.err).find("does not face along"), std::string::npos) << verified.out << verified.err;
}

TEST_F(CommandLine, EveryPlannerThatTurnsOnTheSpotPlansForAMecanumBase) {
  for (const char* planner : {"astar", "theta_star", "clearance_optimal", "visibility_graph", "voronoi", "prm", "rrt_star", "ompl_rrt_connect"}) {
    const auto planned = run("plan " + examples + "mecanum_discs.json -o m --planner " + planner);
    EXPECT_EQ(planned.status, 0) << planner << planned.out << planned.err;
    EXPECT_EQ(run("verify m/plan.json").status, 0) << planner;
  }
}

// Straight runs at the ends, on which the heading stays, and a way between on which it turns: where they meet the vehicle stands, and verify agrees.
TEST_F(CommandLine, RunsIntoNarrowPlacesAreVerified) {
  const json vehicle = read(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/vehicles/mecanum_base.json");
  const json map = {{"polygons", {{"boundary", {{0, 0}, {10, 0}, {10, 6}, {0, 6}}}, {"obstacles", {{{7, 2}, {9, 2}, {9, 2.74}, {7, 2.74}}, {{7, 3.26}, {9, 3.26}, {9, 4}, {7, 4}}}}}}};
  for (const char* planner : {"harmonic", "wavefront", "rrt_star"}) {
    for (const double heading : {0.0, 3.141592653589793}) {
      const json scenario = {{"format", "waywright-scenario/1"}, {"name", "slot"}, {"map", map}, {"vehicle", vehicle}, {"start", {1, 1, 2.5}}, {"goal", {7.6, 3, heading}}, {"planner", {{"name", planner}}}};
      std::ofstream{folder_ / "s.json"} << scenario;
      const auto planned = run("plan s.json -o s");
      ASSERT_EQ(planned.status, 0) << planner << planned.out << planned.err;
      const auto verified = run("verify s/plan.json");
      EXPECT_EQ(verified.status, 0) << planner << verified.out;
      std::filesystem::remove_all(folder_ / "s");
    }
  }
}

// Start and goal at one place: nothing is driven out and back for a turn.
TEST_F(CommandLine, APureTurnIsOne) {
  for (const char* planner : {"harmonic", "wavefront", "potential_field", "navigation_function", "rrt_star"}) {
    for (const char* vehicle : {"mecanum_base", "tugger_differential"}) {
      const json scenario = {{"format", "waywright-scenario/1"}, {"map", {{"polygons", {{"boundary", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}}}}}}, {"vehicle", read(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/vehicles/" + vehicle + ".json")},
                             {"start", {5, 5, 0}}, {"goal", {5, 5, 2}}, {"planner", {{"name", planner}}}};
      std::ofstream{folder_ / "t.json"} << scenario;
      const auto planned = run("plan t.json -o t");
      ASSERT_EQ(planned.status, 0) << planner << " " << vehicle << planned.out << planned.err;
      EXPECT_EQ(read(folder_ / "t/plan.json")["metrics"]["length"], 0.0) << planner;
      std::filesystem::remove_all(folder_ / "t");
    }
  }
}

TEST_F(CommandLine, ASlidingBaseIsReplannedAsItMoves) {
  ASSERT_EQ(run("plan " + examples + "mecanum_discs.json -o o").status, 0);
  std::ofstream{folder_ / "box.json"} << R"({"format": "waywright-obstacles/1", "obstacles": [[[4, 4], [4.2, 4], [4.2, 4.2], [4, 4.2]]]})";
  for (const char* what : {"--goal 3,2.4,2.9", "--obstacles box.json"}) {
    const auto replanned = run(std::string{"replan o/plan.json --at 3 -o r "} + what);
    ASSERT_EQ(replanned.status, 0) << what << replanned.out << replanned.err;
    EXPECT_NE(replanned.out.find("moves without facing along its way"), std::string::npos) << replanned.out;
    const json start = read(folder_ / "r/plan.json")["scenario"]["start"];
    EXPECT_TRUE(start.contains("course") && start.contains("angular_velocity")) << start;
    EXPECT_GT(start["speed"].get<double>(), 0.1);
    EXPECT_EQ(run("verify r/plan.json").status, 0) << what;
  }
}

TEST_F(CommandLine, ControlsOfASlidingBaseEndAtTheGoal) {
  ASSERT_EQ(run("plan " + examples + "mecanum_discs.json -o o").status, 0);
  const auto told = run("controls o/plan.json -o c --json");
  ASSERT_EQ(told.status, 0) << told.err;
  std::ifstream csv{folder_ / "c/controls.csv"};
  std::string header;
  std::getline(csv, header);
  EXPECT_NE(header.find("v_left"), std::string::npos) << header;
  EXPECT_NE(header.find("rear_right"), std::string::npos) << header;
}

// What is solved here is verified there: stops in the middle of a way on which an acceleration of turning binds, and beside a speed limit, where a step leads from rest to rest.
TEST_F(CommandLine, TimesAfterStopsInTheMiddleOfAFieldsWayAreThoseThatVerifyHolds) {
  const std::string scenarios[] = {
      R"({"format":"waywright-scenario/1","name":"a person and a tugger in the hall","map":{"polygons":{"boundary":[[0,0],[16,0],[16,8],[0,8]],"obstacles":[[[4,0],[6,0],[6,2.6],[4,2.6]],[[4,5.4],[6,5.4],[6,8],[4,8]],[[10.5,3.4],[11.5,3.4],[11.5,4.6],[10.5,4.6]]]}},"vehicle":{"name":"round mobile robot, 0.7 m across","footprint":{"disc":0.35},"mass":60,"drive":{"type":"differential","track":0.45},"limits":{"speed":1.5,"acceleration":1.0,"angular_speed":1.5,"angular_acceleration":2.0}},"start":[1.2,4,0],"goal":[14.5,4],"clearance":0,"moving":[{"name":"m0","footprint":{"disc":0.3},"track":[[0,5.95,6.83],[3.78,3.77,3.81],[14.71,11.42,2.32],[19.8,13.7,7.06]],"patience":1},{"name":"m1","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,7.36,2.02,1.2],[4.5,12.46,6.31,2.95],[9.91,12.53,2.05,0.9]],"patience":0.0},{"name":"m2","footprint":{"disc":0.3},"track":[[0,8.5,7.34],[2.46,4.05,0.58],[6.5,12.75,3.01],[12.97,6.51,2.48]],"patience":0.0},{"name":"m3","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,9.68,7.09,-1.11],[6.13,10.73,2.53,-1.84],[16.4,3.03,2.12,-0.13],[17.63,3.51,6.6,1.82]],"patience":0.0},{"name":"m4","footprint":{"disc":0.3},"track":[[0,7.4,5.61],[4.47,7.17,1.83],[4.98,12.55,5.93]],"patience":1}],"planner":{"name":"global_local","global":"wavefront"}})",
      R"({"format":"waywright-scenario/1","name":"a person and a tugger in the hall","map":{"polygons":{"boundary":[[0,0],[16,0],[16,8],[0,8]],"obstacles":[[[4,0],[6,0],[6,2.6],[4,2.6]],[[4,5.4],[6,5.4],[6,8],[4,8]],[[10.5,3.4],[11.5,3.4],[11.5,4.6],[10.5,4.6]]]}},"vehicle":{"name":"round mobile robot, 0.7 m across","footprint":{"disc":0.35},"mass":60,"drive":{"type":"differential","track":0.45},"limits":{"speed":1.5,"acceleration":1.0,"angular_speed":1.5,"angular_acceleration":2.0}},"start":[1.2,4,0],"goal":[14.5,4,0],"clearance":0.05,"moving":[{"name":"m0","footprint":{"disc":0.3},"track":[[0,4.82,6.33],[6.07,8.61,0.82],[12.44,11.94,3.46]],"patience":6},{"name":"m1","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,3.24,4.05,2.68],[8.44,7.82,5.32,0.63],[11.34,5.49,6.7,-1.39],[12.7,12.97,4.16,-0.79]],"patience":6},{"name":"m2","footprint":{"disc":0.3},"track":[[0,5.02,5.07]],"patience":6},{"name":"m3","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,7.27,5.68,-0.64],[5.1,8.8,2.32,0.66],[13.83,6.11,4.77,-1.53]],"patience":6}],"planner":{"name":"global_local","global":"wavefront"}})",
      R"({"format":"waywright-scenario/1","name":"a person and a tugger in the hall","map":{"polygons":{"boundary":[[0,0],[16,0],[16,8],[0,8]],"obstacles":[[[4,0],[6,0],[6,2.6],[4,2.6]],[[4,5.4],[6,5.4],[6,8],[4,8]],[[10.5,3.4],[11.5,3.4],[11.5,4.6],[10.5,4.6]]]}},"vehicle":{"name":"round mobile robot, 0.7 m across","footprint":{"disc":0.35},"mass":60,"drive":{"type":"differential","track":0.45},"limits":{"speed":1.5,"acceleration":1.0,"angular_speed":1.5,"angular_acceleration":2.0}},"start":[1.2,4,0],"goal":[14.5,4,0],"clearance":0,"moving":[{"name":"m0","footprint":{"disc":0.3},"track":[[0,7.16,1.14]],"patience":1},{"name":"m1","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,5.99,4.21,-0.83],[1.4,14.11,3.1,1.32],[9.85,4.13,2.8,-2.95]],"patience":0.0},{"name":"m2","footprint":{"disc":0.3},"track":[[0,14.08,6.04],[8.83,4.51,6.99],[12.45,4.09,4.54]],"patience":1},{"name":"m3","footprint":[[-0.7,-0.4],[0.7,-0.4],[0.7,0.4],[-0.7,0.4]],"track":[[0,9.43,3.26,2.39],[7.78,9.59,0.88,0.05],[10.29,5.58,3.54,0.28],[13.67,6.25,4.21,-0.16]],"patience":0.0},{"name":"m4","footprint":{"disc":0.3},"track":[[0,3.83,7.34],[4.68,9.67,6.13],[11.01,9.97,4.83]],"patience":0.0}],"planner":{"name":"global_local","global":"star_navigation"},"zones":[{"type":"speed_limit","area":[[2,2],[9,2],[9,6.5],[2,6.5]],"speed":0.05}]})",
  };
  for (const std::string& scenario : scenarios) {
    std::ofstream{folder_ / "met.json"} << scenario;
    const auto planned = run("plan met.json -o met");
    ASSERT_EQ(planned.status, 0) << planned.out << planned.err;
    const auto verified = run("verify met/plan.json");
    EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  }
}

}  // namespace
}  // namespace waywright
