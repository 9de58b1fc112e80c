#include "waywright/planner/tree/whale_steering.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace waywright {
namespace {

/// As the steering has it, but every cost whole and every agent looked at. Moves are those that planner/tree/lanes draws, which has tests of its own; they are made
/// here, in single precision as there.
Vec2 plain_aim(const WhaleSteeringOptions& o, const WhaleSteering& steering, Vec2 near, Vec2 sample, Vec2 goal, Random& random) {
  const auto population = static_cast<std::size_t>(o.population), iterations = static_cast<std::size_t>(o.iterations), moves = population * iterations;
  std::vector<float> x(population + whale_lanes::spare), y(x), reach(moves + whale_lanes::spare), factor(reach), scale(reach);
  std::vector<std::int32_t> other(moves + whale_lanes::spare);
  for (std::size_t m = 0; m < moves; ++m) reach[m] = static_cast<float>(whale_reach(o.whale.start, m / population, iterations));
  whale_lanes::Drawing drawing{.counter = random.take(whale_lanes::drawn(population, moves)), .agents = population, .moves = moves, .reach = reach.data(),
                               .spiral = static_cast<float>(o.whale.spiral), .choice = static_cast<float>(o.whale.choice), .threshold = static_cast<float>(o.whale.threshold),
                               .radius = static_cast<float>(o.radius), .x = x.data(), .y = y.data(), .factor = factor.data(), .scale = scale.data(), .other = other.data()};
  whale_lanes::best().draw(drawing);
  const float radius = drawing.radius, most = (1.0F - 0x1.0p-21F) * radius;
  float best_x = 0.0F, best_y = 0.0F;
  float cost = std::numeric_limits<float>::infinity();
  const auto look = [&] {
    for (std::size_t i = 0; i < population; ++i) {
      const float c = steering.cost({x[i], y[i]}, near, sample, goal);
      if (!(c < cost)) continue;
      cost = c;
      best_x = x[i];
      best_y = y[i];
    }
  };
  look();
  const auto moved = [&](std::size_t m, float target, float at) { return std::min(std::max(target + factor[m] * std::abs(scale[m] * target - at), -radius), radius); };
  for (std::size_t m = 0; m < moves;) {
    const std::vector<float> old_x = x, old_y = y;
    for (std::size_t i = 0; i < population; ++i, ++m) {
      const bool is_search = other[m] >= 0;
      const auto whom = static_cast<std::size_t>(std::max(other[m], 0));
      x[i] = moved(m, is_search ? old_x[whom] : best_x, old_x[i]);
      y[i] = moved(m, is_search ? old_y[whom] : best_y, old_y[i]);
      const float squared = x[i] * x[i] + y[i] * y[i];
      if (!(squared > most * most)) continue;
      const float share = most / std::max(std::sqrt(squared), most);
      x[i] *= share;
      y[i] *= share;
    }
    look();
  }
  return sample + Vec2{best_x, best_y};
}

/// Boxes in a rectangle from `corner` on.
Problem hall(Random& random, Vec2 corner, Vec2 size, double disc, int boxes) {
  Scenario s;
  s.map.boundaries = {rectangle(corner, corner + size)};
  for (int i = 0; i < boxes; ++i) {
    const Ring box = rectangle({0, 0}, {random.uniform(0.03, 0.15) * size.x, random.uniform(0.03, 0.15) * size.x});
    const Vec2 at = corner + Vec2{random.uniform(0.06, 0.85) * size.x, random.uniform(0.06, 0.85) * size.y};
    s.map.obstacles.push_back(transformed(box, Frame{make_pose(at, random.uniform(-1, 1))}));
  }
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.clearance = 0.0;
  const Vec2 start = corner + 0.02 * size, goal = corner + 0.98 * size;
  s.start = {start.x, start.y, 0.0};
  s.mission = Pose{goal.x, goal.y, 0.0};
  return Problem::prepare(std::move(s)).value();
}

template <std::size_t count>
double any_of(const double (&values)[count], Random& random) { return values[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(count) - 1))]; }

WhaleSteeringOptions any_options(Random& random, double across) {
  WhaleSteeringOptions o;
  if (random.integer(0, 1) == 0) o.population = static_cast<int>(random.integer(1, 70));
  o.iterations = static_cast<int>(random.integer(1, 12));
  o.radius = any_of({2.5, 0.02 * across, 0.1 * across, across, 1e-3, 1000.0}, random);
  if (random.integer(0, 2) > 0) {
    for (double* weight : {&o.sample_weight, &o.goal_weight, &o.near_weight, &o.view_weight}) *weight = any_of({0.0, 0.2, 1.0, 4.0, 1000.0}, random);
  }
  if (random.integer(0, 1) == 0) o.whale = {.start = random.uniform(0, 5), .spiral = random.uniform(0, 5), .choice = random.uniform(), .threshold = random.uniform(0, 2)};
  return o;
}

TEST(WhaleSteering, LeavesOutOnlyWhatCannotMatter) {
  Random random{4};
  std::int64_t lines = 0, plain_lines = 0;
  for (int map = 0; map < 60; ++map) {
    const double across = any_of({10.0, 20.0, 200.0, 2000.0}, random);
    const Vec2 corner = map % 3 == 0 ? Vec2{random.uniform(-1e5, 1e5), random.uniform(-1e5, 1e5)} : Vec2{}, size{across, random.uniform(0.3, 1.0) * across};
    const Problem problem = hall(random, corner, size, map % 2 == 0 ? 0.0 : random.uniform(0.0, 0.01) * across, static_cast<int>(random.integer(0, 25)));
    const PlaneSpace space{problem};
    const auto any_place = [&] { return corner + Vec2{random.uniform() * size.x, random.uniform() * size.y}; };
    const auto mostly_free = [&] {
      for (int tries = random.integer(0, 4) == 0 ? 1 : 100;; --tries) {
        if (const Vec2 place = any_place(); tries == 1 || space.is_free(place)) return place;
      }
    };
    for (int run = 0; run < 6; ++run) {
      const WhaleSteeringOptions options = any_options(random, across);
      WhaleSteering steering{space, options};
      Vec2 goal = mostly_free();
      for (int i = 0; i < 60; ++i) {
        if (random.integer(0, 19) == 0) goal = mostly_free();
        const Vec2 near = mostly_free(), beside = near + Vec2{random.uniform(-1, 1) * options.radius, random.uniform(-1, 1) * options.radius};
        const std::int64_t kind = random.integer(0, 5);
        const Vec2 sample = kind == 0 ? near : kind == 1 ? goal : kind == 2 ? any_place() : beside;
        Random a{random.next()}, b{a};
        const Vec2 aim = steering.aim(near, sample, goal, a), plain = plain_aim(options, steering, near, sample, goal, b);
        ASSERT_EQ(aim.x, plain.x) << map << " " << run << " " << i;
        ASSERT_EQ(aim.y, plain.y) << map << " " << run << " " << i;
        ASSERT_EQ(a.next(), b.next());
        ASSERT_LE(distance(aim, sample), options.radius * (1.0 + 1e-12) + 1e-10);
        plain_lines += 2 * options.population * (options.iterations + 1);
      }
      lines += steering.lines();
    }
  }
  EXPECT_LT(lines, plain_lines / 2);
}

/// Agents that leave the square at its corner are clamped to the same place as the tree's nearest place is.
TEST(WhaleSteering, APlaceOfTheTreeItselfIsSeenFromIt) {
  Random random{6};
  const Problem problem = hall(random, {}, {20, 20}, 0.0, 12);
  const PlaneSpace space{problem};
  const WhaleSteeringOptions options{.whale = {.start = 100.0, .spiral = 20.0}};
  const float radius = 2.5F, off = (1.0F - 0x1.0p-21F) * radius / std::sqrt(radius * radius + radius * radius) * radius;
  WhaleSteering steering{space, options};
  for (int i = 0; i < 4000; ++i) {
    const Vec2 sample{random.uniform(2, 18), random.uniform(2, 18)}, near = sample + Vec2{random.integer(0, 1) == 0 ? off : -off, random.integer(0, 1) == 0 ? off : -off};
    Random a{random.next()}, b{a};
    const Vec2 aim = steering.aim(near, sample, {18.5, 18.5}, a), plain = plain_aim(options, steering, near, sample, {18.5, 18.5}, b);
    ASSERT_EQ(aim.x, plain.x) << i;
    ASSERT_EQ(aim.y, plain.y) << i;
  }
}

}  // namespace
}  // namespace waywright
