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

double Vehicle::steering_angle(double curvature) const {
  const auto* tricycle = std::get_if<Tricycle>(&drive);
  if (tricycle == nullptr) return 0.0;
  const double angle = arc_tangent(tricycle->wheelbase * curvature, 1.0);
  return tricycle->steered_axle == SteeredAxle::rear ? -angle : angle;
}

}  // namespace waywright
