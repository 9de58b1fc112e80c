#include "waywright/planner/state_lattice/danger_cost.hpp"

#include <algorithm>

#include "waywright/proof/proof.hpp"

namespace waywright {

double DangerCosts::away(double beyond, double length) const {
  const double from = std::clamp(1.0 - beyond / range, 0.0, 1.0), to = std::clamp(1.0 - (beyond + length) / range, 0.0, 1.0);
  return length + weight * range / 3.0 * (from * from * from - to * to * to);
}

MotionCost::MotionCost(const Problem& problem, const DangerCosts& costs, double margin)
    : problem_{problem}, costs_{costs}, required_{problem.required_clearance()}, margin_{margin}, body_{problem.footprint()},
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
    poses.push_back({s.pose.position(), s.pose.heading, stretch.direction == 0 ? costs_.turn * s.angle : each * (s.way + costs_.bend * s.bend), s.way + body_.radius * s.angle});
  }
  return poses;
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
