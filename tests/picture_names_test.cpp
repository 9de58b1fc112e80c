// Names in pictures stand where they can be read: off each other, and within the frame.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/report/label_room.hpp"
#include "waywright/report/report.hpp"

namespace waywright {
namespace {

struct Name {
  std::string text;
  Box box{};  ///< px, about
};

/// Texts of a style that begins so, with what they cover.
std::vector<Name> names(const std::string& svg, const std::string& style) {
  std::vector<Name> found;
  const std::regex text{"<text class=\"(" + style + "[^\"]*)\" x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*>([^<]*)</text>"};
  for (std::sregex_iterator i{svg.begin(), svg.end(), text}, end; i != end; ++i) {
    const double wide = 5.6 * static_cast<double>((*i)[4].length()), y = std::stod((*i)[3]) + ((*i)[0].str().find("dy=") != std::string::npos ? 14.0 : 0.0);
    double x = std::stod((*i)[2]);
    if ((*i)[1].str().find("end") != std::string::npos) x -= wide;
    if ((*i)[1].str().find("middle") != std::string::npos) x -= 0.5 * wide;
    found.push_back({(*i)[4], {{x, y - 9.0}, {x + wide, y + 1.0}}});
  }
  return found;
}

bool cover_alike(const Box& a, const Box& b) { return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y; }

std::string picture_of(Scenario scenario) {
  const Problem problem = Problem::prepare(std::move(scenario)).value();
  return plan_svg(problem, solve(problem).value());
}

Scenario example(const std::string& name) { return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name + ".json").value(); }

TEST(PictureNames, OfWhatMovesAndOfWaitsAreApart) {
  const std::string svg = picture_of(example("moving_hall"));
  std::vector<Name> all = names(svg, "note");
  for (const Name& tight : names(svg, "tighttext")) all.push_back(tight);
  const auto has = [&](const std::string& text) { return std::any_of(all.begin(), all.end(), [&](const Name& n) { return n.text.find(text) != std::string::npos; }); };
  for (const char* text : {"person", "tugger", "waits 4.9 s", "waits 6.0 s", "mm proven"}) EXPECT_TRUE(has(text)) << text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(cover_alike(all[i].box, all[k].box)) << all[i].text << " on " << all[k].text;
  }
}

/// A row of one-way lanes 2 m long, with names as long as four of them, or short ones.
Scenario lanes(std::size_t count, const std::string& stem) {
  Scenario s;
  const double end = 2.0 * static_cast<double>(count);
  s.map.boundaries = {rectangle({-2, -4}, {end + 2, 4})};
  s.vehicle.footprint.disc = 0.2;
  s.vehicle.drive = Differential{0.3};
  s.start = {-1, -3, 0};
  s.mission = Pose{end + 1, -3, 0};
  s.planner = {"astar", {}};
  for (std::size_t i = 0; i < count; ++i) {
    Zone zone;
    zone.type = ZoneType::directed;
    zone.name = fmt::format("{}{}", stem, i);
    zone.area = rectangle({2.0 * static_cast<double>(i), 0.0}, {2.0 * static_cast<double>(i) + 1.9, 2.0});
    s.zones.push_back(std::move(zone));
  }
  return s;
}

TEST(PictureNames, OfManyLanesStandOnlyWhereTheLaneHoldsThem) {
  const std::string crowded = picture_of(lanes(24, "Point-0001 --- Point-000")), short_ones = picture_of(lanes(12, "L")), few = picture_of(lanes(3, "Point-0001 --- Point-000"));
  EXPECT_EQ(crowded.find("Point-0001"), std::string::npos);
  EXPECT_EQ(names(short_ones, "note middle").size(), 12u);
  EXPECT_GE(names(few, "note middle").size(), 1u);
  for (const std::string* svg : {&short_ones, &few}) {
    for (const Name& n : names(*svg, "note middle")) {
      EXPECT_GT(n.box.low.x, 40.0) << n.text;
      EXPECT_LT(n.box.high.x, 860.0) << n.text;
    }
  }
}

TEST(LabelRoom, WeighsTextOverLines) {
  LabelRoom room;
  const Box box{{0, 0}, {100, 14}};
  EXPECT_EQ(room.hidden_by(box), 0.0);
  room.take_line({{0, 7}, {100, 7}});
  const double line = room.hidden_by(box);
  EXPECT_GT(line, 10.0);
  room.take(Box{{90, 10}, {120, 20}});
  EXPECT_GT(room.hidden_by(box), 2.0 * line);
  EXPECT_EQ(room.hidden_by({{0, 30}, {100, 44}}), 0.0);
}

}  // namespace
}  // namespace waywright
