// Stations with straight corners, slivers, touching boxes, no room, at the edge of the world: planned and proven, or refused with a reason.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"
#include "waywright/planner/docking/pattern_docking.hpp"

namespace waywright {
namespace {

struct Answer {
  std::string refused;
  Status status = Status::no_path;
  std::string reason;
};

Answer plan(Scenario scenario) {
  scenario.budget.evaluations = 100;
  const auto problem = Problem::prepare(scenario);
  if (!problem) return {problem.error().message(), Status::no_path, {}};
  if (const auto ends = problem->check_ends()) return {{}, ends->status, ends->reason};
  Budget budget{scenario.budget};
  const auto result = PatternDockingPlanner{{}, std::make_shared<LatticeSearch>(), 1}.plan(*problem, budget);
  if (!result) return {{}, result.error().failure.status, result.error().failure.reason};
  const Plan judged = judge(*problem, problem->whole_path(result->path));
  return {{}, judged.status, judged.reason};
}

const Pose everywhere[] = {{}, {1e6 - 20.0, 20.0 - 1e6, 0.7}, {0, 0, -pi}, {1e-9, 1e-9, 1e-9}};

TEST(DegenerateStation, StraightCornersAndTouchingBoxesChangeNothing) {
  for (const Pose& place : everywhere) {
    Scenario s = fixture::station(fixture::Id::d1, place);
    const Answer plain = plan(s);
    EXPECT_EQ(plain.status, Status::solved) << plain.reason;
    auto& station = std::get<Station>(s.mission);
    Ring& area = station.area;
    for (std::size_t i = area.size(); i-- > 0;) {
      const Vec2 a = area[i], b = area[(i + 1) % area.size()];
      area.insert(area.begin() + static_cast<std::ptrdiff_t>(i) + 1, {a + 1e-9 * (b - a), 0.5 * (a + b), a + (1.0 - 1e-9) * (b - a)});
    }
    s.map.boundaries = {area};  // the same border twice
    s.map.obstacles.push_back(station.shelf.outline());
    s.map.lines.push_back({area[0], area[0]});
    s.map.lines.push_back({area[0], area[1], area[0]});
    const Answer crowded = plan(s);
    EXPECT_EQ(crowded.status, Status::solved) << crowded.refused << crowded.reason;
  }
}

void sizes_are_answered(const std::vector<double>& scales) {
  for (const double scale : scales) {
    for (const bool grown_vehicle : {false, true}) {
      Scenario s = fixture::station(fixture::Id::d0);
      auto& station = std::get<Station>(s.mission);
      for (Vec2& p : station.area) p = scale * p;
      station.shelf.center = scale * station.shelf.center;
      station.shelf.depth *= scale;
      station.shelf.width *= scale;
      station.shelf.gap *= scale;
      s.start = {scale * s.start.x, scale * s.start.y, s.start.heading};
      if (grown_vehicle) {
        for (Vec2& p : s.vehicle.footprint.polygon) p = scale * p;
        std::get<Tricycle>(s.vehicle.drive).wheelbase *= scale;
        s.vehicle.limits.curvature = 0.8 / scale;
      }
      const Answer answer = plan(s);
      const std::string said = answer.refused + answer.reason;
      EXPECT_EQ(answer.status == Status::solved, said.empty()) << scale << " " << said;
      if (scale >= 1.0 && scale <= 1e3) {
        EXPECT_EQ(answer.status, Status::solved) << scale << " " << said;
      }
    }
  }
}

TEST(DegenerateStation, SizesFromNothingToKilometresAreAnswered) { sizes_are_answered({1e-9, 1e-3, 1.0, 1e3}); }
TEST(DegenerateStation, SizesUpToTheWholeWorldAreAnsweredFull) { sizes_are_answered({8e4}); }

TEST(DegenerateStation, SliversOfVehiclesAndStations) {
  for (const Pose& place : everywhere) {
    Scenario thin = fixture::station(fixture::Id::d2, place);
    thin.vehicle.footprint.polygon = rectangle({-2.30, -5e-10}, {0.40, 5e-10});
    const Answer answer = plan(thin);
    EXPECT_EQ(answer.status, Status::solved) << answer.refused << answer.reason;

    Scenario point = fixture::station(fixture::Id::d2, place);
    point.vehicle.footprint = {{}, 0.0};
    EXPECT_EQ(plan(point).status, Status::solved);

    Scenario narrow = fixture::station(fixture::Id::d0, place);
    std::get<Station>(narrow.mission).area = transformed(rectangle({-1.5, -1.35}, {10.5, 1.35 + 1e-9}), Frame{place});
    const Answer none = plan(narrow);
    EXPECT_NE(none.status, Status::solved);
    EXPECT_GT(none.refused.size() + none.reason.size(), 10U);
  }
}

TEST(DegenerateStation, StartWhereTheVehicleDocks) {
  Scenario s = fixture::station(fixture::Id::d0);
  s.start = Problem::prepare(s).value().goal();
  const Answer answer = plan(s);
  EXPECT_TRUE(answer.status == Status::solved || answer.reason.size() > 10) << answer.reason;
  s.start.x += 1e-9;
  const Answer beside = plan(s);
  EXPECT_TRUE(beside.status == Status::solved || beside.reason.size() > 10) << beside.reason;
}

}  // namespace
}  // namespace waywright
