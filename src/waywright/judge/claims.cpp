#include "waywright/judge/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

constexpr double step_limit = 0.05;      // m and rad between samples (plan file format)
constexpr double number_slack = 1e-6;    // m, rad, s: rounding of what was written by another program
constexpr double same_place = 1e-9;      // m
constexpr double relative_slack = 1e-3;  // of speeds, accelerations and times

/// A place on straight interpolation between two samples, with everything that stands there.
struct Match {
  Sample at;         // of the samples that were searched
  double off = 0.0;  // m, of the farthest footprint point
  double mismatch = 0.0;
  std::size_t segment = 0;
};

double square(double x) { return x * x; }

/// `t` of the way from a to b: v² is linear in s, as the speed profile has it.
Sample between(const Sample& a, const Sample& b, double t) {
  Sample s = a;
  s.s += t * (b.s - a.s);
  s.x += t * (b.x - a.x);
  s.y += t * (b.y - a.y);
  s.heading += t * shorter_turn(a.heading, b.heading);
  s.course += t * shorter_turn(a.course, b.course);
  s.curvature += t * (b.curvature - a.curvature);
  s.curvature_rate += t * (b.curvature_rate - a.curvature_rate);
  if (t >= 1.0 || b.s - a.s <= same_place) {  // at b, or where two pieces meet
    s.faces_along = b.faces_along;
    s.heading_rate = b.heading_rate;
  }
  s.speed = std::sqrt(std::max(0.0, square(a.speed) + t * (square(b.speed) - square(a.speed))));
  const double sum = a.speed + s.speed;
  s.t = t >= 1.0 ? b.t : a.t + (sum > 0.0 ? 2.0 * t * (b.s - a.s) / sum : t * (b.t - a.t));
  return s;
}

/// Where between a and b is c? By s where they are apart; at one place by heading, or by curvature where that
/// jumps.
double fraction(const Sample& a, const Sample& b, const Sample& c) {
  if (b.s - a.s > same_place) return std::clamp((c.s - a.s) / (b.s - a.s), 0.0, 1.0);
  if (const double turn = shorter_turn(a.heading, b.heading); turn != 0.0)
    return std::clamp(shorter_turn(a.heading, c.heading) / turn, 0.0, 1.0);
  if (b.curvature != a.curvature)
    return std::clamp((c.curvature - a.curvature) / (b.curvature - a.curvature), 0.0, 1.0);
  return 1.0;
}

/// A stretch of one driving direction and, on the spot, of one sense of turning: indices [first, last].
struct Stretch {
  std::size_t first, last;
};

std::vector<Stretch> stretches(const std::vector<Sample>& samples) {
  std::vector<Stretch> found;
  double sense = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == 0 || is_direction_change(samples[i - 1], samples[i])) {
      found.push_back({i, i});
      sense = 0.0;
    }
    found.back().last = i;
    if (samples[i].direction != 0 || found.back().first == i) continue;
    const double turn = shorter_turn(samples[i - 1].heading, samples[i].heading);
    if (turn * sense < 0.0) {  // the turning point belongs to both
      found.back().last = i - 1;
      found.push_back({i - 1, i});
    }
    if (turn != 0.0) sense = turn;
  }
  return found;
}

/// Finds places of one stretch's samples, asked in order.
class Finder {
 public:
  Finder(const std::vector<Sample>& samples, Stretch stretch, double radius)
      : samples_{samples}, stretch_{stretch}, radius_{radius}, segment_{stretch.first} {}

  /// The first place from the last one on that fits as well as any.
  Match find(const Sample& wanted) {
    std::optional<Match> best;
    while (segment_ + 1 < stretch_.last && samples_[segment_ + 1].s < wanted.s - number_slack) ++segment_;
    for (std::size_t j = segment_;
         j == segment_ || (j < stretch_.last && samples_[j].s <= wanted.s + number_slack); ++j) {
      const Match match = at(j, wanted);
      if (!best || match.mismatch < best->mismatch) best = match;
      if (best->mismatch <= same_place) break;
    }
    segment_ = best->segment;
    return *best;
  }

 private:
  Match at(std::size_t j, const Sample& wanted) const {
    const Sample& a = samples_[j];
    const Sample& b = samples_[std::min(j + 1, stretch_.last)];
    Match match{between(a, b, fraction(a, b, wanted)), 0.0, 0.0, j};
    const Sample& found = match.at;
    match.off = distance(found.pose().position(), wanted.pose().position()) +
                radius_ * std::abs(shorter_turn(found.heading, wanted.heading));
    match.mismatch = match.off + std::abs(found.s - wanted.s) + std::abs(found.curvature - wanted.curvature) +
                     std::abs(shorter_turn(found.course, wanted.course));
    return match;
  }

  const std::vector<Sample>& samples_;
  Stretch stretch_;
  double radius_;
  std::size_t segment_;
};

class SampleCheck {
 public:
  SampleCheck(const std::vector<Sample>& claimed, const std::vector<Sample>& fresh, const Vehicle& vehicle,
              double radius, double tolerance)
      : claimed_{claimed},
        fresh_{fresh},
        vehicle_{vehicle},
        radius_{radius},
        allowed_{tolerance + number_slack} {}

  std::optional<std::string> run() {
    if (claimed_.size() < 2 || fresh_.size() < 2) return "the plan holds fewer than two samples";
    if (std::abs(claimed_.back().s - fresh_.back().s) > number_slack * (1.0 + fresh_.back().s) ||
        claimed_.front().s != 0.0) {
      return fmt::format("the samples run from s = {} to {} m, the curves are {:.6f} m long",
                         claimed_.front().s, claimed_.back().s, fresh_.back().s);
    }
    if (is_too_fast(fresh_.front().speed, claimed_.front().speed)) {
      return fmt::format("the samples begin at {:.4f} m/s, and the vehicle moves at {:.4f} m/s there", claimed_.front().speed, fresh_.front().speed);
    }
    if (claimed_.front().t != 0.0)
      return fmt::format("the samples begin at t = {} s, and must at 0", claimed_.front().t);
    const std::vector<Stretch> claimed = stretches(claimed_);
    const std::vector<Stretch> fresh = stretches(fresh_);
    for (std::size_t i = 0; i < std::min(claimed.size(), fresh.size()); ++i) {
      const Sample& is = claimed_[claimed[i].first];
      const Sample& should = fresh_[fresh[i].first];
      if (is.direction != should.direction || std::abs(is.s - should.s) > number_slack * (1.0 + should.s)) {
        return fmt::format(
            "from s = {:.3f} m on the samples have direction {}; the curves are driven in direction {} from "
            "s = {:.3f} m on",
            is.s, is.direction, should.direction, should.s);
      }
    }
    if (claimed.size() != fresh.size()) {
      return fmt::format("the samples change direction {} times, the curves {} times", claimed.size() - 1,
                         fresh.size() - 1);
    }
    matched_.resize(claimed_.size());
    // Interpolated between samples the claim has the curves' places, and the curves the claim's: it is dense
    // enough, too.
    for (std::size_t i = 0; i < claimed.size(); ++i) {
      Finder on_fresh{fresh_, fresh[i], radius_};
      for (std::size_t k = claimed[i].first; k <= claimed[i].last; ++k) {
        matched_[k] = on_fresh.find(claimed_[k]);
        if (auto finding = check_place(k)) return finding;
        if (auto finding = check_driving(k)) return finding;
      }
      Finder on_claimed{claimed_, claimed[i], radius_};
      for (std::size_t k = fresh[i].first; k <= fresh[i].last; ++k) {
        if (auto finding = check_claim_at(k, on_claimed.find(fresh_[k]))) return finding;
      }
    }
    return std::nullopt;
  }

 private:
  static std::string at(const Sample& sample, const std::string& what) {
    return fmt::format("at s = {:.3f} m {}", sample.s, what);
  }

  std::optional<std::string> check_place(std::size_t k) const {
    const Sample& c = claimed_[k];
    const Match& match = matched_[k];
    if (k > 0) {
      const Sample& b = claimed_[k - 1];
      const double moved = distance(b.pose().position(), c.pose().position());
      const double turned = std::abs(shorter_turn(b.heading, c.heading));
      if (c.s < b.s || moved > step_limit + number_slack || turned > step_limit + number_slack) {
        return fmt::format(
            "samples {} and {} are {:.4f} m and {:.4f} rad apart; at most {} m and {} rad are allowed", k - 1,
            k, moved, turned, step_limit, step_limit);
      }
    }
    if (match.off > allowed_)
      return at(c, fmt::format("the samples are {:.5f} m from the curves", match.off));
    // Between two fresh samples, what can be reached from their values will do.
    const Sample& a = fresh_[match.segment];
    const Sample& b = fresh_[std::min(match.segment + 1, fresh_.size() - 1)];
    const double apart = std::max(0.0, b.s - a.s);
    const double course_step = std::abs(shorter_turn(a.course, b.course)) +
                               apart * std::max(std::abs(a.curvature), std::abs(b.curvature));
    if (std::abs(shorter_turn(match.at.course, c.course)) > number_slack + course_step) {
      return at(c, fmt::format("the course is {:.5f} rad in the file and {:.5f} rad on the curves", c.course,
                               wrap(match.at.course)));
    }
    const double curvature_step =
        apart > same_place ? std::abs(b.curvature - a.curvature) +
                                 apart * std::max(std::abs(a.curvature_rate), std::abs(b.curvature_rate))
                           : 0.0;
    if (std::abs(match.at.curvature - c.curvature) >
        number_slack * (1.0 + std::abs(c.curvature)) + curvature_step) {
      return at(c, fmt::format("the curvature is {:.5f} 1/m in the file and {:.5f} 1/m on the curves",
                               c.curvature, match.at.curvature));
    }
    return std::nullopt;
  }

  /// Squared speed over that of the fastest profile, beyond rounding of s.
  bool is_too_fast(double speed, double fastest) const {
    const double steepest = std::max(vehicle_.limits.acceleration, vehicle_.limits.deceleration);
    return square(speed) > square(fastest) * square(1.0 + relative_slack) + 4.0 * number_slack * steepest;
  }

  std::optional<std::string> check_driving(std::size_t k) const {
    const Sample& c = claimed_[k];
    const Sample& f = matched_[k].at;
    if (!(c.speed >= 0.0) || is_too_fast(c.speed, f.speed)) {
      return at(
          c, f.speed > 0.0
                 ? fmt::format(
                       "the speed of {:.4f} m/s is over the {:.4f} m/s that the vehicle's limits allow there",
                       c.speed, f.speed)
                 : fmt::format("the vehicle must stand still and drives {:.4f} m/s", c.speed));
    }
    if (k == 0) return std::nullopt;
    const Sample& b = claimed_[k - 1];
    const double time = c.t - b.t;
    if (time < 0.0) return at(c, "time runs backwards");
    const double length = c.s - b.s, mean = 0.5 * (c.speed + b.speed);
    // A step that begins and ends at rest speeds up and slows down within it, which can be quicker than the fastest profile's even change; it has its own bound below.
    const double fastest = f.t - matched_[k - 1].at.t;
    if ((mean > 0.0 || length <= same_place) && time < fastest * (1.0 - relative_slack) - number_slack) {
      return at(c, fmt::format("the step takes {:.4f} s, and under the vehicle's limits at least {:.4f} s",
                               time, fastest));
    }
    if (length <= same_place) {
      if (std::abs(c.speed - b.speed) > relative_slack * (b.speed + c.speed) + number_slack) return at(c, fmt::format("at one place the speed goes from {:.4f} to {:.4f} m/s", b.speed, c.speed));
      if (time > number_slack && mean > number_slack) return at(c, fmt::format("for {:.4f} s it drives {:.4f} m/s and stays where it is", time, mean));
      return std::nullopt;
    }
    if (mean > 0.0) {
      if (std::abs(time * mean - length) > relative_slack * length + number_slack)
        return at(c, "time does not fit the speeds");
    } else if (const double least = time_from_rest_to_rest(matched_[k - 1].at, f, vehicle_);
               time < least * (1.0 - relative_slack) - number_slack) {
      return at(c, fmt::format("a step from standing to standing takes {:.4f} s, and under the vehicle's "
                               "limits at least {:.4f} s",
                               time, least));
    }
    return check_acceleration(k, (square(c.speed) - square(b.speed)) / (2.0 * length));
  }

  std::optional<std::string> check_acceleration(std::size_t k, double acceleration) const {
    const Limits& limits = vehicle_.limits;
    const Sample& c = claimed_[k];
    const double length = c.s - claimed_[k - 1].s;
    // What rounding of s makes of an acceleration over a short step.
    const double slack = number_slack * (1.0 + square(c.speed) / (length + number_slack));
    if (acceleration > limits.acceleration * (1.0 + relative_slack) + slack ||
        -acceleration > limits.deceleration * (1.0 + relative_slack) + slack) {
      return at(c, fmt::format("the acceleration of {:.4f} m/s² is over its limit", acceleration));
    }
    if (!limits.angular_acceleration) return std::nullopt;
    for (const std::size_t i : {k - 1, k}) {
      const Sample& f = matched_[i].at;
      const double angular = f.turning() * acceleration + f.turning_rate() * square(claimed_[i].speed);
      if (std::abs(angular) >
          *limits.angular_acceleration * (1.0 + relative_slack) + slack * (1.0 + std::abs(f.turning()))) {
        return at(c, fmt::format("the angular acceleration of {:.4f} rad/s² is over its limit", angular));
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> check_claim_at(std::size_t k, const Match& match) const {
    const Sample& f = fresh_[k];
    if (match.off > allowed_)
      return at(f, fmt::format("the samples, interpolated, are {:.5f} m from the curves", match.off));
    const bool stands = (k > 0 && must_stand(fresh_[k - 1], f, vehicle_)) ||
                        (k + 1 < fresh_.size() && must_stand(f, fresh_[k + 1], vehicle_));
    if (!is_too_fast(match.at.speed, stands ? 0.0 : f.speed)) return std::nullopt;
    return at(
        f, stands
               ? fmt::format("the vehicle must stand still and drives {:.4f} m/s", match.at.speed)
               : fmt::format(
                     "the speed of {:.4f} m/s is over the {:.4f} m/s that the vehicle's limits allow there",
                     match.at.speed, f.speed));
  }

  const std::vector<Sample>& claimed_;
  const std::vector<Sample>& fresh_;
  const Vehicle& vehicle_;
  double radius_, allowed_;
  std::vector<Match> matched_;  // of each claimed sample, on the fresh ones
};

}  // namespace

void check_claimed_samples(const std::vector<Sample>& claimed, const std::vector<Sample>& fresh,
                           const Vehicle& vehicle, double radius, double tolerance,
                           std::vector<std::string>& findings) {
  if (auto finding = SampleCheck{claimed, fresh, vehicle, radius, tolerance}.run())
    findings.push_back(std::move(*finding));
}

void check_claimed_metrics(const Plan& claimed, const Plan& fresh, std::vector<std::string>& findings) {
  const auto compare = [&](const char* name, double is, double should, double slack) {
    if (is == should || std::abs(is - should) <= slack * (1.0 + std::abs(should))) return;
    findings.push_back(fmt::format("metrics.{} is {} in the file and {} when measured", name, is, should));
  };
  // Figures over samples depend a little on where these are.
  constexpr double exact = 1e-6, sampled = 1e-3, of_peaks = 1e-2;
  const Metrics& is = claimed.metrics;
  const Metrics& should = fresh.metrics;
  compare("length", is.length, should.length, exact);
  compare("min_clearance", is.min_clearance, should.min_clearance, sampled);
  compare("mean_clearance", is.mean_clearance, should.mean_clearance, sampled);
  compare("max_curvature", is.max_curvature, should.max_curvature, sampled);
  compare("max_curvature_rate", is.max_curvature_rate, should.max_curvature_rate, of_peaks);
  compare("curvature_change", is.curvature_change, should.curvature_change, of_peaks);
  compare("curvature_change_printed", is.curvature_change_printed, should.curvature_change_printed, sampled);
  compare("turning", is.turning, should.turning, exact);
  compare("direction_changes", is.direction_changes, should.direction_changes, 0.0);
  compare("collision_risk", is.collision_risk, should.collision_risk, sampled);
  if (!claimed.samples.empty()) compare("travel_time", is.travel_time, claimed.samples.back().t, exact);
}

void check_claimed_certificate(const Certificate& claimed, const Certificate& fresh,
                               std::vector<std::string>& findings) {
  if (claimed.clearance > fresh.clearance + number_slack) {
    findings.push_back(fmt::format("the file claims a clearance of {:.6f} m, {:.6f} m could be proven",
                                   claimed.clearance, fresh.clearance));
  }
  if (claimed.pocket_clearance.value_or(0.0) > fresh.pocket_clearance.value_or(0.0) + number_slack) {
    findings.push_back(
        fmt::format("the file claims a clearance of {:.6f} m in the pocket, {:.6f} m could be proven",
                    *claimed.pocket_clearance, fresh.pocket_clearance.value_or(0.0)));
  }
  if (claimed.checked_length > fresh.checked_length + number_slack * (1.0 + fresh.checked_length)) {
    findings.push_back(fmt::format("the file claims that {:.6f} m were checked, {:.6f} m could be",
                                   claimed.checked_length, fresh.checked_length));
  }
  if (claimed.collision_free && !fresh.collision_free) {
    findings.emplace_back("the file claims to be free of collision, which could not be proven");
  }
}

}  // namespace waywright
