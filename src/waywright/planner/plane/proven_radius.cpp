#include "waywright/planner/plane/proven_radius.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace waywright {
namespace {

constexpr std::array<double, 16> odd_shares = [] {  // 1, 1/3, 1/5, …
  std::array<double, 16> shares{};
  for (std::size_t k = 0; k < shares.size(); ++k) shares[k] = 1.0 / static_cast<double>(2 * k + 1);
  return shares;
}();

/// Natural logarithm from plain arithmetic, the same bits everywhere: x = m·2^e, ln m by its series about 1. Error under 1e-12, for radii. @pre x ≥ 1
double logarithm(double x) {
  int exponent = 0;
  while (x > 1.5) {
    x *= 0.5;
    ++exponent;
  }
  const double y = (x - 1.0) / (x + 1.0), y2 = y * y;
  double sum = 0.0;
  for (std::size_t k = odd_shares.size(); k-- > 0;) sum = sum * y2 + odd_shares[k];
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
