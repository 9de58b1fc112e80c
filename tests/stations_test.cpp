// Two hundred random docking stations: every plan that says `solved` is confirmed by verify from its own text and by brute force
// at a millimetre.
#include <gtest/gtest.h>

#include "tests/oracle/brute_force.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/study/generate.hpp"

namespace waywright {
namespace {

class Stations : public testing::TestWithParam<int> {};

TEST_P(Stations, SolvedMeansProvenAgainAndByBruteForce) {
  int solved = 0;
  constexpr int each = 25;
  for (int i = 0; i < each; ++i) {
    const auto seed = static_cast<std::uint64_t>(GetParam() * each + i + 1);
    const auto scenario = generate_station(seed);
    ASSERT_TRUE(scenario) << scenario.error().message();
    const Problem problem = Problem::prepare(*scenario).value();
    const auto plan = solve(problem);
    ASSERT_TRUE(plan);
    // A planner's path that the proof refuses is a fault of the planner.
    EXPECT_NE(plan->status, Status::unproven) << "seed " << seed << ": " << plan->reason;
    if (plan->status != Status::solved) {
      EXPECT_EQ(plan->status, Status::no_path) << "seed " << seed;
      EXPECT_FALSE(plan->reason.empty());
      continue;
    }
    ++solved;
    const auto read = parse_plan(plan_json(*plan), "plan.json");
    ASSERT_TRUE(read) << read.error().message();
    const auto verification = verify(*read);
    ASSERT_TRUE(verification);
    EXPECT_TRUE(verification->holds) << "seed " << seed << ": " << verification->findings.front();
    const auto& station = std::get<Station>(scenario->mission);
    const double truth = oracle_path_clearance(scenario->map, {station.area}, {station.shelf.outline()}, scenario->vehicle.footprint, plan->path, 0.001);
    EXPECT_GE(truth + 1e-9, plan->certificate.clearance + problem.pose_error_margin()) << "seed " << seed;
    EXPECT_GE(truth, scenario->clearance) << "seed " << seed;
  }
  EXPECT_GE(solved, each * 8 / 10);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Stations, testing::Range(0, 8));

}  // namespace
}  // namespace waywright
