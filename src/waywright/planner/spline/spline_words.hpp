// What a plan on one spline says of itself, and why there is none.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "waywright/planner/spline/spline_candidates.hpp"

namespace waywright {

/// "natural cubic spline", "cubic spline", "B-spline".
std::string curve_name(SplineForm form, SplineEnds ends);

/// Where control points are, among how many curves, and what the objective is there and with the points on the straight line, or on the guide.
std::string points_sentence(const SplineOptions& options, std::span<const Vec2> points, double chosen, const Evaluation& of_plainest, std::int64_t looked, bool is_guided);

/// What its cost in metres is made of.
std::string parts_sentence(const SplineCandidates::Parts& parts);

/// Curvature and its rate with the vehicle's limits, and how it comes to its headings.
std::string curve_sentence(const Problem& problem, const SplineOptions& options, const SplineCurve& curve, const SplineCandidates::Parts& parts, SplineEnds ends);

/// (27) and its weights.
std::string fitness_sentence(const SplineMeasures& measures, const SplineWeights& weights, int samples);

std::vector<Pose> picture_of(const Problem& problem, const SplineCurve& curve);

/// Why the best of the curves looked at cannot be driven.
PlanningFailure failure_of(const Problem& problem, const SplineOptions& options, SplineCandidates& candidates, const SplineCurve& curve, std::int64_t looked, const Budget& budget);

/// Where not even a curve was found.
PlanningFailure failure_without_curve(std::int64_t looked, const Budget& budget);

}  // namespace waywright
