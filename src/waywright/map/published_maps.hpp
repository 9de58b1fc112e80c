// The maps of the safe-A* publication, reconstructed: it shows them as pictures only. Cells of one metre; the cell of node (x, y) has its middle at (x, y).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/map/map.hpp"

namespace waywright {

/// A task on a published map: from here to there, as nodes.
struct PublishedTask {
  Vec2 start{}, goal{};
};

struct PublishedMap {
  std::string name;
  CellGrid grid;
  std::vector<PublishedTask> tasks;
};

/// SA-CONVEX, SA-NARROW, SA-RAND1, SA-RAND2, SA-RAND3, SA-IRR, SA-IRR-REG (200 × 200 cells), SA-WH (50 × 50).
const std::vector<std::string>& published_map_names();
std::optional<PublishedMap> published_map(std::string_view name);

/// Rectangles of 6 to 14 cells at random, three cells apart, until a fifth of 200 × 200 cells is covered; four cells around start and goal stay free.
CellGrid random_rectangles(std::uint64_t seed, Vec2 start, Vec2 goal);

/// The rectangle around an irregular obstacle: along the line between its two points farthest from each other, as wide as it is on both sides
/// of it (the publication's construction, corrected; its own does not enclose the points). Counter-clockwise. @pre two different points at least
Ring regularised(const Ring& obstacle);

/// FNV-1a of the cells as bytes 0 and 1, the lowest row first.
std::uint64_t hash_of_cells(const CellGrid& grid);

}  // namespace waywright
