// A pattern that is being driven, bent a little: its point of changing direction moves as little as it must for what is left to be free.
#pragma once

#include <memory>
#include <optional>

#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/planner/docking/pattern_options.hpp"

namespace waywright {

class NearbySearch {
 public:
  /// @pre all three outlive this
  NearbySearch(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer);
  NearbySearch(const NearbySearch&) = delete;
  NearbySearch& operator=(const NearbySearch&) = delete;

  /// What is left of a docking pattern, its ends carried along as by continuation(), its transition pose moved by up to 0.3 m each way and
  /// 0.2 rad: the least that was found to serve. Empty where the vehicle has passed that point, the path is no pattern of ours, or nothing
  /// serves. Nothing is proven of what is returned. Allocates nothing where the optimizer can be halted.
  std::optional<Continuation> search(const Path& old, double driven, std::uint64_t seed, Budget& budget);

 private:
  DockingPattern bent(std::span<const double> x) const;

  const PreparedDocking& prepared_;
  const PatternDockingOptions& options_;
  CandidateEvaluator evaluator_;
  SearchSpace space_;
  SearchOptions search_;
  DockingPattern carried_;
  CostFunction cost_;
  const Optimizer& optimizer_;
  std::unique_ptr<ResumableSearch> resumable_;
};

}  // namespace waywright
