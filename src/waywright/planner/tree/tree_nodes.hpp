// The nodes of a tree with costs from its root, which are hung elsewhere as it grows.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace waywright {

/// Law: cost(node) = cost(parent) + edge(node) for every node but the first, exactly, whatever was hung elsewhere.
class TreeNodes {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Hung {  ///< a node, on a parent from a step on
    std::uint32_t node, parent, step;
  };

  /// Empty but for the root, node 0.
  void clear() {
    nodes_.assign(1, {});
    costs_.assign(1, 0.0);
    hung_.clear();
  }
  std::uint32_t add(std::uint32_t parent, double edge, std::uint32_t step) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    costs_.push_back(0.0);
    attach(node, parent, edge, step);
    return node;
  }
  /// On another parent, with all that hangs on it. @pre the parent does not hang on it
  void rehang(std::uint32_t node, std::uint32_t parent, double edge, std::uint32_t step) {
    detach(node);
    attach(node, parent, edge, step);
    waiting_.assign(1, node);
    while (!waiting_.empty()) {
      const std::uint32_t at = waiting_.back();
      waiting_.pop_back();
      for (std::uint32_t c = nodes_[at].child; c != none; c = nodes_[c].after) {
        costs_[c] = costs_[at] + nodes_[c].edge;
        waiting_.push_back(c);
      }
    }
  }

  std::size_t size() const { return nodes_.size(); }
  std::uint32_t parent(std::uint32_t node) const { return nodes_[node].parent; }
  double edge(std::uint32_t node) const { return nodes_[node].edge; }
  double cost(std::uint32_t node) const { return costs_[node]; }
  const std::vector<Hung>& hung() const { return hung_; }  ///< in order
  /// From the root to the node.
  std::vector<std::uint32_t> way(std::uint32_t node) const {
    std::vector<std::uint32_t> back;
    for (; node != none; node = nodes_[node].parent) back.push_back(node);
    return {back.rbegin(), back.rend()};
  }

 private:
  struct Node {
    double edge = 0.0;  // from the parent
    std::uint32_t parent = none;
    std::uint32_t child = none, before = none, after = none;  // first child; siblings
  };
  void attach(std::uint32_t node, std::uint32_t parent, double edge, std::uint32_t step) {
    Node& n = nodes_[node];
    Node& p = nodes_[parent];
    n.parent = parent;
    n.edge = edge;
    costs_[node] = costs_[parent] + edge;
    n.before = none;
    n.after = p.child;
    if (p.child != none) nodes_[p.child].before = node;
    p.child = node;
    hung_.push_back({node, parent, step});
  }
  void detach(std::uint32_t node) {
    const Node& n = nodes_[node];
    if (n.before != none) nodes_[n.before].after = n.after;
    else nodes_[n.parent].child = n.after;
    if (n.after != none) nodes_[n.after].before = n.before;
  }

  std::vector<Node> nodes_;
  std::vector<double> costs_;  // from the root
  std::vector<Hung> hung_;
  std::vector<std::uint32_t> waiting_;
};

}  // namespace waywright
