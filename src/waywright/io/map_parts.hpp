// What maps consist of: polygons, lines, points and grids of cells as JSON.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// {"boundary", "boundaries", "obstacles", "lines", "points"}, each part optional, coordinates within ±most.
/// Notes of what was repaired go into the map.
void read_polygons(const Node& node, Map& map, double most);
Json polygons_to_json(const Map& map);

/// An array of polygons, added to `rings`.
void read_rings(const Node& node, std::vector<Ring>& rings, std::vector<std::string>& notes, double most);

/// {"name", "columns", "rows", "cell", "origin", "bounds", "runs": [value, count, value, count, …]}: row by
/// row from the top, 0 free, 1 occupied, 2 unknown.
CellGrid read_cells(const Node& node, double most);
Json cells_to_json(const CellGrid& grid);

/// Has the file's name this ending (lower case, with its dot), in capitals or not?
bool has_extension(const std::filesystem::path& file, std::string_view extension);

/// Counts a grid's cells against what one scenario may hold; fails where it is too many.
bool count_cells(const Node& node, std::int64_t columns, std::int64_t rows);

/// Refuses a map of more edges than can be kept ready for questions, or of grids that change too often to be written in a plan.
void check_size(const Node& node, const Map& map);

}  // namespace waywright
