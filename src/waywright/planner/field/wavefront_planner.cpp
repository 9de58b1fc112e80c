#include "waywright/planner/field/wavefront_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/field/field_drawings.hpp"
#include "waywright/planner/field/wavefront.hpp"
#include "waywright/planner/field/way_ends.hpp"
#include "waywright/planner/grid/disc_graph.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {

using grid::counted;

class WavefrontPlanner::Ready {
 public:
  Ready(const Problem& problem, const WavefrontOptions& options) : space_{problem} {
    if (!problem.vehicle().can_turn_on_the_spot()) return;
    auto frame = make_grid_frame(problem, options.resolution);
    if (!frame) {
      refused_ = frame.error();
      return;
    }
    frame_ = *frame;
    graph_ = disc_graph(frame_, CellBounds{problem, frame_}, options.neighbours, space_.needed());
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const WavefrontOptions& options, Budget& budget) const {
    const auto ends = cell_ends(space_, frame_, refused_, "wavefront", budget);
    if (!ends) return ends.error();
    std::vector<Cell> goals;
    if (ends->is_region) {
      for (const DiscConnection& c : ends->goals) goals.push_back(c.cell);
    } else {
      goals = {std::min_element(ends->goals.begin(), ends->goals.end(), [](const DiscConnection& a, const DiscConnection& b) { return a.cost < b.cost; })->cell};
    }
    const auto is_free = [&](Cell c, int move) {
      const Move m = moves[static_cast<std::size_t>(move)];
      return space_.is_free(frame_.centre(c), frame_.centre({c.column + m.column, c.row + m.row}));
    };
    Wavefront front = wavefront(graph_, goals, is_free, [&] { return budget.exhausted(); }, budget.limits().expansions.value_or(std::numeric_limits<std::int64_t>::max()));
    budget.count_expansions(front.expanded);
    if (front.is_stopped) {
      const SearchEnd why = budget.canceled() ? SearchEnd::canceled : budget.cut_short() ? SearchEnd::timed_out : SearchEnd::expansions;
      return tl::unexpected{grid::nothing_found(why, false, front.expanded, budget, frame_.cell, "")};
    }
    const auto value = [&](const DiscConnection& c) { return front.values[graph_.index(c.cell)]; };
    std::optional<DiscConnection> first;
    for (const DiscConnection& c : ends->from) {
      if (value(c) != 0 && (!first || value(c) < value(*first))) first = c;
    }
    if (!first) {
      PlanningFailure failed = not_connected(space_, fmt::format("the wave from the goal came through {} of {:g} m and did not reach the start", counted(front.reached, "cell"), frame_.cell), budget);
      failed.field = wavefront_drawing(frame_, std::move(front), options.neighbours);
      return tl::unexpected{std::move(failed)};
    }
    const auto clearance = [&](Cell c) { return space_.at_least(frame_.centre(c)); };
    const std::vector<Cell> cells = way_down(front, graph_, first->cell, is_free, options.keeps_away ? std::function<double(Cell)>{clearance} : std::function<double(Cell)>{});
    PlanningResult plan = explained(options, front, cells, value(*first), *ends, budget);
    if (plan) plan->field = wavefront_drawing(frame_, std::move(front), options.neighbours);
    return plan;
  }

 private:
  PlanningResult explained(const WavefrontOptions& options, const Wavefront& front, const std::vector<Cell>& cells, std::uint32_t value, const CellEnds& ends, Budget& budget) const {
    std::vector<Vec2> points{ends.start.at};
    for (const Cell c : cells) points.push_back(frame_.centre(c));
    if (!ends.is_region) points.push_back(ends.goal.at);
    std::vector<std::string> text;
    text.push_back(fmt::format("The wave from the goal came through {} of {:g} m; the start's has the value {}, so that {} lead down, with {} neighbours. It counts moves, a diagonal one like a straight one{}.",
                               counted(front.reached, "cell"), frame_.cell, value, counted(static_cast<std::int64_t>(value - Wavefront::goal_value), "move"), static_cast<int>(options.neighbours),
                               options.keeps_away ? "; of moves that lead down alike the one farthest from obstacles was taken" : ""));
    if (options.shortens) {
      const double before = length_of_way(points);
      points = taut_way(std::move(points), space_);
      if (const double after = length_of_way(points); after < before) text.push_back(fmt::format("Corners past which their neighbours see each other were left out: {:.3f} m instead of {:.3f} m.", after, before));
    }
    return finished_plan(space_, plane_path(space_, ends.start, points, ends.goal), ends.start, ends.goal, std::move(text), budget);
  }

  PlaneSpace space_;
  GridFrame frame_;
  GridGraph graph_;
  std::string refused_;
};

WavefrontPlanner WavefrontPlanner::prepared(const Problem& problem) const {
  WavefrontPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult WavefrontPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, budget);
  return Ready{problem, options_}.plan(options_, budget);
}

PlannerDescription wavefront_description() {
  const WavefrontOptions defaults;
  PlannerDescription d{"wavefront",
                       "fewest moves between cells, down the wave from the goal; of a disc, or the disc around the footprint",
                       {{.name = "resolution", .default_value = defaults.resolution, .summary = "of the cells; 0: the map's own, or 0.05 m", .unit = "m", .low = 0, .high = 100},
                        {.name = "neighbours", .default_value = 8.0, .summary = "of a cell", .low = 4, .high = 8, .whole = true, .values = {4, 8}},
                        {.name = "keeps_away", .default_value = defaults.keeps_away, .summary = "of moves that lead down alike the one farthest from obstacles; else the first, as published"},
                        {.name = "shorten", .default_value = defaults.shortens, .summary = "leave out corners past which their neighbours see each other"}},
                       [](const Parameters& p, std::uint64_t) -> AnyPlanner {
                         WavefrontOptions o;
                         o.resolution = number_of(p, "resolution");
                         o.neighbours = static_cast<Neighbours>(static_cast<int>(number_of(p, "neighbours")));
                         o.keeps_away = flag_of(p, "keeps_away");
                         o.shortens = flag_of(p, "shorten");
                         return WavefrontPlanner{o};
                       }};
  d.takes_free_goals = true;
  d.turns_on_the_spot = true;
  d.counts_expansions = true;
  return d;
}

}  // namespace waywright
