// Steering of the RRT*-WOA publication's local variant: the whale optimisation algorithm looks around a sample for where the tree sees the goal.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/optimizer/whale_step.hpp"
#include "waywright/planner/plane/view.hpp"
#include "waywright/planner/tree/lanes/kernels.hpp"
#include "waywright/planner/tree/plane_tree.hpp"

namespace waywright {

/// The publication names four terms and gives neither formula nor weights; these are reconstructed:
///   f(x) = w_r |x − sample| / R + w_g |x − goal| / D + w_n [line from `near` is not free] + w_v [line to the goal is not free] + 10 [x is not free],
/// D the region's diagonal. To the goal alone: w_r = 0; growth at random: w_g = 0.
struct WhaleSteeringOptions {
  int population = 10;
  int iterations = 10;
  double radius = 2.5;  ///< m, of the disc around the sample that is searched [R]
  double sample_weight = 0.2, goal_weight = 1.0, near_weight = 4.0, view_weight = 2.0;
  WhaleParameters whale{};
};

class WhaleSteering final : public TreeSteering {
 public:
  WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options);
  Vec2 aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) override;

  void grown(std::int64_t samples) override;
  /// Agents as they were at last, of a share of the extensions that the tree grew by, spread over the whole search: a hundred at most.
  void draw(SearchPicture& picture) const;

  std::int64_t evaluations() const { return evaluations_; }
  std::int64_t lines() const { return lines_; }  ///< that were looked along: not those that the view of the goal tells

  /// The cost of a place, whole.
  double cost(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal) const;

 private:
  struct Best {
    Vec2 at{};
    Vec2 off{};  // from the sample
    double cost = 0.0;
  };
  struct Candidate {
    double least = 0.0;  // of its cost
    double base = 0.0;   // its distances' share
    double room = 0.0, from_near = 0.0;  // m: PlaneSpace::room, distance
    Vec2 at{};
    std::uint32_t agent = 0;
    PlaneView::Seen goal = PlaneView::Seen::not_told;
  };
  struct Aim {
    Vec2 near, sample, goal;
    double room;       // m, of near
    bool is_hidden;    // the goal is, from the whole disc
    Vec2 from_goal{};  // unit vector to the sample, or nothing
    double away = 0.0; // m, of the sample from the goal
  };
  void prepare_view(Vec2 goal);
  void told(const Aim& aim, Candidate& candidate) const;
  void look(const Aim& aim, Best& best);
  bool is_seen_from_tree(const Aim& aim, const Candidate& candidate);
  double whole_cost(const Aim& aim, const Candidate& candidate, double enough);

  const PlaneSpace& space_;
  WhaleSteeringOptions options_;
  std::size_t population_;
  double per_radius_, per_diagonal_;
  double rounding_;  // more than rounding can take from a cost
  PlaneView view_;   // of the goal, where it stays the same from one extension to the next
  Vec2 last_goal_{};
  bool has_goal_ = false, has_view_ = false;
  const whale_lanes::Kernels& lanes_ = whale_lanes::best();
  std::vector<double> x_, y_, new_x_, new_y_;  // of the agents, from the sample; before and after a move
  std::vector<double> keys_;
  std::vector<PlaneView::Seen> seen_;
  // Moves of all iterations, ahead, as they do not depend on what is found.
  std::vector<double> reaches_, factors_, scales_;
  std::vector<whale_lanes::Search> searches_;
  std::array<double, 2> hits_{};  // m from `near`: where the last lines that were not free were surely blocked
  whale_lanes::Drawing drawing_;
  whale_lanes::Ranking ranking_;
  struct Drawn {
    std::vector<Vec2> agents;
    std::uint32_t samples;
  };
  Vec2 sample_{};  // of the last aim
  std::vector<Drawn> drawn_;  // of every `each_drawn_`-th extension
  std::int64_t extensions_ = 0, each_drawn_ = 1;
  std::int64_t evaluations_ = 0, lines_ = 0;
};

}  // namespace waywright
