// The search's verdict on candidates against plain code: the frozen yardstick of the benchmarks.
#include <gtest/gtest.h>

#include <cstdio>

#include "bench/docking_scene.hpp"
#include "bench/yardstick/plain_waypoints.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/proof/collision.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/planner/waypoint/candidates.hpp"
#include "waywright/planner/waypoint/distances.hpp"

namespace waywright {
namespace {

using bench::Clutter;

yardstick::Hall hall_of(const Scenario& s) {
  const auto polygon_of = [](const Ring& ring) {
    yardstick::Polygon polygon;
    for (const Vec2 p : ring) polygon.emplace_back(p.x, p.y);
    return polygon;
  };
  yardstick::Hall hall;
  hall.footprint = polygon_of(s.vehicle.footprint.polygon);
  hall.objects.push_back(polygon_of(s.map.boundaries.front()));
  for (const Ring& ring : s.map.obstacles) hall.objects.push_back(polygon_of(ring));
  return hall;
}

struct Verdicts {
  int free = 0;       ///< both
  int hit = 0;        ///< both
  int missed = 0;     ///< ours says hit, plain sees none at its poses, and there is one between them
  int cautious = 0;   ///< ours says hit, plain none, and there is none: within a millimetre of the wanted clearance
};

Verdicts compare(Clutter clutter, std::uint64_t seed, int count) {
  const Problem problem = Problem::prepare(bench::docking_scenario(clutter, seed)).value();
  const PreparedDocking prepared{problem};
  const yardstick::Scene scene = bench::scene_of(problem, problem.required_clearance());
  CandidateEvaluator evaluator{prepared};
  Random random{seed};
  Verdicts verdicts;
  for (int i = 0; i < count; ++i) {
    const DockingPattern pattern = bench::random_pattern(problem, prepared.task(), random);
    const CandidateScore ours = evaluator.evaluate(pattern);
    const yardstick::Verdict plain = yardstick::evaluate_boxes_first(scene, bench::candidate_of(pattern), lanes::samples);
    EXPECT_NEAR(ours.measures.curvature_change, plain.curvature_change, 1e-4 * plain.curvature_change + 1e-5);
    // At a near cusp the speed is a small difference of rounded numbers: the curvature of a circle of a millimetre is as good as any.
    const double rounding = plain.max_curvature < 1000.0 ? 1e-5 : 1e-4;
    EXPECT_GE(ours.measures.max_curvature, plain.max_curvature * (1.0 - rounding));
    if (ours.free && plain.hits == 0) {
      ++verdicts.free;
    } else if (!ours.free && plain.hits > 0) {
      ++verdicts.hit;
    } else if (ours.free) {
      ADD_FAILURE() << "candidate " << i << " was called free and hits at pose " << plain.first_hit;
    } else {
      // Plain looks at poses only. The proof's clearance of the whole motion tells who is right.
      const Motion motion{pattern_path(splines_of(pattern))};
      SweepMemory memory;
      const SweptClearance swept =
          swept_clearance(problem.world(), SweptBody{problem.vehicle().footprint}, motion.intervals(), {.tolerance = 1e-5}, memory);
      if (swept.upper <= problem.required_clearance()) {
        ++verdicts.missed;
      } else {
        ++verdicts.cautious;
        EXPECT_LT(swept.lower, prepared.wanted_clearance() + 0.0015) << "candidate " << i;
      }
    }
  }
  return verdicts;
}

void run(int count) {
  for (const Clutter clutter : {Clutter::boxes, Clutter::points}) {
    const Verdicts v = compare(clutter, 2, count);
    const char* name = clutter == Clutter::boxes ? "boxes" : "points";
    std::printf("%s: both free %d, both hit %d, hit between poses %d, within a millimetre and a half of the wanted clearance %d\n", name,
                v.free, v.hit, v.missed, v.cautious);
    EXPECT_GT(v.free, count / 200);
    EXPECT_GT(v.hit, count / 2);
    EXPECT_LT(v.cautious, count / 200);
  }
}

TEST(Yardstick, SameVerdictOnRandomCandidates) { run(4000); }
TEST(Yardstick, SameVerdictOnRandomCandidatesFull) { run(100000); }

// Distances of whole footprints among rings, against plain loops: what only crosses sides with sides the loops do not see.
TEST(Yardstick, SaysTheSameOfDistancesAlongTrajectories) {
  Random random{31};
  int contacts = 0, crossings = 0;
  for (int map = 0; map < 40; ++map) {
    Scenario s;
    s.map.boundaries = {rectangle({-6, -5}, {6, 5})};
    for (int i = 0; i < 12; ++i) {
      const Pose at{random.uniform(-5, 5), random.uniform(-4, 4), random.uniform(-pi, pi)};
      s.map.obstacles.push_back(transformed(rectangle({-random.uniform(0.1, 0.8), -0.2}, {random.uniform(0.1, 0.8), 0.3}), Frame{at}));
    }
    s.vehicle.footprint.polygon = {{-0.9, -0.275}, {0.9, -0.275}, {0.9, 0.275}, {-0.9, 0.275}};
    s.vehicle.drive = Differential{0.45};
    s.mission = Pose{1, 0, 0};
    const Problem problem = Problem::prepare(s).value();
    const yardstick::Hall hall = hall_of(s);
    std::vector<Pose> poses;
    std::vector<yardstick::Pose> plain;
    for (int i = 0; i < 100; ++i) {
      poses.push_back({random.uniform(-5, 5), random.uniform(-4, 4), random.uniform(-pi, pi)});
      plain.push_back({poses.back().x, poses.back().y, poses.back().heading});
    }
    TrajectoryMeasures ours;
    MapObjects{problem}.measure(poses, FitnessForm::corrected, false, ours);
    const yardstick::Distances loops = yardstick::distances_plain(hall, plain), boxes = yardstick::distances_boxes_first(hall, plain);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(boxes.distance[i], loops.distance[i]);
      if (ours.distance[i] > 0.0 || loops.distance[i] == 0.0) {
        EXPECT_NEAR(ours.distance[i], std::min(loops.distance[i], ours.reference), 1e-9);
        contacts += loops.distance[i] == 0.0;
        if (loops.depth[i] > 1e-5) {
          EXPECT_NEAR(ours.depth[i], loops.depth[i], 1e-9);
        }
      } else {
        ++crossings;
      }
    }
  }
  EXPECT_GT(contacts, 500);
  EXPECT_LT(crossings, 400);
}

TEST(Yardstick, FitsTheSameClothoids) {
  Random random{32};
  for (int i = 0; i < 2000; ++i) {
    const Pose a{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)}, b{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    const auto ours = fit_clothoid(a, b);
    const yardstick::FittedClothoid textbook = yardstick::fit_textbook({a.x, a.y, a.heading}, {b.x, b.y, b.heading});
    ASSERT_TRUE(ours);
    if (!(textbook.length < 40.0 * distance(a.position(), b.position()))) continue;  // there another turning is taken
    EXPECT_NEAR(ours->length, textbook.length, 1e-6 * ours->length);
  }
}

TEST(Yardstick, CandidatesThroughWaypointsCostTheSame) {
  Random random{33};
  int contacts = 0;
  for (int round = 0; round < 10; ++round) {
    Scenario s;
    s.map.boundaries = {rectangle({0, 0}, {24, 16})};
    for (int i = 0; i < 12; ++i) {
      const Vec2 at{random.uniform(1, 23), random.uniform(1, 15)};
      if (std::abs(at.y - 8.0) > 1.5) s.map.obstacles.push_back(rectangle(at, at + Vec2{random.uniform(0.3, 1.0), random.uniform(0.3, 1.0)}));
    }
    s.vehicle.footprint.polygon = {{-0.9, -0.275}, {0.9, -0.275}, {0.9, 0.275}, {-0.9, 0.275}};
    s.vehicle.drive = Differential{0.45};
    s.start = {1.5, 8, 0};
    s.mission = Pose{22, 8, 0};
    s.waypoints = {{8, random.uniform(7, 9)}, {15, random.uniform(7, 9)}};
    const Problem problem = Problem::prepare(s).value();
    const yardstick::Hall hall = hall_of(s);
    WaypointOptions options;
    options.objective = WaypointObjective::pwavg;
    options.continuity = Continuity::g1;
    WaypointCandidates candidates{problem, options};
    for (int i = 0; i < 40; ++i) {
      const std::vector<double> x{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
      const double plain = yardstick::candidate_plain(
          hall, {{1.5, 8, 0}, {s.waypoints[0].x, s.waypoints[0].y, x[0]}, {s.waypoints[1].x, s.waypoints[1].y, x[1]}, {22, 8, 0}}, options.samples);
      const double ours = candidates.evaluate(x).objective;
      if (plain < 1.0) {
        EXPECT_NEAR(ours, plain, 1e-9);
      } else {  // sides that cross without a corner inside are contact too, for ours
        EXPECT_GE(ours, plain - 1e-9);
        EXPECT_LE(ours, plain + 0.01);
      }
      contacts += plain >= 1.0;
    }
  }
  EXPECT_GT(contacts, 20);
  EXPECT_LT(contacts, 300);
}

}  // namespace
}  // namespace waywright
