// In pictures of plans no text stands on another, none beyond the edge, and each names what it stands beside.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "waywright/core/random.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_legs.hpp"
#include "waywright/report/closest_approach.hpp"
#include "waywright/report/labels.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/text_size.hpp"

namespace waywright {
namespace {

struct Text {
  std::string text, style;
  Box box{};  ///< px, about as the letters cover it
};

/// Every text of a picture.
std::vector<Text> texts(const std::string& svg) {
  std::vector<Text> found;
  static const std::regex text{"<text class=\"([^\"]*)\" x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"([^>]*)>([^<]*)</text>"};
  for (std::sregex_iterator i{svg.begin(), svg.end(), text}, end; i != end; ++i) {
    const std::string style = (*i)[1];
    std::string written = (*i)[5];
    for (const auto& [code, letter] : {std::pair{"&#39;", "'"}, std::pair{"&quot;", "\""}, std::pair{"&lt;", "<"}, std::pair{"&gt;", ">"}, std::pair{"&amp;", "&"}}) {
      for (std::size_t at = 0; (at = written.find(code, at)) != std::string::npos; ++at) written.replace(at, std::string{code}.size(), letter);
    }
    const TextStyle font = text_style(style);
    const double wide = text_width(written, font.size, font.is_bold), y = std::stod((*i)[3]) + ((*i)[4].str().find("dy=") != std::string::npos ? 1.2 * font.size : 0.0);
    const bool at_end = style.ends_with(" end"), in_middle = style.ends_with(" middle") || font.is_centred;
    const double x = std::stod((*i)[2]) - (at_end ? wide : in_middle ? 0.5 * wide : 0.0);
    found.push_back({written, style, {{x, y - 0.74 * font.size}, {x + wide, y + 0.2 * font.size}}});
  }
  return found;
}

bool boxes_meet(const Box& a, const Box& b) { return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y; }

/// Of an attribute of the picture itself.
double number_after(const std::string& svg, const std::string& words) { return std::stod(svg.substr(svg.find(words) + words.size())); }

void expect_legible(const std::string& svg, const std::string& what) {
  const std::vector<Text> all = texts(svg);
  EXPECT_FALSE(all.empty()) << what;
  const double wide = number_after(svg, " width=\""), high = number_after(svg, " height=\"");
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].box.low.x >= -0.5 && all[i].box.low.y >= -0.5 && all[i].box.high.x <= wide + 0.5 && all[i].box.high.y <= high + 0.5) << what << ": \"" << all[i].text << "\" is cut off";
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes_meet(all[i].box, all[k].box)) << what << ": \"" << all[i].text << "\" on \"" << all[k].text << "\"";
  }
}

Scenario example(const std::string& name) { return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name + ".json").value(); }

struct Drawn {
  Plan plan;
  std::string svg;
};
Drawn drawn(Scenario scenario) {
  if (!scenario.legs.empty()) {
    Plan plan = solve_legs(scenario).value();
    std::string svg = plan_svg(plan);
    return {std::move(plan), std::move(svg)};
  }
  const Problem problem = Problem::prepare(std::move(scenario)).value();
  Plan plan = solve(problem).value();
  std::string svg = plan_svg(problem, plan);
  return {std::move(plan), std::move(svg)};
}

TEST(PictureLabels, AreApartInTheExamples) {
  for (const char* name : {"dock_cluttered", "dock_insertion", "dock_left", "dock_middle", "dock_moving", "dock_narrow_side", "dock_right", "dock_rotated", "dock_warehouse", "goal_pose", "grid_published", "grid_region",
                           "grid_tugger", "grid_warehouse", "grid_zones", "moving_hall", "undock_loaded", "waypoints_low", "mission_warehouse", "fields/mecanum_crossing", "fields/mecanum_discs", "fields/point_trap"}) {
    expect_legible(drawn(example(name)).svg, name);
  }
}

/// A hall of 40 × 20 m full of boxes, movers and zones: more names than there is room for.
Scenario crowded() {
  Scenario s;
  s.name = "crowded";
  s.map.boundaries = {rectangle({0, 0}, {40, 20})};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{1.9, 1.4, 0};
  s.planner = {"theta_star", {}};
  for (int i = 0; i < 14; ++i) {
    for (int k = 0; k < 4; ++k) s.map.obstacles.push_back(rectangle({3.0 + 0.5 * i, 3.0 + 0.5 * k}, {3.2 + 0.5 * i, 3.2 + 0.5 * k}));
  }
  for (int i = 0; i < 12; ++i) {
    MovingObstacle person;
    person.name = fmt::format("person number {} of a group", i);
    person.footprint.disc = 0.3;
    person.track = {{0.0, {20.0 + 0.4 * i, 10.0 + 0.3 * (i % 3), 0.0}}, {30.0, {30.0, 18.0, 0.0}}};
    s.moving.push_back(person);
    Zone zone;
    zone.type = ZoneType::speed_limit;
    zone.speed = 0.7;
    zone.name = fmt::format("slow, please: aisle {}", i);
    zone.area = rectangle({12.0 + 0.3 * i, 4.0}, {18.0 + 0.3 * i, 9.0});
    s.zones.push_back(zone);
  }
  return s;
}

TEST(PictureLabels, AreApartWhereThereAreMoreThanHaveRoom) {
  const Drawn d = drawn(crowded());
  ASSERT_FALSE(d.plan.samples.empty()) << d.plan.reason;
  expect_legible(d.svg, "crowded");
  EXPECT_NE(d.svg.find("left out where they have no room"), std::string::npos);
  EXPECT_NE(d.svg.find(">S</text>"), std::string::npos);
  EXPECT_NE(d.svg.find(">G</text>"), std::string::npos);
}

// Whatever is asked for: apart, within the frame, and what came first by rank is there.
TEST(PictureLabels, AreApartWhateverIsAskedFor) {
  Random random{11};
  for (int round = 0; round < 25; ++round) {
    const View view{0.0, 60.0, 10.0};
    Labels labels{view, {{20, 10}, {580, 590}}};
    labels.keep_off({{1, 1}, {59, 59}}, false);
    const std::size_t many = 10 + 6 * static_cast<std::size_t>(round);
    for (std::size_t i = 0; i < many; ++i) {
      const auto rank = static_cast<LabelRank>(i % 8);
      const Vec2 at{random.uniform(-5.0, 65.0), random.uniform(-5.0, 65.0)};
      Labels::Wish wish{{fmt::format("name {}", i), i % 3 == 0 ? "name" : "note", i % 5 == 0 ? "and a second line" : ""}, rank, {}, 0.0, at, {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)}};
      if (i % 4 == 0) wish.middles = {at};
      if (i % 7 == 3) wish.farthest = 0.0;
      labels.add(wish);
    }
    SvgWriter svg{view};
    const std::size_t left_out = labels.write(svg);
    const std::string written = svg.take();
    const std::vector<Text> all = texts(written);
    std::size_t names = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      names += all[i].text.rfind("name ", 0) == 0 ? 1 : 0;
      EXPECT_TRUE(all[i].box.low.x >= 20 && all[i].box.low.y >= 10 && all[i].box.high.x <= 580 && all[i].box.high.y <= 590) << all[i].text;
      for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(boxes_meet(all[i].box, all[k].box)) << all[i].text << " on " << all[k].text;
    }
    EXPECT_EQ(names + left_out, many);
    EXPECT_EQ(all.front().text, "name 0");
  }
}

// Against the advance widths in the font's own table, of 2048 units an em.
TEST(PictureLabels, AreAsWideAsTheirLetters) {
  EXPECT_NEAR(text_width("AVm 0", 2048.0, false), 1401 + 1401 + 1995 + 651 + 1303, 8.0);
  EXPECT_NEAR(text_width("AVm 0", 2048.0, true), 1585 + 1585 + 2134 + 713 + 1425, 8.0);
  EXPECT_GT(text_width("é", 12.0, false), text_width("e", 12.0, false));
  EXPECT_NEAR(text_width("ééé", 12.0, false), 3.0 * text_width("é", 12.0, false), 1e-12);
  EXPECT_EQ(text_style("tighttext note end").size, 12.0);
  EXPECT_TRUE(text_style("name middle").is_bold);
}

TEST(PictureLabels, OfConcaveObstaclesLieInside) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 12})};
  s.map.obstacles = {{{4, 3}, {14, 3}, {14, 11}, {12, 11}, {12, 5}, {6, 5}, {6, 11}, {4, 11}}};  // a U, whose box has its middle outside
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{18, 1, 0};
  s.planner = {"theta_star", {}};
  const std::string svg = drawn(s).svg;
  for (const Text& text : texts(svg)) {
    if (text.style.rfind("number", 0) != 0) continue;
    const double scale = (860.0 - 40.0) / 22.0;
    const Vec2 middle = 0.5 * (text.box.low + text.box.high);
    EXPECT_TRUE(contains(s.map.obstacles.front(), Vec2{-1.0 + (middle.x - 40.0) / scale, 13.0 - middle.y / scale})) << middle.x << " " << middle.y;
    return;
  }
  ADD_FAILURE() << "there is no number";
}

TEST(ClosestApproach, IsNoFartherThanAtAnyTime) {
  for (const char* name : {"moving_hall", "fields/mecanum_crossing"}) {
    const Problem problem = Problem::prepare(example(name)).value();
    const Plan plan = solve(problem).value();
    const std::vector<ClosestApproach> closest = closest_approaches(problem, plan.samples);
    ASSERT_EQ(closest.size(), problem.scenario().moving.size());
    for (std::size_t i = 1; i < closest.size(); ++i) EXPECT_GE(closest[i].distance, closest[i - 1].distance);
    for (const ClosestApproach& c : closest) {
      // Held against corners and edges of the outlines, whose discs have 36 corners, at times of its own.
      const MovingObstacle& other = problem.scenario().moving[c.obstacle];
      const auto gap = [&](double t) {
        const Pose vehicle = pose_at(plan.samples, t), there = other.at(t);
        double least = 1e9;
        const Ring a = transformed(problem.footprint().polygon, Frame{vehicle});
        if (other.footprint.is_disc()) return distance(nearest_in(a, there.position()), there.position()) - other.footprint.disc;
        const Ring b = transformed(other.footprint.polygon, Frame{there});
        for (const Vec2 p : a) least = std::min(least, distance(p, nearest_in(b, p)));
        for (const Vec2 p : b) least = std::min(least, distance(p, nearest_in(a, p)));
        return least;
      };
      EXPECT_NEAR(gap(c.t), c.distance, 2e-3) << name;
      for (double t = 0.0; t <= plan.samples.back().t; t += 0.013) EXPECT_GE(gap(t), c.distance - 0.02) << name << " at " << t;
      EXPECT_NEAR(distance(c.on_vehicle, c.on_other), c.distance, 5e-3);
      EXPECT_GT(c.distance, problem.scenario().clearance);
    }
  }
}

TEST(PictureLabels, TellTimesAndMeetingsAmongWhatMoves) {
  const Drawn d = drawn(example("fields/mecanum_crossing"));
  const auto count = [&](const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = d.svg.find(part); at != std::string::npos; at = d.svg.find(part, at + 1)) ++n;
    return n;
  };
  const Problem problem = Problem::prepare(example("fields/mecanum_crossing")).value();
  const ClosestApproach nearest = closest_approaches(problem, d.plan.samples).front();
  EXPECT_NE(d.svg.find(fmt::format(">{:.2f} m at {:.1f} s<", nearest.distance, nearest.t)), std::string::npos);
  EXPECT_GE(count("<line class=\"meetingline\""), 1u);
  EXPECT_EQ(count("<polygon class=\"meeting\""), 2 * count("<line class=\"meetingline\""));
  EXPECT_GE(count("class=\"waytick\""), 4u);
  EXPECT_GE(count("class=\"movingtick\""), 6u);
  EXPECT_GE(count("<text class=\"note\" x=") + count("<text class=\"note end\" x="), 6u);
  EXPECT_EQ(drawn(example("dock_middle")).svg.find("meeting\""), std::string::npos);
}

/// Lanes as `meta` tells them, on a map of walls: a way along the lower one of two.
Scenario on_lanes(const std::string& one_way) {
  Scenario s;
  s.map.lines = {{{0, 0}, {40, 0}, {40, 20}, {0, 20}, {0, 0}}};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.4};
  s.start = {5, 5, 0};
  s.mission = Pose{20, 5, 0};
  s.planner = {"theta_star", {}};
  s.meta = R"({"lanes": {"width": 1.0, "courses": [[[2, 5], [38, 5]], [[2, 15], [38, 15]]], "one_way": )" + one_way + "}}";
  return s;
}

TEST(PictureLanes, AreFaintLinesWithArrowsOnThoseOfOneWayAndAllInSight) {
  const auto count = [](const std::string& svg, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++n;
    return n;
  };
  const std::string svg = drawn(on_lanes("[true, false]")).svg;
  EXPECT_EQ(count(svg, "<polyline class=\"lane\""), 2u);
  EXPECT_EQ(count(svg, "<polygon class=\"lanehead\""), 1u);
  EXPECT_NE(svg.find("lane; an arrow: one way"), std::string::npos);
  EXPECT_EQ(count(drawn(on_lanes("[]")).svg, "lanehead\""), 0u);
  // Not cropped to the way, which ends at x = 20: the scale of 40 m and their margin.
  EXPECT_NE(svg.find(">40</text>"), std::string::npos);
  for (const char* meta : {"{}", "[]", R"({"lanes": 3})", R"({"lanes": {"courses": [[[1, "a"]], 7, [[1, 2]]], "one_way": true}})", R"({"lanes": {"courses")"}) {
    Scenario s = on_lanes("[]");
    s.meta = meta;
    EXPECT_EQ(drawn(s).svg.find("class=\"lane\""), std::string::npos) << meta;
  }
}

}  // namespace
}  // namespace waywright
