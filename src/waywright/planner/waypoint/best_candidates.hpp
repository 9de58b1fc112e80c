// The best candidates of a search, for the proof: it may refuse what the search's samples did not see.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

/// The best candidates seen, best last: the best one, and of those before it some that cost ever more.
class BestCandidates {
 public:
  struct Candidate {
    std::vector<double> x;
    Evaluation evaluation;
  };

  void look(std::span<const double> x, const Evaluation& evaluation) {
    if (!kept_.empty() && !(evaluation.graded < kept_.back().evaluation.graded)) return;
    if (const std::size_t n = kept_.size(); n >= 2) {
      const double last = kept_[n - 1].evaluation.graded, before = kept_[n - 2].evaluation.graded;
      if (before - last < apart * std::abs(last)) kept_.pop_back();
    }
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    kept_.push_back({{x.begin(), x.end()}, evaluation});
  }
  const std::vector<Candidate>& kept() const { return kept_; }

 private:
  static constexpr std::size_t most_kept = 64;
  static constexpr double apart = 1e-3;  // of a cost: those nearer to one another are likely to be refused together
  std::vector<Candidate> kept_;
};

}  // namespace waywright
