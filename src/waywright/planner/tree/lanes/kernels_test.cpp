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

/// What an extension draws, in memory of its own.
struct Drawn {
  std::vector<double> x, y, reach, factor, scale;
  std::vector<Search> searches;
  Drawing drawing;
  Drawn(std::size_t agents, std::size_t iterations, double start) {
    const std::size_t moves = agents * iterations;
    for (std::vector<double>* values : {&x, &y}) values->resize(agents + spare);
    for (std::vector<double>* values : {&reach, &factor, &scale}) values->resize(moves + spare);
    searches.resize(moves + spare);
    drawing.agents = agents;
    drawing.moves = drawing.searching = moves;
    for (std::size_t m = 0; m < moves; ++m) reach[m] = start * (1.0 - static_cast<double>(m / agents) / static_cast<double>(iterations));
    drawing.reach = reach.data();
    drawing.x = x.data(), drawing.y = y.data(), drawing.factor = factor.data(), drawing.scale = scale.data();
    drawing.searches = searches.data();
  }
};

TEST(WhaleLanes, DrawsAreThoseOfTheFormulasAndTheStream) {
  Random random{1};
  for (const Kernels& kernels : available()) {
    for (const double choice : {0.5, 0.0, 0.3, 1.0, 2.0}) {
      for (int run = 0; run < 50; ++run) {
        Drawn d{static_cast<std::size_t>(random.integer(1, 40)), static_cast<std::size_t>(random.integer(1, 12)), 2.0};
        const std::size_t agents = d.drawing.agents, moves = d.drawing.moves;
        d.drawing.spiral = random.uniform(-3.0, 3.0);
        d.drawing.choice = choice;
        d.drawing.radius = random.uniform(0.1, 10.0);
        Random stream{random.next()}, taken = stream;
        d.drawing.counter = taken.take(drawn(agents, moves));
        kernels.draw(d.drawing);
        std::vector<double> numbers(2 * agents + 3 * moves);
        for (double& n : numbers) n = stream.uniform();
        EXPECT_EQ(stream.next(), taken.next());
        for (std::size_t i = 0; i < agents; ++i) {
          const double away = d.drawing.radius * std::sqrt(numbers[i]), turn = 2.0 * std::numbers::pi * numbers[agents + i];
          ASSERT_NEAR(d.x[i], away * std::cos(turn), 1e-14 * d.drawing.radius);
          ASSERT_NEAR(d.y[i], away * std::sin(turn), 1e-14 * d.drawing.radius);
        }
        std::size_t searches = 0;
        for (std::size_t m = 0; m < moves; ++m) {
          const double r = numbers[2 * agents + m], s = numbers[2 * agents + moves + m], p = numbers[2 * agents + 2 * moves + m], l = 2.0 * r - 1.0, a = 2.0 * d.reach[m] * r - d.reach[m];
          if (p >= choice) {
            const double growth = std::exp(d.drawing.spiral * l);
            ASSERT_NEAR(d.factor[m], growth * std::cos(2.0 * std::numbers::pi * l), 1e-15 * growth);
            ASSERT_EQ(d.scale[m], 1.0);
            continue;
          }
          ASSERT_EQ(d.factor[m], -a);
          ASSERT_EQ(d.scale[m], 2.0 * s);
          if (std::abs(a) < d.drawing.threshold) continue;
          ASSERT_LT(searches, d.drawing.searches_count);
          ASSERT_EQ(d.searches[searches].move, m);
          ASSERT_EQ(d.searches[searches].other, static_cast<std::uint32_t>(static_cast<double>(agents) / std::min(choice, 1.0) * p));
          ++searches;
        }
        ASSERT_EQ(d.drawing.searches_count, searches);
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
    for (std::size_t k = 0; k < d.drawing.searches_count; ++k) ++times[d.searches[k].other];
    searches += static_cast<int>(d.drawing.searches_count);
  }
  EXPECT_NEAR(searches, 100'000, 5 * std::sqrt(50'000.0));
  double chi = 0.0;  // of nine degrees of freedom: over 40 with a probability under 1e-5
  for (const int n : times) chi += (n - 0.1 * searches) * (n - 0.1 * searches) / (0.1 * searches);
  EXPECT_LT(chi, 40.0);
}

TEST(WhaleLanes, EveryInstructionSetGivesTheSameBits) {
  Random random{3};
  for (int run = 0; run < 300; ++run) {
    const auto agents = static_cast<std::size_t>(random.integer(1, 40)), iterations = static_cast<std::size_t>(random.integer(1, 12));
    const double spiral = random.uniform(-30.0, 30.0), radius = random.uniform(0.1, 10.0);
    const std::uint64_t counter = random.next();
    const double lead_x = random.uniform(-radius, radius), lead_y = random.uniform(-radius, radius), weight = random.uniform(0.0, 1.0), along = random.uniform(-0.5, 0.5);
    std::vector<std::vector<double>> found;
    for (const Kernels& kernels : available()) {
      Drawn d{agents, iterations, 3.0};
      d.drawing.counter = counter;
      d.drawing.spiral = spiral;
      d.drawing.radius = radius;
      kernels.draw(d.drawing);
      std::vector<double>& out = found.emplace_back();
      const auto keep = [&](const std::vector<double>& values, std::size_t count) { out.insert(out.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)); };
      keep(d.x, agents), keep(d.y, agents), keep(d.factor, agents * iterations), keep(d.scale, agents * iterations);
      std::vector<double> new_x(agents + spare), new_y(agents + spare), keys(agents + spare);
      std::size_t search = 0;
      for (std::size_t first = 0; first < agents * iterations; first += agents) {
        const std::size_t begin = search;
        while (search < d.drawing.searches_count && d.searches[search].move < first + agents) {
          out.push_back(d.searches[search].move);
          out.push_back(d.searches[search++].other);
        }
        kernels.move({.agents = agents, .radius = radius, .leader_x = lead_x, .leader_y = lead_y, .factor = d.factor.data() + first, .scale = d.scale.data() + first,
                      .searches = d.searches.data() + begin, .searches_count = search - begin, .first = first, .x = d.x.data(), .y = d.y.data(), .new_x = new_x.data(), .new_y = new_y.data()});
        d.x.swap(new_x);
        d.y.swap(new_y);
        keep(d.x, agents), keep(d.y, agents);
        Ranking ranking{.agents = agents, .x = d.x.data(), .y = d.y.data(), .per_radius = weight, .along_x = along, .along_y = -0.3, .keys = keys.data()};
        kernels.rank(ranking);
        keep(keys, agents);
        out.push_back(static_cast<double>(ranking.least));
        for (std::size_t i = 0; i < agents; ++i) {
          EXPECT_LE(std::hypot(d.x[i], d.y[i]), radius * (1.0 + 1e-15));
          EXPECT_NEAR(keys[i], weight * std::hypot(d.x[i], d.y[i]) + along * d.x[i] - 0.3 * d.y[i], 1e-14 * radius);
        }
        EXPECT_EQ(ranking.least, std::min_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(agents)) - keys.begin());
      }
    }
    for (const std::vector<double>& other : found) ASSERT_EQ(other, found.front());
  }
}

}  // namespace
}  // namespace waywright
