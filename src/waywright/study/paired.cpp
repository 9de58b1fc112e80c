#include "waywright/study/paired.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

/// Share of Student's distribution within ± t. (Abramowitz, Stegun: Handbook of Mathematical Functions, 26.7.3 and 26.7.4.)
double share_within(double t, int freedom) {
  const double angle = arc_tangent(t, std::sqrt(static_cast<double>(freedom)));
  const auto [sine, cosine] = sin_cos(angle);
  const bool is_odd = freedom % 2 == 1;
  double sum = 0.0, term = is_odd ? cosine : 1.0;
  for (int k = is_odd ? 3 : 2; k <= freedom; k += 2) {
    sum += term;
    term *= cosine * cosine * (k - 1.0) / k;
  }
  if (!is_odd) return sine * sum;
  return 2.0 / std::numbers::pi * (angle + sine * sum);
}

}  // namespace

double student_bound(double inside, int freedom) {
  double low = 0.0, high = 1.0;
  while (high < 1e12 && share_within(high, freedom) < inside) high *= 2.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (share_within(middle, freedom) < inside ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

PairedDifference paired_difference(const std::vector<double>& differences, double inside) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto n = static_cast<double>(differences.size());
  PairedDifference result{0.0, -infinity, infinity};
  for (const double d : differences) result.mean += d / n;
  if (differences.size() < 2) return result;
  double squares = 0.0;
  for (const double d : differences) squares += (d - result.mean) * (d - result.mean);
  const double half = student_bound(inside, static_cast<int>(differences.size()) - 1) * std::sqrt(squares / (n - 1.0) / n);
  result.low = result.mean - half;
  result.high = result.mean + half;
  return result;
}

}  // namespace waywright
