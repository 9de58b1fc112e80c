#include "waywright/scenario/zone_rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/geometry/stretches.hpp"

namespace waywright {
namespace {

Zone zone(ZoneType type, Ring area, double value) {
  Zone z;
  z.type = type;
  z.area = std::move(area);
  z.direction = z.factor = z.speed = value;
  return z;
}

Ring star(Random& random) {
  Ring ring;
  const Vec2 middle{random.uniform(-3, 3), random.uniform(-3, 3)};
  const auto corners = random.integer(3, 8);
  for (std::int64_t i = 0; i < corners; ++i) ring.push_back(middle + random.uniform(0.4, 3.0) * unit(two_pi * static_cast<double>(i) / static_cast<double>(corners)));
  return ring;
}

/// What the rules say where every zone is asked, in order.
double plain_cost(const ZoneRules& rules, Vec2 from, Vec2 to) {
  const auto is_inside = [](const ZoneRules::Weighed& zone, Vec2 p) { return zone.box.contains(p) && inner_radius(zone.area, p) > 1e-6; };
  const Box box = bounding_box({from, to});
  std::vector<double> shares{0.0, 1.0};
  bool is_any = false;
  for (const ZoneRules::Weighed& zone : rules.weighed()) {
    if (!meet(zone.box, box)) continue;
    is_any = true;
    add_crossings(zone.area, from, to, shares);
  }
  if (!is_any) return distance(from, to);
  std::sort(shares.begin(), shares.end());
  double more = 0.0;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double part = shares[i] - shares[i - 1];
    double product = 1.0;
    for (const ZoneRules::Weighed& zone : rules.weighed()) {
      if (is_inside(zone, from + 0.5 * (shares[i - 1] + shares[i]) * (to - from))) product *= zone.factor;
    }
    if (part > 0.0) more += part * (std::clamp(product, ZoneRules::least_product, ZoneRules::most_product) - 1.0);
  }
  return (1.0 + more) * distance(from, to);
}

bool plain_may(const ZoneRules& rules, Vec2 from, Vec2 to) {
  return std::all_of(rules.directed().begin(), rules.directed().end(), [&](const ZoneRules::Directed& zone) {
    return !zone.is_against(to - from, ZoneRules::planned_course) || stretches_deeper_than(zone.area, ZoneRules::planned_depth, from, to).empty();
  });
}

// The table of what is near changes no bit, wherever zones lie, overlap, or are many; ways of any length, along the axes, along outlines and outside of all.
TEST(ZoneRules, OfHundredsOfZonesTheNearOnesDecideAsAllWould) {
  Random random{21};
  int weighed = 0, forbidden = 0;
  for (const double extent : {2.0, 60.0, 2e5}) {
    std::vector<Zone> zones;
    for (int k = 0; k < 500; ++k) {
      const Frame at{{random.uniform(-extent, extent), random.uniform(-0.3 * extent, 0.3 * extent), 0.0}};
      const ZoneType type = k % 3 == 0 ? ZoneType::directed : k % 3 == 1 ? ZoneType::preferred : ZoneType::penalty;
      const double value = type == ZoneType::directed ? random.uniform(-3, 3) : type == ZoneType::preferred ? random.uniform(0.3, 0.9) : random.uniform(1.1, 3);
      zones.push_back(zone(type, transformed(k % 7 == 0 ? rectangle({-1, -0.5}, {1, 0.5}) : star(random), at), value));
    }
    zones.push_back(zone(ZoneType::penalty, rectangle({-0.5 * extent, -0.1 * extent}, {0.7 * extent, 0.2 * extent}), 1.5));
    const ZoneRules rules{zones};
    for (int i = 0; i < 1500; ++i) {
      const Zone& some = zones[static_cast<std::size_t>(random.integer(0, 500))];
      Vec2 from{random.uniform(-1.2 * extent, 1.2 * extent), random.uniform(-0.5 * extent, 0.5 * extent)};
      if (i % 4 == 0) from = some.area.front();
      Vec2 to{random.uniform(-1.2 * extent, 1.2 * extent), random.uniform(-0.5 * extent, 0.5 * extent)};
      if (i % 3 == 0) to = from + random.uniform(0.0, 3.0) * unit(random.uniform(-3.2, 3.2));
      if (i % 5 == 0) to.y = from.y;
      if (i % 7 == 0) to.x = from.x;
      if (i % 11 == 0) to = some.area[1];
      const double cost = rules.cost(from, to);
      ASSERT_EQ(cost, plain_cost(rules, from, to)) << extent << " " << i;
      const bool may = rules.may_be_driven(from, to);
      ASSERT_EQ(may, from == to || plain_may(rules, from, to)) << extent << " " << i;
      double product = 1.0;
      for (const ZoneRules::Weighed& w : rules.weighed()) {
        if (w.box.contains(to) && inner_radius(w.area, to) > 1e-6) product *= w.factor;
      }
      ASSERT_EQ(rules.factor_at(to), std::clamp(product, ZoneRules::least_product, ZoneRules::most_product));
      weighed += cost != distance(from, to) ? 1 : 0;
      forbidden += may ? 0 : 1;
    }
  }
  EXPECT_GT(weighed, 500);
  EXPECT_GT(forbidden, 30);
}

TEST(ZoneRules, ALineCostsWhatItsPartsCost) {
  const ZoneRules rules{{zone(ZoneType::penalty, rectangle({2, -1}, {6, 1}), 3.0), zone(ZoneType::preferred, rectangle({5, -1}, {9, 1}), 0.5)}};
  EXPECT_DOUBLE_EQ(rules.cost({0, 0}, {10, 0}), 2 + 3 * 3 + 1 * 1.5 + 3 * 0.5 + 1);
  EXPECT_DOUBLE_EQ(rules.cost({10, 0}, {0, 0}), rules.cost({0, 0}, {10, 0}));
  EXPECT_EQ(rules.cost({0, 2}, {10, 2}), 10.0);
  EXPECT_EQ(rules.cost({0, 1}, {10, 1}), 10.0);  // along the outline
  EXPECT_DOUBLE_EQ(rules.cost({3, 0}, {4, 0}), 3.0);
  EXPECT_DOUBLE_EQ(rules.least_factor(), 0.5);
  EXPECT_DOUBLE_EQ(rules.most_factor(), 3.0);
}

// Against fine sums over the line, and under rigid motions.
TEST(ZoneRules, CostsAreIntegralsWhereverTheZonesLie) {
  Random random{8};
  for (int i = 0; i < 200; ++i) {
    std::vector<Zone> zones;
    for (int k = 0; k < 4; ++k) zones.push_back(k % 2 == 0 ? zone(ZoneType::penalty, star(random), random.uniform(1.1, 9)) : zone(ZoneType::preferred, star(random), random.uniform(0.05, 0.9)));
    const ZoneRules rules{zones};
    const Vec2 from{random.uniform(-5, 5), random.uniform(-5, 5)}, to{random.uniform(-5, 5), random.uniform(-5, 5)};
    constexpr int parts = 4000;
    double sum = 0.0;
    for (int k = 0; k < parts; ++k) {
      const double factor = rules.factor_at(from + (k + 0.5) / parts * (to - from));
      ASSERT_GE(factor, rules.least_factor());
      ASSERT_LE(factor, rules.most_factor());
      sum += factor * distance(from, to) / parts;
    }
    const double cost = rules.cost(from, to);
    ASSERT_NEAR(cost, sum, 90.0 * 12 * 2 * distance(from, to) / parts);  // a crossing is off by a part of the greatest step of the factor
    ASSERT_NEAR(cost, sum, 0.02 * (1.0 + sum));
    const Frame moved{{random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-3, 3)}};
    for (Zone& z : zones) z.area = transformed(z.area, moved);
    ASSERT_NEAR(ZoneRules{zones}.cost(moved.to_world(from), moved.to_world(to)), cost, 1e-9 * (1.0 + cost));
  }
}

TEST(ZoneRules, OneWayIsUpToNinetyDegreesAndOnlyInside) {
  const ZoneRules rules{{zone(ZoneType::directed, rectangle({0, 0}, {10, 2}), 0.0)}};
  EXPECT_TRUE(rules.may_be_driven({1, 1}, {9, 1}));
  EXPECT_FALSE(rules.may_be_driven({9, 1}, {1, 1}));
  EXPECT_TRUE(rules.may_be_driven({5, -1}, {5, 3}));   // across
  EXPECT_FALSE(rules.may_be_driven({5, -1}, {4.9, 3}));
  EXPECT_TRUE(rules.may_be_driven({9, 2}, {1, 2}));    // along the outline
  EXPECT_TRUE(rules.may_be_driven({9, 1.9995}, {1, 1.9995}));
  EXPECT_FALSE(rules.may_be_driven({9, 1.998}, {1, 1.998}));
  EXPECT_FALSE(rules.may_be_driven({11, 3}, {9, 1}));  // clipped by a corner
  EXPECT_TRUE(rules.may_be_driven({12, 3}, {9, 2.1}));
}

TEST(ZoneRules, ProductsAreBounded) {
  std::vector<Zone> zones;
  for (int i = 0; i < 5; ++i) zones.push_back(zone(ZoneType::penalty, rectangle({0, 0}, {1, 1}), most_penalty));
  for (int i = 0; i < 5; ++i) zones.push_back(zone(ZoneType::preferred, rectangle({5, 0}, {6, 1}), least_preference));
  const ZoneRules rules{zones};
  EXPECT_EQ(rules.factor_at({0.5, 0.5}), ZoneRules::most_product);
  EXPECT_EQ(rules.most_factor(), ZoneRules::most_product);
  EXPECT_EQ(rules.factor_at({5.5, 0.5}), ZoneRules::least_product);
  EXPECT_EQ(rules.least_factor(), ZoneRules::least_product);
}

TEST(ZoneRules, NamesAreOneLine) {
  Zone z = zone(ZoneType::forbidden, rectangle({0, 0}, {1, 1}), 0.0);
  EXPECT_EQ(title_of(z, 2), "zone 2");
  z.name = "dock\nroad";
  EXPECT_EQ(title_of(z, 2), "zone \"dock?road\"");
}

}  // namespace
}  // namespace waywright
