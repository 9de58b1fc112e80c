#include "waywright/path/pose_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace waywright {
namespace {

/// Least-squares line or parabola of turning over progress, around the place `at`.
EstimatedCurvature fit(const std::vector<PoseMotion>& motion, const std::vector<std::size_t>& nodes,
                       std::size_t first, std::size_t last, std::size_t at) {
  const std::size_t n = last - first + 1;
  if (n < 2) return {};
  // In units of the window's half length, so that the sums are of one size.
  const double middle = motion[nodes[at]].progress;
  const double half = std::max(motion[nodes[last]].progress - middle, middle - motion[nodes[first]].progress);
  double s1 = 0.0, s2 = 0.0, s3 = 0.0, s4 = 0.0, h0 = 0.0, h1 = 0.0, h2 = 0.0;
  for (std::size_t k = first; k <= last; ++k) {
    const double x = (motion[nodes[k]].progress - middle) / half;
    const double h = motion[nodes[k]].turned - motion[nodes[at]].turned;
    s1 += x, s2 += x * x, s3 += x * x * x, s4 += x * x * x * x;
    h0 += h, h1 += h * x, h2 += h * x * x;
  }
  const auto s0 = static_cast<double>(n);
  const double line = s0 * s2 - s1 * s1;
  if (n == 2) return {(s0 * h1 - s1 * h0) / line / half, 0.0};
  // Normal equations of a + b·x + c·x² by Cramer's rule.
  const double determinant = s0 * (s2 * s4 - s3 * s3) - s1 * (s1 * s4 - s2 * s3) + s2 * (s1 * s3 - s2 * s2);
  const double b =
      (s0 * (h1 * s4 - s3 * h2) - h0 * (s1 * s4 - s3 * s2) + s2 * (s1 * h2 - h1 * s2)) / determinant;
  const double c =
      (s0 * (s2 * h2 - h1 * s3) - s1 * (s1 * h2 - h1 * s2) + h0 * (s1 * s3 - s2 * s2)) / determinant;
  if (!std::isfinite(b) || !std::isfinite(c)) return {(s0 * h1 - s1 * h0) / line / half, 0.0};
  return {b / half, 2.0 * c / (half * half)};
}

}  // namespace

std::vector<PoseMotion> motion_along(const PoseSequence& sequence, int direction) {
  std::vector<PoseMotion> motion(sequence.poses.size());
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const Pose& a = sequence.poses[i - 1];
    const Pose& b = sequence.poses[i];
    const Vec2 chord = b.position() - a.position();
    const double turn = shorter_turn(a.heading, b.heading);
    const Vec2 ahead = unit(a.heading + 0.5 * turn);
    motion[i].progress = motion[i - 1].progress + direction * dot(ahead, chord);
    motion[i].sideways = motion[i - 1].sideways + cross(ahead, chord);
    motion[i].turned = motion[i - 1].turned + turn;
  }
  return motion;
}

std::vector<std::size_t> thinned(const std::vector<PoseMotion>& motion, double apart) {
  std::vector<std::size_t> nodes{0};
  for (std::size_t i = 1; i < motion.size(); ++i) {
    if (motion[i].progress - motion[nodes.back()].progress >= apart) nodes.push_back(i);
  }
  const std::size_t last = motion.size() - 1;
  if (nodes.back() != last && motion[last].progress > motion[nodes.back()].progress) {
    // A last step far shorter than the others would say more about noise than about curvature.
    if (nodes.size() > 1 && motion[last].progress - motion[nodes.back()].progress < 0.5 * apart)
      nodes.pop_back();
    nodes.push_back(last);
  }
  return nodes;
}

std::vector<EstimatedCurvature> estimated_curvature(const PoseSequence& sequence, int direction) {
  std::vector<EstimatedCurvature> estimates(sequence.poses.size());
  const std::vector<PoseMotion> motion = motion_along(sequence, direction);
  const std::vector<std::size_t> nodes = thinned(motion);
  const auto progress = [&](std::size_t node) { return motion[nodes[node]].progress; };
  std::vector<EstimatedCurvature> at_nodes;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    while (progress(k) - progress(first) > estimate_reach) ++first;
    last = std::max(last, k);
    while (last + 1 < nodes.size() && progress(last + 1) - progress(k) <= estimate_reach) ++last;
    // Neighbours at least, however far apart the poses are.
    const std::size_t from = std::min(first, k > 0 ? k - 1 : k);
    const std::size_t to = std::max(last, std::min(k + 1, nodes.size() - 1));
    at_nodes.push_back(fit(motion, nodes, from, to, k));
  }
  std::size_t node = 0;
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    while (node + 1 < nodes.size() && motion[i].progress >= progress(node + 1)) ++node;
    estimates[i] = at_nodes[node];
    if (node + 1 == nodes.size()) continue;
    const double t =
        std::clamp((motion[i].progress - progress(node)) / (progress(node + 1) - progress(node)), 0.0, 1.0);
    estimates[i].curvature += t * (at_nodes[node + 1].curvature - at_nodes[node].curvature);
    estimates[i].rate += t * (at_nodes[node + 1].rate - at_nodes[node].rate);
  }
  return estimates;
}

}  // namespace waywright
