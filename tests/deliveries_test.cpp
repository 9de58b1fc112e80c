// Missions whose legs are driven in the best order, as a user has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "tests/command_line.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/order_legs.hpp"
#include "waywright/planner/solve_legs.hpp"

namespace waywright {
namespace {

const Scenario& example_mission() {
  static const Scenario scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/deliveries_warehouse.json").value();
  return scenario;
}

const Plan& example_plan() {
  static const Plan plan = solve_legs(example_mission()).value();
  return plan;
}

/// A hall of 20 by 12 m with a wall across that has one door; a round robot.
Scenario hall(const char* planner, const Parameters& parameters, const std::vector<Pose>& places) {
  Scenario s;
  s.map.boundaries = {rectangle({0.0, 0.0}, {20.0, 12.0})};
  s.map.obstacles = {rectangle({9.5, 0.0}, {10.5, 8.0}), rectangle({4.0, 5.0}, {6.0, 7.0}), rectangle({14.0, 3.0}, {15.0, 9.0})};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.4};
  s.start = {1.5, 1.5, 0.0};
  s.planner = {planner, parameters};
  for (const Pose& place : places) {
    Leg leg;
    leg.mission = place;
    s.legs.push_back(leg);
  }
  s.order = LegOrder::best;
  return s;
}

const std::vector<Pose> places_in_hall{{18.0, 2.0, 0.0}, {2.0, 10.0, 1.0}, {12.0, 6.0, 0.0}, {7.5, 2.0, -1.0}, {18.0, 10.5, 2.0}};

Scenario as_given(Scenario s, const std::vector<std::size_t>& order) {
  const Scenario before = s;
  s.order = LegOrder::given;
  for (std::size_t i = 0; i < order.size(); ++i) s.legs[i] = before.legs[order[i]];
  return s;
}

std::string without_timing(Plan plan) {
  plan.timing = {};
  return plan_json(plan);
}

/// Every order driven as a mission of its own: none is shorter than the one chosen, and that one is the mission in that order bit for bit.
TEST(Deliveries, NoOrderOfTheHallIsShorterWhenDriven) {
  const std::pair<const char*, Parameters> planners[] = {{"visibility_graph", {}}, {"astar", {{"resolution", 0.25}}}, {"harmonic", {{"resolution", 0.25}}}};
  for (const auto& [planner, parameters] : planners) {
    std::vector<Pose> places = places_in_hall;
    places.resize(4);
    const Scenario s = hall(planner, parameters, places);
    const Plan plan = solve_legs(s).value();
    ASSERT_EQ(plan.status, Status::solved) << planner << ": " << plan.reason;
    ASSERT_TRUE(plan.order);
    EXPECT_TRUE(plan.order->is_exact);
    EXPECT_EQ(plan.order->ways, 4 + 4 * 3);
    EXPECT_NEAR(plan.metrics.length, plan.order->length, 1e-3) << planner;
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double shortest = 1e9;
    do {
      const Plan one = solve_legs(as_given(s, order)).value();
      ASSERT_EQ(one.status, Status::solved) << planner;
      shortest = std::min(shortest, one.metrics.length);
      if (order == plan.order->given_as) {
        EXPECT_EQ(test::fingerprint(one.path.pieces), test::fingerprint(plan.path.pieces)) << planner;
      }
      if (std::is_sorted(order.begin(), order.end())) {
        EXPECT_NEAR(one.metrics.length, plan.order->given_length.value(), 1e-3) << planner;
      }
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_NEAR(plan.metrics.length, shortest, 1e-3) << planner;
    EXPECT_LT(plan.metrics.length, plan.order->given_length.value()) << planner;
    const auto verified = verify(parse_plan(plan_json(plan), "plan.json").value());
    EXPECT_TRUE(verified->holds) << verified->findings.front();
  }
}

TEST(Deliveries, TheExampleTakesEachCrateBeforeItIsLeftAndEndsAtTheCharger) {
  const Plan& plan = example_plan();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_TRUE(plan.order);
  const auto position = [&](std::size_t leg) { return std::find(plan.order->given_as.begin(), plan.order->given_as.end(), leg) - plan.order->given_as.begin(); };
  EXPECT_LT(position(1), position(2));
  EXPECT_LT(position(3), position(4));
  EXPECT_TRUE(position(2) < position(3) || position(4) < position(1)) << "two crates at a time";
  EXPECT_EQ(position(7), 7);
  EXPECT_EQ(plan.scenario.legs.back().name, "charger");
  EXPECT_LT(plan.order->length, plan.order->given_length.value() - 1.0);
  EXPECT_TRUE(verify(parse_plan(plan_json(plan), "plan.json").value())->holds);
  // The plan's scenario planned again comes to the same order: it is the one given now.
  const Plan again = solve_legs(plan.scenario).value();
  EXPECT_EQ(test::fingerprint(again.path.pieces), test::fingerprint(plan.path.pieces));
  EXPECT_TRUE(std::is_sorted(again.order->given_as.begin(), again.order->given_as.end()));
}

TEST(Deliveries, AWarehouseOfCells) {
  for (const char* planner : {"visibility_graph", "harmonic"}) {
    Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/grid_warehouse.json").value();
    s.planner = {planner, {}};
    s.mission = Pose{};
    for (const Pose& place : {Pose{56.4, 4.1, 0.0}, Pose{30.0, 36.52, 0.0}, Pose{56.4, 36.5, 1.0}}) {
      Leg leg;
      leg.mission = place;
      s.legs.push_back(leg);
    }
    s.order = LegOrder::best;
    const Plan plan = solve_legs(s).value();
    ASSERT_EQ(plan.status, Status::solved) << planner << ": " << plan.reason;
    EXPECT_EQ(plan.order->given_as, (std::vector<std::size_t>{1, 2, 0})) << planner;
    EXPECT_NEAR(plan.metrics.length, plan.order->length, 1e-3);
    EXPECT_TRUE(verify(parse_plan(plan_json(plan), "plan.json").value())->holds);
  }
}

TEST(Deliveries, TheSameBitsOnAnyNumberOfThreads) {
  const Scenario s = hall("astar", {{"resolution", 0.25}}, places_in_hall);
  Scenario complete = s;
  ASSERT_TRUE(complete_legs(complete));
  const ChosenOrder one = choose_order(complete, nullptr, 1).value();
  for (const unsigned threads : {2U, 5U}) {
    const ChosenOrder more = choose_order(complete, nullptr, threads).value();
    EXPECT_EQ(more.order.given_as, one.order.given_as);
    EXPECT_EQ(more.order.length, one.order.length);
    EXPECT_EQ(more.order.given_length, one.order.given_length);
    EXPECT_EQ(more.sentences, one.sentences);
    EXPECT_EQ(more.effort.expansions, one.effort.expansions);
  }
  EXPECT_EQ(without_timing(solve_legs(s).value()), without_timing(solve_legs(s).value()));
}

TEST(Deliveries, PlacesThatNothingReachesAreNamed) {
  Scenario s = hall("astar", {{"resolution", 0.25}}, places_in_hall);
  s.legs[2].name = "the shut room";
  s.map.obstacles.push_back(rectangle({9.5, 7.5}, {10.5, 12.0}));  // the door is shut
  const Plan plan = solve_legs(s).value();
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_EQ(plan.reason.rfind("no order reaches every place: no way leads to leg 1, leg 3 (the shut room), leg 5; to leg 1: ", 0), 0U)
      << plan.reason;  // though they reach each other
  EXPECT_FALSE(plan.order);
  Scenario nowhere = s;
  nowhere.start = {5.0, 6.0, 0.0};
  const Plan stuck = solve_legs(nowhere).value();
  EXPECT_EQ(stuck.status, Status::start_in_collision);
  EXPECT_EQ(stuck.reason.rfind("no place can be reached from the start: ", 0), 0U) << stuck.reason;
  Scenario inside = hall("astar", {{"resolution", 0.25}}, places_in_hall);
  inside.legs[2].name = "the pillar";
  inside.legs[2].mission = Pose{5.0, 6.0, 0.0};
  const Plan blocked = solve_legs(inside).value();
  EXPECT_EQ(blocked.status, Status::goal_in_collision);
  EXPECT_EQ(blocked.reason.rfind("no order reaches every place: no way leads to leg 3 (the pillar): ", 0), 0U) << blocked.reason;
  const auto read = parse_plan(plan_json(blocked), "plan.json");
  ASSERT_TRUE(read) << read.error().message();
}

TEST(Deliveries, OneWayAislesMakeWaysOfTwoLengths) {
  Scenario s = hall("astar", {{"resolution", 0.25}}, {{8.0, 10.0, 0.0}, {16.5, 10.5, 0.0}});
  s.order = LegOrder::best;
  Zone east;
  east.type = ZoneType::directed;
  east.area = rectangle({9.0, 8.0}, {11.0, 12.0});
  east.direction = pi;  // out of the right room alone
  s.zones = {east};
  const Plan plan = solve_legs(s).value();
  EXPECT_NE(plan.status, Status::solved);
  EXPECT_NE(plan.reason.find("leg 2"), std::string::npos) << plan.reason;
  s.start = {12.0, 2.0, 0.0};
  s.legs[0].mission = Pose{8.0, 10.0, 0.0};
  const Plan out = solve_legs(s).value();
  ASSERT_EQ(out.status, Status::solved) << out.reason;
  EXPECT_EQ(out.order->given_as, (std::vector<std::size_t>{1, 0}));
  EXPECT_FALSE(out.order->given_length);
  EXPECT_EQ(out.order->ways_missing, 1);
}

/// A load that is set down and fetched again later is not fetched before.
TEST(Deliveries, WhatWasSetDownIsTakenUpAfterwards) {
  Scenario s = hall("astar", {{"resolution", 0.25}}, {{18.0, 2.0, 0.0}, {2.0, 10.0, 0.0}, {7.5, 2.0, 0.0}, {2.0, 10.0, 0.0}, {18.0, 10.5, 0.0}});
  Load crate;
  crate.footprint.polygon = rectangle({-0.4, -0.4}, {0.4, 0.4});
  s.vehicle.loads = {{"crate", crate}};
  s.legs[0].load = "crate";
  s.legs[1].load = "";
  s.legs[3].load = "crate";
  s.legs[4].load = "";
  const Plan plan = solve_legs(s).value();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const auto& given_as = plan.order->given_as;
  const auto position = [&](std::size_t leg) { return std::find(given_as.begin(), given_as.end(), leg) - given_as.begin(); };
  EXPECT_LT(position(0), position(1));
  EXPECT_LT(position(1), position(3));
  EXPECT_LT(position(3), position(4));
}

/// The way into a shelf and out of it stay together; shelf and pallet are those of the example of three legs.
TEST(Deliveries, TheWayOutOfAShelfStaysWithTheWayIn) {
  Scenario s = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/mission_warehouse.json").value();
  Leg last = s.legs[2];
  last.waypoints.clear();
  last.planner = PlannerChoice{"ompl_rrt_connect", {}};
  last.load.reset();
  Leg first = last;
  first.mission = Pose{9.5, 9.0, 0.0};
  last.load = "";
  s.legs = {first, s.legs[0], s.legs[1], last};
  s.order = LegOrder::best;
  Scenario complete = s;
  ASSERT_TRUE(complete_legs(complete));
  const OrderedLegs ordered = ordered_legs(complete).value();
  ASSERT_EQ(ordered.groups.size(), 3U);
  EXPECT_EQ(ordered.groups[1].count, 2U);
  EXPECT_EQ(ordered.visits.places[1].gives, 1);
  EXPECT_EQ(ordered.visits.places[2].needs, 1);
  EXPECT_EQ(ordered.visits.places[2].after, std::vector<std::size_t>{1});
  const Plan plan = solve_legs(s).value();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const auto& given_as = plan.order->given_as;
  const auto in = std::find(given_as.begin(), given_as.end(), 1U);
  EXPECT_EQ(*(in + 1), 2U);
  EXPECT_TRUE(verify(parse_plan(plan_json(plan), "plan.json").value())->holds);
}

TEST(Deliveries, ARaisedFlagAndAClockAreObeyed) {
  const std::atomic<bool> raised{true};
  const Plan canceled = solve_legs(example_mission(), &raised).value();
  EXPECT_EQ(canceled.status, Status::canceled);
  EXPECT_FALSE(canceled.reproducible);
  Scenario s = example_mission();
  s.budget.seconds = 1e-9;
  const Plan late = solve_legs(s).value();
  EXPECT_NE(late.status, Status::solved);
  EXPECT_FALSE(late.reproducible);
}

class DeliveriesOnTheCommandLine : public test::CommandLine {
 protected:
  test::Json mission() const { return test::Json::parse(test::slurp(example("deliveries_warehouse.json"))); }
};

TEST_F(DeliveriesOnTheCommandLine, OnePlanOneReportAndTheOrderInWords) {
  const auto o = run("plan " + example("deliveries_warehouse.json") + " -o out");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  for (const char* word :
       {"The legs are driven in the order ", "No order that takes each load before it is left, one at a time, and ends with the last leg is shorter",
        "ways between places were planned", "Leg 1 of 8", "Leg 8 of 8 (charger)"}) {
    EXPECT_NE(o.out.find(word), std::string::npos) << word << "\n" << o.out;
  }
  EXPECT_EQ(run("verify out/plan.json").status, 0);
  const test::Json plan = test::Json::parse(test::slurp(folder_ / "out" / "plan.json"));
  const test::Json& order = plan["meta"]["order"];
  EXPECT_EQ(order["given_as"].size(), 8U);
  EXPECT_TRUE(order["exact"].get<bool>());
  EXPECT_EQ(order["gap"].get<double>(), 0.0);
  EXPECT_EQ(plan["scenario"]["order"], "best_to_last");
  const std::string report = test::slurp(folder_ / "out" / "report.html");
  EXPECT_NE(report.find("The legs are driven in the order"), std::string::npos);
}

TEST_F(DeliveriesOnTheCommandLine, WhatIsWrongIsOneSentence) {
  const std::pair<std::function<void(test::Json&)>, const char*> wrong[] = {
      {[](auto& s) { s["order"] = "fastest"; }, "s.json: order: \"fastest\""},
      {[](auto& s) { s["order"] = 3; }, "s.json: order: "},
      {[](auto& s) {
         s.erase("legs"), s["goal"] = {3, 9, 0};
       },
       "s.json: order: there are no legs to be ordered"},
      {[](auto& s) {
         s["legs"][0]["goal"] = {12, 11};
       },
       "s.json: legs[0].goal: it leaves the heading free, and the ways from there depend on it"},
      {[](auto& s) {
         s["legs"][0]["goal"] = {{"region", {{12, 11}, {13, 11}, {13, 12}}}};
       },
       "s.json: legs[0].goal: it leaves the place free"},
      {[](auto& s) { s["legs"][3]["load"] = nullptr, s["legs"][4]["load"] = "crate", s["legs"][5]["load"] = "crate"; },
       "s.json: legs[5].load: \"crate\" is taken while \"crate\" is carried"},
      {[](auto& s) {
         test::Json leg = s["legs"][0];
         while (s["legs"].size() < 201) s["legs"].push_back(leg);
       },
       "s.json: legs: the order of 201 places is asked for (allowed: at most 200 with \"order\")"},
  };
  for (const auto& [change, sentence] : wrong) {
    test::Json s = mission();
    change(s);
    refused(run("plan " + write(s)), {sentence});
  }
}

}  // namespace
}  // namespace waywright
