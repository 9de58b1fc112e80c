#include "waywright/io/site_csv.hpp"

#include <gtest/gtest.h>

#include "waywright/io/csv_table.hpp"
#include "waywright/io/place_record.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

Site least_site() {
  const Scenario s = parse_scenario(test::least_scenario, "s", {}).value();
  return {s.map, s.map_source, s.vehicle, {"a note"}};
}

Parsed<std::vector<SiteRow>> rows_of(const std::string& text, const SiteDefaults& defaults = {}) { return parse_site_csv(text, "s.csv", least_site(), defaults); }

std::string refusal(const std::string& text) {
  const auto rows = rows_of(text);
  return rows ? "" : rows.error().message();
}

TEST(SiteCsv, RowsAreScenarios) {
  const auto rows = rows_of(
      "# stations\nName;start_x;start_y;start_heading_deg;goal_x;goal_y;goal_heading;shelf_x;shelf_y;shelf_heading;shelf_depth;shelf_width;gap;slot;area;clearance;planner;seed;"
      "pose_error.lateral;station.manoeuvre;planner.optimizer;budget.evaluations;meta.owner\n"
      "\n  \"A;\"\"1\"\" \" ;1;+2;90;3;4;-1;;;;;;;;;;;;;;;;\r\n"
      ";;;\n"
      "B;1;2;0;;;;5;6;0.5;1.2;2.5;0.3;-0.1;0 0 | 12.5 14;0.07;pattern_docking;9;0.01;undock;de;100;12\n"
      "C;1;2;0;;;;5;6;0.5;1.2;2.5;;;0 0 | 12 0|12 14;;;;;;sa;;\n");
  ASSERT_TRUE(rows) << rows.error().message();
  ASSERT_EQ(rows->size(), 3U);
  const Scenario& a = (*rows)[0].scenario;
  EXPECT_EQ((*rows)[0].name, "A;\"1\"");
  EXPECT_EQ((*rows)[0].origin, "s.csv: line 4");
  EXPECT_EQ(a.start, (Pose{1, 2, 0.5 * pi}));
  EXPECT_EQ(std::get<Pose>(a.mission), (Pose{3, 4, -1}));
  EXPECT_EQ(a.clearance, 0.0);
  EXPECT_EQ(a.map.notes, std::vector<std::string>{"a note"});
  const Scenario& b = (*rows)[1].scenario;
  const auto& station = std::get<Station>(b.mission);
  EXPECT_EQ(station.area, (Ring{{0, 0}, {12.5, 0}, {12.5, 14}, {0, 14}}));
  EXPECT_EQ(station.shelf.center, (Vec2{5, 6}));
  EXPECT_EQ(station.shelf.heading, 0.5);
  EXPECT_EQ(station.shelf.depth, 1.2);
  EXPECT_EQ(station.shelf.width, 2.5);
  EXPECT_EQ(station.shelf.gap, 0.3);
  EXPECT_EQ(station.shelf.slot, -0.1);
  EXPECT_EQ(station.manoeuvre, Manoeuvre::undock);
  EXPECT_EQ(b.clearance, 0.07);
  EXPECT_EQ(b.seed, 9U);
  EXPECT_EQ(b.pose_error.lateral, 0.01);
  EXPECT_EQ(b.budget.evaluations, 100);
  EXPECT_EQ(std::get<std::string>(b.planner.parameters.at("optimizer")), "de");
  EXPECT_EQ(b.meta, R"({"owner":12})");
  EXPECT_EQ(std::get<Station>((*rows)[2].scenario.mission).area.size(), 3U);
  EXPECT_EQ((*rows)[2].scenario.planner.name, "pattern_docking");
}

TEST(SiteCsv, ZonesStandInACellAsJson) {
  const std::string header = "name;start_x;start_y;start_heading;goal_x;goal_y;goal_heading;zones\n";
  const auto rows = rows_of(header + "A;0;0;0;1;0;0;[{\"type\": \"speed_limit\", \"area\": [[0,0],[1,0],[1,1]], \"speed\": 0.4}]\nB;0;0;0;1;0;0;\n");
  ASSERT_TRUE(rows) << rows.error().message();
  ASSERT_EQ((*rows)[0].scenario.zones.size(), 1U);
  EXPECT_EQ((*rows)[0].scenario.zones[0].speed, 0.4);
  EXPECT_TRUE((*rows)[1].scenario.zones.empty());
  const std::string refused = refusal(header + "A;0;0;0;1;0;0;[{\"type\": \"speed_limit\", \"area\": [[0,0],[1,0],[1,1]], \"speed\": 0}]\n");
  EXPECT_NE(refused.find("0 is out of range (allowed: 0.001 to 1000)"), std::string::npos) << refused;
  EXPECT_NE(refused.find("zones"), std::string::npos) << refused;
}

TEST(SiteCsv, DefaultsAreForRowsThatSayNothing) {
  SiteDefaults defaults{0.04, "ompl_rrt_connect", 5};
  const auto rows = rows_of("name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,clearance,planner,seed\nA,0,0,0,1,0,0,,,\nB,0,0,0,1,0,0,0,pattern_docking,6\n", defaults);
  ASSERT_TRUE(rows) << rows.error().message();
  const Scenario &a = (*rows)[0].scenario, &b = (*rows)[1].scenario;
  EXPECT_EQ(a.clearance, 0.04);
  EXPECT_EQ(a.planner.name, "ompl_rrt_connect");
  EXPECT_EQ(a.seed, 5U);
  EXPECT_EQ(b.clearance, 0.0);
  EXPECT_EQ(b.planner.name, "pattern_docking");
  EXPECT_EQ(b.seed, 6U);
}

TEST(SiteCsv, RowsWithWaypointsGetThePlannerForThem) {
  const auto rows = rows_of("name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,waypoints,planner,planner.evaluations\nA,0,0,0,9,0,0,3 1 | 6 1,,50\nB,0,0,0,9,0,0,3 1,,\nC,0,0,0,9,0,0,,,50\n");
  ASSERT_TRUE(rows) << rows.error().message();
  EXPECT_EQ((*rows)[0].scenario.planner.name, "waypoint_clothoid");
  EXPECT_EQ((*rows)[0].scenario.waypoints, (std::vector<Vec2>{{3, 1}, {6, 1}}));
  EXPECT_EQ((*rows)[1].scenario.planner.name, "waypoint_clothoid");
  EXPECT_EQ((*rows)[2].scenario.planner.name, "pattern_docking");
}

TEST(SiteCsv, WhatIsStrangeInARowIsNotedWithItsColumn) {
  const auto rows = rows_of("name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading_deg\nA,0,0,-90,9,0,720\nB,0,0,6.2,9,0,90\n");
  ASSERT_TRUE(rows) << rows.error().message();
  ASSERT_EQ((*rows)[0].notes.size(), 1U);
  EXPECT_EQ((*rows)[0].notes[0], "start_heading: -90 rad is more than a whole turn and is taken as -2.0354 rad (-116.6°); headings are in radians: -90° would be -1.5708 (a column start_heading_deg takes degrees)");
  EXPECT_EQ((*rows)[0].scenario.map.notes, (std::vector<std::string>{"a note", (*rows)[0].notes[0]}));
  EXPECT_NE((*rows)[0].scenario.map_source.find("start_heading: -90 rad"), std::string::npos);
  EXPECT_NEAR((*rows)[0].scenario.start.heading, wrap(-90.0), 1e-12);
  EXPECT_NEAR(std::get<Pose>((*rows)[0].scenario.mission).heading, 0.0, 1e-12);
  EXPECT_TRUE((*rows)[1].notes.empty());
}

TEST(SiteCsv, WhatIsWrongIsToldWithLineNameAndColumn) {
  const std::string header = "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,clearance\n";
  EXPECT_EQ(refusal(header + "A,0,0,0,1,0,0,0\nB,0,zero,0,1,0,0,0\n"), "s.csv: line 3 (B): start_y: \"zero\" is no number (allowed: a finite number with a decimal point)");
  EXPECT_EQ(refusal(header + "A,0,0,,1,0,0,0\n"), "s.csv: line 2 (A): start_heading: it is missing, and others of its kind are given (allowed: a number)");
  EXPECT_EQ(refusal(header + "A,0,0,0,1,0,0,-1\n"), "s.csv: line 2 (A): clearance: -1 is out of range (allowed: 0 to 1000)");
  EXPECT_EQ(refusal(header + ",0,0,0,1,0,0,0\n"), "s.csv: line 2: name: the place has no name (allowed: a name that no other place has)");
  EXPECT_EQ(refusal(header + "A,0,0,0,1,0,0,0,7\n").find("s.csv: line 2: there are 9 cells, and the header names 8"), 0U);
  EXPECT_EQ(refusal(header + "\"A,0,0,0,1,0,0,0\n").find("s.csv: line 2: a quoted cell does not end"), 0U);
  EXPECT_EQ(refusal(header + "T\xFCr,0,0,0,1,0,0,0\n"), "s.csv: line 2: the text is not UTF-8 (allowed: a file saved as UTF-8)");
  EXPECT_EQ(refusal(header + "A,2e6,0,0,1,0,0,0\n").find("s.csv: line 2 (A): start_x: "), 0U);
  EXPECT_EQ(refusal(header), "s.csv: there is no place below the header (allowed: at least one row)");
  EXPECT_EQ(refusal("").find("s.csv: the file is empty"), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y\nA,0,0\n").find("s.csv: the header: the column \"start_heading\" is missing"), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y,start_heading,clearence\n").find("s.csv: the header: the column \"clearence\" is not known"), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y,start_heading,start_heading_deg\n").find("s.csv: the header: the columns \"start_heading\" and \"start_heading_deg\" say the same"), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y,start_heading,area\nA,0,0,0,1 2 3|4 5\n").find("s.csv: line 2 (A): area: \"1 2 3|4 5\" is no list of points"), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y,start_heading,station.nothing\nA,0,0,0,1\n").find("s.csv: line 2 (A): station.nothing: "), 0U);
  EXPECT_EQ(refusal("name,start_x,start_y,start_heading,gap,station.shelf\nA,0,0,0,1,2\n").find("s.csv: line 2 (A): station.shelf: another column"), 0U);
}

TEST(CsvTable, TextIsTakenAsItStands) {
  const auto table = parse_csv_table("\xEF\xBB\xBF" "a\tb,c\r\n1\t\" x\ty \"\n#\n2\n", "t", 10, "");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->header, (std::vector<std::string>{"a", "b,c"}));
  ASSERT_EQ(table->rows.size(), 2U);
  EXPECT_EQ(table->rows[0].cells, (std::vector<std::string>{"1", "x\ty"}));
  EXPECT_EQ(table->rows[1].cells, (std::vector<std::string>{"2", ""}));
  EXPECT_EQ(table->rows[1].line, 4U);
  EXPECT_FALSE(parse_csv_table("a\n1\n2\n", "t", 1, ""));
  for (const char* bad : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80"}) EXPECT_FALSE(parse_csv_table(std::string{"a\n"} + bad, "t", 9, "")) << bad;
  EXPECT_TRUE(parse_csv_table("a\n\xF0\x9F\x9A\x9C\xE2\x82\xAC\xC3\xA4\n", "t", 9, ""));
}

TEST(PlaceRecord, ReadsBackAndTellsEveryChange) {
  PlaceFigures f;
  f.name = "A";
  f.status = Status::solved;
  f.planner = "p";
  f.asked = 0.05;
  f.has_path = f.collision_free = true;
  f.tightest = TightSpot{0.1, {1, 2}, "the shelf"};
  f.length = 0.1 + 0.2;
  f.curvature_limit = 0.8;
  f.direction_changes = 1;
  const std::string text = place_record_json({"key", {{"plan.json", "hash"}}, f});
  const auto again = parse_place_record(text);
  ASSERT_TRUE(again);
  EXPECT_EQ(place_record_json(*again), text);
  EXPECT_EQ(again->figures.tightest->point, (Vec2{1, 2}));
  EXPECT_FALSE(again->figures.on_the_way);
  // Every byte counts but the blanks between the fields.
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' || text[i] == '\n') continue;
    std::string changed = text;
    changed[i] = changed[i] == '1' ? '2' : '1';
    EXPECT_FALSE(changed != text && parse_place_record(changed)) << i;
    EXPECT_FALSE(parse_place_record(text.substr(0, i)));
  }
}

}  // namespace
}  // namespace waywright
