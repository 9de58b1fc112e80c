#include "waywright/planner/field/global_local.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/planner/field/field_planner.hpp"
#include "waywright/planner/field/harmonic_planner.hpp"
#include "waywright/planner/field/local_words.hpp"
#include "waywright/planner/field/timed_drive.hpp"
#include "waywright/planner/field/wavefront_planner.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/visibility_planner.hpp"
#include "waywright/scenario/parameter_values.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;

constexpr double beside_movers = 0.03;     // m: what bounds in time take beside what moves
constexpr double way_step = 0.1;           // m, of the points that a way is followed along
constexpr double room_for_sight = 0.1;     // m, that a shortest way keeps besides, where it can: around its bends nothing ahead is in sight
constexpr double looks_for_zones = 0.25;   // m ahead, at least

AnyPlanner planner_of(const GlobalLocalOptions& o) {
  switch (o.global) {
    case GlobalWay::wavefront: return WavefrontPlanner{WavefrontOptions{.resolution = o.resolution, .shortens = true}};
    case GlobalWay::navigation: return FieldPlanner{"navigation_function", FieldPlannerOptions{.method = FieldMethod::navigation}};
    case GlobalWay::star_navigation: return FieldPlanner{"star_navigation", FieldPlannerOptions{.method = FieldMethod::star}};
    case GlobalWay::visibility: return VisibilityPlanner{};
    case GlobalWay::harmonic: break;
  }
  return HarmonicPlanner{HarmonicOptions{.resolution = o.resolution}};
}

PlanningResult global_way(const GlobalLocalOptions& o, const AnyPlanner& planner, const Problem& problem, Budget& budget) {
  if (o.global == GlobalWay::visibility) {
    Scenario scenario = problem.scenario();
    scenario.moving.clear();
    scenario.clearance += room_for_sight;
    if (const auto wider = Problem::prepare(std::move(scenario))) {
      if (PlanningResult found = planner.plan(*wider, budget)) return found;
    }
  }
  return planner.plan(problem, budget);
}

/// Points of a path without the runs at its ends.
std::vector<Vec2> points_of(const Problem& problem, const Path& path, double run_before, double run_after) {
  const double whole = length(path);
  std::vector<Vec2> points;
  for (const Sample& s : sample(path, problem.footprint().radius(), 1e-3, way_step)) {
    if (s.s < run_before - 1e-9 || s.s > whole - run_after + 1e-9) continue;
    if (points.empty() || distance(points.back(), {s.x, s.y}) > 1e-9) points.push_back({s.x, s.y});
  }
  return points;
}

std::vector<Pose> poses_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  for (const Vec2 p : points) poses.push_back(make_pose(p, 0.0));
  return poses;
}

}  // namespace

class GlobalLocalPlanner::Ready {
 public:
  Ready(const Problem& problem, const GlobalLocalOptions& options) : space_{problem}, global_{planner_of(options).prepared(problem)} {}
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const GlobalLocalOptions& options, Budget& budget) const {
    const Problem& problem = space_.problem();
    if (auto reason = nothing_to_plan(problem, "global_local")) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    PlanningResult global = global_way(options, global_, problem, budget);
    if (!global) return global;
    const std::string name{global_.name()};
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    std::optional<PlaneEnd> goal = is_region ? PlaneEnd{end_pose(global->path).position(), 0} : plane_goal(space_);
    const bool is_in_shelf = problem.is_driven_back() || problem.pocket().has_value();
    if (!start || !goal || is_in_shelf) {
      if (is_in_shelf) global->explanation.push_back("Missions into or out of a shelf's pockets are not driven down a local field: the way is the global one.");
      return global;
    }
    const double run_before = start->run != 0 ? distance(problem.start().position(), start->at) : 0.0, run_after = goal->run != 0 ? distance(goal->at, problem.goal().position()) : 0.0;
    std::vector<Vec2> way = points_of(problem, global->path, run_before, run_after);
    if (way.size() < 2) return global;  // nothing but a turn, or a run
    way.front() = start->at;
    way.back() = goal->at;

    const Movers movers{space_, beside_movers};
    const TimedDrive timed{space_, *start, *goal};
    const FreeMotion motion{problem, problem.free_goal() != nullptr ? 0.0 : shorter_turn(problem.start().heading, problem.goal().heading), distance(start->at, goal->at)};
    const auto top = [&](const FreeState& at) {
      double least = motion.top_speed();
      if (!problem.zones().limits_speed()) return least;
      // As far as it needs to slow down.
      const double reach = std::max(looks_for_zones, motion.braking(at.speed));
      for (const double share : {0.0, 0.5, 1.0}) {
        if (const auto* zone = slowest_zone_at(problem, make_pose(at.at + share * reach * unit(at.course), problem.start().heading))) least = std::min(least, zone->speed);
      }
      return least;
    };
    const auto anew = [&](const FreeState& at, const std::vector<std::size_t>& standing) { return planned_anew(options, at, standing, movers, goal->at, budget); };
    const LocalDriver driver{space_, movers, motion, options.field, options.drive, anew, top};
    Timed times;
    std::optional<Pace> pace;
    Path path;
    const auto proves = [&](const LocalDrive& drive) -> std::optional<LocalDriver::Meeting> {
      path = timed.path(drive);
      if (movers.size() == 0) return std::nullopt;
      pace = timed.pace(drive, movers);
      times = timed.timed(path, *pace);
      return timed.meets(times.samples);
    };
    const LocalDrive drive = driver.run(timed.begin(), way, proves, budget);
    if (drive.ended == LocalEnd::canceled || drive.ended == LocalEnd::timed_out) {
      return tl::unexpected{grid::nothing_found(drive.ended == LocalEnd::canceled ? SearchEnd::canceled : SearchEnd::timed_out, false, budget.expansions(), budget, 0.0, "")};
    }
    Planned planned;
    std::vector<std::string>& text = planned.explanation;
    text.push_back(fmt::format("Global way, as if nothing moved: {}, {:.3f} m. {}", name, drive.ways.front().length(), global->explanation.empty() ? std::string{} : global->explanation.front()));
    Alternative followed;
    followed.name = "global way, " + name;
    followed.outcome = fmt::format("{:.3f} m; it was followed under the local field.", drive.ways.front().length());
    followed.cost = drive.ways.front().length();
    followed.is_length = true;
    followed.poses = poses_of(drive.ways.front().points());
    planned.alternatives.push_back(std::move(followed));
    if (drive.ended != LocalEnd::goal) {
      const std::string why = local_end_sentence(drive, movers);
      text.push_back("The local field came to no end: " + why + ". So the global way itself is driven" + (movers.size() > 0 ? ", with stops for what moves." : "."));
      Alternative tried;
      tried.name = "down the local field";
      tried.outcome = why + ".";
      for (const LocalDriven& d : drive.driven) tried.poses.push_back(make_pose(d.before.at, d.before.course));
      planned.alternatives.push_back(std::move(tried));
      planned.path = std::move(global->path);
      if (movers.size() > 0) planned.shortcoming = "the local field came to no end either: " + why;
      return planned;
    }
    planned.path = std::move(path);
    if (movers.size() > 0) planned.pace = std::move(pace);
    for (std::string& sentence : local_words(space_, drive, movers, motion, times.samples)) text.push_back(std::move(sentence));
    if (start->run != 0 || goal->run != 0) text.push_back(run_sentence(space_, *start, *goal));
    text.push_back(driving_sentence(problem, planned.path));
    if (std::string bound = bound_sentence(least_length(space_, budget), length(planned.path)); !bound.empty()) text.push_back(std::move(bound));
    return planned;
  }

 private:
  /// From where the drive is to its end, past what stands then.
  std::optional<std::vector<Vec2>> planned_anew(const GlobalLocalOptions& options, const FreeState& at, const std::vector<std::size_t>& standing, const Movers& movers, Vec2 goal, Budget& budget) const {
    if (budget.evaluations_left() == std::int64_t{0}) return std::nullopt;
    const Problem& problem = space_.problem();
    Scenario scenario = problem.scenario();
    scenario.moving.clear();
    scenario.start = make_pose(at.at, problem.start().heading);
    scenario.start_motion = {};
    if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) {
      scenario.map.boundaries.push_back(station->area);
      scenario.map.obstacles.push_back(station->shelf.outline());
    }
    scenario.mission = FreeGoal{{goal}};
    for (const std::size_t i : standing) scenario.map.obstacles.push_back(movers.outline(i, at.t, 0.0));
    const auto from_here = Problem::prepare(std::move(scenario));
    if (!from_here) return std::nullopt;
    const PlanningResult found = global_way(options, planner_of(options), *from_here, budget);
    if (!found) return std::nullopt;
    std::vector<Vec2> points = points_of(*from_here, found->path, 0.0, 0.0);
    if (points.empty()) return std::nullopt;
    points.front() = at.at;
    points.back() = goal;
    return points;
  }

  PlaneSpace space_;
  AnyPlanner global_;
};

GlobalLocalPlanner GlobalLocalPlanner::prepared(const Problem& problem) const {
  GlobalLocalPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult GlobalLocalPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, budget);
  return Ready{problem, options_}.plan(options_, budget);
}

PlannerDescription global_local_description() {
  const GlobalLocalOptions d;
  PlannerDescription description{
      "global_local",
      "a global way, planned as if nothing moved, followed in time under a local field: drawn along the way, pushed off by what stands and by what moves",
      {{.name = "global", .default_value = std::string{"harmonic"}, .summary = "planner of the global way", .choices = {"harmonic", "wavefront", "navigation_function", "star_navigation", "visibility_graph"}},
       {.name = "resolution", .default_value = d.resolution, .summary = "of the cells of harmonic and wavefront; 0: as these choose it", .unit = "m", .low = 0, .high = 100},
       {.name = "look_ahead", .default_value = d.field.look_ahead, .summary = "along the way, to the place that attracts", .unit = "m", .low = 0.05, .high = 50},
       {.name = "repulsion", .default_value = d.field.repulsion, .summary = "k_r of what stands, off the way", .low = 0, .high = 1e6},
       {.name = "reach", .default_value = d.field.reach, .summary = "rho_0 of what stands, at most as far as the way keeps from it", .unit = "m", .low = 1e-3, .high = 1e3},
       {.name = "moving_repulsion", .default_value = d.field.moving_repulsion, .summary = "k_r of what moves", .low = 0, .high = 1e6},
       {.name = "moving_reach", .default_value = d.field.moving_reach, .summary = "rho_0 of what moves", .unit = "m", .low = 1e-3, .high = 100},
       {.name = "horizon", .default_value = d.field.horizon, .summary = "that a velocity is looked at ahead", .unit = "s", .low = 0.5, .high = 30},
       {.name = "period", .default_value = d.field.period, .summary = "of each motion", .unit = "s", .low = 0.02, .high = 0.5},
       {.name = "tries", .default_value = static_cast<double>(d.drive.tries), .summary = "begun again from before a meeting, at most", .low = 0, .high = 10'000, .whole = true},
       {.name = "steps", .default_value = static_cast<double>(d.drive.steps), .summary = "down the local field in all, at most", .low = 1, .high = 1e8, .whole = true}},
      [](const Parameters& p, std::uint64_t) -> AnyPlanner {
        GlobalLocalOptions o;
        const std::string& global = word_of(p, "global");
        o.global = global == "wavefront" ? GlobalWay::wavefront : global == "navigation_function" ? GlobalWay::navigation : global == "star_navigation" ? GlobalWay::star_navigation
                   : global == "visibility_graph" ? GlobalWay::visibility : GlobalWay::harmonic;
        o.resolution = number_of(p, "resolution");
        o.field.look_ahead = number_of(p, "look_ahead");
        o.field.repulsion = number_of(p, "repulsion");
        o.field.reach = number_of(p, "reach");
        o.field.moving_repulsion = number_of(p, "moving_repulsion");
        o.field.moving_reach = number_of(p, "moving_reach");
        o.field.horizon = number_of(p, "horizon");
        o.field.period = number_of(p, "period");
        o.drive.tries = static_cast<int>(number_of(p, "tries"));
        o.drive.steps = whole_number_of(p, "steps");
        return GlobalLocalPlanner{o};
      }};
  description.takes_free_goals = true;
  description.plans_in_time = true;
  description.turns_on_the_spot = true;
  description.counts_expansions = true;
  return description;
}

}  // namespace waywright
