// The RRT*-WOA publication's global variant: the whale optimisation algorithm moves the corners of a way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/optimizer/whale_step.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

struct WhaleRefinementOptions {
  int population = 10;
  int iterations = 10;
  double bound = 2.5;  ///< m, that each coordinate of a corner may leave its place by
  WhaleParameters whale{.start = 4.0};
  std::int64_t evaluations = std::numeric_limits<std::int64_t>::max();  ///< at most
};

/// One way after another in the same memory; one object, one thread.
///
/// An agent is the corners between start and goal. The first one is the way itself, the others have each corner moved within a disc of `bound` about its place. A free
/// way comes before one that is not, then the shorter one (lexicographic: with the publication's weights a colliding way more than a tenth shorter would win).
///
/// Laws: never longer than the way given, ends where it ends, free where that is; same arguments, same bits.
class WhaleRefinement {
 public:
  /// @pre the way is free, two points at least. Ends early, with the best so far, where the budget's clock or flag says so.
  std::vector<Vec2> refined(const std::vector<Vec2>& way, const PlaneSpace& space, const WhaleRefinementOptions& options, std::uint64_t seed, Budget& budget);

  static constexpr std::size_t most_drawn = 40;  ///< iterations that are kept for pictures
  /// From now on where agents were after each iteration is kept for pictures: of every run, one after another, evenly left out where there are more
  /// than `most_drawn`.
  void draw_into(std::vector<std::vector<std::vector<Vec2>>>* iterations) {
    drawn_ = iterations;
    iterations_ = 0;
    each_drawn_ = 1;
  }

  std::int64_t evaluations() const { return evaluations_; }  ///< of the last call
  std::int64_t lines() const { return lines_; }              ///< likewise, whose freedom was asked for

 private:
  double length_of(const double* corners);
  bool is_free(const double* corners);
  void draw(int population);

  const PlaneSpace* space_ = nullptr;
  Vec2 start_{}, goal_{};
  std::size_t corners_ = 0;
  // All x first, then all y.
  std::vector<double> low_, high_, agents_, best_, squares_;
  std::vector<std::vector<std::vector<Vec2>>>* drawn_ = nullptr;
  std::size_t iterations_ = 0, each_drawn_ = 1;  // done, and of which every how many-th is kept
  std::int64_t evaluations_ = 0, lines_ = 0;
};

}  // namespace waywright
