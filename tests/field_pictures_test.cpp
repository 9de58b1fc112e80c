// The field in the picture of a plan: there, under the map, within its frame, small, and the same each time.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/raster.hpp"
#include "waywright/report/report.hpp"

namespace waywright {
namespace {

struct Drawn {
  Plan plan;
  std::string svg, html;
};

Drawn drawn(const std::string& example, const std::string& planner = "") {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/fields/" + example + ".json").value();
  if (!planner.empty()) s.planner = {planner, {}};
  const Problem problem = Problem::prepare(std::move(s)).value();
  Drawn d;
  d.plan = *solve(problem);
  d.plan.timing = {};
  d.svg = plan_svg(problem, d.plan);
  d.html = report_html(problem, d.plan);
  return d;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

/// What an attribute of the element with this class holds; of the first.
std::string attribute(const std::string& svg, const std::string& style, const std::string& name) {
  const std::size_t at = svg.find("class=\"" + style + "\""), end = svg.find('>', at), from = svg.find(" " + name + "=\"", at);
  if (at == std::string::npos || from == std::string::npos || from > end) return {};
  return svg.substr(from + name.size() + 3, svg.find('"', from + name.size() + 3) - from - name.size() - 3);
}

/// Points of an SVG path of M, l, L and z.
std::vector<Vec2> points_of(const std::string& d) {
  std::vector<Vec2> points;
  Vec2 at{};
  for (std::size_t i = 0; i < d.size();) {
    const char how = d[i++];
    if (how == 'z') continue;
    std::size_t used = 0;
    const double x = std::stod(d.substr(i, 24), &used);
    i += used;
    const double y = std::stod(d.substr(i, 24), &used);
    i += used;
    at = how == 'l' ? at + Vec2{x, y} : Vec2{x, y};
    points.push_back(at);
  }
  return points;
}

TEST(FieldPictures, ShowTintsContoursStreamlinesAndTheTrap) {
  const Drawn d = drawn("point_trap");
  EXPECT_EQ(d.plan.status, Status::no_path);
  for (const std::string* text : {&d.svg, &d.html}) {
    for (const char* part : {"class=\"fieldheat\"", "class=\"contour\"", "class=\"stream\"", "class=\"streamhead\"", "class=\"trapmark\"", "potential, from low at the goal", "equal values", "the way down", "the trap: the run ended here"}) {
      EXPECT_NE(text->find(part), std::string::npos) << part;
    }
  }
}

// The number of saddles that the explanation tells is the number of marks, one more stands in the legend.
TEST(FieldPictures, MarkAsManySaddlesAsThePlannerTells) {
  const Drawn d = drawn("mecanum_discs");
  ASSERT_EQ(d.plan.status, Status::solved);
  bool told = false;
  for (const std::string& sentence : d.plan.explanation) told = told || sentence.find("finds 3 saddles") != std::string::npos;
  ASSERT_TRUE(told);
  EXPECT_EQ(count_of(d.svg, "class=\"saddle\""), 3u + 1u);
  EXPECT_NE(d.svg.find("3 saddles: the way down parts"), std::string::npos);
  EXPECT_EQ(count_of(d.svg, "class=\"minimum\""), 0u);
}

TEST(FieldPictures, LieUnderTheMapAndThePathWithinTheFrame) {
  for (const auto& [example, planner] : {std::pair{"point_trap", "harmonic"}, {"point_trap", "wavefront"}, {"mecanum_discs", ""}, {"mecanum_warehouse", ""}, {"point_trap", ""}}) {
    const Drawn d = drawn(example, planner);
    const std::size_t heat = d.svg.find("class=\"fieldheat\""), stream = d.svg.find("class=\"streamhead\"");
    ASSERT_NE(heat, std::string::npos) << example << planner;
    for (const char* above : {"class=\"obstacle\"", "class=\"cell\"", "class=\"boundary\"", "class=\"fwd\"", "class=\"sweep\"", "class=\"vehicle\""}) {
      const std::size_t at = d.svg.find(above);
      if (at != std::string::npos) {
        EXPECT_GT(at, heat) << above;
        EXPECT_GT(at, stream) << above;
      }
    }
    const double width = std::stod(attribute(d.svg, "frame", "width")), height = std::stod(attribute(d.svg, "frame", "height")), left = std::stod(attribute(d.svg, "frame", "x"));
    const auto is_within = [&](Vec2 p, double off) { return p.x > left - off && p.x < left + width + off && p.y > -off && p.y < height + off; };
    for (const char* line : {"contour", "stream", "streamhead"}) {
      const std::vector<Vec2> points = points_of(attribute(d.svg, line, "d"));
      EXPECT_GT(points.size(), 20u) << line;
      for (const Vec2 p : points) EXPECT_TRUE(is_within(p, 4.0)) << line << " " << p.x << ", " << p.y;
    }
    const double x = std::stod(attribute(d.svg, "fieldheat", "x")), y = std::stod(attribute(d.svg, "fieldheat", "y"));
    EXPECT_TRUE(is_within({x, y}, 6.0));
    EXPECT_TRUE(is_within({x + std::stod(attribute(d.svg, "fieldheat", "width")), y + std::stod(attribute(d.svg, "fieldheat", "height"))}, 6.0));
    EXPECT_LT(d.svg.size(), 400'000u) << example;
    const std::size_t field = attribute(d.svg, "fieldheat", "href").size() + attribute(d.svg, "contour", "d").size() + attribute(d.svg, "stream", "d").size() + attribute(d.svg, "streamhead", "d").size();
    EXPECT_LT(field, 200'000u) << example << planner;
  }
}

TEST(FieldPictures, AreTheSameEachTime) {
  const Drawn one = drawn("mecanum_discs"), other = drawn("mecanum_discs");
  EXPECT_EQ(one.svg, other.svg);
  EXPECT_EQ(one.html, other.html);
}

TEST(FieldPictures, OfOtherPlannersHaveNone) {
  const Drawn d = drawn("point_trap", "visibility_graph");
  EXPECT_EQ(d.plan.field, nullptr);
  EXPECT_EQ(d.svg.find("class=\"fieldheat\""), std::string::npos);
  EXPECT_EQ(d.svg.find("equal values"), std::string::npos);
}

TEST(Raster, IsAPng) {
  const std::string address = png_address(3, 2, {0, 1, 2, 2, 1, 0}, {{255, 0, 0, 255}, {0, 255, 0, 128}, {0, 0, 0, 0}});
  EXPECT_EQ(address.rfind("data:image/png;base64,iVBORw0KGgo", 0), 0u);
  EXPECT_EQ((address.size() - std::string{"data:image/png;base64,"}.size()) % 4, 0u);
}

}  // namespace
}  // namespace waywright
