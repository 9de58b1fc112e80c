#include "waywright/judge/import.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright {
namespace {

constexpr double snap_distance = 0.01;  // m
constexpr double snap_angle = 0.01;     // rad

/// The origin's pose for a pose of the control point.
Pose origin_of(const Pose& control, const Pose& control_point) {
  const double heading = wrap(control.heading - control_point.heading);
  const Frame turned{make_pose({}, heading)};
  return make_pose(control.position() - turned.rotate(control_point.position()), heading);
}

void for_each_pose(Path& path, const auto& change) {
  for (Piece& piece : path.pieces) {
    if (auto* sequence = std::get_if<PoseSequence>(&piece.curve)) {
      for (Pose& p : sequence->poses) change(p);
    } else if (auto* turn = std::get_if<Turn>(&piece.curve)) {
      Pose p = make_pose(turn->at, turn->from);
      change(p);
      turn->at = p.position();
      turn->from = p.heading;
    }
  }
}

/// Moves an end onto the pose wanted where it is close; returns what to say.
std::string snap(Piece& piece, bool at_end, const Pose& wanted, const char* name) {
  auto* sequence = std::get_if<PoseSequence>(&piece.curve);
  if (sequence == nullptr) return {};
  Pose& p = at_end ? sequence->poses.back() : sequence->poses.front();
  const double off = distance(p.position(), wanted.position());
  const double turned = std::abs(shorter_turn(p.heading, wanted.heading));
  if (p == wanted || off > snap_distance || turned > snap_angle) return {};
  p = wanted;
  return fmt::format("The {} pose of the file was moved onto the scenario's by {:.4f} m and {:.4f} rad.", name, off, turned);
}

}  // namespace

Plan judge_imported(const Problem& problem, Path path) {
  std::vector<std::string> explanation{
      "Imported poses, taken as joined by straight interpolation of position and heading; what the vehicle does between them is "
      "proven for that motion."};
  const Pose& control = problem.vehicle().control_point;
  if (control != Pose{}) {
    for_each_pose(path, [&](Pose& p) { p = origin_of(p, control); });
    explanation.emplace_back("The file's poses are those of the control point; they were brought to the vehicle's origin.");
  }
  for (const auto& said : {snap(path.pieces.front(), false, problem.start(), "first"),
                           snap(path.pieces.back(), true, problem.goal(), "last")}) {
    if (!said.empty()) explanation.push_back(said);
  }
  Plan plan = judge(problem, std::move(path));
  plan.planner = "import";
  plan.parameters.clear();
  plan.scenario.planner = {"import", {}};
  if (auto ends = problem.check_ends(); ends && plan.status == Status::solved) {
    plan.status = ends->status;
    plan.reason = ends->reason;
  }
  plan.explanation = std::move(explanation);
  return plan;
}

}  // namespace waywright
