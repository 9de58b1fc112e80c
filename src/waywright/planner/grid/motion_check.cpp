#include "waywright/planner/grid/motion_check.hpp"

#include <cmath>
#include <span>

#include "waywright/geometry/convex_parts.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Ring placed(const Ring& part, const Pose& pose) {
  const Frame frame{pose};
  Ring ring;
  for (const Vec2 p : part) ring.push_back(frame.to_world(p));
  return ring;
}

Ring hull_of(Ring points, const Ring& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points.size() <= 2 ? points : convex_hull(std::move(points));
}

}  // namespace

double connecting_margin(const Problem& problem) {
  constexpr double within = 2e-7;    // m: less than the proof lets pass where what is required is met exactly
  constexpr double contact = 1e-6;   // m, where nothing is required: apart all the same
  return problem.required_clearance() > 10.0 * contact ? problem.required_clearance() - within : problem.required_clearance() + contact;
}

double lattice_margin(const Problem& problem) { return problem.required_clearance() + 2.0 * ProofOptions{}.tolerance; }

MotionCheck::MotionCheck(const Problem& problem, const Footprint& footprint) : problem_{problem}, is_disc_{footprint.is_disc()} {
  if (footprint.is_disc()) {
    parts_ = {{{0.0, 0.0}}};
    grown_ = footprint.disc;
  } else {
    parts_ = convex_parts(footprint.polygon);
  }
}

std::vector<MotionCheck::Swept> MotionCheck::drive_rings(Vec2 way, double heading) const {
  std::vector<Swept> all;
  for (const Ring& part : parts_) {
    const Ring begin = placed(part, make_pose(Vec2{0.0, 0.0}, heading));
    if (way == Vec2{0.0, 0.0}) {
      all.push_back({begin, grown_});
      continue;
    }
    Ring end = begin;
    for (Vec2& p : end) p = p + way;
    all.push_back({hull_of(begin, end), grown_});
  }
  return all;
}

std::vector<MotionCheck::Swept> MotionCheck::turn_rings(double from, double angle) const {
  std::vector<Swept> all;
  if (is_disc_) return drive_rings({0.0, 0.0}, from);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / turn_step)));
  const double step = angle / steps;
  const double quarter = sin_cos(0.25 * step).sin;
  for (const Ring& part : parts_) {
    double radius = 0.0;
    for (const Vec2 p : part) radius = std::max(radius, norm(p));
    for (int i = 0; i < steps; ++i) {
      const double a = from + step * i;
      // Half a step from both ends a point at radius r is r·(1 − cos(step / 2)) beyond the chord.
      all.push_back({hull_of(placed(part, {0.0, 0.0, wrap(a)}), placed(part, {0.0, 0.0, wrap(a + step)})), 2.0 * radius * quarter * quarter});
    }
  }
  return all;
}

bool MotionCheck::is_free(const std::vector<Swept>& swept, Vec2 at, double margin) {
  for (const Swept& s : swept) {
    placed_ = s.ring;
    for (Vec2& p : placed_) p = p + at;
    if (!problem_.world().is_free(placed_, margin + s.grown)) return false;
  }
  return true;
}

bool MotionCheck::is_drive_free(Vec2 from, Vec2 to, double heading, double margin) { return is_free(drive_rings(to - from, heading), from, margin); }
bool MotionCheck::is_turn_free(Vec2 at, double from, double angle, double margin) { return is_free(turn_rings(from, angle), at, margin); }

}  // namespace waywright
