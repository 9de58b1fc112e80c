#include "waywright/planner/tree/kept_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

namespace waywright {
namespace {

constexpr std::uint32_t none = PlaneTree::none;
constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr double worth = 1e-9;  // m, that a way has to be shorter by

bool meet(const Box& box, Vec2 a, Vec2 b) {
  return std::min(a.x, b.x) <= box.high.x && std::max(a.x, b.x) >= box.low.x && std::min(a.y, b.y) <= box.high.y && std::max(a.y, b.y) >= box.low.y;
}

/// The work on one tree: nodes as they were, and the new root behind them.
class Upkeep {
 public:
  Upkeep(std::vector<PlaneTree::KeptNode> nodes, const PlaneSpace& space, const World& appeared, Vec2 root, double radius, const PlaneTarget& goal, KeptTreeStatistics& statistics)
      : nodes_{std::move(nodes)}, space_{space}, appeared_{appeared}, radius_{radius}, goal_{goal}, statistics_{statistics}, root_{static_cast<std::uint32_t>(nodes_.size())} {
    nodes_.push_back({root, none});
    const Box known = appeared.empty() ? Box{{1.0, 1.0}, {0.0, 0.0}} : appeared.bounds();
    const Vec2 room{space.needed(), space.needed()};
    near_ = {known.low - room, known.high + room};
    has_new_ = !appeared.empty();
    bins_.clear(space.region());
    for (const PlaneTree::KeptNode& n : nodes_) bins_.add(n.at);
    cost_.assign(nodes_.size(), unreached);
    parent_.assign(nodes_.size(), none);
    kept_.resize(nodes_.size());
  }

  void run() {
    cut();
    spread_from_root();
    reattach();
    look_for_goal();
    rewire();
  }

  /// The root first, each node after its parent.
  void write(std::vector<PlaneTree::KeptNode>& nodes, std::vector<double>& costs) const {
    std::vector<std::vector<std::uint32_t>> children(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (parent_[i] != none) children[parent_[i]].push_back(i);
    }
    std::vector<std::uint32_t> order{root_}, place(nodes_.size(), none);
    nodes.clear();
    costs.clear();
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint32_t at = order[k];
      place[at] = static_cast<std::uint32_t>(k);
      const bool is_root = at == root_;
      nodes.push_back({nodes_[at].at, is_root ? none : place[parent_[at]]});
      costs.push_back(is_root ? 0.0 : costs[place[parent_[at]]] + length(parent_[at], at));
      order.insert(order.end(), children[at].begin(), children[at].end());
    }
  }

 private:
  double length(std::uint32_t a, std::uint32_t b) const { return distance(nodes_[a].at, nodes_[b].at); }
  bool is_clear_of_new(Vec2 a, Vec2 b) const {
    if (!has_new_ || !meet(near_, a, b)) return true;
    const std::array<Vec2, 2> ends{a, b};
    return appeared_.is_free(std::span{ends.data(), a == b ? 1U : 2U}, space_.needed());
  }
  bool is_line_free(std::uint32_t a, std::uint32_t b) {
    ++statistics_.lines;
    return space_.is_free(nodes_[a].at, nodes_[b].at);
  }

  /// Edges that are left, of each node to all that it hung together with.
  void cut() {
    for (std::uint32_t i = 0; i < root_; ++i) {
      const std::uint32_t p = nodes_[i].parent;
      if (p == none) continue;
      statistics_.near += has_new_ && meet(near_, nodes_[p].at, nodes_[i].at) ? 1 : 0;
      if (!is_clear_of_new(nodes_[p].at, nodes_[i].at)) {
        ++statistics_.cut;
        continue;
      }
      kept_[p].push_back(i);
      kept_[i].push_back(p);
    }
  }

  using Entry = std::pair<double, std::uint32_t>;
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

  void reach(std::uint32_t node, std::uint32_t parent, double cost, Queue& queue) {
    cost_[node] = cost;
    parent_[node] = parent;
    queue.emplace(cost, node);
  }
  /// Along edges that are left, which need no test.
  void spread(Queue& queue) {
    while (!queue.empty()) {
      const auto [cost, at] = queue.top();
      queue.pop();
      if (cost > cost_[at]) continue;
      for (const std::uint32_t n : kept_[at]) {
        const double through = cost + length(at, n);
        if (through < cost_[n]) reach(n, at, through, queue);
      }
    }
  }
  void spread_from_root() {
    cost_[root_] = 0.0;
    bins_.within(nodes_[root_].at, radius_, found_);
    if (found_.size() < 2) {  // itself alone
      std::uint32_t nearest = none;
      for (std::uint32_t i = 0; i < root_; ++i) {
        if (nearest == none || length(root_, i) < length(root_, nearest)) nearest = i;
      }
      if (nearest != none) found_.push_back({0.0, nearest});
    }
    Queue queue;
    for (const PointBins::Near& n : found_) {
      if (n.index == root_ || !is_line_free(root_, n.index)) continue;
      kept_[root_].push_back(n.index);
      kept_[n.index].push_back(root_);
      reach(n.index, root_, length(root_, n.index), queue);
    }
    spread(queue);
  }

  /// The cheapest line first, whoever's it is; what hangs on a node that is reached comes with it. An orphan stands in the queue with the cheapest way that is known to it.
  void reattach() {
    std::vector<bool> is_orphan(nodes_.size(), false);
    std::vector<double> known(nodes_.size(), unreached);
    std::vector<std::vector<std::uint32_t>> blocked(nodes_.size());  // by whom it has been looked for in vain
    Queue queue;
    const auto offer = [&](std::uint32_t orphan, double cost) {
      if (cost >= known[orphan]) return;
      known[orphan] = cost;
      queue.emplace(cost, orphan);
    };
    for (std::uint32_t i = 0; i < root_; ++i) {
      if (cost_[i] != unreached) continue;
      ++statistics_.orphans;
      is_orphan[i] = is_clear_of_new(nodes_[i].at, nodes_[i].at);
      if (!is_orphan[i]) continue;
      bins_.within(nodes_[i].at, radius_, found_);
      double least = unreached;
      for (const PointBins::Near& n : found_) {
        if (cost_[n.index] != unreached) least = std::min(least, cost_[n.index] + std::sqrt(n.squared));
      }
      if (least != unreached) offer(i, least);
    }
    std::vector<std::uint32_t> reached;
    while (!queue.empty()) {
      const auto [cost, node] = queue.top();
      queue.pop();
      if (cost_[node] != unreached || cost > known[node]) continue;
      bins_.within(nodes_[node].at, radius_, found_);
      std::uint32_t by = none, next = none;
      double through = unreached, then = unreached;
      std::vector<std::uint32_t>& in_vain = blocked[node];
      for (const PointBins::Near& n : found_) {
        if (cost_[n.index] == unreached || std::find(in_vain.begin(), in_vain.end(), n.index) != in_vain.end()) continue;
        const double by_it = cost_[n.index] + length(n.index, node);
        if (by_it < through || (by_it == through && n.index < by)) {
          then = through;
          next = by;
          through = by_it;
          by = n.index;
        } else if (by_it < then) {
          then = by_it;
          next = n.index;
        }
      }
      if (by == none) continue;
      if (!is_line_free(by, node)) {
        in_vain.push_back(by);
        known[node] = unreached;
        if (next != none) offer(node, then);
        continue;
      }
      reached.assign(1, node);
      cost_[node] = through;
      parent_[node] = by;
      for (std::size_t k = 0; k < reached.size(); ++k) {
        ++statistics_.reattached;
        touched_.push_back(reached[k]);
        for (const std::uint32_t n : kept_[reached[k]]) {
          if (cost_[n] != unreached) continue;
          cost_[n] = cost_[reached[k]] + length(reached[k], n);
          parent_[n] = reached[k];
          reached.push_back(n);
        }
      }
      for (const std::uint32_t n : reached) {
        bins_.within(nodes_[n].at, radius_, found_);
        for (const PointBins::Near& o : found_) {
          if (is_orphan[o.index] && cost_[o.index] == unreached) offer(o.index, cost_[n] + std::sqrt(o.squared));
        }
      }
    }
  }

  double to_goal(std::uint32_t node) const { return distance(nodes_[node].at, goal_.nearest(nodes_[node].at)); }
  /// Who sees the goal, of those that are near it: the best way so far, that others have to beat.
  void look_for_goal() {
    sees_goal_.assign(nodes_.size(), false);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const double left = to_goal(i);
      if (cost_[i] == unreached || left > radius_) continue;
      if (left > 0.0) {
        ++statistics_.lines;
        if (!space_.is_free(nodes_[i].at, goal_.nearest(nodes_[i].at))) continue;
      }
      sees_goal_[i] = true;
      best_ = std::min(best_, cost_[i] + left);
    }
  }
  void improve(std::uint32_t node, double cost) {
    cost_[node] = cost;
    if (sees_goal_[node]) best_ = std::min(best_, cost + to_goal(node));
  }

  /// From the root and from what found another parent outwards, as far as ways get shorter.
  void rewire() {
    std::vector<std::vector<std::uint32_t>> children(nodes_.size());
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (parent_[i] != none) children[parent_[i]].push_back(i);
    }
    Queue queue;
    queue.emplace(0.0, root_);
    for (const std::uint32_t child : children[root_]) queue.emplace(cost_[child], child);
    for (const std::uint32_t node : touched_) queue.emplace(cost_[node], node);
    while (!queue.empty()) {
      const auto [cost, at] = queue.top();
      queue.pop();
      if (cost > cost_[at]) continue;
      for (const std::uint32_t child : children[at]) {
        const double through = cost_[at] + length(at, child);
        if (through >= cost_[child]) continue;
        improve(child, through);
        queue.emplace(through, child);
      }
      if (cost_[at] + to_goal(at) >= best_) continue;
      bins_.within(nodes_[at].at, radius_, found_);
      for (const PointBins::Near& n : found_) {
        const std::uint32_t other = n.index;
        if (other == root_ || cost_[other] == unreached) continue;
        const double through = cost_[at] + length(at, other);
        if (!(through < cost_[other] - worth) || through + to_goal(other) >= best_ || !is_line_free(at, other)) continue;
        ++statistics_.rewired;
        std::vector<std::uint32_t>& siblings = children[parent_[other]];
        siblings.erase(std::find(siblings.begin(), siblings.end(), other));
        children[at].push_back(other);
        parent_[other] = at;
        improve(other, through);
        queue.emplace(through, other);
      }
    }
  }

  std::vector<PlaneTree::KeptNode> nodes_;
  const PlaneSpace& space_;
  const World& appeared_;
  double radius_;
  const PlaneTarget& goal_;
  KeptTreeStatistics& statistics_;
  std::uint32_t root_;
  Box near_{};
  bool has_new_ = false;
  PointBins bins_;
  std::vector<double> cost_;
  std::vector<bool> sees_goal_;
  double best_ = unreached;  // m, of a way to the goal
  std::vector<std::uint32_t> parent_;
  std::vector<std::vector<std::uint32_t>> kept_;
  std::vector<std::uint32_t> touched_;
  std::vector<PointBins::Near> found_;
};

}  // namespace

void KeptTree::take(const PlaneTree& tree) {
  nodes_.clear();
  costs_.clear();
  for (std::uint32_t i = 0; i < tree.size(); ++i) {
    nodes_.push_back({tree.place(i), tree.parent(i)});
    costs_.push_back(tree.cost(i));
  }
}

bool KeptTree::carry_over(const PlaneSpace& space, const World& appeared, Vec2 root, double radius, const PlaneTarget& goal) {
  statistics_ = {};
  statistics_.nodes = static_cast<std::int64_t>(nodes_.size());
  Upkeep upkeep{std::move(nodes_), space, appeared, root, radius, goal, statistics_};
  upkeep.run();
  upkeep.write(nodes_, costs_);
  statistics_.kept = static_cast<std::int64_t>(nodes_.size());
  return nodes_.size() > 1;
}

void PlaneTree::take_over() {
  for (std::size_t i = 1; i < kept_->size(); ++i) {
    const KeptNode& kept = (*kept_)[i];
    const std::uint32_t node = add(kept.at, space_->room(kept.at));
    hang(node, kept.parent, distance(bins_[kept.parent], kept.at));
    look_for_goal(node);
  }
}

void PlaneTree::grow_on(const std::vector<KeptNode>& kept, const PlaneSpace& space, const PlaneTreeOptions& options, const PlaneTarget& goal, std::uint64_t seed, Budget& budget, std::int64_t edges,
                        TreeSteering* steering) {
  kept_ = &kept;
  grow(space, options, kept.front().at, goal, seed, budget, edges, steering);
  kept_ = nullptr;
}

}  // namespace waywright
