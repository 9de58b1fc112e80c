// What the figures of docs/performance.md on waypoints are measured against: a trajectory's distances and a clothoid fit as a good engineer writes
// them first. FROZEN: sources and flags (-O2, no special instruction set) stay as they are. Serves as an oracle in the tests too.
#pragma once

#include <vector>

#include "bench/yardstick/plain.hpp"

namespace yardstick {

struct Pose {
  double x, y, heading;
};

/// Rings; the first one is the border, whose outside is occupied.
struct Hall {
  Polygon footprint;  ///< convex, counter-clockwise, body frame
  std::vector<Polygon> objects;
};

struct Distances {
  std::vector<double> distance;  ///< of each pose: corners to the objects' sides, objects' corners to the footprint's sides; 0 in contact
  std::vector<double> depth;     ///< how deep corners are inside
};

Distances distances_plain(const Hall& hall, const std::vector<Pose>& poses);
/// The same with the objects' bounding boxes looked at first.
Distances distances_boxes_first(const Hall& hall, const std::vector<Pose>& poses);

struct FittedClothoid {
  double length, curvature, rate;
};
/// Newton from 3 (φ0 + φ1), eight-point Gauss–Legendre on four equal parts.
FittedClothoid fit_textbook(const Pose& from, const Pose& to);

/// Poses at equal ways along the clothoids from each pose to the next, ends included: each by quadrature from the one before.
std::vector<Pose> sample_textbook(const std::vector<Pose>& through, int samples);

/// Fits, samples, measures; then the piecewise average: one plus the mean depth where something collides, else one less the mean distance, both by
/// half the diagonal of the hall.
double candidate_plain(const Hall& hall, const std::vector<Pose>& through, int samples);

}  // namespace yardstick
