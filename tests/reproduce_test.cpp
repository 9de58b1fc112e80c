// `waywright reproduce safe_astar`: the publication's experiments, and what is said of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "command_line.hpp"
#include "waywright/metrics/grid_metrics.hpp"
#include "waywright/study/reproduce_safe_astar.hpp"

namespace waywright {
namespace {

using namespace reproduction;

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = safe_astar(1, nullptr);
  return all;
}

TEST(Reproduce, HasEveryExperimentWithItsFigures) {
  ASSERT_EQ(experiments().size(), 9U);
  for (const Experiment& e : experiments()) {
    SCOPED_TRACE(e.name);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      SCOPED_TRACE(methods[m]);
      ASSERT_TRUE(e.ours[m].is_found) << e.ours[m].reason;
      ASSERT_TRUE(e.corrected[m].is_proven) << e.corrected[m].reason;
      ASSERT_EQ(e.ours[m].legs.size(), e.legs.size());
      for (std::size_t l = 0; l < e.legs.size(); ++l) {
        for (const Way* way : {&e.ours[m], &e.corrected[m]}) {
          EXPECT_LE(distance(way->legs[l].front(), e.legs[l].start), 1e-9);
          EXPECT_LE(distance(way->legs[l].back(), e.legs[l].goal), 1e-9);
        }
      }
      EXPECT_NEAR(e.ours[m].figures[power], residual_power(e.ours[m].figures[length], e.ours[m].figures[turning]), 1e-12);
    }
    // Past no corner and tested: never shorter than the shortest way past corners of the same moves.
    EXPECT_GE(e.corrected[0].figures[length], e.ours[0].figures[length] - 1e-9);
    EXPECT_LT(e.ours[own].figures[risk], 0.1 * e.ours[0].figures[risk]);
    // Danger in the cost leaves no more of it than danger in the expectation.
    EXPECT_LE(e.corrected[1].figures[risk], e.ours[1].figures[risk] + 1e-9);
  }
}

TEST(Reproduce, PrintedPercentagesFollowFromThePrintedFigures) {
  const Experiment& e = experiments().front();
  const auto reduction_from = [&](std::size_t metric, std::size_t method) { return reduction_of(metric, *e.published[method][metric], *e.published[own][metric]); };
  EXPECT_NEAR(reduction_from(length, 0), 2.89, 0.005);
  EXPECT_NEAR(reduction_from(length, 2), 17.21, 0.005);
  EXPECT_NEAR(reduction_from(search, 0), -32.03, 0.005);
  EXPECT_NEAR(reduction_from(power, 0), 27.49, 0.005);
}

/// The printed tables, which nothing else would show to be mistyped: sums of each table's rows, counted apart from this program, and what holds between rows.
TEST(Reproduce, HasThePrintedTablesAsTheyArePrinted) {
  const std::vector<std::array<double, 6>> sums{{1580.5473, 1012.6896, 5.268, 1698.7, 200.5379, 210.02},
                                                {1820.111, 2219.6732, 5.814, 1956.3136, 159.3738, 192.6},
                                                {802.1205, 257.8171, 5.785, 861.97, 38.2435, 313.68},
                                                {832.2653, 635.4387, 4.911, 894.37, 73.6622, 305.04},
                                                {858.0165, 786.2866, 6.283, 922.04, 66.0309, 303.67},
                                                {1032.2971, 0, 0, 0, 67.3507, 0},
                                                {1065.6495, 940.7604, 12.364, 1145.16, 39.7786, 286.68},
                                                {283.305, 319.0342, 0.44, 304.44, 38.1429, 365.58},
                                                {280.3508, 325.6087, 0.507, 301.28, 49.6193, 364.05}};
  ASSERT_EQ(experiments().size(), sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Experiment& e = experiments()[i];
    SCOPED_TRACE(e.name);
    for (std::size_t metric = 0; metric < metrics.size(); ++metric) {
      double sum = 0.0;
      for (const auto& of_method : e.published) sum += of_method[metric].value_or(0.0);
      EXPECT_NEAR(sum, sums[i][metric], 1e-9) << metrics[metric];
    }
    EXPECT_EQ(e.derived.empty(), e.map != "SA-IRR");
    if (!e.derived.empty()) continue;
    for (const auto& of_method : e.published) EXPECT_NEAR(*of_method[run] / *of_method[length], 1.0748, 1.5e-3);
  }
  const std::string table = text(experiments());
  EXPECT_NE(table.find("derived: the publication's Table 4 has no body"), std::string::npos);
  EXPECT_NE(csv(experiments()).find("SA-IRR,length m,derived,256.22"), std::string::npos);
  EXPECT_EQ(csv(experiments()).find("SA-IRR,length m,published"), std::string::npos);
}

TEST(Reproduce, TellsEveryTrendThatDoesNotHoldAndNoOther) {
  std::vector<Experiment> one{experiments()[3]};  // random obstacles 2: longer than the shortest, as the prototype's is
  const auto mentions = [&](const char* what) {
    const auto all = broken_trends(one);
    return std::any_of(all.begin(), all.end(), [&](const std::string& s) { return s.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(mentions("length m of SHA* against T_A*: 3.25 % less as printed, 0.32 % more here"));
  EXPECT_FALSE(mentions("length m of SHA* against S_A*"));
  one[0].ours[own].figures[length] = 150.0;
  EXPECT_FALSE(mentions("length m"));
}

TEST(Reproduce, WritesTableAndPicture) {
  const std::string table = csv(experiments());
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 9 * 6 * 3);
  EXPECT_NE(text(experiments()).find("9.4 warehouse: parking, goods at (21, 35), exit (SA-WH), two legs one after the other"), std::string::npos);
  const std::string picture = svg(experiments(), 900.0);
  EXPECT_EQ(picture.rfind("<svg", 0), 0U);
  for (const Experiment& e : experiments()) EXPECT_NE(picture.find(e.label), std::string::npos);
}

using ReproduceCommand = test::CommandLine;

TEST_F(ReproduceCommand, WritesItsThreeFilesOrSaysWhatIsWrong) {
  const auto done = run("reproduce safe_astar --runs 1 -o here");
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("9.1 convex tips (SA-CONVEX)"), std::string::npos);
  for (const char* name : {"safe_astar.txt", "safe_astar.csv", "safe_astar.svg"}) EXPECT_TRUE(std::filesystem::exists(folder_ / "here" / name)) << name;
  refused(run("reproduce moon_landing"), {"moon_landing", "safe_astar"});
  refused(run("reproduce safe_astar --runs 0"), {"--runs"});
}

}  // namespace
}  // namespace waywright
