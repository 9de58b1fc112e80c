#include "waywright/planner/roadmap/prm_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/state_roadmap.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

using grid::counted;

constexpr std::int64_t most_drawn_beforehand = 20'000;  // samples: some hundredths of a second

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 along = i + 1 < points.size() ? points[i + 1] - points[i] : i > 0 ? points[i] - points[i - 1] : Vec2{1.0, 0.0};
    poses.push_back(make_pose(points[i], angle_of(along)));
  }
  return poses;
}

std::uint32_t step_of(std::int64_t tested) { return static_cast<std::uint32_t>(std::min<std::int64_t>(tested, SearchPicture::never - 1)); }

constexpr const char* picture_name = "lines of the roadmap that the search took";

SearchPicture picture_of(const RoadmapAnswer& answer) {
  SearchPicture picture;
  picture.name = picture_name;
  picture.steps = step_of(answer.lines);
  for (const RoadmapAnswer::Taken& taken : answer.taken) picture.lines.push_back({taken.from, taken.to, step_of(taken.tested)});
  if (answer.ended == RoadmapEnd::found) picture.ways = {{answer.way, picture.steps}};
  return picture;
}

SearchPicture picture_of(const LazyAnswer<Pose>& answer, const StateQuery& query) {
  SearchPicture picture;
  picture.name = picture_name;
  picture.steps = step_of(answer.lines);
  for (const LazyAnswer<Pose>::Taken& taken : answer.taken) {
    SearchPicture::Line& line = picture.lines.emplace_back(SearchPicture::Line{taken.from.position(), taken.to.position(), step_of(taken.tested)});
    line.bend = query.bend_between(taken.from, taken.to);
  }
  if (answer.ended == RoadmapEnd::found) picture.ways = {{query.places_along(answer.way), picture.steps}};
  return picture;
}

RoadmapOptions limited(RoadmapOptions options, const BudgetLimits& limits) {
  options.samples = std::min(limits.samples.value_or(options.samples), ProbabilisticRoadmap::most_samples);
  return options;
}

}  // namespace

class PrmPlanner::Ready {
 public:
  Ready(const Problem& problem, const PrmPlannerOptions& options, std::uint64_t seed) : space_{problem}, options_{options}, seed_{seed} {
    kind_ = chosen_space(problem, options.space, problem.free_goal() == nullptr && !problem.footprint().is_disc() && !options.space.space && disc_serves(space_));
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  void draw_beforehand() {
    const Problem& problem = space_.problem();
    const RoadmapOptions options = limited(options_.roadmap, problem.scenario().budget);
    if (kind_ != SteeringKind::plane || !problem.vehicle().can_turn_on_the_spot() || options.samples > most_drawn_beforehand) return;
    Budget unlimited;
    drawn_.emplace(space_, options, seed_, unlimited);
  }

  PlanningResult plan(Budget& budget) const {
    using grid::failure;
    const Problem& problem = space_.problem();
    const RoadmapOptions options = limited(options_.roadmap, budget.limits());
    if (kind_ != SteeringKind::plane) return among_states(options, budget);
    if (options_.space.space) {  // it was asked for
      if (std::string reason = space_refusal(problem, kind_, "prm", "PRM"); !reason.empty()) return tl::unexpected{failure(Status::no_path, std::move(reason))};
    }
    if (auto reason = nothing_to_plan(problem, "prm")) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    const auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    if (!start || !goal) {
      budget.count_evaluations();  // the run that was looked for
      return tl::unexpected{no_room(space_, !start)};
    }
    std::optional<ProbabilisticRoadmap> grown;
    if (!drawn_ || drawn_->options().samples != options.samples) grown.emplace(space_, options, seed_, budget);
    const ProbabilisticRoadmap& roadmap = grown ? *grown : *drawn_;
    if (!roadmap.is_whole()) return tl::unexpected{stopped(budget, static_cast<std::int64_t>(roadmap.size()))};
    const PlaneTarget target = target_of(problem, goal->at);
    const RoadmapAnswer answer = roadmap.shortest(start->at, target, budget, budget.evaluations_left().value_or(std::numeric_limits<std::int64_t>::max()));
    budget.count_evaluations(std::max<std::int64_t>(1, answer.lines));
    if (answer.ended == RoadmapEnd::stopped) return tl::unexpected{stopped(budget, static_cast<std::int64_t>(roadmap.size()))};
    if (answer.ended != RoadmapEnd::found) {
      bool is_hopeless = false;
      PlanningFailure failed = nothing_found(roadmap, answer, target, budget, is_hopeless);
      if (is_hopeless || failed.failure.status != Status::no_path) return tl::unexpected{std::move(failed)};
      RoadmapOptions rest = options;
      if (budget.limits().samples) rest.samples -= static_cast<std::int64_t>(roadmap.size());
      if (may_turn_instead(problem, options_.space) && rest.samples > 0 && budget.evaluations_left() != 0) return after_the_disc(failed, among_states(rest, budget));
      if (const std::string itself = footprint_sentence(problem); !itself.empty()) failed.failure.reason += "; " + itself;
      failed.explanation = {failed.failure.reason + "."};
      return tl::unexpected{std::move(failed)};
    }
    return explained(roadmap, answer, *start, *goal, budget);
  }

 private:
  PlanningResult among_states(const RoadmapOptions& options, Budget& budget) const {
    const auto search = [&](const StateQuery& query) {
      const StateRoadmap roadmap{query, options, seed_, budget};
      LazyAnswer<Pose> found;
      if (roadmap.is_whole()) found = roadmap.shortest(query, budget);
      const std::string joined = roadmap.neighbours() > 0 ? fmt::format("each with motions to {} others", roadmap.neighbours()) : fmt::format("with motions of up to {:.2f} m", options.radius);
      const std::string has = fmt::format("{}, {}", counted(static_cast<std::int64_t>(roadmap.size()), "state"), joined);
      StateAnswer answer;
      answer.picture = picture_of(found, query);
      if (roadmap.is_whole() && found.ended == RoadmapEnd::found) {
        answer.states = found.way;
        answer.is_least = found.way.size() == 2;
        answer.found = fmt::format("Its roadmap has {}; the least costly way in it, of cost {:.3f} m, was found by A* with {} tested", has, found.length, counted(found.lines, "motion"));
        return answer;
      }
      const std::string ended = !roadmap.is_whole() || found.ended == RoadmapEnd::stopped ? fmt::format("the {:g} s of its budget were over", budget.limits().seconds.value_or(0.0))
                                : found.ended == RoadmapEnd::lines                        ? motions_spent(query)
                                : found.ended == RoadmapEnd::crowded
                                    ? fmt::format("more than {} million motions waited to be tested: fewer samples make a smaller roadmap", ProbabilisticRoadmap::most_waiting / 1'000'000)
                                    : fmt::format("all that is joined to the start was searched, with {} tested; more samples find what fewer miss", counted(found.lines, "motion"));
      answer.missed = fmt::format("a roadmap of {}, holds no way from start to goal: {}; {} of its states were reached", has, ended, std::max<std::int64_t>(0, found.reached - 1));
      answer.nearest = found.way;
      return answer;
    };
    return StatePlanning{space_, kind_, options_.space, "prm", "PRM"}.plan(search, options_.shortens, seed_, budget);
  }

  PlanningFailure stopped(const Budget& budget, std::int64_t samples) const {
    if (budget.canceled()) return grid::failure(Status::canceled, fmt::format("canceled after {}", counted(samples, "sample")));
    return grid::failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(samples, "sample")));
  }

  std::string what() const { return space_.problem().footprint().is_disc() ? "a disc" : "the disc around the footprint,"; }

  std::string joined_how(const ProbabilisticRoadmap& roadmap) const {
    if (roadmap.options().neighbours > 0) return fmt::format("each joined to its {} nearest", roadmap.options().neighbours);
    return fmt::format("joined within {:.2f} m{}", roadmap.radius(), roadmap.options().radius > 0.0 ? "" : " (the radius of PRM*)");
  }

  PlanningFailure nothing_found(const ProbabilisticRoadmap& roadmap, const RoadmapAnswer& answer, const PlaneTarget& target, Budget& budget, bool& is_hopeless) const {
    const Vec2 reached = answer.way.back();
    const std::string ended = answer.ended == RoadmapEnd::lines ? fmt::format("all {} of its budget were tested", counted(answer.lines, "line"))
                              : answer.ended == RoadmapEnd::crowded
                                  ? fmt::format("more than {} million lines waited to be tested: a smaller radius or fewer samples make a smaller roadmap", ProbabilisticRoadmap::most_waiting / 1'000'000)
                                  : fmt::format("all that is joined to the start was searched, with {} tested", counted(answer.lines, "line"));
    std::string reason = fmt::format("a roadmap of {}, {}, holds no way from start to goal for {} of {:.3f} m: {}; {} of its places were reached, nearest to the goal {}, {:.2f} m off",
                                     counted(static_cast<std::int64_t>(roadmap.size()), "place"), joined_how(roadmap), what(), space_.disc(), ended, answer.reached - 1, grid::place(reached),
                                     distance(reached, target.nearest(reached)));
    if (const std::string more = unreachable_sentence(least_length(space_, budget), space_.problem()); !more.empty()) {
      reason += "; " + more;
      is_hopeless = true;
    } else if (answer.ended == RoadmapEnd::unreachable) {
      reason += "; more samples find what fewer miss";
    }
    if (budget.exhausted()) return stopped(budget, static_cast<std::int64_t>(roadmap.size()));
    PlanningFailure failed = grid::failure(Status::no_path, reason);
    Alternative tried;
    tried.name = "PRM";
    tried.outcome = fmt::format("{:.2f} m short of the goal.", distance(reached, target.nearest(reached)));
    tried.poses = picture_of(answer.way);
    failed.alternatives.push_back(std::move(tried));
    failed.search = picture_of(answer);
    failed.explanation.push_back(reason + ".");
    return failed;
  }

  PlanningResult explained(const ProbabilisticRoadmap& roadmap, const RoadmapAnswer& answer, const PlaneEnd& start, const PlaneEnd& goal, Budget& budget) const {
    Planned planned;
    std::vector<std::string>& text = planned.explanation;
    std::vector<Vec2> points = answer.way;
    planned.search = picture_of(answer);
    const auto tried = [&](std::string name, const std::vector<Vec2>& way, bool is_chosen) {
      Alternative alternative;
      alternative.name = std::move(name);
      alternative.chosen = is_chosen;
      alternative.cost = length_of_way(way);
      alternative.is_length = true;
      alternative.outcome = fmt::format("{:.3f} m with {}.", *alternative.cost, counted(static_cast<std::int64_t>(std::max<std::size_t>(way.size(), 2) - 2), "corner"));
      alternative.poses = picture_of(way);
      planned.alternatives.push_back(std::move(alternative));
    };
    text.push_back(fmt::format("This is the path of a sampling planner, a probabilistic roadmap for {} of {:.3f} m: another seed gives another path. Its roadmap has {}, {}; the shortest way in it, "
                               "{:.3f} m, was found by A* with {} tested.",
                               what(), space_.disc(), counted(static_cast<std::int64_t>(roadmap.size()), "place"), joined_how(roadmap), answer.length, counted(answer.lines, "line")));
    if (options_.shortens) {
      points = taut_way(std::move(points), space_);
      const double after = length_of_way(points);
      if (after < answer.length) text.push_back(fmt::format("Corners past which their neighbours see each other were left out: {:.3f} m.", after));
    }
    if (points != answer.way) tried("PRM", answer.way, false);
    tried(points == answer.way ? "PRM" : "as driven", points, true);
    planned.path = plane_path(space_, start, points, goal);
    if (planned.path.pieces.empty()) return tl::unexpected{grid::failure(Status::no_path, "start and goal are the same place, there is nothing to drive")};
    if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space_, start, goal));
    text.push_back(driving_sentence(space_.problem(), planned.path));
    if (std::string bound = bound_sentence(least_length(space_, budget), length(planned.path)); !bound.empty()) text.push_back(std::move(bound));
    return planned;
  }

  PlaneSpace space_;
  PrmPlannerOptions options_;
  std::uint64_t seed_;
  SteeringKind kind_ = SteeringKind::plane;
  std::optional<ProbabilisticRoadmap> drawn_;
};

PrmPlanner PrmPlanner::prepared(const Problem& problem) const {
  PrmPlanner planner = *this;
  auto ready = std::make_shared<Ready>(problem, options_, seed_);
  ready->draw_beforehand();
  planner.ready_ = std::move(ready);
  return planner;
}

PlanningResult PrmPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(budget);
  return Ready{problem, options_, seed_}.plan(budget);
}

PlannerDescription prm_description() {
  PlannerDescription d{"prm",
                       "probabilistic roadmap (PRM*), shortened: in the plane of a disc, or the disc around the footprint; among headings of the footprint itself, with turns on the spot, Dubins or Reeds-Shepp curves",
                       {
                           {.name = "samples", .default_value = 1000.0, .summary = "free places, or states, drawn; budget.samples takes its place", .low = 1,
                            .high = static_cast<double>(ProbabilisticRoadmap::most_samples), .whole = true},
                           {.name = "radius", .default_value = 0.0, .summary = "within which places are joined; 0: that of the proof of optimality, which shrinks with more samples; with headings so many nearest ones as it asks for", .unit = "m", .low = 0,
                            .high = 1e4},
                           {.name = "neighbours", .default_value = 0.0, .summary = "so many nearest places are joined instead; 0: those within the radius", .low = 0, .high = 100, .whole = true},
                           {.name = "shorten", .default_value = true, .summary = "leave out corners past which their neighbours see each other; with headings, try motions between places on the way"},
                       },
                       [](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
                         PrmPlannerOptions options;
                         options.roadmap = {whole_number_of(p, "samples"), number_of(p, "radius"), static_cast<int>(number_of(p, "neighbours"))};
                         options.shortens = flag_of(p, "shorten");
                         options.space = space_options(p);
                         return PrmPlanner{options, seed};
                       }};
  for (ParameterDescription& parameter : space_parameters("reeds_shepp for a tricycle, plane where a disc serves, else or where that fails turns")) d.parameters.push_back(std::move(parameter));
  d.parameters.push_back(resolution_parameter());
  d.counts_samples = [](const Parameters&) { return true; };
  d.takes_free_goals = true;
  return d;
}

}  // namespace waywright
