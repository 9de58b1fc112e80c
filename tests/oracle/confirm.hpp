// Brute force over a whole mission: who keeps what distance from what, on the way and in the shelf. Nothing here is taken from the
// problem that planner and proof share: load, rest of the vehicle and strips beside the pockets are its own.
#pragma once

#include <algorithm>
#include <optional>

#include "tests/oracle/brute_force.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

struct OracleClearance {
  double vehicle = oracle_cap;   ///< m, vehicle and load to everything; in the shelf the forks to everything but it
  std::optional<double> forks;   ///< m, to the shelf beside its pockets, where the path goes into it
};

namespace oracle {

/// Strips of the shelf that are not pocket, in the world.
inline std::vector<Ring> beside_pockets(const Station& station) {
  const Shelf& shelf = station.shelf;
  auto pockets = station.insertion->pockets;
  std::sort(pockets.begin(), pockets.end(), [](const auto& a, const auto& b) { return a.right < b.right; });
  std::vector<double> edges{-0.5 * shelf.width};
  for (const auto& [right, left] : pockets) edges.insert(edges.end(), {right, left});
  edges.push_back(0.5 * shelf.width);
  const double c = std::cos(shelf.heading), s = std::sin(shelf.heading);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    if (!(edges[i] < edges[i + 1])) continue;
    Ring ring;
    for (const Vec2 p : rectangle({-0.5 * shelf.depth, edges[i]}, {0.5 * shelf.depth, edges[i + 1]})) {
      ring.push_back({shelf.center.x + c * p.x - s * p.y, shelf.center.y + s * p.x + c * p.y});
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// The footprint without its forks.
inline std::vector<Ring> without_forks(const Vehicle& vehicle) {
  bg::model::multi_polygon<Polygon> rest{polygon(vehicle.footprint.polygon)};
  for (const Ring& fork : vehicle.forks) {
    bg::model::multi_polygon<Polygon> left;
    bg::difference(rest, polygon(fork), left);
    rest = std::move(left);
  }
  std::vector<Ring> rings;
  for (const Polygon& part : rest) {
    Ring ring;
    for (const Point& p : part.outer()) ring.push_back({p.x(), p.y()});
    ring.pop_back();  // the closing corner
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace oracle

/// Least clearances of a mission's whole path over poses `step` apart (see oracle_path_clearance).
inline OracleClearance oracle_mission_clearance(const Scenario& scenario, const Path& path, double step = 0.001) {
  std::vector<Footprint> bodies{scenario.vehicle.footprint};
  if (!scenario.carried_load.empty()) bodies.push_back(scenario.vehicle.loads.at(scenario.carried_load).footprint);
  const auto* station = std::get_if<Station>(&scenario.mission);
  std::vector<Ring> borders, shelves;
  if (station != nullptr) {
    borders = {station->area};
    shelves = {station->shelf.outline()};
  }
  OracleClearance found;
  Path open = path;
  if (station != nullptr && station->insertion) {
    const auto stretch = station->manoeuvre == Manoeuvre::undock ? open.pieces.begin() : open.pieces.end() - 1;
    const Path in_shelf{{*stretch}};
    open.pieces.erase(stretch);
    for (const Footprint& body : bodies) {
      found.vehicle = std::min(found.vehicle, oracle_path_clearance(scenario.map, borders, {}, body, in_shelf, step));
    }
    const Map nothing;
    for (const Ring& rest : oracle::without_forks(scenario.vehicle)) {
      found.vehicle = std::min(found.vehicle, oracle_path_clearance(nothing, {}, shelves, Footprint{rest, 0.0}, in_shelf, step));
    }
    found.forks = oracle_cap;
    for (const Ring& fork : scenario.vehicle.forks) {
      found.forks = std::min(*found.forks, oracle_path_clearance(nothing, {}, oracle::beside_pockets(*station), Footprint{fork, 0.0}, in_shelf, step));
    }
  }
  for (const Footprint& body : bodies) {
    found.vehicle = std::min(found.vehicle, oracle_path_clearance(scenario.map, borders, shelves, body, open, step));
  }
  return found;
}

}  // namespace waywright
