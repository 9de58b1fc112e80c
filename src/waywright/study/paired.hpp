// What n runs tell of a difference that was measured run by run, with the same seed on both sides.
#pragma once

#include <vector>

namespace waywright {

/// Student's quantile: a share `inside` in (0, 1) of the distribution lies within ± it. @param freedom ≥ 1, degrees of freedom
double student_bound(double inside, int freedom);

/// The mean of differences and its two-sided interval.
struct PairedDifference {
  double mean = 0.0, low = 0.0, high = 0.0;
};

/// The interval holds the true mean with probability `inside`, as far as the differences are normally distributed; of fewer than two there is none, and it is infinite.
PairedDifference paired_difference(const std::vector<double>& differences, double inside);

}  // namespace waywright
