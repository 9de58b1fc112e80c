// The curves of single entities, as their groups give them.
#include "waywright/dxf/entity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/angle.hpp"
#include "waywright/dxf/test_drawing.hpp"

namespace waywright::dxf {
namespace {

using namespace waywright::test;

Chain curve_in(const std::string& entity) {
  TestDrawing drawing;
  drawing.entities = entity;
  const std::string text = drawing.text();
  Chain chain;
  const auto error = walk(text, "test.dxf", [&](Section section, const Item& item) {
    if (section == Section::entities) chain = curve_of(item);
    return std::optional<InputError>{};
  });
  EXPECT_FALSE(error);
  return chain;
}

Chain arc(const char* from, const char* to, double radius = 2.0) { return curve_in(groups({{0, "ARC"}, {8, "0"}, {10, 1}, {20, 2}, {40, radius}, {50, from}, {51, to}})); }
Chain ellipse(const std::string& from, const std::string& to, int up = 1) {
  return curve_in(groups({{0, "ELLIPSE"}, {8, "0"}, {10, 1}, {20, 2}, {11, 4}, {21, 0}, {40, 0.5}, {41, from}, {42, to}, {210, 0}, {220, 0}, {230, up}}));
}

bool is_whole(const Chain& chain) { return chain.size() == 9 && chain.front().at == chain.back().at; }

TEST(Entity, WholeTurnsOfFewDigitsAndRounding) {
  for (const auto& [from, to] : {std::pair{"0", "360"}, {"30", "390"}, {"45.7", "405.7"}, {"-14.3", "345.7"}, {"0.1", "360.1"}, {"12.34", "372.34"}, {"5", "5"}, {"-180", "180"}, {"0", "360.000000001"}, {"360", "0"}}) {
    EXPECT_TRUE(is_whole(arc(from, to))) << from << " to " << to;
  }
  for (const auto& [from, to] : {std::pair{"0", "6.283185307179586"}, {"0", "6.283185308"}, {"0", "6.283186"}, {"0", "6.28319"}, {"-3.14159266", "3.14159266"}, {"0", "0"}, {"6.283185307", "0"}}) {
    EXPECT_TRUE(is_whole(ellipse(from, to))) << from << " to " << to;
    EXPECT_TRUE(is_whole(ellipse(from, to, -1))) << from << " to " << to;
  }
  // Too short by some digits: not quite closed, which the closing distance mends.
  const Chain open = ellipse("0", "6.28318");
  EXPECT_EQ(open.size(), 9u);
  EXPECT_LT(distance(open.front().at, open.back().at), 2e-5);
}

TEST(Entity, ShortArcsStayShort) {
  const double degree = pi / 180.0;
  for (const auto& [from, to, sweep] : {std::tuple{"359.999", "0.001", 0.002}, {"-0.001", "0.001", 0.002}, {"10", "10.0000001", 1e-7}, {"350", "370", 20.0}, {"350", "10", 20.0}, {"10", "350", 340.0}, {"-10", "10", 20.0},
                                        {"730", "740", 10.0}, {"-350", "20", 10.0}}) {
    const Chain chain = arc(from, to, 1000.0);
    const double angle = sweep * degree;
    ASSERT_GE(chain.size(), 3u);
    EXPECT_NEAR(distance(chain.front().at, chain.back().at), 2000.0 * std::sin(0.5 * angle), 1e-9) << from << " to " << to;
    EXPECT_EQ(chain.size(), sweep > 270.0 ? 9u : 3u);
  }
}

TEST(Entity, EllipsesGoTheWayOfTheirNormal) {
  // From the end of the major axis over a quarter: seen from below, to the other end of the minor one.
  const Chain up = ellipse("0", "1.5707963267948966"), down = ellipse("0", "1.5707963267948966", -1);
  EXPECT_NEAR(distance(up.back().at, {1.0, 4.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(down.back().at, {1.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(up[1].at, {5.0, 4.0}), 0.0, 1e-12);
  // The later angle first: on through the end of the turn.
  const Chain on = ellipse("4.71238898038469", "0");
  EXPECT_NEAR(distance(on.front().at, {1.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(on.back().at, {5.0, 2.0}), 0.0, 1e-12);
}

TEST(Entity, PolylinesCloseThroughTheirLastBulge) {
  const std::vector<Bent> corners{{0, 0, 1.0}, {2, 0, 1.0}};
  const Chain closed = curve_in(polyline("0", true, corners)), open = curve_in(polyline("0", false, corners));
  EXPECT_TRUE(is_whole(closed));
  EXPECT_EQ(open.size(), 5u);  // the last corner's bulge goes nowhere
  EXPECT_NEAR(distance(open[2].at, {1.0, -1.0}), 0.0, 1e-15);
  EXPECT_NEAR(signed_area({closed.begin(), closed.end() - 1}), pi, 1e-12);
  EXPECT_EQ(curve_in(polyline("0", true, {})).size(), 0u);
  EXPECT_EQ(curve_in(polyline("0", false, {{3, 4, 0.5}})).size(), 1u);
}

}  // namespace
}  // namespace waywright::dxf
