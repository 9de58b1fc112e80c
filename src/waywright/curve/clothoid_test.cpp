#include "waywright/curve/clothoid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/curve/arc.hpp"

namespace waywright {
namespace {

struct Far {
  long double x = 0, y = 0;
};

/// End of a clothoid that starts at the origin, from outside: Simpson's rule with Richardson's step in long double, steps of a hundredth of a radian or less.
Far end_by_simpson(const Clothoid& c) {
  const auto sum = [&](int n) {
    Far far;
    const long double h = static_cast<long double>(c.length) / n;
    for (int i = 0; i <= 2 * n; ++i) {
      const long double s = 0.5L * h * i;
      const long double weight = (i == 0 || i == 2 * n ? 1.0L : i % 2 == 1 ? 4.0L : 2.0L) * h / 6.0L;
      const long double course = static_cast<long double>(c.start.heading) + s * (static_cast<long double>(c.curvature) + 0.5L * static_cast<long double>(c.curvature_rate) * s);
      far.x += weight * std::cos(course);
      far.y += weight * std::sin(course);
    }
    return far;
  };
  const int n = 40 + static_cast<int>(100.0 * greatest_curvature(c) * c.length);
  const Far coarse = sum(n), fine = sum(2 * n);
  return {fine.x + (fine.x - coarse.x) / 15.0L, fine.y + (fine.y - coarse.y) / 15.0L};
}

double missed(const Clothoid& c, Vec2 end) {
  const Far far = end_by_simpson(c);
  return static_cast<double>(std::hypot(far.x - static_cast<long double>(end.x), far.y - static_cast<long double>(end.y)));
}

void expect_fits(Vec2 end, double from, double to, double* longest = nullptr) {
  const Pose a{0, 0, from}, b = make_pose(end, to);
  const auto c = fit_clothoid(a, b);
  ASSERT_TRUE(c) << end.x << " " << end.y << " " << from << " " << to;
  const double chord = norm(end);
  EXPECT_LE(missed(*c, end), 1e-11 * chord) << end.x << " " << end.y << " " << from << " " << to;
  EXPECT_LE(distance(evaluate(*c, c->length).position, end), 1e-11 * chord);
  EXPECT_LE(std::abs(shorter_turn(course_at(*c, c->length), to)), 1e-11);
  if (longest != nullptr) *longest = std::max(*longest, c->length / chord);
}

/// Headings against the chord that come near to where solutions end, or are symmetrical.
constexpr std::array hard{0.0, 1e-12, -1e-9, 1e-4, -0.5 * pi, 0.5 * pi, 3.0, -3.0, pi - 1e-4, -pi + 1e-4, pi - 1e-9, -pi + 1e-9, pi, -pi};

void fit_many(int count, std::uint64_t seed) {
  Random random{seed};
  for (int i = 0; i < count; ++i) {
    const double scale = std::pow(10.0, random.uniform(-6, 6));
    expect_fits({scale * random.uniform(-1, 1), scale * random.uniform(-1, 1)}, random.uniform(-pi, pi), random.uniform(-pi, pi));
    if (testing::Test::HasFailure()) return;
  }
}

TEST(ClothoidFit, MeetsBothPosesAgainstHighPrecision) { fit_many(3'000, 1); }
TEST(ClothoidFitFull, MeetsAMillionPairsOfPoses) { fit_many(1'000'000, 2); }

/// Batches of many against single fits, and where they end.
void fit_batches(int count, std::uint64_t seed) {
  Random random{seed};
  std::vector<Pose> from, to;
  for (int i = 0; i < count; ++i) {
    const double scale = std::pow(10.0, random.uniform(-6, 6));
    from.push_back({0, 0, random.uniform(-pi, pi)});
    to.push_back({scale * random.uniform(-1, 1), scale * random.uniform(-1, 1), random.uniform(-pi, pi)});
  }
  for (const double a : hard) {
    for (const double b : hard) {
      from.push_back({0, 0, a});
      to.push_back({1, 0, b});
    }
  }
  from.push_back({1, 1, 0});  // nothing between
  to.push_back({1, 1, 1});
  std::vector<std::optional<Clothoid>> fitted(from.size());
  fit_clothoid_batch(from, to, fitted);
  EXPECT_FALSE(fitted.back());
  for (std::size_t i = 0; i + 1 < from.size(); ++i) {
    ASSERT_TRUE(fitted[i]) << from[i].heading << ' ' << to[i].x << ' ' << to[i].y << ' ' << to[i].heading;
    const double chord = distance(from[i].position(), to[i].position());
    const Clothoid& c = *fitted[i];
    ASSERT_LE(distance(evaluate(c, c.length).position, to[i].position()), 1e-11 * chord) << from[i].heading << ' ' << to[i].heading;
    ASSERT_LE(std::abs(shorter_turn(course_at(c, c.length), to[i].heading)), 1e-11);
    ASSERT_NEAR(fit_clothoid(from[i], to[i])->length, c.length, 1e-9 * c.length) << from[i].heading << ' ' << to[i].heading;
  }
}

TEST(ClothoidFit, BatchesAreTheSameCurves) { fit_batches(20'000, 4); }
TEST(ClothoidFitFull, BatchesAreTheSameCurvesAMillionTimes) { fit_batches(1'000'000, 5); }

TEST(ClothoidFit, MeetsHardHeadingsAtAllScales) {
  double longest = 0.0;
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const double course : {0.0, 1.0, pi}) {
      for (const double from : hard) {
        for (const double to : hard) expect_fits(scale * unit(course), course + from, course + to, &longest);
      }
    }
  }
  EXPECT_LE(longest, 50.0);
}

TEST(ClothoidFit, KnownCurves) {
  struct Known {
    Vec2 end;
    double from, to, length, curvature, rate;  // degrees; mm, 1/mm, 1/mm²
  };
  const std::vector<Known> known{
      {{1000, 1000}, 0, 90, 1570.796327, 1.0e-3, 0},
      {{2000, 0}, 30, -30, 2094.395102, -5.0e-4, 0},
      {{2000, 1000}, 0, 0, 2284.604575, 1.215159e-3, -1.0638e-6},
      {{3000, 3000}, 0, 0, 4511.673277, 1.038254e-3, -4.6025e-7},
      {{2000, 0}, 60, 60, 2230.250148, -2.787008e-3, 2.4993e-6},
      {{1000, 0}, 150, -100, 2634.402577, -2.282488e-3, 4.7540e-7},
      {{-1500, 500}, 0, 180, 2610.450423, 3.551233e-3, -1.7987e-6},
  };
  for (const Known& k : known) {
    const auto c = fit_clothoid({0, 0, k.from * pi / 180}, make_pose(k.end, k.to * pi / 180));
    ASSERT_TRUE(c);
    EXPECT_NEAR(c->length, k.length, 1e-6);
    EXPECT_NEAR(c->curvature, k.curvature, 1e-9);
    EXPECT_NEAR(c->curvature_rate, k.rate, 1e-10);
  }
}

TEST(ClothoidFit, IsTheSameTurnedMovedMirroredAndBackwards) {
  Random random{3};
  for (int i = 0; i < 500; ++i) {
    const Pose a{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    const Pose b{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    const auto c = fit_clothoid(a, b);
    ASSERT_TRUE(c);
    const Frame frame{{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-pi, pi)}};
    const auto moved = fit_clothoid(frame.to_world(a), frame.to_world(b));
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->length, c->length, 1e-9 * c->length);
    EXPECT_NEAR(moved->curvature, c->curvature, 1e-8);
    const auto mirrored = fit_clothoid({a.x, -a.y, -a.heading}, {b.x, -b.y, -b.heading});
    ASSERT_TRUE(mirrored);
    EXPECT_NEAR(mirrored->length, c->length, 1e-9 * c->length);
    EXPECT_NEAR(mirrored->curvature, -c->curvature, 1e-8);
    const auto back = fit_clothoid(make_pose(b.position(), wrap(b.heading + pi)), make_pose(a.position(), wrap(a.heading + pi)));
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->length, c->length, 1e-9 * c->length);
    EXPECT_NEAR(back->curvature, -end_curvature(*c), 1e-8);
  }
}

TEST(ClothoidFit, RefusesWhatHasNoSolution) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fit_clothoid({1, 2, 0}, {1, 2, 1}));
  EXPECT_FALSE(fit_clothoid({1, 2, nan}, {3, 2, 1}));
  EXPECT_FALSE(fit_clothoid({1, 2, 0}, {nan, 2, 1}));
  EXPECT_FALSE(fit_clothoid({1, 2, 0}, {1e308, -1e308, 1}));
}

Clothoid random_clothoid(Random& random) {
  return {{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)}, random.uniform(-1, 1), random.uniform(-0.5, 0.5), random.uniform(0.1, 12)};
}

TEST(Clothoid, EvaluatesToTheIntegral) {
  Random random{4};
  for (int i = 0; i < 300; ++i) {
    Clothoid c = random_clothoid(random);
    c.start.x = c.start.y = 0.0;
    if (i % 10 == 0) c.curvature_rate *= 40.0;
    EXPECT_LE(missed(c, evaluate(c, c.length).position), 2e-14 * (1.0 + greatest_curvature(c) * c.length) * c.length);
  }
}

TEST(Clothoid, IsAnArcWhereItsCurvatureStays) {
  Random random{5};
  for (int i = 0; i < 200; ++i) {
    Clothoid c = random_clothoid(random);
    c.curvature_rate = 0.0;
    const CurvePoint arc = evaluate(Arc{c.start, c.curvature, c.length}, c.length);
    EXPECT_EQ(evaluate(c, c.length).position, arc.position);
    c.curvature_rate = 1e-13;
    EXPECT_LE(distance(evaluate(c, c.length).position, arc.position), 1e-10);
  }
}

TEST(Clothoid, PanelsGiveTheSamePlaces) {
  Random random{6};
  for (int i = 0; i < 200; ++i) {
    const Clothoid c = random_clothoid(random);
    const ClothoidPanels panels{c};
    for (const double share : {0.0, 0.21, 0.5, 0.77, 1.0}) {
      const CurvePoint a = evaluate(c, share * c.length), b = panels.at(share * c.length);
      EXPECT_LE(distance(a.position, b.position), 1e-13);
      EXPECT_EQ(a.course, b.course);
      EXPECT_EQ(a.curvature, b.curvature);
    }
  }
}

TEST(Clothoid, SamplesAreTheirPlaces) {
  Random random{21};
  for (int i = 0; i < 2000; ++i) {
    const Clothoid c{{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)}, random.uniform(-1, 1) * std::pow(10.0, random.uniform(-3, 2)),
                     i % 10 == 0 ? 0.0 : random.uniform(-1, 1) * std::pow(10.0, random.uniform(-3, 2)), std::pow(10.0, random.uniform(-2, 1))};
    const auto n = static_cast<std::size_t>(random.integer(0, 40));
    const double begin = i % 4 == 0 ? 0.0 : random.uniform(0, 0.3) * c.length;
    const double step = n > 1 ? (c.length - begin) / static_cast<double>(n - 1) : 0.0;
    std::vector<Pose> poses;
    sample_clothoid(c, begin, step, n, poses);
    ASSERT_EQ(poses.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
      const CurvePoint truth = evaluate(c, begin + static_cast<double>(k) * step);
      EXPECT_LE(distance(poses[k].position(), truth.position), 1e-12 * (1.0 + c.length)) << i << ' ' << k;
      EXPECT_LE(std::abs(shorter_turn(poses[k].heading, truth.course)), 1e-12 * (1.0 + greatest_curvature(c) * c.length));
    }
  }
}

TEST(Clothoid, RestAndReverseAreTheSameCurve) {
  Random random{7};
  for (int i = 0; i < 200; ++i) {
    const Clothoid c = random_clothoid(random);
    const double s = random.uniform(0.1, 0.9) * c.length;
    const Clothoid rest = rest_from(c, s);
    EXPECT_LE(distance(evaluate(rest, rest.length).position, evaluate(c, c.length).position), 1e-12);
    EXPECT_NEAR(end_curvature(rest), end_curvature(c), 1e-12);
    const Clothoid back = reversed(c);
    EXPECT_LE(distance(evaluate(back, c.length - s).position, evaluate(c, s).position), 1e-12);
    const Clothoid twice = reversed(back);
    EXPECT_LE(distance(twice.start.position(), c.start.position()), 1e-12);
    EXPECT_NEAR(twice.curvature, c.curvature, 1e-12);
  }
}

TEST(Clothoid, NearestPointIsNoFartherThanAnySample) {
  Random random{8};
  for (int i = 0; i < 200; ++i) {
    const Clothoid c = random_clothoid(random);
    const Vec2 q{random.uniform(-8, 8), random.uniform(-8, 8)};
    const NearestPoint nearest = nearest_point(c, q);
    EXPECT_NEAR(distance(evaluate(c, nearest.s).position, q), nearest.distance, 1e-12);
    double least = 1e9;
    for (int k = 0; k <= 2000; ++k) least = std::min(least, distance(evaluate(c, c.length * k / 2000).position, q));
    EXPECT_LE(nearest.distance, least + 1e-9);
    EXPECT_GE(nearest.distance, least - 0.01);
  }
  // From the centre of an arc every place is as far.
  const Clothoid arc{{1, 0, 0.5 * pi}, 1.0, 0.0, 3.0};
  EXPECT_NEAR(nearest_point(arc, {0, 0}, 1e-6).distance, 1.0, 1e-6);
}

TEST(Clothoid, OffsetKeepsItsDistanceAndCurvature) {
  Random random{9};
  for (int i = 0; i < 200; ++i) {
    const Clothoid c = random_clothoid(random);
    const double s = random.uniform(0.2, 0.8) * c.length, left = random.uniform(-0.4, 0.4);
    const CurvePoint on = evaluate(c, s), beside = offset_point(c, s, left);
    EXPECT_NEAR(distance(on.position, beside.position), std::abs(left), 1e-12);
    const double h = 1e-4;
    const Vec2 a = offset_point(c, s - h, left).position, b = offset_point(c, s + h, left).position;
    const double turned = shorter_turn(offset_point(c, s - h, left).course, offset_point(c, s + h, left).course);
    if (1.0 - left * on.curvature <= 0.1) continue;
    EXPECT_NEAR(beside.curvature, turned / distance(a, b), 1e-5 * (1.0 + std::abs(beside.curvature)));
  }
}

}  // namespace
}  // namespace waywright
