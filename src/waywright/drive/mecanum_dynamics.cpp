#include "waywright/drive/mecanum_dynamics.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double gravity = 9.80665;  // m/s²
constexpr double smooth = 0.05;      // rad/s: under it friction grows evenly with speed, so that no step jumps over standing still

double sign_of(double speed) { return std::clamp(speed / smooth, -1.0, 1.0); }

double greatest(const MecanumTorques& t) { return std::max({std::abs(t.front_left), std::abs(t.front_right), std::abs(t.rear_left), std::abs(t.rear_right)}); }

}  // namespace

MecanumBody loaded(const MecanumBody& body, double mass, double own, Vec2 at) {
  MecanumBody both = body;
  both.mass += mass;
  both.inertia += own + mass * squared_norm(at);
  return both;
}

double even_inertia(const Footprint& footprint, double mass) {
  if (footprint.is_disc()) return 0.5 * mass * footprint.disc * footprint.disc;
  // Second moment of the area about the origin, by triangles from it.
  double area = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < footprint.polygon.size(); ++i) {
    const Vec2 a = footprint.polygon[i], b = footprint.polygon[(i + 1) % footprint.polygon.size()];
    const double twice = cross(a, b);
    area += 0.5 * twice;
    moment += twice / 12.0 * (squared_norm(a) + dot(a, b) + squared_norm(b));
  }
  return mass * moment / area;
}

MecanumDynamics::MecanumDynamics(const Mecanum& drive, const MecanumBody& body) : drive_{drive}, body_{body}, arm_{drive.half_length + drive.half_width} {
  const double spin = 4.0 * body.wheel_inertia / (drive.wheel_radius * drive.wheel_radius);
  mass_ = body.mass + spin;
  inertia_ = body.inertia + spin * arm_ * arm_;
  resistance_ = 0.25 * body.mass * gravity * body.rolling_arm;
}

MecanumTorques MecanumDynamics::resisting(const Twist& twist) const {
  const MecanumWheels w = wheels_of(drive_, twist);
  return {resistance_ * sign_of(w.front_left), resistance_ * sign_of(w.front_right), resistance_ * sign_of(w.rear_left), resistance_ * sign_of(w.rear_right)};
}

// M u̇ − m θ̇ v = ΣT/r; M v̇ + m θ̇ u = (−T₁ + T₂ + T₃ − T₄)/r; J θ̈ = ℓ(−T₁ + T₂ − T₃ + T₄)/r.
Twist MecanumDynamics::acceleration(const Twist& twist, const MecanumTorques& torques) const {
  const MecanumTorques r = resisting(twist);
  const double a = torques.front_left - r.front_left, b = torques.front_right - r.front_right, c = torques.rear_left - r.rear_left, d = torques.rear_right - r.rear_right;
  const double per = 1.0 / drive_.wheel_radius;
  return {(per * (a + b + c + d) + body_.mass * twist.turn * twist.left) / mass_, (per * (-a + b + c - d) - body_.mass * twist.turn * twist.forward) / mass_,
          per * arm_ * (-a + b - c + d) / inertia_};
}

MecanumTorques MecanumDynamics::torques(const Twist& twist, const Twist& acceleration) const {
  const MecanumTorques r = resisting(twist);
  const double quarter = 0.25 * drive_.wheel_radius;
  const double ahead = quarter * (mass_ * acceleration.forward - body_.mass * twist.turn * twist.left);
  const double left = quarter * (mass_ * acceleration.left + body_.mass * twist.turn * twist.forward);
  const double turn = quarter * inertia_ * acceleration.turn / arm_;
  return {r.front_left + ahead - left - turn, r.front_right + ahead + left + turn, r.rear_left + ahead + left - turn, r.rear_right + ahead - left + turn};
}

double MecanumDynamics::kinetic_energy(const Twist& t) const { return 0.5 * mass_ * (t.forward * t.forward + t.left * t.left) + 0.5 * inertia_ * t.turn * t.turn; }

double MecanumDynamics::power_in(const Twist& twist, const MecanumTorques& t) const {
  const MecanumWheels w = wheels_of(drive_, twist);
  return t.front_left * w.front_left + t.front_right * w.front_right + t.rear_left * w.rear_left + t.rear_right * w.rear_right;
}

double MecanumDynamics::power_lost(const Twist& twist) const { return power_in(twist, resisting(twist)); }

double share_within(const MecanumDynamics& dynamics, const Twist& twist, const Twist& acceleration, double most) {
  const auto of = [&](double share) { return greatest(dynamics.torques(twist, {share * acceleration.forward, share * acceleration.left, share * acceleration.turn})); };
  if (of(1.0) <= most) return 1.0;
  if (of(0.0) > most) return 0.0;
  // Each torque is linear in the share, so that the greatest is convex in it: between 0 and 1 it passes `most` once.
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (of(middle) <= most ? low : high) = middle;
  }
  return low;
}

Twist saturated(const Mecanum& drive, const Twist& twist, double most) {
  const MecanumWheels w = wheels_of(drive, twist);
  const double fastest = std::max({std::abs(w.front_left), std::abs(w.front_right), std::abs(w.rear_left), std::abs(w.rear_right)});
  if (fastest <= most) return twist;
  const double share = most / fastest;
  return {share * twist.forward, share * twist.left, share * twist.turn};
}

}  // namespace waywright
