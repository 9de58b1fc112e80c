// Chords of curves: nothing of a curve on the wrong side of them, and neither farther from the other than the tolerance.
#include "waywright/dxf/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/angle.hpp"
#include "waywright/core/random.hpp"

namespace waywright::dxf {
namespace {

double distance_to(const Polyline& line, Vec2 p, bool closed) {
  double least = 1e300;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Vec2 a = line[i], d = line[(i + 1) % line.size()] - a;
    const double t = squared_norm(d) > 0.0 ? std::clamp(dot(p - a, d) / squared_norm(d), 0.0, 1.0) : 0.0;
    least = std::min(least, distance(p, a + t * d));
  }
  return least;
}

struct Affine {
  Vec2 x{1.0, 0.0}, y{0.0, 1.0}, at{};
  Vec2 operator()(Vec2 p) const { return at + p.x * x + p.y * y; }
};

Chain moved(Chain chain, const Affine& to) {
  for (Knot& knot : chain) knot.at = to(knot.at);
  return chain;
}

/// A bulge's arc by its centre and angles, with 300 points and its end left out.
void sample_arc(Polyline& into, Vec2 a, Vec2 b, double bulge) {
  constexpr int count = 300;
  const double angle = 4.0 * std::atan(bulge), chord = distance(a, b);
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / count;
    if (std::abs(bulge) < 1e-6 || chord == 0.0) {  // rises by parts in a million of its chord: a parabola
      into.push_back(a + t * (b - a) - 2.0 * bulge * t * (1.0 - t) * left_of(b - a));
      continue;
    }
    // Turned about the first corner: chord of the angle so far, in the direction of the tangent there turned by half of it.
    const double so_far = t * angle, radius = 0.5 * chord / std::sin(0.5 * std::abs(angle)), reach = 2.0 * radius * std::sin(0.5 * std::abs(so_far));
    const double heading = std::atan2(b.y - a.y, b.x - a.x) - 0.5 * angle + 0.5 * so_far;
    into.push_back(a + reach * unit(heading));
  }
}

struct Figure {
  Chain chain;  // closed, the first corner not repeated
  Polyline curve;
};

/// A star-shaped outline of lines and arcs; some arcs bend in, and some corners stand twice.
Figure random_figure(Random& random) {
  Figure figure;
  const double size = std::pow(10.0, random.uniform(-3.0, 3.0));
  const auto n = random.integer(2, 7);
  const double sense = random.integer(0, 1) == 0 ? 1.0 : -1.0;
  std::vector<Vec2> corners;
  for (int k = 0; k < n; ++k) corners.push_back(size * random.uniform(0.9, 1.0) * unit(sense * two_pi * k / static_cast<double>(n)));
  if (random.integer(0, 3) == 0) corners.push_back(corners.back());
  figure.chain.push_back({corners.front()});
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 from = corners[k], to = corners[(k + 1) % corners.size()];
    const double small = std::pow(10.0, random.uniform(-9.0, -2.0));
    double bulge = 0.0;
    switch (random.integer(0, 4)) {
      case 0: bulge = n == 2 ? sense : 0.0; break;
      case 1: bulge = random.integer(0, 1) == 0 ? small : -small; break;
      case 2: bulge = sense * random.uniform(0.9, 1.1); break;
      default: bulge = n == 2 ? sense * random.uniform(0.1, 3.0) : random.uniform(-0.1, 0.5); break;
    }
    if (n > 2) bulge = std::clamp(sense * bulge, -0.1, 0.6) * sense;
    add_arc(figure.chain, to, bulge);
    sample_arc(figure.curve, from, to, bulge);
  }
  figure.chain.pop_back();
  return figure;
}

/// Every point of the curve and every point of the chords, after shears, mirrors and moves, with tolerances that are small and large against it.
TEST(Outline, ChordsLieToOneSideOfTheCurveAndWithinTheTolerance) {
  Random random = Random::stream(31, 0);
  int simple = 0;
  for (int run = 0; run < 500; ++run) {
    const Figure figure = random_figure(random);
    Affine to;
    const double turn = random.uniform(-pi, pi), stretch = std::pow(10.0, random.uniform(-1.5, 1.5));
    to.x = stretch * unit(turn);
    to.y = std::pow(10.0, random.uniform(-1.5, 1.5)) * unit(turn + random.uniform(0.3, pi - 0.3));
    if (run % 2 == 1) to.y = -1.0 * to.y;
    if (run % 3 == 0) to.at = {random.uniform(-1e6, 1e6), random.uniform(-1e6, 1e6)};
    const Chain chain = moved(figure.chain, to);
    Polyline curve;
    for (const Vec2 p : figure.curve) curve.push_back(to(p));
    const Box box = bounding_box(curve);
    const double size = norm(box.high - box.low), tolerance = size * std::pow(10.0, random.uniform(-5.0, 1.0));
    const double rounding = 1e-9 * size + (run % 3 == 0 ? 1e-9 : 0.0);
    double step = 0.0;  // an arc between two samples rises by much less than this over their chord
    for (std::size_t i = 0; i < curve.size(); ++i) step = std::max(step, distance(curve[i], curve[(i + 1) % curve.size()]));
    EXPECT_NEAR(signed_area(chain), signed_area(curve), 2e-3 * size * size + size * rounding) << run;
    const bool counter_clockwise = signed_area(chain) > 0.0;
    for (const Side side : {Side::on, Side::left, Side::right}) {
      const auto chords = chords_of(chain, true, side, tolerance, 1'000'000);
      ASSERT_TRUE(chords);
      for (const Vec2 p : curve) ASSERT_LE(distance_to(*chords, p, true), 1.000001 * tolerance + rounding) << run;
      for (std::size_t i = 0; i < chords->size(); ++i) {
        for (const double t : {0.0, 0.5}) {
          const Vec2 p = (*chords)[i] + t * ((*chords)[(i + 1) % chords->size()] - (*chords)[i]);
          ASSERT_LE(distance_to(curve, p, true), 1.000001 * tolerance + 0.02 * step + rounding) << run;
        }
      }
      // Chords of something narrower than the tolerance may cross, or stand the wrong way round.
      if (side == Side::on || repair_ring(*chords).refused || (signed_area(*chords) > 0.0) != counter_clockwise) continue;
      ++simple;
      const bool contains_all = (side == Side::right) == counter_clockwise;
      for (const Vec2& p : curve) {
        if (contains(*chords, p) != contains_all) {
          ASSERT_LE(distance_to(*chords, p, true), rounding) << run << (contains_all ? " outside" : " inside");
        }
      }
    }
  }
  EXPECT_GT(simple, 750);
}

/// Of a piece that is known by its hull, every control point; also where a stretch lets them not follow each other along the chord any more.
TEST(Outline, HullsContainTheirControlPointsHoweverStretched) {
  Random random = Random::stream(32, 0);
  int folded = 0;
  for (int run = 0; run < 3000; ++run) {
    std::vector<double> along;
    for (int i = 0; i < 4; ++i) along.push_back(random.uniform(0.0, 1.0));
    std::sort(along.begin(), along.end());
    Chain chain{{{0.0, 0.0}}};
    for (const double x : along) chain.push_back({{x, random.uniform(-0.02, 0.1)}, within_hull});
    chain.push_back({{1.0, 0.0}});
    const double turn = random.uniform(-pi, pi), stretch = random.uniform(1.0, 20.0);
    Affine to;
    to.x = {stretch * std::cos(turn), std::sin(turn)};
    to.y = {-stretch * std::sin(turn), std::cos(turn)};
    if (run % 2 == 1) std::swap(to.x, to.y);
    const Chain stretched = moved(chain, to);
    const Vec2 from = stretched.front().at, end = stretched.back().at;
    double before = 0.0;
    bool follows = true;
    for (const Knot& knot : stretched) {
      const double at = dot(knot.at - from, end - from);
      follows = follows && at >= before;
      before = at;
    }
    folded += follows ? 0 : 1;
    for (const Side side : {Side::left, Side::right}) {
      const auto chords = chords_of(stretched, false, side, 1.0, 1000);
      ASSERT_TRUE(chords);
      EXPECT_EQ(chords->front(), from);
      EXPECT_EQ(chords->back(), end);
      // With the chord they are a convex ring about all that lies on that side.
      EXPECT_TRUE(chords->size() < 3 || is_convex(side == Side::left ? Polyline{chords->rbegin(), chords->rend()} : *chords)) << run;
      for (const Knot& knot : stretched) {
        const double beside = cross(end - from, knot.at - from);
        if (side == Side::left ? beside <= 0.0 : beside >= 0.0) continue;
        ASSERT_GE(chords->size(), 3u) << run;
        EXPECT_TRUE(contains(*chords, knot.at) || distance_to(*chords, knot.at, true) < 1e-12) << run;
      }
    }
  }
  EXPECT_GT(folded, 300);
}

TEST(Outline, ArcsOfAnyBulge) {
  for (const double bulge : {1e-9, 1e-3, 0.41, 0.4142136, 0.42, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 2.5, 1e3, 1e6, 1e9}) {
    for (const double sign : {1.0, -1.0}) {
      Chain chain{{{0.0, 0.0}}};
      add_arc(chain, {2.0, 0.0}, sign * bulge);
      const double rise = bulge, radius = 0.5 * (bulge + 1.0 / bulge);
      const Vec2 center{1.0, -sign * (rise - radius)};
      const double tolerance = 1e-4 * std::max(1.0, rise);
      for (const Side side : {Side::on, Side::left, Side::right}) {
        const auto chords = chords_of(chain, false, side, tolerance, 100'000);
        ASSERT_TRUE(chords) << bulge;
        EXPECT_EQ(chords->front(), (Vec2{0.0, 0.0}));
        EXPECT_EQ(chords->back(), (Vec2{2.0, 0.0}));
        double lowest = 0.0;
        for (const Vec2 p : *chords) {
          EXPECT_NEAR(distance(p, center), radius, tolerance + 1e-9 * radius) << bulge;
          lowest = std::max(lowest, -sign * p.y);
        }
        EXPECT_NEAR(lowest, rise, tolerance * (1 + 1e-9)) << bulge;
        // Counter-clockwise arcs bend away from what is to their left.
        const bool outside = (side == Side::right) == (sign > 0.0);
        for (std::size_t i = 0; side != Side::on && i + 1 < chords->size(); ++i) {
          const Vec2 a = (*chords)[i], b = (*chords)[i + 1];
          if (outside) EXPECT_GE(distance_to({a, b}, center, false), radius * (1 - 1e-9)) << bulge;
          else EXPECT_LE(std::max(distance(a, center), distance(b, center)), radius * (1 + 1e-9)) << bulge;
        }
      }
    }
  }
  Chain chain{{{3.0, 4.0}}};
  add_arc(chain, {3.0, 4.0}, 0.7);  // without length
  EXPECT_EQ(*chords_of(chain, false, Side::left, 1e-3, 100), (Polyline{{3.0, 4.0}}));
}

TEST(Outline, NoMorePointsThanAllowed) {
  const Chain circle = elliptic_arc({0.0, 0.0}, {1e9, 0.0}, {0.0, 1e9}, 0.0, two_pi);
  for (const Side side : {Side::on, Side::left, Side::right}) EXPECT_FALSE(chords_of(circle, true, side, 1e-5, 10'000));
  EXPECT_TRUE(chords_of({}, true, Side::on, 1e-3, 10));
  EXPECT_EQ(chords_of({{{1.0, 2.0}}}, true, Side::on, 1e-3, 10)->size(), 1u);
}

}  // namespace
}  // namespace waywright::dxf
