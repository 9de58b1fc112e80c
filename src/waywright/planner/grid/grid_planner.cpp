#include "waywright/planner/grid/grid_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "waywright/planner/grid/connection.hpp"
#include "waywright/planner/grid/disc_graph.hpp"
#include "waywright/planner/grid/free_goal.hpp"
#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/grid/joined_ends.hpp"
#include "waywright/planner/grid/search_pool.hpp"
#include "waywright/planner/grid/sight.hpp"
#include "waywright/planner/grid/theta_search.hpp"
#include "waywright/planner/grid/way_to_goal.hpp"

namespace waywright {

using grid::counted, grid::disc_sentence, grid::failure, grid::is_plain_line, grid::length_sentence, grid::not_connected, grid::nothing_found, grid::of_neighbours, grid::way_to_goal, grid::zone_sentence;

namespace {
constexpr int most_corners = 1000;  // left out where an end is joined straight: as many as are seen
}

/// What is known of one problem.
class GridPlanner::Ready {
 public:
  Ready(const Problem& problem, const GridPlannerOptions& options) : problem_{problem} {
    if (!problem.vehicle().can_turn_on_the_spot()) return;
    auto frame = make_grid_frame(problem, options.resolution);
    if (!frame) {
      refused_ = frame.error();
      return;
    }
    frame_ = *frame;
    bounds_.emplace(problem, frame_);
    footprint_ = problem.footprint();
    // At any angle a footprint has to turn by any angle: the disc around it can, wherever it can stand.
    if (options.any_angle) footprint_ = {{}, footprint_.radius()};
    auto zones = GridZones::make(problem.zones_as_planned(), frame_, options.neighbours);
    if (!zones) {
      refused_ = zones.error();
      return;
    }
    if (footprint_.is_disc()) {
      graph_ = disc_graph(frame_, *bounds_, options.neighbours, footprint_.disc + lattice_margin(problem));
      graph_.set_zones(std::move(*zones));
      if (!options.any_angle) bounds_.reset();  // settled
      return;
    }
    const std::int64_t states = static_cast<std::int64_t>(frame_.columns) * frame_.rows * static_cast<int>(options.neighbours);
    if (states > HeadingSpace::most_states) {
      refused_ = fmt::format("{} x {} cells of {:g} m with {} headings each are {} states, and at most {} are searched: give a coarser resolution or fewer neighbours", frame_.columns,
                             frame_.rows, frame_.cell, static_cast<int>(options.neighbours), states, HeadingSpace::most_states);
      return;
    }
    headings_.emplace(problem, frame_, *bounds_, options.neighbours, options.costs, std::move(*zones));
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &problem_; }

  PlanningResult plan(const GridPlannerOptions& options, std::string_view name, Budget& budget) const {
    if (!problem_.vehicle().can_turn_on_the_spot()) {
      return tl::unexpected{failure(Status::no_path, fmt::format("{} plans straight lines with turns on the spot, which a tricycle cannot drive", name))};
    }
    if (!refused_.empty()) return tl::unexpected{failure(Status::no_path, refused_)};
    if (budget.exhausted()) return tl::unexpected{nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, 0, budget, 0.0, "")};
    budget.count_evaluations();
    if (problem_.free_goal() != nullptr && problem_.is_goal(problem_.start(), 0.0, 0.0)) return tl::unexpected{failure(Status::no_path, "the start is at the goal already, there is nothing to drive")};
    if (problem_.free_goal() == nullptr && problem_.start() == problem_.goal()) return tl::unexpected{failure(Status::no_path, "start and goal are the same pose, there is nothing to drive")};
    MotionCheck test{problem_, footprint_};
    if (auto direct = direct_way(test)) return explained(std::move(*direct), options, 0, std::nullopt);
    return headings_ ? plan_headings(options, budget, test) : plan_disc(options, budget, test);
  }

 private:
  /// Where start and goal are within two cells the grid would only lead astray.
  std::optional<Path> direct_way(MotionCheck& test) const {
    const Pose& start = problem_.start();
    const Pose& goal = problem_.goal();
    const double margin = connecting_margin(problem_), way = distance(start.position(), goal.position());
    const FreeGoal* free = problem_.free_goal();
    if (way > 2.0 * frame_.cell || (free != nullptr && !free->is_point())) return std::nullopt;
    if (way == 0.0) {
      const double turn = shorter_turn(start.heading, goal.heading);
      for (const double angle : {turn, turn > 0.0 ? turn - two_pi : turn + two_pi}) {
        if (test.is_turn_free(start.position(), start.heading, angle, margin)) return path_of(start, {{Action::Kind::turn, angle, {}, 1}}, goal);
      }
      return std::nullopt;
    }
    if (!is_plain_line(problem_.zones_as_planned(), start.position(), goal.position())) return std::nullopt;
    const double course = angle_of(goal.position() - start.position());
    const double first = shorter_turn(start.heading, course), last = shorter_turn(course, goal.heading);
    if (!test.is_turn_free(start.position(), start.heading, first, margin) || !test.is_drive_free(start.position(), goal.position(), course, margin)) return std::nullopt;
    if (free != nullptr) return path_along(start, {{Action::Kind::turn, first, {}, 1}, {Action::Kind::drive, 0.0, goal.position(), 1}});
    if (!test.is_turn_free(goal.position(), course, last, margin)) return std::nullopt;
    return path_of(start, {{Action::Kind::turn, first, {}, 1}, {Action::Kind::drive, 0.0, goal.position(), 1}, {Action::Kind::turn, last, {}, 1}}, goal);
  }

  PlanningResult plan_disc(const GridPlannerOptions& options, Budget& budget, MotionCheck& test) const {
    const Pose& start = problem_.start();
    const Pose& goal = problem_.goal();
    const auto from = disc_connections(problem_, frame_, start.position(), true, test);
    GridQuery query;
    for (const DiscConnection& c : from) query.starts.push_back({c.cell, c.cost / frame_.cell});
    if (problem_.free_goal() != nullptr) {
      query.goals = free_ends(problem_, frame_, test);
    } else {
      for (const DiscConnection& c : disc_connections(problem_, frame_, goal.position(), false, test)) query.goals.push_back({c.cell, c.cost / frame_.cell});
    }
    if (query.starts.empty() || query.goals.empty()) return tl::unexpected{not_connected(problem_, frame_, query.starts.empty())};
    query.heuristic = options.heuristic;
    query.expansions = budget.limits().expansions;
    query.budget = &budget;
    const double margin = lattice_margin(problem_);
    query.is_free = [&](Cell c, int move) {
      const Move m = moves[static_cast<std::size_t>(move)];
      return test.is_drive_free(frame_.centre(c), frame_.centre({c.column + m.column, c.row + m.row}), 0.0, margin);
    };
    auto search = grids_.lend();
    const GridAnswer answer = (*search).run(graph_, query);
    budget.count_expansions(answer.expansions);
    if (answer.ended != SearchEnd::found) {
      return tl::unexpected{nothing_found(answer.ended, answer.known_at_once, answer.expansions, budget, frame_.cell,
                                          fmt::format("{} of {:.3f} m that keeps {:.3f} m", problem_.footprint().is_disc() ? "a disc" : "the disc around the footprint,", footprint_.disc,
                                                      problem_.required_clearance()))};
    }
    if (options.any_angle) return plan_any_angle(options, query, answer, budget, test);
    return explained(way_to_goal(problem_, way_over(answer.cells, test)), options, answer.expansions, answer.cost * frame_.cell);
  }

  /// Of a disc, its ends joined straight.
  std::vector<Action> way_over(const std::vector<Cell>& cells, MotionCheck& test) const {
    std::vector<Action> actions{{Action::Kind::drive, 0.0, frame_.centre(cells.front()), 1}};
    for (const Action& a : drives_along(frame_, cells)) actions.push_back(a);
    if (goal_point()) actions.push_back({Action::Kind::drive, 0.0, problem_.goal().position(), 1});
    return with_joined_ends(problem_, frame_, actions, {.most_corners = most_corners}, test);
  }

  /// Lazy Theta*, and the grid's way pulled taut: the shorter of the two, so never longer than what `astar` finds.
  PlanningResult plan_any_angle(const GridPlannerOptions& options, const GridQuery& query, const GridAnswer& on_grid, Budget& budget, MotionCheck& test) const {
    const Pose& start = problem_.start();
    // Of a region: the cell of it that is nearest over the cells.
    const bool is_region = problem_.free_goal() != nullptr && !problem_.free_goal()->is_point();
    const Vec2 goal = is_region ? frame_.centre(on_grid.cells.back()) : problem_.goal().position();
    const std::vector<GridEnd> goals = is_region ? std::vector<GridEnd>{{on_grid.cells.back(), 0.0}} : query.goals;
    const Sight sight{problem_, frame_, *bounds_, footprint_.disc};
    ThetaQuery any{start.position(), goal, query.starts, goals, lattice_margin(problem_), connecting_margin(problem_), {}, &budget, query.is_free, zones()};
    if (query.expansions) any.expansions = *query.expansions - on_grid.expansions;
    auto search = any_angles_.lend();
    const ThetaAnswer answer = (*search).run(graph_, frame_, sight, any);
    budget.count_expansions(answer.expansions);
    if (answer.ended != SearchEnd::found) {
      return tl::unexpected{nothing_found(answer.ended, false, budget.expansions(), budget, frame_.cell, fmt::format("a disc of {:.3f} m", footprint_.disc))};
    }
    std::vector<Vec2> cells{start.position()};
    for (const Cell c : on_grid.cells) cells.push_back(frame_.centre(c));
    if (!is_region) cells.push_back(goal);
    const auto metres = [&](const std::vector<Vec2>& points) { return zones() != nullptr ? cost_of(points, *zones()) : length_of(points); };
    const double of_grid = metres(cells);
    const auto taut = [&](std::vector<Vec2> points) { return pulled_taut(std::move(points), sight, any.margin, any.end_margin, zones()); };
    std::vector<Vec2> joined{start.position()};
    for (const Action& a : way_over(on_grid.cells, test)) {
      if (a.kind == Action::Kind::drive) joined.push_back(a.to);
    }
    // The cells' whole way, and that which astar drives: straight runs and joined ends leave fewer corners to pull at.
    const std::vector<Vec2> of_cells = taut(std::move(cells)), of_joined = taut(std::move(joined));
    const std::vector<Vec2> from_theta = taut(answer.points);
    const std::vector<Vec2>& from_grid = metres(of_cells) <= metres(of_joined) ? of_cells : of_joined;
    const std::vector<Vec2>& points = metres(from_theta) <= metres(from_grid) ? from_theta : from_grid;
    std::vector<Action> actions;
    for (std::size_t i = 1; i < points.size(); ++i) actions.push_back({Action::Kind::drive, 0.0, points[i], 1});
    Planned planned = explained(way_to_goal(problem_, actions), options, budget.expansions(), of_grid);
    planned.explanation.front() =
        fmt::format("A way at any angle over {} x {} cells of {:g} m{}: {:.3f} m with lazy Theta*, {:.3f} m where the {} way over the cells, {:.3f} m, is pulled taut; the {} is taken. "
                    "{} in both searches.",
                    frame_.columns, frame_.rows, frame_.cell, is_weighed() ? ", as zones weigh it" : "", metres(from_theta), metres(from_grid), is_weighed() ? "least costly" : "shortest", of_grid,
                    is_weighed() ? "cheaper" : "shorter", counted(budget.expansions(), "expansion"));
    if (!problem_.footprint().is_disc()) {
      planned.explanation.push_back(disc_sentence(footprint_.disc));
    }
    return planned;
  }

  PlanningResult plan_headings(const GridPlannerOptions& options, Budget& budget, MotionCheck& test) const {
    const auto from = heading_connections(problem_, *headings_, problem_.start(), true, test);
    const auto to = problem_.free_goal() != nullptr ? free_connections(problem_, *headings_, test) : heading_connections(problem_, *headings_, problem_.goal(), false, test);
    if (from.empty() || to.empty()) return tl::unexpected{not_connected(problem_, frame_, from.empty())};
    std::vector<HeadingEnd> starts, goals;
    for (const HeadingConnection& c : from) starts.push_back({c.state, c.cost});
    for (const HeadingConnection& c : to) goals.push_back({c.state, c.cost});
    auto search = in_headings_.lend();
    const HeadingAnswer answer = (*search).run(*headings_, starts, goals, options.heuristic, budget.limits().expansions, &budget, test);
    budget.count_expansions(answer.expansions);
    if (answer.ended != SearchEnd::found) {
      return tl::unexpected{nothing_found(answer.ended, false, answer.expansions, budget, frame_.cell, fmt::format("the footprint in {} headings", headings_->headings()))};
    }
    const auto of = [](const std::vector<HeadingConnection>& all, const HeadingState& state) -> const std::vector<Action>& {
      const HeadingConnection* best = nullptr;
      for (const HeadingConnection& c : all) {
        if (c.state.cell == state.cell && c.state.heading == state.heading && (best == nullptr || c.cost < best->cost)) best = &c;
      }
      return best->actions;
    };
    std::vector<Action> actions = of(from, answer.first);
    for (const Action& a : actions_along(*headings_, answer)) actions.push_back(a);
    for (const Action& a : of(to, answer.last)) actions.push_back(a);
    const EndsToJoin ends{.most_corners = most_corners, .turn_cost = options.costs.turn, .reverse_cost = options.costs.reverse};
    return explained(way_to_goal(problem_, with_joined_ends(problem_, frame_, actions, ends, test)), options, answer.expansions, answer.cost);
  }

  Planned explained(Path path, const GridPlannerOptions& options, std::int64_t expansions, std::optional<double> cost) const {
    Planned planned;
    std::vector<std::string>& text = planned.explanation;
    if (cost) {
      const bool is_least = never_too_much(options.heuristic, options.neighbours);
      std::string what = is_least ? (headings_ || is_weighed() ? "The least costly way" : "The shortest way") : "A way";
      what += fmt::format(" over {} x {} cells of {:g} m with {}{}: {:.3f} m", frame_.columns, frame_.rows, frame_.cell, of_neighbours(options.neighbours),
                          headings_ ? " and as many headings" : "", *cost);
      if (headings_) {
        what += fmt::format(", where a radian of turning counts as {:g} m", options.costs.turn);
        what += options.costs.reverse > 0.0 ? fmt::format(" and a metre backwards as {:g} m", options.costs.reverse) : std::string{" and it never drives backwards"};
      }
      what += fmt::format("; {} with {}", counted(expansions, "expansion"),
                          options.heuristic == Heuristic::none ? std::string{"no heuristic"} : fmt::format("the heuristic {}", to_string(options.heuristic)));
      text.push_back(what + (is_least ? "." : ", which may expect too much, so that a better way may have been missed."));
    } else {
      text.push_back(fmt::format("Start and goal are within two cells of {:g} m: the way is straight, without a search.", frame_.cell));
    }
    text.push_back(length_sentence(problem_, path));
    text.push_back(fmt::format("Each move was tested against the exact outlines, with {:.1f} mm to spare beyond the {:.4f} m that are required; the cells cost no clearance, but ways that "
                               "lead between their middles are not seen: a passage has to be up to a cell, {:g} m, wider than what just fits.",
                               (lattice_margin(problem_) - problem_.required_clearance()) * 1e3, problem_.required_clearance(), frame_.cell));
    if (std::string sentence = zone_sentence(problem_, path); !sentence.empty()) text.push_back(std::move(sentence));
    planned.path = std::move(path);
    return planned;
  }

  /// The goal is a place, not a region.
  bool goal_point() const { return problem_.free_goal() == nullptr || problem_.free_goal()->is_point(); }
  bool is_weighed() const { return problem_.zones_as_planned().weighs(); }
  /// nullptr where no zone directs or weighs.
  const ZoneRules* zones() const { return problem_.zones_as_planned().directs() || is_weighed() ? &problem_.zones_as_planned() : nullptr; }

  const Problem& problem_;
  std::string refused_;
  GridFrame frame_;
  std::optional<CellBounds> bounds_;
  Footprint footprint_;                   ///< that is searched for
  GridGraph graph_;                       ///< of a disc
  std::optional<HeadingSpace> headings_;  ///< of other footprints
  mutable SearchPool<GridSearch> grids_;
  mutable SearchPool<HeadingSearch> in_headings_;
  mutable SearchPool<ThetaSearch> any_angles_;
};

GridPlanner GridPlanner::prepared(const Problem& problem) const {
  GridPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult GridPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, name_, budget);
  return Ready{problem, options_}.plan(options_, name_, budget);
}

}  // namespace waywright
