// The continuous collision proof by branch and bound over motion intervals.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/map/world.hpp"
#include "waywright/proof/motion.hpp"

namespace waywright {

/// A footprint made ready to be swept: the hull of a convex part's places is convex.
struct SweptBody {
  explicit SweptBody(Footprint of);

  Footprint footprint;
  double radius = 0.0;           ///< m, of the footprint
  std::vector<Ring> parts;       ///< convex, counter-clockwise; of a disc its centre
  double rotating_radius = 0.0;  ///< m, of the parts
  double grown = 0.0;            ///< m, by which the parts are less than the footprint
};

/// Rings under work, reused from query to query.
struct SweepMemory {
  Ring corners, hull;
  /// For bodies like this nothing is allocated.
  void reserve(const SweptBody& body);
};

struct SweptClearance {
  double lower = 0.0;       ///< m, no pose of the motion comes nearer than this (nominal pose, rounding allowed for)
  double upper = 0.0;       ///< m, clearance of the tightest pose found
  std::optional<Pose> tightest;  ///< empty where nothing is within the cap
  Contact contact{};        ///< there
  double length = 0.0;      ///< m covered
  double rounding = 0.0;    ///< m, of the distances themselves where the motion is straight without turning; `lower` allows for it
  bool complete = true;     ///< false where the bound on work ended it: `lower` says nothing
  std::int64_t queries = 0;
};

/// Clearance of the whole footprint over the motion, capped at 10 m, with lower ≥ upper − tolerance (unless it touches:
/// then the search ends with lower = upper = 0).
///
/// For each interval the convex parts of the footprint at its two ends span hulls; every pose between lies in these hulls grown
/// by the interval's deviation. Where a hull comes too near, the interval is halved: hull and deviation shrink quadratically.
/// A bound under `required` is sharpened to half a micrometre where the truth may meet what is required.
struct SweepOptions {
  double tolerance = 5e-4;                    ///< m
  double required = 0.0;                      ///< m
  std::size_t without = World::nothing;       ///< a source of the world that is not looked at
  const std::atomic<bool>* cancel = nullptr;  ///< once raised, the search ends incomplete
};
SweptClearance swept_clearance(const World& world, const SweptBody& body, std::span<const MotionInterval> motion, const SweepOptions& options,
                               SweepMemory& memory);

}  // namespace waywright
