#include "waywright/planner/tree/improved_way.hpp"

#include <algorithm>

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {
namespace {

constexpr double little_gain = 1e-3;  // of the length, in a round
constexpr double least_bound = 1e-3;  // m

/// With a corner before and behind each, on the same lines.
std::vector<Vec2> with_more_corners(const std::vector<Vec2>& points, double bound) {
  std::vector<Vec2> more{points.front()};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double before = distance(points[i - 1], points[i]), after = distance(points[i], points[i + 1]);
    const double off_before = std::min(bound, 0.4 * before), off_after = std::min(bound, 0.4 * after);
    if (off_before > least_bound) more.push_back(points[i] + (off_before / before) * (points[i - 1] - points[i]));
    more.push_back(points[i]);
    if (off_after > least_bound) more.push_back(points[i] + (off_after / after) * (points[i + 1] - points[i]));
  }
  more.push_back(points.back());
  return more;
}

}  // namespace

ImprovedWay improved_way(const std::vector<Vec2>& way, const PlaneSpace& space, const WhaleRefinementOptions& options, int rounds, std::uint64_t seed, Budget& budget) {
  ImprovedWay improved{taut_way(way, space), 0, 0, {}, {}};
  WhaleRefinement refinement;
  refinement.draw_into(&improved.agents);
  WhaleRefinementOptions round = options;
  double length = length_of_way(improved.points);
  while (improved.rounds < rounds && round.bound > least_bound && improved.points.size() > 2 && improved.evaluations < options.evaluations && !budget.exhausted()) {
    const std::uint64_t round_seed = Random::stream(seed, 16 + static_cast<std::uint64_t>(improved.rounds)).next();
    round.evaluations = options.evaluations - improved.evaluations;
    const std::vector<Vec2> moved = refinement.refined(with_more_corners(improved.points, round.bound), space, round, round_seed, budget);
    improved.evaluations += refinement.evaluations();
    ++improved.rounds;
    std::vector<Vec2> taut = taut_way(moved, space);
    const double now = length_of_way(taut);
    if (now < length) improved.points = std::move(taut);
    if (!(now < length * (1.0 - little_gain))) round.bound *= 0.5;
    length = std::min(length, now);
    improved.ways.push_back(improved.points);
  }
  return improved;
}

}  // namespace waywright
