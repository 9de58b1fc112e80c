// What the figures of docs/performance.md are measured against: a docking candidate's evaluation as a good engineer writes it first, with
// Eigen and nothing clever, and the same with bounding boxes tested before exact shapes. FROZEN: sources and flags (-O2, no special
// instruction set) stay as they are, so that figures of different days can be compared. Serves as an oracle in the tests too.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace yardstick {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

/// Boxes and other convex obstacles (counter-clockwise), walls as segments, scan points.
struct Scene {
  Polygon footprint;  ///< convex, counter-clockwise, body frame
  std::vector<Polygon> obstacles;
  std::vector<std::array<Point, 2>> walls;
  std::vector<Point> points;
  double clearance = 0.0;  ///< m; a pose that comes as near as this or nearer is a hit
};

/// Control points of a candidate's two quintics; the first is driven backwards.
struct Candidate {
  std::array<Point, 6> back, forth;
};

struct Verdict {
  double length = 0.0, curvature_change = 0.0, max_curvature = 0.0, max_curvature_rate = 0.0;
  int poses = 0;
  int hits = 0;        ///< poses that are too near to something
  int first_hit = -1;  ///< the first of them; −1: none
};

/// `samples` poses of each quintic, equal steps of the parameter, both ends included.
Verdict evaluate_plain(const Scene& scene, const Candidate& candidate, int samples);
Verdict evaluate_boxes_first(const Scene& scene, const Candidate& candidate, int samples);

/// The distance from the footprint at a pose (position, unit heading) to the nearest thing.
double distance_at(const Scene& scene, const Point& position, const Point& heading);

}  // namespace yardstick
