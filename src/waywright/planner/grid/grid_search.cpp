#include "waywright/planner/grid/grid_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/planner/grid/heuristic_rest.hpp"
#include "waywright/planner/grid/lanes/kernels.hpp"
#include "waywright/planner/grid/search_core.hpp"

namespace waywright {
namespace {

using grid::Terminal;

constexpr std::uint32_t pack(int column, int row) { return static_cast<std::uint32_t>(row) << 16 | static_cast<std::uint32_t>(column); }
constexpr Cell unpack(std::uint32_t state) { return {static_cast<int>(state & 0xFFFF), static_cast<int>(state >> 16)}; }

/// The two that most searches have are compiled each on its own; `others` looks which it is.
enum class Kind { free_way, none, others };

/// The graph as the search sees it.
template <Kind kind, Neighbours neighbours, bool has_danger, bool asks, bool has_zones = false>
class Space {
 public:
  Space(const GridGraph& graph, const MoveWeights& weights, const GridQuery& query, const std::vector<Terminal>& targets)
      : graph_{graph}, query_{query}, all_weights_{weights}, rest_{neighbours, weights, kind == Kind::free_way ? Heuristic::free_way : query.heuristic, has_zones ? graph.zones().least_factor() : 1.0}, width_{static_cast<std::uint32_t>(graph.columns())}, free_{graph.free_moves().data()},
        asked_{graph.asked_moves().data()}, danger_{graph.danger().data()} {
    std::vector<std::pair<Cell, std::uint32_t>> ends;
    for (const Terminal& t : targets) ends.push_back({unpack(t.state), t.cost});
    rest_.aim_at(ends);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      offsets_[i] = static_cast<std::uint32_t>(moves[i].row * 65536 + moves[i].column);
      lattice_.weight[i] = weights.of(static_cast<int>(i));
      lattice_.column[i] = moves[i].column;
      lattice_.row[i] = moves[i].row;
      cells_[i] = moves[i].row * static_cast<std::ptrdiff_t>(width_) + moves[i].column;
    }
    lattice_.width = width_;
    lattice_.danger = has_danger ? danger_ : nullptr;
    if constexpr (kind == Kind::free_way) {
      const std::array<WayTerm, 2> terms = free_way_terms(neighbours, weights);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        lattice_.most[k] = terms[k].most;
        lattice_.least[k] = terms[k].least;
      }
      lattice_.less = rest_.less();
    }
    leaves_at_once_ = (static_cast<std::uint64_t>(graph.most_danger()) * 2 + 511) * weights.most(neighbours) <= std::numeric_limits<std::uint32_t>::max();
  }

  std::size_t size() const { return graph_.cells(); }
  std::size_t margin() const { return graph_.margin(); }
  std::size_t index(std::uint32_t state) const { return static_cast<std::size_t>(state >> 16) * width_ + (state & 0xFFFF); }
  std::uint32_t rest(std::uint32_t state) const {
    if constexpr (kind == Kind::none) return 0;
    if constexpr (kind == Kind::free_way) return rest_.template at_free_way<neighbours>(unpack(state));
    return rest_.at(unpack(state));
  }
  bool may_be_target(std::uint32_t state) const { return rest_.may_be_end(unpack(state)); }
  std::uint64_t most_cost() const {
    const std::uint64_t cost = static_cast<std::uint64_t>(all_weights_.knight) * (256 + graph_.most_danger()) / 256 + 1;
    if constexpr (has_zones) return static_cast<std::uint64_t>(std::ceil(static_cast<double>(cost) * graph_.zones().most_factor())) + 1;
    return cost;
  }
  std::uint64_t most_rest() const {
    return static_cast<std::uint64_t>(graph_.columns() + graph_.rows()) * all_weights_.scale;  // manhattan is the greatest
  }
  std::uint32_t bucket_width() const {
    if constexpr (has_zones) {
      constexpr std::uint64_t most_buckets = 1U << 18;
      return std::bit_floor(static_cast<std::uint32_t>(std::min<std::uint64_t>(1U << 31, std::max<std::uint64_t>({1, all_weights_.scale / 16, 4 * most_cost() / most_buckets}))));
    }
    return std::bit_floor(std::max(1U, all_weights_.scale / 16));
  }

  template <class Reach>
  void expand(std::uint32_t state, std::uint32_t cost_here, const grid::Reached& reached, Reach&& reach) const {
    const std::size_t here = index(state);
    unsigned left = free_[here];
    if constexpr (asks) {
      for (unsigned doubtful = asked_[here]; doubtful != 0; doubtful &= doubtful - 1) {
        const int i = __builtin_ctz(doubtful);
        if (query_.is_free(unpack(state), i)) left |= 1U << i;
      }
    }
    if constexpr (may_leave_at_once) {
      if (leaves_at_once_) {
        const Cell at = unpack(state);
        const Cell middle = rest_.middle();
        move_lanes::Arrivals arrivals;
        const move_lanes::From from{reached.keys() + here, static_cast<std::ptrdiff_t>(here), cost_here, reached.base(), at.column - middle.column, at.row - middle.row, left};
        for (left = leave_(lattice_, from, arrivals); left != 0; left &= left - 1) {
          const auto i = static_cast<std::size_t>(__builtin_ctz(left));
          reach(state + offsets_[i], static_cast<std::size_t>(static_cast<std::ptrdiff_t>(here) + cells_[i]), arrivals.cost[i], arrivals.bound[i], arrivals.bound[i] - arrivals.cost[i], static_cast<int>(i));
        }
        return;
      }
    }
    for (; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left));
      const auto there = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(here) + cells_[i]);
      std::uint32_t cost = lattice_.weight[i];
      if constexpr (has_danger) {
        const std::uint32_t both = static_cast<std::uint32_t>(danger_[here]) + danger_[there];
        cost += static_cast<std::uint32_t>((static_cast<std::uint64_t>(cost) * both) >> 9);
      }
      // Rounded up, so that a sum is never under what the heuristic expects; less than rounding is nothing.
      if constexpr (has_zones) cost = static_cast<std::uint32_t>(std::ceil(cost * graph_.zones().factor(here, static_cast<int>(i)) - 1e-9));
      const std::uint32_t sum = cost_here + cost;
      if (!reached.is_better(there, sum)) continue;
      const std::uint32_t next = state + offsets_[i], more = rest(next);
      reach(next, there, sum, static_cast<std::uint64_t>(sum) + more, more, static_cast<int>(i));
    }
  }

 private:
  const GridGraph& graph_;
  const GridQuery& query_;
  MoveWeights all_weights_;
  HeuristicRest rest_;
  std::uint32_t width_;
  const std::uint16_t* free_;
  const std::uint16_t* asked_;
  const std::uint16_t* danger_;
  static constexpr bool may_leave_at_once = neighbours == Neighbours::sixteen && kind != Kind::others && !has_zones;  // fewer moves are as quick one by one
  bool leaves_at_once_ = false;
  move_lanes::Lattice lattice_;
  decltype(move_lanes::Kernels::leave) leave_ = move_lanes::best().leave;
  std::array<std::uint32_t, all_moves> offsets_{};
  std::array<std::ptrdiff_t, all_moves> cells_{};
};

std::vector<Terminal> terminals(const std::vector<GridEnd>& ends, const MoveWeights& weights) {
  std::vector<Terminal> all;
  for (const GridEnd& e : ends) all.push_back({pack(e.cell.column, e.cell.row), rounded_cost(e.length * weights.scale)});
  return all;
}

/// Back from the target, by the moves that led to each cell.
template <class Queue>
void trace(const GridGraph& graph, const grid::Memory<Queue>& memory, std::uint32_t target, GridAnswer& answer) {
  Cell at = unpack(target);
  for (;;) {
    answer.cells.push_back(at);
    const grid::CameBy came_by = memory.reached.came_by(graph.index(at));
    if (came_by == grid::CameBy::nothing) break;  // one of the starts
    const auto move = static_cast<std::size_t>(came_by);
    answer.counts.add(static_cast<int>(move));
    const Move m = moves[move];
    at = {at.column - m.column, at.row - m.row};
  }
  std::reverse(answer.cells.begin(), answer.cells.end());
}

}  // namespace

struct GridSearch::State {
  grid::Memory<grid::BucketQueue> buckets;
  grid::Memory<grid::OrderedQueue> ordered;

  template <class Queue>
  grid::Memory<Queue>& memory() {
    if constexpr (std::is_same_v<Queue, grid::BucketQueue>) return buckets;
    else return ordered;
  }

  template <Kind kind, Neighbours neighbours, bool has_danger, bool asks, class Queue, bool has_zones = false>
  GridAnswer run(const GridGraph& graph, const GridQuery& query) {
    GridAnswer answer;
    const std::int64_t most = query.expansions.value_or(std::numeric_limits<std::int64_t>::max());
    const auto stop = [&]() -> std::optional<grid::Ended> {
      if (query.budget == nullptr || !query.budget->exhausted()) return std::nullopt;
      return query.budget->canceled() ? grid::Ended::canceled : grid::Ended::time;
    };
    for (int level = 0; level < weight_levels; ++level) {
      const MoveWeights weights = move_weights(neighbours, level);
      const std::vector<Terminal> starts = terminals(query.starts, weights), targets = terminals(query.goals, weights);
      Space<kind, neighbours, has_danger, asks, has_zones> space{graph, weights, query, targets};
      const grid::Outcome outcome = grid::search(space, memory<Queue>(), starts, targets, most - answer.expansions, stop);
      answer.expansions += outcome.expansions;
      switch (outcome.ended) {
        case grid::Ended::overflow: answer.ended = SearchEnd::too_long; continue;
        case grid::Ended::exhausted: answer.ended = SearchEnd::unreachable; break;
        case grid::Ended::expansions: answer.ended = SearchEnd::expansions; break;
        case grid::Ended::time: answer.ended = SearchEnd::timed_out; break;
        case grid::Ended::canceled: answer.ended = SearchEnd::canceled; break;
        case grid::Ended::found:
          answer.ended = SearchEnd::found;
          trace(graph, memory<Queue>(), outcome.target, answer);
          answer.cost = static_cast<double>(outcome.cost) / weights.scale;
          answer.error = 2.0 * ((weights.error() * (has_zones ? graph.zones().most_factor() : 1.0) + (has_zones ? 1.0 / weights.scale : 0.0) + (has_danger ? 1.0 / weights.scale : 0.0)) * static_cast<double>(answer.cells.size()) + 1.0 / weights.scale);
          break;
      }
      break;
    }
    return answer;
  }

  template <Kind kind, Neighbours neighbours, class Queue>
  GridAnswer with_graph(const GridGraph& graph, const GridQuery& query) {
    const bool danger = !graph.danger().empty(), asks = !graph.asked_moves().empty();
    if (graph.zones().weighs()) {
      constexpr Kind any = Kind::others;
      if (danger) return asks ? run<any, neighbours, true, true, Queue, true>(graph, query) : run<any, neighbours, true, false, Queue, true>(graph, query);
      return asks ? run<any, neighbours, false, true, Queue, true>(graph, query) : run<any, neighbours, false, false, Queue, true>(graph, query);
    }
    if (danger) return asks ? run<kind, neighbours, true, true, Queue>(graph, query) : run<kind, neighbours, true, false, Queue>(graph, query);
    return asks ? run<kind, neighbours, false, true, Queue>(graph, query) : run<kind, neighbours, false, false, Queue>(graph, query);
  }

  template <Neighbours neighbours>
  GridAnswer with_order(const GridGraph& graph, const GridQuery& query) {
    if (query.order == SearchOrder::published) return with_graph<Kind::others, neighbours, grid::OrderedQueue>(graph, query);
    if (query.heuristic == Heuristic::free_way) return with_graph<Kind::free_way, neighbours, grid::BucketQueue>(graph, query);
    if (query.heuristic == Heuristic::none) return with_graph<Kind::none, neighbours, grid::BucketQueue>(graph, query);
    return with_graph<Kind::others, neighbours, grid::BucketQueue>(graph, query);
  }
};

GridSearch::GridSearch() : state_{std::make_unique<State>()} {}
GridSearch::~GridSearch() = default;
GridSearch::GridSearch(GridSearch&&) noexcept = default;
GridSearch& GridSearch::operator=(GridSearch&&) noexcept = default;

GridAnswer GridSearch::run(const GridGraph& graph, const GridQuery& query) {
  const bool connected = std::any_of(query.starts.begin(), query.starts.end(), [&](const GridEnd& s) {
    return std::any_of(query.goals.begin(), query.goals.end(), [&](const GridEnd& g) { return graph.may_be_connected(s.cell, g.cell); });
  });
  if (!connected) {
    GridAnswer answer;
    answer.known_at_once = true;
    return answer;
  }
  switch (graph.neighbours()) {
    case Neighbours::four: return state_->with_order<Neighbours::four>(graph, query);
    case Neighbours::eight: return state_->with_order<Neighbours::eight>(graph, query);
    case Neighbours::sixteen: return state_->with_order<Neighbours::sixteen>(graph, query);
  }
  return {};
}

}  // namespace waywright
