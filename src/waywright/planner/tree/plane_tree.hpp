// RRT and RRT* for a disc in the plane: a tree of straight lines that grows from the start.
//
// Sources: S. M. LaValle, J. J. Kuffner: Randomized kinodynamic planning, IJRR 20 (2001) (RRT); S. Karaman, E. Frazzoli: Sampling-based algorithms for optimal motion
// planning, IJRR 30 (2011) (RRT*, the radius); J. D. Gammell, S. S. Srinivasa, T. D. Barfoot: Informed RRT*, IROS 2014 (the ellipse). The goal's threshold, the fixed
// radius and the end at the first path are those of the RRT*-WOA publication.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/core/random.hpp"
#include "waywright/judge/search_picture.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/plane/point_bins.hpp"

namespace waywright {

struct PlaneTreeOptions {
  std::int64_t samples = 10'000;
  double step = 1.0;            ///< m, longest edge that the tree grows by
  double radius = 0.0;          ///< m, within which RRT* looks for better parents; 0: the proven one, which shrinks as the tree grows
  double goal_threshold = 1.0;  ///< m: from so near the goal is looked for
  double goal_bias = 0.0;       ///< share of the samples that are the goal
  bool rewires = true;          ///< RRT*; else RRT
  bool first_path = false;      ///< ends with the first path; else with the last sample
  bool informed = false;        ///< once there is a path, only places are drawn that a shorter one can lead past
  bool straight_first = true;   ///< before anything is drawn the goal is looked for from the start, however far it is; the publication does not
};

/// Where an extension goes that grows from `near` towards the sample; the tree clips it to its step. The default goes to the sample.
class TreeSteering {
 public:
  virtual ~TreeSteering() = default;
  virtual Vec2 aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) = 0;
  /// The tree grew by the last aim, `samples` (≥ 1) having been drawn.
  virtual void grown(std::int64_t /*samples*/) {}
};

struct PlaneTreeStatistics {
  std::int64_t samples = 0;
  std::int64_t edges = 0;  ///< straight lines whose freedom was asked for
  std::int64_t rewired = 0;
  std::int64_t first_path_after = 0;      ///< samples; 0: there was none, or the start saw the goal
  std::optional<double> first_length{};   ///< m
};

/// One search after another in the same memory; one object, one thread.
///
/// Laws: cost(node) = cost(parent) + length of the edge for every node but the first, exactly; every edge is free; same arguments, same bits. With the proven radius, no
/// end at the first path and no steering of its own, the length of the way tends to that of the shortest with the number of samples.
class PlaneTree {
 public:
  static constexpr std::uint32_t none = PointBins::none;

  /// The space outlives the search. @pre the start is free. `edges`: at most so many lines are tested; then it ends.
  void grow(const PlaneSpace& space, const PlaneTreeOptions& options, Vec2 start, const PlaneTarget& goal, std::uint64_t seed, Budget& budget, std::int64_t edges,
            TreeSteering* steering = nullptr);

  /// A node of a tree that was made elsewhere. The first one is the root, the others come after their parents.
  struct KeptNode {
    Vec2 at{};
    std::uint32_t parent = none;
  };
  /// The same from a tree that is there already, to which samples are added. @pre there is a root, its place and all edges are free
  void grow_on(const std::vector<KeptNode>& kept, const PlaneSpace& space, const PlaneTreeOptions& options, const PlaneTarget& goal, std::uint64_t seed, Budget& budget, std::int64_t edges,
               TreeSteering* steering = nullptr);

  bool is_found() const { return best_ != none; }
  double length() const { return best_length_; }  ///< m; +∞ where nothing was found
  std::vector<Vec2> way() const;                  ///< from the start to the goal; empty where nothing was found
  const PlaneTreeStatistics& statistics() const { return statistics_; }

  std::size_t size() const { return bins_.size(); }
  Vec2 place(std::uint32_t node) const { return bins_[node]; }
  std::uint32_t parent(std::uint32_t node) const { return nodes_[node].parent; }
  double cost(std::uint32_t node) const { return costs_[node]; }
  std::uint32_t nearest(Vec2 to) const { return bins_.nearest(to); }

  /// How it grew: every edge with the samples between which it was there, and the best ways.
  SearchPicture picture() const;

 private:
  struct Node {
    double edge = 0.0;  // m from the parent
    std::uint32_t parent = none;
    std::uint32_t child = none, before = none, after = none;  // first child; siblings
  };
  struct GoalEdge {
    std::uint32_t node;
    Vec2 end;
    double length;
  };
  struct Hung {  // a node, on a parent from a sample on
    std::uint32_t node, parent, sample;
  };
  struct Neighbour {
    double through = 0.0;  // m, cost of the new node by this one
    double length = 0.0;
    std::uint32_t node = none;
  };
  bool is_edge_free(Vec2 a, Vec2 b);
  bool is_edge_free(Vec2 a, Vec2 b, double length, double room_a, double room_b);
  std::uint32_t add(Vec2 at, double room);
  std::optional<Vec2> sampled(Random& random);
  double radius() const;
  void attach(std::uint32_t node, std::uint32_t parent, double edge);
  void detach(std::uint32_t node);
  void pass_on(std::uint32_t node);
  std::uint32_t nearest_of_neighbours() const;
  void look_for_parents(double by_near);
  void look_for_children(double cost);
  void insert(Vec2 at, double room, std::uint32_t near, double to_near, bool is_near_known);
  void look_for_goal(std::uint32_t node);
  void choose_best();
  void hang(std::uint32_t node, std::uint32_t parent, double edge);
  void take_over();

  const PlaneSpace* space_ = nullptr;
  const std::vector<KeptNode>* kept_ = nullptr;  // while it takes them over
  PlaneTreeOptions options_;
  PlaneTarget goal_;
  std::int64_t most_edges_ = 0;
  PointBins bins_;
  std::vector<Node> nodes_;
  std::vector<double> costs_;  // m from the start
  std::vector<double> rooms_;  // m, see PlaneSpace::room
  std::vector<GoalEdge> goal_edges_;
  std::vector<PointBins::Near> near_;   // the first near_count_ are within the radius of what is to be added
  std::vector<Neighbour> neighbours_;   // the first neighbour_count_ could be its parents, then its children
  std::size_t near_count_ = 0, neighbour_count_ = 0;
  std::vector<std::uint32_t> waiting_;
  std::vector<Hung> hung_;                   // in order
  std::vector<SearchPicture::Way> best_ways_;
  std::uint32_t best_ = none;  // index into goal_edges_
  double best_length_ = 0.0, drawn_length_ = 0.0;
  bool is_changed_ = false;
  PlaneTreeStatistics statistics_;
};

}  // namespace waywright
