#include "waywright/study/reproduce_safe_astar.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "waywright/judge/judge.hpp"
#include "waywright/metrics/grid_metrics.hpp"
#include "waywright/planner/grid/published_ways.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/study/summary.hpp"

namespace waywright::reproduction {
namespace {

constexpr std::array<PublishedMethod, 4> published_methods{PublishedMethod::shortest, PublishedMethod::danger, PublishedMethod::line, PublishedMethod::boundary};
constexpr std::array<const char*, 4> planners_of{"astar", "danger_astar", "block_astar", "safe_astar"};
constexpr double driving_speed = 1.0;  // m/s, the publication's

using Clock = std::chrono::steady_clock;

Cell cell_of(const CellGrid& grid, Vec2 node) { return {static_cast<int>(node.x), grid.rows - 1 - static_cast<int>(node.y)}; }
/// Nodes count upwards, rows down.
Vec2 turned(const CellGrid& grid, Vec2 p) { return {p.x, grid.rows - 1.0 - p.y}; }

void measure_way(Way& way, const CellGrid& grid, double seconds) {
  way.figures = {};
  for (const std::vector<Vec2>& leg : way.legs) {
    std::vector<Vec2> on_cells;
    for (const Vec2 p : leg) on_cells.push_back(turned(grid, p));
    way.figures[length] += way_length(leg);
    way.figures[turning] += way_turning(leg);
    way.figures[risk] += way_risk(on_cells, grid.blocked, grid.columns, grid.rows, grid.cell);
  }
  way.figures[search] = seconds;
  way.figures[run] = way_time(way.figures[length], driving_speed);
  way.figures[power] = residual_power(way.figures[length], way.figures[turning]);
}

/// Median of the seconds that `search` takes, after one run that warms up.
double timed(int repetitions, const auto& search) {
  search();
  std::vector<double> seconds;
  for (int i = 0; i < repetitions; ++i) {
    const auto begin = Clock::now();
    search();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return spread_of(seconds).median;
}

Way as_published(const CellGrid& grid, const std::vector<PublishedTask>& legs, PublishedMethod method, int repetitions) {
  const PublishedWays ways{CellMap{grid.columns, grid.rows, grid.blocked, grid.blocked}, grid.cell, method, {}};
  PublishedSearch memory;
  Way way;
  std::vector<PublishedWay> found(legs.size());
  const double seconds = timed(repetitions, [&] {
    for (std::size_t i = 0; i < legs.size(); ++i) found[i] = ways.way(cell_of(grid, legs[i].start), cell_of(grid, legs[i].goal), memory, {}, nullptr);
  });
  way.is_found = std::all_of(found.begin(), found.end(), [](const PublishedWay& w) { return w.ended == SearchEnd::found; });
  if (!way.is_found) {
    way.reason = "there is no way over the cells";
    return way;
  }
  for (const PublishedWay& w : found) {
    way.legs.emplace_back();
    for (const Vec2 p : w.points) way.legs.back().push_back(turned(grid, p));
    for (const Vec2 p : w.boundary.shifted) way.boundary.push_back(turned(grid, p));
    if (w.fell_back) way.reason = "no boundary point led to the goal: " + w.boundary.why;
  }
  measure_way(way, grid, seconds);
  return way;
}

/// As users have it: a point on the grid.
Scenario scenario_of(const CellGrid& grid, const PublishedTask& leg, std::size_t method) {
  Scenario scenario;
  scenario.map.grids = {grid};
  scenario.vehicle.footprint = {{}, 0.0};
  scenario.vehicle.drive = Differential{0.6};
  scenario.start = make_pose(leg.start, 0.0);
  scenario.mission = make_pose(leg.goal, 0.0);
  scenario.planner = {planners_of[method], {}};
  return scenario;
}

/// Planned and proven. Its ways are measured with a point each metre.
Way corrected(const CellGrid& grid, const std::vector<PublishedTask>& legs, std::size_t method, int repetitions) {
  Way way;
  const auto without = [&](std::string reason) {
    way.is_found = way.is_proven = false;
    way.reason = std::move(reason);
    return way;
  };
  std::vector<Problem> problems;
  for (const PublishedTask& leg : legs) {
    auto problem = Problem::prepare(scenario_of(grid, leg, method));
    if (!problem) return without(problem.error().message());
    problems.push_back(std::move(*problem));
  }
  const PlannerDescription& description = *find_planner(planners_of[method]);
  const Parameters parameters = *complete_parameters(description, {});
  std::vector<AnyPlanner> ready;
  for (const Problem& problem : problems) ready.push_back(description.make(parameters, problem.scenario().seed).prepared(problem));
  std::vector<PlanningResult> found(legs.size());
  const double seconds = timed(repetitions, [&] {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      Budget budget;
      found[i] = ready[i].plan(problems[i], budget);
    }
  });
  way.is_found = way.is_proven = true;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!found[i]) return without(found[i].error().failure.reason);
    const Plan plan = judge(problems[i], problems[i].whole_path(found[i]->path));
    if (plan.status != Status::solved) {
      way.is_proven = false;
      way.reason = plan.reason;
    }
    std::vector<Vec2> points{legs[i].start};
    for (const Piece& piece : plan.path.pieces) {
      if (const auto* line = std::get_if<Line>(&piece.curve)) points.push_back(line->to);
    }
    way.legs.push_back(with_points_between(points, grid.cell));
  }
  measure_way(way, grid, seconds);
  return way;
}

/// Rows as the publication's tables have them, by metric; columns by method.
using Table = std::array<std::array<double, 4>, 6>;

Experiment experiment(std::string name, std::string label, const char* map, const char* own_map, std::vector<std::size_t> legs, const Table& table) {
  Experiment e;
  e.name = std::move(name);
  e.label = std::move(label);
  e.map = map;
  const PublishedMap published = published_map(map).value();
  e.grid = published.grid;
  e.own_grid = published_map(own_map).value().grid;
  for (const std::size_t leg : legs) e.legs.push_back(published.tasks[leg]);
  for (std::size_t metric = 0; metric < metrics.size(); ++metric) {
    for (std::size_t method = 0; method < methods.size(); ++method) {
      if (std::isfinite(table[metric][method])) e.published[method][metric] = table[metric][method];
    }
  }
  return e;
}

std::vector<Experiment> all_experiments() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Experiment> all;
  all.push_back(experiment("9.1 convex tips", "9.1 convex tips", "SA-CONVEX", "SA-CONVEX", {0},
                           {{{380.5584, 384.0731, 446.3637, 369.5521}, {309.0022, 18.1278, 674.88, 10.6796}, {0.821, 1.725, 1.638, 1.084}, {408.99, 412.79, 479.74, 397.18},
                             {89.5353, 89.5353, 15.3482, 6.1191}, {47.69, 47.34, 52.92, 62.07}}}));
  all.push_back(experiment("9.1 narrow passages", "9.1 narrow passages", "SA-NARROW", "SA-NARROW", {0},
                           {{{421.7056, 426.8772, 557.1755, 414.3527}, {1032.9641, 121.5572, 1052.6305, 12.5214}, {0.746, 1.988, 1.758, 1.322}, {453.26, 458.82, 598.87, 445.3636},
                             {67.5442, 64.4026, 19.1333, 8.2937}, {47.07, 47.06, 41.23, 57.24}}}));
  all.push_back(experiment("9.2 random obstacles 1", "9.2 random obstacles 1", "SA-RAND1", "SA-RAND1", {0},
                           {{{202.6345, 202.6345, 200.2812, 196.5703}, {144.3658, 0, 113.4513, 0}, {0.444, 1.921, 1.758, 1.662}, {217.80, 217.63, 215.27, 211.27},
                             {18.8495, 14.1371, 3.1433, 2.1136}, {76.73, 77.48, 79.47, 80.00}}}));
  all.push_back(experiment("9.2 random obstacles 2", "9.2 random obstacles 2", "SA-RAND2", "SA-RAND2", {0},
                           {{{209.0782, 215.1787, 205.7177, 202.2907}, {319.2708, 74.6585, 241.0164, 0.493}, {0.432, 1.571, 1.467, 1.441}, {224.73, 231.10, 221.12, 217.42},
                             {26.7035, 34.5575, 8.4618, 3.9394}, {74.84, 72.98, 78.08, 79.14}}}));
  all.push_back(experiment("9.2 random obstacles 3", "9.2 random obstacles 3", "SA-RAND3", "SA-RAND3", {0},
                           {{{215.5218, 217.865, 217.815, 206.8147}, {402.6708, 0, 383.6158, 0}, {0.569, 1.998, 2.047, 1.669}, {231.65, 233.99, 234.12, 222.28},
                             {9.4247, 40.8407, 9.3452, 6.4203}, {76.94, 71.71, 76.73, 78.29}}}));
  all.push_back(experiment("9.3 irregular obstacles, SHA* on rectangles around them", "9.3 irregular; SHA* on rectangles", "SA-IRR", "SA-IRR-REG", {0},
                           {{{256.22, 258.56, 262.91, 254.6071}, {none, none, none, none}, {none, none, none, none}, {none, none, none, none}, {31.4, 25.1, 9.4, 1.4507}, {none, none, none, none}}}));
  all.back().derived = "the publication's Table 4 has no body: lengths and turning of the first three follow from the percentages in its text and SHA*'s figures in its Table 5";
  all.push_back(experiment("9.3 rectangles around irregular obstacles, for all", "9.3 rectangles for all", "SA-IRR-REG", "SA-IRR-REG", {0},
                           {{{267.9482, 270.2914, 272.8028, 254.6071}, {361.0685, 0, 579.6919, 0}, {1.482, 2.952, 5.291, 2.639}, {288.00, 290.29, 293.22, 273.65},
                             {18.8495, 10.9955, 8.4829, 1.4507}, {70.20, 71.22, 71.36, 73.90}}}));
  all.push_back(experiment("9.4 warehouse: parking, goods at (29, 19), exit", "9.4 warehouse, goods at (29, 19)", "SA-WH", "SA-WH", {0, 1},
                           {{{69.5979, 72.0951, 72.8876, 68.7244}, {138.1442, 42.4914, 113.3893, 25.0093}, {0.005, 0.068, 0.308, 0.059}, {74.81, 77.43, 78.34, 73.86},
                             {10.9955, 8.1757, 15.2596, 3.7121}, {91.29, 91.48, 90.28, 92.53}}}));
  all.push_back(experiment("9.4 warehouse: parking, goods at (21, 35), exit", "9.4 warehouse, goods at (21, 35)", "SA-WH", "SA-WH", {2, 3},
                           {{{70.7695, 69.4984, 71.3202, 68.7627}, {127.4218, 43.8785, 139.0656, 15.2428}, {0.006, 0.076, 0.359, 0.066}, {76.07, 74.64, 76.66, 73.91},
                             {25.1327, 9.6706, 11.3625, 3.4535}, {88.92, 91.51, 91.05, 92.57}}}));
  return all;
}

}  // namespace

double reduction_of(std::size_t metric, double other, double own_figure) { return metric == power ? power_reduction(other, own_figure) : reduction(other, own_figure); }

std::vector<Experiment> safe_astar(int repetitions, const std::atomic<bool>* cancel) {
  std::vector<Experiment> done;
  for (Experiment& e : all_experiments()) {
    if (cancel != nullptr && *cancel) break;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const CellGrid& grid = m == own ? e.own_grid : e.grid;
      e.ours[m] = as_published(grid, e.legs, published_methods[m], repetitions);
      e.corrected[m] = corrected(grid, e.legs, m, repetitions);
    }
    done.push_back(std::move(e));
  }
  return done;
}

}  // namespace waywright::reproduction
