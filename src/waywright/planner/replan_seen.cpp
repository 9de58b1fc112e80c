#include "waywright/planner/replan_seen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iterator>

#include "waywright/judge/judge.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/detour_words.hpp"
#include "waywright/planner/go_around.hpp"
#include "waywright/planner/moving_ends.hpp"
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/planner/rest_of_plan.hpp"
#include "waywright/planner/solve_words.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/speed/speed.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array<double, 3> back_offs{1.0, 2.0, 4.0};  // of the vehicle's size: how far before and behind what blocks the way it is left and joined
constexpr double least_size = 0.5;                         // m, of a vehicle in this
constexpr double same_place = 1e-6;                        // m
constexpr double least_part = 1e-3;                        // m, of a way that is cut

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::string counted(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::size_t number_of(const Map& still) { return still.obstacles.size() + still.lines.size() + still.points.size(); }

void add_to_map(Map& map, const Map& still) {
  const auto add = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(map.obstacles, still.obstacles);
  add(map.lines, still.lines);
  add(map.points, still.points);
}

/// The plan's scenario as it is now. The way out of a shelf, once the vehicle is out, is one to a pose.
Scenario scenario_now(const Plan& old, const Problem& was, const RestOfPlan& rest, double t, const SeenObstacles& seen) {
  Scenario now = old.scenario;
  if (was.is_driven_back()) {
    const auto& station = std::get<Station>(old.scenario.mission);
    now.map.boundaries.push_back(station.area);
    now.map.obstacles.push_back(station.shelf.outline());
    now.mission = was.last_pose();
  }
  now.start = rest.pose;
  now.start_motion = rest.motion;
  add_to_map(now.map, seen.still);
  for (MovingObstacle& obstacle : now.moving) obstacle = seen_from(obstacle, t);
  for (std::size_t i = 0; i < seen.moving.size(); ++i) {
    now.moving.push_back(seen.moving[i]);
    if (now.moving.back().name.empty()) now.moving.back().name = fmt::format("new moving obstacle {}", i + 1);  // its number in the file, not among all
  }
  constexpr std::string_view mark = ", replanned";
  if (!now.name.ends_with(mark)) now.name += mark;
  return now;
}

std::vector<Pose> poses_of(const Path& path) {
  std::vector<Pose> poses;
  for (const Sample& s : sample(path, 0.0, 0.01, 0.12)) poses.push_back(s.pose());
  return poses;
}

/// For the picture.
Alternative way_not_taken(std::string name, const Path& path, std::string outcome, std::optional<double> cost, bool was_driven) {
  Alternative a;
  a.name = std::move(name);
  a.was_driven = was_driven;
  a.is_length = true;
  a.cost = cost;
  a.outcome = std::move(outcome);
  a.poses = poses_of(path);
  return a;
}

Replanned what_appeared(const Plan& old, const RestOfPlan& rest, const Map& still) {
  Replanned replanned;
  if (rest.driven > same_place) replanned.driven = poses_of(beginning(old.path, rest.driven));
  replanned.obstacles = still.obstacles;
  for (const Vec2 p : still.points) replanned.obstacles.push_back({p});
  replanned.lines = still.lines;
  return replanned;
}

/// A way that could be driven from here on.
struct Candidate {
  std::string name, told;
  Plan plan;
  std::vector<std::string> explanation;
  double left_at = 0.0;
};

class Replanning {
 public:
  Replanning(const Plan& old, const RestOfPlan& rest, const Problem& problem, const SeenObstacles& seen, double t, const std::atomic<bool>* cancel)
      : old_{old}, rest_{rest}, problem_{problem}, seen_{seen}, t_{t}, cancel_{cancel} {}

  Parsed<Plan> run() {
    if (auto failure = moving_at_ends(problem_)) {
      Plan plan = failed_plan(problem_, *failure);
      plan.alternatives.push_back(old_way());
      plan.replanned = what_appeared(old_, rest_, seen_.still);
      return plan;
    }
    const auto begin = Clock::now();
    const HeldAgainst held = held_against(seen_.still, problem_, rest_.path, cancel_);
    // A curve that is cut has other bounds than it had, by less than the tolerance; so what is kept is proven again.
    if (const Proof proof = held.is_free ? prove(problem_, rest_.path, {.cancel = cancel_}) : Proof{}; proof.holds()) {
      auto plan = kept(held, proof, since(begin));
      return plan && plan->status != Status::solved && plans_in_time() ? anew_in_time(std::move(*plan)) : plan;
    }
    auto plan = mended_or_anew();
    if (!plan) return plan;
    plan->replanned = what_appeared(old_, rest_, seen_.still);
    return plan;
  }

 private:
  /// On the spot, too fast to stand at once.
  bool is_turning() const { return !rest_.stopping.pieces.empty(); }
  double stopping_angle() const {
    double angle = 0.0;
    for (const Piece& piece : rest_.stopping.pieces) angle += std::abs(std::get<Turn>(piece.curve).angle);
    return angle;
  }
  /// The rest up to a place of it where the vehicle stands, the turn in which it comes to rest at least.
  Path kept_until_at_rest(double s) const {
    Path kept = kept_until(rest_.path, s);
    return kept.pieces.empty() ? rest_.stopping : kept;
  }

  bool plans_in_time() const {
    const PlannerDescription* planner = find_planner(problem_.scenario().planner.name);
    return planner != nullptr && planner->plans_in_time;
  }

  Parsed<Plan> kept(const HeldAgainst& held, const Proof& proof, double proven_in) {
    // Times of its own are a plan's first choice where its planner makes them; the rule's stops may be a step elsewhere than they were, and not serve.
    const Pace pace = problem_.scenario().moving.empty() ? Pace{} : pace_from(old_.samples, old_.waits, t_, rest_.driven);
    const Pace* own = pace.places.size() > 1 ? &pace : nullptr;
    Plan plan = judge_proven(problem_, rest_.path, proof, cancel_, {}, plans_in_time() ? own : nullptr);
    if (plan.hindrance && own != nullptr && !plans_in_time()) {
      // Cut where it stood, the same way: so it stands there again.
      Path cut = rest_.path;
      for (auto wait = pace.waits.rbegin(); wait != pace.waits.rend(); ++wait) {
        if (wait->s > least_part && wait->s < length(rest_.path) - least_part) cut = joined(beginning(cut, wait->s), remainder(cut, wait->s));
      }
      if (const Proof again = prove(problem_, cut, {.cancel = cancel_}); again.holds()) {
        Plan as_before = judge_proven(problem_, std::move(cut), again, cancel_, {}, own);
        if (!as_before.hindrance) plan = std::move(as_before);
      }
    }
    plan.timing.prove = proven_in;
    plan.replanned = what_appeared(old_, rest_, seen_.still);
    if (is_turning()) plan.explanation.push_back(fmt::format("The vehicle turns on the spot at up to {:.2f} rad/s when the plan begins; the plan's times are those from rest.", rest_.turning));
    const std::size_t n = number_of(seen_.still);
    if (n > 0) {
      plan.explanation.push_back(fmt::format("What was left of the plan is kept as it is: {} that stand{} still {} no nearer to it than {:.3f} m.", counted(n, "new obstacle"), n == 1 ? "s" : "",
                                             n == 1 ? "comes" : "come", held.clearance));
    } else {
      plan.explanation.push_back("What was left of the plan is kept as it is: nothing new stands still.");
    }
    return finish(std::move(plan));
  }

  /// No times serve what was left: a planner that leaves its way for what moves is asked again.
  Parsed<Plan> anew_in_time(Plan kept) {
    if (is_turning()) return kept;
    auto plan = solve(problem_, cancel_);
    if (!plan) return plan;
    if (plan->status != Status::solved) {
      kept.explanation.push_back(fmt::format("Planned anew from where the vehicle is, there is no better: {}.", plan->reason));
      return kept;
    }
    plan->explanation.insert(plan->explanation.begin(), fmt::format("No times serve what was left of the plan: {}. So the way to the goal is planned anew.", kept.reason));
    plan->alternatives.push_back(old_way());
    plan->replanned = what_appeared(old_, rest_, seen_.still);
    return plan;
  }

  Parsed<Plan> finish(Plan plan) {
    auto parameters = complete_parameters(problem_.scenario().planner);
    if (!parameters) return tl::unexpected{parameters.error()};
    plan.planner = problem_.scenario().planner.name;
    plan.parameters = *parameters;
    auto led = led_around(problem_, std::move(plan), cancel_);
    if (!led) return led;
    if (auto failure = moving_at_goal(problem_, *led)) {
      Plan failed = failed_plan(problem_, *failure);
      failed.explanation = std::move(led->explanation);
      failed.alternatives = std::move(led->alternatives);
      failed.replanned = std::move(led->replanned);
      failed.planner = led->planner;
      failed.parameters = led->parameters;
      failed.timing = led->timing;
      failed.effort = led->effort;
      return failed;
    }
    std::vector<std::string> more;
    explain_mission(problem_, *led, more);
    more.push_back(led->status == Status::solved ? proof_sentence(problem_, *led) : "This path is not proven: " + led->reason + ".");
    std::vector<std::string>& text = led->explanation;
    for (std::string& sentence : more) {
      if (std::find(text.begin(), text.end(), sentence) == text.end()) text.push_back(std::move(sentence));
    }
    return led;
  }

  Parsed<Plan> mended_or_anew() {
    samples_ = sample(rest_.path, problem_.footprint().radius(), ProofOptions{}.tolerance);
    blocked_ = blocked_stretches(seen_.still, problem_, samples_);
    brakes_in_ = braking_distance(problem_, samples_);
    const double room = blocked_.stretches.empty() ? length(rest_.path) : blocked_.stretches.front().begin;
    can_stop_ = brakes_in_ && *brakes_in_ <= room + same_place;
    std::vector<std::string> text{situation()};

    if (auto failure = problem_.check_ends()) {
      Plan plan = failed_plan(problem_, *failure);
      plan.explanation = text;
      plan.alternatives.push_back(old_way());
      return plan;
    }
    if (is_turning()) {
      const std::vector<Sample> turn = sample(rest_.stopping, problem_.footprint().radius(), ProofOptions{}.tolerance);
      if (const Blocked there = blocked_stretches(seen_.still, problem_, turn); !there.stretches.empty() || there.ends_blocked) {
        blocked_ = there;
        Plan plan = failed_plan(problem_, {Status::no_path, fmt::format("{} is in the way of the turn on the spot that has begun: from {:.2f} rad/s the vehicle comes to rest in {:.3f} rad", obstacle_name(), rest_.turning, stopping_angle()), rest_.pose, {}});
        plan.explanation = text;
        plan.alternatives.push_back(old_way());
        return plan;
      }
    }
    std::vector<Candidate> candidates;
    if (can_stop_ && !blocked_.stretches.empty() && !blocked_.ends_blocked) mend(candidates);
    std::optional<Plan> failed;
    if (auto error = plan_anew(candidates, failed)) return tl::unexpected{*error};
    return best_of(std::move(candidates), std::move(failed), std::move(text));
  }

  std::string obstacle_name() const {
    if (blocked_.stretches.empty()) return "something new";
    const std::size_t n = blocked_.obstacle, polygons = seen_.still.obstacles.size(), lines = seen_.still.lines.size();
    const Map& before = old_.scenario.map;
    if (n < polygons) return fmt::format("new obstacle {} (obstacle {} of the map now)", n + 1, problem_.scenario().map.obstacles.size() - polygons + n);
    if (n < polygons + lines) return fmt::format("new line {} (line {} of the map now)", n - polygons + 1, before.lines.size() + n - polygons);
    return fmt::format("new point {} (point {} of the map now)", n - polygons - lines + 1, before.points.size() + n - polygons - lines);
  }

  std::string situation() const {
    if (blocked_.stretches.empty()) return "What was left of the plan cannot be shown to be free of what is new.";
    const double ahead = blocked_.stretches.front().near;
    const double required = problem_.required_clearance();
    std::string text = fmt::format("What was left of the plan is blocked by {}: {:.2f} m ahead the footprint would {}", obstacle_name(), ahead,
                                   required > 0.0 ? fmt::format("come nearer than {:.3f} m to it", required) : std::string{"touch it"});
    if (is_turning()) return text + fmt::format("; the vehicle turns on the spot at up to {:.2f} rad/s and comes to rest in {:.3f} rad.", rest_.turning, stopping_angle());
    if (!problem_.motion()) return text + "; the vehicle stands.";
    if (!brakes_in_) return text + fmt::format("; at {:.2f} m/s the vehicle cannot come to rest on what is left of the plan.", problem_.motion()->speed);
    return text + fmt::format("; at {:.2f} m/s the vehicle comes to rest in {:.2f} m{}.", problem_.motion()->speed, *brakes_in_, can_stop_ ? "" : ", which is too far");
  }

  Alternative old_way() const { return way_not_taken("old plan", rest_.path, "What was left of the plan that was being driven.", std::nullopt, true); }

  /// m, of what is left, that ends where the vehicle goes into a shelf.
  double end_of_open_way() const { return length(rest_.path) - (problem_.pocket() ? length(problem_.pocket_stretch()) : 0.0); }

  void mend(std::vector<Candidate>& candidates) {
    const double size = std::max(least_size, 2.0 * problem_.footprint().radius());
    const double first = blocked_.stretches.front().begin, last = blocked_.stretches.back().end, open = end_of_open_way();
    double left_before = -1.0, joined_before = -1.0;
    for (const double back_off : back_offs) {
      const double leave = std::max(*brakes_in_, first - back_off * size), join = last + back_off * size;
      if (join > open - same_place || (leave == left_before && join == joined_before)) continue;
      left_before = leave;
      joined_before = join;
      const Path behind = remainder(rest_.path, join);
      auto found = detour(problem_, kept_until_at_rest(leave), start_pose(behind), {}, cancel_);
      if (!found) continue;
      count(found->plan);
      if (found->plan.status != Status::solved) continue;
      Candidate c;
      c.name = fmt::format("mended from {:.1f} m on", found->s);
      c.plan = judge(problem_, joined(std::move(found->whole), behind), cancel_);
      c.plan.search = std::move(found->plan.search);
      c.left_at = found->s;
      c.told = fmt::format("the first {:.2f} m of what was left and its last {:.2f} m are kept, and {:.2f} m lead around", found->s, length(behind), length(found->plan.path));
      c.explanation = of_part("Of the new part", found->plan.explanation);
      if (!c.plan.path.pieces.empty()) candidates.push_back(std::move(c));
    }
  }

  /// The error of a scenario that its planner does not take; `failed`: what came of it where it is no way.
  std::optional<InputError> plan_anew(std::vector<Candidate>& candidates, std::optional<Plan>& failed) {
    const PlannerDescription* planner = find_planner(problem_.scenario().planner.name);
    const bool in_motion = planner != nullptr && planner->goes_on_in_motion;
    if (can_stop_ && (is_turning() || (problem_.motion() && !in_motion))) {
      auto found = detour(problem_, kept_until_at_rest(*brakes_in_), problem_.scenario().mission, {}, cancel_);
      if (!found) return found.error();
      count(found->plan);
      if (found->plan.status == Status::solved) {
        Candidate c;
        c.name = "planned anew";
        c.plan = judge(problem_, found->whole, cancel_);
        c.plan.search = std::move(found->plan.search);
        c.left_at = found->s;
        c.told = fmt::format("the vehicle stops along the old way, in {}, and the way to the goal is planned anew from there", is_turning() ? fmt::format("{:.3f} rad", stopping_angle()) : fmt::format("{:.2f} m", found->s));
        c.explanation = of_part("Of the new part", found->plan.explanation);
        candidates.push_back(std::move(c));
        if (is_turning() || !plans_in_time() || problem_.scenario().moving.empty()) return std::nullopt;
      } else {
        failed = std::move(found->plan);
        if (is_turning()) return std::nullopt;
      }
    }
    auto plan = solve(problem_, cancel_);
    if (!plan) return plan.error();
    count(*plan);
    if (plan->status == Status::solved || plan->hindrance) {
      Candidate c;
      c.name = "planned anew";
      c.told = problem_.motion() ? "the way to the goal is planned anew from the motion" : "the way to the goal is planned anew";
      c.explanation = std::move(plan->explanation);
      c.plan = std::move(*plan);
      candidates.push_back(std::move(c));
    } else if (!failed) {
      failed = std::move(*plan);
    }
    return std::nullopt;
  }

  Parsed<Plan> best_of(std::vector<Candidate> candidates, std::optional<Plan> failed, std::vector<std::string> text) {
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      const bool a_solved = a.plan.status == Status::solved, b_solved = b.plan.status == Status::solved;
      if (a_solved != b_solved) return a_solved;
      return a.plan.metrics.travel_time < b.plan.metrics.travel_time;
    });
    if (cancel_ != nullptr && cancel_->load()) {
      Plan canceled = failed_plan(problem_, {Status::canceled, "canceled while it was replanned", {}, {}});
      canceled.explanation = std::move(text);
      return canceled;
    }
    if (candidates.empty()) {
      Plan plan = failed_plan(problem_, {failed ? failed->status : Status::no_path, failed ? failed->reason : "no way around was found", {}, {}});
      if (!can_stop_ && problem_.motion() && !blocked_.stretches.empty()) {
        plan.reason = fmt::format("{} is {:.2f} m ahead on the way, and the vehicle needs {} to come to rest from {:.2f} m/s; {}", obstacle_name(), blocked_.stretches.front().near,
                                  brakes_in_ ? fmt::format("{:.2f} m", *brakes_in_) : std::string{"more than is left"}, problem_.motion()->speed, plan.reason);
      }
      plan.explanation = std::move(text);
      if (failed) {
        std::move(failed->explanation.begin(), failed->explanation.end(), std::back_inserter(plan.explanation));
        plan.search = std::move(failed->search);
      }
      plan.alternatives.push_back(old_way());
      set_effort(plan);
      return plan;
    }
    Plan plan = std::move(candidates.front().plan);
    const Candidate& taken = candidates.front();
    text.push_back(fmt::format("{}: {}. It takes {:.1f} s for {:.2f} m.", "So it is " + taken.name, taken.told, plan.metrics.travel_time,
                               plan.metrics.length));
    if (!plan.samples.empty()) text.push_back(detour_sentence({samples_, old_.samples.back().t - t_}, {plan.samples, plan.metrics.travel_time}, taken.left_at));
    std::string others;
    std::vector<Alternative> alternatives{old_way()};
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      const Plan& other = candidates[i].plan;
      const std::string figures = other.status == Status::solved ? fmt::format("{:.1f} s for {:.2f} m", other.metrics.travel_time, other.metrics.length) : "not proven: " + other.reason;
      others += fmt::format("{}{} ({})", others.empty() ? "" : ", ", candidates[i].name, figures);
      alternatives.push_back(way_not_taken(candidates[i].name, other.path, figures + ".", other.metrics.length, false));
      if (i > 1) alternatives.back().poses.clear();  // most of them are much the same
    }
    if (!others.empty()) text.push_back(fmt::format("Not taken: {}.", others));
    text.insert(text.end(), taken.explanation.begin(), taken.explanation.end());
    plan.explanation = std::move(text);
    plan.alternatives = std::move(alternatives);
    set_effort(plan);
    return finish(std::move(plan));
  }

  void count(const Plan& plan) {
    evaluations_ += plan.effort.evaluations;
    expansions_ += plan.effort.expansions;
    timing_.prepare += plan.timing.prepare;
    timing_.plan += plan.timing.plan;
    is_reproducible_ = is_reproducible_ && plan.reproducible;
  }
  void set_effort(Plan& plan) const {
    plan.effort.evaluations = evaluations_;
    plan.effort.expansions = expansions_;
    plan.timing.prepare = timing_.prepare;
    plan.timing.plan = timing_.plan;
    plan.reproducible = is_reproducible_;
  }

  const Plan& old_;
  const RestOfPlan& rest_;
  const Problem& problem_;
  const SeenObstacles& seen_;
  double t_;  ///< s after the old plan's start
  const std::atomic<bool>* cancel_;
  std::vector<Sample> samples_;
  Blocked blocked_;
  std::optional<double> brakes_in_;
  bool can_stop_ = false;
  std::int64_t evaluations_ = 0, expansions_ = 0;
  Timing timing_;
  bool is_reproducible_ = true;
};

/// The profile bounds each step by its worse end, and the rest has other steps than the whole: from the speed that the plan has in the middle of a step the rest may be a little too
/// steep. m/s that it is then taken to begin with, where that is nearly its speed; empty where there is nothing to take off or too much.
std::optional<double> slower_start(const Problem& problem, const Path& path) {
  constexpr double nearly = 0.98;
  const auto& motion = problem.motion();
  if (!motion) return std::nullopt;
  const std::vector<Sample> samples = sample(path, problem.footprint().radius(), ProofOptions{}.tolerance);
  const LimitsAlong along = zone_limits(problem, samples, ProofOptions{}.tolerance);
  SpeedWorkspace workspace;
  if (can_start_with(samples, problem.vehicle(), motion->speed, workspace, along)) return std::nullopt;
  const double slower = greatest_start_speed(samples, problem.vehicle(), workspace, along);
  return slower >= nearly * motion->speed ? std::optional{slower} : std::nullopt;
}

}  // namespace

Parsed<Plan> replan(const Plan& old, double t, const SeenObstacles& seen, const std::atomic<bool>* cancel) {
  if (!old.scenario.legs.empty()) return tl::unexpected{InputError{"", "legs", "a mission in legs is not planned anew while it is driven", "a plan of one goal or station"}};
  if (!old.scenario.waypoints.empty()) return tl::unexpected{InputError{"", "waypoints", "a mission through waypoints is not planned anew while it is driven", "a plan of one goal or station"}};
  const auto was = Problem::prepare(old.scenario);
  if (!was) return tl::unexpected{was.error()};
  const auto rest = rest_of(old, *was, t);
  if (!rest) return tl::unexpected{InputError{"", "", fmt::format("the forks are in the shelf {:g} s after the start, and nothing is planned anew there", t), "a time at which they are out of it"}};
  Scenario scenario = scenario_now(old, *was, *rest, t, seen);
  auto problem = Problem::prepare(scenario);
  if (!problem) return tl::unexpected{problem.error()};
  if (!rest->stopping.pieces.empty() && !problem->scenario().moving.empty()) {
    return tl::unexpected{InputError{"", "", fmt::format("{:g} s after the start the vehicle turns on the spot at up to {:.2f} rad/s, and among what moves nothing is planned from that yet", t, rest->turning), "a time at which it drives or stands"}};
  }
  const auto slower = slower_start(*problem, rest->path);
  if (!slower) return Replanning{old, *rest, *problem, seen, t, cancel}.run();
  const double speed = std::abs(scenario.start_motion.speed);
  scenario.start_motion.speed = std::copysign(*slower, scenario.start_motion.speed);
  problem = Problem::prepare(std::move(scenario));
  if (!problem) return tl::unexpected{problem.error()};
  auto plan = Replanning{old, *rest, *problem, seen, t, cancel}.run();
  if (plan) plan->explanation.insert(plan->explanation.begin(), fmt::format("Its speed of {:.3f} m/s is taken for {:.3f} m/s, from which what is left surely keeps the vehicle's limits.", speed, *slower));
  return plan;
}

}  // namespace waywright
