#include "waywright/planner/field/sphere_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace waywright {
namespace {

constexpr int least_kappa = 2, most_kappa = 20;
constexpr double greatest_kappa = 4096.0;  // where no whole one up to 20 does
constexpr std::size_t greater_kappas = 2;   // that are enough
constexpr int newton_steps = 60, usual_side = 48;
constexpr int halvings = 60;
constexpr int arcs = 64, finest_arc = 1 << 20;  // of a circle that is gone around

/// Behind a disc, as it is seen from the goal, where the slope along the ray turns: near the rim it leads away from it, farther off to the goal. Empty where something else comes
/// first.
std::optional<Vec2> behind(const NavigationFunction& function, const Disc& disc) {
  const Vec2 from_goal = disc.centre - function.goal();
  const Vec2 u = (1.0 / norm(from_goal)) * from_goal;
  const auto at = [&](double gap) { return disc.centre + (disc.radius + gap) * u; };
  double low = 1e-9 * disc.radius, high = low;
  if (!function.is_free(at(low)) || dot(function.slope(at(low)), u) >= 0.0) return std::nullopt;
  for (;;) {
    high = 1.1 * low;
    if (!function.is_free(at(high))) return std::nullopt;
    if (dot(function.slope(at(high)), u) > 0.0) break;
    low = high;
  }
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (low + high);
    (dot(function.slope(at(middle)), u) > 0.0 ? high : low) = middle;
  }
  return at(low);
}

}  // namespace

double NavigationFunction::distance_to_rim(Vec2 q) const {
  double least = world_.outside.radius - distance(q, world_.outside.centre);
  for (const Disc& disc : world_.obstacles) least = std::min(least, distance(q, disc.centre) - disc.radius);
  return least;
}

bool NavigationFunction::is_free(Vec2 q) const { return distance_to_rim(q) > 0.0; }

// ∇ ln d² = 2(q − g)/d²; ∇ ln β₀ = −2(q − q₀)/β₀; ∇ ln βᵢ = 2(q − qᵢ)/βᵢ. No length unit stands in them.
Vec2 NavigationFunction::slope(Vec2 q) const {
  const Vec2 to = q - goal_;
  Vec2 sum = (2.0 * kappa_ / squared_norm(to)) * to;
  const Vec2 in = q - world_.outside.centre;
  sum = sum + (2.0 / (world_.outside.radius * world_.outside.radius - squared_norm(in))) * in;
  for (const Disc& disc : world_.obstacles) {
    const Vec2 away = q - disc.centre;
    sum = sum - (2.0 / (squared_norm(away) - disc.radius * disc.radius)) * away;
  }
  return sum;
}

// The Hessian of ln(|v|² − c) is 2/b·I − 4/b²·v·vᵀ with b = |v|² − c.
SymmetricMatrix NavigationFunction::curvature(Vec2 q) const {
  SymmetricMatrix sum;
  const auto add = [&](double weight, Vec2 v, double b) {
    const double even = 2.0 * weight / b, bent = 4.0 * weight / (b * b);
    sum.xx += even - bent * v.x * v.x;
    sum.xy -= bent * v.x * v.y;
    sum.yy += even - bent * v.y * v.y;
  };
  const Vec2 to = q - goal_, in = q - world_.outside.centre;
  add(kappa_, to, squared_norm(to));
  add(-1.0, in, squared_norm(in) - world_.outside.radius * world_.outside.radius);  // ln β₀ = ln(−b)
  for (const Disc& disc : world_.obstacles) {
    const Vec2 away = q - disc.centre;
    add(-1.0, away, squared_norm(away) - disc.radius * disc.radius);
  }
  return sum;
}

double NavigationFunction::logarithm(Vec2 q) const {
  const double unit = world_.outside.radius * world_.outside.radius;
  double f = kappa_ * std::log(squared_norm(q - goal_) / unit) - std::log((unit - squared_norm(q - world_.outside.centre)) / unit);
  for (const Disc& disc : world_.obstacles) f -= std::log((squared_norm(q - disc.centre) - disc.radius * disc.radius) / unit);
  return f;
}

double NavigationFunction::value(Vec2 q) const {
  if (q == goal_) return 0.0;
  if (!is_free(q)) return 1.0;
  const double f = logarithm(q);
  // (1 + e^−f)^(−1/κ), from whichever side does not overflow.
  const double log_sum = f > 0.0 ? std::log1p(std::exp(-f)) : std::log1p(std::exp(f)) - f;
  return std::exp(-log_sum / kappa_);
}

Vec2 NavigationFunction::gradient(Vec2 q) const {
  if (q == goal_ || !is_free(q)) return {};
  // dφ/df = φ/κ·(1 − φ^κ).
  const double f = logarithm(q);
  const double rest = f > 0.0 ? std::exp(-f) / (1.0 + std::exp(-f)) : 1.0 / (1.0 + std::exp(f));
  return (value(q) * rest / kappa_) * slope(q);
}

std::vector<CriticalPoint> critical_points(const NavigationFunction& function, int side, const std::function<bool()>& stops) {
  const Disc& outside = function.world().outside;
  const double same = 1e-6 * outside.radius, longest = 0.05 * outside.radius;
  std::vector<CriticalPoint> found;
  const auto from = [&](Vec2 q) -> std::optional<Vec2> {
    for (int k = 0; k < newton_steps; ++k) {
      if (distance(q, function.goal()) < 1e-4 * outside.radius) return std::nullopt;
      const Vec2 g = function.slope(q);
      const SymmetricMatrix h = function.curvature(q);
      const double det = h.determinant();
      if (det == 0.0 || !std::isfinite(det)) return std::nullopt;
      Vec2 step{(h.xy * g.y - h.yy * g.x) / det, (h.xy * g.x - h.xx * g.y) / det};
      if (const double far = norm(step); far > longest) step = (longest / far) * step;
      Vec2 next = q + step;
      for (int halves = 0; !function.is_free(next) && halves < 30; ++halves) next = q + (step = 0.5 * step);
      if (!function.is_free(next)) return std::nullopt;
      q = next;
      if (norm(step) < 1e-13 * outside.radius) return q;
    }
    return norm(function.slope(q)) * outside.radius < 1e-7 ? std::optional{q} : std::nullopt;
  };
  const auto look = [&](Vec2 q) {
    const auto at = from(q);
    if (!at || std::any_of(found.begin(), found.end(), [&](const CriticalPoint& c) { return distance(c.at, *at) < same; })) return;
    const SymmetricMatrix h = function.curvature(*at);
    found.push_back({*at, h.determinant() > 0.0 && h.xx > 0.0});
  };
  for (const Disc& disc : function.world().obstacles) {
    if (stops && stops()) return found;
    if (const auto q = behind(function, disc)) look(*q);
  }
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const Vec2 q = outside.centre + outside.radius * Vec2{2.0 * (i + 0.5) / side - 1.0, 2.0 * (j + 0.5) / side - 1.0};
      if (!function.is_free(q)) continue;
      if (stops && stops()) return found;
      look(q);
    }
  }
  std::sort(found.begin(), found.end(), [](const CriticalPoint& a, const CriticalPoint& b) { return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y < b.at.y; });
  return found;
}

bool leads_to_goal(const std::vector<CriticalPoint>& points, const SphereWorld& world) {
  return points.size() == world.obstacles.size() && std::none_of(points.begin(), points.end(), [](const CriticalPoint& c) { return c.is_minimum; });
}

std::vector<double> kappas_that_lead_to_goal(const SphereWorld& world, Vec2 goal, const std::function<bool()>& stops, std::size_t most) {
  std::vector<double> all;
  for (int kappa = least_kappa; kappa <= most_kappa && all.size() < most; ++kappa) {
    const bool leads = leads_to_goal(critical_points({world, goal, static_cast<double>(kappa)}, usual_side, stops), world);
    if (stops && stops()) break;
    if (leads) all.push_back(kappa);
  }
  // 24, 32, 48, 64 …
  double next = 24.0;
  for (bool is_half = true; all.size() < greater_kappas && next <= greatest_kappa && (all.empty() || all.front() > most_kappa); is_half = !is_half) {
    const bool leads = leads_to_goal(critical_points({world, goal, next}, usual_side, stops), world);
    if (stops && stops()) break;
    if (leads) all.push_back(next);
    next *= is_half ? 4.0 / 3.0 : 1.5;
  }
  return all;
}

std::optional<int> turns_around(const NavigationFunction& function, Vec2 centre, double radius) {
  const auto slope_at = [&](int k, int of) -> std::optional<Vec2> {
    const Vec2 q = centre + radius * unit(k * (two_pi / of));
    if (!function.is_free(q)) return std::nullopt;
    const Vec2 slope = function.slope(q);
    if (!(norm(slope) > 0.0)) return std::nullopt;
    return slope;
  };
  // Arcs are divided until the slope turns by less than an eighth of a turn between their ends, twice over.
  double turned = 0.0;
  const std::function<bool(int, int)> add = [&](int k, int of) {
    const auto a = slope_at(k, of), m = slope_at(2 * k + 1, 2 * of), b = slope_at(k + 1, of);
    if (!a || !m || !b) return false;
    const double first = arc_tangent(cross(*a, *m), dot(*a, *m)), second = arc_tangent(cross(*m, *b), dot(*m, *b));
    if (std::abs(first) < 0.25 * pi && std::abs(second) < 0.25 * pi) {
      turned += first + second;
      return true;
    }
    return of < finest_arc && add(2 * k, 2 * of) && add(2 * k + 1, 2 * of);
  };
  for (int k = 0; k < arcs; ++k) {
    if (!add(k, arcs)) return std::nullopt;
  }
  return static_cast<int>(std::lround(turned / two_pi));
}

std::optional<Vec2> way_off(const SymmetricMatrix& m) {
  const double middle = 0.5 * (m.xx + m.yy), half = 0.5 * (m.xx - m.yy);
  const double least = middle - std::sqrt(half * half + m.xy * m.xy);
  if (!(least < 0.0)) return std::nullopt;
  // Of the two rows of M − least·I the longer one; the vector is across it.
  const Vec2 first{m.xx - least, m.xy}, second{m.xy, m.yy - least};
  const Vec2 row = squared_norm(first) > squared_norm(second) ? first : second;
  if (row == Vec2{}) return Vec2{1.0, 0.0};
  return (1.0 / norm(row)) * left_of(row);
}

std::optional<Vec2> minimum_near(const std::function<Vec2(Vec2)>& slope, const std::function<SymmetricMatrix(Vec2)>& curvature, const std::function<double(Vec2)>& rim, Vec2 from, double within) {
  constexpr double vanished = 1e-6;  // of a step's length over `within`
  Vec2 q = from;
  for (int k = 0; k < newton_steps; ++k) {
    const Vec2 g = slope(q);
    const SymmetricMatrix h = curvature(q);
    const double det = h.determinant();
    if (!std::isfinite(det) || !(std::abs(det) > 0.0)) return std::nullopt;
    const Vec2 step{(h.xy * g.y - h.yy * g.x) / det, (h.xy * g.x - h.xx * g.y) / det};
    if (!(norm(step) <= 2.0 * within)) return std::nullopt;
    if (norm(step) < vanished * within) return det > 0.0 && h.xx > 0.0 ? std::optional{q} : std::nullopt;
    q = q + step;
    if (!(distance(q, from) <= within) || !(rim(q) > 0.0)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace waywright
