#include "waywright/planner/grid/safe_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
#include "waywright/planner/grid/way_to_goal.hpp"

namespace waywright {

using grid::counted, grid::failure, grid::nothing_found, grid::of_neighbours, grid::place;

namespace {

constexpr double reach_by_radius = 1.5;  // R₁ = 1.5 r; the publication names no r, its reconstruction takes a metre, which is a cell

std::string searches(std::size_t n) { return n == 1 ? "1 search" : fmt::format("{} searches", n); }

Action drive(Vec2 to) { return {Action::Kind::drive, 0.0, to, 1}; }

}  // namespace

/// What is known of one problem.
class SafePlanner::Ready {
 public:
  Ready(const Problem& problem, const SafePlannerOptions& options) : problem_{problem}, options_{options} {
    if (!problem.vehicle().can_turn_on_the_spot()) return;
    auto frame = make_grid_frame(problem, options.resolution);
    if (!frame) {
      refused_ = frame.error();
      return;
    }
    frame_ = *frame;
    // Straight parts turn by any angle: a footprint with a shape is searched as the disc around it.
    disc_ = {{}, problem.footprint().radius()};
    rule_.reach = options.danger_radius > 0.0 ? options.danger_radius : reach_by_radius * std::max(disc_.disc, frame_.cell);
    keeps_ = rule_.reach / reach_by_radius;
    bounds_.emplace(problem, frame_);
    const double needed = disc_.disc + lattice_margin(problem);
    CellMap cells = cells_of(needed);
    if (options.is_published) {
      ways_.emplace(std::move(cells), frame_.cell, options.method, PublishedWays::Options{rule_, options.neighbours, options.local_radius / frame_.cell, keeps_});
      bounds_.reset();
      return;
    }
    auto zones = GridZones::make(problem.zones_as_planned(), frame_, neighbours());
    if (!zones) {
      refused_ = zones.error();
      return;
    }
    graph_ = disc_graph(frame_, *bounds_, neighbours(), needed);
    graph_.set_zones(std::move(*zones));
    if (options.method != PublishedMethod::line) set_danger(cells);
    if (options.method == PublishedMethod::boundary) {
      obstacles_.emplace(cells.columns, cells.rows, cells.occupied);
      // A line is only stopped by cells that the vehicle surely cannot be in; what it may pass is asked of the outlines.
      for (std::size_t i = 0; i < cells.blocked.size(); ++i) {
        const bool may_be_entered = graph_.free_moves()[i] != 0 || (!graph_.asked_moves().empty() && graph_.asked_moves()[i] != 0);
        cells.blocked[i] = cells.occupied[i] != 0 || !may_be_entered ? 1 : 0;
      }
    }
    cells_ = std::move(cells);
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &problem_; }

  PlanningResult plan(std::string_view name, Budget& budget) const {
    if (!problem_.vehicle().can_turn_on_the_spot()) {
      return tl::unexpected{failure(Status::no_path, fmt::format("{} plans straight lines with turns on the spot, which a tricycle cannot drive", name))};
    }
    if (!refused_.empty()) return tl::unexpected{failure(Status::no_path, refused_)};
    if (budget.exhausted()) return tl::unexpected{nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, 0, budget, 0.0, "")};
    budget.count_evaluations();
    const Pose& start = problem_.start();
    const Pose& goal = problem_.goal();
    const FreeGoal* free = problem_.free_goal();
    const bool is_region = free != nullptr && !free->is_point();
    if (is_region && ways_) return tl::unexpected{failure(Status::no_path, "the published form searches to one cell, not to a region; take form corrected")};
    if (free != nullptr && problem_.is_goal(start, 0.0, 0.0)) return tl::unexpected{failure(Status::no_path, "the start is at the goal already, there is nothing to drive")};
    if (free == nullptr && start == goal) return tl::unexpected{failure(Status::no_path, "start and goal are the same pose, there is nothing to drive")};
    MotionCheck test{problem_, disc_};
    if (!is_region && distance(start.position(), goal.position()) <= 2.0 * frame_.cell && may_be_straight(start.position(), goal.position()) && test.is_drive_free(start.position(), goal.position(), 0.0, connecting_margin(problem_))) {
      return explained({}, fmt::format("Start and goal are within two cells of {:g} m: the way is straight, without a search.", frame_.cell));
    }
    if (ways_) return plan_published(budget);
    if (options_.method == PublishedMethod::line) return plan_line(budget, test);
    if (options_.method == PublishedMethod::boundary) return plan_boundary(budget, test);
    return plan_danger(budget, test, "");
  }

 private:
  Neighbours neighbours() const {
    return options_.method == PublishedMethod::boundary ? Neighbours::sixteen : options_.method == PublishedMethod::line ? Neighbours::eight : options_.neighbours;
  }

  Cell cell_of(Vec2 world) const { return frame_.cell_at(world); }
  Vec2 on_cells(Vec2 world) const { return frame_.in_cells(world) - Vec2{0.5, 0.5}; }
  Vec2 in_world(Vec2 cells) const { return frame_.frame.to_world(Vec2{(cells.x + 0.5) * frame_.cell, (frame_.rows - cells.y - 0.5) * frame_.cell}); }

  CellMap cells_of(double needed) const {
    CellMap cells{frame_.columns, frame_.rows, bounds_->occupied(), {}};
    if (options_.method == PublishedMethod::boundary && options_.regularise) {
      cells.occupied = with_regular_obstacles(frame_.columns, frame_.rows, cells.occupied, {cell_of(problem_.start().position()), cell_of(problem_.goal().position())});
    }
    cells.blocked = cells.occupied;
    for (int row = 0; row < frame_.rows; ++row) {
      for (int column = 0; column < frame_.columns; ++column) {
        // Where the bounds do not tell, the outlines do.
        if (bounds_->at_least({column, row}) >= needed) continue;
        const Vec2 middle = frame_.centre({column, row});
        if (bounds_->at_most({column, row}) < needed || !problem_.world().is_free({&middle, 1}, needed)) cells.blocked[cells.index({column, row})] = 1;
      }
    }
    return cells;
  }

  void set_danger(const CellMap& cells) {
    constexpr double most = 65535.0, unit = 256.0;  // as GridGraph counts
    danger_.emplace(cells.columns, cells.rows, frame_.cell, cells.occupied, rule_);
    if (options_.danger_weight == 0.0) return;
    std::vector<std::uint16_t> costs(graph_.cells(), 0);
    for (int row = 0; row < frame_.rows; ++row) {
      for (int column = 0; column < frame_.columns; ++column) {
        const std::size_t at = graph_.index(column, row);
        const bool is_entered = graph_.free_moves()[at] != 0 || (!graph_.asked_moves().empty() && graph_.asked_moves()[at] != 0);
        if (!is_entered) continue;
        const double counted_as = std::round(unit * options_.danger_weight * danger_->at({column, row}));
        is_capped_ = is_capped_ || counted_as > most;
        costs[at] = static_cast<std::uint16_t>(std::min(most, counted_as));
      }
    }
    graph_.set_danger(costs);
  }

  std::string what_fits() const {
    return fmt::format("{} of {:.3f} m that keeps {:.3f} m", problem_.footprint().is_disc() ? "a disc" : "the disc around the footprint,", disc_.disc, problem_.required_clearance());
  }

  PlanningFailure not_connected(bool is_start) const {
    return grid::not_connected(problem_, frame_, is_start,
                               problem_.footprint().is_disc() ? "" : fmt::format(" for the disc of {:.3f} m around the footprint, which is what is searched (astar asks the footprint itself)", disc_.disc));
  }

  /// Straight parts go against no direction and through no penalty: there it is searched. The published form knows no zones but forbidden ones.
  bool may_be_straight(Vec2 from, Vec2 to) const { return options_.is_published || grid::is_plain_line(problem_.zones_as_planned(), from, to); }

  std::vector<GridEnd> ends_at(const Pose& pose, bool is_start, MotionCheck& test) const {
    std::vector<GridEnd> ends;
    for (const DiscConnection& c : disc_connections(problem_, frame_, pose.position(), is_start, test)) ends.push_back({c.cell, c.cost / frame_.cell});
    return ends;
  }

  /// Least cost over the graph within what the budget has left.
  GridAnswer searched(std::vector<GridEnd> starts, std::vector<GridEnd> goals, Budget& budget, MotionCheck& test) const {
    GridQuery query;
    query.starts = std::move(starts);
    query.goals = std::move(goals);
    if (budget.limits().expansions) query.expansions = *budget.limits().expansions - budget.expansions();
    query.budget = &budget;
    const double margin = lattice_margin(problem_);
    query.is_free = [&](Cell c, int move) {
      const Move m = moves[static_cast<std::size_t>(move)];
      return test.is_drive_free(frame_.centre(c), frame_.centre({c.column + m.column, c.row + m.row}), 0.0, margin);
    };
    auto search = grids_.lend();
    GridAnswer answer = (*search).run(graph_, query);
    budget.count_expansions(answer.expansions);
    return answer;
  }

  PlanningFailure not_found(const GridAnswer& answer, const Budget& budget) const {
    return nothing_found(answer.ended, answer.known_at_once && budget.expansions() == 0, budget.expansions(), budget, frame_.cell, what_fits());
  }

  void append(const std::vector<Cell>& cells, std::vector<Action>& actions) const {
    actions.push_back(drive(frame_.centre(cells.front())));
    for (const Action& a : drives_along(frame_, cells)) actions.push_back(a);
  }

  /// Without stubs to the middles of the cells at its ends; each new drive stays as near to the way that was found, whose danger is known, as the stub was long.
  std::vector<Action> joined(std::vector<Action> actions, bool at_start, bool at_goal, MotionCheck& test) const {
    if (at_goal) actions.push_back(drive(problem_.goal().position()));
    return with_joined_ends(problem_, frame_, actions, {.start = at_start, .goal = at_goal, .most_corners = 1}, test);
  }

  std::string danger_words(const GridAnswer& answer) const {
    return fmt::format("where a metre costs 1 + {:g}·ψ, the second rounded to 1/256{}, and ψ is the danger of occupied cells within {:.3f} m: {:.3f} m, and no way over the cells costs less by more than {:.6f} m",
                       options_.danger_weight, is_capped_ ? " and counted as 256 where it is more" : "", rule_.reach, answer.cost * frame_.cell, answer.error * frame_.cell);
  }

  PlanningResult plan_danger(Budget& budget, MotionCheck& test, const std::string& why) const {
    const auto from = ends_at(problem_.start(), true, test), to = problem_.free_goal() != nullptr ? free_ends(problem_, frame_, test) : ends_at(problem_.goal(), false, test);
    if (from.empty() || to.empty()) return tl::unexpected{not_connected(from.empty())};
    const GridAnswer answer = searched(from, to, budget, test);
    if (answer.ended != SearchEnd::found) return tl::unexpected{not_found(answer, budget)};
    std::vector<Action> actions;
    append(answer.cells, actions);
    return explained(joined(actions, true, problem_.free_goal() == nullptr || problem_.free_goal()->is_point(), test), fmt::format("{}The least costly way over {} x {} cells of {:g} m with {}, {}; {}.", why, frame_.columns, frame_.rows, frame_.cell, of_neighbours(neighbours()),
                                          danger_words(answer), counted(budget.expansions(), "expansion")));
  }

  PlanningResult plan_boundary(Budget& budget, MotionCheck& test) const {
    const Vec2 start = problem_.start().position(), goal = problem_.goal().position();
    const Sight sight{problem_, frame_, *bounds_, disc_.disc};
    constexpr const char* straight_on = "Nothing stands between start and goal: the way is straight, without a search.";
    if (may_be_straight(start, goal) && sight.is_free(start, goal, connecting_margin(problem_))) return explained({}, straight_on);
    const double margin = std::max(lattice_margin(problem_), keeps_ - disc_.disc);
    // What the last straight part keeps it has to keep at the goal, too: where it cannot, nothing has to be asked.
    if (!sight.is_free(goal, goal, margin)) {
      return plan_danger(budget, test, "The goal is nearer to something than a straight part to it may come, so the search went all the way. ");
    }
    const auto sees_goal = [&](Cell c) { return sight.is_free(frame_.centre(c), goal, margin) && !first_crossing(cells_, middle_of(c), on_cells(goal)) && may_be_straight(frame_.centre(c), goal); };
    const BoundaryAnswer boundary = boundary_points({cells_, *obstacles_, *danger_, on_cells(start), on_cells(goal), sees_goal, true, [&] { return budget.exhausted(); }});
    if (budget.exhausted()) return tl::unexpected{nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, 0, budget, frame_.cell, "")};
    if (boundary.kind != BoundaryAnswer::Kind::joined) {
      return plan_danger(budget, test, boundary.kind == BoundaryAnswer::Kind::none ? fmt::format("No boundary point leads to the goal ({}), so the search went all the way. ", boundary.why) : "");
    }
    const auto from = ends_at(problem_.start(), true, test);
    if (from.empty()) return tl::unexpected{not_connected(true)};
    const GridAnswer answer = searched(from, {{boundary.last, 0.0}}, budget, test);
    if (answer.ended == SearchEnd::unreachable) return plan_danger(budget, test, "The cell from which the last boundary point sees the goal cannot be reached, so the search went all the way. ");
    if (answer.ended != SearchEnd::found) return tl::unexpected{not_found(answer, budget)};
    std::vector<Action> actions;
    append(answer.cells, actions);
    const Vec2 last = frame_.centre(boundary.last);
    return explained(joined(actions, true, false, test), fmt::format("From corner to corner of what stands between, {} the way to the goal is straight, {:.3f} m from {}, its middle {:.3f} m or more from everything. Up to there the least costly way over "
                                          "{} x {} cells of {:g} m with 16 neighbours, {}; {}.",
                                          boundary.corners.empty() ? std::string{"none of which is needed,"} : fmt::format("{} in all,", counted(static_cast<std::int64_t>(boundary.corners.size()), "boundary point")),
                                          distance(last, goal), place(last), margin + disc_.disc, frame_.columns, frame_.rows, frame_.cell, danger_words(answer), counted(budget.expansions(), "expansion")));
  }

  PlanningResult plan_line(Budget& budget, MotionCheck& test) const {
    const Vec2 start = problem_.start().position(), goal = problem_.goal().position();
    const Sight sight{problem_, frame_, *bounds_, disc_.disc};
    const double margin = lattice_margin(problem_);
    const Vec2 from = on_cells(start), to = on_cells(goal);
    const double whole = distance(from, to);
    auto detours = detours_of(cells_, from, to, options_.local_radius / frame_.cell, [&](Vec2 a, Vec2 b) { return may_be_straight(in_world(a), in_world(b)) && sight.is_free(in_world(a), in_world(b), margin); });
    bool is_wider = false;
    std::vector<std::vector<Cell>> found;
    for (std::size_t i = 0; i < detours.size();) {
      const Detour& d = detours[i];
      std::vector<GridEnd> starts, goals;
      if (d.begin <= 0.0) starts = ends_at(problem_.start(), true, test);
      else starts = {{cell_on(from, to, d.begin), 0.0}};
      if (d.end >= whole) goals = ends_at(problem_.goal(), false, test);
      else goals = {{cell_on(from, to, d.end), 0.0}};
      if (starts.empty() || goals.empty()) return tl::unexpected{not_connected(starts.empty())};
      const GridAnswer answer = searched(starts, goals, budget, test);
      if (answer.ended == SearchEnd::found) {
        found.push_back(answer.cells);
        ++i;
        continue;
      }
      // An end that is free can lie in a pocket.
      const auto next = answer.ended == SearchEnd::unreachable ? widened(detours, i, whole) : std::nullopt;
      if (!next) return tl::unexpected{not_found(answer, budget)};
      i = *next;
      found.resize(i);
      is_wider = true;
    }
    std::vector<Action> actions;
    for (const std::vector<Cell>& cells : found) append(cells, actions);
    // Straight parts have no stubs.
    const bool at_start = !detours.empty() && detours.front().begin <= 0.0, at_goal = !detours.empty() && detours.back().end >= whole;
    return explained(joined(actions, at_start, at_goal, test), detours.empty() ? std::string{"Nothing stands on the straight line from start to goal: the way is straight, without a search."}
                                              : fmt::format("The straight line from start to goal, with {} over {} x {} cells of {:g} m, each from {:g} m or more before an obstacle to {:g} m or more behind it{}; {}.",
                                                            searches(detours.size()), frame_.columns, frame_.rows, frame_.cell,
                                                            options_.local_radius, options_.local_radius, is_wider ? ", longer where such a stretch led nowhere" : "", counted(budget.expansions(), "expansion")));
  }

  PlanningResult plan_published(Budget& budget) const {
    const Cell start = cell_of(problem_.start().position()), goal = cell_of(problem_.goal().position());
    auto search = published_.lend();
    const PublishedWay way = ways_->way(start, goal, *search, budget.limits().expansions, &budget);
    budget.count_expansions(way.expansions);
    if (budget.exhausted()) return tl::unexpected{nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, way.expansions, budget, frame_.cell, "")};
    if (way.ended != SearchEnd::found) return tl::unexpected{nothing_found(way.ended, way.known_at_once, way.expansions, budget, frame_.cell, what_fits())};
    std::vector<Action> actions;
    for (std::size_t i = 0; i < way.points.size(); ++i) {
      if (i > 0 && i + 1 < way.points.size()) {
        const Vec2 before = way.points[i] - way.points[i - 1], after = way.points[i + 1] - way.points[i];
        constexpr double straight = 1e-9;
        if (std::abs(cross(before, after)) <= straight && dot(before, after) > 0.0) continue;
      }
      actions.push_back(drive(in_world(way.points[i])));
    }
    std::string how = options_.method == PublishedMethod::line ? fmt::format("the straight line with {} around what it crosses", searches(way.local))
                      : options_.method == PublishedMethod::danger ? fmt::format("{}, the danger coefficient in what is expected", of_neighbours(options_.neighbours))
                      : way.fell_back ? fmt::format("16 neighbours all the way, as no boundary point leads to the goal ({})", way.boundary.why)
                                      : fmt::format("16 neighbours, then straight, by {}", counted(static_cast<std::int64_t>(way.boundary.corners.size()), "boundary point"));
    Planned planned = explained(actions, fmt::format("As published, over {} x {} cells of {:g} m: {}; {}. It goes past single corners of blocked cells, and what comes nearer to something than is "
                                                     "required is not proven.",
                                                     frame_.columns, frame_.rows, frame_.cell, how, counted(way.expansions, "expansion")));
    return planned;
  }

  Planned explained(const std::vector<Action>& actions, std::string how) const {
    Planned planned;
    planned.path = grid::way_to_goal(problem_, actions);
    planned.explanation.push_back(std::move(how));
    if (options_.method == PublishedMethod::boundary && options_.regularise) {
      planned.explanation.push_back("Rectangles stood in place of obstacles that are not convex while it was searched, except where start or goal would be in one.");
    }
    planned.explanation.push_back(grid::length_sentence(problem_, planned.path));
    if (!problem_.footprint().is_disc()) {
      planned.explanation.push_back(grid::disc_sentence(disc_.disc));
    }
    if (!options_.is_published) {
      if (std::string sentence = grid::zone_sentence(problem_, planned.path); !sentence.empty()) {
        if (options_.method != PublishedMethod::danger && problem_.zones_as_planned().weighs()) {
          sentence += " Zones are weighed where it searches over cells; straight parts go around penalties, and look for no preferred zone.";
        }
        planned.explanation.push_back(std::move(sentence));
      }
    }
    return planned;
  }

  const Problem& problem_;
  const SafePlannerOptions options_;
  std::string refused_;
  GridFrame frame_;
  Footprint disc_;
  DangerRule rule_;
  bool is_capped_ = false;  ///< some danger is more than costs can hold
  double keeps_ = 0.0;  ///< m from everything, on straight parts
  std::optional<CellBounds> bounds_;
  std::optional<PublishedWays> ways_;  ///< of the published form; the rest is of the corrected one
  GridGraph graph_;
  CellMap cells_;
  std::optional<CellDanger> danger_;
  std::optional<CellObstacles> obstacles_;
  mutable SearchPool<GridSearch> grids_;
  mutable SearchPool<PublishedSearch> published_;
};

SafePlanner SafePlanner::prepared(const Problem& problem) const {
  SafePlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult SafePlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(name_, budget);
  return Ready{problem, options_}.plan(name_, budget);
}

}  // namespace waywright
