// The G1 Hermite problem by clothoids: Bertolazzi and Frego 2015. With the chord as unit and x axis, headings φ0 and φ1 against it and δ = φ1 − φ0, the
// phase is P(τ) = Aτ² + (δ − A)τ + φ0 over τ in [0, 1], and A is a root of ∫ sin P for which ∫ cos P, the chord over the length, is positive.
#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/curve/clothoid.hpp"
#include "waywright/curve/lanes/kernels.hpp"

namespace waywright {
namespace {

constexpr int most_steps = 12;
constexpr double widest = 24.0;       // of A: roots of short curves lie within 3 (|φ0| + |φ1|) ≤ 6π
constexpr double near_root = 1e-6;   // of ∫ sin P, from where one more step is enough: the error is squared
constexpr double least_share = 0.02;  // chord over length: curves longer than 50 chords come of both headings pointing back, one as −π, one as π

using clothoid_lanes::Moments;

Moments moments(double a, double delta, double phi0) {
  static const clothoid_lanes::Kernels& kernels = clothoid_lanes::best();
  const double turning = std::abs(delta) + std::abs(a);  // at least the greatest slope of the phase
  return kernels.moments(a, delta, phi0, turning <= 1.0 ? 0 : static_cast<int>(std::ceil(turning / 8.0)));
}

/// Of the publication: a polynomial near the root everywhere.
double first_guess(double phi0, double phi1) {
  const double x = phi0 / pi, y = phi1 / pi;
  const double p = x * y, q = x * x + y * y;
  return (phi0 + phi1) * (2.989696028701907 + p * (0.716228953608281 - 0.458969738821509 * p) + q * (-0.502821153340377 + 0.261062141752652 * p - 0.045854475238709 * q));
}

struct Root {
  double a, share;  // A; chord over length
};

std::optional<Root> newton(double a, double delta, double phi0) {
  for (int i = 0; i < most_steps; ++i) {
    const Moments m = moments(a, delta, phi0);
    const double step = -m.across / m.across_slope;
    if (!std::isfinite(step)) return std::nullopt;
    a += step;
    if (!(std::abs(a) <= widest)) return std::nullopt;
    if (std::abs(m.across) > near_root || std::abs(step) > near_root) continue;
    const double share = m.along + m.along_slope * step;
    if (share < least_share) return std::nullopt;
    return Root{a, share};
  }
  return std::nullopt;
}

/// Where Newton went astray: the root of the greatest share, that is of the shortest clothoid, among those bracketed by a fine grid.
std::optional<Root> scanned(double delta, double phi0) {
  constexpr int cells = 480;
  const auto at = [&](int i) { return widest * (2.0 * i / cells - 1.0); };
  std::optional<Root> best;
  double before = moments(at(0), delta, phi0).across;
  for (int i = 1; i <= cells; ++i) {
    const double across = moments(at(i), delta, phi0).across;
    if ((across > 0.0) != (before > 0.0)) {
      double low = at(i - 1), high = at(i);
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((moments(middle, delta, phi0).across > 0.0) == (before > 0.0) ? low : high) = middle;
      }
      const double share = moments(low, delta, phi0).along;
      if (share > 0.0 && (!best || share > best->share)) best = Root{low, share};
    }
    before = across;
  }
  return best;
}

struct Fit {
  double delta;
  Root root;
};

/// Turning by whole circles more or less leads to the same headings.
std::optional<Fit> shortest(double delta, double phi0) {
  std::optional<Fit> best;
  for (const double turns : {delta, delta - two_pi, delta + two_pi}) {
    const auto root = scanned(turns, phi0);
    if (root && (!best || root->share > best->root.share)) best = Fit{turns, *root};
  }
  return best;
}

/// What is asked of a pair of poses: headings against the chord.
struct Hermite {
  double r = 0.0, delta = 0.0, phi0 = 0.0, phi1 = 0.0;
};

std::optional<Hermite> hermite_of(const Pose& from, const Pose& to) {
  const Vec2 chord = to.position() - from.position();
  const double r = norm(chord);
  if (!(r > 0.0) || !std::isfinite(r) || !std::isfinite(from.heading) || !std::isfinite(to.heading)) return std::nullopt;
  const double along = angle_of(chord);
  const double phi0 = wrap(from.heading - along);
  const double phi1 = wrap(to.heading - along);
  return Hermite{r, phi1 - phi0, phi0, phi1};
}

std::optional<Clothoid> clothoid_of(const Pose& from, double r, const Fit& fit) {
  const double length = r / fit.root.share;
  const Clothoid clothoid{from, (fit.delta - fit.root.a) / length, 2.0 * fit.root.a / (length * length), length};
  if (!std::isfinite(clothoid.curvature) || !std::isfinite(clothoid.curvature_rate) || !std::isfinite(length)) return std::nullopt;
  return clothoid;
}

std::optional<Clothoid> shortest_from(const Pose& from, const Hermite& h) {
  const auto fit = shortest(h.delta, h.phi0);
  return fit ? clothoid_of(from, h.r, *fit) : std::nullopt;
}

}  // namespace

std::optional<Clothoid> fit_clothoid(const Pose& from, const Pose& to) {
  const auto h = hermite_of(from, to);
  if (!h) return std::nullopt;
  const auto root = newton(first_guess(h->phi0, h->phi1), h->delta, h->phi0);
  return root ? clothoid_of(from, h->r, {h->delta, *root}) : shortest_from(from, *h);
}

void fit_clothoid_batch(std::span<const Pose> from, std::span<const Pose> to, std::span<std::optional<Clothoid>> fitted) {
  constexpr std::size_t width = clothoid_lanes::width;
  static const clothoid_lanes::Kernels& kernels = clothoid_lanes::best();
  for (std::size_t first = 0; first < from.size(); first += width) {
    const std::size_t count = std::min(width, from.size() - first);
    clothoid_lanes::Fits fits;
    std::array<std::optional<Hermite>, width> problems;
    for (std::size_t k = 0; k < width; ++k) {
      if (k < count) problems[k] = hermite_of(from[first + k], to[first + k]);
      const Hermite h = problems[k].value_or(Hermite{});
      fits.delta[k] = h.delta;
      fits.phi0[k] = h.phi0;
      fits.a[k] = first_guess(h.phi0, h.phi1);
    }
    kernels.fit(fits, widest, least_share);
    for (std::size_t k = 0; k < count; ++k) {
      const Pose& at = from[first + k];
      fitted[first + k] = !problems[k]     ? std::nullopt
                          : fits.solved[k] ? clothoid_of(at, problems[k]->r, {problems[k]->delta, {fits.a[k], fits.share[k]}})
                                           : shortest_from(at, *problems[k]);
    }
  }
}

}  // namespace waywright
