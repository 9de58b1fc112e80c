// A plan file's claims held against a fresh proof of its own curves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/judge/judge.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

constexpr double step_limit = 0.05;        // m and rad between samples (plan file format)
constexpr double number_slack = 1e-6;      // m, rad, s: rounding of what was written by another program
constexpr double relative_slack = 1e-3;    // of a speed limit
constexpr double speed_slack = 1e-6;       // m/s

/// The samples against the curves: same ends, same places, dense enough.
void check_samples(const std::vector<Sample>& claimed, const std::vector<Sample>& fresh, double radius, double tolerance,
                   std::vector<std::string>& findings) {
  if (claimed.size() < 2 || fresh.size() < 2) {
    findings.emplace_back("the plan holds fewer than two samples");
    return;
  }
  if (std::abs(claimed.back().s - fresh.back().s) > number_slack + 1e-6 * fresh.back().s || claimed.front().s != 0.0) {
    findings.push_back(fmt::format("the samples run from s = {} to {} m, the curves are {:.6f} m long", claimed.front().s,
                                   claimed.back().s, fresh.back().s));
    return;
  }
  const double allowed = tolerance + number_slack;
  std::size_t k = 0;
  double worst = 0.0;
  double worst_s = 0.0;
  for (std::size_t i = 0; i < claimed.size(); ++i) {
    const Sample& c = claimed[i];
    if (i > 0) {
      const Sample& b = claimed[i - 1];
      const double moved = distance(b.pose().position(), c.pose().position());
      const double turned = std::abs(shorter_turn(b.heading, c.heading));
      if (c.s < b.s || moved > step_limit + number_slack || turned > step_limit + number_slack) {
        findings.push_back(fmt::format("samples {} and {} are {:.4f} m and {:.4f} rad apart; at most {} m and {} rad are allowed",
                                       i - 1, i, moved, turned, step_limit, step_limit));
        return;
      }
    }
    // Turning on the spot keeps s: compare by order there, elsewhere by interpolation in s.
    while (k + 2 < fresh.size() && fresh[k + 1].s < c.s) ++k;
    double off = 1e9;
    for (std::size_t j = k; j + 1 < fresh.size() && fresh[j].s <= c.s + number_slack; ++j) {
      const Sample& a = fresh[j];
      const Sample& b = fresh[j + 1];
      const double span = b.s - a.s;
      const double t = span > 0.0 ? std::clamp((c.s - a.s) / span, 0.0, 1.0) : 0.0;
      for (const double at : {t, span > 0.0 ? t : 1.0}) {
        const Vec2 p = a.pose().position() + at * (b.pose().position() - a.pose().position());
        const double heading = a.heading + at * shorter_turn(a.heading, b.heading);
        off = std::min(off, distance(p, c.pose().position()) + radius * std::abs(shorter_turn(heading, c.heading)));
      }
    }
    if (off > worst) {
      worst = off;
      worst_s = c.s;
    }
  }
  if (worst > 2.0 * allowed) {
    findings.push_back(fmt::format("at s = {:.3f} m the samples are {:.5f} m from the curves", worst_s, worst));
  }
}

/// Speed and time as claimed: at rest where it must be, within the limits, t in step with speed.
void check_speed(const std::vector<Sample>& samples, const Vehicle& vehicle, std::vector<std::string>& findings) {
  const Limits& limits = vehicle.limits;
  const auto complain = [&](const Sample& at, const std::string& what) {
    findings.push_back(fmt::format("at s = {:.3f} m {}", at.s, what));
  };
  const bool steering_limited = limits.curvature_rate.has_value() ||
                                (std::holds_alternative<Tricycle>(vehicle.drive) &&
                                 std::get<Tricycle>(vehicle.drive).max_steering_rate.has_value());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const double top = s.direction >= 0 ? limits.speed : limits.reverse_speed;
    if (!(s.speed >= 0.0) || s.speed > top * (1.0 + relative_slack)) {
      return complain(s, fmt::format("the speed of {:.4f} m/s is over the limit of {:.4f} m/s", s.speed, top));
    }
    if (limits.lateral_acceleration &&
        s.speed * s.speed * std::abs(s.curvature) > *limits.lateral_acceleration * (1.0 + relative_slack) + speed_slack) {
      return complain(s, "the lateral acceleration is over its limit");
    }
    if (limits.angular_speed &&
        s.speed * std::abs(s.curvature) > *limits.angular_speed * (1.0 + relative_slack) + speed_slack) {
      return complain(s, "the angular speed is over its limit");
    }
    const bool first_or_last = i == 0 || i + 1 == samples.size();
    const bool changes = i > 0 && samples[i - 1].direction != s.direction;
    const bool jumps = i > 0 && steering_limited && is_curvature_jump(samples[i - 1], s);
    if ((first_or_last || changes || jumps) && s.speed > speed_slack) {
      return complain(s, fmt::format("the vehicle must stand still and drives {:.4f} m/s", s.speed));
    }
    if (i == 0) continue;
    const Sample& b = samples[i - 1];
    if (s.t < b.t) return complain(s, "time runs backwards");
    const double ds = s.s - b.s;
    if (ds <= 1e-9) continue;
    const double a = (s.speed * s.speed - b.speed * b.speed) / (2.0 * ds);
    // A step from rest to rest speeds up and slows down within it, and shows no acceleration here.
    if (a > limits.acceleration * (1.0 + relative_slack) + speed_slack ||
        -a > limits.deceleration * (1.0 + relative_slack) + speed_slack) {
      return complain(s, fmt::format("the acceleration of {:.4f} m/s² is over its limit", a));
    }
    if (const double mean = 0.5 * (s.speed + b.speed); mean > 0.0 && std::abs((s.t - b.t) * mean - ds) > 1e-3 * ds + 1e-6) {
      return complain(s, "time does not fit the speeds");
    }
  }
}

void check_metrics(const Plan& claimed, const Plan& fresh, std::vector<std::string>& findings) {
  const auto compare = [&](const char* name, double is, double should, double slack) {
    if (std::abs(is - should) <= slack * (1.0 + std::abs(should))) return;
    findings.push_back(fmt::format("metrics.{} is {} in the file and {} when measured", name, is, should));
  };
  compare("length", claimed.metrics.length, fresh.metrics.length, 1e-6);
  compare("min_clearance", claimed.metrics.min_clearance, fresh.metrics.min_clearance, 1e-3);
  compare("max_curvature", claimed.metrics.max_curvature, fresh.metrics.max_curvature, 1e-2);
  compare("curvature_change", claimed.metrics.curvature_change, fresh.metrics.curvature_change, 2e-2);
  compare("direction_changes", claimed.metrics.direction_changes, fresh.metrics.direction_changes, 0.0);
}

}  // namespace

Parsed<Verification> verify(const Plan& plan) {
  auto problem = Problem::prepare(plan.scenario);
  if (!problem) {
    InputError error = problem.error();
    error.field = "scenario." + error.field;
    return tl::unexpected{error};
  }
  Verification verification;
  if (plan.path.pieces.empty()) {
    verification.fresh = failed_plan(*problem, {plan.status, plan.reason, {}, {}});
    verification.findings.push_back(
        fmt::format("the plan holds no path to verify; its status is {}", to_string(plan.status)));
    return verification;
  }
  verification.fresh = judge(*problem, plan.path);
  const Plan& fresh = verification.fresh;
  std::vector<std::string>& findings = verification.findings;
  if (auto ends = problem->check_ends()) findings.push_back(ends->reason);
  if (fresh.status != Status::solved) findings.push_back(fresh.reason);
  if (!fresh.samples.empty()) {
    check_samples(plan.samples, fresh.samples, problem->footprint().radius(), fresh.certificate.tolerance, findings);
    check_speed(plan.samples, problem->vehicle(), findings);
    check_metrics(plan, fresh, findings);
  }
  if (plan.certificate.clearance > fresh.certificate.clearance + fresh.certificate.tolerance) {
    findings.push_back(fmt::format("the file claims a clearance of {:.5f} m, {:.5f} m could be proven",
                                   plan.certificate.clearance, fresh.certificate.clearance));
  }
  if (plan.certificate.pocket_clearance.value_or(0.0) > fresh.certificate.pocket_clearance.value_or(0.0) + fresh.certificate.tolerance) {
    findings.push_back(fmt::format("the file claims a clearance of {:.5f} m in the pocket, {:.5f} m could be proven",
                                   *plan.certificate.pocket_clearance, fresh.certificate.pocket_clearance.value_or(0.0)));
  }
  if (plan.certificate.collision_free && !fresh.certificate.collision_free) {
    findings.emplace_back("the file claims to be free of collision, which could not be proven");
  }
  verification.holds = findings.empty();
  return verification;
}

}  // namespace waywright
