// The waypoint planner on the publication's three maps: examples/waypoints_*.json.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/waypoint/candidates.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Scenario fixture_scenario(const std::string& map) {
  return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/waypoints_" + map + ".json").value();
}

WaypointOptions published(Continuity continuity = Continuity::g1) {
  WaypointOptions options;
  options.form = FitnessForm::published;
  options.continuity = continuity;
  options.heading_range = pi;
  return options;
}

struct Published {
  const char* map;
  std::vector<double> courses;  // degrees
  double length, mean, least;   // mm
  int contacts, crossed;        // poses with a corner inside, poses that touch at all
  double curvature;             // 1/m
};

const std::vector<Published>& fixtures() {
  static const std::vector<Published> all{
      {"low", {14.7, 58.5}, 14708.4, 747.43, 230.47, 0, 0, 0.836},
      {"low", {20, 45}, 14637.5, 678.09, 39.18, 0, 8, 0.932},
      {"medium", {60, 60, 60}, 14814.1, 275.10, 0, 21, 35, 0.944},
      {"high", {330, 275, 270, 0, 50}, 20601.4, 390.71, 0, 10, 14, 0.983},
  };
  return all;
}

TEST(WaypointFixtures, ArePublishedFiguresInMillimetres) {
  for (const Published& f : fixtures()) {
    const Problem problem = Problem::prepare(fixture_scenario(f.map)).value();
    const WaypointOptions options = published();
    WaypointCandidates candidates{problem, options};
    std::vector<double> x;
    for (const double course : f.courses) x.push_back(course * pi / 180.0);
    const auto chain = candidates.chain_at(x);
    ASSERT_TRUE(chain);
    const TrajectoryMeasures corners = candidates.measures_of(*chain, FitnessForm::published, true);
    EXPECT_NEAR(1000.0 * corners.length, f.length, 0.5) << f.map;
    EXPECT_NEAR(1000.0 * mean_distance(corners), f.mean, 0.5) << f.map;
    EXPECT_NEAR(1000.0 * least_distance(corners), f.least, 0.5) << f.map;
    EXPECT_NEAR(poses_in_contact(corners), f.contacts, 1) << f.map;
    EXPECT_NEAR(greatest_curvature(*chain), f.curvature, 0.001) << f.map;
    const TrajectoryMeasures whole = candidates.measures_of(*chain, FitnessForm::corrected, false);
    EXPECT_NEAR(poses_in_contact(whole), f.crossed, 1) << f.map;
    for (std::size_t i = 0; i < corners.distance.size(); ++i) EXPECT_LE(whole.distance[i], corners.distance[i] + 1e-9) << f.map << " " << i;
  }
}

TEST(Fitness, ValuesAreThoseOfTheFormulas) {
  TrajectoryMeasures m;
  m.length = 12.0;
  m.distance = {0.2, 0.5, 0.0, 0.3};
  m.depth = {0.0, 0.0, 0.04, 0.0};
  m.greatest = 4.0;
  m.reference = 8.0;
  const auto published_value = [&](Fitness f) { return fitness_of(f, FitnessForm::published, m); };
  const auto corrected_value = [&](Fitness f) { return fitness_of(f, FitnessForm::corrected, m); };
  EXPECT_DOUBLE_EQ(published_value(Fitness::mlpc), 12'000'000.0);
  EXPECT_DOUBLE_EQ(published_value(Fitness::mlmc), 12'000'000.0);
  EXPECT_DOUBLE_EQ(published_value(Fitness::mdobs), 1e6);
  EXPECT_NEAR(published_value(Fitness::avgmd), 1.0 / 250.0, 1e-15);
  EXPECT_NEAR(published_value(Fitness::pwavg), 1.0 + 40.0 / 250.0, 1e-12);
  EXPECT_NEAR(published_value(Fitness::levels), 0.25 + 0.1 * 3, 1e-12);
  EXPECT_NEAR(corrected_value(Fitness::pwavg), 1.0 + 0.01 / 8.0, 1e-12);
  EXPECT_NEAR(corrected_value(Fitness::avgmd), 1.0 / 240.0, 1e-15);
  EXPECT_NEAR(corrected_value(Fitness::levels), 1.55, 1e-12);
  EXPECT_GT(corrected_value(Fitness::mdobs), 1e6);
  m.depth.assign(4, 0.0);
  m.distance[2] = 0.4;
  EXPECT_DOUBLE_EQ(published_value(Fitness::mlpc), 12'000.0);
  EXPECT_DOUBLE_EQ(published_value(Fitness::mlmc), 0.0);
  EXPECT_DOUBLE_EQ(corrected_value(Fitness::mlmc), 12'000.0);
  EXPECT_NEAR(published_value(Fitness::mdobs), 1.0 / 200.0, 1e-15);
  EXPECT_NEAR(published_value(Fitness::pwavg), 1.0 - 0.35 / 4.0, 1e-12);
  EXPECT_NEAR(fitness_with_margin(m, 0.2), 1.0 - 0.35 / 8.0, 1e-12);
  EXPECT_GT(fitness_with_margin(m, 0.21), 1.0);
}

TEST(Fitness, AnyContactIsAtLeastOneAndAnyFreePathUnder) {
  const Problem problem = Problem::prepare(fixture_scenario("medium")).value();
  const WaypointOptions options = published();
  WaypointCandidates candidates{problem, options};
  Random random{1};
  int contacts = 0, free = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<double> x;
    for (int k = 0; k < 3; ++k) x.push_back(random.uniform(-0.2, 1.4));
    if (i == 0) x = {22.5 * pi / 180, 36.0 * pi / 180, 23.0 * pi / 180};  // free at its corners
    const auto chain = candidates.chain_at(x);
    ASSERT_TRUE(chain);
    for (const FitnessForm form : {FitnessForm::published, FitnessForm::corrected}) {
      const TrajectoryMeasures m = candidates.measures_of(*chain, form, true);
      const double value = fitness_of(Fitness::pwavg, form, m);
      contacts += poses_in_contact(m) > 0;
      free += poses_in_contact(m) == 0;
      EXPECT_EQ(value >= 1.0, poses_in_contact(m) > 0) << value;
    }
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(free, 0);
}

Proof proof_of(const Path& path, std::vector<Vec2> waypoints, double radius) {
  Scenario s;
  s.vehicle.footprint.disc = 0.1;
  s.vehicle.drive = Differential{0.4};
  s.start = start_pose(path);
  s.mission = end_pose(path);
  s.waypoints = std::move(waypoints);
  s.waypoint_radius = radius;
  return prove(Problem::prepare(s).value(), path);
}

TEST(Passing, HoldsAPathToItsWaypointsInOrder) {
  const Path straight{{Piece{Line{{0, 0}, {10, 0}}, 1}}};
  EXPECT_TRUE(proof_of(straight, {{3, 0}, {7, 0}}, 0.0).holds());
  EXPECT_FALSE(proof_of(straight, {{7, 0}, {3, 0}}, 0.0).holds());
  EXPECT_TRUE(proof_of(straight, {{3, 0.1}}, 0.1).holds());
  const Proof missed = proof_of(straight, {{5, 0.5}}, 0.1);
  ASSERT_EQ(missed.violations.size(), 1U);
  EXPECT_NE(missed.violations.front().sentence.find("as near as about 0.500 m, and 0.100 m are allowed"), std::string::npos) << missed.violations.front().sentence;
  Random random{5};
  for (int i = 0; i < 100; ++i) {
    std::vector<Pose> poses;
    for (int k = 0; k < 4; ++k) poses.push_back({3.0 * k, random.uniform(-1, 1), random.uniform(-0.8, 0.8)});
    const Clothoids chain = *chain_through(poses, Continuity::g2);
    const Path path = path_of(chain);
    // Any places along the path, in order; and one a little beside.
    std::vector<Vec2> places;
    for (const std::size_t k : {1U, 4U, 7U}) places.push_back(evaluate(chain[k], random.uniform(0.1, 0.9) * chain[k].length).position);
    EXPECT_TRUE(proof_of(path, places, 0.0).holds());
    std::vector<Vec2> beside = places;
    beside[1].y += 0.02;
    EXPECT_FALSE(proof_of(path, beside, 0.0).holds());
    EXPECT_TRUE(proof_of(path, beside, 0.02).holds());
    std::swap(places[0], places[2]);
    EXPECT_FALSE(proof_of(path, places, 0.0).holds());
  }
}

TEST(WaypointSpacing, PlacesThatCoincideAreRefusedByName) {
  const auto refusal = [](Vec2 first, Vec2 second, Vec2 goal, double radius) {
    Scenario s;
    s.vehicle.footprint.disc = 0.1;
    s.vehicle.drive = Differential{0.4};
    s.start = {1, 1, 0};
    s.waypoints = {first, second};
    s.waypoint_radius = radius;
    s.mission = make_pose(goal, 0.0);
    const auto problem = Problem::prepare(s);
    return problem ? std::string{} : problem.error().message();
  };
  const std::string allowed = " (allowed: places more than 1 mm apart, beyond the waypoint radius of both)";
  EXPECT_EQ(refusal({3, 1}, {5, 1}, {7, 1}, 0.0), "");
  EXPECT_EQ(refusal({1, 1}, {5, 1}, {7, 1}, 0.0), "waypoints[0]: it is 0.0000 m from the start" + allowed);
  EXPECT_EQ(refusal({3, 1}, {3, 1.0009}, {7, 1}, 0.0), "waypoints[1]: it is 0.0009 m from waypoints[0]" + allowed);
  EXPECT_EQ(refusal({3, 1}, {3, 1.0011}, {7, 1}, 0.0), "");
  EXPECT_EQ(refusal({3, 1}, {7, 1.0009}, {7, 1}, 0.0), "goal: it is 0.0009 m from waypoints[1]" + allowed);
  // Apart, the same place may be passed twice.
  EXPECT_EQ(refusal({3, 1}, {5, 1}, {3, 1}, 0.0), "");
  // Each may be left by the radius: two waypoints by both, start and goal are where they are.
  EXPECT_EQ(refusal({1.5005, 1}, {5, 1}, {7, 1}, 0.5), "waypoints[0]: it is 0.5005 m from the start" + allowed);
  EXPECT_EQ(refusal({1.502, 1}, {2.5025, 1}, {7, 1}, 0.5), "waypoints[1]: it is 1.0005 m from waypoints[0]" + allowed);
  EXPECT_EQ(refusal({1.502, 1}, {2.504, 1}, {3.0045, 1}, 0.5), "goal: it is 0.5005 m from waypoints[1]" + allowed);
  EXPECT_EQ(refusal({1.502, 1}, {2.504, 1}, {3.006, 1}, 0.5), "");
}

TEST(WaypointClothoid, SaysInGrammarWhatItDid) {
  // Boxes nowhere near: 0, 1, 2 and 5 waypoints, one candidate or many, either kind of chain.
  const auto text_of = [](std::size_t waypoints, const char* chain, double evaluations, double curvature) {
    Scenario s;
    s.vehicle.footprint.disc = 0.2;
    s.vehicle.drive = Differential{0.4};
    s.vehicle.limits.curvature = curvature;
    s.start = {0, 0, 0.5};
    for (std::size_t i = 1; i <= waypoints; ++i) s.waypoints.push_back({3.0 * static_cast<double>(i), 0.5});
    s.mission = Pose{3.0 * static_cast<double>(waypoints + 1), 0, 0};
    s.planner.name = "waypoint_clothoid";
    s.planner.parameters = {{"chain", std::string{chain}}, {"evaluations", evaluations}};
    const Plan plan = *solve(Problem::prepare(s).value());
    std::string text = plan.reason;
    for (const std::string& sentence : plan.explanation) text += "\n" + sentence;
    return text;
  };
  const auto expect = [](const std::string& text, std::initializer_list<const char*> words) {
    for (const char* w : words) EXPECT_NE(text.find(w), std::string::npos) << w << "\n  is not in\n" << text;
  };
  expect(text_of(0, "g2", 50, 5), {"There are no waypoints to choose courses at", "The way is three clothoids: curvature goes on"});
  expect(text_of(0, "g1", 50, 5), {"The way is one clothoid: curvature is at most"});
  expect(text_of(1, "g2", 50, 5), {"Of 50 candidates, this course at the waypoint is best: ", "with the course halfway between those to and from the waypoint.", "Each leg is three clothoids"});
  expect(text_of(1, "g1", 50, 50), {"curvature jumps at the waypoint;"});
  expect(text_of(1, "g2", 1, 5), {"Only the course halfway between those to and from the waypoint was looked at: "});
  expect(text_of(2, "g2", 1, 5), {"Only the courses halfway between those to and from each waypoint were looked at: "});
  expect(text_of(2, "g1", 50, 50), {"Of 50 candidates, these courses at the waypoints are best: ", "curvature jumps at waypoints;"});
  expect(text_of(5, "g2", 50, 5), {"Of 50 candidates, these courses at the waypoints are best: ", "with the courses halfway between those to and from each waypoint."});
  // And why there is none.
  expect(text_of(0, "g2", 50, 0.01), {"the only chain of clothoids from start to goal that was looked at cannot be driven: it bends with"});
  expect(text_of(1, "g2", 1, 0.01), {"the only chain of clothoids through the waypoint that was looked at cannot be driven: it bends with"});
  expect(text_of(1, "g2", 50, 0.01), {"of 50 chains of clothoids through the waypoint none can be driven; the best one bends with"});
  expect(text_of(5, "g2", 50, 0.01), {"of 50 chains of clothoids through the waypoints none can be driven; the best one bends with"});
}

TEST(WaypointClothoid, ARefusalNamesTheLeg) {
  // Waypoints 1 cm apart, across the way: no vehicle turns there.
  const auto reason_of = [](std::vector<Vec2> waypoints, const char* chain, Pose goal) {
    Scenario s;
    s.vehicle.footprint.disc = 0.2;
    s.vehicle.drive = Differential{0.45};
    s.vehicle.limits.curvature = 2.0;
    s.start = {0, 0, 0};
    s.waypoints = std::move(waypoints);
    s.mission = goal;
    s.planner.name = "waypoint_clothoid";
    s.planner.parameters["chain"] = chain;
    s.planner.parameters["evaluations"] = 200.0;
    return solve(Problem::prepare(s).value())->reason;
  };
  const auto says = [](const std::string& reason, const char* words) { EXPECT_NE(reason.find(words), std::string::npos) << reason; };
  says(reason_of({{3, 0.5}, {6, 0.5}, {6, 0.51}, {9, 0}}, "g2", {12, 0, 0}), "waypoint 2 at (6.000, 0.500) and waypoint 3 at (6.000, 0.510), which are 0.0100 m apart");
  says(reason_of({{0, 0.01}, {4, 0}}, "g2", {12, 0, 0}), "the start at (0.000, 0.000) and waypoint 1 at (0.000, 0.010), which are 0.0100 m apart");
  // Two of them, where the worse one decides and the other is told, too.
  says(reason_of({{3, 0}, {6, 0}, {6, 0.01}}, "g2", {12, 0, 3.0}), "waypoint 2 at (6.000, 0.000) and waypoint 3 at (6.000, 0.010), which are 0.0100 m apart");
  says(reason_of({{3, 0}}, "g2", {3.2, 0, 3.0}), "most between waypoint 1 at (3.000, 0.000) and the goal at (3.200, 0.000), which are 0.2000 m apart");
}

TEST(WaypointRadius, LetsThePathPassBeside) {
  Scenario s = fixture_scenario("medium");
  s.waypoint_radius = 0.15;
  s.planner.parameters["evaluations"] = 3000.0;
  const Plan plan = *solve(Problem::prepare(s).value());
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  s.waypoint_radius = 0.0;
  const Plan exact = *solve(Problem::prepare(s).value());
  ASSERT_EQ(exact.status, Status::solved) << exact.reason;
  EXPECT_GT(plan.certificate.clearance, exact.certificate.clearance);
}

TEST(WaypointClothoid, FindsItsWayAlongManyAndFarWaypoints) {
  for (const double spacing : {10.0, 30.0, 100.0}) {
    for (const int count : {2, 8, 20}) {
      Scenario s;
      s.vehicle.footprint.polygon = {{-0.9, -0.275}, {0.9, -0.275}, {0.9, 0.275}, {-0.9, 0.275}};
      s.vehicle.drive = Differential{0.45};
      s.vehicle.limits.curvature = 1.0;
      for (int i = 1; i <= count; ++i) s.waypoints.push_back({spacing * i, i % 2 == 0 ? 1.0 : -1.0});
      s.mission = Pose{spacing * (count + 1), 0, 0};
      s.planner.name = "waypoint_clothoid";
      s.planner.parameters["evaluations"] = 400.0;
      const Plan plan = *solve(Problem::prepare(s).value());
      EXPECT_EQ(plan.status, Status::solved) << spacing << " " << count << " " << plan.reason;
    }
  }
}

TEST(MapObjects, GridsAreBlockedWhereTheirCellsAre) {
  Scenario s;
  CellGrid grid{"hall", 40, 40, 0.25, {0, 0, 0}, std::vector<std::uint8_t>(1600, 0), true};
  for (int r = 18; r < 22; ++r) {
    for (int c = 18; c < 22; ++c) grid.blocked[static_cast<std::size_t>(r * 40 + c)] = 1;
  }
  s.map.grids.push_back(grid);
  s.vehicle.footprint.polygon = {{-0.3, -0.2}, {0.3, -0.2}, {0.3, 0.2}, {-0.3, 0.2}};
  s.vehicle.drive = Differential{0.4};
  s.start = {2, 2, 0};
  s.mission = Pose{8, 2, 0};
  const Problem problem = Problem::prepare(s).value();
  TrajectoryMeasures m;
  const std::vector<Pose> poses{{2, 2, 0}, {5, 5, 0}, {9.9, 5, 0}, {4.35, 5, 0}};
  MapObjects{problem}.measure(poses, FitnessForm::published, false, m);
  EXPECT_EQ(m.depth[0], 0.0);
  EXPECT_NEAR(m.distance[0], 1.7, 1e-9);
  EXPECT_NEAR(m.depth[1], 0.2, 1e-9);  // in the middle of a block of 1 m: corners 0.2 and 0.3 m from its sides
  EXPECT_NEAR(m.depth[2], 0.2, 1e-9);  // 0.2 m beyond the grid
  EXPECT_NEAR(m.depth[3], 0.15, 1e-9);
}

TEST(Chain, IsContinuousAndPassesItsPoses) {
  Random random{2};
  for (int i = 0; i < 300; ++i) {
    std::vector<Pose> poses;
    for (int k = 0; k < 5; ++k) poses.push_back({3.0 * k + random.uniform(-0.5, 0.5), random.uniform(-1.5, 1.5), random.uniform(-1, 1)});
    for (const Continuity continuity : {Continuity::g1, Continuity::g2}) {
      const auto chain = chain_through(poses, continuity);
      ASSERT_TRUE(chain);
      const std::size_t per_leg = continuity == Continuity::g2 ? 3 : 1;
      ASSERT_EQ(chain->size(), per_leg * 4);
      for (std::size_t k = 0; k < chain->size(); ++k) {
        const CurvePoint end = evaluate((*chain)[k], (*chain)[k].length);
        const bool is_last = k + 1 == chain->size();
        const Pose next = is_last ? poses.back() : (*chain)[k + 1].start;
        EXPECT_LE(distance(end.position, next.position()), 1e-9);
        EXPECT_LE(std::abs(shorter_turn(end.course, next.heading)), 1e-9);
        if (continuity == Continuity::g2) {
          EXPECT_NEAR(end.curvature, is_last ? 0.0 : (*chain)[k + 1].curvature, 1e-8);
        }
        if ((k + 1) % per_leg == 0) {
          EXPECT_LE(distance(end.position, poses[(k + 1) / per_leg].position()), 1e-9);
        }
      }
    }
  }
}

TEST(Chain, IsSampledEvenly) {
  Random random{3};
  for (int i = 0; i < 50; ++i) {
    std::vector<Pose> poses;
    for (int k = 0; k < 4; ++k) poses.push_back({3.0 * k, random.uniform(-1.5, 1.5), random.uniform(-1, 1)});
    const Clothoids chain = *chain_through(poses, Continuity::g1);
    std::vector<Pose> samples;
    sample_evenly(chain, 100, samples);
    ASSERT_EQ(samples.size(), 100U);
    EXPECT_EQ(samples.front(), poses.front());
    EXPECT_LE(distance(samples.back().position(), poses.back().position()), 1e-9);
    const Path path = path_of(chain);
    double begin = 0.0;
    std::size_t leg = 0;
    for (std::size_t k = 0; k < 100; ++k) {
      const double s = length_of(chain) * static_cast<double>(k) / 99.0;
      while (leg + 1 < chain.size() && s > begin + chain[leg].length) begin += chain[leg++].length;
      EXPECT_LE(distance(evaluate(chain[leg], s - begin).position, samples[k].position()), 1e-9);
    }
  }
}

TEST(MapObjects, CornersAndWholeFootprintAgreeWithTheWorld) {
  for (const char* map : {"low", "medium", "high"}) {
    const Problem problem = Problem::prepare(fixture_scenario(map)).value();
    MapObjects objects{problem};
    Random random{4};
    std::vector<Pose> poses;
    for (int i = 0; i < 500; ++i) poses.push_back({random.uniform(-1, 14), random.uniform(-1, 12), random.uniform(-pi, pi)});
    TrajectoryMeasures corners, all, whole;
    objects.measure(poses, FitnessForm::published, false, corners);
    objects.measure(poses, FitnessForm::published, true, all);
    objects.measure(poses, FitnessForm::corrected, false, whole);
    EXPECT_EQ(corners.distance, all.distance);
    EXPECT_EQ(corners.depth, all.depth);
    EXPECT_GT(all.greatest, 5.0);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(whole.depth[i] > 0.0, problem.world().clearance(problem.footprint(), poses[i], 1.0).clearance == 0.0);
      EXPECT_GE(whole.depth[i], corners.depth[i]);
      EXPECT_LE(whole.distance[i], corners.distance[i] + 1e-9);
      // A corner's own clearance, asked of the world.
      double least = 1e9;
      for (const Vec2 corner : problem.footprint().polygon) {
        const Vec2 at = Frame{poses[i]}.to_world(corner);
        least = std::min(least, problem.world().clearance(std::span{&at, 1}, 0.0, 1e9).clearance);
      }
      EXPECT_NEAR(corners.distance[i], least, 1e-9);
    }
  }
}

}  // namespace
}  // namespace waywright
