#include "waywright/planner/grid/heading_search.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "waywright/planner/grid/heuristic_rest.hpp"
#include "waywright/planner/grid/search_core.hpp"

namespace waywright {
namespace {

// Packed: heading, row, column.
constexpr std::uint32_t pack(const HeadingState& s) {
  return static_cast<std::uint32_t>(s.heading) << 28 | static_cast<std::uint32_t>(s.cell.row) << 14 | static_cast<std::uint32_t>(s.cell.column);
}
constexpr HeadingState unpack(std::uint32_t state) {
  return {{static_cast<int>(state & 0x3FFF), static_cast<int>(state >> 14 & 0x3FFF)}, static_cast<int>(state >> 28)};
}
static_assert(GridGraph::longest_side <= 1 << 14);

class Space {
 public:
  Space(const HeadingSpace& space, const MoveWeights& weights, Heuristic heuristic, const std::vector<grid::Terminal>& targets, MotionCheck& test)
      : space_{space}, weights_{weights}, test_{test}, rest_{space.neighbours(), weights, heuristic, space.zones().least_factor()} {
    std::vector<std::pair<Cell, std::uint32_t>> ends;
    for (const grid::Terminal& t : targets) ends.push_back({unpack(t.state).cell, t.cost});
    rest_.aim_at(ends);
    for (int h = 0; h < space.headings(); ++h) {
      turns_.push_back(static_cast<std::uint32_t>(std::lround(space.costs().turn * std::abs(space.turn(h)) / space.frame().cell * weights.scale)));
    }
    greatest_turn_ = *std::max_element(turns_.begin(), turns_.end());
  }

  std::size_t size() const {
    return static_cast<std::size_t>(space_.frame().columns) * static_cast<std::size_t>(space_.frame().rows) * static_cast<std::size_t>(space_.headings());
  }
  static std::size_t margin() { return 0; }
  std::size_t index(std::uint32_t state) const {
    const HeadingState s = unpack(state);
    const std::size_t cell = static_cast<std::size_t>(s.cell.row) * static_cast<std::size_t>(space_.frame().columns) + static_cast<std::size_t>(s.cell.column);
    return cell * static_cast<std::size_t>(space_.headings()) + static_cast<std::size_t>(s.heading);
  }
  std::uint32_t rest(std::uint32_t state) const { return rest_.at(unpack(state).cell); }
  bool may_be_target(std::uint32_t state) const { return rest_.may_be_end(unpack(state).cell); }
  std::uint64_t most_cost() const {
    return std::max<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(weights_.knight * std::max(1.0, space_.costs().reverse) * space_.zones().most_factor())), greatest_turn_);
  }
  std::uint64_t most_rest() const { return static_cast<std::uint64_t>(space_.frame().columns + space_.frame().rows) * weights_.scale; }
  std::uint32_t bucket_width() const {
    if (space_.zones().weighs()) {
      constexpr std::uint64_t most_buckets = 1U << 18;
      return std::bit_floor(static_cast<std::uint32_t>(std::min<std::uint64_t>(1U << 31, std::max<std::uint64_t>({1, weights_.scale / 8, 4 * most_cost() / most_buckets}))));
    }
    return std::bit_floor(std::max(1U, weights_.scale / 8));
  }

  template <class Reach>
  void expand(std::uint32_t packed, std::uint32_t cost_here, const grid::Reached& reached, Reach&& reach) const {
    const HeadingState s = unpack(packed);
    const auto to = [&](const HeadingState& next, std::uint32_t cost, HeadingStep step) {
      const std::uint32_t there = pack(next), sum = cost_here + cost;
      const std::size_t at = index(there);
      if (!reached.is_better(at, sum)) return;
      const std::uint32_t left = rest(there);
      reach(there, at, sum, static_cast<std::uint64_t>(sum) + left, left, static_cast<int>(step));
    };
    const int move = space_.move(s.heading);
    const Move m = moves[static_cast<std::size_t>(move)];
    if (space_.is_drive_free(s.cell, s.heading, false, test_)) {
      to({{s.cell.column + m.column, s.cell.row + m.row}, s.heading}, weighed(weights_.of(move), s, false), HeadingStep::forwards);
    }
    if (space_.costs().reverse > 0.0 && space_.is_drive_free(s.cell, s.heading, true, test_)) {
      to({{s.cell.column - m.column, s.cell.row - m.row}, s.heading}, weighed(static_cast<std::uint32_t>(std::lround(weights_.of(move) * space_.costs().reverse)), s, true), HeadingStep::backwards);
    }
    const int previous = space_.beside(s.heading, -1);
    if (space_.is_turn_free(s.cell, s.heading, test_)) {
      to({s.cell, space_.beside(s.heading, 1)}, turns_[static_cast<std::size_t>(s.heading)], HeadingStep::to_next);
    }
    if (space_.is_turn_free(s.cell, previous, test_)) {
      to({s.cell, previous}, turns_[static_cast<std::size_t>(previous)], HeadingStep::to_previous);
    }
  }

 private:
  /// Rounded up, so that a sum is never under what the heuristic expects.
  std::uint32_t weighed(std::uint32_t cost, const HeadingState& from, bool backwards) const {
    return space_.zones().weighs() ? static_cast<std::uint32_t>(std::ceil(cost * space_.factor(from.cell, from.heading, backwards) - 1e-9)) : cost;
  }

  const HeadingSpace& space_;
  MoveWeights weights_;
  MotionCheck& test_;
  HeuristicRest rest_;
  std::vector<std::uint32_t> turns_;
  std::uint32_t greatest_turn_ = 0;
};

std::vector<grid::Terminal> terminals(const std::vector<HeadingEnd>& ends, double cell, const MoveWeights& weights) {
  std::vector<grid::Terminal> all;
  for (const HeadingEnd& e : ends) all.push_back({pack(e.state), rounded_cost(e.cost / cell * weights.scale)});
  return all;
}

}  // namespace

HeadingSpace::HeadingSpace(const Problem& problem, const GridFrame& frame, const CellBounds& bounds, Neighbours neighbours, const HeadingCosts& costs, GridZones zones)
    : frame_{frame}, bounds_{bounds}, neighbours_{neighbours}, costs_{costs}, zones_{std::move(zones)}, headings_{static_cast<int>(neighbours)}, margin_{lattice_margin(problem)},
      outer_{problem.footprint().radius()}, inner_{problem.footprint().inner_radius()} {
  const MotionCheck test{problem};
  std::vector<Vec2> ways;
  for (int h = 0; h < headings_; ++h) {
    const Move m = moves[static_cast<std::size_t>(move(h))];
    ways.push_back(frame.frame.rotate(frame.cell * Vec2{static_cast<double>(m.column), static_cast<double>(-m.row)}));
    angles_.push_back(angle_of(ways.back()));
  }
  for (int h = 0; h < headings_; ++h) {
    turns_.push_back(shorter_turn(angle(h), angle(beside(h, 1))));
    const Vec2 way = ways[static_cast<std::size_t>(h)];
    forwards_.push_back(test.drive_rings(way, angle(h)));
    backwards_.push_back(test.drive_rings(-way, angle(h)));
    turning_.push_back(test.turn_rings(angle(h), turns_.back()));
  }
}

bool HeadingSpace::is_drive_free(Cell from, int heading, bool backwards, MotionCheck& test) const {
  const int i = move(heading);
  const Move m = moves[static_cast<std::size_t>(backwards ? opposite(i) : i)];
  const Cell to{from.column + m.column, from.row + m.row};
  if (!frame_.contains(to)) return false;
  if (!zones_.empty() && zones_.is_against(index_of(from), moved(heading, backwards))) return false;
  const double length = std::sqrt(static_cast<double>(m.column * m.column + m.row * m.row)) * frame_.cell;
  if (bounds_.at_least(from) >= margin_ + outer_ + length) return true;
  if (bounds_.at_most(from) <= margin_ + inner_ || bounds_.at_most(to) <= margin_ + inner_) return false;
  return test.is_free((backwards ? backwards_ : forwards_)[static_cast<std::size_t>(heading)], frame_.centre(from), margin_);
}

bool HeadingSpace::is_turn_free(Cell at, int heading, MotionCheck& test) const {
  if (bounds_.at_least(at) >= margin_ + outer_) return true;
  if (bounds_.at_most(at) <= margin_ + inner_) return false;
  return test.is_free(turning_[static_cast<std::size_t>(heading)], frame_.centre(at), margin_);
}

struct HeadingSearch::State {
  grid::Memory<grid::BucketQueue> memory;
};

HeadingSearch::HeadingSearch() : state_{std::make_unique<State>()} {}
HeadingSearch::~HeadingSearch() = default;
HeadingSearch::HeadingSearch(HeadingSearch&&) noexcept = default;
HeadingSearch& HeadingSearch::operator=(HeadingSearch&&) noexcept = default;

HeadingAnswer HeadingSearch::run(const HeadingSpace& space, const std::vector<HeadingEnd>& starts, const std::vector<HeadingEnd>& goals, Heuristic heuristic,
                                 std::optional<std::int64_t> expansions, Budget* budget, MotionCheck& test) {
  HeadingAnswer answer;
  if (starts.empty() || goals.empty()) return answer;
  const std::int64_t most = expansions.value_or(std::numeric_limits<std::int64_t>::max());
  const auto stop = [&]() -> std::optional<grid::Ended> {
    if (budget == nullptr || !budget->exhausted()) return std::nullopt;
    return budget->canceled() ? grid::Ended::canceled : grid::Ended::time;
  };
  for (int level = 0; level < weight_levels; ++level) {
    const MoveWeights weights = move_weights(space.neighbours(), level);
    const std::vector<grid::Terminal> from = terminals(starts, space.frame().cell, weights), to = terminals(goals, space.frame().cell, weights);
    Space states{space, weights, heuristic, to, test};
    const grid::Outcome outcome = grid::search(states, state_->memory, from, to, most - answer.expansions, stop);
    answer.expansions += outcome.expansions;
    switch (outcome.ended) {
      case grid::Ended::overflow: answer.ended = SearchEnd::too_long; continue;
      case grid::Ended::exhausted: answer.ended = SearchEnd::unreachable; return answer;
      case grid::Ended::expansions: answer.ended = SearchEnd::expansions; return answer;
      case grid::Ended::time: answer.ended = SearchEnd::timed_out; return answer;
      case grid::Ended::canceled: answer.ended = SearchEnd::canceled; return answer;
      case grid::Ended::found: break;
    }
    answer.ended = SearchEnd::found;
    answer.cost = static_cast<double>(outcome.cost) / weights.scale * space.frame().cell;
    answer.last = unpack(outcome.target);
    HeadingState at = answer.last;
    for (;;) {
      const grid::CameBy came_by = state_->memory.reached.came_by(states.index(pack(at)));
      if (came_by == grid::CameBy::nothing) break;
      const auto step = static_cast<HeadingStep>(came_by);
      answer.steps.push_back(step);
      const Move m = moves[static_cast<std::size_t>(space.move(at.heading))];
      if (step == HeadingStep::forwards) at.cell = {at.cell.column - m.column, at.cell.row - m.row};
      if (step == HeadingStep::backwards) at.cell = {at.cell.column + m.column, at.cell.row + m.row};
      if (step == HeadingStep::to_next) at.heading = space.beside(at.heading, -1);
      if (step == HeadingStep::to_previous) at.heading = space.beside(at.heading, 1);
    }
    answer.first = at;
    std::reverse(answer.steps.begin(), answer.steps.end());
    return answer;
  }
  return answer;
}

}  // namespace waywright
