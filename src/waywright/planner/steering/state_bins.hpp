// States in bins by their positions, asked for those from or to which a motion costs least.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/planner/plane/point_bins.hpp"
#include "waywright/planner/steering/steering.hpp"

namespace waywright {

/// A motion costs no less than the straight distance, so that positions say how far one has to look; among those, motions are made where a closer bound
/// (Steering::bound) does not tell that they cost too much. Queries may run on many threads.
///
/// Law: answers are those of looking at all states one after another, up to motions whose costs differ by rounding.
class StateBins {
 public:
  static constexpr std::uint32_t none = PointBins::none;
  enum class Way { to_it, from_it };  ///< motions from the states to the one asked for, or from that one to them

  /// Empty, for positions of this region. The steering outlives it.
  void clear(const Steering& steering, const Box& region);
  std::uint32_t add(const Pose& pose);
  std::size_t size() const { return states_.size(); }
  const Pose& operator[](std::uint32_t i) const { return states_[i].pose; }

  struct Near {
    double cost = 0.0;  ///< m, of the motion
    std::uint32_t index = none;
    bool operator<(const Near& o) const { return cost != o.cost ? cost < o.cost : index < o.index; }
  };
  /// As many of the least cost, in this order; of several with the same cost those added first. All where there are fewer.
  void nearest(const Pose& at, Way way, std::size_t count, std::vector<Near>& found) const;
  /// Those whose motion costs no more than `radius`, in the order of cost.
  void within(const Pose& at, Way way, double radius, std::vector<Near>& found) const;
  /// Of the least cost. @pre there is a state
  Near nearest(const Pose& at, Way way) const;

 private:
  double cost_under(const Pose& at, Way way, std::uint32_t i, double limit) const {
    return way == Way::to_it ? steering_->distance_under(states_[i].pose, at, limit) : steering_->distance_under(at, states_[i].pose, limit);
  }
  double bound(const Facing& at, Way way, std::uint32_t i) const { return way == Way::to_it ? steering_->bound(states_[i], at) : steering_->bound(at, states_[i]); }

  const Steering* steering_ = nullptr;
  Box region_{};
  PointBins bins_;
  std::vector<Facing> states_;
};

}  // namespace waywright
