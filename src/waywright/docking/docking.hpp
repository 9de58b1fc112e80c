// Docking for a vehicle's own program: a station is prepared once, then plans are made from wherever the vehicle stands. Needs the
// standard library alone at run time: no files, no threads, no logging, no global state; nothing is thrown across this border.
//
// The same work as the command line's planner `pattern_docking` without a second choice: both sides of the shelf, transition point and
// heading searched, the best pattern proven, speed assigned. The same input gives the same bits.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/docking/pattern_docking.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct DockingPlan {
  Status status = Status::no_path;
  std::string reason;  ///< one sentence; empty where solved
  Path path;           ///< exact curves, in the order in which they are driven
  std::vector<Sample> samples;  ///< with t and speed; at most 0.05 m and 0.05 rad apart
  Certificate certificate;
  double length = 0.0;       ///< m
  double travel_time = 0.0;  ///< s
  double cost = 0.0;         ///< of the objective; less is better
  std::int64_t evaluations = 0;
  bool reproducible = true;  ///< false where the clock or the flag cut the search short
};

class Docking {
 public:
  /// Prepares a scenario whose mission is a station. Fields are checked as those of a scenario file: finite numbers, ranges, simple polygons
  /// (repaired where that is safe). Its `start` may be replaced in each plan. Takes some milliseconds; memory: 4 bytes for each 3 cm cell of
  /// the station, at most 4 MiB, and about 200 bytes a segment or scan point of the map.
  static Parsed<Docking> prepare(Scenario scenario, const PatternDockingOptions& options = {}) noexcept;

  Docking(Docking&&) noexcept;
  Docking& operator=(Docking&&) noexcept;
  ~Docking();

  /// Plans from the scenario's start. Work is at most `options.evaluations` candidates a side (five times as many where none serves), or
  /// what `limits` says; with `limits.seconds` or `cancel` raised, the best plan so far. Safe to call from many threads at once.
  DockingPlan plan(const BudgetLimits& limits = {}, const std::atomic<bool>* cancel = nullptr) const noexcept;

  /// The same scenario from another start, prepared anew.
  Parsed<Docking> from(const Pose& start) const noexcept;

  const Problem& problem() const;

 private:
  struct State;
  explicit Docking(std::unique_ptr<const State> state);
  std::unique_ptr<const State> state_;
};

}  // namespace waywright
