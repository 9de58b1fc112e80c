#include "waywright/planner/state_lattice/danger_cost.hpp"

#include <algorithm>

#include "waywright/proof/proof.hpp"

namespace waywright {

namespace {

constexpr double least_look = 0.3;        // m: clearances told apart up to here settle most motions without the exact proof
constexpr double angle_in_zones = 0.02;   // rad between poses where zones tell directions: chords and curve are a quarter of a millimetre apart

}  // namespace

double DangerCosts::away(double beyond, double length) const {
  const double from = std::clamp(1.0 - beyond / range, 0.0, 1.0), to = std::clamp(1.0 - (beyond + length) / range, 0.0, 1.0);
  return length + weight * range / 3.0 * (from * from * from - to * to * to);
}

MotionCost::MotionCost(const Problem& problem, const DangerCosts& costs, double margin)
    : problem_{problem}, zones_{problem.zones_as_planned()}, costs_{costs}, required_{problem.required_clearance()}, margin_{margin}, body_{problem.footprint()},
      along_{problem.world(), problem.footprint(), problem.required_clearance() + std::max(costs.range, least_look)} {
  memory_.reserve(body_);
}

std::vector<CostedPose> MotionCost::poses_of(const LatticeStretch& stretch, double step) const {
  std::vector<SteppedPose> stepped;
  sample_stretch(stretch, step, zones_.directs() ? angle_in_zones : look_angle, stepped);
  const double each = costs_.each(stretch.direction);
  std::vector<CostedPose> poses;
  poses.reserve(stepped.size());
  for (const SteppedPose& s : stepped) {
    const Vec2 course = stretch.direction == 0 ? Vec2{} : static_cast<double>(stretch.direction) * unit(s.pose.heading);
    poses.push_back({s.pose.position(), course, s.pose.heading, s.way, stretch.direction == 0 ? costs_.turn * s.angle : each * (s.way + costs_.bend * s.bend), s.way + body_.radius * s.angle});
  }
  return poses;
}

bool MotionCost::zones_near(Vec2 place, double reach) const {
  const Box here{place - Vec2{reach, reach}, place + Vec2{reach, reach}};
  constexpr double room = 0.02;  // m, as far as tangents are looked at
  const auto is_near = [&](const auto& zone) { return meet(here, zone.box, room); };
  return std::any_of(zones_.weighed().begin(), zones_.weighed().end(), is_near) || std::any_of(zones_.directed().begin(), zones_.directed().end(), is_near);
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

std::optional<double> MotionCost::of(const LatticeStretch& stretch, double step) {
  const std::vector<CostedPose> poses = poses_of(stretch, step);
  return of(poses, Vec2{}, [&] { return is_free(stretch); });
}

bool MotionCost::is_free(const LatticeStretch& stretch) {
  motion_.assign(path_of({stretch}));
  SweepOptions options;
  options.tolerance = 0.5 * ProofOptions{}.tolerance;
  options.required = margin_;
  const SweptClearance swept = swept_clearance(problem_.world(), body_, motion_.intervals(), options, memory_);
  return swept.complete && swept.lower > margin_;
}

}  // namespace waywright
