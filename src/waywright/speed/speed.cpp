// The fastest speed profile on a grid of samples, after the idea of reachability passes (Pham and Pham, A new
// approach to time-optimal path parameterization based on reachability analysis, IEEE T-RO 2018): all limits
// are linear in w = v² and the acceleration a of a step, so that from the end backwards each sample has a
// greatest w from which the rest can be driven, and a forward pass that takes the greatest acceleration at
// each step is the fastest. The angular acceleration |κ·a + κ′·w| ≤ α is taken as it stands, at both ends of
// each step; no share of it is set aside for either term.
#include "waywright/speed/speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// m: samples nearer along the path are one place.
constexpr double same_place = 1e-9;
// rad: a greater change of heading at one place is a turn on the spot, a smaller one the rounding of a joint.
constexpr double turning_threshold = 1e-4;
// m/s: where limits ask for less (a cusp), the vehicle stands for a moment.
constexpr double creeping = 1e-6;
// Shares of v²: rounding of a profile, and how far over what it may be a moving start may be measured.
constexpr double rounding = 2e-6;
constexpr double measured = 2e-3;
// Turning on the spot where the vehicle has no limit: rad/s.
constexpr double default_angular_speed = 1.0;

double square(double x) { return x * x; }

/// s that the steered wheel needs to turn while the vehicle stands between two samples at one place.
double steering_pause(const Sample& before, const Sample& after, const Vehicle& vehicle) {
  const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive);
  if (tricycle == nullptr || !tricycle->max_steering_rate) return 0.0;
  // Curvature is told in the direction of travel; backwards the same wheel angle bends it the other way.
  const double from = vehicle.steering_angle(before.direction * before.curvature);
  const double to = vehicle.steering_angle(after.direction * after.curvature);
  const double pause = std::abs(to - from) / *tricycle->max_steering_rate;
  return std::isfinite(pause) ? pause : 0.0;
}

/// rad that the heading changes at one place; 0 where that is rounding or the vehicle moves.
double turn_on_the_spot(const Sample& from, const Sample& to) {
  if (to.s - from.s > same_place) return 0.0;
  const double turn = shorter_turn(from.heading, to.heading);
  const bool on_the_spot = from.direction == 0 && to.direction == 0;
  return on_the_spot || std::abs(turn) > turning_threshold ? turn : 0.0;
}

/// m²/s², greatest v² at a sample by speed, lateral acceleration, angular speed, steering rate and wheel speed. @pre its curvature and rate are finite
double cap_at(const Sample& at, int direction, const Vehicle& vehicle) {
  const Limits& limits = vehicle.limits;
  double cap = square(direction < 0 ? limits.reverse_speed : limits.speed);
  if (!at.faces_along && limits.reverse_speed < limits.speed) {  // what of it leads backwards keeps that limit
    if (const double ahead = sin_cos(at.course - at.heading).cos; ahead < 0.0) cap = std::min(cap, square(limits.reverse_speed / -ahead));
  }
  if (limits.lateral_acceleration) cap = std::min(cap, *limits.lateral_acceleration / std::abs(at.curvature));
  if (limits.angular_speed) cap = std::min(cap, square(*limits.angular_speed / std::abs(at.turning())));
  if (const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive); tricycle != nullptr && tricycle->max_steering_rate) {
    // Steering angle atan(Lκ): its rate is Lκ′v / (1 + (Lκ)²).
    const double per_metre = tricycle->wheelbase * std::abs(at.curvature_rate) / (1.0 + square(tricycle->wheelbase * at.curvature));
    cap = std::min(cap, square(*tricycle->max_steering_rate / per_metre));
  }
  if (const auto* mecanum = std::get_if<Mecanum>(&vehicle.drive); mecanum != nullptr && mecanum->max_wheel_speed) {
    cap = std::min(cap, square(mecanum->max_speed(at.course - at.heading, 0.0, at.turning())));
  }
  return cap;
}

SpeedStep make_step(const Sample& from, const Sample& to, const Vehicle& vehicle) {
  SpeedStep step;
  step.length = std::max(0.0, to.s - from.s);
  if (step.length <= same_place) {
    step.length = 0.0;
    step.turn = turn_on_the_spot(from, to);
    return step;
  }
  step.turning = std::max(std::abs(from.turning()), std::abs(to.turning()));
  step.rate = std::max(std::abs(from.turning_rate()), std::abs(to.turning_rate()));
  if (!std::isfinite(step.turning) || !std::isfinite(step.rate)) {  // a cusp
    step.turning = step.rate = 0.0;
    step.top = 0.0;
    return step;
  }
  step.top = std::min(cap_at(from, to.direction, vehicle), cap_at(to, to.direction, vehicle));
  if (const auto* mecanum = std::get_if<Mecanum>(&vehicle.drive); mecanum != nullptr && mecanum->max_wheel_speed) {
    const double off = from.course - from.heading;
    step.top = std::min(step.top, square(mecanum->max_speed(off, shorter_turn(off, to.course - to.heading), step.turning)));
  }
  return step;
}

struct Interval {
  double low, high;
  bool empty() const { return low > high; }
  /// Keeps what satisfies slope·a + constant ≤ bound.
  void keep(double slope, double constant, double bound) {
    if (slope > 0.0)
      high = std::min(high, (bound - constant) / slope);
    else if (slope < 0.0)
      low = std::max(low, (bound - constant) / slope);
    else if (constant > bound)
      high = -infinity;
  }
};

class Profile {
 public:
  /// The first sample is passed with `start_speed` where it can be, else with the greatest speed with which it can.
  Profile(const std::vector<Sample>& samples, const Vehicle& vehicle, double start_speed, SpeedWorkspace& workspace, const LimitsAlong& along)
      : samples_{samples}, vehicle_{vehicle}, limits_{vehicle.limits}, along_{along}, steps_{workspace.steps}, caps_{workspace.caps}, w_{workspace.squares} {
    const std::size_t n = samples.size();
    steps_.clear();
    caps_.assign(n, infinity);
    if (start_speed == 0.0) caps_.front() = 0.0;
    caps_.back() = 0.0;
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Sample& a = samples[i];
      const Sample& b = samples[i + 1];
      steps_.push_back(make_step(a, b, vehicle));
      if (!along.steps.empty()) steps_.back().top = std::min(steps_.back().top, square(along.steps[i]));
      const double cap = must_stand(a, b, vehicle) ? 0.0 : steps_.back().top;
      for (const std::size_t k : {i, i + 1}) caps_[k] = std::min(caps_[k], cap);
    }
    for (std::size_t i = 0; i < along.samples.size(); ++i) caps_[i] = std::min(caps_[i], square(along.samples[i]));
    for (double& cap : caps_) {
      if (cap < square(creeping)) cap = 0.0;
    }
    backward();
    starts_so_ = brakes_from(square(start_speed));
  }

  bool starts_as_wanted() const { return starts_so_; }
  /// m²/s², v² of the first sample.
  double start() const { return w_.front(); }

  /// v² of every sample.
  const std::vector<double>& fastest() {
    forward();
    return w_;
  }

 private:
  /// Accelerations with which step i can be driven from w at its start to at most `most` at its end.
  Interval accelerations(std::size_t i, double w, double most) const {
    const double length = steps_[i].length;
    Interval a{-limits_.deceleration, limits_.acceleration};
    a.keep(1.0, 0.0, (most - w) / (2.0 * length));
    a.keep(-1.0, 0.0, w / (2.0 * length));
    if (limits_.angular_acceleration) {
      const double bound = *limits_.angular_acceleration;
      for (const std::size_t k : {i, i + 1}) {
        const double moved = k == i ? 0.0 : 2.0 * length;  // w at the end is w + 2·length·a
        const double slope = samples_[k].turning() + moved * samples_[k].turning_rate();
        const double constant = w * samples_[k].turning_rate();
        a.keep(slope, constant, bound);
        a.keep(-slope, -constant, bound);
      }
    }
    return a;
  }

  void backward() {
    w_ = caps_;
    for (std::size_t i = w_.size() - 1; i-- > 0;) {
      if (steps_[i].length == 0.0) {
        w_[i] = std::min(caps_[i], w_[i + 1]);
        continue;
      }
      double high = std::min(caps_[i], w_[i + 1] + 2.0 * limits_.deceleration * steps_[i].length);
      // From standing still the step can always be driven, and what can be driven is an interval of w (the
      // limits are convex).
      if (limits_.angular_acceleration && accelerations(i, high, w_[i + 1]).empty()) {
        double low = 0.0;
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (low + high);
          (accelerations(i, middle, w_[i + 1]).empty() ? high : low) = middle;
        }
        high = low;
      }
      w_[i] = high;
    }
  }

  /// Brakes from w at the first sample as hard as may be until the profile is met, under what each sample's own curvature allows. (Caps of
  /// steps are those of their worse end: who takes up a path between another's samples meets other caps than that did.) False where
  /// the profile is not met: it is left as it was.
  bool brakes_from(double w) {
    if (w <= w_.front() * (1.0 + measured)) {
      w_.front() = std::min(w_.front(), w);
      return true;
    }
    std::size_t met = 0;
    for (double v = w; v > w_[met] * (1.0 + rounding); ++met) {
      if (met + 1 == w_.size() || caps_[met] == 0.0 || v > own_cap(met) * (1.0 + (met == 0 ? measured : rounding))) return false;
      v = braked(met, v);
      if (v < 0.0) return false;
    }
    for (std::size_t i = 0; i < met; ++i) {
      const double next = braked(i, w);
      w_[i] = w;
      w = next;
    }
    return true;
  }
  /// m²/s², what a sample allows by itself.
  double own_cap(std::size_t i) const {
    const double cap = cap_at(samples_[i], samples_[i].direction, vehicle_);
    return along_.samples.empty() ? cap : std::min(cap, square(along_.samples[i]));
  }
  /// w at the end of step i, braked as hard as may be; negative where the limits leave no acceleration.
  double braked(std::size_t i, double w) const {
    if (steps_[i].length == 0.0) return w;
    double a = -limits_.deceleration;
    if (limits_.angular_acceleration) {
      const Interval all = accelerations(i, w, infinity);
      if (all.empty()) return -1.0;
      a = all.low;
    }
    return std::max(0.0, w + 2.0 * a * steps_[i].length);
  }

  void forward() {
    for (std::size_t i = 0; i + 1 < w_.size(); ++i) {
      if (steps_[i].length == 0.0) {
        w_[i + 1] = std::min(w_[i + 1], w_[i]);
        continue;
      }
      double a = limits_.acceleration;
      if (limits_.angular_acceleration) a = accelerations(i, w_[i], w_[i + 1]).high;
      w_[i + 1] = std::clamp(w_[i] + 2.0 * a * steps_[i].length, 0.0, w_[i + 1]);
    }
  }

  const std::vector<Sample>& samples_;
  const Vehicle& vehicle_;
  const Limits& limits_;
  const LimitsAlong& along_;
  std::vector<SpeedStep>& steps_;
  std::vector<double>& caps_;
  std::vector<double>& w_;
  bool starts_so_ = true;
};

/// s from rest to rest over a distance (or angle), speeding up and slowing down, not above `top`.
double rest_to_rest(double distance, double acceleration, double deceleration, double top) {
  const double per = 0.5 / acceleration + 0.5 / deceleration;  // m of ramps for each unit of w
  const double ramps = top * top * per;
  if (distance <= ramps) return 2.0 * std::sqrt(distance * per);
  return 2.0 * top * per + (distance - ramps) / top;
}

/// A step that begins and ends at rest speeds up and slows down within it; half of the angular acceleration
/// goes to each term.
double rest_to_rest(const SpeedStep& step, const Limits& limits) {
  double top = std::min(step.top, square(std::max(limits.speed, limits.reverse_speed)));
  double acceleration = limits.acceleration;
  double deceleration = limits.deceleration;
  if (limits.angular_acceleration) {
    const double half = 0.5 * *limits.angular_acceleration;
    top = std::min(top, half / step.rate);
    acceleration = std::min(acceleration, half / step.turning);
    deceleration = std::min(deceleration, half / step.turning);
  }
  return rest_to_rest(step.length, std::max(acceleration, creeping), std::max(deceleration, creeping),
                      std::max(std::sqrt(top), creeping));
}

/// s after which `part` of a turn by `whole` (both > 0, rad) is done, from rest to rest.
double turning_time(double part, double whole, const Vehicle& vehicle) {
  const double speed = std::min(vehicle.limits.angular_speed.value_or(default_angular_speed), vehicle.max_turning_speed().value_or(infinity));
  const double acceleration = vehicle.limits.angular_acceleration.value_or(default_angular_acceleration);
  const double total = rest_to_rest(whole, acceleration, acceleration, speed);
  const double ramp = std::min(0.5 * whole, 0.5 * speed * speed / acceleration);
  if (part <= ramp) return std::sqrt(2.0 * part / acceleration);
  if (part >= whole - ramp) return total - std::sqrt(2.0 * std::max(0.0, whole - part) / acceleration);
  return std::sqrt(2.0 * ramp / acceleration) + (part - ramp) / speed;
}

/// Times of the turn on the spot that begins with step i; returns the step after it. A turn goes on through
/// steps of one place and one sense.
std::size_t time_turn(std::vector<Sample>& samples, const std::vector<SpeedStep>& steps, std::size_t i, const Vehicle& vehicle) {
  std::size_t end = i;
  double whole = 0.0;
  const auto goes_on = [&](std::size_t k) {
    if (steps[k].turn == 0.0)
      return samples[k + 1].direction == samples[i].direction;  // a joint of two turns
    return (steps[k].turn > 0.0) == (steps[i].turn > 0.0);
  };
  while (end < steps.size() && steps[end].length == 0.0 && goes_on(end)) {
    whole += std::abs(steps[end++].turn);
  }
  const double begin = samples[i].t;
  double part = 0.0;
  for (std::size_t k = i; k < end; ++k) {
    part = std::min(whole, part + std::abs(steps[k].turn));
    samples[k + 1].t = std::max(samples[k].t, begin + turning_time(part, whole, vehicle));
  }
  return end;
}

}  // namespace

double assign_speed(std::vector<Sample>& samples, const Vehicle& vehicle, double start_speed) {
  SpeedWorkspace workspace;
  return assign_speed(samples, vehicle, start_speed, workspace);
}

double assign_speed(std::vector<Sample>& samples, const Vehicle& vehicle, double start_speed, SpeedWorkspace& workspace, const LimitsAlong& along) {
  if (samples.empty()) return 0.0;
  Profile profile{samples, vehicle, start_speed, workspace, along};
  const std::vector<double>& w = profile.fastest();
  const std::vector<SpeedStep>& steps = workspace.steps;
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].speed = std::sqrt(w[i]);
  samples.front().t = 0.0;
  for (std::size_t i = 0; i < steps.size();) {
    if (steps[i].turn != 0.0) {
      i = time_turn(samples, steps, i, vehicle);
      continue;
    }
    const double sum = samples[i].speed + samples[i + 1].speed;
    double time = 0.0;
    if (steps[i].length == 0.0) {
      if (sum == 0.0) time = steering_pause(samples[i], samples[i + 1], vehicle);
    } else {
      time = sum > 0.0 ? 2.0 * steps[i].length / sum : rest_to_rest(steps[i], vehicle.limits);
    }
    samples[i + 1].t = samples[i].t + time;
    ++i;
  }
  return samples.back().t;
}

double greatest_start_speed(const std::vector<Sample>& samples, const Vehicle& vehicle, SpeedWorkspace& workspace, const LimitsAlong& along) {
  if (samples.empty()) return 0.0;
  return std::sqrt(Profile{samples, vehicle, infinity, workspace, along}.start());
}

bool can_start_with(const std::vector<Sample>& samples, const Vehicle& vehicle, double speed, SpeedWorkspace& workspace, const LimitsAlong& along) {
  return !samples.empty() && Profile{samples, vehicle, speed, workspace, along}.starts_as_wanted();
}

void SpeedWorkspace::reserve(std::size_t samples) {
  steps.reserve(samples);
  caps.reserve(samples);
  squares.reserve(samples);
}

WithinStep within_step(const Sample& from, const Sample& to, double time) {
  const double way = to.s - from.s, whole = to.t - from.t, sum = from.speed + to.speed;
  if (!(way > 0.0)) return {};
  if (sum > 0.0) {
    const double acceleration = 0.5 * (to.speed - from.speed) * sum / way;
    time = std::clamp(time, 0.0, std::max(0.0, whole));
    return {std::clamp(from.speed * time + 0.5 * acceleration * time * time, 0.0, way), std::max(0.0, from.speed + acceleration * time)};
  }
  const double share = whole > 0.0 ? std::clamp(time / whole, 0.0, 1.0) : 1.0, left = 1.0 - share;
  const double top = whole > 0.0 ? 2.0 * way / whole : 0.0;
  return share < 0.5 ? WithinStep{2.0 * way * share * share, 2.0 * top * share} : WithinStep{way * (1.0 - 2.0 * left * left), 2.0 * top * left};
}

double time_from_rest_to_rest(const Sample& before, const Sample& after, const Vehicle& vehicle) {
  return rest_to_rest(make_step(before, after, vehicle), vehicle.limits);
}

bool must_stand(const Sample& before, const Sample& after, const Vehicle& vehicle) {
  if (is_direction_change(before, after) || before.direction == 0 || after.direction == 0) return true;
  if (turn_on_the_spot(before, after) != 0.0) return true;
  if (is_course_jump(before, after)) return true;
  if (vehicle.steering_takes_time() && is_curvature_jump(before, after)) return true;
  return vehicle.limits.angular_acceleration && is_turning_jump(before, after);
}

bool is_curvature_jump(const Sample& before, const Sample& after, double tolerance) {
  return std::abs(after.s - before.s) <= same_place && std::abs(after.curvature - before.curvature) > tolerance;
}

bool is_turning_jump(const Sample& before, const Sample& after, double tolerance) {
  return std::abs(after.s - before.s) <= same_place && std::abs(after.turning() - before.turning()) > tolerance;
}

}  // namespace waywright
