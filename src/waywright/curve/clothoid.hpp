// Clothoids: evaluation by quadrature with a stated error, the G1 Hermite problem, the nearest point.
#pragma once

#include <boost/container/small_vector.hpp>
#include <optional>
#include <span>
#include <vector>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// κ(s) = curvature + curvature_rate·s at the end, 1/m.
double end_curvature(const Clothoid& clothoid);
/// Greatest |κ|, 1/m: that of an end.
double greatest_curvature(const Clothoid& clothoid);
/// θ(s), rad, continuous (not wrapped).
double course_at(const Clothoid& clothoid, double s);

/// The clothoid after `s` metres; s outside [0, length] continues it. Error of the position: under 2e-14 of |s| (Gauss–Legendre on
/// panels whose phase is bounded), and what rounding of the course, 1e-16 of it, does over |s|.
CurvePoint evaluate(const Clothoid& clothoid, double s);

/// The same for many places of one clothoid: what was integrated before is kept.
class ClothoidPanels {
 public:
  explicit ClothoidPanels(const Clothoid& clothoid);
  /// s in [0, length]
  CurvePoint at(double s) const;

 private:
  Clothoid clothoid_;
  double width_ = 0.0;  // m, of a panel
  boost::container::small_vector<Vec2, 4> begins_;
};

/// The same places the other way. Law: reversed twice is the same up to rounding.
Clothoid reversed(const Clothoid& clothoid);
/// What follows after `s` metres in [0, length).
Clothoid rest_from(const Clothoid& clothoid, double s);

/// The G1 Hermite problem: the clothoid from one pose to another (headings are courses), the shorter where there are several: that of Bertolazzi
/// and Frego, G1 fitting with clothoids, Math. Meth. Appl. Sci. 38 (2015). nullopt where the positions coincide or numbers are not finite.
/// Its end misses `to` by less than 1e-11 of the chord and 1e-11 rad.
std::optional<Clothoid> fit_clothoid(const Pose& from, const Pose& to);

/// The same for many at once, eight side by side: from[i] to to[i]. Error as above; last bits may differ from those of a single fit.
/// @pre as many of each
void fit_clothoid_batch(std::span<const Pose> from, std::span<const Pose> to, std::span<std::optional<Clothoid>> fitted);

/// Where a clothoid is at begin + i·step for i = 0 … n−1, places in [0, length], appended: heading is the course. Error of each position under
/// 2e-14 of the way from `begin`, and rounding.
void sample_clothoid(const Clothoid& clothoid, double begin, double step, std::size_t n, std::vector<Pose>& poses);

struct NearestPoint {
  double s = 0.0;         ///< m, in [0, length]
  double distance = 0.0;  ///< m
};
/// Nearest place of a clothoid, by branch and bound: its distance is within `tolerance` (m, ≥ 1e-12) of the least.
NearestPoint nearest_point(const Clothoid& clothoid, Vec2 point, double tolerance = 1e-9);

/// Point at `left` metres beside the place s (negative: to the right), with the course there. Its curvature is κ / (1 − left·κ); where that
/// denominator is not positive, the offset curve has a cusp or runs backwards, and curvature and rate are 0.
CurvePoint offset_point(const Clothoid& clothoid, double s, double left);

}  // namespace waywright
