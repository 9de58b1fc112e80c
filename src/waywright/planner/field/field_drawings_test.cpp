// What the pictures of fields show is what planners find.
#include "waywright/planner/field/field_drawings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/map/field_worlds.hpp"
#include "waywright/planner/field/field_planner.hpp"
#include "waywright/planner/field/harmonic_planner.hpp"
#include "waywright/planner/field/star_world_of.hpp"
#include "waywright/planner/field/wavefront_planner.hpp"

namespace waywright {
namespace {

using Kind = FieldPicture::Critical::Kind;

Problem world_of(const std::string& name, std::size_t task = 0) {
  FieldWorld world = field_world(name).value();
  Scenario s;
  s.map = std::move(world.map);
  s.vehicle.footprint.disc = 0.0;
  s.vehicle.drive = Mecanum{0.05, 0.24, 0.15};
  s.start = make_pose(world.tasks[task].start, 0.0);
  s.mission = make_pose(world.tasks[task].goal, 0.0);
  return Problem::prepare(std::move(s)).value();
}

FieldPlannerOptions options_of(FieldMethod method, double kappa = 0.0, double lambda = 0.0) {
  FieldPlannerOptions o;
  o.method = method;
  o.kappa = kappa;
  o.lambda = lambda;
  o.potential.repels_walls = false;
  return o;
}

SharedDrawing field_of(const PlanningResult& result) { return result ? result->field : result.error().field; }

template <class P>
SharedDrawing drawing_of(const P& planner, const Problem& problem) {
  Budget budget;
  return field_of(planner.plan(problem, budget));
}

std::size_t count(const FieldPicture& picture, Kind kind) {
  return static_cast<std::size_t>(std::count_if(picture.critical.begin(), picture.critical.end(), [&](const auto& c) { return c.kind == kind; }));
}

constexpr Box disc_region{{-5.2, -5.2}, {5.2, 5.2}}, square_region{{-0.5, -0.5}, {10.5, 10.5}};

TEST(FieldDrawings, MarkTheCriticalPointsOfNavigationFunctions) {
  const Problem problem = world_of("NF-S3");
  for (const auto& [kappa, minima, saddles] : {std::tuple{8.0, 0u, 3u}, {10.0, 0u, 3u}, {5.0, 1u, 4u}}) {
    const auto drawing = drawing_of(FieldPlanner{"navigation_function", options_of(FieldMethod::navigation, kappa)}, problem);
    ASSERT_TRUE(drawing) << kappa;
    const auto picture = drawing->of(problem, disc_region);
    EXPECT_EQ(count(*picture, Kind::saddle), saddles) << kappa;
    EXPECT_EQ(count(*picture, Kind::minimum) + count(*picture, Kind::trap), minima) << kappa;
    EXPECT_EQ(picture->critical.size(), minima + saddles);
  }
}

// As many as the model has, where the slope that the planner follows vanishes.
TEST(FieldDrawings, MarkTheSaddlesOfAStarWorldWhereTheMapTakesThemFrom) {
  for (const std::size_t task : {0u, 1u}) {
    const Problem problem = world_of("NF-ST", task);
    const PlaneSpace space{problem};
    const auto stars = stars_or_trees(space, problem.start().position(), problem.goal().position());
    ASSERT_TRUE(stars);
    const auto* world = std::get_if<StarWorld>(&*stars);
    ASSERT_NE(world, nullptr);
    const StarNavigation navigation{*world, problem.goal().position(), 1e6, 8.0};
    const auto places = critical_places(navigation, *world);
    EXPECT_EQ(places.size(), critical_points(navigation.function()).size());
    EXPECT_EQ(places.size(), 3u);
    for (const auto& c : places) {
      EXPECT_EQ(c.kind, Kind::saddle);
      const double around = norm(navigation.slope(c.at + Vec2{0.02, 0.0}));
      EXPECT_LT(norm(navigation.slope(c.at)), 1e-3 * around) << c.at.x << ", " << c.at.y;
    }
    const auto picture = star_drawing(*world, problem.goal().position(), 1e6, 8.0, std::nullopt)->of(problem, disc_region);
    EXPECT_EQ(picture->critical.size(), 3u);
  }
}

// Of trees of stars, too: one saddle for each disc of the model, and streamlines that end at the goal.
TEST(FieldDrawings, ShowWhatThePlannerWentDownAmongTrees) {
  const Problem problem = world_of("APF-2", 0);
  const auto drawing = drawing_of(FieldPlanner{"star_navigation", options_of(FieldMethod::star)}, problem);
  ASSERT_TRUE(drawing);
  const auto picture = drawing->of(problem, square_region);
  EXPECT_EQ(count(*picture, Kind::saddle), 1u);
  EXPECT_EQ(count(*picture, Kind::minimum), 0u);
  EXPECT_EQ(count(*picture, Kind::trap), 0u);
  ASSERT_FALSE(picture->streamlines.empty());
  const bool reaches = std::any_of(picture->streamlines.begin(), picture->streamlines.end(), [&](const auto& line) { return distance(line.back(), problem.goal().position()) < 3.0 * picture->cell; });
  EXPECT_TRUE(reaches);
}

// Who is trapped sees where; who is not sees the same place as a minimum.
TEST(FieldDrawings, MarkTheTrapOfAPotential) {
  const FieldPlanner planner{"potential_field", options_of(FieldMethod::potential)};
  const Problem trapped = world_of("APF-2", 0);
  const auto failed = drawing_of(planner, trapped);
  ASSERT_TRUE(failed);
  const auto picture = failed->of(trapped, square_region);
  ASSERT_EQ(count(*picture, Kind::trap), 1u);
  EXPECT_EQ(count(*picture, Kind::minimum), 0u);
  const auto trap = std::find_if(picture->critical.begin(), picture->critical.end(), [](const auto& c) { return c.kind == Kind::trap; });
  EXPECT_LT(distance(trap->at, {4.624, 5.0}), 0.01);
  const auto as_minimum = potential_drawing(options_of(FieldMethod::potential).potential, trapped.goal().position(), std::nullopt)->of(trapped, square_region);
  ASSERT_EQ(count(*as_minimum, Kind::minimum), 1u);
  EXPECT_EQ(count(*as_minimum, Kind::trap), 0u);
  const auto minimum = std::find_if(as_minimum->critical.begin(), as_minimum->critical.end(), [](const auto& c) { return c.kind == Kind::minimum; });
  EXPECT_LT(distance(minimum->at, trap->at), 0.005);
  // Minima, the goal among them, and maxima less saddles are one less the number of holes, since the slope leads out at every rim.
  const auto saddles = static_cast<std::ptrdiff_t>(count(*as_minimum, Kind::saddle)), minima = static_cast<std::ptrdiff_t>(count(*as_minimum, Kind::minimum)) + 1,
             maxima = static_cast<std::ptrdiff_t>(count(*as_minimum, Kind::maximum));
  EXPECT_EQ(minima + maxima - saddles, 1 - 1);  // the three rectangles of the U touch: one hole
}

/// Values are shares or none, lines lie where there are values and go down, and nothing leaves the region.
void expect_sound(const FieldPicture& picture, const Problem& problem, const Box& region, Vec2 goal, double reached) {
  ASSERT_GT(picture.columns, 20);
  ASSERT_EQ(picture.shares.size(), static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows));
  const auto node = [&](std::size_t i) {
    const auto columns = static_cast<std::size_t>(picture.columns);
    return picture.origin + picture.cell * Vec2{static_cast<double>(i % columns), static_cast<double>(i / columns)};
  };
  std::size_t known = 0;
  for (std::size_t i = 0; i < picture.shares.size(); ++i) {
    EXPECT_TRUE(region.contains(node(i)));
    if (std::isnan(picture.shares[i])) continue;
    ++known;
    EXPECT_GE(picture.shares[i], 0.0);
    EXPECT_LE(picture.shares[i], 1.0);
    EXPECT_FALSE(problem.world().is_blocked(node(i)));
  }
  EXPECT_GT(known, picture.shares.size() / 4);
  ASSERT_GT(picture.streamlines.size(), 5u);
  const auto share_at = [&](Vec2 p) {
    const Vec2 in = (1.0 / picture.cell) * (p - picture.origin);
    const auto column = std::clamp<long>(std::lround(in.x), 0, picture.columns - 1), row = std::clamp<long>(std::lround(in.y), 0, picture.rows - 1);
    return picture.shares[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.columns) + static_cast<std::size_t>(column)];
  };
  double nearest = 1e9;
  for (const Polyline& line : picture.streamlines) {
    ASSERT_GE(line.size(), 2u);
    for (const Vec2 p : line) {
      EXPECT_TRUE(region.contains(p));
      EXPECT_FALSE(problem.world().is_blocked(p));
    }
    const double first = share_at(line.front()), last = share_at(line.back());
    if (!std::isnan(first) && !std::isnan(last)) {
      EXPECT_LT(last, first + 0.01);
    }
    nearest = std::min(nearest, distance(line.back(), goal));
  }
  EXPECT_LT(nearest, reached);
}

TEST(FieldDrawings, GoDownAndStayInTheRegionWhicheverField) {
  const Box part{{1.0, 0.0}, {10.5, 9.0}};
  const Problem hall = world_of("APF-1"), stars = world_of("NF-ST");
  for (const Box& region : {square_region, part}) {
    for (const auto& drawing : {drawing_of(FieldPlanner{"potential_field", options_of(FieldMethod::potential)}, hall), drawing_of(HarmonicPlanner{HarmonicOptions{}}, hall),
                                drawing_of(WavefrontPlanner{WavefrontOptions{}}, hall)}) {
      ASSERT_TRUE(drawing);
      expect_sound(*drawing->of(hall, region), hall, region, hall.goal().position(), region.contains(hall.goal().position()) ? 0.3 : 1.5);
    }
  }
  const auto drawing = drawing_of(FieldPlanner{"star_navigation", options_of(FieldMethod::star, 8.0, 1e6)}, stars);
  ASSERT_TRUE(drawing);
  expect_sound(*drawing->of(stars, disc_region), stars, disc_region, stars.goal().position(), 0.3);
}

TEST(FieldDrawings, AreTheSameEachTimeAndMadeWhenAskedFor) {
  const Problem problem = world_of("APF-1");
  int made = 0;
  const FieldDrawing counted{[&](const Problem&, const Box&) { return ++made, FieldPicture{}; }};
  EXPECT_EQ(made, 0);
  counted.of(problem, square_region);
  counted.of(problem, square_region);
  EXPECT_EQ(made, 1);
  counted.of(problem, disc_region);
  EXPECT_EQ(made, 2);
  const HarmonicPlanner planner{HarmonicOptions{}};
  const auto one = drawing_of(planner, problem)->of(problem, square_region), other = drawing_of(planner, problem)->of(problem, square_region);
  EXPECT_EQ(one->streamlines, other->streamlines);
  EXPECT_TRUE(std::equal(one->shares.begin(), one->shares.end(), other->shares.begin(), other->shares.end(), [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
}

// The harmonic potential has saddles behind obstacles and no minimum.
TEST(FieldDrawings, OfTheHarmonicPotentialHaveSaddlesAlone) {
  const Problem problem = world_of("APF-1");
  const auto picture = drawing_of(HarmonicPlanner{HarmonicOptions{}}, problem)->of(problem, square_region);
  EXPECT_GE(picture->critical.size(), 3u);
  EXPECT_EQ(picture->critical.size(), count(*picture, Kind::saddle));
}

}  // namespace
}  // namespace waywright
