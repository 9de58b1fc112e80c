// Scalar polynomials in Bernstein form on [0, 1]: their coefficients bound them, and halving makes the bounds converge
// quadratically (Farouki: The Bernstein polynomial basis, a centennial retrospective, 2012).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace waywright {

/// Degree ≤ 16. Law: min c ≤ p(u) ≤ max c for u in [0, 1].
struct Bernstein {
  static constexpr std::size_t capacity = 17;
  std::size_t degree = 0;
  std::array<double, capacity> c{};

  double low() const { return *std::min_element(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(degree) + 1); }
  double high() const { return *std::max_element(c.begin(), c.begin() + static_cast<std::ptrdiff_t>(degree) + 1); }
};

inline constexpr auto binomials = [] {
  std::array<std::array<double, Bernstein::capacity>, Bernstein::capacity> table{};
  for (std::size_t n = 0; n < Bernstein::capacity; ++n) {
    table[n][0] = table[n][n] = 1.0;
    for (std::size_t k = 1; k < n; ++k) table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
  }
  return table;
}();

/// Exact product; degrees add. @pre the sum of degrees is at most 16
inline Bernstein operator*(const Bernstein& a, const Bernstein& b) {
  Bernstein product;
  product.degree = a.degree + b.degree;
  std::array<double, Bernstein::capacity> weighted{};
  for (std::size_t j = 0; j <= b.degree; ++j) weighted[j] = binomials[b.degree][j] * b.c[j];
  for (std::size_t i = 0; i <= a.degree; ++i) {
    const double factor = binomials[a.degree][i] * a.c[i];
    for (std::size_t j = 0; j <= b.degree; ++j) product.c[i + j] += factor * weighted[j];
  }
  for (std::size_t k = 0; k <= product.degree; ++k) product.c[k] /= binomials[product.degree][k];
  return product;
}

/// @pre equal degrees
inline Bernstein combine(double p, const Bernstein& a, double q, const Bernstein& b) {
  Bernstein sum;
  sum.degree = a.degree;
  for (std::size_t i = 0; i <= a.degree; ++i) sum.c[i] = p * a.c[i] + q * b.c[i];
  return sum;
}

/// Derivative with respect to u; a constant's is the constant 0.
inline Bernstein derivative(const Bernstein& a) {
  Bernstein d;
  if (a.degree == 0) return d;
  d.degree = a.degree - 1;
  for (std::size_t i = 0; i < a.degree; ++i) d.c[i] = static_cast<double>(a.degree) * (a.c[i + 1] - a.c[i]);
  return d;
}

/// The same polynomial on [0, ½] and on [½, 1].
inline void halve(const Bernstein& a, Bernstein& left, Bernstein& right) {
  left.degree = right.degree = a.degree;
  auto c = a.c;
  left.c[0] = c[0];
  right.c[a.degree] = c[a.degree];
  for (std::size_t level = 1; level <= a.degree; ++level) {
    for (std::size_t i = 0; i + level <= a.degree; ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
    left.c[level] = c[0];
    right.c[a.degree - level] = c[a.degree - level];
  }
}

}  // namespace waywright
