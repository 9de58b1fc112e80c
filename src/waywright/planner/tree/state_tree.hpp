// RRT and RRT* among positions with headings: a tree of motions of any steering that grows from the start.
//
// Sources: S. M. LaValle, J. J. Kuffner: Randomized kinodynamic planning, IJRR 20 (2001) (RRT); S. Karaman, E. Frazzoli: Optimal kinodynamic motion planning using
// incremental sampling-based methods, CDC 2010 (steering, reachability to and from); the same: Sampling-based algorithms for optimal motion planning, IJRR 30 (2011) (how many
// neighbours); the same: Sampling-based optimal motion planning for non-holonomic dynamical systems, ICRA 2013; J. D. Gammell, S. S. Srinivasa, T. D. Barfoot: Informed RRT*,
// IROS 2014.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/judge/search_picture.hpp"
#include "waywright/planner/roadmap/state_planning.hpp"
#include "waywright/planner/steering/state_bins.hpp"
#include "waywright/planner/tree/plane_tree.hpp"
#include "waywright/planner/tree/tree_nodes.hpp"

namespace waywright {

struct StateTreeStatistics {
  std::int64_t samples = 0;
  std::int64_t rewired = 0;
  std::int64_t first_path_after = 0;   ///< samples; 0: there was none, or the start saw the goal
  std::optional<double> first_cost{};  ///< m
  bool is_least = false;               ///< it ended as no chain of such motions costs less
  bool is_stuck = false;               ///< it ended as nothing was left to draw
};

/// One search after another in the same memory; one object, one thread.
///
/// RRT* looks for better parents among so many states as motions from cost least, k = e (1 + 1/d) ln n with d = 3, and for states to be hung on the new one among as many
/// that motions to cost least (with Dubins curves others). That number is proven for straight lines (Karaman, Frazzoli 2011); where motions are curves the proof is of radii
/// (2013) with the volume of what a motion of that cost reaches, whose exponent of 4 would ask for fewer. (Solovey et al., ICRA 2020, found a gap in the proof of RRT*'s radius and closed it
/// with a slightly larger one.) `radius` > 0: all within that cost instead, more and more as the tree grows. Of the PlaneTreeOptions `goal_threshold` is the straight distance
/// from which the goal is looked for, by whatever motion.
///
/// Laws: cost(node) = cost(parent) + distance(parent, node) of the steering for every node but the first, exactly; every edge has been called free by the query's test; a
/// state's cost never grows; same arguments, same bits.
class StateTree {
 public:
  static constexpr std::uint32_t none = TreeNodes::none;

  /// Ends with the samples, with the query's motions, when nothing can cost less, or with the first way where that is asked for.
  void grow(const StateQuery& query, const PlaneTreeOptions& options, std::uint64_t seed, Budget& budget);

  bool is_found() const { return best_ != none; }
  double cost() const { return best_cost_; }  ///< m, of the best way; +∞ where nothing was found
  std::vector<Pose> way() const;              ///< from the start to the goal; empty where nothing was found
  const StateTreeStatistics& statistics() const { return statistics_; }

  std::size_t size() const { return bins_.size(); }
  const Pose& state(std::uint32_t node) const { return bins_[node]; }
  std::uint32_t parent(std::uint32_t node) const { return nodes_.parent(node); }
  double cost(std::uint32_t node) const { return nodes_.cost(node); }
  std::vector<Pose> way_to(std::uint32_t node) const;
  /// The state from which a motion to the goal costs least.
  std::uint32_t nearest_to_goal() const { return bins_.nearest(query_->goal, StateBins::Way::to_it).index; }

  /// How it grew: every edge with the samples between which it was there, and the best ways.
  SearchPicture picture() const;

 private:
  enum class Freedom : std::uint8_t { unknown, free, blocked };
  struct GoalEdge {
    std::uint32_t node;
    Freedom freedom;
    double cost;
  };
  struct Neighbour {
    double through, cost;
    std::uint32_t node;
    bool operator<(const Neighbour& o) const { return through != o.through ? through < o.through : node < o.node; }
  };
  bool is_free(const Pose& from, const Pose& to) { return query_->test.motion_free(query_->steering.between(from, to)); }
  bool is_spent() const { return query_->test.motions() >= query_->motions; }
  std::uint32_t step() const { return static_cast<std::uint32_t>(statistics_.samples); }
  std::optional<Pose> sampled(Random& random, Budget& budget);
  void insert(const Pose& at, std::uint32_t near, double to_near);
  void look_for_goal(std::uint32_t node);
  void choose_best();
  void near_states(const Pose& at, StateBins::Way way, std::vector<StateBins::Near>& found) const;

  const StateQuery* query_ = nullptr;
  PlaneTreeOptions options_;
  double least_ = 0.0;  // m, that any way costs
  StateBins bins_;
  TreeNodes nodes_;
  std::vector<GoalEdge> goal_edges_;
  std::vector<StateBins::Near> near_;
  std::vector<Neighbour> neighbours_;
  std::vector<SearchPicture::Way> best_ways_;
  std::uint32_t best_ = none;  // index into goal_edges_
  double best_cost_ = 0.0, drawn_cost_ = 0.0;
  bool is_changed_ = false;
  StateTreeStatistics statistics_;
};

}  // namespace waywright
