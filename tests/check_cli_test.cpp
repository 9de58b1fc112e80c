// `check` as a user meets it.
#include <signal.h>

#include <chrono>
#include <regex>
#include <set>
#include <thread>

#include "tests/command_line.hpp"

namespace {

using namespace waywright::test;

class CheckCommand : public CommandLine {
 protected:
  static constexpr const char* header = "name,start_x,start_y,start_heading,shelf_x,shelf_y,shelf_heading_deg,shelf_depth,shelf_width,gap,area,goal_x,goal_y,goal_heading,clearance\n";
  static constexpr const char* dock_1 = "A 01,46.2,9.5,3.1416,58.9,9.2,180,1.2,2.7,0.12,44 1 | 59.5 17.5,,,,0.05\n";
  static constexpr const char* dock_2 = "A 02,46.2,9.5,3.1416,58.9,5.2,180,1.2,2.7,0.12,44 1 | 59.5 17.5,,,,\n";
  static constexpr const char* free_pose = "Tür,46.2,9.5,3.1416,,,,,,,,50,5,1.57,0.1\n";
  static constexpr const char* blocked = "in the rack,46.2,9.5,3.1416,,,,,,,,10,3.5,1.57,\n";

  void table(const std::string& rows, const std::string& name = "s.csv") const { std::ofstream{folder_ / name} << header << rows; }
  Outcome check(const std::string& more, const std::string& clearance = "0.03") const {
    return run("check s.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json") + " --clearance " + clearance + " -o c " + more);
  }
  static std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }
};

TEST_F(CheckCommand, PlansProvesAndTellsTheTightestFirst) {
  table(std::string{dock_1} + dock_2 + free_pose + blocked);
  const Outcome o = check("");
  EXPECT_EQ(o.status, 1) << o.err;
  // The form is golden; figures of the search, which change when it does, are read as digits.
  const std::string form = std::regex_replace(std::regex_replace(o.out, std::regex{"[0-9]+"}, "#"), std::regex{" +"}, " ");
  EXPECT_EQ(form,
            "# places: # solved and proven, # not; # taken over, # planned\n"
            " in the rack: goal_in_collision: At the goal pose (#.#, #.#, #.# rad) the footprint touches warehouse.yaml (blocked cell) at (#.#, #.#).\n"
            " place clear. m against way m against length m curv. #/m time s\n"
            " Tür #.# warehouse.yaml (blocked cell) (#.#, #.#) – – #.# #.# #.#\n"
            " A # #.# the shelf (#.#, #.#) #.# the station's area (#.#, #.#) #.# #.# #.#\n"
            " A # #.# the shelf (#.#, #.#) #.# the shelf (#.#, #.#) #.# #.# #.#\n"
            "written: c/check.csv, c/check.html, c/NAME/plan.json, …/plan.svg, …/report.html\n");
  EXPECT_EQ(first_line(o.out), "4 places: 3 solved and proven, 1 not; 0 taken over, 4 planned");
  for (const char* place : {"A-01", "A-02", "Tür", "in-the-rack"}) {
    for (const char* file : {"plan.json", "plan.svg", "report.html", "small.svg", "place.json"}) EXPECT_TRUE(fs::exists(folder_ / "c" / place / file)) << place << file;
    EXPECT_EQ(run("verify c/" + std::string{place} + "/plan.json").status, std::string{place} == "in-the-rack" ? 1 : 0) << place;
  }
  const Json plan = Json::parse(slurp(folder_ / "c/A-01/plan.json"));
  EXPECT_EQ(plan["scenario"]["clearance"], 0.05);
  EXPECT_EQ(Json::parse(slurp(folder_ / "c/A-02/plan.json"))["scenario"]["clearance"], 0.03);
  EXPECT_EQ(plan["scenario"]["map"]["source"]["files"].size(), 2U);
  const std::string html = slurp(folder_ / "c/check.html");
  EXPECT_LT(html.find("Not solved"), html.find("tightest first"));
  EXPECT_NE(html.find("src=\"A-01/small.svg\""), std::string::npos);
  EXPECT_NE(html.find("href=\"T%C3%BCr/report.html\""), std::string::npos);
  const std::string csv = slurp(folder_ / "c/check.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_LT(csv.find("in the rack"), csv.find("Tür"));
}

TEST_F(CheckCommand, APlaceIsPlannedAsPlanPlansItsScenario) {
  table(dock_1);
  ASSERT_EQ(check("--seed 7").status, 0);
  Json j = Json::parse(slurp(folder_ / "c/A-01/plan.json"));
  std::ofstream{folder_ / "again.json"} << j["scenario"].dump();
  Json again = Json::parse(run("plan again.json --json").out);
  j.erase("timing");
  again.erase("timing");
  EXPECT_EQ(j, again);
  EXPECT_EQ(j["seed"], 7);
}

TEST_F(CheckCommand, OnlyWhatChangedIsPlannedAgain) {
  table(std::string{dock_1} + dock_2 + blocked);
  ASSERT_EQ(first_line(check("").out), "3 places: 2 solved and proven, 1 not; 0 taken over, 3 planned");
  const std::string csv = slurp(folder_ / "c/check.csv"), plan = slurp(folder_ / "c/A-01/plan.json");
  const auto said = [&](const std::string& more) { return first_line(check(more).out); };
  EXPECT_EQ(said(""), "3 places: 2 solved and proven, 1 not; 3 taken over, 0 planned");
  EXPECT_EQ(slurp(folder_ / "c/A-01/plan.json"), plan);
  EXPECT_EQ(std::regex_replace(slurp(folder_ / "c/check.csv"), std::regex{",1,\"(A-0|in)"}, ",0,\"$1"), csv);
  // A file that is not whole, one that is away, a record that was changed: planned again.
  std::ofstream{folder_ / "c/A-01/plan.json"} << plan.substr(0, plan.size() / 2);
  EXPECT_EQ(said(""), "3 places: 2 solved and proven, 1 not; 2 taken over, 1 planned");
  EXPECT_EQ(Json::parse(slurp(folder_ / "c/A-01/plan.json"))["status"], "solved");
  fs::remove(folder_ / "c/A-02/plan.svg");
  EXPECT_EQ(said(""), "3 places: 2 solved and proven, 1 not; 2 taken over, 1 planned");
  std::string record = slurp(folder_ / "c/in-the-rack/place.json");
  record.replace(record.find("goal_in_collision"), 17, "solved");
  std::ofstream{folder_ / "c/in-the-rack/place.json"} << record;
  EXPECT_EQ(said(""), "3 places: 2 solved and proven, 1 not; 2 taken over, 1 planned");
  // What the answer depends on: a row, the clearance of those that name none, the seed, a parameter; the order does not matter.
  table(std::string{blocked} + dock_2 + std::regex_replace(std::string{dock_1}, std::regex{"0.12"}, "0.13"));
  EXPECT_EQ(said(""), "3 places: 2 solved and proven, 1 not; 2 taken over, 1 planned");
  EXPECT_EQ(first_line(check("", "0.031").out), "3 places: 2 solved and proven, 1 not; 1 taken over, 2 planned");
  EXPECT_EQ(said("--seed 2"), "3 places: 2 solved and proven, 1 not; 0 taken over, 3 planned");
  EXPECT_EQ(said("--seed 2 --set evaluations=500"), "3 places: 2 solved and proven, 1 not; 0 taken over, 3 planned");
  EXPECT_EQ(said("--seed 2 --set evaluations=500"), "3 places: 2 solved and proven, 1 not; 3 taken over, 0 planned");
  EXPECT_EQ(said("--seed 2 --set evaluations=500 --fresh"), "3 places: 2 solved and proven, 1 not; 0 taken over, 3 planned");
}

TEST_F(CheckCommand, AnotherMapIsPlannedAnew) {
  fs::copy_file(example("warehouse.yaml"), folder_ / "warehouse.yaml");
  fs::copy_file(example("warehouse.png"), folder_ / "warehouse.png");
  table(dock_1);
  const std::string command = "check s.csv --map warehouse.yaml --vehicle " + example("vehicles/forklift.json") + " -o c";
  ASSERT_EQ(run(command).status, 0);
  EXPECT_NE(run(command).out.find("1 taken over"), std::string::npos);
  ASSERT_EQ(run("generate warehouse --seed 5 -o warehouse.yaml").status, 0);
  EXPECT_NE(run(command).out.find("0 taken over"), std::string::npos);
}

TEST_F(CheckCommand, AnyNumberOfThreadsGivesTheSameFiles) {
  const Outcome made = run("generate stations --count 6 --seed 3 -o site.csv");
  ASSERT_EQ(made.status, 0);
  EXPECT_NE(made.out.find("check it: waywright check site.csv --map site.yaml --vehicle site.vehicle.json --clearance 0.05"), std::string::npos) << made.out;
  EXPECT_TRUE(fs::exists(folder_ / "site.vehicle.json"));
  const auto timeless = [&](const std::string& folder) {
    std::string all;
    std::set<fs::path> plans;
    for (const auto& entry : fs::recursive_directory_iterator{folder_ / folder}) {
      if (entry.path().filename() == "plan.json") plans.insert(entry.path());
    }
    for (const fs::path& path : plans) {
      Json j = Json::parse(slurp(path));
      j.erase("timing");
      all += j.dump();
    }
    return all;
  };
  for (const char* threads : {"1", "2", "5"}) {
    const Outcome o = run(std::string{"check site.csv --map site.yaml --vehicle "} + example("vehicles/forklift.json") + " --clearance 0.05 --threads " + threads + " -o t" + threads);
    EXPECT_LE(o.status, 1) << o.err;
    EXPECT_NE(o.out.find("0 taken over, 6 planned"), std::string::npos) << o.out;
  }
  EXPECT_EQ(timeless("t1"), timeless("t2"));
  EXPECT_EQ(timeless("t1"), timeless("t5"));
}

TEST_F(CheckCommand, ScenarioFilesOfDifferentMapsAndVehicles) {
  const Outcome o = run("check " + example("dock_middle.json") + " " + example("goal_pose.json") + " " + example("dock_impossible.json") + " -o c --json");
  EXPECT_EQ(o.status, 1);
  const Json j = Json::parse(o.out);
  EXPECT_EQ(j["format"], "waywright-check/1");
  EXPECT_EQ(j["places"], 3);
  EXPECT_EQ(j["solved"], 2);
  EXPECT_EQ(j["rows"][0]["status"], "no_path");
  EXPECT_GT(j["rows"][1]["figures"]["length"], 1.0);
  const Outcome pockets = run("check " + example("dock_insertion.json") + " -o p --json");
  EXPECT_GT(Json::parse(pockets.out)["rows"][0]["figures"]["pocket_clearance"], 0.0);
  EXPECT_NE(slurp(folder_ / "p/check.html").find("forks in the pocket"), std::string::npos);
  // The same as `plan` finds.
  Json there = Json::parse(slurp(folder_ / "c/dock-at-the-shelf-in-the-middle/plan.json"));
  Json here = Json::parse(run("plan " + example("dock_middle.json") + " --json").out);
  there.erase("timing");
  here.erase("timing");
  EXPECT_EQ(there, here);
  refused(run("check " + example("dock_middle.json") + " " + example("dock_middle.json")), {"dock_middle.json", "name", "the same folder"});
  refused(run("check " + example("dock_middle.json") + " --map m.yaml"), {"--map", "scenario files have their own"});
}

TEST_F(CheckCommand, ASettingGoesToThePlacesWhosePlannerTakesIt) {
  std::ofstream{folder_ / "both.csv"} << "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,waypoints,planner,shelf_x,shelf_y,shelf_heading_deg,shelf_depth,shelf_width,area\n"
                                         "way,2,9.5,0,30,9.5,0,16 9.5,waypoint_clothoid,,,,,,\n"
                                         "dock,46.2,9.5,3.14159,,,,,,58.9,9.2,180,1.2,2.7,44 1 | 59.5 17.5\n";
  const auto setting = [&](const std::string& set) {
    return run("check both.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json") + " --set evaluations=50 --set " + set + " -o c");
  };
  const Outcome o = setting("objective=mlpc");
  EXPECT_NE(o.status, 2) << o.err;
  EXPECT_EQ(Json::parse(slurp(folder_ / "c/way/plan.json"))["scenario"]["planner"]["objective"], "mlpc");
  EXPECT_EQ(Json::parse(slurp(folder_ / "c/dock/plan.json"))["scenario"]["planner"]["objective"], "normalised");
  refused(setting("objective=nobody"), {"--set objective", "waypoint_clothoid: ", "nobody", "mlpc"});
  refused(setting("nothing=1"), {"--set nothing", "has no such parameter"});
}

TEST_F(CheckCommand, BadInputIsOneSentence) {
  const auto bad = [&](const std::string& rows, const std::vector<std::string>& words, const std::string& more = "") {
    table(rows);
    refused(check(more), words);
    EXPECT_FALSE(fs::exists(folder_ / "c"));
  };
  bad("A,46.2,9.5,x,,,,,,,,50,5,1.57,\n", {"s.csv: line 2 (A): start_heading", "\"x\""});
  bad("A,46.2,9.5,0,58.9,9.2,180,1.2,-2.7,0.12,44 1 | 59.5 17.5,,,,\n", {"line 2 (A): shelf_width", "-2.7", "above 0"});
  bad("A,46.2,9.5,0,58.9,9.2,180,1.2,2.7,0.01,44 1 | 59.5 17.5,,,,\n", {"line 2", "station.shelf.gap", "clearance"});
  bad("A,46.2,9.5,0,8.9,9.2,180,1.2,2.7,0.1,44 1 | 59.5 17.5,,,,\n", {"line 2", "station.shelf", "outside the station's area"});
  bad("A,46.2,9.5,0,,,,,,,,,,,\n", {"line 2 (A)", "the mission is missing"});
  bad(std::string{dock_1} + "A-01,46.2,9.5,0,,,,,,,,50,5,1.57,\n", {"line 3", "\"A-01\" and \"A 01\"", "line 2", "the same folder"});
  bad(dock_1, {"line 2", "planner", "nobody", "pattern_docking"}, "--planner nobody");
  bad("check.csv,46.2,9.5,0,,,,,,,,50,5,1.57,\n", {"line 2", "name", "a file of the check itself"});
  bad(dock_1, {"nothing"}, "--set nothing=1");
  bad("", {"s.csv", "no place"});
  refused(run("check"), {"nothing to check"});
  refused(run("check s.csv --vehicle v.json"), {"--map"});
  refused(run("check s.csv --map m.yaml"), {"--vehicle"});
  refused(run("check missing.csv --map " + example("warehouse.yaml") + " --vehicle " + example("vehicles/forklift.json")), {"missing.csv"});
  std::ofstream{folder_ / "site.json"} << R"({"metaInformation": {"projectIdentification": "x"}, "layouts": []})";
  refused(run("check site.json"), {"site.json", "LIF", "not supported yet"});
  refused(run("check site.json --map m.yaml --vehicle v.json"), {"site.json", "LIF", "not supported yet"});
  table(dock_1);
  std::ofstream{folder_ / "c"} << "a file";
  EXPECT_EQ(check("").status, 2);
}

TEST_F(CheckCommand, AMissionThatItsPlannerCannotTakeIsRefusedBeforeAnyPlaceIsPlanned) {
  std::ofstream{folder_ / "s.csv"} << "name,start_x,start_y,start_heading,goal_x,goal_y,goal_heading,waypoints,planner\nA,46.2,9.5,3.1416,50,5,1.57,,ompl_rrt_connect\nB,46.2,9.5,3.1416,50,5,1.57,48 7,ompl_rrt_connect\n";
  const Outcome o = check("");
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("s.csv: line 3: planner.name: ompl_rrt_connect does not plan through waypoints"), std::string::npos) << o.err;
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(CheckCommand, WhatIsTakenOverHasTheNameThatItHasNow) {
  Json j = Json::parse(slurp(example("goal_pose.json")));
  j["name"] = "";
  if (j["vehicle"].is_string()) j["vehicle"] = example(j["vehicle"].get<std::string>());
  ASSERT_EQ(run("check " + write(j, "a b.json").replace(0, 0, "'") + "' -o c").status, 0);
  fs::rename(folder_ / "a b.json", folder_ / "a-b.json");  // the same folder
  const Outcome o = run("check a-b.json -o c");
  EXPECT_NE(o.out.find("1 taken over"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("\n  a-b "), std::string::npos) << o.out;
}

TEST_F(CheckCommand, NamesAreSafeFolders) {
  const std::string pose = ",46.2,9.5,3.1416,,,,,,,,50,5,1.57,0.1\n";
  table(".." + pose + "../../up" + pose + "\"<b>, \"\"x\"\"\"" + pose + std::string(300, 'x') + pose + "1.2" + pose);
  const Outcome o = check("");
  EXPECT_EQ(o.status, 0) << o.err;
  std::set<std::string> folders;
  for (const auto& entry : fs::directory_iterator{folder_ / "c"}) {
    if (entry.is_directory()) folders.insert(entry.path().filename().string());
  }
  EXPECT_EQ(folders, (std::set<std::string>{"-.", "-.-..-up", "-b----x-", std::string(80, 'x'), "1.2"}));
  const std::string html = slurp(folder_ / "c/check.html");
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_NE(html.find("&lt;b&gt;, &quot;x&quot;"), std::string::npos);
  EXPECT_EQ(first_line(slurp(folder_ / "c/check.csv")).find("name,status,clearance"), 0U);
}

TEST_F(CheckCommand, InterruptKeepsWhatIsFinished) {
  ASSERT_EQ(run("generate stations --count 12 -o site.csv").status, 0);
  const std::string vehicle = example("vehicles/forklift.json");
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder_.c_str()) != 0 || ::freopen("out.txt", "w", stdout) == nullptr) ::_exit(9);
    ::execl(WAYWRIGHT_BINARY, "waywright", "check", "site.csv", "--map", "site.yaml", "--vehicle", vehicle.c_str(), "--set", "optimizer=ga", "--set", "evaluations=40000", "--threads",
            "1", "-o", "c", static_cast<char*>(nullptr));
    ::_exit(9);
  }
  for (int i = 0; i < 2000 && !fs::exists(folder_ / "c/A-01/place.json"); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  ASSERT_TRUE(fs::exists(folder_ / "c/A-01/place.json")) << "the first place was not finished in 200 s";
  ::kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const std::string said = slurp(folder_ / "out.txt");
  EXPECT_NE(said.find("interrupted, "), std::string::npos) << said;
  EXPECT_TRUE(fs::exists(folder_ / "c/check.csv"));
  // What was finished is taken over by the next.
  std::istringstream lines{slurp(folder_ / "site.csv")};
  std::ofstream first{folder_ / "first.csv"};
  std::string line;
  for (int i = 0; i < 2 && std::getline(lines, line); ++i) first << line << '\n';
  first.close();
  const Outcome more = run("check first.csv --map site.yaml --vehicle " + vehicle + " --set optimizer=ga --set evaluations=40000 -o c");
  EXPECT_NE(more.out.find("1 taken over, 0 planned"), std::string::npos) << more.out << more.err;
}

}  // namespace
