#include "waywright/proof/directions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/geometry/stretches.hpp"

namespace waywright {
namespace {

Zone one_way(Ring area, double direction, std::string name = "aisle") {
  Zone zone;
  zone.type = ZoneType::directed;
  zone.area = std::move(area);
  zone.direction = wrap(direction);
  zone.name = std::move(name);
  return zone;
}

Problem problem_with(std::vector<Zone> zones, const Path& path) {
  Scenario s;
  s.vehicle.footprint.disc = 0.1;
  s.vehicle.drive = Differential{0.5};
  s.start = start_pose(path);
  s.mission = end_pose(path);
  s.zones = std::move(zones);
  return Problem::prepare(std::move(s)).value();
}

/// The sentences of a path in one zone from (0, 0) to (10, 4) with a direction.
std::string said(const Path& path, double direction) {
  const Proof proof = prove(problem_with({one_way(rectangle({0, 0}, {10, 4}), direction)}, path), path);
  std::string text;
  for (const Violation& v : proof.violations) text += (text.empty() ? "" : "; ") + v.sentence;
  return text;
}

TEST(Directions, AStraightWayAgainstOneIsNamedWithItsPlace) {
  const Path east{{{Line{{-1, 2}, {11, 2}}, 1}}};
  EXPECT_EQ(said(east, 0.0), "");
  EXPECT_EQ(said(east, 1.5), "");
  EXPECT_EQ(said(east, pi / 2), "");
  EXPECT_EQ(said(east, pi / 2 + 0.002), "in zone \"aisle\" at (0.001, 2.000) the vehicle drives 90.1° off the zone's direction, and at most 90° are allowed");
  EXPECT_EQ(said(east, pi), "in zone \"aisle\" at (0.001, 2.000) the vehicle drives 180.0° off the zone's direction, and at most 90° are allowed");
}

// What counts is where it drives to, not where it looks.
TEST(Directions, BackingAlongTheDirectionIsAllowedAndAgainstItIsNot) {
  const Path backwards{{{Line{{1, 2}, {9, 2}}, -1}}};
  EXPECT_EQ(said(backwards, 0.0), "");
  EXPECT_NE(said(backwards, pi), "");
}

TEST(Directions, TurningOnTheSpotIsAllowed) {
  const Path path{{{Turn{{5, 2}, 0.0, pi}, 0}, {Line{{5, 2}, {5, 6}}, -1}}};
  Path turned = path;
  turned.pieces.pop_back();
  EXPECT_EQ(said(turned, 0.0), "");
}

TEST(Directions, BesideAndAMillimetreInsideItDoesNotHold) {
  EXPECT_EQ(said(Path{{{Line{{11, 4}, {-1, 4}}, 1}}}, 0.0), "");
  EXPECT_EQ(said(Path{{{Line{{11, 3.9995}, {-1, 3.9995}}, 1}}}, 0.0), "");
  EXPECT_NE(said(Path{{{Line{{11, 3.998}, {-1, 3.998}}, 1}}}, 0.0), "");
}

// A half circle of radius 1 from (3, 1) over (4, 2) to (3, 3): it drives east, north and west; in a zone that goes north all of it is allowed.
TEST(Directions, OfAnArcTheWorstPlaceDecides) {
  const Path arc{{{Arc{{3, 1, 0}, 1.0, pi}, 1}}};
  EXPECT_EQ(said(arc, pi / 2), "");
  EXPECT_NE(said(arc, pi / 2 + 0.01), "");
  EXPECT_NE(said(arc, pi / 2 - 0.01), "");
  const Path quarter{{{Arc{{3, 1, 0}, 1.0, 0.5 * pi}, 1}}};
  EXPECT_EQ(said(quarter, 0.0), "");
  const Path more{{{Arc{{3, 1, 0}, 1.0, 0.5 * pi + 0.01}, 1}}};
  EXPECT_NE(said(more, 0.0), "");
}

// Curves of every kind against samples of them: a violation that samples show is found; where the samples stay clear of the rule by a margin, none is told.
TEST(Directions, CurvesAreJudgedAsTheirSamplesShow) {
  Random random{77};
  int broken = 0, kept = 0;
  for (int i = 0; i < 600; ++i) {
    Path path;
    const Pose at{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    const int direction = i % 2 == 0 ? 1 : -1;
    if (i % 3 == 0) {
      path.pieces.push_back({Arc{at, random.uniform(-1.5, 1.5), random.uniform(0.5, 4)}, direction});
    } else if (i % 3 == 1) {
      path.pieces.push_back({Clothoid{at, random.uniform(-1, 1), random.uniform(-0.5, 0.5), random.uniform(0.5, 4)}, direction});
    } else {
      const Vec2 along = unit(at.heading);
      BezierSpan span;
      span.degree = 3;
      span.control = {at.position(), at.position() + random.uniform(0.5, 2) * along, at.position() + 3.0 * along + random.uniform(-1.5, 1.5) * left_of(along),
                      at.position() + 4.0 * along + random.uniform(-2, 2) * left_of(along)};
      path.pieces.push_back({Spline{SplineKind::natural_cubic, {span}}, direction});
    }
    const Zone zone = one_way({{-2, -1.5}, {1.5, -2}, {2, 1}, {0, 0.2}, {-1.5, 2}}, random.uniform(-pi, pi));
    const Problem problem = problem_with({zone}, path);
    bool is_broken = false, is_close = false;
    for (const Sample& s : sample(path, 0.1, 1e-6, 0.002)) {
      const double off = std::abs(shorter_turn(zone.direction, s.course));
      const double deep = depth_in(zone.area, s.pose().position());
      is_broken = is_broken || (off > pi / 2 + zone_course + 1e-6 && deep > zone_depth + 1e-6);
      is_close = is_close || (off > pi / 2 + zone_course - 0.01 && contains(zone.area, s.pose().position()));
    }
    const auto found = check_directions(problem, path, Motion{path}, {});
    if (is_broken) {
      ++broken;
      ASSERT_EQ(found.size(), 1U) << i;
      ASSERT_NE(found[0].sentence.find("off the zone's direction"), std::string::npos) << found[0].sentence;
      ASSERT_GE(depth_in(zone.area, found[0].where->position()), zone_depth - 1e-9);
    } else if (!is_close) {
      ++kept;
      ASSERT_TRUE(found.empty()) << i << ": " << found[0].sentence;
    }
  }
  EXPECT_GT(broken, 100);
  EXPECT_GT(kept, 100);
}

/// Poses along y = 2 from x = 1, each step so far on, with noise.
Path poses(double step, int count, double noise) {
  Random random{3};
  PoseSequence sequence;
  for (int i = 0; i < count; ++i) sequence.poses.push_back({1.0 + (step < 0 ? 8.0 : 0.0) + i * step + random.uniform(-noise, noise), 2.0, step < 0 ? pi : 0.0});
  return Path{{{sequence, 1}}};
}

TEST(Directions, NoiseOfOutsidePosesIsNoDriving) {
  const auto found = [](const Path& path) {
    return check_directions(problem_with({one_way(rectangle({0, 0}, {10, 4}), 0.0)}, path), path, Motion{path}, {});
  };
  EXPECT_TRUE(found(poses(0.01, 800, 0.002)).empty());
  EXPECT_TRUE(found(poses(0.001, 800, 0.003)).empty());
  const auto against = found(poses(-0.01, 800, 0.002));
  ASSERT_EQ(against.size(), 1U);
  EXPECT_NE(against[0].sentence.find("back against the zone's direction"), std::string::npos) << against[0].sentence;
  EXPECT_EQ(found(poses(-0.5, 10, 0.0)).size(), 1U);
}

TEST(Directions, EachZoneHasItsOwnSentence) {
  const Path path{{{Line{{9, 2}, {1, 2}}, 1}}};
  const Problem problem = problem_with({one_way(rectangle({0, 0}, {4, 4}), 0.0, "west end"), one_way(rectangle({5, 0}, {10, 4}), 0.0, ""), one_way(rectangle({0, 5}, {10, 9}), 0.0)}, path);
  const auto found = check_directions(problem, path, Motion{path}, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].sentence.find("zone \"west end\""), std::string::npos);
  EXPECT_NE(found[1].sentence.find("zone 1"), std::string::npos);
}

}  // namespace
}  // namespace waywright
