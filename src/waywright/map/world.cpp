#include "waywright/map/world.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>

#include "waywright/core/result.hpp"

namespace waywright {
namespace {

/// A footprint's outline placed in the world; a disc is its centre. Up to 64 corners need no memory of their own.
class PlacedOutline {
 public:
  PlacedOutline(const Footprint& footprint, const Pose& pose) {
    if (footprint.is_disc()) {
      corners_.push_back(pose.position());
      return;
    }
    const Frame frame{pose};
    for (const Vec2 p : footprint.polygon) corners_.push_back(frame.to_world(p));
  }
  std::span<const Vec2> ring() const { return {corners_.data(), corners_.size()}; }

 private:
  boost::container::small_vector<Vec2, 64> corners_;
};

}  // namespace

World::World(const Map& map) : map_{map} {
  for (std::size_t i = 0; i < map.boundaries.size(); ++i) {
    add_boundary(map.boundaries[i], map.boundaries.size() == 1 ? "the boundary" : "boundary " + std::to_string(i));
  }
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) add_obstacle(map.obstacles[i], "obstacle " + std::to_string(i));
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    const std::size_t source = add_source("line " + std::to_string(i), false, false);
    const Polyline& line = map.lines[i];
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      segments_.push_back({line[k], line[k + 1], static_cast<std::uint32_t>(source)});
    }
  }
  for (std::size_t i = 0; i < map.points.size(); ++i) {
    const std::size_t source = add_source("scan point " + std::to_string(i), false, false);
    segments_.push_back({map.points[i], map.points[i], static_cast<std::uint32_t>(source)});
  }
  for (const CellGrid& grid : map.grids) add_grid(grid);
}

std::size_t World::add_source(std::string name, bool boundary, bool solid) {
  sources_.push_back({std::move(name), boundary, solid});
  return sources_.size() - 1;
}

void World::add_ring_edges(const Ring& ring, std::size_t source) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    segments_.push_back({ring[i], ring[(i + 1) % ring.size()], static_cast<std::uint32_t>(source), true});
  }
}

std::size_t World::add_boundary(const Ring& ring, std::string name) {
  const std::size_t source = add_source(std::move(name), true, false);
  boundaries_.push_back({ring, bounding_box(ring), source});
  add_ring_edges(ring, source);
  return source;
}

std::size_t World::add_obstacle(const Ring& ring, std::string name) {
  const std::size_t source = add_source(std::move(name), false, true);
  obstacles_.push_back({ring, bounding_box(ring), source});
  add_ring_edges(ring, source);
  return source;
}

/// The outline between blocked and free cells, straight runs merged: with the inside test it is the exact union of the cells. What is blocked is on
/// the left of each segment, so that where one ends another begins.
void World::add_grid(const CellGrid& grid) {
  const std::size_t source = add_source((grid.name.empty() ? std::string{"the grid"} : grid.name) + " (blocked cell)", false, false);
  grid_sources_.push_back(source);
  const auto blocked = [&grid](int column, int row) {
    if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return grid.bounds;
    return grid.is_blocked(column, row);
  };
  const Frame frame{grid.origin};
  const auto add = [&](int column, int row, int to_column, int to_row, bool is_forward) {
    Vec2 a = frame.to_world(Vec2{column * grid.cell, (grid.rows - row) * grid.cell});
    Vec2 b = frame.to_world(Vec2{to_column * grid.cell, (grid.rows - to_row) * grid.cell});
    if (!is_forward) std::swap(a, b);
    segments_.push_back({a, b, static_cast<std::uint32_t>(source), true});
  };
  for (int row = 0; row <= grid.rows; ++row) {
    for (int column = 0; column < grid.columns;) {
      const int first = column;
      const bool above = blocked(column, row - 1);
      if (above == blocked(column++, row)) continue;
      while (column < grid.columns && blocked(column, row - 1) == above && blocked(column, row) != above) ++column;
      add(first, row, column, row, above);
    }
  }
  for (int column = 0; column <= grid.columns; ++column) {
    for (int row = 0; row < grid.rows;) {
      const int first = row;
      const bool left = blocked(column - 1, row);
      if (left == blocked(column, row++)) continue;
      while (row < grid.rows && blocked(column - 1, row) == left && blocked(column, row) != left) ++row;
      add(column, first, column, row, !left);
    }
  }
}

void World::build() {
  index_ = ObstacleIndex{std::move(segments_)};
  segments_.clear();
  std::vector<Box> boxes;
  for (const NamedRing& obstacle : obstacles_) boxes.push_back(obstacle.box);
  obstacle_bins_ = RingBins{boxes};
}

bool World::inside_blocked(Vec2 point, Contact& contact, std::size_t without) const {
  contact.clearance = 0.0;
  contact.point = point;
  for (const NamedRing& boundary : boundaries_) {
    if (boundary.box.contains(point) && contains(boundary.ring, point)) continue;
    contact.source = boundary.source;
    contact.outside = true;
    return true;
  }
  for (const std::uint32_t i : obstacle_bins_.near(point)) {
    const NamedRing& obstacle = obstacles_[i];
    if (obstacle.source == without || !obstacle.box.contains(point) || !contains(obstacle.ring, point)) continue;
    contact.source = obstacle.source;
    return true;
  }
  for (std::size_t i = 0; i < map_.grids.size(); ++i) {
    const CellGrid& grid = map_.grids[i];
    const Vec2 local = Frame{grid.origin}.to_local(point);
    const double column = std::floor(local.x / grid.cell);
    const double row = grid.rows - 1 - std::floor(local.y / grid.cell);
    const bool within = column >= 0 && row >= 0 && column < grid.columns && row < grid.rows;
    const bool blocked =
        within ? grid.is_blocked(static_cast<int>(column), static_cast<int>(row)) : grid.bounds;
    if (!blocked) continue;
    contact.source = grid_sources_[i];
    contact.outside = !within;
    return true;
  }
  return false;
}

Contact World::clearance(std::span<const Vec2> ring, double radius, double enough, std::size_t without) const {
  Contact contact;
  if (inside_blocked(ring.front(), contact, without)) return contact;
  const Nearest nearest = index_.nearest(ring, enough + radius, without);
  contact.clearance = std::max(0.0, nearest.distance - radius);
  if (nearest.found) {
    contact.point = nearest.point;
    contact.source = nearest.source;
    contact.outside = sources_[nearest.source].boundary && contact.clearance == 0.0;
  }
  return contact;
}

Contact World::clearance(const Footprint& footprint, const Pose& pose, double enough, std::size_t without) const {
  return clearance(PlacedOutline{footprint, pose}.ring(), footprint.is_disc() ? footprint.disc : 0.0, enough, without);
}

double World::least_clearance(std::span<const Vec2> ring, double radius, double enough, std::size_t without) const {
  Contact contact;
  if (inside_blocked(ring.front(), contact, without)) return 0.0;
  return std::max(0.0, index_.distance(ring, enough + radius, without) - radius);
}

double World::least_clearance(const Footprint& footprint, const Pose& pose, double enough, std::size_t without) const {
  return least_clearance(PlacedOutline{footprint, pose}.ring(), footprint.is_disc() ? footprint.disc : 0.0, enough, without);
}

bool World::is_free(const Footprint& footprint, const Pose& pose, double margin) const {
  return is_free(PlacedOutline{footprint, pose}.ring(), margin + (footprint.is_disc() ? footprint.disc : 0.0));
}

bool World::is_free(std::span<const Vec2> ring, double margin) const {
  Contact contact;
  return !inside_blocked(ring.front(), contact) && index_.is_clear(ring, margin);
}

std::string World::source_name(std::size_t source) const {
  return source < sources_.size() ? one_line(sources_[source].name) : std::string{"nothing"};
}

Box World::bounds() const { return index_.empty() ? Box{{-0.5, -0.5}, {0.5, 0.5}} : index_.bounds(); }

}  // namespace waywright
