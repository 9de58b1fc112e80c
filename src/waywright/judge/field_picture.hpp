// The field that a planner goes down, for pictures alone: no plan file holds it, and none is made before somebody asks.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "waywright/geometry/polygon.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct FieldPicture {
  struct Critical {
    enum class Kind { minimum, saddle, maximum, trap } kind;  ///< trap: where the run ended
    Vec2 at{};
  };
  std::string name;            ///< what its values are: "potential"
  Vec2 origin{};               ///< of the lower left node
  double cell = 0.0;           ///< m between nodes
  int columns = 0, rows = 0;
  /// Of each node, row by row from below, the share of nodes with a lower value, in [0, 1]; NaN where there is no field. Shares, since values are often flat nearly
  /// everywhere and steep at walls; lines of equal share are lines of equal value.
  std::vector<double> shares;
  std::vector<double> levels;  ///< shares that contours are drawn at
  std::vector<Polyline> streamlines;  ///< down the field; each ends at the goal, in a trap, or where it comes near an earlier one
  std::vector<Critical> critical;     ///< but the goal
};

/// Makes the picture of a region when it is asked for, and keeps the latest.
class FieldDrawing {
 public:
  using Draw = std::function<FieldPicture(const Problem&, const Box& region)>;
  explicit FieldDrawing(Draw draw) : draw_{std::move(draw)} {}

  /// @pre the problem that was planned, or one like it
  std::shared_ptr<const FieldPicture> of(const Problem& problem, const Box& region) const {
    const std::lock_guard lock{mutex_};
    if (!latest_ || region.low != region_.low || region.high != region_.high) {
      latest_ = std::make_shared<const FieldPicture>(draw_(problem, region));
      region_ = region;
    }
    return latest_;
  }

 private:
  Draw draw_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const FieldPicture> latest_;
  mutable Box region_{};
};

}  // namespace waywright
