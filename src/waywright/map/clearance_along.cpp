#include "waywright/map/clearance_along.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "waywright/core/elementary.hpp"

namespace waywright {
namespace {

constexpr std::size_t width = segment_lanes::width;
constexpr Vec2 centre{};

std::span<const Vec2> corners_of(const Footprint& footprint) {
  return footprint.is_disc() ? std::span<const Vec2>{&centre, 1} : std::span<const Vec2>{footprint.polygon};
}

}  // namespace

ClearanceAlong::ClearanceAlong(const World& world, const Footprint& footprint, double cap)
    : world_{&world}, cap_{cap}, grown_{footprint.is_disc() ? footprint.disc : 0.0}, radius_{footprint.is_disc() ? 0.0 : footprint.radius()},
      outline_{corners_of(footprint)} {}

void ClearanceAlong::forget() {
  has_last_ = false;
  last_ = {};
  clearance_ = 0.0;
  outline_.forget();
}

double ClearanceAlong::at(const Pose& pose) {
  const SinCos turn = sin_cos(pose.heading);
  return at(pose, turn.sin, turn.cos);
}

void ClearanceAlong::at(std::span<const Pose> poses, std::vector<double>& clearances) {
  static const segment_lanes::Kernels& kernels = segment_lanes::best();
  clearances.reserve(clearances.size() + poses.size());
  alignas(64) std::array<double, width> headings, sines, cosines;
  for (; !poses.empty(); poses = poses.subspan(std::min(width, poses.size()))) {
    const std::size_t count = std::min(width, poses.size());
    bool is_usual = true;
    for (std::size_t i = 0; i < width; ++i) {
      headings[i] = poses[std::min(i, count - 1)].heading;
      is_usual = is_usual && std::abs(headings[i]) <= 8.0;
    }
    if (is_usual) kernels.sin_cos(headings.data(), sines.data(), cosines.data());
    for (std::size_t i = 0; i < count; ++i) clearances.push_back(is_usual ? at(poses[i], sines[i], cosines[i]) : at(poses[i]));
  }
}

double ClearanceAlong::at(const Pose& pose, double sin, double cos) {
  constexpr double rounding = 1e-9;  // of all lengths here, and m: what is not found within the bound is looked for without it
  const double moved = distance(last_.position(), pose.position()) + radius_ * std::abs(shorter_turn(last_.heading, pose.heading));
  const double by = moved + rounding * (1.0 + moved + clearance_);
  const bool was_free = has_last_ && clearance_ > by;
  const double bound = std::min(cap_, clearance_ + by);
  outline_.place(pose, sin, cos);
  has_last_ = true;
  last_ = pose;
  if (was_free) {
    const double found = outline_.distance(world_->index(), bound + grown_) - grown_;
    if (found < bound || bound == cap_) return clearance_ = std::clamp(found, 0.0, cap_);
  }
  return clearance_ = std::min(cap_, world_->least_clearance(outline_.ring(), grown_, cap_));
}

}  // namespace waywright
