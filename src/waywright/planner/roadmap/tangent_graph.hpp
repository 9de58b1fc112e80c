// The visibility graph of a disc: straight lines that touch the circles about obstacles' corners, and the arcs of those circles between them. A shortest way of the disc
// is made of them.
//
// Sources: T. Lozano-Pérez, M. A. Wesley: An algorithm for planning collision-free paths among polyhedral obstacles, CACM 22 (1979); Y.-H. Liu, S. Arimoto: Path
// planning using a tangent graph for mobile robots among polygonal and curved obstacles, IJRR 11 (1992).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/roadmap/corners.hpp"

namespace waywright {

/// A way: from the start straight to the first bend, along its arc, straight to the next …, to the goal.
struct TangentWay {
  struct Bend {
    Vec2 center{};
    Vec2 from{};         ///< direction of length 1 from the center to where the arc begins
    double angle = 0.0;  ///< rad, counter-clockwise positive
  };
  Vec2 start{}, goal{};
  std::vector<Bend> bends;
  double length = 0.0;  ///< m
};

enum class TangentEnd { found, unreachable, expansions, stopped };

struct TangentAnswer {
  TangentEnd ended = TangentEnd::unreachable;
  TangentWay way;  ///< where found
  std::int64_t expansions = 0;
  std::int64_t lines = 0;  ///< whose freedom was asked for
  double least = 0.0;      ///< m, where it was ended before: no way in the graph is shorter
};

/// Immutable once made; queries may run on many threads. The space outlives it.
///
/// Law: what a query finds is a shortest way among those that keep `radius` from everything, up to rounding and `radius − margin`: lines and arcs are called free where
/// they keep `margin`, a little less than the radius at which they run.
class TangentGraph {
 public:
  /// @pre 0 ≤ margin < radius, m
  TangentGraph(const PlaneSpace& space, double radius, double margin, Rounding rounding = Rounding::safe);

  double radius() const { return radius_; }
  double margin() const { return margin_; }
  std::size_t corners() const { return corners_.size(); }
  const std::vector<Corner>& corner_list() const { return corners_; }
  /// Asks beforehand which corners see which, so that queries need not: time grows with the square of the corners.
  void see_all();
  std::size_t tangents() const { return tangents_.size(); }  ///< that are free; 0 before see_all()
  /// Of the free ones the ends of each, for pictures.
  std::vector<std::pair<Vec2, Vec2>> lines() const;

  /// The shortest way to the goal. @pre the start is free
  TangentAnswer shortest(Vec2 start, const PlaneTarget& goal, Budget& budget, std::optional<std::int64_t> expansions = {}) const;

 private:
  friend class TangentSearch;
  /// From one corner to another.
  struct Tangent {
    std::uint32_t to = 0;
    Vec2 along{};           // of length 1
    double length = 0.0;    // m
    bool to_left = false;   // the other corner lies to the left: its arc goes on counter-clockwise
  };
  /// A side of a corner: passed with the corner to the left (counter-clockwise) or to the right.
  static std::uint32_t side(std::uint32_t corner, bool is_left) { return 2 * corner + (is_left ? 1U : 0U); }
  std::optional<Tangent> tangent(std::uint32_t from, bool from_left, std::uint32_t to, bool to_left) const;
  Vec2 touching(std::uint32_t corner, bool is_left, Vec2 along) const { return corners_[corner].at - (is_left ? radius_ : -radius_) * left_of(along); }
  bool is_free(Vec2 from, Vec2 to) const { return space_.is_free(from, to, margin_); }

  const PlaneSpace& space_;
  double radius_, margin_;
  Rounding rounding_;
  std::vector<Corner> corners_;
  bool sees_all_ = false;
  std::vector<std::uint32_t> first_;  // of each side, into tangents_; one more
  std::vector<Tangent> tangents_;
};

}  // namespace waywright
