// `waywright controls` as a user runs it: files, figures, exit statuses, what is refused.
#include "command_line.hpp"

#include <cmath>

namespace waywright::test {
namespace {

class Controls : public CommandLine {
 protected:
  /// Plans into the folder; the plan's name there.
  std::string planned(const std::string& scenario, const std::string& more = "") const {
    const Outcome o = run("plan '" + scenario + "' -o p " + more);
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    return "p/plan.json";
  }
  std::vector<double> column(const Json& controls, const char* name) const { return controls["series"][name].get<std::vector<double>>(); }
};

TEST_F(Controls, ExactOfADockingPlan) {
  const std::string plan = planned(example("dock_middle.json"));
  const Outcome o = run("controls " + plan + " -o c");
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_NE(o.out.find("end error"), std::string::npos);
  EXPECT_NE(o.out.find("written: c/controls.json, c/controls.csv, c/controls.svg"), std::string::npos) << o.out;
  const Json j = Json::parse(slurp(folder_ / "c/controls.json")), p = Json::parse(slurp(folder_ / plan));
  EXPECT_EQ(j["format"], "waywright-controls/1");
  EXPECT_EQ(j["method"], "exact");
  EXPECT_EQ(j["vehicle"]["drive"]["type"], "tricycle");
  EXPECT_LT(j["end_error"]["position"].get<double>(), 1e-3);
  const auto t = column(j, "t"), v = column(j, "v"), steering = column(j, "steering"), x = column(j, "x"), y = column(j, "y");
  ASSERT_EQ(t.size(), x.size());
  EXPECT_NEAR(t[1] - t[0], 0.05, 1e-12);
  EXPECT_EQ(v.back(), 0.0);
  EXPECT_NEAR(x.back(), p["path"]["samples"]["x"].back().get<double>(), 1e-3);
  EXPECT_NEAR(y.back(), p["path"]["samples"]["y"].back().get<double>(), 1e-3);
  EXPECT_LT(*std::min_element(v.begin(), v.end()), -0.2) << "the docking pattern backs out";
  EXPECT_GT(*std::max_element(v.begin(), v.end()), 0.2);
  // The CSV holds the same numbers, a line a command.
  const std::string csv = slurp(folder_ / "c/controls.csv");
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "t,v,w,steering,wheel,x,y,heading");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), t.size() + 1);
  EXPECT_EQ(slurp(folder_ / "c/controls.svg").substr(0, 4), "<svg");
  // On standard output the same file, and the error shrinks with the period.
  const Outcome again = run("controls " + plan + " --json");
  EXPECT_EQ(again.out, slurp(folder_ / "c/controls.json"));
  const Outcome finer = run("controls " + plan + " --json --period 0.01");
  EXPECT_LT(Json::parse(finer.out)["figures"]["greatest_deviation"].get<double>(), 0.1 * j["figures"]["greatest_deviation"].get<double>());
}

TEST_F(Controls, WhalesDriveTheDifferentialExample) {
  const std::string plan = planned(example("grid_tugger.json"));
  const Outcome o = run("controls " + plan + " --method woa -o c");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  const Json j = Json::parse(slurp(folder_ / "c/controls.json"));
  EXPECT_EQ(j["method"], "woa");
  EXPECT_EQ(j["seed"], 1);
  EXPECT_EQ(j["parameters"]["population"], 30.0);
  EXPECT_TRUE(j["collision_free"].get<bool>());
  EXPECT_TRUE(j["arrives"].get<bool>());
  EXPECT_GT(j["segments"].size(), 10U);
  for (const Json& segment : j["segments"]) {
    EXPECT_LT(segment["end_error"]["position"].get<double>(), 0.10);
    EXPECT_TRUE(segment["collision_free"].get<bool>());
    EXPECT_GE(segment["triplets"].size(), 2U);
  }
  EXPECT_LT(j["end_error"]["position"].get<double>(), 0.10);
  EXPECT_TRUE(j["series"].contains("right"));
  EXPECT_EQ(run("controls " + plan + " --method woa --json").out, slurp(folder_ / "c/controls.json")) << "same seed, same bits";
  EXPECT_NE(run("controls " + plan + " --method woa --json --seed 2 --set iterations=10").out, slurp(folder_ / "c/controls.json"));
}

TEST_F(Controls, MissesAreStatusOne) {
  const std::string plan = planned(example("grid_tugger.json"));
  const Outcome o = run("controls " + plan + " --method woa --set population=2 --set iterations=1 --set restarts=0 --set most_triplets=2 -o c");
  EXPECT_EQ(o.status, 1) << o.out;
  EXPECT_TRUE(fs::exists(folder_ / "c/controls.json"));
}

TEST_F(Controls, MissionsInLegsAreDrivenExactly) {
  const std::string plan = planned(example("mission_warehouse.json"));
  const Outcome o = run("controls " + plan + " -o c");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_LT(Json::parse(slurp(folder_ / "c/controls.json"))["end_error"]["position"].get<double>(), 1e-3);
  refused(run("controls " + plan + " --method woa"), {"p/plan.json", "legs", "woa", "--method exact"});
}

TEST_F(Controls, TorquesOfMecanumWheelsAndPlansThatAreDrivenSlowerForThem) {
  const std::string plan = planned(example("fields/mecanum_discs.json"));
  ASSERT_EQ(run("controls " + plan + " -o c").status, 0);
  const Json free = Json::parse(slurp(folder_ / "c/controls.json"));
  EXPECT_EQ(free["motors"]["slowing"], 1.0);
  const double torque = free["motors"]["greatest_torque"].get<double>(), speed = free["motors"]["greatest_wheel_speed"].get<double>();
  EXPECT_GT(torque, 0.1);
  EXPECT_NE(slurp(folder_ / "c/controls.csv").find(",torque_front_left,torque_front_right,torque_rear_left,torque_rear_right,x,"), std::string::npos);
  const std::string picture = slurp(folder_ / "c/controls.svg");
  EXPECT_NE(picture.find("Torques of the motors at the wheels"), std::string::npos);
  // Forward, sideways and turning apart, the ground told by where it mainly goes; each wheel has a chart of its own for its speed, and one for its torque.
  const auto charts = [&](const std::string& title) {
    std::size_t n = 0;
    for (std::size_t at = picture.find("<title>" + title + "</title>"); at != std::string::npos; at = picture.find("<title>" + title + "</title>", at + 1)) ++n;
    return n;
  };
  for (const char* title : {"Speed forward v_x in m/s", "Speed sideways v_y in m/s, left positive", "Turning rate ω in rad/s, left positive"}) EXPECT_EQ(charts(title), 1u) << title;
  for (const char* wheel : {"front left", "front right", "rear left", "rear right"}) EXPECT_EQ(charts(wheel), 2u) << wheel;
  EXPECT_NE(picture.find("<rect class=\"bandside\""), std::string::npos);
  EXPECT_NE(picture.find("<rect class=\"bandfwd\""), std::string::npos);
  const Outcome o = run("controls " + plan + " -o c --set rolling_arm=0.001 --set wheel_inertia=0.0002 --set max_torque=" + std::to_string(0.7 * torque) + " --set max_wheel_speed=" + std::to_string(0.9 * speed));
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("slowed"), std::string::npos) << o.out;
  const Json slow = Json::parse(slurp(folder_ / "c/controls.json"));
  EXPECT_GT(slow["motors"]["slowing"].get<double>(), 1.1);
  EXPECT_LE(slow["motors"]["greatest_torque"].get<double>(), 0.7 * torque + 1e-6);
  EXPECT_LE(slow["motors"]["greatest_wheel_speed"].get<double>(), 0.9 * speed + 1e-6);
  const Json& m = slow["motors"];
  EXPECT_NEAR(m["driving"].get<double>() - m["braking"].get<double>(), m["kinetic_change"].get<double>() + m["rolling_losses"].get<double>(), 1e-6);
  EXPECT_GT(slow["time"].get<double>(), 1.1 * free["time"].get<double>());
  for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
    for (const Json& value : slow["series"][std::string{"torque_"} + wheel]) ASSERT_LE(std::abs(value.get<double>()), 0.7 * torque + 1e-6);
  }
  refused(run("controls " + plan + " --set inertia=100"), {"--set inertia: 100 is more than the whole mass has"});
  refused(run("controls " + plan + " --set max_torqe=1"), {"--set max_torqe: exact has no such parameter, did you mean \"max_torque\"?"});
  refused(run("controls " + plan + " --method wao"), {"--method", "did you mean \"woa\"?"});
  refused(run("controls " + plan + " --set max_torque=-1"), {"--set max_torque: -1 is out of range"});
  refused(run("controls " + planned(example("goal_pose.json")) + " --set max_torque=1"), {"--set: the exact method's parameters are those of a mecanum base's motors"});
}

// The input is what it should be, and it cannot be done: status 1, with what it takes and what there is.
TEST_F(Controls, MotorsThatCannotFollowAreStatusOneAndSayWhatTheyLack) {
  const std::string plan = planned(example("fields/mecanum_discs.json"));
  const auto number_behind = [](const std::string& text, const std::string& words) {
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words << " is not in: " << text;
    return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
  };
  // Rolling alone takes more than there is, however slowly.
  const Outcome o = run("controls " + plan + " --set rolling_arm=0.001 --set max_torque=0.001 -o w");
  EXPECT_EQ(o.status, 1) << o.out << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  EXPECT_FALSE(fs::exists(folder_ / "w"));
  for (const char* words : {"p/plan.json: the motors are too weak for the plan: the ", " wheel needs ", " N m at ", " s, and max_torque is 0.001 N m", "would be enough at the plan's speed"}) {
    EXPECT_NE(o.err.find(words), std::string::npos) << words << "\n" << o.err;
  }
  // What it calls enough is enough, and nearly as little as can be.
  const double slowest = number_behind(o.err, "at the plan's speed, max_torque ");
  const std::string so_much = " --set rolling_arm=0.001 --set max_torque=";
  EXPECT_EQ(run("controls " + plan + so_much + std::to_string(1.01 * slowest) + " -o s").status, 0);
  EXPECT_EQ(run("controls " + plan + so_much + std::to_string(0.9 * slowest) + " -o s").status, 1);
  const double at_speed = number_behind(o.err, ". max_torque ");
  ASSERT_EQ(run("controls " + plan + so_much + std::to_string(at_speed) + " -o s").status, 0);
  EXPECT_EQ(Json::parse(slurp(folder_ / "s/controls.json"))["motors"]["slowing"], 1.0);
  // Times among what moves cannot be stretched; the same of wheels that are too slow.
  const std::string moving = planned(example("fields/mecanum_crossing.json"));
  const Outcome late = run("controls " + moving + " --set max_wheel_speed=3");
  EXPECT_EQ(late.status, 1) << late.err;
  for (const char* words : {" wheel turns at ", " rad/s at ", "max_wheel_speed is 3 rad/s", "its times among what moves are proven", ". max_wheel_speed ", "would be enough"}) {
    EXPECT_NE(late.err.find(words), std::string::npos) << words << "\n" << late.err;
  }
}

TEST_F(Controls, MotorsOfTheVehiclesFileBoundTheProfileAndAreTakenFromThere) {
  Json scenario = Json::parse(slurp(example("fields/mecanum_discs.json")));
  if (scenario["vehicle"].is_string()) {
    const fs::path file = fs::path{example("fields/mecanum_discs.json")}.parent_path() / scenario["vehicle"].get<std::string>();
    scenario["vehicle"] = Json::parse(slurp(file));
  }
  const Outcome free = run("controls " + planned(example("fields/mecanum_discs.json")) + " --json");
  ASSERT_EQ(free.status, 0);
  const double fast = Json::parse(free.out)["motors"]["greatest_wheel_speed"].get<double>();
  Json& drive = scenario["vehicle"]["drive"];
  drive["max_wheel_speed"] = 0.5 * fast;
  drive["wheel_inertia"] = 2e-4;
  drive["rolling_arm"] = 0.001;
  drive["max_torque"] = 50;
  std::ofstream{folder_ / "m.json"} << scenario.dump();
  ASSERT_EQ(run("plan m.json -o m").status, 0);
  EXPECT_EQ(run("verify m/plan.json").status, 0);
  const Outcome o = run("controls m/plan.json --json");
  ASSERT_EQ(o.status, 0) << o.err;
  const Json motors = Json::parse(o.out)["motors"];
  EXPECT_EQ(motors["slowing"], 1.0) << "the profile keeps to it already";
  EXPECT_LE(motors["greatest_wheel_speed"].get<double>(), 0.5 * fast * (1.0 + 1e-5));
  EXPECT_GT(motors["greatest_wheel_speed"].get<double>(), 0.49 * fast);
  EXPECT_EQ(motors["rolling_arm"], 0.001);
  EXPECT_EQ(motors["wheel_inertia"], 2e-4);
  EXPECT_EQ(motors["max_torque"], 50.0);
  // What is set comes before it.
  const Outcome set = run("controls m/plan.json --json --set max_torque=40 --set rolling_arm=0 --set max_wheel_speed=" + std::to_string(0.4 * fast));
  ASSERT_EQ(set.status, 0) << set.err;
  const Json other = Json::parse(set.out)["motors"];
  EXPECT_EQ(other["max_torque"], 40.0);
  EXPECT_EQ(other["rolling_arm"], 0.0);
  EXPECT_GT(other["slowing"].get<double>(), 1.2);
  // A plan that is faster than its vehicle's wheels is not proven.
  Json plan = Json::parse(slurp(folder_ / "m/plan.json"));
  plan["scenario"]["vehicle"]["drive"]["max_wheel_speed"] = 0.4 * fast;
  std::ofstream{folder_ / "faster.json"} << plan.dump();
  const Outcome verified = run("verify faster.json");
  EXPECT_EQ(verified.status, 1) << verified.out;
  EXPECT_NE((verified.out + verified.err).find("over the"), std::string::npos) << verified.out << verified.err;
}

TEST_F(Controls, RefusesWhatItCannotUse) {
  const std::string plan = planned(example("goal_pose.json"));
  refused(run("controls nowhere.json"), {"nowhere.json"});
  refused(run("controls " + plan + " --method best"), {"--method", "best", "exact, woa"});
  for (const char* period : {"0", "-1", "2", "nan", "soon", "0.0001"}) refused(run("controls " + plan + " --period " + period), {"--period", period, "0.001 to 1"});
  refused(run("controls " + plan + " --set population=3"), {"--set", "exact"});
  refused(run("controls " + plan + " --seed 3"), {"--seed", "exact"});
  refused(run("controls " + plan + " --method woa --set whales=3"), {"--set whales", "woa", "population"});
  refused(run("controls " + plan + " --method woa --set population=1"), {"--set population", "1 is out of range", "2 to 10000"});
  refused(run("controls " + plan + " --method woa --set population=3 --set population=4"), {"--set population", "twice"});
  refused(run("controls " + plan + " --method woa --set least_time=5"), {"least_time", "most_time"});
  refused(run("controls " + plan + " --method woa --set triplets=5"), {"triplets", "most_triplets"});
  // Plans without a path, and such as are not what they claim.
  Json p = Json::parse(slurp(folder_ / plan));
  Json none = p;
  none["path"] = none["metrics"] = none["certificate"] = nullptr;
  none["status"] = "no_path";
  none["reason"] = "there is no way";
  refused(run("controls " + write(none, "none.json")), {"none.json", "path", "no_path"});
  Json moved = p;
  moved["path"]["samples"]["x"][3] = moved["path"]["samples"]["x"][3].get<double>() + 0.1;
  refused(run("controls " + write(moved, "moved.json")), {"moved.json", "not proven"});
  refused(run("controls " + example("goal_pose.json")), {"format"});
}

}  // namespace
}  // namespace waywright::test
