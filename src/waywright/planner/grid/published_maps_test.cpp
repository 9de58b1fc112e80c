// The reconstructed maps of the safe-A* publication: their hashes, and the lengths of the shortest ways on them.
#include "waywright/map/published_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/planner/grid/grid_search.hpp"

namespace waywright {
namespace {

struct Expected {
  const char* name;
  int occupied;
  std::uint64_t hash;
  std::vector<double> loose, strict;  ///< cells, of each task; strict of none: not given
};

TEST(PublishedMaps, HaveTheCellsAndTheShortestWaysOfTheirReconstruction) {
  const std::vector<Expected> all{
      {"SA-CONVEX", 7576, 0x8a960c659c3a8fc9, {380.1320}, {382.4752}},   {"SA-NARROW", 2910, 0x5b17a875ca8d6e85, {422.1737}, {424.5168}},
      {"SA-RAND1", 8024, 0x03d527bea672d079, {202.6346}, {203.8061}},    {"SA-RAND2", 8098, 0xaa574242c6509e83, {209.0782}, {212.5929}},
      {"SA-RAND3", 8009, 0xa1f779329729f4c0, {209.6640}, {213.7645}},    {"SA-IRR", 3211, 0x42b4e68cdd0cedbe, {257.9899}, {258.5757}},
      {"SA-IRR-REG", 6176, 0x7f7e378c3f755015, {264.4335}, {266.1909}},  {"SA-WH", 558, 0xbdab3d06346f7ee5, {32.3848, 37.3137, 42.1421, 28.7279}, {}},
  };
  ASSERT_EQ(all.size(), published_map_names().size());
  GridSearch search;
  for (const Expected& e : all) {
    SCOPED_TRACE(e.name);
    const PublishedMap map = published_map(e.name).value();
    EXPECT_EQ(std::count(map.grid.blocked.begin(), map.grid.blocked.end(), 1), e.occupied);
    EXPECT_EQ(hash_of_cells(map.grid), e.hash);
    const auto lengths = [&](CornerRule corners) {
      const GridGraph graph{map.grid.columns, map.grid.rows, map.grid.blocked, Neighbours::eight, corners};
      std::vector<double> found;
      for (const PublishedTask& task : map.tasks) {
        const auto cell = [&](Vec2 node) { return Cell{static_cast<int>(node.x), map.grid.rows - 1 - static_cast<int>(node.y)}; };
        GridQuery query;
        query.starts = {{cell(task.start), 0.0}};
        query.goals = {{cell(task.goal), 0.0}};
        query.heuristic = Heuristic::euclidean;  // the publication's
        query.order = SearchOrder::published;
        found.push_back(search.run(graph, query).counts.length());
      }
      return found;
    };
    const std::vector<double> loose = lengths(CornerRule::loose), strict = lengths(CornerRule::strict);
    ASSERT_EQ(loose.size(), e.loose.size());
    for (std::size_t i = 0; i < loose.size(); ++i) EXPECT_NEAR(loose[i], e.loose[i], 1e-4);
    for (std::size_t i = 0; i < e.strict.size(); ++i) EXPECT_NEAR(strict[i], e.strict[i], 1e-4);
  }
  EXPECT_FALSE(published_map("SA-NONE"));
}

TEST(PublishedMaps, TheRectangleEnclosesItsObstacle) {
  const Ring first = regularised({{33, 34}, {44, 30}, {54, 35}, {49, 44}, {55, 52}, {42, 49}, {37, 55}, {34, 45}});
  const Ring printed{{40.93, 24.31}, {62.93, 42.31}, {46.31, 62.62}, {24.31, 44.62}};
  for (const Vec2 p : printed) {
    EXPECT_TRUE(std::any_of(first.begin(), first.end(), [&](Vec2 q) { return distance(p, q) < 0.01; })) << p.x << ", " << p.y;
  }
}

}  // namespace
}  // namespace waywright
