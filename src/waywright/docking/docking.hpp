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
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/planner/docking/pattern_options.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct DockingPlan {
  Status status = Status::no_path;
  std::string reason;  ///< one sentence; empty where solved, and in a session, which tells it when asked
  Path path;           ///< exact curves, in the order in which they are driven
  std::vector<Sample> samples;  ///< with t and speed; at most 0.05 m and 0.05 rad apart
  Certificate certificate;
  double length = 0.0;       ///< m
  double travel_time = 0.0;  ///< s
  double cost = 0.0;         ///< of the objective; less is better; 0 of a plan that was carried on
  bool is_carried_on = false;  ///< what was left of another plan, no place of it farther off than `moved`
  double moved = 0.0;        ///< m
  bool in_motion = false;    ///< goes on from a vehicle that moves without stopping first
  std::int64_t evaluations = 0;
  bool reproducible = true;  ///< false where the clock or the flag cut the search short
};

class DockingSession;

class Docking {
 public:
  /// Prepares a scenario whose mission is a station. Fields are checked as those of a scenario file: finite numbers, ranges, simple polygons
  /// (repaired where that is safe). Its `start` may be replaced in each plan. Takes some milliseconds; memory: 4 bytes for each 3 cm cell of
  /// the station, at most 4 MiB, and about 200 bytes a segment or scan point of the map.
  static Parsed<Docking> prepare(Scenario scenario, const PatternDockingOptions& options = {}) noexcept;

  Docking(Docking&&) noexcept;
  Docking& operator=(Docking&&) noexcept;
  ~Docking();

  /// Plans from the scenario's start, in motion where `start_motion` says so. Work is at most `options.evaluations` candidates a side (four times as many where none serves), or
  /// what `limits` says; with `limits.seconds` or `cancel` raised, the best plan so far. Safe to call from many threads at once.
  DockingPlan plan(const BudgetLimits& limits = {}, const std::atomic<bool>* cancel = nullptr) const noexcept;

  /// What is left of `old`, which is being driven and was made for this station with its shelf or start elsewhere by centimetres, after
  /// `driven` metres: carried along where that stands (continuation.hpp), else planned anew as by plan(). Prepare it first by from() with what was
  /// measured: handover_at() says where a plan has the vehicle.
  DockingPlan replan(const DockingPlan& old, double driven, const BudgetLimits& limits = {}, const std::atomic<bool>* cancel = nullptr) const noexcept;

  /// The same scenario from another start, with another shelf where one is given, prepared anew.
  Parsed<Docking> from(const Pose& start, const StartMotion& motion = {}, const std::optional<Shelf>& shelf = std::nullopt) const noexcept;

  const Problem& problem() const;

 private:
  friend class DockingSession;
  struct State;
  explicit Docking(std::unique_ptr<const State> state);
  std::unique_ptr<const State> state_;
};

/// One plan after another in the same memory: once it is made, a plan allocates nothing (as long as its path has at most 4096 samples, some
/// 150 m). For one thread at a time; any number of sessions may share a Docking.
class DockingSession {
 public:
  static constexpr std::size_t usual_samples = 4096;
  /// @pre the docking outlives this
  static Parsed<DockingSession> on(const Docking& docking) noexcept;
  DockingSession(DockingSession&&) noexcept;
  DockingSession& operator=(DockingSession&&) noexcept;
  ~DockingSession();

  /// As Docking's. What is returned stays until the next plan. (`old` may be the last plan made here.)
  const DockingPlan& plan(const BudgetLimits& limits = {}, const std::atomic<bool>* cancel = nullptr) noexcept;
  const DockingPlan& replan(const DockingPlan& old, double driven, const BudgetLimits& limits = {}, const std::atomic<bool>* cancel = nullptr) noexcept;
  /// Why the last plan is not solved, in one sentence; empty where it is.
  std::string reason() const noexcept;

 private:
  struct State;
  explicit DockingSession(std::unique_ptr<State> state);
  const DockingPlan& work(const DockingPlan* old, double driven, const BudgetLimits& limits, const std::atomic<bool>* cancel) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace waywright
