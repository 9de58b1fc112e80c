// Is a straight line free for a disc? Sphere tracing in the distance bounds of the cells, and the exact outlines where those do not tell.
#pragma once

#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/scenario/zone_rules.hpp"

namespace waywright {

class Sight {
 public:
  Sight(const Problem& problem, const GridFrame& frame, const CellBounds& bounds, double radius) : problem_{problem}, frame_{frame}, bounds_{bounds}, radius_{radius} {}

  /// Does a disc keep more than `margin` m from everything on the way?
  bool is_free(Vec2 from, Vec2 to, double margin) const;

 private:
  const Problem& problem_;
  const GridFrame& frame_;
  const CellBounds& bounds_;
  double radius_;
};

/// The same ends, fewer corners: each is left out that the ones before and after it see each other past. Never longer. The first and last leg need
/// `end_margin`, the others `margin`. With `zones` no leg is new that breaks a directed zone's rule, or that costs more than what it replaces.
std::vector<Vec2> pulled_taut(std::vector<Vec2> points, const Sight& sight, double margin, double end_margin, const ZoneRules* zones = nullptr);

double length_of(const std::vector<Vec2>& points);
/// The same as zones weigh it.
double cost_of(const std::vector<Vec2>& points, const ZoneRules& zones);

}  // namespace waywright
