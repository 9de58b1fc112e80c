#include "waywright/planner/state_lattice/lattice_search.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <queue>

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr int directions = 3;  // of arrival: none yet, forward, backward
constexpr std::size_t most_open = 30'000'000;  // motions that wait, about 1.5 GB
constexpr std::uint32_t states_a_cell = lattice_headings * directions;

/// Of one state. Memory comes in blocks, as the search spreads.
struct Node {
  double cost = infinity;
  std::uint32_t parent = none;
  std::uint16_t primitive = 0;
  bool is_closed = false;
};

class Nodes {
 public:
  explicit Nodes(std::size_t cells) : blocks_((cells + block - 1) / block) {}
  Node& at(std::uint32_t state) {
    const std::uint32_t cell = state / states_a_cell;
    auto& b = blocks_[cell / block];
    if (!b) b = std::make_unique<Node[]>(block * states_a_cell);
    return b[cell % block * states_a_cell + state % states_a_cell];
  }

 private:
  static constexpr std::uint32_t block = 16;  // cells
  std::vector<std::unique_ptr<Node[]>> blocks_;
};

/// A motion that the search may take, or has evaluated.
struct Entry {
  double estimate = 0.0;  // cost up to its end and the rest from there, the rest stretched
  double cost = 0.0;      // up to its end; a lower bound until evaluated
  std::uint32_t from = none;
  std::uint32_t to = none;      // state; none: the goal
  std::uint32_t motion = 0;     // primitive, or motion into the goal
  std::uint64_t order = 0;      // of entering: ties are settled the same way each time
  bool is_evaluated = false;
  friend bool operator<(const Entry& a, const Entry& b) { return a.estimate != b.estimate ? a.estimate > b.estimate : a.order < b.order; }
};

class Search {
 public:
  Search(const LatticeGraph& graph, const LatticeRest& rest, MotionCost& cost, double gap, Budget& budget)
      : graph_{graph}, rest_{rest}, cost_{cost}, stretch_{1.0 + gap}, budget_{budget}, nodes_{graph.cells()} {}

  LatticeAnswer run() {
    start_ = graph_.start_cell() * states_a_cell;
    Node& first = nodes_.at(start_);
    first.cost = 0.0;
    first.is_closed = true;
    expand(start_);
    const auto& most = budget_.limits().expansions;
    while (!open_.empty()) {
      const Entry top = open_.top();
      open_.pop();
      if (top.to != none && nodes_.at(top.to).is_closed) continue;
      if (!top.is_evaluated) {
        if (++answer_.motions % 64 == 0 && budget_.exhausted()) return ended(budget_.canceled() ? LatticeAnswer::End::canceled : LatticeAnswer::End::timed_out, top);
        evaluate(top);
        continue;
      }
      if (top.to == none) return found(top);
      if (open_.size() > most_open) return ended(LatticeAnswer::End::too_many, top);
      if (most && answer_.expansions >= *most) return ended(LatticeAnswer::End::out_of_budget, top);
      Node& node = nodes_.at(top.to);
      node = {top.cost, top.from, static_cast<std::uint16_t>(top.motion), true};
      expand(top.to);
    }
    return answer_;
  }

 private:
  static std::uint32_t cell_of(std::uint32_t state) { return state / states_a_cell; }
  static int heading_of(std::uint32_t state) { return static_cast<int>(state % states_a_cell / directions); }
  /// 0: it has only turned on the spot.
  static int direction_of(std::uint32_t state) { return state % directions == 0 ? 0 : state % directions == 1 ? 1 : -1; }
  static std::uint32_t state(std::uint32_t cell, int heading, int direction) {
    return cell * states_a_cell + static_cast<std::uint32_t>(heading) * directions + (direction == 0 ? 0U : direction > 0 ? 1U : 2U);
  }

  /// What it costs to go on this way.
  double changing(std::uint32_t from, int direction) const { return direction_of(from) == 0 || direction == 0 || direction == direction_of(from) ? 0.0 : cost_.costs().change; }

  void push(Entry e, std::uint32_t cell_at_end) {
    e.order = entered_++;
    e.estimate = e.cost + (e.to == none ? 0.0 : stretch_ * rest_(cell_at_end));
    if (e.estimate < infinity) open_.push(e);
  }

  void expand(std::uint32_t at) {
    ++answer_.expansions;
    const std::uint32_t cell = cell_of(at);
    const int heading = heading_of(at);
    const double so_far = nodes_.at(at).cost;
    const auto& primitives = graph_.primitives()[static_cast<std::size_t>(heading)];
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
      const MotionPrimitive& p = primitives[i];
      const int direction = p.stretch.direction;
      const auto there = graph_.moved(cell, p.step);
      if (!there) continue;
      const std::uint32_t to = state(*there, p.to, direction == 0 ? direction_of(at) : direction);
      const double least = rest_.motion_at_least(cell, *there, p);
      const double cost = so_far + changing(at, direction) + least;
      // Closed, or reached for less by a motion that was looked at.
      if (!(cost < infinity) || nodes_.at(to).cost <= cost) continue;
      push({0.0, cost, at, to, i}, *there);
    }
    const auto [begin, end] = graph_.goal_motions_of(cell);
    for (std::size_t i = begin; i < end; ++i) {
      const GoalMotion& m = graph_.goal_motions()[i];
      if (m.heading == heading) push({0.0, so_far + changing(at, m.direction) + cost_.least_factor() * m.metres, at, none, static_cast<std::uint32_t>(i)}, cell);
    }
  }

  void evaluate(Entry e) {
    const std::uint32_t cell = cell_of(e.from);
    std::optional<double> cost;
    int direction = 0;
    if (e.to == none) {
      const GoalMotion& m = graph_.goal_motions()[e.motion];
      direction = m.direction;
      double sum = 0.0;
      bool is_free = true;
      for (const LatticeStretch& s : m.stretches) {
        const auto one = cost_.of(s, std::min(0.1, graph_.cell()));
        is_free = one.has_value();
        if (!is_free) break;
        sum += *one;
      }
      if (is_free) cost = sum;
    } else {
      const MotionPrimitive& p = graph_.primitives()[static_cast<std::size_t>(heading_of(e.from))][e.motion];
      direction = p.stretch.direction;
      cost = cost_of(cell, p);
    }
    if (!cost) return;
    e.cost = nodes_.at(e.from).cost + changing(e.from, direction) + *cost;
    e.is_evaluated = true;
    if (e.to != none) {
      Node& node = nodes_.at(e.to);
      if (node.cost <= e.cost) return;
      node.cost = e.cost;
    }
    push(e, e.to == none ? 0 : cell_of(e.to));
  }

  std::optional<double> cost_of(std::uint32_t cell, const MotionPrimitive& p) {
    const Vec2 at = graph_.place(cell);
    const bool is_open = graph_.distance_at_least(at + p.middle) - p.reach - cost_.radius() >= cost_.no_danger_from();
    if (is_open && !(cost_.heeds_zones() && cost_.zones_near(at + p.middle, p.reach))) return p.metres;
    return cost_.of(p.poses, at, [&] { return cost_.is_free(graph_.stretch(cell, p)); });
  }

  LatticeAnswer found(const Entry& last) {
    answer_.ended = LatticeAnswer::End::found;
    answer_.cost = last.cost;
    bound(last);
    std::vector<std::vector<LatticeStretch>> backwards{graph_.goal_motions()[last.motion].stretches};
    for (std::uint32_t at = last.from; at != start_; at = nodes_.at(at).parent) {
      const Node& node = nodes_.at(at);
      const MotionPrimitive& p = graph_.primitives()[static_cast<std::size_t>(heading_of(node.parent))][node.primitive];
      backwards.push_back({graph_.stretch(cell_of(node.parent), p)});
    }
    for (auto it = backwards.rbegin(); it != backwards.rend(); ++it) answer_.stretches.insert(answer_.stretches.end(), it->begin(), it->end());
    return answer_;
  }

  LatticeAnswer ended(LatticeAnswer::End how, const Entry& top) {
    answer_.ended = how;
    bound(top);
    return answer_;
  }

  /// The estimate of what comes next is at most so many times what the best way costs (A* with a consistent estimate; Pohl 1970, Likhachev et al. 2003).
  void bound(const Entry& top) { answer_.lower_bound = std::max(top.estimate / stretch_, rest_(graph_.start_cell())); }

  const LatticeGraph& graph_;
  const LatticeRest& rest_;
  MotionCost& cost_;
  double stretch_;
  Budget& budget_;
  Nodes nodes_;
  std::priority_queue<Entry> open_;
  std::uint32_t start_ = 0;
  std::uint64_t entered_ = 0;
  LatticeAnswer answer_;
};

}  // namespace

LatticeAnswer search_lattice(const LatticeGraph& graph, const LatticeRest& rest, MotionCost& cost, double gap, Budget& budget) {
  return Search{graph, rest, cost, gap, budget}.run();
}

}  // namespace waywright
