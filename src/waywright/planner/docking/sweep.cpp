#include "waywright/planner/docking/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

constexpr int most_halvings = 5;

Vec2 placed(const SweptQuintic::State& at, Vec2 p) {
  return at.position + p.x * at.heading + p.y * left_of(at.heading);
}

/// How far a pose between can be from the straight interpolation of both ends, with half as much again for what the derivatives do
/// between them.
double bow(const SweptQuintic::State& a, const SweptQuintic::State& b, double h, double radius) {
  const double position = h * h / 8.0 * std::max(norm(a.acceleration), norm(b.acceleration));
  const double turned = h * std::max(std::abs(a.turn_rate), std::abs(b.turn_rate));
  const double heading = h / 8.0 * std::abs(b.turn_rate - a.turn_rate);
  return 1.5 * (position + radius * (turned * turned / 8.0 + heading));
}

}  // namespace

SweptQuintic::State SweptQuintic::at(double u) const {
  const Derivatives d = derivatives(span, u);
  const double speed2 = squared_norm(d.d1);
  State state;
  state.position = d.p;
  state.acceleration = d.d2;
  if (speed2 > 0.0) {
    state.heading = ((direction < 0 ? -1.0 : 1.0) / std::sqrt(speed2)) * d.d1;
    state.turn_rate = cross(d.d1, d.d2) / speed2;
  }
  return state;
}

Sweep::Sweep(const PreparedDocking& prepared) : prepared_{prepared} {
  std::size_t most = 0;
  for (const Ring& part : prepared.parts()) most = std::max(most, part.size());
  corners_.reserve(2 * most);
  hull_.reserve(4 * most);
}

bool Sweep::hulls_are_clear(const State& a, const State& b, double margin) {
  for (const Ring& part : prepared_.parts()) {
    corners_.clear();
    for (const Vec2 p : part) corners_.push_back(placed(a, p));
    for (const Vec2 p : part) corners_.push_back(placed(b, p));
    convex_hull(corners_, hull_);
    if (!prepared_.problem().world().is_free(hull_, margin + prepared_.disc())) return false;
  }
  return true;
}

bool Sweep::between(const SweptQuintic& quintic, double u0, const State& a, double u1, const State& b, double margin,
                    int halvings) {
  if (hulls_are_clear(a, b, margin + bow(a, b, u1 - u0, prepared_.radius()))) return true;
  if (halvings == 0 || !hulls_are_clear(b, b, margin)) return false;
  const double u = 0.5 * (u0 + u1);
  const State middle = quintic.at(u);
  return between(quintic, u0, a, u, middle, margin, halvings - 1) && between(quintic, u, middle, u1, b, margin, halvings - 1);
}

bool Sweep::is_clear(const SweptQuintic& quintic, double u0, double u1, double margin) {
  return between(quintic, u0, quintic.at(u0), u1, quintic.at(u1), margin, most_halvings);
}

bool Sweep::is_clear(Vec2 from, Vec2 to, Vec2 heading, double margin) {
  return hulls_are_clear({from, heading, {}, 0.0}, {to, heading, {}, 0.0}, margin);
}

}  // namespace waywright
