// The map made ready for distance questions: every kind of obstacle as segments and points in one hierarchy, with
// inside tests beside it. Immutable once built; safe to read from many threads.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "waywright/map/map.hpp"
#include "waywright/map/ring_bins.hpp"
#include "waywright/geometry/obstacle_index.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// What stands nearest to a footprint.
struct Contact {
  double clearance = 0.0;   ///< m; 0 where they touch or overlap; a lower bound no less than `enough` where it is beyond that
  Vec2 point{};             ///< obstacle's nearest point, world frame
  std::size_t source = 0;   ///< index for World::source_name
  bool outside = false;     ///< the pose is outside a boundary or the grid, rather than against an obstacle
};

class World {
 public:
  World() = default;
  explicit World(const Map& map);

  /// Adds before `build()`.
  std::size_t add_boundary(const Ring& ring, std::string name);  ///< its source
  std::size_t add_obstacle(const Ring& ring, std::string name);
  void build();

  static constexpr std::size_t nothing = static_cast<std::size_t>(-1);

  /// Exact clearance of the footprint at a pose: the least distance from its area to anything blocked, 0 on contact.
  /// Where it is at least `enough` the search may stop early and return any lower bound ≥ enough. `without`: a source
  /// that is not looked at.
  Contact clearance(const Footprint& footprint, const Pose& pose, double enough, std::size_t without = nothing) const;

  /// The same for the area of a closed ring in the world frame (one or two points allowed), grown by `radius`.
  Contact clearance(std::span<const Vec2> ring, double radius, double enough, std::size_t without = nothing) const;

  /// The number alone, cheaper: what stands there is not looked for.
  double least_clearance(const Footprint& footprint, const Pose& pose, double enough, std::size_t without = nothing) const;
  double least_clearance(std::span<const Vec2> ring, double radius, double enough, std::size_t without = nothing) const;

  /// True where clearance(footprint, pose) > margin. Cheaper than asking for the distance.
  bool is_free(const Footprint& footprint, const Pose& pose, double margin) const;

  /// The same for the area of a closed ring in the world frame.
  bool is_free(std::span<const Vec2> ring, double margin) const;

  /// True where a point lies inside something solid or outside a boundary; edges alone (walls, scan points) do not count.
  bool is_blocked(Vec2 point) const {
    Contact contact;
    return inside_blocked(point, contact);
  }

  const ObstacleIndex& index() const { return index_; }  ///< all edges

  /// Is the inside of its ring blocked (obstacles), or the outside (boundaries)? Grids, walls and scan points have no ring.
  bool is_solid(std::size_t source) const { return sources_[source].solid; }
  bool is_boundary(std::size_t source) const { return sources_[source].boundary; }

  /// Of the map's i-th grid.
  std::size_t grid_source(std::size_t i) const { return grid_sources_[i]; }

  /// "obstacle 3", "scan point 17", "shelf", "boundary", "warehouse.yaml (occupied cell)"; for messages.
  std::string source_name(std::size_t source) const;

  Box bounds() const;  ///< of everything known; a unit box about the origin where nothing is
  const Map& map() const { return map_; }
  bool empty() const { return index_.empty() && boundaries_.empty(); }

 private:
  struct NamedRing {
    Ring ring;
    Box box;
    std::size_t source;
  };
  struct Source {
    std::string name;
    bool boundary = false;
    bool solid = false;
  };
  std::size_t add_source(std::string name, bool boundary, bool solid);
  void add_ring_edges(const Ring& ring, std::size_t source);
  void add_grid(const CellGrid& grid);
  /// Contact where a point of the body stands inside something solid or outside a boundary.
  bool inside_blocked(Vec2 point, Contact& contact, std::size_t without = nothing) const;

  Map map_;
  std::vector<NamedRing> boundaries_;
  std::vector<NamedRing> obstacles_;
  RingBins obstacle_bins_;
  std::vector<Source> sources_;
  std::vector<Segment> segments_;  ///< until build()
  ObstacleIndex index_;
  std::vector<std::size_t> grid_sources_;
};

}  // namespace waywright
