#include "waywright/vehicle/vehicle.hpp"
#include "waywright/core/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {

double Footprint::radius() const {
  double r = is_disc() ? disc : 0.0;
  for (const Vec2 p : polygon) r = std::max(r, norm(p));
  return r;
}

double Footprint::inner_radius() const { return is_disc() ? disc : waywright::inner_radius(polygon, {}); }

double Footprint::front() const {
  if (is_disc()) return disc;
  double x = polygon.front().x;
  for (const Vec2 p : polygon) x = std::max(x, p.x);
  return x;
}

double Footprint::least_width() const { return is_disc() ? 2.0 * disc : waywright::least_width(polygon); }

double Mecanum::max_speed(double off, double change, double turning) const {
  if (!max_wheel_speed) return std::numeric_limits<double>::infinity();
  const auto sizes = [](double angle) {
    const SinCos side = sin_cos(angle);
    return std::abs(side.cos) + std::abs(side.sin);
  };
  const double least = std::min(off, off + change), most = std::max(off, off + change);
  const bool is_askew = std::floor(most / (0.5 * pi) - 0.5) >= std::ceil(least / (0.5 * pi) - 0.5);  // an odd eighth of a turn lies between
  const double share = is_askew ? std::sqrt(2.0) : std::max(sizes(least), sizes(most));
  return *max_wheel_speed * wheel_radius / (share + (half_length + half_width) * std::abs(turning));
}

double Vehicle::max_curvature() const {
  double bound = limits.curvature.value_or(std::numeric_limits<double>::infinity());
  if (const auto* tricycle = std::get_if<Tricycle>(&drive)) {
    const SinCos steering = sin_cos(tricycle->max_steering);
    bound = std::min(bound, steering.sin / (steering.cos * tricycle->wheelbase));
  }
  return bound;
}

bool Vehicle::can_turn_on_the_spot() const { return !std::holds_alternative<Tricycle>(drive); }

bool Vehicle::steering_takes_time() const {
  if (limits.curvature_rate) return true;
  const auto* tricycle = std::get_if<Tricycle>(&drive);
  return tricycle != nullptr && tricycle->max_steering_rate.has_value();
}

std::optional<double> Vehicle::max_turning_speed() const {
  const auto* mecanum = std::get_if<Mecanum>(&drive);
  if (mecanum == nullptr || !mecanum->max_wheel_speed) return limits.angular_speed;
  const double by_wheels = *mecanum->max_wheel_speed * mecanum->wheel_radius / (mecanum->half_length + mecanum->half_width);
  return limits.angular_speed ? std::min(*limits.angular_speed, by_wheels) : by_wheels;
}

double Vehicle::steering_angle(double curvature) const {
  const auto* tricycle = std::get_if<Tricycle>(&drive);
  if (tricycle == nullptr) return 0.0;
  const double angle = arc_tangent(tricycle->wheelbase * curvature, 1.0);
  return tricycle->steered_axle == SteeredAxle::rear ? -angle : angle;
}

}  // namespace waywright
