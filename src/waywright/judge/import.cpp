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

bool is_near(const Pose& a, const Pose& b) {
  return distance(a.position(), b.position()) <= snap_distance && std::abs(shorter_turn(a.heading, b.heading)) <= snap_angle;
}

/// Makes the stretch in the shelf a piece of its own, as the proof wants it: added where the poses end docked, cut off as a straight
/// line where they go on into the shelf without leaving it by more than the snap distance. Returns what to say.
std::string separate_pocket_stretch(const Problem& problem, Path& path) {
  const PocketMotion& pocket = *problem.pocket();
  const bool first = problem.is_driven_back();
  const Piece stretch = problem.pocket_stretch();
  const auto end = first ? path.pieces.begin() : path.pieces.end();
  auto* sequence = std::get_if<PoseSequence>(first ? &path.pieces.front().curve : &path.pieces.back().curve);
  if (sequence == nullptr) return {};
  std::vector<Pose>& poses = sequence->poses;
  if (is_near(first ? poses.front() : poses.back(), pocket.outer)) {
    (first ? poses.front() : poses.back()) = pocket.outer;
    path.pieces.insert(end, stretch);
    return "The file's poses end docked; the straight stretch in the shelf was added.";
  }
  const auto in_shelf = [&](const Pose& p) {
    const Vec2 along = Frame{pocket.outer}.to_local(p.position());
    return along.x >= -snap_distance && std::abs(along.y) <= snap_distance && std::abs(shorter_turn(p.heading, pocket.outer.heading)) <= snap_angle;
  };
  std::size_t count = 0;
  while (count < poses.size() && in_shelf(first ? poses[count] : poses[poses.size() - 1 - count])) ++count;
  if (count == 0 || !is_near(first ? poses.front() : poses.back(), pocket.inner)) return {};
  const auto cut = static_cast<std::ptrdiff_t>(count);
  if (first) {
    poses.erase(poses.begin(), poses.begin() + cut);
    poses.insert(poses.begin(), pocket.outer);
  } else {
    poses.erase(poses.end() - cut, poses.end());
    poses.push_back(pocket.outer);
  }
  if (poses.size() < 2) {
    path.pieces.erase(first ? path.pieces.begin() : path.pieces.end() - 1);
  }
  path.pieces.insert(first ? path.pieces.begin() : path.pieces.end(), stretch);
  return fmt::format("The last {} poses in the shelf were taken as the straight stretch between the docked pose and the forks' place there.", count);
}

}  // namespace

Plan judge_imported(const Problem& problem, Path path, std::vector<PoseSpeed> speeds) {
  std::vector<std::string> explanation{
      "Imported poses, taken as joined by straight interpolation of position and heading; what the vehicle does between them is "
      "proven for that motion."};
  const Pose& control = problem.vehicle().control_point;
  if (control != Pose{}) {
    for_each_pose(path, [&](Pose& p) { p = origin_of(p, control); });
    for (PoseSpeed& s : speeds) s.pose = origin_of(s.pose, control);
    explanation.emplace_back("The file's poses are those of the control point; they were brought to the vehicle's origin.");
  }
  const std::string pocket_said = problem.pocket() ? separate_pocket_stretch(problem, path) : std::string{};
  for (const auto& said : {pocket_said, snap(path.pieces.front(), false, problem.first_pose(), "first"),
                           problem.free_goal() != nullptr ? std::string{} : snap(path.pieces.back(), true, problem.last_pose(), "last")}) {
    if (!said.empty()) explanation.push_back(said);
  }
  Plan plan = judge(problem, std::move(path));
  plan.planner = "import";
  plan.parameters.clear();
  if (auto ends = problem.check_ends(); ends && plan.status == Status::solved) {
    plan.status = ends->status;
    plan.reason = ends->reason;
  }
  if (auto too_fast = check_zone_speeds(problem, speeds)) {
    if (plan.status == Status::solved) plan.status = Status::unproven;
    plan.reason += (plan.reason.empty() ? "" : "; ") + *too_fast;
  }
  plan.explanation = std::move(explanation);
  return plan;
}

}  // namespace waywright
