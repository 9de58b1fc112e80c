// Test scenarios and maps made from a seed: the same seed gives the same file everywhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "waywright/core/result.hpp"
#include "waywright/io/image.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

struct StationOptions {
  std::optional<int> boxes;  ///< 0 to 12 by seed where absent
};

/// A docking station whose start and docked pose are free; whether there is a way between them is left to chance.
///
/// Station 9–16 m deep and 10–18 m wide, three in ten with a corner cut off or notched; shelf 1.0–1.4 × 2.2–3.2 m on the back wall,
/// in the middle (0.4), at the left (0.2) or right (0.2) or anywhere (0.2); vehicle as the published one with its length ±15 %,
/// curvature limit 0.6–0.9 1/m, half of them with a curvature rate limit of 0.8–2 1/m²; start facing away from the shelf ±0.3 rad;
/// boxes of 0.3–1.5 m, turned at random, and up to three clusters of scan points, all clear of start and docked pose; clearance
/// 0.02–0.10 m, three in ten with a pose error; the whole placed anywhere in the world at any angle.
Parsed<Scenario> generate_station(std::uint64_t seed, const StationOptions& options = {});

/// A warehouse of 60 × 40 m as an occupancy picture at 0.05 m: walls, racks in aisles, columns, pallets placed by seed, and a free
/// docking area in the south-east corner (x 44 to 59, y 2 to 17 m).
GreyImage generate_warehouse(std::uint64_t seed);
inline constexpr double warehouse_cell = 0.05;  ///< m

/// A hall of docking stations, as a site has it.
struct GeneratedSite {
  GreyImage map;         ///< occupancy at warehouse_cell, lower left corner at the origin
  std::string stations;  ///< stations.csv
};
/// `count` bays of 12 × 13 m in rows that face each other across lanes of 3 m, in each a shelf at the back wall (1.0–1.4 × 2.2–3.2 m, anywhere
/// along it, three in ten with the slot beside its middle), a start that looks away from it, columns, and up to five pallets of 0.8 × 1.2 m that
/// leave start and docked pose of the vehicle free; whether there is a way between them is left to chance.
/// @pre 1 ≤ count ≤ most_generated_stations
GeneratedSite generate_site(std::uint64_t seed, int count, const Vehicle& vehicle);
inline constexpr int most_generated_stations = 1000;

/// The first task on a publication's map (`published_map`, `whale_map`), for a point that turns on the spot and looks from start to goal at both; planned by
/// astar unless another is asked for. Empty where no map has the name.
std::optional<Scenario> published_scenario(std::string_view name);

}  // namespace waywright
