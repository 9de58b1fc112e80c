// Draws a path: lines and curves one after another, with turns on the spot where the course jumps.
#pragma once

#include "waywright/path/path.hpp"

namespace waywright {

class PathPencil {
 public:
  explicit PathPencil(const Pose& start) : at_{start} {}
  const Pose& at() const { return at_; }
  void face(double heading);
  /// direction: +1 forwards, −1 backwards
  void line(Vec2 to, int direction);
  /// A quadratic Bézier curve, forwards. @pre control is neither end
  void curve(Vec2 control, Vec2 to);
  Path take() { return std::move(path_); }

 private:
  Path path_;
  Pose at_;
};

/// The greatest curvature of a quadratic Bézier curve, 1/m; +∞ where it has a cusp.
double greatest_curvature(Vec2 from, Vec2 control, Vec2 to);

/// Ends of chords of it, none farther than `sagitta` from it; `from` not among them.
void add_chords(Vec2 from, Vec2 control, Vec2 to, double sagitta, std::vector<Vec2>& points);

}  // namespace waywright
