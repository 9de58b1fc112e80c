// A* over a roadmap whose motions are tested when the search takes them (R. Bohlin, L. E. Kavraki: Path planning using lazy PRM, ICRA 2000).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "waywright/core/budget.hpp"

namespace waywright {

enum class RoadmapEnd { found, unreachable, lines, crowded, stopped };

template <class Place>
struct LazyAnswer {
  struct Taken {
    Place from{}, to{};
    std::int64_t tested = 0;  ///< by then
  };
  RoadmapEnd ended = RoadmapEnd::unreachable;
  std::vector<Place> way;      ///< from the start to the goal; where nothing was found, to the place reached that is nearest to the goal
  double length = 0.0;         ///< m, what the way costs
  std::int64_t lines = 0;      ///< motions whose freedom was asked for
  std::int64_t reached = 0;    ///< places, the start among them
  std::vector<Taken> taken;    ///< motions by which places were reached first
};

struct RoadmapNeighbour {
  std::uint32_t index = 0;
  double cost = 0.0;  ///< m, of the motion there
};

struct LazyLimits {
  std::int64_t tested = 0;   ///< motions, at most
  std::size_t waiting = 0;   ///< motions that it keeps in mind; it ends crowded where there are more
};

/// Graph has
///   using Place; std::uint32_t count(); Place place(std::uint32_t); Place start(); Place goal_from(Place);
///   double cost(Place, Place); double least(Place): no way from there to the goal costs less; bool is_free(Place, Place);
///   std::vector<RoadmapNeighbour> from_start(), neighbours(std::uint32_t); std::vector<std::uint32_t> before_goal().
///
/// Law: the way is one of least cost among all whose motions are free and in the graph, or join start and goal, whatever was tested in which order. One entry a motion.
template <class Graph>
class LazySearch {
 public:
  using Place = typename Graph::Place;
  LazySearch(Graph& graph, Budget& budget, const LazyLimits& limits) : graph_{graph}, budget_{budget}, limits_{limits}, count_{graph.count()} {}

  LazyAnswer<Place> run() {
    is_before_goal_.assign(count_, false);
    for (const std::uint32_t i : graph_.before_goal()) is_before_goal_[i] = true;
    parents_.assign(count_ + 2, none);
    costs_.assign(count_ + 2, std::numeric_limits<double>::infinity());
    const std::vector<RoadmapNeighbour> from_start = graph_.from_start();
    settle(start(), none, 0.0);
    for (const RoadmapNeighbour& n : from_start) offer(start(), n);
    const Place first = graph_.start();
    offer(start(), {goal(), graph_.cost(first, graph_.goal_from(first))});  // however far they are apart
    answer_.ended = search();
    const std::uint32_t last = answer_.ended == RoadmapEnd::found ? goal() : nearest_;
    answer_.length = costs_[last];
    for (std::uint32_t i = last; i != none; i = parents_[i]) {
      const Place at = i == goal() ? graph_.goal_from(place(parents_[i])) : place(i);
      if (answer_.way.empty() || answer_.way.back() != at) answer_.way.push_back(at);
    }
    std::reverse(answer_.way.begin(), answer_.way.end());
    return std::move(answer_);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr int clock_every = 32;  // motions
  struct Entry {
    double estimate, cost;
    std::uint32_t node, parent;
    /// Worse ones first, for a queue whose top is the last. In full order: the same whoever compares.
    bool operator<(const Entry& o) const {
      if (estimate != o.estimate) return estimate > o.estimate;
      if (cost != o.cost) return cost < o.cost;
      if (node != o.node) return node > o.node;
      return parent > o.parent;
    }
  };
  std::uint32_t start() const { return count_; }
  std::uint32_t goal() const { return count_ + 1; }
  Place place(std::uint32_t i) const { return i == start() ? graph_.start() : graph_.place(i); }

  void settle(std::uint32_t node, std::uint32_t parent, double cost) {
    parents_[node] = parent;
    costs_[node] = cost;
    if (node == goal()) return;
    ++answer_.reached;
    const double off = graph_.least(place(node));
    if (off >= missing_) return;
    missing_ = off;
    nearest_ = node;
  }

  void offer(std::uint32_t from, const RoadmapNeighbour& to) {
    if (std::isfinite(costs_[to.index])) return;
    const double cost = costs_[from] + to.cost;
    waiting_.push({to.index == goal() ? cost : cost + graph_.least(graph_.place(to.index)), cost, to.index, from});
  }

  RoadmapEnd search() {
    for (std::int64_t step = 0; !waiting_.empty(); ++step) {
      if (step % clock_every == 0 && budget_.exhausted()) return RoadmapEnd::stopped;
      const Entry next = waiting_.top();
      waiting_.pop();
      if (std::isfinite(costs_[next.node])) continue;
      const Place from = place(next.parent), to = next.node == goal() ? graph_.goal_from(from) : graph_.place(next.node);
      if (from != to) {
        if (answer_.lines >= limits_.tested) return RoadmapEnd::lines;
        ++answer_.lines;
        if (!graph_.is_free(from, to)) continue;
      }
      settle(next.node, next.parent, next.cost);
      answer_.taken.push_back({from, to, answer_.lines});
      if (next.node == goal()) return RoadmapEnd::found;
      if (waiting_.size() > limits_.waiting) return RoadmapEnd::crowded;
      if (is_before_goal_[next.node]) offer(next.node, {goal(), graph_.cost(to, graph_.goal_from(to))});
      for (const RoadmapNeighbour& n : graph_.neighbours(next.node)) offer(next.node, n);
    }
    return RoadmapEnd::unreachable;
  }

  Graph& graph_;
  Budget& budget_;
  LazyLimits limits_;
  std::uint32_t count_;
  std::vector<bool> is_before_goal_;
  std::vector<std::uint32_t> parents_;
  std::vector<double> costs_;  // m; +∞: not reached
  std::priority_queue<Entry> waiting_;
  double missing_ = std::numeric_limits<double>::infinity();
  std::uint32_t nearest_ = none;
  LazyAnswer<Place> answer_;
};

}  // namespace waywright
