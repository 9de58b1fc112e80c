// Planner `wavefront`: the way of fewest moves between cells, down the wavefront from the goal.
#pragma once

#include <memory>
#include <string_view>

#include "waywright/planner/grid/lattice.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

struct WavefrontOptions {
  double resolution = 0.0;  ///< m; 0: the map's own, or 0.05 m
  Neighbours neighbours = Neighbours::eight;
  bool keeps_away = true;   ///< of moves that lead down alike the one farthest from obstacles; else the first, as published
  bool shortens = false;    ///< leave out corners past which their neighbours see each other
};

/// For the disc around the footprint, of vehicles that move any way or turn on the spot.
class WavefrontPlanner {
 public:
  explicit WavefrontPlanner(const WavefrontOptions& options) : options_{options} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "wavefront"; }
  /// The moves between cells.
  WavefrontPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  WavefrontOptions options_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription wavefront_description();

}  // namespace waywright
