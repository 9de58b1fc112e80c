// Paths and vehicles for the tests of speed, and a check of every limit.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/speed/speed.hpp"

namespace waywright::speed_test {

inline Vehicle differential() {
  Vehicle vehicle;
  vehicle.limits = Limits{};
  vehicle.limits.speed = 1.0;
  vehicle.limits.reverse_speed = 0.5;
  vehicle.limits.acceleration = 0.5;
  vehicle.limits.deceleration = 0.5;
  return vehicle;
}

inline Vehicle tricycle(std::optional<double> steering_rate) {
  Vehicle vehicle = differential();
  vehicle.drive = Tricycle{.wheelbase = 1.9, .max_steering = 1.2, .max_steering_rate = steering_rate};
  return vehicle;
}

/// Samples of a curve given by its curvature κ(s) and dκ/ds; positions are of no account for the speed.
inline std::vector<Sample> stretch(double length, std::size_t steps,
                                   const std::function<double(double)>& curvature,
                                   const std::function<double(double)>& rate, int direction = 1) {
  std::vector<Sample> samples;
  double heading = 0.0;
  for (std::size_t i = 0; i <= steps; ++i) {
    Sample sample;
    sample.s = length * static_cast<double>(i) / static_cast<double>(steps);
    sample.curvature = curvature(sample.s);
    sample.curvature_rate = rate(sample.s);
    if (i > 0) heading += 0.5 * (samples.back().curvature + sample.curvature) * (sample.s - samples.back().s);
    sample.heading = wrap(heading);
    sample.direction = direction;
    samples.push_back(sample);
  }
  return samples;
}

inline std::vector<Sample> line(double length, std::size_t steps, int direction = 1) {
  const auto zero = [](double) { return 0.0; };
  return stretch(length, steps, zero, zero, direction);
}

inline std::vector<Sample> circle(double length, std::size_t steps, double curvature) {
  return stretch(
      length, steps, [=](double) { return curvature; }, [](double) { return 0.0; });
}

inline void append(std::vector<Sample>& samples, std::vector<Sample> more) {
  const Sample last = samples.back();
  for (Sample& sample : more) {
    sample.s += last.s;
    sample.heading = wrap(sample.heading + last.heading);
    samples.push_back(sample);
  }
}

inline std::vector<Sample> turn(double angle, std::size_t steps) {
  std::vector<Sample> samples(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) {
    samples[i].heading = wrap(angle * static_cast<double>(i) / static_cast<double>(steps));
    samples[i].direction = 0;
  }
  return samples;
}

/// What is wrong with a profile; empty where nothing is.
inline std::string broken_limit(const std::vector<Sample>& samples, const Vehicle& vehicle,
                                double slack = 1e-6, double start_speed = 0.0) {
  const Limits& limits = vehicle.limits;
  const auto* steered = std::get_if<Tricycle>(&vehicle.drive);
  const auto over = [&](double value, double limit) { return !(value <= limit * (1.0 + slack) + 1e-12); };
  const auto at = [](const char* what, std::size_t i) { return what + (" at sample " + std::to_string(i)); };
  if (samples.front().speed != start_speed) return "does not begin at the start speed";
  if (samples.back().speed != 0.0) return "not at rest at the end";
  if (samples.front().t != 0.0) return "does not begin at 0";
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (!std::isfinite(s.t) || !std::isfinite(s.speed) || s.speed < 0.0) return at("not a number", i);
    if (over(s.speed, s.direction < 0 ? limits.reverse_speed : limits.speed)) return at("speed", i);
    if (limits.lateral_acceleration &&
        over(s.speed * s.speed * std::abs(s.curvature), *limits.lateral_acceleration))
      return at("lateral acceleration", i);
    if (limits.angular_speed && over(s.speed * std::abs(s.curvature), *limits.angular_speed))
      return at("angular speed", i);
    if (steered != nullptr && steered->max_steering_rate) {
      const double l = steered->wheelbase;
      const double rate =
          l * std::abs(s.curvature_rate) * s.speed / (1.0 + l * l * s.curvature * s.curvature);
      if (over(rate, *steered->max_steering_rate)) return at("steering rate", i);
    }
    if (i == 0) continue;
    const Sample& b = samples[i - 1];
    if (s.t < b.t) return at("time", i);
    if (s.direction != b.direction && (s.speed != 0.0 || b.speed != 0.0))
      return at("moves while changing direction", i);
    const double ds = s.s - b.s;
    if (ds <= 1e-9) {
      if (s.speed != b.speed) return at("two speeds at one place", i);
      continue;
    }
    if (s.speed + b.speed == 0.0) continue;
    const double a = (s.speed * s.speed - b.speed * b.speed) / (2.0 * ds);
    if (over(a, limits.acceleration) || over(-a, limits.deceleration)) return at("acceleration", i);
    if (limits.angular_acceleration) {
      for (const Sample* e : {&b, &s}) {
        if (over(std::abs(e->curvature * a + e->curvature_rate * e->speed * e->speed),
                 *limits.angular_acceleration))
          return at("angular acceleration", i);
      }
    }
    // Where it crept before, times are great, and their differences rounded.
    if (std::abs((s.t - b.t) * (s.speed + b.speed) - 2.0 * ds) > 1e-9 * (1.0 + ds) + 1e-15 * s.t * (s.speed + b.speed))
      return at("time out of step", i);
  }
  return "";
}

}  // namespace waywright::speed_test
