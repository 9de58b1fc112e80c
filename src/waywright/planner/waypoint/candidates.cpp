#include "waywright/planner/waypoint/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/planner/waypoint/nearness.hpp"

namespace waywright {
namespace {

constexpr double infeasible = 1e20;     // graded cost from where on a candidate is not feasible: no objective comes near
constexpr double unsolvable = 1e30;     // of a candidate without a chain, all of it
constexpr double most_bend = 3.0;       // rad over a leg, that a variable's curvature comes to
constexpr double most_poses = 20'000.0;
constexpr std::size_t least_poses = 20;

/// Mean of the courses to and from a waypoint.
double mean_course(Vec2 before, Vec2 here, Vec2 after) {
  const double in = angle_of(here - before);
  return wrap(in + 0.5 * shorter_turn(in, angle_of(after - here)));
}

double share_over(double value, double limit) { return std::isfinite(limit) ? std::max(0.0, value / limit - 1.0) : 0.0; }

/// Whether an objective is one of the publication's functions.
std::optional<Fitness> fitness_for(WaypointObjective objective) {
  switch (objective) {
    case WaypointObjective::mlpc: return Fitness::mlpc;
    case WaypointObjective::mlmc: return Fitness::mlmc;
    case WaypointObjective::mdobs: return Fitness::mdobs;
    case WaypointObjective::avgmd: return Fitness::avgmd;
    case WaypointObjective::pwavg: return Fitness::pwavg;
    case WaypointObjective::levels: return Fitness::levels;
    default: return std::nullopt;
  }
}

}  // namespace

const char* to_string(WaypointObjective objective) {
  switch (objective) {
    case WaypointObjective::mlpc: return "mlpc";
    case WaypointObjective::mlmc: return "mlmc";
    case WaypointObjective::mdobs: return "mdobs";
    case WaypointObjective::avgmd: return "avgmd";
    case WaypointObjective::pwavg: return "pwavg";
    case WaypointObjective::levels: return "levels";
    case WaypointObjective::pwavg_margin: return "pwavg_margin";
    case WaypointObjective::metres: return "metres";
  }
  return "";
}

WaypointCandidates::WaypointCandidates(const Problem& problem, const WaypointOptions& options)
    : problem_{problem}, options_{options}, objects_{problem} {
  const std::vector<Vec2>& waypoints = problem.scenario().waypoints;
  const double radius = problem.scenario().waypoint_radius;
  const bool all_round = options.heading_range >= pi;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const Vec2 before = i == 0 ? problem.start().position() : waypoints[i - 1];
    const Vec2 after = i + 1 < waypoints.size() ? waypoints[i + 1] : problem.goal().position();
    const double course = mean_course(before, waypoints[i], after);
    space_.low.push_back(course - options.heading_range);
    space_.high.push_back(course + options.heading_range);
    space_.periodic.push_back(all_round);
  }
  const auto add = [&](std::size_t count, double range) {
    space_.low.insert(space_.low.end(), count, -range);
    space_.high.insert(space_.high.end(), count, range);
    space_.periodic.insert(space_.periodic.end(), count, false);
  };
  has_bends_ = options.continuity == Continuity::g2 && options.bend_range > 0.0;
  may_leave_ = radius > 0.0;
  for (std::size_t i = 0; has_bends_ && i < waypoints.size(); ++i) {
    const Vec2 before = i == 0 ? problem.start().position() : waypoints[i - 1];
    const Vec2 after = i + 1 < waypoints.size() ? waypoints[i + 1] : problem.goal().position();
    // What a leg can be bent by shrinks with its length.
    add(1, std::min(options.bend_range, most_bend / std::min(distance(before, waypoints[i]), distance(waypoints[i], after))));
  }
  if (may_leave_) add(2 * waypoints.size(), radius);
}

std::optional<Clothoids> WaypointCandidates::chain_at(std::span<const double> x, std::size_t* unsolved) const {
  const std::vector<Vec2>& waypoints = problem_.scenario().waypoints;
  const double radius = problem_.scenario().waypoint_radius;
  std::vector<Pose> poses;
  poses.reserve(waypoints.size() + 2);
  const std::span<const double> bends = has_bends_ ? x.subspan(waypoints.size(), waypoints.size()) : std::span<const double>{};
  const std::span<const double> places = x.subspan(waypoints.size() + bends.size());
  poses.push_back(problem_.start());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    Vec2 off{};
    if (may_leave_) {
      off = {places[2 * i], places[2 * i + 1]};
      const double by = norm(off);
      if (by > radius) off = (radius / by) * off;  // corners of the square fold onto the circle
    }
    poses.push_back(make_pose(waypoints[i] + off, wrap(x[i])));
  }
  poses.push_back(problem_.goal());
  return chain_through(poses, options_.continuity, bends, unsolved);
}

/// Shares by which curvature and its rate are over the vehicle's limits.
double WaypointCandidates::beyond_limits(const Clothoids& chain) const {
  double over = share_over(greatest_curvature(chain), problem_.vehicle().max_curvature());
  if (const auto& rate = problem_.vehicle().limits.curvature_rate) over += share_over(greatest_curvature_rate(chain), *rate);
  return over;
}

double WaypointCandidates::sample_by_step(const Clothoids& chain) {
  const double length = length_of(chain);
  const auto n = std::max(least_poses, static_cast<std::size_t>(std::min(most_poses, std::ceil(length / options_.step) + 1.0)));
  sample_evenly(chain, n, poses_);
  return length / static_cast<double>(n - 1);
}

WaypointCandidates::Tightest WaypointCandidates::tightest_of(const Clothoids& chain) {
  sample_by_step(chain);
  Tightest tightest;
  tightest.contact.clearance = std::numeric_limits<double>::infinity();
  for (const Pose& pose : poses_) {
    const Contact contact = problem_.world().clearance(problem_.footprint(), pose, 10.0);
    if (contact.clearance < tightest.contact.clearance) tightest = {pose, contact};
  }
  return tightest;
}

/// Length + ∫ barrier(clearance) ds + w ∫ κ² ds: metres all of it, and no constants that knock out.
WaypointCandidates::Figures WaypointCandidates::figures_at(std::span<const double> x) {
  const auto chain = chain_at(x);
  if (!chain) return {unsolvable, -unsolvable, unsolvable, unsolvable};
  const Metres metres = in_metres(*chain);
  return {length_of(*chain), metres.clearance + problem_.required_clearance(), greatest_curvature(*chain), metres.evaluation.violation};
}

WaypointCandidates::Metres WaypointCandidates::in_metres(const Clothoids& chain) {
  const double length = length_of(chain);
  const double ds = sample_by_step(chain);
  const std::size_t n = poses_.size();
  double bends = 0.0;
  for (const Clothoid& c : chain) {
    const double by = c.curvature_rate * c.length;  // ∫ (κ0 + κ′s)² ds
    bends += c.length * (c.curvature * c.curvature + by * (c.curvature + by / 3.0));
  }
  Nearness nearness{problem_, options_.wanted_clearance, [this](const Pose& pose) { return objects_.depth_of(pose); }};
  for (std::size_t i = 0; i + 1 < n; ++i) nearness.add(poses_[i], poses_[i + 1], ds, i == 0, i + 2 == n);
  Evaluation e;
  e.objective = length + options_.clearance_weight * nearness.barrier() + options_.bend_weight * bends;
  e.violation = nearness.lacking() / length + beyond_limits(chain);
  return {e, nearness.least()};
}

const TrajectoryMeasures& WaypointCandidates::measures_of(const Clothoids& chain, FitnessForm form, bool wants_greatest) {
  sample_evenly(chain, static_cast<std::size_t>(options_.samples), poses_);
  objects_.measure(poses_, form, wants_greatest, measures_);
  measures_.length = length_of(chain);
  return measures_;
}

Evaluation WaypointCandidates::evaluate(std::span<const double> x) {
  const auto chain = chain_at(x);
  if (!chain) return {unsolvable, unsolvable, unsolvable};
  Evaluation e;
  if (options_.objective == WaypointObjective::metres) {
    e = in_metres(*chain).evaluation;
    e.graded = e.violation > 0.0 ? infeasible * (1.0 + e.violation) : e.objective;
    return e;
  }
  // The publication's functions weigh contact themselves, and know no limits but those of the corrected form.
  if (options_.objective == WaypointObjective::pwavg_margin) {
    e.objective = fitness_with_margin(measures_of(*chain, FitnessForm::corrected, false), problem_.required_clearance() + options_.margin);
  } else {
    const Fitness fitness = *fitness_for(options_.objective);
    const bool wants_greatest = fitness == Fitness::pwavg && options_.form == FitnessForm::published;
    e.objective = fitness_of(fitness, options_.form, measures_of(*chain, options_.form, wants_greatest));
  }
  if (options_.continuity == Continuity::g2) e.violation = beyond_limits(*chain);
  e.graded = e.violation > 0.0 ? infeasible * (1.0 + e.violation) : e.objective;
  return e;
}

}  // namespace waywright
