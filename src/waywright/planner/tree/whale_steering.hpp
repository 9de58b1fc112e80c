// Steering of the RRT*-WOA publication's local variant: the whale optimisation algorithm looks around a sample for where the tree sees the goal.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/optimizer/whale_step.hpp"
#include "waywright/planner/plane/view.hpp"
#include "waywright/planner/tree/lanes/kernels.hpp"
#include "waywright/planner/tree/plane_tree.hpp"

namespace waywright {

/// The publication names four terms and gives neither formula nor weights; these are reconstructed:
///   f(x) = w_r |x − sample| / R + w_g |x − goal| / D + w_n [line from `near` is not free] + 10 [x is not free] + w_v [line to the goal is not free],
/// D the region's diagonal; in single precision, as places are. To the goal alone: w_r = 0; growth at random: w_g = 0.
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
  WhaleSteering(const WhaleSteering&) = delete;  // what the lanes take points into it
  WhaleSteering& operator=(const WhaleSteering&) = delete;
  Vec2 aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) override;

  void grown(std::int64_t samples) override;
  /// Agents as they were at last, of a share of the extensions that the tree grew by, spread over the whole search: a hundred at most.
  void draw(SearchPicture& picture) const;

  std::int64_t evaluations() const { return evaluations_; }
  std::int64_t lines() const { return lines_; }  ///< that were looked along, one by one

  /// The cost of a place, whole; `off` is where it is, from the sample.
  float cost(whale_lanes::Place off, Vec2 near, Vec2 sample, Vec2 goal) const;

 private:
  struct Best {
    whale_lanes::Place off{};  // from the sample
    float cost = 0.0F;
  };
  struct Aim {
    Vec2 near, sample, goal;
    double room;           // m, of near
    PlaneView::Seen seen;  // the goal, from the whole disc
  };
  void prepare_view(Vec2 goal);
  void look(const Aim& aim, Best& best);
  bool try_out(const Aim& aim, std::size_t agent, bool is_first_of_equals, Best& best);
  bool is_seen_from_tree(const Aim& aim, whale_lanes::Place off, Vec2 at);
  bool sees_goal(const Aim& aim, Vec2 at, PlaneView::Seen told);
  float square_of_less(double length) const;
  void add_shadow(const Aim& aim, Vec2 along, double hit, double blocked);

  const PlaneSpace& space_;
  WhaleSteeringOptions options_;
  std::size_t population_;
  PlaneView view_;   // of the goal, where it stays the same from one extension to the next
  Vec2 last_goal_{};
  bool has_goal_ = false, has_view_ = false;
  const whale_lanes::Kernels& lanes_ = whale_lanes::best();
  std::vector<float> x_, y_, before_x_, before_y_;  // of the agents, from the sample
  std::vector<float> keys_, bounds_;
  std::vector<std::int32_t> is_dark_, is_known_;
  // Moves of all iterations, ahead, as they do not depend on what is found.
  std::vector<float> reaches_, factors_, scales_;
  std::vector<std::int32_t> others_;
  std::size_t oldest_shadow_ = 0;
  whale_lanes::Drawing drawing_;
  whale_lanes::Flight flight_;
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
