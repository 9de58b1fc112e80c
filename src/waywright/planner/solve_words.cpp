#include "waywright/planner/solve_words.hpp"

#include <fmt/format.h>

namespace waywright {

std::string proof_sentence(const Problem& problem, const Plan& plan) {
  const Certificate& c = plan.certificate;
  const bool is_measured = c.tightest.has_value();
  std::string text = is_measured ? fmt::format("Proven along the whole motion: the footprint keeps at least {:.4f} m from everything{}", c.clearance, problem.scenario().moving.empty() ? "" : " that stands")
                                 : fmt::format("Proven along the whole motion: nothing is nearer to the footprint than {:.4f} m", c.clearance);
  if (problem.pose_error_margin() > 0.0) {
    text += fmt::format(" at every pose within the pose error (which takes {:.4f} m)", problem.pose_error_margin());
  }
  if (is_measured) {
    text += fmt::format("; it is tightest against {} at ({:.2f}, {:.2f})", plan.tightest_obstacle, c.tightest_point.x,
                        c.tightest_point.y);
  }
  return text + ".";
}

std::string unheeded_zones_sentence(const Problem& problem, const std::string& planner, bool heeds_zones) {
  const ZoneRules& zones = problem.zones();
  if (heeds_zones || (!zones.directs() && !zones.weighs())) return {};
  if (!zones.directs()) return planner + " does not weigh preferred and penalty zones.";
  if (!zones.weighs()) return planner + " does not look at the direction of directed zones while it plans; the proof does.";
  return planner + " does not weigh preferred and penalty zones, and does not look at the direction of directed ones while it plans; the proof does.";
}

std::string stop_sentence(const Problem& problem) {
  const EntryMotion& motion = *problem.motion();
  return fmt::format("The vehicle moves {} at {:.2f} m/s when the plan begins: its path begins with the {:.2f} m in which it can stop with the curvature that it has "
                     "({:.3f} 1/m), and what was planned follows.",
                     problem.scenario().start_motion.word(), motion.speed, length(problem.stopping_stretch()), motion.curvature);
}

std::string wait_sentence(const Problem& problem, const Wait& wait) {
  const MovingObstacle& obstacle = problem.scenario().moving[wait.obstacle];
  const std::string who = one_line(title_of(obstacle, wait.obstacle));
  const std::string stop = wait.s > 0.0 ? fmt::format("After {:.1f} s, at s = {:.2f} m, the vehicle stops for {}", wait.from, wait.s, who) : fmt::format("The vehicle stands for {}", who);
  if (wait.is_wanted) return stop + fmt::format(", and goes on after {:.1f} s.", wait.until);
  if (wait.stays) return stop + fmt::format(" and waits until {:.1f} s; then it goes around it.", wait.until);
  // From a motion it may be too late to stop as far away as the rule has it.
  const auto& motion = problem.motion();
  const bool is_late = motion && wait.ahead < obstacle.range && wait.s <= 0.5 * motion->speed * motion->speed / problem.vehicle().limits.deceleration + 2.0 * sample_step;
  return stop + fmt::format(", which comes into its way {:.2f} m ahead{}, and goes on after {:.1f} s, when its way has been clear for {:g} s.", wait.ahead,
                            is_late ? fmt::format(" (it wants {:g} m, and cannot stop before)", obstacle.range) : std::string{}, wait.until, obstacle.free_for);
}

void explain_mission(const Problem& problem, const Plan& plan, std::vector<std::string>& text) {
  if (problem.is_driven_back()) {
    text.insert(text.begin(), "The way out was planned as the way of docking from the last pose, and is driven back.");
  }
  explain_driven(problem, plan, text);
}

void explain_driven(const Problem& problem, const Plan& plan, std::vector<std::string>& text) {
  const Scenario& scenario = problem.scenario();
  if (problem.free_goal() != nullptr && !plan.path.pieces.empty()) {
    const Pose end = end_pose(plan.path);
    text.push_back(fmt::format("The goal leaves the heading free{}: the vehicle ends at ({:.3f}, {:.3f}) with {:.4f} rad, as its last drive has it.",
                               problem.free_goal()->is_point() ? "" : ", and the place within its region", end.x, end.y, end.heading));
  }
  for (const Wait& wait : plan.waits) text.push_back(wait_sentence(problem, wait));
  if (!scenario.moving.empty() && plan.status == Status::solved) {
    text.push_back(fmt::format("Proven in time: at every moment of the plan the footprint {} {} wherever {} can be then.",
                               problem.required_clearance() > 0.0 ? fmt::format("keeps more than {:.3f} m from", problem.required_clearance()) : std::string{"does not touch"},
                               scenario.moving.size() == 1 ? one_line(title_of(scenario.moving.front(), 0)) : fmt::format("{} moving obstacles,", scenario.moving.size()),
                               scenario.moving.size() == 1 ? "it" : "they"));
  }
  if (!scenario.carried_load.empty()) {
    text.push_back(fmt::format("The load \"{}\" is carried all the way and belongs to the footprint{}.", scenario.carried_load,
                               problem.pocket() ? "; only between the docked pose and the forks' place in the shelf it may overlap the shelf" : ""));
  }
  if (problem.pocket() && plan.certificate.pocket_clearance && plan.certificate.collision_free) {
    const Insertion& insertion = *std::get<Station>(scenario.mission).insertion;
    text.push_back(fmt::format("The forks move straight for {:.2f} m, to {:.2f} m behind the shelf's face; no more than they enter the shelf, and they keep at least "
                               "{:.4f} m from its parts beside the pockets at every pose within the pose error.",
                               distance(problem.pocket()->outer.position(), problem.pocket()->inner.position()), insertion.depth,
                               *plan.certificate.pocket_clearance));
  }
}

}  // namespace waywright
