#include "waywright/planner/waypoint/waypoint_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

constexpr double degrees = 180.0 / pi;

std::string courses_of(const Problem& problem, std::span<const double> x) {
  std::string text;
  for (std::size_t i = 0; i < problem.scenario().waypoints.size(); ++i) text += fmt::format("{}{:.1f}°", i == 0 ? "" : ", ", wrap(x[i]) * degrees);
  return text;
}

/// Does the body cover the point that follows the path?
bool contains_origin(const Footprint& footprint) { return footprint.is_disc() || contains(footprint.polygon, Vec2{}); }

std::size_t legs_of(const Problem& problem) { return problem.scenario().waypoints.size() + 1; }

/// The i-th of start, waypoints and goal.
Vec2 place_of(const Problem& problem, std::size_t i) {
  const std::vector<Vec2>& waypoints = problem.scenario().waypoints;
  return i == 0 ? problem.start().position() : i <= waypoints.size() ? waypoints[i - 1] : problem.goal().position();
}

double length_of_leg(const Problem& problem, std::size_t leg) { return distance(place_of(problem, leg), place_of(problem, leg + 1)); }

/// "waypoint 2 at (6.000, 6.100) and waypoint 3 at (6.010, 6.100), which are 0.0100 m apart"
std::string leg_words(const Problem& problem, std::size_t leg) {
  const auto name = [&](std::size_t i) {
    const Vec2 at = place_of(problem, i);
    return fmt::format("{} at ({:.3f}, {:.3f})", i == 0 ? std::string{"the start"} : i == legs_of(problem) ? std::string{"the goal"} : fmt::format("waypoint {}", i), at.x, at.y);
  };
  return fmt::format("{} and {}, which are {:.4f} m apart", name(leg), name(leg + 1), length_of_leg(problem, leg));
}

/// Of a chain beyond the vehicle's limits: the leg that is farthest beyond one.
std::size_t worst_leg(const Problem& problem, const Clothoids& chain) {
  const std::size_t pieces = chain.size() / legs_of(problem);
  const auto& rate = problem.vehicle().limits.curvature_rate;
  double most = -1.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double over = std::max(greatest_curvature(chain[i]) / problem.vehicle().max_curvature(), rate ? std::abs(chain[i].curvature_rate) / *rate : 0.0);
    if (!(over > most)) continue;
    most = over;
    worst = i / pieces;
  }
  return worst;
}

/// The shortest leg, where the vehicle could hardly turn at all on it.
std::optional<std::size_t> tiny_leg(const Problem& problem) {
  constexpr double share = 0.1, unlimited = 0.05;  // of the least radius; m, without one
  const double curvature = problem.vehicle().max_curvature();
  std::size_t shortest = 0;
  for (std::size_t i = 1; i < legs_of(problem); ++i) shortest = length_of_leg(problem, i) < length_of_leg(problem, shortest) ? i : shortest;
  return length_of_leg(problem, shortest) < (std::isfinite(curvature) ? share / curvature : unlimited) ? std::optional{shortest} : std::nullopt;
}

/// Where the bends of a chain come from: its worst leg, and a tiny one, which bends its neighbours, too.
std::string bends_words(const Problem& problem, const Clothoids& chain) {
  const std::size_t worst = worst_leg(problem, chain);
  const auto tiny = tiny_leg(problem);
  return ": most between " + leg_words(problem, worst) + (tiny && *tiny != worst ? "; it has to turn on the way between " + leg_words(problem, *tiny) : "");
}

Status status_of(const Budget& budget) { return budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path; }

}  // namespace

std::string counted(std::int64_t n, const char* one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

std::string courses_sentence(const Problem& problem, WaypointObjective objective, std::span<const double> x, const Evaluation& chosen, const Evaluation& of_middle, std::int64_t looked) {
  const std::size_t waypoints = problem.scenario().waypoints.size();
  if (waypoints == 0) return "There are no waypoints to choose courses at: start and goal alone decide the path.";
  const bool is_one = waypoints == 1;
  const char* halfway = is_one ? "the course halfway between those to and from the waypoint" : "the courses halfway between those to and from each waypoint";
  const std::string value = fmt::format("Objective {}: {}; it is {:.6g} here", to_string(objective), meaning_of(objective), chosen.objective);
  if (looked == 1) return fmt::format("Only {} {} looked at: {}. {}.", halfway, is_one ? "was" : "were", courses_of(problem, x), value);
  return fmt::format("Of {} candidates, {}: {}. {}, and {} with {}.", looked, is_one ? "this course at the waypoint is best" : "these courses at the waypoints are best", courses_of(problem, x),
                     value, of_middle.violation > 0.0 ? "not feasible" : fmt::format("{:.6g}", of_middle.objective), halfway);
}

std::string limits_sentence(const Problem& problem, const Clothoids& chain, Continuity continuity) {
  const std::size_t legs = problem.scenario().waypoints.size() + 1;
  const char* leg = legs == 1 ? "The way" : "Each leg";
  std::string text = continuity == Continuity::g2 ? fmt::format("{} is three clothoids: curvature goes on without jumps, at most {:.4f} 1/m", leg, greatest_curvature(chain))
                     : legs == 1                  ? fmt::format("{} is one clothoid: curvature is at most {:.4f} 1/m", leg, greatest_curvature(chain))
                                 : fmt::format("{} is one clothoid: curvature jumps at {}; it is at most {:.4f} 1/m", leg, legs == 2 ? "the waypoint" : "waypoints", greatest_curvature(chain));
  if (const double limit = problem.vehicle().max_curvature(); std::isfinite(limit)) text += fmt::format(" (the vehicle can {:.4f})", limit);
  text += fmt::format(", its rate at most {:.4f} 1/m²", greatest_curvature_rate(chain));
  if (const auto& rate = problem.vehicle().limits.curvature_rate) text += fmt::format(" (limit {:.4f})", *rate);
  return text + ".";
}

std::string measures_sentence(const TrajectoryMeasures& m) {
  return fmt::format("At {} poses of equal distance the footprint's corners are {:.3f} m from obstacles in the mean and {:.3f} m at least; {} in contact.",
                     m.distance.size(), mean_distance(m), least_distance(m), counted(poses_in_contact(m), "pose") + (poses_in_contact(m) == 1 ? " is" : " are"));
}

std::vector<Pose> picture_of(const Clothoids& chain) {
  std::vector<Pose> poses;
  sample_evenly(chain, std::clamp<std::size_t>(static_cast<std::size_t>(length_of(chain) / 0.12), 2, 1000), poses);
  return poses;
}

Refusal refusal_of(const Problem& problem, WaypointCandidates& candidates, const Clothoids& chain) {
  if (candidates.is_beyond_limits(chain)) {
    return {fmt::format("bends with {:.4f} 1/m, changing by {:.4f} 1/m² at most, which the vehicle cannot{}", greatest_curvature(chain), greatest_curvature_rate(chain),
                        bends_words(problem, chain)),
            {}};
  }
  const WaypointCandidates::Tightest tightest = candidates.tightest_of(chain);
  const Contact& contact = tightest.contact;
  const std::string obstacle = problem.world().source_name(contact.source);
  const std::string place = fmt::format("{} at ({:.3f}, {:.3f})", obstacle, contact.point.x, contact.point.y);
  if (contact.clearance <= 0.0) return {"touches " + place, tightest};
  if (contact.clearance >= problem.required_clearance()) return {"comes too near to something between the poses looked at, near " + place, tightest};
  return {fmt::format("comes as near as {:.4f} m to {}, and {:.4f} m are required", contact.clearance, place, problem.required_clearance()), tightest};
}

PlanningFailure failure_of(const Problem& problem, WaypointCandidates& candidates, const Clothoids& chain, std::int64_t looked, const Budget& budget) {
  PlanningFailure failure;
  failure.failure.status = status_of(budget);
  const auto [why, tightest] = refusal_of(problem, candidates, chain);
  if (tightest) {
    failure.failure.pose = tightest->pose;
    failure.failure.point = tightest->contact.point;
  }
  const std::size_t waypoints = problem.scenario().waypoints.size();
  const char* through = waypoints == 0 ? "from start to goal" : waypoints == 1 ? "through the waypoint" : "through the waypoints";
  failure.failure.reason = looked == 1 ? fmt::format("the only chain of clothoids {} that was looked at cannot be driven: it {}", through, why)
                                       : fmt::format("of {} chains of clothoids {} none can be driven; the best one {}", looked, through, why);
  failure.explanation.push_back(limits_sentence(problem, chain, candidates.options().continuity));
  failure.alternatives.push_back({looked == 1 ? "the only candidate" : "best candidate", false, std::nullopt, "It " + why + ".", picture_of(chain), {}});
  return failure;
}

std::optional<PlanningFailure> blocked_waypoint(const Problem& problem) {
  const Scenario& scenario = problem.scenario();
  if (scenario.waypoint_radius > 0.0) return std::nullopt;
  const bool is_covered = contains_origin(problem.footprint());
  const double inner = problem.footprint().inner_radius();
  for (std::size_t i = 0; i < scenario.waypoints.size(); ++i) {
    const Vec2 at = scenario.waypoints[i];
    const double needed = inner + problem.required_clearance();
    const Contact contact = problem.world().clearance(std::span{&at, 1}, 0.0, needed);
    if (!is_covered || (contact.clearance > 0.0 && contact.clearance >= needed)) continue;
    const std::string name = problem.world().source_name(contact.source);
    PlanningFailure failure;
    if (contact.clearance > 0.0) {
      failure.failure = {Status::no_path,
                         fmt::format("waypoint {} at ({:.3f}, {:.3f}) is {:.4f} m from {}, and whatever its heading there the vehicle needs {:.4f} m{}", i + 1, at.x, at.y,
                                     contact.clearance, name, needed, problem.required_clearance() > 0.0 ? ", the clearance asked for included" : ""),
                         make_pose(at, 0.0), contact.point};
      return failure;
    }
    const bool is_thin = name.rfind("line ", 0) == 0 || name.rfind("scan point ", 0) == 0;
    failure.failure = {Status::no_path, fmt::format("waypoint {} at ({:.3f}, {:.3f}) is {} {}", i + 1, at.x, at.y, contact.outside ? "outside" : is_thin ? "on" : "in", name),
                       make_pose(at, 0.0), at};
    return failure;
  }
  return std::nullopt;
}

PlanningFailure failure_without_chain(const Problem& problem, std::int64_t looked, std::optional<std::size_t> unsolved, const Budget& budget) {
  PlanningFailure failure;
  failure.failure.status = status_of(budget);
  failure.failure.reason = looked == 0   ? "the search was ended before it looked at a candidate"
                           : looked == 1 ? "the only candidate has no chain of clothoids from waypoint to waypoint"
                                         : fmt::format("none of {} has a chain of clothoids from waypoint to waypoint", counted(looked, "candidate"));
  if (const auto tiny = tiny_leg(problem); looked > 0 && tiny) failure.failure.reason += "; too near to turn between may be " + leg_words(problem, *tiny);
  else if (looked > 0 && unsolved) failure.failure.reason += "; there is none between " + leg_words(problem, *unsolved);
  return failure;
}

}  // namespace waywright
