// What the documents show as input is read as they say.
#include "tests/command_line.hpp"

namespace {

using namespace waywright::test;

/// The fenced block after a marker in docs/formats.md.
std::string block_after(const std::string& marker) {
  const std::string text = slurp(WAYWRIGHT_SOURCE_DIR "/docs/formats.md");
  const std::size_t at = text.find("<!-- " + marker + " -->");
  if (at == std::string::npos) return {};
  const std::size_t begin = text.find('\n', text.find("```", at)) + 1;
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST_F(CommandLine, TheDocumentsMapIsRead) {
  const std::string map = block_after("loaded");
  ASSERT_FALSE(map.empty());
  std::ofstream{folder_ / "map.json"} << map;
  const Outcome o = run("map map.json");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("cells: 4 × 3 of 0.5 m, origin (6, 6, 0 rad); 9 free"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("2 occupied, 1 unknown"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("1 boundary, 2 obstacle polygons (2.50 m²), 1 line, 2 points"), std::string::npos) << o.out;
  // And a scenario may name it.
  const Json s = {{"format", "waywright-scenario/1"},
                  {"map", {{"polygons", "map.json"}}},
                  {"vehicle", {{"footprint", {{"disc", 0.3}}}, {"drive", {{"type", "differential"}, {"track", 0.4}}}}},
                  {"start", {2, 8, 0}},
                  {"goal", {10, 8, 0}},
                  {"planner", {{"name", "ompl_rrt_connect"}}}};
  const Outcome planned = run("plan " + write(s) + " -o o");
  EXPECT_EQ(planned.status, 0) << planned.out << planned.err;
}

TEST_F(CommandLine, TheDocumentsZonesAreRead) {
  const std::string zones = block_after("zones");
  ASSERT_FALSE(zones.empty());
  Json s = {{"format", "waywright-scenario/1"},
            {"map", {{"polygons", {{"boundary", {{0, 0}, {30, 0}, {30, 16}, {0, 16}}}}}}},
            {"vehicle", {{"footprint", {{"disc", 0.3}}}, {"drive", {{"type", "differential"}, {"track", 0.4}}}}},
            {"start", {2, 6, 0}},
            {"goal", {27, 6, 0}},
            {"planner", {{"name", "astar"}, {"resolution", 0.25}}}};
  s["zones"] = Json::parse(zones);
  const Outcome planned = run("plan " + write(s) + " -o o");
  EXPECT_EQ(planned.status, 0) << planned.out << planned.err;
  EXPECT_EQ(Json::parse(slurp((folder_ / "o/plan.json").string()))["scenario"]["zones"].size(), 5U);
}

TEST_F(CommandLine, TheDocumentsObstaclesAreRead) {
  Json s = {{"format", "waywright-scenario/1"},
            {"map", {{"generate", "WOA-2"}}},
            {"vehicle", Json::parse(slurp(WAYWRIGHT_SOURCE_DIR "/examples/vehicles/wheelchair.json"))},
            {"start", {1.5, 1.5, 0.785}},
            {"goal", {18.5, 18.5, 0.785}},
            {"planner", {{"name", "visibility_graph"}}}};
  const std::string moving = block_after("moving");
  ASSERT_FALSE(moving.empty());
  s["moving"] = Json::parse(moving);
  const Outcome planned = run("plan " + write(s) + " -o o");
  EXPECT_EQ(planned.status, 0) << planned.out << planned.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "o/plan.json"))["scenario"]["moving"].size(), 2U);
  const std::string seen = block_after("seen");
  ASSERT_FALSE(seen.empty());
  std::ofstream{folder_ / "seen.json"} << seen;
  const Outcome again = run("replan o/plan.json --after 6 --obstacles seen.json -o r");
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "r/plan.json"))["scenario"]["moving"].size(), 3U);
  EXPECT_EQ(run("verify r/plan.json").status, 0);
}

TEST_F(CommandLine, TheDocumentsTableOfStationsIsRead) {
  const std::string table = block_after("checked");
  ASSERT_FALSE(table.empty());
  std::ofstream{folder_ / "s.csv"} << table;
  const Outcome o = run("check s.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json") + " -o c");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("2 places: 2 solved and proven"), std::string::npos) << o.out;
  EXPECT_EQ(o.err, "");
}

}  // namespace
