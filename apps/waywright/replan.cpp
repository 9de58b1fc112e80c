#include "waywright/planner/replan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "lane_words.hpp"
#include "numbers.hpp"
#include "outputs.hpp"
#include "waywright/io/obstacles_io.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/map/world.hpp"
#include "waywright/planner/replan_seen.hpp"
#include "waywright/planner/rest_of_plan.hpp"
#include "waywright/report/report.hpp"
#include "waywright/report/words.hpp"

namespace waywright::app {
namespace {

Parsed<Pose> pose_from(const char* option, const std::string& text) {
  if (const auto v = numbers_from(text, std::array{',', ','})) return make_pose({(*v)[0], (*v)[1]}, wrap((*v)[2]));
  return tl::unexpected{InputError{"", option, fmt::format("\"{}\" is not a pose", text), "X,Y,HEADING in metres and radians"}};
}

/// What was measured takes the place of what the scenario says.
Parsed<void> change(const ReplanArguments& arguments, Scenario& scenario) {
  if (arguments.shelf) {
    auto* station = std::get_if<Station>(&scenario.mission);
    if (station == nullptr) return tl::unexpected{InputError{"", "--shelf", "the plan's mission is not a station", "--goal"}};
    const auto measured = pose_from("--shelf", *arguments.shelf);
    if (!measured) return tl::unexpected{measured.error()};
    station->shelf.center = measured->position();
    station->shelf.heading = measured->heading;
  }
  if (arguments.goal) {
    auto* goal = std::get_if<Pose>(&scenario.mission);
    if (goal == nullptr) return tl::unexpected{InputError{"", "--goal", "the plan's mission is a station", "--shelf"}};
    const auto measured = pose_from("--goal", *arguments.goal);
    if (!measured) return tl::unexpected{measured.error()};
    *goal = *measured;
  }
  if (arguments.pose) {
    const auto measured = pose_from("--pose", *arguments.pose);
    if (!measured) return tl::unexpected{measured.error()};
    scenario.start = *measured;
  }
  return {};
}

std::string situation_sentence(double at, const Handover& now) {
  const std::string start = fmt::format("After {:g} s the vehicle has driven {:.2f} m of the old plan", at, now.driven);
  if (now.motion.speed == 0.0) return start + " and stands.";
  return start + fmt::format(" and moves {} at {:.3f} m/s with a curvature of {:.3f} 1/m.", now.motion.word(),
                             std::abs(now.motion.speed), now.motion.curvature);
}

/// s after the plan's start, of what the options say. @pre the plan has samples
Parsed<double> time_of(const ReplanArguments& arguments, const std::vector<Sample>& samples) {
  if (arguments.at && arguments.after) return tl::unexpected{InputError{"", "--after", "--at is given too", "one of the two"}};
  if (!arguments.at && !arguments.after) return tl::unexpected{InputError{"", "--at", "it is missing", "--at SECONDS or --after METRES"}};
  if (arguments.after) {
    const double whole = samples.back().s;
    const auto driven = numbers_from(*arguments.after, std::array<char, 0>{});
    if (!driven || !((*driven)[0] >= 0.0 && (*driven)[0] < whole)) {
      return tl::unexpected{InputError{"", "--after", fmt::format("\"{}\" is not within the plan's length in m", *arguments.after), fmt::format("0 to less than {:.3f}", whole)}};
    }
    return time_at(samples, (*driven)[0]);
  }
  const double ends = samples.back().t;
  const auto at = numbers_from(*arguments.at, std::array<char, 0>{});
  if (!at || !((*at)[0] >= 0.0 && (*at)[0] < ends)) {
    return tl::unexpected{InputError{"", "--at", fmt::format("\"{}\" is not within the plan's time in s", *arguments.at), fmt::format("0 to less than {:.3f}", ends)}};
  }
  return (*at)[0];
}

int replan_among_seen(const ReplanArguments& arguments);

}  // namespace

int replan(const ReplanArguments& arguments) {
  if (arguments.obstacles) return replan_among_seen(arguments);
  auto old = read_plan(arguments.plan);
  if (!old) return complain(old.error());
  const auto complain_of = [&](InputError error, const char* within) {
    if (error.file.empty() && error.field.rfind("--", 0) != 0) {
      error.file = arguments.plan.string();
      error.field = within + error.field;
    }
    return complain(error);
  };
  if (auto one = refuse_legs(old->scenario, arguments.plan, "a mission in legs is not planned anew while it is driven", "a plan of one goal or station"); !one) {
    one.error().field = "scenario.legs";
    return complain(one.error());
  }
  auto was = Problem::prepare(old->scenario);
  if (!was) return complain_of(was.error(), "scenario.");
  if (!was->scenario().waypoints.empty()) return complain_of({"", "waypoints", "a mission through waypoints is not planned anew while it is driven", "docking, a goal pose"}, "scenario.");
  if (was->free_goal() != nullptr) return complain_of({"", "goal", "a goal that leaves the heading free is not planned anew while it is driven", "docking, a goal pose"}, "scenario.");
  if (was->is_driven_back()) return complain_of({"", "station.manoeuvre", "the way out of a shelf is not planned anew while it is driven", "dock"}, "scenario.");
  // What a file claims is believed where it verifies: its samples may be slower than the vehicle could.
  const auto verification = [&] {
    const Interruptible interruptible;
    return verify(*old);
  }();
  if (!verification) return complain_of(verification.error(), "");
  if (!verification->holds) return complain_of({"", "path", "the plan is not proven: " + verification->findings.front(), "a plan that `waywright verify` confirms"}, "");
  const auto at = time_of(arguments, old->samples);
  if (!at) return complain(at.error());
  const Handover now = handover_at(old->path, old->samples, *at);
  if (now.is_turning) return complain({"", "--at", fmt::format("the vehicle turns on the spot {:g} s after the start", *at), "a time at which it drives or stands"});
  if (was->pocket() && now.driven > length(old->path) - length(was->pocket_stretch()) + 1e-6) {
    return complain({"", "--at", fmt::format("the forks are in the shelf {:g} s after the start, and nothing is planned anew there", *at), "an earlier time"});
  }
  Scenario scenario = old->scenario;
  scenario.start = now.pose;
  scenario.start_motion = now.motion;
  for (MovingObstacle& obstacle : scenario.moving) obstacle = seen_from(obstacle, *at);
  constexpr std::string_view mark = ", replanned";
  if (!scenario.name.ends_with(mark)) scenario.name += mark;
  if (auto changed = change(arguments, scenario); !changed) return complain(changed.error());
  // The reader's ranges hold for what was measured, too.
  const auto checked = parse_scenario(scenario_json(scenario), arguments.plan.string(), arguments.plan.parent_path());
  if (!checked) return complain(checked.error());
  const auto problem = Problem::prepare(*checked);
  if (!problem && arguments.shelf && problem.error().field.rfind("station.shelf", 0) == 0) {
    return complain({"", "--shelf", problem.error().problem, problem.error().allowed});
  }
  if (!problem) return complain_of(problem.error(), "scenario.");

  const std::filesystem::path folder = arguments.out.value_or(default_folder(problem->scenario().name));
  const bool write = !arguments.json || arguments.out;
  if (write) {
    if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
  }
  auto plan = [&] {
    const Interruptible interruptible;
    return waywright::replan(*problem, old->path, now.driven, interruptible.flag());
  }();
  if (!plan) return complain_of(plan.error(), "");
  plan->explanation.insert(plan->explanation.begin(),
                           situation_sentence(*at, now));
  tell_of_lanes(*plan);
  note_all({}, warnings(*plan));
  if (write) {
    if (auto written = write_plan(folder, *problem, *plan); !written) return complain(written.error());
  }
  const bool printed = arguments.json ? print_raw(plan_json(*plan))
                                      : print(plan_text(*plan) + fmt::format("written: {0}/plan.json, {0}/plan.svg, {0}/report.html\n", folder.string()));
  return plan->status == Status::solved && printed ? solved : not_solved;
}

namespace {

/// What lies so far off all that the old plan knows that nobody can have seen it there: mostly another frame or unit.
std::vector<std::string> far_off(const Plan& old, const SeenObstacles& seen) {
  World world{old.scenario.map};
  world.build();
  std::vector<Vec2> known;
  for (const Sample& s : old.samples) known.push_back(s.pose().position());
  if (!world.empty()) {
    known.push_back(world.bounds().low);
    known.push_back(world.bounds().high);
  }
  const Box box = bounding_box(known);
  const double room = 2.0 * old.scenario.vehicle.footprint.radius() + 1.0;  // m
  const auto is_off = [&](const Box& b) { return b.low.x > box.high.x + room || b.high.x < box.low.x - room || b.low.y > box.high.y + room || b.high.y < box.low.y - room; };
  std::vector<std::string> notes;
  const auto tell = [&](const std::string& what, Vec2 at) {
    notes.push_back(fmt::format("{} at ({:.2f}, {:.2f}) lies off the map, which reaches from ({:.2f}, {:.2f}) to ({:.2f}, {:.2f}): another frame or unit?", what, at.x, at.y, box.low.x, box.low.y, box.high.x, box.high.y));
  };
  const auto tell_all = [&](const auto& all, const char* what, const auto& points_of) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Box of_one = bounding_box(points_of(all[i]));
      if (is_off(of_one)) tell(fmt::format("new {} {}", what, i + 1), 0.5 * (of_one.low + of_one.high));
    }
  };
  tell_all(seen.still.obstacles, "obstacle", [](const Ring& ring) { return ring; });
  tell_all(seen.still.lines, "line", [](const Polyline& line) { return line; });
  std::size_t points = 0;
  for (const Vec2 p : seen.still.points) points += is_off({p, p}) ? 1 : 0;
  if (points > 0) tell(fmt::format("of the new points {}, the first of them", points), *std::find_if(seen.still.points.begin(), seen.still.points.end(), [&](Vec2 p) { return is_off({p, p}); }));
  for (std::size_t i = 0; i < seen.moving.size(); ++i) {
    std::vector<Vec2> track;
    for (const MovingObstacle::Place& place : seen.moving[i].track) track.push_back(place.pose.position());
    if (norm(seen.moving[i].velocity) == 0.0 && is_off(bounding_box(track))) tell(seen.moving[i].name.empty() ? fmt::format("new moving obstacle {}", i + 1) : one_line(seen.moving[i].name), track.front());
  }
  return notes;
}

int replan_among_seen(const ReplanArguments& arguments) {
  for (const auto& [option, given] : {std::pair{"--shelf", arguments.shelf.has_value()}, {"--goal", arguments.goal.has_value()}, {"--pose", arguments.pose.has_value()}}) {
    if (given) return complain({"", option, "it does not go with --obstacles: the vehicle is where the plan has it, and goes where it was to go", "--obstacles alone"});
  }
  auto old = read_plan(arguments.plan);
  if (!old) return complain(old.error());
  const auto complain_of = [&](InputError error) {
    if (error.file.empty() && error.field.rfind("--", 0) != 0) {
      error.file = arguments.plan.string();
      error.field = "scenario." + error.field;
    }
    return complain(error);
  };
  if (auto one = refuse_legs(old->scenario, arguments.plan, "a mission in legs is not planned anew while it is driven", "a plan of one goal or station"); !one) {
    one.error().field = "scenario.legs";
    return complain(one.error());
  }
  const auto seen = read_obstacles(*arguments.obstacles);
  if (!seen) return complain(seen.error());
  const auto verification = [&] {
    const Interruptible interruptible;
    return verify(*old);
  }();
  if (!verification) return complain_of(verification.error());
  if (!verification->holds) return complain({arguments.plan.string(), "path", "the plan is not proven: " + verification->findings.front(), "a plan that `waywright verify` confirms"});
  const auto at = time_of(arguments, old->samples);
  if (!at) return complain(at.error());
  const Handover now = handover_at(old->path, old->samples, *at);

  auto plan = [&] {
    const Interruptible interruptible;
    return waywright::replan(*old, *at, *seen, interruptible.flag());
  }();
  if (!plan) return plan.error().field.empty() ? complain({"", "--at", plan.error().problem, plan.error().allowed}) : complain_of(plan.error());
  const auto problem = Problem::prepare(plan->scenario);
  if (!problem) return complain_of(problem.error());
  plan->explanation.insert(plan->explanation.begin(), now.is_turning ? fmt::format("After {:g} s the vehicle has driven {:.2f} m of the old plan and turns on the spot; it begins to stand there.", *at, now.driven) : situation_sentence(*at, now));
  const std::filesystem::path folder = arguments.out.value_or(default_folder(plan->scenario.name));
  tell_of_lanes(*plan);
  note_all(seen->still.notes, far_off(*old, *seen));
  note_all({}, warnings(*plan));
  if (!arguments.json || arguments.out) {
    if (auto ready = prepare_folder(folder); !ready) return complain(ready.error());
    if (auto written = write_plan(folder, *problem, *plan); !written) return complain(written.error());
  }
  const bool printed = arguments.json ? print_raw(plan_json(*plan))
                                      : print(plan_text(*plan) + fmt::format("written: {0}/plan.json, {0}/plan.svg, {0}/report.html\n", folder.string()));
  return plan->status == Status::solved && printed ? solved : not_solved;
}

}  // namespace

}  // namespace waywright::app
