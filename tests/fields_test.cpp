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

TEST_F(CommandLine, ASlidingBaseIsReplannedWhereItStandsAlone) {
  ASSERT_EQ(run("plan " + examples + "mecanum_discs.json -o o").status, 0);
  refused(run("replan o/plan.json --at 3 --goal 3,2.4,2.9 -o r"), {"--at", "does not face along", "stands"});
  std::ofstream{folder_ / "box.json"} << R"({"format": "waywright-obstacles/1", "obstacles": [[[4, 4], [4.2, 4], [4.2, 4.2], [4, 4.2]]]})";
  refused(run("replan o/plan.json --at 3 --obstacles box.json -o r"), {"--at", "does not face along", "stands"});
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

}  // namespace
}  // namespace waywright
