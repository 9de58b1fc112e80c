// How much work a planner may do, and how it is told to stop.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

namespace waywright {

/// What the scenario allows; an absent field is the planner's documented default.
struct BudgetLimits {
  std::optional<std::int64_t> evaluations;  ///< candidate paths evaluated, ≥ 1
  std::optional<std::int64_t> expansions;   ///< nodes expanded, ≥ 1
  std::optional<std::int64_t> samples;      ///< states sampled, ≥ 1
  std::optional<double> seconds;            ///< wall clock, > 0; makes a run irreproducible where it cuts it short
};

/// A run's budget: counts the work and answers "may I go on?". One run, one thread;
/// `cancel` points to a flag that any thread (or a signal handler) may raise.
class Budget {
 public:
  explicit Budget(BudgetLimits limits = {}, const std::atomic<bool>* cancel = nullptr)
      : limits_{limits}, cancel_{cancel}, begin_{Clock::now()} {}

  const BudgetLimits& limits() const { return limits_; }
  std::int64_t evaluations() const { return evaluations_; }
  void count_evaluations(std::int64_t n = 1) { evaluations_ += n; }

  std::int64_t expansions() const { return expansions_; }
  void count_expansions(std::int64_t n) { expansions_ += n; }

  /// What the limit leaves, ≥ 0.
  std::optional<std::int64_t> evaluations_left() const {
    if (!limits_.evaluations) return std::nullopt;
    return *limits_.evaluations > evaluations_ ? *limits_.evaluations - evaluations_ : 0;
  }

  bool canceled() const { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }
  bool timed_out() {
    if (!limits_.seconds) return false;
    if (elapsed() >= *limits_.seconds) cut_short_ = true;
    return cut_short_;
  }
  /// True where the clock or the flag ends the run; asked at every evaluation.
  bool exhausted() { return canceled() || timed_out(); }
  /// The wall clock changed what the answer is.
  bool cut_short() const { return cut_short_; }
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  std::optional<double> seconds_left() const {
    if (!limits_.seconds) return std::nullopt;
    return *limits_.seconds - elapsed();
  }
  const std::atomic<bool>* cancel_flag() const { return cancel_; }

 private:
  using Clock = std::chrono::steady_clock;
  BudgetLimits limits_;
  const std::atomic<bool>* cancel_;
  Clock::time_point begin_;
  std::int64_t evaluations_ = 0;
  std::int64_t expansions_ = 0;
  bool cut_short_ = false;
};

}  // namespace waywright
