// Places of a path by their distance from its start, on the exact curves: prepared once, asked many times.
#pragma once

#include <variant>
#include <vector>

#include "waywright/curve/bezier.hpp"
#include "waywright/path/path.hpp"

namespace waywright {

/// A vehicle on a path.
struct PathPlace {
  Pose pose{};             ///< of the vehicle
  double curvature = 0.0;  ///< 1/m in the direction of travel
};

class PathPlaces {
 public:
  /// Keeps its own copy of the pieces. @pre the path is not empty
  explicit PathPlaces(const Path& path);

  /// m
  double length() const { return ends_.back(); }
  /// After `s` metres, clamped to the path. At a joint: where the piece that follows begins. Turns on the spot have no place of their own.
  PathPlace at(double s) const;

 private:
  struct Prepared {
    Piece piece;
    std::vector<ArcLengthTable> spans;  ///< of a spline
    std::vector<double> ends;           ///< m, of its spans, or of steps between poses
    double length = 0.0;                ///< m
  };
  PathPlace on(const Prepared& piece, double s) const;

  std::vector<Prepared> pieces_;
  std::vector<double> ends_;  ///< m, from the path's start
};

}  // namespace waywright
