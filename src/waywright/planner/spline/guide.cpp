#include "waywright/planner/spline/guide.hpp"

#include <algorithm>
#include <variant>

#include "waywright/planner/grid/grid_planner.hpp"

namespace waywright {
namespace {

constexpr double finest_cell = 0.1;   // m, of maps that have none
constexpr double most_cells = 1500.0;  // a side, of those

double cell_of(const World& world) {
  const Box box = world.bounds();
  return std::max(finest_cell, std::max(box.high.x - box.low.x, box.high.y - box.low.y) / most_cells);
}

/// The same start, goal and obstacles for a vehicle that can turn anywhere; nullopt where it does not fit at start or goal.
std::optional<Problem> free_problem(const Problem& problem, double disc, double more_clearance) {
  Scenario scenario;
  scenario.map = problem.world().map();
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) {
    scenario.map.boundaries.push_back(station->area);
    scenario.map.obstacles.push_back(station->shelf.outline());
  }
  scenario.zones = problem.scenario().zones;
  scenario.vehicle = problem.vehicle();
  scenario.vehicle.drive = Differential{1.0};
  scenario.vehicle.limits = {};
  scenario.vehicle.footprint = {{}, disc};
  scenario.vehicle.forks.clear();
  scenario.vehicle.loads.clear();
  scenario.start = problem.start();
  scenario.mission = problem.goal();
  scenario.clearance = problem.required_clearance() + more_clearance;
  auto prepared = Problem::prepare(std::move(scenario));
  if (!prepared || prepared->check_ends()) return std::nullopt;
  return std::move(*prepared);
}

}  // namespace

Guide guide_for(const Problem& problem, double wanted, Budget& budget) {
  GridPlannerOptions options;
  options.any_angle = true;
  options.resolution = problem.world().map().grids.empty() ? cell_of(problem.world()) : 0.0;
  std::vector<double> discs{problem.footprint().radius()};
  if (!problem.footprint().is_disc()) discs.push_back(0.5 * problem.footprint().least_width());
  for (const double disc : discs) {
    for (const double more : {0.5 * wanted, 0.0}) {
      if (budget.exhausted()) return {};
      const auto free = free_problem(problem, disc, more);
      if (!free) continue;
      BudgetLimits limits;
      limits.seconds = budget.seconds_left();
      Budget own{limits, budget.cancel_flag()};
      const PlanningResult result = GridPlanner{"guide", options}.plan(*free, own);
      if (!result) continue;
      Guide guide{{problem.start().position()}, disc};
      for (const Piece& piece : result->path.pieces) {
        if (const auto* line = std::get_if<Line>(&piece.curve)) guide.corners.push_back(line->to);
      }
      if (guide.corners.size() >= 2) return guide;
    }
  }
  return {};
}

std::vector<Vec2> points_along(const std::vector<Vec2>& guide, std::size_t count) {
  std::vector<Vec2> points = guide;
  if (guide.size() - 2 > count) {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < guide.size(); ++i) length += distance(guide[i], guide[i + 1]);
    points.clear();
    std::size_t leg = 0;
    double before = 0.0;  // m, up to the leg
    for (std::size_t i = 1; i <= count; ++i) {
      const double at = length * static_cast<double>(i) / static_cast<double>(count + 1);
      while (leg + 2 < guide.size() && before + distance(guide[leg], guide[leg + 1]) < at) {
        before += distance(guide[leg], guide[leg + 1]);
        ++leg;
      }
      const double whole = distance(guide[leg], guide[leg + 1]);
      points.push_back(guide[leg] + (whole > 0.0 ? (at - before) / whole : 0.0) * (guide[leg + 1] - guide[leg]));
    }
    return points;
  }
  while (points.size() < count + 2) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      if (distance(points[i], points[i + 1]) > distance(points[longest], points[longest + 1])) longest = i;
    }
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(longest) + 1, 0.5 * (points[longest] + points[longest + 1]));
  }
  return {points.begin() + 1, points.end() - 1};
}

}  // namespace waywright
