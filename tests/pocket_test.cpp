// Forks in the pocket and back out with the load: planned, proven, confirmed by brute force; what cannot be is refused with its reason.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/oracle/confirm.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/import.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

constexpr double tine_inside = 0.12, tine_outside = 0.33;  // m from the vehicle's axis

Vehicle pallet_truck() {
  Vehicle v;
  v.footprint.polygon = {{-2.30, -0.45}, {-0.75, -0.45}, {-0.75, -0.33}, {0.40, -0.33}, {0.40, -0.12}, {-0.75, -0.12},
                         {-0.75, 0.12},  {0.40, 0.12},   {0.40, 0.33},   {-0.75, 0.33}, {-0.75, 0.45}, {-2.30, 0.45}};
  v.forks = {rectangle({-0.75, -tine_outside}, {0.40, -tine_inside}), rectangle({-0.75, tine_inside}, {0.40, tine_outside})};
  v.loads["pallet"] = {{rectangle({-0.75, -0.40}, {0.45, 0.40}), 0.0}, 800.0};
  v.drive = Tricycle{1.9, 1.0, std::nullopt, SteeredAxle::rear};
  v.limits.curvature = 0.8;
  return v;
}

/// A shelf at `place` (middle of its face, heading out of it) with a slot and two openings for the tines, `play` m wider on each side.
Scenario scenario_at(const Pose& place, double slot, double play, double depth = 1.0) {
  Scenario s;
  s.vehicle = pallet_truck();
  const Frame face{place};
  Station station;
  station.area = transformed(rectangle({-1.5, -7.0}, {10.5, 7.0}), face);
  station.shelf.center = face.to_world(Vec2{-0.6, 0.0});
  station.shelf.heading = place.heading;
  station.shelf.depth = 1.2;
  station.shelf.width = 2.7;
  station.shelf.slot = slot;
  station.insertion = Insertion{depth,
                                {{slot - tine_outside - play, slot - tine_inside + play}, {slot + tine_inside - play, slot + tine_outside + play}}};
  s.map.obstacles.push_back(transformed(rectangle({5.2, 3.0}, {6.4, 3.8}), face));
  s.start = face.to_world(Pose{8.0, 0.0, 0.0});
  s.clearance = 0.04;
  s.pose_error = {0.01, 0.01, 0.004};
  s.mission = station;
  return s;
}

Plan solved(const Scenario& scenario) {
  const auto problem = Problem::prepare(scenario);
  EXPECT_TRUE(problem) << problem.error().message();
  auto plan = solve(*problem);
  EXPECT_TRUE(plan);
  return std::move(*plan);
}

void confirm(const Scenario& scenario, const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const auto read = parse_plan(plan_json(plan), "plan.json");
  ASSERT_TRUE(read) << read.error().message();
  const auto verification = verify(*read);
  ASSERT_TRUE(verification);
  EXPECT_TRUE(verification->holds) << verification->findings.front();

  const Problem problem = Problem::prepare(scenario).value();
  const auto& station = std::get<Station>(scenario.mission);
  const bool out = station.manoeuvre == Manoeuvre::undock;
  const std::size_t stretch = out ? 0 : plan.path.pieces.size() - 1;
  ASSERT_EQ(problem.pocket_piece(plan.path), stretch);
  const double margin = problem.pose_error_margin();
  const OracleClearance found = oracle_mission_clearance(scenario, plan.path);
  EXPECT_GE(found.vehicle + 1e-9, plan.certificate.clearance + margin);
  ASSERT_TRUE(plan.certificate.pocket_clearance);
  ASSERT_TRUE(found.forks);
  EXPECT_GE(*found.forks + 1e-9, *plan.certificate.pocket_clearance + margin);
  EXPECT_LE(*found.forks, *plan.certificate.pocket_clearance + margin + 0.002);
  EXPECT_NEAR(plan.certificate.checked_length, length(plan.path), 1e-9);
}

TEST(Pocket, DockedAndUndockedAtRandomShelves) {
  Random random{3};
  for (int i = 0; i < 12; ++i) {
    const Pose place = make_pose({random.uniform(-50, 50), random.uniform(-50, 50)}, random.uniform(-pi, pi));
    Scenario scenario = scenario_at(place, random.uniform(-0.9, 0.9), random.uniform(0.035, 0.09));
    const Plan in = solved(scenario);
    confirm(scenario, in);
    EXPECT_EQ(in.samples.back().direction, 1);
    const Vec2 tips = Frame{std::get<Station>(scenario.mission).shelf.face()}.to_local(Frame{in.samples.back().pose()}.to_world(Vec2{0.40, 0.0}));
    EXPECT_NEAR(tips.x, -1.0, 1e-9) << "the tips are as deep behind the face as asked";

    std::get<Station>(scenario.mission).manoeuvre = Manoeuvre::undock;
    scenario.carried_load = "pallet";
    const Plan out = solved(scenario);
    confirm(scenario, out);
    EXPECT_EQ(out.samples.front().direction, -1);
    EXPECT_LT(distance(out.samples.front().pose().position(), in.samples.back().pose().position()), 1e-9);
    EXPECT_LT(distance(out.samples.back().pose().position(), scenario.start.position()), 1e-9);
    EXPECT_GT(out.metrics.min_clearance, 0.04);
  }
}

TEST(Pocket, OnlyTheForksMayEnterAndOnlyThere) {
  const Plan deep = solved(scenario_at({}, 0.3, 0.05, 1.15));
  EXPECT_EQ(deep.status, Status::goal_in_collision) << "the body would touch the face";
  EXPECT_NE(deep.reason.find("the shelf"), std::string::npos) << deep.reason;

  const Plan tight = solved(scenario_at({}, 0.3, 0.02));
  EXPECT_EQ(tight.status, Status::goal_in_collision) << "the pose error is more than the forks' play";
  EXPECT_NE(tight.reason.find("beside its pockets"), std::string::npos) << tight.reason;

  Scenario beside = scenario_at({}, 0.3, 0.05);
  std::get<Station>(beside.mission).shelf.slot = 0.0;
  EXPECT_EQ(solved(beside).status, Status::goal_in_collision) << "no pocket in front of the forks";
}

TEST(Pocket, AnObstacleBesideTheFaceCounts) {
  Scenario s = scenario_at({}, 0.0, 0.05);
  s.map.points.push_back({0.3, 0.47});  // 2 cm from where the body's side comes, with the forks in
  EXPECT_EQ(solved(s).status, Status::goal_in_collision);
}

TEST(Pocket, VerifyRefusesAnyOtherWayIn) {
  const Scenario scenario = scenario_at({}, 0.3, 0.05);
  const Problem problem = Problem::prepare(scenario).value();
  const Plan plan = solved(scenario);
  ASSERT_EQ(plan.status, Status::solved);
  const auto refused = [&](const auto& change, const char* words) {
    Plan other = plan;
    change(other.path);
    const Plan judged = judge(problem, other.path);
    EXPECT_EQ(judged.status, Status::unproven);
    EXPECT_NE(judged.reason.find(words), std::string::npos) << judged.reason;
  };
  refused([](Path& p) { p.pieces.pop_back(); }, "does not stand as one line");
  refused([](Path& p) { std::get<Line>(p.pieces.back().curve).to.x -= 0.01; }, "does not stand as one line");
  refused([](Path& p) { std::get<Line>(p.pieces.back().curve).to.y += 0.01; }, "does not stand as one line");
  refused([](Path& p) { p.pieces.back().direction = -1; }, "does not stand as one line");
  refused(
      [](Path& p) {  // the same places as two lines: only one stretch is known
        const Line line = std::get<Line>(p.pieces.back().curve);
        const Vec2 middle = 0.5 * (line.from + line.to);
        p.pieces.back().curve = Line{line.from, middle};
        p.pieces.push_back({Line{middle, line.to}, 1});
      },
      "does not stand as one line");
}

TEST(Pocket, ImportedPosesMayEndDockedOrInTheShelf) {
  for (const bool out : {false, true}) {
    Scenario scenario = scenario_at({}, 0.3, 0.05);
    if (out) {
      std::get<Station>(scenario.mission).manoeuvre = Manoeuvre::undock;
      scenario.carried_load = "pallet";
    }
    const Problem problem = Problem::prepare(scenario).value();
    const Plan plan = solved(scenario);
    for (const bool with_stretch : {true, false}) {
      Path path;
      for (const Sample& s : plan.samples) {
        const bool in_stretch = s.piece == (out ? 0U : plan.path.pieces.size() - 1);
        if (in_stretch && !with_stretch && s.pose().position() != problem.pocket()->outer.position()) continue;
        if (path.pieces.empty() || path.pieces.back().direction != s.direction) path.pieces.push_back({PoseSequence{}, s.direction});
        std::get<PoseSequence>(path.pieces.back().curve).poses.push_back(s.pose());
      }
      const Plan imported = judge_imported(problem, path);
      EXPECT_EQ(imported.status, Status::solved) << imported.reason;
      EXPECT_NEAR(imported.metrics.length, plan.metrics.length, 0.002);
      EXPECT_GT(imported.explanation.size(), 1U);
    }
  }
}

TEST(Pocket, RefusesWhatCannotBe) {
  const auto sentence = [](const auto& change) {
    Scenario s = scenario_at({}, 0.3, 0.05);
    change(s, std::get<Station>(s.mission));
    const auto problem = Problem::prepare(s);
    return problem ? std::string{"accepted"} : problem.error().message();
  };
  using S = Scenario&;
  using T = Station&;
  EXPECT_EQ(sentence([](S s, T) { s.vehicle.forks.clear(); }),
            "vehicle.forks: the field is missing, and station.insertion needs it (allowed: the part of the footprint that may enter a pocket)");
  EXPECT_EQ(sentence([](S s, T) { s.vehicle.footprint = {{}, 0.5}; }), "vehicle.footprint: a disc has no forks (allowed: a polygon)");
  EXPECT_EQ(sentence([](S s, T) { s.vehicle.forks = {rectangle({-0.75, 0.12}, {0.3, 0.33})}; }),
            "vehicle.forks: the fork tips are at x = 0.3000 m and the footprint's front at 0.4000 m (allowed: forks that are the front of the footprint)");
  EXPECT_EQ(sentence([](S s, T) { s.vehicle.forks = {rectangle({-0.75, 0.0}, {0.4, 0.33})}; }),
            "vehicle.forks: a part of the forks is outside the footprint (allowed: a part of the footprint)");
  EXPECT_EQ(sentence([](S, T t) { t.insertion->pockets = {{1.0, 1.5}}; }),
            "station.insertion.pockets: the pocket [1, 1.5] reaches beyond the shelf's face of 2.7 m (allowed: -1.35 to 1.35)");
  EXPECT_EQ(sentence([](S, T t) { t.insertion->pockets = {{0.2, 0.5}, {0.4, 0.6}}; }),
            "station.insertion.pockets: the pockets [0.2, 0.5] and [0.4, 0.6] overlap (allowed: pockets beside each other)");
  EXPECT_EQ(sentence([](S s, T) { s.carried_load = "barrel"; }), "carried_load: the vehicle has no load \"barrel\" (allowed: pallet)");
  EXPECT_EQ(sentence([](S s, T) {
              s.vehicle.loads["far"] = {{rectangle({3, 3}, {4, 4}), 0.0}, 1.0};
              s.carried_load = "far";
            }),
            "vehicle.loads.far.footprint: load and vehicle do not make one simple polygon (allowed: a load that overlaps the vehicle's footprint and leaves no hole)");
}

TEST(Pocket, ACarriedLoadWidensWhatDrives) {
  Scenario s = scenario_at({}, 0.0, 0.05);
  std::get<Station>(s.mission).insertion.reset();
  s.vehicle.loads["wide"] = {{rectangle({-0.75, -0.9}, {0.45, 0.9}), 0.0}, 100.0};
  s.map.points.push_back({7.6, 0.7});  // beside the forks at the start: 0.37 m from them, inside a wide load
  EXPECT_EQ(solved(s).status, Status::solved);
  s.carried_load = "wide";
  EXPECT_EQ(solved(s).status, Status::start_in_collision);
}

}  // namespace
}  // namespace waywright
