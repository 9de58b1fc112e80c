#include "waywright/drive/plan_motion.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

// As the profile has them (speed/speed.cpp).
constexpr double same_place = 1e-9;                   // m
constexpr double turning_threshold = 1e-4;            // rad

/// What is done of `whole` after `time` of `duration`, from rest to rest, speeding up and slowing down at these rates as far as they allow it.
double trapezoid(double time, double duration, double whole, double acceleration, double deceleration) {
  if (!(duration > 0.0) || time >= duration) return whole;
  const double per = 0.5 / acceleration + 0.5 / deceleration;
  const double top = 2.0 * whole / (duration + std::sqrt(std::max(0.0, duration * duration - 4.0 * whole * per)));
  // Where the rates are too low for the time, the ramps are as steep as they must be.
  const double shorter = std::min(1.0, duration / (2.0 * top * per));
  const double up = shorter * top / acceleration, down = shorter * top / deceleration;
  if (time < up) return 0.5 * top * time * time / up;
  if (time <= duration - down) return top * (time - 0.5 * up);
  const double left = duration - time;
  return whole - 0.5 * top * left * left / down;
}

}  // namespace

PlanMotion::PlanMotion(const Path& path, std::vector<Sample> samples, const Vehicle& vehicle) : places_{path}, samples_{std::move(samples)}, vehicle_{vehicle} {
  headings_.push_back(samples_.front().heading);
  for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
    const Sample& a = samples_[i];
    const Sample& b = samples_[i + 1];
    const double turn = shorter_turn(a.heading, b.heading), time = b.t - a.t;
    headings_.push_back(headings_.back() + turn);
    Stretch* now = stretches_.empty() || stretches_.back().last != i ? nullptr : &stretches_.back();
    Stretch::Kind kind = Stretch::Kind::drive;
    if (b.s - a.s <= same_place) {
      const bool on_the_spot = (a.direction == 0 && b.direction == 0) || std::abs(turn) > turning_threshold;
      if (on_the_spot && turn != 0.0) {
        kind = Stretch::Kind::turn;
        const bool goes_on = now != nullptr && now->kind == kind && (headings_[i] > headings_[now->first]) == (turn > 0.0);
        if (!goes_on) now = nullptr;
      } else if (time > 0.0) {
        kind = Stretch::Kind::wait;
        now = nullptr;
      } else {  // a joint
        if (now != nullptr) now->last = i + 1;
        continue;
      }
    } else if (now != nullptr && (now->kind != kind || now->direction != b.direction || a.speed == 0.0)) {
      now = nullptr;
    }
    if (now == nullptr) {
      stretches_.push_back({kind, kind == Stretch::Kind::drive ? b.direction : 0, i, i, 0.0});
      now = &stretches_.back();
    }
    now->last = i + 1;
    now->duration = samples_[i + 1].t - samples_[now->first].t;
  }
}

Moment PlanMotion::at_sample(std::size_t i) const {
  const Sample& sample = samples_[i];
  return {sample.pose(), sample.s, headings_[i], vehicle_.steering_angle(sample.direction * sample.curvature)};
}

double PlanMotion::driven(std::size_t step, double time) const {
  const Sample& a = samples_[step];
  const Sample& b = samples_[step + 1];
  const double length = b.s - a.s, duration = b.t - a.t, sum = a.speed + b.speed;
  if (!(duration > 0.0)) return length;
  if (sum > 0.0) {
    // A file's times may be slower than its speeds: the step is driven evenly slower then.
    const double own = 2.0 * length / sum, at = std::clamp(time / duration, 0.0, 1.0) * own;
    const double acceleration = 0.5 * (b.speed - a.speed) * sum / length;
    return std::clamp(a.speed * at + 0.5 * acceleration * at * at, 0.0, length);
  }
  double acceleration = vehicle_.limits.acceleration, deceleration = vehicle_.limits.deceleration;
  if (vehicle_.limits.angular_acceleration) {
    const double share = 0.5 * *vehicle_.limits.angular_acceleration / std::max({std::abs(a.curvature), std::abs(b.curvature), 1e-9});
    acceleration = std::min(acceleration, share);
    deceleration = std::min(deceleration, share);
  }
  return trapezoid(time, duration, length, acceleration, deceleration);
}

Moment PlanMotion::at(const Stretch& stretch, double time) const {
  if (time <= 0.0) return at_sample(stretch.first);
  if (time >= stretch.duration) return at_sample(stretch.last);
  const Sample& first = samples_[stretch.first];
  if (stretch.kind == Stretch::Kind::wait) {
    Moment moment = at_sample(stretch.first);
    moment.steering += time / stretch.duration * (at_sample(stretch.last).steering - moment.steering);
    return moment;
  }
  if (stretch.kind == Stretch::Kind::turn) {
    const double whole = headings_[stretch.last] - headings_[stretch.first];
    const double rate = vehicle_.limits.angular_acceleration.value_or(default_angular_acceleration);
    const double part = std::copysign(trapezoid(time, stretch.duration, std::abs(whole), rate, rate), whole);
    Moment moment = at_sample(stretch.first);
    moment.heading += part;
    moment.pose.heading = wrap(moment.heading);
    return moment;
  }
  const auto begin = samples_.begin() + static_cast<std::ptrdiff_t>(stretch.first), end = samples_.begin() + static_cast<std::ptrdiff_t>(stretch.last);
  const double t = first.t + time;
  const auto after = std::upper_bound(std::next(begin), end, t, [](double value, const Sample& s) { return value < s.t; });
  const auto step = static_cast<std::size_t>(std::prev(after) - samples_.begin());
  const double s = samples_[step].s + driven(step, t - samples_[step].t);
  if (s <= first.s) return at_sample(stretch.first);
  if (s >= samples_[stretch.last].s) return at_sample(stretch.last);
  const PathPlace place = places_.at(s);
  return {place.pose, s, headings_[step] + shorter_turn(samples_[step].heading, place.pose.heading), vehicle_.steering_angle(stretch.direction * place.curvature)};
}

}  // namespace waywright
