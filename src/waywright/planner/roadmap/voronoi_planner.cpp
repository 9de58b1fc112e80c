#include "waywright/planner/roadmap/voronoi_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/path_pencil.hpp"
#include "waywright/planner/roadmap/voronoi_roadmap.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

using grid::counted;

// Of what is kept beyond the requirement (twice the proof's tolerance) the proof itself needs half; these two together stay under the other half.
constexpr double chord_sagitta = 2e-4;  // m
constexpr double tiny = 2e-4;           // m, a step so short is given to the one before

/// Steps of a few micrometres, where several edges meet in nearly one place, are no steps to drive; straight ones that follow each other nearly straight are one.
std::vector<VoronoiStep> tidied(const std::vector<VoronoiStep>& way, const PlaneSpace& space) {
  std::vector<VoronoiStep> kept{way.front()};
  Vec2 given = way.front().at;  // where the last step that was kept ended
  for (std::size_t i = 1; i < way.size(); ++i) {
    const VoronoiStep& step = way[i];
    const bool is_last = i + 1 == way.size();
    if (kept.size() > 1 && kept.back().is_on_diagram && step.is_on_diagram && distance(given, step.at) < tiny && !is_last) {
      kept.back().at = step.at;
      continue;
    }
    kept.push_back(step);
    given = step.at;
  }
  std::vector<VoronoiStep> joined{kept.front()};
  for (std::size_t i = 1; i < kept.size();) {
    VoronoiStep step = kept[i];
    std::size_t k = i + 1;
    const Vec2 from = joined.back().at;
    for (; k < kept.size() && !step.control && step.is_on_diagram && !kept[k].control && kept[k].is_on_diagram; ++k) {
      bool is_straight = true;
      for (std::size_t j = i; j < k; ++j) is_straight = is_straight && point_segment_distance(kept[j].at, from, kept[k].at) <= VoronoiRoadmap::sagitta;
      if (!is_straight || !space.is_free(from, kept[k].at)) break;
    }
    for (std::size_t j = i; j < k; ++j) step.clearance = std::min(step.clearance, kept[j].clearance);
    step.at = kept[k - 1].at;
    joined.push_back(step);
    i = k;
  }
  return joined;
}

bool drives_curve(const Vehicle& vehicle, Vec2 from, Vec2 control, Vec2 to) {
  return control != from && control != to && !vehicle.steering_takes_time() && greatest_curvature(from, control, to) <= vehicle.max_curvature();
}

std::vector<Vec2> chords_of(const std::vector<VoronoiStep>& way) {
  std::vector<Vec2> points{way.front().at};
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (way[i].control) add_chords(way[i - 1].at, *way[i].control, way[i].at, chord_sagitta, points);
    else points.push_back(way[i].at);
  }
  return points;
}

Path path_of(const std::vector<VoronoiStep>& way, const Problem& problem, const PlaneEnd& start, const PlaneEnd& goal) {
  PathPencil pencil{problem.start()};
  if (start.run != 0) pencil.line(start.at, start.run);
  std::vector<Vec2> chords;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vec2 from = way[i - 1].at, to = way[i].at;
    if (way[i].control && drives_curve(problem.vehicle(), from, *way[i].control, to)) {
      pencil.curve(*way[i].control, to);
      continue;
    }
    chords.clear();
    if (way[i].control) add_chords(from, *way[i].control, to, chord_sagitta, chords);
    else chords.push_back(to);
    for (const Vec2 p : chords) pencil.line(p, 1);
  }
  if (goal.run != 0) pencil.line(problem.goal().position(), goal.run);
  if (problem.free_goal() == nullptr) pencil.face(problem.goal().heading);
  return pencil.take();
}

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 along = i + 1 < points.size() ? points[i + 1] - points[i] : i > 0 ? points[i] - points[i - 1] : Vec2{1.0, 0.0};
    poses.push_back(make_pose(points[i], angle_of(along)));
  }
  return poses;
}

}  // namespace

class VoronoiPlanner::Ready {
 public:
  explicit Ready(const Problem& problem) : space_{problem} {
    if (problem.vehicle().can_turn_on_the_spot()) map_.emplace(space_);
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const VoronoiPlannerOptions& options, Budget& budget) const {
    using grid::failure;
    const Problem& problem = space_.problem();
    if (auto reason = nothing_to_plan(problem, "voronoi")) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
    budget.count_evaluations();
    if (!map_->refusal().empty()) return tl::unexpected{failure(Status::no_path, map_->refusal())};
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    const auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    if (!start || !goal) return tl::unexpected{no_room(space_, !start)};
    const VoronoiAnswer answer = map_->shortest(start->at, target_of(problem, goal->at), options.clearance_weight, budget, budget.limits().expansions);
    budget.count_expansions(answer.expansions);
    switch (answer.ended) {
      case VoronoiEnd::stopped: return tl::unexpected{stopped(budget, answer.expansions)};
      case VoronoiEnd::expansions:
        return tl::unexpected{failure(Status::no_path, fmt::format("all {} of its budget were used up before the goal was reached", counted(answer.expansions, "expansion")))};
      case VoronoiEnd::no_start:
      case VoronoiEnd::no_goal:
      case VoronoiEnd::unreachable: return tl::unexpected{nothing_found(answer, budget)};
      case VoronoiEnd::found: break;
    }
    return explained(options, answer, *start, *goal, budget);
  }

 private:
  PlanningFailure stopped(const Budget& budget, std::int64_t expansions) const {
    if (budget.canceled()) return grid::failure(Status::canceled, fmt::format("canceled after {}", counted(expansions, "expansion")));
    return grid::failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(expansions, "expansion")));
  }

  std::string what() const { return space_.problem().footprint().is_disc() ? "a disc" : "the disc around the footprint,"; }

  SearchPicture picture() const {
    SearchPicture picture;
    picture.name = "Voronoi diagram where the disc fits";
    for (const auto& [from, to] : map_->line_list()) picture.lines.push_back({from, to});
    return picture;
  }

  PlanningFailure nothing_found(const VoronoiAnswer& answer, Budget& budget) const {
    const std::string cause = answer.ended == VoronoiEnd::unreachable ? fmt::format("all that is joined to the start was searched, {}", counted(answer.expansions, "expansion"))
                                                                      : fmt::format("no line of it that {} fits on is seen from the {}", space_.problem().footprint().is_disc() ? "it" : "that disc",
                                                                                    answer.ended == VoronoiEnd::no_start ? "start" : "goal");
    std::string reason = fmt::format("no way leads from start to goal along the Voronoi diagram for {} of {:.3f} m that keeps {}: {}", what(), space_.disc(),
                                     kept_words(space_), cause);
    std::string more = unreachable_sentence(least_length(space_, budget), space_.problem());
    if (more.empty()) more = footprint_sentence(space_.problem());
    if (!more.empty()) reason += "; " + more;
    if (budget.exhausted()) return stopped(budget, answer.expansions);
    PlanningFailure failed = grid::failure(Status::no_path, std::move(reason));
    failed.search = picture();
    return failed;
  }

  std::string kept_sentence(const VoronoiAnswer& answer) const {
    double least = std::numeric_limits<double>::infinity(), before = 0.0, after = 0.0;
    bool is_on = false;
    for (std::size_t i = 1; i < answer.way.size(); ++i) {
      const double metres = distance(answer.way[i - 1].at, answer.way[i].at);
      if (answer.way[i].is_on_diagram) {
        is_on = true;
        least = std::min({least, answer.way[i].clearance, answer.way[i - 1].clearance});
      } else {
        (is_on ? after : before) += metres;
      }
    }
    if (!is_on) return "The goal is seen from the start, and nearer than the diagram: it is driven to directly.";
    return fmt::format("On the diagram nothing is nearer to the {} than {:.3f} m; {:.2f} m lead to it from the start, {:.2f} m from it to the goal.",
                       space_.problem().footprint().is_disc() ? "disc" : "disc around the footprint", least - space_.disc(), before, after);
  }

  PlanningResult explained(const VoronoiPlannerOptions& options, const VoronoiAnswer& answer, const PlaneEnd& start, const PlaneEnd& goal, Budget& budget) const {
    const Problem& problem = space_.problem();
    Planned planned;
    std::vector<std::string>& text = planned.explanation;
    const std::vector<VoronoiStep> way = tidied(answer.way, space_);
    const std::vector<Vec2> along = chords_of(way);
    std::vector<Vec2> points = along;
    planned.search = picture();
    const std::string aim = options.clearance_weight > 0.0 ? fmt::format("The way of least cost (a metre with a clearance of c metres costs 1 + {:g}/c)", options.clearance_weight)
                                                           : std::string{"The shortest way"};
    text.push_back(fmt::format("{} along the Voronoi diagram of the map{}, as far from what is on either side as can be, for {} of {:.3f} m: {:.3f} m; {} in {} of the diagram.", aim,
                               map_->has_frame() ? " and a rectangle around all of it" : "", what(), space_.disc(), length_of_way(along), counted(answer.expansions, "expansion"),
                               counted(static_cast<std::int64_t>(map_->lines()), "line")));
    text.push_back(kept_sentence(answer));
    const auto tried = [&](std::string name, const std::vector<Vec2>& driven, bool is_chosen) {
      Alternative alternative;
      alternative.name = std::move(name);
      alternative.chosen = is_chosen;
      alternative.cost = length_of_way(driven);
      alternative.is_length = true;
      alternative.outcome = fmt::format("{:.3f} m.", *alternative.cost);
      alternative.poses = picture_of(driven);
      planned.alternatives.push_back(std::move(alternative));
    };
    if (options.shortens) {
      points = taut_way(std::move(points), space_);
      text.push_back(fmt::format("Corners past which their neighbours see each other were left out: {:.3f} m, nearer to what is around.", length_of_way(points)));
    }
    if (options.shortens) tried("along the diagram", along, false);
    tried(options.shortens ? "as driven" : "along the diagram", points, true);
    planned.path = options.shortens ? plane_path(space_, start, points, goal) : path_of(way, problem, start, goal);
    if (planned.path.pieces.empty()) return tl::unexpected{grid::failure(Status::no_path, "start and goal are the same place, there is nothing to drive")};
    if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space_, start, goal));
    text.push_back(driving_sentence(space_.problem(), planned.path));
    if (std::string bound = bound_sentence(least_length(space_, budget), length(planned.path)); !bound.empty()) text.push_back(std::move(bound));
    return planned;
  }

  PlaneSpace space_;
  std::optional<VoronoiRoadmap> map_;
};

VoronoiPlanner VoronoiPlanner::prepared(const Problem& problem) const {
  VoronoiPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem);
  return planner;
}

PlanningResult VoronoiPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, budget);
  return Ready{problem}.plan(options_, budget);
}

PlannerDescription voronoi_description() {
  PlannerDescription d{"voronoi",
                       "ways along the Voronoi diagram of the map, as far from everything as can be; of a disc, or the disc around the footprint",
                       {
                           {.name = "clearance_weight", .default_value = 0.0, .summary = "a metre with c metres of clearance costs 1 + weight/c; 0: the shortest way along the diagram", .unit = "m",
                            .low = 0, .high = 1e3},
                           {.name = "shorten", .default_value = false, .summary = "leave out corners past which their neighbours see each other, which gives the clearance away"},
                       },
                       [](const Parameters& p, std::uint64_t) -> AnyPlanner { return VoronoiPlanner{{number_of(p, "clearance_weight"), flag_of(p, "shorten")}}; }};
  d.counts_expansions = true;
  d.takes_free_goals = true;
  d.turns_on_the_spot = true;
  return d;
}

}  // namespace waywright
