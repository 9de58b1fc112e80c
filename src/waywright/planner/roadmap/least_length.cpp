#include "waywright/planner/roadmap/least_length.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {
namespace {

constexpr double rounding = 1e-6;  // m, under what the proof can tell
constexpr std::size_t most_corners = 3000;
constexpr double least_curvature = 1e-3;  // 1/m, that the curves' rounding is small for

/// How many corners may be left where there are very many: as much work as a roadmap or a tree is.
std::optional<std::int64_t> expansions_for(std::size_t corners) {
  constexpr std::size_t looked_at = 2'000'000;  // corners, from all that are left together
  if (corners <= most_corners) return std::nullopt;
  return static_cast<std::int64_t>(1 + looked_at / corners);
}

LeastLength least_of_disc(const PlaneSpace& space, Budget& budget) {
  const Problem& problem = space.problem();
  LeastLength least;
  least.metres = least_way(problem);
  least.is_straight = true;
  const Footprint& footprint = problem.footprint();
  least.disc = footprint.is_disc() ? footprint.disc : footprint.inner_radius();
  const double radius = std::max(rounding, least.disc + problem.required_clearance() - rounding);
  const Vec2 start = problem.start().position();
  const PlaneTarget goal = target_of(problem, problem.goal().position());
  // A straight line that is free needs no corners.
  if (space.is_free(start, goal.nearest(start), radius)) {
    least.is_straight = false;
    return least;
  }
  const TangentGraph graph{space, radius, radius - 0.5 * rounding, Rounding::optimistic};
  const TangentAnswer answer = graph.shortest(start, goal, budget, expansions_for(graph.corners()));
  if (answer.ended == TangentEnd::expansions && answer.least - rounding > least.metres) {
    least.metres = answer.least - rounding;
    least.is_straight = false;
    least.is_partial = true;
  }
  if (answer.ended == TangentEnd::found) {
    least.metres = std::max(least.metres, answer.way.length);
    least.is_straight = false;
  } else if (answer.ended == TangentEnd::unreachable) {
    least.is_unreachable = true;
  } else {
    least.is_cut_short = answer.ended == TangentEnd::stopped;
  }
  return least;
}

}  // namespace

LeastLength least_length(const PlaneSpace& space, Budget& budget) {
  LeastLength least = least_of_disc(space, budget);
  const Problem& problem = space.problem();
  const double curvature = problem.vehicle().max_curvature();
  if (problem.vehicle().can_turn_on_the_spot() || problem.free_goal() != nullptr || !std::isfinite(curvature) || curvature < least_curvature) return least;
  const double driven = ReedsShepp{1.0 / curvature}.distance(problem.start(), problem.goal()) - rounding;
  if (driven > least.metres) {
    least.metres = driven;
    least.is_curve = true;
    least.is_straight = least.is_partial = false;
  }
  return least;
}

std::string bound_sentence(const LeastLength& least, double metres) {
  if (least.is_partial) {
    return fmt::format("No path from start to goal can be shorter than {:.3f} m (by a visibility graph of the disc of {:.3f} m that the footprint holds, searched in part, as the map has very many corners): this one is at "
                       "most {:.2f} % longer than the shortest.",
                       least.metres, least.disc, std::max(0.0, metres / least.metres - 1.0) * 100.0);
  }
  if (least.is_unreachable || !(least.metres > 0.0)) return {};
  const std::string how = least.is_curve       ? std::string{"the Reeds-Shepp curve of the vehicle's least turning radius, were there nothing in the way"}
                          : least.is_cut_short ? std::string{"the straight line; the budget was over before a closer bound was found"}
                          : least.is_straight  ? std::string{"the straight line; the map has too many corners for a closer bound"}
                                               : fmt::format("the shortest way of the disc of {:.3f} m that the footprint holds, whatever its heading, by a visibility graph", least.disc);
  return fmt::format("No path from start to goal can be shorter than {:.3f} m ({}): this one is at most {:.2f} % longer than the shortest.", least.metres, how,
                     std::max(0.0, metres / least.metres - 1.0) * 100.0);
}

std::string unreachable_sentence(const LeastLength& least, const Problem& problem) {
  if (!least.is_unreachable) return {};
  return fmt::format("there is none at all: not even the disc of {:.3f} m that the footprint holds gets from start to goal with {:.4f} m of clearance (visibility graph)", least.disc,
                     problem.required_clearance());
}

}  // namespace waywright
