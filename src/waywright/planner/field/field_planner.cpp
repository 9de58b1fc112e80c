#include "waywright/planner/field/field_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "waywright/planner/field/field_drawings.hpp"
#include "waywright/planner/field/sphere_world_of.hpp"
#include "waywright/planner/field/star_world_of.hpp"
#include "waywright/planner/field/way_ends.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/plane/rounded_way.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;
using grid::place;

constexpr double thinning = 0.002;        // m
constexpr double rim_share = 0.2;         // of the distance to the nearest rim, that a step is long at most
constexpr double shortest_step = 1e-6;    // of the outer disc's radius
constexpr double spare_shares[] = {0.5, 0.25, 0.12, 0.06};  // of the room at start and goal, that a way among trees keeps away at most
constexpr double most_spare = 0.5;        // m
constexpr std::size_t tree_kappas = 3;    // that are tried among trees
constexpr double longer_allowed = 1.1;    // of a way that keeps farther away, over the shortest
const std::vector<double> usual_kappas{8.0, 3.0, 5.0, 12.0, 20.0};  // where none is shown to do; 8 is the reconstruction's
constexpr std::size_t most_places = 24;   // of a region, that are tried
constexpr std::size_t most_regions = 4;   // of these, to which trees are tried to be made
constexpr int region_points = 24;         // a side, that are looked at in a region for one where the disc can stand

/// Places of the goal's region where the disc can stand, the nearest to the start first.
std::vector<Vec2> places_of(const PlaneTarget& target, const PlaneSpace& space, Vec2 start) {
  std::vector<Vec2> places;
  if (const Vec2 near = target.nearest(start); space.is_free(near)) places.push_back(near);
  Vec2 low = target.area.front(), high = low;
  for (const Vec2 p : target.area) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const std::size_t nearest = places.size();
  for (int j = 0; j < region_points; ++j) {
    for (int i = 0; i < region_points; ++i) {
      const Vec2 p{low.x + (i + 0.5) / region_points * (high.x - low.x), low.y + (j + 0.5) / region_points * (high.y - low.y)};
      if (contains(target.area, p) && space.is_free(p)) places.push_back(p);
    }
  }
  std::stable_sort(places.begin() + static_cast<std::ptrdiff_t>(nearest), places.end(), [&](Vec2 a, Vec2 b) { return distance(a, start) < distance(b, start); });
  return places;
}

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  const std::size_t every = std::max<std::size_t>(1, points.size() / 2000);
  for (std::size_t i = 0; i + 1 < points.size(); i += every) poses.push_back(make_pose(points[i], angle_of(points[i + 1] - points[i])));
  return poses;
}

}  // namespace

class FieldPlanner::Ready {
 public:
  explicit Ready(const Problem& problem) : space_{problem} {}
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const FieldPlannerOptions& options, std::string_view name, Budget& budget) const {
    const Problem& problem = space_.problem();
    if (auto reason = nothing_to_plan(problem, name)) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    std::vector<Vec2> goals;
    if (start && is_region) goals = places_of(target_of(problem, {}), space_, start->at);
    else if (goal) goals = {goal->at};
    if (goals.empty()) goal.reset();
    else goal->at = goals.front();
    if (!start || !goal) {
      budget.count_evaluations();
      return tl::unexpected{no_room(space_, !start)};
    }
    std::vector<std::string> text;
    Descent descent;
    DrawingOf field_drawn;
    const std::int64_t most = std::min(options.steps, budget.evaluations_left().value_or(std::numeric_limits<std::int64_t>::max()));
    if (options.method == FieldMethod::potential) {
      // Of a region, places from the nearest to the farthest one after another: beside an obstacle one may be a trap's, and the next is not.
      const std::size_t tries = std::min(goals.size(), most_places);
      std::int64_t steps = 0;
      for (std::size_t k = 0; k < tries && (k == 0 || steps < most); ++k) {
        const Vec2 at = goals[k * goals.size() / tries];
        const PotentialField field{space_, options.potential, at};
        const auto down = [&](Vec2 q) -> std::optional<FieldStep> {
          const auto value = field.at(q);
          if (!value) return std::nullopt;
          return FieldStep{-value->gradient, value->potential};
        };
        Descent next = descend(down, start->at, at, options.descent, most - steps, budget);
        steps += next.steps;
        const bool is_last = next.ended == DescentEnd::goal || next.ended == DescentEnd::canceled || next.ended == DescentEnd::timed_out;
        if (k > 0 && is_last) text.push_back(fmt::format("On the way to {} nearer {} of the goal's region it was trapped.", k, k == 1 ? "place" : "places"));
        if (k == 0 || is_last) {
          descent = std::move(next);
          goal->at = at;
        }
        if (is_last) break;
      }
      text.push_back(fmt::format("Down the potential of the goal's attraction ({:g}, conic from {:g} m) and the repulsion of what is nearer than {:g} m ({:g}): {} of at most {:g} m.",
                                 options.potential.attraction, options.potential.conic_from, options.potential.reach, options.potential.repulsion, counted(descent.steps, "step"),
                                 options.descent.speed * options.descent.period));
      field_drawn = [&](std::optional<Vec2> trap) { return potential_drawing(options.potential, goal->at, trap); };
    } else if (options.method == FieldMethod::star) {
      auto world = stars_or_trees(space_, start->at, goal->at, [&] { return budget.exhausted(); });
      // Of a region, another place may lie where trees leave room.
      for (std::size_t k = 1; k < most_regions && !world && k < goals.size() && !budget.exhausted(); ++k) {
        goal->at = goals[k * (goals.size() - 1) / (most_regions - 1)];
        world = stars_or_trees(space_, start->at, goal->at, [&] { return budget.exhausted(); });
      }
      if (!world && budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
      if (!world) {
        budget.count_evaluations();
        return tl::unexpected{failure(Status::no_path, "the world cannot be seen as one of stars: " + world.error())};
      }
      if (const auto* trees = std::get_if<TreeMap>(&*world)) {
        descent = down_tree_navigation(options, *trees, start->at, goal->at, most, text, field_drawn, budget);
      } else {
        const StarWorld& stars = std::get<StarWorld>(*world);
        const StarMap map{stars, start->at, 1.0};
        const auto reached = std::find_if(goals.begin(), goals.end(), [&](Vec2 at) { return map.is_free(at); });
        if (reached != goals.end()) goal->at = *reached;
        descent = down_star_navigation(options, stars, start->at, goal->at, most, text, field_drawn, budget);
      }
    } else {
      const auto covering = covering_world(space_, start->at, goals);
      if (!covering) {
        budget.count_evaluations();
        return tl::unexpected{failure(Status::no_path, "a navigation function on a world of discs needs each obstacle in a disc apart from the others: " + covering.error())};
      }
      goal->at = covering->goal;
      descent = down_navigation_function(options, covering->world, start->at, goal->at, most, text, field_drawn, budget);
    }
    if (descent.ended != DescentEnd::goal) {
      PlanningFailure failed = trapped(descent, goal->at, std::move(text), name, budget);
      const bool is_trap = descent.ended == DescentEnd::local_minimum || descent.ended == DescentEnd::oscillation;
      if (field_drawn) failed.field = field_drawn(is_trap ? std::optional{descent.last} : std::nullopt);
      return tl::unexpected{std::move(failed)};
    }
    descent.points.push_back(goal->at);
    PlanningResult plan = finished_plan(space_, rounded_path(space_, *start, thinned_way(space_, descent.points, thinning), *goal), *start, *goal, std::move(text), budget);
    if (plan && field_drawn) plan->field = field_drawn(std::nullopt);
    return plan;
  }

 private:
  /// The field that was gone down, with the trap that it ended in.
  using DrawingOf = std::function<SharedDrawing(std::optional<Vec2> trap)>;

  /// With the κ that is told; else with each that is shown to do.
  static Descent down_navigation_function(const FieldPlannerOptions& options, const SphereWorld& world, Vec2 start, Vec2 goal, std::int64_t most, std::vector<std::string>& text, DrawingOf& drawn,
                                          Budget& budget) {
    std::vector<double> kappas{options.kappa};
    if (options.kappa == 0.0) {
      kappas = kappas_that_lead_to_goal(world, goal, [&] { return budget.exhausted(); });
      if (kappas.empty()) {
        kappas = usual_kappas;
        text.push_back("No whole κ from 2 to 20, and no greater one of those looked at up to 4096, was shown to leave no minimum but the goal; some are tried.");
      }
    }
    const Chosen chosen = best_of(kappas, [&](double kappa) { return follow({world, goal, kappa}, start, options, most, budget); }, [&](Vec2 q) { return NavigationFunction{world, goal, 1.0}.distance_to_rim(q); }, budget);
    const double best_kappa = chosen.kappa;
    const Descent& best = chosen.descent;
    drawn = [=](std::optional<Vec2> trap) { return navigation_drawing(world, goal, best_kappa, trap); };
    const auto discs = static_cast<std::int64_t>(world.obstacles.size());
    text.push_back(fmt::format("Down the navigation function of κ = {:g} on the disc of {:.3f} m around ({:.3f}, {:.3f}) with {} in it: {}.", best_kappa, world.outside.radius,
                               world.outside.centre.x, world.outside.centre.y, counted(discs, "disc"), counted(best.steps, "step")));
    const std::vector<CriticalPoint> points = critical_points({world, goal, best_kappa}, 48, [&] { return budget.exhausted(); });
    if (leads_to_goal(points, world)) {
      text.push_back(fmt::format("Newton's method finds {}, one for each disc, and no minimum but the goal.{}", counted(static_cast<std::int64_t>(points.size()), "saddle"),
                                 kappas.size() > 1 ? fmt::format(" So it does for {} other κ; of the ways at most a tenth longer than the shortest of theirs this one's keeps farthest away.", kappas.size() - 1) : std::string{}));
    } else {
      for (const CriticalPoint& c : points) {
        if (c.is_minimum) text.push_back(fmt::format("With κ = {:g} there is another minimum than the goal, at {}.", best_kappa, place(c.at)));
      }
    }
    return best;
  }

  struct Chosen {
    Descent descent;
    double kappa = 0.0;
  };
  /// Of the ways that are at most a tenth longer than the shortest the one that keeps farthest from all rims. Where none leads to the goal, the first.
  static Chosen best_of(const std::vector<double>& kappas, const std::function<Descent(double)>& down, const std::function<double(Vec2)>& rim, Budget& budget) {
    struct Tried {
      Chosen chosen;
      double length = std::numeric_limits<double>::infinity(), room = 0.0;
    };
    // Kept are those alone that may be chosen still, whatever comes: a descent can be long.
    std::vector<Tried> open;
    double shortest = std::numeric_limits<double>::infinity();
    for (const double kappa : kappas) {
      Tried tried{{down(kappa), kappa}};
      if (tried.chosen.descent.ended == DescentEnd::goal) {
        tried.length = length_of_way(tried.chosen.descent.points);
        tried.room = std::numeric_limits<double>::infinity();
        for (const Vec2 p : tried.chosen.descent.points) tried.room = std::min(tried.room, rim(p));
        shortest = std::min(shortest, tried.length);
      }
      if (open.empty() || std::isfinite(tried.length)) {
        std::erase_if(open, [&](const Tried& other) { return !(other.length <= longer_allowed * shortest) || (other.length >= tried.length && other.room < tried.room); });
        const bool is_less = std::any_of(open.begin(), open.end(), [&](const Tried& other) { return other.length <= tried.length && other.room >= tried.room; });
        if (open.empty() || (!is_less && tried.length <= longer_allowed * shortest)) open.push_back(std::move(tried));
      }
      if (budget.exhausted()) break;
    }
    return std::max_element(open.begin(), open.end(), [](const Tried& a, const Tried& b) { return a.room < b.room; })->chosen;
  }

  /// A field to be followed by steps of one length, shorter near rims.
  struct Slope {
    std::function<std::optional<Vec2>(Vec2, double)> step;  ///< where it leads from there, by so many m; empty where it leads nowhere
    std::function<double(Vec2)> rim;       ///< m, to the nearest rim
    std::function<std::optional<Vec2>(Vec2)> off;  ///< from a saddle
    Vec2 goal{};
    double radius = 1.0;      ///< m, of the world: what steps are measured by
    std::size_t saddles = 0;  ///< that there may be
  };

  static std::optional<Vec2> along(Vec2 way, Vec2 q, double long_) {
    const double steep = norm(way);
    if (!(steep > 0.0) || !std::isfinite(steep)) return std::nullopt;
    return q + (long_ / steep) * way;
  }

  /// Who runs into a saddle leaves it to a side.
  static Descent follow(const Slope& field, Vec2 start, const FieldPlannerOptions& options, std::int64_t most, Budget& budget) {
    DescentOptions steps = options.descent;
    steps.period = 1.0;
    steps.speed = options.step * field.radius;
    steps.goal_tolerance = 2.0 * steps.speed;
    const double about = 10.0 * steps.speed;  // m, of a saddle: what the steps are in which it is stuck
    steps.trapped_within = about / (steps.speed * steps.period * steps.window);
    steps.patience = std::numeric_limits<int>::max();
    steps.may_creep = true;
    const auto down = [&](Vec2 q) -> std::optional<FieldStep> {
      const double rim = field.rim(q);
      if (!(rim > 0.0)) return std::nullopt;
      const auto next = field.step(q, std::clamp(rim_share * rim, shortest_step * field.radius, steps.speed));
      return next ? FieldStep{*next - q, 0.0} : FieldStep{};
    };
    Descent all;
    all.points = {start};
    all.last = start;
    for (std::size_t saddles = 0;; ++saddles) {
      Descent next = descend(down, all.last, field.goal, steps, most - all.steps, budget);
      all.ended = next.ended;
      all.last = next.last;
      all.steps += next.steps;
      all.points.insert(all.points.end(), next.points.begin() + 1, next.points.end());
      keep_bounded(all.points);
      const bool is_stuck = next.ended == DescentEnd::local_minimum || next.ended == DescentEnd::oscillation;
      if (!is_stuck) return all;
      all.ended = DescentEnd::local_minimum;  // steps of one length do not rest in it
      const auto aside = field.off(all.last);
      if (!aside || saddles > field.saddles) return all;
      // The steps about the saddle are left out, with the way to it alone.
      while (all.points.size() > 1 && distance(all.points.back(), all.last) < about) all.points.pop_back();
      const Vec2 off = std::min(2.0 * about, 0.5 * field.rim(all.last)) * *aside;
      all.last = all.last + off;
      all.points.push_back(all.last);
    }
  }

  static Descent follow(const NavigationFunction& function, Vec2 start, const FieldPlannerOptions& options, std::int64_t most, Budget& budget) {
    return follow(Slope{[&](Vec2 q, double long_) { return along(-function.slope(q), q, long_); }, [&](Vec2 q) { return function.distance_to_rim(q); }, [&](Vec2 q) { return way_off(function.curvature(q)); }, function.goal(),
                        function.world().outside.radius, function.world().obstacles.size()},
                  start, options, most, budget);
  }

  /// λ is the least that does not fold the map, κ those that lead to the goal in the model.
  Descent down_star_navigation(const FieldPlannerOptions& options, const StarWorld& world, Vec2 start, Vec2 goal, std::int64_t most, std::vector<std::string>& text, DrawingOf& drawn,
                               Budget& budget) const {
    double lambda = options.lambda;
    if (lambda == 0.0) {
      const ChosenLambda chosen = choose_lambda(world, goal, 140, [&] { return budget.exhausted(); });
      lambda = chosen.lambda;
      text.push_back(chosen.is_shown ? fmt::format("λ = {:g} is the least power of ten with which the map to a world of discs folds at none of 140 × 140 places.", lambda)
                                     : fmt::format("With no λ up to {:g} the map to a world of discs was free of folds.", lambda));
    }
    const StarMap map{world, goal, lambda};
    std::vector<double> kappas{options.kappa};
    if (options.kappa == 0.0) {
      kappas = kappas_that_lead_to_goal(map.model(), goal, [&] { return budget.exhausted(); });
      if (kappas.empty()) {
        kappas = usual_kappas;
        text.push_back("No κ of those looked at up to 4096 was shown to leave no minimum but the goal in the model; some are tried.");
      }
    }
    const auto rim = [&](Vec2 q) { return distance_to_polygons(space_, q); };
    const auto down = [&](double kappa) {
      const StarNavigation navigation{world, goal, lambda, kappa};
      const auto off = [&](Vec2 q) { return saddle_direction(navigation, q); };
      const auto step = [&](Vec2 q, double long_) { return along(-navigation.slope(q), q, long_); };
      const Slope slope{step, rim, off, goal, world.outside.greatest_rim(), world.obstacles.size()};
      return follow(slope, start, options, most, budget);
    };
    const Chosen chosen = best_of(kappas, down, rim, budget);
    const double best_kappa = chosen.kappa;
    const Descent& best = chosen.descent;
    drawn = [=](std::optional<Vec2> trap) { return star_drawing(world, goal, lambda, best_kappa, trap); };
    text.push_back(fmt::format("Down the navigation function of κ = {:g} on the world of discs that the map of λ = {:g} makes of {}: {}.", best_kappa, lambda,
                               counted(static_cast<std::int64_t>(world.obstacles.size()), "star"), counted(best.steps, "step")));
    return best;
  }

  struct Among {
    Chosen chosen;
    bool is_shown = false;
  };
  /// The first few κ that lead to the goal in the model. No λ is needed: the map of trees cannot fold.
  Among down_among(const FieldPlannerOptions& options, const TreeMap& map, Vec2 start, Vec2 goal, std::int64_t most, Budget& budget) const {
    std::vector<double> kappas{options.kappa};
    Among among;
    if (options.kappa == 0.0) {
      kappas = kappas_that_lead_to_goal(map.model(), map.at(goal).at, [&] { return budget.exhausted(); });
      among.is_shown = !kappas.empty();
      if (kappas.empty()) kappas = usual_kappas;
      kappas.resize(std::min(kappas.size(), tree_kappas));
    }
    const auto rim = [&](Vec2 q) { return map.distance_to_rim(q); };
    const auto down = [&](double kappa) {
      const TreeNavigation navigation{map, goal, kappa};
      const auto step = [&](Vec2 q, double long_) { return std::optional{navigation.next(q, long_)}; };
      const auto off = [&](Vec2 q) { return navigation.way_off(q); };
      return follow(Slope{step, rim, off, goal, map.stars().back().disc().radius, map.model().obstacles.size()}, start, options, most, budget);
    };
    among.chosen = best_of(kappas, down, rim, budget);
    return among;
  }

  /// Leaves are drawn in to next to nothing, so that the model's ways pass close to them: where there is room, all is taken as larger than it need be, as long as that makes
  /// the way no more than a tenth longer.
  Descent down_tree_navigation(const FieldPlannerOptions& options, const TreeMap& needed, Vec2 start, Vec2 goal, std::int64_t most, std::vector<std::string>& text, DrawingOf& drawn, Budget& budget) const {
    Among best = down_among(options, needed, start, goal, most, budget);
    TreeMap map = needed;
    double spare = 0.0;
    if (best.chosen.descent.ended == DescentEnd::goal) {
      const double shortest = length_of_way(best.chosen.descent.points), room = std::min({most_spare, distance_to_polygons(space_, start), distance_to_polygons(space_, goal)});
      for (const double share : spare_shares) {
        if (budget.exhausted()) break;
        const auto wider = trees_with(space_, start, goal, share * room, [&] { return budget.exhausted(); });
        if (!wider) continue;
        Among other = down_among(options, *wider, start, goal, most, budget);
        if (other.chosen.descent.ended != DescentEnd::goal || length_of_way(other.chosen.descent.points) > longer_allowed * shortest) continue;
        best = std::move(other);
        map = *wider;
        spare = share * room;
        break;
      }
    }
    drawn = [map = std::make_shared<const TreeMap>(map), goal, kappa = best.chosen.kappa](std::optional<Vec2> trap) { return tree_drawing(map, goal, kappa, trap); };
    const auto leaves = static_cast<std::int64_t>(map.leaves().size()), discs = static_cast<std::int64_t>(map.model().obstacles.size());
    text.push_back(fmt::format("Obstacles or the boundary are no stars, or too near to each other to pass between them: as trees of stars they are seen as a world of {} in a disc of {:.3f} m{}.",
                               counted(discs, "disc"), map.model().outside.radius, leaves == 0 ? std::string{} : fmt::format(", when {} drawn in", leaves == 1 ? "1 leaf is" : fmt::format("{} leaves are", leaves))));
    if (spare > 0.0) text.push_back(fmt::format("All is grown by {:.3f} m more than the vehicle needs, which makes the way no more than a tenth longer.", spare));
    if (options.kappa == 0.0 && !best.is_shown) text.push_back("No κ was shown to leave no minimum but the goal in the model; some are tried.");
    text.push_back(fmt::format("Down the navigation function of κ = {:g} on that world of discs, seen back: {}.", best.chosen.kappa, counted(best.chosen.descent.steps, "step")));
    return best.chosen.descent;
  }

  /// By differences: which way the slope falls off most.
  static std::optional<Vec2> saddle_direction(const StarNavigation& navigation, Vec2 q) {
    const double h = 1e-6 * navigation.function().world().outside.radius;
    const Vec2 dx = (0.5 / h) * (navigation.slope(q + Vec2{h, 0}) - navigation.slope(q - Vec2{h, 0})), dy = (0.5 / h) * (navigation.slope(q + Vec2{0, h}) - navigation.slope(q - Vec2{0, h}));
    return way_off({dx.x, 0.5 * (dx.y + dy.x), dy.y});
  }

  PlanningFailure stopped(const Budget& budget, std::int64_t steps) const {
    if (budget.canceled()) return failure(Status::canceled, fmt::format("canceled after {}", counted(steps, "step")));
    return failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(steps, "step")));
  }

  PlanningFailure trapped(const Descent& descent, Vec2 goal, std::vector<std::string> text, std::string_view name, const Budget& budget) const {
    if (descent.ended == DescentEnd::canceled || descent.ended == DescentEnd::timed_out) return stopped(budget, descent.steps);
    const std::string where = fmt::format("{}, {:.3f} m from the goal", place(descent.last), distance(descent.last, goal));
    std::string reason;
    switch (descent.ended) {
      case DescentEnd::local_minimum: reason = fmt::format("{} is trapped in a local minimum at {}{}", name, where, name == "potential_field" ? ": attraction and repulsion cancel there" : ""); break;
      case DescentEnd::oscillation: reason = fmt::format("{} goes to and fro about {}, and gets no nearer", name, where); break;
      case DescentEnd::blocked: reason = fmt::format("a step of {} leads to {}, where the disc cannot stand", name, where); break;
      default: reason = fmt::format("{} did not reach the goal in {}: it came to {}", name, counted(descent.steps, "step"), where); break;
    }
    PlanningFailure failed = failure(Status::no_path, reason, make_pose(descent.last, 0.0));
    Alternative tried;
    tried.name = std::string{name};
    tried.outcome = reason + ".";
    tried.poses = picture_of(descent.points);
    failed.alternatives.push_back(std::move(tried));
    failed.explanation = std::move(text);
    failed.explanation.push_back(reason + ".");
    return failed;
  }

  PlaneSpace space_;
};

FieldPlanner FieldPlanner::prepared(const Problem& problem) const {
  FieldPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem);
  return planner;
}

PlanningResult FieldPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, name_, budget);
  return Ready{problem}.plan(options_, name_, budget);
}

}  // namespace waywright
