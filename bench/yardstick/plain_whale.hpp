// What the figures of docs/performance.md on the whale optimisation algorithm are measured against: corners of a way moved by it, as a good engineer writes it first.
// FROZEN: sources and flags (-O2, no special instruction set) stay as they are.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace yardstick {

struct WhaleScene {
  std::vector<std::vector<Eigen::Vector2d>> obstacles;  ///< polygons
  double radius = 0.0;                                  ///< m, that a point keeps from them
};

struct WhaleWay {
  std::vector<Eigen::Vector2d> points;
  double length = 0.0;
};

/// `population` agents, each the corners between the ends, the first one the way itself; `iterations` moves; cost: length, and a thousand where any segment of the way comes
/// nearer than the radius to any side.
WhaleWay whale_plain(const WhaleScene& scene, const std::vector<Eigen::Vector2d>& way, int population, int iterations, double bound, unsigned seed);

}  // namespace yardstick
