#include "waywright/io/whale_config.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/io/image.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/map/whale_maps.hpp"

namespace waywright {
namespace {

/// As the publication prints it, comma before the end and all.
const std::string printed = R"({
  "ReturnOnFirstPath": true, "RenderGraphics": false, "CreateVideo": false, "TestMode": true,
  "MapProcessor_Obstacles_Dilation": 0, "MapProcessor_Epsilon": 0.02, "MapProcessor_Map_Name": "5",
  "PathPlanner_Iterations": 10000, "PathPlanner_Step_Size": 1.0, "PathPlanner_Search_Radius": 1.5, "PathPlanner_Goal_Threshold": 1.0,
  "PathOptimizer_Population": 10, "PathOptimizer_Iterations": 10, "PathOptimizer_a_Parameter": 4.0, "PathOptimizer_b_Parameter": 1.0,
  "PathOptimizer_Shortness_Weight": 10.0, "PathOptimizer_Collision_Free_Weight": 1.0, "PathOptimizer_Width_Bound": 2.5, "PathOptimizer_Height_Bound": 2.5,
})";

bool says(const ConfiguredScenario& configured, const std::string& line) { return std::find(configured.mapping.begin(), configured.mapping.end(), line) != configured.mapping.end(); }

std::string refusal(const std::string& text, const std::filesystem::path& folder = "nowhere") {
  const auto configured = parse_whale_config(text, "c.json", folder);
  return configured ? "accepted" : configured.error().message();
}

TEST(WhaleConfig, ThePrintedFileIsTheGlobalVariantOnTheFifthMap) {
  ASSERT_TRUE(is_whale_config(printed));
  const ConfiguredScenario configured = parse_whale_config(printed, "c.json", {}).value();
  const Scenario& s = configured.scenario;
  EXPECT_EQ(s.map.obstacles, whale_map("WOA-5")->map.obstacles);
  EXPECT_TRUE(s.vehicle.footprint.is_disc());
  EXPECT_EQ(s.vehicle.footprint.disc, 0.0);
  EXPECT_EQ(s.start.position(), (Vec2{1.5, 1.5}));
  EXPECT_EQ(std::get<Pose>(s.mission).position(), (Vec2{18.5, 18.5}));
  EXPECT_EQ(s.clearance, 0.0);
  EXPECT_EQ(s.planner.name, "rrt_star_woa_global");
  const Parameters expected{{"first_path", true}, {"iterations", 10000.0}, {"step", 1.0}, {"radius", 1.5}, {"goal_threshold", 1.0}, {"population", 10.0}, {"woa_iterations", 10.0}, {"a0", 4.0}, {"b", 1.0}, {"bound", 2.5}};
  EXPECT_EQ(s.planner.parameters, expected);
  // A line each of its 19 keys, two of the map's, and one of the comma.
  EXPECT_EQ(configured.mapping.size(), 21U);
  EXPECT_TRUE(says(configured, "PathPlanner_Step_Size 1.0 -> planner.parameters.step = 1"));
  EXPECT_TRUE(says(configured, "ReturnOnFirstPath true -> planner.parameters.first_path = true"));
  EXPECT_TRUE(says(configured, "MapProcessor_Map_Name \"5\" -> map.generate = \"WOA-5\""));
  EXPECT_TRUE(says(configured, "CreateVideo false is ignored: there are no videos"));
  // It is a scenario like any other.
  EXPECT_TRUE(parse_scenario(scenario_json(s), "s.json", {}));
}

TEST(WhaleConfig, ObjectsOfKeysAreTheSame) {
  const std::string nested = R"({"ReturnOnFirstPath": true, "RenderGraphics": false, "CreateVideo": false, "TestMode": true,
    "MapProcessor": {"Obstacles_Dilation": 0, "Epsilon": 0.02, "Map_Name": 5},
    "PathPlanner": {"Iterations": 10000, "Step_Size": 1.0, "Search_Radius": 1.5, "Goal_Threshold": 1.0},
    "PathOptimizer": {"Population": 10, "Iterations": 10, "a_Parameter": 4.0, "b_Parameter": 1.0, "Shortness_Weight": 10.0, "Collision_Free_Weight": 1.0, "Width_Bound": 2.5, "Height_Bound": 2.5}})";
  ASSERT_TRUE(is_whale_config(nested));
  const Scenario one = parse_whale_config(nested, "c.json", {})->scenario, other = parse_whale_config(printed, "c.json", {})->scenario;
  EXPECT_EQ(one.planner.parameters, other.planner.parameters);
  EXPECT_EQ(one.map.obstacles, other.map.obstacles);
}

TEST(WhaleConfig, ThePlannerFollowsFromTheKeysOrIsNamed) {
  EXPECT_EQ(parse_whale_config(R"({"MapProcessor_Map_Name": "1", "PathPlanner_Iterations": 50})", "c.json", {})->scenario.planner.name, "rrt_star");
  const auto takes = [](const std::string& planner, const std::string& parameter) { return planner != "rrt" || parameter == "step"; };
  const auto named = parse_whale_config(R"({"MapProcessor_Map_Name": "1", "PathPlanner_Step_Size": 2, "PathOptimizer_b_Parameter": 1})", "c.json", {}, "rrt", takes);
  EXPECT_EQ(named->scenario.planner.name, "rrt");
  EXPECT_EQ(named->scenario.planner.parameters, (Parameters{{"step", 2.0}}));
  EXPECT_TRUE(says(*named, "PathOptimizer_b_Parameter 1 is ignored: rrt has no such parameter"));
}

TEST(WhaleConfig, APictureIsTwentyMetresWide) {
  const test::Folder folder;
  GreyImage image{40, 30, std::vector<std::uint8_t>(1200, 255)};
  image.pixels[0] = 0;
  folder.write("m.png", encode_png(image));
  const auto configured = parse_whale_config(R"({"MapProcessor_Map_Name": "m.png", "MapProcessor_Obstacles_Dilation": 3})", "c.json", folder.path());
  ASSERT_TRUE(configured) << configured.error().message();
  const CellGrid& grid = configured->scenario.map.grids.front();
  EXPECT_EQ(grid.cell, 0.5);
  EXPECT_TRUE(grid.is_blocked(0, 0));
  EXPECT_EQ(configured->scenario.clearance, 1.5);
  EXPECT_EQ(std::get<Pose>(configured->scenario.mission).position(), (Vec2{18.5, 13.5}));
}

TEST(WhaleConfig, BadOnesAreRefusedInASentence) {
  EXPECT_EQ(refusal(R"({"MapProcessor_Map_Name": "6"})"), "c.json: MapProcessor_Map_Name: \"6\" is no map that is known (allowed: \"1\" to \"5\", or the name of a PNG or PGM picture)");
  EXPECT_EQ(refusal(R"({"TestMode": true})"), "c.json: MapProcessor_Map_Name: the field is missing (allowed: \"1\" to \"5\", or the name of a PNG or PGM picture)");
  EXPECT_EQ(refusal(R"({"MapProcessor": {"Map_Name": "1", "Obstacles_Dilation": 3}})"), "c.json: MapProcessor.Obstacles_Dilation: the map is made of polygons and has no pixels (allowed: 0, or a picture as the map)");
  EXPECT_EQ(refusal(R"({"MapProcessor_Map_Name": "1", "PathOptimizer_Width_Bound": 2.5, "PathOptimizer_Height_Bound": 2})"),
            "c.json: PathOptimizer_Height_Bound: the two bounds differ, and a way is varied by one (allowed: 2.5, as PathOptimizer_Width_Bound and PathOptimizer_Height_Bound both)");
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1", "PathPlanner_Stepsize": 1})").find("PathPlanner_Stepsize: unknown key, did you mean \"PathPlanner_Step_Size\"? (allowed: ReturnOnFirstPath, "), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1", "PathPlanner_Iterations": 1.5})").find("PathPlanner_Iterations: "), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1", "RenderGraphics": 1})").find("RenderGraphics: "), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1", "MapProcessor": {"Map_Name": "2"}})").find("given twice"), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "gone.png"})").find("gone.png"), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1", "PathPlanner": 3})").find("PathPlanner: "), std::string::npos);
  EXPECT_NE(refusal(R"({"MapProcessor_Map_Name": "1",,})").find("not valid JSON"), std::string::npos);
}

TEST(WhaleConfig, ScenariosAreNone) {
  EXPECT_FALSE(is_whale_config(test::full_scenario));
  EXPECT_FALSE(is_whale_config(R"({"format": "waywright-scenario/1", "TestMode": true})"));
  EXPECT_FALSE(is_whale_config(R"({"meta": {"TestMode": true}})"));
  EXPECT_FALSE(is_whale_config(R"(["TestMode"])"));
  EXPECT_FALSE(is_whale_config(R"({"TestMode": )"));
  EXPECT_FALSE(is_whale_config(""));
}

}  // namespace
}  // namespace waywright
