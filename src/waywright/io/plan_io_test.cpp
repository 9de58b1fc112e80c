#include "waywright/io/plan_io.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

using test::fingerprint;
using test::Folder;

/// A plan with every kind of piece and every field; its numbers need not fit each other.
Plan full_plan() {
  Plan p;
  p.version = "0.0.9-other";
  p.status = Status::unproven;
  p.reason = "the path jumps after piece 1 \"by much\"";
  p.reproducible = false;
  p.scenario = parse_scenario(test::full_scenario, "s.json", {}).value();
  p.planner = "ours";
  p.parameters = {{"weight", 0.1}, {"polish", true}, {"optimizer", std::string{"de"}}};
  p.scenario.planner = {p.planner, p.parameters};
  p.seed = 9223372036854775807U;
  p.timing = {0.1, 0.2, 1e-300, 0.30000000000000004};
  p.effort.evaluations = 640;
  p.effort.expansions = 1234;
  BezierSpan cubic{3, {Vec2{0.1, 1e-300}, {1, 0}, {2, 1}, {3, 1}}};
  BezierSpan quintic{5, {Vec2{3, 1}, {4, 1}, {5, 2}, {6, 2}, {7, 2}, {8, -0.0}}};
  BezierSpan line{1, {Vec2{8, 0}, {9, 0}}};
  p.path.pieces = {{Line{{0, 0}, {0.1, 1.0 / 3.0}}, 1},
                   {Arc{{0, 0, 9.42}, -0.7, 1e-300}, -1},
                   {Spline{SplineKind::natural_cubic, {cubic, line}}, 1},
                   {Spline{SplineKind::quintic, {quintic}}, -1},
                   {Turn{{8, 0}, 3.5, -0.1}, 0},
                   {PoseSequence{{{8, 0, 3.1}, {8.1, 0, 3.2 - two_pi}, {8.2, 5e-324, -3.0}}}, -1}};
  for (int i = 0; i < 7; ++i) {
    Sample s;
    s.s = 0.1 * i;
    s.x = 1.0 / (i + 3);
    s.y = -0.0;
    s.heading = -3.1 + i;
    s.course = pi;
    s.curvature = i == 3 ? 1e300 : 0.1 * i;
    s.direction = i % 3 - 1;
    s.t = 0.7 * i;
    s.speed = 0.3;
    p.samples.push_back(s);
  }
  p.metrics = {1.1, 0.2, 0.30000000000000004, 4e100, 5.5, 6.6, 7.7, 8.8, 9, 1e-300, 11.1};
  p.certificate = {true, 0.051, 0.0005, 3.3, 0.0041, Pose{1, 2, 0.1}, {0.1, 0.2}, World::nothing};
  p.tightest_obstacle = "obstacle 3";
  p.explanation = {"why", "against which alternatives: 50 % \xe2\x80\x93 \"so\""};
  p.alternatives = {{"left side", true, 0.1, "taken", {}, {}},
                    {"right side", false, std::nullopt, "too narrow", {}, {}}};
  return p;
}

TEST(PlanIo, RoundTripKeepsEveryBit) {
  const Plan plan = full_plan();
  const std::string text = plan_json(plan);
  const auto back = parse_plan(text, "plan.json");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(fingerprint(*back), fingerprint(plan));
  EXPECT_EQ(plan_json(*back), text);
}

TEST(PlanIo, EveryStatusWithoutAPathKeeps) {
  for (const Status status :
       {Status::no_path, Status::start_in_collision, Status::goal_in_collision, Status::start_outside,
        Status::goal_outside, Status::timed_out, Status::canceled}) {
    Plan plan = full_plan();
    plan.status = status;
    plan.path = {};
    plan.samples.clear();
    plan.metrics = {};
    plan.certificate = {};
    plan.tightest_obstacle.clear();
    const std::string text = plan_json(plan);
    const Json json = Json::parse(text);
    EXPECT_TRUE(json["path"].is_null() && json["metrics"].is_null() && json["certificate"].is_null());
    EXPECT_EQ(fingerprint(parse_plan(text, "p").value()), fingerprint(plan)) << to_string(status);
  }
  Plan solved = full_plan();
  solved.status = Status::solved;
  solved.reason.clear();
  EXPECT_TRUE(Json::parse(plan_json(solved))["reason"].is_null());
  EXPECT_EQ(fingerprint(parse_plan(plan_json(solved), "p").value()), fingerprint(solved));
}

TEST(PlanIo, FieldsAreThoseOfTheContract) {
  const Json json = Json::parse(plan_json(full_plan()));
  const auto names = [](const Json& object) {
    std::string text;
    for (const auto& [key, value] : object.items()) text += key + " ";
    return text;
  };
  EXPECT_EQ(names(json),
            "format version status reason reproducible scenario planner seed timing effort path metrics "
            "certificate explanation meta ");
  EXPECT_EQ(json["format"], "waywright-plan/1");
  EXPECT_EQ(names(json["timing"]), "load prepare plan prove ");
  EXPECT_EQ(names(json["path"]["samples"]), "s x y heading course curvature direction t speed ");
  EXPECT_EQ(names(json["metrics"]),
            "length min_clearance mean_clearance max_curvature max_curvature_rate curvature_change "
            "curvature_change_printed turning "
            "collision_risk travel_time direction_changes ");
  EXPECT_EQ(names(json["certificate"]), "collision_free clearance tolerance checked_length pocket_clearance tightest ");
  EXPECT_EQ(names(json["certificate"]["tightest"]), "pose point obstacle ");
  EXPECT_EQ(names(json["path"]["pieces"][0]), "kind direction from to ");
  EXPECT_EQ(names(json["path"]["pieces"][1]), "kind direction start curvature length ");
  EXPECT_EQ(json["path"]["pieces"][2]["kind"], "natural_cubic_spline");
  EXPECT_EQ(json["path"]["pieces"][2]["spans"][1].size(), 2U);
  EXPECT_EQ(json["path"]["pieces"][3]["kind"], "quintic_spline");
  EXPECT_EQ(names(json["path"]["pieces"][4]), "kind direction at from angle ");
  EXPECT_EQ(names(json["path"]["pieces"][5]), "kind direction poses ");
  EXPECT_TRUE(json["meta"]["alternatives"][1]["cost"].is_null());
  EXPECT_EQ(json["scenario"]["planner"]["name"], "ours") << "the scenario as used";
}

TEST(PlanIo, NoNumberIsWrittenThatIsNone) {
  Plan plan = full_plan();
  const double infinity = std::numeric_limits<double>::infinity();
  plan.samples[2].curvature = infinity;
  plan.samples[3].curvature = -infinity;
  plan.samples[4].curvature = std::nan("");
  plan.metrics.max_curvature = infinity;
  plan.metrics.curvature_change = infinity;
  plan.alternatives[0].cost = infinity;
  plan.scenario.vehicle.limits.curvature = infinity;
  const std::string text = plan_json(plan);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  const auto back = parse_plan(text, "p");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(back->samples[2].curvature, std::numeric_limits<double>::max());
  EXPECT_EQ(back->samples[3].curvature, -std::numeric_limits<double>::max());
  EXPECT_EQ(back->metrics.max_curvature, infinity) << "left out, and known to be so";
  EXPECT_EQ(back->metrics.length, plan.metrics.length);
  EXPECT_FALSE(back->alternatives[0].cost);
}

TEST(PlanIo, WhatIsFreeIsLeftAlone) {
  Json json = Json::parse(plan_json(full_plan()));
  for (const char* meta : {R"({})", R"({"alternatives": 5})", R"({"alternatives": [{"name": 1}]})",
                           R"({"alternatives": [7], "x": {"y": []}})"}) {
    json["meta"] = Json::parse(meta);
    const auto plan = parse_plan(json.dump(), "p");
    ASSERT_TRUE(plan) << plan.error().message();
    EXPECT_TRUE(plan->alternatives.empty());
  }
  for (const char* field : {"reason", "reproducible", "seed", "timing", "effort", "explanation", "meta"})
    json.erase(field);
  EXPECT_TRUE(parse_plan(json.dump(), "p")) << "what others judge anew may be missing";
  json["version"] = "17.4";
  EXPECT_EQ(parse_plan(json.dump(), "p")->version, "17.4");
}

TEST(PlanIo, AScenarioOfTheGreatestDepthFits) {
  Json deep = Json::object();
  for (std::size_t i = 0; i + 3 < deepest_json; ++i) deep = Json::array({deep});
  Json scenario = Json::parse(test::least_scenario);
  scenario["meta"] = {{"deep", deep}};
  Plan plan = full_plan();
  plan.scenario = parse_scenario(scenario.dump(), "s", {}).value();
  const auto back = parse_plan(plan_json(plan), "p");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(back->scenario.meta, plan.scenario.meta);
}

TEST(PlanIo, FilesOfAPlanStartAtItsFolder) {
  const Folder folder;
  Json json = Json::parse(plan_json(full_plan()));
  json["scenario"]["vehicle"] = "v.json";
  folder.write(
      "v.json",
      R"({"name": "other", "footprint": {"disc": 0.2}, "drive": {"type": "differential", "track": 0.3}})");
  const auto plan = read_plan(folder.write("plan.json", json.dump()));
  ASSERT_TRUE(plan) << plan.error().message();
  EXPECT_EQ(plan->scenario.vehicle.name, "other");
  EXPECT_EQ(read_plan(folder.path()).error().problem, "it is a folder");
}

TEST(BadPlan, EveryFieldIsRefusedWithItsSentence) {
  struct BadField {
    const char* pointer;
    const char* value;
    const char* sentence;
  };
  const BadField fields[] = {
      // clang-format off
      {"/format", R"("waywright-plan/2")", R"(format: "waywright-plan/2" was written by a newer version; this one reads /1 (allowed: waywright-plan/1))"},
      {"/format", R"("waywright-scenario/1")", R"(format: "waywright-scenario/1" is not a format that can be read here (allowed: waywright-plan/1))"},
      {"/version", R"(1)", R"(version: it is a number (allowed: text))"},
      {"/status", R"("fine")", R"(status: "fine" is not known (allowed: solved, unproven, no_path, start_in_collision, goal_in_collision, start_outside, goal_outside, timed_out, canceled))"},
      {"/status", R"()", R"(status: the field is missing (allowed: solved, unproven, no_path, start_in_collision, goal_in_collision, start_outside, goal_outside, timed_out, canceled))"},
      {"/reason", R"(0)", R"(reason: it is a number (allowed: text))"},
      {"/reproducible", R"("yes")", R"(reproducible: it is text (allowed: true or false))"},
      {"/verdict", R"(true)", R"(verdict: unknown field (allowed: format, version, status, reason, reproducible, scenario, planner, seed, timing, effort, legs, path, metrics, certificate, explanation, meta))"},
      {"/legs", R"([{}])", R"(legs: there are 1 (allowed: no such field, as the scenario has no legs))"},
      {"/legs", R"({})", R"(legs: it is an object (allowed: an array))"},
      {"/scenario", R"()", R"(scenario: the field is missing (allowed: an object))"},
      {"/scenario/clearance", R"(-1)", R"(scenario.clearance: -1 is out of range (allowed: 0 to 1000))"},
      {"/scenario/format", R"("waywright-scenario/2")", R"(scenario.format: "waywright-scenario/2" was written by a newer version; this one reads /1 (allowed: waywright-scenario/1))"},
      {"/planner", R"("de")", R"(planner: it is text (allowed: an object))"},
      {"/planner/parameters", R"()", R"(planner.parameters: the field is missing (allowed: an object of parameters by name))"},
      {"/planner/parameters/weight", R"(null)", R"(planner.parameters.weight: it is null (allowed: a number, text, true or false))"},
      {"/planner/optimizer", R"("de")", R"(planner.optimizer: unknown field (allowed: name, parameters))"},
      {"/seed", R"(-1)", R"(seed: -1 is out of range (allowed: 0 to 9223372036854775807))"},
      {"/timing", R"(0.1)", R"(timing: it is a number (allowed: an object))"},
      {"/timing/plan", R"(-1)", R"(timing.plan: -1 is out of range (allowed: 0 to 1000000000))"},
      {"/timing/total", R"(1)", R"(timing.total: unknown field (allowed: load, prepare, plan, prove))"},
      {"/effort/evaluations", R"(0.5)", R"(effort.evaluations: 0.5 is not a whole number (allowed: a whole number))"},
      {"/effort/luck", R"(1)", R"(effort.luck: unknown field (allowed: evaluations, expansions, samples))"},
      {"/path", R"()", R"(path: the field is missing (allowed: an object, or null where there is no path))"},
      {"/path", R"(null)", R"(metrics: it is given without a path (allowed: null))"},
      {"/metrics", R"(null)", R"(metrics: it is null (allowed: an object, as there is a path))"},
      {"/certificate", R"(null)", R"(certificate: it is null (allowed: an object, as there is a path))"},
      {"/certificate", R"()", R"(certificate: the field is missing (allowed: an object, or null where there is no path))"},
      {"/path/pieces", R"([])", R"(path.pieces: a path without pieces (allowed: at least one piece, or null as the path))"},
      {"/path/pieces", R"({})", R"(path.pieces: it is an object (allowed: an array))"},
      {"/path/points", R"([])", R"(path.points: unknown field (allowed: pieces, samples))"},
      {"/path/samples", R"()", R"(path.samples: the field is missing (allowed: an object))"},
      {"/path/pieces/0/kind", R"("loop")", R"(path.pieces[0].kind: "loop" is not known (allowed: line, arc, clothoid, turn, poses, natural_cubic_spline, quintic_spline))"},
      {"/path/pieces/0/kind", R"()", R"(path.pieces[0].kind: the field is missing (allowed: line, arc, clothoid, turn, poses, natural_cubic_spline, quintic_spline))"},
      {"/path/pieces/0/direction", R"(0)", R"(path.pieces[0].direction: 0 on a piece of kind "line" (allowed: 1, -1))"},
      {"/path/pieces/0/direction", R"(2)", R"(path.pieces[0].direction: 2 is out of range (allowed: -1 to 1))"},
      {"/path/pieces/0/direction", R"(0.5)", R"(path.pieces[0].direction: 0.5 is not a whole number (allowed: a whole number))"},
      {"/path/pieces/0/to", R"([1])", R"(path.pieces[0].to: it has 1 element (allowed: [x, y]))"},
      {"/path/pieces/0/curvature", R"(0)", R"(path.pieces[0].curvature: unknown field (allowed: kind, direction, from, to, heading))"},
      {"/path/pieces/1/start", R"([0,0])", R"(path.pieces[1].start: it has 2 elements (allowed: [x, y, course]))"},
      {"/path/pieces/1/length", R"(0)", R"(path.pieces[1].length: 0 is out of range (allowed: above 0, at most 10000000))"},
      {"/path/pieces/1/curvature", R"(1e9)", R"(path.pieces[1].curvature: 1000000000 is out of range (allowed: -1000000 to 1000000))"},
      {"/path/pieces/2/spans", R"([])", R"(path.pieces[2].spans: a spline without spans (allowed: at least one span))"},
      {"/path/pieces/2/spans/0", R"([[0,0]])", R"(path.pieces[2].spans[0]: a span of 1 control point (allowed: 2 to 6 points [x, y]))"},
      {"/path/pieces/2/spans/0", R"([[0,0],[0,0],[0,0],[0,0],[0,0],[0,0],[0,0]])", R"(path.pieces[2].spans[0]: a span of 7 control points (allowed: 2 to 6 points [x, y]))"},
      {"/path/pieces/2/spans/1/0/1", R"("0")", R"(path.pieces[2].spans[1][0][1]: it is text (allowed: a number from -10000000 to 10000000))"},
      {"/path/pieces/4/direction", R"(1)", R"(path.pieces[4].direction: 1 on a piece of kind "turn" (allowed: 0))"},
      {"/path/pieces/4/angle", R"(1e4)", R"(path.pieces[4].angle: 10000 is out of range (allowed: -1000 to 1000))"},
      {"/path/pieces/5/poses", R"([[0,0,0]])", R"(path.pieces[5].poses: fewer than two poses (allowed: at least two poses [x, y, heading]))"},
      {"/path/pieces/5/poses/1", R"([0,0])", R"(path.pieces[5].poses[1]: it has 2 elements (allowed: [x, y, heading]))"},
      {"/path/samples/x", R"()", R"(path.samples.x: the field is missing (allowed: an array of numbers))"},
      {"/path/samples/x", R"([1,2])", R"(path.samples.x: it has 2 elements (allowed: as many as s: 7))"},
      {"/path/samples/s", R"({})", R"(path.samples.s: it is an object (allowed: an array of numbers))"},
      {"/path/samples/s", R"([])", R"(path.samples.x: it has 7 elements (allowed: as many as s: 0))"},
      {"/path/samples/speed/2", R"(null)", R"(path.samples.speed[2]: it is null (allowed: a number))"},
      {"/path/samples/direction/1", R"(0.5)", R"(path.samples.direction[1]: 0.5 is no direction (allowed: 1, -1, 0))"},
      {"/path/samples/direction/1", R"(2)", R"(path.samples.direction[1]: 2 is out of range (allowed: -1 to 1))"},
      {"/path/samples/z", R"([])", R"(path.samples.z: unknown field (allowed: s, x, y, heading, course, curvature, direction, t, speed))"},
      {"/metrics/length", R"("far")", R"(metrics.length: it is text (allowed: a number))"},
      {"/metrics/direction_changes", R"(-1)", R"(metrics.direction_changes: -1 is out of range (allowed: 0 to 1000000000))"},
      {"/metrics/direction_changes", R"()", R"(metrics.direction_changes: the field is missing (allowed: a whole number from 0 to 1000000000))"},
      {"/metrics/beauty", R"(1)", R"(metrics.beauty: unknown field (allowed: length, min_clearance, mean_clearance, max_curvature, max_curvature_rate, curvature_change, curvature_change_printed, turning, direction_changes, collision_risk, travel_time))"},
      {"/certificate/collision_free", R"(1)", R"(certificate.collision_free: it is a number (allowed: true or false))"},
      {"/certificate/clearance", R"(-0.1)", R"(certificate.clearance: -0.1 is out of range (allowed: 0 to 1000000000))"},
      {"/certificate/tightest", R"({})", R"(certificate.tightest.pose: the field is missing (allowed: [x, y, heading]))"},
      {"/certificate/tightest/obstacle", R"(3)", R"(certificate.tightest.obstacle: it is a number (allowed: text))"},
      {"/explanation", R"("because")", R"(explanation: it is text (allowed: an array))"},
      {"/explanation/0", R"(7)", R"(explanation[0]: it is a number (allowed: text))"},
      {"/meta", R"([])", R"(meta: it is an array (allowed: an object))"},
      // clang-format on
  };
  const std::string text = plan_json(full_plan());
  for (const BadField& field : fields) {
    SCOPED_TRACE(std::string{field.pointer} + " = " + field.value);
    Json json = Json::parse(text);
    const Json::json_pointer place{field.pointer};
    if (*field.value == '\0')
      json[place.parent_pointer()].erase(place.back());
    else
      json[place] = Json::parse(field.value);
    const auto plan = parse_plan(json.dump(), "p.json");
    EXPECT_EQ(plan ? "accepted" : plan.error().message(), "p.json: " + std::string{field.sentence});
  }
}

}  // namespace
}  // namespace waywright
