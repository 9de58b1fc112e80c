// Maps of cells as polygons, from the files on: what `map --trace` writes holds every blocked cell of real maps, and plans in it are plans among the cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tests/command_line.hpp"
#include "tests/outside_data.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/distance_field.hpp"
#include "waywright/map/trace.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

/// Where horizontal lines are in the rings, in the grid's frame: a list of spans for each of `parts` heights of each row.
class Coverage {
 public:
  static constexpr std::array<double, 3> parts{0.02, 0.5, 0.98};

  Coverage(const CellGrid& grid, const std::vector<Ring>& rings) : rows_{grid.rows}, lines_(parts.size() * static_cast<std::size_t>(grid.rows)) {
    const Frame frame{grid.origin};
    std::vector<std::pair<std::size_t, double>> hits;
    for (const Ring& ring : rings) {
      hits.clear();
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 a = (1.0 / grid.cell) * frame.to_local(ring[i]), b = (1.0 / grid.cell) * frame.to_local(ring[(i + 1) % ring.size()]);
        if (a.y > b.y) std::swap(a, b);
        for (int row = std::max(0, static_cast<int>(std::floor(a.y)) - 1); row <= std::min(rows_ - 1, static_cast<int>(std::floor(b.y)) + 1); ++row) {
          for (std::size_t k = 0; k < parts.size(); ++k) {
            const double y = row + parts[k];
            if ((a.y > y) != (b.y > y)) hits.emplace_back(static_cast<std::size_t>(row) * parts.size() + k, a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
          }
        }
      }
      std::sort(hits.begin(), hits.end());
      for (std::size_t i = 0; i + 1 < hits.size(); i += 2) lines_[hits[i].first].emplace_back(hits[i].second, hits[i + 1].second);
    }
    for (auto& line : lines_) std::sort(line.begin(), line.end());
  }

  /// Spans at a height of a row, counted from below, that do not overlap.
  std::vector<std::pair<double, double>> at(int row, std::size_t part) const {
    std::vector<std::pair<double, double>> joined;
    for (const auto& span : lines_[static_cast<std::size_t>(row) * parts.size() + part]) {
      if (!joined.empty() && span.first <= joined.back().second + 1e-7) joined.back().second = std::max(joined.back().second, span.second);
      else joined.push_back(span);
    }
    return joined;
  }

 private:
  int rows_;
  std::vector<std::vector<std::pair<double, double>>> lines_;
};

void expect_traced(const CellGrid& grid, double tolerance) {
  const TracedGrid traced = trace(grid, {tolerance, {}, 0.0}).value();
  EXPECT_LE(traced.reached, tolerance);
  for (const Ring& ring : traced.obstacles) {
    const RingRepair repair = repair_ring(ring);
    ASSERT_FALSE(repair.refused) << *repair.refused;
  }
  const Coverage coverage{grid, traced.obstacles};
  const DistanceField field{grid.columns, grid.rows, grid.blocked, false};
  // A point of a cell is at most half a diagonal from its middle, and so is one of the nearest blocked cell.
  const double most = tolerance / grid.cell + std::sqrt(2.0);
  std::int64_t held = 0, beyond = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (std::size_t part = 0; part < Coverage::parts.size(); ++part) {
      const auto spans = coverage.at(grid.rows - 1 - row, part);
      std::size_t span = 0;
      for (int column = 0; column < grid.columns; ++column) {
        while (span < spans.size() && spans[span].second < column + 1 - 1e-6) ++span;
        if (grid.is_blocked(column, row)) {
          ++held;
          ASSERT_TRUE(span < spans.size() && spans[span].first <= column + 1e-6) << "cell " << column << ", " << row;
        }
      }
      for (const auto& [from, to] : spans) {
        for (int column = std::max(0, static_cast<int>(from)); column < std::min(grid.columns, static_cast<int>(std::ceil(to))); ++column) {
          beyond += grid.is_blocked(column, row) ? 0 : 1;
          ASSERT_LE(std::sqrt(field.squared(column, row)), most) << column << ", " << row;
        }
      }
    }
  }
  EXPECT_GT(held, 0);
  EXPECT_GT(beyond, 0);
  std::printf("%s: %s\n", grid.name.c_str(), describe(traced, {tolerance, {}, 0.0}).c_str());
}

TEST(TracedMaps, RealMapsAreHeldWithinTheTolerance) {
  const auto folder = test::outside_data("ros_maps");
  if (!folder) GTEST_SKIP() << test::no_outside_data;
  for (const char* name : {"aulario/map.yaml", "aws_hospital/hospital.yaml", "ipa_factory/map.yaml", "levine/levine.yaml", "nav2/depot.yaml", "nav2/tb3_sandbox.yaml", "nav2/warehouse.yaml"}) {
    SCOPED_TRACE(name);
    const auto loaded = load_ros_map(*folder / name, false);
    ASSERT_TRUE(loaded) << loaded.error().message();
    expect_traced(loaded->grid, 2.0 * loaded->grid.cell);
    expect_traced(loaded->grid, 5.0 * loaded->grid.cell);
  }
}

TEST(TracedMaps, MoreToleranceIsFewerCorners) {
  const CellGrid grid = load_ros_map(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/warehouse.yaml", false)->grid;
  std::size_t before = trace(grid, {0.025, {}, 0.0})->corners;
  for (const double tolerance : {0.05, 0.1, 0.3}) {
    const std::size_t corners = trace(grid, {tolerance, {}, 0.0})->corners;
    EXPECT_LE(corners, before) << tolerance;
    before = corners;
  }
  expect_traced(grid, 0.1);
}

using waywright::test::CommandLine;
using waywright::test::Json;
using waywright::test::slurp;

TEST_F(CommandLine, MapsAreTraced) {
  const auto traced = run("map " + example("warehouse.yaml") + " --trace 0.1 --dilate 0.05 -o m.json --picture m.svg");
  ASSERT_EQ(traced.status, 0) << traced.err;
  EXPECT_NE(traced.out.find("blocked cells"), std::string::npos) << traced.out;
  EXPECT_NE(traced.out.find("0.1 m allowed"), std::string::npos) << traced.out;
  EXPECT_EQ(traced.out.find("  cells: "), std::string::npos) << traced.out;
  const auto again = run("map m.json");
  EXPECT_EQ(again.status, 0) << again.err;
  // A picture needs a scale.
  EXPECT_EQ(run("map " + example("warehouse.png") + " --resolution 0.05 --trace 0.1 --trace-relative 0.02 -o p.json").status, 0);
  refused(run("map " + example("warehouse.png") + " --trace 0.1"), {"scale", "--resolution"});
  refused(run("map " + example("warehouse.yaml") + " --resolution 0.05"), {"no picture"});
  refused(run("map " + example("warehouse.yaml") + " --trace 0.01"), {"trace", "half a cell", "0.025 m or more"});
  refused(run("map " + example("warehouse.yaml") + " --dilate 0.1"), {"dilate", "trace"});
  refused(run("map m.json --trace 0.1"), {"trace", "no cells"});
}

TEST_F(CommandLine, AScenarioMayTraceItsMap) {
  Json s = Json::parse(slurp(example("grid_warehouse.json")));
  s["map"]["ros"] = example("warehouse.yaml");
  s["vehicle"] = example("vehicles/disc_robot.json");
  s["planner"] = {{"name", "astar"}, {"neighbours", 8}};
  const auto cells = run("plan " + write(s, "c.json") + " -o c");
  s["map"]["trace"] = 0.1;
  const auto polygons = run("plan " + write(s, "p.json") + " -o p");
  ASSERT_EQ(cells.status, 0) << cells.err;
  ASSERT_EQ(polygons.status, 0) << polygons.err;
  EXPECT_NE(polygons.err.find("became"), std::string::npos) << polygons.err;
  EXPECT_EQ(run("verify p/plan.json").status, 0);
  const Json plan = Json::parse(slurp(folder_ / "p/plan.json"));
  EXPECT_FALSE(plan["scenario"]["map"].contains("cells"));
  EXPECT_EQ(plan["scenario"]["map"]["source"]["trace"], 0.1);
  // The cells lie within the polygons: at every pose at least as much is free of them.
  const auto among_polygons = parse_plan(slurp(folder_ / "p/plan.json"), "p"), among_cells = parse_plan(slurp(folder_ / "c/plan.json"), "c");
  ASSERT_TRUE(among_polygons && among_cells);
  World polygons_alone{among_polygons->scenario.map}, cells_alone{among_cells->scenario.map};
  polygons_alone.build();
  cells_alone.build();
  const Footprint& footprint = among_polygons->scenario.vehicle.footprint;
  for (const Sample& sample : among_polygons->samples) {
    const double near = polygons_alone.least_clearance(footprint, sample.pose(), 1.0);
    EXPECT_GT(near, 0.1);
    EXPECT_GE(cells_alone.least_clearance(footprint, sample.pose(), 1.0), std::min(near, 1.0) - 1e-9);
  }
  const double by_cells = Json::parse(slurp(folder_ / "c/plan.json"))["metrics"]["length"], by_polygons = plan["metrics"]["length"];
  EXPECT_GE(by_polygons, by_cells - 1e-9);
  EXPECT_LE(by_polygons, 1.05 * by_cells);
}

}  // namespace
}  // namespace waywright
