// Legs joined into one plan: its figures are theirs, by hand and by the single plans; verify finds whatever does not fit.
#include "waywright/judge/legs.hpp"
#include "waywright/judge/left_behind.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace waywright {
namespace {

/// A disc of 0.4 m that can turn on the spot; with a load, a square of 1.2 m.
Vehicle robot() {
  Vehicle v;
  v.footprint.disc = 0.4;
  v.drive = Differential{0.5};
  v.limits = {1.0, 0.6, 0.5, 0.5, std::nullopt, 0.8, std::nullopt, std::nullopt, std::nullopt};
  v.mass = 100.0;
  v.loads["crate"] = {{rectangle({-0.6, -0.6}, {0.6, 0.6}), 0.0}, 50.0};
  return v;
}

Leg leg_to(const Pose& goal, std::optional<std::string> load = {}, const std::string& name = {}) {
  Leg leg;
  leg.name = name;
  leg.mission = goal;
  leg.load = std::move(load);
  return leg;
}

/// 3 m forwards beside a wall at y = 2; a turn, and 4 m upwards with the crate beside a wall at x = 5; back again by 1 m without it.
Scenario mission() {
  Scenario s;
  s.name = "three legs";
  s.map.lines = {{{-1.0, -2.0}, {4.0, -2.0}}, {{5.0, -1.0}, {5.0, 6.0}}};
  s.vehicle = robot();
  s.clearance = 0.1;
  s.start = {0.0, 0.0, 0.0};
  s.legs = {leg_to({3.0, 0.0, 0.0}, "crate", "to the crate"), leg_to({3.0, 4.0, pi / 2}, "", "with the crate"), leg_to({3.0, 3.0, pi / 2})};
  return s;
}

std::vector<Path> paths() {
  return {Path{{{Line{{0.0, 0.0}, {3.0, 0.0}}, 1}}}, Path{{{Turn{{3.0, 0.0}, 0.0, pi / 2}, 0}, {Line{{3.0, 0.0}, {3.0, 4.0}}, 1}}}, Path{{{Line{{3.0, 4.0}, {3.0, 3.0}}, -1}}}};
}

/// Each leg judged as a plan of its own.
std::vector<JudgedLeg> judged(const Scenario& mission, const std::vector<Path>& paths) {
  std::vector<JudgedLeg> legs;
  const World of_map{mission.map};
  LegBegin begin = first_leg(mission);
  for (const Path& path : paths) {
    const auto problem = prepare_leg(mission, begin, of_map);
    if (!problem) {
      ADD_FAILURE() << problem.error().message();
      return legs;
    }
    const Pose end = problem->last_pose();
    legs.push_back({begin, end, judge(*problem, path)});
    begin = next_leg(mission, begin, end);
  }
  return legs;
}

Plan joined(const Scenario& mission, const std::vector<Path>& paths) { return join_legs(mission, judged(mission, paths)); }

TEST(Legs, EachBeginsWhereTheOneBeforeEndsWithWhatIsCarriedThen) {
  Scenario s = mission();
  s.carried_load = "crate";
  LegBegin begin = first_leg(s);
  EXPECT_EQ(begin.load, "crate");
  const Scenario first = leg_scenario(s, begin);
  EXPECT_TRUE(first.legs.empty());
  EXPECT_EQ(std::get<Pose>(first.mission), (Pose{3.0, 0.0, 0.0}));
  begin = next_leg(s, begin, {3.0, 0.0, 0.0});
  EXPECT_EQ(begin.load, "crate");
  begin = next_leg(s, begin, {3.0, 4.0, pi / 2});
  EXPECT_EQ(begin.load, "");
  const Scenario third = leg_scenario(s, begin);
  EXPECT_EQ(third.start, (Pose{3.0, 4.0, pi / 2}));
  EXPECT_EQ(third.carried_load, "");
  EXPECT_EQ(leg_label(s, 1), "leg 2 of 3 (with the crate)");
  EXPECT_EQ(leg_label(s, 2), "leg 3 of 3");
}

TEST(Legs, JoinedFiguresAreThoseThatAHandFinds) {
  const Plan plan = joined(mission(), paths());
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_EQ(plan.path.pieces.size(), 4U);
  EXPECT_NEAR(plan.metrics.length, 8.0, 1e-12);
  // The wall below is 2 m away of a disc of 0.4 m, 1.6 m. The one to the right stands 2 m from x = 3: 1.4 m from the crate's side, and while it turns
  // its corners, 0.6·√2 m out, come to 2 − 0.8485 m; the wall below that ends at x = 4 is as near then.
  const double at_corner = 2.0 - 0.6 * std::sqrt(2.0);
  EXPECT_NEAR(plan.metrics.min_clearance, at_corner, 1e-3);
  EXPECT_NEAR(plan.certificate.clearance, at_corner, 6e-4);
  EXPECT_EQ(plan.metrics.direction_changes, 1);  // between the second leg and the third
  EXPECT_NEAR(plan.metrics.turning, pi / 2, 1e-9);
  EXPECT_NEAR(plan.certificate.checked_length, 8.0, 1e-9);
  // Each leg from rest to rest.
  const auto at_most = [](double s, double v, double a) { return s > v * v / a ? 2.0 * v / a + (s - v * v / a) / v : 2.0 * std::sqrt(s / a); };
  const double turn = plan.legs[1].metrics.travel_time - at_most(4.0, 1.0, 0.5);
  EXPECT_GT(turn, pi / 2 / 0.8 - 1e-9);
  EXPECT_NEAR(plan.metrics.travel_time, at_most(3.0, 1.0, 0.5) + at_most(4.0, 1.0, 0.5) + turn + at_most(1.0, 0.6, 0.5), 5e-3);  // speeds are told at samples
  for (const std::size_t border : {plan.legs[0].samples, plan.legs[0].samples + plan.legs[1].samples}) {
    const Sample& before = plan.samples[border - 1];
    const Sample& after = plan.samples[border];
    EXPECT_EQ(before.s, after.s);
    EXPECT_EQ(before.t, after.t);
    EXPECT_EQ(before.pose().position(), after.pose().position());
    EXPECT_EQ(before.speed, 0.0);
    EXPECT_EQ(after.speed, 0.0);
  }
}

TEST(Legs, JoinedFiguresAreThoseOfTheSingleLegs) {
  const std::vector<JudgedLeg> legs = judged(mission(), paths());
  const Plan plan = join_legs(mission(), legs);
  Metrics sum;
  double weighted = 0.0, worst = 1e9, checked = 0.0;
  for (const JudgedLeg& leg : legs) {
    const Metrics& m = leg.plan.metrics;
    sum.length += m.length;
    sum.turning += m.turning;
    sum.collision_risk += m.collision_risk;
    sum.travel_time += m.travel_time;
    sum.curvature_change += m.curvature_change;
    weighted += m.length * m.mean_clearance;
    worst = std::min(worst, leg.plan.certificate.clearance);
    checked += leg.plan.certificate.checked_length;
  }
  EXPECT_EQ(plan.metrics.length, sum.length);
  EXPECT_EQ(plan.metrics.turning, sum.turning);
  EXPECT_EQ(plan.metrics.collision_risk, sum.collision_risk);
  EXPECT_EQ(plan.metrics.travel_time, sum.travel_time);
  EXPECT_EQ(plan.metrics.curvature_change, sum.curvature_change);
  EXPECT_EQ(plan.metrics.mean_clearance, weighted / sum.length);
  EXPECT_EQ(plan.certificate.clearance, worst);
  EXPECT_EQ(plan.certificate.checked_length, checked);
  EXPECT_NEAR(plan.samples.back().s, sum.length, 1e-12);
  EXPECT_NEAR(plan.samples.back().t, sum.travel_time, 1e-12);
}

TEST(Legs, OneLegIsThePlainMission) {
  Scenario s = mission();
  s.legs.resize(1);
  s.legs[0].load.reset();
  Scenario plain = s;
  plain.legs.clear();
  plain.mission = Pose{3.0, 0.0, 0.0};
  const Plan one = joined(s, {paths()[0]});
  const Plan single = judge(Problem::prepare(plain).value(), paths()[0]);
  ASSERT_EQ(one.samples.size(), single.samples.size());
  for (std::size_t i = 0; i < one.samples.size(); ++i) {
    EXPECT_EQ(one.samples[i].pose(), single.samples[i].pose());
    EXPECT_EQ(one.samples[i].t, single.samples[i].t);
    EXPECT_EQ(one.samples[i].speed, single.samples[i].speed);
  }
  EXPECT_EQ(one.metrics.mean_clearance, single.metrics.mean_clearance);
  EXPECT_EQ(one.certificate.clearance, single.certificate.clearance);
  EXPECT_EQ(one.metrics.travel_time, single.metrics.travel_time);
}

TEST(Legs, ARigidMotionMovesThePlanAndNothingElse) {
  const Pose origin{-40.0, 7.0, 2.3};
  const Frame place{origin};
  const auto moved = [&](const Pose& p) { return make_pose(place.to_world(p.position()), wrap(p.heading + origin.heading)); };
  Scenario s = mission();
  for (auto& line : s.map.lines) {
    for (Vec2& p : line) p = place.to_world(p);
  }
  s.start = moved(s.start);
  for (Leg& leg : s.legs) leg.mission = moved(std::get<Pose>(leg.mission));
  std::vector<Path> there = paths();
  for (Path& path : there) {
    for (Piece& piece : path.pieces) {
      if (auto* line = std::get_if<Line>(&piece.curve)) *line = Line{place.to_world(line->from), place.to_world(line->to)};
      if (auto* turn = std::get_if<Turn>(&piece.curve)) *turn = Turn{place.to_world(turn->at), turn->from + origin.heading, turn->angle};
    }
  }
  const Plan here = joined(mission(), paths());
  const Plan far = joined(s, there);
  ASSERT_EQ(far.status, Status::solved) << far.reason;
  EXPECT_NEAR(far.metrics.length, here.metrics.length, 1e-9);
  EXPECT_NEAR(far.metrics.travel_time, here.metrics.travel_time, 5e-3);  // samples lie elsewhere
  EXPECT_NEAR(far.metrics.mean_clearance, here.metrics.mean_clearance, 1e-9);
  EXPECT_NEAR(far.certificate.clearance, here.certificate.clearance, 2e-3);
  EXPECT_TRUE(verify(far).value().holds);
}

TEST(Legs, VerifyHoldsAndFindsEachFalsification) {
  const Plan honest = joined(mission(), paths());
  const auto holds = verify(honest);
  ASSERT_TRUE(holds) << holds.error().message();
  ASSERT_TRUE(holds->holds) << holds->findings.front();
  const std::pair<const char*, std::function<void(Plan&)>> falsifications[] = {
      {"a border one piece later", [](Plan& p) { ++p.legs[0].pieces, --p.legs[1].pieces; }},
      {"a border one sample later", [](Plan& p) { ++p.legs[0].samples, --p.legs[1].samples; }},
      {"a border one sample earlier", [](Plan& p) { --p.legs[0].samples, ++p.legs[1].samples; }},
      {"a leg without pieces", [](Plan& p) { p.legs[1].pieces += p.legs[0].pieces, p.legs[0].pieces = 0; }},
      {"fewer pieces than there are", [](Plan& p) { --p.legs[1].pieces; }},
      {"a number of pieces beyond all", [](Plan& p) { p.legs[0].pieces = std::size_t{0} - 1; }},
      {"a leg's record missing", [](Plan& p) { p.legs.pop_back(); }},
      {"a leg's pieces and samples missing",
       [](Plan& p) {
         p.path.pieces.resize(p.path.pieces.size() - p.legs.back().pieces);
         p.samples.resize(p.samples.size() - p.legs.back().samples);
         p.legs.pop_back();
       }},
      {"another load in a record", [](Plan& p) { p.legs[1].load = ""; }},
      {"the load taken one leg later", [](Plan& p) { std::swap(p.scenario.legs[0].load, p.scenario.legs[1].load); }},
      {"another name", [](Plan& p) { p.legs[1].name = "elsewhere"; }},
      {"another start", [](Plan& p) { p.legs[1].start.x += 1e-3; }},
      {"another end", [](Plan& p) { p.legs[1].end.heading += 1e-3; }},
      {"a goal moved in the mission", [](Plan& p) { std::get<Pose>(p.scenario.legs[1].mission).y += 0.01; }},
      {"legs exchanged in the mission", [](Plan& p) { std::swap(p.scenario.legs[0], p.scenario.legs[1]); }},
      {"a status", [](Plan& p) { p.status = Status::unproven; }},
      {"a leg's status", [](Plan& p) { p.legs[2].status = Status::unproven; }},
      {"the clearance", [](Plan& p) { p.certificate.clearance += 0.01; }},
      {"a leg's clearance", [](Plan& p) { p.legs[0].certificate.clearance += 0.01; }},
      {"the checked length", [](Plan& p) { p.certificate.checked_length += 0.01; }},
      {"a leg's checked length", [](Plan& p) { p.legs[2].certificate.checked_length += 0.01; }},
      {"the length", [](Plan& p) { p.metrics.length += 0.01; }},
      {"a leg's length", [](Plan& p) { p.legs[2].metrics.length += 0.01; }},
      {"the mean clearance", [](Plan& p) { p.metrics.mean_clearance += 0.01; }},
      {"the changes of direction", [](Plan& p) { p.metrics.direction_changes = 0; }},
      {"the time", [](Plan& p) { p.metrics.travel_time -= 0.01; }},
      {"a leg's time", [](Plan& p) { p.legs[1].metrics.travel_time -= 0.01; }},
      {"time between legs",
       [](Plan& p) {
         for (std::size_t i = p.legs[0].samples; i < p.samples.size(); ++i) p.samples[i].t += 1.0;
         p.metrics.travel_time += 1.0;
       }},
      {"a jump of s between legs",
       [](Plan& p) {
         for (std::size_t i = p.legs[0].samples; i < p.samples.size(); ++i) p.samples[i].s += 0.5;
       }},
      {"driving on at a border", [](Plan& p) { p.samples[p.legs[0].samples - 1].speed = p.samples[p.legs[0].samples].speed = 0.3; }},
      {"a piece elsewhere", [](Plan& p) { std::get<Line>(p.path.pieces.back().curve).to.x += 0.01; }},
      {"a last load that does not fit",
       [](Plan& p) {
         p.scenario.map.points.push_back({3.55, 3.55});  // beside the disc, inside of the crate
         p.scenario.legs.back().load = "crate";
       }},
      {"an obstacle beside the crate alone", [](Plan& p) { p.scenario.map.points.push_back({3.65, 2.0}); }},
  };
  for (const auto& [what, falsify] : falsifications) {
    Plan plan = honest;
    falsify(plan);
    const auto found = verify(plan);
    if (!found) {
      EXPECT_FALSE(found.error().message().empty());
      continue;
    }
    EXPECT_FALSE(found->holds) << what;
    EXPECT_EQ(found->holds, found->findings.empty()) << what;
  }
}

/// Kilometres and hours on, s and t have fewer digits left for a leg's first steps from rest.
TEST(Legs, ALegFarDownTheMissionVerifiesToo) {
  Scenario s;
  s.vehicle = robot();
  s.start = {0.1, 0.0, 0.0};
  s.legs = {leg_to({9000.3, 0.0, 0.0}), leg_to({9014.37, 0.0, 0.0})};
  const Plan plan = joined(s, {Path{{{Line{{0.1, 0.0}, {9000.3, 0.0}}, 1}}}, Path{{{Line{{9000.3, 0.0}, {9014.37, 0.0}}, 1}}}});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const auto honest = verify(plan).value();
  EXPECT_TRUE(honest.holds) << honest.findings.front();
  Plan faster = plan;
  for (std::size_t i = plan.legs[0].samples + 1; i < plan.samples.size(); ++i) faster.samples[i].t -= 0.01;
  EXPECT_FALSE(verify(faster).value().holds);
}

TEST(Legs, ALegThatIsNotProvenMakesTheWholeUnproven) {
  Scenario s = mission();
  s.map.points = {{3.55, 2.0}};  // beside the disc, inside of the crate's way
  const Plan plan = joined(s, paths());
  EXPECT_EQ(plan.status, Status::unproven);
  EXPECT_EQ(plan.reason.rfind("leg 2 of 3 (with the crate): ", 0), 0U) << plan.reason;
  EXPECT_FALSE(plan.certificate.collision_free);
  EXPECT_EQ(plan.path.pieces.size(), 4U);
  EXPECT_TRUE(plan.legs[0].certificate.collision_free);
  EXPECT_EQ(plan.legs[2].status, Status::solved);
  const auto found = verify(plan);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->holds);
}

TEST(Legs, AMissionThatEndsEarlyKeepsWhatWasDriven) {
  std::vector<JudgedLeg> legs = judged(mission(), {paths()[0], paths()[1]});
  const auto problem = prepare_leg(mission(), legs[1].begin, World{mission().map}).value();
  legs[1].plan = failed_plan(problem, {Status::no_path, "nothing was found", {}, {}});
  const Plan plan = join_legs(mission(), std::move(legs));
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_EQ(plan.reason, "leg 2 of 3 (with the crate): nothing was found");
  EXPECT_TRUE(plan.path.pieces.empty());
  EXPECT_TRUE(plan.samples.empty());
  ASSERT_EQ(plan.legs.size(), 2U);
  EXPECT_EQ(plan.legs[0].pieces, 0U);
  EXPECT_FALSE(plan.legs[0].driven.empty());
  EXPECT_NEAR(plan.legs[0].metrics.length, 3.0, 1e-12);
  EXPECT_EQ(plan.explanation.front().rfind("Leg 1 of 3 (to the crate), without a load", 0), 0U) << plan.explanation.front();
}

TEST(Legs, ALoadThatDoesNotFitWhereItIsTakenIsNamed) {
  Scenario s = mission();
  s.map.points = {{3.55, 0.0}};
  const World of_map{s.map};
  LegBegin second = next_leg(s, first_leg(s), {3.0, 0.0, 0.0});
  const auto problem = prepare_leg(s, second, of_map).value();
  const auto failure = problem.check_ends();
  ASSERT_TRUE(failure);
  const Failure told = told_of_load(s, second, *failure);
  EXPECT_EQ(told.status, Status::start_in_collision);
  EXPECT_EQ(told.reason.rfind("the load \"crate\", taken where leg 1 ends, does not fit there: ", 0), 0U) << told.reason;
  // Where the mission ends no leg would show it.
  s.map.points = {{3.55, 3.55}};
  s.legs.back().load = "crate";
  const auto last = check_last_load(s, {3, {3.0, 3.0, pi / 2}, "crate"}, World{s.map});
  ASSERT_TRUE(last);
  ASSERT_TRUE(*last);
  EXPECT_EQ((*last)->status, Status::goal_in_collision);
  s.map.points.clear();
  EXPECT_FALSE(check_last_load(s, {3, {3.0, 3.0, pi / 2}, "crate"}, World{s.map}).value());
}

TEST(Legs, TheShelfOfAnotherLegIsAnObstacle) {
  Scenario s = mission();
  s.map.lines.clear();
  Station station;
  station.area = rectangle({-3.0, -3.0}, {8.0, 8.0});
  station.shelf = {{6.0, 0.0}, pi, 1.0, 1.5, 0.1, 0.0};  // its face at x = 5.5, towards the start
  Leg dock;
  dock.mission = station;
  s.legs = {dock, leg_to({2.0, 0.0, pi}), leg_to({7.0, 4.0, pi / 2})};
  const World of_map{s.map};
  LegBegin begin = next_leg(s, first_leg(s), prepare_leg(s, first_leg(s), of_map).value().last_pose());
  const auto second = prepare_leg(s, begin, of_map).value();
  EXPECT_NEAR(second.start().x, 5.0, 1e-12);
  const Contact contact = second.world().clearance(second.footprint(), second.start(), 2.0);
  EXPECT_NEAR(contact.clearance, 0.1, 1e-9);
  EXPECT_EQ(second.world().source_name(contact.source), "the shelf of leg 1");
  // In its own leg it is there once.
  const auto first = prepare_leg(s, first_leg(s), of_map).value();
  EXPECT_EQ(first.world().source_name(first.world().clearance(first.footprint(), {5.0, 0.0, 0.0}, 2.0).source), "the shelf");
  EXPECT_TRUE(check_legs(s));
}

/// The crate is carried 3 m and set down, the disc backs out of it by 2 m, and comes back past it or through it.
Scenario with_crate_left(double y) {
  Scenario s;
  s.vehicle = robot();
  s.clearance = 0.1;
  s.carried_load = "crate";
  s.legs = {leg_to({3.0, 0.0, 0.0}, ""), leg_to({1.0, 0.0, 0.0}), leg_to({1.0, y, 0.0}), leg_to({6.0, y, 0.0})};
  return s;
}

std::vector<Path> past_the_crate(double y) {
  const double side = y < 0.0 ? -pi / 2 : pi / 2;
  return {Path{{{Line{{0.0, 0.0}, {3.0, 0.0}}, 1}}}, Path{{{Line{{3.0, 0.0}, {1.0, 0.0}}, -1}}},
          Path{{{Turn{{1.0, 0.0}, 0.0, side}, 0}, {Line{{1.0, 0.0}, {1.0, y}}, 1}, {Turn{{1.0, y}, side, -side}, 0}}}, Path{{{Line{{1.0, y}, {6.0, y}}, 1}}}};
}

TEST(Legs, WhatSeveralLegsHaveInCommonIsToldOnce) {
  const auto explained = [](const std::vector<std::vector<std::string>>& sentences) {
    std::vector<JudgedLeg> legs = judged(mission(), paths());
    for (std::size_t i = 0; i < legs.size(); ++i) legs[i].plan.explanation = sentences[i];
    return join_legs(mission(), std::move(legs)).explanation;
  };
  const std::vector<std::string> told = explained({{"The cost is so.", "One.", "Proven."}, {"The cost is so.", "Two.", "Proven."}, {"Three.", "Proven.", "Proven."}});
  std::vector<std::string> without_headlines;
  for (const std::string& sentence : told) {
    if (sentence.rfind("Leg ", 0) != 0) without_headlines.push_back(sentence);
  }
  const std::string left = "The load \"crate\", left where leg 2 ends, is an obstacle on no later leg.";
  EXPECT_EQ(without_headlines, (std::vector<std::string>{"One.", "Two.", "Three.", "On legs 1 and 2: The cost is so.", "On all legs: Proven.", left}));
  EXPECT_EQ(told.front().rfind("Leg 1 of 3", 0), 0U);
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ(tells_of_several_legs(told[i]), i >= 6) << told[i];
  EXPECT_EQ(explained({{"One."}, {"Two."}, {"Three."}}).size(), 3U + 3U + 1U);  // headlines, sentences, the load
}

TEST(Legs, ALoadThatIsSetDownIsAnObstacleOnceTheVehicleIsClearOfIt) {
  const Plan past = joined(with_crate_left(1.5), past_the_crate(1.5));
  ASSERT_EQ(past.status, Status::solved) << past.reason;
  EXPECT_NEAR(past.legs[3].certificate.clearance, 1.5 - 0.6 - 0.4, 6e-4);  // lane, half the crate, the disc
  EXPECT_EQ(past.legs[3].tightest_obstacle, "the load \"crate\" left where leg 1 ends");
  EXPECT_NEAR(past.legs[2].certificate.clearance, 2.4 - 1.0 - 0.4, 6e-4);
  EXPECT_FALSE(past.legs[1].certificate.tightest);
  EXPECT_EQ(past.explanation.back(), "The load \"crate\", left where leg 1 ends, stands there as an obstacle on legs 3 and 4.");
  const auto verified = verify(past).value();
  EXPECT_TRUE(verified.holds) << verified.findings.front();
  const Plan through = joined(with_crate_left(0.9), past_the_crate(0.9));
  EXPECT_EQ(through.status, Status::unproven);
  EXPECT_NE(through.reason.find("the load \"crate\" left where leg 1 ends"), std::string::npos) << through.reason;
  EXPECT_FALSE(verify(through).value().holds);
}

TEST(Legs, OnTheLegThatDrivesOutOfALoadItIsProvenToStayOut) {
  Scenario s = with_crate_left(1.5);
  const World of_map{s.map};
  const LegBegin begin = next_leg(s, first_leg(s), {3.0, 0.0, 0.0});
  const auto found = [&](const Pose& goal, const Path& path) {
    s.legs[1].mission = goal;
    const auto problem = prepare_leg(s, begin, of_map).value();
    Plan plan = judge(problem, path);
    judge_left_behind(s, begin, problem, plan);
    return plan;
  };
  const Plan out = found({1.0, 0.0, 0.0}, {{{Line{{3.0, 0.0}, {1.0, 0.0}}, -1}}});
  EXPECT_EQ(out.status, Status::solved) << out.reason;
  const auto out_problem = prepare_leg(s, begin, of_map).value();
  const auto behind = check_left_behind(s, begin, out_problem, out.path);
  ASSERT_EQ(behind.size(), 1U);
  EXPECT_NEAR(behind[0].clear_after.value(), 0.6 + 0.4 + 0.1, 0.051 + 1e-3);  // half the crate, the disc, the clearance; a sample's step
  const Plan again = found({2.2, 0.0, 0.0}, {{{Line{{3.0, 0.0}, {1.0, 0.0}}, -1}, {Line{{1.0, 0.0}, {2.2, 0.0}}, 1}}});
  EXPECT_EQ(again.status, Status::unproven);
  EXPECT_EQ(again.reason.rfind("it comes back to the load \"crate\" left where leg 1 ends", 0), 0U) << again.reason;
  const Plan within = found({2.8, 0.0, 0.0}, {{{Line{{3.0, 0.0}, {2.8, 0.0}}, -1}}});
  EXPECT_EQ(within.explanation.back(), "The vehicle stays in the load \"crate\" left where leg 1 ends all the way; nothing is proven of the two.");
  EXPECT_FALSE(next_leg(s, begin, {2.8, 0.0, 0.0}).left.front().is_clear);
  EXPECT_TRUE(next_leg(s, begin, {1.0, 0.0, 0.0}).left.front().is_clear);
}

TEST(Legs, ALoadThatIsTakenUpAgainStandsThereNoMore) {
  Scenario s = with_crate_left(1.5);
  s.legs = {leg_to({3.0, 0.0, 0.0}, ""), leg_to({1.0, 0.0, 0.0}), leg_to({3.0, 0.0, 0.0}, "crate"), leg_to({0.0, 0.0, 0.0})};
  const std::vector<Path> there = {Path{{{Line{{0.0, 0.0}, {3.0, 0.0}}, 1}}}, Path{{{Line{{3.0, 0.0}, {1.0, 0.0}}, -1}}}, Path{{{Line{{1.0, 0.0}, {3.0, 0.0}}, 1}}},
                                   Path{{{Line{{3.0, 0.0}, {0.0, 0.0}}, -1}}}};
  const Plan plan = joined(s, there);
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_EQ(plan.legs[3].load, "crate");
  EXPECT_EQ(plan.explanation.back(), "The load \"crate\", left where leg 1 ends, is an obstacle on no later leg; leg 3 takes it up again, and is not proven against it.");
  // Another crate elsewhere is not that one.
  s.legs[2] = leg_to({3.0, 1.6, 0.0}, "crate");
  LegBegin begin = first_leg(s);
  begin = next_leg(s, begin, {3.0, 0.0, 0.0});
  begin = next_leg(s, begin, {1.0, 0.0, 0.0});
  EXPECT_EQ(standing_on(s, 2, begin.left).size(), 1U);
  EXPECT_EQ(next_leg(s, begin, {3.0, 1.6, 0.0}).left.size(), 1U);
}

TEST(Legs, WhatIsWrongIsOneSentenceThatNamesTheLeg) {
  const auto wrong = [](const std::function<void(Scenario&)>& change) {
    Scenario s = mission();
    change(s);
    const auto checked = check_legs(s);
    return checked ? std::string{"accepted"} : checked.error().message();
  };
  EXPECT_EQ(wrong([](Scenario&) {}), "accepted");
  EXPECT_EQ(wrong([](Scenario& s) { s.legs[0].load = "barrel"; }), "legs[0].load: the vehicle has no load \"barrel\" (allowed: crate)");
  EXPECT_EQ(wrong([](Scenario& s) { s.legs[2].load = "barrel"; }), "legs[2].load: the vehicle has no load \"barrel\" (allowed: crate)");
  EXPECT_EQ(wrong([](Scenario& s) { s.carried_load = "crate"; }),
            "legs[0].load: \"crate\" is taken while \"crate\" is carried, from the beginning (allowed: a load where none is carried: let a leg before it end with \"load\": null)");
  EXPECT_EQ(wrong([](Scenario& s) { s.vehicle.loads["box"] = s.vehicle.loads["crate"], s.legs[1].load = "box"; }),
            "legs[1].load: \"box\" is taken while \"crate\" is carried, since leg 1 (allowed: a load where none is carried: let a leg before it end with \"load\": null)");
  EXPECT_EQ(wrong([](Scenario& s) { s.carried_load = "barrel"; }), "carried_load: the vehicle has no load \"barrel\" (allowed: crate)");
  EXPECT_EQ(wrong([](Scenario& s) { s.legs[1].waypoints = {{3.0, 4.0}}; }).rfind("legs[1].goal: it is 0.0000 m from waypoints[0]", 0), 0U);
  EXPECT_EQ(wrong([](Scenario& s) { s.legs.resize(most_legs + 1, s.legs[0]); }), "legs: there are 1001 (allowed: at most 1000)");
  Station station;
  station.area = rectangle({-3.0, -3.0}, {8.0, 8.0});
  station.shelf = {{6.0, 0.0}, pi, 1.0, 1.5, 0.1, 0.0};
  station.manoeuvre = Manoeuvre::undock;
  const std::string elsewhere = wrong([&](Scenario& s) { s.legs[1].mission = station; });  // the crate's front is 0.6 m before the origin
  EXPECT_EQ(elsewhere.rfind("legs[1].station: the way out of the shelf begins at (4.8000000, ", 0), 0U) << elsewhere;
  EXPECT_NE(elsewhere.find("and the vehicle stands at (3.0000000, 0.0000000, 0.0000000) then"), std::string::npos) << elsewhere;
  const auto plain = Problem::prepare(mission());
  ASSERT_FALSE(plain);
  EXPECT_EQ(plain.error().message(), "legs: a mission of several legs is not one problem (allowed: one goal or station)");
}

}  // namespace
}  // namespace waywright
