// The search for the best docking pattern on both sides of the shelf: what comes of each side, as figures. Words are made of them
// elsewhere (pattern_words.hpp), where somebody wants some.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/pattern_options.hpp"
#include "waywright/planner/docking/prepared.hpp"

namespace waywright {

/// How the vehicle comes to the pattern.
struct PatternEntry {
  PatternStart start;
  double speed = 0.0;  ///< m/s backwards, ≥ 0
};

/// What the search on one side came to.
struct SideFound {
  bool wanted = false;     ///< neither left out nor not asked for
  bool searched = false;   ///< at least one candidate was looked at
  bool feasible = false;
  bool given_up = false;   ///< the other side was better by far
  bool refused = false;    ///< by the proof
  std::int64_t evaluations = 0;
  double cost = 0.0;       ///< objective of the best; graded where not feasible
  CandidateScore score;    ///< of the best
  Placement transition;    ///< of the best, world
  DockingPattern pattern;  ///< the best
};

/// One search at a time, as often as wanted. Allocates nothing after its making where the optimizer can be halted.
class PatternSearch {
 public:
  /// @pre all three outlive this
  PatternSearch(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer);
  ~PatternSearch();

  /// Told of the best candidate of all so far, feasible, once it has stood for a while: what comes of it can be made ready for an end at any time.
  /// The side's index, and what it came to.
  using Watch = std::function<void(std::size_t, const SideFound&)>;
  void watch(Watch watch) { watch_ = std::move(watch); }  ///< empty: nobody does

  /// What came of each side, in the order of the task's zones. `evaluations` a side, or what the budget allows for all of them, of which a
  /// part is kept where there is a second choice. Both sides get a first share of the work; then a side that is worse by far than the
  /// other one is given up.
  std::vector<SideFound>& search(const PatternEntry& entry, std::int64_t evaluations, std::uint64_t seed, bool second_choice, Budget& budget);
  /// The last search goes on to so many evaluations a side, those done included; begun anew where the optimizer cannot be halted.
  std::vector<SideFound>& search_on(std::int64_t evaluations, Budget& budget);

 private:
  class OneSide;
  std::vector<SideFound>& compare_sides(Budget& budget);
  const PreparedDocking& prepared_;
  const PatternDockingOptions& options_;
  CandidateEvaluator evaluator_;
  std::vector<std::unique_ptr<OneSide>> sides_;  ///< nullptr: a side that is not searched
  std::vector<SideFound> found_;
  Watch watch_;
  double watched_ = 0.0;  ///< least cost that was told of
};

/// Best feasible one that the proof has not refused, or nullptr; equal costs: the left side.
SideFound* best_of(std::vector<SideFound>& found);

/// What costs are relative to. One reference for both sides, so that their costs can be compared: the shorter of the two reference paths, its
/// change of curvature no more than three bends at the curvature limit.
PathMeasures reference_measures(const PreparedDocking& prepared, const PatternLeads& leads);

/// Less is better; grows with length and with change of curvature.
double objective_value(const PatternDockingOptions& options, const PathMeasures& path, const PathMeasures& reference);

}  // namespace waywright
