#include "waywright/io/scenario_io.hpp"

#include <gtest/gtest.h>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

using test::fingerprint;
using test::Folder;
using test::full_scenario;
using test::least_scenario;

Scenario parsed(const std::string& text, const std::filesystem::path& folder = {}) {
  auto scenario = parse_scenario(text, "s.json", folder);
  EXPECT_TRUE(scenario) << scenario.error().message();
  return scenario ? *scenario : Scenario{};
}

Scenario with_map(const std::string& map, const std::filesystem::path& folder = {}) {
  Json json = Json::parse(least_scenario);
  json["map"] = Json::parse(map);
  return parsed(json.dump(), folder);
}

/// Two free cells below, an occupied and an unknown one above; 0.5 m a cell.
void write_ros_map(const Folder& folder) {
  folder.write("maps/m.yaml",
               "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: "
               "0.65\nfree_thresh: 0.196\n");
  folder.write("maps/m.pgm", std::string{"P5\n2 2\n255\n"} + '\x00' + '\xcd' + '\xfe' + '\xfe');
}

TEST(ScenarioIo, ReadsEveryField) {
  const Scenario s = parsed(full_scenario);
  EXPECT_EQ(s.name, "dock at shelf 3 ä🚚");
  EXPECT_EQ(s.meta, R"({"any":[1,2.5,{"thing":null}],"n":1.0})");
  EXPECT_EQ(s.map.boundaries.size(), 2U);
  EXPECT_EQ(s.map.obstacles.size(), 2U);
  EXPECT_EQ(s.map.obstacles[0][0], (Vec2{4.25, 4.5}));
  EXPECT_EQ(s.map.obstacles[1][0], (Vec2{6, 6})) << "further obstacles stand in the world frame";
  EXPECT_EQ(s.map.grids[0].blocked, (std::vector<std::uint8_t>{0, 0, 1, 1, 1, 2}));
  EXPECT_EQ(s.map.grids[0].origin.x, 1.75);
  EXPECT_FALSE(s.map.grids[0].bounds);
  EXPECT_EQ(s.map.alignment->transform, (Pose{0.25, 0.5, 0.0}));
  const auto& drive = std::get<Tricycle>(s.vehicle.drive);
  EXPECT_EQ(drive.steered_axle, SteeredAxle::front);
  EXPECT_EQ(drive.max_steering_rate, 0.9);
  EXPECT_EQ(s.vehicle.limits.curvature_rate, 1.3);
  ASSERT_EQ(s.vehicle.forks.size(), 1U);
  EXPECT_EQ(s.vehicle.forks[0].size(), 4U);
  EXPECT_EQ(s.vehicle.loads.at("drum").footprint.disc, 0.4);
  EXPECT_EQ(s.vehicle.loads.at("pallet").mass, 500.0);
  EXPECT_EQ(s.vehicle.control_point, (Pose{0.1, 0.0, 0.2}));
  EXPECT_EQ(s.start, (Pose{2, 8, wrap(7.0)})) << "angles are wrapped";
  const auto& station = std::get<Station>(s.mission);
  EXPECT_EQ(station.shelf.slot, -0.3);
  EXPECT_EQ(station.shelf.width, 2.0);
  EXPECT_EQ(s.budget.expansions, 2000);
  EXPECT_EQ(s.budget.seconds, 12.5);
  EXPECT_EQ(std::get<std::string>(s.planner.parameters.at("optimizer")), "de");
  EXPECT_EQ(std::get<double>(s.planner.parameters.at("population")), 20.0);
  EXPECT_TRUE(std::get<bool>(s.planner.parameters.at("polish")));
  EXPECT_EQ(s.seed, 9223372036854775807U);
}

TEST(ScenarioIo, DefaultsAreThoseOfTheContract) {
  const Scenario s = parsed(least_scenario);
  EXPECT_EQ(s.clearance, 0.0);
  EXPECT_EQ(s.seed, 1U);
  EXPECT_EQ(s.planner.name, "astar") << "which the contract leaves open: a disc that turns on the spot docks at nothing";
  EXPECT_TRUE(s.vehicle.footprint.is_disc());
  EXPECT_FALSE(s.budget.seconds || s.budget.evaluations);
  EXPECT_TRUE(s.map.boundaries.empty());
  Json json = Json::parse(least_scenario);
  json["vehicle"]["limits"] = {{"speed", 3.0}, {"acceleration", 0.9}};
  const Limits limits = parsed(json.dump()).vehicle.limits;
  EXPECT_EQ(limits.reverse_speed, 3.0) << "backwards as fast as forwards";
  EXPECT_EQ(limits.deceleration, 0.9);
  EXPECT_FALSE(limits.curvature);
  json["vehicle"]["footprint"] = Json::parse("[[1,-0.5],[2,-0.5],[2,0.5],[1,0.5]]");
  EXPECT_EQ(parsed(json.dump()).vehicle.footprint.polygon.size(), 4U) << "the origin may lie outside";
}

TEST(ScenarioIo, RoundTripKeepsEveryBit) {
  for (const char* text : {full_scenario, least_scenario}) {
    const Scenario once = parsed(text);
    const std::string written = scenario_json(once);
    const Scenario twice = parsed(written);
    EXPECT_EQ(fingerprint(once), fingerprint(twice));
    EXPECT_EQ(written, scenario_json(twice));
    EXPECT_EQ(fingerprint(once), fingerprint(parsed(scenario_json(once, 0)))) << "indentation says nothing";
  }
  Scenario made = parsed(least_scenario);
  made.map_source = "{}";
  made.map.points = {{0.1, -0.0}, {1e-300, 5e-324}, {1.0 / 3.0, 123456.789012345678}, {-1e6, 1e6}};
  made.mission = Pose{2.2250738585072014e-308, 0.30000000000000004, pi};
  made.vehicle.drive = Mecanum{0.1, 0.2, 0.30000000000000004, 12.000000000000002, 3.3, 2e-4, 0.0010000000000000002};
  made.planner.parameters = {
      {"huge", 1e300}, {"tiny", -1e-300}, {"word", std::string{"\"quoted\"\n"}}, {"flag", false}};
  EXPECT_EQ(fingerprint(made), fingerprint(parsed(scenario_json(made))));
}

TEST(ScenarioIo, WhereNoPlannerIsNamedItIsTheOneForTheMission) {
  struct Case {
    const char *vehicle, *goal, *planner;
  };
  const char* turns = R"({"footprint": {"disc": 0.3}, "drive": {"type": "differential", "track": 0.5}})";
  const char* slides = R"({"footprint": {"disc": 0.3}, "drive": {"type": "mecanum", "wheel_radius": 0.1, "half_length": 0.3, "half_width": 0.2}})";
  const char* steers = R"({"footprint": {"disc": 0.3}, "drive": {"type": "tricycle", "wheelbase": 0.5, "max_steering": 1}})";
  const char* forked = R"({"footprint": [[-1,-1],[1,-1],[1,1],[-1,1]], "forks": [[0,-1],[1,-1],[1,1],[0,1]], "drive": {"type": "differential", "track": 0.5}})";
  for (const Case& c : {Case{turns, "[1, 1, 0]", "astar"}, Case{slides, "[1, 1, 0]", "astar"}, Case{steers, "[1, 1, 0]", "pattern_docking"}, Case{forked, "[1, 1, 0]", "pattern_docking"},
                        Case{turns, "[1, 1]", "astar"}, Case{forked, "[1, 1]", "astar"}}) {
    const std::string text = std::string{R"({"format": "waywright-scenario/1", "map": {"polygons": {}}, "start": [0, 0, 0], "vehicle": )"} + c.vehicle + R"(, "goal": )" + c.goal;
    EXPECT_EQ(parsed(text + "}").planner.name, c.planner) << c.vehicle << c.goal;
    EXPECT_EQ(parsed(text + R"(, "waypoints": [[3, 3]]})").planner.name, "waypoint_clothoid");
    EXPECT_EQ(parsed(text + R"(, "planner": {"name": "voronoi"}})").planner.name, "voronoi");
    // A leg's is the same.
    const std::string legs = std::string{R"({"format": "waywright-scenario/1", "map": {"polygons": {}}, "start": [0, 0, 0], "vehicle": )"} + c.vehicle + R"(, "legs": [{"goal": )" + c.goal + "}]}";
    const Scenario in_legs = parsed(legs);
    EXPECT_EQ(in_legs.legs.front().planner.value_or(in_legs.planner).name, c.planner);
  }
}

TEST(ScenarioIo, BundledExamplesKeepEveryBit) {
  int examples = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator{std::string{WAYWRIGHT_SOURCE_DIR} + "/examples"}) {
    if (entry.path().extension() != ".json") continue;
    const auto once = read_scenario(entry.path());
    ASSERT_TRUE(once) << once.error().message();
    EXPECT_EQ(fingerprint(*once), fingerprint(parsed(scenario_json(*once)))) << entry.path();
    ++examples;
  }
  EXPECT_GE(examples, 5);
}

TEST(ScenarioIo, AnInfiniteLimitIsNone) {
  Scenario s = parsed(least_scenario);
  s.vehicle.limits.curvature = std::numeric_limits<double>::infinity();
  s.budget.seconds = std::numeric_limits<double>::infinity();
  const Scenario back = parsed(scenario_json(s));
  EXPECT_FALSE(back.vehicle.limits.curvature);
  EXPECT_FALSE(back.budget.seconds);
}

TEST(ScenarioIo, WhatWasMendedIsSaidOnce) {
  const Folder folder;
  folder.write(
      "v.json",
      R"({"footprint": [[0,0],[0,1],[1,1],[1,0]], "drive": {"type": "differential", "track": 0.5}})");
  folder.write("m.json", R"({"polygons": {"obstacles": [[[0,0],[1,0],[1,0],[1,1]]]}})");
  Json json = Json::parse(least_scenario);
  json["vehicle"] = "v.json";
  json["map"] = {{"polygons", "m.json"}, {"obstacles", Json::parse("[[[5,5],[5,6],[6,6],[5,5]]]")}};
  const Scenario s = parsed(json.dump(), folder.path());
  const std::vector<std::string> said{"m.json: polygons.obstacles[0]: 1 duplicate corner removed",
                                      "map.obstacles[0]: 1 duplicate corner removed",
                                      "map.obstacles[0]: clockwise order reversed",
                                      "v.json: footprint: clockwise order reversed"};
  EXPECT_EQ(s.map.notes, said);
  EXPECT_EQ(Json::parse(s.map_source)["notes"], Json(said));
  EXPECT_EQ(fingerprint(s), fingerprint(parsed(scenario_json(s))))
      << "nothing is left to mend, and nothing is said twice";
}

TEST(MapJson, RosMapsAreRecordedWithTheirHashes) {
  const Folder folder;
  write_ros_map(folder);
  const Scenario s = with_map(R"({"ros": "maps/m.yaml", "transform": [10, 0, 0]})", folder.path());
  ASSERT_EQ(s.map.grids.size(), 1U);
  EXPECT_EQ(s.map.grids[0].blocked, (std::vector<std::uint8_t>{1, 2, 0, 0}));
  EXPECT_EQ(s.map.grids[0].origin, (Pose{11, 2, 0}));
  EXPECT_TRUE(s.map.grids[0].bounds);
  // By sha256sum.
  EXPECT_EQ(
      s.map_source,
      R"({"kind":"ros","file":"maps/m.yaml","files":[{"name":"m.yaml","sha256":"71c14411275ee9f59df1131117ffbd2c591e48e31aafb51c5e0326ccf8ef84d9"},)"
      R"({"name":"m.pgm","sha256":"58f150592a1905323c6bfa8e1d2859ee264a56b6a2a7e60da3ae253296e21805"}],"transform":[10.0,0.0,0.0]})");
  EXPECT_EQ(
      with_map(R"({"ros": "maps/m.yaml", "unknown_is_free": true})", folder.path()).map.grids[0].blocked,
      (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(fingerprint(s), fingerprint(parsed(scenario_json(s)))) << "inlined: no file is needed any more";
}

TEST(MapJson, PicturesHaveResolutionAndOrigin) {
  const Folder folder;
  write_ros_map(folder);
  const Scenario s =
      with_map(R"({"image": "maps/m.pgm", "resolution": 0.1, "origin": [3, 4, 0.5], "occupied_below": 0.9})",
               folder.path());
  EXPECT_EQ(s.map.grids[0].blocked, (std::vector<std::uint8_t>{1, 1, 0, 0}));
  EXPECT_EQ(s.map.grids[0].cell, 0.1);
  EXPECT_EQ(s.map.grids[0].origin, (Pose{3, 4, 0.5}));
  const Json source = Json::parse(s.map_source);
  EXPECT_EQ(source["occupied_below"], 0.9);
  EXPECT_EQ(source["files"][0]["name"], "m.pgm");
}

TEST(MapJson, OverlaysDoNotBound) {
  const Folder folder;
  write_ros_map(folder);
  const Scenario s =
      with_map(R"({"polygons": {"boundary": [[0,0],[12,0],[12,10],[0,10]]}, "transform": [100, 0, 0],
      "overlay": [{"ros": "maps/m.yaml", "align": [[[0,0],[5,5]],[[1,0],[5,6]]]}, {"ros": "maps/m.yaml", "unknown_is_free": true},
                  {"polygons": {"points": [[1,1]]}, "obstacles": [[[0,0],[1,0],[1,1]]]}]})",
               folder.path());
  ASSERT_EQ(s.map.grids.size(), 2U);
  EXPECT_FALSE(s.map.grids[0].bounds);
  EXPECT_EQ(s.map.grids[0].blocked[1], 2) << "unknown cells block";
  EXPECT_EQ(s.map.grids[1].blocked[1], 0);
  EXPECT_NEAR(s.map.grids[0].origin.heading, 0.5 * pi, 1e-12);
  EXPECT_NEAR(s.map.grids[0].origin.x, 5.0 - 2.0, 1e-12);
  EXPECT_NEAR(s.map.grids[0].origin.y, 5.0 + 1.0, 1e-12);
  EXPECT_EQ(s.map.points[0], (Vec2{1, 1})) << "an overlay has its own place";
  EXPECT_EQ(s.map.boundaries[0][0], (Vec2{100, 0}));
  const Json source = Json::parse(s.map_source);
  EXPECT_EQ(source["overlay"].size(), 3U);
  EXPECT_EQ(source["overlay"][0]["align_residuals"].size(), 2U);
  EXPECT_EQ(fingerprint(s), fingerprint(parsed(scenario_json(s))));
}

TEST(MapJson, AlignmentKeepsItsResiduals) {
  // The second pair is 0.02 m farther apart in the world: each end is off by half of it.
  const Scenario s =
      with_map(R"({"polygons": {"points": [[1,1]]}, "align": [[[0,0],[10,0]],[[2,0],[10,2.02]]]})");
  ASSERT_EQ(s.map.alignment->residuals.size(), 2U);
  EXPECT_NEAR(s.map.alignment->residuals[0], 0.01, 1e-12);
  EXPECT_NEAR(s.map.points[0].x, 9.0, 1e-12);
  EXPECT_NEAR(s.map.points[0].y, 1.01, 1e-12);
  const Scenario back = parsed(scenario_json(s));
  EXPECT_EQ(back.map.alignment->residuals, s.map.alignment->residuals);
  EXPECT_EQ(fingerprint(back), fingerprint(s));
}

TEST(MapJson, LimitsHoldAfterTheTransform) {
  const char* far =
      R"({"polygons": {"boundary": [[5000000,4000000],[5000012,4000000],[5000012,4000010],[5000000,4000010]]}, "transform": [-5000000,-4000000,0]})";
  EXPECT_EQ(with_map(far).map.boundaries[0][2], (Vec2{12, 10})) << "a national grid, brought near";
  const Folder folder;
  write_ros_map(folder);
  folder.write("maps/far.yaml",
               "image: m.pgm\nresolution: 0.5\norigin: [5000000, 4000000, 0]\nnegate: 0\noccupied_thresh: "
               "0.65\nfree_thresh: 0.196\n");
  EXPECT_EQ(with_map(R"({"ros": "maps/far.yaml", "transform": [-5000000,-4000000,0]})", folder.path())
                .map.grids[0]
                .origin,
            Pose{});
  EXPECT_EQ(read_map(folder.path() / "maps/far.yaml").error().problem,
            "it reaches (5e+06, 4e+06) in the world frame");
  const auto refused = parse_scenario(
      R"({"format": "waywright-scenario/1", "map": {"polygons": {}, "cells": [{"columns": 1000000, "rows": 1, "cell": 2,
      "origin": [0, 0, 0], "runs": [0, 1000000]}]}})",
      "s.json", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(),
            "s.json: map: it reaches (2e+06, 2) in the world frame (allowed: coordinates within 1e+06 m "
            "after the transform)");
}

TEST(MapJson, CornersThatRoundingBringsTogetherAreMended) {
  const Scenario s =
      with_map(R"({"polygons": {"obstacles": [[[0,0],[1,0],[5e-324,1],[0,1]]]}, "transform": [0.25, 0, 0]})");
  EXPECT_EQ(s.map.obstacles[0], (Ring{{0.25, 0}, {1.25, 0}, {0.25, 1}}));
  EXPECT_EQ(s.map.notes, (std::vector<std::string>{"map: in the world frame 1 duplicate corner removed"}));
  EXPECT_EQ(fingerprint(s), fingerprint(parsed(scenario_json(s))));
  const auto lost = parse_scenario(
      R"({"format": "waywright-scenario/1", "map": {"polygons": {"obstacles": [[[0,0],[1e-12,0],[0,1e-12]]]}, "transform": [1000, 0, 0]}})",
      "s", {});
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().message().rfind("s: map: in the world frame ", 0), 0U) << lost.error().message();
}

TEST(MapJson, NamedMapsHoldAMapOrItsPolygons) {
  const Folder folder;
  write_ros_map(folder);
  folder.write("maps/object.json", R"({"polygons": {"points": [[1,2]]}, "transform": [1, 0, 0]})");
  folder.write("maps/bare.json", R"({"points": [[1,2]], "obstacles": [[[0,0],[1,0],[1,1]]]})");
  folder.write("maps/ros.json", R"({"ros": "m.yaml"})");
  const Scenario object =
      with_map(R"({"polygons": "maps/object.json", "transform": [0, 1, 0]})", folder.path());
  EXPECT_EQ(object.map.points[0], (Vec2{2, 3}));
  EXPECT_EQ(object.map.alignment->transform, (Pose{1, 1, 0})) << "placed twice";
  EXPECT_EQ(Json::parse(object.map_source)["source"]["kind"], "polygons");
  EXPECT_EQ(with_map(R"({"polygons": "maps/bare.json"})", folder.path()).map.obstacles.size(), 1U);
  EXPECT_EQ(with_map(R"({"polygons": "maps/ros.json"})", folder.path()).map.grids.size(), 1U)
      << "paths start at the file that names them";
  EXPECT_EQ(fingerprint(object), fingerprint(parsed(scenario_json(object))));
}

TEST(MapJson, MapsAloneAreReadAndWritten) {
  const Folder folder;
  write_ros_map(folder);
  const Map ros = read_map(folder.path() / "maps/m.yaml").value();
  EXPECT_EQ(ros.grids[0].blocked, (std::vector<std::uint8_t>{1, 2, 0, 0}));
  Map map = parsed(full_scenario).map;
  map.grids.push_back(ros.grids[0]);
  const Map back = read_map(folder.write("m.json", map_json(map))).value();
  for (std::string& note : map.notes) note = "m.json: " + note;
  EXPECT_EQ(fingerprint(back), fingerprint(map));
  const auto sentence = [&](const std::string& name) {
    return read_map(folder.path() / name).error().message().substr(folder.path().string().size() + 1);
  };
  EXPECT_EQ(sentence("hall.dxf"), "hall.dxf: there is no such file (allowed: a file that can be read)");
  EXPECT_EQ(sentence("maps/m.pgm"),
            "maps/m.pgm: a picture alone has no scale (allowed: a ROS yaml, a map.json with image and "
            "resolution, or `map --resolution`)");
  EXPECT_EQ(sentence("gone.json"), "gone.json: there is no such file (allowed: a file that can be read)");
}

TEST(MapJson, AMillionPointsAreReadInTime) {
  Scenario s = parsed(least_scenario);
  for (int i = 0; i < 1'000'000; ++i) s.map.points.push_back({0.1 * (i % 1000), 0.001 * i});
  const Scenario back = parsed(scenario_json(s));
  EXPECT_EQ(back.map.points, s.map.points);
}

}  // namespace
}  // namespace waywright
