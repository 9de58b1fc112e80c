// One candidate of the docking search: its measures, and how far it can be driven.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "waywright/objective/docking_cost.hpp"
#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/docking/pattern.hpp"
#include "waywright/planner/docking/prepared.hpp"
#include "waywright/planner/docking/sweep.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {

/// What a candidate came to.
struct CandidateScore {
  PathMeasures measures;
  double max_curvature_rate = 0.0;  ///< 1/m²; 0 where the vehicle has no limit of it
  double reach = 0.0;               ///< share of the path driven before the first contact, in [0, 1]
  double deficit = 0.0;             ///< m², how deep and how long the footprint is too near to something, about; > 0 where not free
  bool free = false;                ///< reached the end
  Pose blocked_at{};                ///< where it ended, if not free
  double excess = 0.0;              ///< how far limits are exceeded, as a share of them; 0: kept
  double entry_excess = 0.0;        ///< of this, how far the vehicle is too fast for the way when it begins
  bool feasible() const { return free && excess == 0.0; }
  /// How far from feasible: grows steadily with depth and excess; 0: feasible.
  double violation() const { return deficit + excess; }
};

/// Evaluates candidates of our form.
///
/// Measures are taken from 91 samples of each quintic in single precision. Contact is looked for along the continuous motion: the clearance
/// field settles most of it, stretch by stretch; what it leaves open is decided by the hulls that the footprint sweeps between
/// neighbouring samples. A candidate that is surely too near somewhere is not looked at more closely: where it is blocked is then known to
/// a stretch that the field leaves open. Allocates nothing.
class CandidateEvaluator {
 public:
  explicit CandidateEvaluator(const PreparedDocking& prepared, const lanes::Kernels& kernels = lanes::best());

  CandidateScore evaluate(const DockingPattern& pattern) {
    CandidateScore score = measure(pattern);
    check(pattern, score);
    return score;
  }
  /// From now on patterns are entered with this speed, m/s backwards: one that is too short or too bent to be driven from it is not feasible.
  /// @pre 0, or the problem's vehicle moves
  void enter_with(double speed);
  /// In two steps: measures and limits …
  CandidateScore measure(const DockingPattern& pattern);
  /// … and contact. @pre `score` is what measure() just gave for this pattern
  void check(const DockingPattern& pattern, CandidateScore& score);

 private:
  /// A straight run and its verdict, asked again only where it is another one.
  struct KnownRun {
    Vec2 from{}, to{}, heading{};
    bool known = false;
    bool clear = false;
    bool is_clear(Sweep& sweep, Vec2 begin, Vec2 end, Vec2 along, double margin);
  };
  Placement pose_at(const lanes::Track& track, std::size_t i) const;
  double bow_of(const lanes::Track& track, std::size_t i) const;
  double entry_excess(const PatternPoints& points);

  const PreparedDocking& prepared_;
  const lanes::Kernels& kernels_;
  lanes::Field field_;
  Sweep sweep_;
  KnownRun start_run_, dock_run_;
  double curvature_limit_;
  bool has_rate_limit_;
  double rate_limit_;
  double entry_speed_ = 0.0;
  std::vector<Sample> entry_;  ///< the way back, of a vehicle that moves
  SpeedWorkspace timing_;
  std::array<lanes::Track, 2> tracks_;
};

/// For searches that know one number alone: `base` where feasible; above it graded, so that they find their way into narrow stations:
/// the farther the path came before its first contact, the lower.
double graded_cost(const CandidateScore& score, double base);

/// A pattern as an optimizer wants it: `objective(measures)` first, contact only where that is under `enough`.
template <class Objective>
Evaluation evaluation_of(CandidateEvaluator& evaluator, const DockingPattern& pattern, double enough, const Objective& objective) {
  CandidateScore score = evaluator.measure(pattern);
  const double value = objective(score.measures);
  if (value >= enough) return {value, 0.0, value};
  evaluator.check(pattern, score);
  return {value, score.violation(), graded_cost(score, value)};
}

}  // namespace waywright
