#include "waywright/planner/waypoint/nearness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace waywright {
namespace {

constexpr int deepest = 6;         // halvings between two poses
constexpr double softest = 0.02;   // of what is wanted: nearer than that counts as that

}  // namespace

Nearness::Nearness(const Problem& problem, double wanted, std::function<double(const Pose&)> depth_of)
    : depth_of_{std::move(depth_of)}, required_{problem.required_clearance()}, wanted_{wanted}, radius_{problem.footprint().radius()},
      along_{problem.world(), problem.footprint(), required_ + wanted_} {}

void Nearness::add(const Pose& a, const Pose& b, double length, bool is_first, bool is_last) {
  if (is_first) before_ = beyond(a);
  // The ends may just keep what is required, whatever is planned between them.
  const double end = beyond(b);
  const double floor = softest * wanted_;
  add(a, b, is_first ? std::max(before_, floor) : before_, is_last ? std::max(end, floor) : end, length, 0);
  before_ = end;
}

double Nearness::beyond(const Pose& pose) {
  const double clearance = along_.at(pose);
  const double beyond = clearance > 0.0 ? std::min(clearance - required_, wanted_) : -required_ - depth_of_(pose);
  least_ = std::min(least_, beyond);
  return beyond;
}

void Nearness::add(const Pose& a, const Pose& b, double ca, double cb, double length, int depth) {
  const double moved = distance(a.position(), b.position()) + radius_ * std::abs(shorter_turn(a.heading, b.heading));
  if (ca + cb <= moved && std::max(ca, cb) > 0.0 && depth < deepest) {
    const Pose middle = make_pose(0.5 * (a.position() + b.position()), a.heading + 0.5 * shorter_turn(a.heading, b.heading));
    const double c = beyond(middle);
    add(a, middle, ca, c, 0.5 * length, depth + 1);
    add(middle, b, c, cb, 0.5 * length, depth + 1);
    return;
  }
  for (const double c : {ca, cb}) {
    if (c <= 0.0) lacking_ += 0.5 * length * (1.0 - c / wanted_);
    else if (c < wanted_) barrier_ += 0.5 * length * (wanted_ / std::max(c, softest * wanted_) - 1.0);
  }
}

}  // namespace waywright
