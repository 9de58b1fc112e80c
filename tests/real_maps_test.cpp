// Every planner on maps that others made, between places drawn in their free space: what is called solved is proven by verify, what is not has its reason, no path is
// shorter than the bound, and who searches a whole graph finds the way that is there. Run as a whole, `real_maps_test --gtest_filter='*Full*'` ends with the tables of
// docs/maps.md.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "tests/real_maps.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {
namespace {

using test::RealMap;

constexpr double clearance = 0.03;          // m
constexpr double seconds = 15.0;            // of a plan
constexpr double unasked = 40.0;            // s: preparation and proof, which the budget does not limit, on a busy machine
constexpr std::uint64_t seed = 1;

/// Work where the default is for smaller maps, or for one plan that somebody waits for; seconds end what takes too long with it.
const std::map<std::string, Parameters> work{
    {"ompl_rrt_star", {{"checks", 40'000.0}}}, {"ompl_informed_rrt_star", {{"checks", 40'000.0}}}, {"ompl_bit_star", {{"checks", 10'000.0}}},       {"ompl_ait_star", {{"checks", 3'000.0}}},
    {"rrt", {{"iterations", 20'000.0}}},       {"rrt_star", {{"iterations", 20'000.0}}},           {"rrt_star_woa_global", {{"iterations", 20'000.0}}}, {"prm", {{"samples", 3'000.0}}},
    {"capso_spline", {{"evaluations", 3'000.0}}}};

/// They search all of a graph that covers the free space, so that they find a way wherever one with some room is there.
const std::set<std::string> complete_ones{"astar", "dijkstra", "theta_star", "danger_astar", "visibility_graph", "voronoi"};
/// Their sentences when a map is larger than they take.
const std::vector<std::string> limits{"corners", "edges"};
/// As printed in a publication, their paths may fail the proof, and the plan says so.
const std::set<std::string> unproven_ones{"pattern_docking_published"};

struct Cell {
  int solved = 0, runs = 0;
  std::vector<double> times;  // s, of the solved ones
};
using Table = std::map<std::string, std::map<std::string, Cell>>;  // map, planner
Table& table() {
  static Table all;
  return all;
}

double since(std::chrono::steady_clock::time_point begin) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); }

Scenario scenario_on(const RealMap& map, const std::filesystem::path& data) {
  const std::string text = R"({"format": "waywright-scenario/1", "map": )" + map.object + R"(, "vehicle": {"footprint": {"disc": 0.1}, "drive": {"type": "differential", "track": 0.1}}, "start": [0, 0, 0], "goal": [1, 1, 0], "clearance": )" +
                           std::to_string(clearance) + "}";
  return parse_scenario(text, map.name, data).value();
}

LeastLength bound_of(const Problem& problem) {
  const PlaneSpace space{problem};
  BudgetLimits limits_of_it;
  limits_of_it.seconds = seconds;
  Budget budget{limits_of_it};
  return least_length(space, budget);
}

void run_planners(const RealMap& map, const std::filesystem::path& data, std::size_t pairs, const std::vector<std::string>& wanted) {
  const Scenario on_map = scenario_on(map, data);
  const World unbuilt{on_map.map};
  World world = unbuilt;
  world.build();
  for (const Vehicle& vehicle : test::map_vehicles()) {
    const std::vector<test::Ends> drawn = test::drawn_ends(world, vehicle, clearance, pairs, seed);
    // Some maps are for smaller robots than the larger ones of these.
    if (vehicle.footprint.is_disc()) EXPECT_EQ(drawn.size(), pairs) << map.name;
    else if (drawn.size() < pairs) std::printf("%s: the %s has room for %zu of %zu pairs of places\n", map.name.c_str(), vehicle.name.c_str(), drawn.size(), pairs);
    for (const test::Ends& ends : drawn) {
      Scenario scenario = on_map;
      scenario.vehicle = vehicle;
      scenario.start = ends.start;
      scenario.mission = ends.goal;
      scenario.budget.seconds = seconds;
      const Problem base = Problem::prepare(scenario, &unbuilt).value();
      const LeastLength least = bound_of(base);
      EXPECT_FALSE(least.is_unreachable) << map.name << " " << vehicle.name;
      for (const PlannerDescription& planner : planners()) {
        if (planner.turns_on_the_spot && !vehicle.can_turn_on_the_spot()) continue;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), planner.name) == wanted.end()) continue;
        scenario.planner = {planner.name, work.contains(planner.name) ? work.at(planner.name) : Parameters{}};
        const std::string what = map.name + ", " + planner.name + ", " + vehicle.name + " from " + std::to_string(ends.start.x) + ", " + std::to_string(ends.start.y);
        const auto begin = std::chrono::steady_clock::now();
        const auto plan = solve(Problem::prepare(scenario, &unbuilt).value());
        const double took = since(begin);
        ASSERT_TRUE(plan) << what << ": " << plan.error().message();
        Cell& cell = table()[map.name][planner.name];
        ++cell.runs;
        EXPECT_LT(took, seconds + unasked) << what;
        if (plan->status == Status::solved) {
          ++cell.solved;
          cell.times.push_back(took);
          EXPECT_GE(plan->metrics.length, least.metres - 1e-6) << what;
          const auto verification = verify(*plan);
          ASSERT_TRUE(verification) << what;
          EXPECT_TRUE(verification->holds) << what << ": " << verification->findings.front();
          if (planner.name == "visibility_graph" && vehicle.footprint.is_disc() && !least.is_straight) {
            EXPECT_LE(plan->metrics.length, (least.is_partial ? 1.03 : 1.01) * least.metres + 0.05) << what;  // a bound of a search in part is lower, by 3 % at most on these maps
          }
          continue;
        }
        EXPECT_FALSE(plan->reason.empty()) << what;
        EXPECT_TRUE(plan->status == Status::no_path || plan->status == Status::timed_out || (plan->status == Status::unproven && unproven_ones.contains(planner.name)))
            << what << ": " << to_string(plan->status) << ", " << plan->reason;
        const bool is_too_large = std::any_of(limits.begin(), limits.end(), [&](const std::string& word) { return plan->reason.find(word) != std::string::npos; });
        EXPECT_TRUE(!complete_ones.contains(planner.name) || plan->status == Status::timed_out || is_too_large) << what << ": " << plan->reason;
      }
    }
  }
}

/// Whom the environment names, parted by commas, to measure them alone; without it all.
std::vector<std::string> planners_named() {
  std::vector<std::string> names;
  const char* all = std::getenv("WAYWRIGHT_TEST_PLANNERS");
  std::stringstream text{all == nullptr ? "" : all};
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

/// In columns of maps, rows of planners: solved of asked, and the median time of the solved ones.
void print_tables() {
  std::vector<std::string> maps;
  for (const RealMap& map : test::real_maps()) {
    if (table().contains(map.name)) maps.push_back(map.name);
  }
  if (maps.empty()) return;
  constexpr std::size_t columns = 6;
  for (std::size_t first = 0; first < maps.size(); first += columns) {
    const std::size_t end = std::min(maps.size(), first + columns);
    std::printf("\n| planner |");
    for (std::size_t i = first; i < end; ++i) std::printf(" %s |", maps[i].c_str());
    std::printf("\n| --- |");
    for (std::size_t i = first; i < end; ++i) std::printf(" --- |");
    for (const PlannerDescription& planner : planners()) {
      if (const auto named = planners_named(); !named.empty() && std::find(named.begin(), named.end(), planner.name) == named.end()) continue;
      std::printf("\n| `%s` |", planner.name.c_str());
      for (std::size_t i = first; i < end; ++i) {
        Cell& cell = table()[maps[i]][planner.name];
        std::sort(cell.times.begin(), cell.times.end());
        if (cell.runs == 0) std::printf(" – |");
        else if (cell.solved == 0) std::printf(" 0/%d |", cell.runs);
        else std::printf(" %d/%d, %.2g s |", cell.solved, cell.runs, cell.times[cell.times.size() / 2]);
      }
    }
    std::printf("\n");
  }
}

struct Printing : testing::Environment {
  void TearDown() override { print_tables(); }
};
const testing::Environment* const printing = testing::AddGlobalTestEnvironment(new Printing);  // gtest deletes it

class RealMapsFull : public testing::TestWithParam<RealMap> {};

TEST_P(RealMapsFull, EveryPlannerIsProvenOrSaysWhyNot) {
  const RealMap& map = GetParam();
  const auto data = test::outside_data();
  if (!map.file.empty() && (!data || !std::filesystem::exists(*data / map.file))) GTEST_SKIP() << "no outside data: " << map.file << " (WAYWRIGHT_TEST_DATA)";
  run_planners(map, data.value_or("."), 2, planners_named());
}

INSTANTIATE_TEST_SUITE_P(Maps, RealMapsFull, testing::ValuesIn(test::real_maps()), [](const auto& map) { return map.param.name; });

/// A sample of them for every day: small maps of each kind, whoever is quick there.
class RealMapsSample : public testing::TestWithParam<std::string> {};

TEST_P(RealMapsSample, QuickPlannersAreProvenOrSayWhyNot) {
  const auto& all = test::real_maps();
  const RealMap& map = *std::find_if(all.begin(), all.end(), [](const RealMap& m) { return m.name == GetParam(); });
  const auto data = test::outside_data();
  if (!map.file.empty() && (!data || !std::filesystem::exists(*data / map.file))) GTEST_SKIP() << "no outside data: " << map.file << " (WAYWRIGHT_TEST_DATA)";
  run_planners(map, data.value_or("."), 1, {"astar", "theta_star", "danger_astar", "safe_astar", "visibility_graph", "voronoi", "prm", "rrt_star", "ompl_rrt_connect", "ompl_prm_star", "ga_bspline"});
}

INSTANTIATE_TEST_SUITE_P(Maps, RealMapsSample, testing::Values("WOA_2", "WOA_5", "nav2_depot", "ipa_factory", "opentcs_demo", "rmf_office", "bench_parking1", "bench_intel_lab", "movingai_arena"),
                         [](const auto& map) { return map.param; });

}  // namespace
}  // namespace waywright
