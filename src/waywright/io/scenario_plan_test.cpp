// Scenario and plan texts: round trips to the bit, and broken ones.
#include <gtest/gtest.h>

#include "waywright/core/random.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"

namespace waywright {
namespace {

std::string scenario_text() {
  return R"({"format": "waywright-scenario/1", "name": "n", "meta": {"who": ["a", 1, null]},
 "map": {"polygons": {"boundary": [[-1, -3], [9, -3], [9, 3], [-1, 3]], "obstacles": [[[2.1, 1.5], [3.3, 1.5], [3.3, 2.25]]], "lines": [[[1, 2], [1, 3]]], "points": [[0.1, 2.9]]},
         "cells": [{"name": "g", "columns": 2, "rows": 2, "cell": 0.1, "origin": [7, 2, 0.3], "bounds": false, "runs": [0, 1, 1, 2, 2, 1]}]},
 "vehicle": {"name": "v", "footprint": [[-0.5, -0.4], [0.6, -0.4], [0.6, 0.4], [-0.5, 0.4]], "forks": [[0.2, -0.3], [0.6, -0.3], [0.6, 0.3], [0.2, 0.3]],
   "loads": {"pallet": {"footprint": {"disc": 0.7}, "mass": 500}}, "mass": 100,
   "drive": {"type": "tricycle", "wheelbase": 1.1, "max_steering": 1.0, "max_steering_rate": 0.5, "steered_axle": "front"},
   "limits": {"speed": 1.1, "curvature": 0.9, "curvature_rate": 1e-1}, "control_point": [0.1, 0, 0.2]},
 "start": [0, 0, 0.1], "goal": [5, 0.3, -0.1], "clearance": 0.013, "pose_error": {"lateral": 0.001, "heading": 0.002},
 "zones": [], "budget": {"evaluations": 50, "samples": 700, "seconds": 2.5}, "planner": {"name": "ompl_rrt_connect", "checks": 1234}, "seed": 9007199254740993})";
}

Plan example_plan() {
  Scenario s = parse_scenario(scenario_text(), "s", {}).value();
  const Problem problem = Problem::prepare(s).value();
  Path path{{{Line{{0, 0}, {1.0 / 3.0, 1e-300}}, 1},
             {Arc{{1.0 / 3.0, 1e-300, 0.1}, 0.1, 2.0}, -1},
             {Turn{{1, 2}, 0.5, -1.5}, 0},
             {Spline{SplineKind::quintic, {{5, {Vec2{0, 0}, {1, 0}, {2, 0.1}, {3, 0.2}, {4, 0.2}, {5, 0.3}}}, {1, {Vec2{5, 0.3}, {6, 0.3}}}}}, 1},
             {PoseSequence{{{0, 0, 0}, {1, 0, 0.1}}}, 1}}};
  Plan plan = judge(problem, path);
  plan.explanation = {"a sentence with \"quotes\" and ünïcode"};
  plan.alternatives = {{"left side", true, 0.5, "ok", {}, {}}};
  return plan;
}

TEST(ScenarioText, ReadsBackToTheSameText) {
  const auto first = parse_scenario(scenario_text(), "s", {});
  ASSERT_TRUE(first) << first.error().message();
  EXPECT_EQ(first->seed, 9007199254740993ULL);
  EXPECT_EQ(first->map.grids[0].blocked, (std::vector<std::uint8_t>{0, 1, 1, 2}));
  const std::string text = scenario_json(*first);
  const auto second = parse_scenario(text, "s", {});
  ASSERT_TRUE(second) << second.error().message();
  EXPECT_EQ(scenario_json(*second), text);
  EXPECT_EQ(second->vehicle.footprint.polygon, first->vehicle.footprint.polygon);
  EXPECT_EQ(second->map.obstacles, first->map.obstacles);
  EXPECT_EQ(second->pose_error.heading, 0.002);
  EXPECT_EQ(std::get<Tricycle>(second->vehicle.drive).steered_axle, SteeredAxle::front);
  EXPECT_EQ(second->meta, first->meta);
}

TEST(PlanText, ReadsBackToTheSameBits) {
  const Plan plan = example_plan();
  const std::string text = plan_json(plan);
  const auto read = parse_plan(text, "p");
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->path.pieces.size(), plan.path.pieces.size());
  EXPECT_EQ(std::get<Line>(read->path.pieces[0].curve).to, std::get<Line>(plan.path.pieces[0].curve).to);
  EXPECT_EQ(std::get<Spline>(read->path.pieces[3].curve).spans[0].control, std::get<Spline>(plan.path.pieces[3].curve).spans[0].control);
  ASSERT_EQ(read->samples.size(), plan.samples.size());
  for (std::size_t i = 0; i < plan.samples.size(); ++i) EXPECT_EQ(read->samples[i].x, plan.samples[i].x);
  EXPECT_EQ(read->status, plan.status);
  EXPECT_EQ(read->certificate.clearance, plan.certificate.clearance);
  EXPECT_EQ(read->explanation, plan.explanation);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

/// Seeded mutations: any answer but a crash, a hang or an exception; what is read is judged too.
template <class Read>
void survives(const std::string& good, int runs, std::uint64_t seed, Read read) {
  Random random{seed};
  int refused = 0;
  for (int i = 0; i < runs; ++i) {
    std::string text = good;
    for (auto n = random.integer(1, 4); n > 0; --n) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(text.size()) - 1));
      switch (random.integer(0, 4)) {
        case 0: text[at] = "0123456789-+eE.,:[]{}\"ax"[random.integer(0, 23)]; break;
        case 1: text.erase(at, static_cast<std::size_t>(random.integer(1, 12))); break;
        case 2: text.insert(at, 1, "0123456789-eE.,[]{}"[random.integer(0, 18)]); break;
        case 3: text[at] = static_cast<char>(random.integer(0, 255)); break;
        default: text.insert(at, text.substr(at, static_cast<std::size_t>(random.integer(1, 20)))); break;
      }
    }
    if (!read(text)) ++refused;
  }
  EXPECT_GT(refused, runs / 4);
}

TEST(ScenarioText, MutationsNeverCrash) {
  survives(scenario_text(), 20000, 1, [](const std::string& text) {
    auto scenario = parse_scenario(text, "s", {});
    if (!scenario) {
      EXPECT_FALSE(scenario.error().message().empty());
      return false;
    }
    auto problem = Problem::prepare(std::move(*scenario));
    if (problem) static_cast<void>(problem->check_ends());
    return true;
  });
}

TEST(PlanText, MutationsNeverCrashAndAreJudged) {
  survives(plan_json(example_plan()), 1500, 2, [](const std::string& text) {
    const auto plan = parse_plan(text, "p");
    if (!plan) return false;
    static_cast<void>(verify(*plan));
    return true;
  });
}

TEST(PosesCsv, ReadsWhatPeopleWrite) {
  const auto path = parse_poses_csv("\xEF\xBB\xBFTheta;Y;X;extra\r\n0;0;0;9\r\n# note\r\n0;0;1;9\r\n0;0;1;9\r\n0;0;0.5;9\r\n1;0;0.5;9\r\n", "p.csv");
  ASSERT_TRUE(path) << path.error().message();
  ASSERT_EQ(path->pieces.size(), 3U);
  EXPECT_EQ(path->pieces[0].direction, 1);
  EXPECT_EQ(path->pieces[1].direction, -1);
  EXPECT_TRUE(std::holds_alternative<Turn>(path->pieces[2].curve));
}

TEST(PosesCsv, RefusalsNameTheLine) {
  const auto sentence = [](const std::string& text) {
    const auto path = parse_poses_csv(text, "p.csv");
    return path ? std::string{"read"} : path.error().message();
  };
  EXPECT_NE(sentence("").find("empty"), std::string::npos);
  EXPECT_NE(sentence("x,y\n1,2\n").find("heading"), std::string::npos);
  EXPECT_NE(sentence("x,y,heading\n1,2,3\n1,2\n").find("line 3"), std::string::npos);
  EXPECT_NE(sentence("x,y,heading\n1,nan,3\n").find("line 2"), std::string::npos);
  EXPECT_NE(sentence("x,y,heading,direction\n1,1,3,2\n").find("direction is 2"), std::string::npos);
  EXPECT_NE(sentence("x,y,heading\n1,2,3\n1,2,3\n").find("fewer than two"), std::string::npos);
}

}  // namespace
}  // namespace waywright
