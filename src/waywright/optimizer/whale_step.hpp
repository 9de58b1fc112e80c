// The moves of the whale optimisation algorithm (Mirjalili and Lewis 2016, as printed in the RRT*-WOA publication, (2.1)–(2.8)): where one agent goes,
// given its random numbers. Allocates nothing, draws nothing, knows no populations: searches with memory of their own are made of it.
//
// Laws, tested: an agent ends within its bounds; moving bounds, target and agent by a vector moves the result by it (to rounding); with choice = 1
// and threshold = 0 every move is a search, with choice = 1 and an infinite threshold every move encircles, with choice = 0 every move is a spiral.
//
// Not as printed: |C X* − X| depends on where the origin of coordinates is, because C scales them. Here they count from the middle of the bounds.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "waywright/core/elementary.hpp"
#include "waywright/core/exponentials.hpp"
#include "waywright/core/random.hpp"

namespace waywright {

/// Symbols of the publication in brackets. Any finite number is allowed for spiral, the others are ≥ 0; threshold may be infinite.
struct WhaleParameters {
  double start = 2.0;      ///< [a₀] |A| is at most this at the beginning; it falls to 0 in a straight line
  double spiral = 1.0;     ///< [b] how fast the spiral opens
  double choice = 0.5;     ///< [μ] share of the moves that encircle or search; the others are spirals
  double threshold = 1.0;  ///< [λ] |A| under it: encircle the best; else: search about another agent
};

/// [a] of iteration t of T: a₀ (1 − t/T). @pre 0 ≤ t ≤ T, T > 0
inline double whale_reach(double start, std::size_t t, std::size_t iterations) {
  return start * (1.0 - static_cast<double>(t) / static_cast<double>(iterations));
}

/// One agent's random numbers in one iteration.
struct WhaleDraws {
  double r1, r2;  ///< in [0, 1): A = 2 a r₁ − a, C = 2 r₂
  double l;       ///< in [−1, 1): where on the spiral
  double p;       ///< in [0, 1): which move
  static WhaleDraws from(Random& random) {
    WhaleDraws d{};
    d.r1 = random.uniform();
    d.r2 = random.uniform();
    d.l = random.uniform(-1.0, 1.0);
    d.p = random.uniform();
    return d;
  }
};

enum class WhaleMove { encircle, search, spiral };

/// A move, ready to be made: what is the same for all variables.
struct WhaleStep {
  WhaleMove move = WhaleMove::encircle;
  double factor = 0.0;  ///< encircle, search: A; spiral: e^{bl} cos 2πl
  double scale = 1.0;   ///< encircle, search: C
};

inline bool is_whale_spiral(const WhaleParameters& parameters, const WhaleDraws& draws) { return draws.p >= parameters.choice; }
/// e^{bl} cos 2πl
inline double whale_spiral(const WhaleParameters& parameters, double l) {
  return exponential(parameters.spiral * l) * sin_cos(2.0 * std::numbers::pi * l).cos;
}

/// The same of each l in its place, same bits, faster.
inline void whale_spirals(const WhaleParameters& parameters, std::span<double> l) {
  constexpr std::size_t wide = 64;
  std::array<double, wide> growth;
  for (std::size_t first = 0; first < l.size(); first += wide) {
    const std::size_t count = l.size() - first < wide ? l.size() - first : wide;
    for (std::size_t i = 0; i < count; ++i) growth[i] = parameters.spiral * l[first + i];
    exponential_each({growth.data(), count});
    for (std::size_t i = 0; i < count; ++i) l[first + i] = growth[i] * sin_cos(2.0 * std::numbers::pi * l[first + i]).cos;
  }
}

/// @param reach  [a], see whale_reach
inline WhaleStep whale_step_but_spiral(const WhaleParameters& parameters, double reach, const WhaleDraws& draws) {
  const double a = 2.0 * reach * draws.r1 - reach;  // one for all variables: it is compared with the threshold
  return {std::abs(a) < parameters.threshold ? WhaleMove::encircle : WhaleMove::search, a, 2.0 * draws.r2};
}
inline WhaleStep whale_step(const WhaleParameters& parameters, double reach, const WhaleDraws& draws) {
  if (is_whale_spiral(parameters, draws)) return {WhaleMove::spiral, whale_spiral(parameters, draws.l), 1.0};
  return whale_step_but_spiral(parameters, reach, draws);
}

/// Where C counts coordinates from, and whether variables draw numbers of their own.
enum class WhaleForm {
  published,  ///< from the middle of the bounds; all variables of an agent move by the same numbers. Draws it to the middle, and along diagonals: off the middle it
              ///< is worse by orders of magnitude (docs/controls.md has figures)
  unbiased    ///< from the mean of all agents; each variable has its own sign of A and its own l. Ours
};

/// Moves agent x: encircle, search: x ← target − A |C target − x|; spiral: x ← target + e^{bl} cos(2πl) |target − x|, all from the middle of the
/// bounds; then clamped. The target is the best place so far for encircle and spiral, another agent's for search; it may be x itself.
/// @pre all of one length, low ≤ high
inline void make_whale_step(const WhaleStep& step, std::span<const double> target, std::span<const double> low, std::span<const double> high,
                            std::span<double> x) {
  const double factor = step.move == WhaleMove::spiral ? step.factor : -step.factor;
  const double* const t = target.data();
  const double* const lo = low.data();
  const double* const hi = high.data();
  double* const at = x.data();
  for (std::size_t k = 0, n = x.size(); k < n; ++k) {
    const double middle = 0.5 * (lo[k] + hi[k]);
    const double from_target = std::abs(step.scale * (t[k] - middle) - (at[k] - middle));
    const double wanted = t[k] + factor * from_target;
    const double above = wanted < lo[k] ? lo[k] : wanted;  // plain, so that the compiler makes vectors of it
    at[k] = above > hi[k] ? hi[k] : above;
  }
}

/// The unbiased form: the same with coordinates from `origin`, and for each variable a sign of A or a place on the spiral of its own.
/// Law: moving bounds, origin, target and agent by a vector moves the result by it (to rounding), wherever in the bounds they are.
/// @pre as above
inline void make_unbiased_whale_step(const WhaleParameters& parameters, const WhaleStep& step, std::span<const double> target, std::span<const double> origin,
                                     std::span<const double> low, std::span<const double> high, std::span<double> x, Random& random) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    double factor = 0.0;
    const double drawn = random.uniform(-1.0, 1.0);
    if (step.move == WhaleMove::spiral) {
      factor = exponential(parameters.spiral * drawn) * sin_cos(2.0 * std::numbers::pi * drawn).cos;
    } else {
      factor = drawn < 0.0 ? step.factor : -step.factor;
    }
    const double wanted = target[k] + factor * std::abs(step.scale * (target[k] - origin[k]) - (x[k] - origin[k]));
    const double above = wanted < low[k] ? low[k] : wanted;
    x[k] = above > high[k] ? high[k] : above;
  }
}

}  // namespace waywright
