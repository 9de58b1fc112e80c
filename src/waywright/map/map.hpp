// What is known of the world: boundary, obstacles, walls, scan points, occupancy cells. Plain data, world frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Occupancy cells. Row 0 is the top; the cell of column c, row r of `rows` rows has its centre, in the frame of
/// `origin` (pose of the lower left corner), at ((c + ½)·cell, (rows − r − ½)·cell).
struct CellGrid {
  std::string name;  ///< file it came from, for messages
  int columns = 0;
  int rows = 0;
  double cell = 0.0;  ///< metres, > 0
  Pose origin{};
  std::vector<std::uint8_t> blocked;  ///< row-major, columns × rows; 0 free, 1 occupied, 2 unknown (blocked too)
  bool bounds = true;                 ///< what lies outside the grid is forbidden (main map), or not covered (overlay)

  bool is_blocked(int column, int row) const {
    return blocked[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                   static_cast<std::size_t>(column)] != 0;
  }
  Vec2 corner(double column, double row) const {  ///< world point of a grid corner (columns from left, rows from top)
    return Frame{origin}.to_world(Vec2{column * cell, (rows - row) * cell});
  }
};

/// How a map was brought into the world frame, for the record.
struct Alignment {
  Pose transform{};               ///< map frame → world frame
  std::vector<double> residuals;  ///< metres, one per pair of points; empty where no pairs were given
};

struct Map {
  std::vector<Ring> boundaries;  ///< the vehicle stays inside each of them; none: unbounded
  std::vector<Ring> obstacles;   ///< solid
  std::vector<Polyline> lines;   ///< open walls without thickness
  std::vector<Vec2> points;      ///< scan points
  std::vector<CellGrid> grids;
  std::optional<Alignment> alignment;
  std::vector<std::string> notes;  ///< what was taken, left out and repaired on loading, in plain sentences
};

}  // namespace waywright
