// Candidates of the spline planners: from decision variables to a curve and what it costs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "waywright/planner/spline/spline_planner.hpp"

namespace waywright {

/// Evaluates candidates of one problem, in memory that is kept: for one thread.
class SplineCandidates {
 public:
  /// `guide`: corners of a way from start to goal that control points are looked for about; empty: the straight line. @pre problem and options
  /// outlive this
  SplineCandidates(const Problem& problem, const SplineOptions& options, const std::vector<Vec2>& guide = {});

  const SearchSpace& space() const { return space_; }
  /// The candidate whose control points are on the straight line, or on the guide.
  std::vector<double> plainest() const;
  std::vector<Vec2> control_points(std::span<const double> x) const;
  std::optional<SplineCurve> curve_at(std::span<const double> x) const;
  SplineEnds ends() const { return ends_; }

  /// Ours; a candidate without a curve is as bad as can be.
  Evaluation in_metres(std::span<const double> x);

  /// What it is made of.
  struct Parts {
    double length = 0.0, nearness = 0.0, bends = 0.0, turns = 0.0;  ///< m, weighted
    double violation = 0.0;                                         ///< share of the length that is too near, and of limits that are passed
    double clearance = 0.0;                                         ///< m, least beyond the required one, at the poses looked at
    double curvature = 0.0, curvature_rate = 0.0;                   ///< greatest, there
    bool is_beyond_limits = false;                                  ///< of curvature or its rate
    double sum() const { return length + nearness + bends + turns; }
  };
  Parts parts_of(const SplineCurve& curve);

  /// What (27) sees.
  SplineMeasures measures_of(const SplineCurve& curve);

  struct Tightest {
    Pose pose{};
    Contact contact{};
  };
  /// Where the poses that `metres` looks at are nearest to something.
  Tightest tightest_of(const SplineCurve& curve);

 private:
  double depth_of(const Pose& pose) const;
  void add_places(const std::vector<Vec2>& guide, const Box& box);

  const Problem& problem_;
  const SplineOptions& options_;
  SplineEnds ends_;
  SearchSpace space_;
  struct Place {
    Vec2 at{}, along{};                       // along: unit
    double ahead = 0.0, left = 0.0, right = 0.0;  // m, how far from it a control point may be
  };
  std::vector<Place> places_;                 // of control points; not of ControlSpace::map
  SplineMeasurer measurer_;
  std::vector<SplineSample> samples_;
  std::vector<Pose> poses_;
};

}  // namespace waywright
