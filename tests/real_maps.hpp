// Maps that others made, vehicles to drive on them, and places drawn in their free space: for tests that run every planner on real maps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::test {

/// One map, as the `map` object of a scenario; its files lie in the folder of outside data.
struct RealMap {
  std::string name;    ///< letters, digits and underscores
  std::string file;    ///< that has to be there, relative to that folder; empty: the program has it
  std::string object;  ///< JSON
};

inline const std::vector<RealMap>& real_maps() {
  const auto ros = [](const std::string& name, const std::string& file, const std::string& more = "") {
    return RealMap{name, "ros_maps/" + file, R"({"ros": "ros_maps/)" + file + "\"" + more + "}"};
  };
  const auto svg = [](const std::string& name) { return RealMap{"bench_" + name, "bench_mr/polygon_mazes/" + name + ".svg", R"({"svg": "bench_mr/polygon_mazes/)" + name + R"(.svg"})"}; };
  static const std::vector<RealMap> all{
      {"WOA_1", "", R"({"generate": "WOA-1"})"},
      {"WOA_2", "", R"({"generate": "WOA-2"})"},
      {"WOA_3", "", R"({"generate": "WOA-3"})"},
      {"WOA_4", "", R"({"generate": "WOA-4"})"},
      {"WOA_5", "", R"({"generate": "WOA-5"})"},
      {"opentcs_demo", "roadmaps/opentcs_Demo-01.xml", R"({"opentcs": "roadmaps/opentcs_Demo-01.xml", "corridor": 3})"},
      ros("nav2_warehouse", "nav2/warehouse.yaml"),
      ros("nav2_depot", "nav2/depot.yaml"),
      ros("nav2_sandbox", "nav2/tb3_sandbox.yaml"),
      ros("ipa_factory", "ipa_factory/map.yaml"),
      ros("ipa_plant", "ipa_production_plant/map.yaml"),
      ros("ipa_plant_traced", "ipa_production_plant/map.yaml", R"(, "trace": 0.1)"),
      ros("aws_hospital", "aws_hospital/hospital.yaml"),
      ros("stata_basement", "stata_basement/stata_basement.yaml"),
      ros("aulario", "aulario/map.yaml"),
      ros("levine", "levine/levine.yaml"),
      {"rmf_office", "roadmaps/rmf_office.building.yaml", R"({"rmf": "roadmaps/rmf_office.building.yaml"})"},
      {"rmf_airport", "roadmaps/rmf_airport_terminal.building.yaml", R"({"rmf": "roadmaps/rmf_airport_terminal.building.yaml"})"},
      svg("parking1"),
      svg("parking3"),
      svg("warehouse"),
      {"bench_intel_lab", "bench_mr/image_mazes/intel-lab.png", R"({"image": "bench_mr/image_mazes/intel-lab.png", "resolution": 0.05, "occupied_below": 0.95})"},
      {"movingai_arena", "movingai/arena.map", R"({"movingai": "movingai/arena.map", "cell": 1})"},
      {"movingai_warehouse", "movingai/warehouse-20-40-10-2-2.map", R"({"movingai": "movingai/warehouse-20-40-10-2-2.map", "cell": 1})"},
  };
  return all;
}

/// The folder of outside data, where the test's environment names one that is there.
inline std::optional<std::filesystem::path> outside_data() {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !std::filesystem::is_directory(data)) return std::nullopt;
  return std::filesystem::path{data};
}

/// A disc and a rectangle that turn on the spot, a tricycle that does not.
inline std::vector<Vehicle> map_vehicles() {
  const std::filesystem::path folder{std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/vehicles"};
  Vehicle small;
  small.name = "tricycle";
  small.footprint.polygon = {{-0.9, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.9, 0.3}};
  small.drive = Tricycle{0.7, 1.0, 0.8, SteeredAxle::rear};
  small.limits.speed = small.limits.reverse_speed = 1.0;
  small.limits.curvature = 1.2;
  std::vector<Vehicle> all{read_vehicle(folder / "disc_robot.json").value(), read_vehicle(folder / "tugger_differential.json").value(), small};
  all[0].name = "disc";
  all[1].name = "rectangle";
  return all;
}

struct Ends {
  Pose start{}, goal{};
};

/// Pairs of places that a disc around the footprint reaches from each other whatever it does at them: drawn from the largest part of the free space that hangs
/// together, as a grid of at most `most` cells shows it; headings at random, at least a tenth of the map's diagonal apart. Fewer where there is no room.
inline std::vector<Ends> drawn_ends(const World& world, const Vehicle& vehicle, double clearance, std::size_t count, std::uint64_t seed) {
  constexpr double most = 160'000.0, spare = 0.005;  // cells; m
  const Box box = world.bounds();
  const Vec2 size = box.high - box.low;
  const double cell = std::max(0.1, std::sqrt(size.x * size.y / most));
  const int columns = std::max(1, static_cast<int>(size.x / cell)), rows = std::max(1, static_cast<int>(size.y / cell));
  const auto index = [&](int c, int r) { return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c); };
  const auto middle = [&](int c, int r) { return Vec2{box.low.x + (c + 0.5) * cell, box.low.y + (r + 0.5) * cell}; };
  const double wanted = vehicle.footprint.radius() + clearance + spare;
  const Footprint point{{}, 0.0};
  std::vector<std::uint8_t> is_free(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Vec2 p = middle(c, r);
      // Between two free neighbours every point is at most half a cell from one of their middles.
      is_free[index(c, r)] = world.least_clearance(point, {p.x, p.y, 0.0}, wanted + cell) > wanted + 0.5 * cell ? 1 : 0;
    }
  }
  std::vector<std::pair<int, int>> largest, part;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      if (is_free[index(c, r)] != 1) continue;
      part.assign(1, {c, r});
      is_free[index(c, r)] = 2;
      for (std::size_t i = 0; i < part.size(); ++i) {
        const auto [x, y] = part[i];
        for (const auto& [u, v] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
          if (u < 0 || v < 0 || u >= columns || v >= rows || is_free[index(u, v)] != 1) continue;
          is_free[index(u, v)] = 2;
          part.emplace_back(u, v);
        }
      }
      if (part.size() > largest.size()) largest = part;
    }
  }
  std::vector<Ends> drawn;
  if (largest.size() < 2) return drawn;
  Box reached{middle(largest.front().first, largest.front().second), middle(largest.front().first, largest.front().second)};
  for (const auto& [c, r] : largest) {
    const Vec2 p = middle(c, r);
    reached.low = {std::min(reached.low.x, p.x), std::min(reached.low.y, p.y)};
    reached.high = {std::max(reached.high.x, p.x), std::max(reached.high.y, p.y)};
  }
  Random random = Random::stream(seed, 0);
  const auto draw = [&] {
    const auto [c, r] = largest[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(largest.size()) - 1))];
    const Vec2 p = middle(c, r) + Vec2{random.uniform(-0.35, 0.35) * cell, random.uniform(-0.35, 0.35) * cell};
    return make_pose(p, random.uniform(-3.14, 3.14));
  };
  for (int tries = 0; tries < 1000 && drawn.size() < count; ++tries) {
    const Ends ends{draw(), draw()};
    if (distance(ends.start.position(), ends.goal.position()) > 0.1 * norm(reached.high - reached.low)) drawn.push_back(ends);
  }
  return drawn;
}

}  // namespace waywright::test
