// A tree in the plane that outlives the map it grew on: what new obstacles leave of it is kept, and its root goes along with the robot.
//
// Sources: the root that moves and its surroundings that are looked at again first are those of K. Naderi, J. Rajamäki, P. Hämäläinen: RT-RRT*, MIG 2015; orphans that find
// parents among the nodes beside them those of M. Otte, E. Frazzoli: RRTX, WAFR 2014. Here nothing is drawn at random: the same arguments give the same tree.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/map/world.hpp"
#include "waywright/planner/tree/plane_tree.hpp"

namespace waywright {

struct KeptTreeStatistics {
  std::int64_t nodes = 0;         ///< before
  std::int64_t kept = 0;          ///< after, the new root among them
  std::int64_t near = 0;          ///< edges that were held against what is new
  std::int64_t cut = 0;           ///< of these not free
  std::int64_t orphans = 0;       ///< nodes that lost their way to the root
  std::int64_t reattached = 0;    ///< of these found another
  std::int64_t rewired = 0;       ///< nodes that got a shorter way
  std::int64_t lines = 0;         ///< straight lines that were held against the whole map
};

/// Laws: every edge is free on the new map where it was free on the old one; the cost of a node is that of its parent and the length of the edge between; a node that is
/// gone is blocked, or no line of at most the radius joins it to one that is kept.
class KeptTree {
 public:
  /// The tree as it grew; it is looked at and grown on after carry_over(). @pre its edges are free
  void take(const PlaneTree& tree);
  bool empty() const { return nodes_.empty(); }

  /// `space`: the map with what is new; `appeared`: what is new alone, built; `root`: where the robot is now, free; `radius`: m, within which parents are looked for.
  /// Ways are shortened where that can lead to a shorter one to the goal (as bounded by the straight line). False where the root sees no node: then only it is left.
  bool carry_over(const PlaneSpace& space, const World& appeared, Vec2 root, double radius, const PlaneTarget& goal);

  /// The root first, each after its parent.
  const std::vector<PlaneTree::KeptNode>& nodes() const { return nodes_; }
  const std::vector<double>& costs() const { return costs_; }  ///< m from the root
  const KeptTreeStatistics& statistics() const { return statistics_; }

 private:
  std::vector<PlaneTree::KeptNode> nodes_;
  std::vector<double> costs_;
  KeptTreeStatistics statistics_;
};

}  // namespace waywright
