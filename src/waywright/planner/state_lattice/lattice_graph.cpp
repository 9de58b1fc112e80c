#include "waywright/planner/state_lattice/lattice_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {
namespace {

constexpr double cells_a_radius = 8.0;
constexpr double finest = 0.1, coarsest = 0.5;  // m, of cells that nobody asked for
constexpr double rounded_to = 0.05;                // m
constexpr double usual_cells = 120'000;          // where nobody asks
constexpr double most_bent = 0.6;                // rad, of a motion into the goal: how far the chord leaves that of an arc
constexpr std::size_t most_a_heading = 16;       // motions into the goal from states of one heading and direction, the shortest
constexpr double same_place = 1e-9;              // m
constexpr std::size_t most_tries = 3000;         // of motions into the goal, of each heading and direction
constexpr double near_by = 2.5;                  // cells, from where a vehicle that turns on the spot drives straight to the goal

/// m, of the largest disc about the origin in the footprint; of one that the origin is outside of: less than nothing, by how far it is.
double reach_inside(const Footprint& footprint) {
  const double inner = footprint.inner_radius();
  if (inner > 0.0 || footprint.is_disc()) return inner;
  return -distance(nearest_in(footprint.polygon, {0.0, 0.0}), {0.0, 0.0});
}

double cell_of(double radius) { return std::clamp(rounded_to * std::round(radius / cells_a_radius / rounded_to), finest, coarsest); }

}  // namespace

LatticeGraph::LatticeGraph(const Problem& problem, const LatticeOptions& options)
    : options_{options}, margin_{connecting_margin(problem)}, required_{problem.required_clearance()}, frame_{problem.start()} {
  const Vehicle& vehicle = problem.vehicle();
  if (problem.is_driven_back()) {
    std::swap(options_.costs.forward, options_.costs.reverse);
    std::swap(options_.may_forward, options_.may_reverse);
  }
  options_.may_turn = options.may_turn && vehicle.can_turn_on_the_spot();
  limits_.curvature = std::isfinite(vehicle.max_curvature()) ? vehicle.max_curvature() : 1.0 / options.min_radius;
  limits_.curvature_rate = vehicle.limits.curvature_rate.value_or(std::numeric_limits<double>::infinity());
  if (!(limits_.curvature > 0.0)) {
    refused_ = "the vehicle cannot bend its way at all: its curvature is limited to 0";
    return;
  }
  options_.costs.bend = options.bend_share / (limits_.curvature * limits_.curvature);
  cell_ = options.cell > 0.0 ? options.cell : cell_of(1.0 / limits_.curvature);
  if (cell_ < least_cell) {
    refused_ = fmt::format("the resolution is {:g} m, and cells of {:g} m or more are searched", cell_, least_cell);
    return;
  }
  if (!set_extent(problem)) return;
  if (const double radius = 1.0 / limits_.curvature; radius > most_cells_a_radius * cell_) {
    refused_ = fmt::format("the vehicle's least radius, {:g} m, is more than {:g} cells of {:g} m: give a coarser resolution", radius, most_cells_a_radius, cell_);
    return;
  }
  bounds_.emplace(problem, grid_);
  inner_radius_ = reach_inside(problem.footprint());
  bound_clearances();
  look_for_a_way(problem);
  const MotionCost cost{problem, options_.costs, margin_};
  const double diagonal = cell_ * std::sqrt(static_cast<double>(columns_) * columns_ + static_cast<double>(rows_) * rows_);
  primitives_ = motion_primitives({cell_, limits_, options_.may_turn, options_.may_forward, options_.may_reverse, 2.0 * diagonal, frame_.heading()}, cost);
  find_goal_motions(problem);
}

/// The lattice covers all that grids for this problem would.
bool LatticeGraph::set_extent(const Problem& problem) {
  for (;;) {
    auto grid = make_grid_frame(problem, 0.5 * cell_);
    if (grid) {
      grid_ = *grid;
      Box box{{0.0, 0.0}, {0.0, 0.0}};
      const double width = grid_.columns * grid_.cell, height = grid_.rows * grid_.cell;
      for (const Vec2 corner : {Vec2{0.0, 0.0}, Vec2{width, 0.0}, Vec2{0.0, height}, Vec2{width, height}}) {
        const Vec2 p = frame_.to_local(grid_.frame.to_world(corner));
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
      }
      const double columns = std::floor(box.high.x / cell_) - std::ceil(box.low.x / cell_) + 1.0, rows = std::floor(box.high.y / cell_) - std::ceil(box.low.y / cell_) + 1.0;
      if (columns * rows <= (options_.cell > 0.0 ? static_cast<double>(most_cells) : usual_cells)) {
        first_ = {static_cast<int>(std::ceil(box.low.x / cell_)), static_cast<int>(std::ceil(box.low.y / cell_))};
        columns_ = static_cast<int>(columns);
        rows_ = static_cast<int>(rows);
        return true;
      }
      if (options_.cell > 0.0) {
        refused_ = fmt::format("the lattice would have {:.0f} x {:.0f} cells of {:g} m, and at most {} are searched: give a coarser resolution", columns, rows, cell_, most_cells);
        return false;
      }
    } else if (options_.cell > 0.0 || cell_ > 100.0) {
      refused_ = fmt::format("for cells of {:g} m {}", cell_, grid.error());
      return false;
    }
    cell_ *= 2.0;
  }
}

double LatticeGraph::clearance_at_most(Vec2 place) const {
  const Vec2 at = grid_.in_cells(place);
  const Cell c = grid_.cell_at(place);
  // Beyond a grid of the map's own all is blocked; beyond cells that were laid over what can be driven on nothing is known.
  if (!grid_.contains(c)) return grid_.is_native ? std::max(0.0, -inner_radius_) : std::numeric_limits<double>::infinity();
  const double x = at.x - c.column - 0.5, y = at.y - c.row - 0.5;
  return bounds_->at_most(c) + std::sqrt(x * x + y * y) * grid_.cell * (1.0 + 1e-9) - inner_radius_;
}

void LatticeGraph::bound_clearances() {
  at_most_.resize(cells());
  for (std::uint32_t i = 0; i < at_most_.size(); ++i) at_most_[i] = std::nextafter(static_cast<float>(clearance_at_most(place(i))), std::numeric_limits<float>::infinity());
}

/// Where the origin goes on any way that is free, it passes from one cell of the grid to one that touches it, and each holds a place with the clearance that is required.
void LatticeGraph::look_for_a_way(const Problem& problem) {
  const Cell from = grid_.cell_at(problem.start().position()), to = grid_.cell_at(problem.goal().position());
  if (!grid_.contains(from) || !grid_.contains(to)) return;  // on the border, or beyond what is known
  const auto columns = static_cast<std::size_t>(grid_.columns);
  std::vector<std::uint8_t> seen(columns * static_cast<std::size_t>(grid_.rows), 0);
  const auto at = [&](Cell c) { return static_cast<std::size_t>(c.row) * columns + static_cast<std::size_t>(c.column); };
  std::vector<Cell> open{from};
  seen[at(from)] = 1;
  while (!open.empty()) {
    const Cell c = open.back();
    open.pop_back();
    if (c == to) return;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {
        const Cell next{c.column + dc, c.row + dr};
        // Ways beyond the cells are not looked at: there all counts as free.
        if (!grid_.contains(next)) {
          if (!grid_.is_native) return;
          continue;
        }
        if (seen[at(next)] != 0) continue;
        seen[at(next)] = 1;
        if (bounds_->at_most(next) + half_cell_diagonal * grid_.cell - inner_radius_ >= required_) open.push_back(next);
      }
    }
  }
  is_cut_off_ = true;
}

double LatticeGraph::distance_at_least(Vec2 point) const {
  const Cell c = grid_.cell_at(point);
  return grid_.contains(c) ? bounds_->at_least(c) - half_cell_diagonal * grid_.cell : 0.0;
}

std::pair<std::size_t, std::size_t> LatticeGraph::goal_motions_of(std::uint32_t cell) const {
  const auto [low, high] = std::equal_range(goal_motions_.begin(), goal_motions_.end(), GoalMotion{cell, 0, {}, 0, 0.0}, [](const GoalMotion& a, const GoalMotion& b) { return a.cell < b.cell; });
  return {static_cast<std::size_t>(low - goal_motions_.begin()), static_cast<std::size_t>(high - goal_motions_.begin())};
}

std::optional<std::uint32_t> LatticeGraph::moved(std::uint32_t cell, LatticeStep step) const {
  const LatticeCell from = cell_at(cell), to{from.column + step.column, from.row + step.row};
  if (to.column < first_.column || to.row < first_.row || to.column >= first_.column + columns_ || to.row >= first_.row + rows_) return std::nullopt;
  return index(to);
}

LatticeStretch LatticeGraph::stretch(std::uint32_t cell, const MotionPrimitive& primitive) const {
  return placed(primitive.stretch, Frame{make_pose(place(cell), frame_.heading())});
}

/// Smooth ones within the limits, and for a vehicle that turns on the spot: turn, straight on, turn.
void LatticeGraph::find_goal_motions(const Problem& problem) {
  const Pose goal = frame_.to_local(problem.goal());
  const auto add = [&](std::uint32_t cell, int heading, int direction, std::vector<LatticeStretch> stretches) {
    GoalMotion m{cell, heading, {}, direction, 0.0};
    for (const LatticeStretch& s : stretches) {
      m.stretches.push_back(placed(s, frame_));
      m.metres += options_.costs.metres_of(s);
    }
    goal_motions_.push_back(std::move(m));
  };
  // Long enough for every heading's smallest turn or shift.
  double longest = 0.0;
  for (int h = 0; h < lattice_headings; ++h) {
    for (const MotionPrimitive& p : primitives_[static_cast<std::size_t>(h)]) {
      const int turned = std::min((p.to - h + lattice_headings) % lattice_headings, (h - p.to + lattice_headings) % lattice_headings);
      if (turned <= 1) longest = std::max(longest, p.length);
    }
  }
  const double reach = 1.3 * longest + 2.0 * cell_;
  const int around = static_cast<int>(std::ceil(reach / cell_));
  const LatticeCell middle{static_cast<int>(std::lround(goal.x / cell_)), static_cast<int>(std::lround(goal.y / cell_))};
  struct Near {
    double distance;
    std::uint32_t cell;
  };
  std::vector<Near> near;
  for (int row = middle.row - around; row <= middle.row + around; ++row) {
    for (int column = middle.column - around; column <= middle.column + around; ++column) {
      if (column < first_.column || row < first_.row || column >= first_.column + columns_ || row >= first_.row + rows_) continue;
      const double far = distance({column * cell_, row * cell_}, goal.position());
      const std::uint32_t cell = index({column, row});
      if (far <= reach && clearance_at_most(cell) > margin_) near.push_back({far, cell});
    }
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) { return a.distance != b.distance ? a.distance < b.distance : a.cell < b.cell; });
  const auto may = [&](int direction) { return direction < 0 ? options_.may_reverse : options_.may_forward; };
  for (const int direction : {1, -1}) {
    if (!may(direction)) continue;
    const double course = wrap(direction < 0 ? goal.heading + pi : goal.heading);
    for (int h = 0; h < lattice_headings; ++h) {
      const double turn = wrap(course - lattice_heading(h));
      if (std::abs(turn) > 0.5 * pi + 0.1) continue;
      std::size_t found = 0, tries = 0;
      for (const Near& n : near) {
        if (found == most_a_heading || tries == most_tries) break;
        const Vec2 way = goal.position() - local(n.cell);
        if (n.distance <= same_place) {
          if (std::abs(turn) <= 1e-9) add(n.cell, direction > 0 ? h : other_way(h), direction, {}), ++found;
          continue;
        }
        const double aside = wrap(angle_of(way) - lattice_heading(h));
        if (std::abs(aside) > 0.5 * pi || std::abs(2.0 * aside - turn) > most_bent) continue;
        // What turns so much within the limits is longer than what is taken between such places.
        if (std::abs(turn) > longest_fit * n.distance * limits_.curvature) continue;
        ++tries;
        auto curves = fitted_within(make_pose(local(n.cell), lattice_heading(h)), 0.0, make_pose(goal.position(), course), 0.0, limits_);
        if (curves.empty()) continue;
        add(n.cell, direction > 0 ? h : other_way(h), direction, {LatticeStretch{direction, std::move(curves), {}}});
        ++found;
      }
    }
  }
  if (options_.may_turn) {
    for (const Near& n : near) {
      if (n.distance > near_by * cell_) break;
      const Vec2 at = local(n.cell), way = goal.position() - at;
      for (int h = 0; h < lattice_headings; ++h) {
        for (const int direction : {1, -1}) {
          if (n.distance <= same_place || !may(direction)) continue;
          const double course = angle_of(way), heading = wrap(direction < 0 ? course + pi : course);
          const double first = wrap(heading - lattice_heading(h)), last = wrap(goal.heading - heading);
          if (std::abs(first) > 0.5 * pi + 1e-9) continue;
          add(n.cell, h, direction,
              {LatticeStretch{0, {}, Turn{at, lattice_heading(h), first}}, LatticeStretch{direction, {Clothoid{make_pose(at, course), 0.0, 0.0, n.distance}}, {}}, LatticeStretch{0, {}, Turn{goal.position(), heading, last}}});
        }
        if (n.distance <= same_place) add(n.cell, h, 0, {LatticeStretch{0, {}, Turn{at, lattice_heading(h), wrap(goal.heading - lattice_heading(h))}}});
      }
    }
  }
  std::stable_sort(goal_motions_.begin(), goal_motions_.end(), [](const GoalMotion& a, const GoalMotion& b) { return a.cell < b.cell; });
}

}  // namespace waywright
