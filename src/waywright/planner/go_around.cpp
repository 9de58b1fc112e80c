#include "waywright/planner/go_around.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/judge/judge.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/solve_words.hpp"

namespace waywright {
namespace {

constexpr int disc_corners = 36, room_corners = 8;
constexpr double room_beside = 5e-3;  // m, that bounds in time take beside what stands
constexpr double least_kept = 1e-6;  // m

/// The mission beside which nothing of a station is left to do but to reach a pose: its shelf and its area are obstacles then.
void take_station_into_map(Scenario& scenario, const Mission& mission) {
  const auto* station = std::get_if<Station>(&scenario.mission);
  if (station == nullptr || std::holds_alternative<Station>(mission)) return;
  scenario.map.boundaries.push_back(station->area);
  scenario.map.obstacles.push_back(station->shelf.outline());
}

}  // namespace

Ring outline_that_holds(const Footprint& footprint, const Pose& pose, double room) {
  const int corners = footprint.is_disc() ? disc_corners : room_corners;
  const double radius = (room + (footprint.is_disc() ? footprint.disc : 0.0)) / sin_cos(pi / corners).cos;
  if (!footprint.is_disc() && !(radius > 0.0)) return convex_hull(transformed(footprint.polygon, Frame{pose}));
  std::vector<Vec2> points;
  for (const Vec2 middle : footprint.is_disc() ? Ring{pose.position()} : transformed(footprint.polygon, Frame{pose})) {
    for (int i = 0; i < corners; ++i) points.push_back(middle + std::max(radius, 1e-3) * unit(two_pi * i / corners));
  }
  return convex_hull(std::move(points));
}

Path joined(Path first, const Path& then) {
  for (const Piece& piece : then.pieces) first.pieces.push_back(piece);
  return first;
}

Parsed<Detour> detour(const Problem& problem, const Path& path, double s, const Mission& mission, const std::vector<Ring>& more, const std::atomic<bool>* cancel) {
  Scenario scenario = problem.scenario();
  take_station_into_map(scenario, mission);
  scenario.mission = mission;
  scenario.moving.clear();
  scenario.map.obstacles.insert(scenario.map.obstacles.end(), more.begin(), more.end());
  Detour found;
  Path kept;
  if (s > least_kept) {
    kept = beginning(path, s);
    found.s = length(kept);
    scenario.start = end_pose(kept);
    scenario.start_motion = {};
  }
  auto from_there = Problem::prepare(std::move(scenario));
  if (!from_there) return tl::unexpected{from_there.error()};
  auto plan = solve(*from_there, cancel);
  if (!plan) return tl::unexpected{plan.error()};
  found.plan = std::move(*plan);
  if (found.plan.status == Status::solved) found.whole = joined(std::move(kept), found.plan.path);
  return found;
}

Parsed<Plan> led_around(const Problem& problem, Plan plan, const std::atomic<bool>* cancel) {
  std::vector<WantedWait> wanted;
  std::vector<Ring> standing;
  const std::vector<MovingObstacle>& moving = problem.scenario().moving;
  for (std::size_t round = 0; round < moving.size(); ++round) {
    if (!plan.hindrance || plan.hindrance->kind != Hindrance::Kind::stands || plan.path.pieces.empty() || problem.pocket() || problem.is_driven_back()) return plan;
    const Hindrance h = *plan.hindrance;
    const MovingObstacle& obstacle = moving[h.obstacle];
    const auto since = obstacle.stands_from();
    if (!since) return plan;
    standing.push_back(outline_that_holds(obstacle.footprint, obstacle.at(*since), room_beside));
    const std::string who = one_line(title_of(obstacle, h.obstacle));
    auto found = detour(problem, plan.path, h.s, problem.scenario().mission, standing, cancel);
    if (!found) return tl::unexpected{found.error()};
    if (found->plan.status != Status::solved) {
      plan.explanation.push_back(fmt::format("No way leads around {} from where the vehicle waits for it: {}.", who, found->plan.reason));
      return plan;
    }
    wanted.push_back({found->s, h.from + obstacle.patience, h.obstacle});
    Plan around = judge(problem, found->whole, cancel, wanted);
    around.explanation = std::move(plan.explanation);
    around.explanation.push_back(fmt::format("{} stays in the way: the vehicle waits for {:g} s, {:.2f} m before it, and then takes it for an obstacle that stays, and a way around it.", who, obstacle.patience, h.ahead));
    around.alternatives = std::move(plan.alternatives);
    around.search = std::move(found->plan.search);
    around.planner = plan.planner;
    around.parameters = plan.parameters;
    around.timing.load = plan.timing.load;
    around.timing.prepare = plan.timing.prepare + found->plan.timing.prepare;
    around.timing.plan = plan.timing.plan + found->plan.timing.plan;
    around.timing.prove += plan.timing.prove;
    around.effort.evaluations = plan.effort.evaluations + found->plan.effort.evaluations;
    around.effort.expansions = plan.effort.expansions + found->plan.effort.expansions;
    around.reproducible = plan.reproducible && found->plan.reproducible;
    around.replanned = std::move(plan.replanned);
    plan = std::move(around);
  }
  return plan;
}

}  // namespace waywright
