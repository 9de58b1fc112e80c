#include "waywright/planner/tree/lanes/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using namespace whale_lanes;

constexpr double single = 0x1.0p-23;  // the step of single precision at 1

/// What an extension draws, in memory of its own.
struct Drawn {
  std::vector<float> x, y, reach, factor, scale;
  std::vector<std::int32_t> other;
  Drawing drawing;
  Drawn(std::size_t agents, std::size_t iterations, double start) {
    const std::size_t moves = agents * iterations;
    for (std::vector<float>* values : {&x, &y}) values->resize(agents + spare);
    for (std::vector<float>* values : {&reach, &factor, &scale}) values->resize(moves + spare);
    other.resize(moves + spare);
    drawing.agents = agents;
    drawing.moves = moves;
    for (std::size_t m = 0; m < moves; ++m) reach[m] = static_cast<float>(start * (1.0 - static_cast<double>(m / agents) / static_cast<double>(iterations)));
    drawing.reach = reach.data();
    drawing.x = x.data(), drawing.y = y.data(), drawing.factor = factor.data(), drawing.scale = scale.data();
    drawing.other = other.data();
  }
  std::vector<std::size_t> searches() const {
    std::vector<std::size_t> found;
    for (std::size_t m = 0; m < drawing.moves; ++m) {
      if (other[m] >= 0) found.push_back(m);
    }
    return found;
  }
};

/// So many of the stream's numbers, two of each word.
std::vector<double> numbers_of(Random& stream, std::size_t count) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const std::uint64_t word = stream.next();
    for (const std::uint64_t half : {word & 0xFFFFFFFFU, word >> 32U}) numbers.push_back(static_cast<double>(half >> 8U) * 0x1.0p-24);
  }
  numbers.resize(count);
  return numbers;
}

TEST(WhaleLanes, DrawsAreThoseOfTheFormulasAndTheStream) {
  Random random{1};
  for (const Kernels& kernels : available()) {
    for (const double choice : {0.5, 0.0, 0.3, 1.0, 2.0}) {
      for (int run = 0; run < 50; ++run) {
        Drawn d{static_cast<std::size_t>(random.integer(1, 40)), static_cast<std::size_t>(random.integer(1, 12)), 2.0};
        const std::size_t agents = d.drawing.agents, moves = d.drawing.moves;
        d.drawing.spiral = static_cast<float>(random.uniform(-3.0, 3.0));
        d.drawing.choice = static_cast<float>(choice);
        d.drawing.radius = static_cast<float>(random.uniform(0.1, 10.0));
        Random stream{random.next()}, taken = stream;
        d.drawing.counter = taken.take(drawn(agents, moves));
        kernels.draw(d.drawing);
        const std::vector<double> us = numbers_of(stream, agents), vs = numbers_of(stream, agents), rs = numbers_of(stream, moves), ss = numbers_of(stream, moves), ps = numbers_of(stream, moves);
        EXPECT_EQ(stream.next(), taken.next());
        for (std::size_t i = 0; i < agents; ++i) {
          const double away = d.drawing.radius * std::sqrt(us[i]), turn = 2.0 * std::numbers::pi * vs[i];
          ASSERT_NEAR(d.x[i], away * std::cos(turn), 8.0 * single * d.drawing.radius);
          ASSERT_NEAR(d.y[i], away * std::sin(turn), 8.0 * single * d.drawing.radius);
        }
        for (std::size_t m = 0; m < moves; ++m) {
          const double l = 2.0 * rs[m] - 1.0;
          const float r = static_cast<float>(rs[m]), s = static_cast<float>(ss[m]), p = static_cast<float>(ps[m]), a = 2.0F * d.reach[m] * r - d.reach[m];
          if (p >= d.drawing.choice) {
            const double growth = std::exp(d.drawing.spiral * l);
            ASSERT_NEAR(d.factor[m], growth * std::cos(2.0 * std::numbers::pi * l), 6.0 * single * growth);
            ASSERT_EQ(d.scale[m], 1.0F);
            ASSERT_LT(d.other[m], 0);
            continue;
          }
          ASSERT_EQ(d.factor[m], -a);
          ASSERT_EQ(d.scale[m], 2.0F * s);
          if (std::abs(a) < d.drawing.threshold) {
            ASSERT_LT(d.other[m], 0);
          } else {
            ASSERT_EQ(d.other[m], static_cast<std::int32_t>(static_cast<float>(agents) / std::min(d.drawing.choice, 1.0F) * p));
            ASSERT_LT(d.other[m], static_cast<std::int32_t>(agents));
          }
        }
      }
    }
  }
}

TEST(WhaleLanes, SearchesGoToEveryAgentAlike) {
  Drawn d{10, 1, 1e6};  // |A| is hardly ever under the threshold
  Random random{2};
  std::vector<int> times(10);
  int searches = 0;
  for (int i = 0; i < 20'000; ++i) {
    d.drawing.counter = random.take(drawn(10, 10));
    best().draw(d.drawing);
    for (const std::size_t m : d.searches()) {
      ++times[static_cast<std::size_t>(d.other[m])];
      ++searches;
    }
  }
  EXPECT_NEAR(searches, 100'000, 5 * std::sqrt(50'000.0));
  double chi = 0.0;  // of nine degrees of freedom: over 40 with a probability under 1e-5
  for (const int n : times) chi += (n - 0.1 * searches) * (n - 0.1 * searches) / (0.1 * searches);
  EXPECT_LT(chi, 40.0);
}

/// One iteration of one kind of coordinate, as the flight has it.
float moved(float factor, float scale, float target, float radius, float x) { return std::min(std::max(target + factor * std::abs(scale * target - x), -radius), radius); }

bool is_in(const Flight& f, const Shadow& shadow, float x, float y) {
  const float to_x = x - f.begin_x, to_y = y - f.begin_y, squared = to_x * to_x + to_y * to_y;
  const float across = to_x * shadow.y - to_y * shadow.x, along = to_x * shadow.x + to_y * shadow.y;
  return across * across <= shadow.squared * squared && along > 0.0F && along <= squared;
}

/// What is known of an agent's cost.
struct Known {
  float key, bound;
  bool is_dark, is_all;
};
Known known(const Flight& f, float x, float y) {
  const float to_x = x - f.goal_x, to_y = y - f.goal_y, squared = to_x * to_x + to_y * to_y;
  Known k{f.per_radius * std::sqrt(x * x + y * y) + f.per_goal * std::sqrt(squared), 0.0F, false, false};
  for (std::size_t s = 0; s < f.shadow_count; ++s) k.is_dark = k.is_dark || is_in(f, f.shadows[s], x, y);
  bool is_seen = f.goal == Flight::Goal::is_seen, is_hidden = f.goal == Flight::Goal::is_hidden;
  if (f.goal == Flight::Goal::told_by_view && squared > f.at_goal_squared) {
    const float share = to_y / (std::abs(to_x) + std::abs(to_y)), around = to_x < 0.0F ? 2.0F - share : share < 0.0F ? 4.0F + share : share;
    const auto bin = static_cast<std::size_t>(0.25F * directions * around) % directions;
    is_seen = squared < f.seen_squares[bin];
    is_hidden = squared > f.hidden_squares[bin];
  }
  k.bound = k.is_dark ? k.key + f.dark : k.key;
  if (is_hidden) k.bound += f.hidden;
  const float from_x = x - f.begin_x, from_y = y - f.begin_y, off_x = x - f.lit_x, off_y = y - f.lit_y;
  k.is_all = (is_seen || is_hidden) && (from_x * from_x + from_y * from_y < f.lit_squared || off_x * off_x + off_y * off_y < f.lit_around_squared);
  return k;
}

/// The flight in plain loops, one agent after the other.
struct PlainFlight {
  Flight f;
  std::vector<float> x, y;
  bool is_open = false;
  std::size_t least = 0;

  /// Where all agents are; whether one has to be looked at.
  void look() {
    least = 0;
    for (std::size_t i = 1; i < f.agents; ++i) {
      if (known(f, x[i], y[i]).bound < known(f, x[least], y[least]).bound) least = i;
    }
    const Known k = known(f, x[least], y[least]);
    is_open = k.bound < f.enough && !k.is_all;
    if (!(k.bound < f.enough) || is_open) return;
    f.leader_x = x[least];
    f.leader_y = y[least];
    f.enough = k.bound;
  }
  void fly() {
    is_open = false;
    while (f.first < f.moves && !is_open) {
      const std::vector<float> old_x = x, old_y = y;
      for (std::size_t i = 0; i < f.agents; ++i, ++f.first) {
        const std::size_t m = f.first;
        const bool is_search = f.other[m] >= 0;
        x[i] = moved(f.factor[m], f.scale[m], is_search ? old_x[static_cast<std::size_t>(f.other[m])] : f.leader_x, f.radius, old_x[i]);
        y[i] = moved(f.factor[m], f.scale[m], is_search ? old_y[static_cast<std::size_t>(f.other[m])] : f.leader_y, f.radius, old_y[i]);
        const float most = (1.0F - 0x1.0p-21F) * f.radius, squared = x[i] * x[i] + y[i] * y[i];
        const float share = squared > most * most ? most / std::max(std::sqrt(squared), most) : 1.0F;
        x[i] *= share;
        y[i] *= share;
      }
      look();
    }
  }
};

TEST(WhaleLanes, EveryInstructionSetFliesAsThePlainLoopDoes) {
  Random random{3};
  int stops = 0, ends = 0, shaded = 0, went_on = 0;
  std::vector<float> seen(directions), hidden(directions);
  for (int run = 0; run < 3000; ++run) {
    const auto agents = static_cast<std::size_t>(random.integer(1, run % 4 == 0 ? 80 : 20)), iterations = static_cast<std::size_t>(random.integer(1, 12));
    const std::uint64_t counter = random.next();
    const auto spiral = static_cast<float>(random.uniform(-30.0, 30.0)), radius = static_cast<float>(random.uniform(0.1, 10.0));
    const auto share = [&](double least, double most) { return static_cast<float>(random.uniform(least, most)) * radius; };
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const float at = share(0.0, 1.5) * radius;
      seen[i] = 0.7F * at;
      hidden[i] = random.uniform() < 0.2 ? std::numeric_limits<float>::infinity() : at;
    }
    Flight given{.agents = agents, .radius = radius, .per_radius = static_cast<float>(random.uniform(0.0, 1.0)), .per_goal = static_cast<float>(random.uniform(0.0, 0.5)), .goal_x = share(-2.0, 2.0), .goal_y = share(-2.0, 2.0),
                 .dark = share(0.0, 2.0), .hidden = share(0.0, 1.0), .begin_x = share(-1.0, 1.0), .begin_y = share(-1.0, 1.0), .shadow_count = static_cast<std::size_t>(random.integer(0, 4)),
                 .lit_squared = share(-0.2, 0.5) * radius, .lit_x = share(-0.7, 0.7), .lit_y = share(-0.7, 0.7), .lit_around_squared = share(-0.2, 0.2) * radius, .goal = static_cast<Flight::Goal>(run % 4),
                 .seen_squares = seen.data(), .hidden_squares = hidden.data(), .at_goal_squared = share(0.0, 0.1) * radius, .moves = agents * iterations, .leader_x = share(-0.7, 0.7), .leader_y = share(-0.7, 0.7), .enough = share(0.0, 1.5)};
    for (Shadow& shadow : given.shadows) shadow = {share(-1.0, 1.0), share(-1.0, 1.0), share(-0.1, 0.3) * radius};
    const Shadow one_more{share(-1.0, 1.0), share(-1.0, 1.0), share(0.0, 0.5) * radius};
    for (const Kernels& kernels : available()) {
      const auto drawn_by = [&](const Kernels& by) {
        Drawn d{agents, iterations, 3.0};
        d.drawing.counter = counter;
        d.drawing.spiral = spiral;
        d.drawing.radius = radius;
        by.draw(d.drawing);
        return d;
      };
      Drawn d = drawn_by(kernels), plainly_drawn = drawn_by(available().front());
      const auto is_same = [](const auto& a, const auto& b, std::size_t count) { return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin()); };
      ASSERT_TRUE(is_same(d.x, plainly_drawn.x, agents) && is_same(d.y, plainly_drawn.y, agents) && is_same(d.factor, plainly_drawn.factor, d.drawing.moves));
      ASSERT_TRUE(is_same(d.scale, plainly_drawn.scale, d.drawing.moves) && is_same(d.other, plainly_drawn.other, d.drawing.moves));
      std::vector<float> before_x(agents + spare), before_y(agents + spare), keys(agents + spare), bounds(agents + spare);
      std::vector<std::int32_t> is_dark(agents + spare), is_known(agents + spare);
      Flight flight = given;
      flight.factor = d.factor.data(), flight.scale = d.scale.data(), flight.other = d.other.data();
      flight.searching = d.searches().empty() ? 0 : d.searches().back() + 1;
      if (run % 7 == 0) flight.begin_x = d.x[0], flight.begin_y = d.y[0];  // a line of no length
      PlainFlight plain{flight, d.x, d.y};
      flight.x = d.x.data(), flight.y = d.y.data(), flight.before_x = before_x.data(), flight.before_y = before_y.data();
      flight.keys = keys.data(), flight.bounds = bounds.data(), flight.is_dark = is_dark.data(), flight.is_known = is_known.data();
      const auto expect_same = [&] {
        ASSERT_EQ(flight.first, plain.f.first);
        ASSERT_EQ(flight.is_promising, plain.is_open);
        ASSERT_EQ(flight.leader_x, plain.f.leader_x);
        ASSERT_EQ(flight.leader_y, plain.f.leader_y);
        ASSERT_EQ(flight.enough, plain.f.enough);
        for (std::size_t i = 0; i < agents; ++i) {
          ASSERT_EQ(d.x[i], plain.x[i]);
          ASSERT_EQ(d.y[i], plain.y[i]);
          ASSERT_LE(std::hypot(double{d.x[i]}, double{d.y[i]}), radius);
        }
        if (!flight.is_promising) return;
        ASSERT_EQ(flight.least, plain.least);
        for (std::size_t i = 0; i < agents; ++i) {
          const Known k = known(flight, d.x[i], d.y[i]);
          ASSERT_EQ(keys[i], k.key);
          ASSERT_EQ(is_dark[i] != 0, k.is_dark);
          ASSERT_LE(bounds[i], k.bound);  // looked at no closer where even less is too much
          if (k.bound < flight.enough) {
            ASSERT_EQ(bounds[i], k.bound);
          }
        }
      };
      kernels.rank(flight);
      plain.look();
      expect_same();
      while (flight.first < flight.moves) {
        const float before = flight.enough;
        kernels.fly(flight);
        plain.fly();
        expect_same();
        went_on += flight.enough < before ? 1 : 0;
        ++(flight.is_promising ? stops : ends);
        if (!flight.is_promising) continue;
        const std::vector<float> unshaded = bounds;
        kernels.shade(flight, one_more);
        for (std::size_t i = 0; i < agents; ++i) {
          const bool is_darker = is_in(flight, one_more, d.x[i], d.y[i]);
          shaded += is_darker ? 1 : 0;
          ASSERT_EQ(bounds[i], is_darker ? std::max(unshaded[i], keys[i] + flight.dark) : unshaded[i]);
          ASSERT_EQ(is_dark[i] != 0, is_darker || known(flight, d.x[i], d.y[i]).is_dark);
        }
      }
    }
  }
  EXPECT_GT(stops, 1000);
  EXPECT_GT(ends, 100);
  EXPECT_GT(went_on, 1000);
  EXPECT_GT(shaded, 1000);
}

}  // namespace
}  // namespace waywright
