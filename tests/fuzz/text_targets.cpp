// Texts: scenario.json, plan.json, poses as CSV.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tests/fuzz/sentences.hpp"
#include "tests/fuzz/target.hpp"
#include "waywright/io/obstacles_io.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/site_csv.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/io/whale_config.hpp"
#include "waywright/judge/import.hpp"
#include "waywright/judge/legs.hpp"
#include "waywright/planner/solve_legs.hpp"

namespace waywright::fuzz {
namespace {

using test::fingerprint;

constexpr std::size_t most_cells = 1 << 16;    // of a grid: writing out more takes the time of many small inputs
constexpr std::size_t most_segments = 20'000;  // of a path

bool is_small(const Map& map) {
  std::size_t cells = 0;
  for (const CellGrid& grid : map.grids) cells += grid.blocked.size();
  return cells <= most_cells;
}

bool is_small(const Path& path) {
  std::size_t segments = 0;
  for (const Piece& piece : path.pieces) {
    if (const auto* spline = std::get_if<Spline>(&piece.curve)) segments += spline->spans.size();
    else if (const auto* poses = std::get_if<PoseSequence>(&piece.curve)) segments += poses->poses.size();
    else ++segments;
  }
  return segments <= most_segments;
}

/// What a judged path says is a number or nothing, and its claims fit together.
void require_sound(const Plan& plan) {
  const Certificate& c = plan.certificate;
  require(std::isfinite(c.clearance) && c.clearance >= 0.0, "the certificate's clearance is a number from 0");
  require((plan.status == Status::solved) == plan.reason.empty(), "a reason is given where there is no solution, and only there");
  if (plan.status == Status::solved) require(c.collision_free, "what is solved is free of collision");
  for (const Sample& s : plan.samples) {
    require(is_finite(s.pose()) && std::isfinite(s.s) && std::isfinite(s.t) && std::isfinite(s.speed) && s.speed >= 0.0,
            "samples are numbers");
  }
}

std::string example(const std::string& name) { return std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name; }

}  // namespace

Outcome run_scenario(const std::string& text) {
  const auto scenario = parse_scenario(text, "s.json", "nowhere");
  if (!scenario) {
    require_sentence(scenario.error());
    return Outcome::refused;
  }
  if (!is_small(scenario->map)) return Outcome::accepted;
  const auto again = parse_scenario(scenario_json(*scenario), "again", "nowhere");
  require(again.has_value(), "what was accepted is written so that it is accepted again");
  require(fingerprint(*again) == fingerprint(*scenario), "what was accepted reads back to the same bits");
  if (!scenario->legs.empty()) {
    Scenario mission = *scenario;
    if (const auto complete = complete_legs(mission); !complete) require_sentence(complete.error());
    else if (const auto first = prepare_leg(mission, first_leg(mission), World{mission.map}); !first) require_sentence(first.error());
    else if (const auto ends = first->check_ends()) require(ends->reason.size() > 5, "an end that cannot be is told why");
    return Outcome::accepted;
  }
  const auto problem = Problem::prepare(*scenario);
  if (!problem) {
    require_sentence(problem.error());
    return Outcome::accepted;
  }
  if (const auto ends = problem->check_ends()) require(ends->reason.size() > 5, "an end that cannot be is told why");
  return Outcome::accepted;
}

Outcome run_plan(const std::string& text) {
  const auto plan = parse_plan(text, "nowhere/plan.json");
  if (!plan) {
    require_sentence(plan.error());
    return Outcome::refused;
  }
  if (!is_small(plan->scenario.map)) return Outcome::accepted;
  const std::string written = plan_json(*plan);
  const auto again = parse_plan(written, "nowhere/again.json");
  require(again.has_value(), "what was accepted is written so that it is accepted again");
  require(plan_json(*again) == written, "what was accepted reads back to the same bits");
  if (!is_small(plan->path)) return Outcome::accepted;
  const auto verification = verify(*plan);
  if (!verification) {
    require_sentence(verification.error());
    return Outcome::accepted;
  }
  require(verification->holds == verification->findings.empty(), "findings are what does not hold");
  for (const std::string& finding : verification->findings) require(finding.size() > 5, "a finding is a sentence");
  if (!plan->path.pieces.empty()) require_sound(verification->fresh);
  return Outcome::accepted;
}

Outcome run_poses(const std::string& text) {
  const auto path = parse_poses_csv(text, "p.csv");
  if (!path) {
    require_sentence(path.error());
    return Outcome::refused;
  }
  for (std::size_t k = 0; k < path->pieces.size(); ++k) {
    const Piece& piece = path->pieces[k];
    require((piece.direction == 0) == std::holds_alternative<Turn>(piece.curve), "only turns have no direction");
    require(is_finite(start_pose(piece)) && is_finite(end_pose(piece)), "poses are numbers");
    if (k == 0) continue;
    const Pose before = end_pose(path->pieces[k - 1]);
    require(before.position() == start_pose(piece).position(), "a piece begins where the one before ends");
    require(std::abs(shorter_turn(before.heading, start_pose(piece).heading)) <= 1e-9, "and looks where it did");
  }
  if (!is_small(*path)) return Outcome::accepted;
  static const Problem problem = Problem::prepare(read_scenario(example("dock_insertion.json")).value()).value();
  require_sound(judge_imported(problem, *path));
  return Outcome::accepted;
}

Outcome run_site(const std::string& text) {
  static const Site site = [] {
    const Scenario whole = read_scenario(example("dock_insertion.json")).value();
    return Site{whole.map, whole.map_source, whole.vehicle, whole.map.notes};
  }();
  const auto rows = parse_site_csv(text, "stations.csv", site);
  if (!rows) {
    require_sentence(rows.error());
    return Outcome::refused;
  }
  require(!rows->empty(), "a site has a place");
  for (const SiteRow& row : *rows) {
    require(!row.name.empty(), "a place has a name");
    const auto again = parse_scenario(scenario_json(row.scenario), "again", "nowhere");
    require(again.has_value(), "what was accepted is a scenario");
    require(fingerprint(*again) == fingerprint(row.scenario), "and reads back to the same bits");
    const auto problem = Problem::prepare(row.scenario);
    if (!problem) require_sentence(problem.error());
  }
  return Outcome::accepted;
}

Outcome run_obstacles(const std::string& text) {
  const auto seen = parse_obstacles(text, "obstacles.json");
  if (!seen) {
    require_sentence(seen.error());
    return Outcome::refused;
  }
  for (const MovingObstacle& obstacle : seen->moving) {
    require(!obstacle.track.empty(), "what moves is somewhere");
    for (std::size_t i = 1; i < obstacle.track.size(); ++i) require(obstacle.track[i].t > obstacle.track[i - 1].t, "times rise");
    const MovingPlaces places{obstacle};
    for (const double t : {0.0, 0.5 * obstacle.track.back().t, obstacle.track.back().t + 7.0}) {
      require(is_finite(obstacle.at(t)), "it is somewhere at any time");
      require(distance(obstacle.at(t).position(), places.between(t, t + 1.0).pose.position()) <= places.between(t, t + 1.0).reach * (1.0 + 1e-9) + 1e-6, "what bounds its motion holds");
    }
  }
  const auto again = parse_obstacles(obstacles_json(*seen), "again");
  require(again.has_value() && obstacles_json(*again) == obstacles_json(*seen), "what is written reads back to the same bits");
  return Outcome::accepted;
}

Outcome run_whale_config(const std::string& text) {
  const auto configured = parse_whale_config(text, "config.json", "nowhere");
  if (!configured) {
    require_sentence(configured.error());
    return Outcome::refused;
  }
  require(!configured->mapping.empty(), "each key is told");
  for (const std::string& line : configured->mapping) require(std::none_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), "in one line");
  const auto again = parse_scenario(scenario_json(configured->scenario), "again", "nowhere");
  require(again.has_value() && fingerprint(*again) == fingerprint(configured->scenario), "what it becomes is a scenario, and reads back to the same bits");
  return Outcome::accepted;
}

std::vector<std::string> scenario_seeds() {
  std::vector<std::string> seeds{test::full_scenario, test::least_scenario,
                                 scenario_json(parse_scenario(test::full_scenario, "s", {}).value())};
  for (const auto& entry : std::filesystem::directory_iterator{example("")}) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "dock_warehouse.json") continue;  // a large grid
    seeds.push_back(scenario_json(read_scenario(entry.path()).value(), -1));
  }
  std::sort(seeds.begin() + 3, seeds.end());
  return seeds;
}

std::vector<std::string> plan_seeds() {
  Plan every;
  every.version = "1";
  every.scenario = parse_scenario(test::least_scenario, "s", {}).value();
  every.path.pieces = {{Line{{0, 0}, {1, 0}}, 1},
                       {Arc{{1, 0, 0}, 0.5, 1}, 1},
                       {Spline{SplineKind::quintic, {{2, {Vec2{0, 0}, {1, 0}, {1, 1}}}}}, -1},
                       {Turn{{1, 1}, 0.5, 0.5}, 0},
                       {PoseSequence{{{1, 1, 1}, {2, 1, 1}}}, -1}};
  every.samples = {Sample{}, Sample{}, Sample{}};
  every.certificate.tightest = Pose{};
  every.explanation = {"why"};
  every.alternatives = {{"left", true, 1.0, "taken", {}, {}}};
  every.parameters = {{"a", 1.0}};

  // One that holds, beside an obstacle.
  Scenario beside = every.scenario;
  beside.map.obstacles = {rectangle({-0.5, 0.6}, {0.8, 0.9})};
  beside.vehicle.footprint = {rectangle({-0.3, -0.3}, {0.4, 0.3}), 0.0};
  beside.clearance = 0.02;
  beside.mission = Pose{0.3, 0.0, 0.2};
  const Path path{{{Line{{0, 0}, {0.3, 0}}, 1}, {Turn{{0.3, 0}, 0.0, 0.2}, 0}}};
  const Plan holds = judge(Problem::prepare(beside).value(), path);
  // And one through zones of every type, on curves of every kind.
  Scenario zoned = every.scenario;
  zoned.zones = {{ZoneType::directed, "one way", rectangle({-1, -1}, {2, 1}), 0.4, 1.0, 1.0}, {ZoneType::speed_limit, "slow", rectangle({0.5, -1}, {1, 1}), 0.0, 1.0, 0.2},
                 {ZoneType::penalty, "", rectangle({0, 0}, {1, 1}), 0.0, 2.0, 1.0}, {ZoneType::preferred, "", rectangle({0, 0}, {1, 1}), 0.0, 0.5, 1.0},
                 {ZoneType::forbidden, "closed", rectangle({3, 3}, {4, 4}), 0.0, 1.0, 1.0}};
  const Path through{{{Line{{0, 0}, {0.5, 0}}, 1}, {Clothoid{{0.5, 0, 0}, 0.0, 0.5, 0.4}, 1}, {PoseSequence{{{0.9, 0.005, 0.04}, {1.0, 0.01, 0.05}}}, 1}}};
  const Plan through_zones = judge(Problem::prepare(zoned).value(), through);

  // Two legs with a load between them, and the same as far as its first.
  Scenario mission = beside;
  mission.vehicle.loads["crate"] = {{rectangle({-0.35, -0.3}, {0.4, 0.35}), 0.0}, 20.0};
  Leg out, back;
  out.mission = FreeGoal{{{0.3, 0.0}}};
  out.name = "out";
  out.load = "crate";
  back.mission = Pose{0.1, 0.0, 0.0};
  back.planner = PlannerChoice{"astar", {}};
  mission.legs = {out, back};
  const auto legs_of = [&](std::size_t count) {
    std::vector<JudgedLeg> legs;
    LegBegin begin = first_leg(mission);
    for (const Path& part : {Path{{{Line{{0, 0}, {0.3, 0}}, 1}}}, Path{{{Line{{0.3, 0}, {0.1, 0}}, -1}}}}) {
      const Problem problem = prepare_leg(mission, begin, World{mission.map}).value();
      Plan plan = legs.size() < count ? judge(problem, part) : failed_plan(problem, {Status::no_path, "nothing was found", {}, {}});
      const Pose end = end_of(problem, part);
      legs.push_back({begin, end, std::move(plan)});
      begin = next_leg(mission, begin, end);
    }
    return plan_json(join_legs(mission, std::move(legs)));
  };
  return {plan_json(every), plan_json(holds), plan_json(through_zones), legs_of(2), legs_of(1)};
}

std::vector<std::string> obstacles_seeds() {
  return {R"({"format": "waywright-obstacles/1", "obstacles": [[[11.5, 11.5], [13, 11.5], [13, 13], [11.5, 13]]], "lines": [[[0, 0], [1, 1]]], "points": [[2, 3]]})",
          R"({"format": "waywright-obstacles/1", "moving": [{"name": "person", "footprint": {"disc": 0.3}, "track": [[0, 1, 2], [4.5, 3, 2, 1.5], [9, 0, 0]], "velocity": [0.5, 0],
 "spread": 0.05, "range": 1, "free_for": 1, "patience": 10}, {"footprint": [[0, 0], [1, 0], [1, 1]], "velocity": [-1, 0.5]}]})"};
}

std::vector<std::string> whale_config_seeds() {
  return {R"({"ReturnOnFirstPath": true, "RenderGraphics": false, "CreateVideo": false, "TestMode": true, "MapProcessor_Obstacles_Dilation": 0, "MapProcessor_Epsilon": 0.02,
 "MapProcessor_Map_Name": "5", "PathPlanner_Iterations": 10000, "PathPlanner_Step_Size": 1.0, "PathPlanner_Search_Radius": 1.5, "PathPlanner_Goal_Threshold": 1.0,
 "PathOptimizer_Population": 10, "PathOptimizer_Iterations": 10, "PathOptimizer_a_Parameter": 4.0, "PathOptimizer_b_Parameter": 1.0, "PathOptimizer_Shortness_Weight": 10.0,
 "PathOptimizer_Collision_Free_Weight": 1.0, "PathOptimizer_Width_Bound": 2.5, "PathOptimizer_Height_Bound": 2.5})",
          R"({"MapProcessor": {"Map_Name": 3}, "PathPlanner": {"Iterations": 100, "Step_Size": 0.5}, "PathOptimizer": {"Population": 10}})", R"({"MapProcessor_Map_Name": "1", "TestMode": false, "ReturnOnFirstPath": true})"};
}

std::vector<std::string> poses_seeds() {
  return {
      "# poses\nx,y,heading,direction\n0,0,0,1\n1,0,0.1,1\n1,0,0.1,-1\n0.5,0,0.1,-1\n0.5,0,0.6,0\n0.5,1,0.7,1\n",
      "x,y,heading,speed\n0,0,0,0.5\n0.5,0,0,\n1,0,0,-1e3\n",
      "yaw;X;y\n0;0;0\n0.01;1;0\n\n0.02;2;0.02\n",
  };
}

std::vector<std::string> site_seeds() {
  return {
      "# a site\nname,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,clearance,planner,seed\n"
      "A,1,2,0.5,3,4,-1,0.05,,\n\"B \"\"1\"\"\",1,2,0.5,3,4,-1,,ompl_rrt_connect,7\n",
      "name;start_x;start_y;start_heading_deg;shelf_x;shelf_y;shelf_heading_deg;shelf_depth;shelf_width;gap;slot;area;station.insertion.depth;station.insertion.pockets;"
      "station.manoeuvre;pose_error.lateral;planner.optimizer;meta.who\n"
      "A;9.5;7;0;0.9;7;0;1.2;2.7;0.1;-0.2;0 0 | 12 14;0.5;[[-0.6, -0.2], [0.1, 0.5]];dock;0.01;de;me\n"
      "B;9.5;7;0;0.9;7;0;1.2;2.7;;;0 0 | 12 0 | 12 14 | 0 14;;;;;;\n",
  };
}

}  // namespace waywright::fuzz
