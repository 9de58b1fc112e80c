#include "waywright/io/svg_map.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "waywright/io/scenario_io.hpp"
#include "waywright/io/svg_path.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

std::string drawing(const std::string& inside, const std::string& attributes = "viewBox='0 0 10 8'") {
  return "<?xml version='1.0'?><svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + inside + "</svg>";
}

std::string refusal(const std::string& text) {
  const auto map = decode_svg_map(text, "s.svg", 1.0);
  return map ? "accepted" : map.error().message();
}

void expect_ring(const Ring& ring, const Ring& expected) {
  ASSERT_EQ(ring.size(), expected.size());
  for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_LT(distance(ring[i], expected[i]), 1e-12) << i << ": " << ring[i].x << ", " << ring[i].y;
}

TEST(SvgMap, ShapesAreTakenFromTheLowerLeftCorner) {
  const Map map = decode_svg_map(drawing("<rect x='1' y='2' width='3' height='1'/><polygon points='5,5 6,5 6,6'/><path d='M 1 7 h2 v1z'/><line x1='0' y1='0' x2='10' y2='8'/>"
                                         "<polyline fill='none' points='0 0 1 1 2 0'/>"),
                                 "s.svg", 2.0)
                      .value();
  ASSERT_EQ(map.obstacles.size(), 3U);
  // y downwards becomes upwards, so that the order of corners turns over.
  expect_ring(map.obstacles[0], {{2, 12}, {2, 10}, {8, 10}, {8, 12}});
  expect_ring(map.obstacles[1], {{10, 6}, {12, 4}, {12, 6}});
  expect_ring(map.obstacles[2], {{2, 2}, {6, 0}, {6, 2}});
  ASSERT_EQ(map.lines.size(), 2U);
  expect_ring(map.lines[0], {{0, 16}, {20, 0}});
  expect_ring(map.lines[1], {{0, 16}, {2, 14}, {4, 16}});
}

TEST(SvgMap, TransformsAreApplied) {
  const auto first = [](const std::string& inside) { return decode_svg_map(drawing(inside, ""), "s.svg", 1.0).value().obstacles.front(); };
  const std::string square = "<path d='M0 0H1V1H0Z'/>";
  expect_ring(first("<g transform='translate(2, 3)'>" + square + "</g>"), {{2, -3}, {2, -4}, {3, -4}, {3, -3}});
  expect_ring(first("<g transform='translate(2) scale(2,-1)'>" + square + "</g>"), {{2, 0}, {4, 0}, {4, 1}, {2, 1}});
  expect_ring(first("<g transform='translate(1 1)'><g transform='rotate(90)'>" + square + "</g></g>"), {{1, -1}, {0, -1}, {0, -2}, {1, -2}});
  expect_ring(first("<g transform='rotate(180 1 1)'>" + square + "</g>"), {{2, -2}, {2, -1}, {1, -1}, {1, -2}});
  expect_ring(first("<g transform='matrix(1 0 1 1 0 0)'>" + square + "</g>"), first("<g transform='skewX(45)'>" + square + "</g>"));
}

TEST(SvgPath, CommandsAreThoseOfSvg) {
  const auto points = [](const char* d) { return svg::path(d).value().at(0).points; };
  EXPECT_EQ(points("m1,1 2-.5l-1e0.5.25.75z"), (std::vector<Vec2>{{1, 1}, {3, 0.5}, {2, 1}, {2.25, 1.75}}));
  EXPECT_EQ(points("M1 1L2 1 3 3h-1v+2"), (std::vector<Vec2>{{1, 1}, {2, 1}, {3, 3}, {2, 3}, {2, 5}}));
  EXPECT_EQ(svg::path("M0 0h1v1zl5 5")->size(), 2U);
  EXPECT_EQ(svg::path("M0 0h1v1z m5 5 h1 v1 z")->at(1).points.front(), (Vec2{5, 5}));
  for (const char* bad : {"1 1", "M", "M 1", "M1 1 L", "M1 1 L x", "Z", "L1 1", "M1 1 h 1e999", "M1 1 C 1 1 2 2 3 3", "M1 1 B 2", "M 1 1 z 3", "M+-1 1"}) EXPECT_FALSE(svg::path(bad)) << bad;
  for (const char* bad : {"turn(3)", "scale()", "rotate(1 2)", "matrix(1 2 3)", "translate(1", "translate(nan)", "skewX(90)x"}) EXPECT_FALSE(svg::transform(bad)) << bad;
}

TEST(SvgMap, WhatIsNotSeenIsLeftOut) {
  const Map map = decode_svg_map(drawing("<defs><path d='M0 0C1 1 2 2 3 3'/></defs><text>a</text><g style='display:none'><circle r='1'/></g><metadata><x:y xmlns:x='z'/></metadata>"
                                         "<path style='stroke:red; fill : none' d='M1 1h1v1z'/><path fill='none' style='fill:red' d='M1 1h1v1'/>"),
                                 "s.svg", 1.0)
                      .value();
  EXPECT_EQ(map.lines.size(), 1U);
  EXPECT_EQ(map.lines[0].size(), 4U);
  EXPECT_EQ(map.obstacles.size(), 1U);
  EXPECT_EQ(map.notes, (std::vector<std::string>{"left out: hidden elements (1)", "left out: texts (1)"}));
}

TEST(SvgMap, BadOnesAreRefusedInASentence) {
  EXPECT_EQ(refusal(drawing("<path id='p7' d='M0 0C1 1 2 2 3 3'/>")), "s.svg: line 1 (p7): the path has a curve (C) (allowed: straight lines: M, L, H, V, Z and their small letters)");
  EXPECT_NE(refusal(drawing("<circle r='1'/>")).find("<circle> is not read"), std::string::npos);
  EXPECT_NE(refusal(drawing("<use href='#a'/>")).find("<use> is not read"), std::string::npos);
  EXPECT_NE(refusal(drawing("<rect width='3' height='1' rx='.1'/>")).find("round corners"), std::string::npos);
  EXPECT_NE(refusal(drawing("<path d='M0 0 L2 2 L2 0 L0 2z'/>")).find("cross"), std::string::npos);
  EXPECT_NE(refusal(drawing("<path d='M0 0h9v9h-9z M1 1h1v1h-1z'/>")).find("(a hole)"), std::string::npos);
  EXPECT_NE(refusal(drawing("")).find("nothing in it"), std::string::npos);
  EXPECT_NE(refusal("<html/>").find("document of <html>"), std::string::npos);
  EXPECT_NE(refusal("<svg><g></svg>").find("not valid XML"), std::string::npos);
  EXPECT_NE(refusal("no XML").find("not valid XML"), std::string::npos);
  EXPECT_NE(refusal("<!DOCTYPE svg [<!ENTITY a 'aaaa'>]><svg>&a;</svg>").find("entities"), std::string::npos);
  EXPECT_NE(refusal(drawing("<path d='M0 0h1v1z'/>", "viewBox='0 0 0 1'")).find("viewBox"), std::string::npos);
  EXPECT_NE(refusal(drawing("<g transform='scale(1e300)'><g transform='scale(1e300)'><rect width='1' height='1'/></g></g>")).find("it reaches"), std::string::npos);
  // Infinite times nothing is no number, in y alone too.
  for (const char* scale : {"scale(1,1e200)", "scale(1e200,1)"}) {
    const std::string both = std::string{"<g transform='"} + scale + "'><g transform='" + scale + "'>";
    EXPECT_NE(refusal(drawing(both + "<path fill='none' d='M0 0L0 0L0 0'/></g></g>")).find("it reaches"), std::string::npos) << scale;
  }
  std::string deep;
  for (int i = 0; i < 200; ++i) deep += "<g>";
  EXPECT_NE(refusal(drawing(deep)).find("nested too deeply"), std::string::npos);
}

TEST(SvgMap, BenchMrScenesAreRead) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path{data} / "bench_mr")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  const std::filesystem::path folder = std::filesystem::path{data} / "bench_mr" / "polygon_mazes";
  struct Scene {
    const char* file;
    std::size_t polygons;
    double width, height;  // m, as the files' pages have them
  };
  for (const Scene& scene : {Scene{"parking1.svg", 13, 18.658882, 14.412246}, Scene{"parking3.svg", 18, 36.6, 26.7}, Scene{"warehouse.svg", 88, 85.772506, 80.471351}, Scene{"car.svg", 1, 4.2533908, 2.433861},
                             Scene{"warehouse_robot.svg", 1, 3.79, 3.62}}) {
    SCOPED_TRACE(scene.file);
    const auto map = read_map(folder / scene.file);
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(map->obstacles.size(), scene.polygons);
    EXPECT_TRUE(map->lines.empty());
    World world{*map};
    world.build();
    // Pages were fitted to what is drawn.
    EXPECT_NEAR(world.bounds().low.x, 0.0, 0.1);
    EXPECT_NEAR(world.bounds().low.y, 0.0, 0.1);
    EXPECT_NEAR(world.bounds().high.x, scene.width, 0.1);
    EXPECT_NEAR(world.bounds().high.y, scene.height, 0.1);
  }
}

}  // namespace
}  // namespace waywright
