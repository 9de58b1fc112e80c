#include "waywright/planner/grid/grid_words.hpp"

#include <fmt/format.h>

namespace waywright::grid {

PlanningFailure failure(Status status, std::string reason, std::optional<Pose> pose) {
  PlanningFailure f;
  f.failure.status = status;
  f.failure.reason = std::move(reason);
  f.failure.pose = pose;
  return f;
}

std::string counted(std::int64_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::string place(Vec2 p) { return fmt::format("({:.3f}, {:.3f})", p.x, p.y); }

PlanningFailure nothing_found(SearchEnd ended, bool at_once, std::int64_t expansions, const Budget& budget, double cell, const std::string& what_fits) {
  switch (ended) {
    case SearchEnd::canceled: return failure(Status::canceled, fmt::format("canceled after {}", counted(expansions, "expansion")));
    case SearchEnd::timed_out:
      return failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(expansions, "expansion")));
    case SearchEnd::expansions: return failure(Status::no_path, fmt::format("all {} of its budget were used up before the goal was reached", counted(expansions, "expansion")));
    case SearchEnd::too_long: return failure(Status::no_path, "the way over the cells is longer than costs of 32 bits can tell");
    case SearchEnd::unreachable:
    case SearchEnd::found: break;
  }
  const std::string how = at_once ? "known from the connected parts of the free cells, without a search" : fmt::format("all that can be reached was searched, {}", counted(expansions, "expansion"));
  return failure(Status::no_path, fmt::format("no way over cells of {:g} m leads from start to goal for {}: {}", cell, what_fits, how));
}

bool is_plain_line(const ZoneRules& zones, Vec2 from, Vec2 to) {
  return zones.may_be_driven(from, to) && (!zones.weighs() || zones.cost(from, to) <= distance(from, to) * (1.0 + 1e-12));
}

std::string zone_sentence(const Problem& problem, const Path& path) {
  const ZoneRules& zones = problem.zones_as_planned();
  if (!zones.directs() && !zones.weighs()) return {};
  double metres = 0.0, cost = 0.0;
  for (const Piece& piece : path.pieces) {
    if (const auto* line = std::get_if<Line>(&piece.curve)) {
      metres += distance(line->from, line->to);
      cost += zones.cost(line->from, line->to);
    }
  }
  std::string text;
  if (zones.weighs()) text = fmt::format("Zones weigh: the way's {:.3f} m cost {:.3f} m by the factors of preferred and penalty zones", metres, cost);
  if (zones.directs()) text += text.empty() ? "No move goes against the direction of a directed zone" : "; no move goes against the direction of a directed zone";
  return text + ".";
}

const char* of_neighbours(Neighbours n) {
  return n == Neighbours::four ? "4 neighbours" : n == Neighbours::eight ? "8 neighbours" : "16 neighbours";
}

}  // namespace waywright::grid
