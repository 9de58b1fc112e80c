#include "waywright/report/spots.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/judge/judge.hpp"

namespace waywright {
namespace {

constexpr double straight = 1e-6;      // 1/m
constexpr double clearly_more = 1e-3;  // m

Spot spot_at(const Problem& problem, const Pose& pose, const Contact& contact) {
  return {pose, contact.point, contact.clearance, problem.world().source_name(contact.source)};
}

/// Samples [first, last) off the straight stretch at the shelf.
std::pair<std::size_t, std::size_t> off_straight(const Problem& problem, const std::vector<Sample>& samples) {
  const std::size_t n = samples.size();
  const auto same_stretch = [&](std::size_t i, std::size_t shelf) {
    return std::abs(samples[i].curvature) < straight && samples[i].direction == samples[shelf].direction;
  };
  std::size_t count = 0;
  if (problem.is_driven_back()) {
    while (count < n && same_stretch(count, 0)) ++count;
    return {count, n};
  }
  while (count < n && same_stretch(n - 1 - count, n - 1)) ++count;
  return {0, n - count};
}

}  // namespace

std::optional<Spot> tightest_off_straight(const Problem& problem, const Plan& plan) {
  if (plan.samples.size() < 2 || !std::holds_alternative<Station>(problem.scenario().mission))
    return std::nullopt;
  const auto [first, last] = off_straight(problem, plan.samples);
  if (first >= last || last - first == plan.samples.size()) return std::nullopt;
  const std::vector<double> clearance = clearances_along(problem, plan.path, plan.samples);
  const auto at = [&](std::size_t i) { return clearance.begin() + static_cast<std::ptrdiff_t>(i); };
  const auto least = std::min_element(at(first), at(last));
  if (*least < *std::min_element(clearance.begin(), clearance.end()) + clearly_more) return std::nullopt;
  const Pose pose = plan.samples[static_cast<std::size_t>(least - clearance.begin())].pose();
  return spot_at(problem, pose, problem.world().clearance(problem.footprint(), pose, clearance_cap));
}

std::vector<Spot> blocked_spots(const Problem& problem, const Plan& plan) {
  if (!plan.samples.empty()) return {};
  if (const auto failure = problem.check_ends()) {
    if (!failure->pose || !failure->point) return {};
    return {{*failure->pose, *failure->point,
             problem.world().clearance(problem.footprint(), *failure->pose, 1.0).clearance, ""}};
  }
  std::vector<Spot> spots;
  const double required = problem.required_clearance();
  for (const Alternative& a : plan.alternatives) {
    if (a.cost) continue;
    std::vector<std::size_t> met;
    for (const Pose& pose : a.poses) {
      const Contact contact = problem.world().clearance(problem.footprint(), pose, required + 1.0);
      if (contact.clearance > 0.0 && contact.clearance >= required - clearly_more) continue;
      if (std::find(met.begin(), met.end(), contact.source) != met.end()) continue;
      met.push_back(contact.source);
      spots.push_back(spot_at(problem, pose, contact));
    }
  }
  return spots;
}

std::vector<std::size_t> leg_borders(const Plan& plan) {
  std::vector<std::size_t> borders;
  std::size_t first = 0;
  for (const LegResult& leg : plan.legs) {
    if (first > 0 && first < plan.samples.size()) borders.push_back(first);
    first += leg.samples;
  }
  return borders;
}

std::vector<std::size_t> steering_stops(const Plan& plan) {
  std::vector<std::size_t> stops;
  const std::vector<std::size_t> borders = leg_borders(plan);
  for (std::size_t i = 1; i + 1 < plan.samples.size(); ++i) {
    if (std::binary_search(borders.begin(), borders.end(), i)) continue;
    const Sample& before = plan.samples[i - 1];
    const Sample& here = plan.samples[i];
    const bool stands = before.s == here.s && here.s > 0.0 && here.s < plan.samples.back().s &&
                        before.speed == 0.0 && here.speed == 0.0;
    const bool waits = std::any_of(plan.waits.begin(), plan.waits.end(), [&](const Wait& wait) { return wait.s == here.s; });
    if (stands && !waits && before.direction == here.direction && here.direction != 0) stops.push_back(i);
  }
  return stops;
}

}  // namespace waywright
