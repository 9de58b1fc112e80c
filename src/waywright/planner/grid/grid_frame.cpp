#include "waywright/planner/grid/grid_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace waywright {
namespace {

constexpr double usual_cell = 0.05;               // m
constexpr double usual_cells = 4e6;               // where nobody asks for a resolution
constexpr double touch = 1e-6;                    // cells: an edge on the border of a cell is taken as in both
constexpr double rounding = 1e-7;                 // m, of coordinates up to 1e6 m after turning and shifting

/// What the vehicle's origin can be in: within every boundary; where there is none, around everything with room to pass by.
Box drivable(const Problem& problem) {
  const Map& map = problem.scenario().map;
  std::optional<Box> inside;
  const auto meet = [&](const Box& box) {
    if (!inside) inside = box;
    inside->low = {std::max(inside->low.x, box.low.x), std::max(inside->low.y, box.low.y)};
    inside->high = {std::min(inside->high.x, box.high.x), std::min(inside->high.y, box.high.y)};
  };
  for (const Ring& ring : map.boundaries) meet(bounding_box(ring));
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) meet(bounding_box(station->area));
  for (const CellGrid& grid : map.grids) {
    if (!grid.bounds) continue;
    const double c = grid.columns, r = grid.rows;
    meet(bounding_box({grid.corner(0, 0), grid.corner(c, 0), grid.corner(0, r), grid.corner(c, r)}));
  }
  if (inside) return *inside;
  Box box = problem.world().empty() ? Box{problem.start().position(), problem.start().position()} : problem.world().bounds();
  for (const Vec2 p : {problem.start().position(), problem.goal().position()}) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  const double room = 2.0 * (problem.footprint().radius() + problem.required_clearance()) + 1.0;
  return {box.low - Vec2{room, room}, box.high + Vec2{room, room}};
}

std::optional<std::size_t> main_grid(const Map& map) {
  for (std::size_t i = 0; i < map.grids.size(); ++i) {
    if (map.grids[i].bounds) return i;
  }
  return std::nullopt;
}

bool has_forbidden_zone(const Scenario& scenario) {
  return std::any_of(scenario.zones.begin(), scenario.zones.end(), [](const Zone& zone) { return zone.type == ZoneType::forbidden; });
}

std::string too_many(double columns, double rows, double cell) {
  return fmt::format("the grid would have {:.0f} x {:.0f} cells of {:g} m, and at most {} cells of at most {} a side are searched: give a coarser resolution", columns, rows, cell,
                     most_grid_cells, DistanceField::longest_side);
}

bool is_small_enough(double columns, double rows) {
  return columns <= DistanceField::longest_side && rows <= DistanceField::longest_side && columns * rows <= static_cast<double>(most_grid_cells);
}

}  // namespace

tl::expected<GridFrame, std::string> make_grid_frame(const Problem& problem, double resolution) {
  const Map& map = problem.scenario().map;
  GridFrame frame;
  if (const auto main = main_grid(map); main && (resolution == 0.0 || std::abs(resolution - map.grids[*main].cell) <= 1e-9 * resolution)) {
    const CellGrid& grid = map.grids[*main];
    frame = {Frame{grid.origin}, grid.cell, grid.columns, grid.rows, true, *main};
    if (!is_small_enough(grid.columns, grid.rows)) return tl::unexpected{too_many(grid.columns, grid.rows, grid.cell)};
    return frame;
  }
  const Box box = drivable(problem);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  if (!(width > 0.0 && height > 0.0)) return tl::unexpected{std::string{"the boundaries have nothing in common that could be driven on"}};
  frame.cell = resolution;
  if (resolution == 0.0) {
    frame.cell = usual_cell;
    while (width / frame.cell * (height / frame.cell) > usual_cells || std::max(width, height) / frame.cell > DistanceField::longest_side) frame.cell *= 2.0;
  }
  const double columns = std::max(1.0, std::ceil(width / frame.cell)), rows = std::max(1.0, std::ceil(height / frame.cell));
  if (!is_small_enough(columns, rows)) return tl::unexpected{too_many(columns, rows, frame.cell)};
  frame.frame = Frame{make_pose(box.low, 0.0)};
  frame.columns = static_cast<int>(columns);
  frame.rows = static_cast<int>(rows);
  return frame;
}

CellBounds::CellBounds(const Problem& problem, const GridFrame& frame) : cell_{frame.cell} {
  const Map& map = problem.scenario().map;
  const std::size_t cells = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  if (frame.is_native) {
    const CellGrid& grid = map.grids[frame.native];
    occupied_.resize(cells);
    std::transform(grid.blocked.begin(), grid.blocked.end(), occupied_.begin(), [](std::uint8_t b) { return b != 0 ? 1 : 0; });
    is_cells_alone_ = map.boundaries.empty() && map.obstacles.empty() && map.lines.empty() && map.points.empty() && map.grids.size() == 1 &&
                      !std::holds_alternative<Station>(problem.scenario().mission) && !has_forbidden_zone(problem.scenario());
  } else {
    occupied_.assign(cells, 0);
  }
  if (!is_cells_alone_) {
    mark_segments(problem, frame);
    mark_insides(problem, frame);
  }
  // A blocked cell is all obstacle: from its middle to the obstacle's nearest point it is half a cell at least. A marked one holds some part of one.
  low_ = -half_cell_diagonal;
  high_ = is_cells_alone_ ? -0.5 : half_cell_diagonal;
  field_.assign(frame.columns, frame.rows, occupied_, frame.is_native);
}

double CellBounds::bound(Cell c, double shift) const {
  const std::int32_t squared = field_.squared(c.column, c.row);
  if (squared == DistanceField::nowhere) return std::numeric_limits<double>::infinity();
  return (std::sqrt(static_cast<double>(squared)) + shift) * cell_ - rounding;
}

double CellBounds::at_most(Cell c) const {
  const double value = bound(c, high_);
  return std::max(0.0, value) + 2.0 * rounding;
}

/// Every cell that an edge touches, row by row.
void CellBounds::mark_segments(const Problem& problem, const GridFrame& frame) {
  // The native grid's cells are marked already.
  const std::size_t own = frame.is_native ? problem.world().grid_source(frame.native) : World::nothing;
  for (const Segment& s : problem.world().index().segments()) {
    if (frame.is_native && s.source == own) continue;
    Vec2 a = frame.in_cells(s.a), b = frame.in_cells(s.b);
    if (a.y > b.y) std::swap(a, b);
    const double low_x = std::min(a.x, b.x), high_x = std::max(a.x, b.x);
    if (b.y < -touch || a.y > frame.rows + touch || high_x < -touch || low_x > frame.columns + touch) continue;
    const int first = static_cast<int>(std::max(0.0, std::floor(a.y - touch)));
    const int last = static_cast<int>(std::min(frame.rows - 1.0, std::floor(b.y + touch)));
    for (int row = first; row <= last; ++row) {
      double from = low_x, to = high_x;
      if (b.y - a.y > touch) {
        const auto x_at = [&](double y) { return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0); };
        const double x0 = x_at(row - touch), x1 = x_at(row + 1 + touch);
        from = std::min(x0, x1);
        to = std::max(x0, x1);
      }
      const int begin = static_cast<int>(std::clamp(std::floor(from - touch), 0.0, static_cast<double>(frame.columns)));
      const int end = static_cast<int>(std::clamp(std::floor(to + touch) + 1.0, 0.0, static_cast<double>(frame.columns)));
      for (int c = begin; c < end; ++c) occupied_[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(c)] = 1;
    }
  }
}

/// Cells that no edge parts are inside or outside together: one of each region is looked at.
void CellBounds::mark_insides(const Problem& problem, const GridFrame& frame) {
  constexpr std::uint8_t seen = 2;
  std::vector<std::uint32_t> region;
  const auto width = static_cast<std::uint32_t>(frame.columns);
  for (std::uint32_t start = 0; start < occupied_.size(); ++start) {
    if (occupied_[start] != 0) continue;
    region.assign(1, start);
    occupied_[start] = seen;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const std::uint32_t at = region[i];
      const auto visit = [&](bool is_there, std::uint32_t next) {
        if (!is_there || occupied_[next] != 0) return;
        occupied_[next] = seen;
        region.push_back(next);
      };
      visit(at % width != 0, at - 1);
      visit(at % width != width - 1, at + 1);
      visit(at >= width, at - width);
      visit(at + width < occupied_.size(), at + width);
    }
    const Cell c{static_cast<int>(start % width), static_cast<int>(start / width)};
    if (!problem.world().is_blocked(frame.centre(c))) continue;
    for (const std::uint32_t cell : region) occupied_[cell] = 1;
  }
  for (std::uint8_t& o : occupied_) o = o == 1 ? 1 : 0;
}

}  // namespace waywright
