// Curves through or along control points, as vehicles drive them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

enum class SplineForm {
  cubic,    ///< C² cubic through start, control points and goal, chord-length parameter (published with CAPSO)
  bspline,  ///< clamped uniform cubic B-spline with start, control points and goal as its control points (published with the GA)
};

/// How a vehicle gets from its heading to the curve's course at start and goal.
enum class SplineEnds {
  turned,   ///< it turns on the spot; the curve begins and ends as it likes
  kept,     ///< the curve begins and ends in the headings
  ignored,  ///< as published: not at all. The path is not the mission's, unless courses and headings are the same
};

struct SplineCurve {
  Spans spans;
  double start_turn = 0.0, end_turn = 0.0;  ///< rad on the spot, before and after
};

/// `leads`: m, of a B-spline whose headings are kept, how far its second and last but one control point are from start and goal; > 0.
/// nullopt where neighbouring points coincide, so that the curve has no course there.
std::optional<SplineCurve> spline_curve(const Problem& problem, SplineForm form, SplineEnds ends, std::span<const Vec2> control_points, std::array<double, 2> leads = {});

/// From start to goal, forwards.
Path path_of(const Problem& problem, const SplineCurve& curve);

struct SplineSample {
  Pose pose{};
  double along = 0.0;  ///< m from the sample before, straight; 0 while turning on the spot
  double curvature = 0.0, curvature_rate = 0.0;
};
/// Places at most about `step` metres and, turning on the spot, 0.1 rad apart; first and last are start and goal. At most about 20 000.
void sample_by_step(const Problem& problem, const SplineCurve& curve, double step, std::vector<SplineSample>& samples);

/// `count` ≥ 2 poses at equal steps of the curve's parameter (chord length; of a B-spline its knots), without turns.
void sample_by_parameter(SplineForm form, const SplineCurve& curve, std::size_t count, std::vector<Pose>& poses);

}  // namespace waywright
