#include "waywright/planner/plane/proven_radius.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace waywright {
namespace {

/// Natural logarithm from plain arithmetic, the same bits everywhere: x = m·2^e, ln m by its series about 1. Error under 1e-12, for radii. @pre x ≥ 1
double logarithm(double x) {
  int exponent = 0;
  while (x > 1.5) {
    x *= 0.5;
    ++exponent;
  }
  const double y = (x - 1.0) / (x + 1.0), y2 = y * y;
  double sum = 0.0;
  for (int k = 15; k >= 0; --k) sum = sum * y2 + 1.0 / (2 * k + 1);
  return 2.0 * y * sum + exponent * std::numbers::ln2;
}

}  // namespace

double proven_radius(double free_area, double places) {
  const double n = std::max(2.0, places);
  return 1.0001 * 2.0 * std::sqrt(1.5) * std::sqrt(free_area / std::numbers::pi) * std::sqrt(logarithm(n) / n);
}

int proven_neighbours(double states) {
  constexpr double dimensions = 3.0;
  return static_cast<int>(std::numbers::e * (1.0 + 1.0 / dimensions) * logarithm(std::max(2.0, states))) + 1;
}

}  // namespace waywright
