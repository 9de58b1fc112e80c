#include "waywright/planner/go_around.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/judge/judge.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/detour_words.hpp"
#include "waywright/planner/rest_of_plan.hpp"
#include "waywright/proof/moving_clearance.hpp"

namespace waywright {
namespace {

constexpr int disc_corners = 36, room_corners = 8;
constexpr double room_beside = 5e-3;  // m, that bounds in time take beside what stands
constexpr double least_kept = 1e-6;  // m
constexpr double look_every = 0.1;   // s
constexpr double share_of_size = 0.2;  // of its radius, that an obstacle moves by within one polygon of what it sweeps

/// The mission beside which nothing of a station is left to do but to reach a pose: its shelf and its area are obstacles then.
void take_station_into_map(Scenario& scenario, const Mission& mission) {
  const auto* station = std::get_if<Station>(&scenario.mission);
  if (station == nullptr || std::holds_alternative<Station>(mission)) return;
  scenario.map.boundaries.push_back(station->area);
  scenario.map.obstacles.push_back(station->shelf.outline());
}

/// All that an obstacle is predicted to sweep up to a time, as polygons that hold it.
std::vector<Ring> swept(const MovingObstacle& obstacle, double until) {
  std::vector<double> times{0.0};
  for (const MovingObstacle::Place& place : obstacle.track) {
    if (place.t > 0.0 && place.t < until) times.push_back(place.t);
  }
  times.push_back(until);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i + 1 < times.size();) {
    // Short steps of the track are one hull, as long as they go no farther than a share of its size.
    const Pose a = obstacle.at(times[i]);
    double way = 0.0;
    std::size_t end = i;
    bool turns = false;
    Ring points;
    std::vector<Pose> places{a};
    do {
      const Pose b = obstacle.at(times[++end]);
      way += distance(places.back().position(), b.position());
      turns = turns || a.heading != b.heading;
      places.push_back(b);
    } while (end + 1 < times.size() && way < share_of_size * obstacle.footprint.radius());
    // Where it turns, the disc around it holds it whatever its heading.
    const Footprint body = turns ? Footprint{{}, obstacle.footprint.radius()} : obstacle.footprint;
    const double room = room_beside + obstacle.off_by(times[end]);
    for (const Pose& place : places) {
      const Ring there = outline_that_holds(body, place, room);
      points.insert(points.end(), there.begin(), there.end());
    }
    rings.push_back(convex_hull(std::move(points)));
    i = end;
  }
  return rings;
}

/// What a plan takes over from the one that it comes in place of. `why`: a sentence; `left_at`: m, up to which both are the same.
void take_over(Plan& around, Plan& before, Plan& detour, std::string why, double left_at) {
  // A second detour's sentences are not those of a first one's way.
  const bool is_first = std::none_of(before.explanation.begin(), before.explanation.end(), [](const std::string& sentence) { return sentence.starts_with("Before what moves was looked at: "); });
  around.explanation = is_first ? of_part("Before what moves was looked at", before.explanation) : std::move(before.explanation);
  around.explanation.push_back(std::move(why));
  if (!before.samples.empty() && !around.samples.empty()) {
    around.explanation.push_back(detour_sentence({before.samples, before.metrics.travel_time, before.hindrance ? " if nothing moved" : ""}, {around.samples, around.metrics.travel_time}, left_at));
  }
  for (std::string& sentence : of_part("Of the detour", detour.explanation)) around.explanation.push_back(std::move(sentence));
  around.alternatives = std::move(before.alternatives);
  around.search = std::move(detour.search);
  around.planner = before.planner;
  around.parameters = before.parameters;
  around.timing.load = before.timing.load;
  around.timing.prepare = before.timing.prepare + detour.timing.prepare;
  around.timing.plan = before.timing.plan + detour.timing.plan;
  around.timing.prove += before.timing.prove;
  around.effort.evaluations = before.effort.evaluations + detour.effort.evaluations;
  around.effort.expansions = before.effort.expansions + detour.effort.expansions;
  around.reproducible = before.reproducible && detour.reproducible;
  around.replanned = std::move(before.replanned);
}

/// Of a plan that something comes to meet: a way beside what it is predicted to sweep until then, from the first place where the vehicle can stand. Empty where none serves.
Parsed<std::optional<Plan>> beside_what_comes(const Problem& problem, Plan& plan, const std::atomic<bool>* cancel) {
  const Hindrance& h = *plan.hindrance;
  const MovingObstacle& obstacle = problem.scenario().moving[h.obstacle];
  const auto leave = braking_distance(problem, plan.samples);
  if (!leave) return std::optional<Plan>{};
  // Until it has come so near to where the vehicle leaves its way that there is just room to turn away. (Then it walks on over places that the vehicle has left.)
  const Path kept = kept_until(plan.path, *leave);
  const Pose from = kept.pieces.empty() ? problem.first_pose() : end_pose(kept);
  const double room = 2.0 * problem.footprint().radius() + problem.required_clearance() + 2.0 * room_beside, latest = obstacle.track.back().t + 2.0 * plan.metrics.travel_time + 10.0;
  const MovingClearance clearance{problem, 0.0, 0.0};
  double until = 0.0;
  while (until < latest && clearance.distance_at(from, h.obstacle, until, 2.0 * room) > room) until += look_every;
  if (until == 0.0) return std::optional<Plan>{};
  auto found = detour(problem, kept, problem.scenario().mission, swept(obstacle, until), cancel);
  if (!found) return tl::unexpected{found.error()};
  if (found->plan.status != Status::solved) return std::optional<Plan>{};
  Plan around = judge(problem, found->whole, cancel);
  if (around.status != Status::solved) return std::optional<Plan>{};
  take_over(around, plan, found->plan, fmt::format("{} comes to where the vehicle could wait for it, so the way leads beside what it is predicted to sweep until it is there.", one_line(title_of(obstacle, h.obstacle))), found->s);
  return std::optional<Plan>{std::move(around)};
}

/// What stands in for what moves has a number of the map in sentences of planners: its name in place of that.
std::string named(std::string text, std::size_t first, const std::vector<std::string>& names) {
  for (std::size_t k = names.size(); k-- > 0;) {
    const std::string number = fmt::format("obstacle {} at ", first + k);
    for (std::size_t at = text.find(number); at != std::string::npos; at = text.find(number, at)) {
      text.replace(at, number.size(), names[k] + " at ");
      at += names[k].size();
    }
  }
  return text;
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

Path kept_until(const Path& path, double s) { return s > least_kept ? beginning(path, s) : Path{}; }

Parsed<WayOn> detour(const Problem& problem, Path kept, const Mission& mission, const std::vector<Ring>& more, const std::atomic<bool>* cancel) {
  Scenario scenario = problem.scenario();
  take_station_into_map(scenario, mission);
  scenario.mission = mission;
  scenario.moving.clear();
  scenario.map.obstacles.insert(scenario.map.obstacles.end(), more.begin(), more.end());
  WayOn found;
  if (!kept.pieces.empty()) {
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
  std::vector<std::string> names;  // of those
  const std::vector<MovingObstacle>& moving = problem.scenario().moving;
  for (std::size_t round = 0; round < moving.size(); ++round) {
    if (!plan.hindrance || plan.path.pieces.empty() || problem.pocket() || problem.is_driven_back()) return plan;
    const Hindrance h = *plan.hindrance;
    if (h.kind == Hindrance::Kind::comes && wanted.empty()) {
      auto beside = beside_what_comes(problem, plan, cancel);
      if (!beside) return tl::unexpected{beside.error()};
      return beside->has_value() ? std::move(**beside) : std::move(plan);
    }
    if (h.kind != Hindrance::Kind::stands) return plan;
    const MovingObstacle& obstacle = moving[h.obstacle];
    const auto since = obstacle.stands_from();
    if (!since) return plan;
    standing.push_back(outline_that_holds(obstacle.footprint, obstacle.at(*since), room_beside));
    const std::string who = one_line(title_of(obstacle, h.obstacle));
    names.push_back(who);
    auto found = detour(problem, kept_until(plan.path, h.s), problem.scenario().mission, standing, cancel);
    if (!found) return tl::unexpected{found.error()};
    if (found->plan.status != Status::solved) {
      plan.explanation.push_back(fmt::format("No way leads around {} from where the vehicle waits for it: {}.", who, named(found->plan.reason, problem.scenario().map.obstacles.size(), names)));
      return plan;
    }
    wanted.push_back({found->s, h.from + obstacle.patience, h.obstacle});
    Plan around = judge(problem, found->whole, cancel, wanted);
    take_over(around, plan, found->plan, fmt::format("{} stays in the way: the vehicle waits for {:g} s, {:.2f} m before it, and then takes it for an obstacle that stays, and a way around it.", who, obstacle.patience, h.ahead), found->s);
    plan = std::move(around);
  }
  return plan;
}

}  // namespace waywright
