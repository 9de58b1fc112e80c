#include "waywright/planner/field/harmonic_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/planner/field/field_drawings.hpp"
#include "waywright/planner/field/way_ends.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/rounded_way.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;

constexpr std::int64_t usual_cells = 100'000;       // solved in some tenths of a second
constexpr double step_of_cell = 0.5;
constexpr double thinning = 0.1;                    // of a cell
constexpr double stub_of_cell = 3.0;                // so near to start and goal middles of cells are not turned aside for

}  // namespace

class HarmonicPlanner::Ready {
 public:
  Ready(const Problem& problem, const HarmonicOptions& options) : space_{problem} {
    if (!problem.vehicle().can_turn_on_the_spot()) return;
    auto frame = frame_of(problem, options.resolution);
    if (!frame) refused_ = frame.error();
    else frame_ = *frame;
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const HarmonicOptions& options, Budget& budget) const {
    const auto ends = cell_ends(space_, frame_, refused_, "harmonic", budget);
    if (!ends) return ends.error();
    std::vector<Cell> goals;
    for (const DiscConnection& c : ends->goals) goals.push_back(c.cell);
    const auto is_free = [&](Cell c) { return space_.is_free(frame_.centre(c)); };
    const auto may_drive = [&](Cell a, Cell b) { return space_.is_free(frame_.centre(a), frame_.centre(b)); };
    HarmonicField::Options wanted = options.field;
    wanted.most_unknowns = budget.limits().expansions.value_or(wanted.most_unknowns);
    const auto shared = std::make_shared<const HarmonicField>(frame_, goals, is_free, may_drive, wanted);
    const HarmonicField& field = *shared;
    budget.count_expansions(field.unknowns());
    if (field.is_over()) return tl::unexpected{grid::nothing_found(SearchEnd::expansions, false, field.unknowns(), budget, frame_.cell, "")};
    if (budget.exhausted()) return tl::unexpected{grid::nothing_found(budget.canceled() ? SearchEnd::canceled : SearchEnd::timed_out, false, field.unknowns(), budget, frame_.cell, "")};
    std::optional<Cell> first;
    for (const DiscConnection& c : ends->from) {
      if (field.at(c.cell) > 0.0 && (!first || field.at(c.cell) > field.at(*first))) first = c.cell;
    }
    if (!first && std::any_of(ends->from.begin(), ends->from.end(), [&](const DiscConnection& c) { return field.reaches(c.cell); })) {
      return tl::unexpected{failure(Status::no_path, fmt::format("at the start the potential is under what numbers can tell, so far is it from the goal between walls that draw off {:g}; less absorption, or coarser cells, reach farther",
                                                                 options.field.absorption))};
    }
    if (!first) {
      PlanningFailure failed = not_connected(space_, fmt::format("the start is not connected to the goal between {} of {:g} m (a finer `resolution` joins what is narrower)", counted(field.unknowns(), "free cell"), frame_.cell), budget);
      failed.field = harmonic_drawing(shared);
      return tl::unexpected{std::move(failed)};
    }
    std::vector<Vec2> points = streamline(field, goals, *first);
    points.insert(points.begin(), ends->start.at);
    if (!ends->is_region) points.push_back(ends->goal.at);
    std::vector<std::string> text{fmt::format("Along a streamline of the harmonic potential on {} of {:g} m, which walls draw off at {:g} of what a free neighbour does: it has no local minimum but the goal.",
                                              counted(field.unknowns(), "free cell"), frame_.cell, options.field.absorption)};
    PlanningResult plan = finished_plan(space_, rounded_path(space_, ends->start, thinned_way(space_, without_stubs(space_, std::move(points), stub_of_cell * frame_.cell), thinning * frame_.cell), ends->goal), ends->start, ends->goal, std::move(text), budget);
    if (plan) plan->field = harmonic_drawing(shared);
    return plan;
  }

 private:
  static tl::expected<GridFrame, std::string> frame_of(const Problem& problem, double resolution) {
    auto frame = make_grid_frame(problem, resolution);
    if (!frame) return frame;
    const auto cells = [&] { return static_cast<std::int64_t>(frame->columns) * frame->rows; };
    // Coarser until there are few enough, where nobody told.
    for (double cell = frame ? 1.25 * frame->cell : 0.0; resolution == 0.0 && frame && cells() > usual_cells; cell *= 1.25) frame = make_grid_frame(problem, cell);
    if (frame && cells() > most_cells)
      return tl::unexpected{fmt::format("{} x {} cells of {:g} m are {}, and at most {} are solved for: give a coarser resolution", frame->columns, frame->rows, frame->cell, cells(), most_cells)};
    return frame;
  }

  /// Up w from a node: along its slope by half a cell at a time where that leads up and is free, else from node to node. Once nodes had to be gone back to they are kept to.
  std::vector<Vec2> streamline(const HarmonicField& field, const std::vector<Cell>& goals, Cell first) const {
    std::vector<Vec2> points{frame_.centre(first)};
    const auto is_goal = [&](Cell c) { return std::find(goals.begin(), goals.end(), c) != goals.end(); };
    Cell node = first;
    std::size_t at_node = 1;  // points up to that node
    bool follows = true;
    const double step = step_of_cell * frame_.cell;
    while (!is_goal(node)) {
      if (follows) {
        const Vec2 q = points.back();
        const HarmonicField::Value here = field.at(q);
        const double steep = norm(here.gradient);
        if (steep > 0.0 && std::isfinite(steep)) {
          const Vec2 next = q + (step / steep) * here.gradient;
          if (field.at(next).w > here.w && space_.is_free(q, next)) {
            points.push_back(next);
            // Near a goal's middle that is seen the way is over.
            const auto there = std::find_if(goals.begin(), goals.end(), [&](Cell c) { return distance(frame_.centre(c), next) < frame_.cell && space_.is_free(next, frame_.centre(c)); });
            if (there != goals.end()) {
              points.push_back(frame_.centre(*there));
              return points;
            }
            continue;
          }
        }
        if (auto corner = seen_corner(field, q, here.w)) {
          points.push_back(frame_.centre(*corner));
          node = *corner;
          at_node = points.size();
        } else {
          points.resize(at_node);
          follows = false;
        }
        if (is_goal(node)) break;
      }
      Cell best = node;
      for (const Cell to : {Cell{node.column + 1, node.row}, Cell{node.column - 1, node.row}, Cell{node.column, node.row + 1}, Cell{node.column, node.row - 1}}) {
        if (field.at(to) > field.at(best) && field.may_drive(node, to)) best = to;
      }
      if (best == node) break;  // cannot be, by the field's law
      node = best;
      points.push_back(frame_.centre(node));
      at_node = points.size();
    }
    return points;
  }

  /// Of the four nodes around a place the one of greatest w, where that is over `w` and seen.
  std::optional<Cell> seen_corner(const HarmonicField& field, Vec2 q, double w) const {
    const Vec2 in = frame_.in_cells(q) - Vec2{0.5, 0.5};
    std::optional<Cell> best;
    for (const double dy : {0.0, 1.0}) {
      for (const double dx : {0.0, 1.0}) {
        const Cell c{static_cast<int>(std::floor(in.x) + dx), static_cast<int>(std::floor(in.y) + dy)};
        if (field.at(c) > (best ? field.at(*best) : w) && space_.is_free(q, frame_.centre(c))) best = c;
      }
    }
    return best;
  }

  PlaneSpace space_;
  GridFrame frame_;
  std::string refused_;
};

HarmonicPlanner HarmonicPlanner::prepared(const Problem& problem) const {
  HarmonicPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult HarmonicPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, budget);
  return Ready{problem, options_}.plan(options_, budget);
}

PlannerDescription harmonic_description() {
  const HarmonicOptions defaults;
  PlannerDescription d{"harmonic",
                       "along a streamline of a potential without local minima, on any map; of a disc, or the disc around the footprint",
                       {{.name = "resolution", .default_value = defaults.resolution, .summary = "of the cells; 0: as fine as a hundred thousand cells allow, the map's own or 0.05 m at least", .unit = "m", .low = 0, .high = 100},
                        {.name = "absorption", .default_value = defaults.field.absorption, .summary = "how much walls draw off: 1 as published; less goes nearer to walls and fades more slowly", .low = 1e-4, .high = 1}},
                       [](const Parameters& p, std::uint64_t) -> AnyPlanner {
                         HarmonicOptions o;
                         o.resolution = number_of(p, "resolution");
                         o.field.absorption = number_of(p, "absorption");
                         return HarmonicPlanner{o};
                       }};
  d.takes_free_goals = true;
  d.turns_on_the_spot = true;
  d.counts_expansions = true;
  return d;
}

}  // namespace waywright
