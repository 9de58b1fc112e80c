// One candidate of the docking search: its path, its measures, how far it can be driven.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "waywright/objective/docking_cost.hpp"
#include "waywright/planner/docking/pattern.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// What a candidate came to.
struct CandidateScore {
  PathMeasures measures;
  double max_curvature_rate = 0.0;  ///< 1/m²
  double reach = 0.0;               ///< m driven free before the first contact
  bool free = false;                ///< reached the end
  std::optional<Contact> contact;   ///< the first one
  double excess = 0.0;              ///< how far limits are exceeded, as a share of them; 0: kept
  bool feasible() const { return free && excess == 0.0; }
};

/// Evaluates candidates of our form: measures by dense samples, contact along the continuous motion.
///
/// Free means: from sample to sample the clearance found exceeds the required one by more than any footprint point can move in
/// between (the sum of both ends' slack against path length + radius × turning), so a candidate that counts as free is free
/// between the samples too, up to the margin `reserve`. Reuses its buffers: no allocation after the first call.
class CandidateEvaluator {
 public:
  explicit CandidateEvaluator(const Problem& problem);

  /// `stop_at_contact` false: measures only (for the reference path).
  CandidateScore evaluate(const std::array<Spline, 2>& splines, bool check_contact = true);

 private:
  struct State {
    Pose pose;
    double s = 0.0;
    double turned = 0.0;  ///< ∫|κ| ds from the start
    std::size_t spline = 0;
    std::size_t span = 0;
    double u = 0.0;
  };
  void sample(const std::array<Spline, 2>& splines, CandidateScore& score);
  void drive(const std::array<Spline, 2>& splines, CandidateScore& score) const;
  State between(const std::array<Spline, 2>& splines, const State& a, const State& b) const;

  const Problem& problem_;
  double radius_;
  double required_;
  double curvature_limit_;
  double rate_limit_;
  std::vector<State> states_;
};

/// Cost that the search minimises: `base` where feasible; above it graded, so that a search finds its way into narrow stations:
/// the farther the path came before its first contact, the lower.
double graded_cost(const CandidateScore& score, double base);

}  // namespace waywright
