// Zones from scenario to judged plan: every planner, every type, against ways computed by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/import.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/map/world.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

const double root2 = std::sqrt(2.0);

Zone zone(ZoneType type, Ring area, double value = 0.0, std::string name = "") {
  Zone z;
  z.type = type;
  z.name = std::move(name);
  z.area = std::move(area);
  if (type == ZoneType::directed) z.direction = value;
  if (type == ZoneType::preferred || type == ZoneType::penalty) z.factor = value;
  if (type == ZoneType::speed_limit) z.speed = value;
  return z;
}

Plan planned(Scenario scenario, const std::string& planner, Parameters parameters = {}) {
  scenario.planner = {planner, std::move(parameters)};
  return *solve(Problem::prepare(std::move(scenario)).value());
}

/// A hall of 20 × 12 m, parted at x = 10 by a wall with two gaps, 2 m wide, at y = 2 and y = 9. Start and goal stand before the lower one, 12 m apart.
/// With cells of 0.5 m and 8 neighbours the way through the upper one is 23 diagonal moves and 4 straight ones.
Scenario two_gaps(std::vector<Zone> zones = {}) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 12})};
  s.map.obstacles = {rectangle({9.9, 0.01}, {10.1, 1}), rectangle({9.9, 3}, {10.1, 8}), rectangle({9.9, 10}, {10.1, 11.99})};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.5};
  s.start = {4.25, 2.25, 0};
  s.mission = Pose{16.25, 2.25, 0};
  s.zones = std::move(zones);
  return s;
}
const double lower = 12.0, upper = 0.5 * (23 * root2 + 4);
const Ring around_lower_gap = rectangle({9, 0.5}, {11, 3.5});

double cost_of(const Plan& plan) {
  const ZoneRules rules{plan.scenario.zones};
  double sum = 0.0;
  for (const Piece& piece : plan.path.pieces) {
    if (const auto* line = std::get_if<Line>(&piece.curve)) sum += rules.cost(line->from, line->to);
  }
  return sum;
}

bool says(const Plan& plan, const std::string& what) {
  return std::any_of(plan.explanation.begin(), plan.explanation.end(), [&](const std::string& s) { return s.find(what) != std::string::npos; });
}

struct Wanted {
  const char* name;
  std::vector<Zone> zones;
  double length;
  double cost;
};

std::vector<Wanted> wanted() {
  return {
      {"none", {}, lower, lower},
      {"forbidden", {zone(ZoneType::forbidden, rectangle({9.5, 0.5}, {10.5, 3.5}), 0, "closed")}, upper, upper},
      {"along", {zone(ZoneType::directed, around_lower_gap, 0.3)}, lower, lower},
      {"against", {zone(ZoneType::directed, around_lower_gap, pi)}, upper, upper},
      {"across", {zone(ZoneType::directed, around_lower_gap, pi / 2)}, lower, lower},
      {"worth it", {zone(ZoneType::penalty, around_lower_gap, 4.0)}, lower, lower + 2 * 3.0},
      {"not worth it", {zone(ZoneType::penalty, around_lower_gap, 4.2)}, upper, upper},
      {"two penalties multiply", {zone(ZoneType::penalty, around_lower_gap, 2.05), zone(ZoneType::penalty, around_lower_gap, 2.05)}, upper, upper},
      {"penalty and preference cancel", {zone(ZoneType::penalty, around_lower_gap, 8.0), zone(ZoneType::preferred, around_lower_gap, 0.25)}, lower, lower + 2 * 1.0},
      // Up in three straight moves and ten diagonal ones; the tenth part of a metre outside is dear, so the sideways moves are made inside.
      {"preferred", {zone(ZoneType::preferred, rectangle({2, 4}, {18, 11}), 0.3)}, 3 + 10 * root2 + 2, 3 + 0.5 * root2 + 0.3 * (9.5 * root2 + 2)},
      {"both ways barred", {zone(ZoneType::directed, around_lower_gap, pi), zone(ZoneType::forbidden, rectangle({9.5, 7.5}, {10.5, 10.5}))}, -1.0, 0.0},
  };
}

TEST(Zones, CellPlannersFindTheWaysThatAHandComputes) {
  for (const Wanted& w : wanted()) {
    for (const auto& [planner, parameters] : std::vector<std::pair<const char*, Parameters>>{{"dijkstra", {}}, {"astar", {}}, {"astar", {{"heuristic", "euclidean"}}}, {"danger_astar", {{"danger_weight", 0.0}}}}) {
      SCOPED_TRACE(std::string{w.name} + " " + planner);
      Parameters p = parameters;
      p["resolution"] = 0.5;
      const Plan plan = planned(two_gaps(w.zones), planner, p);
      if (w.length < 0.0) {
        EXPECT_EQ(plan.status, Status::no_path);
        continue;
      }
      ASSERT_EQ(plan.status, Status::solved) << plan.reason;
      EXPECT_NEAR(plan.metrics.length, w.length, 1e-6);
      EXPECT_NEAR(cost_of(plan), w.cost, 1e-3);
      EXPECT_FALSE(says(plan, "does not weigh"));
    }
  }
}

// A box drives the same cells; turning on the spot costs a little, the same both ways.
TEST(Zones, SoDoesAFootprintWithHeadings) {
  for (const Wanted& w : wanted()) {
    SCOPED_TRACE(w.name);
    Scenario s = two_gaps(w.zones);
    s.vehicle.footprint = {rectangle({-0.3, -0.3}, {0.3, 0.3}), 0.0};
    for (const char* planner : {"dijkstra", "astar"}) {
      const Plan plan = planned(s, planner, {{"resolution", 0.5}, {"turn_cost", 0.001}});
      if (w.length < 0.0) {
        EXPECT_EQ(plan.status, Status::no_path);
        continue;
      }
      ASSERT_EQ(plan.status, Status::solved) << plan.reason;
      EXPECT_NEAR(plan.metrics.length, w.length, 1e-6);
      EXPECT_NEAR(cost_of(plan), w.cost, 1e-3);
    }
  }
}

TEST(Zones, AnyAnglesCostNoMoreThanTheGridAndNoLessThanStraightLinesCan) {
  // Through the upper gap no way is shorter than taut over the corners of its lower edge, (9.9, 8) and (10.1, 8), grown by the disc.
  const double taut = std::hypot(9.9 - 4.25, 8.0 - 2.25) + 0.2 + std::hypot(16.25 - 10.1, 8.0 - 2.25);
  for (const Wanted& w : wanted()) {
    SCOPED_TRACE(w.name);
    const Plan plan = planned(two_gaps(w.zones), "theta_star", {{"resolution", 0.5}});
    if (w.length < 0.0) {
      EXPECT_EQ(plan.status, Status::no_path);
      continue;
    }
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    EXPECT_LE(cost_of(plan), w.cost + 1e-6);
    if (w.length == lower && w.cost == lower) {
      EXPECT_NEAR(plan.metrics.length, lower, 1e-9);
    }
    const bool goes_up = std::any_of(plan.samples.begin(), plan.samples.end(), [](const Sample& s) { return s.y > 8.0; });
    if (goes_up) {
      EXPECT_GE(plan.metrics.length, taut);
    }
    if (w.length == upper) {
      EXPECT_TRUE(goes_up);
    }
    if (w.length == upper) {
      EXPECT_LE(plan.metrics.length, taut + 1.2);  // as near as cells of 0.5 m get
    }
  }
}

// Where a line crosses a penalty, what it crosses costs: around the zone by its corner, or through, by which is cheaper.
TEST(Zones, AnyAnglesWeighWhatALineCrosses) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 12})};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.5};
  s.start = {4.25, 6.25, 0};
  s.mission = Pose{16.25, 6.25, 0};
  // Through: 12 + 2·(factor − 1). Around the corners at (9, 9) and (11, 9): 2·√(4.75² + 2.75²) + 2 for a point.
  const double around = std::hypot(9 - 4.25, 9 - 6.25) + 2.0 + std::hypot(16.25 - 11, 9 - 6.25);
  for (const double factor : {1.2, 1.5, 3.0}) {
    s.zones = {zone(ZoneType::penalty, rectangle({9, 2}, {11, 9}), factor)};
    const Plan any = planned(s, "theta_star", {{"resolution", 0.25}}), grid = planned(s, "astar", {{"resolution", 0.25}});
    ASSERT_EQ(any.status, Status::solved) << any.reason;
    const double through = 12 + 2 * (factor - 1);
    EXPECT_LE(cost_of(any), cost_of(grid) + 1e-9);
    EXPECT_LE(cost_of(any), through + 1e-9);
    EXPECT_NEAR(cost_of(any), std::min(around, through), 0.15) << factor;
  }
}

// The corrected forms that drive straight where they can: what the zones rule is kept, penalties are gone around by searching.
TEST(Zones, StraightPartsKeepTheRules) {
  for (const char* planner : {"safe_astar", "block_astar", "danger_astar"}) {
    for (const Wanted& w : wanted()) {
      SCOPED_TRACE(std::string{w.name} + " " + planner);
      Parameters parameters{{"resolution", 0.25}};
      if (std::string{planner} == "block_astar") parameters["local_radius"] = 30.0;
      const Plan plan = planned(two_gaps(w.zones), planner, parameters);
      if (w.length < 0.0) {
        EXPECT_EQ(plan.status, Status::no_path);
        continue;
      }
      ASSERT_EQ(plan.status, Status::solved) << plan.reason;
      if (w.cost == lower && std::string{planner} != "danger_astar") {
        EXPECT_NEAR(plan.metrics.length, lower, 0.6);
      }
      const bool goes_up = std::any_of(plan.samples.begin(), plan.samples.end(), [](const Sample& s) { return s.y > 8.0; });
      if (std::string{w.name} == "forbidden" || std::string{w.name} == "against") {
        EXPECT_TRUE(goes_up);
      }
      if (std::string{w.name} == "not worth it") {
        EXPECT_LE(cost_of(plan), 1.25 * upper);
      }
    }
  }
}

/// A corridor 0.9 m wide from x = 0 to 12 with rooms at both ends; a box 1 m long cannot turn in it.
Scenario corridor(double direction, double heading) {
  Scenario s;
  s.map.boundaries = {{{-3, -2.05}, {0, -2.05}, {0, -0.45}, {12, -0.45}, {12, -2.05}, {15, -2.05}, {15, 2}, {12, 2}, {12, 0.45}, {0, 0.45}, {0, 2}, {-3, 2}}};
  s.vehicle.footprint = {rectangle({-0.5, -0.25}, {0.5, 0.25}), 0.0};
  s.vehicle.drive = Differential{0.5};
  s.start = {2.05, 0.0, heading};  // the middle of a cell
  s.mission = Pose{10.05, 0.0, heading};
  s.zones = {zone(ZoneType::directed, rectangle({0, -0.45}, {12, 0.45}), direction, "corridor")};
  return s;
}

TEST(Zones, BackingAlongTheDirectionIsAWay) {
  const Plan facing = planned(corridor(0.0, 0.0), "astar", {{"resolution", 0.1}});
  ASSERT_EQ(facing.status, Status::solved) << facing.reason;
  const Plan backing = planned(corridor(0.0, pi), "astar", {{"resolution", 0.1}});
  ASSERT_EQ(backing.status, Status::solved) << backing.reason;
  EXPECT_TRUE(std::all_of(backing.samples.begin(), backing.samples.end(), [](const Sample& s) { return s.direction <= 0; }));
  EXPECT_NEAR(backing.metrics.length, 8.0, 1e-9);
  for (const double heading : {0.0, pi}) {
    const Plan against = planned(corridor(pi, heading), "astar", {{"resolution", 0.1}});
    EXPECT_EQ(against.status, Status::no_path) << against.reason;
  }
}

// The same hall, its cells and its zones, turned and moved: the same costs.
TEST(Zones, RigidMotionsChangeNothing) {
  CellGrid grid;
  grid.name = "hall";
  grid.columns = 40;
  grid.rows = 24;
  grid.cell = 0.5;
  for (int r = 0; r < 24; ++r) {
    for (int c = 0; c < 40; ++c) grid.blocked.push_back(c == 20 && (r < 4 || (r > 7 && r < 18) || r > 21) ? 1 : 0);
  }
  const std::vector<Zone> zones{zone(ZoneType::directed, rectangle({9.3, 1.2}, {11.2, 2.9}), pi), zone(ZoneType::penalty, rectangle({3, 5}, {8, 8}), 2.5), zone(ZoneType::preferred, rectangle({12.1, 3}, {15.3, 9.9}), 0.4)};
  double costs[2] = {0, 0};
  std::size_t turn = 0;
  for (const Pose& at : {Pose{0, 0, 0}, Pose{-37.1, 12.3, 0.7}}) {
    const Frame frame{at};
    Scenario s;
    s.map.grids = {grid};
    s.map.grids[0].origin = at;
    s.vehicle.footprint.disc = 0.3;
    s.vehicle.drive = Differential{0.5};
    s.start = frame.to_world(Pose{4.25, 2.25, 0});
    s.mission = frame.to_world(Pose{16.25, 2.25, 0});
    s.zones = zones;
    for (Zone& z : s.zones) {
      z.area = transformed(z.area, frame);
      z.direction = wrap(z.direction + at.heading);
    }
    for (const char* planner : {"astar", "theta_star"}) {
      const Plan plan = planned(s, planner);
      ASSERT_EQ(plan.status, Status::solved) << plan.reason;
      if (std::string{planner} == "astar") costs[turn] = cost_of(plan);
    }
    ++turn;
  }
  EXPECT_GT(costs[0], 12.0);
  EXPECT_NEAR(costs[0], costs[1], 1e-4);
}

// Docking: the zone lies where the way went.
TEST(Zones, DockingKeepsOutOfAForbiddenZone) {
  Scenario s = fixture::station(fixture::Id::d0);
  const Plan free = planned(s, "pattern_docking");
  ASSERT_EQ(free.status, Status::solved) << free.reason;
  const auto turn = std::find_if(free.samples.begin(), free.samples.end(), [](const Sample& sample) { return sample.direction == 1; });
  const Vec2 at = turn->pose().position();
  const Ring area = rectangle(at - Vec2{0.4, 0.4}, at + Vec2{0.4, 0.4});
  s.zones = {zone(ZoneType::forbidden, area, 0, "charging")};
  s.clearance = 0.1;
  const Plan kept = planned(s, "pattern_docking");
  ASSERT_EQ(kept.status, Status::solved) << kept.reason;
  World world;
  world.add_obstacle(area, "zone");
  world.build();
  for (const Sample& sample : kept.samples) EXPECT_GE(world.clearance(s.vehicle.footprint, sample.pose(), 1.0).clearance, 0.1 - 1e-9);
  // And with the path of before it is named.
  const Plan judged = judge(Problem::prepare(s).value(), free.path);
  EXPECT_EQ(judged.status, Status::unproven);
  EXPECT_NE(judged.reason.find("zone \"charging\""), std::string::npos) << judged.reason;
}

TEST(Zones, TheForksStillGoInBesideAForbiddenZone) {
  Scenario s = fixture::with_pockets(Manoeuvre::dock);
  const Frame shelf = std::get<Station>(s.mission).shelf.face();
  s.zones = {zone(ZoneType::forbidden, transformed(rectangle({0.5, 3.5}, {1.5, 4.5}), shelf), 0, "corner")};
  const Plan plan = planned(s, "pattern_docking");
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_TRUE(plan.certificate.pocket_clearance.has_value());
  // Over the docked pose it is the goal that cannot be.
  s.zones[0].area = transformed(rectangle({0.5, -0.2}, {1.5, 0.2}), shelf);
  const Plan none = planned(s, "pattern_docking");
  EXPECT_EQ(none.status, Status::goal_in_collision);
  EXPECT_NE(none.reason.find("zone \"corner\""), std::string::npos) << none.reason;
}

TEST(Zones, AStartInAForbiddenZoneIsNamed) {
  const Plan plan = planned(two_gaps({zone(ZoneType::forbidden, rectangle({4, 2}, {5, 3}), 0, "bay")}), "astar");
  EXPECT_EQ(plan.status, Status::start_in_collision);
  EXPECT_NE(plan.reason.find("zone \"bay\""), std::string::npos) << plan.reason;
}

TEST(Zones, ZonesThatLeaveNoWayAreNamed) {
  const Zone against = zone(ZoneType::directed, rectangle({9, 0.5}, {11, 3.5}), pi, "aisle west");
  const Zone shut = zone(ZoneType::forbidden, rectangle({9, 7.5}, {11, 10.5}), 0.0, "charging");
  const Zone aside = zone(ZoneType::forbidden, rectangle({1, 10}, {2, 11}));
  for (const char* planner : {"astar", "theta_star", "danger_astar"}) {
    const Plan plan = planned(two_gaps({aside, shut, against}), planner, {{"resolution", 0.5}});
    EXPECT_EQ(plan.status, Status::no_path) << planner;
    EXPECT_EQ(plan.reason.rfind("zone \"aisle west\" (directed, against the way) stands in the way: without forbidden and directed zones there is one of 12.000 m; with them no way over cells", 0), 0U)
        << plan.reason;
  }
  const Plan both = planned(two_gaps({shut, zone(ZoneType::forbidden, around_lower_gap)}), "ompl_rrt_connect", {{"space", std::string{"turns"}}});
  EXPECT_EQ(both.status, Status::no_path);
  EXPECT_EQ(both.reason.rfind("zone ", 0), 0U) << both.reason;
  EXPECT_NE(both.reason.find("(forbidden) stands in the way"), std::string::npos) << both.reason;
  // Where walls shut it no zone is blamed.
  Scenario walls = two_gaps({aside});
  walls.map.lines = {{{10.0, 0.0}, {10.0, 12.0}}};
  EXPECT_EQ(planned(walls, "astar", {{"resolution", 0.5}}).reason.rfind("no way over cells", 0), 0U);
}

TEST(Zones, AStartInADirectedZoneMayFaceWhereverItDoes) {
  for (const double heading : {0.0, 1.5, 3.0}) {
    Scenario s = two_gaps({zone(ZoneType::directed, rectangle({3, 1}, {6, 4}), 0.0)});
    s.start.heading = heading;
    const Plan plan = planned(s, "astar", {{"resolution", 0.5}});
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    EXPECT_NEAR(plan.metrics.length, lower, 1e-6);
  }
}

// Every other planner's path is judged, and it says what it does not look at.
TEST(Zones, WhoDoesNotLookAtZonesSaysSoAndIsJudged) {
  for (const char* planner : {"pattern_docking", "pattern_docking_published", "ompl_rrt_connect"}) {
    SCOPED_TRACE(planner);
    Scenario s = fixture::station(fixture::Id::d0);
    // The last metres into the shelf go against this one.
    s.zones = {zone(ZoneType::directed, rectangle({0.5, -1}, {4.0, 1}), 0.0, "out only"), zone(ZoneType::penalty, rectangle({5, 5}, {6, 6}), 2.0)};
    s.budget.evaluations = 400;
    const Plan plan = planned(s, planner);
    EXPECT_NE(plan.status, Status::solved);
    if (!plan.samples.empty()) {
      EXPECT_EQ(plan.status, Status::unproven);
      EXPECT_NE(plan.reason.find("zone \"out only\""), std::string::npos) << plan.reason;
    }
    EXPECT_TRUE(says(plan, std::string{planner} + " does not weigh preferred and penalty zones, and does not look at the direction of directed ones"));
  }
}

TEST(Zones, LimitsOfSpeedAreInTheProfileAndTheTime) {
  const Plan plan = planned(two_gaps({zone(ZoneType::speed_limit, around_lower_gap, 0.25, "gap")}), "astar", {{"resolution", 0.5}});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_NEAR(plan.metrics.length, lower, 1e-6);
  for (const Sample& s : plan.samples) {
    if (s.x + 0.3 > 9.0 && s.x - 0.3 < 11.0) {
      EXPECT_LE(s.speed, 0.25 + 1e-12);
    }
  }
  // 2.6 m at 0.25 m/s instead of 1 m/s, with ramps of 0.9375 m at 0.5 m/s² on both sides; up to 5 cm more at both ends.
  const auto time = [&](double slow) {
    const double ramp = (1 - 0.0625) / (2 * 0.5);
    return 4.0 + (12 - 2.0 - slow - 2 * ramp) + 2 * (0.75 / 0.5) + slow / 0.25;
  };
  EXPECT_GE(plan.metrics.travel_time, time(2.6) - 1e-6);
  EXPECT_LE(plan.metrics.travel_time, time(2.7) + 0.02);  // where a ramp ends between samples it is a little less steep
}

TEST(Zones, PlanFilesKeepThemAndVerifyHoldsThem) {
  const Scenario s = two_gaps({zone(ZoneType::speed_limit, around_lower_gap, 0.25, "gap"), zone(ZoneType::directed, rectangle({12, 1}, {15, 4}), 0.0, "east"),
                               zone(ZoneType::penalty, rectangle({12, 5}, {15, 6}), 2.0), zone(ZoneType::preferred, rectangle({12, 7}, {15, 8}), 0.5), zone(ZoneType::forbidden, rectangle({1, 10}, {2, 11}), 0, "bay")});
  const Plan plan = planned(s, "astar", {{"resolution", 0.5}});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const Plan read = parse_plan(plan_json(plan), "plan.json").value();
  ASSERT_EQ(read.scenario.zones.size(), 5U);
  EXPECT_EQ(plan_json(read), plan_json(plan));
  EXPECT_TRUE(verify(read)->holds);
  const auto finding = [](const Plan& tampered) {
    const auto verification = verify(tampered);
    std::string text;
    for (const std::string& f : verification->findings) text += f + "\n";
    return verification->holds ? "holds" : text;
  };
  Plan turned = read;
  turned.scenario.zones[1].direction = pi;
  EXPECT_NE(finding(turned).find("zone \"east\""), std::string::npos) << finding(turned);
  Plan closed = read;
  closed.scenario.zones[4].area = rectangle({7, 2}, {8, 3});
  EXPECT_NE(finding(closed).find("zone \"bay\""), std::string::npos) << finding(closed);
  // The profile of before the limit was there.
  Scenario unlimited = s;
  unlimited.zones.erase(unlimited.zones.begin());
  Plan fast = planned(unlimited, "astar", {{"resolution", 0.5}});
  fast.scenario.zones = s.zones;
  EXPECT_NE(finding(fast).find("in zone \"gap\""), std::string::npos) << finding(fast);
  Plan slower = read;
  slower.scenario.zones[0].speed = 0.1;
  EXPECT_NE(finding(slower).find("in zone \"gap\""), std::string::npos) << finding(slower);
}

TEST(Zones, OneThatLiesOffTheMapIsNoted) {
  const auto notes_of = [](std::vector<Zone> zones) {
    Scenario s = two_gaps(std::move(zones));
    s.planner = {"astar", {}};
    const Plan plan = *solve(Problem::prepare(s).value());
    const Plan read = parse_plan(plan_json(plan), "plan.json").value();
    EXPECT_EQ(parse_plan(plan_json(read), "plan.json").value().scenario.map.notes, read.scenario.map.notes);  // once, however often it is read
    return read.scenario.map.notes;
  };
  EXPECT_TRUE(notes_of({zone(ZoneType::penalty, around_lower_gap, 2.0), zone(ZoneType::speed_limit, rectangle({19, 11}, {30, 30}), 0.5)}).empty());
  EXPECT_EQ(notes_of({zone(ZoneType::penalty, around_lower_gap, 2.0), zone(ZoneType::forbidden, rectangle({100, 0}, {110, 5}), 0.0, "charging")}),
            (std::vector<std::string>{"zones: zone \"charging\" lies off the map and the mission, which reach from (0.00, 0.00) to (20.00, 12.00)"}));
  EXPECT_EQ(notes_of({zone(ZoneType::forbidden, rectangle({-9, 0}, {-1, 5})), zone(ZoneType::directed, rectangle({0, 13}, {1, 14}))}).front().rfind("zones: zone 0, zone 1 lie off", 0), 0U);
}

TEST(Zones, ImportedPosesAreHeldToThem) {
  const Problem problem = Problem::prepare(two_gaps({zone(ZoneType::directed, around_lower_gap, pi, "west only"), zone(ZoneType::speed_limit, rectangle({12, 1}, {14, 4}), 0.3, "door")})).value();
  PoseSequence sequence;
  for (int i = 0; i <= 240; ++i) sequence.poses.push_back({4.25 + 0.05 * i, 2.25, 0.0});
  const Plan plan = judge_imported(problem, Path{{{sequence, 1}}});
  EXPECT_EQ(plan.status, Status::unproven);
  EXPECT_NE(plan.reason.find("zone \"west only\""), std::string::npos) << plan.reason;
  Scenario s = problem.scenario();
  s.zones.erase(s.zones.begin());
  const Problem open = Problem::prepare(s).value();
  EXPECT_EQ(judge_imported(open, Path{{{sequence, 1}}}).status, Status::solved);
  // With the speeds that the file tells.
  std::string csv = "x,y,heading,speed\n";
  for (int i = 0; i <= 240; ++i) csv += std::to_string(4.25 + 0.05 * i) + ",2.25,0," + (i == 40 ? "" : "0.8") + "\n";
  std::vector<PoseSpeed> speeds;
  const Path path = parse_poses_csv(csv, "poses.csv", nullptr, &speeds).value();
  ASSERT_EQ(speeds.size(), 240U);
  const Plan fast = judge_imported(open, path, speeds);
  EXPECT_EQ(fast.status, Status::unproven);
  EXPECT_NE(fast.reason.find("in zone \"door\" at (11.750, 2.250) the vehicle drives 0.8 m/s, and at most 0.3 m/s are allowed"), std::string::npos) << fast.reason;
  for (PoseSpeed& p : speeds) p.speed = -0.3;
  EXPECT_EQ(judge_imported(open, path, speeds).status, Status::solved);
}

}  // namespace
}  // namespace waywright
