#include "waywright/docking/docking.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "waywright/docking/docking.h"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

using fixture::Id;

Docking ready(Id id) {
  auto docking = Docking::prepare(fixture::station(id));
  EXPECT_TRUE(docking) << docking.error().message();
  return std::move(*docking);
}

TEST(Docking, PlansWhatTheJudgeConfirms) {
  for (const Id id : {Id::d0, Id::d1, Id::d2, Id::d3}) {
    const Docking docking = ready(id);
    const DockingPlan plan = docking.plan();
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    const Plan judged = judge(docking.problem(), plan.path);
    EXPECT_EQ(judged.status, Status::solved);
    EXPECT_EQ(judged.certificate.clearance, plan.certificate.clearance);
    EXPECT_EQ(judged.metrics.length, plan.length);
    EXPECT_EQ(judged.metrics.travel_time, plan.travel_time);
    EXPECT_EQ(judged.samples.size(), plan.samples.size());
    EXPECT_TRUE(plan.reproducible);
  }
}

TEST(Docking, SaysWhyWhereThereIsNone) {
  Scenario blocked = fixture::station(Id::d0);
  blocked.map.obstacles.push_back(rectangle({7.0, -0.3}, {7.5, 0.3}));
  EXPECT_EQ(Docking::prepare(blocked)->plan().status, Status::start_in_collision);
  Scenario walled = fixture::station(Id::d0);
  walled.map.lines.push_back({{3.6, -7.0}, {3.6, 7.0}});
  const DockingPlan plan = Docking::prepare(walled)->plan();
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_NE(plan.reason.find("line 0"), std::string::npos) << plan.reason;
}

TEST(Docking, BadFieldsAreRefusedByName) {
  const auto sentence = [](const auto& change) {
    Scenario s = fixture::station(Id::d0);
    change(s);
    const auto docking = Docking::prepare(s);
    return docking ? std::string{"accepted"} : docking.error().field;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sentence([&](Scenario& s) { s.start.x = nan; }), "start");
  EXPECT_EQ(sentence([&](Scenario& s) { s.map.points.push_back({0.0, std::numeric_limits<double>::infinity()}); }), "map.points");
  EXPECT_EQ(sentence([&](Scenario& s) { s.map.obstacles.push_back({{0, 0}, {1, 1}, {1, 0}, {0, 1}}); }), "map.obstacles");
  EXPECT_EQ(sentence([&](Scenario& s) { s.vehicle.footprint.polygon.clear(); s.vehicle.footprint.disc = -1.0; }), "vehicle.footprint");
  EXPECT_EQ(sentence([&](Scenario& s) { std::get<Tricycle>(s.vehicle.drive).wheelbase = 0.0; }), "vehicle.drive.wheelbase");
  EXPECT_EQ(sentence([&](Scenario& s) { s.vehicle.limits.speed = 0.0; }), "vehicle.limits.speed");
  EXPECT_EQ(sentence([&](Scenario& s) { s.vehicle.drive = Mecanum{}; }), "vehicle.drive");
  EXPECT_EQ(sentence([&](Scenario& s) { s.mission = Pose{}; }), "station");
  EXPECT_EQ(sentence([&](Scenario& s) { std::get<Station>(s.mission).shelf.width = nan; }), "station.shelf.size");
  EXPECT_EQ(sentence([&](Scenario& s) { std::get<Station>(s.mission).shelf.slot = 9.0; }), "station.shelf.slot");
  EXPECT_EQ(sentence([&](Scenario& s) { s.clearance = -0.1; }), "clearance");
  EXPECT_EQ(sentence([](Scenario& s) { s.moving.emplace_back(); }), "moving");
  Scenario clockwise = fixture::station(Id::d0);
  std::reverse(std::get<Station>(clockwise.mission).area.begin(), std::get<Station>(clockwise.mission).area.end());
  EXPECT_TRUE(Docking::prepare(clockwise)) << "repaired";
}

TEST(Docking, ABudgetOfWorkIsKeptAndRepeatable) {
  const Docking docking = ready(Id::d2);
  BudgetLimits limits;
  limits.evaluations = 300;
  const DockingPlan a = docking.plan(limits), b = docking.plan(limits);
  EXPECT_LE(a.evaluations, 300);
  EXPECT_TRUE(a.reproducible);
  EXPECT_EQ(a.cost, b.cost);
}

TEST(Docking, ARaisedFlagGivesTheBestSoFar) {
  PatternDockingOptions endless;
  endless.evaluations = 1'000'000'000;
  const auto docking = Docking::prepare(fixture::station(Id::d1), endless);
  std::atomic<bool> cancel{false};
  std::thread other{[&] {
    std::this_thread::sleep_for(std::chrono::milliseconds{50});
    cancel = true;
  }};
  const DockingPlan plan = docking->plan({}, &cancel);
  other.join();
  EXPECT_EQ(plan.status, Status::solved) << "what was found by then is proven";
  EXPECT_TRUE(prove(docking->problem(), plan.path).holds());
  EXPECT_LT(distance(plan.samples.back().pose().position(), end_pose(plan.path).position()), 1e-9);
  EXPECT_FALSE(plan.reproducible);
  EXPECT_LT(plan.evaluations, endless.evaluations);
  BudgetLimits soon;
  soon.seconds = 0.02;
  EXPECT_FALSE(docking->plan(soon).reproducible);
}

struct Corners {
  explicit Corners(const Ring& ring) {
    for (const Vec2 p : ring) list.push_back({p.x, p.y});
  }
  ww_points points() const { return {list.data(), list.size()}; }
  std::vector<ww_point> list;
};

TEST(DockingC, PlansTheSameAsTheCppInterface) {
  Scenario scenario = fixture::station(Id::d1);
  const Station& station = std::get<Station>(scenario.mission);
  const Corners footprint{scenario.vehicle.footprint.polygon}, area{station.area}, points{scenario.map.points};
  ww_request request{};
  request.vehicle.footprint = footprint.points();
  request.vehicle.wheelbase = 1.9;
  request.vehicle.max_steering = 60.0 * pi / 180.0;
  request.vehicle.speed = request.vehicle.reverse_speed = 1.0;
  request.vehicle.acceleration = request.vehicle.deceleration = 0.5;
  request.vehicle.curvature = 0.8;
  request.station.area = area.points();
  request.station.shelf_center = {station.shelf.center.x, station.shelf.center.y};
  request.station.shelf_depth = station.shelf.depth;
  request.station.shelf_width = station.shelf.width;
  request.station.gap = station.shelf.gap;
  request.station.points = points.points();
  request.start = {scenario.start.x, scenario.start.y, scenario.start.heading};
  char message[200] = "";
  ww_docking* docking = ww_docking_prepare(&request, message, sizeof message);
  ASSERT_NE(docking, nullptr) << message;
  ww_cancel* cancel = ww_cancel_create();
  ww_plan* plan = ww_docking_plan(docking, 0.0, cancel);
  ASSERT_NE(plan, nullptr);
  const DockingPlan same = ready(Id::d1).plan();
  EXPECT_EQ(ww_plan_status(plan), WW_SOLVED) << ww_plan_reason(plan);
  EXPECT_EQ(ww_plan_length(plan), same.length);
  EXPECT_EQ(ww_plan_clearance(plan), same.certificate.clearance);
  EXPECT_EQ(ww_plan_time(plan), same.travel_time);
  EXPECT_EQ(ww_plan_cost(plan), same.cost);
  size_t count = 0;
  const ww_sample* samples = ww_plan_samples(plan, &count);
  ASSERT_EQ(count, same.samples.size());
  EXPECT_EQ(samples[count / 2].x, same.samples[count / 2].x);
  // On the way the shelf turns out to be 2 cm aside.
  const ww_state half = ww_plan_state(plan, 0.5 * ww_plan_time(plan));
  EXPECT_GT(half.driven, 0.3 * ww_plan_length(plan));
  EXPECT_EQ(ww_docking_from(docking, nullptr, nullptr, message, sizeof message), nullptr);
  const ww_pose aside{station.shelf.center.x, station.shelf.center.y + 0.02, station.shelf.heading};
  ww_docking* later = ww_docking_from(docking, &half, &aside, message, sizeof message);
  ASSERT_NE(later, nullptr) << message;
  ww_session* session = ww_session_create(later);
  ASSERT_NE(session, nullptr);
  const ww_plan* next = ww_session_replan(session, plan, half.driven, 0.0, nullptr);
  ASSERT_NE(next, nullptr);
  EXPECT_EQ(ww_plan_status(next), WW_SOLVED) << ww_plan_reason(next);
  EXPECT_EQ(ww_plan_is_carried_on(next), 1);
  EXPECT_GT(ww_plan_moved(next), 0.019);
  EXPECT_NEAR(ww_plan_samples(next, &count)[0].speed, std::abs(half.speed), 1e-5);
  EXPECT_EQ(ww_plan_status(ww_session_plan(session, 0.0, nullptr)), WW_SOLVED);
  ww_session_free(session);
  ww_docking_free(later);
  ww_plan_free(plan);
  ww_cancel_raise(cancel);
  plan = ww_docking_plan(docking, 0.0, cancel);
  EXPECT_EQ(ww_plan_status(plan), WW_CANCELED);
  ww_plan_free(plan);
  ww_cancel_free(cancel);
  ww_docking_free(docking);
}

TEST(DockingC, SaysWhatIsWrongInOneSentence) {
  char message[40] = "";
  ww_request request{};
  EXPECT_EQ(ww_docking_prepare(&request, message, sizeof message), nullptr);
  EXPECT_GT(std::string{message}.size(), 10U);
  EXPECT_EQ(ww_docking_prepare(nullptr, message, sizeof message), nullptr);
  EXPECT_EQ(std::string{message}, "there is no request");
  EXPECT_EQ(ww_docking_prepare(&request, nullptr, 0), nullptr);
  ww_docking_free(nullptr);
  ww_plan_free(nullptr);
  ww_session_free(ww_session_create(nullptr));
  EXPECT_EQ(ww_session_plan(nullptr, 0.0, nullptr), nullptr);
  EXPECT_EQ(ww_plan_state(nullptr, 1.0).driven, 0.0);
  EXPECT_EQ(ww_plan_status(nullptr), WW_NO_PATH);
}

}  // namespace
}  // namespace waywright
