// The command line as a user meets it: files, standard streams, exit statuses.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/command_line.hpp"
#include "waywright/dxf/test_drawing.hpp"

namespace {

using namespace waywright::test;
namespace test = waywright::test;

TEST_F(CommandLine, EveryExamplePlansAndVerifies) {
  for (const auto& entry : fs::directory_iterator{example("")}) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json") continue;
    const bool impossible = name == "dock_impossible.json";
    const Outcome planned = run("plan " + entry.path().string() + " -o " + name + ".out");
    EXPECT_EQ(planned.status, impossible ? 1 : 0) << name << planned.err;
    for (const char* file : {"plan.json", "plan.svg", "report.html"}) EXPECT_TRUE(fs::exists(folder_ / (name + ".out") / file)) << name;
    const Json plan = Json::parse(slurp(folder_ / (name + ".out") / "plan.json"));
    EXPECT_EQ(plan["status"], impossible ? "no_path" : "solved");
    EXPECT_EQ(run("verify " + name + ".out/plan.json").status, impossible ? 1 : 0) << name;
  }
}

TEST_F(CommandLine, WithoutArgumentsPlansTheBundledExampleAndNamesItsFiles) {
  const Outcome o = run("");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("plan.svg"), std::string::npos);
  EXPECT_NE(o.out.find("report.html"), std::string::npos);
}

TEST_F(CommandLine, JsonIsAloneOnStandardOutputAndReproducible) {
  auto timeless = [](const std::string& text) {
    Json j = Json::parse(text);
    j.erase("timing");
    return j.dump();
  };
  const Outcome a = run("plan " + example("dock_cluttered.json") + " --json");
  const Outcome b = run("plan " + example("dock_cluttered.json") + " --json");
  EXPECT_EQ(a.status, 0);
  EXPECT_TRUE(a.err.empty()) << a.err;
  EXPECT_EQ(timeless(a.out), timeless(b.out));
  EXPECT_FALSE(fs::exists(folder_ / "waywright-out"));
}

TEST_F(CommandLine, ProcessorsWithoutFusedMultiplyAddGiveTheSameBits) {
  // The C library is told to act as on a processor without it; its own sine then differs in the last bit.
  const auto plan = [&](const std::string& name) {
    Json j = Json::parse(run("plan " + example(name) + " --json").out);
    j.erase("timing");
    return j.dump();
  };
  for (const char* name : {"dock_middle.json", "dock_cluttered.json", "dock_rotated.json", "dock_warehouse.json"}) {
    const std::string here = plan(name);
    ::setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F", 1);
    EXPECT_EQ(plan(name), here) << name;
    ::unsetenv("GLIBC_TUNABLES");
  }
}

TEST_F(CommandLine, PlanFileKeepsItsContract) {
  ASSERT_EQ(run("plan " + example("dock_middle.json") + " -o o --seed 7 --set evaluations=300").status, 0);
  const Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  EXPECT_EQ(plan["format"], "waywright-plan/1");
  EXPECT_EQ(plan["seed"], 7);
  EXPECT_EQ(plan["planner"]["parameters"]["evaluations"], 300);
  EXPECT_EQ(plan["scenario"]["planner"]["evaluations"], 300);
  EXPECT_TRUE(plan["reason"].is_null());
  const Json& s = plan["path"]["samples"];
  const std::size_t n = s["s"].size();
  for (const char* column : {"x", "y", "heading", "course", "curvature", "direction", "t", "speed"}) ASSERT_EQ(s[column].size(), n) << column;
  EXPECT_NEAR(s["x"][0].get<double>(), 9.5, 1e-9);
  EXPECT_NEAR(s["x"][n - 1].get<double>(), 2.0, 1e-9);
  for (std::size_t i = 1; i < n; ++i) {
    const double dx = s["x"][i].get<double>() - s["x"][i - 1].get<double>();
    const double dy = s["y"][i].get<double>() - s["y"][i - 1].get<double>();
    EXPECT_LE(std::hypot(dx, dy), 0.05 + 1e-9);
    EXPECT_GE(s["t"][i].get<double>(), s["t"][i - 1].get<double>());
    if (s["direction"][i] != s["direction"][i - 1]) {
      EXPECT_EQ(s["s"][i], s["s"][i - 1]);
      EXPECT_EQ(s["speed"][i], 0.0);
    }
  }
  for (const char* metric : {"length", "min_clearance", "mean_clearance", "max_curvature", "max_curvature_rate", "curvature_change", "turning",
                             "direction_changes", "collision_risk", "travel_time", "curvature_change_printed"}) {
    EXPECT_TRUE(plan["metrics"].contains(metric)) << metric;
  }
  EXPECT_TRUE(plan["certificate"]["collision_free"].get<bool>());
  EXPECT_GE(plan["certificate"]["clearance"].get<double>(), 0.05);
}

TEST_F(CommandLine, VerifyFindsWhatWasTamperedWith) {
  ASSERT_EQ(run("plan " + example("dock_middle.json") + " -o o").status, 0);
  const Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  const auto verdict = [&](auto change) {
    Json j = plan;
    change(j);
    std::ofstream{folder_ / "t.json"} << j.dump();
    return run("verify t.json");
  };
  EXPECT_EQ(verdict([](Json&) {}).status, 0);
  EXPECT_EQ(verdict([](Json& j) { j["certificate"]["clearance"] = 0.5; }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["samples"]["x"][50] = 3.0; }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["samples"]["speed"][50] = 9.0; }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["pieces"][0]["spans"][0][2][1] = 6.0; }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["metrics"]["length"] = 3.0; }).status, 1);
  for (const char* status : {"unproven", "no_path", "start_in_collision"}) EXPECT_EQ(verdict([&](Json& j) { j["status"] = status; }).status, 1) << status;
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["clearance"] = 0.095; }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["map"]["polygons"]["obstacles"].push_back({{5, 3}, {6, 3}, {6, 4}}); }).status, 1);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["pieces"][0]["kind"] = "loop"; }).status, 2);
  EXPECT_EQ(verdict([](Json& j) { j.erase("scenario"); }).status, 2);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["samples"]["x"].erase(3); }).status, 2);
}

TEST_F(CommandLine, ASettingIsGivenOnce) {
  const std::string waypoints = example("waypoints_low.json");
  for (const std::string& command : {"plan " + waypoints, "pareto " + waypoints, "compare " + waypoints, "check " + waypoints}) {
    const Outcome twice = run(command + " --set margin=0.02 --set margin=0.03 -o twice");
    EXPECT_EQ(twice.status, 2) << command;
    EXPECT_NE(twice.err.find("--set margin: it is given twice (allowed: each KEY once)"), std::string::npos) << twice.err;
    EXPECT_FALSE(fs::exists(folder_ / "twice"));
  }
  const Outcome same = run("compare " + waypoints + " --set objective=metres,metres -o twice");
  EXPECT_EQ(same.status, 2);
  EXPECT_NE(same.err.find("\"metres\" is named twice"), std::string::npos) << same.err;
}

TEST_F(CommandLine, ReplanTakesOverWhileAPlanIsDriven) {
  ASSERT_EQ(run("plan " + example("dock_middle.json") + " -o o").status, 0);
  const Outcome on = run("replan o/plan.json --at 4 --shelf 0.91,7.02,0.01 -o r");
  EXPECT_EQ(on.status, 0) << on.out << on.err;
  EXPECT_NE(on.out.find("carried along"), std::string::npos) << on.out;
  EXPECT_EQ(run("verify r/plan.json").status, 0);
  const Json old = Json::parse(slurp(folder_ / "o/plan.json")), next = Json::parse(slurp(folder_ / "r/plan.json"));
  EXPECT_EQ(next["scenario"]["station"]["shelf"]["center"], Json::array({0.91, 7.02}));
  EXPECT_LT(next["scenario"]["start"]["speed"], -0.5);
  EXPECT_NEAR(next["path"]["samples"]["speed"][0].get<double>(), -next["scenario"]["start"]["speed"].get<double>(), 1e-3);
  EXPECT_LT(next["metrics"]["length"], old["metrics"]["length"]);
  // Again from there, and from beside the path; too late for a curve it stops, backs off and docks again, or says why not.
  EXPECT_EQ(run("replan r/plan.json --at 1 -o rr").status, 0);
  const Json pose = next["scenario"]["start"]["pose"];
  EXPECT_EQ(run("replan o/plan.json --at 4 --pose " + std::to_string(pose[0].get<double>()) + "," + std::to_string(pose[1].get<double>() + 0.01) + "," +
                std::to_string(pose[2].get<double>()) + " -o side")
                .status,
            0);
  const Outcome late = run("replan o/plan.json --at 13 --shelf 0.9,7.04,0.02 -o late");
  EXPECT_NE(late.out.find("planned anew"), std::string::npos) << late.out;
  EXPECT_EQ(late.status, Json::parse(slurp(folder_ / "late/plan.json"))["status"] == "solved" ? 0 : 1);
  const Outcome json = run("replan o/plan.json --at 0 --json");
  EXPECT_EQ(Json::parse(json.out)["status"], "solved");

  refused(run("replan o/plan.json --at 400"), {"--at", "within the plan's time"});
  refused(run("replan o/plan.json --at nan"), {"--at"});
  refused(run("replan o/plan.json --at 1 --shelf 1,2"), {"--shelf", "1,2", "X,Y,HEADING"});
  refused(run("replan o/plan.json --at 1 --goal 1,2,3"), {"--goal", "station"});
  refused(run("replan o/plan.json --at 1 --shelf 90,7,0"), {"--shelf", "outside the station"});
  refused(run("replan missing.json --at 1"), {"missing.json"});
  Json broken = old;
  broken["scenario"]["clearance"] = 0.095;
  std::ofstream{folder_ / "broken.json"} << broken.dump();
  refused(run("replan broken.json --at 1"), {"broken.json", "path", "not proven"});
}

TEST_F(CommandLine, ReplanAmongWhatHasAppeared) {
  ASSERT_EQ(run("plan " + example("rrt_woa/wheelchair_2.json") + " --planner visibility_graph -o o").status, 0);
  const Outcome box = run("replan o/plan.json --after 8 --obstacles " + example("obstacles/box.json") + " -o b");
  EXPECT_EQ(box.status, 0) << box.out << box.err;
  EXPECT_NE(box.out.find("8.00 m of the old plan"), std::string::npos) << box.out;
  EXPECT_NE(box.out.find("1 new obstacle that stands still"), std::string::npos) << box.out;
  EXPECT_EQ(run("verify b/plan.json").status, 0);
  EXPECT_NE(slurp(folder_ / "b/plan.svg").find("new obstacle"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "b/report.html").find("driven already"), std::string::npos);
  // From there again, what moves this time; its plan has the box on its map, still.
  const Outcome person = run("replan b/plan.json --at 1 --obstacles " + example("obstacles/person.json") + " -o p");
  EXPECT_EQ(person.status, 0) << person.out << person.err;
  EXPECT_NE(person.out.find("is kept as it is"), std::string::npos) << person.out;
  EXPECT_NE(person.out.find("Proven in time"), std::string::npos) << person.out;
  EXPECT_EQ(run("verify p/plan.json").status, 0);
  const Json plan = Json::parse(slurp(folder_ / "p/plan.json"));
  EXPECT_EQ(plan["scenario"]["map"]["polygons"]["obstacles"].size(), 7U);
  EXPECT_EQ(Json::parse(run("replan o/plan.json --at 0 --json --obstacles " + example("obstacles/box.json")).out)["status"], "solved");

  // As the docs have it: it stops for somebody who crosses.
  ASSERT_EQ(run("plan " + example("rrt_woa/wheelchair_2.json") + " --planner rrt_star -o old").status, 0);
  const Outcome crossing = run("replan old/plan.json --after 8 --obstacles " + example("obstacles/person.json") + " -o new");
  EXPECT_EQ(crossing.status, 0) << crossing.err;
  EXPECT_NE(crossing.out.find("the vehicle stops for person, which comes into its way"), std::string::npos) << crossing.out;

  const std::string with_box = " --obstacles " + example("obstacles/box.json");
  refused(run("replan o/plan.json" + with_box), {"--at", "--after"});
  refused(run("replan o/plan.json --at 1 --after 1" + with_box), {"--after", "one of the two"});
  refused(run("replan o/plan.json --after 400" + with_box), {"--after", "within the plan's length"});
  refused(run("replan o/plan.json --after x" + with_box), {"--after", "x"});
  refused(run("replan o/plan.json --at 1 --goal 1,2,3" + with_box), {"--goal", "--obstacles"});
  refused(run("replan o/plan.json --at 1 --obstacles missing.json"), {"missing.json"});
  // What lies off the map by far is asked about.
  std::ofstream{folder_ / "far.json"} << R"({"format": "waywright-obstacles/1", "obstacles": [[[11.5, 11.5], [13, 11.5], [13, 13]], [[800, 800], [801, 800], [801, 801]]], "points": [[-500, 3]]})";
  const Outcome far = run("replan o/plan.json --at 1 --obstacles far.json -o far");
  EXPECT_NE(far.err.find("new obstacle 2 at (800.50, 800.50) lies off the map"), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("of the new points 1"), std::string::npos) << far.err;
  EXPECT_EQ(far.err.find("new obstacle 1"), std::string::npos) << far.err;
  // One that stands on the way: what of the old one is kept, and what that costs.
  const Outcome pallet = run("replan o/plan.json --after 8 --obstacles " + example("obstacles/pallet.json") + " -o c");
  EXPECT_EQ(pallet.status, 0) << pallet.out << pallet.err;
  EXPECT_NE(pallet.out.find("blocked by new obstacle 1"), std::string::npos) << pallet.out;
  EXPECT_NE(pallet.out.find("It leaves the old way after "), std::string::npos) << pallet.out;
  std::ofstream{folder_ / "empty.json"} << R"({"format": "waywright-obstacles/1"})";
  refused(run("replan o/plan.json --at 1 --obstacles empty.json"), {"empty.json", "no obstacle"});
}

TEST_F(CommandLine, ThePlanOfTheMovingHallWaits) {
  const Outcome o = run("plan " + example("moving_hall.json") + " -o o");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("the vehicle stops for"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("tugger stays in the way"), std::string::npos) << o.out;
  EXPECT_NE(slurp(folder_ / "o/plan.svg").find("waits"), std::string::npos);
  EXPECT_EQ(run("verify o/plan.json").status, 0);
  EXPECT_EQ(run("controls o/plan.json -o c").status, 0);
  Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  plan["scenario"]["moving"][0]["track"] = {{0, 8, 0.5}, {25, 8, 7.4}};
  std::ofstream{folder_ / "slower.json"} << plan.dump();
  const Outcome slower = run("verify slower.json");
  EXPECT_EQ(slower.status, 1) << slower.out;
  EXPECT_NE(slower.out.find("person"), std::string::npos) << slower.out;
}

TEST_F(CommandLine, AMovingStartIsPlannedFrom) {
  Json moving = scenario();
  moving["start"] = {{"pose", {9.5, 7.0, 0.0}}, {"speed", -0.8}, {"curvature", 0.2}};
  ASSERT_EQ(run("plan " + write(moving) + " -o o").status, 0);
  EXPECT_EQ(run("verify o/plan.json").status, 0);
  EXPECT_NE(slurp(folder_ / "o/report.html").find("moving backwards at 0.80 m/s"), std::string::npos);
  Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  EXPECT_EQ(plan["scenario"]["start"], moving["start"]);
  // What the file says of the beginning is not believed.
  const auto verdict = [&](auto change) {
    Json j = plan;
    change(j);
    std::ofstream{folder_ / "t.json"} << j.dump();
    return run("verify t.json").status;
  };
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["start"]["speed"] = 0.8; }), 1);
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["start"]["speed"] = -0.7; }), 1);
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["start"]["curvature"] = 0.1; }), 1);
  EXPECT_EQ(verdict([](Json& j) { j["scenario"]["start"] = j["scenario"]["start"]["pose"]; }), 1);
  EXPECT_EQ(verdict([](Json& j) { j["path"]["samples"]["speed"][0] = 0.0; }), 1);
  moving["start"]["speed"] = 30.0;
  refused(run("plan " + write(moving)), {"start.speed", "limit"});
}

TEST_F(CommandLine, ImportJudgesAnyonesPoses) {
  ASSERT_EQ(run("plan " + example("dock_middle.json") + " -o o").status, 0);
  const Json s = Json::parse(slurp(folder_ / "o/plan.json"))["path"]["samples"];
  std::ofstream csv{folder_ / "p.csv"};
  csv << "x,y,heading,direction\n";
  csv.precision(5);
  for (std::size_t i = 0; i < s["x"].size(); ++i) csv << s["x"][i] << ',' << s["y"][i] << ',' << s["heading"][i] << ',' << s["direction"][i] << '\n';
  csv.close();
  const Outcome good = run("import p.csv --scenario " + example("dock_middle.json") + " -o i");
  EXPECT_EQ(good.status, 0) << good.out << good.err;
  EXPECT_EQ(run("verify i/plan.json").status, 0);
  // The scenario in it is the user's, and can be planned again.
  const Json imported = Json::parse(slurp(folder_ / "i/plan.json"));
  EXPECT_EQ(imported["planner"]["name"], "import");
  EXPECT_EQ(imported["scenario"]["planner"]["name"], "pattern_docking");
  std::ofstream{folder_ / "again.json"} << imported["scenario"].dump();
  EXPECT_EQ(run("plan again.json -o again").status, 0);
  EXPECT_NE(good.out.find("Proven along the whole motion"), std::string::npos) << good.out;
  // Among what moves: where it waits is said, as of a plan.
  ASSERT_EQ(run("plan " + example("moving_hall.json") + " -o h").status, 0);
  Json crossing = Json::parse(slurp(folder_ / "h/plan.json"))["scenario"];
  crossing["moving"].erase(1);
  std::ofstream{folder_ / "crossing.json"} << crossing.dump();
  ASSERT_EQ(run("plan crossing.json -o h").status, 0);
  const Json driven = Json::parse(slurp(folder_ / "h/plan.json"))["path"]["samples"];
  std::ofstream across{folder_ / "h.csv"};
  across << "x,y,heading,direction\n";
  across.precision(9);
  for (std::size_t i = 0; i < driven["x"].size(); ++i) across << driven["x"][i] << ',' << driven["y"][i] << ',' << driven["heading"][i] << ',' << driven["direction"][i] << '\n';
  across.close();
  const Outcome waits = run("import h.csv --scenario crossing.json -o w");
  EXPECT_EQ(waits.status, 0) << waits.out << waits.err;
  EXPECT_NE(waits.out.find("the vehicle stops for person"), std::string::npos) << waits.out;
  EXPECT_NE(waits.out.find("Proven in time"), std::string::npos) << waits.out;
  std::ofstream{folder_ / "bad.csv"} << "x,y,heading\n9.5,7,0\n2,7,3.14159265\n";
  EXPECT_EQ(run("import bad.csv --scenario " + example("dock_middle.json") + " -o b").status, 1);
  std::ofstream{folder_ / "broken.csv"} << "x,y,heading\n9.5,seven,0\n2,7,3.1\n";
  refused(run("import broken.csv --scenario " + example("dock_middle.json")), {"broken.csv", "line 2"});
}

TEST_F(CommandLine, CompareWritesTableAndPicture) {
  const Outcome o = run("compare " + example("dock_middle.json") + " --runs 2 --planners pattern_docking,ompl_rrt_connect -o c");
  EXPECT_EQ(o.status, 0) << o.err;
  const std::string csv = slurp(folder_ / "c/compare.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  // The deterministic planner's runs count as one; the other's are several.
  EXPECT_NE(o.out.find("2/2 all alike"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("pattern_docking: its 2 runs are the same to the last bit"), std::string::npos);
  EXPECT_NE(o.out.find("2/2 0.34–1.00"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "c/compare.svg").find(", the shortest of 2 runs"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder_ / "c/compare.svg"));
  refused(run("compare " + example("dock_middle.json") + " --planners nobody"), {"nobody", "pattern_docking"});
  refused(run("compare " + example("dock_middle.json") + " --planners ,"), {"--planners", "pattern_docking"});
  refused(run("compare " + example("dock_middle.json") + " --planners pattern_docking,pattern_docking"), {"twice"});
  refused(run("compare --suite movingai folder"), {"--suite", "not supported yet"});
  refused(run("compare"), {"SCENARIO"});
}

TEST_F(CommandLine, CompareGivesAllOneBudget) {
  const auto evaluations = [&](const std::string& more) {
    EXPECT_EQ(run("compare " + example("dock_middle.json") + " --planners pattern_docking,pattern_docking_published " + more + " -o c").status, 0);
    std::istringstream csv{slurp(folder_ / "c/compare.csv")};
    std::vector<long> found;
    std::string line;
    std::getline(csv, line);
    while (std::getline(csv, line)) {
      const std::size_t at = line.find(",1,") + 3;  // after the seed
      found.push_back(std::stol(line.substr(line.find(',', at) + 1)));
    }
    return found;
  };
  const auto common = evaluations("");
  ASSERT_EQ(common.size(), 2U);
  for (const long e : common) EXPECT_LE(e, 2000);
  EXPECT_GT(common[1], 600);  // over its own 300 a side
  for (const long e : evaluations("--evaluations 200")) EXPECT_LE(e, 200);
  EXPECT_GT(evaluations("--set evaluations=1500")[1], 2000);  // named for them: 1500 a side
  refused(run("compare " + example("dock_middle.json") + " --set evaluations=100 --evaluations 200"), {"--evaluations", "one of the two"});
}

TEST_F(CommandLine, CompareRunsAnOutsidePlanner) {
  std::ofstream{folder_ / "p.csv"} << "x,y,heading\n9.5,7,0\n9,7,0\n";
  const Outcome o = run("compare " + example("dock_middle.json") + " --planners 'exec:cat >/dev/null; cat p.csv' -o c");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(slurp(folder_ / "c/compare.csv").find("unproven"), std::string::npos);
  // Commas part planners, outside ones too; one in a command is written with a backslash.
  const Outcome several = run("compare " + example("dock_middle.json") + " --planners 'exec:exit 3,pattern_docking,exec:cat >/dev/null; printf \"x\\,y\\,heading\\n9.5\\,7\\,0\\n9\\,7\\,0\\n\"' -o c");
  EXPECT_EQ(several.status, 0) << several.err;
  const std::string csv = slurp(folder_ / "c/compare.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4) << csv;
  EXPECT_NE(csv.find("\"exec:exit 3\""), std::string::npos);
  // What found nothing has no figures, and its reason stands below.
  EXPECT_NE(several.out.find("exec:exit 3: 1 × no_path: the outside planner ended with status 3"), std::string::npos) << several.out;
  const std::string row = several.out.substr(several.out.find("exec:exit 3"), several.out.find('\n', several.out.find("exec:exit 3")) - several.out.find("exec:exit 3"));
  EXPECT_EQ(row.find("0.000"), std::string::npos) << row;
  EXPECT_NE(row.find("–"), std::string::npos) << row;
  const Outcome failing = run("compare " + example("dock_middle.json") + " --planners 'exec:exit 3' -o c");
  EXPECT_NE(slurp(folder_ / "c/compare.csv").find("ended with status 3"), std::string::npos) << failing.err;
}

TEST_F(CommandLine, ListMapAndGenerate) {
  EXPECT_NE(run("list planners").out.find("pattern_docking"), std::string::npos);
  EXPECT_NE(run("list pattern_docking").out.find("heading_range"), std::string::npos);
  for (const char* zone : {"forbidden", "directed", "preferred", "penalty", "speed_limit"}) EXPECT_NE(run("list zones").out.find(zone), std::string::npos) << zone;
  EXPECT_EQ(run("list").status, 0);
  refused(run("list nonsense"), {"nonsense", "planners"});
  EXPECT_NE(run("map " + example("warehouse.yaml") + " -o m.json").out.find("1200 × 800"), std::string::npos);
  EXPECT_NE(run("map m.json").out.find("1200 × 800"), std::string::npos);
  EXPECT_EQ(run("generate station --seed 3 -o a.json").status, 0);
  EXPECT_EQ(run("generate station --seed 3 -o b.json").status, 0);
  EXPECT_EQ(slurp(folder_ / "a.json"), slurp(folder_ / "b.json"));
  EXPECT_EQ(run("generate warehouse -o w.yaml").status, 0);
  EXPECT_EQ(slurp(folder_ / "w.yaml"), slurp(example("warehouse.yaml")).replace(7, 13, "w.png"));
  refused(run("generate castle -o c.json"), {"castle", "station"});
}

TEST_F(CommandLine, UsageErrorsAreOneSentence) {
  refused(run("plan"), {"SCENARIO"});
  refused(run("fly"), {"fly"});
  refused(run("plan nowhere.json"), {"nowhere.json", "no such file"});
  refused(run("plan " + example("dock_middle.json") + " --set population"), {"KEY=VALUE"});
  refused(run("plan " + example("dock_middle.json") + " --set wings=2"), {"wings", "evaluations"});
  refused(run("plan " + example("dock_middle.json") + " --set evaluations=0"), {"evaluations", "1 to"});
  refused(run("simulate " + example("dock_middle.json")), {"simulate", "not supported yet"});
  refused(run("plan " + example("vehicles")), {"folder"});
  // Words that a script left empty.
  refused(run("plan " + example("dock_middle.json") + " -o ''"), {"-o", "an empty word is given"});
  refused(run("plan ''"), {"an empty word is given", "the name of a file"});
  refused(run("compare " + example("dock_middle.json") + " --planners ''"), {"--planners", "an empty word is given"});
  refused(run("compare " + example("dock_middle.json") + " --planners="), {"--planners", "an empty word is given"});
  refused(run("map " + example("warehouse.yaml") + " -o ''"), {"-o", "an empty word is given"});
  // A setting that cannot be searched is no map without a way; nothing is left behind.
  refused(run("plan " + example("grid_tugger.json") + " --set resolution=0.0001 -o fine"), {"grid_tugger.json", "planner.resolution", "coarser resolution", "0, or from about", "1 GiB"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "fine"));
}

TEST_F(CommandLine, WhereAWordIsNotKnownTheOneThatMayBeMeantIsNamed) {
  const std::string s = write(scenario()), goal = example("goal_pose.json");
  const auto meant = [](const char* word) { return std::string{", did you mean \""} + word + "\"?"; };
  refused(run("plna " + s), {meant("plan")});
  refused(run("plan " + s + " --planer astar"), {"--planer", meant("--planner")});
  refused(run("map m.json --scenaro s.json"), {"--scenaro", meant("--scenario")});
  refused(run("compare " + s + " --planer=astar"), {"--planer", meant("--planners")});
  refused(run("plan " + s + " --planner patern_docking"), {"\"patern_docking\" is not known" + meant("pattern_docking"), "(allowed: pattern_docking, "});
  refused(run("plan " + s + " --set optimiser=de"), {"--set optimiser", meant("optimizer")});
  refused(run("plan " + s + " --set optimizer=pos"), {"--set optimizer", "\"pos\" is not known" + meant("pso")});
  refused(run("plan " + goal + " --planner astar --set turn_cots=1"), {"--set turn_cots", meant("turn_cost")});
  refused(run("compare " + goal + " --planners atsar"), {"--planners", meant("astar")});
  refused(run("compare " + goal + " --planners astar:turn_cots=1"), {meant("turn_cost")});
  refused(run("compare " + goal + " --planners astar,theta_star --set turn_cots=1"), {"--set turn_cots", meant("turn_cost")});
  refused(run("check " + goal + " --planner atsar -o c"), {meant("astar")});
  refused(run("list planers"), {meant("planners")});
  refused(run("list theta_satr"), {meant("theta_star")});
  refused(run("generate statoin -o s2.json"), {meant("station")});
  refused(run("generate WOA-6 -o s2.json"), {meant("WOA-1")});
  refused(run("reproduce safe_asatr"), {meant("safe_astar")});
  struct Field {
    const char *name, *value, *word;
  };
  for (const Field& f : {Field{"planner", R"({"name": "patern_docking"})", "pattern_docking"}, Field{"planner", R"({"name": "pattern_docking", "optimiser": "de"})", "optimizer"},
                         Field{"map", R"({"generate": "SA-CONVEXE"})", "SA-CONVEX"}, Field{"budget", R"({"evaluation": 3})", "evaluations"}}) {
    Json bad = scenario();
    bad[f.name] = Json::parse(f.value);
    refused(run("plan " + write(bad, "bad.json")), {"bad.json", meant(f.word)});
  }
  std::ofstream{folder_ / "m.yaml"} << "image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nocupied_thresh: 0.6\n";
  refused(run("map m.yaml"), {"ocupied_thresh", meant("occupied_thresh")});
  std::ofstream{folder_ / "site.csv"} << "name,start_x,start_y,start_headng\n";
  refused(run("check site.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json")), {"start_headng", meant("start_heading")});
  refused(run("map " + example("warehouse.dxf") + " --unit mn"), {"\"mn\" is not known", meant("mm")});
  // What is like nothing gets no hint.
  const Outcome o = run("plan " + s + " --planner teleport");
  EXPECT_EQ(o.err.find("did you mean"), std::string::npos) << o.err;
}

TEST_F(CommandLine, TradeOffsAreProvenPlansOfWhichNoneIsBetterInAll) {
  const Outcome o = run("pareto " + example("waypoints_low.json") + " --set evaluations=3000 --points 6 -o front");
  ASSERT_EQ(o.status, 0) << o.err;
  std::vector<std::array<double, 3>> all;
  std::stringstream csv{slurp(folder_ / "front/front.csv")};
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line.substr(0, 33), "number,length,clearance,mean_clea");
  while (std::getline(csv, line)) {
    const std::string folder = line.substr(line.rfind(',') + 1);
    const Json plan = Json::parse(slurp(folder_ / "front" / folder));
    EXPECT_EQ(plan["status"], "solved");
    all.push_back({plan["metrics"]["length"].get<double>(), -plan["certificate"]["clearance"].get<double>(), plan["metrics"]["max_curvature"].get<double>()});
    EXPECT_EQ(run("verify front/" + folder).status, 0);
  }
  ASSERT_GE(all.size(), 3U);
  ASSERT_LE(all.size(), 6U);
  for (const auto& a : all) {
    for (const auto& b : all) EXPECT_FALSE(&a != &b && a[0] >= b[0] && a[1] >= b[1] && a[2] >= b[2]);
  }
  for (const char* file : {"front.svg", "paths.svg"}) EXPECT_NE(slurp(folder_ / "front" / file).find("<svg"), std::string::npos);
  refused(run("pareto " + example("dock_middle.json")), {"planner.name", "pattern_docking", "waypoint_clothoid"});
  // A smaller front takes the larger one's place, and nothing else's.
  fs::create_directories(folder_ / "front/77");
  for (const char* mine : {"front/77/plan.json", "front/03/notes.txt", "front/hall.txt"}) std::ofstream{folder_ / mine} << "mine";
  const Outcome again = run("pareto " + example("waypoints_low.json") + " --set evaluations=3000 --points 2 -o front");
  ASSERT_EQ(again.status, 0) << again.err;
  for (std::size_t i = 1; i <= all.size(); ++i) EXPECT_EQ(fs::exists(folder_ / fmt::format("front/{:02}/plan.json", i)), i <= 2) << i;
  EXPECT_EQ(fs::exists(folder_ / "front/04"), false);
  for (const char* mine : {"front/77/plan.json", "front/03/notes.txt", "front/hall.txt"}) EXPECT_EQ(slurp(folder_ / mine), "mine");
}

TEST_F(CommandLine, AFrontWithoutPlansSaysWhy) {
  Json s = Json::parse(slurp(example("waypoints_low.json")));
  s["vehicle"] = Json::parse(slurp(example("vehicles/trolley_agv.json")));
  s["vehicle"]["limits"]["curvature"] = 0.05;
  s["budget"]["evaluations"] = 200;
  Outcome o = run("pareto " + write(s) + " -o front");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_NE(o.out.find("none: of 200 chains of clothoids through the waypoints none can be driven; the best one bends with"), std::string::npos) << o.out;
  s["vehicle"]["limits"].erase("curvature");
  s["waypoints"][0] = s["map"]["polygons"]["obstacles"][0][0];
  o = run("pareto " + write(s) + " -o front");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_NE(o.out.find("none: waypoint 1 at"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("is in obstacle 0"), std::string::npos) << o.out;
  // Too near to something for any heading is told without a search, too.
  const Json low = s["map"]["polygons"]["boundary"];
  s["waypoints"][0] = {0.5 * (low[0][0].get<double>() + low[1][0].get<double>()), low[0][1].get<double>() + 0.1};
  o = run("pareto " + write(s) + " -o front");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_NE(o.out.find("is 0.1000 m from the boundary, and whatever its heading there the vehicle needs"), std::string::npos) << o.out;
}

TEST_F(CommandLine, WaypointsArePlannedThroughByWhoCan) {
  refused(run("plan " + example("waypoints_low.json") + " --planner pattern_docking"), {"planner.name", "pattern_docking does not plan through waypoints", "waypoint_clothoid"});
  refused(run("compare " + example("waypoints_low.json") + " --planners ompl_rrt_connect"), {"waypoints_low.json", "does not plan through waypoints"});
  const Outcome o = run("compare " + example("waypoints_low.json") + " --set objective=mdobs,metres --evaluations 300 -o c");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("all of them: waypoint_clothoid\n"), std::string::npos);
  EXPECT_NE(o.out.find("\n  objective=mdobs "), std::string::npos);
  EXPECT_EQ(o.out.find("waypoint_clothoid:"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "c/compare.csv").find("\"waypoint_clothoid:objective=mdobs\""), std::string::npos);
  EXPECT_NE(slurp(folder_ / "c/compare.svg").find("all: waypoint_clothoid<"), std::string::npos);
  EXPECT_EQ(o.out.find("pattern_docking"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "c/clearance.svg").find("Clearance along the path"), std::string::npos);
}

TEST_F(CommandLine, BadScenariosAreOneSentenceThatNamesTheField) {
  struct Case {
    const char* what;
    std::function<void(Json&)> change;
    std::vector<std::string> words;
  };
  const std::vector<Case> cases{
      {"missing", [](Json& j) { j.erase("start"); }, {"start", "missing"}},
      {"unknown", [](Json& j) { j["clearence"] = 0.1; }, {"clearence", "clearance"}},
      {"mistyped", [](Json& j) { j["clearance"] = "wide"; }, {"clearance", "a number"}},
      {"negative", [](Json& j) { j["clearance"] = -0.1; }, {"clearance", "-0.1", "0 to"}},
      {"too large", [](Json& j) { j["start"][0] = 2e6; }, {"start[0]", "2000000"}},
      {"newer", [](Json& j) { j["format"] = "waywright-scenario/2"; }, {"format", "newer"}},
      {"no format", [](Json& j) { j["format"] = "hello"; }, {"format"}},
      {"crossing", [](Json& j) { j["station"]["area"] = {{0, 0}, {12, 14}, {12, 0}, {0, 14}}; }, {"station.area", "cross"}},
      {"empty", [](Json& j) { j["map"]["polygons"]["obstacles"][0] = Json::array(); }, {"obstacles[0]", "empty"}},
      {"flat footprint", [](Json& j) { j["vehicle"] = {{"footprint", {{0, 0}, {1, 0}, {2, 0}}}, {"drive", {{"type", "differential"}, {"track", 1}}}}; }, {"vehicle.footprint"}},
      {"wheelbase", [](Json& j) { j["vehicle"] = {{"footprint", {{"disc", 0.3}}}, {"drive", {{"type", "tricycle"}, {"wheelbase", 0}, {"max_steering", 1}}}}; }, {"vehicle.drive.wheelbase", "above 0"}},
      {"drive", [](Json& j) { j["vehicle"] = {{"footprint", {{"disc", 0.3}}}, {"drive", {{"type", "sledge"}}}}; }, {"sledge", "tricycle"}},
      {"shelf outside", [](Json& j) { j["station"]["shelf"]["center"] = {-3, 7}; }, {"station.shelf", "outside"}},
      {"gap", [](Json& j) { j["clearance"] = 0.2; }, {"station.shelf.gap", "clearance"}},
      {"small station", [](Json& j) { j["station"]["area"] = {{0, 6.7}, {12, 6.7}, {12, 7.3}, {0, 7.3}}; j["station"]["shelf"]["size"] = {1.2, 0.4}; }, {"station.area", "wide"}},
      {"two missions", [](Json& j) { j["goal"] = {1, 2, 3}; }, {"more than one mission"}},
      {"no mission", [](Json& j) { j.erase("station"); }, {"mission is missing", "goal, station, legs)"}},
      {"waypoints", [](Json& j) { j["waypoints"] = {{1, 2}}; }, {"waypoints", "beside a station"}},
      {"zones", [](Json& j) { j["zones"] = {{{"type", "forbidden"}}}; }, {"zones[0].area", "missing", "array of points"}},
      {"factor", [](Json& j) { j["zones"] = {{{"type", "penalty"}, {"area", {{0, 0}, {1, 0}, {1, 1}}}, {"factor", 0}}}; }, {"zones[0].factor", "0 is out of range", "1 to 1000"}},
      {"undock", [](Json& j) { j["station"]["manoeuvre"] = "undok"; }, {"undok", "undock"}},
      {"load", [](Json& j) { j["carried_load"] = "pallet"; }, {"carried_load", "pallet", "no load"}},
      {"insertion", [](Json& j) { j["station"]["insertion"] = {{"depth", 1}}; }, {"insertion", "pockets", "missing"}},
      {"planner", [](Json& j) { j["planner"] = {{"name", "oracle"}}; }, {"oracle", "pattern_docking"}},
      {"parameter", [](Json& j) { j["planner"] = {{"name", "pattern_docking"}, {"optimizer", "luck"}}; }, {"optimizer", "luck", "de"}},
      {"budget", [](Json& j) { j["budget"] = {{"evaluations", 0}}; }, {"budget.evaluations"}},
      {"expansions", [](Json& j) { j["budget"] = {{"expansions", 10}}; }, {"budget.expansions", "pattern_docking counts no expansions", "evaluations, samples, seconds"}},
      {"samples", [](Json& j) { j["budget"] = {{"samples", 10}}; j["planner"] = {{"name", "pattern_docking"}, {"fallback", false}}; }, {"budget.samples", "counts no samples"}},
      {"published samples", [](Json& j) { j["budget"] = {{"samples", 10}}; j["planner"] = {{"name", "pattern_docking_published"}}; }, {"budget.samples", "counts no samples"}},
      {"seed", [](Json& j) { j["seed"] = 1.5; }, {"seed", "whole"}},
      {"map kinds", [](Json& j) { j["map"]["ros"] = "x.yaml"; }, {"kinds of map"}},
      {"map file", [](Json& j) { j["map"] = {{"ros", "x.yaml"}}; }, {"x.yaml", "no such file"}},
      {"vehicle file", [](Json& j) { j["vehicle"] = "gone.json"; }, {"s.json: vehicle: gone.json", "no such file"}},
      {"overlay file", [](Json& j) { j["map"]["overlay"] = {{{"ros", "gone.yaml"}}}; }, {"s.json: map.overlay[0].ros: gone.yaml", "no such file"}},
      {"legs", [](Json& j) { j.erase("station"); j["legs"] = Json::array(); }, {"legs", "there is none"}},
      {"station smaller than shelf", [](Json& j) { j["station"]["area"] = {{0, 6}, {2, 6}, {2, 8}, {0, 8}}; }, {"station.shelf", "2.00 × 2.00 m"}},
      {"align", [](Json& j) { j["map"]["align"] = {{{0, 0}, {1, 1}}}; }, {"align", "two pairs"}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    Json j = scenario();
    c.change(j);
    refused(run("plan " + write(j)), c.words);
  }
}

TEST_F(CommandLine, BrokenJsonIsOneSentence) {
  const auto refuse = [&](const std::string& text, const std::string& word) {
    std::ofstream{folder_ / "s.json"} << text;
    refused(run("plan s.json"), {"s.json", word});
  };
  refuse("", "not valid JSON");
  refuse("{\"format\": ", "not valid JSON");
  refuse("{\"format\": NaN}", "not valid JSON");
  refuse("{\"clearance\": 1e999}", "too large");
  refuse(std::string(100000, '['), "nested too deeply");
  refuse("{\"seed\": 1, \"seed\": 2}", "twice");
  refuse("[1, 2]", "object");
  refuse(std::string("\xff\xfe\x00", 3), "not valid JSON");
}

TEST_F(CommandLine, BadMapsAreOneSentence) {
  const auto with_map = [&](const std::string& yaml, const std::string& image) {
    std::ofstream{folder_ / "m.yaml"} << yaml;
    std::ofstream{folder_ / "m.pgm", std::ios::binary} << image;
    Json j = scenario();
    j["map"] = {{"ros", "m.yaml"}};
    return run("plan " + write(j));
  };
  const std::string yaml = "image: m.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  refused(with_map(yaml, "P5\n10 10\n255\nabc"), {"m.pgm", "cut short"});
  refused(with_map(yaml, "P5\n30000 30000\n255\n"), {"m.pgm", "30000"});
  refused(with_map(yaml, "hello"), {"m.pgm", "not a picture"});
  refused(with_map("image: m.pgm\norigin: [0, 0, 0]\n", "P5\n1 1\n255\na"), {"m.yaml", "resolution"});
  refused(with_map("a: &a [x]\nb: &b [*a, *a, *a]\nc: &c [*b, *b, *b]\n", ""), {"m.yaml", "aliases"});
  refused(with_map(std::string(5000, '[') , ""), {"m.yaml", "deeply"});
  refused(with_map("image: [\n", ""), {"m.yaml"});
  std::ofstream{folder_ / "README.md"} << "# Hello\n";
  refused(run("map README.md"), {"README.md", "no kind that is read as a map", ".yaml", ".dxf", ".svg", ".xml", ".json"});
  std::ofstream{folder_ / "broken.json"} << "# Hello\n";
  refused(run("map broken.json"), {"broken.json", "not valid JSON"});
}

TEST_F(CommandLine, WhereGrownCellsCoverAllItIsSaid) {
  const auto all = run("map " + example("warehouse.yaml") + " --trace 0.1 --dilate 1000");
  EXPECT_EQ(all.status, 0);
  EXPECT_NE(all.out.find("note: nothing is free any more: what is blocked, grown by 1000 m, covers all 60 x 40 m of the map"), std::string::npos) << all.out;
  EXPECT_EQ(run("map " + example("warehouse.yaml") + " --trace 0.1 --dilate 0.1").out.find("nothing is free"), std::string::npos);
}

TEST_F(CommandLine, RepairsAreSaid) {
  Json j = scenario();
  j["station"]["area"] = {{0, 0}, {0, 14}, {12, 14}, {12, 14}, {12, 0}};
  const Outcome o = run("plan " + write(j) + " -o o");
  EXPECT_EQ(o.status, 0) << o.err;
  const std::string plan = slurp(folder_ / "o/plan.json");
  EXPECT_NE(plan.find("station.area: 1 duplicate corner removed"), std::string::npos);
  EXPECT_NE(plan.find("clockwise order reversed"), std::string::npos);
  EXPECT_NE(o.err.find("note: station.area: 1 duplicate corner removed"), std::string::npos) << o.err;
  EXPECT_NE(slurp(folder_ / "o/report.html").find("Noted on loading: station.area: 1 duplicate corner removed"), std::string::npos);
}

TEST_F(CommandLine, BadAlignmentsAreSaid) {
  Json j = scenario();
  j["map"]["align"] = {{{0, 0}, {0, 0}}, {{10, 0}, {10.2, 0}}};
  const Outcome far = run("plan " + write(j) + " -o o");
  EXPECT_NE(far.err.find("warning: The map is 0.100 m off at pair"), std::string::npos) << far.err;
  EXPECT_NE(slurp(folder_ / "o/report.html").find("The map is 0.100 m off at pair"), std::string::npos);
  j["map"]["align"] = {{{0, 0}, {0, 0}}, {{10, 0}, {10.02, 0}}};
  const Outcome near = run("plan " + write(j) + " -o o");
  EXPECT_EQ(near.status, 0) << near.err;
  EXPECT_EQ(near.err, "");
}

TEST_F(CommandLine, DrawingsBecomeMapsPicturesAndPlans) {
  test::TestDrawing drawing;  // 12 m × 10 m, in millimetres, with a rack, a pillar and a wall
  drawing.entities = test::box("HALL", 0, 0, 12000, 10000) + test::box("RACKS", 4000, 8500, 8000, 9500) + test::circle("RACKS", 6000, 500, 300) + test::line("WALLS", 9000, 9000, 9000, 10000);
  std::ofstream{folder_ / "plan.dxf"} << drawing.text();
  const Outcome o = run("map plan.dxf --boundary-layer hall --obstacle-layers RACKS,walls -o m.json --align 0,0=1,2 --align 12,0=1,14.004 --overlay " + example("warehouse.yaml") + " --picture p.svg");
  EXPECT_EQ(o.status, 0) << o.err;
  for (const char* words : {"1 boundary, 2 obstacle polygons", "1 line, 0 points", "residuals in m: 0.0020, 0.0020", "note: plan.dxf: in mm as the drawing says", "written: m.json\nwritten: p.svg"}) {
    EXPECT_NE(o.out.find(words), std::string::npos) << o.out;
  }
  const std::string picture = slurp(folder_ / "p.svg");
  for (const char* part : {"placedbound", "placedline", "class=\"cell\"", "1: 2 mm", "plan.dxf: walls", "warehouse.yaml"}) EXPECT_NE(picture.find(part), std::string::npos) << part;
  EXPECT_EQ(run("map m.json").status, 0);

  const Json j = {{"format", "waywright-scenario/1"},
       {"map", {{"dxf", "plan.dxf"}, {"unit", "mm"}, {"obstacle_layers", {"RACKS", "WALLS"}}, {"boundary_layer", "HALL"}}},
       {"vehicle", {{"footprint", {{-0.5, -0.4}, {1.0, -0.4}, {1.0, 0.4}, {-0.5, 0.4}}}, {"drive", {{"type", "tricycle"}, {"wheelbase", 1.0}, {"max_steering", 1.0}}}}},
       {"start", {2, 3, 0}},
       {"goal", {9, 6, 1.5}},
       {"planner", {{"name", "ompl_rrt_connect"}}}};
  const Outcome planned = run("plan " + write(j) + " -o o");
  EXPECT_EQ(planned.status, 0) << planned.err;
  EXPECT_NE(planned.err.find("note: plan.dxf: in mm; taken: "), std::string::npos) << planned.err;
  fs::remove(folder_ / "plan.dxf");
  EXPECT_EQ(run("verify o/plan.json").status, 0);  // the map is in the plan
  const Json source = Json::parse(slurp(folder_ / "o/plan.json"))["scenario"]["map"]["source"];
  EXPECT_EQ(source["kind"], "dxf");
  EXPECT_EQ(source["unit"], "mm");
  EXPECT_EQ(source["files"][0]["sha256"].get<std::string>().size(), 64u);
}

TEST_F(CommandLine, AStartInsideOfAClosedOutlineNamesTheRemedy) {
  test::TestDrawing drawing;
  drawing.entities = test::box("ROOM", 0, 0, 12000, 10000);
  std::ofstream{folder_ / "plan.dxf"} << drawing.text();
  Json j = {{"format", "waywright-scenario/1"},
            {"map", {{"dxf", "plan.dxf"}}},
            {"vehicle", {{"footprint", {{-0.5, -0.4}, {1.0, -0.4}, {1.0, 0.4}, {-0.5, 0.4}}}, {"drive", {{"type", "tricycle"}, {"wheelbase", 1.0}, {"max_steering", 1.0}}}}},
            {"start", {2, 3, 0}},
            {"goal", {9, 6, 1.5}},
            {"planner", {{"name", "ompl_rrt_connect"}}}};
  const std::string words = "the start lies inside of obstacle 0, a closed outline of 120.0 m² (x 0.00 to 12.00, y 0.00 to 10.00 m), which is solid; if it is the outline of a room, name its layer as boundary_layer";
  Outcome o = run("plan " + write(j) + " -o o");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_NE(o.err.find(words), std::string::npos) << o.err;
  EXPECT_NE(slurp(folder_ / "o/report.html").find("a closed outline of 120.0"), std::string::npos);
  EXPECT_EQ(run("verify o/plan.json").err.find("and more"), std::string::npos);
  std::ofstream{folder_ / "vehicle.json"} << j["vehicle"].dump();
  std::ofstream{folder_ / "s.csv"} << "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,planner\nA,2,3,0,9,6,1.5,ompl_rrt_connect\nB,20,3,0,29,6,1.5,ompl_rrt_connect\n";
  o = run("check s.csv --map plan.dxf --vehicle vehicle.json -o c");
  EXPECT_NE(o.err.find("note: s.csv: line 2 (A): " + words), std::string::npos) << o.err;
  EXPECT_EQ(o.err.find("(B)"), std::string::npos) << o.err;
  j["map"]["boundary_layer"] = "ROOM";
  o = run("plan " + write(j) + " -o o");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.err.find("outline of a room"), std::string::npos) << o.err;
}

TEST_F(CommandLine, PicturesAndOverlaysAreWhatTheirNamesSay) {
  test::TestDrawing drawing;
  drawing.unit = "0";
  drawing.entities = test::box("HALL", 0, 0, 12000, 10000);
  std::ofstream{folder_ / "plan.dxf"} << drawing.text();
  const std::string map = "map " + example("warehouse.yaml");
  refused(run(map + " --picture x.png"), {"x.png", "--picture", "written as SVG", "a name that ends in .svg"});
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
  refused(run(map + " --overlay plan.dxf --picture p.svg"), {"plan.dxf", "12000 x 10000 units", "give unit (--overlay-unit)"});
  refused(run(map + " --overlay " + example("warehouse.yaml") + " --overlay-unit mm --picture p.svg"), {"--overlay-unit", "drawing alone"});
  refused(run(map + " --overlay-unit mm --picture p.svg"), {"--overlay-unit", "--overlay FILE.dxf"});
  const Outcome o = run(map + " --overlay plan.dxf --overlay-unit mm --picture p.SVG");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(slurp(folder_ / "p.SVG").find("<svg"), std::string::npos);
  // What names the unit where there is no --unit.
  std::ofstream{folder_ / "s.csv"} << "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading\nA,2,3,0,9,6,1.5\n";
  refused(run("check s.csv --map plan.dxf --vehicle " + example("vehicles/forklift.json")), {"plan.dxf", "convert it with `waywright map plan.dxf --unit UNIT -o map.json`"});
  Json j = scenario();
  j["map"] = {{"dxf", "plan.dxf"}};
  refused(run("plan " + write(j)), {"plan.dxf", "give map.unit ("});
  j["map"] = {{"polygons", "plan.dxf"}};
  refused(run("plan " + write(j)), {"map.polygons: plan.dxf is a drawing, not a map.json", "{\"dxf\": \"plan.dxf\"}"});
  refused(run("check s.csv --vehicle v.json"), {"--map", "DXF"});
  // What is read is not written over.
  ASSERT_EQ(run("map plan.dxf --unit mm -o m.json").status, 0);
  const std::string before = slurp(folder_ / "m.json");
  refused(run("map m.json --align 0,0=1,1 --align 1,0=2,1 -o ./m.json"), {"m.json", "-o", "would be lost"});
  EXPECT_EQ(slurp(folder_ / "m.json"), before);
}

TEST_F(CommandLine, HeadingsThatLookLikeDegreesAreDoubted) {
  Json j = scenario();
  j["start"][2] = 360.0;
  Outcome o = run("plan " + write(j) + " -o o");
  EXPECT_NE(o.err.find("note: start[2]: 360 rad is more than a whole turn and is taken as 1.8584 rad (106.5°); headings are in radians: 360° would be 0.0000"), std::string::npos) << o.err;
  EXPECT_NE(slurp(folder_ / "o/plan.json").find("start[2]: 360 rad"), std::string::npos);
  j = scenario();
  j["station"]["shelf"]["heading"] = j["station"]["shelf"]["heading"].get<double>() - 4.0 * 3.14159265358979;
  EXPECT_NE(run("plan " + write(j) + " -o o").err.find("note: station.shelf.heading: -12.5664 rad is"), std::string::npos);
  std::ofstream{folder_ / "s.csv"} << "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading\nA,2,3,90,9,6,180\nB,2,3,1.5,9,6,-6\n";
  o = run("check s.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json") + " -o c");
  EXPECT_NE(o.err.find("note: s.csv: line 2 (A): start_heading: 90 rad is"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("note: s.csv: line 2 (A): goal_heading: 180 rad is"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("a column goal_heading_deg takes degrees"), std::string::npos) << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 2) << o.err;
}

TEST_F(CommandLine, WhereTheSecondChoiceFailsItsCauseIsTold) {
  Json j = Json::parse(slurp(example("dock_impossible.json")));
  j["budget"]["samples"] = 2000;
  const Outcome o = run("check " + write(j) + " -o c");
  EXPECT_EQ(o.status, 1) << o.err;
  EXPECT_NE(o.out.find("left side blocked by obstacle 2"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("; the second choice ompl_rrt_connect found none either: RRTConnect found no way from start to goal before"), std::string::npos) << o.out;
  for (const char* file : {"c/check.html", "c/check.csv"}) EXPECT_NE(slurp(folder_ / file).find("found none either: RRTConnect found no way"), std::string::npos) << file;
  // In the plan's own report once.
  const Json plan = Json::parse(slurp(folder_ / "c/no-way-in/plan.json"));
  for (const Json& sentence : plan["explanation"]) EXPECT_EQ(sentence.get<std::string>().find("RRTConnect found no way"), std::string::npos) << sentence;
}

TEST_F(CommandLine, EvaluationsOfTheCommandLineAreNotSilentlyOverridden) {
  Json j = scenario();
  j["budget"]["evaluations"] = 300;
  const std::string file = write(j);
  refused(run("plan " + file + " --set evaluations=500"), {file, "--set evaluations", "budget.evaluations, 300, would take its place"});
  refused(run("check " + file + " --set evaluations=500"), {file, "--set evaluations", "300"});
  EXPECT_EQ(run("plan " + file + " --set population=30 -o o").status, 0);
}

TEST_F(CommandLine, WithoutItsPartForDrawingsItSaysSo) {
  test::TestDrawing drawing;
  drawing.entities = test::box("0", 0, 0, 12000, 10000);
  std::ofstream{folder_ / "plan.dxf"} << drawing.text();
  ASSERT_EQ(::setenv("WAYWRIGHT_DXF_MODULE", "/nowhere/libwaywright_dxf.so", 1), 0);
  const Outcome o = run("map plan.dxf");
  ::unsetenv("WAYWRIGHT_DXF_MODULE");
  refused(o, {"plan.dxf", "libwaywright_dxf.so, is not there", "libgdal-dev"});
  EXPECT_EQ(run("map plan.dxf").status, 0);
}

TEST_F(CommandLine, AMapWithoutAFreePlaceHasItsOwnExtent) {
  std::ofstream{folder_ / "full.json"} << R"({"cells": [{"name": "full", "columns": 4, "rows": 2, "cell": 0.5, "origin": [3, 5, 0], "runs": [1, 8]}]})";
  const Outcome o = run("map full.json");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("full.json: x 3.000 to 5.000 m, y 5.000 to 6.000 m\n"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("note: nothing is free"), std::string::npos) << o.out;
}

TEST_F(CommandLine, MapAlignsByPairsOfPoints) {
  const Outcome o = run("map " + example("warehouse.yaml") + " --align 0,0=10,5 --align 10,0=10,15.02 -o m.json");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("residuals in m: 0.0100, 0.0100"), std::string::npos) << o.out;
  EXPECT_NE(run("map m.json").out.find("residuals in m: 0.0100, 0.0100"), std::string::npos);
  EXPECT_EQ(o.err, "");
  const Outcome off = run("map " + example("warehouse.yaml") + " --align 0,0=10,5 --align 10,0=10,15.6 --overlay " + example("warehouse.yaml") + " --picture p.svg");
  EXPECT_EQ(off.status, 0) << off.err;
  EXPECT_NE(off.err.find("warning: the map is 0.300 m off at the pair "), std::string::npos) << off.err;
  EXPECT_NE(off.out.find("note: align: the pairs fit a map 1.06 times as large: wrong unit?"), std::string::npos) << off.out;
  EXPECT_NE(slurp(folder_ / "p.svg").find("class=\"spotline\""), std::string::npos);
  refused(run("map " + example("warehouse.yaml") + " --align 0,0=10,5 --align 10,0=10,25"), {"align: the pairs do not fit the map", "2.00 times as large: wrong unit?"});
  refused(run("map " + example("warehouse.yaml") + " --align 0,0=10"), {"--align", "0,0=10", "X,Y=X,Y"});
  refused(run("map " + example("warehouse.yaml") + " --align 0,0=10,5"), {"align", "two pairs"});
  refused(run("map " + example("warehouse.yaml") + " --unit mm"), {"--unit", "a .dxf file"});
  refused(run("map " + example("warehouse.yaml") + " --overlay m.json"), {"--overlay", "--picture"});
  refused(run("map gone.dxf"), {"waywright: gone.dxf: there is no such file"});
  refused(run("map gone.yaml"), {"waywright: gone.yaml: there is no such file"});
}

TEST_F(CommandLine, NamesDoNotCommandTheTerminal) {
  Json j = scenario();
  j["name"] = "red \x1b[31m \x7f \xc2\x9b" "2J é";
  const Outcome o = run("plan " + write(j) + " -o o");
  EXPECT_EQ(o.out.rfind("red ?[31m ? ?2J é: solved", 0), 0U) << o.out;
  EXPECT_EQ(Json::parse(run("plan s.json --json").out)["scenario"]["name"], j["name"]);
}

TEST_F(CommandLine, AFullStandardOutputIsSaid) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const std::string command = "cd '" + folder_.string() + "' && '" WAYWRIGHT_BINARY "' plan " + example("dock_middle.json") + " -o o >/dev/full 2>err.txt";
  const int raw = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(raw), 1);
  EXPECT_NE(slurp(folder_ / "err.txt").find("standard output cannot be written to"), std::string::npos);
}

TEST_F(CommandLine, FilesAppearAllOrNone) {
  fs::create_directories(folder_ / "o" / "plan.svg");
  const Outcome o = run("plan " + example("dock_middle.json") + " -o o");
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("a folder has its name"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(folder_ / "o" / "plan.json"));
  std::size_t entries = 0;
  for ([[maybe_unused]] const auto& e : fs::directory_iterator{folder_ / "o"}) ++entries;
  EXPECT_EQ(entries, 1U);
}

TEST_F(CommandLine, GenerateIgnoresNothing) {
  refused(run("generate warehouse --boxes 5 -o w.yaml"), {"--boxes", "station"});
  const Outcome o = run("generate station -o new/s.json");
  EXPECT_EQ(o.status, 0);
  EXPECT_NE(o.err.find("the folder new was made"), std::string::npos) << o.err;
}

TEST_F(CommandLine, EachThingIsSaidOnce) {
  const Outcome o = run("plan " + example("dock_impossible.json") + " -o o");
  const std::string html = slurp(folder_ / "o/report.html");
  for (const char* side : {"On the left side no pattern fits", "On the right side no pattern fits", "RRTConnect found no way"}) {
    for (const std::string& text : {o.out, html}) {
      const std::size_t first = text.find(side);
      ASSERT_NE(first, std::string::npos) << side;
      EXPECT_EQ(text.find(side, first + 1), std::string::npos) << side;
    }
  }
}

TEST_F(CommandLine, OnlyWhatIsProvenIsCalledProven) {
  std::ofstream{folder_ / "p.csv"} << "x,y,heading\n9.5,7,0\n2,7,3.14159265\n";
  const Outcome o = run("import p.csv --scenario " + example("dock_middle.json") + " -o o");
  EXPECT_EQ(o.status, 1);
  EXPECT_EQ(o.out.find("proven clearance"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("the path is not proven"), std::string::npos) << o.out;
  EXPECT_EQ(slurp(folder_ / "o/report.html").find("Proven clearance"), std::string::npos);
}

TEST_F(CommandLine, EmptyPlacesHaveNoTightestSpot) {
  Json j = scenario();
  j["map"] = {{"polygons", Json::object()}};
  j.erase("station");
  j["goal"] = {2, 7, 0};
  j["planner"] = {{"name", "ompl_rrt_connect"}};
  const Outcome o = run("plan " + write(j) + " -o o");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("proven clearance       more than"), std::string::npos) << o.out;
  const std::string html = slurp(folder_ / "o/report.html");
  EXPECT_NE(html.find("Solved and proven: more than"), std::string::npos);
  EXPECT_EQ(html.find("tightest spot"), std::string::npos);
  EXPECT_NE(run("verify o/plan.json").out.find("with more than"), std::string::npos);
}

TEST_F(CommandLine, UnwritableFoldersAreRefusedBeforeTheWork) {
  std::ofstream{folder_ / "file"} << "x";
  const Outcome o = run("plan " + example("dock_middle.json") + " -o file/inside");
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("cannot be made"), std::string::npos) << o.err;
  EXPECT_EQ(run("plan " + example("dock_middle.json") + " -o /proc/waywright").status, 2);
}

TEST_F(CommandLine, InterruptKeepsWhatIsFinishedAndEndsInOrder) {
  Json j = Json::parse(slurp(example("dock_impossible.json")));
  j["planner"] = {{"name", "ompl_rrt_connect"}, {"checks", 900000000}};
  const std::string file = write(j);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder_.c_str()) != 0 || ::freopen("err.txt", "w", stderr) == nullptr) ::_exit(9);
    ::execl(WAYWRIGHT_BINARY, "waywright", "plan", file.c_str(), "-o", "o", static_cast<char*>(nullptr));
    ::_exit(9);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  ::kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const Json plan = Json::parse(slurp(folder_ / "o/plan.json"));
  EXPECT_EQ(plan["status"], "canceled");
  EXPECT_EQ(plan["reproducible"], false);
  EXPECT_NE(slurp(folder_ / "err.txt").find("interrupted"), std::string::npos);
  EXPECT_NE(slurp(folder_ / "o/report.html").find("Interrupted, no path yet"), std::string::npos);
}

/// A command that waits for its input is interrupted: it ends by the signal.
TEST_F(CommandLine, InterruptEndsEveryCommandThatReads) {
  const fs::path pipe = folder_ / "pipe.yaml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string scenario = example("dock_middle.json");
  for (const std::vector<const char*>& arguments : std::vector<std::vector<const char*>>{
           {"verify", "pipe.yaml"}, {"plan", "pipe.yaml"}, {"compare", "pipe.yaml"}, {"map", "pipe.yaml"}, {"import", "pipe.yaml", "--scenario", scenario.c_str()}}) {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::chdir(folder_.c_str()) != 0) ::_exit(9);
      std::vector<char*> argv{const_cast<char*>("waywright")};
      for (const char* a : arguments) argv.push_back(const_cast<char*>(a));
      argv.push_back(nullptr);
      ::execv(WAYWRIGHT_BINARY, argv.data());
      ::_exit(9);
    }
    const int writer = ::open(pipe.c_str(), O_WRONLY);  // returns once the command reads
    ASSERT_GE(writer, 0);
    ::kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << arguments[0];
    ::close(writer);
  }
  for (const auto& entry : fs::directory_iterator{folder_}) EXPECT_EQ(entry.path(), pipe);
}

/// Output closed or not, with children of its own or not: an outside planner ends with its budget.
TEST_F(CommandLine, OutsidePlannersDoNotOutliveTheirBudget) {
  Json j = scenario();
  j["budget"] = {{"seconds", 0.2}};
  const std::string file = write(j);
  for (const std::string command : {"exec 1>&-; echo $$ >pid; sleep 600", "sleep 600 >/dev/null & echo $! >pid; exec 1>&-; wait", "echo $$ >pid; sleep 600"}) {
    const Outcome o = run("compare " + file + " --planners 'exec:" + command + "' -o c");
    EXPECT_NE(slurp(folder_ / "c/compare.csv").find("timed_out"), std::string::npos) << o.err;
    // Killed before its parent was waited for; it may still be waiting for init to take note.
    const std::string process = "/proc/" + std::to_string(std::atoi(slurp(folder_ / "pid").c_str())) + "/stat";
    const std::string stat = slurp(process);
    EXPECT_TRUE(stat.empty() || stat.find(") Z ") != std::string::npos || stat.find(") X ") != std::string::npos) << stat;
  }
  // What a planner leaves running when it is done goes with it.
  std::ofstream{folder_ / "p.csv"} << "x,y,heading\n9.5,7,0\n9,7,0\n";
  j["budget"] = {{"seconds", 600}};
  EXPECT_EQ(run("compare " + write(j) + " --planners 'exec:sleep 600 >/dev/null & echo $! >pid; cat p.csv' -o c").status, 0);
  const std::string stat = slurp("/proc/" + std::to_string(std::atoi(slurp(folder_ / "pid").c_str())) + "/stat");
  EXPECT_TRUE(stat.empty() || stat.find(") Z ") != std::string::npos || stat.find(") X ") != std::string::npos) << stat;
}

TEST_F(CommandLine, OutputsAppearTogetherOrNotAtAll) {
  fs::create_directories(folder_ / "o/report.html");  // the last of the three cannot be written
  EXPECT_EQ(run("plan " + example("dock_middle.json") + " -o o").status, 2);
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator{folder_ / "o"}) names.push_back(entry.path().filename().string());
  EXPECT_EQ(names, std::vector<std::string>{"report.html"});
}

TEST_F(CommandLine, StationOnARealMap) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !fs::exists(fs::path{data} / "ros_maps")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  struct Place {
    const char* map;
    double x0, y0, x1, y1, shelf_x, shelf_y;
  };
  for (const Place& p : {Place{"ipa_production_plant/map.yaml", 7, -2, 19.5, 11.5, 10.2, 5.2}, Place{"nav2/warehouse.yaml", -8, -3, 5.5, 11, -6.4, 4.0}}) {
    Json j = scenario();
    j["map"] = {{"ros", (fs::path{data} / "ros_maps" / p.map).string()}};
    j["start"] = {p.shelf_x + 7.2, p.shelf_y, 0.0};
    j["station"] = {{"area", {{p.x0, p.y0}, {p.x1, p.y0}, {p.x1, p.y1}, {p.x0, p.y1}}},
                    {"shelf", {{"center", {p.shelf_x, p.shelf_y}}, {"heading", 0}, {"size", {1.0, 2.0}}, {"gap", 0.12}}}};
    EXPECT_EQ(run("plan " + write(j) + " -o o").status, 0) << p.map;
    EXPECT_EQ(run("verify o/plan.json").status, 0) << p.map;
  }
}

}  // namespace
