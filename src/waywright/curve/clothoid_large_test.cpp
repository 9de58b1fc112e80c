// Clothoids that turn many times over: spirals of 100 to 1000 rad.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

/// One of `turning` rad in all (both ways, where the curvature changes its sign on the way), of a length between a millimetre and a kilometre.
Clothoid spiral(Random& random) {
  const double length = std::pow(10.0, random.uniform(-3, 3));
  const double turning = random.uniform(100, 1000) * (random.uniform() < 0.5 ? -1.0 : 1.0);
  const double share = random.uniform(-1, 1);  // of the turning that is there from the start
  const double curvature = share * turning / length;
  return {{random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-pi, pi)}, curvature, 2.0 * (turning / length - curvature) / length, length};
}

double most_turning(const Clothoid& c) { return greatest_curvature(c) * c.length; }

/// What the header promises of a position, with some roundings of the coordinates themselves.
double allowed(const Clothoid& c, double s) { return (2e-14 + 4e-16 * most_turning(c)) * std::abs(s) + 1e-14; }

/// The place after s metres from outside: Simpson's rule with Richardson's step in long double, steps of a hundredth of a radian or less.
Vec2 place_by_simpson(const Clothoid& c, double s) {
  const auto sum = [&](int n) {
    long double x = 0, y = 0;
    const long double h = static_cast<long double>(s) / n;
    for (int i = 0; i <= 2 * n; ++i) {
      const long double at = 0.5L * h * i;
      const long double weight = (i == 0 || i == 2 * n ? 1.0L : i % 2 == 1 ? 4.0L : 2.0L) * h / 6.0L;
      const long double course = static_cast<long double>(c.start.heading) + at * (static_cast<long double>(c.curvature) + 0.5L * static_cast<long double>(c.curvature_rate) * at);
      x += weight * std::cos(course);
      y += weight * std::sin(course);
    }
    return std::pair{x, y};
  };
  const int n = 40 + static_cast<int>(100.0 * most_turning(c));
  const auto coarse = sum(n), fine = sum(2 * n);
  return {static_cast<double>(static_cast<long double>(c.start.x) + fine.first + (fine.first - coarse.first) / 15.0L),
          static_cast<double>(static_cast<long double>(c.start.y) + fine.second + (fine.second - coarse.second) / 15.0L)};
}

TEST(ClothoidLarge, PlacesAreAsExactAsPromised) {
  Random random{11};
  for (int i = 0; i < 60; ++i) {
    const Clothoid c = spiral(random);
    const ClothoidPanels panels{c};
    for (const double share : {random.uniform(), 1.0}) {
      const double s = share * c.length;
      const Vec2 exact = place_by_simpson(c, s);
      const CurvePoint alone = evaluate(c, s), kept = panels.at(s);
      EXPECT_LE(distance(alone.position, exact), allowed(c, c.length)) << i << " " << c.length << " " << most_turning(c);
      EXPECT_LE(distance(kept.position, exact), allowed(c, c.length)) << i << " " << c.length << " " << most_turning(c);
      EXPECT_LE(std::abs(shorter_turn(alone.course, course_at(c, s))), 1e-12 * most_turning(c));
      EXPECT_EQ(alone.course, kept.course);
    }
  }
}

TEST(ClothoidLarge, TheOtherWayAndTheRestPassTheSamePlaces) {
  Random random{12};
  for (int i = 0; i < 200; ++i) {
    const Clothoid c = spiral(random);
    const Clothoid back = reversed(c);
    const double s = random.uniform(0.0, c.length);
    // Rounding of the end's pose and course goes over all of the way.
    const double rounding = 1e-12 * c.length + 4.0 * allowed(c, c.length);
    EXPECT_LE(distance(evaluate(back, c.length - s).position, evaluate(c, s).position), rounding) << i;
    const Clothoid rest = rest_from(c, s);
    EXPECT_NEAR(rest.length, c.length - s, 1e-15 * c.length);
    EXPECT_LE(distance(evaluate(rest, rest.length).position, evaluate(c, c.length).position), rounding) << i;
  }
}

TEST(ClothoidLarge, TheNearestPlaceIsNearerThanAllOthers) {
  Random random{13};
  for (int i = 0; i < 40; ++i) {
    const Clothoid c = spiral(random);
    const ClothoidPanels panels{c};
    const Vec2 middle = evaluate(c, random.uniform(0.0, c.length)).position;
    const double spread = std::pow(10.0, random.uniform(-4, 0)) * c.length;
    const Vec2 point = middle + Vec2{random.uniform(-spread, spread), random.uniform(-spread, spread)};
    const double tolerance = std::max(1e-12, 1e-9 * c.length);
    const NearestPoint nearest = nearest_point(c, point, tolerance);
    EXPECT_GE(nearest.s, 0.0);
    EXPECT_LE(nearest.s, c.length);
    EXPECT_NEAR(distance(evaluate(c, nearest.s).position, point), nearest.distance, allowed(c, c.length) + 1e-14);
    constexpr int places = 20'000;
    for (int k = 0; k <= places; ++k) {
      ASSERT_GE(distance(panels.at(c.length * k / places).position, point), nearest.distance - tolerance - 2.0 * allowed(c, c.length)) << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace waywright
