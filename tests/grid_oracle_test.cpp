// The grid search against published optima and against textbook code that shares nothing with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "bench/yardstick/plain_grid.hpp"
#include "tests/oracle/movingai_problems.hpp"
#include "tests/outside_data.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/planner/grid/grid_search.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

/// Every `stride`-th problem of every file.
void published_optima(std::size_t stride) {
  const auto folder = test::outside_data("movingai");
  if (!folder) GTEST_SKIP() << test::no_outside_data;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator{*folder}) {
    if (entry.path().extension() == ".scen") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  std::size_t solved = 0;
  GridSearch search;
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    const std::size_t end = name.find(".map.scen");
    const std::string map = end != std::string::npos ? name.substr(0, end) : name.substr(0, std::min(name.find("-even"), name.find("-random")));
    const auto loaded = load_movingai_map(*folder / (map + ".map"), 1.0);
    ASSERT_TRUE(loaded) << loaded.error().message();
    const GridGraph graph{loaded->grid.columns, loaded->grid.rows, loaded->grid.blocked, Neighbours::eight, CornerRule::strict};
    const auto problems = oracle::read_movingai_problems(file.string());
    ASSERT_FALSE(problems.empty()) << name;
    for (std::size_t i = 0; i < problems.size(); i += stride) {
      const oracle::MovingAiProblem& p = problems[i];
      GridQuery query;
      query.starts = {{{p.start_column, p.start_row}, 0.0}};
      query.goals = {{{p.goal_column, p.goal_row}, 0.0}};
      const GridAnswer answer = search.run(graph, query);
      ASSERT_EQ(answer.ended, SearchEnd::found) << name << " problem " << i;
      ASSERT_NEAR(answer.counts.length(), p.length, std::max(0.01, 1e-5 * p.length)) << name << " problem " << i;
      ++solved;
    }
  }
  EXPECT_GT(solved, stride == 1 ? 24'000U : 200U);
}

TEST(MovingAiOptima, ASampleOfEveryFile) { published_optima(97); }
TEST(MovingAiOptima, FullEveryProblem) { published_optima(1); }

yardstick::Grid random_grid(Random& random, int neighbours, bool danger) {
  yardstick::Grid g;
  g.columns = static_cast<int>(random.integer(2, 45));
  g.rows = static_cast<int>(random.integer(2, 45));
  g.neighbours = neighbours;
  g.loose = random.uniform() < 0.3;
  const double share = random.uniform(0.0, 0.4);
  for (int i = 0; i < g.columns * g.rows; ++i) {
    g.blocked.push_back(random.uniform() < share ? 1 : 0);
    if (danger) g.danger.push_back(static_cast<float>(random.integer(0, 700)) / 256.0F);
  }
  return g;
}

// Lengths to the rounding of doubles; with danger to the rounding of each move to whole units.
TEST(GridSearch, CostsWhatTextbookSearchesCost) {
  Random random{44};
  GridSearch search;
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const int neighbours = i % 3 == 0 ? 4 : i % 3 == 1 ? 8 : 16;
    const bool danger = i % 2 == 1;
    const yardstick::Grid grid = random_grid(random, neighbours, danger);
    GridGraph graph{grid.columns, grid.rows, grid.blocked, static_cast<Neighbours>(neighbours), grid.loose ? CornerRule::loose : CornerRule::strict};
    if (danger) {
      std::vector<std::uint16_t> fixed;
      for (const float d : grid.danger) fixed.push_back(static_cast<std::uint16_t>(std::lround(d * 256.0F)));
      graph.set_danger(fixed);
    }
    const int cells = grid.columns * grid.rows;
    const int start = static_cast<int>(random.integer(0, cells - 1)), goal = static_cast<int>(random.integer(0, cells - 1));
    if (grid.blocked[static_cast<std::size_t>(start)] != 0 || grid.blocked[static_cast<std::size_t>(goal)] != 0) continue;
    GridQuery query;
    query.starts = {{{start % grid.columns, start / grid.columns}, 0.0}};
    query.goals = {{{goal % grid.columns, goal / grid.columns}, 0.0}};
    const GridAnswer ours = search.run(graph, query);
    const yardstick::Found textbook = yardstick::textbook_astar(grid, start, goal), heap = yardstick::heap_astar(grid, start, goal);
    ASSERT_EQ(ours.ended == SearchEnd::found, textbook.found) << i;
    ASSERT_EQ(heap.found, textbook.found);
    if (!textbook.found) continue;
    ++found;
    ASSERT_NEAR(textbook.cost, heap.cost, 1e-9);
    ASSERT_NEAR(ours.cost, textbook.cost, ours.error + 1e-9);
    if (!danger) {
      ASSERT_NEAR(ours.counts.length(), textbook.cost, neighbours == 16 ? ours.error : 1e-9);
    }
  }
  EXPECT_GT(found, 800);
}

TEST(DistanceField, IsThePlainOne) {
  Random random{4};
  for (int i = 0; i < 50; ++i) {
    const yardstick::Grid grid = random_grid(random, 8, false);
    EXPECT_EQ(DistanceField(grid.columns, grid.rows, grid.blocked, false).values(), yardstick::plain_distances(grid));
  }
}

}  // namespace
}  // namespace waywright
