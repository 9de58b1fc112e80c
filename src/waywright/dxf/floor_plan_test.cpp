// Floor plans: what becomes of each kind of entity, layers, units, blocks, repairs, and what is refused.
#include "waywright/dxf/floor_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "waywright/core/random.hpp"
#include "waywright/dxf/test_drawing.hpp"

namespace waywright::dxf {
namespace {

namespace fs = std::filesystem;
using namespace waywright::test;

const std::string hall = box("WALLS", 0, 0, 20000, 10000);

FloorPlan plan_of(const std::string& text, const Options& options = {}) {
  auto plan = read_floor_plan(text, "dir/plan.dxf", options);
  EXPECT_TRUE(plan) << plan.error().message();
  return plan ? *plan : FloorPlan{};
}

std::string error_of(const std::string& text, const Options& options = {}) {
  const auto plan = read_floor_plan(text, "dir/plan.dxf", options);
  EXPECT_FALSE(plan);
  return plan ? "" : plan.error().message();
}

std::string entities(const std::string& content) {
  TestDrawing drawing;
  drawing.entities = content;
  return drawing.text();
}

bool says(const FloorPlan& plan, const std::string& words) {
  return std::any_of(plan.notes.begin(), plan.notes.end(), [&](const std::string& note) { return note.find(words) != note.npos; });
}
#define EXPECT_SAYS(plan, words) EXPECT_TRUE(says(plan, words)) << testing::PrintToString((plan).notes)

double distance_to(const Polyline& line, Vec2 p, bool closed) {
  double least = 1e300;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Vec2 a = line[i], d = line[(i + 1) % line.size()] - a;
    const double t = squared_norm(d) > 0.0 ? std::clamp(dot(p - a, d) / squared_norm(d), 0.0, 1.0) : 0.0;
    least = std::min(least, distance(p, a + t * d));
  }
  return least;
}

TEST(FloorPlan, LinesAreWallsAndClosedOutlinesAreSolid) {
  const FloorPlan plan = plan_of(entities(line("WALLS", 0, 0, 20000, 0) + box("RACKS", 1000, 1000, 3000, 2000) + polyline("WALLS", false, {{0, 0}, {0, 9000}, {500, 9000}})));
  ASSERT_EQ(plan.lines.size(), 2u);
  ASSERT_EQ(plan.obstacles.size(), 1u);
  EXPECT_EQ(plan.obstacles[0], rectangle({1, 1}, {3, 2}));
  EXPECT_EQ(plan.lines[1], (Polyline{{0, 0}, {0, 9}, {0.5, 9}}));
  EXPECT_SAYS(plan, "plan.dxf: in mm as the drawing says; taken: 1 LINE and 1 LWPOLYLINE on WALLS; 1 LWPOLYLINE on RACKS");
}

TEST(FloorPlan, OldPolylinesAreReadTooAndTheirFramesAreNot) {
  const std::string old = groups({{0, "POLYLINE"}, {8, "A"}, {66, 1}, {70, 1}, {0, "VERTEX"}, {8, "A"}, {10, 0}, {20, 0}, {0, "VERTEX"}, {8, "A"}, {10, 9999}, {20, 9999}, {70, 16},
                                  {0, "VERTEX"}, {8, "A"}, {10, 4000}, {20, 0}, {0, "VERTEX"}, {8, "A"}, {10, 4000}, {20, 2000}, {0, "SEQEND"}, {8, "A"}});
  const FloorPlan plan = plan_of(entities(old));
  ASSERT_EQ(plan.obstacles.size(), 1u);
  EXPECT_EQ(plan.obstacles[0], (Ring{{0, 0}, {4, 0}, {4, 2}}));
  const std::string mesh = groups({{0, "POLYLINE"}, {8, "A"}, {66, 1}, {70, 64}, {0, "VERTEX"}, {10, 0}, {20, 0}, {0, "SEQEND"}});
  EXPECT_SAYS(plan_of(entities(hall + mesh)), "though it may stand for walls: 1 POLYLINE on A");
}

/// Every point of the true curve is near its chords and every chord's middle near the curve, in a drawing with a scale of its own.
TEST(FloorPlan, CurvesKeepTheTolerance) {
  TestDrawing drawing;
  // A circle of 1 m, an ellipse, an arc and a half circle by its bulge; all in a block that is inserted at twice the size, inside another one.
  drawing.block("CURVES", 0, 0, circle("W", 0, 0, 1000) + groups({{0, "ARC"}, {8, "W"}, {10, 20000}, {20, 0}, {40, 9000}, {50, 300}, {51, 45}}));
  drawing.block("OUTER", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "curves"}, {10, 0}, {20, 0}, {41, 2}, {42, 2}}));
  drawing.entities = groups({{0, "INSERT"}, {8, "0"}, {2, "OUTER"}, {10, 50000}, {20, 0}}) + polyline("W", false, {{0, 0, 1}, {4000, 0}}) +
                     groups({{0, "ELLIPSE"}, {8, "W"}, {10, 0}, {20, 30000}, {11, 6000}, {21, 0}, {40, 0.25}, {41, 0}, {42, 2 * pi}});
  for (const double tolerance : {1e-4, 1e-3, 0.02}) {
    Options options;
    options.tolerance = tolerance;
    const FloorPlan plan = plan_of(drawing.text(), options);
    ASSERT_EQ(plan.obstacles.size(), 2u);
    ASSERT_EQ(plan.lines.size(), 2u);
    double worst = 0.0;
    for (int i = 0; i <= 5000; ++i) {
      const double t = i / 5000.0;
      worst = std::max(worst, distance_to(plan.obstacles[0], Vec2{50, 0} + 2.0 * unit(two_pi * t), true));
      worst = std::max(worst, distance_to(plan.obstacles[1], {6 * std::cos(two_pi * t), 30 + 1.5 * std::sin(two_pi * t)}, true));
      worst = std::max(worst, distance_to(plan.lines[0], Vec2{90, 0} + 18.0 * unit((-60 + 105 * t) * pi / 180), false));
      worst = std::max(worst, distance_to(plan.lines[1], Vec2{2, 0} + 2.0 * unit(pi + pi * t), false));
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, 0.01 * tolerance);  // no more points than it takes, by far
    EXPECT_LT(plan.obstacles[0].size(), 8 * std::sqrt(2.0 / tolerance));
  }
}

/// One arc of a large radius does not make thousands of points of every small circle.
TEST(FloorPlan, EachCurveHasThePointsThatItNeeds) {
  std::string content = groups({{0, "ARC"}, {8, "W"}, {10, -9e6}, {20, 0}, {40, 9e6}, {50, -0.1}, {51, 0.1}});
  for (int i = 0; i < 2000; ++i) content += circle("W", i % 50 * 100, i / 50 * 100, 40);
  const FloorPlan plan = plan_of(entities(content));
  ASSERT_EQ(plan.obstacles.size(), 2000u);
  for (const Ring& ring : plan.obstacles) EXPECT_LT(ring.size(), 40u);
  ASSERT_EQ(plan.lines.size(), 1u);
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) worst = std::max(worst, distance_to(plan.lines[0], Vec2{-9000, 0} + 9000.0 * unit((-0.1 + 0.0002 * i) * pi / 180), false));
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(plan.lines[0].size(), 30u);
  EXPECT_SAYS(plan, "chords no farther than 1 mm from them");
}

TEST(FloorPlan, BlocksAreInsertedWithScaleTurnMirrorAndArray) {
  TestDrawing drawing;
  drawing.block("B", 1000, 0, box("0", 1000, 0, 3000, 1000));
  drawing.block("N", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "B"}, {10, 5000}, {20, 0}, {41, 2}, {42, 1}, {50, 90}}));
  drawing.entities = groups({{0, "INSERT"}, {8, "MACHINES"}, {2, "N"}, {10, 10000}, {20, 2000}, {41, 1}, {42, 3}, {50, 30}}) +
                     groups({{0, "INSERT"}, {8, "MACHINES"}, {2, "b"}, {10, 0}, {20, 0}, {41, -1}, {42, 1}, {70, 2}, {71, 3}, {44, 10000}, {45, 4000}});
  const FloorPlan plan = plan_of(drawing.text());
  ASSERT_EQ(plan.obstacles.size(), 7u);
  const auto nested = [](Vec2 p) {  // from the block's own frame, in metres
    const Vec2 scaled{2 * (p.x - 1), p.y};
    const Vec2 turned = left_of(scaled) + Vec2{5, 0};
    return Frame{Pose{10, 2, pi / 6}}.to_world(Vec2{turned.x, 3 * turned.y});
  };
  double area = 0.0;
  for (const Vec2 corner : rectangle({1, 0}, {3, 1})) {
    double nearest = 1e9;
    for (const Vec2 p : plan.obstacles[0]) nearest = std::min(nearest, distance(p, nested(corner)));
    EXPECT_LT(nearest, 1e-9);
  }
  area = signed_area(plan.obstacles[0]);
  EXPECT_NEAR(area, 2 * 2 * 3, 1e-9);
  Box all = bounding_box(plan.obstacles[1]);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_NEAR(signed_area(plan.obstacles[i]), 2, 1e-9);  // mirrored, and counter-clockwise again
    const Box b = bounding_box(plan.obstacles[i]);
    all = {{std::min(all.low.x, b.low.x), std::min(all.low.y, b.low.y)}, {std::max(all.high.x, b.high.x), std::max(all.high.y, b.high.y)}};
  }
  EXPECT_NEAR(all.low.x, -2, 1e-9);
  EXPECT_NEAR(all.high.x, 10, 1e-9);
  EXPECT_NEAR(all.high.y, 9, 1e-9);
  EXPECT_SAYS(plan, "7 LWPOLYLINE on MACHINES");  // what lies on layer 0 in a block is on the layer of its insertion
}

TEST(FloorPlan, LayersSayWhatIsTaken) {
  TestDrawing drawing;
  drawing.layer("WALLS", 0, 7);
  drawing.layer("ICE", 1, 7);
  drawing.layer("DARK", 0, -7);
  drawing.block("B", 0, 0, line("WALLS", 0, 0, 100, 100) + line("ICE", 0, 0, 100, 100));
  drawing.entities = hall + line("ICE", 0, 0, 1, 1000) + line("DARK", 0, 0, 1, 1000) + line("A-TEXT-1", 0, 0, 1, 1000) + line("dims", 0, 0, 1, 1000) + line("Defpoints", 0, 0, 1, 1000) +
                     groups({{0, "TEXT"}, {8, "WALLS"}, {10, 0}, {20, 0}, {1, "hall"}}) + groups({{0, "HATCH"}, {8, "WALLS"}}) + groups({{0, "MLINE"}, {8, "WALLS"}}) +
                     groups({{0, "INSERT"}, {8, "ICE"}, {2, "B"}, {10, 0}, {20, 0}}) + groups({{0, "INSERT"}, {8, "0"}, {2, "B"}, {10, 0}, {20, 0}}) +
                     groups({{0, "LINE"}, {8, "WALLS"}, {67, 1}, {10, 0}, {20, 0}, {11, 5}, {21, 99999999}}) + groups({{0, "INSERT"}, {8, "0"}, {2, "GONE"}, {10, 0}, {20, 0}});
  const FloorPlan plan = plan_of(drawing.text());
  EXPECT_EQ(plan.lines.size(), 1u);
  EXPECT_EQ(plan.obstacles.size(), 1u);
  for (const char* words : {"annotations: 1 LINE on A-TEXT-1; 1 LINE on dims; 1 LINE on Defpoints", "frozen layers: 2 LINE on ICE", "layers that are off: 1 LINE on DARK",
                            "writing and the like: 1 HATCH and 1 TEXT on WALLS", "may stand for walls: 1 MLINE on WALLS", "1 inserted block on a frozen layer", "1 entity of paper space",
                            "1 inserted block that the drawing does not define"}) {
    EXPECT_SAYS(plan, words);
  }
  Options named;
  named.obstacle_layers = {"dims", "A-Text-1"};
  named.boundary_layer = "walls";
  const FloorPlan other = plan_of(drawing.text(), named);
  EXPECT_EQ(other.lines.size(), 3u);  // and the open line on the boundary's layer
  EXPECT_EQ(other.boundaries.size(), 1u);
  EXPECT_SAYS(other, "layers that are not named: 1 LINE on Defpoints");
  named.obstacle_layers = {"WALL"};
  EXPECT_EQ(error_of(drawing.text(), named).find("dir/plan.dxf: obstacle_layers: the drawing has no layer \"WALL\" (allowed: 0, WALLS, ICE"), 0u);
}

TEST(FloorPlan, BoundaryOfLinesThatMeet) {
  const std::string lines = line("B", 0, 0, 20000, 0) + line("B", 20000, 3, 20000, 10000) + line("B", 0, 10000, 20000, 10000) + line("B", 0, 10000, 0, 0);
  Options options;
  options.boundary_layer = "B";
  const FloorPlan plan = plan_of(entities(lines + box("R", 1000, 1000, 2000, 2000)), options);
  ASSERT_EQ(plan.boundaries.size(), 1u);
  EXPECT_NEAR(signed_area(plan.boundaries[0]), 200, 0.1);
  EXPECT_EQ(plan.lines.size(), 0u);
  EXPECT_SAYS(plan, "4 lines of the boundary layer were joined to 1 ring (gaps up to 3 mm)");
  options.closing = 0.001;
  EXPECT_NE(error_of(entities(lines), options).find("layer B holds no closed ring"), std::string::npos);
  options.closing = 0.01;
  EXPECT_NE(error_of(entities(box("B", 0, 0, 5000, 5000) + box("B", 6000, 0, 9000, 5000)), options).find("beside each other"), std::string::npos);
}

TEST(FloorPlan, AnOutlineOfThePlanIsNotSolid) {
  std::string racks;
  for (int i = 0; i < 5; ++i) racks += box("RACKS", 1000 + 3000 * i, 1000, 2000 + 3000 * i, 8000);
  const FloorPlan plan = plan_of(entities(hall + racks));
  EXPECT_EQ(plan.obstacles.size(), 5u);
  ASSERT_EQ(plan.lines.size(), 1u);
  EXPECT_EQ(plan.lines[0].front(), plan.lines[0].back());
  EXPECT_SAYS(plan, "taken as walls, not as solid (boundary_layer makes it the boundary)");
  // With racks on its layer, naming it would be refused.
  EXPECT_SAYS(plan_of(entities(hall + racks + box("WALLS", 17000, 1000, 18000, 8000))), "(on a layer of its own, boundary_layer would make it the boundary)");
}

TEST(FloorPlan, ARoomThatIsTakenAsSolidIsTold) {
  const std::string remedy = "if it is the outline of a room, name its layer as boundary_layer";
  const FloorPlan alone = plan_of(entities(hall));
  ASSERT_EQ(alone.obstacles.size(), 1u);
  EXPECT_SAYS(alone, "the largest closed LWPOLYLINE (200.0 m², on WALLS) is taken as solid, and there is nothing else: " + remedy);
  const FloorPlan full = plan_of(entities(hall + box("RACKS", 1000, 1000, 3000, 2000)));
  EXPECT_SAYS(full, "is taken as solid, with everything else inside: " + remedy);
  Options options;
  options.boundary_layer = "WALLS";
  EXPECT_FALSE(says(plan_of(entities(hall + box("RACKS", 1000, 1000, 3000, 2000)), options), remedy));
  // Racks beside each other are no rooms.
  EXPECT_FALSE(says(plan_of(entities(box("RACKS", 1000, 1000, 6000, 4000) + box("RACKS", 8000, 1000, 11000, 4000))), remedy));
}

TEST(FloorPlan, ShortLinesOfABoundaryAreJoinedWhereTheyMeet) {
  // A chamfer of 5 mm: each of its ends is nearer to the other one than the closing distance.
  Options options;
  options.boundary_layer = "HALL";
  const FloorPlan plan = plan_of(entities(line("HALL", 0, 0, 20000, 0) + line("HALL", 20000, 0, 20000, 9995) + line("HALL", 20000, 9995, 19995, 10000) + line("HALL", 19995, 10000, 0, 10000) +
                                          line("HALL", 0, 9997, 0, 0)), options);
  ASSERT_EQ(plan.boundaries.size(), 1u);
  EXPECT_NEAR(signed_area(plan.boundaries[0]), 200.0, 1e-2);
  EXPECT_SAYS(plan, "5 lines of the boundary layer were joined to 1 ring (gaps up to 3 mm)");
}

TEST(FloorPlan, RingsOfABoundaryWithinEachOtherAreTold) {
  Options options;
  options.boundary_layer = "HALL";
  const FloorPlan plan = plan_of(entities(box("HALL", 0, 0, 20000, 10000) + box("HALL", 200, 200, 19800, 9800)), options);
  EXPECT_EQ(plan.boundaries.size(), 2u);
  EXPECT_SAYS(plan, "the boundary layer holds 2 rings of 188.2 to 200.0 m² within each other; the vehicle stays inside each of them, so the smallest decides");
  TestDrawing drawing;
  drawing.layer("HALL", 1, 7);
  drawing.entities = box("HALL", 0, 0, 20000, 10000);
  EXPECT_EQ(error_of(drawing.text(), options), "dir/plan.dxf: boundary_layer: layer HALL is frozen in the drawing (allowed: a layer that is on)");
  EXPECT_NE(error_of(entities(polyline("HALL", true, {{0, 0}, {9000, 5000}, {9000, 0}, {0, 5000}})), options).find("holds no closed ring that encloses something clearly: a LWPOLYLINE on HALL, edges"),
            std::string::npos);
}

TEST(FloorPlan, FlatBulgesKeepTheTolerance) {
  // A rise of 5 mm over 10 m, under one of 5 m: as arcs of 2500 m and more they turn by little, and are still no chords.
  for (const double bulge : {1e-3, -1e-3, 3e-3, 2e-2}) {
    const FloorPlan plan = plan_of(entities(polyline("0", false, {{0, 0, bulge}, {10000, 0}})));
    ASSERT_EQ(plan.lines.size(), 1u);
    const double rise = 0.5 * 10.0 * bulge, radius = 0.25 * 10.0 * (std::abs(bulge) + 1.0 / std::abs(bulge));
    const Vec2 center{5.0, (bulge > 0 ? 1.0 : -1.0) * (radius - std::abs(rise))};
    for (int i = 0; i <= 1000; ++i) {
      const double x = 0.01 * i, dx = x - center.x;
      const Vec2 on_arc{x, center.y - (bulge > 0 ? 1.0 : -1.0) * std::sqrt(radius * radius - dx * dx)};
      ASSERT_LE(distance_to(plan.lines[0], on_arc, false), 1.001e-3) << bulge << " " << x;
    }
  }
  // What only rounding bends is straight, and asks nothing of the rest of its line.
  const FloorPlan noise = plan_of(entities(polyline("0", false, {{0, 0, 1e-8}, {10000, 0, 1.0}, {10000, 2000}})));
  ASSERT_EQ(noise.lines.size(), 1u);
  EXPECT_LT(noise.lines[0].size(), 100u);
}

TEST(FloorPlan, UnitsAreBelievedWhereTheSizeIsThatOfAHall) {
  TestDrawing drawing;
  drawing.entities = box("0", 0, 0, 900, 400);
  const std::string small = error_of(drawing.text());
  EXPECT_NE(small.find("this hall would be 0.9 m wide and 0.4 m deep in the unit that the drawing names, mm"), std::string::npos) << small;
  EXPECT_NE(small.find("22.9 m in inches"), std::string::npos) << small;
  EXPECT_NE(small.find("--unit"), std::string::npos);
  drawing.unit = "6";
  drawing.entities = box("0", 0, 0, 2000, 400);
  EXPECT_NE(error_of(drawing.text()).find("this hall would be 2 km wide"), std::string::npos);
  Options options;
  for (const auto& [unit, metres] : {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}, {"ft", 0.3048}}) {
    options.unit = unit;
    EXPECT_NEAR(bounding_box(plan_of(drawing.text(), options).obstacles[0]).high.x, 2000 * metres, 1e-9);
  }
  options.unit = "yd";
  EXPECT_NE(error_of(drawing.text(), options).find("\"yd\" is not known (allowed: mm, cm, m, in, ft)"), std::string::npos);
  for (const char* none : {"", "0", "3"}) {
    drawing.unit = none;
    EXPECT_NE(error_of(drawing.text()).find("give unit (--unit)"), std::string::npos);
  }
}

TEST(FloorPlan, RepairsAreTold) {
  const FloorPlan open = plan_of(entities(polyline("0", false, {{0, 0}, {9000, 0}, {9000, 5000}, {0, 5000}, {0, 4}})));
  EXPECT_EQ(open.obstacles.size(), 1u);
  EXPECT_SAYS(open, "1 polyline whose ends are up to 4 mm apart was closed");
  const FloorPlan crossing = plan_of(entities(polyline("0", true, {{0, 0}, {9000, 5000}, {9000, 0}, {0, 5000}})));
  EXPECT_EQ(crossing.obstacles.size(), 0u);
  ASSERT_EQ(crossing.lines.size(), 1u);
  EXPECT_EQ(crossing.lines[0].size(), 5u);
  EXPECT_SAYS(crossing, "a closed outline that encloses nothing clearly was taken as walls (a LWPOLYLINE on 0, edges");
  const FloorPlan twice = plan_of(entities(polyline("0", true, {{0, 0}, {9000, 0}, {9000, 0}, {9000, 5000}, {0, 5000}, {0, 0}})));
  ASSERT_EQ(twice.obstacles.size(), 1u);
  EXPECT_EQ(twice.obstacles[0].size(), 4u);
  const FloorPlan nothing = plan_of(entities(hall + line("0", 5, 5, 5, 5)));
  EXPECT_SAYS(nothing, "1 entity without length");
  const FloorPlan solid = plan_of(entities(groups({{0, "SOLID"}, {8, "0"}, {10, 0}, {20, 0}, {11, 4000}, {21, 0}, {12, 0}, {22, 4000}, {13, 4000}, {23, 4000}})));
  ASSERT_EQ(solid.obstacles.size(), 1u);
  EXPECT_NEAR(signed_area(solid.obstacles[0]), 16, 1e-9);
}

TEST(FloorPlan, WhatCannotBeReadIsRefusedInASentence) {
  const std::string good = entities(hall);
  struct Case {
    std::string text;
    const char* words;
  };
  TestDrawing selfish;
  selfish.block("A", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "B"}, {10, 0}, {20, 0}}));
  selfish.block("B", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "A"}, {10, 0}, {20, 0}}));
  selfish.entities = hall + groups({{0, "INSERT"}, {8, "0"}, {2, "A"}, {10, 0}, {20, 0}});
  TestDrawing bomb;
  bomb.block("A0", 0, 0, line("0", 0, 0, 1, 1));
  for (int i = 1; i < 9; ++i) {
    std::string ten;
    for (int k = 0; k < 10; ++k) ten += groups({{0, "INSERT"}, {8, "0"}, {2, fmt::format("A{}", i - 1)}, {10, k}, {20, 0}});
    bomb.block(fmt::format("A{}", i), 0, 0, ten);
  }
  bomb.entities = hall + groups({{0, "INSERT"}, {8, "0"}, {2, "A8"}, {10, 0}, {20, 0}});
  TestDrawing twice;
  twice.block("A", 0, 0, "");
  twice.block("a", 0, 0, "");
  for (const Case& c : std::vector<Case>{
           {"", "not a DXF drawing"},
           {"hello\nworld\n", "there is no group code"},
           {"AutoCAD Binary DXF\r\n\x1a", "binary DXF"},
           {"AC1032 and so on", "DWG"},
           {good.substr(0, good.size() / 2), "cut short"},
           {good.substr(0, good.rfind("  0\nEOF")), "cut short: it ends before its EOF"},
           {entities(hall + line("W", std::nan(""), 0, 1, 1)), "(LINE on layer W): \"nan\" is not a finite number"},
           {entities(hall + groups({{0, "LINE"}, {8, "W"}, {10, "1e999"}, {20, 0}, {11, 1}, {21, 1}})), "\"1e999\" is not a finite number"},
           {entities(hall + groups({{0, "LINE"}, {8, "W"}, {10, "x"}, {20, 0}, {11, 1}, {21, 1}})), "\"x\" is not a finite number"},
           {entities(hall + line("W", 1e300, 0, 1, 1)), "is out of range"},
           {entities(hall + groups({{0, "ARC"}, {8, "W"}, {10, 0}, {20, 0}, {40, 1}, {50, 1e300}, {51, 0}})), "is out of range"},
           {selfish.text(), "inserts itself"},
           {bomb.text(), "more than 3000000 entities"},
           {twice.text(), "defined twice"},
           {good.substr(0, good.rfind("  0\nEOF")) + groups({{0, "SECTION"}, {2, "BLOCKS"}, {0, "BLOCK"}, {2, "A"}, {0, "ENDBLK"}, {0, "ENDSEC"}, {0, "EOF"}}), "blocks stand after"},
           {entities(groups({{0, "TEXT"}, {8, "0"}, {1, "x"}})), "there is nothing to take"},
           {entities(hall + groups({{0, "SPLINE"}, {8, "W"}, {71, 3}, {40, 0}, {10, 0}, {20, 0}})), "control points"}}) {
    const std::string error = error_of(c.text);
    EXPECT_NE(error.find(c.words), std::string::npos) << error;
    EXPECT_EQ(error.find("dir/plan.dxf"), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(FloorPlan, AnUnknownBlockOnAFrozenLayerIsLeftOut) {
  TestDrawing drawing;
  drawing.layer("ICE", 1, 7);
  drawing.entities = hall + groups({{0, "INSERT"}, {8, "ICE"}, {2, "NAMED NOWHERE ELSE"}, {10, 0}, {20, 0}});
  const FloorPlan plan = plan_of(drawing.text());
  EXPECT_EQ(plan.obstacles.size(), 1u);
  EXPECT_SAYS(plan, "left out: 1 inserted block on a frozen layer");
}

TEST(FloorPlan, APolylineOfNoCornersDoesNotCostTheDrawing) {
  const FloorPlan plan = plan_of(entities(hall + polyline("0", false, {}) + polyline("0", true, {})));
  EXPECT_EQ(plan.obstacles.size(), 1u);
  EXPECT_EQ(plan.lines.size(), 0u);
}

/// A closed curve, sampled by centres and angles: nothing here is shared with what is tested.
struct TrueShape {
  std::string entity;
  std::vector<Vec2> samples;  // drawing units
};

TrueShape random_shape(Random& random, const std::string& layer) {
  constexpr int count = 4000;
  TrueShape shape;
  const Vec2 c{random.uniform(-5000, 5000), random.uniform(-5000, 5000)};
  const double r = std::pow(10.0, random.uniform(1.5, 4.3));
  switch (random.integer(0, 2)) {
    case 0:
      shape.entity = circle(layer, c.x, c.y, r);
      for (int i = 0; i < count; ++i) shape.samples.push_back(c + r * unit(two_pi * i / count));
      break;
    case 1: {
      const double turn = random.uniform(0, two_pi), ratio = random.uniform(0.05, 1.0);
      shape.entity = groups({{0, "ELLIPSE"}, {8, layer}, {10, c.x}, {20, c.y}, {11, r * std::cos(turn)}, {21, r * std::sin(turn)}, {40, ratio}, {41, 0}, {42, two_pi}});
      for (int i = 0; i < count; ++i) {
        const Vec2 u = unit(two_pi * i / count);
        shape.samples.push_back(c + r * u.x * unit(turn) + r * ratio * u.y * left_of(unit(turn)));
      }
      break;
    }
    default: {
      std::vector<Bent> corners;
      const auto n = random.integer(4, 8);
      const bool clockwise = random.integer(0, 1) == 1;
      for (int k = 0; k < n; ++k) {
        const Vec2 p = c + r * random.uniform(0.85, 1.0) * unit((clockwise ? -1 : 1) * two_pi * k / static_cast<double>(n));
        corners.push_back({p.x, p.y, random.integer(0, 3) == 0 ? 0.0 : random.uniform(-0.2, 0.35)});
      }
      shape.entity = polyline(layer, true, corners);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2 a{corners[k].x, corners[k].y}, b{corners[(k + 1) % corners.size()].x, corners[(k + 1) % corners.size()].y};
        const double angle = 4.0 * std::atan(corners[k].bulge);
        if (angle == 0.0) {
          for (int i = 0; i < 500; ++i) shape.samples.push_back(a + i / 500.0 * (b - a));
          continue;
        }
        const double radius = 0.5 * distance(a, b) / std::sin(0.5 * angle);
        const Vec2 center = 0.5 * (a + b) + radius * std::cos(0.5 * angle) / distance(a, b) * left_of(b - a);
        const double from = std::atan2(a.y - center.y, a.x - center.x);
        for (int i = 0; i < 1000; ++i) shape.samples.push_back(center + std::abs(radius) * unit(from + angle * i / 1000.0));
      }
    }
  }
  return shape;
}

/// Solids contain the true curve, boundaries lie within it, and neither leaves it by more than the tolerance: in inserts that stretch, turn and
/// mirror, with tolerances that are small and large against the curve.
TEST(FloorPlan, ClosedCurvesAreNeverSmallerThanTheyAre) {
  Random random = Random::stream(20, 0);
  int solids = 0, inner = 0;
  for (int run = 0; run < 400; ++run) {
    const bool boundary = run % 2 == 1;
    const TrueShape shape = random_shape(random, boundary ? "HALL" : "0");
    const double sx = random.uniform(0.3, 3.0) * (random.integer(0, 1) == 0 ? 1 : -1), sy = random.integer(0, 1) == 0 ? sx : random.uniform(0.3, 3.0), turn = random.uniform(-180, 180);
    TestDrawing drawing;
    drawing.block("B", 0, 0, shape.entity);
    drawing.entities = groups({{0, "INSERT"}, {8, "0"}, {2, "B"}, {10, 500}, {20, -700}, {41, sx}, {42, sy}, {50, turn}}) + line("0", 5e5, 5e5, 6e5, 5e5);
    Polyline curve;
    for (const Vec2 p : shape.samples) {
      const Vec2 u = unit(turn * pi / 180);
      curve.push_back(1e-3 * (Vec2{500, -700} + sx * p.x * u + sy * p.y * left_of(u)));
    }
    Options options;
    options.unit = "mm";
    options.tolerance = std::pow(10.0, random.uniform(-4, 0));
    if (boundary) options.boundary_layer = "HALL";
    const FloorPlan plan = plan_of(drawing.text(), options);
    const auto& rings = boundary ? plan.boundaries : plan.obstacles;
    ASSERT_EQ(rings.size(), 1u) << run << testing::PrintToString(plan.notes);
    const Ring& ring = rings[0];
    const double rounding = 1e-9;
    for (const Vec2 p : curve) {
      const bool inside = contains(ring, p);
      if (inside == boundary) {
        ASSERT_LE(distance_to(ring, p, true), rounding) << run << (boundary ? " outside of it is free" : " not all of it is solid");
      }
    }
    // As exact as the curve is sampled.
    double step = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) step = std::max(step, distance(curve[i], curve[(i + 1) % curve.size()]));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        ASSERT_LE(distance_to(curve, ring[i] + t * (ring[(i + 1) % ring.size()] - ring[i]), true), 1.0001 * options.tolerance + 0.01 * step) << run;
      }
    }
    ++(boundary ? inner : solids);
  }
  EXPECT_EQ(solids, 200);
  EXPECT_EQ(inner, 200);
}

/// Splines in blocks that are stretched to one side.
TEST(FloorPlan, StretchedSplinesAreSolidInWhole) {
  Random random = Random::stream(23, 0);
  for (int run = 0; run < 60; ++run) {
    constexpr int n = 7;
    // A closed cubic of seven control points about the origin, the first three of which come again, with knots a unit apart.
    std::vector<Vec2> controls;
    for (int k = 0; k < n; ++k) controls.push_back(random.uniform(700, 1000) * unit(two_pi * k / n));
    std::string spline = groups({{0, "SPLINE"}, {8, "P"}, {71, 3}});
    for (int k = 0; k < n + 7; ++k) spline += groups({{40, k}});
    for (int k = 0; k < n + 3; ++k) spline += groups({{10, controls[static_cast<std::size_t>(k % n)].x}, {20, controls[static_cast<std::size_t>(k % n)].y}});
    const double sx = random.uniform(5.0, 20.0), turn = random.uniform(-180, 180);
    TestDrawing drawing;
    drawing.block("S", 0, 0, groups({{0, "INSERT"}, {8, "0"}, {2, "T"}, {10, 0}, {20, 0}, {50, turn}}));
    drawing.block("T", 0, 0, spline);
    drawing.entities = groups({{0, "INSERT"}, {8, "0"}, {2, "S"}, {10, 0}, {20, 0}, {41, sx}, {42, run % 2 == 0 ? 1 : -1}}) + line("W", 0, 30000, 20000, 30000);
    Options options;
    options.tolerance = std::pow(10.0, random.uniform(-3, 0));
    const FloorPlan plan = plan_of(drawing.text(), options);
    ASSERT_EQ(plan.obstacles.size(), 1u) << testing::PrintToString(plan.notes);
    EXPECT_FALSE(says(plan, "convex hull"));
    for (int k = 0; k < n; ++k) {
      const auto c = [&](int i) { return controls[static_cast<std::size_t>((k + i) % n)]; };
      for (int i = 0; i < 300; ++i) {
        const double t = i / 300.0, s = 1 - t;
        const Vec2 p = (1.0 / 6.0) * (s * s * s * c(0) + (3 * t * t * t - 6 * t * t + 4) * c(1) + (-3 * t * t * t + 3 * t * t + 3 * t + 1) * c(2) + t * t * t * c(3));
        const Vec2 turned = p.x * unit(turn * pi / 180) + p.y * left_of(unit(turn * pi / 180));
        const Vec2 at{1e-3 * sx * turned.x, (run % 2 == 0 ? 1e-3 : -1e-3) * turned.y};
        ASSERT_TRUE(contains(plan.obstacles[0], at) || distance_to(plan.obstacles[0], at, true) < 1e-9) << run << ", by " << distance_to(plan.obstacles[0], at, true);
        ASSERT_LE(distance_to(plan.obstacles[0], at, true), options.tolerance * (1 + 1e-9));
      }
    }
  }
}

TEST(FloorPlan, ACoarseToleranceLosesNoPillar) {
  const std::string spline = groups({{0, "SPLINE"}, {8, "P"}, {71, 3}, {40, 0}, {40, 0}, {40, 0}, {40, 0}, {40, 1}, {40, 1}, {40, 1}, {40, 1}, {10, 9000}, {20, 0}, {10, 9400}, {20, 500}, {10, 8600},
                                     {20, 500}, {10, 9000}, {20, 0}});
  const std::string crescent = polyline("P", true, {{12000, 0, 0.5}, {12400, 0, -0.4}});
  const std::string disc_by_arc = groups({{0, "ARC"}, {8, "P"}, {10, 15000}, {20, 0}, {40, 200}, {50, 30}, {51, 390}});
  for (const double tolerance : {1e-3, 0.05, 0.4, 1.0}) {
    Options options;
    options.tolerance = tolerance;
    const FloorPlan plan = plan_of(entities(line("W", 0, 3000, 20000, 3000) + circle("P", 0, 0, 200) + groups({{0, "ELLIPSE"}, {8, "P"}, {10, 3000}, {20, 0}, {11, 200}, {21, 0}, {40, 0.5}, {41, 0}, {42, 6.2831853}}) +
                                            polyline("P", true, {{6000, 0, 0.02}, {6400, 0, 0.0}}) + spline + crescent + disc_by_arc), options);
    ASSERT_EQ(plan.obstacles.size(), 6u) << tolerance;
    EXPECT_EQ(plan.lines.size(), 1u);
    EXPECT_FALSE(says(plan, "without length"));
    for (int i = 0; i < 360; ++i) {
      const Vec2 u = unit(i * pi / 180);
      EXPECT_TRUE(contains(plan.obstacles[0], 0.1999999 * u));
      EXPECT_TRUE(contains(plan.obstacles[1], {3 + 0.1999999 * u.x, 0.0999999 * u.y}));
      EXPECT_TRUE(contains(plan.obstacles[5], Vec2{15, 0} + 0.1999999 * u));
    }
    EXPECT_TRUE(contains(plan.obstacles[2], {6.2, -0.00399}));  // a rise of 4 mm
    for (int i = 1; i < 1000; ++i) {
      const double t = 1e-3 * i, s = 1 - t;
      const Vec2 p{9 + 3 * s * s * t * 0.4 - 3 * s * t * t * 0.4, 0.5 * (3 * s * s * t + 3 * s * t * t)};
      EXPECT_TRUE(contains(plan.obstacles[3], p) || distance_to(plan.obstacles[3], p, true) < 1e-9) << tolerance << " " << t;
    }
    EXPECT_TRUE(contains(plan.obstacles[4], {12.2, -0.095}));  // between −0.1 and −0.08
  }
  Options coarse;
  coarse.tolerance = 1.0;
  EXPECT_SAYS(plan_of(entities(hall + circle("P", 0, 0, 200)), coarse), "chords no farther than 1000 mm from them: solids contain their outline");
  for (const auto& [tolerance, words] : {std::pair{0.0996, "than 100 mm"}, {0.4, "than 400 mm"}, {0.00996, "than 10 mm"}, {2.5e-5, "than 0.025 mm"}}) {
    coarse.tolerance = tolerance;
    EXPECT_SAYS(plan_of(entities(hall + circle("P", 0, 0, 200)), coarse), words);
  }
}

TEST(FloorPlan, ABoundaryOfLinesAndArcsLiesWithinThem) {
  // A hall with one end that bulges out, one that bulges in.
  const std::string hall_of_arcs = line("HALL", 0, 0, 20000, 0) + groups({{0, "ARC"}, {8, "HALL"}, {10, 20000}, {20, 5000}, {40, 5000}, {50, 270}, {51, 90}}) + line("HALL", 20000, 10000, 0, 10000) +
                                   groups({{0, "ARC"}, {8, "HALL"}, {10, -4898.979485566356}, {20, 5000}, {40, 7000}, {50, -45.58469140280703}, {51, 45.58469140280703}});
  for (const double tolerance : {1e-3, 0.1, 1.0}) {
    Options options;
    options.boundary_layer = "HALL";
    options.tolerance = tolerance;
    const FloorPlan plan = plan_of(entities(hall_of_arcs), options);
    ASSERT_EQ(plan.boundaries.size(), 1u);
    for (int i = 0; i <= 1000; ++i) {
      const Vec2 u = unit((-0.5 + 1e-3 * i) * pi);
      EXPECT_FALSE(contains(plan.boundaries[0], Vec2{20, 5} + 5.0000001 * u));
      const Vec2 inward = Vec2{-4.898979485566356, 5} + 7.0 * unit((-1.0 + 2e-3 * i) * 45.58469140280703 * pi / 180);
      EXPECT_TRUE(!contains(plan.boundaries[0], inward) || distance_to(plan.boundaries[0], inward, true) < 1e-9) << tolerance << " " << i;
      EXPECT_LE(distance_to(plan.boundaries[0], Vec2{20, 5} + 5.0 * u, true), tolerance);
      EXPECT_LE(distance_to(plan.boundaries[0], inward, true), tolerance);
    }
  }
}

/// Of a crescent that is thinner than the tolerance the inner chords of one face lie beyond the other: a ring that is simple, and nowhere within it.
TEST(FloorPlan, AThinCrescentBoundsNothingOutsideOfIt) {
  for (const double tolerance : {1e-3, 0.05, 0.3, 1.0}) {
    Options options;
    options.boundary_layer = "HALL";
    options.tolerance = tolerance;
    const FloorPlan plan = plan_of(entities(polyline("HALL", true, {{0, 0, 0.3}, {4000, 0, -0.24}})), options);
    ASSERT_EQ(plan.boundaries.size(), 1u);
    EXPECT_GT(signed_area(plan.boundaries[0]), 0.0);
    for (const Vec2 p : plan.boundaries[0]) {
      const auto rise = [&](double bulge) {  // below the chord at p
        const double radius = bulge + 1.0 / bulge, dx = p.x - 2.0;
        return std::sqrt(radius * radius - dx * dx) - (radius - 2.0 * bulge);
      };
      EXPECT_LE(-p.y, rise(0.3) + 1e-9) << tolerance;
      EXPECT_GE(-p.y, rise(0.24) - 1e-9) << tolerance;
    }
  }
}

/// A gap between two round faces that is narrower than the tolerance, and one that narrows to nothing.
TEST(FloorPlan, SolidsWithNarrowGapsStaySolid) {
  Options options;
  options.tolerance = 0.05;
  // A ring of 1 m with a slit of 20 mm.
  const FloorPlan slit = plan_of(entities(hall + polyline("0", true, {{6000, 10, 0}, {7000, 10, 0.98}, {7000, -10, 0}, {6000, -10, -0.97}})), options);
  ASSERT_EQ(slit.obstacles.size(), 2u);
  EXPECT_FALSE(says(slit, "convex hull"));
  // A half disc that rests on the edge of a block: the chords of its outside lie on that edge.
  const FloorPlan cusp = plan_of(entities(hall + polyline("0", true, {{0, 0}, {4000, 0}, {4000, 2000}, {2000, 2000, 1}, {2000, 4000}, {0, 4000}})), options);
  ASSERT_EQ(cusp.obstacles.size(), 2u);
  EXPECT_TRUE(contains(cusp.obstacles[1], {2.99, 3}));
  EXPECT_SAYS(cusp, "1 solid with a notch too narrow to be drawn was taken as its convex hull");
}

TEST(FloorPlan, BlocksThatEnlargeWithoutEndAreRefused) {
  // Twenty-seven levels of 10¹² each: the size is no number any more.
  TestDrawing drawing;
  for (int i = 0; i < 27; ++i) {
    const std::string inner = i == 0 ? circle("0", 0, 0, 1) : groups({{0, "INSERT"}, {8, "0"}, {2, fmt::format("N{}", i - 1)}, {10, 0}, {20, 0}, {41, 1e12}, {42, 1e12}});
    drawing.block(fmt::format("N{}", i), 0, 0, inner);
  }
  drawing.entities = groups({{0, "INSERT"}, {8, "0"}, {2, "N26"}, {10, 0}, {20, 0}}) + hall;
  EXPECT_NE(error_of(drawing.text()).find("is enlarged more than 1e+12 times where it is inserted"), std::string::npos);
}

TEST(FloorPlan, LayerNamesOfOldAndNewFiles) {
  const FloorPlan plan = plan_of(entities(hall + line("B\xC3\xB6" "den", 0, 0, 1000, 5) + line("T\xFCr", 0, 0, 1000, 6) + line("Stra\\U+00DFe", 0, 0, 1000, 7)));
  EXPECT_SAYS(plan, "1 LINE on B\xC3\xB6" "den");
  EXPECT_SAYS(plan, "1 LINE on T\xC3\xBCr");
  EXPECT_SAYS(plan, "1 LINE on Stra\xC3\x9F" "e");
}

/// Outside drawings.
class OutsideDrawings : public testing::Test {
 protected:
  static std::string read(const char* file) {
    const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
    if (data == nullptr) return {};
    std::ifstream in{fs::path{data} / "dxf" / file, std::ios::binary};
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }
};
#define READ_OR_SKIP(text, file)                                                                     \
  const std::string text = read(file);                                                               \
  if (text.empty()) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA): " << (file)

Box box_of(const FloorPlan& plan) {
  std::vector<Vec2> all;
  for (const auto* lists : {&plan.obstacles, &plan.lines}) {
    for (const auto& list : *lists) all.insert(all.end(), list.begin(), list.end());
  }
  return bounding_box(all);
}

TEST_F(OutsideDrawings, AHouseDrawnInInchesThatSaysMillimetres) {
  READ_OR_SKIP(text, "floorplan.dxf");
  const std::string error = error_of(text);
  EXPECT_NE(error.find("this hall would be 0.803 m wide"), std::string::npos) << error;
  EXPECT_NE(error.find("20.4 m in inches"), std::string::npos) << error;
  Options options;
  options.unit = "in";
  const FloorPlan plan = plan_of(text, options);
  EXPECT_SAYS(plan, "168 LINE and 7 LWPOLYLINE on xref-Bishop-Overland-08$0$A-WALL");
  EXPECT_SAYS(plan, "63 DIMENSION, 13 HATCH");
  options.obstacle_layers = {"xref-Bishop-Overland-08$0$A-GARAGE-DOOR"};
  const FloorPlan door = plan_of(text, options);
  const Vec2 size = box_of(door).high - box_of(door).low;
  EXPECT_NEAR(std::max(size.x, size.y), 16 * 0.3048, 0.01);  // a door of 16 ft
}

TEST_F(OutsideDrawings, APlateInTheOldestFormat) {
  READ_OR_SKIP(text, "issue42.dxf");
  EXPECT_NE(error_of(text).find("names no unit"), std::string::npos);
  Options options;
  options.unit = "mm";
  options.tolerance = 1e-5;
  const FloorPlan plan = plan_of(text, options);
  const Vec2 size = box_of(plan).high - box_of(plan).low;
  EXPECT_NEAR(size.x, 0.284, 1e-4);
  EXPECT_NEAR(size.y, 0.208, 1e-4);
  EXPECT_SAYS(plan, "11 CIRCLE, 10 LINE, 6 ARC and 1 POLYLINE on 0");
  EXPECT_SAYS(plan, "13 DIMENSION on ADSK_CONSTRAINTS");
}

TEST_F(OutsideDrawings, ABlockTurnedAndStretched) {
  READ_OR_SKIP(text, "blocks1.dxf");
  Options options;
  options.unit = "mm";
  options.tolerance = 1e-5;
  const FloorPlan plan = plan_of(text, options);
  // The header's own extent of the drawing.
  const Box box = box_of(plan);
  EXPECT_NEAR(box.low.x, -0.01121320343559643, 1e-5);
  EXPECT_NEAR(box.low.y, 0.01483563916494109, 1e-5);
  EXPECT_NEAR(box.high.x, 0.1326414252294443, 1e-5);
  EXPECT_NEAR(box.high.y, 0.1177817459305202, 1e-5);
  ASSERT_EQ(plan.obstacles.size(), 2u);
  EXPECT_NEAR(signed_area(plan.obstacles[1]) / signed_area(plan.obstacles[0]), 2.0, 0.01);  // the circle became an ellipse twice as long
}

TEST_F(OutsideDrawings, AClosedAndAnOpenPolyline) {
  READ_OR_SKIP(text, "lwpolylines.dxf");
  Options options;
  options.unit = "mm";
  const FloorPlan plan = plan_of(text, options);
  EXPECT_EQ(plan.obstacles.size(), 1u);
  EXPECT_EQ(plan.lines.size(), 1u);
  EXPECT_NEAR(box_of(plan).high.x, 0.080, 1e-6);
  EXPECT_NEAR(box_of(plan).high.y, 0.120, 1e-6);
}

TEST_F(OutsideDrawings, EveryKindOfEntity) {
  READ_OR_SKIP(text, "entities.dxf");
  Options options;
  options.unit = "mm";
  const FloorPlan plan = plan_of(text, options);
  EXPECT_SAYS(plan, "29 LINE and 29 LWPOLYLINE on boxes");
  EXPECT_SAYS(plan, "14 ARC, 12 LINE, 9 CIRCLE, 6 SPLINE, 3 ELLIPSE and 3 LWPOLYLINE on entities");
  options.obstacle_layers = {"boxes"};
  EXPECT_EQ(plan_of(text, options).obstacles.size(), 29u);
}

TEST_F(OutsideDrawings, PaperSpaceIsNoObstacle) {
  READ_OR_SKIP(text, "testModelPaperSpace.dxf");
  Options options;
  options.unit = "in";
  const FloorPlan plan = plan_of(text, options);
  EXPECT_EQ(plan.obstacles.size(), 0u);  // the circle of the paper
  EXPECT_EQ(plan.lines.size(), 4u);      // six lines, two of them without length
  EXPECT_SAYS(plan, "3 entities of paper space");
  EXPECT_SAYS(plan, "2 entities without length");
}

TEST(FloorPlan, FullAMillionEntitiesAreReadInSeconds) {
  TestDrawing drawing;
  drawing.entities.reserve(80'000'000);
  for (int i = 0; i < 1'000'000; ++i) drawing.entities += line("W", i % 1000 * 20, i / 1000 * 20, i % 1000 * 20 + 15, i / 1000 * 20 + 10);
  EXPECT_EQ(plan_of(drawing.text()).lines.size(), 1'000'000u);
}

}  // namespace
}  // namespace waywright::dxf
