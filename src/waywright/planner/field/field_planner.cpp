#include "waywright/planner/field/field_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "waywright/planner/field/field_drawings.hpp"
#include "waywright/planner/field/field_words.hpp"
#include "waywright/planner/field/navigation_ways.hpp"
#include "waywright/planner/field/sphere_world_of.hpp"
#include "waywright/planner/field/way_ends.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/plane/rounded_way.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;

constexpr double thinning = 0.002;        // m
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
    double keeps = 0.0;  // m
    DrawingOf field_drawn;
    const std::int64_t most = steps_left(options.steps, budget);
    const auto take = [&](NavigationWay found) {
      descent = std::move(found.way.descent);
      keeps = found.keeps;
      text.insert(text.end(), std::make_move_iterator(found.text.begin()), std::make_move_iterator(found.text.end()));
      field_drawn = std::move(found.drawn);
    };
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
        const bool is_over = next.ended == DescentEnd::canceled || next.ended == DescentEnd::timed_out || (next.ended == DescentEnd::steps && is_used_up(budget));
        const bool is_last = next.ended == DescentEnd::goal || is_over;
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
      NavigationWay found;
      if (const auto* trees = std::get_if<TreeMap>(&*world)) {
        found = way_among_trees(navigation_options(options), space_, *trees, start->at, goal->at, budget);
        text.emplace_back("Obstacles or the boundary are no stars, or too near to each other to pass between them.");
      } else {
        const StarWorld& stars = std::get<StarWorld>(*world);
        const StarMap map{stars, start->at, 1.0};
        const auto reached = std::find_if(goals.begin(), goals.end(), [&](Vec2 at) { return map.is_free(at); });
        if (reached != goals.end()) goal->at = *reached;
        found = way_among_stars(navigation_options(options), space_, stars, start->at, goal->at, budget);
      }
      take(std::move(found));
    } else {
      const auto covering = covering_world(space_, start->at, goals);
      if (!covering) {
        budget.count_evaluations();
        return tl::unexpected{failure(Status::no_path, "a navigation function on a world of discs needs each obstacle in a disc apart from the others: " + covering.error())};
      }
      goal->at = covering->goal;
      take(way_among_discs(navigation_options(options), covering->world, start->at, goal->at, budget));
    }
    if (descent.ended != DescentEnd::goal) {
      PlanningFailure failed = not_at_goal(descent, goal->at, space_, std::move(text), name, budget);
      const bool is_trap = descent.ended == DescentEnd::local_minimum || descent.ended == DescentEnd::oscillation;
      if (field_drawn) failed.field = field_drawn(is_trap ? std::optional{descent.minimum.value_or(descent.last)} : std::nullopt);
      return tl::unexpected{std::move(failed)};
    }
    descent.points.push_back(goal->at);
    PlanningResult plan = finished_plan(space_, rounded_path(space_, *start, thinned_way(space_, descent.points, thinning), *goal, keeps), *start, *goal, std::move(text), budget);
    if (plan && field_drawn) plan->field = field_drawn(std::nullopt);
    return plan;
  }

 private:
  /// The field that was gone down, with the trap that it ended in.
  using DrawingOf = std::function<SharedDrawing(std::optional<Vec2> trap)>;

  static NavigationOptions navigation_options(const FieldPlannerOptions& options) { return {options.kappa, options.lambda, {options.descent, options.step, options.steps}}; }

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
