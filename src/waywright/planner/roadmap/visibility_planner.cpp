#include "waywright/planner/roadmap/visibility_planner.hpp"

#include <fmt/format.h>

#include <optional>

#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/tangent_path.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_seen_beforehand = 800;
constexpr std::size_t most_corners = 12'000;

}  // namespace

class VisibilityPlanner::Ready {
 public:
  explicit Ready(const Problem& problem) : space_{problem} {
    if (!problem.vehicle().can_turn_on_the_spot()) return;
    graph_.emplace(space_, space_.needed(), space_.needed() - ProofOptions{}.tolerance);
    if (graph_->corners() <= most_seen_beforehand) graph_->see_all();
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(Budget& budget) const {
    using grid::failure;
    const Problem& problem = space_.problem();
    if (auto reason = nothing_to_plan(problem, "visibility_graph")) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
    budget.count_evaluations();
    if (graph_->corners() > most_corners) {
      return tl::unexpected{failure(Status::no_path, fmt::format("the map has {} corners that a way may bend around, and at most {} are searched", graph_->corners(), most_corners))};
    }
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    const auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    if (!start || !goal) return tl::unexpected{no_room(space_, !start)};
    const TangentAnswer answer = graph_->shortest(start->at, target_of(problem, goal->at), budget, budget.limits().expansions);
    budget.count_expansions(answer.expansions);
    switch (answer.ended) {
      case TangentEnd::stopped: return tl::unexpected{stopped(budget, answer.expansions)};
      case TangentEnd::expansions:
        return tl::unexpected{failure(Status::no_path, fmt::format("all {} of its budget were used up before the goal was reached", grid::counted(answer.expansions, "expansion")))};
      case TangentEnd::unreachable: return tl::unexpected{unreachable(answer, budget)};
      case TangentEnd::found: break;
    }
    Planned planned;
    planned.path = tangent_path(space_, *start, answer.way, *graph_, *goal);
    explain(planned, answer, *start, *goal, budget);
    return planned;
  }

 private:
  PlanningFailure stopped(const Budget& budget, std::int64_t expansions) const {
    if (budget.canceled()) return grid::failure(Status::canceled, fmt::format("canceled after {}", grid::counted(expansions, "expansion")));
    return grid::failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), grid::counted(expansions, "expansion")));
  }

  PlanningFailure unreachable(const TangentAnswer& answer, Budget& budget) const {
    const Problem& problem = space_.problem();
    std::string reason = fmt::format("no way leads from start to goal for {} of {:.3f} m that keeps {}: all that can be reached was searched, {}",
                                     problem.footprint().is_disc() ? "a disc" : "the disc around the footprint,", space_.disc(), kept_words(space_),
                                     grid::counted(answer.expansions, "expansion"));
    std::string more = unreachable_sentence(least_length(space_, budget), problem);
    if (more.empty()) more = footprint_sentence(problem);
    if (!more.empty()) reason += "; " + more;
    return grid::failure(Status::no_path, std::move(reason));
  }

  void explain(Planned& planned, const TangentAnswer& answer, const PlaneEnd& start, const PlaneEnd& goal, Budget& budget) const {
    const Problem& problem = space_.problem();
    std::vector<std::string>& text = planned.explanation;
    const double metres = length(planned.path);
    text.push_back(fmt::format("The shortest way of {} of {:.3f} m that keeps {:.4f} m and {:.1f} mm to spare: {:.3f} m, by the visibility graph of {} corners; {}, {} looked along.",
                               problem.footprint().is_disc() ? "a disc" : "the disc around the footprint,", space_.disc(), problem.required_clearance(),
                               (space_.needed() - space_.disc() - problem.required_clearance()) * 1e3, answer.way.length, graph_->corners(), grid::counted(answer.expansions, "expansion"),
                               grid::counted(answer.lines, "line")));
    text.push_back(bend_sentence(answer.way, planned.path));
    if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space_, start, goal));
    if (std::string bound = bound_sentence(least_length(space_, budget), metres); !bound.empty()) text.push_back(std::move(bound));
  }

  std::string bend_sentence(const TangentWay& way, const Path& path) const {
    const Turning turning = turning_of(path);
    const std::string turns = turning.turns == 0 ? std::string{"it never turns on the spot"}
                                                 : fmt::format("it turns on the spot {}, {:.1f}° in all", turning.turns == 1 ? std::string{"once"} : fmt::format("{} times", turning.turns),
                                                               turning.angle * 180.0 / pi);
    if (way.bends.empty()) return fmt::format("It is one straight line; {}.", turns);
    const bool arcs = drives_arcs(space_.problem().vehicle(), graph_->radius());
    return fmt::format("It bends around {}, {}; {}.", grid::counted(static_cast<std::int64_t>(way.bends.size()), "corner"),
                       arcs ? fmt::format("each on an arc of {:.3f} m", graph_->radius()) : std::string{"each by corners around an arc that is too tight to drive"}, turns);
  }

  PlaneSpace space_;
  std::optional<TangentGraph> graph_;
};

VisibilityPlanner VisibilityPlanner::prepared(const Problem& problem) const {
  VisibilityPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem);
  return planner;
}

PlanningResult VisibilityPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(budget);
  return Ready{problem}.plan(budget);
}

PlannerDescription visibility_graph_description() {
  PlannerDescription d{"visibility_graph", "the shortest way in the plane, as lines and arcs around corners; of a disc, or the disc around the footprint", {},
                       [](const Parameters&, std::uint64_t) -> AnyPlanner { return VisibilityPlanner{}; }};
  d.counts_expansions = true;
  d.takes_free_goals = true;
  d.turns_on_the_spot = true;
  return d;
}

}  // namespace waywright
