// Many runs side by side: fair when cut short, and no figures where there are none.
#include "waywright/study/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <tuple>

#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/threads.hpp"
#include "waywright/study/merits.hpp"
#include "waywright/study/run_cost.hpp"
#include "waywright/study/short_names.hpp"
#include "waywright/study/summary.hpp"

namespace waywright {
namespace {

std::vector<Problem> problems() {
  std::vector<Problem> all;
  for (const char* name : {"dock_middle.json", "goal_pose.json"}) {
    all.push_back(
        Problem::prepare(read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name).value())
            .value());
  }
  return all;
}

const std::vector<Contestant> contestants{{"patterns", "pattern_docking", {}, {}},
                                          {"trees", "ompl_rrt_connect", {}, {}}};

TEST(OnThreads, AllJobsAreDoneByNoMoreThreadsThanThereAreJobs) {
  for (const unsigned wanted : {0U, 1U, 3U, 1024U}) {
    for (const std::size_t jobs : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
      std::atomic<std::size_t> next{0}, done{0}, workers{0};
      on_threads(wanted, jobs, [&] {
        ++workers;
        while (next.fetch_add(1) < jobs) ++done;
      });
      EXPECT_EQ(done.load(), jobs);
      EXPECT_GE(workers.load(), 1U);
      EXPECT_LE(workers.load(), std::max<std::size_t>(1, jobs));
    }
  }
}

TEST(Compare, WhatIsCutShortCanBeCompared) {
  std::atomic<bool> cancel{false};
  CompareOptions options;
  options.runs = 100;
  options.threads = 1;
  options.budget.evaluations = 200;
  options.cancel = &cancel;
  options.progress = [&](std::size_t done, std::size_t) {
    if (done == 9) cancel = true;
  };
  const auto runs = compare(problems(), contestants, options);
  ASSERT_EQ(runs.size(), 9U);
  std::vector<std::size_t> counts;
  for (const Summary& s : summarise(runs, 2, 2)) counts.push_back(s.solved.all);
  EXPECT_EQ(counts, (std::vector<std::size_t>{3, 2, 2, 2}));
  for (std::size_t i = 1; i < runs.size(); ++i) {  // by scenario, contestant and seed
    EXPECT_LT(std::tie(runs[i - 1].scenario, runs[i - 1].contestant, runs[i - 1].seed),
              std::tie(runs[i].scenario, runs[i].contestant, runs[i].seed));
  }
}

TEST(Compare, TheDefaultBudgetIsForWhoNamesNone) {
  std::vector<Problem> both = problems();
  Scenario own = both[0].scenario();
  own.budget.evaluations = 60;
  both[0] = Problem::prepare(own).value();
  CompareOptions options;
  options.default_evaluations = 90;
  const auto runs = compare(both, {contestants[0]}, options);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_LE(runs[0].plan.effort.evaluations, 60);
  EXPECT_LE(runs[1].plan.effort.evaluations, 90);
  EXPECT_GT(runs[1].plan.effort.evaluations, 60);
}

TEST(Compare, NoRunAndNoPathHaveNoFigures) {
  waywright::Run failed;
  failed.seed = 7;
  failed.plan.status = Status::no_path;
  failed.plan.reason = std::string(400, 'x') + " y";
  waywright::Run other = failed;
  other.seed = 8;
  other.plan.status = Status::timed_out;
  other.plan.reason = "too slow";
  const auto summaries = summarise({failed, other}, 1, 2);
  ASSERT_EQ(summaries.size(), 2U);
  EXPECT_EQ(summaries[0].paths, 0U);
  ASSERT_EQ(summaries[0].failures.size(), 2U);
  EXPECT_EQ(summaries[0].failures[0].seed, 7U);
  EXPECT_FALSE(summaries[0].all_alike);
  const std::string text = summary_text(summaries, {"s"}, contestants);
  EXPECT_EQ(text.find("0.000"), std::string::npos) << text;
  EXPECT_EQ(text.find(std::string(200, 'x')), std::string::npos) << text;
  EXPECT_EQ(text.find("0/0"), std::string::npos) << text;
  EXPECT_NE(text.find("patterns: 1 × timed_out: too slow"), std::string::npos) << text;
}

waywright::Run run_that_costs(std::size_t contestant, const std::string& planner, double cost, double weight, bool is_length = false) {
  waywright::Run run;
  run.contestant = contestant;
  run.plan.status = Status::solved;
  run.plan.planner = planner;
  if (!is_length) run.plan.parameters = {{"objective", std::string{"normalised"}}, {"length_weight", weight}, {"population", 20.0}};
  run.plan.samples.resize(2);
  run.plan.alternatives = {{"left side", false, 0.1, "", {}, {}}, {"right side", true, cost, "", {}, {}, is_length}};
  return run;
}

TEST(Compare, CostsAreToldWithTheirObjective) {
  const auto one = cost_of(run_that_costs(0, "pattern_docking", 0.8, 0.3).plan);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->objective, "docking, normalised, length_weight 0.3");
  EXPECT_EQ(one->cost, 0.8);
  const std::vector<waywright::Run> alike{run_that_costs(0, "pattern_docking", 0.8, 0.3), run_that_costs(0, "pattern_docking", 0.9, 0.3), run_that_costs(0, "pattern_docking", 0.7, 0.3),
                                          run_that_costs(1, "pattern_docking_published", 1.25, 0.3)};
  const auto summaries = summarise(alike, 1, 2);
  EXPECT_EQ(summaries[0].cost.median, 0.8);
  EXPECT_EQ(summaries[0].costs, 3U);
  const std::string text = summary_text(summaries, {"s"}, contestants);
  EXPECT_NE(text.find("0.8000"), std::string::npos) << text;
  EXPECT_NE(text.find("1.2500"), std::string::npos) << text;
  EXPECT_NE(text.find("  cost: by the planner's own objective (docking, normalised, length_weight 0.3)\n"), std::string::npos) << text;
  EXPECT_NE(runs_csv(alike, {"s"}, contestants).find(",0.8,\"docking, normalised, length_weight 0.3\",\"\"\n"), std::string::npos);
  // Another weight is another objective, and so is the length that a second choice is told by.
  for (const waywright::Run& other : {run_that_costs(1, "pattern_docking_published", 1.25, 0.4), run_that_costs(1, "ompl_rrt_connect", 12.5, 0.0, true)}) {
    const std::string apart = summary_text(summarise({alike[0], other}, 1, 2), {"s"}, contestants);
    EXPECT_NE(apart.find("only those of one objective can be compared"), std::string::npos) << apart;
    EXPECT_NE(apart.find("    " + cost_of(other.plan)->objective + ": "), std::string::npos) << apart;
  }
  waywright::Run silent = alike[0];
  silent.plan.alternatives.clear();
  EXPECT_FALSE(cost_of(silent.plan));
  EXPECT_EQ(summary_text(summarise({silent}, 1, 1), {"s"}, contestants).find("own objective"), std::string::npos);
}

// Medians, what is left in the battery, and percentages as the publication counts them, by hand.
TEST(Merits, ArePercentagesAgainstTheFirstWithAPath) {
  const auto run = [](std::size_t contestant, double length, double turning, double risk, double time) {
    waywright::Run r;
    r.contestant = contestant;
    r.plan.metrics.length = length;
    r.plan.metrics.turning = turning;
    r.plan.metrics.collision_risk = risk;
    r.plan.metrics.travel_time = time;
    r.plan.samples.resize(2);
    return r;
  };
  waywright::Run none;  // the first contestant found no path
  const std::vector<waywright::Run> runs{none, run(1, 100.0, pi, 4.0, 50.0), run(1, 300.0, pi, 4.0, 50.0), run(1, 200.0, pi, 4.0, 50.0), run(2, 150.0, 2.0 * pi, 1.0, 50.0)};
  const std::vector<Merits> merits = merits_of(runs, 1, 3);
  ASSERT_EQ(merits.size(), 2U);
  EXPECT_EQ(merits[0].contestant, 1U);
  EXPECT_NEAR(merits[0].length, 200.0, 1e-12);
  EXPECT_NEAR(merits[0].power, 100.0 - 20.0 - 0.5, 1e-9);  // 200 of 1000 m, π of 200π rad
  EXPECT_NEAR(merits[1].power, 100.0 - 15.0 - 1.0, 1e-9);
  const Reductions r = reductions(merits[0], merits[1]);
  EXPECT_NEAR(r.length, 25.0, 1e-9);
  EXPECT_NEAR(r.turning, -100.0, 1e-9);
  EXPECT_NEAR(r.risk, 75.0, 1e-9);
  EXPECT_NEAR(r.power, 100.0 * (20.5 - 16.0) / 20.5, 1e-9);
  EXPECT_NEAR(r.time, 0.0, 1e-9);
  const std::vector<std::string> names{"a", "b", "c"};
  const std::string text = merits_text(merits, 0, names);
  EXPECT_NE(text.find("less than b, %"), std::string::npos) << text;
  EXPECT_NE(text.find("+25.0"), std::string::npos) << text;
  EXPECT_NE(merits_svg(merits, 0, names, "x & y").find("x &amp; y"), std::string::npos);
  EXPECT_EQ(merits_text(merits, 1, names), "");
  EXPECT_EQ(merits_svg({merits[0]}, 0, names, "x"), "");
}

Contestant with(const std::string& planner, std::vector<std::string> settings) {
  Contestant c{planner, planner, {}, {}};
  for (const std::string& setting : settings) c.label += ":" + setting;
  c.settings = std::move(settings);
  return c;
}

TEST(ShortNames, WhatAllShareIsToldOnce) {
  const auto waypoint = [](std::vector<std::string> settings) { return with("waypoint_clothoid", std::move(settings)); };
  const ShortNames one = short_names({waypoint({"optimizer=de", "objective=mlpc"}), waypoint({"objective=metres", "optimizer=de"})});
  EXPECT_EQ(one.shared, "waypoint_clothoid with optimizer=de");
  EXPECT_EQ(one.names, (std::vector<std::string>{"objective=mlpc", "objective=metres"}));
  const ShortNames two = short_names({waypoint({"optimizer=de", "objective=mlpc"}), with("pattern_docking", {"optimizer=de"})});
  EXPECT_EQ(two.shared, "with optimizer=de");
  EXPECT_EQ(two.names, (std::vector<std::string>{"waypoint_clothoid:objective=mlpc", "pattern_docking"}));
  // Who cannot have it does not matter; who could and has not keeps it in the others' names.
  const Contestant outside{"exec:./mine", "", {}, "./mine"};
  const ShortNames three = short_names({waypoint({"objective=mlpc"}), waypoint({"objective=mlpc", "seed_runs=2"}), with("ompl_rrt_connect", {}), outside});
  EXPECT_EQ(three.shared, "with, where a planner has it, objective=mlpc");
  EXPECT_EQ(three.names, (std::vector<std::string>{"waypoint_clothoid", "waypoint_clothoid:seed_runs=2", "ompl_rrt_connect", "exec:./mine"}));
  const ShortNames four = short_names({waypoint({"objective=mlpc"}), waypoint({"objective=mlpc", "optimizer=de"}), waypoint({})});
  EXPECT_EQ(four.shared, "");
  EXPECT_EQ(four.names[1], "waypoint_clothoid:objective=mlpc:optimizer=de");
  EXPECT_EQ(short_names({waypoint({"objective=mlpc"})}).names, (std::vector<std::string>{"waypoint_clothoid:objective=mlpc"}));
  // In another order they are the same, and are told apart by their labels.
  EXPECT_EQ(short_names({waypoint({"objective=mlpc", "optimizer=de"}), waypoint({"optimizer=de", "objective=mlpc"})}).shared, "");
}

}  // namespace
}  // namespace waywright
