// Geometry through reader, planner and proof, held against brute force.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/fuzz/sentences.hpp"
#include "tests/fuzz/station_bytes.hpp"
#include "tests/fuzz/target.hpp"
#include "tests/oracle/confirm.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/replan.hpp"

namespace waywright::fuzz {
namespace {

constexpr double coarse_step = 0.02;  // m; any sample nearer than the proven bound refutes it, however coarse
constexpr std::int64_t few = 48;      // candidate paths

void confirm(const Problem& problem, const Plan& plan) {
  const Scenario& scenario = problem.scenario();
  const OracleClearance found = oracle_mission_clearance(scenario, plan.path, coarse_step);
  const double slack = 1e-9 + 1e-14 * norm(scenario.start.position());
  const double margin = problem.pose_error_margin();
  require(found.vehicle > 0.0, "a solved path touches nothing");
  require(plan.certificate.clearance + margin <= found.vehicle + slack,
          fmt::format("{} m of clearance are proven, {} m are measured", plan.certificate.clearance + margin, found.vehicle));
  require(plan.certificate.clearance >= scenario.clearance - 1e-6, "a solved path keeps its clearance");
  require(found.forks.has_value() == plan.certificate.pocket_clearance.has_value(), "forks in a pocket are proven where there are some");
  if (found.forks) {
    require(*plan.certificate.pocket_clearance + margin <= *found.forks + slack,
            fmt::format("{} m of clearance are proven in the pocket, {} m are measured", *plan.certificate.pocket_clearance + margin, *found.forks));
  }
}

/// What every plan keeps; false where it found nothing.
bool stands(const Problem& problem, const Plan& plan) {
  require((plan.status == Status::solved) == plan.reason.empty(), "a reason is given where there is no solution, and only there");
  if (plan.status != Status::solved) return false;
  confirm(problem, plan);
  const auto read = parse_plan(plan_json(plan), "plan.json");
  require(read.has_value(), "a plan's file is read");
  const auto verification = verify(*read);
  require(verification.has_value(), "a plan's scenario is prepared again");
  require(verification->holds, verification->holds ? "" : "a solved plan verifies: " + verification->findings.front());
  const double off = plan.samples.front().speed - std::abs(problem.scenario().start_motion.speed);
  require(std::abs(off) <= 2e-3, fmt::format("a plan begins at the vehicle's speed, and not {} m/s off it", off));
  return true;
}

/// On the way the shelf and the vehicle turn out to be elsewhere.
void drive_into(const Surprise& surprise, const Problem& problem, const Plan& plan) {
  if (problem.is_driven_back()) return;
  const Handover now = handover_at(plan.path, plan.samples, surprise.at * plan.samples.back().t);
  Scenario scenario = problem.scenario();
  scenario.start = Frame{now.pose}.to_world(surprise.vehicle);
  scenario.start_motion = now.motion;
  scenario.start_motion.curvature += surprise.curvature;
  Shelf& shelf = std::get<Station>(scenario.mission).shelf;
  const Pose where = Frame{make_pose(shelf.center, shelf.heading)}.to_world(surprise.shelf);
  shelf.center = where.position();
  shelf.heading = where.heading;
  const auto changed = Problem::prepare(scenario);
  if (!changed) return require_sentence(changed.error());
  const auto next = replan(*changed, plan.path, now.driven);
  require(next.has_value(), "the planner's parameters still fit");
  stands(*changed, *next);
}

}  // namespace

Outcome run_station(const std::string& bytes) {
  const auto [made, surprise] = station_of(bytes);
  // Through the writer and the reader, whose checks and repairs the rest builds on.
  const auto scenario = parse_scenario(scenario_json(made), "station", {});
  if (!scenario) {
    require_sentence(scenario.error());
    return Outcome::refused;
  }
  Scenario bounded = *scenario;
  bounded.planner = {"pattern_docking", {{"fallback", false}}};
  bounded.budget.evaluations = few;
  const auto problem = Problem::prepare(bounded);
  if (!problem) {
    require_sentence(problem.error());
    return Outcome::refused;
  }
  const auto plan = solve(*problem);
  require(plan.has_value(), "the planner's parameters fit");
  if (!stands(*problem, *plan)) return Outcome::refused;
  drive_into(surprise, *problem, *plan);
  return Outcome::accepted;
}

/// Stations that are solved, without awkward numbers but those that mutations bring.
std::vector<std::string> station_seeds() {
  std::vector<std::string> seeds;
  for (std::uint64_t seed = 0; seeds.size() < 24; ++seed) {
    Random random = Random::stream(seed, 0);
    std::string bytes;
    for (int i = 0; i < 220; ++i) bytes.push_back(static_cast<char>(random.integer(0, 239)));
    if (run_station(bytes) == Outcome::accepted) seeds.push_back(std::move(bytes));
  }
  return seeds;
}

}  // namespace waywright::fuzz
