// The lattice of one problem: states (cell, heading, direction of arrival), the motions between them, and those that lead from them into the goal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/state_lattice/motion_primitives.hpp"

namespace waywright {

struct LatticeOptions {
  double cell = 0.0;        ///< m; 0: an eighth of the least radius, 0.1 to 0.5
  double min_radius = 0.5;  ///< m, of vehicles whose curvature is not limited
  bool may_turn = true;     ///< on the spot, where the vehicle can
  bool may_forward = true, may_reverse = true;  ///< as it is planned
  double bend_share = 0.2;  ///< by so much a metre at the sharpest bend costs more
  DangerCosts costs{};      ///< `bend` is made of the share
};

/// A cell of the lattice: `column` along the start's heading, `row` to its left, both from the start.
struct LatticeCell {
  int column = 0, row = 0;
};

/// From a state into the goal.
struct GoalMotion {
  std::uint32_t cell = 0;
  int heading = 0;         ///< of the vehicle in the state
  std::vector<LatticeStretch> stretches;  ///< in the world
  int direction = 1;       ///< it begins with, turns aside
  double metres = 0.0;     ///< what it costs where nothing is near
};

class LatticeGraph {
 public:
  static constexpr std::int64_t most_cells = 500'000;
  static constexpr double least_cell = 0.01;  ///< m
  static constexpr double most_cells_a_radius = 200.0;

  /// `refused` says why there is none. @pre the problem outlives this
  LatticeGraph(const Problem& problem, const LatticeOptions& options);

  const std::string& refused() const { return refused_; }
  const LatticeOptions& options() const { return options_; }
  const BendLimits& limits() const { return limits_; }
  double cell() const { return cell_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cells() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  std::uint32_t start_cell() const { return index({0, 0}); }
  const MotionPrimitives& primitives() const { return primitives_; }
  const std::vector<GoalMotion>& goal_motions() const { return goal_motions_; }  ///< in the order of cells
  /// Those of a cell: from the first to before the second.
  std::pair<std::size_t, std::size_t> goal_motions_of(std::uint32_t cell) const;

  std::optional<std::uint32_t> moved(std::uint32_t cell, LatticeStep step) const;
  Vec2 place(std::uint32_t cell) const { return frame_.to_world(local(cell)); }
  Pose pose(std::uint32_t cell, int heading) const { return make_pose(place(cell), wrap(frame_.heading() + lattice_heading(heading))); }
  /// A primitive where it is driven from the cell.
  LatticeStretch stretch(std::uint32_t cell, const MotionPrimitive& primitive) const;

  /// m, the footprint's clearance is at most this where its origin is in the cell's place, whatever it faces.
  double clearance_at_most(std::uint32_t cell) const { return at_most_[cell]; }
  /// The same for any place of the world.
  double clearance_at_most(Vec2 place) const;
  /// Not even the largest disc in the footprint can get from start to goal.
  bool is_cut_off() const { return is_cut_off_; }
  /// m, nothing is nearer to this point of the world.
  double distance_at_least(Vec2 point) const;
  double margin() const { return margin_; }
  double required() const { return required_; }

 private:
  std::uint32_t index(LatticeCell c) const { return static_cast<std::uint32_t>(c.row - first_.row) * static_cast<std::uint32_t>(columns_) + static_cast<std::uint32_t>(c.column - first_.column); }
  LatticeCell cell_at(std::uint32_t i) const {
    return {first_.column + static_cast<int>(i % static_cast<std::uint32_t>(columns_)), first_.row + static_cast<int>(i / static_cast<std::uint32_t>(columns_))};
  }
  Vec2 local(std::uint32_t i) const {
    const LatticeCell c = cell_at(i);
    return {c.column * cell_, c.row * cell_};
  }
  bool set_extent(const Problem& problem);
  void bound_clearances();
  void look_for_a_way(const Problem& problem);
  void find_goal_motions(const Problem& problem);

  std::string refused_;
  LatticeOptions options_;
  BendLimits limits_;
  double cell_ = 0.0, margin_ = 0.0, required_ = 0.0;
  Frame frame_;
  LatticeCell first_{};
  int columns_ = 0, rows_ = 0;
  GridFrame grid_;
  std::optional<CellBounds> bounds_;
  double inner_radius_ = 0.0;
  bool is_cut_off_ = false;
  MotionPrimitives primitives_;
  std::vector<GoalMotion> goal_motions_;
  std::vector<float> at_most_;
};

}  // namespace waywright
