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

TEST(WhaleLanes, EveryInstructionSetFliesAsThePlainLoopDoes) {
  Random random{3};
  int stops = 0, ends = 0;
  for (int run = 0; run < 400; ++run) {
    const auto agents = static_cast<std::size_t>(random.integer(1, run % 4 == 0 ? 80 : 20)), iterations = static_cast<std::size_t>(random.integer(1, 12));
    const auto spiral = static_cast<float>(random.uniform(-30.0, 30.0)), radius = static_cast<float>(random.uniform(0.1, 10.0));
    const std::uint64_t counter = random.next();
    const float leader_x = static_cast<float>(random.uniform(-0.7, 0.7)) * radius, leader_y = static_cast<float>(random.uniform(-0.7, 0.7)) * radius;
    const float weight = static_cast<float>(random.uniform(0.0, 1.0)), along = static_cast<float>(random.uniform(-0.5, 0.5)), enough = static_cast<float>(random.uniform(-0.3, 0.2)) * radius;
    for (const Kernels& kernels : available()) {
      Drawn d{agents, iterations, 3.0};
      d.drawing.counter = counter;
      d.drawing.spiral = spiral;
      d.drawing.radius = radius;
      kernels.draw(d.drawing);
      if (&kernels == available().data()) {
        for (std::size_t i = 0; i < agents; ++i) ASSERT_LE(std::hypot(double{d.x[i]}, double{d.y[i]}), radius);
      } else {
        Drawn plain{agents, iterations, 3.0};
        plain.drawing.counter = counter;
        plain.drawing.spiral = spiral;
        plain.drawing.radius = radius;
        available().front().draw(plain.drawing);
        const auto is_same = [](const auto& a, const auto& b, std::size_t count) { return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin()); };
        ASSERT_TRUE(is_same(d.x, plain.x, agents) && is_same(d.y, plain.y, agents) && is_same(d.factor, plain.factor, d.drawing.moves));
        ASSERT_TRUE(is_same(d.scale, plain.scale, d.drawing.moves) && is_same(d.other, plain.other, d.drawing.moves));
      }
      std::vector<float> x = d.x, y = d.y, before_x(agents + spare), before_y(agents + spare), keys(agents + spare);
      Flight flight{.agents = agents, .radius = radius, .per_radius = weight, .along_x = along, .along_y = -0.3F, .factor = d.factor.data(), .scale = d.scale.data(), .other = d.other.data(),
                    .searching = d.searches().empty() ? 0 : d.searches().back() + 1, .moves = agents * iterations, .leader_x = leader_x, .leader_y = leader_y, .enough = enough,
                    .x = d.x.data(), .y = d.y.data(), .before_x = before_x.data(), .before_y = before_y.data(), .keys = keys.data()};
      std::size_t first = 0;
      const auto expect_keys = [&] {  // of the plain loop's places
        std::size_t least = 0;
        for (std::size_t i = 0; i < agents; ++i) {
          ASSERT_EQ(d.x[i], x[i]);
          ASSERT_EQ(d.y[i], y[i]);
          ASSERT_EQ(keys[i], weight * std::sqrt(x[i] * x[i] + y[i] * y[i]) + (along * x[i] + -0.3F * y[i]));
          ASSERT_LE(std::hypot(double{x[i]}, double{y[i]}), radius);
          if (keys[i] < keys[least]) least = i;
        }
        ASSERT_EQ(flight.is_promising, keys[least] < enough);
        if (flight.is_promising) {
          ASSERT_EQ(flight.least, least);
        }
      };
      kernels.rank(flight);
      expect_keys();
      while (first < flight.moves) {
        kernels.fly(flight);
        const std::size_t end = flight.first;
        ASSERT_GT(end, first);
        for (; first < end; first += agents) {
          const std::vector<float> old_x = x, old_y = y;
          bool is_promising = false;
          for (std::size_t i = 0; i < agents; ++i) {
            const std::size_t m = first + i;
            const bool is_search = d.other[m] >= 0;
            x[i] = moved(d.factor[m], d.scale[m], is_search ? old_x[static_cast<std::size_t>(d.other[m])] : leader_x, radius, old_x[i]);
            y[i] = moved(d.factor[m], d.scale[m], is_search ? old_y[static_cast<std::size_t>(d.other[m])] : leader_y, radius, old_y[i]);
            const float most = (1.0F - 0x1.0p-21F) * radius, squared = x[i] * x[i] + y[i] * y[i];
            const float share = squared > most * most ? most / std::max(std::sqrt(squared), most) : 1.0F;
            x[i] *= share;
            y[i] *= share;
            is_promising = is_promising || weight * std::sqrt(x[i] * x[i] + y[i] * y[i]) + (along * x[i] + -0.3F * y[i]) < enough;
          }
          ASSERT_EQ(is_promising, first + agents == end && flight.is_promising);
        }
        expect_keys();
        ++(flight.is_promising ? stops : ends);
      }
    }
  }
  EXPECT_GT(stops, 1000);
  EXPECT_GT(ends, 100);
}

}  // namespace
}  // namespace waywright
