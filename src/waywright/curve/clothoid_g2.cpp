// Curvature is linear between four knots: κ0 at 0, κa at ¼, κb at ¾ and κ1 at 1 of the length L. The heading at the end ties κb to κa and L; the end's
// position gives two equations for those two.
#include "waywright/curve/clothoid_g2.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/clothoid.hpp"
#include "waywright/curve/gauss.hpp"

namespace waywright {
namespace {

constexpr double outer = 0.25, inner = 0.5;  // shares of the length
constexpr int most_steps = 40;
constexpr double enough = 1e-12;             // of the chord
constexpr double most_turning = 400.0;       // rad, what the panels are for
constexpr double longest = 8.0;              // chords: longer ones are loops

/// Integrals over τ of the hat functions of the four knots, up to τ.
std::array<double, 4> hats(double t) {
  if (t <= outer) {
    const double a = t * t / (2.0 * outer);
    return {t - a, a, 0.0, 0.0};
  }
  if (t <= outer + inner) {
    const double u = t - outer;
    const double b = u * u / (2.0 * inner);
    return {0.5 * outer, 0.5 * outer + u - b, b, 0.0};
  }
  const double u = t - outer - inner;
  const double c = u * u / (2.0 * outer);
  return {0.5 * outer, 0.5 * (outer + inner), 0.5 * inner + u - c, c};
}
constexpr double full_hat = 0.5 * (outer + inner);  // of κa and κb over the whole

struct Unknowns {
  double a, length;  // κa, L
};

struct Task {
  double heading, turning;  // at the start; of the whole curve
  double k0, k1;
  Vec2 chord{};

  double b_of(const Unknowns& x) const { return (turning / x.length - 0.5 * outer * (k0 + k1)) / full_hat - x.a; }
};

struct Residual {
  Vec2 off{};             // m, of the end
  Vec2 by_a{}, by_length{};  // its derivatives
};

Residual residual(const Task& task, const Unknowns& x) {
  const double b = task.b_of(x);
  const double b_by_length = -task.turning / (x.length * x.length) / full_hat;
  Residual r;
  Vec2 along{};
  const auto add = [&](double t, double weight) {
    const auto [h0, ha, hb, h1] = hats(t);
    const double phase = task.k0 * h0 + x.a * ha + b * hb + task.k1 * h1;
    const SinCos d = sin_cos(task.heading + x.length * phase);
    const Vec2 normal{-d.sin, d.cos};
    along = along + weight * Vec2{d.cos, d.sin};
    r.by_a = r.by_a + (weight * x.length * x.length * (ha - hb)) * normal;
    r.by_length = r.by_length + (weight * x.length * (phase + x.length * hb * b_by_length)) * normal;
  };
  const std::array knots{task.k0, x.a, b, task.k1};
  const std::array ends{0.0, outer, outer + inner, 1.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = ends[i + 1] - ends[i];
    const double turn = std::max(std::abs(knots[i]), std::abs(knots[i + 1])) * x.length * share;
    const int panels = turn <= most_turning ? static_cast<int>(std::max(1.0, std::ceil(turn / 8.0))) : 1;  // more is refused
    for (int k = 0; k < panels; ++k) {
      const double half = 0.5 * share / panels;
      const double middle = ends[i] + (2.0 * k + 1.0) * half;
      const auto all = [&](const auto& rule) {
        for (std::size_t n = 0; n < rule.size; ++n) {
          add(middle - half * rule.node[n], half * rule.weight[n]);
          add(middle + half * rule.node[n], half * rule.weight[n]);
        }
      };
      turn <= 1.0 ? all(gauss_8) : all(gauss_16);
    }
  }
  r.off = x.length * along - task.chord;
  r.by_length = r.by_length + along;
  return r;
}

}  // namespace

std::optional<ClothoidTriple> fit_clothoids(const CurvaturePose& from, const CurvaturePose& to) {
  const auto single = fit_clothoid(from.pose, to.pose);
  if (!single || !std::isfinite(from.curvature) || !std::isfinite(to.curvature)) return std::nullopt;
  const double chord = distance(from.pose.position(), to.pose.position());
  const Task task{from.pose.heading, course_at(*single, single->length) - from.pose.heading, from.curvature, to.curvature, to.pose.position() - from.pose.position()};
  if (!(std::max(std::abs(from.curvature), std::abs(to.curvature)) * single->length <= most_turning)) return std::nullopt;
  Unknowns x{single->curvature + single->curvature_rate * outer * single->length, single->length};
  Residual r = residual(task, x);
  for (int i = 0; !(norm(r.off) <= enough * chord); ++i) {
    const double det = cross(r.by_a, r.by_length);
    if (i == most_steps || !(std::abs(det) > 0.0) || !std::isfinite(det)) return std::nullopt;
    const Unknowns step{-cross(r.off, r.by_length) / det, -cross(r.by_a, r.off) / det};
    // Newton, its step shortened until the end comes nearer.
    bool is_nearer = false;
    for (double share = 1.0; share > 1e-3 && !is_nearer; share *= 0.5) {
      const Unknowns next{x.a + share * step.a, x.length + share * step.length};
      if (!(next.length > 0.5 * chord && next.length < longest * chord)) continue;
      const Residual there = residual(task, next);
      if (!(norm(there.off) < norm(r.off))) continue;
      is_nearer = true;
      x = next;
      r = there;
    }
    if (!is_nearer) {
      if (norm(r.off) <= 1e-10 * chord) break;  // rounding
      return std::nullopt;
    }
  }
  const double b = task.b_of(x);
  const double sharpest = std::max({std::abs(task.k0), std::abs(x.a), std::abs(b), std::abs(task.k1)});
  if (!(sharpest * x.length <= most_turning)) return std::nullopt;
  const double l0 = outer * x.length, l1 = inner * x.length;
  ClothoidTriple triple;
  triple[0] = {from.pose, task.k0, (x.a - task.k0) / l0, l0};
  const CurvePoint first = evaluate(triple[0], l0);
  triple[1] = {make_pose(first.position, course_at(triple[0], l0)), x.a, (b - x.a) / l1, l1};
  const CurvePoint second = evaluate(triple[1], l1);
  triple[2] = {make_pose(second.position, course_at(triple[1], l1)), b, (task.k1 - b) / l0, l0};
  return triple;
}

}  // namespace waywright
