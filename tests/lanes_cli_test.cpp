// Lanes from the files on: a plant model becomes a scenario whose plan keeps to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "tests/command_line.hpp"

namespace waywright {
namespace {

using waywright::test::CommandLine;
using waywright::test::Json;
using waywright::test::slurp;

const std::string plant = R"(<model version="7.0.0" name="ring">
  <point name="A" positionX="0" positionY="0" vehicleOrientationAngle="NaN"/><point name="B" positionX="12000" positionY="0" vehicleOrientationAngle="NaN"/>
  <point name="C" positionX="12000" positionY="8000" vehicleOrientationAngle="90"/><point name="D" positionX="0" positionY="8000" vehicleOrientationAngle="NaN"/>
  <path name="AB" sourcePoint="A" destinationPoint="B" maxVelocity="1000"/><path name="BC" sourcePoint="B" destinationPoint="C" maxVelocity="400"/>
  <path name="CD" sourcePoint="C" destinationPoint="D" maxVelocity="1000"/><path name="DA" sourcePoint="D" destinationPoint="A" maxVelocity="1000"/>
  <location name="dock" positionX="14000" positionY="8000"><link point="C"/></location>
  <vehicle name="cart" maxVelocity="1200"><boundingBox length="800" width="600"/></vehicle>
</model>)";

// A ring of many places: every one is told, in lines that a terminal holds.
TEST_F(CommandLine, ManyPlacesAreToldInColumns) {
  constexpr int many = 83;
  std::string points, paths;
  const auto name = [](int i) { return (i % 10 == 3 ? "Übergabe im Süden " : "P") + std::to_string(i); };
  for (int i = 0; i < many; ++i) {
    points += "<point name=\"" + name(i) + "\" positionX=\"" + std::to_string(3000 * (i % 9)) + "\" positionY=\"" + std::to_string(3000 * (i / 9)) + "\" vehicleOrientationAngle=\"NaN\"/>";
    if (i > 0) paths += "<path name=\"" + std::to_string(i) + "\" sourcePoint=\"" + name(i - 1) + "\" destinationPoint=\"" + name(i) + "\" maxVelocity=\"1000\"/>";
  }
  std::ofstream{folder_ / "many.xml"} << "<model version=\"7.0.0\" name=\"many\">" << points << paths << "</model>";
  const auto told = run("map many.xml");
  ASSERT_EQ(told.status, 0) << told.err;
  std::istringstream lines{told.out.substr(told.out.find("  places:"))};
  std::size_t in_lines = 0;
  for (std::string line; std::getline(lines, line) && line.rfind("  note:", 0) != 0; ++in_lines) {
    EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 100) << line;
  }
  EXPECT_GE(in_lines, 30u);
  EXPECT_LE(in_lines, 50u);
  for (int i = 0; i < many; ++i) {
    const std::string place = ' ' + name(i) + " (";
    const std::size_t at = told.out.find(place);
    ASSERT_NE(at, std::string::npos) << place;
    EXPECT_EQ(told.out.find(place, at + 1), std::string::npos) << place;
  }
}

TEST_F(CommandLine, APlantModelBecomesAScenarioAlongItsLanes) {
  std::ofstream{folder_ / "ring.xml"} << plant;
  const auto made = run("map ring.xml --corridor 1.6 --scenario s.json --from D --to dock --picture p.svg");
  ASSERT_EQ(made.status, 0) << made.err;
  for (const char* told : {"4 places, 4 lanes of 40.0 m in all, 4 of them one way", "places: A (0.000, 0.000), B (12.000, 0.000), C (12.000, 8.000, 1.5708 rad)", "stations: dock (14.000, 8.000; at C)"}) {
    EXPECT_NE(made.out.find(told), std::string::npos) << told << "\n" << made.out;
  }
  EXPECT_NE(made.err.find("the vehicle is cart, 0.8 x 0.6 m"), std::string::npos) << made.err;
  EXPECT_NE(slurp(folder_ / "p.svg").find("one way"), std::string::npos);
  const Json scenario = Json::parse(slurp(folder_ / "s.json"));
  EXPECT_EQ(scenario["meta"]["lanes"]["route"], Json::parse(R"(["D", "A", "B", "C"])"));
  EXPECT_EQ(scenario["meta"]["lanes"]["one_way"], Json::parse("[true, true, true, true]"));
  EXPECT_EQ(scenario["map"]["source"]["corridor"], 1.6);
  int directed = 0, slow = 0;
  for (const auto& zone : scenario["zones"]) {
    directed += zone["type"] == "directed" ? 1 : 0;
    slow += zone["type"] == "speed_limit" && zone["speed"] == 0.4 ? 1 : 0;
  }
  EXPECT_EQ(directed, 4);
  EXPECT_EQ(slow, 1);
  // Straight along the lane from C to D, backwards, the way would be 12 m; along the one-way lanes it is 28 m.
  const auto planned = run("plan s.json -o o");
  ASSERT_EQ(planned.status, 0) << planned.out << planned.err;
  EXPECT_EQ(run("verify o/plan.json").status, 0);
  const Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  EXPECT_GT(plan["metrics"]["length"].get<double>(), 25.0);
  EXPECT_LT(plan["metrics"]["length"].get<double>(), 28.5);
  // The limit of the lane to C.
  const auto& samples = plan["path"]["samples"];
  for (std::size_t i = 0; i < samples["s"].size(); ++i) {
    if (samples["x"][i].get<double>() < 11.5 || samples["y"][i].get<double>() < 1.0) continue;
    EXPECT_LE(samples["speed"][i].get<double>(), 0.4 + 1e-9);
  }
  // Who knows nothing of directions is judged all the same.
  EXPECT_EQ(run("plan s.json --planner visibility_graph -o v").status, 1);
  EXPECT_EQ(Json::parse(slurp(folder_ / "v/plan.json"))["status"], "unproven");
}

TEST_F(CommandLine, AScenarioOfAPlantKeepsToItsLanesUnlessToldOtherwise) {
  std::ofstream{folder_ / "ring.xml"} << plant;
  const auto made = run("map ring.xml --scenario s.json --from D --to dock");
  ASSERT_EQ(made.status, 0) << made.err;
  // The disc about 0.8 x 0.6 m is 1 m across.
  EXPECT_NE(made.err.find("nothing is free but strips 1.15 m across along the lanes"), std::string::npos) << made.err;
  Json scenario = Json::parse(slurp(folder_ / "s.json"));
  EXPECT_EQ(scenario["name"], "D to dock");
  EXPECT_EQ(scenario["map"]["source"]["corridor"], 1.15);
  const auto planned = run("plan s.json -o o");
  ASSERT_EQ(planned.status, 0) << planned.out << planned.err;
  EXPECT_NE(planned.out.find("It keeps to the lanes: all of its "), std::string::npos) << planned.out;
  EXPECT_GT(Json::parse(slurp(folder_ / "o/plan.json"))["metrics"]["length"].get<double>(), 25.0);
  // What was noted when the scenario was made is not said again.
  EXPECT_EQ(planned.err.find("note:"), std::string::npos) << planned.err;
  EXPECT_NE(slurp(folder_ / "o/plan.json").find("4 places, 4 lanes"), std::string::npos);

  // Where all is free around the lanes, the plan says how much of it is off them, and where.
  ASSERT_EQ(run("map ring.xml --margin 3 --scenario m.json --from D --to dock").status, 0);
  scenario = Json::parse(slurp(folder_ / "m.json"));
  EXPECT_EQ(scenario["map"]["source"]["margin"], 3);
  scenario["zones"] = Json::array();
  scenario["start"] = {0, 4, 0};
  scenario["goal"] = {12, 4, 0};
  std::ofstream{folder_ / "m.json"} << scenario.dump();
  const auto off = run("plan m.json -o m");
  ASSERT_EQ(off.status, 0) << off.out << off.err;
  EXPECT_NE(off.out.find("m of its 12.00 m lie off the lanes, farther than 0.5 m from their middle: 1"), std::string::npos) << off.out;
  EXPECT_NE(off.out.find("from (0.5"), std::string::npos) << off.out;
  EXPECT_NE(off.out.find("to (11.5"), std::string::npos) << off.out;
  // Whatever else stands in meta is nobody's business.
  for (const char* meta : {R"({"lanes": 3})", R"({"lanes": {"width": 1, "courses": [[[0, 0]], 7, [["a", 1], [2, 3]]]}})", R"({"lanes": {"width": "1", "courses": []}})"}) {
    scenario["meta"] = Json::parse(meta);
    std::ofstream{folder_ / "m.json"} << scenario.dump();
    const auto other = run("plan m.json -o m");
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_EQ(other.out.find("lanes"), std::string::npos) << other.out;
  }
  EXPECT_NE(made.err.find("the vehicle keeps to the lanes: nothing is free but strips"), std::string::npos) << made.err;
  const auto freed = run("map ring.xml --off-lanes --scenario n.json --from D --to dock");
  ASSERT_EQ(freed.status, 0) << freed.err;
  EXPECT_NE(freed.err.find("the vehicle may leave the lanes: all is free 5 m around places and lanes"), std::string::npos) << freed.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "n.json"))["map"]["source"]["margin"], 5);
  refused(run("map ring.xml --off-lanes --corridor 2 --scenario n.json --from D --to dock"), {"--off-lanes", "--corridor"});
  refused(run("map ring.xml --off-lanes"), {"--off-lanes", "--scenario"});
  refused(run("map ring.xml --margin 3 --corridor 2"), {"margin", "does not go with corridor"});
  refused(run("map " + example("warehouse.yaml") + " --margin 2"), {"no plant model"});
}

const std::string building = R"(levels:
  L1:
    measurements:
      - [0, 1, {distance: [3, 10]}]
    vertices:
      - [0, 0, 0, west]
      - [100, 0, 0, east]
      - [0, 100, 0, ""]
      - [100, 100, 0, ""]
      - [-20, -20, 0, ""]
      - [120, -20, 0, ""]
    lanes:
      - [0, 1, {bidirectional: [4, true]}]
    walls:
      - [4, 5, {}]
)";

TEST_F(CommandLine, LanesOfABuildingCanBeAllThatIsFree) {
  std::ofstream{folder_ / "a.building.yaml"} << building;
  const auto told = run("map a.building.yaml");
  ASSERT_EQ(told.status, 0) << told.err;
  const std::size_t first = told.out.find("west (0.000, ");
  ASSERT_NE(first, std::string::npos) << told.out;
  EXPECT_EQ(told.out.find("west (0.000, ", first + 1), std::string::npos) << "places stand there once: " << told.out;
  const auto made = run("map a.building.yaml --corridor 1.5 --scenario s.json --from west --to east --vehicle " + example("vehicles/disc_robot.json"));
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "s.json"))["map"]["source"]["corridor"], 1.5);
  const auto planned = run("plan s.json -o o");
  EXPECT_EQ(planned.status, 0) << planned.out << planned.err;
  EXPECT_NE(planned.out.find("It keeps to the lanes: all of its 10.00 m lie within 0.75 m of their middle."), std::string::npos) << planned.out;
}

// As a plant's: kept unless told otherwise, and either is said.
TEST_F(CommandLine, AScenarioOfABuildingKeepsToItsLanesUnlessToldOtherwise) {
  std::string bent = building;  // from west to a corner off the straight way, along two lanes
  bent.replace(bent.find("      - [0, 1, {bidirectional: [4, true]}]\n"), std::string{"      - [0, 1, {bidirectional: [4, true]}]\n"}.size(), "      - [0, 1, {bidirectional: [4, true]}]\n      - [1, 3, {bidirectional: [4, true]}]\n");
  bent.replace(bent.find("[100, 100, 0, \"\"]"), std::string{"[100, 100, 0, \"\"]"}.size(), "[100, 100, 0, south]");
  std::ofstream{folder_ / "a.building.yaml"} << bent;
  const std::string ends = " --from west --to south --vehicle " + example("vehicles/disc_robot.json");
  const auto made = run("map a.building.yaml --scenario s.json" + ends);
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.err.find("the vehicle keeps to the lanes: nothing is free but strips 1 m across along the lanes, in which it has room to turn"), std::string::npos) << made.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "s.json"))["map"]["source"]["corridor"], 1);
  const auto kept = run("plan s.json -o o");
  ASSERT_EQ(kept.status, 0) << kept.out << kept.err;
  EXPECT_NE(kept.out.find("It keeps to the lanes: all of its "), std::string::npos) << kept.out;
  EXPECT_GT(Json::parse(slurp(folder_ / "o/plan.json"))["metrics"]["length"].get<double>(), 18.0);  // straight 14.1 m

  const auto freed = run("map a.building.yaml --off-lanes --scenario f.json" + ends);
  ASSERT_EQ(freed.status, 0) << freed.err;
  EXPECT_NE(freed.err.find("the vehicle may leave the lanes: all that walls leave free may be driven on"), std::string::npos) << freed.err;
  const auto off = run("plan f.json -o f");
  ASSERT_EQ(off.status, 0) << off.out << off.err;
  EXPECT_NE(off.out.find(" lie off the lanes"), std::string::npos) << off.out;
  EXPECT_LT(Json::parse(slurp(folder_ / "f/plan.json"))["metrics"]["length"].get<double>(), 15.0);
  // What drives there a building does not tell.
  refused(run("map a.building.yaml --scenario s2.json --from west --to south"), {"a.building.yaml: --vehicle: the map tells no vehicle", "--vehicle FILE.json"});
  refused(run("map a.building.yaml --scenario s2.json --from wets --to south --vehicle " + example("vehicles/disc_robot.json")), {"--from", "no place \"wets\", did you mean \"west\"?"});
}

TEST_F(CommandLine, LanesThatCannotBeScenariosAreRefused) {
  std::ofstream{folder_ / "ring.xml"} << plant;
  refused(run("map ring.xml --scenario s.json --from A"), {"--to", "A, B, C, D"});
  refused(run("map ring.xml --scenario s.json --from A --to X"), {"--to", "no place \"X\"", "A, B, C, D"});
  refused(run("map ring.xml --scenario s.json --from A --to A"), {"--to", "same place"});
  refused(run("map ring.xml --scenario s.json --from A --to B --prefer 2"), {"--prefer", "0.01"});
  refused(run("map ring.xml --scenario s.json --from A --to B --lane-width -1"), {"--lane-width", "not over 0"});
  refused(run("map ring.xml --scenario ring.xml --from A --to B"), {"--scenario", "would be lost"});
  refused(run("map ring.xml --from A"), {"--scenario"});
  refused(run("map " + example("warehouse.yaml") + " --scenario s.json --from A --to B"), {"no lanes"});
  refused(run("map " + example("warehouse.yaml") + " --corridor 2"), {"no lanes"});
  refused(run("map ring.xml --corridor 0.001"), {"corridor", "four cells"});
  refused(run("map ring.xml --vehicle v.json --scenario s.json --from A --to B"), {"v.json"});
}

TEST_F(CommandLine, TheDemoPlantAndTheOfficeAreDrivenAlongTheirLanes) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path{data} / "roadmaps")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  const std::string folder = std::string{data} + "/roadmaps/";
  const auto plant_made = run("map " + folder + "opentcs_Demo-01.xml --corridor 2 --scenario d.json --from 'Goods in north 01' --to 'Point-0001'");
  ASSERT_EQ(plant_made.status, 0) << plant_made.err;
  const auto demo = run("plan d.json -o d");
  EXPECT_EQ(demo.status, 0) << demo.out << demo.err;
  EXPECT_EQ(run("verify d/plan.json").status, 0);
  const auto office_made = run("map " + folder + "rmf_office.building.yaml --scenario f.json --from pantry --to supplies --prefer 0.5 --vehicle " + example("vehicles/disc_robot.json"));
  ASSERT_EQ(office_made.status, 0) << office_made.err;
  const auto office = run("plan f.json -o f");
  EXPECT_EQ(office.status, 0) << office.out << office.err;
  EXPECT_EQ(run("verify f/plan.json").status, 0);
}

}  // namespace
}  // namespace waywright
