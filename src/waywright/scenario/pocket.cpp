#include "waywright/scenario/pocket.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/boolean.hpp"

namespace waywright {
namespace {

constexpr double front_tolerance = 1e-6;  // m

InputError refuse(std::string field, std::string problem, std::string allowed) {
  return InputError{"", std::move(field), std::move(problem), std::move(allowed)};
}

/// Strips of the shelf between and beside the pockets, in the frame of its face.
std::vector<Ring> beside_pockets(const Shelf& shelf, std::vector<Insertion::Pocket> pockets) {
  std::sort(pockets.begin(), pockets.end(), [](const auto& a, const auto& b) { return a.right < b.right; });
  std::vector<Ring> strips;
  double from = -0.5 * shelf.width;
  const auto add = [&](double to) {
    if (to > from) strips.push_back(rectangle({-shelf.depth, from}, {0.0, to}));
  };
  for (const Insertion::Pocket& pocket : pockets) {
    add(pocket.right);
    from = pocket.left;
  }
  add(0.5 * shelf.width);
  return strips;
}

std::optional<InputError> check_pockets(const Shelf& shelf, std::vector<Insertion::Pocket> pockets) {
  std::sort(pockets.begin(), pockets.end(), [](const auto& a, const auto& b) { return a.right < b.right; });
  for (std::size_t i = 0; i < pockets.size(); ++i) {
    const auto& [right, left] = pockets[i];
    if (right < -0.5 * shelf.width || left > 0.5 * shelf.width) {
      return refuse("station.insertion.pockets",
                    fmt::format("the pocket [{}, {}] reaches beyond the shelf's face of {} m", right, left, shelf.width),
                    fmt::format("{} to {}", -0.5 * shelf.width, 0.5 * shelf.width));
    }
    if (i > 0 && right < pockets[i - 1].left) {
      return refuse("station.insertion.pockets", fmt::format("the pockets [{}, {}] and [{}, {}] overlap", pockets[i - 1].right, pockets[i - 1].left, right, left),
                    "pockets beside each other");
    }
  }
  return std::nullopt;
}

}  // namespace

std::variant<PocketMotion, InputError> make_pocket_motion(const Vehicle& vehicle, const Station& station, const Pose& outer) {
  const Shelf& shelf = station.shelf;
  const Insertion& insertion = *station.insertion;
  if (auto error = check_pockets(shelf, insertion.pockets)) return *error;
  if (vehicle.forks.empty()) {
    return refuse("vehicle.forks", "the field is missing, and station.insertion needs it", "the part of the footprint that may enter a pocket");
  }
  if (vehicle.footprint.is_disc()) return refuse("vehicle.footprint", "a disc has no forks", "a polygon");
  const double front = vehicle.footprint.front();
  double tips = -std::numeric_limits<double>::infinity();
  std::vector<Ring> rest{vehicle.footprint.polygon};
  for (const Ring& fork : vehicle.forks) {
    tips = std::max(tips, Footprint{fork, 0.0}.front());
    const auto outside = without(fork, vehicle.footprint.polygon);
    if (!outside || !outside->empty()) return refuse("vehicle.forks", "a part of the forks is outside the footprint", "a part of the footprint");
    std::vector<Ring> left;
    for (const Ring& ring : rest) {
      const auto pieces = without(ring, fork);
      if (!pieces) return refuse("vehicle.forks", "the footprint without its forks has a hole", "forks that reach its front");
      left.insert(left.end(), pieces->begin(), pieces->end());
    }
    rest = std::move(left);
  }
  if (std::abs(tips - front) > front_tolerance) {
    return refuse("vehicle.forks", fmt::format("the fork tips are at x = {:.4f} m and the footprint's front at {:.4f} m", tips, front),
                  "forks that are the front of the footprint");
  }

  PocketMotion motion;
  motion.outer = outer;
  const Frame face = shelf.face();
  motion.inner = make_pose(face.to_world(Vec2{front - insertion.depth, shelf.slot}), outer.heading);
  for (const Ring& fork : vehicle.forks) motion.forks.push_back({fork, 0.0});
  for (Ring& ring : rest) motion.rest.push_back({std::move(ring), 0.0});
  motion.shelf.add_obstacle(shelf.outline(), "the shelf");
  motion.shelf.build();
  for (const Ring& strip : beside_pockets(shelf, insertion.pockets)) {
    motion.beside_pockets.add_obstacle(transformed(strip, face), "the shelf beside its pockets");
  }
  motion.beside_pockets.build();
  return motion;
}

PocketContacts contacts_at(const PocketMotion& pocket, const World& world, const Footprint& footprint, const Pose& pose, double enough) {
  PocketContacts contacts;
  contacts.vehicle = world.clearance(footprint, pose, enough, pocket.shelf_source);
  for (const Footprint& part : pocket.rest) {
    const Contact to_shelf = pocket.shelf.clearance(part, pose, enough);
    if (to_shelf.clearance >= contacts.vehicle.clearance) continue;
    contacts.vehicle = to_shelf;
    contacts.is_shelf = true;
  }
  contacts.forks.clearance = enough;
  for (const Footprint& fork : pocket.forks) {
    const Contact beside = pocket.beside_pockets.clearance(fork, pose, enough);
    if (beside.clearance < contacts.forks.clearance) contacts.forks = beside;
  }
  return contacts;
}

}  // namespace waywright
