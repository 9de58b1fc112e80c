#include "waywright/geometry/contour.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

struct Grid {
  int columns = 0, rows = 0;
  std::vector<double> values;
  template <class F>
  Grid(int c, int r, F&& of) : columns{c}, rows{r} {
    for (int y = 0; y < r; ++y) {
      for (int x = 0; x < c; ++x) values.push_back(of(x, y));
    }
  }
  std::vector<ContourLine> lines(double level) const { return contour_lines(values, columns, rows, level); }
  double at(int x, int y) const { return values[static_cast<std::size_t>(y * columns + x)]; }
};

double length_of(const ContourLine& line) {
  double sum = line.is_closed ? distance(line.points.back(), line.points.front()) : 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1], line.points[i]);
  return sum;
}

// Of a cone: circles. Chords between points that interpolation misses by h²/8r at most.
TEST(Contours, OfAConeAreCircles) {
  const Vec2 middle{50.3, 49.6};
  const Grid cone{101, 101, [&](int x, int y) { return distance({static_cast<double>(x), static_cast<double>(y)}, middle); }};
  std::vector<Vec2> within;
  for (const double r : {5.0, 12.5, 30.0, 44.0}) {
    const auto lines = cone.lines(r);
    ASSERT_EQ(lines.size(), 1u) << r;
    EXPECT_TRUE(lines[0].is_closed);
    EXPECT_NEAR(length_of(lines[0]), two_pi * r, two_pi * r * 0.3 / (r * r)) << r;
    for (const Vec2 p : lines[0].points) EXPECT_NEAR(distance(p, middle), r, 0.13 / r);
    // What is above lies outside, on the left: the ring turns clockwise. Its area is the circle's.
    EXPECT_NEAR(signed_area(lines[0].points), -two_pi / 2.0 * r * r, 1.0);
    for (const Vec2 p : within) EXPECT_TRUE(contains(lines[0].points, p));
    within = lines[0].points;
  }
}

TEST(Contours, OfAPlaneAreStraight) {
  const Grid slope{21, 11, [](int x, int y) { return 2.0 * x + y; }};
  const auto lines = slope.lines(20.25);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].is_closed);
  EXPECT_NEAR(length_of(lines[0]), distance({10.125, 0.0}, {5.125, 10.0}), 1e-12);
  EXPECT_EQ(simplified(lines[0].points, 1e-9).size(), 2u);
  EXPECT_EQ(slope.lines(-1.0).size() + slope.lines(51.0).size(), 0u);
}

/// Laws of the header, over any values.
void expect_laws(const Grid& grid, double level) {
  std::map<std::pair<double, double>, int> seen;
  const auto node_at = [&](Vec2 p) {
    return p.x >= 0.0 && p.y >= 0.0 && p.x < grid.columns && p.y < grid.rows ? grid.at(static_cast<int>(p.x), static_cast<int>(p.y)) : std::numeric_limits<double>::quiet_NaN();
  };
  std::size_t crossed = 0;
  for (const ContourLine& line : grid.lines(level)) {
    ASSERT_GE(line.points.size(), 2u);
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec2 p = line.points[i];
      ++crossed;
      EXPECT_EQ(++seen[(std::pair{p.x, p.y})], 1);  // values are such that no line leads through a node
      const bool is_across = p.y == std::floor(p.y);
      ASSERT_TRUE(is_across || p.x == std::floor(p.x));
      // Its edge crosses the level; the end that is above lies to the left of where the line goes on.
      const Vec2 a{std::floor(p.x), std::floor(p.y)}, b = a + (is_across ? Vec2{1, 0} : Vec2{0, 1});
      EXPECT_NE(node_at(a) >= level, node_at(b) >= level);
      const Vec2 high = node_at(a) >= level ? a : b, low = node_at(a) >= level ? b : a;
      const std::size_t next = i + 1 < line.points.size() ? i + 1 : line.is_closed ? 0 : i;
      if (next != i) {
        EXPECT_GE(cross(line.points[next] - p, high - low), 0.0);
      }
      // Watertight: an end has no square with four nodes beyond it.
      if (!line.is_closed && (i == 0 || i + 1 == line.points.size())) {
        int squares = 0;
        for (const Vec2 corner : {a, a - (is_across ? Vec2{0, 1} : Vec2{1, 0})}) {
          bool whole = true;
          for (const Vec2 off : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) whole = whole && std::isfinite(node_at(corner + off));
          squares += whole ? 1 : 0;
        }
        EXPECT_EQ(squares, 1);
      }
    }
  }
  // Every edge of a whole square that crosses the level is on some line.
  std::size_t wanted = 0;
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.columns; ++x) {
      for (const bool is_across : {true, false}) {
        const Vec2 a{static_cast<double>(x), static_cast<double>(y)}, b = a + (is_across ? Vec2{1, 0} : Vec2{0, 1});
        if (!std::isfinite(node_at(a)) || !std::isfinite(node_at(b)) || (node_at(a) >= level) == (node_at(b) >= level)) continue;
        bool any = false;
        for (const Vec2 corner : {a, a - (is_across ? Vec2{0, 1} : Vec2{1, 0})}) {
          bool whole = true;
          for (const Vec2 off : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}}) whole = whole && std::isfinite(node_at(corner + off));
          any = any || whole;
        }
        wanted += any ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(crossed, wanted);
}

TEST(Contours, AreWatertightOverAnyValues) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> value{0.0, 1.0};
  for (int round = 0; round < 40; ++round) {
    const Grid noise{3 + round % 13, 2 + round % 9, [&](int, int) { return value(random) < 0.1 ? std::numeric_limits<double>::quiet_NaN() : value(random); }};
    for (const double level : {0.2, 0.5, 0.9}) expect_laws(noise, level);
  }
}

// Values that are the level themselves: lines may touch there, and all is closed still.
TEST(Contours, OfWholeNumbersEndAtTheRimAlone) {
  std::mt19937_64 random{3};
  for (int round = 0; round < 30; ++round) {
    const Grid steps{12, 9, [&](int, int) { return static_cast<double>(random() % 4); }};
    for (const ContourLine& line : steps.lines(2.0)) {
      if (line.is_closed) continue;
      for (const Vec2 p : {line.points.front(), line.points.back()}) EXPECT_TRUE(p.x == 0.0 || p.y == 0.0 || p.x == 11.0 || p.y == 8.0) << p.x << ", " << p.y;
    }
  }
}

TEST(Simplified, KeepsWithinItsTolerance) {
  Polyline wave;
  for (int i = 0; i <= 500; ++i) wave.push_back({0.02 * i, std::sin(0.02 * i)});
  const Polyline fewer = simplified(wave, 0.01);
  EXPECT_LT(fewer.size(), 40u);
  EXPECT_EQ(fewer.front(), wave.front());
  EXPECT_EQ(fewer.back(), wave.back());
  for (const Vec2 p : wave) {
    double nearest = 1.0;
    for (std::size_t i = 1; i < fewer.size(); ++i) nearest = std::min(nearest, point_segment_distance(p, fewer[i - 1], fewer[i]));
    EXPECT_LE(nearest, 0.01 + 1e-12);
  }
}

}  // namespace
}  // namespace waywright
