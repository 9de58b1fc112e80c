#include "waywright/planner/field/navigation_ways.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "waywright/planner/field/field_words.hpp"
#include "waywright/planner/field/straightened_way.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/plane/rounded_way.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::place;

constexpr double spare_shares[] = {0.5, 0.25, 0.12, 0.06};  // of the room at start and goal, that a way among trees keeps away at most
constexpr double most_spare = 0.5;        // m
constexpr double thinning = 0.002;        // m
constexpr std::size_t tree_kappas = 3;    // that are tried among trees
constexpr double worth_another = 1.25;    // a way down the published map that is longer than so many times the straight line is held against trees
constexpr double room_at_corners = 0.75;  // of what a straightened way keeps, that arcs at its corners keep still
constexpr double difference = 1e-6;       // of the world's radius
const std::vector<double> usual_kappas{8.0, 3.0, 5.0, 12.0, 20.0};  // where none is shown to do; 8 is the reconstruction's

bool is_there(const NavigationWay& found) { return found.way.descent.ended == DescentEnd::goal; }

std::string not_all_tried(const Budget& budget) { return fmt::format("The limit of {} was reached before all was tried.", counted(budget.limits().evaluations.value_or(0), "evaluation")); }

/// By differences: how the slope changes.
SymmetricMatrix curvature_of(const StarNavigation& navigation, Vec2 q) {
  const double h = difference * navigation.function().world().outside.radius;
  const Vec2 dx = (0.5 / h) * (navigation.slope(q + Vec2{h, 0}) - navigation.slope(q - Vec2{h, 0})), dy = (0.5 / h) * (navigation.slope(q + Vec2{0, h}) - navigation.slope(q - Vec2{0, h}));
  return {dx.x, 0.5 * (dx.y + dy.x), dy.y};
}

/// λ is the least that does not fold the map, κ those that lead to the goal in the model.
NavigationWay by_published_map(const NavigationOptions& options, const PlaneSpace& space, const StarWorld& world, Vec2 start, Vec2 goal, Budget& budget) {
  NavigationWay found;
  double lambda = options.lambda;
  if (lambda == 0.0) {
    const ChosenLambda chosen = choose_lambda(world, goal, 140, [&] { return budget.exhausted(); });
    lambda = chosen.lambda;
    found.text.push_back(chosen.is_shown ? fmt::format("λ = {:g} is the least power of ten with which the map to a world of discs folds at none of 140 × 140 places.", lambda)
                                         : fmt::format("With no λ up to {:g} the map to a world of discs was free of folds.", lambda));
  }
  const StarMap map{world, goal, lambda};
  std::vector<double> kappas{options.kappa};
  if (options.kappa == 0.0) {
    kappas = kappas_that_lead_to_goal(map.model(), goal, [&] { return budget.exhausted(); });
    if (kappas.empty()) {
      kappas = usual_kappas;
      found.text.push_back("No κ of those looked at up to 4096 was shown to leave no minimum but the goal in the model; some are tried.");
    }
  }
  const auto rim = [&](Vec2 q) { return distance_to_polygons(space, q); };
  const auto down = [&](double kappa) {
    const StarNavigation navigation{world, goal, lambda, kappa};
    const auto slope = [&](Vec2 q) { return navigation.slope(q); };
    const auto curvature = [&](Vec2 q) { return curvature_of(navigation, q); };
    const auto step = [&](Vec2 q, double longest) -> std::optional<Vec2> {
      const Vec2 way = slope(q);
      const double steep = norm(way);
      if (!(steep > 0.0) || !std::isfinite(steep)) return std::nullopt;
      return q - (longest / steep) * way;
    };
    const auto off = [&](Vec2 q) { return way_off(curvature(q)); };
    const auto minimum = [&](Vec2 q, double within) { return minimum_near(slope, curvature, rim, q, within); };
    return follow(NavigationSlope{step, rim, off, minimum, goal, world.outside.greatest_rim(), world.obstacles.size()}, start, options.steps, budget);
  };
  found.way = best_way(kappas, down, rim, budget);
  const double kappa = found.way.kappa;
  found.drawn = [=](std::optional<Vec2> trap) { return star_drawing(world, goal, lambda, kappa, trap); };
  found.text.push_back(fmt::format("Down the navigation function of κ = {:g} on the world of discs that the map of λ = {:g} makes of {}: {}.", kappa, lambda,
                                   counted(static_cast<std::int64_t>(world.obstacles.size()), "star"), counted(found.way.descent.steps, "step")));
  return found;
}

struct Among {
  FollowedWay way;
  bool is_shown = false;
};
/// The first few κ that lead to the goal in the model. No λ is needed: the map of trees cannot fold.
Among down_among(const NavigationOptions& options, const PlaneSpace& space, const TreeMap& map, Vec2 start, Vec2 goal, Budget& budget) {
  std::vector<double> kappas{options.kappa};
  Among among;
  if (options.kappa == 0.0) {
    kappas = kappas_that_lead_to_goal(map.model(), map.at(goal).at, [&] { return budget.exhausted(); }, tree_kappas);
    among.is_shown = !kappas.empty();
    if (kappas.empty()) kappas = usual_kappas;
    kappas.resize(std::min(kappas.size(), tree_kappas));
  }
  const auto rim = [&](Vec2 q) { return map.distance_to_rim(q); };
  const double longest = options.steps.step * map.stars().back().disc().radius;
  const auto down = [&](double kappa) {
    const TreeNavigation navigation{map, goal, kappa};
    // Steps are not shortened near rims: that they are free is looked at, and along a wall, where leaves are drawn in, the way may be within a hair of it for metres.
    const auto step = [&](Vec2 q, double) { return std::optional{navigation.next(q, longest)}; };
    const auto off = [&](Vec2 q) { return navigation.way_off(q); };
    const auto minimum = [&](Vec2 q, double within) { return navigation.minimum_near(q, within); };
    return follow(NavigationSlope{step, rim, off, minimum, goal, map.stars().back().disc().radius, map.model().obstacles.size()}, start, options.steps, budget);
  };
  among.way = best_way(kappas, down, [&](Vec2 q) { return distance_to_polygons(space, q); }, budget);
  return among;
}

bool has_convex_polygons(const PlaneSpace& space) {
  const Map& map = space.problem().world().map();
  const auto all_are = [](const std::vector<Ring>& rings) { return std::all_of(rings.begin(), rings.end(), [](const Ring& ring) { return is_convex(ring); }); };
  return all_are(map.obstacles) && all_are(map.boundaries);
}

/// Lines in place of detours: the model's straight ways follow walls and arms, seen back. m, how long it was.
double straighten(FollowedWay& way, const PlaneSpace& space, Vec2 goal, double step) {
  std::vector<Vec2>& points = way.descent.points;
  if (points.back() != goal) points.push_back(goal);
  const double before = length_of_way(points);
  const std::vector<Vec2> corners = straightened_way(space, thinned_way(space, points, thinning));
  points = {corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto parts = static_cast<int>(std::ceil(std::max(1.0, distance(corners[i - 1], corners[i]) / step)));
    for (int k = 1; k <= parts; ++k) points.push_back(k == parts ? corners[i] : corners[i - 1] + (static_cast<double>(k) / parts) * (corners[i] - corners[i - 1]));
  }
  way.length = length_of_way(points);
  way.room = std::numeric_limits<double>::infinity();
  for (const Vec2 p : points) way.room = std::min(way.room, distance_to_polygons(space, p));
  return before;
}

void prepend(NavigationWay& found, std::string sentence) { found.text.insert(found.text.begin(), std::move(sentence)); }

}  // namespace

NavigationWay way_among_discs(const NavigationOptions& options, const SphereWorld& world, Vec2 start, Vec2 goal, Budget& budget) {
  NavigationWay found;
  std::vector<double> kappas{options.kappa};
  if (options.kappa == 0.0) {
    kappas = kappas_that_lead_to_goal(world, goal, [&] { return budget.exhausted(); });
    if (kappas.empty()) {
      kappas = usual_kappas;
      found.text.push_back("No whole κ from 2 to 20, and no greater one of those looked at up to 4096, was shown to leave no minimum but the goal; some are tried.");
    }
  }
  found.way = best_way(kappas, [&](double kappa) { return follow({world, goal, kappa}, start, options.steps, budget); }, [&](Vec2 q) { return NavigationFunction{world, goal, 1.0}.distance_to_rim(q); }, budget);
  const double kappa = found.way.kappa;
  found.drawn = [=](std::optional<Vec2> trap) { return navigation_drawing(world, goal, kappa, trap); };
  found.text.push_back(fmt::format("Down the navigation function of κ = {:g} on the disc of {:.3f} m around ({:.3f}, {:.3f}) with {} in it: {}.", kappa, world.outside.radius, world.outside.centre.x,
                                   world.outside.centre.y, counted(static_cast<std::int64_t>(world.obstacles.size()), "disc"), counted(found.way.descent.steps, "step")));
  if (is_there(found) && is_used_up(budget) && kappas.size() > 1) found.text.push_back(not_all_tried(budget));
  const std::vector<CriticalPoint> points = critical_points({world, goal, kappa}, 48, [&] { return budget.exhausted(); });
  if (leads_to_goal(points, world)) {
    found.text.push_back(fmt::format("Newton's method finds {}, one for each disc, and no minimum but the goal.{}", counted(static_cast<std::int64_t>(points.size()), "saddle"),
                                     kappas.size() > 1 ? fmt::format(" So it does for {} other κ; of the ways at most a tenth longer than the shortest of theirs this one's keeps farthest away.", kappas.size() - 1) : std::string{}));
  } else {
    for (const CriticalPoint& c : points) {
      if (c.is_minimum) found.text.push_back(fmt::format("With κ = {:g} there is another minimum than the goal, at {}.", kappa, place(c.at)));
    }
  }
  return found;
}

NavigationWay way_among_trees(const NavigationOptions& options, const PlaneSpace& space, const TreeMap& needed, Vec2 start, Vec2 goal, Budget& budget) {
  Among best = down_among(options, space, needed, start, goal, budget);
  TreeMap map = needed;
  double spare = 0.0;
  if (best.way.descent.ended == DescentEnd::goal) {
    const double shortest = best.way.length, room = std::min({most_spare, distance_to_polygons(space, start), distance_to_polygons(space, goal)});
    for (const double share : spare_shares) {
      if (budget.exhausted() || is_used_up(budget)) break;
      const auto wider = trees_with(space, start, goal, share * room, [&] { return budget.exhausted(); });
      if (!wider) continue;
      Among other = down_among(options, space, *wider, start, goal, budget);
      if (other.way.descent.ended != DescentEnd::goal || other.way.length > longer_allowed * shortest) continue;
      best = std::move(other);
      map = *wider;
      spare = share * room;
      break;
    }
  }
  NavigationWay found;
  found.drawn = [map = std::make_shared<const TreeMap>(map), goal, kappa = best.way.kappa](std::optional<Vec2> trap) { return tree_drawing(map, goal, kappa, trap); };
  const auto leaves = static_cast<std::int64_t>(map.leaves().size()), discs = static_cast<std::int64_t>(map.model().obstacles.size());
  found.text.push_back(fmt::format("As trees of stars obstacles and boundary are seen as a world of {} in a disc of {:.3f} m{}.", counted(discs, "disc"), map.model().outside.radius,
                                   leaves == 0 ? std::string{} : fmt::format(", when {} drawn in", leaves == 1 ? "1 leaf is" : fmt::format("{} leaves are", leaves))));
  if (spare > 0.0) found.text.push_back(fmt::format("All is grown by {:.3f} m more than the vehicle needs, which makes the way no more than a tenth longer.", spare));
  if (options.kappa == 0.0 && !best.is_shown) found.text.push_back("No κ was shown to leave no minimum but the goal in the model; some are tried.");
  found.text.push_back(fmt::format("Down the navigation function of κ = {:g} on that world of discs, seen back: {}.", best.way.kappa, counted(best.way.descent.steps, "step")));
  found.way = std::move(best.way);
  if (!is_there(found)) return found;
  if (is_used_up(budget)) found.text.push_back(not_all_tried(budget));
  const double before = straighten(found.way, space, goal, options.steps.step * map.stars().back().disc().radius);
  found.keeps = room_at_corners * std::max(0.0, found.way.room);
  found.text.push_back(fmt::format("Lines that keep at least as far from everything take the place of its detours: {:.2f} m of {:.2f} m.", found.way.length, before));
  return found;
}

NavigationWay way_among_stars(const NavigationOptions& options, const PlaneSpace& space, const StarWorld& world, Vec2 start, Vec2 goal, Budget& budget) {
  const auto as_trees = [&]() -> tl::expected<NavigationWay, std::string> {
    const auto trees = trees_with(space, start, goal, 0.0, [&] { return budget.exhausted(); });
    if (!trees) return tl::unexpected{trees.error()};
    return way_among_trees(options, space, *trees, start, goal, budget);
  };
  const auto is_over = [&] { return budget.exhausted() || is_used_up(budget); };
  if (options.lambda > 0.0 || has_convex_polygons(space)) {
    NavigationWay published = by_published_map(options, space, world, start, goal, budget);
    const bool is_found = is_there(published);
    if (is_over() || (is_found && (options.lambda > 0.0 || !(published.way.length > worth_another * distance(start, goal))))) return published;
    auto trees = as_trees();
    if (is_found) {
      if (!trees || !is_there(*trees) || !(longer_allowed * trees->way.length < published.way.length)) return published;
      prepend(*trees, fmt::format("Down the published map from stars to discs the way is {:.2f} m long; so all is seen as trees of stars, among which it is shorter.", published.way.length));
      return *std::move(trees);
    }
    if (is_over() && !(trees && is_there(*trees))) return published;
    if (!trees) {
      published.text.push_back("Trees of stars do not serve either: " + trees.error() + ".");
      return published;
    }
    prepend(*trees, fmt::format("The published map from stars to discs does not lead to the goal: {}. So all is seen as trees of stars, by a map that cannot fold.", end_of_descent(published.way.descent, goal, space, budget)));
    return *std::move(trees);
  }
  auto trees = as_trees();
  if (trees && (is_there(*trees) || is_over())) return *std::move(trees);
  NavigationWay published = by_published_map(options, space, world, start, goal, budget);
  if (trees && !is_there(published)) return *std::move(trees);
  prepend(published, fmt::format("Seen as trees of stars it does not come to the goal: {}. So it goes through the published map from stars to discs.",
                                 trees ? end_of_descent(trees->way.descent, goal, space, budget) : trees.error()));
  return published;
}

}  // namespace waywright
