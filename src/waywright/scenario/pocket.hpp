// The straight stretch on which the forks are in the shelf: who may be where.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/map/world.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// On the stretch between `outer` and `inner` the shelf is no obstacle to the whole footprint any more; instead its parts beside the
/// pockets are to the forks, which may come as near to them as the pose error lets them without touching, and the whole shelf is to the
/// rest of the vehicle, which keeps the scenario's clearance. A load that is carried has its place in the shelf and is free of it there.
struct PocketMotion {
  Pose outer{};             ///< docked
  Pose inner{};             ///< the forks are in
  std::vector<Footprint> forks;
  std::vector<Footprint> rest;  ///< of the vehicle without load and forks
  World shelf;              ///< the shelf alone, solid
  World beside_pockets;     ///< its parts that are not pocket
  std::size_t shelf_source = World::nothing;  ///< of the shelf in the problem's world
};

/// What comes nearest at a pose of the stretch.
struct PocketContacts {
  Contact vehicle;             ///< the footprint with its load to everything but the shelf, and the rest to the shelf
  bool is_shelf = false;       ///< `vehicle` names a source of `shelf`, not of the problem's world
  Contact forks;               ///< the forks to the shelf beside the pockets
};
PocketContacts contacts_at(const PocketMotion& pocket, const World& world, const Footprint& footprint, const Pose& pose, double enough);

/// Made from a station with insertion; refuses what cannot be: no forks, forks that are not the front of the footprint, pockets beyond
/// the shelf's width or over each other.
std::variant<PocketMotion, InputError> make_pocket_motion(const Vehicle& vehicle, const Station& station, const Pose& outer);

}  // namespace waywright
