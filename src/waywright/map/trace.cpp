#include "waywright/map/trace.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "waywright/map/cell_pieces.hpp"
#include "waywright/map/distance_field.hpp"
#include "waywright/map/outward_outline.hpp"

namespace waywright {
namespace {

constexpr std::int64_t most_cells = std::int64_t{1} << 26;
constexpr double bridge = 0.25;        // cells: as far a bridged corner reaches from the two cells that touch there
constexpr double least_tolerance = 0.5;  // cells
constexpr double rounding = 1e-9;      // of a cell

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

tl::unexpected<InputError> refuse(const char* field, std::string problem, std::string allowed) { return tl::unexpected{InputError{"", field, std::move(problem), std::move(allowed)}}; }

/// Length of an outline in cells.
double length_of(const std::vector<HalfCell>& outline) {
  double length = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const HalfCell a = outline[i], b = outline[(i + 1) % outline.size()];
    const double x = b.x - a.x, y = b.y - a.y;
    length += std::sqrt(x * x + y * y);
  }
  return 0.5 * length;
}

CellGrid padded(const CellGrid& grid, int by) {
  CellGrid wide;
  wide.name = grid.name;
  wide.columns = grid.columns + 2 * by;
  wide.rows = grid.rows + 2 * by;
  wide.cell = grid.cell;
  wide.bounds = grid.bounds;
  wide.origin = make_pose(Frame{grid.origin}.to_world(Vec2{-by * grid.cell, -by * grid.cell}), grid.origin.heading);
  wide.blocked.assign(static_cast<std::size_t>(wide.columns) * static_cast<std::size_t>(wide.rows), 0);
  for (int row = 0; row < grid.rows; ++row) {
    const auto from = grid.blocked.begin() + static_cast<std::ptrdiff_t>(row) * grid.columns;
    std::copy(from, from + grid.columns, wide.blocked.begin() + static_cast<std::ptrdiff_t>(row + by) * wide.columns + by);
  }
  return wide;
}

/// The cells and all that touch them, at corners too. What lies outside counts where the grid bounds.
std::vector<std::uint8_t> with_neighbours(const CellGrid& grid) {
  const auto columns = static_cast<std::size_t>(grid.columns), rows = static_cast<std::size_t>(grid.rows);
  std::vector<std::uint8_t> wide(grid.blocked.size()), all(grid.blocked.size());
  const std::uint8_t outside = grid.bounds ? 1 : 0;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t i = r * columns + c;
      const auto left = c > 0 ? grid.blocked[i - 1] : outside, right = c + 1 < columns ? grid.blocked[i + 1] : outside;
      wide[i] = grid.blocked[i] != 0 || left != 0 || right != 0 ? 1 : 0;
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t i = r * columns + c;
      const auto above = r > 0 ? wide[i - columns] : outside, below = r + 1 < rows ? wide[i + columns] : outside;
      all[i] = wide[i] != 0 || above != 0 || below != 0 ? 1 : 0;
    }
  }
  return all;
}

}  // namespace

CellGrid dilated(const CellGrid& grid, double distance) {
  if (distance <= 0.0) return grid;
  const double cells = distance / grid.cell;
  CellGrid grown = grid.bounds ? grid : padded(grid, static_cast<int>(std::ceil(cells)) + 1);
  // The least distance between two cells is that between the middle of the one and the nearest middle among the other and its neighbours.
  const DistanceField field{grown.columns, grown.rows, with_neighbours(grown), grown.bounds};
  const double most = cells * cells;
  for (std::size_t i = 0; i < grown.blocked.size(); ++i) {
    if (grown.blocked[i] == 0 && static_cast<double>(field.values()[i]) < most) grown.blocked[i] = 1;
  }
  return grown;
}

Parsed<TracedGrid> trace(const CellGrid& grid, const TraceOptions& options) {
  const double least = least_tolerance * grid.cell;
  // A hair less is taken: a tolerance of half a cell of 0.1 m is written 0.05, which is not half of it to the last bit.
  if (!(options.tolerance >= least * (1.0 - rounding))) return refuse("trace", number(options.tolerance) + " m is under half a cell, with which no slanted wall gets shorter", number(least) + " m or more");
  const double margin = grid.bounds ? 0.0 : 2.0 * (options.dilate / grid.cell + 2.0);
  const double columns = grid.columns + margin, rows = grid.rows + margin;
  if (columns > DistanceField::longest_side || rows > DistanceField::longest_side || columns * rows > static_cast<double>(most_cells)) {
    return refuse("trace", "the grid has " + number(columns) + " x " + number(rows) + " cells" + (options.dilate > 0.0 ? " with what is dilated" : ""),
                  "at most " + std::to_string(DistanceField::longest_side) + " a side and " + std::to_string(most_cells) + " in all");
  }
  TracedGrid traced;
  traced.blocked = static_cast<std::int64_t>(grid.blocked.size()) - std::count(grid.blocked.begin(), grid.blocked.end(), 0);
  const CellGrid cells = dilated(grid, options.dilate);
  const Frame frame{cells.origin};
  const auto place = [&](double x, double y) { return frame.to_world(Vec2{0.5 * x * cells.cell, 0.5 * y * cells.cell}); };
  if (grid.bounds) {
    const double width = 2.0 * cells.columns, height = 2.0 * cells.rows;
    traced.boundary = Ring{place(0, 0), place(width, 0), place(width, height), place(0, height)};
  }
  std::int64_t doubled_beyond = 0;  // square half cells
  for (const CellPiece& piece : pieces_of(cells.columns, cells.rows, cells.blocked)) {
    double tolerance = options.tolerance / cells.cell;
    if (options.relative) tolerance = std::clamp(*options.relative * length_of(piece.outline), std::min(least_tolerance, tolerance), tolerance);
    const double own = piece.is_bridged ? bridge : 0.0;
    const OutwardOutline outline = outward_outline(piece.outline, 2.0 * (tolerance - own));
    Ring ring;
    for (const HalfCell p : outline.corners) ring.push_back(place(p.x, p.y));
    traced.covered += piece.cells;
    traced.outline_corners += piece.outline.size();
    traced.corners += ring.size();
    traced.reached = std::max(traced.reached, (0.5 * outline.reached + own) * cells.cell);
    doubled_beyond += doubled_area(outline.corners) - 8 * piece.cells;
    traced.obstacles.push_back(std::move(ring));
  }
  traced.lost = 0.125 * static_cast<double>(doubled_beyond) * cells.cell * cells.cell;
  return traced;
}

std::string describe(const TracedGrid& traced, const TraceOptions& options) {
  std::string text = std::to_string(traced.blocked) + " blocked cells";
  if (options.dilate > 0.0) text += " (" + std::to_string(traced.covered) + " dilated by " + number(options.dilate) + " m)";
  text += " became " + std::to_string(traced.obstacles.size()) + (traced.obstacles.size() == 1 ? " polygon" : " polygons") + " with " + std::to_string(traced.corners) + " corners (" +
          std::to_string(traced.outline_corners) + " before some were left out), which hold all of them and reach at most " + number(traced.reached) + " m beyond (" + number(options.tolerance) +
          " m allowed); at most " + number(traced.lost) + " m² of free area is lost";
  return text;
}

}  // namespace waywright
