#include "waywright/dxf/spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright::dxf {
namespace {

/// By the recursion of Cox and de Boor, which shares nothing with what is tested.
double basis(const std::vector<double>& t, std::size_t i, int p, double u) {
  if (p == 0) return u >= t[i] && u < t[i + 1] ? 1.0 : 0.0;
  const auto q = static_cast<std::size_t>(p);
  const double a = t[i + q] > t[i] ? (u - t[i]) / (t[i + q] - t[i]) * basis(t, i, p - 1, u) : 0.0;
  const double b = t[i + q + 1] > t[i + 1] ? (t[i + q + 1] - u) / (t[i + q + 1] - t[i + 1]) * basis(t, i + 1, p - 1, u) : 0.0;
  return a + b;
}

Vec2 at(const SplineCurve& curve, double u) {
  double w = 0.0;
  Vec2 sum{};
  for (std::size_t i = 0; i < curve.controls.size(); ++i) {
    const double b = basis(curve.knots, i, curve.degree, u) * (curve.weights.empty() ? 1.0 : curve.weights[i]);
    w += b;
    sum = sum + b * curve.controls[i];
  }
  return (1.0 / w) * sum;
}

double distance_to(const std::vector<Vec2>& line, Vec2 p) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 d = line[i + 1] - line[i];
    const double t = squared_norm(d) > 0.0 ? std::clamp(dot(p - line[i], d) / squared_norm(d), 0.0, 1.0) : 0.0;
    least = std::min(least, distance(p, line[i] + t * d));
  }
  return least;
}

TEST(Spline, RandomOnesKeepTheTolerance) {
  Random random = Random::stream(7, 0);
  double worst_share = 0.0;
  for (int run = 0; run < 300; ++run) {
    SplineCurve curve;
    curve.degree = static_cast<int>(random.integer(1, 5));
    const auto n = static_cast<std::size_t>(curve.degree + random.integer(1, 8));
    for (std::size_t i = 0; i < n; ++i) curve.controls.push_back({random.uniform(-100, 100), random.uniform(-100, 100)});
    if (run % 2 == 0) {
      for (std::size_t i = 0; i < n; ++i) curve.weights.push_back(random.uniform(0.2, 5.0));
    }
    double knot = 0.0;
    const auto p = static_cast<std::size_t>(curve.degree);
    for (std::size_t i = 0; i < n + p + 1; ++i) {
      const bool clamped = run % 3 != 0 && (i <= p || i > n);
      if (i > 0 && (!clamped || i == n + 1 || i == p + 1) && random.integer(0, 4) > 0) knot += random.uniform(0.1, 2.0);
      curve.knots.push_back(knot);
    }
    if (!(curve.knots[n] > curve.knots[p])) continue;
    const double tolerance = 0.05;
    const auto found = chords(curve, tolerance);
    const auto* corners = std::get_if<std::vector<Vec2>>(&found);
    ASSERT_NE(corners, nullptr) << std::get<std::string>(found);
    for (int i = 0; i < 2000; ++i) {
      const double u = curve.knots[p] + (curve.knots[n] - curve.knots[p]) * i / 2000.0;
      const double off = distance_to(*corners, at(curve, u));
      ASSERT_LE(off, tolerance * (1 + 1e-6)) << "run " << run << " at " << u;
      worst_share = std::max(worst_share, off / tolerance);
    }
  }
  EXPECT_GT(worst_share, 0.2);
}

TEST(Spline, ACircleByWeights) {
  const double r = std::sqrt(0.5);
  SplineCurve curve{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}, {1, r, 1, r, 1, r, 1, r, 1}};
  const auto corners = std::get<std::vector<Vec2>>(chords(curve, 1e-4));
  for (const Vec2 p : corners) EXPECT_NEAR(norm(p), 1.0, 1e-12);
  EXPECT_LT(corners.size(), 600u);
}

TEST(Spline, WhatIsNoneIsRefused) {
  const SplineCurve good{1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {}};
  EXPECT_TRUE(std::holds_alternative<std::vector<Vec2>>(chords(good, 0.1)));
  const auto refused = [&](auto change) {
    SplineCurve curve = good;
    change(curve);
    return std::holds_alternative<std::string>(chords(curve, 0.1));
  };
  EXPECT_TRUE(refused([](SplineCurve& c) { c.degree = 0; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.degree = 99; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.degree = 2; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.knots = {0, 1}; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.knots = {0, 1, 0, 1}; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.knots = {1, 1, 1, 1}; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.weights = {1, 0}; }));
  EXPECT_TRUE(refused([](SplineCurve& c) { c.weights = {1}; }));
}

}  // namespace
}  // namespace waywright::dxf
