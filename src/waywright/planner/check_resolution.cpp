#include "waywright/planner/check_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/planner/field/harmonic_planner.hpp"
#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/heading_search.hpp"
#include "waywright/planner/state_lattice/lattice_graph.hpp"

namespace waywright {
namespace {

constexpr double highest = 100.0;  // m, of the parameter

double number(const Parameters& parameters, const char* name) {
  const auto found = parameters.find(name);
  const double* value = found == parameters.end() ? nullptr : std::get_if<double>(&found->second);
  return value == nullptr ? 0.0 : *value;
}

struct Limit {
  double cells = 0.0;    ///< that are searched at most
  double least = 0.0;    ///< m, of a cell in any case
  std::string in_words;  ///< of the cells
};

std::optional<Limit> limit_of(const Problem& problem, const std::string& planner, const Parameters& parameters) {
  const auto cells = static_cast<double>(most_grid_cells);
  if ((planner == "astar" || planner == "dijkstra") && !problem.footprint().is_disc()) {
    const double headings = std::max(1.0, number(parameters, "neighbours"));
    const double states = std::min(cells, static_cast<double>(HeadingSpace::most_states) / headings);
    return Limit{states, 0.0, fmt::format("at most {:.0f} cells of {:.0f} headings, whose records take 1 GiB", states, headings)};
  }
  for (const char* over_cells : {"astar", "dijkstra", "theta_star", "danger_astar", "block_astar", "safe_astar", "wavefront"}) {
    if (planner == over_cells) return Limit{cells, 0.0, fmt::format("at most {:.0f} cells, of up to 1 GiB in all", cells)};
  }
  if (planner == "harmonic") return Limit{static_cast<double>(HarmonicPlanner::most_cells), 0.0, fmt::format("at most {} cells", HarmonicPlanner::most_cells)};
  if (planner == "clearance_optimal") {
    const double limited = problem.vehicle().max_curvature(), radius = number(parameters, "min_radius");
    const double bent = std::isfinite(limited) ? limited : radius > 0.0 ? 1.0 / radius : 0.0;
    const double least = std::max(LatticeGraph::least_cell, bent > 0.0 ? 1.0 / (bent * LatticeGraph::most_cells_a_radius) : 0.0);
    return Limit{static_cast<double>(LatticeGraph::most_cells), least, fmt::format("at most {} cells of {} headings, {:g} m or more", LatticeGraph::most_cells, lattice_headings, least)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<InputError> refused_resolution(const Problem& problem, const std::string& planner, const Parameters& parameters, const std::string& why) {
  const double resolution = number(parameters, "resolution");
  const auto limit = resolution > 0.0 ? limit_of(problem, planner, parameters) : std::nullopt;
  const auto usual = limit ? make_grid_frame(problem, 0.0) : tl::expected<GridFrame, std::string>{tl::unexpected{std::string{}}};
  if (!limit || !usual) return std::nullopt;
  double width = usual->columns * usual->cell, height = usual->rows * usual->cell;
  if (planner == "clearance_optimal") {  // its lattice lies along the start's heading
    const SinCos turn = sin_cos(problem.start().heading);
    const Vec2 across{std::abs(turn.cos) * width + std::abs(turn.sin) * height, std::abs(turn.sin) * width + std::abs(turn.cos) * height};
    width = across.x;
    height = across.y;
  }
  const double least = std::max({limit->least, std::sqrt(width * height / limit->cells), std::max(width, height) / DistanceField::longest_side});
  constexpr double rounded_up = 1.02;  // of cells at the edges
  if (!(resolution < rounded_up * least)) return std::nullopt;
  // Two digits, rounded up.
  const double digit = std::pow(10.0, std::floor(std::log10(least)) - 1.0);
  return InputError{"", "planner.resolution", why, fmt::format("0, or from about {:g} m on here: {}", std::min(highest, digit * std::ceil(rounded_up * least / digit)), limit->in_words)};
}

}  // namespace waywright
