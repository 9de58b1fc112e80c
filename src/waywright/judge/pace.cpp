#include "waywright/judge/pace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double same_place = 1e-9;   // m
constexpr double no_turn = 1e-9;      // rad
constexpr double of_wait = 1e-6;      // m, between a wait that is told and the samples that stand
constexpr double least_speed = 1e-3;  // m/s: of a step between two places where the pace is nearly 0
constexpr double told_from = 0.5;     // s: shorter stops are no waits in words and pictures

/// Greatest speeds at places of the way, asked in order.
class SpeedWanted {
 public:
  explicit SpeedWanted(const Pace& pace) : places_{pace.places} {}

  double at(double s) {
    constexpr double any = std::numeric_limits<double>::infinity();
    if (places_.size() < 2 || s < places_.front().s - same_place || s > places_.back().s + same_place) return any;
    while (next_ + 1 < places_.size() && places_[next_].s < s) ++next_;
    while (next_ > 1 && places_[next_ - 1].s > s) --next_;
    if (next_ == 0) next_ = 1;
    const Pace::Place &a = places_[next_ - 1], &b = places_[next_];
    const double share = b.s - a.s > same_place ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 1.0;
    return std::sqrt(a.speed * a.speed + share * (b.speed * b.speed - a.speed * a.speed));
  }

 private:
  const std::vector<Pace::Place>& places_;
  std::size_t next_ = 0;
};

/// What the way allows and the pace asks for, whichever is less. `fastest`: the samples with the fastest profile, which no speed is over: under a limit of angular acceleration
/// one that was slower before might be, for a moment, and `verify` takes it for the bound that it nearly is.
LimitsAlong limits_with(const std::vector<Sample>& samples, const std::vector<Sample>& fastest, const LimitsAlong& along, const Pace& pace) {
  LimitsAlong both;
  both.samples.reserve(samples.size());
  SpeedWanted wanted{pace};
  for (std::size_t i = 0; i < samples.size(); ++i) both.samples.push_back(std::min(wanted.at(samples[i].s), fastest[i].speed));
  both.steps.reserve(samples.size());
  auto place = pace.places.begin();
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    double top = std::max({both.samples[i], both.samples[i + 1], least_speed});
    while (place != pace.places.end() && place->s < samples[i].s) ++place;
    for (auto on = place; on != pace.places.end() && on->s < samples[i + 1].s; ++on) top = std::max(top, on->speed);
    both.steps.push_back(top);
  }
  if (!along.steps.empty()) {
    for (std::size_t i = 0; i < both.steps.size(); ++i) both.steps[i] = std::min(both.steps[i], along.steps[i]);
  }
  return both;
}

LimitsAlong part_of(const LimitsAlong& along, std::size_t from, std::size_t to) {
  const auto at = [](const std::vector<double>& values, std::size_t a, std::size_t b) {
    return std::vector<double>{values.begin() + static_cast<std::ptrdiff_t>(a), values.begin() + static_cast<std::ptrdiff_t>(b)};
  };
  return {at(along.steps, from, to), at(along.samples, from, to + 1)};
}

}  // namespace

Pace pace_from(const std::vector<Sample>& samples, std::span<const Wait> waits, double t, double driven) {
  Pace pace;
  double stood = 0.0, turned = 0.0;  // s at one place, since t
  const auto leave = [&](double s, double at) {
    // It turns when it has stood: the profile knows where it stands, not in which order.
    if (stood > 0.0) {
      const auto wait = std::find_if(waits.begin(), waits.end(), [&](const Wait& w) { return std::abs(w.s - s) <= of_wait; });
      pace.waits.push_back({std::max(0.0, s - driven), at - t - turned, wait == waits.end() ? 0 : wait->obstacle});
    }
    stood = turned = 0.0;
  };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample &a = samples[i - 1], &b = samples[i];
    if (!(b.t > t)) continue;
    const double way = b.s - a.s, begin = std::max(a.t, t);
    if (way <= same_place) {
      (std::abs(shorter_turn(a.heading, b.heading)) > no_turn ? turned : stood) += b.t - begin;
      continue;
    }
    leave(a.s, a.t);
    if (pace.places.empty()) pace.places.push_back({0.0, within_step(a, b, begin - a.t).speed});
    const double middle = 0.5 * (a.t + b.t);
    if (a.speed == 0.0 && b.speed == 0.0 && middle > t) pace.places.push_back({std::max(0.0, a.s + 0.5 * way - driven), within_step(a, b, middle - a.t).speed});
    pace.places.push_back({std::max(0.0, b.s - driven), b.speed});
  }
  if (!samples.empty()) leave(samples.back().s, samples.back().t);
  return pace;
}

Timed timed_at_pace(const Problem& problem, const std::vector<Sample>& samples, const LimitsAlong& along, const Pace& pace) {
  Timed timed;
  if (samples.size() < 2) return {samples, {}, {}};
  SpeedWorkspace workspace;
  double time = 0.0, speed = problem.motion() ? problem.motion()->speed : 0.0;
  std::vector<Sample> fastest = samples;
  assign_speed(fastest, problem.vehicle(), speed, workspace, along);
  const LimitsAlong limits = limits_with(samples, fastest, along, pace);
  std::size_t from = 0;
  const auto drive_to = [&](std::size_t to) {
    std::vector<Sample> part{samples.begin() + static_cast<std::ptrdiff_t>(from), samples.begin() + static_cast<std::ptrdiff_t>(to) + 1};
    if (part.size() > 1) assign_speed(part, problem.vehicle(), speed, workspace, part_of(limits, from, to));
    else part.front().t = part.front().speed = 0.0;
    const std::size_t skip = timed.samples.empty() || timed.samples.back().t < time ? 0 : 1;
    for (std::size_t i = skip; i < part.size(); ++i) {
      timed.samples.push_back(part[i]);
      timed.samples.back().t += time;
    }
    time += part.back().t;
    from = to;
    speed = 0.0;
  };
  for (const WantedWait& wait : pace.waits) {
    const auto found = std::lower_bound(samples.begin() + static_cast<std::ptrdiff_t>(from), samples.end(), wait.s - same_place, [](const Sample& a, double s) { return a.s < s; });
    if (found == samples.end()) break;
    if (found == samples.begin() && speed > 0.0) continue;  // who moves cannot stand where it begins
    drive_to(static_cast<std::size_t>(found - samples.begin()));
    if (wait.until <= time) continue;
    if (wait.until - time >= told_from) timed.waits.push_back({samples[from].s, samples[from].pose(), time, wait.until, wait.obstacle, 0.0, false, true});
    time = wait.until;
  }
  drive_to(samples.size() - 1);
  return timed;
}

}  // namespace waywright
