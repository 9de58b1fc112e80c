#include "waywright/planner/state_lattice/danger_cost.hpp"

#include <algorithm>

#include "waywright/proof/proof.hpp"

namespace waywright {

double DangerCosts::away(double beyond, double length) const {
  const double from = std::clamp(1.0 - beyond / range, 0.0, 1.0), to = std::clamp(1.0 - (beyond + length) / range, 0.0, 1.0);
  return length + weight * range / 3.0 * (from * from * from - to * to * to);
}

MotionCost::MotionCost(const Problem& problem, const DangerCosts& costs, double margin)
    : problem_{problem}, zones_{problem.zones()}, costs_{costs}, required_{problem.required_clearance()}, margin_{margin}, body_{problem.footprint()},
      along_{problem.world(), problem.footprint(), problem.required_clearance() + costs.range} {
  memory_.reserve(body_);
}

std::vector<CostedPose> MotionCost::poses_of(const Stretch& stretch, double step) const {
  std::vector<SteppedPose> stepped;
  sample_stretch(stretch, step, look_angle, stepped);
  const double each = stretch.direction < 0 ? costs_.reverse : costs_.forward;
  std::vector<CostedPose> poses;
  poses.reserve(stepped.size());
  for (const SteppedPose& s : stepped) {
    const Vec2 course = stretch.direction == 0 ? Vec2{} : static_cast<double>(stretch.direction) * unit(s.pose.heading);
    poses.push_back({s.pose.position(), course, s.pose.heading, stretch.direction == 0 ? costs_.turn * s.angle : each * (s.way + costs_.bend * s.bend), s.way + body_.radius * s.angle});
  }
  return poses;
}

std::optional<double> MotionCost::zone_factor(const CostedPose& from, const CostedPose& to, Vec2 at) const {
  constexpr double ahead = 0.01;  // m along the tangents: the way between bends from one to the other
  if (to.course == Vec2{}) return 1.0;
  const Vec2 a = at + from.offset, b = at + to.offset;
  if (zones_.directs() && (!zones_.may_be_driven(a, b) || !zones_.may_be_driven(a, a + ahead * from.course) || !zones_.may_be_driven(b - ahead * to.course, b))) return std::nullopt;
  if (!zones_.weighs()) return 1.0;
  const double chord = distance(a, b);
  return chord > 0.0 ? zones_.cost(a, b) / chord : zones_.factor_at(a);
}

std::optional<double> MotionCost::of(const Stretch& stretch, double step) {
  const std::vector<CostedPose> poses = poses_of(stretch, step);
  return of(poses, Vec2{}, [&] { return is_free(stretch); });
}

bool MotionCost::is_free(const Stretch& stretch) {
  motion_.assign(path_of({stretch}));
  SweepOptions options;
  options.tolerance = 0.5 * ProofOptions{}.tolerance;
  options.required = margin_;
  const SweptClearance swept = swept_clearance(problem_.world(), body_, motion_.intervals(), options, memory_);
  return swept.complete && swept.lower > margin_;
}

}  // namespace waywright
